"""Networks for tests that are not of their size."""

from raybundle.planning.synthetic_networks import TargetField

SMALL = TargetField(rows=6, columns=8, stations=8, frontal=2)
"""48 points in 10 images, the corners 1, 8, 41 and 48"""
