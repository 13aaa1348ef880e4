"""The camera of computer vision: central or equidistant projection, then distortion at the ideal point.

OpenCV, COLMAP, Metashape, MicMac, OpenSfM, OPF and nerfstudio describe cameras in this direction, with parameters in
pixels; raybundle's Brown model corrects the measured point instead.  One class covers them all; what a program
does not know stays zero.  `raybundle.cameras.conversions` goes from one direction to the other.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from raybundle.numerics.arrays import Array

Projection = Literal["central", "equidistant"]
TERMS = (
    "fx", "fy", "cx", "cy", "skew", "k1", "k2", "k3", "k4", "p1", "p2", "d1", "d2", "d3",
    "k5", "s1", "s2", "s3", "s4", "tau_x", "tau_y", "ca", "cb", "e1", "e2",
)  # fmt: skip
"""The order of the parameters in `ForwardCamera.vector`."""
STEP = 1e-30


@dataclass(frozen=True, slots=True, kw_only=True)
class ForwardCamera:
    """Parameters in pixels; the origin of cx, cy is the outer corner of the first pixel, x right, y down.

    a, b   ideal point: x / z, y / z (central), or turned to the radius theta (equidistant); minus (ca, cb)
    L      (1 + k1 r^2 + k2 r^4 + k3 r^6 + k4 r^8 + k5 r^10) / (1 + d1 r^2 + d2 r^4 + d3 r^6)
    a'     a L + 2 p1 a b + p2 (r^2 + 2 a^2) + s1 r^2 + s2 r^4 + e1 a + e2 b + ca
    b'     b L + p1 (r^2 + 2 b^2) + 2 p2 a b + s3 r^2 + s4 r^4 + cb
    tilt   (a', b') onto a plane turned by tau_x, tau_y [rad] (OpenCV's Scheimpflug terms)
    pixel  fx a' + skew b' + cx,  fy b' + cy
    """

    width_px: int
    height_px: int
    projection: Projection = "central"
    fx: float
    fy: float
    cx: float
    cy: float
    skew: float = 0.0
    k1: float = 0.0
    k2: float = 0.0
    k3: float = 0.0
    k4: float = 0.0
    p1: float = 0.0
    p2: float = 0.0
    d1: float = 0.0
    d2: float = 0.0
    d3: float = 0.0
    k5: float = 0.0
    s1: float = 0.0
    s2: float = 0.0
    s3: float = 0.0
    s4: float = 0.0
    tau_x: float = 0.0
    tau_y: float = 0.0
    ca: float = 0.0
    cb: float = 0.0
    e1: float = 0.0
    e2: float = 0.0

    @property
    def vector(self) -> Array:
        """(25,) parameters in the order of TERMS."""
        return np.array([getattr(self, name) for name in TERMS], float)

    @property
    def is_pinhole(self) -> bool:
        """Whether there is neither distortion nor skew."""
        return self.projection == "central" and not self.vector[4:].any()


def ideal_points(rays: Array, projection: Projection) -> Array:
    """Ideal points (2, n), x right, y down, of directions (3, n) in the sensor frame (y up, view along -Z).

    Directions at or behind the image plane have no ideal point in central projection; they become NaN.
    """
    x, y, z = rays[0], -rays[1], -rays[2]
    if projection == "central":
        depth = np.where(z > 0, z, np.nan)
        return np.stack([x / depth, y / depth])
    radius = np.hypot(x, y)
    small = radius < 1e-12 * np.abs(z)
    scale = np.where(small, 1 / np.where(z == 0, 1, z), np.arctan2(radius, z) / np.where(small, 1, radius))
    return np.stack([x * scale, y * scale])


def distorted(points: Array, vector: Array) -> Array:
    """Pixels (2, n) of ideal points (2, n) with the parameters (25,); points and parameters may be complex."""
    fx, fy, cx, cy, skew, k1, k2, k3, k4, p1, p2, d1, d2, d3, k5, s1, s2, s3, s4, *rest = vector
    tau_x, tau_y, ca, cb, e1, e2 = rest
    a, b = points[0] - ca, points[1] - cb
    r2 = a * a + b * b
    top = 1 + r2 * (k1 + r2 * (k2 + r2 * (k3 + r2 * (k4 + r2 * k5))))
    radial = top / (1 + r2 * (d1 + r2 * (d2 + r2 * d3)))
    u = a * radial + 2 * p1 * a * b + p2 * (r2 + 2 * a * a) + r2 * (s1 + r2 * s2) + e1 * a + e2 * b + ca
    v = b * radial + p1 * (r2 + 2 * b * b) + 2 * p2 * a * b + r2 * (s3 + r2 * s4) + cb
    if tau_x or tau_y:
        u, v = _tilted(u, v, tau_x, tau_y)
    return np.stack([fx * u + skew * v + cx, fy * v + cy])


def _tilted(u: Array, v: Array, tau_x: complex, tau_y: complex) -> tuple[Array, Array]:
    """Points on a plane turned about x, then y; distances along the axis are kept (Louhichi et al. 2007)."""
    cos_x, sin_x, cos_y, sin_y = np.cos(tau_x), np.sin(tau_x), np.cos(tau_y), np.sin(tau_y)
    x = cos_y * u + sin_y * sin_x * v - sin_y * cos_x
    y = cos_x * v + sin_x
    z = sin_y * u - cos_y * sin_x * v + cos_y * cos_x
    depth = cos_y * cos_x
    return (depth * x + sin_y * cos_x * z) / z, (depth * y - sin_x * z) / z


def first_limit(vector: Array) -> tuple[float, Literal["fold", "pole", ""]]:
    """Smallest ideal radius at which the radial part L r stops growing (fold) or is infinite (pole); inf: none.

    vector  (25,) real parameters
    Limits: where decentring and thin-prism terms alone fold the image over.
    """
    values: dict[str, float] = dict(zip(TERMS, np.real(vector).tolist(), strict=True))
    top = np.polynomial.Polynomial([1.0, *(values[f"k{n}"] for n in range(1, 6))])
    base = np.polynomial.Polynomial([1.0, *(values[f"d{n}"] for n in range(1, 4))])
    twice = np.polynomial.Polynomial([0.0, 2.0])
    fold = _smallest_root(top * base + twice * (top.deriv() * base - top * base.deriv()))
    pole = _smallest_root(base)
    if not np.isfinite(min(fold, pole)):
        return np.inf, ""
    return float(np.sqrt(min(fold, pole))), "fold" if fold < pole else "pole"


def _smallest_root(polynomial: np.polynomial.Polynomial) -> float:
    coefficients = np.trim_zeros(polynomial.coef, "b")
    roots = np.polynomial.Polynomial(coefficients).roots() if len(coefficients) > 1 else np.zeros(0)
    real = roots.real[(np.abs(roots.imag) <= 1e-9 * np.abs(roots)) & (roots.real > 0)]
    return float(real.min(initial=np.inf))


def forward_pixels(camera: ForwardCamera, rays: Array) -> Array:
    """Pixels (2, n) of directions (3, n) in the sensor frame; NaN where the projection has none."""
    return distorted(ideal_points(rays, camera.projection), camera.vector)


def forward_rays(camera: ForwardCamera, pixels: Array) -> Array:
    """Unit directions (3, n) in the sensor frame of pixels (2, n); NaN where the distortion has no inverse.

    Newton with derivatives by the complex step.  A polynomial that folds over within the format has no
    inverse beyond the fold.
    """
    vector = camera.vector
    b = (pixels[1] - camera.cy) / camera.fy
    start = np.stack([(pixels[0] - camera.cx - camera.skew * b) / camera.fx, b])
    points = start.copy()
    good = np.zeros(points.shape[1], bool)
    with np.errstate(all="ignore"):
        for _ in range(60):
            by_a = distorted(points + np.array([[STEP * 1j], [0]]), vector)
            by_b = distorted(points + np.array([[0], [STEP * 1j]]), vector)
            g = np.real(by_a) - pixels
            (j00, j10), (j01, j11) = np.imag(by_a) / STEP, np.imag(by_b) / STEP
            det = j00 * j11 - j01 * j10
            step = np.stack([j11 * g[0] - j01 * g[1], j00 * g[1] - j10 * g[0]]) / det
            length = np.hypot(step[0], step[1])
            points = points - step * np.minimum(1, 0.5 / np.maximum(length, 1e-300))
            good = (det > 0) & (length < 1e-12 * (1 + np.hypot(points[0], points[1])))
            if good.all():
                break
    limit, _ = first_limit(vector)
    good &= np.hypot(points[0] - camera.ca, points[1] - camera.cb) <= limit
    points = np.where(good, points, np.nan)
    return _rays_of(points, camera.projection)


def _rays_of(points: Array, projection: Projection) -> Array:
    radius = np.hypot(points[0], points[1])
    if projection == "central":
        rays = np.stack([points[0], -points[1], -np.ones_like(radius)])
        return rays / np.linalg.norm(rays, axis=0)
    radius = np.where(radius > np.pi, np.nan, radius)
    ratio = np.sinc(radius / np.pi)
    return np.stack([points[0] * ratio, -points[1] * ratio, -np.cos(radius)])
