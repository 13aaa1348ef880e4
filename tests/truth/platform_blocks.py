"""Every frame sensor on every platform: a rig of two cameras, or cameras that are read while they move."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.block import Block, Camera
from raybundle.planning.simulate import measured
from raybundle.planning.synthetic_networks import look_at
from raybundle.platforms import Carried, sensor_models
from tests.truth.mixed_blocks import block_of, control_table

MOUNTING = {"bx": 0.312, "by": -0.011, "bz": 0.024, "om": 0.012, "ph": -0.051, "ka": 0.007}
MOTION = ("vx", "vy", "vz", "wx", "wy", "wz")
SIGMA = dict(zip(MOTION, (0.05, 0.05, 0.05, 0.01, 0.01, 0.01), strict=True))
WAY = (*MOTION, "ax", "ay", "az", "qx", "qy", "qz")
WAYS = dict(zip(WAY, (1e-3, -6e-4, 4e-4, 1e-4, -1.6e-4, 2e-4, 4e-5, -3e-5, 2e-5, 6e-6, -8e-6, 1e-5), strict=True))
WAY_SIGMA = dict(zip(WAY, (1e-4,) * 3 + (2e-5,) * 3 + (1e-5,) * 3 + (2e-6,) * 3, strict=True))
"""By the line [mm], and what GNSS and INS tell of it: 0.8 mm and 0.009 deg at the border of the format"""
COMBINATIONS = sorted(n for n, m in sensor_models.items() if isinstance(m, Carried) and m.frame and not m.local_width)
"""Of frames (pushbroom: test_mixed); coefficients of curves (spline) are too many for such blocks, see tests/sensors"""


def camera_of(model: str, **how) -> Camera:
    """A camera at typical values of its sensor."""
    sensor = sensor_models[model]
    base = sensor
    while isinstance(base, Carried):
        base = base.sensor
    values = dict.fromkeys(sensor.symbols, 0.0) | dict(zip(base.symbols, base.typical.tolist(), strict=True))
    width, height, pixel = 4000, 3000, 0.005
    if base.name == "spherical":
        width, height, pixel, values["c"] = 8000, 4000, 0.01, 80 / (2 * np.pi)
    return Camera(
        id=how.pop("id", "a"), model=model, width_px=width, height_px=height, pixel_mm=(pixel, pixel),
        values=values | how.pop("values", {}), **how,
    )  # fmt: skip


def platform_block(model: str, stations: int = 6) -> Block:
    """Images by a sensor on its platforms before a field of points, four of which are control."""
    rng = np.random.default_rng(31)
    p = 50
    xyz = np.column_stack([rng.uniform(-2, 2, p), rng.uniform(-1.5, 1.5, p), rng.uniform(-0.4, 0.4, p)])
    centre = np.column_stack(
        [rng.uniform(-1.5, 1.5, stations), rng.uniform(-1, 1, stations), rng.uniform(4, 5, stations)]
    )
    rotation = look_at(
        centre, rng.uniform(-0.3, 0.3, (stations, 3)), rng.uniform(0, 6, stations), up=np.array([0.0, 1.0, 0.0])
    )
    moving = dict(zip(MOTION, (0.5, -0.3, 0.2, 0.05, -0.08, 0.1), strict=True)) | {"r": 0.03 / 15}
    free, known = MOTION, SIGMA
    if "_trajectory" in model:
        moving, free, known = WAYS, WAY, WAY_SIGMA
    table = control_table(p, 5, 10, 0.001)
    if model.endswith("_mounted"):
        base = model.removesuffix("_mounted")
        rolling = moving if base.endswith(("_rolling", "_trajectory")) else {}
        left = camera_of(base, id="left", values=rolling)
        right = replace(camera_of(model, id="right", values=rolling | MOUNTING), estimate=tuple(MOUNTING))
        if rolling:  # images of one station share their motion: given for all of a camera's
            left = replace(left, estimate=free, sigma=known)
        block = block_of(
            [left, right], np.tile([0, 1], stations), np.repeat(centre, 2, axis=0), np.repeat(rotation, 2, axis=0),
            xyz, *table, station=np.repeat(np.arange(stations, dtype=np.int32), 2),
        )  # fmt: skip
        return measured(block, 0.2)
    camera = camera_of(model, values=moving, estimate=free, per_image=free, sigma=known)
    own = {i: {s: moving[s] * float(rng.uniform(-1.5, 1.5)) for s in free} for i in range(stations)}
    return measured(block_of([camera], np.zeros(stations), centre, rotation, xyz, *table, interior=own), 0.2)
