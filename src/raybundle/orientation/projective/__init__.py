"""Projective geometry: DLT, fundamental matrices, cameras of which nothing is known."""
