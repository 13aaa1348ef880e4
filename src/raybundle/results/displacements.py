"""The displacements of a result of several dates, as its table has them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.io.formats.base import Displaced
from raybundle.io.tables import Column, read_table

DISPLACEMENTS = "displacements.csv"
AXES = "XYZ"
EXCEEDS, TESTED = "p_exceeds_limit", "p_tested"


def read_displacements(path: Path) -> Displaced:
    """The displacements of a result."""
    texts, numbers = ("point", "from", "to", "verdict"), [f"{h}{a}" for h in ("d", "sd") for a in AXES]
    more = (*AXES, "rXY", "rXZ", "rYZ", "length", "F", "p", "detectable_before", "detectable", EXCEEDS, TESTED)
    columns = [
        *(Column(name=n, kind="text", empty=True) for n in texts),
        *(Column(name=n, kind="number", empty=True, optional=n in {EXCEEDS, TESTED}) for n in (*numbers, *more)),
    ]
    t = read_table(path, columns, least_rows=0, own=True)
    R = np.tile(np.eye(3), (len(t.text["point"]), 1, 1))
    for name, (i, j) in {"rXY": (0, 1), "rXZ": (0, 2), "rYZ": (1, 2)}.items():
        R[:, i, j] = R[:, j, i] = t.numbers(name)[:, 0]
    std = t.numbers(*(f"sd{a}" for a in AXES))
    point, start, end, verdict = (tuple(t.text[n]) for n in texts)
    return Displaced(
        point=point, start=start, end=end, verdict=verdict, xyz=t.numbers(*AXES), p=t.numbers("p")[:, 0],
        vector=t.numbers(*(f"d{a}" for a in AXES)), covariance=std[:, :, None] * R * std[:, None, :],
    )  # fmt: skip
