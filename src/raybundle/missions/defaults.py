"""What flights have where nothing else is asked for."""

OVERLAP = (0.8, 0.7)
"""Of photographs along a line, and of lines: a place lies in some 1 / ((1 - 0.8) (1 - 0.7)) = 17 photographs"""
