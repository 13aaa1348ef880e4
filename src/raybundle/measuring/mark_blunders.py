"""Marks by hand that contradict the others: found by data snooping, and named whether they took part or not.

A mistaken mark bends a block of few marks, the camera first, so that the residuals of the adjustment in which it took
part need not show which it is, and blame the camera instead.  One in which contradicting observations leave one by one
does.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.adjusted_values import as_start
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block.rejection import RejectionKind
from raybundle.errors import NotSolvable, Text, Value, phrase
from raybundle.numerics.arrays import Index
from raybundle.numerics.statistics import ALPHA, family_wise_tau
from raybundle.observations import observation_kinds

BENT = frozenset(
    {"camera_contradicts", "image_contradicts", "pixel_shape"} | {f"{k}_suspect" for k in observation_kinds}
)
"""What a mistaken mark makes an adjustment say of others"""
TESTED_UP_TO = 50_000
"""Image observations of a block whose marks are looked at."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Wrong:
    """A mark that contradicts the others."""

    point: str
    images: tuple[str, ...]
    """where it stands; several where it cannot be determined which of them is wrong"""
    tau: float
    """its test value; NaN where there is none"""
    size_px: float = float("nan")
    """how far it lies from where the others see it; NaN where that hangs on which of several is wrong"""

    @property
    def values(self) -> dict[str, Value]:
        """The values of its messages; 0 for numbers that are not known."""
        known = {name: 0.0 if np.isnan(v) else v for name, v in (("tau", self.tau), ("size_px", self.size_px))}
        return {"point": self.point, "images": self.images, "n": len(self.images), **known}

    @property
    def words(self) -> Text:
        """For the person who measures."""
        return phrase("mark.contradicts", **self.values)


@dataclass(frozen=True, slots=True, kw_only=True)
class MarkNotice(Notice):
    """A mistaken mark, with what is known of it: `ids` are its point and its images."""

    wrong: Wrong


def wrong_marks(result: Adjustment, marked: frozenset[str]) -> tuple[Wrong, ...]:
    """Marks that contradict the others: those that left a result, and those that took part and are reported.

    marked  the points that are marked by hand: of others nobody can look a mark at again
    """
    wrong = tuple(n.wrong for n in result.notices if isinstance(n, MarkNotice))
    return (*wrong, *(w for w in _left(result, marked) if w not in wrong))


def with_wrong_marks(result: Adjustment, marked: frozenset[str], *, alone: bool) -> Adjustment:
    """The result with a notice of each mistaken mark in place of what it makes the adjustment say of others.

    alone  whether photographs were oriented from the marks, so that a mistaken one may bend everything
    Looked at where a test value of a mark, or, of marks alone, the sum of all squares is beyond its limit; named where
    chance makes as large a test value anywhere in one of a thousand blocks.
    """
    if result.options.reject == "snooping":
        return _with_notices(result, result, _beyond_chance(result, _left(result, marked)))
    if (
        not result.options.statistics
        or len(result.given.observations) > TESTED_UP_TO
        or not _doubtful(result, marked, alone=alone)
    ):
        return result
    start = as_start(result.given, result.adjusted) if not alone else result.given
    try:
        tested = decide(start, replace(result.options, reject="snooping"))
    except NotSolvable:
        return result
    return _with_notices(result, tested, _beyond_chance(tested, _left(tested, marked)))


def _doubtful(result: Adjustment, marked: frozenset[str], *, alone: bool) -> bool:
    _, square, upper = result.global_test
    if alone and square > upper:
        return True
    at = [k for k, name in enumerate(result.given.points.ids) if name in marked]
    t = np.abs(result.image_observations.t[np.isin(result.given.observations.point, at)])
    return bool((np.nan_to_num(t) > result.critical_tau).any())


def _beyond_chance(tested: Adjustment, found: Sequence[Wrong]) -> tuple[Wrong, ...]:
    """Those whose test value is beyond the family-wise limit at `ALPHA`, of the redundancy before they left."""
    used = tested.image_observations.used
    tests = int(2 * len(used) + sum(len(g.ids) for g in tested.groups))
    limit = family_wise_tau(ALPHA, tests, tested.redundancy + 2 * int((~used).sum()))
    return tuple(w for w in found if w.tau > limit)


def _with_notices(result: Adjustment, tested: Adjustment, found: Sequence[Wrong]) -> Adjustment:
    if not found:
        return result
    took_part = tested is not result
    notices = tuple(_notice(w, took_part=took_part) for w in found)
    stated = {n.code for n in tested.notices}
    others = tuple(n for n in result.notices if n.code not in BENT or n.code in stated)
    return replace(result, notices=(*notices, *others))


def _notice(wrong: Wrong, *, took_part: bool) -> MarkNotice:
    return MarkNotice(
        code="mark_contradicts" if took_part else "mark_contradicts.excluded", values=wrong.values,
        ids=(wrong.point, *wrong.images), wrong=wrong, measured=Severity.FAULT if took_part else Severity.WARNING,
    )  # fmt: skip


def _left(result: Adjustment, marked: frozenset[str]) -> tuple[Wrong, ...]:
    """Marks that left a result as blunders, those of a point together where it cannot be determined which."""
    o, b = result.given.observations, result.given
    rejected = result.image_observations.rejected
    hand = np.array([name in marked for name in b.points.ids], bool)[o.point]
    out = np.array([why is not None and why.kind is not RejectionKind.GIVEN for why in rejected], bool)
    rows = np.flatnonzero(hand & out)
    far = _distances(result, rows)
    single: list[Wrong] = []
    together: dict[str, list[Wrong]] = {}
    for k, size in zip(rows.tolist(), far, strict=True):
        point, image, why = b.points.ids[int(o.point[k])], b.images.ids[int(o.image[k])], rejected[k]
        assert why is not None
        one = Wrong(point=point, images=(image,), tau=why.tau, size_px=size)
        if why.kind is RejectionKind.BLUNDER:
            single.append(one)
        else:
            together.setdefault(point, []).append(one)
    named = {w.point for w in single}
    shared = [
        Wrong(point=p, images=tuple(w.images[0] for w in ws), tau=float(np.fmax.reduce([w.tau for w in ws])))
        for p, ws in together.items()
        if p not in named
    ]  # fmt: skip
    return (*sorted(single, key=lambda w: -w.tau), *shared)


def _distances(result: Adjustment, rows: Index) -> list[float]:
    """How far image observations lie from where a result sees their points [px]; NaN where it has none."""
    if not len(rows):
        return []
    o = result.adjusted.observations
    seen = (
        np.isfinite(result.adjusted.points.xyz[o.point[rows]]).all(axis=1)
        & result.adjusted.images.oriented[o.image[rows]]
    )
    far = np.full(len(rows), np.nan)
    if seen.any():
        far[seen] = np.linalg.norm(residuals_px(result.adjusted, rows[seen]), axis=1)
    return far.tolist()
