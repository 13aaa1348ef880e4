"""Object space as the page draws it: points, stations, ellipsoids, bars, as one piece of bytes."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from raybundle.adjustment.statistics.network import FEW
from raybundle.block import Block, Role
from raybundle.numerics.arrays import Array, Index
from raybundle.report.figures.photographs import STRONG
from raybundle.report.figures.svg import spread_rows
from raybundle.report.network.page import basis_of, ellipsoids_of, extent_of
from raybundle.report.network.shape import frusta
from raybundle.studio.desk import Desk

MOST_POINTS = 1_000_000
MOST_PAIRS = 200_000
KINDS = {"f4": "<f4", "u1": "u1", "u2": "<u2", "u4": "<u4"}


def scene(desk: Desk) -> bytes:
    """The head as JSON, then the arrays that it names, little endian."""
    session = desk.session
    block, a = session.block, session.adjustment
    rows = _shown(block)
    images = np.flatnonzero(block.images.oriented & np.isfinite(block.images.centre).all(axis=1)).astype(np.int32)
    xyz, centre = block.points.xyz[rows], block.images.centre[images]
    every = xyz if len(xyz) else centre
    origin = np.median(every, axis=0) if len(every) else np.zeros(3)
    extent = extent_of(xyz - origin if len(xyz) else centre - origin)
    free = a is not None and any(part.startswith("rotation") for part in a.datum_defect)
    precision = None if a is None else a.precision
    sigma = np.full(len(rows), np.nan)
    if precision is not None:
        sigma = np.max(precision.object_point_std[rows], axis=1, initial=0.0)
    arrays: list[tuple[str, str, Array]] = [
        ("xyz", "f4", xyz - origin), ("role", "u1", np.asarray(block.points.role)[rows]),
        ("rays", "u2", np.minimum(block.ray_count[rows], 65535)), ("sigma", "f4", sigma),
        *((name, "f4", values[rows]) for name, values in _of_rays(desk).items()),
        ("centre", "f4", centre - origin), ("frustum", "f4", frusta(block, images, 0.05 * extent)[:, 1:] - origin),
    ]  # fmt: skip
    if precision is not None:
        of, axes = ellipsoids_of(block, precision.object_points, rows)
        arrays += [("ellipsoid_of", "u4", of), ("ellipsoid", "f4", axes)]
    place = np.full(len(block.points), -1)
    place[rows] = np.arange(len(rows))
    ends = place[np.stack([block.distances.start, block.distances.end], axis=1)] if len(block.distances) else None
    if ends is not None:
        arrays.append(("bars", "u4", ends[(ends >= 0).all(axis=1)]))
    where = np.full(len(block.images), -1)
    where[images] = np.arange(len(images))
    graph = desk.shared[:MOST_PAIRS]
    graph = graph[(where[graph[:, :2]] >= 0).all(axis=1)]
    arrays += [("pair", "u4", where[graph[:, :2]]), ("common", "u4", graph[:, 2])]
    head: dict[str, Any] = {
        "origin": origin.tolist(), "extent": extent, "unit": "" if block.free_scale else block.length_unit,
        "basis": basis_of(block, images, xyz, free=free).ravel().tolist(),
        "arrays": [{"name": n, "kind": k, "shape": list(v.shape)} for n, k, v in arrays],
        "image_ids": [block.images.ids[i] for i in images], "total": len(block.points),
        "few": FEW, "strong": STRONG,
        "names": [block.points.ids[p] for p in rows],
    }  # fmt: skip
    text = json.dumps(head, allow_nan=False, separators=(",", ":")).encode()
    text += b" " * (-(len(text) + 4) % 8)
    parts = [np.array(len(text), "<u4").tobytes(), text]
    for _, kind, values in arrays:
        data = np.ascontiguousarray(values, dtype=KINDS[kind]).tobytes()
        parts += [data, b"\0" * (-len(data) % 4)]
    return b"".join(parts)


def _shown(block: Block) -> Index:
    """Points that are drawn: control and check points all, of the others as many as a page can hold, evenly."""
    known = np.isfinite(block.points.xyz).all(axis=1)
    special = known & (np.asarray(block.points.role) != Role.TIE)
    tie = np.flatnonzero(known & ~special)
    room = max(MOST_POINTS - int(special.sum()), 0)
    return np.concatenate([np.flatnonzero(special), tie[spread_rows(len(tie), room)]]).astype(np.int32)


def _of_rays(desk: Desk) -> dict[str, Array]:
    """What the image observations of each point show together, (p,) each, NaN without.

    w  largest |w|, rejected ones included; r  smallest redundancy number of those that take part; v  root mean square
    of their residuals [px].
    """
    block, a = desk.block, desk.adjustment
    w, r, v = (np.full(len(block.points), np.nan) for _ in range(3))
    if a is not None:
        s, point = a.image_observations, block.observations.point
        w[:] = 0.0
        np.maximum.at(w, point, np.nan_to_num(np.abs(s.w)).max(axis=1, initial=0.0))
        used = np.flatnonzero(s.used)
        np.fmin.at(r, point[used], np.fmin.reduce(s.redundancy[used], axis=1, initial=np.nan))
        count = np.bincount(point[used], minlength=len(v))
        square = np.bincount(point[used], (s.residuals_px[used] ** 2).sum(axis=1), minlength=len(v))
        np.sqrt(square / np.maximum(count, 1), out=v, where=count > 0)
    return {"w": w, "r": r, "v": v}
