"""What orienting and adjusting so many photographs takes: sizes, constants that are measured, an estimate."""
