"""Optical distortion of line-scan ISDs: from measured to undistorted coordinates of the focal plane [mm].

ALE writes one kind for each family of cameras.  Four are closed forms of the measured point, the others define
the measured point as a function of the undistorted one, which is found by Newton's method:

    radial        u = d (1 - k0 - k1 r^2 - k2 r^4)
    cahvor        the same about a centre, coefficients 4 and 5
    kaguyalism    u = d + b + a0 + a1 r + a2 r^2 + a3 r^3, b the boresight; by axis (Kaguya TC and MI)
    lrolrocnac    u_y = d_y / (1 + k d_y^2), along the detector alone (LRO NAC)
    kplo_shadowcam  u_y = d_y (1 + k d_y^2)
    themisir      u_x = d_x / k;  d_y = u_y (1 + a1 + a2 u_y)
    transverse    d = cubic polynomials of u;   dawnfc  d = u (1 + k r^2);   radtan  as in OpenCV, of u / f
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from raybundle.io.reading.trees import Json
from raybundle.io.reading.words import quoted
from raybundle.numerics.arrays import Array

STEPS = 30
"""Of Newton's method, which squares the error with each."""
ROUNDING_MM = 1e-12
ROUNDED_MM = 1e-9
"""Misfit of an inverse that was found; a millionth of a pixel."""


def undistorted(optics: Json, plane: Array, f: float) -> Array:
    """Undistorted coordinates (2, n) [mm] of measured ones.

    optics  the section `optical_distortion`: one key, the kind
    raises  InputError where the kind is not known or folds the focal plane over itself
    """
    kinds = optics.mapping()
    for name, kind in kinds.items():
        if name in KINDS:
            return KINDS[name](kind, plane, f)
        if not _all_zero(kind):
            incomplete = name in INCOMPLETE
            kind.fail("isd.distortion_unknown", name=quoted(name), incomplete=incomplete, known=sorted(KINDS))
    return plane


INCOMPLETE = ("legendre",)
"""Kinds with coefficients that the description does not contain"""


def _all_zero(kind: Json) -> bool:
    parts = [
        kind.get(part) for part in ("coefficients", "x", "y", "x_coefficients", "y_coefficients") if kind.has(part)
    ]
    return bool(parts) and not any(v.number() for part in parts for v in part.items())


def _coefficients(kind: Json, count: int, key: str = "coefficients") -> Array:
    """(count,) coefficients; those left out at the end are zero."""
    given = np.array([v.number() for v in kind.get(key).items()])
    if len(given) > count:
        kind.get(key).fail("isd.coefficient_count", n=len(given), most=count)
    return np.append(given, np.zeros(count - len(given)))


def _radial_about(kind: Json, k: Array, plane: Array, centre: Array) -> Array:
    d = plane - centre[:, None]
    r = np.hypot(*d)
    _check_unfolded(kind, k, float(r.max(initial=0.0)))
    return d * (1 - (k[0] + r**2 * (k[1] + r**2 * k[2]))) + centre[:, None]


def _check_unfolded(kind: Json, k: Array, r_max: float) -> None:
    """Raise where the undistorted radius does not grow with the measured one: no lens images so.

    d/dr of r (1 - k0 - k1 r^2 - k2 r^4) must stay positive from the axis to the farthest element.
    """
    r = np.linspace(0.0, r_max, 1001)
    slope = 1 - k[0] - 3 * k[1] * r**2 - 5 * k[2] * r**4
    if (slope <= 0).any():
        at, factor = r[np.argmax(slope <= 0)], 1 - (k[0] + r_max**2 * (k[1] + r_max**2 * k[2]))
        kind.fail("isd.distortion_folds", coefficients=k[:3].tolist(), radius_mm=at, detector_mm=r_max, factor=factor)


def _radial(kind: Json, plane: Array, _: float) -> Array:
    return _radial_about(kind, _coefficients(kind, 3), plane, np.zeros(2))


def _cahvor(kind: Json, plane: Array, _: float) -> Array:
    k = _coefficients(kind, 5)
    return _radial_about(kind, k, plane, k[3:])


def _kaguya(kind: Json, plane: Array, _: float) -> Array:
    r = np.hypot(*plane)
    powers = r ** np.arange(4)[:, None]
    moved = [_coefficients(kind, 4, axis) @ powers + kind.get(f"boresight_{axis}").number() for axis in ("x", "y")]
    return plane + np.array(moved)


def _lro(kind: Json, plane: Array, _: float) -> Array:
    k = _coefficients(kind, 1)[0]
    x, y = plane
    below = 1 + k * y * y
    if (1 - k * y * y <= 0).any() or (below <= 0).any():
        kind.fail("isd.distortion_folds_detector", coefficient=k, detector_mm=np.abs(y).max())
    return np.stack([x, y / below])


def _shadowcam(kind: Json, plane: Array, _: float) -> Array:
    k = _coefficients(kind, 1)[0]
    x, y = plane
    if (1 + 3 * k * y * y <= 0).any():
        kind.fail("isd.distortion_folds_detector", coefficient=k, detector_mm=np.abs(y).max())
    return np.stack([x, y * (1 + k * y * y)])


def _themis(kind: Json, plane: Array, _: float) -> Array:
    a1, a2, k = (kind.get(f"p_{s}").number() for s in ("alpha1", "alpha2", "k"))
    x, y = plane
    inside = (1 + a1) ** 2 + 4 * a2 * y
    if k == 0 or (inside <= 0).any():
        kind.fail("isd.distortion_no_inverse", n=3, coefficients=[a1, a2, k])
    return np.stack([x / k, 2 * y / (1 + a1 + np.sqrt(inside))])


def _inverse(kind: Json, plane: Array, distort: Callable[[Array], Array]) -> Array:
    """The u with distort(u) = plane, by Newton's method from u = plane."""
    u, h = plane.copy(), 1e-6
    for _ in range(STEPS):
        miss = distort(u) - plane
        steps = np.eye(2)[:, :, None] * h
        J = np.stack([(distort(u + s) - distort(u - s)) / (2 * h) for s in steps], axis=1)
        det = J[0, 0] * J[1, 1] - J[0, 1] * J[1, 0]
        if not np.isfinite(det).all() or (np.abs(det) < ROUNDING_MM).any():
            break
        du = np.stack([J[1, 1] * miss[0] - J[0, 1] * miss[1], J[0, 0] * miss[1] - J[1, 0] * miss[0]]) / det
        u = u - du
        if np.abs(du).max(initial=0.0) < ROUNDING_MM * (1 + np.abs(u).max(initial=0.0)):
            break
    if not np.abs(distort(u) - plane).max(initial=0.0) < ROUNDED_MM:
        kind.fail("isd.distortion_no_inverse", n=0, coefficients=[])
    return u


def _transverse(kind: Json, plane: Array, _: float) -> Array:
    a = np.stack([_coefficients(kind, 10, axis) for axis in ("x", "y")])

    def distort(u: Array) -> Array:
        x, y = u
        return a @ np.stack([np.ones_like(x), x, y, x * x, x * y, y * y, x**3, x * x * y, x * y * y, y**3])

    return _inverse(kind, plane, distort)


def _dawn(kind: Json, plane: Array, _: float) -> Array:
    k = _coefficients(kind, 1)[0]
    return _inverse(kind, plane, lambda u: u * (1 + k * np.sum(u * u, axis=0)))


def _radtan(kind: Json, plane: Array, f: float) -> Array:
    k1, k2, p1, p2, k3 = _coefficients(kind, 5)

    def distort(u: Array) -> Array:
        x, y = u
        r2 = x * x + y * y
        radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        return np.stack(
            [x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x), y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y]
        )

    return f * _inverse(kind, plane / f, distort)


KINDS: dict[str, Callable[[Json, Array, float], Array]] = {
    "radial": _radial,
    "cahvor": _cahvor,
    "kaguyalism": _kaguya,
    "lrolrocnac": _lro,
    "kplo_shadowcam": _shadowcam,
    "themisir": _themis,
    "transverse": _transverse,
    "dawnfc": _dawn,
    "radtan": _radtan,
}
