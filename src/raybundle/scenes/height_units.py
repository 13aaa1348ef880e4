"""Heights of control in another unit than metres, as in feet.

Where the ground is level they shift the image along its height parallax, which a bias takes up without residuals; where
it is not, they leave residuals.  Both are compared with what the same points leave with their heights in each unit.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError, NotSolvable
from raybundle.numerics.arrays import Array
from raybundle.numerics.length_units import UNITS
from raybundle.numerics.statistics import fisher_tail
from raybundle.scenes.bias import BiasKind, bias_design
from raybundle.scenes.bias_blunders import solve_bias
from raybundle.scenes.bias_choice import FAR, BiasFit
from raybundle.scenes.rpc import Rpc

LEVEL = 1e-5
"""Probability with which residuals of right heights are smaller by chance in another unit, over all units, at most"""
DECIDEDLY = 2.0
"""Ratio of the residuals from which a unit is better"""
MET = 1e-2
"""Probability with which a bias beyond what the vendor states meets a shift by a unit by chance, at most"""
MET_UNSTATED = 1e-4
"""The same where the vendor states none, so that any bias is as likely"""


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightUnit:
    """A unit in which the heights of control fit an RPC."""

    name: str
    shift_px: tuple[float, float]
    """Length of the shift as given and in this unit"""
    rms_px: tuple[float, float]
    """Residuals of a coordinate beside the bias as given and in this unit"""


def height_unit(
    rpc: Rpc, geographic: Array, heights_m: Array, xy_px: Array, covariance: Array, fit: BiasFit
) -> HeightUnit | None:
    """The unit in which heights fit decidedly better than in metres; None where none does.

    geographic  (n, 3) longitude, latitude, ellipsoidal height [m]
    heights_m   (n,) heights as the file has them, above any surface, taken for metres
    xy_px       (n, 2) measured there
    covariance  (n, 2, 2) of the image points, with that of the ground points [px^2]
    fit         the bias on the points as given

    Residuals: W as given and W' in a unit, both of r degrees of freedom and the same bias, have the ratio F(r, r) if
    both fit alike.  Shifts: a bias of any size in a random direction falls within r of a place at the distance R with
    a probability of r^2 / (e R^2) at most; R is the shift by the unit, r what is left of the bias.
    What it does not find: another unit of heights near 0.
    """
    before, shift = (_solved(rpc, geographic, xy_px, covariance, kind) for kind in (fit.kind, "shift"))
    if before is None or shift is None:
        return None
    prior, units = rpc.bias_sigma_px(), {n: metres for n, metres in UNITS.items() if n != "m"}
    redundancy = 2 * len(xy_px) - len(before.values)
    found: list[tuple[float, HeightUnit]] = []
    for name, metres in units.items():
        mended = geographic - np.outer((1 - metres) * heights_m, [0, 0, 1])
        after, rest = (_solved(rpc, mended, xy_px, covariance, kind) for kind in (fit.kind, "shift"))
        if after is None or rest is None:
            continue
        gain = max(before.square_sum, 1e-300) / max(after.square_sum, 1e-300)
        better = redundancy > 0 and gain >= DECIDEDLY**2
        scatter = better and fisher_tail(gain, redundancy, redundancy) < LEVEL / len(units)
        moved = max(float(np.linalg.norm(shift.values - rest.values)), 1e-300)
        met = (rest.length / moved) ** 2 / np.e * len(units)
        far = prior is None or _ratio(shift.values, prior) > FAR >= _ratio(rest.values, prior)
        level = gain * DECIDEDLY**2 >= 1 and far and met < (MET_UNSTATED if prior is None else MET)
        if scatter or level:
            shifts, rms = (shift.length, rest.length), (before.rms, after.rms)
            found.append((after.square_sum, HeightUnit(name=name, shift_px=shifts, rms_px=rms)))
    return min(found, key=lambda f: f[0])[1] if found else None


def check_height_unit(
    rpc: Rpc, geographic: Array, heights_m: Array, xy_px: Array, covariance: Array, fit: BiasFit
) -> None:
    """Raise NotSolvable where the heights of control are in another unit; arguments as of `height_unit`."""
    found = height_unit(rpc, geographic, heights_m, xy_px, covariance, fit)
    if found is None:
        return
    (shift, shift_then), (rms, rms_then) = found.shift_px, found.rms_px
    raise NotSolvable(
        "scene_control.height_unit",
        unit=found.name,
        factor=UNITS[found.name],
        shift_px=shift,
        rms_px=rms,
        shift_then_px=shift_then,
        rms_then_px=rms_then,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class _Solved:
    """A bias on points with heights in one unit."""

    values: Array
    square_sum: float
    rms: float

    @property
    def length(self) -> float:
        return float(np.linalg.norm(self.values))


def _solved(rpc: Rpc, geographic: Array, xy_px: Array, covariance: Array, kind: BiasKind) -> _Solved | None:
    try:
        projected = rpc.project(geographic)
    except InputError:  # far above or below the scene
        return None
    uv = (projected - rpc.image_offset) / rpc.image_scale
    solved = solve_bias(kind, uv, xy_px - projected, covariance)
    if solved is None:
        return None
    residuals = xy_px - projected - bias_design(kind, uv) @ solved[0]
    return _Solved(values=solved[0], square_sum=solved[2], rms=float(np.sqrt(np.mean(residuals**2))))


def _ratio(shift: Array, prior: Array) -> float:
    return float(np.sqrt(np.mean((shift / prior) ** 2)))
