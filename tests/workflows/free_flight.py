"""A free block of a flight whose truth is known, with six points that are marked in it, and its positions."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.block.transform import transform_block
from raybundle.io.geo.control_files import ControlFile, Measurements
from raybundle.numerics.geodesy import LocalPlace
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.numerics.transform import SimilarityTransform
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene

NAMES = ("A", "B", "C", "D", "E", "F")


@pytest.fixture(scope="module")
def flight():
    """A free block somewhere, the truth, and six points with their marks."""
    simulation = simulate(aerial_scene(AerialStrips()), Survey(image_sigma_px=0.1, interior="exact"))
    truth = simulation.truth
    rays = truth.ray_count
    xyz = truth.points.xyz
    chosen: list[int] = []
    for corner in np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [0, 0], [0.5, -0.2]]):
        half = np.ptp(xyz[:, :2], axis=0) * 0.35
        distance = np.linalg.norm(xyz[:, :2] - (xyz[:, :2].mean(axis=0) + corner * half), axis=1)
        distance[rays < 4] = np.inf
        distance[chosen] = np.inf
        chosen.append(int(distance.argmin()))
    o = simulation.observed.observations
    rows = np.flatnonzero(np.isin(o.point, chosen))
    marks = Measurements(
        image=tuple(truth.images.ids[i] for i in o.image[rows]),
        point=np.array([chosen.index(p) for p in o.point[rows]], np.int32),
        xy_px=o.xy_px[rows],
        line=np.arange(2, 2 + len(rows), dtype=np.int32),
    )
    role = np.zeros(len(truth.points), np.int32)
    free = replace(
        truth,
        points=replace(truth.points, role=role, sigma=np.full_like(xyz, np.nan)),
        observations=simulation.observed.observations,
    )
    free = transform_block(
        free,
        SimilarityTransform(
            scale=0.013,
            rotation=rotation_from_angles(np.array([0.4, -0.3, 2.0])),
            translation=np.array([1.0, 2.0, 3.0]),
        ),
        observed="stay",
    )
    photos = [
        SimpleNamespace(
            name=name, width_px=truth.cameras[0].width_px, height_px=truth.cameras[0].height_px, orientation=1,
            metadata=SimpleNamespace(gps=None, make="", model="", serial="", taken=None),
        )
        for name in truth.images.ids
    ]  # fmt: skip
    return SimpleNamespace(free=free, truth=truth, photos=photos, marks=marks, xyz=xyz[chosen])


def control(flight, xyz=None, marks=None, sigma=0.01):
    xyz = flight.xyz if xyz is None else xyz
    return ControlFile(
        path=Path("control.csv"), crs=None, ids=NAMES, xyz=xyz, sigma=np.where(np.isfinite(xyz), sigma, np.nan),
        role=np.full(6, Role.CONTROL, np.int32), measurements=marks or flight.marks,
    )  # fmt: skip


def error(flight, placed):
    return np.linalg.norm(placed.block.images.centre - flight.truth.images.centre, axis=1).max()


def codes(placed):
    return {n.code for n in placed.notices}


CRS = "EPSG:4979"
PLACE = (8.0, 50.0, 200.0)


def with_gps(flight, noise=0.02, shift=(0.0, 0.0, 0.0), pause=None):
    """The photographs with RTK positions; after number `pause` half an hour goes by and the shift changes its sign."""
    rng = np.random.default_rng(1)
    place = LocalPlace(origin=PLACE)
    second = np.arange(len(flight.photos)) >= (len(flight.photos) if pause is None else pause)
    moved = flight.truth.images.centre + np.where(second[:, None], -1, 1) * np.array(shift)
    photos = []
    for k, (photo, at) in enumerate(zip(flight.photos, moved + rng.normal(0, noise, moved.shape), strict=True)):
        lon, lat, h = place.geographic_from_local(at[None])[0]
        gps = SimpleNamespace(
            latitude_deg=lat, longitude_deg=lon, altitude_m=h, sigma_m=(noise, noise, noise), fix="rtk fixed"
        )
        taken = datetime(2026, 5, 1, 10, tzinfo=UTC) + timedelta(seconds=2 * k + 1800 * bool(second[k]))
        metadata = SimpleNamespace(**{**vars(photo.metadata), "gps": gps, "taken": taken})
        photos.append(SimpleNamespace(**{**vars(photo), "metadata": metadata}))
    return photos


def in_degrees(flight, chosen):
    """Control in longitude, latitude, height; the others are measured only."""
    xyz = np.full_like(flight.xyz, np.nan)
    xyz[chosen] = LocalPlace(origin=PLACE).geographic_from_local(flight.xyz[chosen])
    return replace(control(flight, xyz), crs=CRS)


def adjusted(placed):
    return adjust_block(placed.block, AdjustmentOptions())
