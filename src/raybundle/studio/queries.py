"""Questions of the page: coordinates, distances, angles, areas, each with its standard deviation."""

from __future__ import annotations

from typing import Any

from raybundle.errors import InputError
from raybundle.measuring.quantities import QUANTITIES, Quantity
from raybundle.measuring.query import ask
from raybundle.studio.desk import Desk


def answer(desk: Desk, kind: str, points: tuple[str, ...]) -> dict[str, Any]:
    """Values with their standard deviations; raises InputError where there is no adjustment to ask."""
    known: dict[str, Quantity] = {q: q for q in QUANTITIES}
    quantity = known.get(kind)
    if quantity is None:
        raise InputError("value.not_one_of", entry="kind", given=kind, known=list(QUANTITIES))
    a = desk.adjustment
    if a is None:
        raise InputError(desk.session.neglected or "studio.no_adjustment")
    found = ask(a, quantity, points)
    return {
        "remark": found.remark,
        "values": [
            {"name": n, "value": v, "sigma": s, "unit": found.unit}
            for n, v, s in zip(found.names, found.values, found.sigma, strict=True)
        ],
    }  # fmt: skip
