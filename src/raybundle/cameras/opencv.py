"""What OpenCV calls a calibration, with what OpenCV does not give: the covariance of all of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from raybundle.block import Camera
from raybundle.cameras.conversions import (
    CLOSE_PX,
    EXACT,
    FISHEYE,
    LIMIT_PX,
    ForwardFit,
    exact_forward,
    forward_fit,
    grid_px,
    rays_of,
    terms_for,
)
from raybundle.cameras.fixed_rays import derivatives, in_pixels
from raybundle.cameras.forward_camera import STEP, TERMS, ForwardCamera, distorted, ideal_points
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

HALF = 0.5
"""Our coordinate of the centre of the first pixel, which is OpenCV's origin."""
ORDER = ("k1", "k2", "p1", "p2", "k3", "d1", "d2", "d3", "s1", "s2", "s3", "s4", "tau_x", "tau_y")
"""Terms of a forward camera in the order of OpenCV's coefficients"""
NAMES = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4", "taux", "tauy")
"""What OpenCV calls them"""
COUNTS = (4, 5, 8, 12, 14)
SMALL = 1e-12
"""Singular values, of the largest, below which a direction of the coefficients changes nothing in the image."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OpenCVCamera:
    """Camera matrix and distortion as `cv2` takes them, and their covariance.

    `cv2.projectPoints(X, rvec, tvec, camera.K, camera.distortion)`, `cv2.undistort(image, camera.K,
    camera.distortion)`; of a fisheye the same in `cv2.fisheye`.
    """

    K: Array
    """(3, 3) camera matrix; pixels count from the centre of the first one"""
    distortion: Array
    """(n,) coefficients, n of 4, 5, 8, 12, 14; of a fisheye 4"""
    fisheye: bool
    """whether they belong to `cv2.fisheye`"""
    width_px: int
    height_px: int
    names: tuple[str, ...]
    """(u,) fx, fy, cx, cy and the coefficients, in the order of `covariance`"""
    covariance: Array
    """(u, u); rows of what was held are zero; NaN where the calibration states no covariance"""
    deviation_px: float = 0.0
    """largest distance between the images of one ray by this and by our model; 0 where both have the same terms"""
    held: tuple[str, ...] = field(default=())
    """names of which nothing was estimated"""

    @property
    def values(self) -> Mapping[str, float]:
        """By name."""
        every = (self.K[0, 0], self.K[1, 1], self.K[0, 2], self.K[1, 2], *self.distortion)
        return dict(zip(self.names, map(float, every), strict=True))

    @property
    def std(self) -> Mapping[str, float]:
        """Standard deviations by name."""
        return dict(zip(self.names, np.sqrt(np.maximum(np.diag(self.covariance), 0)).tolist(), strict=True))

    def __repr__(self) -> str:
        """Name, value and standard deviation."""
        std = self.std
        each = ", ".join(f"{n} {v:.6g} ± {std[n]:.2g}" for n, v in self.values.items())
        return f"<OpenCVCamera{' fisheye' if self.fisheye else ''} {self.width_px} x {self.height_px} px: {each}>"


def opencv_camera(
    camera: Camera, free: Sequence[str] = (), covariance: Array | None = None, *, coefficients: int | None = None
) -> OpenCVCamera:
    """A camera as OpenCV has it.

    free, covariance  symbols of its parameters and their covariance (u, u); None: nothing is known of it
    coefficients      how many; None: the fewest of 4, 5, 8 and 12 that are exact, or within 0.01 px
    raises            InputError where OpenCV has no camera within 0.1 px of it, or no such number of coefficients

    Exact for the models `rational`, `thin_prism`, `kannala_brandt` and `radial`; others, which correct the measured
    point, are fitted over the format.  The covariance is propagated through the images of fixed rays: d q = F^+ G d p,
    with G the change of image points by our parameters p, F by OpenCV's q, over a grid on the format.

    Limits: errors of the model that all photographs share.
    """
    fit, terms = _fitted(camera, coefficients)
    forward = fit.camera
    if fit.deviation_px > LIMIT_PX:
        raise InputError(
            "camera.opencv_deviation",
            camera=camera.id,
            n=len(terms) - 4,
            deviation_px=fit.deviation_px,
            limit_px=LIMIT_PX,
        )
    order = FISHEYE[4:] if forward.projection == "equidistant" else ORDER[: len(terms) - 4]
    names = FISHEYE if forward.projection == "equidistant" else ("fx", "fy", "cx", "cy", *NAMES[: len(order)])
    K = np.array([[forward.fx, forward.skew, forward.cx - HALF], [0, forward.fy, forward.cy - HALF], [0, 0, 1]])
    C, held = _covariance(camera, forward, terms, names, free, covariance)
    return OpenCVCamera(
        K=K, distortion=np.array([float(getattr(forward, n)) for n in order]),
        fisheye=forward.projection == "equidistant", width_px=camera.width_px, height_px=camera.height_px, names=names,
        covariance=C, held=held, deviation_px=fit.deviation_px,
    )  # fmt: skip


def _fitted(camera: Camera, coefficients: int | None) -> tuple[ForwardFit, tuple[str, ...]]:
    """The forward camera, and the terms fx, fy, cx, cy and coefficients that it has."""
    exact, wide = exact_forward(camera), camera.sensor.all_round
    if coefficients is not None and coefficients not in ((4,) if wide else COUNTS):
        known = [4] if wide else [*COUNTS]
        raise InputError("camera.opencv_coefficients", fisheye=wide, n=coefficients, known=known)
    if wide:
        terms = FISHEYE
        return (_as_it_is(exact) if exact is not None else forward_fit(camera, terms, projection="equidistant")), terms
    choice = (coefficients,) if coefficients else COUNTS[:-1]
    if exact is not None:
        least = max((k + 1 for k, t in enumerate(ORDER) if getattr(exact, t)), default=0)
        fitting = [n for n in choice if n >= least]
        if fitting:
            return _as_it_is(exact), ("fx", "fy", "cx", "cy", *ORDER[: fitting[0]])
    best: tuple[ForwardFit, tuple[str, ...]] | None = None
    for n in choice:
        terms = ("fx", "fy", "cx", "cy", *ORDER[:n])
        fit = forward_fit(camera, terms_for(camera, terms))
        if best is None or fit.deviation_px < best[0].deviation_px:
            best = fit, terms
        if fit.deviation_px <= CLOSE_PX:
            break
    assert best is not None
    return best


def _as_it_is(camera: ForwardCamera) -> ForwardFit:
    return ForwardFit(camera=camera, deviation_px=0.0)


def _covariance(
    camera: Camera, forward: ForwardCamera, terms: Sequence[str], names: Sequence[str], free: Sequence[str],
    covariance: Array | None,
) -> tuple[Array, tuple[str, ...]]:  # fmt: skip
    """The covariance of the terms, and names of which it is zero."""
    if covariance is None:
        return np.full((len(names), len(names)), np.nan), ()
    if not free:
        return np.zeros((len(names), len(names))), tuple(names)
    if camera.model in EXACT and all(t in terms for t, _ in EXACT[camera.model].terms.values() if getattr(forward, t)):
        back = _by_term(camera, terms, free)
        C = back @ np.asarray(covariance, float) @ back.T
        return (C + C.T) / 2, tuple(n for n, row in zip(names, back, strict=True) if not row.any())
    pixels = grid_px(camera.width_px, camera.height_px)
    rays = rays_of(camera, pixels)
    ideal = ideal_points(rays, forward.projection)
    seen = np.isfinite(rays).all(axis=0) & np.isfinite(ideal).all(axis=0)
    B, _, by = derivatives(camera, camera.image_from_pixel(pixels[:, seen].T).T, rays[:, seen])
    G = in_pixels(camera, B, by[:, :, [camera.sensor.symbols.index(s) for s in free]]).reshape(-1, len(free))
    columns: list[Array] = []
    for term in terms:
        vector = forward.vector.astype(complex)
        vector[TERMS.index(term)] += STEP * 1j
        columns.append(np.imag(distorted(ideal[:, seen], vector)).T.ravel() / STEP)
    F = np.stack(columns, axis=1)
    scale = np.linalg.norm(F, axis=0)
    back = np.linalg.lstsq(F / scale, G, rcond=SMALL)[0] / scale[:, None]
    C = back @ np.asarray(covariance, float) @ back.T
    std = np.sqrt(np.maximum(np.diag(C), 0))
    held = std * scale <= SMALL * float((std * scale).max(initial=0.0))
    C[held] = C[:, held] = 0.0
    return (C + C.T) / 2, tuple(n for n, h in zip(names, held.tolist(), strict=True) if h)


def _by_term(camera: Camera, terms: Sequence[str], free: Sequence[str]) -> Array:
    """(q, u) change of the terms by the parameters of a model that has the same terms."""
    width, height = camera.pixel_mm
    c, A = float(camera.values["c"]), float(camera.values.get("A", 0.0))
    of = {s: ((t, float(sign)),) for s, (t, sign) in EXACT[camera.model].terms.items()}
    of |= {
        "c": (("fx", 1 / width), ("fy", (1 + A) / height)), "A": (("fy", c / height),), "x0": (("cx", 1 / width),),
        "y0": (("cy", -1 / height),),
    }  # fmt: skip
    J = np.zeros((len(terms), len(free)))
    for k, symbol in enumerate(free):
        for term, slope in of[symbol]:
            if term in terms:  # what is left out is zero and was held
                J[list(terms).index(term), k] = slope
    return J
