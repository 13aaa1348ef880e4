"""What is to be stated of interior orientations: what is not determinable, what is coupled, and the remedy."""

from __future__ import annotations

import math

import numpy as np

from raybundle.adjustment.records.figures import InteriorResult, printed_unit
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.numerics.arrays import Array

STRONG = 0.95


def interior_notices(result: Adjustment) -> list[Notice]:
    """What is to be stated of each interior orientation."""
    found: list[Notice] = []
    for interior in result.interior:
        name = interior.camera if interior.image is None else f"{interior.camera}/{interior.image}"
        found += [
            Notice(
                code="not_determinable",
                values={
                    "name": name, "symbol": p.symbol, "sigma": math.nan if p.std is None else p.std,
                    "unit": printed_unit(p.unit, result.length_unit), "remedy": _remedy(result, p.symbol),
                },
                ids=(interior.camera if interior.image is None else f"image {interior.image}", p.symbol),
            )
            for p in interior.parameters.values()
            if p.status == "not determinable"
        ]  # fmt: skip
        found += _unknown_constant(result, name, interior)
        found += _correlations(result, name, interior.camera, interior.free, interior.correlations)
    return found


UNKNOWN = 0.2
"""Relative standard deviation of a camera constant above which a block is not calibrated.

The second-order part of its error is that share of the first: above a fifth, standard deviations are not true to 10 %
(1 + 2 x 0.2^2), and the depth of the object is open by as much."""


def _unknown_constant(result: Adjustment, name: str, interior: InteriorResult) -> list[Notice]:
    """The fault of a camera constant that is not determined well enough."""
    camera = next((c for c in result.given.cameras if c.id == interior.camera), None)
    symbol = "" if camera is None else camera.sensor.scale_symbol
    p = interior.parameters.get(symbol)
    if p is None or p.std is None or symbol not in interior.free or not p.std > UNKNOWN * abs(p.value):
        return []
    values = {"name": name, "symbol": symbol, "share": p.std / abs(p.value), "limit": UNKNOWN}
    return [Notice(code="camera_constant_unknown", ids=(interior.camera, symbol), values=values)]


def _remedy(result: Adjustment, symbol: str) -> str:
    """What makes a parameter determinable, as `not_determinable` knows it."""
    if symbol in {"c", "f"}:
        return "converge"
    if symbol in {"x0", "y0", "P1", "P2", "A", "S"}:
        return "roll" if _lacks_roll(result) else "views"
    return "corners"


def _lacks_roll(result: Adjustment) -> bool:
    """Whether no image is rolled by 90 degrees."""
    network = result.network
    if network is None:
        return False
    roll = network.roll[np.isfinite(network.roll)]
    return not np.any(np.abs(np.abs(roll) - np.pi / 2) < np.pi / 6)


def _correlations(result: Adjustment, name: str, camera: str, free: tuple[str, ...], R: Array) -> list[Notice]:
    """Strong correlations other than among the radial terms, whose correlation is no harm."""
    found: list[Notice] = []
    if len(R) != len(free):
        return found
    for i, a in enumerate(free):
        for j in range(i):
            b = free[j]
            if abs(R[i, j]) > STRONG and not {a[0], b[0]} <= {"K", "k"}:
                roll = bool({a, b} & {"x0", "y0", "P1", "P2"}) and _lacks_roll(result)
                values = {
                    "name": name, "first": b, "second": a, "correlation": abs(float(R[i, j])), "roll": roll
                }  # fmt: skip
                found.append(Notice(code="correlation", values=values, ids=(camera, b, a)))
    return found
