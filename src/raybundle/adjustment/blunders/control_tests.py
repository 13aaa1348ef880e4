"""Control against all other observations: which points, held or weighted, are wrong, and which may be instead."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import comb, log

import numpy as np
from scipy.special import fdtri

from raybundle.adjustment.evaluation.joint_cofactors import design_rows
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.reliability import rounding
from raybundle.adjustment.statistics.system_state import Work
from raybundle.adjustment.system.assemble import State, System
from raybundle.adjustment.system.normals import SIDES
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import fisher_tail

MOST = 40
"""Points that are tested, those on which the strongest forces act."""
CONTROLLED = 1e-6
"""Share of a direction's information that must show in the residuals for it to be tested.

What is formed as a difference of two cofactors carries some 1e-13 of rounding times the condition of the part.
"""
REFUTED = 0.99
"""Probability beyond which what another point's error leaves unexplained refutes that error: that of `separability`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlTest:
    """The test of one control point, all its coordinates together, against all other observations."""

    point: int
    square: float
    """T, by how much the weighted square sum falls when the point is let go"""
    directions: int
    """k, how many of its directions are controlled"""
    probability: float
    """Of so large an F if the coordinates are right"""
    shift: Array
    """(3,) where the observations want the point, minus given; 0 where no control [object unit]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class WrongPoint:
    """A control point without which the others fit."""

    name: str
    w: float
    """sqrt(T) / sigma0 of its coordinates together, the other wrong ones let go; as |w| of a single observation"""
    limit: float
    """of w, family-wise"""
    square: float
    """T of it alone"""
    shift: Array
    """(3,) where the observations want it, minus given [object unit]"""
    others: tuple[str, ...] = ()
    """control points of which one that is wrong would explain that as well"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Contradiction:
    """What control that does not fit comes from."""

    wrong: tuple[WrongPoint, ...] = ()
    """by w, the largest first; () where nothing contradicts, or no few points explain it"""
    swayed: tuple[str, ...] = ()
    """right ones that fail the test by themselves, because the wrong ones bend the block"""
    unexplained: tuple[str, ...] = ()
    """points that contradict, most first, where errors of few do not explain it, or larger errors of all do as well"""


@dataclass(frozen=True, slots=True, kw_only=True)
class _Joint:
    """All coordinates of the tested points together, scaled to unit information."""

    at: list[Array]
    """of each point, which coordinates are its own"""
    Q: Array
    """(k, k) cofactors of the forces"""
    g: Array
    """(k,) forces"""
    scale: Array
    """(k,) root of the information [1 / object unit]"""
    within: float
    """eigenvalues of Q that are rounding"""


class ControlTests:
    """Forces on the control points of a result and their cofactors, of which the test of any of them is made.

    Let the error of a given coordinate be a further unknown d with the partials H of the whitened observations:
    v = A dx + H d - l.  H is that of the image points and distances where the coordinate is held, -1 / sigma of its own
    observation where it is weighted.  At the solution with d = 0 the force is g = H'v, and its cofactor Q = H'Qvv H =
    H'H - H'A N^-1 A'H.  Letting a set of points go moves them by -Q^-1 g and takes T = g' Q^-1 g from the weighted
    square sum W (Baarda 1968 for one unknown, w = g / sqrt(Q); Teunissen 2000, sec. 4.3, for several).  As sigma0 is
    estimated, and an error of control is in it,

        F = (T / k) / ((W - T) / (r - k))

    is distributed as F(k, r - k) where the coordinates are right; k counts the directions that the others control.
    For an error so large that v is no longer linear in d, T is a first approximation.
    """

    def __init__(self, result: Adjustment, most: int = MOST) -> None:
        """Of the `most` points on which the strongest forces act; of none without statistics."""
        self.result = result
        self.tests = _tests(result)
        self.level = result.options.significance / max(self.tests, 1)
        work = result.handle.work
        usable = work is not None and work.found is not None and result.redundancy >= 2
        seen = _seen(work) if usable and work is not None else []
        self.count = len(seen)
        self._seen = sorted(seen, key=lambda s: -s.least)[:most]

    @cached_property
    def _joint(self) -> _Joint:
        work = self.result.handle.work
        assert work is not None
        assert work.found is not None
        seen = [_with_rows(work, s) for s in self._seen]
        ends = np.cumsum([0, *(len(s.axes) for s in seen)])
        at = [np.arange(a, b) for a, b in pairwise(ends.tolist())]
        Q = np.zeros((ends[-1], ends[-1]))
        for first in range(0, len(seen), SIDES // 3):
            some = slice(first, first + SIDES // 3)
            columns = slice(ends[first], ends[min(some.stop, len(seen))])
            rhs = np.zeros((*work.state.xyz.shape, columns.stop - columns.start))
            for i, s in zip(at[some], seen[some], strict=True):
                rhs[s.point][:, i - columns.start] = s.at_point
            x, y = work.normals.solve(work.state, np.concatenate([s.nodes for s in seen[some]], axis=1), rhs)
            for j, other in zip(at, seen, strict=True):
                Q[j, columns] = -other.nodes.T @ x - other.at_point.T @ y[other.point]
                for i, s in zip(at[some], seen[some], strict=True):
                    Q[np.ix_(j, i)] += s.own if other is s else _shared(other, s)
        scale = np.sqrt(np.concatenate([np.maximum(np.diagonal(s.own), 1e-300) for s in seen]))
        force = np.concatenate([s.force for s in seen])
        within = max(CONTROLLED, rounding(work.normals, work.state, work.found))
        return _Joint(at=at, Q=(Q + Q.T) / 2 / np.outer(scale, scale), g=force / scale, scale=scale, within=within)

    def let_go(self, chosen: Sequence[int]) -> tuple[float, int, Array]:
        """T, k and the shifts (n, 3) of these points, by their position among those that are tested."""
        shift = np.zeros((len(chosen), 3))
        if not chosen:
            return 0.0, 0, shift
        joint = self._joint
        at = np.concatenate([joint.at[i] for i in chosen])
        values, vectors = np.linalg.eigh(joint.Q[np.ix_(at, at)])
        testable = values > joint.within
        along = vectors[:, testable].T @ joint.g[at]
        d = -(vectors[:, testable] @ (along / values[testable])) / joint.scale[at]
        start = 0
        for k, i in enumerate(chosen):
            axes = self._seen[i].axes
            shift[k, axes] = d[start : start + len(axes)]
            start += len(axes)
        return float((along**2 / values[testable]).sum()), int(testable.sum()), shift

    def tail(self, more: float, directions: int, T: float = 0.0, k: int = 0) -> float:
        """Probability that letting more go takes `more` from what is left of W when T in k directions is gone."""
        W, r = self.result.weighted_square_sum, self.result.redundancy - k - directions
        if directions < 1 or r < 1:
            return 1.0
        left = max(W - T - more, 1e-12 * W)
        return fisher_tail((more / directions) / (left / r), directions, r) if left > 0 else 1.0

    def each(self) -> tuple[ControlTest, ...]:
        """The tests of the points one by one, the least probable first."""
        found: list[ControlTest] = []
        for i, s in enumerate(self._seen):
            T, k, shift = self.let_go([i])
            if k and self.result.redundancy > k:
                p = self.tail(T, k)
                found.append(ControlTest(point=s.point, square=T, directions=k, probability=p, shift=shift[0]))
        return tuple(sorted(found, key=lambda t: (t.probability, -t.square)))

    def left_out(self) -> Iterator[tuple[int, Array]]:
        """Each tested point and adjusted minus given (3,) had it, whole, taken no part.

        0 where it has no control, NaN of a point without which one of its directions is open.
        """
        for i, s in enumerate(self._seen):
            _, k, shift = self.let_go([i])
            yield s.point, shift[0] if k == len(s.axes) else np.full(3, np.nan)

    def name(self, i: int) -> str:
        """Name of a tested point."""
        return self.result.given.points.ids[self._seen[i].point]

    @cached_property
    def contradiction(self) -> Contradiction:
        """Which points are wrong: stepwise, as a wrong one bends the block and makes right ones fail the test.

        That point is let go beside which the others contradict least; one that adds nothing beside those let go since
        returns; the end is where no other fails.  Of n points fewer than half may be wrong, or what is left explains
        as little.  Beside them let go, another point j takes the place of i where i, let go as well, adds nothing.
        """
        if not any(s.held for s in self._seen):  # then `least` is T, and nothing needs to be solved where all is right
            p = [self.tail(s.least, len(s.axes)) for s in self._seen if s.least > 0]
            if not p or min(p) > self.level:
                return Contradiction()
        single = [self.tail(T, k) for T, k, _ in (self.let_go([i]) for i in range(len(self._seen)))]
        order = sorted(range(len(single)), key=lambda i: (single[i], -self.let_go([i])[0]))
        failing = [i for i in order if single[i] < self.level]
        if not failing:
            return Contradiction()
        chosen = self._stepwise(max(1, (self.count - 1) // 2))
        if chosen is None or self._all_as_well(chosen):
            return Contradiction(unexplained=tuple(self.name(i) for i in failing))
        T, k, shift = self.let_go(chosen)
        left = max(self.result.weighted_square_sum - T, 1e-12) / (self.result.redundancy - k)
        wrong: list[WrongPoint] = []
        for i, d in zip(chosen, shift, strict=True):
            less, of, _ = self.let_go([j for j in chosen if j != i])
            wrong.append(
                WrongPoint(
                    name=self.name(i), w=float(np.sqrt(max(T - less, 0.0) / left)), shift=d, square=self.let_go([i])[0],
                    limit=self._limit(k - of, self.result.redundancy - k), others=self._instead(i, chosen),
                )
            )  # fmt: skip
        taken = {n for p in wrong for n in (p.name, *p.others)}
        return Contradiction(
            wrong=tuple(sorted(wrong, key=lambda p: -p.w)),
            swayed=tuple(self.name(i) for i in failing if self.name(i) not in taken),
        )

    def _limit(self, k: int, r: int) -> float:
        return float(np.sqrt(k * fdtri(k, r, 1 - self.level)))

    def _added(self, i: int, chosen: list[int]) -> tuple[float, float]:
        """Probability and size of what a point takes from W beside those let go."""
        T, k, _ = self.let_go(chosen)
        both, of, _ = self.let_go([*chosen, i])
        return self.tail(both - T, of - k, T, k), both - T

    def _stepwise(self, most: int) -> list[int] | None:
        """Positions of the points that explain it; None where more than `most` were needed."""
        chosen: list[int] = []
        for _ in range(2 * len(self._seen)):
            tried = [(*self._added(i, chosen), i) for i in range(len(self._seen)) if i not in chosen]
            p, _, best = min(tried, key=lambda t: (t[0], -t[1]), default=(1.0, 0.0, -1))
            if p > self.level:
                return chosen
            chosen.append(best)
            for i in chosen[:-1]:
                rest = [j for j in chosen if j != i]
                if self._added(i, rest)[0] > self.level:
                    chosen = rest
            if len(chosen) > most:
                return None
        return chosen

    def _instead(self, i: int, chosen: list[int]) -> tuple[str, ...]:
        """Points that, wrong in the place of i, would explain it as well."""
        rest = [j for j in chosen if j != i]
        outside = [j for j in range(len(self._seen)) if j not in chosen]
        return tuple(self.name(j) for j in outside if self._added(i, [*rest, j])[0] > 1 - REFUTED)

    def _all_as_well(self, chosen: list[int]) -> bool:
        """Whether a larger standard deviation of all of them is more likely than gross errors of these.

        With f times the standard deviation, T of all in k directions is f^2 chi-square: -2 ln L falls by
        T - k - k ln (T / k) (T over the variance that the other observations have by themselves), for one parameter;
        with the chosen ones let go it falls by their T, for as many parameters as directions, chosen among all.  A
        parameter costs ln k (Schwarz 1978).
        """
        T, k, _ = self.let_go(range(len(self._seen)))
        few, of, _ = self.let_go(chosen)
        freedom = self.result.redundancy - k
        if k <= of or freedom < 1:
            return False
        variance = max(self.result.weighted_square_sum - T, 1e-12 * T) / freedom
        scaled = T / variance - k - k * np.log(T / variance / k) - np.log(k)
        choices = 2 * log(comb(self.count, len(chosen)))  # an integer beyond 2^63 is none for NumPy
        return bool(few / variance - of * np.log(k) - choices < scaled)


def control_tests(result: Adjustment) -> tuple[ControlTest, ...]:
    """The tests of the control points one by one, the least probable first; () without statistics or control."""
    return ControlTests(result).each()


def _tests(result: Adjustment) -> int:
    """Number of tests among which a false alarm is to be rare: all of the adjustment."""
    rows = 0 if result.handle.work is None else 2 * len(result.handle.work.system.rows)
    return rows + sum(len(g.ids) for g in result.groups)


@dataclass(slots=True)
class _Seen:
    """A control point, its coordinates that were given, and what they are to the observations."""

    point: int
    axes: Array
    held: bool
    """whether one of them is"""
    rows: Array
    """positions in `System.rows`"""
    H: Array
    """(2 n, 3) whitened partials of its image points by its coordinates"""
    own: Array
    """(k, k) H'H"""
    force: Array
    """(k,) g"""
    distances: dict[int, Array]
    """(k,) partials of distances, by row of the extra observations"""
    least: float
    """T is no less, as far as image points show; T itself where all is weighted"""
    nodes: Array
    """(u, k) of A'H, the unknowns of nodes"""
    at_point: Array
    """(3, k) of A'H, its own coordinates, where they are eliminated"""


def _seen(work: Work) -> list[_Seen]:
    """The control points of a block, forces and information without what distances say."""
    from raybundle.adjustment.system.images_numpy import image_residuals

    system, state = work.system, work.state
    assert work.found is not None
    held = system.control_held & system.points_used[:, None]
    weighted = system.prior & system.points_used[:, None]
    points = np.flatnonzero((held | weighted).any(axis=1))
    v, _ = work.normals.residuals(state)
    o = system.block.observations
    rows = np.flatnonzero(np.isin(o.point[system.rows], points))
    image, point = o.image[system.rows[rows]], o.point[system.rows[rows]]
    partials = image_residuals(system, state, image, point, system.xy_mm[rows])[1][:, :, :3] @ state.rotation[image]
    W = np.zeros((len(rows), 2, 2))
    W[:, 0, 0], W[:, 1, 0], W[:, 1, 1] = system.whiten[rows].T
    partials = W @ partials
    found: list[_Seen] = []
    none = np.zeros((0, 0))
    for p in points.tolist():
        mine = np.flatnonzero(point == p)
        if not len(mine):
            continue
        H = np.where(held[p], partials[mine].reshape(-1, 3), 0.0)
        axes = np.flatnonzero(held[p] | weighted[p])
        own, force = (H.T @ H)[np.ix_(axes, axes)], (H.T @ v[rows[mine]].ravel())[axes]
        least = float(force @ np.linalg.lstsq(own, force, rcond=1e-12)[0])
        a = axes[weighted[p, axes]]
        s = system.block.points.sigma[p, a]
        u = (state.xyz[p, a] + system.shift[a] - system.block.points.xyz[p, a]) / s
        k = np.flatnonzero(weighted[p, axes])
        own[k, k], force[k] = 1 / s**2, -u / s
        if len(a):
            values, vectors = np.linalg.eigh(
                np.eye(len(a)) - work.found.points_minimal[p][np.ix_(a, a)] / np.outer(s, s)
            )
            testable = values > CONTROLLED
            least += float(((vectors[:, testable].T @ u) ** 2 / values[testable]).sum())
        found.append(
            _Seen(
                point=p, axes=axes, held=bool(held[p].any()), rows=rows[mine], H=H, own=own, force=force, distances={},
                least=least, nodes=none, at_point=none,
            )
        )  # fmt: skip
    return found


def _with_rows(work: Work, seen: _Seen) -> _Seen:
    """With A'H, and what distances say of its held coordinates."""
    system, state, normals = work.system, work.state, work.normals
    p, axes = seen.point, seen.axes
    nodes, at_point = np.zeros((int(system.offsets[-1]), len(axes))), np.zeros((3, len(axes)))
    if seen.held:
        by_point, columns, by_node = design_rows(system, state, seen.rows)
        H = seen.H[:, axes].reshape(-1, 2, len(axes))
        some = columns >= 0
        np.add.at(nodes, columns[some], np.einsum("raw,rak->rwk", by_node, H)[some])
        at_point += np.where(system.held[p], 0.0, 1.0)[:, None] * np.einsum("rae,rak->ek", by_point, H)
    is_held = system.control_held[p, axes]
    for r, partial in _distances(system, state, p) if seen.held else ():
        e = normals.extra(state)
        mine = e.row == r
        h = np.where(is_held, partial[axes], 0.0)
        np.add.at(nodes, e.unknown[mine], np.outer(e.value[mine], h))
        seen.own += np.outer(h, h)
        seen.force += h * e.residual[r]
        seen.distances[r] = h
    free = np.flatnonzero(~is_held)
    at_point[axes[free], free] -= 1 / system.block.points.sigma[p, axes[free]] ** 2
    retained = system.point_node[p]
    if retained >= 0:  # its free coordinates are unknowns of a node
        nodes[system.offsets[retained] + np.arange(3)] += at_point * ~system.held[p][:, None]
        at_point = np.zeros_like(at_point)
    seen.nodes, seen.at_point = nodes, at_point
    return seen


def _shared(first: _Seen, second: _Seen) -> Array:
    """H'H of two points, (k, l): by a distance between them."""
    own = np.zeros((len(first.axes), len(second.axes)))
    for r in first.distances.keys() & second.distances.keys():
        own += np.outer(first.distances[r], second.distances[r])
    return own


def _distances(system: System, state: State, point: int) -> list[tuple[int, Array]]:
    """Rows of the extra observations that are distances from a point, and their whitened partials (3,) by it."""
    part = system.extra.of("distance")
    if part is None:
        return []
    found: dict[int, Array] = {}
    for by in part.kind.observed(part.table, part.rows, system.extra.scope, state).partials:
        for k in np.flatnonzero(by.item == point):
            row = found.setdefault(int(by.row[k]), np.zeros(3))
            row[by.component[k]] += by.value[k] / part.rows.sigma[by.row[k]]
    return [(part.start + r, row) for r, row in found.items()]
