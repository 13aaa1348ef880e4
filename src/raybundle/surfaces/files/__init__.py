"""Files of heights: read, checked, written, drawn."""
