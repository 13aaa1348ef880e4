"""No-go zones: lines end before them, ways between lines go round them."""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.errors import InputError
from raybundle.missions.patterns.base import Line
from raybundle.missions.polygons import distance_to, inside, signed_area, within
from raybundle.numerics.arrays import Array, Mask

CLEAR_M = 5.0
"""Kept from a no-go zone; what a receiver without corrections is off by."""


def cut_lines(lines: Sequence[Line], zones: Sequence[Array]) -> tuple[list[Line], float]:
    """The parts of lines outside of zones, and the metres (or photographs of rings) that are lost.

    A line that photographs by distance keeps whole bases, so that its overlap stays; a part shorter than a base is
    left out.
    """
    if not zones:
        return list(lines), 0.0
    kept: list[Line] = []
    lost = 0.0
    for line in lines:
        if line.base is None:
            free = ~np.any([_near(zone, line.xy) for zone in zones], axis=0)
            lost += float((~free).sum())
            kept += _point_parts(line, free, zones)
            continue
        parts = _free_parts(line, zones)
        lost += line.length - sum(p.length for p in parts)
        kept += parts
    return kept, lost


def _near(zone: Array, xy: Array) -> Mask:
    return inside(zone, xy) | (distance_to(zone, xy) < CLEAR_M)


def _point_parts(line: Line, free: Mask, zones: Sequence[Array]) -> list[Line]:
    """The free points of a line, cut wherever a zone lies on the way from one to the next."""
    rows = np.flatnonzero(free)
    if not len(rows):
        return []
    cut = [
        k for k in range(1, len(rows))
        if rows[k] != rows[k - 1] + 1 or within(zones, line.xy[rows[k - 1]], line.xy[rows[k]])
    ]  # fmt: skip
    parts = np.split(rows, cut)
    return [_points(line, part, f" part {n + 1}" if cut else "") for n, part in enumerate(parts)]


def _points(line: Line, keep: Array, suffix: str) -> Line:
    return replace(
        line, name=line.name + suffix, xy=line.xy[keep], above=line.above[keep], heading=line.heading[keep],
        pitch=line.pitch[keep],
    )  # fmt: skip


def _free_parts(line: Line, zones: Sequence[Array]) -> list[Line]:
    """Parts of a line by distance, at whole bases from its begin."""
    assert line.base is not None
    length = np.linalg.norm(np.diff(line.xy, axis=0), axis=1)
    way = np.append(0.0, np.cumsum(length))
    count = round(float(way[-1]) / line.base)
    s = np.arange(count + 1) * line.base
    fine = np.linspace(0, way[-1], max(2, int(way[-1] / 1.0) + 1))
    xy = np.stack([np.interp(fine, way, line.xy[:, j]) for j in (0, 1)], axis=1)
    blocked = np.any([_near(zone, xy) for zone in zones], axis=0)
    if not blocked.any():
        return [line]
    free: list[tuple[float, float]] = []
    k = 0
    while k < len(s) - 1:
        end = k
        while end + 1 < len(s) and not blocked[(fine >= s[end] - 1e-6) & (fine <= s[end + 1] + 1e-6)].any():
            end += 1
        if end > k:
            free.append((float(s[k]), float(s[end])))
        k = max(end, k + 1)
    return [part_of(line, a, b, f" part {n + 1}" if len(free) > 1 else "") for n, (a, b) in enumerate(free)]


def part_of(line: Line, start: float, end: float, suffix: str = "") -> Line:
    """A line from one length along it to another [m]."""
    way = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(line.xy, axis=0), axis=1)))
    s = np.concatenate([[start], way[(way > start + 1e-9) & (way < end - 1e-9)], [end]])
    low = np.clip(np.searchsorted(way, s + 1e-9, side="right") - 1, 0, len(way) - 2)
    return replace(
        line,
        name=line.name + suffix,
        xy=np.stack([np.interp(s, way, line.xy[:, j]) for j in (0, 1)], axis=1),
        above=np.interp(s, way, line.above),
        heading=line.heading[low],
        pitch=line.pitch[low],
    )


def way_round(a: Array, b: Array, zones: Sequence[Array]) -> Array:
    """The shortest way (n, 2) from a to b that keeps out of all zones, straight where it can be.

    raises  InputError where there is none, or an end lies within a zone
    """
    if not zones or not within(zones, a, b):
        return np.array([a, b])
    for what, point in (("begins", a), ("ends", b)):
        for zone in zones:
            if inside(zone, point[None])[0]:
                raise InputError("mission.way_in_zone", end=what, x=point[0], y=point[1])
    nodes = np.concatenate([[a, b], *(_round_corners(z) for z in zones)])
    free = np.array([not any(inside(z, n[None])[0] for z in zones) for n in nodes])
    best = np.full(len(nodes), np.inf)
    before = np.full(len(nodes), -1)
    best[0] = 0.0
    queue: list[tuple[float, int]] = [(0.0, 0)]
    while queue:
        length, k = heapq.heappop(queue)
        if k == 1 or length > best[k]:
            continue
        for j in np.flatnonzero(free).tolist():
            step = float(np.linalg.norm(nodes[j] - nodes[k]))
            if length + step < best[j] - 1e-9 and not within(zones, nodes[k], nodes[j]):
                best[j], before[j] = length + step, k
                heapq.heappush(queue, (length + step, j))
    if not np.isfinite(best[1]):
        raise InputError("mission.no_way", x=a[0], y=a[1], to_x=b[0], to_y=b[1])
    chain = [1]
    while chain[-1] != 0:
        chain.append(int(before[chain[-1]]))
    return nodes[chain[::-1]]


def _round_corners(zone: Array) -> Array:
    """Points (n, 2) off the corners of a zone, at the distance that is kept from its edges."""
    ring = zone if signed_area(zone) > 0 else zone[::-1]
    ahead = np.roll(ring, -1, axis=0) - ring
    ahead /= np.linalg.norm(ahead, axis=1)[:, None]
    out = np.stack([ahead[:, 1], -ahead[:, 0]], axis=1)
    before = np.roll(out, 1, axis=0)
    share = np.maximum(1 + np.sum(out * before, axis=1), 0.2)
    return ring + CLEAR_M * (out + before) / share[:, None]
