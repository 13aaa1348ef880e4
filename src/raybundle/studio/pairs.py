"""Which images share points: the match graph, as a table."""

from __future__ import annotations

from typing import Any

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.studio.desk import Desk
from raybundle.studio.tables import Wanted, containing, page_of


def pairs(desk: Desk, wanted: Wanted) -> dict[str, Any]:
    """A page of the table of pairs; the base is the distance of their projection centres."""
    block = desk.block
    a, b, common = desk.shared.T
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
