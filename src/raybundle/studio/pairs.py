"""Which images share points: the match graph, as lines in space and as a table."""

from __future__ import annotations

from typing import Any

import numpy as np

from raybundle.numerics.arrays import Array, Index
from raybundle.orientation.rays import common_counts
from raybundle.studio.desk import Desk
from raybundle.studio.tables import Wanted, containing, page_of


def shared(desk: Desk) -> Index:
    """(k, 3) pairs of images and the points that they share by observations that take part, most first."""
    block, a = desk.block, desk.adjustment
    o = block.observations
    used = np.ones(len(o), bool) if a is None else a.image_observations.used
    every = np.ones(len(block.images), bool)
    return common_counts(o.image[used], o.point[used], every, len(block.points))


def pairs(desk: Desk, wanted: Wanted) -> dict[str, Any]:
    """A page of the table of pairs; the base is the distance of their projection centres."""
    block = desk.block
    found = shared(desk)
    a, b, common = found.T
    base = np.linalg.norm(block.images.centre[a] - block.images.centre[b], axis=1)
    names = np.array(block.images.ids, object)
    columns: dict[str, Array] = {"image": names[a], "other": names[b], "common": common, "base": base}
    hit = containing(block.images.ids, wanted.search)
    total, rows = page_of(columns, hit[a] | hit[b], wanted)
    return {"total": total, "rows": [
        {"image": names[a[k]], "other": names[b[k]], "common": int(common[k]),
         "base": float(base[k]) if np.isfinite(base[k]) else None}
        for k in rows
    ]}  # fmt: skip
