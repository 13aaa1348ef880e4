"""Photographs of a known scene, with exact truth.

The package shares no code with raybundle: what it renders judges the results of raybundle. Object space is
right-handed, in metres, Z up. Pixels count from the outer corner of the first pixel, x right, y down; the centre of
that pixel is (0.5, 0.5). Rotations turn object axes to image axes, R = R3(kappa) R2(phi) R1(omega).
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
"""Products of matrices are small here: threads within them only wait for each other."""
