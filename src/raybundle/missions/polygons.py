"""Polygons of the plane: whether they are sound, what lies within, where lines enter and leave."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.planes import hull

Interval = tuple[float, float]
NEAR = 1e-9
"""Share of a polygon's extent below which two of its points are one."""


AT_ONCE = 1_000_000
"""Pairs of edges that are looked at together."""
THINNEST = 1e-4
"""Share of the square of its length that an area has at least: a kilometre of a decimetre's width is a line."""


def checked_ring(xy: Array, kind: Literal["area", "object", "zone", "outline"] = "outline", name: str = "") -> Array:
    """The corners (n, 2) of a polygon, each once, counter-clockwise.

    kind, name  of the polygon, for messages
    raises      InputError for fewer than three corners, no extent, or edges that cross, with the place
    """
    ring = np.asarray(xy, float)
    if ring.ndim != 2 or ring.shape[1] != 2 or not np.isfinite(ring).all():
        raise InputError("flight_area.not_finite", kind=kind, name=name)
    size = float(np.ptp(ring, axis=0).max(initial=0.0)) if len(ring) else 0.0
    keep = np.linalg.norm(ring - np.roll(ring, 1, axis=0), axis=1) > NEAR * size
    ring = ring[keep]
    if len(ring) < 3:
        raise InputError("flight_area.too_few_corners", kind=kind, name=name, n=len(ring))
    crossing = _crossing(ring)
    if crossing is not None:
        i, j, (x, y) = crossing
        raise InputError("flight_area.crosses_itself", kind=kind, name=name, first=i + 1, second=j + 1, x=x, y=y)
    area = signed_area(ring)
    if abs(area) <= THINNEST * size * size:
        raise InputError("flight_area.no_area", kind=kind, name=name, area=abs(area), length=size)
    return ring if area > 0 else ring[::-1]


def signed_area(ring: Array) -> float:
    """Area of a polygon (n, 2), positive where its corners run counter-clockwise."""
    x, y = (ring - ring.mean(axis=0)).T
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y) / 2)


def part_in_box(ring: Array, low: Array, high: Array) -> tuple[float, Array]:
    """Area of what a box with sides along the axes has of a polygon (n, 2), and its centre of gravity (2,).

    The polygon is cut at one side after the other (Sutherland and Hodgman 1974); where that leaves several pieces,
    the edges that join them run to and fro along the box and add nothing.  Without an area, the centre of the box.
    """
    middle = (low + high) / 2
    part = ring - middle
    for axis in (0, 1):
        for sign in (1.0, -1.0):
            part = _cut_at(part, axis, sign, float(high[axis] - middle[axis]))
    u, v = part, np.roll(part, -1, axis=0)
    cross = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    twice = float(cross.sum())
    if not abs(twice) > 1e-12 * float(np.prod(high - low)):
        return 0.0, middle
    return abs(twice) / 2, middle + np.sum((u + v) * cross[:, None], axis=0) / (3 * twice)


def _cut_at(ring: Array, axis: int, sign: float, limit: float) -> Array:
    """What a polygon (n, 2) has where sign * coordinate <= limit."""
    if not len(ring):
        return ring
    over = sign * ring[:, axis] - limit
    after, next_over = np.roll(ring, -1, axis=0), np.roll(over, -1)
    with np.errstate(divide="ignore", invalid="ignore"):
        met = ring + (over / (over - next_over))[:, None] * (after - ring)
    both = np.stack([ring, met], axis=1).reshape(-1, 2)
    keep = np.stack([over <= 0, (over <= 0) != (next_over <= 0)], axis=1).ravel()
    return both[keep]


def _crossing(ring: Array) -> tuple[int, int, Array] | None:
    """Two edges that meet elsewhere than at a common corner, the first such two along the polygon, and where."""
    a, b = ring, np.roll(ring, -1, axis=0)
    n, found = len(ring), list[tuple[int, int, float]]()
    for i, j in _near(np.minimum(a, b), np.maximum(a, b)):
        i, j = np.minimum(i, j), np.maximum(i, j)  # noqa: PLW2901  (in their order along the polygon)
        t, s = _meeting(a[i], b[i], a[j], b[j])
        neighbours = (j == i + 1) | ((i == 0) & (j == n - 1))
        hit = np.flatnonzero((t >= 0) & (t <= 1) & (s >= 0) & (s <= 1) & ~neighbours)
        found += [(int(i[k]), int(j[k]), float(t[k])) for k in hit[np.lexsort((j[hit], i[hit]))][:1]]
    if not found:
        return None
    one, other, t = min(found)
    return one, other, a[one] + t * (b[one] - a[one])


def _near(low: Array, high: Array) -> Iterator[tuple[Index, Index]]:
    """Pairs of boxes (n, 2) that overlap or touch, some at a time: along the axis of which fewer do, those in reach."""

    def reach(axis: int) -> tuple[Index, Index]:
        order = np.argsort(low[:, axis], kind="stable")
        last = np.searchsorted(low[order, axis], high[order, axis], side="right")
        return order, last - np.arange(len(low)) - 1

    order, many = min(reach(0), reach(1), key=lambda found: int(found[1].sum()))
    total, first = np.cumsum(many), 0
    while first < len(order):
        before = int(total[first - 1]) if first else 0
        last = max(first + 1, int(np.searchsorted(total, before + AT_ONCE)))
        one = np.repeat(np.arange(first, last), many[first:last])
        other = (
            one + 1 + np.arange(len(one)) - (np.repeat(total[first:last] - many[first:last], many[first:last]) - before)
        )
        i, j = order[one], order[other]
        near = ((low[i] <= high[j]) & (low[j] <= high[i])).all(axis=1)
        yield i[near], j[near]
        first = last


def _meeting(a: Array, b: Array, c: Array, d: Array) -> tuple[Array, Array]:
    """Where lines a-b (2,) or (n, 2) meet the lines c-d (n, 2): shares of both, NaN for parallel lines."""
    u, v = b - a, d - c
    cross = u[..., 0] * v[:, 1] - u[..., 1] * v[:, 0]
    w = c - a
    with np.errstate(divide="ignore", invalid="ignore"):
        t = (w[:, 0] * v[:, 1] - w[:, 1] * v[:, 0]) / cross
        s = (w[:, 0] * u[..., 1] - w[:, 1] * u[..., 0]) / cross
    return np.where(cross == 0, np.nan, t), np.where(cross == 0, np.nan, s)


def astray(ring: Array, other: Array, *, within: bool) -> Array | None:
    """(2,) a place on the edges of a polygon (n, 2) within another, or not within it; None: there is none.

    Edges that run along those of the other are neither.
    """
    middles = list[Array]()
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        t, s = _meeting(a, b, other, np.roll(other, -1, axis=0))
        cuts = np.unique(np.concatenate([[0.0, 1.0], t[(s >= 0) & (s <= 1) & (t > 0) & (t < 1)]]))
        middles.append(a + ((cuts[:-1] + cuts[1:]) / 2)[:, None] * (b - a))
    places = np.concatenate(middles)
    places = places[inside(other, places) == within]
    size = float(np.ptp(np.concatenate([ring, other]), axis=0).max())
    places = places[distance_to(other, places) > NEAR * size] if len(places) else places
    return places[0] if len(places) else None


def inside(ring: Array, xy: Array) -> Mask:
    """(n,) which points (n, 2) lie within a polygon (k, 2); even-odd rule."""
    xy = np.asarray(xy, float)
    found = np.zeros(len(xy), bool)
    for (x0, y0), (x1, y1) in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        if y0 == y1:
            continue
        between = (y0 > xy[:, 1]) != (y1 > xy[:, 1])
        found ^= between & (xy[:, 0] < x0 + (xy[:, 1] - y0) * (x1 - x0) / (y1 - y0))
    return found


def distance_to(ring: Array, xy: Array) -> Array:
    """Distances (n,) of points (n, 2) from the outline of a polygon (k, 2)."""
    best = np.full(len(xy), np.inf)
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        d = b - a
        t = np.clip((xy - a) @ d / (d @ d), 0, 1)
        best = np.minimum(best, np.linalg.norm(xy - a - t[:, None] * d, axis=1))
    return best


def within(rings: Sequence[Array], a: Array, b: Array) -> tuple[Interval, ...]:
    """The parts of the way from a to b (2,) that lie within any of the polygons, as shares 0 to 1 of it."""
    found: list[Interval] = []
    for ring in rings:
        t, s = _meeting(a, b, ring, np.roll(ring, -1, axis=0))
        cuts = np.concatenate([[0.0, 1.0], t[(s >= 0) & (s <= 1) & (t > 0) & (t < 1)]])
        cuts = np.unique(cuts)
        middle = (cuts[:-1] + cuts[1:]) / 2
        hit = inside(ring, a + middle[:, None] * (b - a))
        found += [(float(p), float(q)) for p, q, h in zip(cuts[:-1], cuts[1:], hit, strict=True) if h]
    return united(found)


def united(parts: Sequence[Interval], gap: float = 1e-12) -> tuple[Interval, ...]:
    """Intervals in their order, those that overlap or lie less than a gap apart joined."""
    joined: list[Interval] = []
    for low, high in sorted(parts):
        if joined and low <= joined[-1][1] + gap:
            joined[-1] = (joined[-1][0], max(joined[-1][1], high))
        else:
            joined.append((low, high))
    return tuple(joined)


def along(ring: Array, low: float, high: float) -> tuple[Interval, ...]:
    """Intervals of x that a polygon (n, 2) covers at any y from low to high.

    Between the heights of its corners the ends of an interval move linearly with y: the corners and the two borders
    show all.
    """
    reach = (high - low) * 1e-9
    heights = [low, high]
    for y in ring[:, 1]:
        if low <= y <= high:
            heights += [max(low, float(y) - reach), min(high, float(y) + reach)]
    parts: list[Interval] = []
    for y in sorted(set(heights)):
        y0, y1 = ring[:, 1], np.roll(ring[:, 1], -1)
        cut = (y0 > y) != (y1 > y)
        with np.errstate(divide="ignore", invalid="ignore"):
            x = ring[:, 0] + (y - y0) * (np.roll(ring[:, 0], -1) - ring[:, 0]) / (y1 - y0)
        ends = np.sort(x[cut])
        parts += [(float(p), float(q)) for p, q in zip(ends[::2], ends[1::2], strict=False)]
    return united(parts)


def widened(ring: Array, by: float) -> Array:
    """A convex outline of a polygon (n, 2), all round at least `by` away from it."""
    corners = hull(ring)
    turns = np.arange(12) * np.pi / 6
    circle = by / np.cos(np.pi / 12) * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    return hull((corners[:, None] + circle[None]).reshape(-1, 2))


def longest_direction(ring: Array) -> float:
    """Azimuth [rad] along which a polygon (n, 2) is covered by the fewest lines: that of its least width."""
    corners = hull(ring)
    best, azimuth = np.inf, 0.0
    for edge in np.roll(corners, -1, axis=0) - corners:
        d = edge / np.linalg.norm(edge)
        width = float(np.ptp(corners @ np.array([-d[1], d[0]])))
        if width < best - 1e-9:
            best, azimuth = width, float(np.arctan2(d[0], d[1]) % np.pi)
    return azimuth
