"""From tracks to a precise free block: approximate values, least-squares matching, weights from the residuals."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, cast

import numpy as np

from raybundle.adjustment.engine import adjust_block, as_start
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.predict import residuals_px
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera, Images, Observations, Points
from raybundle.block.select import with_rows
from raybundle.block.stored import is_observed_jointly
from raybundle.io.photos.photo import Photo
from raybundle.matching.refine import (
    NEIGHBOURS_FROM,
    Candidates,
    TrackPoints,
    match_candidates,
    refine_tracks,
)
from raybundle.matching.tracks import Tracks
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.orientation.cleaning import clean
from raybundle.orientation.rays import intersect_linear, object_rays, rays_of
from raybundle.platforms.station import sensor_from_object

if TYPE_CHECKING:
    from raybundle.scenes.sensor import SceneSensor

FEATURE_SIGMA_PX = 0.5
"""A-priori standard deviation of a feature; only the ratio to nothing else matters before the weights are known."""
FIRST_FREE = ("c", "K1", "K2")
"""Free at the start, where nothing is precise yet."""
FREE = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S")


FLAT = 1.0e-4
"""Eigenvalue ratio of an intersection below which it has no depth: rays parallel to about 1.2 degrees."""
WEAK_PX = 0.5
"""Standard deviation above which a match says nothing beside the others and is left out."""
SURE = 0.95
"""Least correlation of a point measured where no feature was found."""
NEAR_PX = 2.0
"""Largest distance of such a point from its predicted place."""
SURROUNDINGS = 0.03
"""Share of the format's diagonal within which neighbours tell whether a point is seen."""
MARGIN_PX = 20.0
RISE_M = 500.0
"""Difference of height between two points of a scene's ray."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TieBlock:
    """A block of tie points and what is known of its image points."""

    block: Block
    scale_px: Array
    """(m,) of the features"""
    angle: Array
    """(m,)"""
    not_oriented: tuple[tuple[str, str], ...]
    """images and reasons"""


def free_at_start(camera: Camera) -> tuple[str, ...]:
    """Parameters that the start may move: none of a camera that was given as calibrated."""
    if is_observed_jointly(camera):
        return ()
    if camera.estimate == "auto":
        return FIRST_FREE
    return tuple(s for s in camera.estimate if s in FIRST_FREE)


def free_when_precise(camera: Camera) -> tuple[str, ...]:
    """Parameters that are free once the image points are precise; the final adjustment tests each."""
    if camera.estimate == "auto":
        return tuple(s for s in FREE if s not in ("A", "S"))
    return camera.estimate


def block_of_tracks(
    name: str,
    photos: Sequence[Photo],
    cameras: Sequence[Camera],
    camera_of_photo: Index,
    xy: Sequence[Array],
    t: Tracks,
) -> Block:
    """A block without orientation and coordinates."""
    n, p = len(photos), t.points
    xy_px = np.empty((len(t.image), 2))
    for i in range(n):
        mine = t.image == i
        xy_px[mine] = xy[i][t.feature[mine]]
    nothing = np.full((p, 3), np.nan)
    return Block(
        name=name,
        cameras=tuple(cameras),
        images=Images(
            ids=tuple(photo.name for photo in photos),
            camera=camera_of_photo.astype(np.int32),
            file=tuple(photo.name for photo in photos),
            centre=np.full((n, 3), np.nan),
            rotation=np.full((n, 3, 3), np.nan),
        ),
        observations=Observations(
            image=t.image,
            point=t.point,
            xy_px=xy_px,
            cov_px2=np.tile([FEATURE_SIGMA_PX**2, FEATURE_SIGMA_PX**2, 0.0], (len(t.image), 1)),
        ),
        points=Points(
            ids=tuple(f"t{k + 1}" for k in range(p)), role=np.zeros(p, np.int32), xyz=nothing, sigma=nothing.copy()
        ),
    )


def flat_points(block: Block) -> Mask:
    """(p,) tie points whose rays are nearly parallel: they say nothing of the object and hinder convergence."""
    origin, direction = viewing_lines(block)
    p = len(block.points)
    _, count, ratio = intersect_linear(origin, direction, block.observations.point, p)
    return (count < 2) | (ratio < FLAT) | ~np.isfinite(block.points.xyz).all(axis=1)


def viewing_lines(block: Block) -> tuple[Array, Array]:
    """A point (m, 3) and the unit direction (m, 3) of the ray of every image observation, in object space.

    A scene's rays have no common centre: each is the line through its ground points at two heights.
    """
    o = block.observations
    of_scene = np.array([c.is_scene for c in block.cameras])[block.images.camera][o.image]
    origin, direction = np.empty((len(o), 3)), np.empty((len(o), 3))
    rows = np.flatnonzero(~of_scene)
    if len(rows):
        rays = rays_of(replace(block, observations=_rows(o, rows)) if of_scene.any() else block)
        origin[rows] = block.images.centre[rays.image]
        direction[rows] = object_rays(block.images.rotation[rays.image], rays.direction)
    for i in np.unique(o.image[of_scene]):
        rows = np.flatnonzero(o.image == i)
        camera = block.cameras[int(block.images.camera[i])]
        sensor = cast("SceneSensor", camera.sensor)
        low, high = (sensor.localise(o.xy_px[rows], sensor.height_m + d, camera.parameters) for d in (0.0, RISE_M))
        origin[rows] = low
        direction[rows] = (low - high) / np.linalg.norm(low - high, axis=1, keepdims=True)
    return origin, direction


def _rows(o: Observations, rows: Index) -> Observations:
    return replace(o, image=o.image[rows], point=o.point[rows], xy_px=o.xy_px[rows], cov_px2=o.cov_px2[rows])


@dataclass(frozen=True, slots=True, kw_only=True)
class Weights:
    """Variance of a least-squares match: factor * (covariance from grey values) + floor; of a reference: reference."""

    factor: float = 9.0
    floor_px2: float = 0.03**2
    reference_px2: float = 0.1**2

    def covariance(self, grey: Array, reference: Mask) -> Array:
        """(m, 3) variances and covariances [px^2]."""
        cov = self.factor * grey
        cov[:, :2] += self.floor_px2
        cov[reference] = self.reference_px2, self.reference_px2, 0.0
        return cov


@dataclass(frozen=True, slots=True, kw_only=True)
class PreciseBlock:
    """A block of tie points measured by least-squares matching, with weights that its residuals confirm."""

    block: Block
    weights: Weights
    measured: int
    """image points measured by least-squares matching, references included"""
    offered: int
    added: int
    """image points measured where no feature was found"""
    adjustment: Adjustment


def refine(
    tie: TieBlock,
    image: Callable[[int], Array],
    threads: int,
    progress: Progress = silent,
) -> PreciseBlock:
    """Measure every track again, also where no feature was found, and weigh the measurements by their residuals."""
    o = tie.block.observations
    points = TrackPoints(image=o.image, point=o.point, xy_px=o.xy_px, scale_px=tie.scale_px, angle=tie.angle)
    found = refine_tracks(points, image, threads=threads, progress=progress)
    keep = found.measured
    block = with_rows(replace(tie.block, observations=replace(o, xy_px=found.xy_px)), keep)
    work = _Work(
        block=block, grey=found.cov_px2[keep], reference=found.reference[keep], weights=Weights(),
        rejected=np.zeros(len(block.observations), bool), scale_px=tie.scale_px[keep], angle=tie.angle[keep],
    )  # fmt: skip
    # weights and blunders need no more: the final adjustment converges fully
    options = AdjustmentOptions(threads=threads, tolerance=1e-2)
    result = _settle(work, options, first=31)
    progress("weights", 1 / 3)
    added = _complete(work, image, threads, progress)
    for k in range(2):
        result = _settle(work, options, first=7.0)
        progress("weights", (k + 2) / 3)
    strong = work.grey[:, :2].max(axis=1) * work.weights.factor < WEAK_PX**2
    block = _weighted(work.block, work.weights.covariance(work.grey.copy(), work.reference))
    return PreciseBlock(
        block=with_rows(block, _with_partners(block, ~work.rejected & (strong | work.reference))),
        weights=work.weights,
        measured=int(keep.sum()),
        offered=len(keep),
        added=added,
        adjustment=result,
    )


@dataclass(slots=True)
class _Work:
    """A block whose measurements and weights are being settled."""

    block: Block
    grey: Array
    reference: Mask
    weights: Weights
    rejected: Mask
    scale_px: Array
    angle: Array


def _settle(work: _Work, options: AdjustmentOptions, first: float) -> Adjustment:
    """Clean, adjust with statistics, and take the weights from the residuals."""
    block = _weighted(work.block, work.weights.covariance(work.grey.copy(), work.reference))
    free = {c.id: free_when_precise(c) for c in block.cameras}
    cleaned = clean(block, options, free, rejected=work.rejected, first=first)
    work.rejected = cleaned.rejected
    reasons = tuple("residual" if r else "" for r in work.rejected)
    result = adjust_block(cleaned.block, options, free=free, rejected=reasons)
    work.block = as_start(cleaned.block, result.adjusted)
    work.weights = estimate_weights(result, work.grey, work.reference, work.weights)
    return result


def _with_partners(block: Block, keep: Mask) -> Mask:
    """Rows that stay, without those of points that are left with one ray."""
    rays = np.bincount(block.observations.point[keep], minlength=len(block.points))
    return keep & (rays[block.observations.point] > 1)


def _complete(work: _Work, image: Callable[[int], Array], threads: int, progress: Progress) -> int:
    """Measure points in images that should see them and where no feature was found; the number of rays gained."""
    block, o = work.block, work.block.observations
    used = ~work.rejected
    points = TrackPoints(
        image=o.image[used], point=o.point[used], xy_px=o.xy_px[used], scale_px=work.scale_px[used],
        angle=work.angle[used],
    )  # fmt: skip
    places = candidates(block, points, np.flatnonzero(work.reference[used]))
    found = match_candidates(points, places, image, threads=threads, progress=progress)
    near = np.linalg.norm(found.xy_px - places.xy_px, axis=1) < NEAR_PX
    good = found.good & near & (found.correlation > SURE)
    n = int(good.sum())
    # a ray that had been rejected gives way to the new measurement of the same point in the same image
    images = len(block.images)
    new = places.point[good].astype(np.int64) * images + places.image[good]
    old = ~np.isin(o.point.astype(np.int64) * images + o.image, new)
    work.block = replace(
        block,
        observations=replace(
            o,
            image=np.concatenate([o.image[old], places.image[good]]).astype(np.int32),
            point=np.concatenate([o.point[old], places.point[good]]).astype(np.int32),
            xy_px=np.vstack([o.xy_px[old], found.xy_px[good]]),
            cov_px2=np.vstack([o.cov_px2[old], np.tile([1.0, 1.0, 0.0], (n, 1))]),
        ),
    )
    work.grey = np.vstack([work.grey[old], found.cov_px2[good]])
    work.reference = np.concatenate([work.reference[old], np.zeros(n, bool)])
    work.rejected = np.concatenate([work.rejected[old], np.zeros(n, bool)])
    own = places.reference[good]
    work.scale_px = np.concatenate([work.scale_px[old], points.scale_px[own]])
    work.angle = np.concatenate([work.angle[old], points.angle[own]])
    return n


def candidates(block: Block, points: TrackPoints, references: Index) -> Candidates:
    """Images in which points should be seen, by the orientation and by neighbours that both images see.

    references  rows of the track points from which windows are taken, one of each point
    """
    columns: list[tuple[Index, Index, Array]] = []
    rows_of = [np.flatnonzero(points.image == i) for i in range(len(block.images))]
    for a in range(len(block.images)):
        mine = references[points.image[references] == a]
        if not len(mine):
            continue
        for b in range(len(block.images)):
            _, in_a, in_b = np.intersect1d(points.point[rows_of[a]], points.point[rows_of[b]], return_indices=True)
            if b == a or len(in_a) < NEIGHBOURS_FROM:
                continue
            unseen = mine[~np.isin(points.point[mine], points.point[rows_of[b]])]
            common = points.xy_px[rows_of[a][in_a]]
            unseen = unseen[_near(points.xy_px[unseen], common, block.cameras[block.images.camera[a]])]
            xy, fine = _project(block, b, points.point[unseen], points.xy_px[rows_of[b][in_b]].mean(axis=0))
            columns.append((unseen[fine], np.full(int(fine.sum()), b, np.int32), xy[fine]))
    if not columns:
        none = np.zeros(0, np.int64)
        return Candidates(reference=none, image=none, point=none, xy_px=np.zeros((0, 2)), row=none)
    rows = np.concatenate([c[0] for c in columns])
    return Candidates(
        reference=rows,
        image=np.concatenate([c[1] for c in columns]),
        point=points.point[rows],
        xy_px=np.vstack([c[2] for c in columns]),
        row=np.full(len(rows), -1),
    )


def _near(xy: Array, common: Array, camera: Camera) -> Mask:
    """Whether the third nearest of the common points is near enough to believe that this point is seen as well."""
    from scipy.spatial import KDTree  # noqa: PLC0415

    distance = KDTree(common).query(xy, k=3)[0][:, 2]
    return distance < SURROUNDINGS * float(np.hypot(camera.width_px, camera.height_px))


def _project(block: Block, image: int, point: Index, guess: Array) -> tuple[Array, Mask]:
    """Places (n, 2) [px] of object points in an image, and whether they lie within the format, by Newton steps."""
    camera = block.cameras[block.images.camera[image]]
    if camera.is_scene:
        seen = _roughly_seen(block, image, block.points.xyz[point])
        if not seen.all():  # an orbit has no place for what lies far beyond its scene
            xy, inside = np.tile(guess, (len(point), 1)), np.zeros(len(point), bool)
            if seen.any():
                xy[seen], inside[seen] = _project(block, image, point[seen], guess)
            return xy, inside
    n = len(point)
    xy = np.tile(guess, (n, 1))
    step = np.full((n, 2), np.inf)
    for _ in range(12):
        o = Observations(
            image=np.full(n, image, np.int32), point=point.astype(np.int32), xy_px=xy, cov_px2=np.ones((n, 3))
        )
        with np.errstate(all="ignore"):
            step = residuals_px(replace(block, observations=o), np.arange(n))
        step[~np.isfinite(step)] = 0.0
        longest = np.linalg.norm(step, axis=1, keepdims=True)
        step *= np.minimum(1, camera.width_px / 4 / np.maximum(longest, 1e-9))
        xy = xy + step
    size = np.array([camera.width_px, camera.height_px])
    inside = ((xy > MARGIN_PX) & (xy < size - MARGIN_PX)).all(axis=1) & (np.abs(step).max(axis=1, initial=0) < 0.1)
    P = sensor_from_object(
        block.images.rotation[[image] * n], block.images.centre[[image] * n], block.points.xyz[point]
    )
    return xy, inside & (P[2] < 0)


def _roughly_seen(block: Block, image: int, xyz: Array) -> Mask:
    """Whether points (n, 3) lie in a scene or close to it, by its nominal viewpoint."""
    camera = block.cameras[block.images.camera[image]]
    P = (xyz - block.images.centre[image]) @ block.images.rotation[image].T
    c = cast("SceneSensor", camera.sensor).camera_constant(camera.parameters)
    return (np.abs(c * P[:, :2] / -P[:, 2:]) < 0.6 * camera.size_mm).all(axis=1)


def _weighted(block: Block, cov_px2: Array) -> Block:
    return replace(block, observations=replace(block.observations, cov_px2=cov_px2))


def estimate_weights(result: Adjustment, grey: Array, reference: Mask, before: Weights, classes: int = 10) -> Weights:
    """Variance components by the precision that the grey values promise.

    In classes of equal number, sum v^2 / sum r estimates the variance of an image coordinate (Förstner 1979); a line
    through the classes gives factor and floor.  References are a class of their own.
    """
    s = result.image_observations
    used = np.array([not x for x in s.rejected])
    v2 = (s.residuals_px**2).sum(axis=1)
    r = np.nan_to_num(s.redundancy.sum(axis=1))
    mean = (grey[:, 0] + grey[:, 1]) / 2
    good = used & ~reference & (r > 0.2)
    if good.sum() < 20 * classes:
        return before
    edges = np.quantile(mean[good], np.linspace(0, 1, classes + 1))
    label = np.clip(np.searchsorted(edges, mean, side="right") - 1, 0, classes - 1)
    x, y = np.empty(classes), np.empty(classes)
    for k in range(classes):
        mine = good & (label == k)
        x[k], y[k] = mean[mine].mean(), v2[mine].sum() / max(r[mine].sum(), 1e-9)
    A = np.stack([x, np.ones(classes)], axis=1) / y[:, None]
    factor, floor = np.linalg.lstsq(A, np.ones(classes), rcond=None)[0]
    if floor < 0:
        factor, floor = 1 / float(np.mean(x / y)), 0.0
    if factor < 0:
        factor, floor = 0.0, float(y.mean())
    mine = used & reference & (r > 0.2)
    own = v2[mine].sum() / r[mine].sum() if mine.sum() > 20 else before.reference_px2
    return Weights(
        factor=float(factor), floor_px2=max(float(floor), 0.01**2), reference_px2=float(np.clip(own, 0.02**2, 1.0))
    )


def image_sigma_px(result: Adjustment) -> float:
    """Standard deviation of an image coordinate of mean weight: sigma0 x root mean square of the a-priori ones."""
    s = result.image_observations
    used = np.array([not x for x in s.rejected])
    cov = result.given.observations.cov_px2[used]
    return float(result.sigma0 * np.sqrt(cov[:, :2].mean()))
