"""Questions of the page: coordinates, distances, angles, areas, each with its standard deviation."""

from __future__ import annotations

from typing import Any, cast

from raybundle.errors import InputError
from raybundle.measuring.query import NAMES, Quantity, ask
from raybundle.studio.desk import Desk


def asked(desk: Desk, kind: str, points: tuple[str, ...]) -> dict[str, Any]:
    """Values with their standard deviations; raises InputError where there is no adjustment to ask."""
    if kind not in NAMES:
        raise InputError(f"kind {kind!r} is none of {', '.join(NAMES)}")
    a = desk.adjustment
    if a is None:
        raise InputError(desk.session.neglected or "there is no adjustment yet; wait until it is done")
    found = ask(a, cast("Quantity", kind), points)
    return {
        "words": f"{kind} {', '.join(points)}", "remark": found.remark,
        "values": [
            {"name": n, "value": v, "sigma": s, "unit": found.unit}
            for n, v, s in zip(found.names, found.values, found.sigma, strict=True)
        ],
    }  # fmt: skip
