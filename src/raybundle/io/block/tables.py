"""What the readers and writers of a block folder's tables share."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from raybundle.errors import Message
from raybundle.io.tables import SHOWN, Problem, fail
from raybundle.numerics.arrays import Array, Index, Mask

XYZ = ("X", "Y", "Z")
SIGMA_XYZ = ("sX", "sY", "sZ")
ANGLES = ("omega_deg", "phi_deg", "kappa_deg")


def problems_of(mask: Mask, column: str, message: Callable[[int], Message], first_line: int = 2) -> list[Problem]:
    """The first rows of a mask (n,) as problems of a table."""
    return [Problem(int(k) + first_line, column, message(int(k))) for k in np.flatnonzero(mask)[: SHOWN + 1]]


def require(path: Path, *groups: Sequence[Problem]) -> None:
    """Raise InputError where there are problems."""
    problems = [p for group in groups for p in group]
    if problems:
        fail(path, problems)


def named(ids: Sequence[str], index: Index) -> list[str]:
    """The ids at these positions."""
    positions: list[int] = index.tolist()
    return [ids[k] for k in positions]


def columns_of(names: Sequence[str], values: Array) -> dict[str, Array]:
    """The columns of a matrix under their names."""
    return {name: values[:, k] for k, name in enumerate(names)}
