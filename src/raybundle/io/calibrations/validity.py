"""How far from the axis a calibration holds: where its radial distortion folds over or has a pole."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.block import Camera
from raybundle.cameras.conversions import parameter_vector
from raybundle.cameras.forward_camera import TERMS, ForwardCamera, first_limit
from raybundle.numerics.arrays import Array
from raybundle.sensors import sensor_models


@dataclass(frozen=True, slots=True, kw_only=True)
class Validity:
    """Up to where the radial part of a distortion grows; what lies beyond must not be used.

    What it does not tell: whether the calibration was determined so far out.
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

    def __str__(self) -> str:
        """One sentence for people."""
        if not self.reason:
            return "its radial distortion is invertible everywhere"
        words = {"fold": "its radial distortion folds over", "pole": "its radial distortion has a pole"}[self.reason]
        where = f" ({self.radius_px:.0f} px)" if np.isfinite(self.radius_px) else ""
        inside = "beyond the format" if self.whole_format else "WITHIN the format"
        corner = f"its corners are at {self.corner_px:.0f} px"
        return f"{words} at {self.angle_deg:.1f} deg off the axis{where}, {inside}; {corner}"


def validity(camera: Camera | ForwardCamera) -> Validity:
    """The valid radius of a camera, from its radial terms alone (roots of the derivative, and of a denominator)."""
    return _forward(camera) if isinstance(camera, ForwardCamera) else _measured(camera)


def _corner(width: int, height: int, point: tuple[float, float]) -> float:
    return float(np.hypot(max(point[0], width - point[0]), max(point[1], height - point[1])))


def _forward(camera: ForwardCamera) -> Validity:
    radius, reason = first_limit(camera.vector)
    central = camera.projection == "central"
    limit = np.inf
    if reason == "fold":
        values: dict[str, float] = dict(zip(TERMS, camera.vector.tolist(), strict=True))
        t = radius * radius
        top = sum((values[f"k{n}"] * t**n for n in range(1, 6)), 1.0)
        base = sum((values[f"d{n}"] * t**n for n in range(1, 4)), 1.0)
        limit = abs(radius * top / base) * min(camera.fx, camera.fy)
    angle = np.degrees(np.arctan(radius) if central else min(radius, np.pi))
    principal = (camera.cx + camera.fx * camera.ca, camera.cy + camera.fy * camera.cb)
    corner = _corner(camera.width_px, camera.height_px, principal)
    return Validity(radius_px=float(limit), angle_deg=float(angle), corner_px=corner, reason=reason)


def _measured(camera: Camera) -> Validity:
    model = sensor_models[camera.model]
    values = dict(zip(model.symbols, parameter_vector(camera).tolist(), strict=True))
    c, x0, y0 = (values.get(s, 0.0) for s in ("c", "x0", "y0"))
    x, y = camera.pixel_from_image(np.array([[x0, y0]]))[0].tolist()
    corner = _corner(camera.width_px, camera.height_px, (x, y))
    if camera.model in {"radial", "aicon"}:
        forward = _as_forward(camera, values, (x, y))
        return _forward(forward)
    K = np.array([values.get(s, 0.0) for s in ("K1", "K2", "K3")])
    growth = np.trim_zeros(np.array([1.0, *(K * [3, 5, 7])]), "b")
    roots = np.polynomial.Polynomial(growth).roots() if len(growth) > 1 else np.zeros(0)
    real = roots.real[(np.abs(roots.imag) <= 1e-9 * np.abs(roots)) & (roots.real > 0)]
    if not len(real):
        limit = 180.0 if camera.model == "fisheye" else 90.0
        return Validity(radius_px=np.inf, angle_deg=limit, corner_px=corner, reason="")
    t = float(real.min())
    measured = np.sqrt(t)
    corrected = measured * (1 + t * (K[0] + t * (K[1] + t * K[2])))
    angle = corrected / c if camera.model == "fisheye" else np.arctan(corrected / c)
    radius = measured / max(camera.pixel_mm)
    return Validity(radius_px=float(radius), angle_deg=float(np.degrees(angle)), corner_px=corner, reason="fold")


def _as_forward(camera: Camera, values: dict[str, float], principal: tuple[float, float]) -> ForwardCamera:
    """The radial part of a model that distorts the ideal point."""
    c = values["c"]
    terms: Array = np.array([1.0, values.get("k1", 0.0), values.get("k2", 0.0)])
    if camera.model == "aicon":
        K1, K2, z2 = values["K1"], values["K2"], values["R0"] ** 2
        terms = np.array([1 - K1 * z2 - K2 * z2 * z2, K1 * c**2, K2 * c**4])
    scale = c * terms[0]
    return ForwardCamera(
        width_px=camera.width_px,
        height_px=camera.height_px,
        fx=scale / camera.pixel_mm[0],
        fy=scale / camera.pixel_mm[1],
        cx=principal[0],
        cy=principal[1],
        k1=float(terms[1] / terms[0]),
        k2=float(terms[2] / terms[0]),
    )
