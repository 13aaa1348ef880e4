"""Block folders: block.toml and the tables beside it, strictly read and written so that they read back equal."""
