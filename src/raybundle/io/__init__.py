"""Reading and writing: block folders and their tables."""
