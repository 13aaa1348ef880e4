"""Networks with everything that crosses the border of two parts."""

from dataclasses import replace

import numpy as np

from raybundle.block import Attitudes, Distances, Instrument, Stations
from raybundle.numerics.rotation import angles_from_rotation, rotation_from_vector
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.platforms import instrument_models


def flight(*, control=4, observed=True, bar=True, interior="exact", seed=1, images=9):
    """Three strips of one camera whose interior orientation is free; a GNSS shift each, an IMU, a long bar."""
    survey = Survey(
        image_sigma_px=0.3, control=control, control_sigma=(0.02, 0.02, 0.02), interior=interior, seed=seed,
        points="approximate", approximate=1e-4,
    )  # fmt: skip
    strips = AerialStrips(images_per_strip=images, points_per_image=25)
    made = simulate(aerial_scene(replace(strips, camera=replace(strips.camera, estimate=("c", "x0", "y0")))), survey)
    block, truth = made.observed, made.truth
    rng = np.random.default_rng(seed)
    n = len(truth.images)
    line = np.arange(n) // images
    if observed:
        symbols = instrument_models["antenna"].symbols
        antennas = tuple(
            Instrument(id=f"line{k}", model="antenna", estimate=("sx", "sy", "sz"), values=dict.fromkeys(symbols, 0.0))
            for k in range(int(line.max()) + 1)
        )
        imu = Instrument(
            id="imu",
            model="imu",
            estimate=instrument_models["imu"].symbols[:3],
            values=dict.fromkeys(instrument_models["imu"].symbols, 0.0),
        )
        shift = rng.normal(0, 0.3, (len(antennas), 3))
        stations = Stations(
            image=np.arange(n, dtype=np.int32), antenna=line.astype(np.int32), sigma=np.full((n, 3), 0.03),
            xyz=truth.images.centre + shift[line] + rng.normal(0, 0.03, (n, 3)),
        )  # fmt: skip
        turned = rotation_from_vector(rng.normal(0, 2e-4, (n, 3))) @ truth.images.rotation
        attitudes = Attitudes(
            image=np.arange(n, dtype=np.int32), angles=angles_from_rotation(turned), sigma=np.full((n, 3), 2e-4),
            imu=np.full(n, len(antennas), np.int32),
        )  # fmt: skip
        block = replace(block, instruments=(*antennas, imu)).having(stations, attitudes)
    if bar:
        seen = np.bincount(block.observations.point, minlength=len(block.points)) > 2
        x = np.where(seen, truth.points.xyz[:, 0], np.nan)
        ends = np.array([[np.nanargmin(x), np.nanargmax(x)]], np.int32)
        length = np.linalg.norm(np.diff(truth.points.xyz[ends[0]], axis=0), axis=1)
        bars = Distances(
            start=ends[:, 0], end=ends[:, 1], length=length + rng.normal(0, 0.01, 1), sigma=np.full(1, 0.01)
        )
        block = block.having(bars)
    return block
