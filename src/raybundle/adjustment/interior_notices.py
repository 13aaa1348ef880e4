"""What is to be said of interior orientations: what is not determinable, what is coupled, and the remedy."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.result import Adjustment, InteriorResult, Notice
from raybundle.numerics.arrays import Array

STRONG = 0.95


def interior_notices(result: Adjustment) -> list[Notice]:
    """What is to be said of each interior orientation."""
    found: list[Notice] = []
    for interior in result.interior:
        who = f"camera {interior.camera}" + ("" if interior.image is None else f", image {interior.image}")
        found += [
            Notice(
                code="not_determinable",
                message=f"{who}: {p.symbol} is not determinable: its standard deviation "
                f"{p.std_words(result.length_unit)} says less than is known beforehand. {_remedy(result, p.symbol)}",
                ids=(interior.camera if interior.image is None else f"image {interior.image}", p.symbol),
            )
            for p in interior.parameters.values()
            if p.status == "not determinable"
        ]
        found += _unknown_constant(result, who, interior)
        found += _correlations(result, who, interior.camera, interior.free, interior.correlations)
    return found


UNKNOWN = 0.2
"""Relative standard deviation of a camera constant above which a block is not calibrated.

The second-order part of its error is that share of the first: above a fifth, standard deviations are not true to 10 %
(1 + 2 x 0.2^2), and the depth of the object is open by as much."""


def _unknown_constant(result: Adjustment, who: str, interior: InteriorResult) -> list[Notice]:
    """The fault of a camera constant that is not determined well enough."""
    camera = next((c for c in result.given.cameras if c.id == interior.camera), None)
    symbol = "" if camera is None else camera.sensor.scale_symbol
    p = interior.parameters.get(symbol)
    if p is None or p.std is None or symbol not in interior.free or not p.std > UNKNOWN * abs(p.value):
        return []
    share = p.std / abs(p.value)
    message = (
        f"{who}: not calibrated: {symbol} is known to {share:.0%} only (limit {UNKNOWN:.0%}), and the shape of the "
        "object with it. Give a calibration, or photographs that converge and show depth"
    )
    values = {"share": share, "limit": UNKNOWN}
    return [Notice(code="camera_constant_unknown", message=message, ids=(interior.camera, symbol), values=values)]


def _remedy(result: Adjustment, symbol: str) -> str:
    if symbol in {"c", "f"}:
        return "Hold it, or add images that converge by 45 degrees or more, or points at different depths."
    if symbol in {"x0", "y0", "P1", "P2", "A", "S"}:
        return _roll_advice(result) or "Hold it, or add convergent images."
    return "Hold it, or measure points up to the corners of the format."


def _roll_advice(result: Adjustment) -> str:
    network = result.network
    if network is None:
        return ""
    roll = network.roll[np.isfinite(network.roll)]
    turned = int(np.sum(np.abs(np.abs(roll) - np.pi / 2) < np.pi / 6))
    if turned:
        return ""
    return "No image is rolled by 90 degrees: add two rolled images."


def _correlations(result: Adjustment, who: str, camera: str, free: tuple[str, ...], R: Array) -> list[Notice]:
    """Strong correlations other than among the radial terms, whose correlation is no harm."""
    found: list[Notice] = []
    if len(R) != len(free):
        return found
    for i, a in enumerate(free):
        for j in range(i):
            b = free[j]
            if abs(R[i, j]) > STRONG and not {a[0], b[0]} <= {"K", "k"}:
                advice = _roll_advice(result) if {a, b} & {"x0", "y0", "P1", "P2"} else ""
                found.append(
                    Notice(
                        code="correlation",
                        message=f"{who}: {b} and {a} correlate by {abs(R[i, j]):.2f}. {advice}".rstrip(),
                        ids=(camera, b, a),
                    )
                )
    return found
