"""What `raybundle plan` does: one file a subcommand."""
