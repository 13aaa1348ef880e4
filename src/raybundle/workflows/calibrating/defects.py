"""What keeps photographs from calibrating a camera, in the words of whoever took them."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.errors import InputError, Message, NotSolvable, as_detail, message
from raybundle.numerics.arrays import Array

COMMON = 6
"""Points that two photographs must share to be compared."""
PAIRS = 200
FLAT = 0.01
"""Distance of points from a projective transformation between two photographs, as a share of their extent, up to which
the object is called flat: ten times what distortion and measurement leave."""
SQUARE = np.radians(15)
"""Angle between views from which on they show a camera constant from a distance at all."""
WORSE = 1.1
"""Ratio of image residuals, spline over the model it started from, from which it fits worse: it holds every other one,
and can only fit as well or better if it was found."""


def flat_only(block: Block) -> Message | None:
    """Why photographs of a flat object do not determine the camera constant; None where they may.

    Between two photographs of a plane lies a projective transformation; where one view is tilted by an angle against
    the other, a circle in one is an ellipse in the other with about the cosine of that angle as the ratio of its axes.
    """
    o = block.observations
    images = np.unique(o.image)
    of = {
        i: dict(zip(o.point[o.image == i].tolist(), np.flatnonzero(o.image == i).tolist(), strict=True))
        for i in images.tolist()
    }
    tilts: list[float] = []
    for a, b in list(combinations(images.tolist(), 2))[:PAIRS]:
        both = sorted(of[a].keys() & of[b].keys())
        if len(both) < COMMON:
            continue
        here, there = (o.xy_px[[of[k][p] for p in both]] for k in (a, b))
        found = _tilt(here, there)
        if found is None:
            return None
        tilts.append(found)
    if not tilts or max(tilts) > SQUARE:
        return None
    return message("calibration.flat_views", angle_deg=np.degrees(max(tilts)), least_deg=np.degrees(SQUARE))


def _tilt(here: Array, there: Array) -> float | None:
    """Angle between two views of a plane, by the affine part of what lies between them; None where it is no plane."""
    a, b = here - here.mean(axis=0), there - there.mean(axis=0)
    size = np.sqrt((b**2).mean())
    a, b = a / np.sqrt((a**2).mean()), b / size
    one, zero = np.ones((len(a), 1)), np.zeros((len(a), 3))
    p = np.concatenate([a, one], axis=1)
    A = np.concatenate([
        np.concatenate([p, zero, -b[:, :1] * p], axis=1), np.concatenate([zero, p, -b[:, 1:] * p], axis=1)
    ])  # fmt: skip
    H = np.linalg.svd(A)[2][-1].reshape(3, 3)
    q = p @ H.T
    if np.abs(q[:, 2]).min() < 1e-9 or np.sqrt((((q[:, :2] / q[:, 2:]) - b) ** 2).mean()) > FLAT:
        return None
    affine = (H[:2, :2] - np.outer(H[:2, 2], H[2, :2]) / H[2, 2]) / H[2, 2]
    s = np.linalg.svd(affine, compute_uv=False)
    return float(np.arccos(np.clip(s[1] / s[0], 0, 1)))


def explained(error: NotSolvable | InputError, block: Block) -> NotSolvable | InputError:
    """The error with the photographs that are missing, where that is what it comes from."""
    why = flat_only(block)
    if why is not None:
        return NotSolvable(why)
    if isinstance(error, NotSolvable):
        return error.worded(message("calibration.not_possible", details=[as_detail(error)]))
    return error


def check_spline(before: Adjustment, after: Adjustment) -> None:
    """Raise NotSolvable where the model spline ended worse than what it started from."""
    old, new = _rms(before), _rms(after)
    for camera in after.adjusted.cameras:
        c = camera.parameters[0]
        if camera.model == "spline" and not (c > 0 and new <= WORSE * old):
            raise NotSolvable("calibration.spline_worse", camera=camera.id, rms_px=new, start_rms_px=old, c_mm=c)


def _rms(a: Adjustment) -> float:
    """Root mean square image residual, for a redundancy share of one [px]."""
    v = a.image_observations.residuals_px[a.image_observations.used]
    return float(np.sqrt((v**2).sum() / max(a.redundancy, 1)))
