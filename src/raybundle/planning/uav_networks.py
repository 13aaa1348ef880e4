"""Flights with RTK positions over flat ground: to see what strips, headings and tilted cross strips determine."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.block.block import Block, Camera, Images, Observations, Points, Role, Stations
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.numerics.attitude import rotation_from_gimbal
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.scenes import Scene, brown_camera
from raybundle.planning.simulate import measured
from raybundle.settings import option

FREE = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2")


def uav_camera() -> Camera:
    """20 megapixels, c = 3650 px, no distortion, the eight terms of Brown's model free."""
    values = dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S"), 0.0)
    return brown_camera(values={"c": 8.76, **values}, size_px=(5472, 3648), pixel_mm=0.0024, estimate=FREE)


@dataclass(frozen=True, slots=True, kw_only=True)
class Flight:
    """Lines of photographs over a square of flat ground, the longer side of the format across the flight."""

    camera: Camera = field(default_factory=uav_camera)
    seed: int = 1
    height: float = 80.0
    """Above ground [m]"""
    lines: int = 4
    photographs: int = 8
    """In each line"""
    spacing: float = 48.0
    """Between lines [m]"""
    base: float = 16.0
    """Between photographs of a line [m]"""
    size: float = 120.0
    """Side of the square [m]"""
    points: int = 30
    """Tie points along a side of the square"""
    alternating: bool = False
    """Whether every second line is flown the other way, so that the heading differs by 180 degrees"""
    cross_tilt_deg: float | None = None
    """Tilt of as many photographs again in lines across, forward and backward by turns; None: no such lines"""
    height_jitter: float = 0.5
    """Standard deviation of the flying height [m]"""
    angle_jitter_deg: float = 1.5
    """Standard deviation of the turns about each axis of the image"""
    image_sigma_px: float = 0.3
    station_sigma: tuple[float, float, float] = (0.02, 0.02, 0.03)
    """Standard deviations of the positions east, north, up [m]"""
    least_points: int = 4
    """Photographs that show fewer are left out"""
    control: int = 0
    """Control points: the first in the middle, the others in the corners; at most 5"""
    control_sigma: tuple[float, float, float] = (0.01, 0.01, 0.02)
    """Their standard deviations [m]"""

    @property
    def footprint(self) -> tuple[float, float]:
        """What a level photograph covers along and across the flight [m]."""
        c = self.camera
        width, height = (n * size for n, size in zip((c.width_px, c.height_px), c.pixel_mm, strict=True))
        return self.height * height / c.values["c"], self.height * width / c.values["c"]

    @property
    def overlap(self) -> tuple[float, float]:
        """Share of a photograph that the next along and the next line show as well; negative for a gap."""
        along, across = self.footprint
        return 1 - self.base / along, 1 - self.spacing / across

    @property
    def pixel_on_ground(self) -> float:
        """Side of a pixel on level ground [m]."""
        return self.height * self.camera.pixel_mm[0] / self.camera.values["c"]


def flight_scene(plan: Flight) -> Scene:
    """Stations and tie points of a flight, without errors of measurement."""
    rng = np.random.default_rng(plan.seed)
    line, along = np.divmod(np.arange(plan.lines * plan.photographs), plan.photographs)
    across = (line - (plan.lines - 1) / 2) * plan.spacing
    forward = (along - (plan.photographs - 1) / 2) * plan.base
    heading = np.where(plan.alternating & (line % 2 == 1), 180.0, 0.0)
    parts = [np.stack([across, forward, heading, np.zeros(len(line))])]
    if plan.cross_tilt_deg is not None:
        turned = 90.0 + np.where(line % 2 == 1, 180.0, 0.0)
        parts.append(np.stack([forward, across, turned, np.full(len(line), plan.cross_tilt_deg)]))
    x, y, yaw, tilt = np.concatenate(parts, axis=1)
    n = len(x)
    z = plan.height + rng.normal(0, plan.height_jitter, n)
    jitter = np.radians(rng.normal(0, plan.angle_jitter_deg, (n, 3)))
    planned = rotation_from_gimbal(np.radians(np.stack([yaw, tilt - 90.0, np.zeros(n)], axis=1)))
    g = np.linspace(-0.5, 0.5, plan.points) * plan.size
    px, py = np.meshgrid(g, g)
    return Scene(
        camera=plan.camera,
        centre=np.stack([x, y, z], axis=1),
        rotation=rotation_from_vector(jitter) @ planned,
        xyz=np.stack([px.ravel(), py.ravel(), np.zeros(px.size)], axis=1),
        name="flight",
    )


def flight_block(plan: Flight) -> Block:
    """The block that a flight gives, with noise of the stated standard deviations and true approximate values."""
    block = _exact(flight_scene(plan), plan)
    rng = np.random.default_rng([plan.seed, 1])
    o, s, p = block.observations, block.stations, block.points
    image_noise = rng.normal(0, plan.image_sigma_px, o.xy_px.shape)
    stations = s.with_errors(rng)
    given = rng.normal(0, 1, p.xyz.shape) * np.nan_to_num(p.sigma)
    return replace(
        block, points=replace(p, xyz=p.xyz + given), observations=replace(o, xy_px=o.xy_px + image_noise)
    ).having(stations)


def _exact(scene: Scene, plan: Flight) -> Block:
    """Exact image points and positions; without the photographs that show too few points."""
    block = measured(_empty(scene, plan), plan.image_sigma_px)
    count = np.bincount(block.observations.image, minlength=len(block.images))
    keep = np.flatnonzero(count >= plan.least_points)
    if len(keep) < 2:
        across = " x ".join(f"{side:.3g}" for side in plan.footprint)
        raise InputError(
            f"flight: {len(keep)} of {len(count)} photographs show {plan.least_points} tie points or more, two are "
            f"needed. A photograph covers {across} m, tie points lie {plan.size / (plan.points - 1):.3g} m apart over "
            f"{plan.size:.3g} x {plan.size:.3g} m, photographs {plan.base:.3g} m and lines {plan.spacing:.3g} m: bring "
            f"these figures together ({option('height')}, {option('base')}, {option('spacing')}, {option('ground')}, "
            f"{option('points')}, {option('jitter')})"
        )
    if len(keep) == len(count):
        return block
    part = replace(scene, centre=scene.centre[keep], rotation=scene.rotation[keep])
    return measured(_empty(part, plan), plan.image_sigma_px)


def _empty(scene: Scene, plan: Flight) -> Block:
    """Stations and points without image points."""
    n, p = len(scene.centre), len(scene.xyz)
    role, sigma = np.full(p, Role.TIE, np.int32), np.full((p, 3), np.nan)
    chosen = _control(scene.xyz, plan)
    role[chosen], sigma[chosen] = Role.CONTROL, plan.control_sigma
    none = np.zeros(0, np.int32)
    return Block(
        name=scene.name,
        about=f"simulated flight: {plan.lines} lines of {plan.photographs} photographs at {plan.height:g} m",
        source=f"raybundle simulation, seed {plan.seed}",
        cameras=(scene.camera,),
        images=Images(
            ids=tuple(f"{k + 1:03d}" for k in range(n)),
            camera=np.zeros(n, np.int32),
            file=("",) * n,
            centre=scene.centre,
            rotation=scene.rotation,
        ),
        observations=Observations(image=none, point=none, xy_px=np.zeros((0, 2)), cov_px2=np.zeros((0, 3))),
        points=Points(
            ids=tuple(f"p{k + 1}" for k in range(p)),
            role=role,
            xyz=scene.xyz,
            sigma=sigma,
        ),
    ).having(
        Stations(
            image=np.arange(n, dtype=np.int32),
            xyz=scene.centre.copy(),
            sigma=np.tile(np.array(plan.station_sigma), (n, 1)),
        )
    )


def _control(xyz: Array, plan: Flight) -> list[int]:
    """Rows of the tie points nearest to the middle and to the corners of the ground."""
    places = np.array([[0, 0], [-1, -1], [1, 1], [-1, 1], [1, -1]]) * 0.4 * plan.size
    return [int(np.linalg.norm(xyz[:, :2] - at, axis=1).argmin()) for at in places[: plan.control]]
