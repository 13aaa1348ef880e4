"""Tie points measured precisely: least-squares matching, completion, weights from the residuals.

Nothing that the start has oriented is lost here: a photograph of which matching measures too little keeps the positions
of its features, with a standard deviation of their own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, cast

import numpy as np

from raybundle.adjustment.blunders.collinear_points import any_in_line
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.adjusted_values import as_start
from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Block, Camera, Observations
from raybundle.block.rejection import Rejection, RejectionKind
from raybundle.block.select import with_rows, without_images
from raybundle.errors import NotSolvable, phrase
from raybundle.matching.least_squares import FIGURES
from raybundle.matching.refine import (
    NEIGHBOURS_FROM,
    WINDOWS,
    Candidates,
    Matcher,
    TrackPoints,
    refine_tracks,
)
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.rows import rows_of_each
from raybundle.orientation.cleaning import clean
from raybundle.orientation.rays import common_counts, intersect_linear
from raybundle.ties.block import (
    FEATURE_SIGMA_PX,
    TieBlock,
    free_when_precise,
    object_pixel,
    viewing_lines,
)
from raybundle.ties.curvature import without_curvature
from raybundle.ties.match_weights import Matches, Weights, estimate_weights
from raybundle.ties.relief import misfit_and_relief

if TYPE_CHECKING:
    from raybundle.scenes.sensor import SceneSensor

Visible = Callable[[Index, Array, Array], Mask]
"""Whether images (k,) show at places (k, 2) what may be measured, within radii (k,) [px]: no mask reaches in."""
SURE = 0.95
"""Least correlation of a point measured where no feature was found."""
NEAR_PX = 2.0
"""Largest distance of such a point from its predicted place."""
SURROUNDINGS = 0.03
"""Share of the format's diagonal within which neighbours show whether a point is seen."""
MARGIN_PX = 20.0
FEWEST_HELD = 6
"""Points that hold an image which the start has oriented: as many redundant coordinates as unknowns."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PreciseBlock:
    """A block of tie points measured by least-squares matching, with weights that its residuals confirm."""

    block: Block
    weights: Weights
    matches: Matches
    """of the image points of `block`"""
    measured: int
    """image points measured by least-squares matching, references included"""
    offered: int
    added: int
    """image points measured where no feature was found"""
    features_kept: int = 0
    """image points that keep the position of their feature"""
    by_features: tuple[str, ...] = ()
    """images that keep positions of features: matching measured too little in them"""
    left_out: tuple[tuple[str, str], ...] = ()
    """images that nothing holds, and why"""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Spare:
    """Features that matching did not measure; a photograph that needs them takes them."""

    image: Index
    point: Index
    """in the start's block"""
    xy_px: Array
    scale_px: Array
    angle: Array


@dataclass(slots=True)
class _Work:
    """A block whose measurements and weights are being settled."""

    start: Block
    spare: _Spare
    block: Block
    grey: Array
    level: Index
    window_px: Array
    residual: Array
    reference: Mask
    feature: Mask
    weights: Weights
    rejected: Mask
    scale_px: Array
    angle: Array
    fallen: set[int] = field(default_factory=set[int])
    """images that keep features"""
    left_out: dict[int, str] = field(default_factory=dict[int, str])
    held: bool = False
    """whether the cameras are held as the start found them: free ones cost images"""

    def free(self) -> dict[str, tuple[str, ...]]:
        """The free parameters of each camera."""
        return {c.id: () if self.held else free_when_precise(c) for c in self.block.cameras}

    def weighted(self) -> Block:
        """The block with the covariances of its present weights."""
        cov = self.weights.covariance(self.grey, self.level, self.reference, self.feature)
        return replace(self.block, observations=replace(self.block.observations, cov_px2=cov))


def refine(
    tie: TieBlock,
    match: Matcher,
    threads: int,
    progress: Progress = silent,
    visible: Visible | None = None,
) -> PreciseBlock:
    """Measure every track again, also where no feature was found, and weigh the measurements by their residuals.

    match    least-squares matching of candidates
    threads  of the adjustments

    An image in which matching measures less than its features show, or too little to hold it, keeps the features as
    well; one that even they do not hold is left out by name.
    """
    o = tie.block.observations
    points = TrackPoints(image=o.image, point=o.point, xy_px=o.xy_px, scale_px=tie.scale_px, angle=tie.angle)
    found = refine_tracks(points, match)
    seen = found.measured if visible is None else found.measured & visible(o.image, found.xy_px, reach(found.level))
    keep, left = seen, ~seen
    block = with_rows(replace(tie.block, observations=replace(o, xy_px=found.xy_px)), keep)
    work = _Work(
        start=tie.block,
        spare=_Spare(
            image=o.image[left], point=o.point[left], xy_px=o.xy_px[left], scale_px=tie.scale_px[left],
            angle=tie.angle[left],
        ),
        block=block, grey=found.cov_px2[keep], level=found.level[keep], window_px=found.window_px[keep],
        residual=found.residual[keep], reference=found.reference[keep],
        feature=np.zeros(len(block.observations), bool), weights=Weights(),
        rejected=np.zeros(len(block.observations), bool), scale_px=tie.scale_px[keep],
        angle=tie.angle[keep],
    )  # fmt: skip
    _take_features(work, _better_by_features(work, tie.block))
    # weights and blunders need no more: the final adjustment converges fully
    options = AdjustmentOptions(jobs=threads, tolerance=1e-2)
    _settle(work, options, first=31)
    progress("weights", 1 / 3)
    added = _complete(work, match, visible)
    for k in range(2):
        _settle(work, options, first=7.0)
        progress("weights", (k + 2) / 3)
    block = work.weighted()
    stay = _with_partners(block, ~work.rejected)
    misfit, relief = misfit_and_relief(block, work.residual, work.window_px, work.reference)
    width = windows(block, work.window_px, work.reference)
    block = replace(block, points=replace(block.points, window=width, misfit=misfit, relief=relief))
    block = without_curvature(block, work.residual, work.reference, stay & np.isfinite(work.window_px))
    kept = with_rows(block, stay)
    ids = tie.block.images.ids
    matches = Matches(
        images=ids, image=kept.observations.image, xy_px=kept.observations.xy_px, grey=work.grey[stay],
        level=work.level[stay], reference=work.reference[stay], feature=work.feature[stay],
    )  # fmt: skip
    return PreciseBlock(
        block=without_images(kept, np.isin(np.arange(len(ids)), list(work.left_out))),
        weights=work.weights,
        matches=matches,
        measured=int(keep.sum()),
        offered=len(keep),
        added=added,
        features_kept=int((work.feature & stay).sum()),
        by_features=tuple(ids[i] for i in sorted(work.fallen - work.left_out.keys())),
        left_out=tuple((ids[i], reason) for i, reason in sorted(work.left_out.items())),
    )


def _better_by_features(work: _Work, start: Block) -> list[int]:
    """Oriented images of which all features together show more than the few points that matching measured.

    Information is number over variance: by the weights before any residual is known, 25 features are worth a match.
    """
    n = len(start.images)
    matched = np.bincount(work.block.observations.image, minlength=n)
    offered = np.bincount(start.observations.image, minlength=n)
    worth = offered / FEATURE_SIGMA_PX**2 > matched / work.weights.reference_px2
    return [int(i) for i in np.flatnonzero(start.images.oriented & (offered > 0) & worth)]


def _take_features(work: _Work, images: Sequence[int]) -> None:
    """Add the features of images that matching did not measure, where another ray of their point takes part."""
    new = [i for i in images if i not in work.fallen]
    work.fallen.update(new)
    spare, block = work.spare, work.block
    rows = np.flatnonzero(np.isin(spare.image, new))
    if not len(rows):
        return
    number = {name: k for k, name in enumerate(block.points.ids)}
    ids = work.start.points.ids
    at = np.array([number.get(ids[p], -1) for p in spare.point[rows]])
    rays = np.bincount(spare.point[rows], minlength=len(ids))
    present = np.bincount(block.observations.point[~work.rejected], minlength=len(block.points) + 1)  # last: none
    enough = rays[spare.point[rows]] + present[at] > 1
    rows, at = rows[enough], at[enough]
    fresh = np.unique(spare.point[rows[at < 0]])
    at[at < 0] = len(number) + np.searchsorted(fresh, spare.point[rows[at < 0]])
    _append(work, fresh, rows, at)


def _append(work: _Work, fresh: Index, rows: Index, at: Index) -> None:
    """Append the spare rows to the block, at these points of it; `fresh` are points of the start that it lacks."""
    spare, block, start = work.spare, work.block, work.start.points
    k = len(rows)
    more = Observations(
        image=spare.image[rows], point=at.astype(np.int32), xy_px=spare.xy_px[rows],
        cov_px2=np.tile([1.0, 1.0, 0.0], (k, 1)),
    )  # fmt: skip
    points, observations = block.points.append(start.rows(fresh)), block.observations.append(more)
    work.block = replace(block, points=points, observations=observations)
    work.grey = np.vstack([work.grey, np.zeros((k, 3))])
    work.level = np.concatenate([work.level, np.zeros(k, int)])
    work.window_px = np.concatenate([work.window_px, np.full(k, np.nan)])
    work.residual = np.vstack([work.residual, np.zeros((k, FIGURES))])
    work.reference = np.concatenate([work.reference, np.zeros(k, bool)])
    work.feature = np.concatenate([work.feature, np.ones(k, bool)])
    work.rejected = np.concatenate([work.rejected, np.zeros(k, bool)])
    work.scale_px = np.concatenate([work.scale_px, spare.scale_px[rows]])
    work.angle = np.concatenate([work.angle, spare.angle[rows]])
    if len(fresh):  # the block may have moved since the start
        origin, direction = viewing_lines(work.block)
        xyz, _, _ = intersect_linear(origin, direction, observations.point, len(points))
        placed = np.array(points.xyz)
        placed[len(block.points) :] = xyz[len(block.points) :]
        work.block = replace(work.block, points=replace(points, xyz=placed))


def _settle(work: _Work, options: AdjustmentOptions, first: float) -> Adjustment | None:
    """Clean, adjust with statistics, and take the weights from the residuals; None where nothing can be adjusted.

    Images that lose their points, or that the adjustment names as not determined, take their features first, and
    leave then.
    """
    while True:
        block = work.weighted()
        free = work.free()
        cleaned = clean(block, options, free, rejected=work.rejected, first=first)
        work.rejected = cleaned.rejected | _of_images(block, work.left_out)
        used = np.bincount(block.observations.image[~work.rejected], minlength=len(block.images))
        there = np.bincount(block.observations.image, minlength=len(block.images)) > 0
        thin = [int(i) for i in np.flatnonzero(there & (used < FEWEST_HELD)) if i not in work.left_out]
        if thin and _yield(work, thin, {i: phrase("not_oriented.few_fit", n=int(used[i])) for i in thin}):
            continue
        if not (~work.rejected).any():
            return None
        out = Rejection(kind=RejectionKind.RESIDUAL)
        reasons = tuple(out if r else None for r in work.rejected)
        # the weights need no covariances; only images that may turn about a line do
        extent = "report" if any_in_line(cleaned.block, ~work.rejected) else "tests"
        try:
            result = adjust_block(cleaned.block, options, free=free, rejected=reasons, extent=extent)
        except NotSolvable as error:
            named = [block.images.ids.index(n) for n in error.names("image")]
            worst = [i for i in named if i not in work.left_out][:1]
            why = phrase("excluded.undetermined")
            if worst and _yield(work, worst, dict.fromkeys(worst, why)):
                continue
            return None  # the final adjustment has more ways out; the weights stay as they are
        work.block = as_start(cleaned.block, result.adjusted)
        work.weights = estimate_weights(result, work.grey, work.level, work.reference, work.weights, work.feature)
        return result


def _of_images(block: Block, images: Iterable[int]) -> Mask:
    return np.isin(block.observations.image, list(images))


def _yield(work: _Work, images: Sequence[int], reasons: Mapping[int, str]) -> bool:
    """Images take their features; those that have them already are left out; whether two images are left.

    Before the first one leaves, all begin again with the cameras held: in weak geometry free ones bend what they see.
    """
    again = [i for i in images if i in work.fallen]
    _take_features(work, images)
    if again and not work.held:
        work.held = True
        _begin_again(work)
        return True
    for i in again:
        work.left_out[i] = reasons[i]
    work.rejected |= _of_images(work.block, work.left_out)
    return int(work.start.images.oriented.sum()) - len(work.left_out) >= 2


def _begin_again(work: _Work) -> None:
    """Orientations, coordinates and cameras as the start left them; nothing is rejected."""
    start, p = work.start, work.block.points
    number = {name: k for k, name in enumerate(start.points.ids)}
    xyz = start.points.xyz[[number[name] for name in p.ids]]
    work.block = replace(work.block, cameras=start.cameras, images=start.images, points=replace(p, xyz=np.array(xyz)))
    work.rejected = _of_images(work.block, work.left_out)


def _with_partners(block: Block, keep: Mask) -> Mask:
    """Rows that stay, without those of points that are left with one ray."""
    rays = np.bincount(block.observations.point[keep], minlength=len(block.points))
    return keep & (rays[block.observations.point] > 1)


def windows(block: Block, window_px: Array, reference: Mask) -> Array:
    """(p,) standard deviations of the windows of the points on the object, as their references see them.

    window_px  (m,) of each match [px]; NaN where there was none
    reference  (m,) from which windows are taken
    """
    o, found = block.observations, np.full(len(block.points), np.nan)
    matched = np.isfinite(window_px)
    order = np.lexsort((window_px, o.point))
    order = order[matched[order]]
    first = np.searchsorted(o.point[order], np.arange(len(found) + 1))
    middle = order[np.minimum((first[:-1] + first[1:]) // 2, max(len(order) - 1, 0))] if len(order) else order
    rows = np.flatnonzero(reference)
    mine = o.point[rows]
    there = first[mine + 1] > first[mine]
    rows, mine = rows[there], mine[there]
    if len(rows):
        found[mine] = window_px[middle[mine]] * object_pixel(block, rows)
    return found


def reach(level: Index) -> Array:
    """(k,) radius [px] of the largest window at levels of the pyramid."""
    return np.sqrt(2) * WINDOWS[-1].half * 2.0 ** np.asarray(level)


def _complete(work: _Work, match: Matcher, visible: Visible | None) -> int:
    """Measure points in images that should see them and where no feature was found; the number of rays gained."""
    block, o = work.block, work.block.observations
    used = ~work.rejected
    points = TrackPoints(
        image=o.image[used], point=o.point[used], xy_px=o.xy_px[used], scale_px=work.scale_px[used],
        angle=work.angle[used],
    )  # fmt: skip
    places = candidates(block, points, np.flatnonzero(work.reference[used]))
    # what was found at a level elsewhere and is not found at it here is hidden, as a rule
    places = replace(places, coarsest=work.level[used][places.reference])
    if visible is not None:
        places = places.rows(visible(places.image, places.xy_px, reach(np.zeros(len(places.image), int))))
    found = match(points, places)
    near = np.linalg.norm(found.xy_px - places.xy_px, axis=1) < NEAR_PX
    good = found.good & near & (found.correlation > SURE)
    if visible is not None:
        good &= visible(places.image, found.xy_px, reach(found.level))
    n = int(good.sum())
    # a ray that had been rejected gives way to the new measurement of the same point in the same image
    images = len(block.images)
    new = places.point[good].astype(np.int64) * images + places.image[good]
    old = ~np.isin(o.point.astype(np.int64) * images + o.image, new)
    work.block = replace(
        block,
        observations=o.rows(old).append(
            Observations(
                image=places.image[good].astype(np.int32),
                point=places.point[good].astype(np.int32),
                xy_px=found.xy_px[good],
                cov_px2=np.tile([1.0, 1.0, 0.0], (n, 1)),
            )
        ),
    )
    work.grey = np.vstack([work.grey[old], found.cov_px2[good]])
    work.level = np.concatenate([work.level[old], found.level[good]])
    work.window_px = np.concatenate([work.window_px[old], found.window_px[good]])
    work.residual = np.vstack([work.residual[old], found.residual[good]])
    work.reference = np.concatenate([work.reference[old], np.zeros(n, bool)])
    work.feature = np.concatenate([work.feature[old], np.zeros(n, bool)])
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
    n = len(block.images)
    rows_of, references_of = rows_of_each(points.image, n), rows_of_each(points.image[references], n)
    for a, others in enumerate(_with_common_points(points, n, len(block.points))):
        mine = references[references_of[a]]
        if not len(mine):
            continue
        for b in others:
            _, in_a, _ = np.intersect1d(points.point[rows_of[a]], points.point[rows_of[b]], return_indices=True)
            unseen = mine[~np.isin(points.point[mine], points.point[rows_of[b]])]
            common = points.xy_px[rows_of[a][in_a]]
            unseen = unseen[_near(points.xy_px[unseen], common, block.cameras[block.images.camera[a]])]
            xy, fine = _within(block, b, points.point[unseen])
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


def _with_common_points(points: TrackPoints, images: int, count: int) -> list[list[int]]:
    """Of each image those that see enough of its points, in their order; count: object points."""
    pairs = common_counts(points.image, points.point, np.ones(images, bool), count)
    a, b, _ = pairs[pairs[:, 2] >= NEIGHBOURS_FROM].T
    owner, other = np.concatenate([a, b]), np.concatenate([b, a])
    return [np.sort(other[rows]).tolist() for rows in rows_of_each(owner, images)]


def _near(xy: Array, common: Array, camera: Camera) -> Mask:
    """Whether the third nearest of the common points is near enough to believe that this point is seen as well."""
    from scipy.spatial import KDTree

    distance = KDTree(common).query(xy, k=3)[0][:, 2]
    return distance < SURROUNDINGS * float(np.hypot(camera.width_px, camera.height_px))


def _within(block: Block, image: int, point: Index) -> tuple[Array, Mask]:
    """Places (n, 2) [px] of object points in an image, and whether they lie within the format."""
    camera = block.cameras[block.images.camera[image]]
    xyz, xy = block.points.xyz[point], np.full((len(point), 2), np.nan)
    # an orbit has no place for what lies far beyond its scene
    seen = _roughly_seen(block, image, xyz) if camera.is_scene else np.ones(len(point), bool)
    if seen.any():
        xy[seen] = predicted_px(block, image, xyz[seen])
    with np.errstate(invalid="ignore"):
        beyond = (xy <= MARGIN_PX) | (xy >= np.array([camera.width_px, camera.height_px]) - MARGIN_PX) | np.isnan(xy)
    return xy, np.asarray(~beyond.any(axis=1), bool)


def _roughly_seen(block: Block, image: int, xyz: Array) -> Mask:
    """Whether points (n, 3) lie in a scene or close to it, by its nominal viewpoint."""
    camera = block.cameras[block.images.camera[image]]
    P = (xyz - block.images.centre[image]) @ block.images.rotation[image].T
    c = cast("SceneSensor", camera.sensor).camera_constant(camera.parameters)
    return (np.abs(c * P[:, :2] / -P[:, 2:]) < 0.6 * camera.size_mm).all(axis=1)
