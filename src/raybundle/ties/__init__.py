"""Tie points: found, freed of what is wrong, measured precisely; steps over blocks."""
