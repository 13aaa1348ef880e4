"""Calibration of cameras: options, state, and what its stages have in common."""
