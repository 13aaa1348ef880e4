"""Marks by hand that contradict the others: left out of an adjustment where they are found, named in any case.

In an oriented block the marks of each point are tested against each other (`mark_tests`).  Where photographs were
oriented from the marks alone, a mistaken one bends the block, the camera first, so that the residuals of the adjustment
in which it took part need not show which it is, and blame the camera instead.  One in which contradicting observations
leave one by one does.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block
from raybundle.block.rejection import RejectionKind, known_wrong
from raybundle.errors import NotSolvable, Text, Value, phrase
from raybundle.measuring.mark_tests import LEVEL, PointTest, point_test, variance_without
from raybundle.measuring.position import Row
from raybundle.measuring.session import Session
from raybundle.numerics.arrays import Index
from raybundle.numerics.statistics import ALPHA, family_wise_tau
from raybundle.observations import observation_kinds

BENT = frozenset(
    {"camera_contradicts", "image_contradicts", "pixel_shape"} | {f"{k}_suspect" for k in observation_kinds}
)
"""What a mistaken mark makes an adjustment say of others"""
TESTED_UP_TO = 50_000
"""Image observations of a block whose marks are looked at."""
ROUNDS = 3
"""Adjustments anew without marks that the others contradict: what bent them may have hidden others."""


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
    shift: float = float("nan")
    """how far the point moves without it, at most without one of several; NaN where it is not known [length unit]"""
    unit: str = ""
    """of `shift`; "": none, as of a block without scale"""

    @property
    def values(self) -> dict[str, Value]:
        """The values of its messages; 0 for numbers that are not known."""
        numbers = {"tau": self.tau, "size_px": self.size_px, "shift": self.shift if self.unit else 0.0}
        known = {name: v if np.isfinite(v) else 0.0 for name, v in numbers.items()}
        return {"point": self.point, "images": self.images, "n": len(self.images), "unit": self.unit, **known}

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


def without_wrong_marks(block: Block, marked: frozenset[str], adjust: Callable[[Block], Adjustment]) -> Adjustment:
    """The adjustment of an oriented block without the marks that the others contradict, with a notice of each.

    Marks of which it cannot be determined which are wrong take part with standard deviations under which they agree,
    and are named; so are those that nothing tests.
    """
    result, wrong = adjust(block), dict[str, Wrong]()
    tests = _tests(result, marked)
    for _ in range(ROUNDS):
        found = {f"{i}\n{t.point}": _of(result, t, i) for t in tests for i in t.wrong}
        if not found:
            break
        wrong |= found
        out = tuple((w.images[0], w.point) for w in wrong.values())
        result = adjust(replace(block, rejected=(*block.rejected, *out)))
        tests = _tests(result, marked)
    undecided = [t for t in tests if t.contradicts]
    open_ = [_of(result, t) for t in undecided]
    if undecided:
        out = tuple((w.images[0], w.point) for w in wrong.values())
        result = adjust(replace(_with_larger_sigmas(block, undecided), rejected=(*block.rejected, *out)))
    named = {w.point for w in (*wrong.values(), *open_)}
    left = [w for w in _beyond_chance(result, _left(result, marked)) if w.point not in named]
    notices = [
        *(_notice(w, took_part=True) for w in open_),
        *(_notice(w, took_part=False) for w in (*wrong.values(), *left)),
    ]
    return _noted(result, notices, bent=bool(open_), tests=tests)


def _with_larger_sigmas(block: Block, tests: Sequence[PointTest]) -> Block:
    """The block with the marks of these points as inaccurate as they contradict each other: T over its mean."""
    o, covariance = block.observations, np.array(block.observations.cov_px2)
    position = {name: k for k, name in enumerate(block.points.ids)}
    for t in tests:
        covariance[o.point == position[t.point]] *= max(t.square / max(2 * len(t.images) - 3, 1), 1.0)
    return replace(block, observations=replace(o, cov_px2=covariance))


def _noted(result: Adjustment, notices: Sequence[Notice], *, bent: bool, tests: Sequence[PointTest]) -> Adjustment:
    """With notices of mistaken marks before all others, and one of those that nothing tests."""
    others = [n for n in result.notices if not (bent and n.code in BENT)]
    untested = [t for t in tests if t.untested]
    if untested:
        points = tuple(t.point for t in untested)
        n = sum(len(t.untested) for t in untested)
        unseen = max(t.unseen_px[i] for t in untested for i in t.untested)
        code = "marks_untested" if np.isfinite(unseen) else "marks_untested.open"
        values = {"n": n, "points": points, **({"unseen_px": unseen} if np.isfinite(unseen) else {})}
        others.append(Notice(code=code, values=values, ids=points))
    return replace(result, notices=(*notices, *others))


def _tests(result: Adjustment, marked: frozenset[str]) -> list[PointTest]:
    """The tests of the points marked by hand that two marks or more determine; none without covariances."""
    if not result.options.statistics:
        return []
    session, b = Session.of(result), result.adjusted
    variance = variance_without(result, marked)
    o, taken = b.observations, ~known_wrong(b)
    rows: dict[int, list[Row]] = {k: [] for k, name in enumerate(b.points.ids) if name in marked}
    for k in np.flatnonzero(np.isin(o.point, [*rows]) & taken & b.images.oriented[o.image]):
        xx, yy, xy = o.cov_px2[k]
        covariance = np.array([[xx, xy], [xy, yy]])
        rows[int(o.point[k])].append(Row(int(o.image[k]), np.array(o.xy_px[k]), covariance, adjusted=False))
    level = LEVEL / max(len(rows), 1)
    found = [point_test(session, b.points.ids[k], own, level=level, variance=variance) for k, own in rows.items()]
    return [t for t in found if t is not None]


def _of(result: Adjustment, test: PointTest, image: str = "") -> Wrong:
    """The mark of an image that a test names, or all suspects."""
    unit = "" if result.free_scale else result.given.length_unit
    if image:
        return Wrong(point=test.point, images=(image,), tau=test.sigmas[image], size_px=test.distance_px[image],
                     shift=test.shift, unit=unit)  # fmt: skip
    return Wrong(point=test.point, images=test.look, tau=max(test.sigmas.values()), shift=test.shift, unit=unit)


def with_wrong_marks(result: Adjustment, marked: frozenset[str]) -> Adjustment:
    """The result, oriented from marks, with a notice of each mistaken one in place of what it makes of others.

    Looked at where a test value of a mark, or the sum of all squares is beyond its limit; named where chance makes as
    large a test value anywhere in one of a thousand blocks.
    """
    return _noted(_with_blunders(result, marked), (), bent=False, tests=_tests(result, marked))


def _with_blunders(result: Adjustment, marked: frozenset[str]) -> Adjustment:
    if result.options.reject == "snooping":
        return _with_notices(result, result, _beyond_chance(result, _left(result, marked)))
    if not result.options.statistics or len(result.given.observations) > TESTED_UP_TO or not _doubtful(result, marked):
        return result
    try:
        tested = decide(result.given, replace(result.options, reject="snooping"))
    except NotSolvable:
        return result
    return _with_notices(result, tested, _beyond_chance(tested, _left(tested, marked)))


def _doubtful(result: Adjustment, marked: frozenset[str]) -> bool:
    _, square, upper = result.global_test
    if square > upper:
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
    code = "mark_contradicts" if len(wrong.images) == 1 else "mark_contradicts.undecided"
    return MarkNotice(
        code=code if took_part else "mark_contradicts.excluded", values=wrong.values,
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
