"""Cameras: of computer vision, in the library of the user, of zoom lenses, and their conversions."""
