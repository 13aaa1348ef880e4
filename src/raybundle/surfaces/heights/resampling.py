"""Heights of one grid at the cells of another that lies in the same frame; differences of two surfaces."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.heights.height_model import Blocks, HeightModel, Holes
from raybundle.surfaces.heights.heights import Heights
from raybundle.surfaces.heights.hole_filling import parts_of
from raybundle.surfaces.heights.nodes import at_places, variances

SAME = 1e-3
"""Of a cell, by which two grids may be apart and yet have the same cells."""
ONE_SURFACE = 0.1
"""Share of the cells with the very same measurement from where two surfaces that orientation moves by the same are of
one orientation; by chance far fewer agree."""
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
    row, column = (
        (start + np.arange(-(-n // like.block) + 1) * like.block * scale) / model.block
        for start, n in ((top, rows), (left, columns))
    )
    holes = None
    if model.holes is not None:
        number, sigma = (np.where(known, a[j][:, i], 0) for a in (model.holes.number, model.holes.sigma))
        holes = Holes(number=number, sigma=sigma.astype(np.float32))
    blocks = model.blocks
    if blocks is not None:
        blocks = Blocks(sigma=np.where(known, blocks.sigma[j][:, i], 0).astype(np.float32), reach=blocks.reach / scale)
    return replace(
        model, heights=heights, blocks=blocks, moved=at_places(model.moved, row, column).astype(np.float32),
        block=like.block, cell=like.cell, length=model.length / scale, holes=holes,
        factors=None if model.factors is None else np.where(known[..., None], model.factors[j][:, i], 0),
        levels=None if model.levels is None else at_places(model.levels, row, column),
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
    moves both alike cancels.  Cells that both have from one measurement, as a surface and its ground, differ by nothing
    at all.
    """
    a, b = before.heights, after.heights
    both = np.isfinite(a.height) & np.isfinite(b.height)
    one = one_measurement(before, after)

    def together(name: str) -> Array:
        found = np.where(one, 0.0, np.hypot(getattr(a, name), getattr(b, name)))
        return np.where(both, found, np.nan).astype(np.float32)

    pair = np.where(both, a.image.astype(np.int64) * MAPS + b.image, -1)
    _, image = np.unique(pair, return_inverse=True)
    moves = _moves_of(before, after, one, both)
    same = moves.of_one
    if same:
        of_cells = np.sqrt(variances(moves.moved, before.block, before.shape, factors=moves.factors))
        orientation = np.where(both, of_cells, np.nan).astype(np.float32)
    else:
        orientation = np.where(both, np.hypot(a.orientation, b.orientation), np.nan).astype(np.float32)
    heights = Heights(
        height=np.where(both, b.height.astype(float) - a.height, np.nan).astype(np.float32), local=together("local"),
        step=np.nan_to_num(together("step")), orientation=orientation, point=together("point"),
        points=np.where(both, np.minimum(a.points, b.points), 0).astype(np.uint16),
        image=np.where(both, image.reshape(both.shape), -1).astype(np.int32),
    )  # fmt: skip
    return HeightModel(
        heights=heights, moved=moves.moved, factors=moves.factors, block=before.block, cell=before.cell,
        length=max(before.length, after.length), apart=max(before.apart, after.apart),
        holes=_holes_of(before, after, both), blocks=_blocks_of(before, after, both & ~one),
        errors=before.errors if same else "", adjustment=before.adjustment if same else "",
    )  # fmt: skip


def one_measurement(before: HeightModel, after: HeightModel) -> Mask:
    """Which cells two surfaces on one grid have from one measurement."""
    a, b = before.heights, after.heights
    known = np.isfinite(a.height) & np.isfinite(b.height)
    return known & (a.height == b.height) & (a.local == b.local) & (a.image == b.image)


def _blocks_of(before: HeightModel, after: HeightModel, both: Mask) -> Blocks | None:
    """Errors by blocks of compression of either: other photographs have other parallaxes."""
    there = [m.blocks for m in (before, after) if m.blocks is not None]
    if not there:
        return None
    sigma = np.where(both, np.linalg.norm([b.sigma for b in there], axis=0), 0.0)
    return Blocks(sigma=sigma.astype(np.float32), reach=max(b.reach for b in there))


@dataclass(frozen=True, slots=True, kw_only=True)
class _Moves:
    """How errors move differences."""

    moved: Array
    factors: Array | None
    of_one: bool
    """the errors are those of both"""


def _moves_of(before: HeightModel, after: HeightModel, one: Mask, both: Mask) -> _Moves:
    """By the parts of both, those before with the opposite sign; what has one factor in both counts once."""
    a, b = before.moved, after.moved
    alike = np.array_equal(a, b)
    of_one = (before.errors != "" and before.errors == after.errors) or (
        alike and bool(one.sum() >= ONE_SURFACE * both.sum())
    )
    F = [m.factors for m in (before, after) if m.factors is not None]
    if of_one and alike and len(F) == 2:
        # a slope may be of neighbours that were replaced, but not the height
        return _Moves(moved=b, factors=np.where(one[..., None], 0, F[1] - F[0]), of_one=True)
    if not of_one:
        none = [np.zeros((*m.shape[:3], n), np.float32) for m, n in ((a, b.shape[3]), (b, a.shape[3]))]
        a, b = np.concatenate([a, none[0]], axis=3), np.concatenate([none[1], b], axis=3)
    if not F:
        return _Moves(moved=b - a, factors=None, of_one=of_one)
    # shifts upwards, the first part, count once in each
    ones = np.ones((*both.shape, 1), F[0].dtype)
    moved = np.concatenate([b[:, :, :1] - a[:, :, :1], -a[:, :, 1:], b[:, :, 1:]], axis=2)
    return _Moves(moved=moved, factors=np.concatenate([ones, *(f[..., 1:] for f in F)], axis=2), of_one=of_one)


def _holes_of(before: HeightModel, after: HeightModel, both: Mask) -> Holes | None:
    """What was filled in either: parts that touch count as one hole."""
    found = [m.holes.sigma.astype(float) ** 2 for m in (before, after) if m.holes is not None]
    if not found:
        return None
    variance = np.where(both, sum(found), 0.0)
    number, _ = parts_of(variance > 0)
    return Holes(number=number, sigma=np.sqrt(variance).astype(np.float32))
