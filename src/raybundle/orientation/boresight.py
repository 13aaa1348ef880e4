"""GNSS and INS against the adjusted orientation: misalignment and lever arm, and what is left.

The INS shows the rotation of its body, R_body (object axes to body axes), GNSS the position of its antenna, G.  With
the adjusted R and X0 of the photographs:

    R = M R_body                   M the mounting of the camera (boresight), one for all photographs
    G = X0 + R' a + s              a the lever arm in the axes of the image, s a shift of the flight

Both are least-squares fits after the adjustment; the orientation is taken as free of error against GNSS and INS, so
where its own standard deviations come near theirs, the stated ones are too small: adjust them together
(`platforms.antenna`, `platforms.imu`).
Skaloud and Lichti 2006; Hutton and Mostafa 2005.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.rotation import nearest_rotation, rotation_from_vector, vector_from_rotation

LEVER = ("ax", "ay", "az", "sx", "sy", "sz")
DETERMINED = 1e-3
"""Smallest share of a parameter's information that is its own, below which it is called not determinable."""
SECONDS = float(np.degrees(1) * 3600)


@dataclass(frozen=True, slots=True, kw_only=True)
class Boresight:
    """The rotation from the body of an INS to the image axes of the camera."""

    image_from_body: Array
    """(3, 3)"""
    misalignment: Array
    """(3,) small rotation about the image axes from the nominal mounting to this one [rad]."""
    covariance: Array
    """(3, 3) of the misalignment [rad^2], by the scatter of the attitudes."""
    residuals: Array
    """(n, 3) small rotations that are left, about the image axes [rad]."""
    sigma: float
    """Standard deviation of one attitude about one axis [rad]; NaN for a single photograph."""

    @property
    def std(self) -> Array:
        """(3,) standard deviations of the misalignment [rad]."""
        return np.sqrt(np.diag(self.covariance))


def boresight(rotation: Array, body: Array, nominal: Array | None = None) -> Boresight:
    """The mounting of the camera from adjusted rotations (n, 3, 3) and those of the body (n, 3, 3).

    nominal  (3, 3) the mounting by design, from which the misalignment counts; None: the one found
    raises   InputError without a photograph that has both
    A misalignment about the view and a wrong yaw of the INS are one and the same; a constant error of its roll and
    pitch likewise hides in it.
    """
    mount = np.asarray(rotation, float) @ np.swapaxes(np.asarray(body, float), -1, -2)
    mount = mount[np.isfinite(mount).all(axis=(1, 2))]
    if len(mount) == 0:
        raise InputError("mounting.no_attitudes")
    mean = nearest_rotation(mount.mean(axis=0))
    for _ in range(5):
        small = vector_from_rotation(mount @ mean.T)
        mean = rotation_from_vector(small.mean(axis=0)) @ mean
    left = vector_from_rotation(mount @ mean.T)
    n = len(mount)
    sigma = float(np.sqrt(np.sum(left**2) / (3 * (n - 1)))) if n > 1 else float("nan")
    base = mean if nominal is None else np.asarray(nominal, float)
    return Boresight(
        image_from_body=mean,
        misalignment=vector_from_rotation(mean @ base.T),
        covariance=np.eye(3) * sigma**2 / n,
        residuals=left,
        sigma=sigma,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class LeverArm:
    """Lever arm and shift between adjusted projection centres and GNSS positions."""

    symbols: tuple[str, ...]
    """ax, ay, az (image axes) and, where asked for, sx, sy, sz (object axes)."""
    values: Array
    """(k,) [m]; NaN for what is not determinable."""
    std: Array
    """(k,) with the a-posteriori sigma0."""
    not_determinable: tuple[str, ...]
    residuals: Array
    """(n, 3) adjusted - given, object axes [m]."""
    sigma0: float


def lever_arm(centre: Array, rotation: Array, gnss: Array, sigma: Array, *, shift: bool = False) -> LeverArm:
    """Lever arm, and a shift if asked for, by least squares.

    centre, rotation  adjusted (n, 3), (n, 3, 3); gnss, sigma: positions and their standard deviations (n, 3)
    raises            InputError where fewer than two photographs have a position
    With all headings alike a lever arm and a shift are one: those of the six that cannot be distinguished are named.
    After an adjustment in which GNSS alone gave the datum, the lever arm has gone into the projection centres already,
    and what is found here is what they could not take up.
    """
    centre, gnss, sigma = (np.asarray(v, float) for v in (centre, gnss, sigma))
    good = np.flatnonzero(np.isfinite(np.column_stack([centre, gnss])).all(axis=1) & (sigma > 0).all(axis=1))
    n = len(good)
    if n < 2:
        raise InputError("mounting.lever_arm", n=n)
    A = np.swapaxes(np.asarray(rotation, float)[good], -1, -2)
    if shift:
        A = np.concatenate([A, np.tile(np.eye(3), (n, 1, 1))], axis=2)
    symbols = LEVER[: A.shape[2]]
    weight = 1 / sigma[good].ravel()
    Aw = A.reshape(3 * n, -1) * weight[:, None]
    lw = (gnss - centre)[good].ravel() * weight
    lost = _lost(Aw)
    kept = np.flatnonzero(~lost)
    values, std = np.full(len(symbols), np.nan), np.full(len(symbols), np.nan)
    N = Aw[:, kept].T @ Aw[:, kept]
    x = np.linalg.solve(N, Aw[:, kept].T @ lw) if len(kept) else np.zeros(0)
    v = Aw[:, kept] @ x - lw
    redundancy = 3 * n - len(kept)
    sigma0 = float(np.sqrt(v @ v / redundancy)) if redundancy else float("nan")
    values[kept] = x
    std[kept] = sigma0 * np.sqrt(np.diag(np.linalg.inv(N)))
    residuals = np.full(centre.shape, np.nan)
    residuals[good] = (v / weight).reshape(-1, 3)
    return LeverArm(
        symbols=symbols,
        values=values,
        std=std,
        not_determinable=tuple(s for s, k in zip(symbols, lost, strict=True) if k),
        residuals=residuals,
        sigma0=sigma0,
    )


def _lost(A: Array) -> Mask:
    """(k,) columns that depend on others: those with a share in a direction of (nearly) no information."""
    scaled = A / np.maximum(np.linalg.norm(A, axis=0), 1e-300)
    _, s, vt = np.linalg.svd(scaled, full_matrices=False)
    weak = vt[s < DETERMINED * s[0]]
    return np.asarray((np.abs(weak) > 0.1).any(axis=0), bool) if len(weak) else np.zeros(A.shape[1], bool)


def comparison(
    centre: Array, rotation: Array, gnss: Array, attitude: Array | None = None, nominal: Array | None = None
) -> str:
    """Direct georeferencing against the adjusted orientation, as a table: mean, scatter and largest difference.

    centre, rotation  adjusted (n, 3), (n, 3, 3); gnss: given positions (n, 3)
    attitude          given rotations (n, 3, 3) of the camera or of the body; None: none
    nominal           (3, 3) rotation from the body to the image axes; None: `attitude` is the camera's
    """
    lines = ["given minus adjusted         mean       sd      largest"]
    d = np.asarray(gnss, float) - np.asarray(centre, float)
    d = d[np.isfinite(d).all(axis=1)]
    if len(d) == 0:
        raise InputError("mounting.no_positions")
    for axis, values in zip("XYZ", d.T, strict=True):
        lines.append(_row(f"{axis} [m]", values, 4))
    if attitude is not None:
        own = np.asarray(attitude, float) if nominal is None else nominal @ np.asarray(attitude, float)
        turn = own @ np.swapaxes(np.asarray(rotation, float), -1, -2)
        turn = turn[np.isfinite(turn).all(axis=(1, 2))]
        for axis, values in zip("xyz", np.degrees(vector_from_rotation(turn)).T, strict=True):
            lines.append(_row(f"turn about image {axis} [deg]", values, 4))
    lines.append(f"{len(d)} photographs; a mean far beyond sd / sqrt(n) is a lever arm, a datum or a misalignment")
    return "\n".join(lines)


def _row(name: str, values: Array, digits: int) -> str:
    sd = float(values.std(ddof=1)) if len(values) > 1 else float("nan")
    worst = float(values[np.argmax(np.abs(values))])
    return f"{name:<24} {values.mean():>9.{digits}f} {sd:>9.{digits}f} {worst:>10.{digits}f}"
