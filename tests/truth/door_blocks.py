"""Blocks as a user gives them: errors, gross errors, sigmas wrong by a factor, and no approximate values.

A case is a block at its true values with the standard deviations that are stated; `given` draws what was measured.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.block import Block, Camera
from raybundle.observations.distance import Distances
from raybundle.observations.station import Stations
from raybundle.observations.total_station import Directions, SlopeDistances, ZenithAngles
from raybundle.planning.flights.uav_networks import Flight, flight_block
from raybundle.planning.simulate import Survey, measured, simulate
from raybundle.planning.synthetic_networks import Scene, TargetField, brown_camera, field_scene
from tests.truth.platform_blocks import camera_of

GROSS_SHARE, GROSS_SIGMAS = 0.01, (5.0, 50.0)


@dataclass(frozen=True)
class Case:
    """A block at its true values, and how wrong what is stated of it is."""

    truth: Block
    factor: Mapping[str, float] = field(default_factory=dict)
    """Kind of observation -> true standard deviation over the stated one; 1 where not named"""
    wrong_control: float = 0.0
    """Share of the runs in which one control coordinate has a gross error"""
    wrong_bar: float = 0.0
    """Share of the runs in which one scale bar has"""
    gross: float = GROSS_SHARE
    """Share of the image points that have one"""

    @property
    def clean(self) -> Case:
        """The same with nothing to decide: no gross errors, and standard deviations as stated."""
        return Case(self.truth, gross=0.0)

    def given(self, seed: int) -> tuple[Block, np.ndarray]:
        """What a user brings, without orientations and tie points; and the gross errors (m,) of its image points.

        Measured with the true standard deviations, in units of which gross errors are given.
        """
        rng = np.random.default_rng([seed, 2026])
        t = self.truth
        xyz = np.where(t.points.is_control, self._control(rng), np.nan)
        xy, gross = self._image_points(rng)
        nowhere = np.full((len(t.images), 3), np.nan)
        block = replace(
            t,
            cameras=tuple(map(nominal, t.cameras)),
            images=replace(t.images, centre=nowhere, rotation=np.full((len(nowhere), 3, 3), np.nan)),
            observations=replace(t.observations, xy_px=xy),
            points=replace(t.points, xyz=xyz),
        ).having(*self._tables(rng))
        return block, gross

    def _image_points(self, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        o = self.truth.observations
        sigma = np.sqrt(o.cov_px2[:, :2]) * self.factor.get("image", 1.0)
        turn = rng.uniform(0, 2 * np.pi, len(o))
        size = (rng.random(len(o)) < self.gross) * rng.uniform(*GROSS_SIGMAS, len(o))
        gross = size[:, None] * np.stack([np.cos(turn), np.sin(turn)], axis=1)
        return o.xy_px + sigma * (rng.normal(0, 1, sigma.shape) + gross), size

    def _control(self, rng: np.random.Generator) -> np.ndarray:
        p = self.truth.points
        sigma = np.where(p.is_control, np.nan_to_num(p.sigma), 0.0) * self.factor.get("control", 1.0)
        error = rng.normal(0, 1, sigma.shape)
        if rng.random() < self.wrong_control:
            rows = np.argwhere(p.is_control)
            k, axis = rows[rng.integers(len(rows))]
            error[k, axis] += rng.uniform(*GROSS_SIGMAS) * rng.choice([-1, 1])
        return p.xyz + sigma * error

    def _tables(self, rng: np.random.Generator) -> list:
        measured_again = []
        for name, table in self.truth.tables.items():
            of = "length" if hasattr(table, "length") else "angle" if hasattr(table, "angle") else "xyz"
            value = getattr(table, of)
            error = rng.normal(0, 1, value.shape)
            if len(value) and rng.random() < self.wrong_bar and isinstance(table, Distances):
                error[rng.integers(len(error))] += rng.uniform(*GROSS_SIGMAS) * rng.choice([-1, 1])
            sigma = table.sigma * self.factor.get(name, 1.0)
            measured_again.append(replace(table, **{of: value + sigma * error}))
        return measured_again


def nominal(camera: Camera) -> Camera:
    """A camera as its maker describes it: the camera constant two per cent off, no distortion."""
    free = camera.sensor.symbols if camera.estimate == "auto" else camera.estimate
    scale = {p.symbol for p in camera.sensor.parameters if p.kind == "scale"}
    rough = {s: round(v * 0.98, 1) if s in scale else 0.0 for s, v in camera.values.items() if s in free}
    return replace(camera, values={**camera.values, **rough})


SIGMA_PX = 0.2
FIELD = TargetField(rows=6, columns=8, stations=8, frontal=2)


def close_range() -> Case:
    """A convergent network with self-calibration and nothing else: inner constraints."""
    survey = Survey(image_sigma_px=SIGMA_PX)
    return Case(simulate(field_scene(FIELD), survey).truth, {"image": 2.0})


def flight() -> Case:
    """A flight with GNSS positions and control; the positions are less precise than stated."""
    plan = Flight(
        lines=3, photographs=5, alternating=True, cross_tilt_deg=25.0, points=9, base=20.0, control=5,
        image_sigma_px=1e-9, station_sigma=(1e-9,) * 3, control_sigma=(1e-9,) * 3,
    )  # fmt: skip
    exact, sigma = flight_block(plan), np.array([0.02, 0.02, 0.03])
    stations = Stations(
        image=exact.stations.image, xyz=exact.images.centre.copy(), sigma=np.tile(sigma, (len(exact.images), 1))
    )
    control = np.where(exact.points.is_control, [0.01, 0.01, 0.02], np.nan)
    exact = replace(exact, points=replace(exact.points, sigma=control)).having(stations)
    truth = measured(exact, 0.3)
    return Case(truth, {"stations": 2.5}, wrong_control=0.2)


def two_cameras() -> Case:
    """Two cameras of one field, with scale bars between targets; all sigmas are half of what they are."""
    truth = simulate(field_scene(FIELD), Survey(image_sigma_px=SIGMA_PX)).truth
    second = replace(brown_camera(values={"c": 28.7, "x0": -0.05, "y0": 0.02, "K1": 9e-5, "K2": -1e-7}), id="2")
    camera = np.arange(len(truth.images), dtype=np.int32) % 2
    truth = replace(truth, cameras=(*truth.cameras, second), images=replace(truth.images, camera=camera))
    truth = measured(truth, SIGMA_PX, least_rays=3)
    X = truth.points.xyz
    across = np.argsort(X[:, 0], kind="stable").astype(np.int32)
    start, end = across[:6], across[-6:]
    length = np.linalg.norm(X[start] - X[end], axis=1)
    truth = truth.having(Distances(start=start, end=end, length=length, sigma=np.full(6, 1e-4)))
    return Case(truth, {"image": 2.0, "distances": 2.0}, wrong_bar=0.2)


def fisheye() -> Case:
    """A fisheye in a field with weighted control; image points are more precise than stated."""
    camera = camera_of("fisheye", id="1", values={"x0": 0.03, "y0": -0.02}, estimate=("c", "x0", "y0", "K1", "K2"))
    scene: Scene = field_scene(replace(FIELD, camera=camera, distance=1.4, depth=0.6))
    survey = Survey(image_sigma_px=SIGMA_PX, control=6, control_sigma=(2e-4,) * 3)
    truth = simulate(scene, survey).truth
    return Case(truth, {"image": 0.6, "control": 0.6}, wrong_control=0.2)


def total_station() -> Case:
    """A field with sights of a total station, whose angles and distances are less precise than stated."""
    survey = Survey(image_sigma_px=SIGMA_PX, control=4, control_sigma=(5e-4,) * 3)
    truth = simulate(field_scene(FIELD), survey).truth
    X, role = truth.points.xyz, np.asarray(truth.points.role)
    first = int(np.flatnonzero(role == 1)[0])
    target = np.setdiff1d(np.arange(len(X)), [first])[::2].astype(np.int32)
    station, d = np.full(len(target), first, np.int32), X[target] - X[first]
    level = np.hypot(d[:, 0], d[:, 1])
    angle = np.full(len(target), 5e-5)
    truth = truth.having(
        Directions(
            set=("first",) * len(target), station=station, target=target,
            angle=np.arctan2(d[:, 0], d[:, 1]) % (2 * np.pi), sigma=angle,
        ),
        ZenithAngles(station=station, target=target, angle=np.arctan2(level, d[:, 2]), sigma=angle),
        SlopeDistances(station=station, target=target, length=np.linalg.norm(d, axis=1), sigma=np.full(len(d), 1e-4)),
    )  # fmt: skip
    sights = dict.fromkeys(("directions", "zenith_angles", "slope_distances"), 3.0)
    return Case(truth, sights)


CASES: dict[str, Callable[[], Case]] = {
    "close range": close_range,
    "flight": flight,
    "two cameras": two_cameras,
    "fisheye": fisheye,
    "total station": total_station,
}
