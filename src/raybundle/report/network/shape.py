"""What the views of a network show: points, images and ellipses, before they are drawn."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.block import Block
from raybundle.numerics.arrays import Array, Index
from raybundle.report.figures.svg import Interval, round_below, span, spread_rows
from raybundle.report.view import View

MOST_ELLIPSES = 250


@dataclass(frozen=True, slots=True, kw_only=True)
class NetworkShape:
    """Which points and images stand in the views, and how far these reach."""

    seen: Index
    """rows of the object points with rays and coordinates"""
    kept: Index
    """those of them within the limits"""
    images: Index
    """rows of the images that took part"""
    limits: tuple[Interval, Interval, Interval]
    """along X, Y and Z; half a per cent of many points may lie outside"""

    @property
    def far(self) -> int:
        """Points outside the limits."""
        return len(self.seen) - len(self.kept)


def network_shape(view: View) -> NetworkShape | None:
    """What is to be drawn of a network; None if nothing has coordinates."""
    xyz, centre = view.adjusted.points.xyz, view.adjusted.images.centre
    seen = np.flatnonzero((view.rays > 0) & np.isfinite(xyz).all(axis=1))
    taken = np.zeros(len(centre), bool)
    taken[view.given.observations.image[view.used]] = True
    images = np.flatnonzero(taken & np.isfinite(centre).all(axis=1))
    if not len(seen):
        return None
    limits = _limits(xyz[seen], centre[images])
    inside = np.all([(xyz[seen, k] >= low) & (xyz[seen, k] <= high) for k, (low, high) in enumerate(limits)], axis=0)
    return NetworkShape(seen=seen, kept=seen[inside], images=images, limits=limits)


def _limits(points: Array, centres: Array) -> tuple[Interval, Interval, Interval]:
    """Extent along each axis; half a per cent of the points may lie outside where there are many."""
    result: list[Interval] = []
    for k in range(3):
        own = points[:, k]
        if len(own) > 200:
            low, high = np.quantile(own, [0.005, 0.995])
            own = own[(own >= low) & (own <= high)]
        result.append(span(own, centres[:, k], margin=0.06))
    widest = max(high - low for low, high in result)
    # a plane network keeps a strip that can be read
    x, y, z = (max(0.0, 0.12 * widest - (high - low)) / 2 for low, high in result)
    return (
        (result[0][0] - x, result[0][1] + x),
        (result[1][0] - y, result[1][1] + y),
        (result[2][0] - z, result[2][1] + z),
    )


def frustum_size(limits: tuple[Interval, Interval, Interval], count: int) -> float:
    """Length at which the viewing pyramid of an image is drawn, in units of object space, where so many are drawn."""
    return 0.045 * max(high - low for low, high in limits) / max(1.0, float(np.sqrt(count / 40)))


def frusta(block: Block, images: Index, size: float) -> Array:
    """Projection centre and four corners of the format before it (n, 5, 3) in object space."""
    corners = np.zeros((len(images), 5, 3))
    for k, i in enumerate(images):
        camera = block.cameras[int(block.images.camera[i])]
        c = abs(next(iter(camera.values.values()), 1.0)) or 1.0
        half = np.clip(camera.size_mm / 2 / c, 0.15, 0.8)
        axes_ = block.images.rotation[i]
        for j, (sx, sy) in enumerate(((-1, -1), (1, -1), (1, 1), (-1, 1)), 1):
            corners[k, j] = size * (sx * half[0] * axes_[0] + sy * half[1] * axes_[1] - axes_[2])
    return corners + block.images.centre[images][:, None]


def ellipse_rows(view: View, shown: Index, length: float) -> tuple[Index, float]:
    """Points whose ellipses are drawn, and a round enlargement; three quarters of them become shorter than a length.

    length  of a major semi-axis as drawn, in units of object space
    returns rows of object points, and 0 where nothing has a standard deviation
    """
    a = view.adjustment
    if a.precision is None:
        return np.zeros(0, np.int32), 0.0
    C = a.precision.object_points[shown]
    known = np.isfinite(C).all(axis=(1, 2)) & (np.trace(C, axis1=1, axis2=2) > 0)
    rows = shown[known]
    rows = rows[spread_rows(len(rows), MOST_ELLIPSES)]
    if not len(rows):
        return np.zeros(0, np.int32), 0.0
    major = np.sqrt(np.linalg.eigvalsh(a.precision.object_points[rows])[:, -1])
    typical = float(np.quantile(major, 0.75))
    return rows.astype(np.int32), (max(1.0, round_below(length / typical)) if typical > 0 else 0.0)


def ellipses(view: View, rows: Index, a: int, b: int) -> tuple[Array, Array]:
    """Error ellipses (1 sigma) in the plane of two object axes: the covariances projected onto it.

    returns  (n, 2) semi-axes, the minor one first, in units of object space, and (n, 2) direction of the major one
    """
    precision = view.adjustment.precision
    assert precision is not None
    C = precision.object_points[rows][:, [a, b]][:, :, [a, b]]
    values, axes_ = np.linalg.eigh(C)
    return np.sqrt(np.maximum(values, 0)), axes_[:, :, 1]
