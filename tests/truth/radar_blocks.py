"""Blocks of radar scenes, with and without an optical one, at their true values."""

import functools

import numpy as np

from raybundle.block import Block
from raybundle.numerics.places import Local
from raybundle.planning.simulate import measured
from raybundle.scenes.kinds.range_doppler import RangeDopplerSensor, side_looking
from raybundle.scenes.sensor import scene_camera, view_of
from tests.truth.mixed_blocks import PLACE, block_of, control_table, satellite_cameras

SIGMA = {"dr": 3.0, "dt": 2e-4, "kr": 3e-6} | {f"{axis}{k}": 0.5 for axis in ("along", "across", "up") for k in (0, 1)}


def radar_camera(name, off_deg, *, degree=-1, rate=False, place=None, sigma=None):
    """A scene of 9 x 12 km from 693 km; at 3 and 4.6 degrees the incidence is 34 and 46 degrees."""
    sensor = RangeDopplerSensor(
        side_looking(PLACE, off_deg=off_deg), place or Local(origin=PLACE), degree, PLACE[2], range_rate=rate
    )
    own = {s: SIGMA[s] for s in sensor.symbols} if sigma is None else sigma
    return scene_camera(name, sensor, sigma=own)


def radar_block(*, optical=False, radars=2, degree=-1, rate=False, points=60, check=20) -> Block:
    """Two radar scenes of one side, four control points of 0.3 m, image points of 0.3 px; also an optical scene."""
    place = Local(origin=PLACE)
    cameras = [
        radar_camera(name, off, degree=degree, rate=rate, place=place) for name, off in (("A", 3.0), ("B", 4.6))
    ][:radars]
    if optical:
        cameras.append(satellite_cameras(place, size=12000)[0])
    rng = np.random.default_rng(1)
    xyz = np.column_stack([rng.uniform(-3500, 3500, (points, 2)), rng.uniform(-100, 400, points)])
    views = [view_of(c) for c in cameras]
    block = block_of(
        cameras, list(range(len(cameras))), [v.centre for v in views], [v.rotation for v in views], xyz,
        *control_table(points, 4, check, 0.3), held=np.ones(len(cameras), bool), place=place,
    )  # fmt: skip
    return measured(block, 0.3)


BLOCKS = {
    "two radar scenes": radar_block,
    "two radar scenes and an optical one": functools.partial(radar_block, optical=True),
    "one radar scene and an optical one": functools.partial(radar_block, optical=True, radars=1),
    "with corrections of the orbits": functools.partial(radar_block, optical=True, degree=1, rate=True),
}
