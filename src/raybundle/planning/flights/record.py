"""A flight as it was flown, from the adjusted block: ground sample distance, flying height, area, overlap."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.spatial import KDTree

from raybundle.block import Block, Role
from raybundle.numerics.arrays import Array, Index, Mask

STEEP = math.cos(math.radians(60))
"""A photograph looks down where its axis is within 60 degrees of the plumb line: nadir, or oblique as surveys fly it"""
ABOVE_M = 10.0
"""Height above the points from which photographs are of a flight where no coordinate system states that the block is of
the earth: a pole does not reach farther"""
CELLS, MOST_GROUND = 160, 20_000
"""Cells of the longer side of the map in which photographs are counted, points that show the height of the ground"""
FAR = 0.01
"""Share of the points on either side that no range and no map holds: some are wrong"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Flight:
    """What was flown; lengths in metres."""

    photographs: int
    gsd_m: float
    """Ground sample distance, median over the object points"""
    gsd_range_m: tuple[float, float]
    """Of 98 % of the object points"""
    height_m: float
    """Median over the photographs of their height above the points that they show"""
    area_one_m2: float
    """Shown by at least one photograph, within the extent of the object points"""
    area_three_m2: float
    """By at least three"""
    rays: float
    """Median number of image points of an object point"""


def flight_of(block: Block, used: Mask, *, on_the_earth: bool) -> Flight | None:
    """The flight that a block in metres is of; None where it is of none.

    block         adjusted, its Z axis up
    used          (m,) image observations that took part
    on_the_earth  whether it stands in a coordinate system; else control or positions must place it, and the photographs
                  be taken from higher than a pole reaches

    A flight is what most photographs of frame cameras say by their geometry: they look down, from above the points that
    they show.  The area takes photographs as central projections onto the ground that the object points show.
    """
    o, metres = block.observations, 0.001 if block.length_unit == "mm" else 1.0
    constant = np.array([c.values.get("c", math.nan) if not c.is_scene else math.nan for c in block.cameras])
    rows = np.flatnonzero(used & np.isfinite(constant[block.images.camera[o.image]]))
    rows = rows[np.isfinite(block.images.centre[o.image[rows]]).all(axis=1)]
    rows = rows[np.isfinite(block.points.xyz[o.point[rows]]).all(axis=1)]
    images = np.unique(o.image[rows])
    if len(images) < 2:
        return None
    height = _heights(block, rows, images)
    down = block.images.rotation[images, 2, 2] > STEEP
    if np.mean(down & (height > 0)) <= 0.5:
        return None
    placed = bool((np.asarray(block.points.role) == Role.CONTROL).any()) or len(block.stations) > 0
    typical = float(np.median(height)) * metres
    if not (on_the_earth or (placed and typical > ABOVE_M)):
        return None
    depth = _depths(block, rows)
    pixel = np.array([np.mean(c.pixel_mm) for c in block.cameras]) / constant
    each = np.abs(depth * pixel[block.images.camera[o.image[rows]]]) * metres
    rays = np.bincount(o.point[rows], minlength=len(block.points))
    gsd = np.bincount(o.point[rows], each, minlength=len(block.points))[rays > 0] / rays[rays > 0]
    low, middle, high = (float(q) for q in np.quantile(gsd, [FAR, 0.5, 1 - FAR]))
    one, three = _areas(block, images, np.flatnonzero(rays > 0), constant)
    return Flight(
        photographs=len(images), gsd_m=middle, gsd_range_m=(low, high), height_m=typical,
        area_one_m2=one * metres**2, area_three_m2=three * metres**2, rays=float(np.median(rays[rays > 0])),
    )  # fmt: skip


def _heights(block: Block, rows: Index, images: Index) -> Array:
    """(n,) of images above the median of the points that they show."""
    o = block.observations
    order = rows[np.argsort(o.image[rows], kind="stable")]
    pieces = np.split(block.points.xyz[o.point[order], 2], np.flatnonzero(np.diff(o.image[order])) + 1)
    return np.asarray(block.images.centre[images, 2] - np.array([np.median(z) for z in pieces]))


def _depths(block: Block, rows: Index) -> Array:
    """(k,) of observed points along the axis of their image."""
    o = block.observations
    away = block.points.xyz[o.point[rows]] - block.images.centre[o.image[rows]]
    return np.asarray(-np.einsum("ni,ni->n", away, block.images.rotation[o.image[rows], 2]))


def _areas(block: Block, images: Index, points: Index, constant: Array) -> tuple[float, float]:
    """Areas that at least one and at least three images show, within the extent of the points."""
    xyz = block.points.xyz[points]
    low, high = np.quantile(xyz, [FAR, 1 - FAR], axis=0)
    near = np.flatnonzero(((xyz >= low) & (xyz <= high)).all(axis=1))
    if len(near) < 3:
        return 0.0, 0.0
    ground = xyz[near[np.linspace(0, len(near) - 1, min(len(near), MOST_GROUND)).astype(int)]]
    (x0, y0), (x1, y1) = ground[:, :2].min(axis=0), ground[:, :2].max(axis=0)
    side = max(x1 - x0, y1 - y0) / CELLS
    if side <= 0:
        return 0.0, 0.0
    x, y = (a + side * (np.arange(max(1, math.ceil((b - a) / side))) + 0.5) for a, b in ((x0, x1), (y0, y1)))
    plan = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    z = np.median(ground[KDTree(ground[:, :2]).query(plan, k=min(3, len(ground)))[1], 2].reshape(len(plan), -1), axis=1)
    cells = np.column_stack([plan, z])
    count = np.zeros(len(cells), np.int32)
    for i in images.tolist():
        camera = block.cameras[int(block.images.camera[i])]
        seen = (cells - block.images.centre[i]) @ block.images.rotation[i].T
        depth = -seen[:, 2]
        half = depth[:, None] * (camera.size_mm / 2 / abs(constant[block.images.camera[i]]))
        count += (depth > 0) & (np.abs(seen[:, :2]) <= half).all(axis=1)
    return float((count >= 1).sum()) * side**2, float((count >= 3).sum()) * side**2
