"""Coordinate systems of the earth, and control in them."""
