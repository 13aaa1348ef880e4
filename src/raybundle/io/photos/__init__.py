"""Photographs: files, metadata, cameras with their starting values, frames of a video."""
