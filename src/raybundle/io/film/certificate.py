"""The calibration certificate of a metric camera, as a camera."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.block import Camera
from raybundle.errors import InputError, phrase


@dataclass(frozen=True, slots=True, kw_only=True)
class Certificate:
    """What the certificate of a metric camera states."""

    id: str
    c_mm: float
    """Calibrated camera constant."""
    format_mm: tuple[float, float]
    symmetry_mm: tuple[float, float] = (0.0, 0.0)
    """Principal point of best symmetry, about which the distortion is given, from the fiducial centre."""
    autocollimation_mm: tuple[float, float] | None = None
    """Principal point of autocollimation; None: not stated."""
    radius_mm: tuple[float, ...] = ()
    distortion_um: tuple[float, ...] = ()
    """Mean radial distortion at these radii, positive outwards: measured minus ideal radius."""


def certificate_camera(certificate: Certificate, *, pixel_mm: float) -> tuple[Camera, tuple[str, ...]]:
    """The camera of a certificate with held interior orientation, its pixels those of the scans, and remarks.

    The principal point of best symmetry becomes x0, y0: the distortion belongs to it.  Where that of autocollimation
    differs, the difference acts as a small turn of the camera, which the exterior orientation takes up but for
    r^2 |difference| / c^2; the remark shows how much.
    raises  InputError for a table of distortion that does not fit
    """
    width, height = (round(side / pixel_mm) for side in certificate.format_mm)
    if not (certificate.c_mm > 0 and width > 0 and height > 0):
        raise InputError("certificate.not_positive", camera=certificate.id)
    r, d = np.array(certificate.radius_mm), np.array(certificate.distortion_um) / 1000
    if len(r) != len(d) or not np.isfinite([*r, *d]).all() or (r < 0).any():
        raise InputError("certificate.distortion_table", camera=certificate.id, radii=len(r), distortions=len(d))
    remarks: list[str] = []
    K = np.zeros(3)
    if len(r):
        terms = min(3, int((r > 0).sum()))
        A = np.stack([r ** (2 * k + 3) for k in range(terms)], axis=1)
        scale = np.maximum(np.abs(A).max(axis=0), 1e-300)
        K[:terms] = np.linalg.lstsq(A / scale, -d, rcond=None)[0] / scale
        worst = float(np.abs(A @ K[:terms] + d).max()) * 1000
        remarks.append(phrase("film.distortion_terms", n=terms, largest_um=worst))
    x0, y0 = certificate.symmetry_mm
    if certificate.autocollimation_mm is not None:
        gap = float(np.hypot(x0 - certificate.autocollimation_mm[0], y0 - certificate.autocollimation_mm[1]))
        corner = float(np.hypot(*certificate.format_mm)) / 2
        rest_um = 1000 * gap * (corner / certificate.c_mm) ** 2
        remarks.append(phrase("film.principal_points_differ", difference_um=1000 * gap, corner_um=rest_um))
    values = {"c": certificate.c_mm, "x0": x0, "y0": y0, "K1": K[0], "K2": K[1], "K3": K[2]}
    rest = dict.fromkeys(("P1", "P2", "A", "S"), 0.0)
    return (
        Camera(
            id=certificate.id,
            model="brown",
            width_px=width,
            height_px=height,
            pixel_mm=(pixel_mm, pixel_mm),
            values={**{k: float(v) for k, v in values.items()}, **rest},
            estimate=(),
        ),
        tuple(remarks),
    )
