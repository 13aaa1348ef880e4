"""Axes by points: an origin, a direction, and a plane or what shows the vertical."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import cross_matrix

IN_LINE = 1e-3
"""Sine of the angle below which points lie in one line."""
BY_POINTS = ((0, 1, 2), (1, 2), (2,))
"""Coordinates that are 0 by definition: of the origin, the axis point and the plane point."""
BY_VERTICAL = ((0, 1, 2), (1,))
"""The same of origin and axis point where something else shows the vertical."""

Turn = Callable[[Array], Array]
"""Rotation (3, 3) into the axes of points (k, 3)."""


def by_points(xyz: Array) -> Array:
    """Rotation into the axes of origin, axis point and plane point (3, 3): X towards the second, the third at Y > 0."""
    a, b = xyz[1] - xyz[0], xyz[2] - xyz[0]
    x = a / np.linalg.norm(a)
    across = b - (b @ x) * x
    y = across / np.linalg.norm(across)
    return np.stack([x, y, np.cross(x, y)])


def by_vertical(xyz: Array, up: Array) -> Array:
    """Rotation into the axes of origin and axis point (2 or more, 3): Z along `up`, X towards the second in plan."""
    a = xyz[1] - xyz[0]
    x = a - (a @ up) * up
    x = x / np.linalg.norm(x)
    return np.stack([x, np.cross(up, x), up])


def by_level(xyz: Array, up: Array) -> Array:
    """The same with Z across the plane that fits the points behind the first two best, on the side of `up`."""
    r = xyz[2:] - xyz[2:].mean(axis=0)
    normal: Array = np.linalg.svd(r)[2][2]
    return by_vertical(xyz, normal if normal @ up > 0 else -normal)


def vertical(levels: Sequence[Array], plumb_lines: Sequence[Array], up: Array) -> Array:
    """Unit vector that points (k, 3) at levels and on plumb lines show, of what is left open nearest to `up`."""
    M = np.zeros((3, 3))
    for xyz in levels:
        r = xyz - xyz.mean(axis=0)
        M += r.T @ r
    for xyz in plumb_lines:
        r = xyz - xyz.mean(axis=0)
        M += (r**2).sum() * np.eye(3) - r.T @ r
    M += 1e-6 * np.trace(M) * (np.eye(3) - np.outer(up, up))
    found: Array = np.linalg.eigh(M)[1][:, 0]
    return found if found @ up > 0 else -found


def turn_between(a: Array, b: Array) -> Array:
    """The smallest rotation that takes the unit vector a to b, which is not opposite."""
    V = cross_matrix(np.cross(a, b))
    return np.eye(3) + V + V @ V / (1 + a @ b)


def check_points(names: Sequence[str], xyz: Array) -> None:
    """Raise InputError for origin, axis point and plane point (3, 3) that define no axes."""
    _check_known(names, xyz)
    a, b = xyz[1] - xyz[0], xyz[2] - xyz[0]
    sine = float(np.linalg.norm(np.cross(a, b))) / max(float(np.linalg.norm(a) * np.linalg.norm(b)), 1e-300)
    if not sine > IN_LINE:
        raise InputError("axes.in_line", names=names, sine=sine, limit=IN_LINE)


def check_direction(names: Sequence[str], xyz: Array, up: Array) -> None:
    """Raise InputError for an origin and an axis point (2, 3) above each other."""
    _check_known(names, xyz)
    a = xyz[1] - xyz[0]
    sine = float(np.linalg.norm(np.cross(a, up))) / max(float(np.linalg.norm(a)), 1e-300)
    if not sine > IN_LINE:
        raise InputError("axes.vertical", names=names, sine=sine, limit=IN_LINE)


def check_level(names: Sequence[str], xyz: Array) -> None:
    """Raise InputError for points of a level (k, 3) that lie in one line."""
    _check_known(names, xyz)
    size = np.linalg.svd(xyz - xyz.mean(axis=0), compute_uv=False)
    if len(xyz) < 3 or not size[1] > IN_LINE * size[0]:
        raise InputError(
            "axes.level_no_plane",
            names=names,
            n=len(xyz),
            width=size[1] / size[0] if len(xyz) > 1 else 0.0,
            limit=IN_LINE,
        )


def _check_known(names: Sequence[str], xyz: Array) -> None:
    for name, X in zip(names, xyz, strict=True):
        if not np.isfinite(X).all():
            raise InputError("axes.no_coordinates", names=names, point=name)
