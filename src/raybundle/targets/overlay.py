"""Photographs with what was found drawn on them; loads OpenCV."""

from __future__ import annotations

import cv2
import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.targets.detect import eight_bits
from raybundle.targets.marks import Marks

NAMED, BARE = (0, 200, 0), (0, 140, 255)
FINE = 4
"""Binary places of the drawing's coordinates."""
CROSS = 4.0
"""Arms of the crosses on corners [px]."""


def overlay(image: Array, found: Marks) -> Array:
    """A colour picture (h, w, 3) uint8, blue first: edges of dots and crosses on corners, names beside them.

    image  (h, w) grey, as it was searched
    """
    picture = cv2.cvtColor(eight_bits(image)[0], cv2.COLOR_GRAY2BGR)
    t = np.linspace(0, 2 * np.pi, 49)
    u = np.stack([np.cos(t), np.sin(t)], axis=1)
    for name, xy, ellipse in zip(found.name, found.xy_px - 0.5, found.ellipse, strict=True):
        dot = bool(np.isfinite(ellipse).all())
        colour = NAMED if name else BARE
        if dot:
            _line(picture, xy + u @ np.linalg.cholesky(ellipse).T, colour)
        else:
            for arm in ([CROSS, CROSS], [CROSS, -CROSS]):
                _line(picture, xy + np.array([arm, [0, 0], [-arm[0], -arm[1]]]), colour)
        if name:
            reach = 1.5 * np.sqrt(ellipse[0, 0]) if dot else CROSS
            x, y = np.round(xy + np.array([reach, -reach])).astype(int)
            cv2.putText(picture, name, (int(x), int(y)), cv2.FONT_HERSHEY_SIMPLEX, 0.5, colour, 1, cv2.LINE_AA)
    return picture


def _line(picture: Array, xy: Array, colour: tuple[int, int, int]) -> None:
    cv2.polylines(picture, [np.round(xy * 2**FINE).astype(np.int32)], False, colour, 1, cv2.LINE_AA, FINE)


def as_png(picture: Array) -> bytes:
    """The picture as a PNG file."""
    _, data = cv2.imencode(".png", picture)
    return data.tobytes()
