"""What keeps points from fitting: for nominal coordinates, axes, control and epochs alike."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import POOR_FIT, Severity
from raybundle.errors import Message, Value, message
from raybundle.metrology.best_fit import BestFit
from raybundle.metrology.misfit import Misfit

MM = 1000.0
FEW = 5
"""Points that are named with their figures"""
NEAR_UNIT = 0.01
"""Difference from a ratio of units, as a share, within which a factor is taken for it: bars and parts are better"""
UNITS = {
    1000.0: ("mm", "m"), 100.0: ("cm", "m"), 10.0: ("mm", "cm"), 25.4: ("mm", "in"), 2.54: ("cm", "in"),
    1 / 0.0254: ("in", "m"), 12.0: ("in", "ft"), 1 / 0.3048: ("ft", "m"),
}  # fmt: skip
"""Ratios of lengths, and in which units they are when these are taken for those"""


def unit_of(factor: float) -> str:
    """Which exchange of units a factor of lengths looks like, "mm for m"; "" for none."""
    for ratio, (small, large) in UNITS.items():
        if abs(factor / ratio - 1) < NEAR_UNIT:
            return f"{small} for {large}"
        if abs(factor * ratio - 1) < NEAR_UNIT:
            return f"{large} for {small}"
    return ""


def fit_values(found: Misfit) -> dict[str, Value]:
    """The figures of a misfit: the fit, the fit with another scale or mirrored, the factor of scale and its unit."""
    near = abs(found.factor - 1) < NEAR_UNIT
    return {
        "n": len(found.fits), "agree": int(found.fits.sum()), "rms_mm": MM * found.rms,
        "rms_same_scale_mm": MM * found.rms_kept, "factor": found.factor, "factor_sigma": found.factor_sigma,
        "scale_ppm": 1e6 * (found.factor - 1) if near else 0.0, "sigma_ppm": 1e6 * found.factor_sigma, "near_1": near,
        "units": unit_of(found.factor),
    }  # fmt: skip


def wrong_points(found: Misfit, names: Sequence[str]) -> tuple[Message, ...]:
    """Which points do not agree with the others, by how much, and which names look exchanged."""
    each = [
        message("points_fit.apart", point=names[k], apart_mm=MM * float(found.distance[k])) for k in found.wrong[:FEW]
    ]
    for a, b in found.exchanged[:FEW]:
        each.append(message("points_fit.names_exchanged", first=names[a], second=names[b]))
    if found.instead:
        each.append(message("points_fit.instead", names=[names[k] for k in found.instead]))
    return tuple(each)


def nominal_contradicted(fit: BestFit) -> tuple[Notice, ...]:
    """What keeps measured points from fitting onto nominal ones: a fault for each, the gravest first."""
    m, n = fit.misfit, fit.asked
    values = fit_values(m)
    if m.scattered:
        return (Notice(code="nominal_names", values=values, measured=Severity.FAULT),)
    found: list[Notice] = []
    if m.mirrored:
        found.append(Notice(code="nominal_mirrored", values=values, measured=Severity.FAULT))
    if m.scaled:
        grave = Severity.FAULT if m.rms_kept > POOR_FIT * m.rms else Severity.WARNING
        found.append(Notice(code="nominal_scale", values=values, measured=grave))
    if m.wrong and not m.mirrored:
        out = any(not f and i in set(n) for i, f in zip(fit.ids, fit.fitted.tolist(), strict=True))
        ids = tuple(n[k] for k in m.wrong[:100])
        found.append(
            Notice(
                code="nominal_wrong", ids=ids, details=wrong_points(m, n),
                values={"wrong": len(m.wrong), "excluded": out, "rms_mm": MM * m.rms},
            )
        )  # fmt: skip
    return tuple(found)


def axes_notices(fit: BestFit, file: str, largest: float) -> tuple[Notice, ...]:
    """How well the axes of a file fit, and which of its points do not agree with the others.

    largest  length of the largest displacement [m]
    """
    turn = float(np.sqrt(max(np.linalg.eigvalsh(fit.turn)[-1], 0.0)))
    values: dict[str, Value] = {
        "name": file, "n": int(fit.fitted.sum()), "rms_mm": MM * fit.rms, "rotation_mrad": 1e3 * turn,
        "largest_mm": MM * turn * largest,
    }  # fmt: skip
    fitted = Notice(code="axes_fitted", values=values, measured=Severity.NOTE)
    return (*(replace(n, measured=Severity.WARNING) for n in nominal_contradicted(fit)), fitted)


def control_contradicted(found: Misfit, file: str, names: Sequence[str]) -> tuple[Notice, ...]:
    """A fault where control contradicts the network as a whole, so that none of it takes part."""
    values: dict[str, Value] = {"name": file, **fit_values(found)}
    ids = tuple(names[:100])
    if found.scattered:
        return (Notice(code="control_contradicts.scattered", values=values, ids=ids),)
    if found.mirrored:
        return (Notice(code="control_mirrored", values=values, ids=ids),)
    if found.scaled:
        return (Notice(code="control_contradicts.scale", values=values, ids=ids),)
    return ()


def control_wrong(found: Misfit, file: str, names: Sequence[str]) -> tuple[Notice, ...]:
    """Of single control points that contradict the others."""
    if not found.wrong:
        return ()
    code = "control_contradicts.ambiguous" if found.instead else "control_left_out"
    values: dict[str, Value] = {"name": file, "n": len(found.wrong), "rms_mm": MM * found.rms}
    ids = tuple(names[k] for k in found.wrong)
    return (Notice(code=code, values=values, ids=ids, details=wrong_points(found, names)),)
