"""Photographs that were cropped off the centre: a camera of their own format with its principal point far off."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment

OFF = 0.1
"""Of a side of the format from which on a principal point is no lens's: two standard deviations of what is assumed of a
camera that nothing is known of, and five times what lenses have."""
SURE = 5.0
"""Standard deviations by which the offset must differ from zero."""


def cropped_notices(result: Adjustment) -> list[Notice]:
    """The photographs of each camera with an estimated principal point far off the middle of the format.

    Limits: shift lenses; crops about the middle, and crops that were enlarged to the format of the others.
    """
    notices = list[Notice]()
    images = result.adjusted.images
    cameras = {camera.id: (k, camera) for k, camera in enumerate(result.adjusted.cameras)}
    for interior in result.interior:
        if interior.camera not in cameras:  # an antenna or IMU
            continue
        k, camera = cameras[interior.camera]
        off = 0.0
        for symbol, side in zip(("x0", "y0"), camera.size_mm.tolist(), strict=True):
            p = interior.parameters.get(symbol)
            if p is not None and p.std and abs(p.value) > SURE * p.std:
                off = max(off, abs(p.value) / side)
        names = tuple(images.ids[i] for i in np.flatnonzero((images.camera == k) & images.oriented))
        if names and off > OFF:
            notices.append(
                Notice(code="cropped_photographs", ids=names, values={"camera": camera.id, "off": off, "limit": OFF})
            )
    return notices
