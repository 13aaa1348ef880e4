"""Satellite scenes: rational polynomials, line sensors on a trajectory, empirical models; numerics only, no files."""
