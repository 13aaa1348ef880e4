"""Heights of one grid at the cells of another that lies in the same frame; differences of two surfaces."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.surfaces.height_model import HeightModel
from raybundle.surfaces.heights import Heights

SAME = 1e-3
"""Of a cell, by which two grids may be apart and yet have the same cells."""
MAPS = 1 << 15
"""More than images that heights are of: pairs of them are numbered by it"""


def resampled(model: HeightModel, left: float, top: float, scale: float, like: HeightModel) -> HeightModel:
    """The heights at the middles of the cells of another grid, linear between four.

    left, top  upper left corner of the other grid, in cells of this one
    scale      side of the other's cells, in cells of this one

    A cell has a height where all four have one that count.  Standard deviations are those of single heights: what
    lies between is not better known.
    """
    rows, columns = like.shape
    x, y = (start + (np.arange(n) + 0.5) * scale - 0.5 for start, n in ((left, columns), (top, rows)))
    # places that are those of cells but for rounding are theirs
    x, y = (np.where(np.abs(v - np.round(v)) < SAME, np.round(v), v) for v in (x, y))
    h = model.heights
    height = _between(h.height.astype(float), x, y)
    known = np.isfinite(height)
    i, j = (np.clip(np.round(v), 0, n - 1).astype(int) for v, n in ((x, model.shape[1]), (y, model.shape[0])))
    near = {name: getattr(h, name)[j][:, i] for name in ("local", "step", "orientation", "point", "points", "image")}
    if (x != np.round(x)).any() or (y != np.round(y)).any():
        # a place between cells has the steps of all of them
        near["step"] = cv2.dilate(np.nan_to_num(near["step"]).astype(np.float32), np.ones((3, 3)))
    heights = Heights(
        height=height.astype(np.float32), points=np.where(known, near["points"], 0).astype(np.uint16),
        image=np.where(known, near["image"], -1).astype(np.int32),
        step=np.where(known, near["step"], 0).astype(np.float32),
        **{k: np.where(known, near[k], np.nan).astype(np.float32) for k in ("local", "orientation", "point")},
    )  # fmt: skip
    blocks = [-(-n // like.block) for n in (rows, columns)]
    at = [
        np.clip(np.arange(n) * like.block + like.block / 2, 0, size - 1)
        for n, size in zip(blocks, (rows, columns), strict=True)
    ]
    row, column = (
        np.clip((start + v * scale) // model.block, 0, n - 1).astype(int)
        for start, v, n in zip((top, left), at, model.moved.shape[:2], strict=True)
    )
    return replace(
        model, heights=heights, moved=model.moved[row][:, column], block=like.block, cell=like.cell,
        length=model.length / scale, holes=None,
    )  # fmt: skip


def _between(height: Array, x: Array, y: Array) -> Array:
    """(rows, columns) linear between four cells each, at columns x and rows y; NaN where one that counts has none."""
    inside = ((y >= 0) & (y <= height.shape[0] - 1))[:, None] & ((x >= 0) & (x <= height.shape[1] - 1))
    (i, u), (j, v) = (
        (np.clip(np.floor(k), 0, n - 1).astype(int), k - np.floor(k))
        for k, n in zip((x, y), height.shape[::-1], strict=True)
    )
    i2, j2 = (np.minimum(k + 1, n - 1) for k, n in zip((i, j), height.shape[::-1], strict=True))
    found = np.zeros(inside.shape)
    for row, down in ((j, 1 - v), (j2, v)):
        for column, right in ((i, 1 - u), (i2, u)):
            w = down[:, None] * right
            found += np.where(w > 0, w * height[row][:, column], 0.0)
    return np.where(inside, found, np.nan)


def difference(before: HeightModel, after: HeightModel) -> HeightModel:
    """Heights of `after` less those of `before` on the same grid.

    Their noise has nothing in common.  Orientations of one adjustment, which name the same independent errors, do: what
    moves both alike cancels.
    """
    a, b = before.heights, after.heights
    both = np.isfinite(a.height) & np.isfinite(b.height)

    def together(name: str) -> Array:
        return np.where(both, np.hypot(getattr(a, name), getattr(b, name)), np.nan).astype(np.float32)

    pair = np.where(both, a.image.astype(np.int64) * MAPS + b.image, -1)
    _, image = np.unique(pair, return_inverse=True)
    same = before.errors != "" and before.errors == after.errors
    if same:
        moved = after.moved - before.moved
        of_block = np.linalg.norm(moved.astype(float), axis=2)
        of_cells = np.kron(of_block, np.ones((before.block,) * 2))[: both.shape[0], : both.shape[1]]
        orientation = np.where(both, of_cells, np.nan).astype(np.float32)
    else:
        moved = np.concatenate([-before.moved, after.moved], axis=2)
        orientation = together("orientation")
    heights = Heights(
        height=np.where(both, b.height.astype(float) - a.height, np.nan).astype(np.float32), local=together("local"),
        step=np.nan_to_num(together("step")), orientation=orientation, point=together("point"),
        points=np.where(both, np.minimum(a.points, b.points), 0).astype(np.uint16),
        image=np.where(both, image.reshape(both.shape), -1).astype(np.int32),
    )  # fmt: skip
    return HeightModel(
        heights=heights, moved=moved, block=before.block, cell=before.cell, length=max(before.length, after.length),
        apart=max(before.apart, after.apart),
        errors=before.errors if same else "", adjustment=before.adjustment if same else "",
    )  # fmt: skip
