"""How far from the axis a calibration holds: where its distortion folds over or has a pole.

The model itself is asked, whichever it is: along rays away from the axis the determinant of the derivatives of image
by direction (or, where distortion is one of image points, of corrected by measured point) keeps its sign as long as
image points and directions belong to each other one to one.  It goes through zero at a fold and through infinity at a
pole.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.block import Camera
from raybundle.cameras.conversions import parameter_vector
from raybundle.cameras.forward_camera import STEP, ForwardCamera, distorted
from raybundle.errors import Message, note, warning
from raybundle.numerics.arrays import Array
from raybundle.sensors import SensorModel, sensor_models

AZIMUTHS = 24
"""Directions about the axis."""
STEPS = 2000
"""Along each of them."""
CLOSER = 60
"""Halvings of a step, to the end of a float's digits."""
WIDEST = {"central": 89.99, "all round": 179.9}
"""Angles off the axis [deg] up to which is looked."""
FARTHEST = 4.0
"""Distance in the image, in that of its farthest corner, up to which is looked where distortion is one of image
points."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Validity:
    """Up to where image points and directions belong together one to one; what lies beyond must not be used.

    Limits: whether the calibration was determined so far out.
    """

    radius_px: float
    """Distance from the principal point in the image; inf: everywhere."""
    angle_deg: float
    """The same as an angle off the axis; 180 at most, 90 for a central projection."""
    corner_px: float
    """Distance of the farthest corner of the format from the principal point."""
    reason: Literal["fold", "pole", ""]
    """What ends it."""

    @property
    def whole_format(self) -> bool:
        """Whether the whole format lies within the valid radius."""
        return self.radius_px >= self.corner_px

    @property
    def message(self) -> Message:
        """The radius in words: a note, or a warning where it lies within the format."""
        made = note if self.whole_format else warning
        return made(
            "calibration.validity", reason=self.reason or "none", angle_deg=self.angle_deg,
            finite=bool(np.isfinite(self.radius_px)), radius_px=self.radius_px, corner_px=self.corner_px,
            inside=not self.whole_format,
        )  # fmt: skip


def validity(camera: Camera | ForwardCamera) -> Validity:
    """The valid radius of a camera, the smallest over all azimuths."""
    return _forward(camera) if isinstance(camera, ForwardCamera) else _of_model(camera)


Determinant = Callable[[Array, Array], Array]
"""Of distances (n,) from the axis and azimuths (n,) [rad]."""


@dataclass(frozen=True, slots=True)
class _End:
    """Where the determinant changes its sign first, one entry for each azimuth that has such a place."""

    at: Array
    azimuth: Array
    pole: bool


def _end(determinant: Determinant, farthest: float) -> _End | None:
    """The nearest change of sign; None where there is none.

    farthest  largest distance from the axis, of the kind that `determinant` takes
    """
    azimuth = np.arange(AZIMUTHS) * (2 * np.pi / AZIMUTHS)
    at = np.linspace(0, farthest, STEPS + 1)[1:]
    with np.errstate(all="ignore"):
        grid = determinant(np.repeat(at, AZIMUTHS), np.tile(azimuth, STEPS)).reshape(STEPS, AZIMUTHS)
        first = determinant(np.full(AZIMUTHS, at[0] * 1e-3), azimuth)
        wrong = ~(grid * np.sign(first) > 0)
        hit = np.flatnonzero(wrong.any(axis=0))
        if not len(hit):
            return None
        k = wrong[:, hit].argmax(axis=0)
        low, high = np.where(k > 0, at[k - 1], 0.0), at[k]
        for _ in range(CLOSER):
            middle = (low + high) / 2
            good = determinant(middle, azimuth[hit]) * np.sign(first[hit]) > 0
            low, high = np.where(good, middle, low), np.where(good, high, middle)
        before = np.abs(determinant(np.where(k > 0, at[k - 1], at[0] * 1e-3), azimuth[hit]))
        pole = np.abs(determinant(low, azimuth[hit])) > before
    nearest = int(low.argmin())
    same = pole == pole[nearest]
    return _End(low[same], azimuth[hit][same], bool(pole[nearest]))


def _corner(width: int, height: int, point: tuple[float, float]) -> float:
    return float(np.hypot(max(point[0], width - point[0]), max(point[1], height - point[1])))


def _forward(camera: ForwardCamera) -> Validity:
    central = camera.projection == "central"
    vector = camera.vector

    def points(angle: Array, azimuth: Array) -> Array:
        r = np.tan(angle) if central else angle
        return np.stack([camera.ca + r * np.cos(azimuth), camera.cb + r * np.sin(azimuth)])

    def determinant(angle: Array, azimuth: Array) -> Array:
        ideal = points(angle, azimuth)
        by_a = np.imag(distorted(ideal + np.array([[STEP * 1j], [0]]), vector)) / STEP
        by_b = np.imag(distorted(ideal + np.array([[0], [STEP * 1j]]), vector)) / STEP
        return by_a[0] * by_b[1] - by_a[1] * by_b[0]

    principal = distorted(np.array([[camera.ca], [camera.cb]]), vector)
    x, y = float(principal[0, 0]), float(principal[1, 0])
    corner = _corner(camera.width_px, camera.height_px, (x, y))
    widest = WIDEST["central" if central else "all round"]
    end = _end(determinant, np.radians(widest))
    if end is None:
        return Validity(radius_px=np.inf, angle_deg=90.0 if central else 180.0, corner_px=corner, reason="")
    radius = np.inf
    if not end.pole:
        radius = float(np.linalg.norm(distorted(points(end.at, end.azimuth), vector) - principal, axis=0).min())
    return _validity(end, radius, corner, float(np.degrees(end.at.min())))


def _validity(end: _End, radius: float, corner: float, angle: float) -> Validity:
    return Validity(radius_px=radius, angle_deg=angle, corner_px=corner, reason="pole" if end.pole else "fold")


def _of_model(camera: Camera) -> Validity:
    model = sensor_models[camera.model]
    values = parameter_vector(camera)
    widest = 180.0 if model.all_round else 90.0
    if not model.one_exposure:
        corner = _corner(camera.width_px, camera.height_px, (camera.width_px / 2, camera.height_px / 2))
        return Validity(radius_px=np.inf, angle_deg=180.0, corner_px=corner, reason="")
    named = dict(zip(model.symbols, values.tolist(), strict=True))
    centre = np.array([named.get("x0", 0.0), named.get("y0", 0.0)])
    x, y = camera.pixel_from_image(centre[None])[0].tolist()
    corner = _corner(camera.width_px, camera.height_px, (x, y))
    ended = _of_directions if _explicit(model, values, centre) else _of_image_points
    found = ended(camera, model, values, centre, corner)
    return found or Validity(radius_px=np.inf, angle_deg=widest, corner_px=corner, reason="")


def _explicit(model: SensorModel, values: Array, centre: Array) -> bool:
    """Whether the condition is an image point minus a function of the direction."""
    image = centre[:, None] + values[0] * np.array([[0.0, 0.1, -0.3], [0.0, 0.2, 0.1]])
    ray = np.tile([[0.0], [0.0], [-1.0]], 3)
    by_image = model.condition_and_jacobian(*image, *ray, *values)[1][:, :2]
    return bool(np.abs(by_image - np.eye(2)[:, :, None]).max() < 1e-12)


def _of_directions(camera: Camera, model: SensorModel, values: Array, centre: Array, corner: float) -> Validity | None:
    """Where the image of directions folds over."""
    del centre

    def rays(angle: Array, azimuth: Array) -> Array:
        return np.stack([np.sin(angle) * np.cos(azimuth), np.sin(angle) * np.sin(azimuth), -np.cos(angle)])

    def images(ray: Array) -> Array:
        return -model.condition_at(np.zeros((2, ray.shape[1])), ray, values)

    def determinant(angle: Array, azimuth: Array) -> Array:
        ray = rays(angle, azimuth)
        cos, sin = np.cos(azimuth), np.sin(azimuth)
        outwards = np.stack([np.cos(angle) * cos, np.cos(angle) * sin, np.sin(angle)])
        around = np.stack([-sin, cos, np.zeros_like(sin)])
        by_ray = model.condition_and_jacobian(*images(ray), *ray, *values)[1][:, 2:5]
        a, b = np.einsum("ken,en->kn", by_ray, outwards), np.einsum("ken,en->kn", by_ray, around)
        return a[0] * b[1] - a[1] * b[0]

    end = _end(determinant, np.radians(WIDEST["all round" if model.all_round else "central"]))
    if end is None:
        return None
    radius = np.inf
    if not end.pole:
        axis = images(np.array([[0.0], [0.0], [-1.0]]))
        away = (images(rays(end.at, end.azimuth)) - axis) / np.array(camera.pixel_mm)[:, None]
        radius = float(np.linalg.norm(away, axis=0).min())
    return _validity(end, radius, corner, float(np.degrees(end.at.min())))


def _of_image_points(
    camera: Camera, model: SensorModel, values: Array, centre: Array, corner: float
) -> Validity | None:
    """Where the correction of image points folds over."""
    axis = np.tile([[0.0], [0.0], [-1.0]], 1)

    def images(radius: Array, azimuth: Array) -> Array:
        return centre[:, None] + radius * np.stack([np.cos(azimuth), np.sin(azimuth)])

    def determinant(radius: Array, azimuth: Array) -> Array:
        image = images(radius, azimuth)
        (a, b), (c, d) = model.condition_and_jacobian(*image, *np.tile(axis, len(radius)), *values)[1][:, :2]
        return a * d - b * c

    end = _end(determinant, FARTHEST * corner * max(camera.pixel_mm))
    if end is None:
        return None
    nearest = int(end.at.argmin())
    away = end.at * np.hypot(np.cos(end.azimuth) / camera.pixel_mm[0], np.sin(end.azimuth) / camera.pixel_mm[1])
    way = images(end.at[nearest] * np.linspace(0, 1, 41)[1:], np.full(40, end.azimuth[nearest]))
    angle = _angle(model, values, way)
    return _validity(end, float(away.min()), corner, angle)


def _angle(model: SensorModel, values: Array, way: Array) -> float:
    """Angle off the axis [deg] at the end of a way (2, n) of image points away from the axis."""
    ray = None if model.by_image else np.array([[0.0], [0.0], [-1.0]])
    with np.errstate(all="ignore"):
        for image in way.T[-1:] if model.by_image else way.T:
            ray = model.ray(image[:, None], values, ray)
    assert ray is not None
    return float(np.degrees(np.arctan2(np.hypot(ray[0, 0], ray[1, 0]), -ray[2, 0])))
