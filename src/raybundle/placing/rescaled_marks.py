"""Marks that were measured in reduced copies of the photographs: recognised by where their rays meet, and stated.

Programs that collect marks in a browser show copies of 2000 or 2400 px.  Such marks lie inside the photographs all
right, and contradict each other by hundreds of pixels; tested one by one, each of them seems to be a blunder.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block
from raybundle.io.geo.control_files import ControlFile
from raybundle.numerics.arrays import Array, Index
from raybundle.placing.marks import GROSS, Placing, intersected

USUAL = (
    640, 800, 1000, 1024, 1200, 1280, 1440, 1500, 1600, 1800, 1920, 2000, 2048, 2400, 2500, 2560, 3000, 3200, 3840,
    4000, 4096,
)  # fmt: skip
"""Long sides [px] to which programs reduce photographs."""
LARGEST = 8.0
"""Reduction up to which copies are looked for; marks in smaller ones are worth little."""
CHANCE = 1e-3
"""Probability of agreement by chance up to which a size is believed.

A ray of a wrong mark passes within q of a place that other rays give with a probability of about 2 q / long side for
each surplus coordinate; `SIZES` are tried."""
SIZES = 120
"""Sizes between full and full / `LARGEST`, 2 % apart."""
POINTS = 20
"""Points that the search looks at; more of them change nothing but its time."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Size:
    """The copies in which the marks of a file were measured."""

    long_side: float
    """[px]"""
    sigma: float
    """[px]; 0 where a usual size explains it"""
    before: float
    """Median distance of marks from where the others put them, as they stand [px of the photographs]"""
    after: float
    """The same at this size"""
    marks: int
    """Marks that were looked at"""


def take_at_their_size(state: Placing, control: Sequence[ControlFile], mark_px: float) -> None:
    """Bring marks of each control file to the size of the photographs, where they were measured in smaller copies."""
    for file in control:
        mine = {name: k for k, name in enumerate(state.block.points.ids)}
        points = np.array([mine[n] for n in file.ids if n in mine], np.int32)
        found = size_of_copies(state.block, points, mark_px)
        if found is None:
            continue
        block, rows = state.block, np.flatnonzero(np.isin(state.block.observations.point, points))
        o, factor = block.observations, _factors(block, rows, found.long_side)
        xy, cov = o.xy_px.copy(), o.cov_px2.copy()
        xy[rows] *= factor[:, None]
        cov[rows] *= factor[:, None] ** 2
        if found.sigma > 0:  # the size's own uncertainty moves a mark along its distance from the corner
            step = xy[rows] * (found.sigma / found.long_side)
            cov[rows] += np.column_stack([step[:, 0] ** 2, step[:, 1] ** 2, step[:, 0] * step[:, 1]])
        state.block = replace(block, observations=replace(o, xy_px=xy, cov_px2=cov))
        state.notices.append(_notice(file, found, float(_long_sides(block)[o.image[rows]].max())))


def size_of_copies(block: Block, points: Index, mark_px: float) -> Size | None:
    """The size at which the marks of points agree, where they do not as they stand; None where they do, or never do.

    block   free and oriented; its orientation does not depend on the marks
    points  (k,) rows of points with marks
    mark_px standard deviation of a mark in its picture [px]

    As they stand more than half of the marks must lie beyond the gross limit, and at the size found at least half
    within it, more closely than chance would bring them (`CHANCE`).

    Limits: copies that were cropped or turned besides.
    """
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    points = points[rays[points] > 1][:POINTS]
    rows = np.flatnonzero(np.isin(block.observations.point, points))
    if len(rows) == 0:
        return None
    limit, full = GROSS * mark_px, float(_long_sides(block)[block.observations.image[rows]].max())

    def apart(side: float) -> Array:
        """(n,) distances in pixels of the copies."""
        return _distances(block, rows, side)

    before = apart(full)
    if np.median(before) <= limit:
        return None
    sizes = np.geomspace(full / LARGEST, 0.98 * full, SIZES)
    k = int(np.argmin([np.median(apart(float(s))) for s in sizes]))
    ends = float(sizes[max(k - 1, 0)]), float(sizes[min(k + 1, len(sizes) - 1)])
    side = _least(lambda s: float((np.minimum(apart(s), limit) ** 2).sum()), ends)
    distance = apart(side)
    near = distance <= limit
    seen = np.bincount(block.observations.point[rows][near], minlength=len(block.points))
    redundancy = int(np.maximum(2 * seen - 3, 0).sum()) - 1
    if np.median(distance) > limit or redundancy < 1:
        return None
    if SIZES * (2 * float(distance[near].max()) / side) ** redundancy > CHANCE:
        return None
    sigma = _sigma(apart, side, distance, near, redundancy, mark_px)
    usual = [s for s in (*USUAL, full / 2, full / 3, full / 4, full / 8) if abs(s - side) <= 3.3 * sigma and s < full]
    best = min(usual, key=lambda s: abs(s - side), default=side)
    return Size(
        long_side=best, sigma=0.0 if usual else sigma, before=float(np.median(before)),
        after=float(np.median(apart(best) * full / best)), marks=len(rows),
    )  # fmt: skip


def _least(cost: Callable[[float], float], ends: tuple[float, float]) -> float:
    """Where a function is least between two ends."""
    from scipy.optimize import minimize_scalar

    found: Any = minimize_scalar(cost, bounds=ends, method="bounded", options={"xatol": 0.1})
    return float(found.x)


def _sigma(
    apart: Callable[[float], Array], side: float, distance: Array, near: Array, redundancy: int, mark_px: float
) -> float:
    """Standard deviation of the size: how fast marks that agree part with it, beside how well they agree."""
    step = 0.02 * side
    speed = (np.abs(apart(side + step) - distance) + np.abs(apart(side - step) - distance))[near] / (2 * step)
    spread = max(float(np.sqrt((distance[near] ** 2).sum() / redundancy)), mark_px)
    return spread / float(np.sqrt(max((speed**2).sum(), 1e-12)))


def _distances(block: Block, rows: Index, side: float) -> Array:
    """(n,) distances of marks from where the others put them if measured in copies of this size [px of these]."""
    factor = _factors(block, rows, side)
    xy = block.observations.xy_px[rows] * factor[:, None]
    o = block.observations
    few = replace(o.rows(rows), xy_px=xy)
    scaled = replace(block, observations=few)
    free = intersected(scaled)
    xyz = np.where(np.isfinite(free), free, block.points.xyz)
    v = residuals_px(replace(scaled, points=replace(block.points, xyz=xyz)), np.arange(len(rows)))
    distance = np.linalg.norm(v, axis=1) / factor
    return np.where(np.isfinite(distance), distance, np.inf)


def _long_sides(block: Block) -> Array:
    """(n,) long side of each image [px]."""
    return np.array([max(c.width_px, c.height_px) for c in block.cameras], float)[block.images.camera]


def _factors(block: Block, rows: Index, side: float) -> Array:
    return _long_sides(block)[block.observations.image[rows]] / side


def _notice(file: ControlFile, found: Size, full: float) -> Notice:
    return Notice(
        code="marks_reduced", ids=(str(file.path.name),),
        values={
            "table": file.path.name, "side_px": found.long_side, "sigma_px": found.sigma, "exact": found.sigma == 0,
            "full_px": full, "factor": full / found.long_side, "before_px": found.before, "after_px": found.after,
            "marks": found.marks,
        },
    )  # fmt: skip
