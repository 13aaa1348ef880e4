"""Approximate values of rigs."""
