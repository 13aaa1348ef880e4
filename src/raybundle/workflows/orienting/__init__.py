"""Orientation from photographs: options, state, and what its stages have in common."""
