"""Tie points from image contents: features, pairs, verification, tracks, least-squares matching."""
