"""Cameras as computer vision describes them, and the way from ours to theirs and back."""
