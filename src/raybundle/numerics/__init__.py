"""Rotations, transforms, sparse factor and selected inverse, statistics, derivation of sensor models."""

import os

# Idle OpenBLAS threads spin for milliseconds before they sleep, on the processors that the passes over
# the observations need; the shortest time-out ends that.  OpenBLAS reads it once, when SciPy loads it.
os.environ.setdefault("OPENBLAS_THREAD_TIMEOUT", "4")
