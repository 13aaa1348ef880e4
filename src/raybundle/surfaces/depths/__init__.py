"""Depth maps: a depth and its standard deviation for every pixel of a photograph, and the points of them."""
