"""Rigs of several cameras in a room, at their true values, and starts that are rough or not there at all."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.block import Block, Camera
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.simulate import measured
from raybundle.platforms.rig import ANGLES, OFFSET
from raybundle.sensors import sensor_models
from tests.truth.mixed_blocks import block_of, control_table

ROOM = np.array([6.0, 5.0, 3.0])
MOUNTING = (*OFFSET, *ANGLES)
UPRIGHT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""Object axes to those of an upright camera that looks along +Y"""
QUARTER = np.pi / 2
RIGS = {
    "pair": (12.0, [(0.30, 0.01, -0.02, 0.01, -0.03, 0.02)]),
    "back to back": (12.0, [(0.03, 0.02, 0.15, 0.02, np.pi - 0.03, 0.01)]),
    "six": (
        14.0,
        [
            (0.09, 0.01, 0.08, 0.01, QUARTER, 0.02),
            (0.01, -0.01, 0.17, 0.02, np.pi - 0.02, -0.01),
            (-0.09, 0.0, 0.08, -0.02, -QUARTER, 0.01),
            (0.0, 0.09, 0.08, QUARTER, 0.01, 0.03),
            (0.0, -0.09, 0.08, -QUARTER, 0.02, -0.02),
        ],
    ),
}
"""Camera constant [mm] and the mountings of the other cameras in the frame of the first"""
LEAST = 8
"""Points that two stations have in common which hang together"""


def rig_block(
    kind: str, seed: int, *, stations: int = 12, points: int = 160, sigma_px: float = 0.5, control: int = 6,
    free: tuple[str, ...] = MOUNTING, noise: bool = True,
    turn: float = np.pi,
) -> Block:  # fmt: skip
    """A rig in a room of 6 x 5 x 3 m with points on its walls; image points with errors, all else at true values.

    turn  largest heading of a station [rad]

    Drawn again where stations do not hang together by pairs with `LEAST` points in common.
    """
    how = {"stations": stations, "points": points, "sigma_px": sigma_px, "control": control, "free": free}
    for attempt in range(500):
        rng = np.random.default_rng([7, seed, attempt])
        block = _drawn(kind, rng, turn=turn, **how)
        if _hangs_together(block):
            break
    if not noise:
        return block
    o, given = block.observations, block.points
    moved = given.xyz + np.nan_to_num(given.sigma) * rng.normal(0, 1, given.xyz.shape)
    return replace(
        block,
        observations=replace(o, xy_px=o.xy_px + rng.normal(0, sigma_px, o.xy_px.shape)),
        points=replace(given, xyz=moved),
    )


def _hangs_together(block: Block) -> bool:
    """Whether every station is reached from the first one over pairs with `LEAST` points in common."""
    o, station = block.observations, block.images.station
    seen = np.zeros((int(station.max()) + 1, len(block.points)), int)
    seen[station[o.image], o.point] = 1
    near = seen @ seen.T >= LEAST
    return bool((np.linalg.matrix_power(near.astype(float), len(near))[0] > 0).all())


def _drawn(kind: str, rng, *, stations: int, points: int, sigma_px: float, control: int, free, turn: float) -> Block:
    """The block without errors."""
    xyz = rng.uniform(0, 1, (points, 3)) * ROOM
    side = rng.integers(0, 3, points)
    xyz[np.arange(points), side] = rng.integers(0, 2, points) * ROOM[side]
    xyz += rng.normal(0, 0.02, xyz.shape)
    xyz[:6] = (
        np.array([[0, 0.2, 0.3], [1, 0.3, 0.8], [0.7, 0, 0.9], [0.2, 1, 0.7], [0.5, 1, 0.1], [1, 0.8, 0.2]]) * ROOM
    )
    c, mountings = RIGS[kind]
    symbols = sensor_models["brown_mounted"].symbols
    values = dict.fromkeys(symbols, 0.0) | {"c": c, "K1": -1e-4}
    first = Camera(
        id="cam0", model="brown", width_px=4000, height_px=3000, pixel_mm=(0.005, 0.005),
        values={s: values[s] for s in sensor_models["brown"].symbols}, estimate=(),
    )  # fmt: skip
    others = [
        replace(
            first, id=f"cam{k + 1}", model="brown_mounted", estimate=free,
            values=values | dict(zip(MOUNTING, m, strict=True)),
        )
        for k, m in enumerate(mountings)
    ]  # fmt: skip
    cameras = [first, *others]
    n, m = len(cameras), stations
    centre = ROOM * [0.5, 0.5, 0.5] + rng.uniform(-1, 1, (m, 3)) * [1.6, 1.2, 0.5]
    heading = np.column_stack([rng.normal(0, 0.15, m), rng.normal(0, 0.15, m), rng.uniform(-turn, turn, m)])
    rotation = UPRIGHT @ rotation_from_vector(heading)
    block = block_of(
        cameras, np.tile(np.arange(n), m), np.repeat(centre, n, axis=0), np.repeat(rotation, n, axis=0), xyz,
        *control_table(points, control, 0, 0.001), station=np.repeat(np.arange(m, dtype=np.int32), n),
    )  # fmt: skip
    return measured(block, sigma_px)


def rough(block: Block, seed: int, *, centre: float, degrees: float, points: float | None, mounting: str) -> Block:
    """The block with a start of this roughness.

    centre    standard deviation of a station's coordinates; NaN: no exterior orientation at all
    degrees   of a station's rotation, about each axis
    points    of the tie points' coordinates; None: they have none
    mounting  true, near (1 cm, 0.5 degrees) or unknown (0)
    """
    rng = np.random.default_rng([8, seed])
    station = block.images.station
    count = int(station.max()) + 1
    shift = (rng.normal(0, 1, (count, 3)) * centre)[station]
    turn = rotation_from_vector(rng.normal(0, 1, (count, 3)) * np.radians(degrees))[station]
    tie = ~block.points.is_control.any(axis=1)
    error = rng.normal(0, 1, block.points.xyz.shape)
    moved = np.where(tie[:, None], block.points.xyz + (np.nan if points is None else points * error), block.points.xyz)
    cameras = []
    for camera in block.cameras:
        values = dict(camera.values)
        for s in camera.estimate if mounting != "true" else ():
            if s in MOUNTING:
                near = values[s] + rng.normal() * (0.01 if s in OFFSET else np.radians(0.5))
                values[s] = near if mounting == "near" else 0.0
        cameras.append(replace(camera, values=values))
    images = replace(block.images, centre=block.images.centre + shift, rotation=turn @ block.images.rotation)
    if not np.isfinite(centre):
        images = replace(images, rotation=np.full_like(images.rotation, np.nan))
    return replace(block, cameras=tuple(cameras), images=images, points=replace(block.points, xyz=moved))
