"""A block of several dates: an object point of each date, or one of all dates where it did not move."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.decision.decide import Earlier, decide
from raybundle.adjustment.decision.snooping import innocent
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.result_figures import Extent
from raybundle.block import Block
from raybundle.block.rejection import Rejection, RejectionKind, given_rejections
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.progress import Progress
from raybundle.orientation.rays import intersect_linear
from raybundle.ties.block import FLAT, viewing_lines

AT = "@"
"""Between the name of a point and the date at which it lies there: t12@2026-05-01"""
RAYS = 2
"""Image points of a date from which on a point has a place at that date"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Dates:
    """The dates of the images of a block, in the order of time."""

    names: tuple[str, ...]
    of_image: Index
    """(n,) position in `names`"""

    @classmethod
    def of(cls, dates: Sequence[str]) -> Dates:
        """Of the date of each image; raises InputError for fewer than two dates."""
        names = tuple(sorted(set(dates)))
        if len(names) < 2:
            raise InputError("epochs.one_date", dates=list(names))
        place = {d: k for k, d in enumerate(names)}
        return cls(names=names, of_image=np.array([place[d] for d in dates], np.int64))

    def base(self, point: str) -> str:
        """The name of a point without a date."""
        name, _, date = point.rpartition(AT)
        return name if name and date in self.names else point

    def point(self, base: str, date: int) -> str:
        """The name of a point at a date."""
        return f"{base}{AT}{self.names[date]}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Dated:
    """A block in which places of a point at different dates are points of their own, or one."""

    block: Block
    bases: tuple[str, ...]
    """Names of the points without dates"""
    at: Index
    """(b, dates) position of the point of each date in `block.points`, -1 where it has no place then; a point that is
    one place stands at each date at which it was seen"""
    together: Mask
    """(b,) points that are one place at all dates"""
    seen: Index
    """(b, dates) image points of each date"""

    @property
    def place(self) -> Index:
        """(p,) number of the base of each point of `block`."""
        found = len(self.bases) + np.arange(len(self.block.points))
        base, date = np.nonzero(self.at >= 0)
        found[self.at[base, date]] = base
        return found

    @property
    def spanning(self) -> Mask:
        """(b,) points with places of their own at two dates or more."""
        return ~self.together & ((self.at >= 0).sum(axis=1) > 1)


def by_dates(block: Block, dates: Dates, together: Sequence[str] = (), rows: Mask | None = None) -> Dated:
    """The block with object points of each date.

    together  names (without dates) of points that are one place at all dates
    rows      (m,) image points that take part; None: all
    Control and check points stay what they are.  A point with one ray at a date has no place then: that ray is left
    out, unless the point is one place at all dates.
    """
    o, p = block.observations, block.points
    bases, base_of = _numbered([dates.base(n) for n in p.ids])
    D, B = len(dates.names), len(bases)
    one_place = set(together)
    whole = np.array([name in one_place for name in bases], bool)
    known = np.asarray(p.is_control.any(axis=1) | p.is_check.any(axis=1), bool)
    whole[base_of[known]] = True
    keep = np.ones(len(o), bool) if rows is None else rows.copy()
    b, d = base_of[o.point], dates.of_image[o.image]
    seen = np.zeros((B, D), np.int64)
    np.add.at(seen, (b[keep], d[keep]), 1)
    keep &= np.where(whole[b], seen.sum(axis=1)[b] >= RAYS, seen[b, d] >= RAYS) | known[o.point]
    key = b * (D + 1) + np.where(whole[b], D, d)
    given = base_of[known] * (D + 1) + D
    keys = np.unique(np.concatenate([key[keep], given]))
    source = _sources(keys, key, keep, o.point, base_of, known, D)
    places = (seen >= RAYS).sum(axis=1)
    ids = tuple(
        bases[one] if date == D or places[one] < 2 else dates.point(bases[one], date)
        for one, date in (divmod(k, D + 1) for k in keys.tolist())
    )
    at = np.full((B, D), -1, np.int64)
    for n, k in enumerate(keys.tolist()):
        base, date = divmod(k, D + 1)
        if date == D:
            at[base, seen[base] > 0] = n
        else:
            at[base, date] = n
    first = np.where((at >= 0).any(axis=1), at[np.arange(B), (at >= 0).argmax(axis=1)], -1)
    one = np.flatnonzero(whole) * (D + 1) + D
    first[whole] = np.where(np.isin(one, keys), np.searchsorted(keys, one), -1)
    new = first[base_of].astype(np.int32)
    found = replace(
        block, points=replace(p.rows(source), ids=ids),
        observations=replace(o.rows(keep), point=np.searchsorted(keys, key[keep]).astype(np.int32)),
        rejected=(),
    ).of_tables(lambda t: t.renumbered("point", new))  # fmt: skip
    return Dated(block=found, bases=bases, at=at, together=whole, seen=seen)


def _numbered(names: Sequence[str]) -> tuple[tuple[str, ...], Index]:
    """Different names in the order of their first, and which each is."""
    place: dict[str, int] = {}
    at = np.array([place.setdefault(n, len(place)) for n in names], np.int64)
    return tuple(place), at


def _sources(keys: Index, key: Index, keep: Mask, point: Index, base_of: Index, known: Mask, dates: int) -> Index:
    """(k,) the point of the block that each new one takes its attributes from: that of its first row."""
    source = np.zeros(len(keys), np.int64)
    rows = np.flatnonzero(keep)[::-1]
    source[np.searchsorted(keys, key[rows])] = point[rows]
    control = np.flatnonzero(known)
    source[np.searchsorted(keys, base_of[control] * (dates + 1) + dates)] = control
    return source


def placed_by_dates(block: Block, dates: Dates, together: Sequence[str] = ()) -> Dated:
    """As `by_dates`, each point of a date where its rays meet; rays of points that have no depth then are left out."""
    dated = by_dates(block, dates, together)
    placed, flat = _intersected(dated.block, _own_place(dated))
    if flat.any():
        dated = by_dates(dated.block, dates, together, rows=~flat[dated.block.observations.point])
        placed, _ = _intersected(dated.block, _own_place(dated))
    return replace(dated, block=placed)


def _own_place(dated: Dated) -> Mask:
    """(p,) points that the rays of their dates alone place."""
    mine = np.zeros(len(dated.block.points), bool)
    at = dated.at[~dated.together]
    mine[at[at >= 0]] = True
    return mine & ~np.asarray(dated.block.points.is_control.any(axis=1), bool)


def _intersected(block: Block, points: Mask) -> tuple[Block, Mask]:
    """The block with some points where their rays meet, and which of these have no depth."""
    origin, direction = viewing_lines(block)
    xyz, count, ratio = intersect_linear(origin, direction, block.observations.point, len(block.points))
    flat = points & ((count < RAYS) | (ratio < FLAT) | ~np.isfinite(xyz).all(axis=1))
    placed: Array = np.where((points & ~flat)[:, None], xyz, block.points.xyz)
    return replace(block, points=replace(block.points, xyz=placed)), flat


def adjusted_again(
    block: Block, dates: Dates, options: AdjustmentOptions, progress: Progress, before: Adjustment | None, *,
    extent: Extent = "report", snooping: bool = True,
) -> Adjustment:  # fmt: skip
    """The adjustment of a block with what was decided of its image points before; `snooping`: which then goes on."""
    earlier = None if before is None else _decided(block, dates, before)
    options = options if snooping else replace(options, reject="none")
    return decide(block, options, progress, earlier=earlier, extent=extent)


def _decided(block: Block, dates: Dates, before: Adjustment) -> Earlier:
    """What data snooping decided of the same image points, of which other points may now be one place.

    Of points of which no single wrong ray could be determined it stands where they have the same rays.
    """
    blocks = block, before.given
    place = _numbered([dates.base(p) for b in blocks for p in b.points.ids])[1]
    places = np.split(place, [len(block.points)])
    now, then = (
        p[b.observations.point] * len(b.images) + b.observations.image for p, b in zip(places, blocks, strict=True)
    )
    order = np.argsort(then, kind="stable")
    at = order[np.minimum(np.searchsorted(then[order], now), len(then) - 1)]
    same = then[at] == now
    rays, known = (np.bincount(b.observations.point)[b.observations.point] for b in blocks)
    reasons, back = before.image_observations.rejected, frozenset(innocent(before))
    kept = {RejectionKind.BLUNDER}, {RejectionKind.BLUNDER, RejectionKind.BLUNDER_NOT_LOCATED}
    found: list[Rejection | None] = list(given_rejections(block))
    for k in np.flatnonzero(same).tolist():
        why = reasons[at[k]]
        if why is not None and why.kind in kept[int(rays[k] == known[at[k]])]:
            found[k] = why
    return Earlier(reasons=tuple(found), returned=frozenset(k for k in np.flatnonzero(same).tolist() if at[k] in back))
