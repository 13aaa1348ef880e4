"""Cameras in files: the library of the user, zoom lenses, blocks at one instant."""
