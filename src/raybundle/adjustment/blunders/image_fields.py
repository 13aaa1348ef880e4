"""Images whose residuals want an interior orientation of their own: cropped, zoomed, stretched, of another camera.

Where measurements that contradict the approximate orientation are dropped before the adjustment, those that are left of
such an image fit nearly as well as the others', and the size of its residuals shows nothing; their pattern does.
"""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.blunders.wrong_images import SMOOTH, outlying
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import POOR_FIT, Severity
from raybundle.adjustment.result import Adjustment
from raybundle.errors import Value

LARGE = 0.01
"""Displacement, as a share of half the longer side of the format, from which on a field is none of one lens.

Stabilisers and focus move c and the principal point by 0.3 to 7 px from image to image, below 0.3 % of half a format;
focusing at a hundred times c lengthens it by one in a hundred.
"""


def own_field_notices(result: Adjustment) -> list[Notice]:
    """A fault for each image whose field stands out and is larger than one camera's fields are.

    T / k of an image over that of the other images of its camera is held against F as for the size of residuals
    (`wrong_images`), has to be more than POOR_FIT^2, and the field LARGE.  In samples of large blocks only the images
    in them are tested.

    Limits: an image that differs where all do, an image so weakly connected that its orientation and
    points absorb the difference, and whether the image or what it is compared with is wrong.
    """
    if any(n.severity is Severity.FAULT and n.code.startswith("control") for n in result.notices):
        return []  # wrong control bends the images that show it
    work = result.handle.work
    tested = work.spread.own_fields if work is not None and work.spread is not None else ()
    T, left, n = np.zeros(len(result.given.images)), np.zeros(len(result.given.images)), len(result.given.images)
    rms = np.zeros(n)
    for f in tested:
        T[f.image], left[f.image], rms[f.image] = f.square, f.directions, f.rms_px
    named = {i for notice in result.notices if notice.code == "image_contradicts" for i in notice.ids}
    found: list[Notice] = []
    for k, camera in enumerate(result.given.cameras):
        mine = np.flatnonzero((result.given.images.camera == k) & (left >= SMOOTH))
        half = max(camera.width_px, camera.height_px) / 2
        for w in outlying(mine, T, left, rms > LARGE * half):
            name = result.given.images.ids[w.image]
            if name not in named:
                found.append(_notice(name, camera.id, w.ratio, float(rms[w.image]), LARGE * half))
    return found


def _notice(name: str, camera: str, ratio: float, rms_px: float, limit_px: float) -> Notice:
    values: dict[str, Value] = {
        "image": name,
        "camera": camera,
        "ratio": ratio,
        "limit": POOR_FIT,
        "rms_px": rms_px,
        "limit_px": limit_px,
    }
    return Notice(code="image_contradicts.interior", values=values, ids=(name,))
