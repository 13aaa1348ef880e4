"""Numbers and sentences of reports and command lines."""
