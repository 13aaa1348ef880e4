"""Cameras with Brown's distortion, and photographs taken with them."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class InteriorOrientation:
    """Camera constant, principal point [mm] and the parameters of Brown (1971), A and S of Fraser (1997).

    With u = x - x0, v = y - y0, r2 = u^2 + v^2 the corrected point is
    u + u (K1 r2 + K2 r2^2 + K3 r2^3) + P1 (r2 + 2 u^2) + 2 P2 u v + A u + S v,
    v + v (K1 r2 + K2 r2^2 + K3 r2^3) + P2 (r2 + 2 v^2) + 2 P1 u v.
    """

    c: float
    x0: float = 0.0
    y0: float = 0.0
    K1: float = 0.0
    K2: float = 0.0
    K3: float = 0.0
    P1: float = 0.0
    P2: float = 0.0
    A: float = 0.0
    S: float = 0.0

    def corrections(self, u: Array, v: Array) -> tuple[Array, Array]:
        """Corrections (du, dv) [mm] at image points (u, v) [mm] measured from the principal point."""
        r2 = u * u + v * v
        radial = r2 * (self.K1 + r2 * (self.K2 + r2 * self.K3))
        du = u * radial + self.P1 * (r2 + 2 * u * u) + 2 * self.P2 * u * v + self.A * u + self.S * v
        dv = v * radial + self.P2 * (r2 + 2 * v * v) + 2 * self.P1 * u * v
        return du, dv

    def undistorted(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Points of the central projection [mm], from the principal point, of measured image points (x, y) [mm]."""
        u, v = x - self.x0, y - self.y0
        du, dv = self.corrections(u, v)
        return u + du, v + dv

    def distorted(self, u: Array, v: Array) -> tuple[Array, Array]:
        """Measured image points [mm] of points (u, v) of the central projection [mm]; the inverse of `undistorted`."""
        p, q = np.array(u, dtype=float), np.array(v, dtype=float)
        for _ in range(60):
            du, dv = self.corrections(p, q)
            step = np.maximum(np.abs(u - du - p), np.abs(v - dv - q))
            p, q = u - du, v - dv
            if step.size == 0 or np.nanmax(step) < 1e-12:
                break
        return p + self.x0, q + self.y0


@dataclass(frozen=True, slots=True, kw_only=True)
class Camera:
    """A frame camera: format, interior orientation, light fall-off and the names in its metadata."""

    name: str
    model: str
    width_px: int
    height_px: int
    pixel_mm: float
    interior: InteriorOrientation
    corner_light: float = 0.7
    """Light in the corners as a share of that in the centre."""

    @property
    def focal_35mm(self) -> float:
        """Focal length of the same diagonal angle of view on 36 x 24 mm."""
        diagonal = self.pixel_mm * np.hypot(self.width_px, self.height_px)
        return float(self.interior.c / diagonal * np.hypot(36, 24))

    def light(self, x_px: Array, y_px: Array) -> Array:
        """Share of light at pixels, 1 in the centre, by the fourth power of a cosine of an angle off axis."""
        half = np.hypot(self.width_px, self.height_px) / 2
        r2 = ((x_px - self.width_px / 2) ** 2 + (y_px - self.height_px / 2) ** 2) / half**2
        return 1 / (1 + r2 * (self.corner_light**-0.5 - 1)) ** 2


SENSORS = {
    "A": (
        13.2,
        0.7,
        InteriorOrientation(
            c=1.1 * 13.2, x0=0.031, y0=-0.022, K1=-1.1e-4, K2=6.0e-7, K3=-1.5e-9, P1=9e-6, P2=-7e-6, A=1.2e-4, S=-6e-5
        ),
    ),
    "B": (
        23.5,
        0.5,
        InteriorOrientation(
            c=0.85 * 23.5, x0=-0.07, y0=0.05, K1=2.6e-4, K2=-6.5e-7, K3=8e-10, P1=-6e-6, P2=8e-6, A=-8e-5, S=6e-5
        ),
    ),
}
"""Width of the format [mm], light in the corners and interior orientation of each camera."""


def camera(name: str, width_px: int, height_px: int) -> Camera:
    """Camera A (long focal length, little distortion) or B (wide angle, barrel distortion) of a format in pixels."""
    if name not in SENSORS:
        raise ValueError(f"camera {name!r} is not one of {', '.join(SENSORS)}")
    sensor_mm, corner_light, interior = SENSORS[name]
    return Camera(
        name=name,
        model=f"Rendering {name}",
        width_px=width_px,
        height_px=height_px,
        pixel_mm=sensor_mm / width_px,
        interior=interior,
        corner_light=corner_light,
    )


def rotation(omega: float, phi: float, kappa: float) -> Array:
    """R3(kappa) R2(phi) R1(omega) of angles [rad], object axes to image axes."""
    so, co, sp, cp, sk, ck = *_sin_cos(omega), *_sin_cos(phi), *_sin_cos(kappa)
    R1 = np.array([[1, 0, 0], [0, co, so], [0, -so, co]])
    R2 = np.array([[cp, 0, -sp], [0, 1, 0], [sp, 0, cp]])
    R3 = np.array([[ck, sk, 0], [-sk, ck, 0], [0, 0, 1]])
    return R3 @ R2 @ R1


def angles(R: Array) -> tuple[float, float, float]:
    """Angles omega, phi, kappa [rad] of a rotation matrix."""
    phi = np.arcsin(np.clip(R[2, 0], -1, 1))
    return float(np.arctan2(-R[2, 1], R[2, 2])), float(phi), float(np.arctan2(-R[1, 0], R[0, 0]))


def _sin_cos(angle: float) -> tuple[float, float]:
    return float(np.sin(angle)), float(np.cos(angle))


def small_rotation(vector: Array) -> Array:
    """exp([v]x), (..., 3, 3), of rotation vectors (..., 3) [rad] (Rodrigues)."""
    v = np.asarray(vector, dtype=float)
    angle = np.linalg.norm(v, axis=-1)[..., None, None]
    zero = np.zeros(v.shape[:-1])
    K = np.stack(
        [zero, -v[..., 2], v[..., 1], v[..., 2], zero, -v[..., 0], -v[..., 1], v[..., 0], zero], axis=-1
    ).reshape(*v.shape[:-1], 3, 3)
    return np.eye(3) + np.sinc(angle / np.pi) * K + 0.5 * np.sinc(angle / (2 * np.pi)) ** 2 * (K @ K)


@dataclass(frozen=True, slots=True, kw_only=True)
class Photograph:
    """A camera at a station; with a rolling shutter it moves while its rows are read.

    centre      (3,)    projection centre [m] at the middle row
    rotation    (3, 3)  object axes to image axes at the middle row
    velocity    (3,)    movement [m] during the read-out of the whole format
    turn        (3,)    rotation vector [rad], in image axes, during the same time
    """

    name: str
    camera: Camera
    interior: InteriorOrientation
    centre: Array
    rotation: Array
    velocity: Array = field(default_factory=lambda: np.zeros(3))
    turn: Array = field(default_factory=lambda: np.zeros(3))

    @property
    def moves(self) -> bool:
        """Whether the station changes during the read-out."""
        return bool(np.any(self.velocity) or np.any(self.turn))

    def rays(self, x_px: Array, y_px: Array) -> tuple[Array, Array]:
        """Rays of pixels: origins (..., 3) [m] and directions (..., 3), not of unit length.

        x_px and y_px have shapes that go together, as (1, n) and (m, 1).
        """
        cam, own = self.camera, self.interior
        x = (x_px - cam.width_px / 2) * cam.pixel_mm
        y = (cam.height_px / 2 - y_px) * cam.pixel_mm
        u, v = own.undistorted(x, y)
        image = np.stack([u, v, np.full_like(u, -own.c)], axis=-1)
        if not self.moves:
            return np.broadcast_to(self.centre, image.shape), image @ self.rotation
        centre, R = self._station_at(y_px)
        by_row = R.shape[-3] == 1
        turned = image @ R[..., 0, :, :] if by_row else np.einsum("...ij,...i->...j", R, image)
        return np.broadcast_to(centre, image.shape), turned

    def project(self, points: Array) -> Array:
        """Pixels (n, 2) of object points (n, 3) [m]; NaN behind the camera."""
        pixels = self._project(points, np.full(len(points), self.camera.height_px / 2))
        if self.moves:
            for _ in range(30):
                before = pixels
                pixels = self._project(points, pixels[:, 1])
                if np.nanmax(np.abs(pixels - before), initial=0) < 1e-9:
                    break
        return pixels

    def _station_at(self, y_px: Array) -> tuple[Array, Array]:
        share = (y_px / self.camera.height_px - 0.5)[..., None]
        return self.centre + share * self.velocity, small_rotation(share * self.turn) @ self.rotation

    def _project(self, points: Array, y_px: Array) -> Array:
        centre, R = self._station_at(y_px) if self.moves else (self.centre, self.rotation[None])
        U, V, W = np.moveaxis(np.einsum("nij,nj->ni", R, points - centre), -1, 0)
        W = np.where(W < 0, W, np.nan)
        own, cam = self.interior, self.camera
        x, y = own.distorted(-own.c * U / W, -own.c * V / W)
        return np.stack([x / cam.pixel_mm + cam.width_px / 2, cam.height_px / 2 - y / cam.pixel_mm], axis=-1)
