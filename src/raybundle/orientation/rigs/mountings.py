"""Mountings of cameras from their images at oriented stations, and stations from images whose mountings are known."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from raybundle.adjustment.estimation import estimate_only
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.rigs import (
    MOUNTING,
)
from raybundle.errors import InputError, NotSolvable
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import rotation_between, rotation_from_vector
from raybundle.numerics.rows import rows_of_each
from raybundle.orientation.candidates import resect_all, resect_robust
from raybundle.orientation.completion import complete
from raybundle.orientation.growth import WRONG
from raybundle.orientation.rays import angular_residuals, intersect_linear, object_rays
from raybundle.orientation.rigs.pose import (
    FEWEST,
    HALF,
    StationRays,
    mean_pose,
    refined_station,
)
from raybundle.orientation.rigs.state import (
    Mounting,
    Rigs,
    at_stations,
    camera_rays,
    given_mounting,
    renew_points,
    station_rays,
    symbols_of,
    with_poses,
)

PASSES = 3
"""Mountings from stations and stations from mountings, one after the other."""
RAYS, TURNS, REFINED = 4, 72, 6
"""Rays that give rotations of a camera of which few points are known, turns about each, and mountings refined."""
NEARLY = 20.0
"""Factor of the limits where the place of a camera in its rig is not known: 10 cm in 2 m are 3 degrees."""


def fit(rigs: Rigs, images: Mask, known: Mapping[int, Mounting]) -> None:
    """Mountings and stations by these images (n,), all in one coordinate system.

    Where no mounting is known, the camera with most of the images defines the frame by its given mounting.
    """
    rigs.mounting, rigs.pose = dict(known), {}
    size = _depth(rigs, images)
    first = -1
    if images.any() and not np.isin(rigs.camera[images], list(known)).any():
        first = int(np.bincount(rigs.camera[images]).argmax())
        rigs.mounting[first] = given_mounting(rigs.block.cameras[first])
    rigs.anchored = set()
    lost = set[int]()
    while True:
        set_stations(rigs, images)
        open_ = at_stations(rigs) & ~np.isin(rigs.camera, [*rigs.mounting, *lost])
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
        set_stations(rigs, images)
    if first >= 0:
        rigs.anchored = set(rigs.mounting) - set(known)


def _take_in(rigs: Rigs, camera: int) -> bool:
    """Orient images of a camera by their rigs that could not be by themselves; whether there are any."""
    new = np.flatnonzero(at_stations(rigs) & (rigs.camera == camera) & ~rigs.oriented)
    if not len(new):
        return False
    rigs.alone = with_poses(rigs, rigs.alone, new)
    rigs.oriented[new] = True
    rigs.system[new] = rigs.system[np.flatnonzero(np.isin(rigs.station, rigs.station[new]))[0]]
    renew_points(rigs, rigs.oriented & (rigs.system == rigs.system[new[0]]))
    return True


def _depth(rigs: Rigs, images: Mask) -> float:
    """Median distance from images to their points."""
    rays, block = rigs.growth.rays, rigs.alone
    rows = images[rays.image] & rigs.fits
    away = np.linalg.norm(block.points.xyz[rays.point[rows]] - block.images.centre[rays.image[rows]], axis=1)
    return float(np.nanmedian(away)) if len(away) else 1.0


def _mounting_by_images(rigs: Rigs, camera: int, images: Mask, size: float) -> Mounting | None:
    """The mounting of a camera by its images at oriented stations; None where half of their rays do not fit.

    images  (n,) those that are oriented one by one

    In the frame of the rig all of these images are one, which sees the points of all stations: it is resected like any
    image.  The mean of the mountings by single images, and the given one, are tried as well.
    """
    mine = np.flatnonzero(at_stations(rigs) & (rigs.camera == camera))
    rays = camera_rays(rigs, mine)
    tried = [given_mounting(rigs.block.cameras[camera])]
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


def _best_mounting(rigs: Rigs, images: Index, tried: Sequence[Mounting]) -> _Best:
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


def _adjusted(rigs: Rigs, images: Index, mounting: Mounting) -> Mounting:
    """The mounting of a camera by a robust adjustment of it and of the points of its images (k,), all images held."""
    camera, own = int(rigs.camera[images[0]]), rigs.alone.images
    centre, rotation = own.centre.copy(), own.rotation.copy()
    for i in images.tolist():
        rotation[i], centre[i] = rigs.pose[int(rigs.station[i])]
    cameras = list(rigs.alone.cameras)
    values = {**rigs.block.cameras[camera].values, **cameras[camera].values, **symbols_of(mounting)}
    cameras[camera] = replace(rigs.block.cameras[camera], values=values)
    used, rays = rigs.oriented.copy(), rigs.growth.rays
    used[images] = True
    seen = np.zeros(len(rigs.sound), bool)
    seen[rays.point[np.isin(rays.image, images)]] = True
    rows = used[rays.image] & seen[rays.point] & rigs.fits
    rows &= (np.bincount(rays.point[rows], minlength=len(seen)) > 1)[rays.point]
    alone = with_poses(rigs, rigs.alone, images, mounting)
    xyz = complete(alone, rays, ~rigs.given, np.where(used, np.pi, 0.0)).xyz
    block = replace(
        rigs.alone, cameras=tuple(cameras), tables={}, points=replace(rigs.alone.points, xyz=xyz),
        images=replace(own, centre=centre, rotation=rotation, held=np.ones(len(used), bool)),
    )  # fmt: skip
    free: dict[str, tuple[str, ...]] = {c.id: MOUNTING if k == camera else () for k, c in enumerate(cameras)}
    options = AdjustmentOptions(robust_start=True, statistics=False, max_iterations=30)
    try:
        found, _ = estimate_only(block, options, free, ~rows)
    except (InputError, NotSolvable, np.linalg.LinAlgError):
        return mounting
    return given_mounting(found.cameras[camera])


def _judged(rigs: Rigs, images: Index, mounting: Mounting, loose: float = 1.0) -> tuple[float, int, int]:
    """What images (k,) of one camera on oriented stations bring together with a mounting.

    returns  sum of the angles between rays and points in units of their limits, each one at most; rays that fit; rays

    loose  factor of the limits

    Points that are not known are intersected, with these rays and those of oriented images.
    """
    alone = with_poses(rigs, rigs.alone, images, mounting)
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


def set_stations(rigs: Rigs, images: Mask) -> None:
    """Orient the stations by those of these images whose mounting is known."""
    ready = np.flatnonzero(images & np.isin(rigs.camera, list(rigs.mounting)))
    count = int(rigs.station.max(initial=-1)) + 1
    for s, mine in enumerate(rows_of_each(rigs.station[ready], count)):
        if not len(mine):
            continue
        poses = [_rig_by_image(rigs, i) for i in ready[mine].tolist()]
        if len(poses) > 1:
            rays = station_rays(rigs, ready[mine])
            poses = [refined_station(rays, *min(poses, key=lambda p: rays.cost(*p)))]
        rigs.pose[s] = poses[0]


def _rig_by_image(rigs: Rigs, image: int) -> Mounting:
    """Rotation and centre of the rig from those of one of its images."""
    own, (M, b) = rigs.alone.images, rigs.mounting[int(rigs.camera[image])]
    R = M.T @ own.rotation[image]
    return R, own.centre[image] - R.T @ b
