"""Marks of a point against each other: which are wrong, which may be, and how large an error would not show.

Let e (2 n) be the marks of a point less the places at which oriented images see it, with the covariance S of the marks
and of the orientations together, and B the partials by its coordinates.  With

    W = S^-1 - S^-1 B (B' S^-1 B)^-1 B' S^-1,    w = W e,    T = e' w

T is distributed as chi-square with 2 n - 3 degrees of freedom where all marks are right.  Without the marks of a set it
falls by w_s' W_ss^-1 w_s (Teunissen 2000, section 4.3), and W_ss^-1 w_s is how far these lie from where the others see
the point.  An error d of a mark alone shifts T by the noncentrality d' W_ii d (Baarda 1968).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.errors import Severity, Text, phrase
from raybundle.measuring.position import Row, design, joint_of, meeting, rows_of
from raybundle.measuring.session import Session
from raybundle.measuring.state import State
from raybundle.measuring.views import View, seen_in, view
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.statistics import chi_square_limit, detectable_noncentrality

LEVEL = 0.01
"""Significance of the tests of all points of an adjustment together (Bonferroni): with the alarms of clicks at
`CLICK_SIGMAS`, a clean set has one in fewer than one of twenty."""
CLICK_SIGMAS = 4.0
"""Distance of a mark from where the others see its point, in standard deviations, from which on it is reported at once:
by chance one of 3 000 (chi-square, two degrees of freedom)."""
CLICK_LEVEL = float(np.exp(-(CLICK_SIGMAS**2) / 2))
"""The same as a probability: significance of the test of all marks of a point at a click."""
MOST_WRONG = 3
"""Marks of a point that may be wrong together."""
LARGE_SIGMAS = 10.0
"""Error of a mark [its standard deviations] that shows with the probability `POWER`, else the mark is untested: of a
hand of 0.5 px an error of 5 px."""
POWER = 0.99
MOST_MARKS = 24
"""Marks of a point, those with the largest test values, among which the wrong ones are looked for."""
STARTS = 20
"""Pairs of rays from which a point begins that not all rays place."""
CLOSE_PX = 3.0
"""Distance of all marks from where their rays meet within which the linear model holds."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PointTest:
    """What the marks of a point show of each other."""

    point: str
    images: tuple[str, ...]
    """in which it is marked"""
    square: float
    """T"""
    limit: float
    distance_px: dict[str, float]
    """image -> distance of its mark from where the others see the point"""
    sigmas: dict[str, float]
    """the same in standard deviations; 0 where nothing controls the mark"""
    unseen_px: dict[str, float]
    """image -> error of its mark that remains undetected with the probability 1 - POWER, in the worst direction"""
    untested: tuple[str, ...]
    """images with marks that may be wrong by `LARGE_SIGMAS` and more without being detected"""
    wrong: tuple[str, ...] = ()
    """images with wrong marks: the others agree, and no other few explain the contradiction"""
    suspects: tuple[str, ...] = ()
    """where it cannot be determined which are wrong: images, the likeliest first"""
    shift: float = 0.0
    """how far the point moves without the wrong marks, at most without one of the suspects [length unit]"""

    @property
    def contradicts(self) -> bool:
        """Whether some mark is wrong."""
        return self.square > self.limit

    @property
    def look(self) -> tuple[str, ...]:
        """Images to look at again, the likeliest first."""
        return self.wrong or self.suspects


@dataclass(slots=True)
class _Marks:
    """The linear model of a point's marks."""

    views: list[View]
    e: Array
    """(2 n,)"""
    B: Array
    """(2 n, 3)"""
    S: Array
    """(2 n, 2 n)"""
    W: Array = field(init=False)
    w: Array = field(init=False)

    def __post_init__(self) -> None:
        P = np.linalg.inv(self.S)
        PB = P @ self.B
        self.W = P - PB @ np.linalg.solve(self.B.T @ PB, PB.T)
        self.w = self.W @ self.e

    @property
    def square(self) -> float:
        return float(self.e @ self.w)

    def without(self, marks: Sequence[int]) -> float:
        """T of the others."""
        at = _rows(marks)
        return self.square - float(self.w[at] @ np.linalg.lstsq(self.W[np.ix_(at, at)], self.w[at], rcond=1e-9)[0])

    def off(self, marks: Sequence[int], mark: int) -> tuple[float, float]:
        """How far one of some marks lies from where all but these see the point: [px], and in standard deviations."""
        at = _rows(marks)
        C = np.linalg.pinv(self.W[np.ix_(at, at)], rcond=1e-9, hermitian=True)
        own = slice(2 * marks.index(mark), 2 * marks.index(mark) + 2)
        d = (C @ self.w[at])[own]
        square = d @ np.linalg.pinv(C[own, own], rcond=1e-9, hermitian=True) @ d
        return float(np.linalg.norm(d)), float(np.sqrt(max(square, 0.0)))

    def coordinates(self, marks: Sequence[int] = ()) -> Array:
        """(3,) of the point without some marks, from where it is linearised."""
        keep = np.setdiff1d(np.arange(len(self.e)), _rows(marks))
        P = np.linalg.inv(self.S[np.ix_(keep, keep)])
        N = self.B[keep].T @ P @ self.B[keep]
        return np.linalg.solve(N, self.B[keep].T @ P @ self.e[keep])


def point_test(session: Session, point: str, rows: Sequence[Row], *, level: float, variance: float
) -> PointTest | None:  # fmt: skip
    """The marks of a point against each other; None without covariances, and where fewer than two rays meet.

    level     significance of the test of the point
    variance  factor of the covariances of marks and orientations, of `variance_without`
    """
    n = len(rows)
    model = _model(session, rows, variance) if n > 1 else None
    if model is None:
        return None
    names = [session.block.images.ids[r.image] for r in rows]
    limits = {k: chi_square_limit(level, 2 * k - 3) for k in range(2, n + 1)}
    noncentrality = detectable_noncentrality(level, 2 * n - 3, POWER)
    distance, sigmas, unseen, untested = dict[str, float](), dict[str, float](), dict[str, float](), list[str]()
    for k, name in enumerate(names):
        at = _rows([k])
        own = model.W[np.ix_(at, at)]
        size = np.linalg.eigvalsh(own)
        distance[name], sigmas[name] = model.off([k], k)
        unseen[name] = float(np.sqrt(noncentrality / size[0])) if size[0] > 1e-9 * size[1] else np.inf
        if unseen[name] > LARGE_SIGMAS * np.sqrt(np.linalg.eigvalsh(rows[k].covariance)[1]):
            untested.append(name)
    found = PointTest(
        point=point, images=tuple(names), square=model.square, limit=limits[n], distance_px=distance, sigmas=sigmas,
        unseen_px=unseen, untested=tuple(untested),
    )  # fmt: skip
    return found if not found.contradicts else _explained(found, model, names, limits)


def _explained(found: PointTest, model: _Marks, names: Sequence[str], limits: dict[int, float]) -> PointTest:
    """Which marks are wrong: those without which the others fit, if these are three or more and nothing else does."""
    n = len(names)
    if n == 2:
        return _because(found, (), tuple(names), float("inf"))
    by_size = sorted(range(n), key=lambda k: -found.sigmas[names[k]])[:MOST_MARKS]
    fits = [
        (frozenset(s), square)
        for k in range(1, min(MOST_WRONG, n - 2) + 1)
        for s in combinations(by_size, k)
        if (square := model.without(s)) <= limits[n - k]
    ]
    least = min(fits, key=lambda f: (len(f[0]), f[1]))[0] if fits else frozenset[int]()
    if least and n - len(least) > 2 and all(least <= s for s, _ in fits):
        marks = sorted(least)
        seen = {names[k]: model.off(marks, k) for k in marks}
        found = replace(
            found, distance_px=found.distance_px | {i: d for i, (d, _) in seen.items()},
            sigmas=found.sigmas | {i: s for i, (_, s) in seen.items()},
        )  # fmt: skip
        return _because(found, tuple(seen), (), _apart(model, [marks]))
    likely = sorted(range(n), key=lambda k: model.without([k]))
    return _because(found, (), tuple(names[k] for k in likely), _apart(model, [[k] for k in likely]))


def _because(found: PointTest, wrong: tuple[str, ...], suspects: tuple[str, ...], shift: float) -> PointTest:
    return replace(found, wrong=wrong, suspects=suspects, shift=shift)


def _apart(model: _Marks, sets: Sequence[Sequence[int]]) -> float:
    """How far the point moves at most without one of some sets of marks."""
    whole = model.coordinates()
    return max(float(np.linalg.norm(model.coordinates(s) - whole)) for s in sets)


def mark_verdict(session: Session, state: State, point: str, image: str) -> Text | None:
    """What is to be stated of a mark that was just put: how far it lies from where the others see its point.

    image   id of its image
    returns a warning of the mark that is beyond `CLICK_SIGMAS`, or that contradicts; None where nothing tests it yet
    """
    test = point_test_of(session, state, point)
    if test is None or image not in test.images:
        return None
    off = test.look or ((image,) if test.sigmas[image] > CLICK_SIGMAS else ())
    at = image if not off or (image in off and not test.wrong) else off[0]
    code = "mark.off" if off else "mark.open" if image in test.untested else "mark.fits"
    text = phrase(
        code, point=point, image=at, distance_px=test.distance_px[at], sigmas=test.sigmas[at], images=off or (image,),
        n=len(test.images) - 1,
    )  # fmt: skip
    return Text.of(replace(text.message, severity=Severity.WARNING)) if off else text


def point_test_of(session: Session, state: State, point: str) -> PointTest | None:
    """The test of a point with all that is marked of it; None where that is too little."""
    rows = rows_of(session, state, point)
    if len(rows) < 2:
        return None
    variance = variance_without(session.adjustment, frozenset(p for _, p in state.marks))
    return point_test(session, point, rows, level=CLICK_LEVEL, variance=variance)


def off_images(test: PointTest | None) -> tuple[str, ...]:
    """Images with marks that are to be shown as mistaken: those that are, or may be, or lie too far from the others."""
    if test is None:
        return ()
    return test.look or tuple(i for i, s in test.sigmas.items() if s > CLICK_SIGMAS)


def variance_without(adjustment: Adjustment | None, marked: frozenset[str]) -> float:
    """The variance factor of an adjustment without its points marked by hand: their errors do not count in it.

    1 where too little is left that determines it.
    """
    if adjustment is None:
        return 1.0
    o, s = adjustment.given.observations, adjustment.image_observations
    hand = np.array([name in marked for name in adjustment.given.points.ids], bool)
    rows = np.flatnonzero(hand[o.point] & s.used)
    count = np.bincount(o.point[rows], minlength=1)
    redundancy = adjustment.redundancy - int((2 * count - 3)[count > 1].sum())
    if redundancy < ENOUGH:
        return 1.0
    xx, yy, xy = o.cov_px2[rows].T
    x, y = np.nan_to_num(s.residuals_px[rows]).T
    square = float(((yy * x * x - 2 * xy * x * y + xx * y * y) / (xx * yy - xy * xy)).sum())
    return max(adjustment.variance_factor * adjustment.redundancy - square, 0.0) / redundancy


ENOUGH = 30
"""Redundancy from which on a variance factor is known to a quarter."""


def _rows(marks: Sequence[int]) -> Index:
    return np.array([2 * k + axis for k in marks for axis in (0, 1)], np.int32)


def _model(session: Session, rows: Sequence[Row], variance: float) -> _Marks | None:
    images = [r.image for r in rows]
    C = joint_of(session, images)
    xyz = _start(session, rows)
    if C is None or xyz is None:
        return None
    views = [view(session, r.image, xyz) for r in rows]
    seen = [v for v in views if v is not None]
    if len(seen) < len(rows):
        return None
    H = np.concatenate([design(session, images, v)[:, 3:] for v in seen])
    S = (variance / session.variance) * H @ C @ H.T
    for k, r in enumerate(rows):
        S[2 * k : 2 * k + 2, 2 * k : 2 * k + 2] += max(variance, 1.0) * r.covariance
    e = np.concatenate([r.xy - v.xy for r, v in zip(rows, seen, strict=True)])
    B = np.concatenate([v.by_point for v in seen])
    return None if np.linalg.cond(B) > 1e7 else _Marks(seen, e, B, S)


def _start(session: Session, rows: Sequence[Row]) -> Array | None:
    """Where two rays meet that most others agree with, as far as each can disagree."""
    images, xy = np.array([r.image for r in rows], np.int64), np.array([r.xy for r in rows])
    best, found = np.inf, None
    pairs = list(combinations(rows, 2))
    for pair in [rows, *pairs[:: max(1, len(pairs) // STARTS)]]:
        xyz = meeting(session, pair)
        if xyz is None:
            continue
        away = np.linalg.norm(np.nan_to_num(seen_in(session, images, xyz), nan=np.inf) - xy, axis=1)
        cost = float(np.sort(away)[: (len(away) + 3) // 2].sum())
        if cost < best:
            best, found = cost, xyz
        if pair is rows and away.max() < CLOSE_PX:
            break
    return found
