"""Approximate values of rigs: images oriented one by one, from them the mountings, then the stations.

Each image is oriented for itself, as if it stood on no rig.  Stations at which several cameras are oriented give their
mountings, the mean of those near the middle one.  Of the poses of a station by each of its images the one that most of
all its rays fit is taken; a station of which no image could be oriented is resected by the rays of all its cameras.
Cameras that share no points with the others stand in a system of their own, which common stations join.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import NamedTuple

import numpy as np

from raybundle.adjustment.engine import estimate_only
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.block import Block, Camera
from raybundle.block.rigs import (
    MOUNTING,
    is_mounted,
    station_numbers,
    with_shared_orientation,
    without_rigs,
)
from raybundle.errors import InputError, NotSolvable
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.counting import counted
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.rotation import rotation_between, rotation_from_angles, rotation_from_vector
from raybundle.numerics.rows import rows_of_each
from raybundle.orientation.assembly import ApproximateValues, image_values
from raybundle.orientation.candidates import resect_all, resect_robust
from raybundle.orientation.completion import complete
from raybundle.orientation.growth import SMALL_ANGLE, WRONG, Growth
from raybundle.orientation.onto_rays import KnownRays, onto_rays
from raybundle.orientation.rays import angular_residuals, intersect_linear, object_rays, rays_of
from raybundle.orientation.rig_pose import (
    FEWEST,
    HALF,
    Common,
    StationRays,
    joined_by_stations,
    mean_pose,
    refined_station,
    resected_station,
)
from raybundle.platforms.rig import OFFSET, mounting_of

ROUNDS = 4
"""Times that images are oriented one by one, each time beside the stations found before."""
PASSES = 3
"""Mountings from stations and stations from mountings, one after the other."""

RAYS, TURNS, REFINED = 4, 72, 6
"""Rays that give rotations of a camera of which few points are known, turns about each, and mountings refined."""
NEARLY = 20.0
"""Factor of the limits where the place of a camera in its rig is not known: 10 cm in 2 m are 3 degrees."""

Mounting = tuple[Array, Array]


@dataclass(slots=True)
class _Rigs:
    """Images one by one, and what is found of their rigs."""

    block: Block
    """With rigs, as given"""
    alone: Block
    """Its images one by one"""
    growth: Growth
    """Of `alone`: its rays and their limits"""
    fits: Mask
    """(m,) observations that fit the others of their point"""
    oriented: Mask
    """(n,) images that are oriented one by one"""
    system: Index
    """(n,) coordinate system of their orientations"""
    station: Index
    """(n,)"""
    sound: Mask
    """(p,) points that are given, or that two rays of oriented images determine"""
    local: bool = False
    """Whether the rigs stand in a system of their own, in which given coordinates are none"""
    mounting: dict[int, Mounting] = field(default_factory=dict[int, Mounting])
    """By camera"""
    pose: dict[int, Mounting] = field(default_factory=dict[int, Mounting])
    """By station: rotation and centre of the rig"""

    @property
    def camera(self) -> Index:
        """Position of the camera of each image (n,)."""
        return self.block.images.camera

    @property
    def given(self) -> Mask:
        """Points with given coordinates (p,)."""
        return np.isfinite(self.block.points.xyz).all(axis=1) & (not self.local)


def rig_values(block: Block, progress: Progress = silent) -> ApproximateValues:
    """Approximate values of a block with rigs, as `assembly.possible_values`.

    Mountings that are held, or observed with a standard deviation, stay as given; they give a free block its scale.
    """
    given = with_shared_orientation(block)
    alone = without_rigs(given)
    found = image_values(alone, progress)
    rigs = _of_rigs(given, found)
    before = len(alone.images)
    for _ in range(ROUNDS):
        waiting = int((rigs.growth.seen & ~_standing(rigs)).sum())
        if not waiting or waiting >= before:
            break
        before = waiting
        again = image_values(_with_poses(rigs, alone, np.flatnonzero(_standing(rigs))), progress)
        rigs = _of_rigs(given, again)
    return _values(rigs, found)


def _standing(rigs: _Rigs) -> Mask:
    """(n,) images whose station is oriented and whose mounting is known."""
    return np.isin(rigs.station, list(rigs.pose)) & np.isin(rigs.camera, list(rigs.mounting))


def _of_rigs(given: Block, found: ApproximateValues) -> _Rigs:
    """Mountings and stations from images that are oriented one by one."""
    growth = Growth.of(found.block, rays_of(found.block))
    rigs = _Rigs(
        block=given, alone=found.block, growth=growth, fits=~found.outliers,
        oriented=found.block.images.oriented & growth.seen, system=found.system.copy(),
        station=station_numbers(given.images), sound=np.zeros(len(given.points), bool),
    )  # fmt: skip
    known = {k: _given_mounting(c) for k, c in enumerate(given.cameras) if not _is_free(c)}
    scaled = set(found.scaled)
    order = np.unique(rigs.system[rigs.oriented], return_counts=True)
    systems = sorted(
        zip(*(a.tolist() for a in order), strict=True), key=lambda s: (s[0] != 0, s[0] not in scaled, -s[1])
    )
    main = -1
    for number, _ in systems:
        mine = rigs.oriented & (rigs.system == number)
        if number not in scaled and _scaled_by_mountings(rigs, mine, known if main < 0 else rigs.mounting):
            scaled.add(number)
        if main < 0:
            main, rigs.local = number, number != 0
            _renew_points(rigs, mine)
            _fit(rigs, mine, known)
        elif _join(rigs, main, mine, same_scale=number in scaled and main in scaled):
            rigs.system[mine] = main
            joined = rigs.oriented & (rigs.system == main)
            _renew_points(rigs, joined)
            _fit(rigs, joined, known)
    rigs.oriented &= rigs.system == main
    if main > 0 and not _onto_control(rigs) and main not in scaled:
        _scale_by_offsets(rigs)
    _keep_given(rigs)
    _resect_stations(rigs)
    return rigs


def _is_free(camera: Camera) -> bool:
    """Whether nothing is known of a part of a camera's mounting at least."""
    return any(_is_open(camera, s) for s in MOUNTING) if is_mounted(camera) else False


def _is_open(camera: Camera, symbol: str) -> bool:
    """Whether a parameter is estimated and not observed."""
    observed = symbol in camera.sigma or (camera.calibrated is not None and symbol in camera.calibrated.symbols)
    return (camera.estimate == "auto" or symbol in camera.estimate) and not observed


def _given_mounting(camera: Camera) -> Mounting:
    values = [camera.values.get(s, 0.0) if is_mounted(camera) else 0.0 for s in MOUNTING]
    return rotation_from_angles(np.array(values[3:])), np.array(values[:3])


def _fit(rigs: _Rigs, images: Mask, known: Mapping[int, Mounting]) -> None:
    """Mountings and stations by these images (n,), all in one coordinate system.

    Where no mounting is known, the camera with most of the images defines the frame by its given mounting.
    """
    rigs.mounting, rigs.pose = dict(known), {}
    size = _depth(rigs, images)
    first = -1
    if images.any() and not np.isin(rigs.camera[images], list(known)).any():
        first = int(np.bincount(rigs.camera[images]).argmax())
        rigs.mounting[first] = _given_mounting(rigs.block.cameras[first])
    lost = set[int]()
    while True:
        _set_stations(rigs, images)
        open_ = _at_stations(rigs) & ~np.isin(rigs.camera, [*rigs.mounting, *lost])
        if not open_.any():
            break
        rays = np.bincount(rigs.growth.rays.image, minlength=len(open_))
        camera = int(np.bincount(rigs.camera[open_], rays[open_]).argmax())
        found = _mounting_by_images(rigs, camera, images, size)
        if found is None:
            lost.add(camera)
            continue
        rigs.mounting[camera] = found
        if _take_in(rigs, camera):
            lost.clear()
    for _ in range(PASSES):
        for camera in [k for k in rigs.mounting if k not in known and k != first]:
            rigs.mounting[camera] = _mounting_by_images(rigs, camera, images, size) or rigs.mounting[camera]
        _set_stations(rigs, images)


def _take_in(rigs: _Rigs, camera: int) -> bool:
    """Orient images of a camera by their rigs that could not be by themselves; whether there are any."""
    new = np.flatnonzero(_at_stations(rigs) & (rigs.camera == camera) & ~rigs.oriented)
    if not len(new):
        return False
    rigs.alone = _with_poses(rigs, rigs.alone, new)
    rigs.oriented[new] = True
    rigs.system[new] = rigs.system[np.flatnonzero(np.isin(rigs.station, rigs.station[new]))[0]]
    _renew_points(rigs, rigs.oriented & (rigs.system == rigs.system[new[0]]))
    return True


def _renew_points(rigs: _Rigs, images: Mask) -> None:
    """Intersect the points from these images (n,), all in one coordinate system, and judge them and their rays."""
    own, rays = rigs.alone.images, rigs.growth.rays
    centre = np.where(images[:, None], own.centre, np.nan)
    given = rigs.given
    xyz = np.where(given[:, None], rigs.block.points.xyz, np.nan)
    block = replace(rigs.alone, images=replace(own, centre=centre), points=replace(rigs.alone.points, xyz=xyz))
    found = complete(block, rays, ~given, 2 * rigs.growth.limits(images))
    rigs.alone = replace(rigs.alone, points=replace(block.points, xyz=found.xyz))
    rigs.fits = ~found.outliers
    rows = np.flatnonzero(images[rays.image] & rigs.fits)
    image, point = rays.image[rows], rays.point[rows]
    direction = object_rays(own.rotation[image], rays.direction[rows])
    _, count, ratio = intersect_linear(own.centre[image], direction, point, len(given))
    rigs.sound = given | ((count >= 2) & (ratio > SMALL_ANGLE))


def _at_stations(rigs: _Rigs) -> Mask:
    """(n,) images with observations at stations that are oriented."""
    return rigs.growth.seen & np.isin(rigs.station, list(rigs.pose))


def _depth(rigs: _Rigs, images: Mask) -> float:
    """Median distance from images to their points."""
    rays, block = rigs.growth.rays, rigs.alone
    rows = images[rays.image] & rigs.fits
    away = np.linalg.norm(block.points.xyz[rays.point[rows]] - block.images.centre[rays.image[rows]], axis=1)
    return float(np.nanmedian(away)) if len(away) else 1.0


def _mounting_by_images(rigs: _Rigs, camera: int, images: Mask, size: float) -> Mounting | None:
    """The mounting of a camera by its images at oriented stations; None where half of their rays do not fit.

    images  (n,) those that are oriented one by one

    In the frame of the rig all of these images are one, which sees the points of all stations: it is resected like any
    image.  The mean of the mountings by single images, and the given one, are tried as well.
    """
    mine = np.flatnonzero(_at_stations(rigs) & (rigs.camera == camera))
    rays = _camera_rays(rigs, mine)
    tried = [_given_mounting(rigs.block.cameras[camera])]
    oriented = mine[images[mine]]
    if len(oriented):
        own = rigs.alone.images
        R, C = (np.array(v) for v in zip(*(rigs.pose[int(s)] for s in rigs.station[oriented]), strict=True))
        away = np.einsum("nij,nj->ni", R, own.centre[oriented] - C)
        tried.append(mean_pose(own.rotation[oriented] @ np.swapaxes(R, 1, 2), away, size))
    if len(rays.xyz) >= FEWEST:
        pose = resect_robust(rays.direction, rays.xyz, float(np.median(rays.limit)))
        tried += [] if pose is None else [(pose.rotation, pose.centre)]
    if FEWEST > len(rays.xyz) >= 3 and not len(oriented):
        tried += [(p.rotation, p.centre) for p in resect_all(rays.direction, rays.xyz, keep=np.inf)]
    if len(rays.xyz) >= FEWEST:
        tried.append(refined_station(rays, *min(tried, key=lambda m: rays.cost(*m))))
    found = _best_mounting(rigs, mine, tried)
    if not found.fits and not len(oriented):
        few = [(R, b) for R in _by_few(rays) for b in (tried[0][1], np.zeros(3))]
        likely = sorted([tried[0], *few], key=lambda m: _judged(rigs, mine, m, NEARLY)[0])[:REFINED]
        found = _best_mounting(rigs, mine, [_adjusted(rigs, mine, m) for m in likely])
    return found.mounting if found.fits or found.nearly else None


class _Best(NamedTuple):
    """The mounting of a camera that brings most of its rays together."""

    mounting: Mounting
    fits: bool
    """Whether half of the rays are within their limits"""
    nearly: bool
    """Whether half of them are not wrong: parts that stations join are bent against each other"""


def _best_mounting(rigs: _Rigs, images: Index, tried: Sequence[Mounting]) -> _Best:
    """Of some mountings of the camera of images (k,) the best one."""
    _, fits, count, best = min([(*_judged(rigs, images, m), m) for m in tried], key=lambda j: j[0])
    nearly = _judged(rigs, images, best, WRONG)[1]
    least = max(FEWEST, HALF * count)
    return _Best(best, fits >= least, nearly >= least)


def _by_few(rays: StationRays) -> list[Array]:
    """Rotations of a camera that is near the origin of its rig, by each of a few of its rays and turns about it."""
    unit = rays.xyz / np.linalg.norm(rays.xyz, axis=1, keepdims=True)
    turns = np.arange(TURNS) * (2 * np.pi / TURNS)
    found = list[Array]()
    for a, d in zip(unit[:RAYS], rays.direction, strict=False):
        about = rotation_from_vector(turns[:, None] * d)
        found += list(about @ rotation_between(a, d))
    return found


def _adjusted(rigs: _Rigs, images: Index, mounting: Mounting) -> Mounting:
    """The mounting of a camera by a robust adjustment of it and of the points of its images (k,), all images held."""
    camera, own = int(rigs.camera[images[0]]), rigs.alone.images
    centre, rotation = own.centre.copy(), own.rotation.copy()
    for i in images.tolist():
        rotation[i], centre[i] = rigs.pose[int(rigs.station[i])]
    cameras = list(rigs.alone.cameras)
    values = {**rigs.block.cameras[camera].values, **cameras[camera].values, **_symbols_of(mounting)}
    cameras[camera] = replace(rigs.block.cameras[camera], values=values)
    used, rays = rigs.oriented.copy(), rigs.growth.rays
    used[images] = True
    seen = np.zeros(len(rigs.sound), bool)
    seen[rays.point[np.isin(rays.image, images)]] = True
    rows = used[rays.image] & seen[rays.point] & rigs.fits
    rows &= (np.bincount(rays.point[rows], minlength=len(seen)) > 1)[rays.point]
    alone = _with_poses(rigs, rigs.alone, images, mounting)
    xyz = complete(alone, rays, ~rigs.given, np.where(used, np.pi, 0.0)).xyz
    block = replace(
        rigs.alone, cameras=tuple(cameras), tables={}, points=replace(rigs.alone.points, xyz=xyz),
        images=replace(own, centre=centre, rotation=rotation, held=np.ones(len(used), bool)),
    )  # fmt: skip
    free = {c.id: MOUNTING if k == camera else () for k, c in enumerate(cameras)}
    options = AdjustmentOptions(robust_start=True, statistics=False, max_iterations=30)
    try:
        found, _ = estimate_only(block, options, free, ~rows)
    except (InputError, NotSolvable, np.linalg.LinAlgError):
        return mounting
    return _given_mounting(found.cameras[camera])


def _judged(rigs: _Rigs, images: Index, mounting: Mounting, loose: float = 1.0) -> tuple[float, int, int]:
    """What images (k,) of one camera on oriented stations bring together with a mounting.

    returns  sum of the angles between rays and points in units of their limits, each one at most; rays that fit; rays

    loose  factor of the limits

    Points that are not known are intersected, with these rays and those of oriented images.
    """
    alone = _with_poses(rigs, rigs.alone, images, mounting)
    rays, mine = rigs.growth.rays, np.zeros(len(alone.images), bool)
    mine[images] = True
    seen = np.zeros(len(rigs.sound), bool)
    seen[rays.point[mine[rays.image]]] = True
    rows = np.flatnonzero(seen[rays.point] & (mine | rigs.oriented)[rays.image] & rigs.fits)
    image, point = rays.image[rows], rays.point[rows]
    rotation, centre = alone.images.rotation[image], alone.images.centre[image]
    direction = rays.direction[rows]
    xyz, count, _ = intersect_linear(centre, object_rays(rotation, direction), point, len(seen))
    xyz = np.where(rigs.sound[:, None], alone.points.xyz, xyz)
    asked = mine[image] & (rigs.sound | (count > 1))[point]
    angle = angular_residuals(rotation, centre, xyz[point], direction)[asked]
    share = angle / loose / np.array([rigs.growth.limit(i) for i in image[asked].tolist()])
    return float(np.minimum(share, 1.0).sum()), int((share < 1.0).sum()), len(share)


def _camera_rays(rigs: _Rigs, images: Index) -> StationRays:
    """The rays of images (k,) of one camera to known points, as one image in the frame of their rigs."""
    rows = _rows_to_known(rigs, images)
    rays = rigs.growth.rays
    pose = {i: rigs.pose[int(rigs.station[i])] for i in images.tolist()}
    points, image = rigs.alone.points.xyz[rays.point[rows]], rays.image[rows].tolist()
    local = [pose[i][0] @ (xyz - pose[i][1]) for i, xyz in zip(image, points, strict=True)]
    return StationRays(
        origin=np.zeros((len(rows), 3)), direction=rays.direction[rows], xyz=np.array(local).reshape(-1, 3),
        limit=np.array([rigs.growth.limit(i) for i in image]),
    )  # fmt: skip


def _rows_to_known(rigs: _Rigs, images: Index) -> Index:
    """Rows of the observations in images (k,) whose points are known and that fit these."""
    rows = np.concatenate([np.zeros(0, np.int64), *(rigs.growth.by_image[i] for i in images.tolist())])
    return rows[rigs.fits[rows] & rigs.sound[rigs.growth.rays.point[rows]]]


def _set_stations(rigs: _Rigs, images: Mask) -> None:
    """Orient the stations by those of these images whose mounting is known."""
    ready = np.flatnonzero(images & np.isin(rigs.camera, list(rigs.mounting)))
    count = int(rigs.station.max(initial=-1)) + 1
    for s, mine in enumerate(rows_of_each(rigs.station[ready], count)):
        if not len(mine):
            continue
        poses = [_rig_by_image(rigs, i) for i in ready[mine].tolist()]
        if len(poses) > 1:
            rays = _station_rays(rigs, ready[mine])
            poses = [refined_station(rays, *min(poses, key=lambda p: rays.cost(*p)))]
        rigs.pose[s] = poses[0]


def _rig_by_image(rigs: _Rigs, image: int) -> Mounting:
    """Rotation and centre of the rig from those of one of its images."""
    own, (M, b) = rigs.alone.images, rigs.mounting[int(rigs.camera[image])]
    R = M.T @ own.rotation[image]
    return R, own.centre[image] - R.T @ b


def _station_rays(rigs: _Rigs, images: Index) -> StationRays:
    """The rays of these images (k,) of a station, whose mountings are known, to points that are."""
    rays, xyz = rigs.growth.rays, rigs.alone.points.xyz
    rows = _rows_to_known(rigs, images)
    camera = rigs.camera[rays.image[rows]]
    M, b = np.zeros((len(rigs.block.cameras), 3, 3)), np.zeros((len(rigs.block.cameras), 3))
    for k, (R, offset) in rigs.mounting.items():
        M[k], b[k] = R, offset
    return StationRays(
        origin=b[camera], direction=object_rays(M[camera], rays.direction[rows]), xyz=xyz[rays.point[rows]],
        limit=np.array([rigs.growth.limit(i) for i in rays.image[rows].tolist()]),
    )  # fmt: skip


def _resect_stations(rigs: _Rigs) -> None:
    """Orient stations of which no image is oriented by the rays of all their images."""
    waiting = rigs.growth.seen & ~np.isin(rigs.station, list(rigs.pose)) & np.isin(rigs.camera, list(rigs.mounting))
    images = np.flatnonzero(waiting)
    for s, mine in enumerate(rows_of_each(rigs.station[images], int(rigs.station.max(initial=-1)) + 1)):
        found = resected_station(_station_rays(rigs, images[mine])) if len(mine) else None
        if found is not None:
            rigs.pose[s] = found


def _move(rigs: _Rigs, images: Mask, scale: float, rotation: Array, translation: Array) -> None:
    """Bring images (n,) and the points that they see to another coordinate system."""
    block, rays = rigs.alone, rigs.growth.rays
    centre, turned, xyz = block.images.centre.copy(), block.images.rotation.copy(), block.points.xyz.copy()
    centre[images] = scale * centre[images] @ rotation.T + translation
    turned[images] = turned[images] @ rotation.T
    seen = np.zeros(len(xyz), bool)
    seen[rays.point[images[rays.image]]] = True
    seen &= rigs.local | ~block.points.is_control.any(axis=1)
    xyz[seen] = scale * xyz[seen] @ rotation.T + translation
    rigs.alone = replace(
        block, images=replace(block.images, centre=centre, rotation=turned), points=replace(block.points, xyz=xyz)
    )


def _scaled_by_mountings(rigs: _Rigs, images: Mask, known: Mapping[int, Mounting]) -> bool:
    """Scale a free system by the distances of cameras whose mountings are known; False where there are none."""
    ready = np.flatnonzero(images & np.isin(rigs.camera, list(known)))
    ratio, own = list[float](), rigs.alone.images
    for mine in rows_of_each(rigs.station[ready], int(rigs.station.max(initial=-1)) + 1):
        for a, b in zip(ready[mine[:-1]].tolist(), ready[mine[1:]].tolist(), strict=True):
            base = np.linalg.norm(known[int(rigs.camera[a])][1] - known[int(rigs.camera[b])][1])
            there = np.linalg.norm(own.centre[a] - own.centre[b])
            if base > 0 and there > 0:
                ratio.append(float(base / there))
    if not ratio:
        return False
    _move(rigs, images, float(np.median(ratio)), np.eye(3), np.zeros(3))
    return True


def _scale_by_offsets(rigs: _Rigs) -> None:
    """Scale the rigs by offsets of which a part is known, where nothing else scales them."""
    given, there = list[float](), list[float]()
    for k, (_, b) in rigs.mounting.items():
        camera = rigs.block.cameras[k]
        if not is_mounted(camera) or not _is_free(camera):
            continue
        for axis, s in enumerate(OFFSET):
            if not _is_open(camera, s):
                given.append(camera.values.get(s, 0.0))
                there.append(float(b[axis]))
    square = float(np.dot(given, there))
    if not square > 0:
        return
    _transform(rigs, float(np.dot(given, given)) / square, np.eye(3), np.zeros(3))


def _onto_control(rigs: _Rigs) -> bool:
    """Bring the rigs onto control by the rays to it; False where these leave anything open.

    Points that one ray sees count as well: together, the parts of a rig may have what none of them has.
    """
    rays, images, points = rigs.growth.rays, rigs.alone.images, rigs.block.points
    rows = np.flatnonzero(rigs.oriented[rays.image] & points.is_control.all(axis=1)[rays.point])
    image, point = rays.image[rows], rays.point[rows]
    direction = object_rays(images.rotation[image], rays.direction[rows])
    own, count, ratio = intersect_linear(images.centre[image], direction, point, len(points))
    own[(count < 2) | (ratio <= SMALL_ANGLE)] = np.nan
    known = KnownRays(image=image, point=point, target=points.xyz[point], centre=images.centre[image],
                      direction=direction)  # fmt: skip
    found = onto_rays(known, own[point])
    limit = np.array([rigs.growth.limit(i) for i in image.tolist()])
    if found is None or not np.median(found.angle / limit) < WRONG:
        return False
    _transform(rigs, found.scale, found.rotation, found.translation)
    rigs.local = False
    _renew_points(rigs, rigs.oriented)
    return True


def _transform(rigs: _Rigs, scale: float, rotation: Array, translation: Array) -> None:
    """Bring the oriented images, their rigs and free mountings to another coordinate system."""
    _move(rigs, rigs.oriented, scale, rotation, translation)
    free = {k for k in rigs.mounting if _is_free(rigs.block.cameras[k])}
    rigs.mounting = {k: (R, scale * b if k in free else b) for k, (R, b) in rigs.mounting.items()}
    rigs.pose = {s: (R @ rotation.T, scale * rotation @ C + translation) for s, (R, C) in rigs.pose.items()}


def _join(rigs: _Rigs, main: int, images: Mask, *, same_scale: bool) -> bool:
    """Bring images (n,) of another coordinate system to the main one, over stations that both know."""
    there = rigs.oriented & (rigs.system == main)
    common = {
        (a, b): (_common(rigs, there, images, a, b), _common(rigs, images, there, a, b))
        for a, b in combinations(np.unique(rigs.camera[there | images]).tolist(), 2)
    }
    for (a, b), (here, back) in sorted(common.items(), key=lambda c: -len(c[1][0].centre) - len(c[1][1].centre)):
        found = joined_by_stations(here, back, _mounting_between(rigs, a, b), scaled=same_scale)
        if found is not None:
            _move(rigs, images, found.scale, found.rotation, found.translation)
            return True
    return False


def _common(rigs: _Rigs, first: Mask, second: Mask, a: int, b: int) -> Common:
    """The stations of camera a among the first images (n,) and of camera b among the second ones."""
    one, other = (np.flatnonzero(mine & (rigs.camera == k)) for mine, k in ((first, a), (second, b)))
    _, i, j = np.intersect1d(rigs.station[one], rigs.station[other], return_indices=True)
    own = rigs.alone.images
    return Common(
        rotation=own.rotation[one[i]], centre=own.centre[one[i]], other_rotation=own.rotation[other[j]],
        other_centre=own.centre[other[j]],
    )  # fmt: skip


def _mounting_between(rigs: _Rigs, a: int, b: int) -> Mounting | None:
    """The mounting of camera b in the frame of camera a; None where one of them is not known."""
    if a not in rigs.mounting or b not in rigs.mounting:
        return None
    (M, o), (N, p) = rigs.mounting[a], rigs.mounting[b]
    return N @ M.T, M @ (p - o)


def _keep_given(rigs: _Rigs) -> None:
    """Mountings with what is known of each, stations as they were given, the others by these.

    A camera of which no rays give a mounting has the given one: its points are known by it alone.
    """
    for k in np.unique(rigs.camera[_at_stations(rigs)]).tolist():
        rigs.mounting.setdefault(k, _given_mounting(rigs.block.cameras[k]))
    for k, (R, b) in list(rigs.mounting.items()):
        camera = rigs.block.cameras[k]
        if _is_free(camera):
            rigs.mounting[k] = _given_mounting(replace(camera, values=_values_of(camera, (R, b))))
    if not rigs.oriented.any():
        return
    rigs.pose = {}
    _set_stations(rigs, rigs.oriented)
    images = rigs.block.images
    for i in np.flatnonzero(images.oriented).tolist():
        rigs.pose[int(rigs.station[i])] = (images.rotation[i], images.centre[i])


def _values_of(camera: Camera, mounting: Mounting) -> dict[str, float]:
    """The values of a mounted camera with those of a mounting that are estimated and not observed."""
    return {**camera.values, **{s: v for s, v in _symbols_of(mounting).items() if _is_open(camera, s)}}


def _symbols_of(mounting: Mounting) -> dict[str, float]:
    R, b = mounting
    return mounting_of(np.zeros(3), np.eye(3), b, R)


def _with_poses(rigs: _Rigs, alone: Block, chosen: Index, mounting: Mounting | None = None) -> Block:
    """Images one by one, those chosen (k,), of oriented stations, where their rigs have them.

    mounting  of all of them; None: as found
    """
    images = alone.images
    centre, rotation = images.centre.copy(), images.rotation.copy()
    for i in chosen.tolist():
        (M, b), (R, C) = mounting or rigs.mounting[int(rigs.camera[i])], rigs.pose[int(rigs.station[i])]
        centre[i], rotation[i] = C + R.T @ b, M @ R
    return replace(alone, cameras=rigs.alone.cameras, images=replace(images, centre=centre, rotation=rotation))


def _values(rigs: _Rigs, first: ApproximateValues) -> ApproximateValues:
    """The block with rigs as they were found, and its points from them."""
    block = rigs.block
    standing = _standing(rigs)
    alone = _with_poses(rigs, without_rigs(block), np.flatnonzero(standing))
    rays = rigs.growth.rays
    kept = np.isfinite(block.points.xyz).all(axis=1)
    points = complete(alone, rays, ~kept, 2 * rigs.growth.limits(alone.images.oriented & rigs.growth.seen))
    cameras = list(block.cameras)
    for k, camera in enumerate(block.cameras):
        values = {**camera.values, **rigs.alone.cameras[k].values}
        cameras[k] = replace(camera, values=values)
        if is_mounted(camera) and k in rigs.mounting:
            cameras[k] = replace(camera, values=_values_of(cameras[k], rigs.mounting[k]))
    centre, rotation = block.images.centre.copy(), block.images.rotation.copy()
    for i in range(len(block.images)):
        pose = rigs.pose.get(int(rigs.station[i]))
        if pose is not None:
            rotation[i], centre[i] = pose
    left = np.flatnonzero(rigs.growth.seen & ~standing)
    ids = block.images.ids
    return ApproximateValues(
        block=replace(
            block, cameras=tuple(cameras), images=replace(block.images, centre=centre, rotation=rotation),
            points=replace(block.points, xyz=points.xyz),
        ),
        notices=first.notices,
        outliers=points.outliers,
        not_oriented={ids[i]: _reason(rigs, int(i), first) for i in left},
        system=np.zeros(len(ids), np.int64),
        scaled=frozenset({0}),
    )  # fmt: skip


def _reason(rigs: _Rigs, image: int, first: ApproximateValues) -> str:
    """Why an image could not be oriented: its own reason, and how much its station has."""
    own = first.not_oriented.get(rigs.block.images.ids[image], "")
    if rigs.system[image] != rigs.system[rigs.oriented].max(initial=0) and not own:
        own = "shares no points with the other cameras, and too few stations or turns join them"
    mine = rigs.growth.seen & (rigs.station == rigs.station[image])
    rays = int(mine[rigs.growth.rays.image].sum())
    of_station = f"{counted(rays, 'image point')} at its station in {counted(int(mine.sum()), 'image')}"
    return f"{own}; {of_station}" if own else of_station
