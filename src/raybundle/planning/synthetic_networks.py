"""Scenes to be simulated: cameras and points of fields of targets, strips, rings and single photographs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from raybundle.block.block import (
    Camera,
    LengthUnit,
)
from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import rotation_from_vector


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """Geometry without errors."""

    camera: Camera
    """With true values."""
    centre: Array
    """(n, 3) projection centres."""
    rotation: Array
    """(n, 3, 3) object axes to image axes."""
    xyz: Array
    """(p, 3) object points."""
    normal: Array | None = None
    """(p, 3) outward surface normals; a point is seen only from its outer side.  None: from everywhere."""
    name: str = "simulated"
    length_unit: LengthUnit = "m"


def brown_camera(
    *,
    values: Mapping[str, float] | None = None,
    size_px: tuple[int, int] = (6000, 4000),
    pixel_mm: float = 0.004,
    estimate: tuple[str, ...] = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2"),
) -> Camera:
    """A camera with 24 mm x 16 mm format and the distortion of a good 20 mm lens, unless stated otherwise."""
    lens = {"c": 20.4, "x0": 0.041, "y0": -0.063, "K1": 2.1e-4, "K2": -4.2e-7, "K3": 3.0e-10, "P1": 9e-6, "P2": -6e-6}
    return Camera(
        id="1",
        model="brown",
        width_px=size_px[0],
        height_px=size_px[1],
        pixel_mm=(pixel_mm, pixel_mm),
        values={"A": 0.0, "S": 0.0, **lens, **(values or {})},
        estimate=estimate,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetField:
    """Convergent images of a field of targets, rolled by quarter turns."""

    camera: Camera = field(default_factory=brown_camera)
    size: tuple[float, float] = (2.4, 1.6)
    """Width and height of the field (X, Y)."""
    depth: float = 0.4
    """Height of the relief; 0 = a flat field."""
    rows: int = 10
    columns: int = 14
    stations: int = 16
    """On a circle round the field, besides `frontal` ones."""
    frontal: int = 4
    """Images squarely in front of the field."""
    tilt_deg: float = 35.0
    """Angle between the view from the circle and the field's normal."""
    distance: float = 2.2
    roll_deg: tuple[float, ...] = (0.0, 90.0, 180.0, 270.0)
    """Taken in turn."""
    seed: int = 7
    """Of the relief and the freehand scatter of the stations."""


@dataclass(frozen=True, slots=True, kw_only=True)
class AerialStrips:
    """Parallel strips of vertical images over hilly ground; flown there and back."""

    camera: Camera = field(
        default_factory=lambda: brown_camera(
            values={"c": 50.0, "x0": 0.0, "y0": 0.0, "K1": 0.0, "K2": 0.0, "K3": 0.0, "P1": 0.0, "P2": 0.0},
            size_px=(10000, 7500),
            pixel_mm=0.005,
            estimate=(),
        )
    )
    height: float = 800.0
    """Above mean ground."""
    relief: float = 40.0
    strips: int = 3
    images_per_strip: int = 6
    forward_overlap: float = 0.6
    side_overlap: float = 0.3
    points_per_image: int = 60
    wobble_deg: float = 2.0
    """Scatter of omega, phi and kappa."""
    seed: int = 7


@dataclass(frozen=True, slots=True, kw_only=True)
class Ring:
    """Stations on rings round a cylinder; a point is seen only from its own side."""

    camera: Camera = field(default_factory=brown_camera)
    radius: float = 1.0
    height: float = 2.0
    distance: float = 4.0
    """Of the stations from the axis."""
    stations: int = 16
    """On each ring."""
    rings: int = 2
    points: int = 300
    roll_deg: tuple[float, ...] = (0.0, 90.0)
    seed: int = 7


@dataclass(frozen=True, slots=True, kw_only=True)
class SinglePhoto:
    """One photo of a few points at various depths: a resection."""

    camera: Camera = field(default_factory=lambda: brown_camera(estimate=()))
    points: int = 12
    distance: float = 10.0
    depth: float = 3.0
    seed: int = 7


def look_at(centre: Array, target: Array, roll: Array | float = 0.0, up: Array | None = None) -> Array:
    """Rotations (n, 3, 3), object axes to image axes, of cameras at `centre` (n, 3) that view `target` (n, 3).

    roll  turn of the image about the viewing axis, against the position in which `up` is up [rad]
    """
    back = np.atleast_2d(centre) - np.atleast_2d(target)
    back = back / np.linalg.norm(back, axis=1, keepdims=True)
    right = np.cross(np.array([0.0, 0.0, 1.0]) if up is None else up, back)
    plumb = np.linalg.norm(right, axis=1) < 1e-9
    right[plumb] = np.cross([0.0, 1.0, 0.0], back[plumb])
    right /= np.linalg.norm(right, axis=1, keepdims=True)
    upright = np.stack([right, np.cross(back, right), back], axis=1)
    turn = np.zeros((len(back), 3))
    turn[:, 2] = -np.asarray(roll)
    return rotation_from_vector(turn) @ upright


def field_scene(plan: TargetField) -> Scene:
    """Points and stations of a testfield; the field lies in the plane Z = 0, the stations above it."""
    rng = np.random.default_rng(plan.seed)
    w, h = plan.size
    x, y = np.meshgrid(np.linspace(-w / 2, w / 2, plan.columns), np.linspace(-h / 2, h / 2, plan.rows))
    z = plan.depth * rng.integers(0, 5, x.size) / 4
    xyz = np.stack([x.ravel(), y.ravel(), z], axis=1)
    n = plan.stations + plan.frontal
    azimuth = 2 * np.pi * np.arange(plan.stations) / max(plan.stations, 1)
    tilt = np.radians(plan.tilt_deg + rng.uniform(-5, 5, plan.stations))
    circle = np.stack([np.sin(tilt) * np.cos(azimuth), np.sin(tilt) * np.sin(azimuth), np.cos(tilt)], axis=1)
    frontal = np.tile([0.0, 0.0, 1.0], (plan.frontal, 1))
    scatter = rng.uniform(-0.05, 0.05, (n, 3)) * plan.distance
    centre = np.concatenate([circle, frontal]) * plan.distance * rng.uniform(0.9, 1.15, (n, 1)) + scatter
    target = rng.uniform(-0.1, 0.1, (n, 3)) * [w, h, 0] + [0, 0, plan.depth / 2]
    roll = np.radians(np.resize(np.asarray(plan.roll_deg), n))
    rotation = look_at(centre, target, roll, up=np.array([0.0, 1.0, 0.0]))
    return Scene(camera=plan.camera, centre=centre, rotation=rotation, xyz=xyz, name="testfield")


def aerial_scene(plan: AerialStrips) -> Scene:
    """Points and stations of an aerial block, strips along X."""
    rng = np.random.default_rng(plan.seed)
    c = plan.camera.values["c"]
    width, height = plan.camera.size_mm * plan.height / c
    base, spacing = width * (1 - plan.forward_overlap), height * (1 - plan.side_overlap)
    strip, along = np.divmod(np.arange(plan.strips * plan.images_per_strip), plan.images_per_strip)
    back = strip % 2 == 1
    x = np.where(back, plan.images_per_strip - 1 - along, along) * base
    n = len(x)
    centre = np.stack([x, strip * spacing, np.full(n, plan.height)], axis=1)
    centre += rng.uniform(-0.02, 0.02, (n, 3)) * plan.height
    angles = rng.normal(0, np.radians(plan.wobble_deg), (n, 3))
    level = np.tile(np.eye(3), (n, 1, 1))
    level[back] = np.diag([-1.0, -1.0, 1.0])
    rotation = rotation_from_vector(angles) @ level
    low = [-width / 2, -height / 2]
    high = [(plan.images_per_strip - 1) * base + width / 2, (plan.strips - 1) * spacing + height / 2]
    area = (high[0] - low[0]) * (high[1] - low[1])
    count = max(4, round(plan.points_per_image * area / (width * height)))
    xy = rng.uniform(low, high, (count, 2))
    wave = np.sin(3 * np.pi * xy[:, 0] / (high[0] - low[0])) * np.cos(2 * np.pi * xy[:, 1] / (high[1] - low[1]))
    z = plan.relief / 2 * (wave + rng.uniform(-0.2, 0.2, count))
    xyz = np.column_stack([xy, z])
    return Scene(camera=plan.camera, centre=centre, rotation=rotation, xyz=xyz, name="aerial")


def ring_scene(plan: Ring) -> Scene:
    """Points on a cylinder about the Z axis, and stations on rings round it."""
    rng = np.random.default_rng(plan.seed)
    angle = rng.uniform(0, 2 * np.pi, plan.points)
    normal = np.stack([np.cos(angle), np.sin(angle), np.zeros(plan.points)], axis=1)
    xyz = plan.radius * rng.uniform(0.97, 1.03, (plan.points, 1)) * normal
    xyz[:, 2] = rng.uniform(-plan.height / 2, plan.height / 2, plan.points)
    ring, at = np.divmod(np.arange(plan.rings * plan.stations), plan.stations)
    turn = 2 * np.pi * (at + ring / plan.rings) / plan.stations
    level = plan.height * (ring / max(plan.rings - 1, 1) - 0.5) if plan.rings > 1 else np.zeros(len(ring))
    centre = np.stack([plan.distance * np.cos(turn), plan.distance * np.sin(turn), level], axis=1)
    roll = np.radians(np.resize(np.asarray(plan.roll_deg), len(centre)))
    rotation = look_at(centre, np.zeros_like(centre), roll)
    return Scene(camera=plan.camera, centre=centre, rotation=rotation, xyz=xyz, normal=normal, name="ring")


def single_scene(plan: SinglePhoto) -> Scene:
    """Points spread over the format of one photo taken in an arbitrary direction."""
    rng = np.random.default_rng(plan.seed)
    depth = plan.distance + rng.uniform(-plan.depth / 2, plan.depth / 2, plan.points)
    half = 0.42 * plan.camera.size_mm / plan.camera.values["c"]
    # one point in each cell of a grid, so that they are spread
    columns = int(np.ceil(np.sqrt(plan.points)))
    cell = np.stack(np.divmod(np.arange(plan.points), columns), axis=1) + rng.uniform(0.1, 0.9, (plan.points, 2))
    tangent = (2 * cell / [np.ceil(plan.points / columns), columns] - 1) * half
    sensor = np.column_stack([tangent * depth[:, None], -depth])
    rotation = rotation_from_vector(np.array([0.4, -0.3, 1.1]))
    centre = np.array([12.0, -7.0, 5.0])
    return Scene(
        camera=plan.camera,
        centre=centre[None],
        rotation=rotation[None],
        xyz=centre + sensor @ rotation,
        name="resection",
    )
