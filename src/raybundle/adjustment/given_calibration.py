"""What becomes of a calibration that was given with its covariance: whether it still holds, and what it is left to say.

Observations are weighted by white noise alone.  Where their errors are smooth, photographs have more weight against a
calibration than they deserve; standard deviations that contain such errors (noise of kind fields) show it: a parameter
may come out less precise than it was given.
"""

from __future__ import annotations

import numpy as np
from scipy.special import chdtri

from raybundle.adjustment.known_before import LEVEL
from raybundle.adjustment.result import Adjustment, InteriorResult, Notice
from raybundle.block import Camera
from raybundle.block.stored import joint_covariance

WIDER = 1.1
"""Ratio of the standard deviations, afterwards and as given, from which on the calibration was outweighed: standard
deviations are stated to two digits."""


def calibration_notices(result: Adjustment) -> tuple[Notice, ...]:
    """What there is to say of cameras that were given with the covariance of their calibration."""
    cameras = {c.id: c for c in result.given.cameras}
    found: list[Notice] = []
    for interior in result.interior:
        camera = cameras[interior.camera]
        symbols, covariance = joint_covariance(camera)
        if covariance is None or interior.image is not None:
            continue
        found += _contradicted(result, camera)
        found += _outweighed(camera, interior, dict(zip(symbols, np.sqrt(np.diagonal(covariance)), strict=True)))
    return tuple(found)


def _contradicted(result: Adjustment, camera: Camera) -> list[Notice]:
    """Where the interior orientation lies beyond the calibration: v' C^-1 v, chi-square distributed or smaller."""
    square, count = 0.0, 0
    for g in result.groups:
        for k, (name, origin) in enumerate(zip(g.ids, g.origin, strict=False)):
            if name == camera.id and origin == "calibration":
                square, count = square + float((g.residual[k] / g.sigma[k]) ** 2), count + 1
    limit = float(chdtri(count, LEVEL)) if count else np.inf
    if not square > limit:
        return []
    message = (
        f"camera {camera.id}: the photographs contradict its calibration (chi-square {square:.0f} of {count}, limit "
        f"{limit:.1f} at {100 * LEVEL:g} %): focus, zoom or mounting was another, or the errors of the photographs are "
        "smooth, which their weights do not know. Calibrate under the conditions of the photographs, or hold the "
        "calibration (estimate = [])"
    )
    return [Notice(code="calibration_contradicted", message=message, ids=(camera.id,))]


def _outweighed(camera: Camera, interior: InteriorResult, given: dict[str, float]) -> list[Notice]:
    """Parameters that the result states less precisely than the calibration did."""
    told: list[str] = []
    for symbol, before in given.items():
        after = interior.parameters[symbol].std if symbol in interior.parameters else None
        if after is not None and after > WIDER * before:
            told.append(f"{symbol} {before:.2g} before, {after:.2g} now")
    if not told:
        return []
    message = (
        f"camera {camera.id}: the result knows it less precisely than the calibration that was given (standard "
        f"deviations of {'; '.join(told)}): observations are weighted as if their errors were independent, and draw it "
        "from values that are known better. To keep these, hold the calibration (estimate = [])"
    )
    return [Notice(code="calibration_outweighed", message=message, ids=(camera.id, *given))]
