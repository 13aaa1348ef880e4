"""Which object points and images the page of a network holds where it cannot hold all: its level of detail."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.block import Role
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.thinning import one_of_each_cell
from raybundle.report.figures.svg import spread_rows
from raybundle.report.view import View

MOST_POINTS, MOST_IMAGES = 50_000, 20_000
"""Points that a screen resolves, a point on 6 x 6 of its pixels; images, whose pyramids are 100 bytes each"""
POINT_BYTES = 6_000_000
"""Of the points with their rays: with the program and the images a page stays below 10 MB"""
WORST = 10
"""One in so many points is there for being the worst determined"""
TRIES = 8


@dataclass(frozen=True, slots=True)
class Detail:
    """Rows of the object points of a page, ascending, and how they were chosen."""

    points: Index
    cell: float = 0.0
    """Edge of the cells of which each that holds tie points shows one [length unit of the block]; 0: all are there"""
    worst: int = 0
    """How many are there for their large standard deviations"""


def detail_of(view: View) -> Detail:
    """The points of the page: control, check and named points, and of tie points as many as it can hold.

    Where there are more, a tie point from each cell of a regular grid, the finest with as many occupied cells as there
    is room for, so that the outline stays, to a cell, however unevenly points lie; and those with the largest
    standard deviations of a coordinate.

    Limits: how densely points lie, within a cell.
    """
    known = (view.rays > 0) & np.isfinite(view.adjusted.points.xyz).all(axis=1)
    tie = known & (np.asarray(view.given.points.role) == Role.TIE) & ~view.given.points_named
    special = np.flatnonzero(known & ~tie)
    special = special[spread_rows(len(special), MOST_POINTS // 2)].astype(np.int32)
    rows = np.flatnonzero(tie).astype(np.int32)
    cost = _bytes(view)
    room = max(MOST_POINTS - len(special), 0)
    left = POINT_BYTES - float(cost[special].sum())
    if len(rows) <= room and cost[rows].sum() <= left:
        return Detail(np.sort(np.concatenate([special, rows])))
    room = min(room, int(left / max(float(cost[rows].mean()), 1.0)))
    found, cell, worst = _sample(view, rows, room)
    for _ in range(TRIES):
        total = float(cost[found].sum())
        if total <= left or not room:
            break
        room = int(0.95 * room * left / total)
        found, cell, worst = _sample(view, rows, room)
    return Detail(np.sort(np.concatenate([special, found])).astype(np.int32), cell, worst)


def _bytes(view: View) -> Array:
    """(p,) what each point takes in the page: its id, 31 bytes of numbers and 4 a ray, in base64."""
    ids = np.fromiter(map(len, view.given.points.ids), float, len(view.given.points))
    return ids + 3 + 4 / 3 * (31 + 4 * np.asarray(view.rays, float))


def _sample(view: View, rows: Index, room: int) -> tuple[Index, float, int]:
    """Some of the points, edge of their cells, and how many of them are the worst determined."""
    std = np.full(len(rows), np.nan) if view.std is None else np.sqrt(np.mean(np.square(view.std[rows]), axis=1))
    order = np.argsort(np.where(np.isfinite(std), -std, np.inf), kind="stable")
    worst = order[: min(room // WORST, int(np.isfinite(std).sum()))]
    first, cell = one_of_each_cell(view.adjusted.points.xyz[rows], room - len(worst))
    return rows[np.union1d(worst, first)], cell, len(worst)


def shown_images(view: View) -> Index:
    """Rows of the images of the page: oriented, and with a used observation."""
    taken = np.zeros(len(view.given.images), bool)
    taken[view.given.observations.image[view.used]] = True
    rows = np.flatnonzero(taken & view.adjusted.images.oriented)
    return rows[spread_rows(len(rows), MOST_IMAGES)].astype(np.int32)
