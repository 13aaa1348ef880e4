"""The table of object points of a block folder."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from raybundle.block import ROLES, Points, Role
from raybundle.errors import message
from raybundle.io.block.tables import SIGMA_XYZ, XYZ, columns_of, problems_of, require
from raybundle.io.digits import EVERY
from raybundle.io.reading.files import stands
from raybundle.io.reading.words import quoted
from raybundle.io.tables import Column, Problem, read_table, write_table
from raybundle.numerics.arrays import Array

WINDOW = ("window", "misfit", "relief", "sigma_curvature")
"""Of points that were measured by matching: optional columns"""
COLUMNS = (
    Column(name="point", kind="id"),
    Column(name="role", kind="text"),
    *(Column(name=n, kind="number", empty=True) for n in XYZ),
    *(Column(name=n, kind="number", empty=True, limit=">= 0") for n in SIGMA_XYZ),
    *(Column(name=n, kind="number", optional=True, empty=True, limit="> 0") for n in WINDOW),
)


def read_points(path: Path) -> Points:
    """The object points of a table, none where it does not stand there; raises InputError with row and column."""
    if not stands(path):
        empty = np.zeros((0, 3))
        return Points(ids=(), role=np.zeros(0, np.int32), xyz=empty, sigma=empty)
    table = read_table(path, COLUMNS, own=True)
    ids, roles = table.text["point"], table.text["role"]
    unknown = np.array([r not in ROLES for r in roles])
    require(
        path,
        problems_of(
            unknown, "role", lambda k: message("value.not_supported", value=quoted(roles[k]), known=list(ROLES))
        ),
    )
    role = np.fromiter((ROLES[r] for r in roles), np.int32, len(roles))
    xyz, sigma = table.numbers(*XYZ), table.numbers(*SIGMA_XYZ)
    given, weighted = np.isfinite(xyz), np.isfinite(sigma)
    problems: list[Problem] = []
    for axis, s in zip(XYZ, SIGMA_XYZ, strict=True):
        k = XYZ.index(axis)
        problems += problems_of(
            weighted[:, k] & ~given[:, k],
            s,
            lambda row, axis=axis, s=s: message(
                "point.sigma_without_coordinate", point=ids[row], sigma=s, coordinate=axis
            ),
        )
    problems += problems_of(
        (role == Role.TIE) & weighted.any(axis=1),
        "sX",
        lambda k: message("point.tie_with_sigma", point=ids[k]),
    )
    problems += problems_of(
        (role == Role.CONTROL) & ~(given & weighted).any(axis=1),
        "sX",
        lambda k: message("point.control_without_sigma", point=ids[k]),
    )
    problems += problems_of(
        (role == Role.CHECK) & ~given.any(axis=1),
        "X",
        lambda k: message("point.check_without_coordinate", point=ids[k]),
    )
    window = table.number.get("window")
    if window is not None and given.all(axis=1).sum() > 1:
        extent = float(np.linalg.norm(np.ptp(xyz[given.all(axis=1)], axis=0)))
        problems += problems_of(
            window > extent,
            "window",
            lambda k: message("point.window_too_large", point=ids[k], window=window[k], extent=extent),
        )
    require(path, problems)
    return Points(ids=ids, role=role, xyz=xyz, sigma=sigma, **{n: table.number.get(n) for n in WINDOW})


def with_tie_points(points: Points, new: tuple[str, ...]) -> Points:
    """The points with those that only the observations know."""
    unknown = np.full((len(new), 3), np.nan)
    role = np.full(len(new), Role.TIE, np.int32)
    return points.append(Points(ids=new, role=role, xyz=unknown, sigma=unknown))


def write_points(path: Path, points: Points) -> None:
    """Write the table, with all digits."""
    columns = {**point_columns(points), **columns_of(XYZ, points.xyz), **columns_of(SIGMA_XYZ, points.sigma)}
    columns |= {n: values for n in WINDOW if (values := getattr(points, n)) is not None}
    write_table(path, columns, EVERY)


def point_columns(points: Points) -> dict[str, Sequence[str] | Array]:
    """The columns `point` and `role`."""
    return {"point": points.ids, "role": [Role(r).word for r in np.asarray(points.role).tolist()]}
