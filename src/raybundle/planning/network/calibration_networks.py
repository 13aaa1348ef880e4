"""Networks for the calibration of a camera on a flat field, good and bad ones: to see what each determines."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from raybundle.block.block import Camera
from raybundle.numerics.arrays import Array
from raybundle.planning.synthetic_networks import Scene, brown_camera

FREE = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2")
ROLLS = (0.0, 90.0, 180.0, 270.0)


def calibration_camera() -> Camera:
    """24 megapixels, c = 4000 px, no distortion, the eight terms of Brown's model free."""
    values = dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S"), 0.0)
    return brown_camera(values={"c": 24.0, **values}, size_px=(6000, 4000), pixel_mm=0.006, estimate=FREE)


@dataclass(frozen=True, slots=True, kw_only=True)
class FlatField:
    """A flat field of points and photographs of it at equal azimuths, each axis through the middle of the field."""

    camera: Camera = field(default_factory=calibration_camera)
    size: float = 1.0
    """Side of the field [m]"""
    points: int = 10
    """Points along a side"""
    distances: tuple[float, ...] = (1.5,)
    """Of the stations from the middle [m], in turn"""
    tilt_deg: float = 30.0
    """Of the axes against the normal of the field"""
    rolls_deg: tuple[float, ...] = (0.0,)
    """Of the camera about its axis, in turn; 0: the x axis of the image along X of the field"""
    photographs: int = 8
    up_to_centre: bool = False
    """As one walks round a table: the upper side of each image towards the middle, whatever `rolls_deg` states"""
    shift: float = 0.0
    """Sideways steps between photographs [m]; for square views, which would otherwise be one photograph"""


def flat_field_scene(plan: FlatField) -> Scene:
    """The scene of a plan."""
    t = np.radians(plan.tilt_deg)
    g = ((np.arange(plan.points) + 0.5) / plan.points - 0.5) * plan.size
    x, y = np.meshgrid(g, g)
    centre, rotation = list[Array](), list[Array]()
    for k in range(plan.photographs):
        a = 2 * np.pi * k / plan.photographs
        out = np.array([np.sin(t) * np.cos(a), np.sin(t) * np.sin(a), np.cos(t)])
        aside = plan.shift * np.array([np.cos(a), np.sin(a), 0.0])
        if plan.up_to_centre:
            up = -np.array([np.cos(a), np.sin(a), 0.0])
            right = np.cross(up, out)
            right = right / np.linalg.norm(right)
        else:
            right = np.array([1.0, 0.0, 0.0]) - out[0] * out
            right = right / np.linalg.norm(right)
        frame = np.stack([right, np.cross(out, right), out])
        r = np.radians(0.0 if plan.up_to_centre else plan.rolls_deg[k % len(plan.rolls_deg)])
        roll = np.array([[np.cos(r), np.sin(r), 0], [-np.sin(r), np.cos(r), 0], [0, 0, 1]])
        centre.append(plan.distances[k % len(plan.distances)] * out + aside)
        rotation.append(roll @ frame)
    return Scene(
        camera=plan.camera,
        centre=np.array(centre),
        rotation=np.array(rotation),
        xyz=np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1),
        name="flat field",
    )
