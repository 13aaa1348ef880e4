"""A strip of level ground: a road, a river bank, an excavation trench."""

from __future__ import annotations

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array
from raybundle.objects.kinds.base import ObjectKind, grid_triangles
from raybundle.objects.surface import Surface

SHARP = 0.2
"""Least cosine of half a turn: the strip is not drawn wider than five times its width where its axis turns back."""


class Corridor(ObjectKind):
    """Along X from the origin, or along the axis given; Z = 0."""

    name = "corridor"
    about = "a strip of level ground along an axis"
    numbers = ("length", "width")
    line = "the axis of a corridor (X, Y)"
    line_for = 1
    side = "above"
    example = (60.0, 8.0)

    def made(self, numbers: tuple[float, ...], line: Array | None) -> Surface:
        """Two rows of vertices beside the axis, mitred where it turns."""
        width = numbers[-1]
        axis = np.array([[0.0, 0.0], [numbers[0], 0.0]]) if line is None else line
        ahead = np.diff(axis, axis=0)
        ahead = ahead / np.linalg.norm(ahead, axis=1, keepdims=True)
        before, after = np.vstack([ahead[:1], ahead]), np.vstack([ahead, ahead[-1:]])
        mean = before + after
        turned_back = np.linalg.norm(mean, axis=1) < 1e-9
        mean[turned_back] = after[turned_back]
        mean = mean / np.linalg.norm(mean, axis=1, keepdims=True)
        left = np.stack([-mean[:, 1], mean[:, 0]], axis=1)
        half = width / 2 / np.maximum(np.sum(mean * after, axis=1, keepdims=True), SHARP)
        rows = np.concatenate([axis - half * left, axis + half * left])
        length = float(np.linalg.norm(np.diff(axis, axis=0), axis=1).sum())
        return Surface(
            name="corridor", vertices=np.column_stack([rows, np.zeros(len(rows))]),
            triangles=grid_triangles(2, len(axis)),
            about=phrase("object_size.corridor", length_m=length, width_m=width),
        )  # fmt: skip
