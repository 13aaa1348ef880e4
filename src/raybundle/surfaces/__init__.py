"""The surface of what photographs show: a depth and its standard deviation for every pixel."""
