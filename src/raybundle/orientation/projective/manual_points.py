"""Approximate values of photographs in which few points are measured, and these by hand.

Thousands of matched points distinguish pairs of candidates by counting; six points fit several.  Here every
candidate of a start is carried to the end, a bundle of all photographs with their camera constants and first radial
terms free within what is known of them, and that is taken which orients most and leaves the smallest residuals
(Cauchy's estimator: a mistaken mark weighs little against the others).

    photographs that are oriented already, or control in the photographs: the others by resection
    else the pairs with most common points: minimal solutions of five points each (Nister 2004), the others by resection
    camera constants that nothing shows: several, and that of the projective model where there is one

The result are approximate values, to be adjusted.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

import numpy as np

from raybundle.adjustment.estimation import estimate_only
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block, Camera, Role
from raybundle.block.known import known_before, observed_as_known
from raybundle.block.stored import is_observed_jointly
from raybundle.errors import InputError, NoOrientation
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import nearest_rotation
from raybundle.observations.relation import Relation
from raybundle.orientation.candidates import Pose, pose_from_solver, resect_all, resect_robust
from raybundle.orientation.projective.missing_data import COMMON, KNOWN, Lack, lacking
from raybundle.orientation.projective.model import self_calibration
from raybundle.orientation.rays import (
    FLIP,
    angular_residuals,
    common_rows,
    image_pairs,
    intersect_linear,
    object_rays,
    rays_of,
)

ROBUST = 8
"""Points from which on a resection leaves out those that contradict the others."""
PAIRS, CANDIDATES, POSES, SUBSETS = 4, 6, 3, 60
"""Pairs that are tried as a start, candidates of each, poses of a photograph, choices of five points."""
PARALLEL = 2e-5
"""Ratio of eigenvalues of an intersection below which it has no depth: rays parallel to half a degree."""
LINE = 0.02
"""Breadth of points by their length below which they are in a line: they leave the turn about it open."""
RADIAL = 0.15
"""Standard deviation of K1 c^2 of a lens of which nothing is known: 15 % at 45 degrees off the axis."""
CONSTANT = 0.1
"""Standard deviation of the logarithm of a free camera constant of which nobody states how well it is known."""
UNTOLD = 0.4
"""The same from which on it is as good as not known."""
FACTORS = (1.0, 0.7, 1.4, 0.5, 2.0, 2.8)
"""By which camera constants that nothing shows are multiplied, the likeliest first."""
LENS = 0.002
"""Error of a ray before a distortion is known, as a share of the diagonal of the format."""
ROUGH_PX = 2.0
"""Standard deviation of image points for a projective model, which knows no distortion."""
CROOKED = 0.1
"""Misfit of a projective model from which its camera constants are not believed."""
NARROWEST, WIDEST = 0.3, 12.0
"""Camera constants in larger sides of the format that are believed."""
LOST = 1e4
"""Square of the residual, in standard deviations, that counts for a point behind its photograph."""
MANY = 2000
"""Image points from which on a start from pairs is not for this module."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FewPoints:
    """A block with what could be oriented."""

    block: Block
    new: Mask
    """(n,) images oriented here"""
    lacking: tuple[Lack, ...] = ()
    by_control: bool = False
    """whether control in the photographs, not their common points, began it: it stands in the frame of control"""
    unknown: tuple[str, ...] = ()
    """cameras whose constant nothing states; it comes from the points alone"""


@dataclass(slots=True)
class _Trial:
    """One way to orient the photographs."""

    block: Block
    given: Mask
    """(n,) images that were oriented before; they are held"""
    known: Mask
    """(p,) points with coordinates that hold"""
    left: Mask
    """(n,) images to be oriented"""
    cost: float = np.inf

    @property
    def rank(self) -> tuple[int, int, float]:
        """The larger, the better: images, image points of theirs that meet others, residuals."""
        placed, o = self.block.images.oriented, self.block.observations
        rays = np.bincount(o.point[placed[o.image]], minlength=len(self.known)) + self.known
        return int(placed.sum()), int((placed[o.image] & (rays > 1)[o.point]).sum()), -self.cost


def orient_few(block: Block, *, control: bool = True) -> FewPoints:
    """Orient the images that are not, as far as the points measured in them allow.

    control  whether control coordinates are in the frame in which oriented images stand; where none is oriented, true
    Limits: whether the points are the same spots of the object; an orientation from six points fits
    nearly everything.  Images that are oriented are held, and so are cameras that have such an image.
    """
    images, o = block.images, block.observations
    scenes = np.array([c.is_scene for c in block.cameras], bool)[images.camera]
    counts = np.bincount(o.image, minlength=len(images))
    left = ~images.oriented & ~scenes & (counts > 0)
    given = images.oriented | scenes
    if not left.any():
        return FewPoints(block=block, new=np.zeros(len(images), bool), lacking=lacking(block, counts))
    start, unknown = _prepared(block, given)
    known = _finite(block.points.xyz) & (np.asarray(block.points.role) != Role.CHECK)
    full = np.asarray(block.points.is_control.all(axis=1), bool)
    known &= full if not given.any() else ~full | control
    best, by_control = _started(start, given, known, left, unknown)
    if best is None:
        return FewPoints(block=block, new=np.zeros(len(images), bool), lacking=lacking(block, counts))
    made = _returned(block, best.block)
    return FewPoints(
        block=made, new=made.images.oriented & ~images.oriented, lacking=lacking(made, counts),
        by_control=by_control, unknown=unknown,
    )  # fmt: skip


def _started(start: Block, given: Mask, known: Mask, left: Mask, unknown: Sequence[str]) -> tuple[_Trial | None, bool]:
    """The best way of all, and whether control began it."""
    best: _Trial | None = None
    by_control = False
    for block in _with_constants(start, unknown, left):
        if given.any() or known.any():
            placed = _Trial(_unplaced(block, known), given, known, left)
            found = _grown(_intersected(placed))
            if found.block.images.oriented[left].any() and (best is None or found.rank > best.rank):
                best, by_control = found, not given.any()
        if given.any() or (best is not None and best.block.images.oriented[left].all()):
            continue
        for found in _from_pairs(block, given, left):
            if best is None or found.rank > best.rank:
                best, by_control = found, False
    if best is not None:
        best = _bundle(_bundle(best))
    return best, by_control


def _from_pairs(block: Block, given: Mask, left: Mask) -> Iterator[_Trial]:
    """The photographs by their common points alone, in a frame of their own: the best of each pair that begins."""
    o, free = block.observations, np.zeros(len(block.points), bool)
    if len(o) > MANY:
        return
    for k, (a, b, common) in enumerate(image_pairs(o.image, o.point, left, len(block.points), PAIRS)):
        if common < COMMON:
            return
        begun: list[_Trial] = []
        for pose in pair_poses(block, a, b)[:CANDIDATES]:
            made = _set(_unplaced(block, free), a, np.eye(3), np.zeros(3))
            trial = _Trial(_set(made, b, pose.rotation, pose.centre), given, free, left)
            begun.append(_bundle(_intersected(trial)))
        begun.sort(key=lambda t: t.cost)
        grown = [_grown(t) for t in begun[:POSES]]
        if grown:
            best = max(grown, key=lambda t: t.rank)
            yield best
            if best.block.images.oriented[left].all() and k > 0:
                return


def _finite(xyz: Array) -> Mask:
    """(p,) points with coordinates."""
    return np.asarray(np.isfinite(xyz).all(axis=1), bool)


def _prepared(block: Block, given: Mask) -> tuple[Block, tuple[str, ...]]:
    """The block with cameras as a start frees them, and those whose constant nothing shows."""
    cameras: list[Camera] = []
    unknown: list[str] = []
    used = set(np.asarray(block.images.camera)[given].tolist())
    for k, camera in enumerate(block.cameras):
        scale = camera.sensor.scale_symbol
        if k in used or camera.is_scene or is_observed_jointly(camera) or not camera.estimate or not scale:
            cameras.append(replace(camera, estimate=(), relations=(), sigma={}, calibrated=None))
            continue
        if not camera.values.get(scale):
            camera = replace(camera, values={**camera.values, scale: 1.2 * float(camera.size_mm.max())})  # noqa: PLW2901
            sigma = 0.5
        else:
            before = known_before(camera).get(scale)
            sigma = CONSTANT if before is None else before.sigma
        if sigma >= UNTOLD:
            unknown.append(camera.id)
        cameras.append(_freed(camera, scale, sigma))
    return replace(block, cameras=tuple(cameras), tables={}), tuple(unknown)


def _freed(camera: Camera, scale: str, sigma: float) -> Camera:
    """A camera whose constant and first radial term are free within what is known of them."""
    plain = replace(camera, relations=(), sigma={}, calibrated=None)
    freed = observed_as_known(plain, {scale: sigma})
    radial = next((p.symbol for p in camera.sensor.parameters if p.symbol in {"K1", "k1"}), "")
    if not radial:
        return replace(freed, estimate=(scale,))
    lens = Relation(
        name=f"known before: {radial}", terms={radial: 1.0}, origin="known before",
        sigma=RADIAL / camera.values[scale] ** 2, observed=camera.values.get(radial, 0.0),
    )  # fmt: skip
    return replace(freed, estimate=(scale, radial), relations=(*freed.relations, lens))


def _with_constants(block: Block, unknown: Sequence[str], left: Mask) -> Iterator[Block]:
    """The block with the camera constants that may be, where nothing shows them."""
    if not unknown:
        yield block
        return
    projective = _projective(block, left)
    if projective is not None:
        yield _scaled(block, {n: projective[n] for n in unknown if n in projective})
    for factor in FACTORS:
        yield _scaled(block, {c.id: c.values[c.sensor.scale_symbol] * factor for c in block.cameras if c.id in unknown})


def _scaled(block: Block, constants: dict[str, float]) -> Block:
    return replace(
        block,
        cameras=tuple(
            replace(c, values={**c.values, c.sensor.scale_symbol: constants[c.id]}) if c.id in constants else c
            for c in block.cameras
        ),
    )


def _projective(block: Block, left: Mask) -> dict[str, float] | None:
    """Camera constants [mm] that make a projective model metric; None where the points are too few for one."""
    if left.sum() < 3:
        return None
    try:
        found = self_calibration(block, sigma_px=ROUGH_PX, common=ROBUST)
    except (NoOrientation, np.linalg.LinAlgError):
        return None
    if not found.misfit < CROOKED:
        return None
    sizes = {c.id: (c.values[c.sensor.scale_symbol], float(c.size_mm.max())) for c in found.block.cameras if c.estimate}
    return {name: c for name, (c, side) in sizes.items() if NARROWEST * side < c < WIDEST * side} or None


def pair_poses(block: Block, a: int, b: int) -> list[Pose]:
    """Orientations of an image relative to another (at the origin, R = I), base of length 1; the best first.

    All minimal solutions of five common points each, sixty choices at most, judged by all common points; such as put
    most points behind an image, or have no base, are left out.
    """
    import poselib

    o, rays = block.observations, rays_of(block)
    ra, rb = common_rows(np.flatnonzero(o.image == a), np.flatnonzero(o.image == b), o.point)
    first, second, n = rays.direction[ra], rays.direction[rb], len(ra)
    choices = list(combinations(range(n), 5))
    if len(choices) > SUBSETS:
        rng = np.random.default_rng(0)
        choices = [tuple(rng.choice(n, 5, replace=False).tolist()) for _ in range(SUBSETS)]
    limit = max(_limit(block, a), _limit(block, b)) * float(rays.px[ra].mean())
    if _turned_apart(first, second) < limit:
        return []  # a rotation explains all: from one place
    found: list[tuple[float, Pose]] = []
    for choice in choices:
        five = list(choice)
        solutions: list[Any] = poselib.relpose_5pt(first[five] * FLIP, second[five] * FLIP)
        for solution in solutions:
            R, C = pose_from_solver(solution)
            pose = Pose(R * FLIP, FLIP * C, 0.0, np.ones(n, bool))
            cost = _pair_cost(pose, first, second, limit)
            if np.isfinite(cost):
                found.append((cost, pose))
    found.sort(key=lambda f: f[0])
    return _unlike([pose for _, pose in found])


def _turned_apart(first: Array, second: Array) -> float:
    """Median angle [rad] between common rays (n, 3) of two images, one turned onto the other."""
    turn = nearest_rotation(second.T @ first)
    return float(np.median(np.linalg.norm(second - first @ turn.T, axis=1)))


def _unlike(poses: Sequence[Pose]) -> list[Pose]:
    """Those of some poses, the best first, that are no copies of a better one."""
    kept: list[Pose] = []
    for pose in poses:
        if len(kept) == 2 * CANDIDATES:
            break
        turns = [np.arccos(np.clip((np.trace(p.rotation @ pose.rotation.T) - 1) / 2, -1, 1)) for p in kept]
        if all(t > 0.05 or float(p.centre @ pose.centre) < 0.99 for t, p in zip(turns, kept, strict=True)):
            kept.append(pose)
    return kept


def _pair_cost(pose: Pose, first: Array, second: Array, limit: float) -> float:
    """How badly a relative orientation explains common rays (n, 3); infinite where it does not."""
    n = len(first)
    base = float(np.linalg.norm(pose.centre))
    if not np.isfinite(base) or base < 1e-9 or not np.isfinite(pose.rotation).all():
        return np.inf
    pose.centre = pose.centre / base
    rotation = np.concatenate([np.broadcast_to(np.eye(3), (n, 3, 3)), np.broadcast_to(pose.rotation, (n, 3, 3))])
    centre = np.concatenate([np.zeros((n, 3)), np.broadcast_to(pose.centre, (n, 3))])
    direction = np.concatenate([first, second])
    index = np.tile(np.arange(n, dtype=np.int32), 2)
    xyz, _, ratio = intersect_linear(centre, object_rays(rotation, direction), index, n)
    angle = angular_residuals(rotation, centre, xyz[index], direction)
    worst = np.maximum(angle[:n], angle[n:])
    if np.median(ratio) < PARALLEL or np.median(worst) > 0.5:
        return np.inf
    return float(np.log1p((worst / limit) ** 2).sum())


def _limit(block: Block, image: int) -> float:
    """Error to be expected of a ray [px]."""
    camera = block.cameras[int(block.images.camera[image])]
    rows = block.observations.image == image
    sigma = float(np.sqrt(np.median(block.observations.cov_px2[rows, :2])))
    lens = LENS * float(np.hypot(camera.width_px, camera.height_px)) if camera.estimate else 0.0
    return 3 * sigma + lens


def _set(block: Block, image: int, rotation: Array, centre: Array) -> Block:
    R, C = block.images.rotation.copy(), block.images.centre.copy()
    R[image], C[image] = rotation, centre
    return replace(block, images=replace(block.images, centre=C, rotation=R))


def _unplaced(block: Block, known: Mask) -> Block:
    """The block with the coordinates of known points alone, as its only control."""
    p = block.points
    return replace(
        block,
        points=replace(
            p, xyz=np.where(known[:, None], p.xyz, np.nan),
            role=np.where(known, Role.CONTROL, Role.TIE).astype(np.int32),
            sigma=np.where(known[:, None], 0.0, np.nan) * np.ones(3),
        ),
    )  # fmt: skip


def _intersected(trial: _Trial) -> _Trial:
    """With coordinates of the points whose rays meet in front of the oriented images."""
    block = trial.block
    o, images = block.observations, block.images
    scenes = np.array([c.is_scene for c in block.cameras], bool)[images.camera]
    rows = np.flatnonzero((images.oriented & ~scenes)[o.image] & ~trial.known[o.point])
    xyz = np.where(trial.known[:, None], block.points.xyz, np.nan)
    if len(rows):
        part = replace(o, image=o.image[rows], point=o.point[rows], xy_px=o.xy_px[rows], cov_px2=o.cov_px2[rows])
        sensor = rays_of(replace(block, observations=part)).direction
        R, C = images.rotation[part.image], images.centre[part.image]
        numbers, index = np.unique(part.point, return_inverse=True)
        met, count, ratio = intersect_linear(C, object_rays(R, sensor), index.astype(np.int32), len(numbers))
        angle = angular_residuals(R, C, met[index], sensor)
        behind = np.bincount(index, angle > np.pi / 2, minlength=len(numbers)) > 0
        good = (count > 1) & (ratio > PARALLEL) & ~behind
        xyz[numbers[good]] = met[good]
    return replace(trial, block=replace(block, points=replace(block.points, xyz=xyz)))


def _bundle(trial: _Trial) -> _Trial:
    """Adjusted, with its cost; as it was where that leads nowhere."""
    block, own = trial.block, not trial.given.any() and not trial.known.any()
    mask = ~_rows(trial)
    options = AdjustmentOptions(
        datum="inner" if own else "auto", robust_start=True, statistics=False, max_iterations=15
    )
    start = replace(block, images=replace(block.images, held=trial.given if trial.given.any() else None))
    free = {c.id: tuple(c.estimate) for c in block.cameras}
    try:
        found, _ = estimate_only(start, options, free, mask)
    except (InputError, NoOrientation, np.linalg.LinAlgError):
        found = block
    made = replace(found, images=replace(found.images, held=block.images.held))
    made = made if _sane(made, block) else block
    done = _intersected(replace(trial, block=made))
    cost = _cost(done)
    before = _cost(trial)
    return replace(done, cost=cost) if cost < before else replace(trial, cost=before)


def _rows(trial: _Trial) -> Mask:
    """(m,) observations that take part: of oriented images, of points with coordinates and a second ray."""
    block = trial.block
    o = block.observations
    new = trial.left & block.images.oriented
    used = block.images.oriented[o.image] & _finite(block.points.xyz)[o.point]
    used &= (np.bincount(o.point[new[o.image]], minlength=len(block.points)) > 0)[o.point]
    rays = np.bincount(o.point[used], minlength=len(block.points))
    return used & ((rays > 1) | trial.known)[o.point]


def _sane(new: Block, old: Block) -> bool:
    for a, b in zip(new.cameras, old.cameras, strict=True):
        s = a.sensor.scale_symbol
        if s and a.estimate:
            side = float(a.size_mm.max())
            if not (0.3 < a.values[s] / b.values[s] < 3.0 and NARROWEST * side < a.values[s] < WIDEST * side):
                return False
    placed = old.images.oriented
    return bool(np.isfinite(new.images.centre[placed]).all() and np.isfinite(new.images.rotation[placed]).all())


def _cost(trial: _Trial) -> float:
    """Sum over the image points of the new images of log(1 + v^2 / sigma^2); of those behind an image, much.

    What is known of camera constants and lenses counts with it.
    """
    block = trial.block
    o = block.observations
    new = trial.left & block.images.oriented
    rows = np.flatnonzero(new[o.image])
    seen = np.bincount(o.point[block.images.oriented[o.image]], minlength=len(block.points)) + trial.known
    rows = rows[seen[o.point[rows]] > 1]
    square = np.full(len(rows), LOST)
    there = _finite(block.points.xyz)[o.point[rows]]
    at = rows[there]
    v = residuals_px(block, at)
    square[there] = np.nan_to_num((v**2).sum(axis=1) / o.cov_px2[at, :2].mean(axis=1), nan=LOST)
    sizes = 0.0
    for camera in block.cameras:
        for r in camera.relations if camera.estimate else ():
            (symbol,) = r.terms
            value = camera.values[symbol]
            sizes += ((np.log(max(value, 1e-9)) if r.logarithm else value) - r.observed) ** 2 / r.sigma**2
    return float(np.log1p(np.minimum(square, LOST)).sum() + 0.5 * sizes)


def _grown(trial: _Trial) -> _Trial:
    """With the other photographs by resection, those first that see most points with coordinates."""
    refused: dict[int, int] = {}
    while True:
        block = trial.block
        o = block.observations
        known = _finite(block.points.xyz)
        counts = np.bincount(o.image[known[o.point]], minlength=len(trial.left))
        waiting = [
            int(i)
            for i in np.flatnonzero(trial.left & ~block.images.oriented & (counts >= KNOWN))
            if counts[i] > refused.get(int(i), 0)
        ]
        if not waiting:
            return trial if np.isfinite(trial.cost) else replace(trial, cost=_cost(trial))
        image = max(waiting, key=lambda i: int(counts[i]))
        tries = [
            _bundle(_intersected(replace(trial, block=_set(block, image, p.rotation, p.centre))))
            for p in _resected(block, image, np.flatnonzero((o.image == image) & known[o.point]))
        ]
        if tries:
            trial = min(tries, key=lambda t: t.cost)
        else:
            refused[image] = int(counts[image])


def _resected(block: Block, image: int, rows: Index) -> list[Pose]:
    """Poses of an image by points with coordinates, the best first."""
    o, rays = block.observations, rays_of(block)
    direction, xyz = rays.direction[rows], block.points.xyz[o.point[rows]]
    limit = _limit(block, image) * float(rays.px[rows].mean())
    spread = np.linalg.svd(xyz - xyz.mean(axis=0), compute_uv=False)
    if spread[1] < LINE * spread[0]:
        return []
    if len(rows) >= ROBUST:
        pose = resect_robust(direction, xyz, 2 * limit)
        if pose is not None and 2 * pose.inliers.sum() >= len(rows):
            return [pose]
    try:
        poses = resect_all(direction, xyz)
    except (IndexError, np.linalg.LinAlgError):
        return []
    return [p for p in poses if p.rms < 4 * limit][:POSES]


def _returned(block: Block, found: Block) -> Block:
    """The block as it was given, with the orientations and the values of cameras that were found."""
    cameras = tuple(
        replace(old, values={**old.values, **new.values}, known=old.known or dict(old.values)) if new.estimate else old
        for old, new in zip(block.cameras, found.cameras, strict=True)
    )
    xyz = np.where(np.isfinite(block.points.xyz), block.points.xyz, found.points.xyz)
    images = replace(block.images, centre=found.images.centre, rotation=found.images.rotation)
    return replace(block, cameras=cameras, images=images, points=replace(block.points, xyz=xyz))
