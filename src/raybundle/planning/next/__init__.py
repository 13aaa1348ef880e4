"""The next photographs of a block in hand."""
