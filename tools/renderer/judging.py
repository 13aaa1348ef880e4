"""How far stated standard deviations of points are true, by class of place."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.stats import spearmanr

from .classes import NAMES
from .truth import Surface
from .truth_mesh import MeshSurface

Array = NDArray[np.float64]
NORMAL_MEDIAN = 0.6744897501960817
"""Median of the absolute value of a standard normal variable."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Points:
    """Object points of a result with the standard deviations [m] of their coordinates.

    correlation  (n, 3)  of X and Y, X and Z, Y and Z; 0 where the table has none
    flagged      (n,)    whether the table has a remark about a point
    """

    names: NDArray[np.str_]
    coordinates: Array
    sigma: Array
    correlation: Array
    rays: Array
    flagged: NDArray[np.bool_]

    def sigma_along(self, directions: Array) -> Array:
        """Standard deviations (n,) [m] along unit vectors (n, 3)."""
        return np.sqrt(np.maximum(np.einsum("pi,pij,pj->p", directions, self.covariances(), directions), 0))

    def covariances(self) -> Array:
        """(n, 3, 3) [m^2]."""
        R = np.broadcast_to(np.eye(3), (len(self.sigma), 3, 3)).copy()
        R[:, [0, 0, 1], [1, 2, 2]] = R[:, [1, 2, 2], [0, 0, 1]] = self.correlation
        return R * self.sigma[:, :, None] * self.sigma[:, None, :]


def read_points(path: Path, flag_column: str = "flag") -> Points:
    """Tie points of a points.csv; `flag_column` is empty, 0 or absent for points without a remark."""
    with path.open(newline="", encoding="utf-8-sig") as file:
        rows = [row for row in csv.DictReader(file) if row["role"] == "tie" and row["sX"]]

    def numbers(*columns: str) -> Array:
        return np.array([[float(row.get(name) or 0) for name in columns] for row in rows]).reshape(-1, len(columns))

    return Points(
        names=np.array([row["point"] for row in rows]),
        coordinates=numbers("X", "Y", "Z"),
        sigma=numbers("sX", "sY", "sZ"),
        correlation=numbers("rXY", "rXZ", "rYZ"),
        rays=numbers("rays")[:, 0],
        flagged=np.array([(row.get(flag_column) or "0") != "0" for row in rows], dtype=bool),
    )


def robust_chi_square(ratio: Array) -> float:
    """Squared median of |error| / sigma over that of a normal variable: 1 where sigma is true."""
    return float((np.median(np.abs(ratio)) / NORMAL_MEDIAN) ** 2) if len(ratio) else float("nan")


def statistics(error: Array, sigma: Array) -> dict[str, float]:
    """Count, robust chi-square, share beyond five sigma, medians [mm] and rank correlation of |error| and sigma."""
    ratio = error / sigma
    return {
        "n": len(error),
        "chi_square": robust_chi_square(ratio),
        "beyond_5_sigma": float(np.mean(np.abs(ratio) > 5)) if len(error) else float("nan"),
        "sigma_mm": float(1e3 * np.median(sigma)) if len(error) else float("nan"),
        "error_mm": float(1e3 * np.median(np.abs(error)) / NORMAL_MEDIAN) if len(error) else float("nan"),
        "spearman": float(np.asarray(spearmanr(np.abs(error), sigma))[0]) if len(error) > 5 else float("nan"),
    }


def nearest_ways(normals: Array, covariances: Array) -> tuple[Array, Array]:
    """Unit directions (n, 3) of the ways to planes that are shortest in units of points' covariances; sigmas (n,).

    Of all places of a plane with normal n, that along C n lies nearest by the covariance C: sqrt(n' C n) to the plane.
    At an edge the normal of the plane of best fit leans away from the rays. Along it errors grow by 1 / cos of the
    angle between them and standard deviations shrink by cos, also those of points that lie well; along C n they do not.
    """
    ways = np.einsum("pij,pj->pi", covariances, normals)
    length = np.linalg.norm(ways, axis=1)
    sigma = np.sqrt(np.maximum(np.einsum("pi,pi->p", normals, ways), 0))
    return ways / length[:, None], length / sigma


def similarity(source: Array, target: Array) -> tuple[float, Array, Array]:
    """Scale, rotation (3, 3) and shift (3,) of target = scale R source + shift, by least squares (Umeyama 1991)."""
    a, b = source - source.mean(axis=0), target - target.mean(axis=0)
    U, S, V = np.linalg.svd(b.T @ a)
    sign = np.array([1, 1, np.sign(np.linalg.det(U @ V))])
    R = (U * sign) @ V
    scale = float((S * sign).sum() / (a**2).sum())
    return scale, R, target.mean(axis=0) - scale * R @ source.mean(axis=0)


def fitted(points: Array, surface: Surface | MeshSurface, half: float, sigma: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Points moved, turned and scaled onto the surface, by distances along its normals on smooth ground.

    sigma    (n, 3) standard deviations of the points [m]
    returns  the points (n, 3), and which of them the fit rests on
    """
    moved = points.copy()
    used = np.zeros(len(points), dtype=bool)
    for _ in range(8):
        used = surface.in_core(moved) & np.isin(
            surface.classes_at(moved, half), (NAMES.index("smooth"), NAMES.index("slope"))
        )
        part = moved[used]
        normals = surface.normals(part, half)
        error = surface.distances(part, normals)
        scale = np.linalg.norm(normals * sigma[used], axis=1)
        good = np.isfinite(error) & (np.abs(error) < 4 * np.nanmedian(np.abs(error)) + 1e-9)
        design = np.column_stack([normals, np.cross(part, normals), (part * normals).sum(axis=1)])
        weight = 1 / scale[good, None]
        step, *_ = np.linalg.lstsq(design[good] * weight, error[good] * weight[:, 0], rcond=None)
        moved = moved - step[:3] - np.cross(step[3:6], moved) - step[6] * moved
    return moved, used


def surface_errors(
    surface: Surface | MeshSurface, points: Points, coordinates: Array, half: float, error_of: str = "surface"
) -> tuple[NDArray[np.bool_], Array, Array]:
    """Points in the core (n,), their errors from the true surface and standard deviations (m,) [m].

    error_of             "surface": along the shortest way to the surface by the covariance; "normal": along the normal
                         of the plane of best fit in the window; "window": from the mean of the surface over it

    coordinates  (n, 3)  where the points are judged: those of the table, or after a fit
    half                 half side of the matching window on the object [m]
    """
    inside = surface.in_core(coordinates)
    part = coordinates[inside]
    normals, covariances = surface.normals(part, half), points.covariances()[inside]
    error = surface.window_distances(part, normals, half)
    sigma = np.sqrt(np.einsum("pi,pij,pj->p", normals, covariances, normals))
    if error_of != "window":
        ways, length = nearest_ways(normals, covariances) if error_of == "surface" else (normals, sigma)
        exact = surface.distances(part, ways)
        met = np.isfinite(exact)
        error, sigma = np.where(met, exact, error), np.where(met, length, sigma)
    return inside, error, sigma


def by_class(
    surface: Surface | MeshSurface, points: Points, coordinates: Array, half: float, error_of: str = "surface"
) -> Iterator[tuple[str, str, dict[str, float]]]:
    """Statistics of points in the core: (class, whether flagged, statistics); arguments as of surface_errors."""
    inside, error, sigma = surface_errors(surface, points, coordinates, half, error_of)
    flagged, codes = points.flagged[inside], surface.classes_at(coordinates[inside], half)
    for code, name in enumerate(NAMES):
        for label, chosen in (("", ~flagged), ("flagged", flagged)):
            of_class = (codes == code) & chosen
            if of_class.any():
                yield name, label, statistics(error[of_class], sigma[of_class])
    yield "all", "", statistics(error[~flagged], sigma[~flagged])
