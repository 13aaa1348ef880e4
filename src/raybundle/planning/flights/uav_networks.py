"""Flights over a rectangle of ground: to see what strips, headings and tilted cross strips determine."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.block.block import Block, Camera
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.numerics.attitude import rotation_from_gimbal
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.flights.aerial import PLACES, control_rows
from raybundle.planning.flights.aerial_block import Aerial, aerial_block
from raybundle.planning.synthetic_networks import Scene, brown_camera

LEAST_POINTS = 4
"""Tie points along the shorter side of the ground"""
ROUNDING = 1e-9
"""Of a number of lines or photographs: ground of whole ones asks for no further one"""
FREE = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2")


def uav_camera() -> Camera:
    """20 megapixels, c = 3650 px, no distortion, the eight terms of Brown's model free."""
    values = dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S"), 0.0)
    return brown_camera(values={"c": 8.76, **values}, size_px=(5472, 3648), pixel_mm=0.0024, estimate=FREE)


@dataclass(frozen=True, slots=True, kw_only=True)
class Flight:
    """Lines of photographs over a rectangle of ground, the longer side of the format across the flight."""

    camera: Camera = field(default_factory=uav_camera)
    seed: int = 1
    height: float = 80.0
    """Above the middle of the ground [m]"""
    relief: float = 0.0
    """Between the lowest and the highest ground point, as a share of the height: hills nearly as large as the ground"""
    lines: int = 4
    photographs: int = 8
    """In each line"""
    spacing: float = 48.0
    """Between lines [m]"""
    base: float = 16.0
    """Between photographs of a line [m]"""
    size: float = 120.0
    """Side of the ground across the lines [m]"""
    length: float | None = None
    """Its side along the lines [m]; None: it is a square"""
    points: int = 30
    """Tie points along its longer side"""
    alternating: bool = False
    """Whether every second line is flown the other way, so that the heading differs by 180 degrees"""
    cross_tilt_deg: float | None = None
    """Tilt of as many photographs again in lines across, forward and backward by turns; None: no such lines"""
    cross_height: float | None = None
    """Of the lines across, above the middle of the ground [m]; None: as high as the others"""
    height_jitter: float = 0.5
    """Standard deviation of the flying height [m]"""
    angle_jitter_deg: float = 1.5
    """Standard deviation of the turns about each axis of the image"""
    image_sigma_px: float = 0.3
    station_sigma: tuple[float, float, float] = (0.02, 0.02, 0.03)
    """Standard deviations of the positions east, north, up [m]"""
    lever_arm: bool = False
    """Whether the lever arm from the projection centre to the antenna is free"""
    read_out_s: float = 0.0
    """Read-out time of a rolling shutter, free [s]; 0: there is none"""
    speed: float = 10.0
    """On the lines, for the rolling shutter [m/s]"""
    least_points: int = 4
    """Photographs that show fewer are left out"""
    control: int = 0
    """Control points: as many as `raybundle.planning.flights.aerial.PLACES` has"""
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
    def sides(self) -> tuple[float, float]:
        """Of the ground, across and along the lines [m]."""
        return self.size, self.length or self.size

    @property
    def pixel_on_ground(self) -> float:
        """Side of a pixel on level ground [m]."""
        return self.height * self.camera.pixel_mm[0] / self.camera.values["c"]


def flight_scene(plan: Flight) -> Scene:
    """Stations and tie points of a flight, without errors of measurement."""
    rng = np.random.default_rng(plan.seed)
    across, forward, line = _grid(plan, plan.lines, plan.photographs)
    heading = np.where(plan.alternating & (line % 2 == 1), 180.0, 0.0)
    parts = [np.stack([across, forward, heading, np.zeros(len(line))])]
    if plan.cross_tilt_deg is not None or plan.cross_height is not None:
        across, forward, number = _grid(plan, *_lines_across(plan))
        turned = 90.0 + np.where(number % 2 == 1, 180.0, 0.0)
        parts.append(np.stack([forward, across, turned, np.full(len(number), plan.cross_tilt_deg or 0.0)]))
    x, y, yaw, tilt = np.concatenate(parts, axis=1)
    n = len(x)
    high = np.where(np.arange(n) < len(line), plan.height, plan.cross_height or plan.height)
    z = high + rng.normal(0, plan.height_jitter, n)
    jitter = np.radians(rng.normal(0, plan.angle_jitter_deg, (n, 3)))
    planned = rotation_from_gimbal(np.radians(np.stack([yaw, tilt - 90.0, np.zeros(n)], axis=1)))
    wide, long = plan.sides
    count = (max(LEAST_POINTS, round(plan.points * side / max(wide, long))) for side in (wide, long))
    px, py = (a.ravel() for a in np.meshgrid(*(np.linspace(-0.5, 0.5, n) for n in count)))
    return Scene(
        camera=plan.camera,
        centre=np.stack([x, y, z], axis=1),
        rotation=rotation_from_vector(jitter) @ planned,
        xyz=np.stack([px * wide, py * long, _hills(px, py) * plan.relief * plan.height], axis=1),
        name="flight",
    )


def _grid(plan: Flight, lines: int, photographs: int) -> tuple[Array, Array, Array]:
    """Places (n,) of photographs across their lines and along them [m], and the numbers of the lines."""
    line, along = np.divmod(np.arange(lines * photographs), photographs)
    return (line - (lines - 1) / 2) * plan.spacing, (along - (photographs - 1) / 2) * plan.base, line


def _lines_across(plan: Flight) -> tuple[int, int]:
    """Lines across and photographs of each: as many as along over a square, else as many as cover the ground."""
    if plan.length is None:
        return plan.lines, plan.photographs
    return covering((plan.length, plan.size), plan.spacing, plan.base)


def covering(sides: tuple[float, float], spacing: float, base: float) -> tuple[int, int]:
    """Lines, and photographs of each, over ground of two sides, across the lines and along them [m].

    They reach half a spacing beyond its edges, as those of a mission (`raybundle.missions.patterns`): an edge is seen
    from two lines.
    """
    wide, long = (side + spacing for side in sides)
    return math.ceil(wide / spacing - ROUNDING), math.ceil(long / base - ROUNDING) + 1


def _hills(x: Array, y: Array) -> Array:
    """Heights (p,) of hills over ground of sides 1: 1 between the lowest and the highest, 0 in the mean of these."""
    z = np.sin(2 * np.pi * 1.3 * x + 0.4) * np.cos(2 * np.pi * 1.1 * y)
    return (z - (z.max() + z.min()) / 2) / np.ptp(z)


def flight_block(plan: Flight) -> Block:
    """The block that a flight gives, with noise of the stated standard deviations and true approximate values."""
    block = aerial_block(flight_aerial(plan))
    rng = np.random.default_rng([plan.seed, 1])
    o, s, p = block.observations, block.stations, block.points
    image_noise = rng.normal(0, plan.image_sigma_px, o.xy_px.shape)
    stations = s.with_errors(rng)
    given = rng.normal(0, 1, p.xyz.shape) * np.nan_to_num(p.sigma)
    return replace(
        block, points=replace(p, xyz=p.xyz + given), observations=replace(o, xy_px=o.xy_px + image_noise)
    ).having(stations)


def flight_aerial(plan: Flight) -> Aerial:
    """The flight as stations over ground points; without the photographs that show too few points.

    raises  InputError where less than two are left, or for a number of control points without a layout
    """
    scene = flight_scene(plan)
    if plan.control and plan.control not in PLACES:
        raise InputError("simulation.control_layout", n=plan.control, known=list(PLACES))
    heading = scene.rotation[:, 1] * [1.0, 1.0, 0.0]  # upwards in the image is ahead
    speed = plan.speed / np.linalg.norm(heading, axis=1, keepdims=True)
    whole = Aerial(
        camera=scene.camera, centre=scene.centre, rotation=scene.rotation, ground=scene.xyz,
        image_sigma_px=plan.image_sigma_px, station_sigma=plan.station_sigma, lever_arm=plan.lever_arm,
        read_out_s=plan.read_out_s, velocity=heading * speed, control_sigma=plan.control_sigma, name=scene.name,
        control=control_rows(scene.xyz, PLACES[plan.control]) if plan.control else np.zeros(0, np.int64),
        about=f"simulated flight: {plan.lines} lines of {plan.photographs} photographs at {plan.height:g} m",
        source=f"raybundle simulation, seed {plan.seed}",
    )  # fmt: skip
    count = np.bincount(aerial_block(whole).observations.image, minlength=len(scene.centre))
    keep = np.flatnonzero(count >= plan.least_points)
    if len(keep) < 2:
        wide, long = plan.sides
        dense = max(plan.sides) / (plan.points - 1)
        raise InputError(
            "simulation.too_few_photographs",
            n=len(keep),
            total=len(count),
            least=plan.least_points,
            across_m=list(plan.footprint),
            spacing_m=dense,
            width_m=wide,
            length_m=long,
            base_m=plan.base,
            lines_m=plan.spacing,
        )
    return whole if len(keep) == len(count) else whole.part(keep)
