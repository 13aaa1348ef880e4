"""Tables of points and image observations, sorted and filtered here, a page at a time: a million rows stay here."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from raybundle.block import ROLES, Role
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Mask
from raybundle.studio.answers import finite
from raybundle.studio.desk import Desk

MOST_ROWS = 1000


@dataclass(frozen=True, slots=True, kw_only=True)
class Wanted:
    """Which rows."""

    sort: str = ""
    down: bool = False
    search: str = ""
    role: str = ""
    offset: int = 0
    limit: int = 100


def points(desk: Desk, wanted: Wanted) -> dict[str, Any]:
    """A page of the table of object points."""
    block, a = desk.block, desk.adjustment
    xyz = block.points.xyz
    std = np.full_like(xyz, np.nan)
    if a is not None and a.precision is not None:
        std = a.precision.object_point_std
    w = np.full(len(xyz), np.nan)
    if a is not None:
        w[:] = 0.0
        np.maximum.at(w, block.observations.point, np.nan_to_num(np.abs(a.image_observations.w)).max(axis=1))
    rays = block.ray_count
    ids, role = np.array(block.points.ids, object), np.asarray(block.points.role).astype(int)
    columns = {
        "point": ids, "role": role, "rays": rays, "w": w,
        **{n: xyz[:, k] for k, n in enumerate("XYZ")}, **{f"s{n}": std[:, k] for k, n in enumerate("XYZ")},
    }  # fmt: skip
    keep = containing(block.points.ids, wanted.search)
    if wanted.role:
        keep &= role == ROLES.get(wanted.role, -1)
    total, rows = page_of(columns, keep, wanted)
    return {"total": total, "rows": [
        {"point": block.points.ids[k], "role": Role(int(role[k])).word, "xyz": [finite(v) for v in xyz[k]],
         "sigma": [finite(v) for v in std[k]], "rays": int(rays[k]), "w": finite(w[k])}
        for k in rows
    ]}  # fmt: skip


def observations(desk: Desk, wanted: Wanted) -> dict[str, Any]:
    """A page of the table of image observations; x and y in the pixels of the camera, as in observations.csv."""
    block, a = desk.block, desk.adjustment
    o = block.observations
    v = np.full((len(o), 2), np.nan) if a is None else a.image_observations.residuals_px
    w = np.full(len(o), np.nan)
    if a is not None:
        w = np.nanmax(np.nan_to_num(np.abs(a.image_observations.w), nan=-1.0), axis=1, initial=-1.0)
        w = np.where(w < 0, np.nan, w)
    r = np.full(len(o), np.nan) if a is None else a.image_observations.redundancy.min(axis=1, initial=np.inf)
    columns = {
        "image": o.image, "point": o.point, "x": o.xy_px[:, 0], "y": o.xy_px[:, 1], "vx": v[:, 0], "vy": v[:, 1],
        "w": w, "r": r,
    }  # fmt: skip
    keep = np.ones(len(o), bool)
    if wanted.search:
        of_point, of_image = containing(block.points.ids, wanted.search), containing(block.images.ids, wanted.search)
        keep = of_point[o.point] | of_image[o.image]
    total, rows = page_of(columns, keep, wanted)
    reasons = None if a is None else a.image_observations.rejected
    return {"total": total, "rows": [
        {"image": block.images.ids[o.image[k]], "point": block.points.ids[o.point[k]], "x": float(o.xy_px[k, 0]),
         "y": float(o.xy_px[k, 1]), "vx": finite(v[k, 0]), "vy": finite(v[k, 1]), "w": finite(w[k]), "r": finite(r[k]),
         "rejected": "" if reasons is None or (reason := reasons[k]) is None else reason.text}
        for k in rows
    ]}  # fmt: skip


def containing(names: tuple[str, ...], text: str) -> Mask:
    """Which names hold a text, small and capital letters alike; all where none is asked for."""
    if not text:
        return np.ones(len(names), bool)
    small = text.casefold()
    return np.array([small in n for n in _folded(names)], bool)


@lru_cache(maxsize=2)
def _folded(names: tuple[str, ...]) -> tuple[str, ...]:
    """Names without capital letters; kept, since a million of them take a second."""
    return tuple(n.casefold() for n in names)


def page_of(columns: dict[str, Array], keep: Mask, wanted: Wanted) -> tuple[int, list[int]]:
    """Number of rows that are kept, and those of one page; what has no value comes last."""
    rows = np.flatnonzero(keep)
    if wanted.sort:
        values = columns.get(wanted.sort)
        if values is None:
            raise InputError("table.no_such_column", name=wanted.sort, known=list(columns))
        values = values[rows]
        if values.dtype == object:
            order = np.argsort(values.astype(str), kind="stable")
        else:
            order = np.argsort(np.where(np.isnan(values), np.inf, -values if wanted.down else values), kind="stable")
        if wanted.down and values.dtype == object:
            order = order[::-1]
        rows = rows[order]
    first = max(wanted.offset, 0)
    return len(rows), rows[first : first + min(max(wanted.limit, 0), MOST_ROWS)].tolist()
