"""What orienting and adjusting so many photographs takes: a model of sizes, constants that are measured, an estimate."""
