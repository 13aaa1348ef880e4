"""Photographs with what was found drawn on them; loads OpenCV."""

from __future__ import annotations

import cv2
import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.targets.detect import Detections, eight_bits

CODED, BARE = (0, 200, 0), (0, 140, 255)
FINE = 4
"""Binary places of the drawing's coordinates."""


def overlay(image: Array, found: Detections) -> Array:
    """A colour picture (h, w, 3) uint8, blue first: edges of the dots, numbers beside them.

    image  (h, w) grey, as it was searched
    """
    picture = cv2.cvtColor(eight_bits(image)[0], cv2.COLOR_GRAY2BGR)
    t = np.linspace(0, 2 * np.pi, 49)
    u = np.stack([np.cos(t), np.sin(t)], axis=1)
    for i in range(len(found)):
        edge = found.xy_px[i] - 0.5 + u @ np.linalg.cholesky(found.ellipse[i]).T
        colour = CODED if found.id[i] >= 0 else BARE
        cv2.polylines(picture, [np.round(edge * 2**FINE).astype(np.int32)], True, colour, 1, cv2.LINE_AA, FINE)
        if found.id[i] >= 0:
            reach = 1.5 * np.sqrt(found.ellipse[i, 0, 0])
            x, y = np.round(found.xy_px[i] + [reach, -reach]).astype(int)
            cv2.putText(
                picture, str(found.id[i]), (int(x), int(y)), cv2.FONT_HERSHEY_SIMPLEX, 0.6, colour, 1, cv2.LINE_AA
            )
    return picture


def as_png(picture: Array) -> bytes:
    """The picture as a PNG file."""
    _, data = cv2.imencode(".png", picture)
    return data.tobytes()
