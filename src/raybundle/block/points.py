"""Names of object points."""

from __future__ import annotations

import re
from collections.abc import Iterable

import numpy as np

from raybundle.numerics.arrays import Mask

NEAR_PX = 1.0
"""Distance within which two measurements in one photograph are of the same place.

Of a format of a million pixels a pair of points taken by chance lies as near with a probability of 3e-6, and in one
photograph more than not (of two or more) never; what one matching measures lies within some tenths of a pixel of what
another does."""
_AUTOMATIC = re.compile(r"t[0-9]+")
_DOT = re.compile(r"dot ([1-9][0-9]*)")


def automatic_name(k: int) -> str:
    """Name of the k-th tie point (from 0) that a program found without a name."""
    return f"t{k + 1}"


def automatic_number(name: str) -> int:
    """Which tie point (from 0) has this automatic name; -1 for another name."""
    return int(name[1:]) - 1 if is_automatic(name) else -1


def is_automatic(name: str) -> bool:
    """Whether a point has a name that a program gave it, and nobody else."""
    return _AUTOMATIC.fullmatch(name) is not None


def automatic(names: Iterable[str]) -> Mask:
    """Which of these points (n,) have a name that a program gave them."""
    matches = _AUTOMATIC.fullmatch
    return np.array([matches(name) is not None for name in names], bool)


def dot_name(k: int) -> str:
    """Name of the k-th dot without a code (from 0): a running number of one measurement, another in the next."""
    return f"dot {k + 1}"


def dot_number(name: str) -> int:
    """Which dot (from 0) has this name; -1 for another name."""
    return int(name[4:]) - 1 if _DOT.fullmatch(name) else -1
