"""What keeps photographs from calibrating a camera, in the words of whoever took them."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.errors import InputError, NotSolvable
from raybundle.numerics.arrays import Array
from raybundle.settings import option

CANNOT = "the camera cannot be calibrated from these photographs"
COMMON = 6
"""Points that two photographs must share to be compared."""
PAIRS = 200
FLAT = 0.01
"""Distance of points from a projective transformation between two photographs, as a share of their extent, up to which
the object is called flat: ten times what distortion and measurement leave."""
SQUARE = np.radians(15)
"""Angle between views from which on they tell a camera constant from a distance at all."""
WORSE = 1.1
"""Ratio of image residuals, spline over the model it started from, from which it fits worse: it holds every other one,
and can only fit as well or better if it was found."""


def flat_only(block: Block) -> str:
    """Why photographs of a flat object cannot tell the camera constant; "" where that is not what is missing.

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
            return ""
        tilts.append(found)
    if not tilts or max(tilts) > SQUARE:
        return ""
    return (
        f"the photographs show something flat from nearly the same direction: their views differ by "
        f"{np.degrees(max(tilts)):.0f} degrees at most, {np.degrees(SQUARE):.0f} are the least. Seen squarely, a flat "
        "object twice as far away through twice the camera constant looks the same, so that nothing tells the camera. "
        "What is missing are photographs that converge: from the left, the right, above and below, 30 to 45 degrees "
        "off the normal, some with the camera rolled by 90 degrees"
    )


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
    """The error in words that say which photographs are missing, where that is what it comes from."""
    why = flat_only(block)
    if why:
        return NotSolvable(f"{CANNOT}: {why}")
    if isinstance(error, NotSolvable):
        return error.worded(
            f"{CANNOT}: {error}\n  `calibrate` needs 6 to 20 photographs "
            "of the same points that converge by 30 to 45 degrees, some rolled by 90 degrees; leave out photographs "
            "that are named here"
        )
    return error


def check_spline(before: Adjustment, after: Adjustment) -> None:
    """Raise NotSolvable where the model spline ended worse than what it started from."""
    old, new = _rms(before), _rms(after)
    for camera in after.adjusted.cameras:
        c = camera.parameters[0]
        if camera.model == "spline" and not (c > 0 and new <= WORSE * old):
            raise NotSolvable(
                f"camera {camera.id}: the model spline ends worse than the model it started from: residuals of "
                f"{new:.2g} px in place of {old:.2g} px, camera constant {c:.3g} mm. Its surfaces are not determined "
                f"by these photographs; leave {option('model')} away, or take more that cover the format to its corners"
            )


def _rms(a: Adjustment) -> float:
    """Root mean square image residual, for a redundancy share of one [px]."""
    v = a.image_observations.residuals_px[a.image_observations.used]
    return float(np.sqrt((v**2).sum() / max(a.redundancy, 1)))
