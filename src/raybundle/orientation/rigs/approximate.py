"""Approximate values of rigs: images oriented one by one, from them the mountings, then the stations.

Each image is oriented for itself, as if it stood on no rig.  Stations at which several cameras are oriented give their
mountings, the mean of those near the middle one.  Of the poses of a station by each of its images the one that most of
all its rays fit is taken; a station of which no image could be oriented is resected by the rays of all its cameras.
Cameras that share no points with the others stand in a system of their own, which common stations join.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.block import Block
from raybundle.block.rigs import (
    is_mounted,
    station_numbers,
    with_shared_orientation,
    without_rigs,
)
from raybundle.errors import Text, joined_texts, phrase
from raybundle.numerics.arrays import Mask
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.rows import rows_of_each
from raybundle.orientation.assembly import ApproximateValues, image_values
from raybundle.orientation.completion import complete
from raybundle.orientation.growth import Growth
from raybundle.orientation.rays import rays_of
from raybundle.orientation.rigs.mountings import fit, set_stations
from raybundle.orientation.rigs.pose import (
    resected_station,
)
from raybundle.orientation.rigs.state import (
    Rigs,
    at_stations,
    given_mounting,
    is_free,
    placed_images,
    renew_points,
    station_rays,
    values_of,
    with_poses,
)
from raybundle.orientation.rigs.systems import join, onto_control, scale_by_offsets, scaled_by_mountings

ROUNDS = 4
"""Times that images are oriented one by one, each time beside the stations found before."""


def rig_values(block: Block, progress: Progress = silent) -> ApproximateValues:
    """Approximate values of a block with rigs, as `approximate.possible_values`.

    Mountings that are held, or observed with a standard deviation, stay as given; they give a free block its scale.
    """
    given = with_shared_orientation(block)
    alone = without_rigs(given)
    found = image_values(alone, progress)
    rigs = _of_rigs(given, found)
    before = len(alone.images)
    for _ in range(ROUNDS):
        waiting = int((rigs.growth.seen & ~placed_images(rigs)).sum())
        if not waiting or waiting >= before:
            break
        before = waiting
        again = image_values(with_poses(rigs, alone, np.flatnonzero(placed_images(rigs))), progress)
        rigs = _of_rigs(given, again)
    return _values(rigs, found)


def _of_rigs(given: Block, found: ApproximateValues) -> Rigs:
    """Mountings and stations from images that are oriented one by one."""
    growth = Growth.of(found.block, rays_of(found.block))
    rigs = Rigs(
        block=given, alone=found.block, growth=growth, fits=~found.outliers,
        oriented=found.block.images.oriented & growth.seen, system=found.system.copy(),
        station=station_numbers(given.images), sound=np.zeros(len(given.points), bool),
    )  # fmt: skip
    known = {k: given_mounting(c) for k, c in enumerate(given.cameras) if not is_free(c)}
    scaled = set(found.scaled)
    order = np.unique(rigs.system[rigs.oriented], return_counts=True)
    systems = sorted(
        zip(*(a.tolist() for a in order), strict=True), key=lambda s: (s[0] != 0, s[0] not in scaled, -s[1])
    )
    main = -1
    for number, _ in systems:
        mine = rigs.oriented & (rigs.system == number)
        if number not in scaled and scaled_by_mountings(rigs, mine, known if main < 0 else rigs.mounting):
            scaled.add(number)
        if main < 0:
            main, rigs.local = number, number != 0
            renew_points(rigs, mine)
            fit(rigs, mine, known)
        elif join(rigs, main, mine, same_scale=number in scaled and main in scaled):
            rigs.system[mine] = main
            joined = rigs.oriented & (rigs.system == main)
            renew_points(rigs, joined)
            fit(rigs, joined, known)
    rigs.oriented &= rigs.system == main
    if main > 0 and not onto_control(rigs) and main not in scaled:
        scale_by_offsets(rigs)
    _keep_given(rigs)
    _resect_stations(rigs)
    return rigs


def _resect_stations(rigs: Rigs) -> None:
    """Orient stations of which no image is oriented by the rays of all their images."""
    waiting = rigs.growth.seen & ~np.isin(rigs.station, list(rigs.pose)) & np.isin(rigs.camera, list(rigs.mounting))
    images = np.flatnonzero(waiting)
    for s, mine in enumerate(rows_of_each(rigs.station[images], int(rigs.station.max(initial=-1)) + 1)):
        found = resected_station(station_rays(rigs, images[mine])) if len(mine) else None
        if found is not None:
            rigs.pose[s] = found


def _keep_given(rigs: Rigs) -> None:
    """Mountings with what is known of each, stations as they were given, the others by these.

    A camera of which no rays give a mounting has the given one: its points are known by it alone.
    """
    for k in np.unique(rigs.camera[at_stations(rigs)]).tolist():
        rigs.mounting.setdefault(k, given_mounting(rigs.block.cameras[k]))
    for k, (R, b) in list(rigs.mounting.items()):
        camera = rigs.block.cameras[k]
        if is_free(camera):
            rigs.mounting[k] = given_mounting(replace(camera, values=values_of(camera, (R, b))))
    if not rigs.oriented.any():
        return
    rigs.pose = {}
    set_stations(rigs, rigs.oriented)
    images = rigs.block.images
    for i in np.flatnonzero(images.oriented).tolist():
        rigs.pose[int(rigs.station[i])] = (images.rotation[i], images.centre[i])


def _values(rigs: Rigs, first: ApproximateValues) -> ApproximateValues:
    """The block with rigs as they were found, and its points from them."""
    block = rigs.block
    standing = placed_images(rigs)
    alone = with_poses(rigs, without_rigs(block), np.flatnonzero(standing))
    rays = rigs.growth.rays
    kept: Mask = np.asarray(np.isfinite(block.points.xyz).all(axis=1))
    points = complete(alone, rays, ~kept, 2 * rigs.growth.limits(alone.images.oriented & rigs.growth.seen))
    cameras = list(block.cameras)
    for k, camera in enumerate(block.cameras):
        values = {**camera.values, **rigs.alone.cameras[k].values}
        cameras[k] = replace(camera, values=values)
        if is_mounted(camera) and k in rigs.mounting:
            cameras[k] = replace(camera, values=values_of(cameras[k], rigs.mounting[k]))
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


def _reason(rigs: Rigs, image: int, first: ApproximateValues) -> Text:
    """Why an image could not be oriented: its own reason, and how much its station has."""
    own = first.not_oriented.get(rigs.block.images.ids[image])
    if rigs.system[image] != rigs.system[rigs.oriented].max(initial=0) and not own:
        own = phrase("not_oriented.other_cameras")
    mine = rigs.growth.seen & (rigs.station == rigs.station[image])
    rays = int(mine[rigs.growth.rays.image].sum())
    of_station = phrase("not_oriented.station", n=rays, images=int(mine.sum()))
    return joined_texts(own, of_station) if isinstance(own, Text) else of_station
