"""The array types of the numeric layers."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
"""Floats; shapes stand in the docstrings."""

Index = NDArray[np.int32]
"""Positions in another table; -1 where there is none."""

Mask = NDArray[np.bool_]
"""True where something holds."""
