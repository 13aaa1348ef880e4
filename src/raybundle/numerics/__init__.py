"""Rotations, transforms, sparse factor and selected inverse, statistics, derivation of sensor models."""
