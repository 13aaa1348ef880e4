"""Differences of points between epochs as a linear model: their weights, what moved eliminated, tests of hypotheses.

d (3 n k) = B t + displacements, with covariance Q: B t is the datum of each later epoch.  Weights of all differences
are formed once; what moved is eliminated from them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from raybundle.errors import InputError
from raybundle.metrology.areas import AreaTest, Hypothesis, sums_of
from raybundle.metrology.point_set import PointSet, datum_directions
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.statistics import fisher_tail
from raybundle.numerics.transform import SimilarityTransform, similarity

LEAST = 4
"""Common points that a datum and a test need: three carry the datum, one can be tested against them"""
POWER = 0.8
"""Probability with which the smallest detectable displacement is found"""
TOGETHER = 128
"""Rows of which squares are formed together"""
CHANGES = 100
"""Points taken out or put back from which on the weights are factored again: rounding adds up"""
WORTH = 4
"""Rows taken out or put back that take as long as so many that are factored"""
SINGULAR = 1e-10
"""Eigenvalue, as a share of the largest, below which a direction weighs nothing"""


def model_of(
    first: PointSet, later: Sequence[PointSet], stayed: Mask, *, scale: bool, joint: Array | None = None
) -> Model:
    """Of epochs, turned into the axes of the first by the points that stayed."""
    n, k = len(first.ids), len(later)
    axes = [axes_onto(e, first, stayed, scale=scale) for e in later]
    here = [e.moved(by) for e, by in zip(later, axes, strict=True)]
    G = datum_directions(first.xyz, scale=scale).reshape(3 * n, -1)
    if joint is None:
        Q = np.kron(np.ones((k, k)), first.covariance)
        for j, e in enumerate(here):
            s = slice(3 * n * j, 3 * n * (j + 1))
            Q[s, s] += e.covariance
    else:
        Q = _of_differences(joint, [t.scale * t.rotation for t in axes])
    freedom = [e.freedom for e in (first, *later)]
    if joint is not None:  # one variance factor, of one adjustment
        freedom = freedom[:1]
    return Model.of(
        np.concatenate([(e.xyz - first.xyz).ravel() for e in here]), Q, np.kron(np.eye(k), G), n,
        float("inf") if np.isinf(freedom).any() else float(sum(freedom)),
    )  # fmt: skip


def axes_onto(e: PointSet, first: PointSet, by: Mask, *, scale: bool) -> SimilarityTransform:
    """Of an epoch onto the first, by some points, weighted by their mean variances."""
    variance = np.trace(first.own + e.own, axis1=1, axis2=2)
    weights = 1 / np.maximum(variance, 1e-3 * np.median(variance))
    fit = similarity(e.xyz[by], first.xyz[by], weights[by] / weights[by].max(), scale=None if scale else 1.0)
    return SimilarityTransform(scale=fit.scale, rotation=fit.rotation, translation=fit.translation)


def _of_differences(joint: Array, turns: Sequence[Array]) -> Array:
    """Covariance (3 n k, 3 n k) of the differences of later epochs against the first, each turned into its axes."""
    e, u = joint.shape[:2]
    A = np.stack([np.eye(3), *turns])
    C = joint.reshape(e, u // 3, 3, e, u // 3, 3)
    C = np.einsum("aij,apjbqk,blk->apibql", A, C, A, optimize=True).reshape(e, u, e, u)
    Q = C[1:, :, 1:] - C[1:, :, :1] - C[:1, :, 1:] + C[:1, :, :1]
    Q = Q.reshape((e - 1) * u, -1)
    return (Q + Q.T) / 2


class Factor(NamedTuple):
    """By how much variances are larger than those of the adjustment, and the freedom with which that is known."""

    variance: float
    freedom: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Model:
    """Differences d (3 n k) = datum B t + displacements, with covariance Q; the datum of Q itself is of no account."""

    d: Array
    Q: Array
    B: Array
    weights: Array
    """of the differences of all points, once the datum is free: singular by the datum"""
    misfit: Array
    """weights d"""
    points: int
    freedom: float
    last: list[Stayed] = field(default_factory=list["Stayed"], compare=False)
    """Of the last tests of points"""

    @classmethod
    def of(cls, d: Array, Q: Array, B: Array, points: int, freedom: float) -> Model:
        """Of differences; raises InputError where their covariance is singular beyond the datum."""
        # what lies in the datum of Q is filled up: B t takes it away again
        fill = np.trace(Q) / max(float(np.trace(B @ B.T)), 1e-300)
        root = _root(Q + fill * B @ B.T)
        W = root.T @ root
        WB = W @ B
        W = W - WB @ np.linalg.solve(B.T @ WB, WB.T)
        W = (W + W.T) / 2
        return cls(d=d, Q=Q, B=B, weights=W, misfit=W @ d, points=points, freedom=freedom)

    @property
    def later(self) -> int:
        """Number of epochs after the first."""
        return len(self.d) // (3 * self.points)

    def rows(self, points: Index) -> Index:
        """(len(points), 3 later) rows of points."""
        at = (3 * points[:, None] + np.arange(3)[None])[:, None, :]
        return (at + 3 * self.points * np.arange(self.later)[None, :, None]).reshape(len(points), 3 * self.later)

    def stayed(self, moved: Mask) -> Stayed:
        """The points that have not moved, those that moved free; raises InputError where they test nothing."""
        points = np.flatnonzero(moved)
        each = self.rows(np.arange(self.points))
        rows = each[points].ravel()
        inverse = _root(self.weights[np.ix_(rows, rows)])
        taken = inverse @ self.weights[rows]
        own = self.weights[each[:, :, None], each[:, None, :]]
        own -= sum(_squares(part[:, each]) for part in np.array_split(taken, len(taken) // TOGETHER + 1))
        return Stayed(
            model=self, moved=moved.copy(), points=points, rows=rows, inverse=inverse, taken=taken, own=own,
            free=_squares(inverse.reshape(len(rows), len(points), each.shape[1])), size=inverse @ self.misfit[rows],
        )  # fmt: skip

    def near(self, moved: Mask) -> Stayed:
        """As `stayed`; where few points are others than in the last tests, by a change of these."""
        if not self.last or self.last[0].changes >= CHANGES:
            return self.stayed(moved)
        last = self.last[0]
        out, back = np.flatnonzero(moved & ~last.moved), np.flatnonzero(last.moved & ~moved)
        if WORTH * 3 * self.later * (len(out) + len(back)) > len(last.rows):
            return self.stayed(moved)
        last = last.without(back) if len(back) else last
        return last.beside(out) if len(out) else last

    def whole(self, moved: Mask) -> tuple[float, float]:
        """Global test of the points that have not moved: F and its probability."""
        freedom = len(self.d) - 3 * self.later * int(moved.sum()) - self.B.shape[1]
        rest = self.stayed(moved).square_sum
        F = rest / max(freedom, 1)
        return F, fisher_tail(F, freedom, self.freedom)

    def tests(self, moved: Mask) -> tuple[Array, Array]:
        """(n,) F of each point against those that stayed, without it; and its probability."""
        self.last[:] = [self.near(moved)]
        return self.tested(*self.last[0].compared())

    def tested(self, u: Array, S: Array) -> tuple[Array, Array]:
        """F (h,) of hypotheses by their vectors (h, 3 k) and covariances or weights, and their probabilities."""
        from scipy.special import chdtrc, fdtrc

        dof = 3 * self.later
        F = _squared(u, S) / dof
        return F, np.asarray(chdtrc(dof, F * dof) if np.isinf(self.freedom) else fdtrc(dof, self.freedom, F))

    def together(self, family: Family, moved: Mask) -> Array:
        """(h,) probability of the mean displacement of the points of areas that have not moved; NaN: too few."""
        found = np.full(len(family.areas), np.nan)
        inside = family.sums @ (~moved)
        some = np.flatnonzero((inside > 1) & ((~moved).sum() - inside >= max(LEAST, self.points // 3)))
        if len(some):
            found[some] = self.of_areas(family, some, moved)[1]
        return found

    def of_areas(self, family: Family, some: Index, moved: Mask) -> tuple[Array, Array]:
        """F (h,) of the mean displacements of the points of areas that have not moved, and their probabilities."""
        from scipy.special import fdtrc

        u, S = self.near(moved).shifts(family, some)
        F, _ = self.tested(u / np.sqrt(family.factors[some])[:, None], S)
        unknown = np.maximum(1 / family.freedom[some] + 1 / self.freedom, 1e-9)  # of chi-square: none
        return F, np.asarray(fdtrc(3 * self.later, 1 / unknown, F))

    def patch_sizes(
        self, family: Family, moved: Mask, alpha: float
    ) -> tuple[tuple[int, float, float], ...]:  # fmt: skip
        """Of patches by their sizes, the medians of their smallest detectable mean displacements, before and after."""
        found: list[tuple[int, float, float]] = []
        sizes = np.array([0 if a.given else len(a.points) for a in family.areas])
        for size in np.unique(sizes[sizes > 0]).tolist():
            every = np.flatnonzero(sizes == size)
            least = [
                [
                    self._least(S / family.factors[every[0]], alpha, float(family.freedom[every[0]]))
                    for S in self.stayed(m).shifts(family, every)[1]
                ]
                for m in (np.zeros(self.points, bool), moved)
            ]
            found.append((size, float(np.median(least[0])), float(np.median(least[1]))))
        return tuple(found)

    def area(self, family: Family, which: int, moved: Mask, level: float) -> AreaTest:
        """The test of an area as a whole: its mean displacement against all else that stayed.

        level  probability below which its points did not move alike
        """
        area, limit, factor = family.areas[which], float(family.limits[which]), float(family.factors[which])
        none, one, freedom = np.zeros(self.points, bool), np.array([which]), float(family.freedom[which])
        back = moved.copy()
        back[area.points] = False
        (u,), (S,) = (x / factor for x in self.stayed(back).shifts(family, one))
        F, p = self.of_areas(family, one, back)
        C = np.linalg.pinv(S, rcond=1e-10, hermitian=True)
        before = self.stayed(none).shifts(family, one)[1][0] / factor
        d, uniform = self._uniform(area.points, moved, family.single)
        length = np.linalg.norm(d.reshape(-1, self.later, 3), axis=2)
        return AreaTest(
            name=area.name, given=area.given, points=area.points, displacement=(C @ u).reshape(self.later, 3),
            joint=C.reshape(self.later, 3, self.later, 3), F=float(F[0]), p_value=float(p[0]),
            moved=bool(p[0] < limit), detectable=self._least(S, limit, freedom),
            detectable_before=self._least(before, limit, freedom), p_uniform=uniform, uneven=uniform < level,
            shortest=length.min(axis=0), longest=length.max(axis=0),
        )  # fmt: skip

    def _uniform(self, points: Index, moved: Mask, each: Factor) -> tuple[Array, float]:
        """Displacements (m, 3 k) of points, and the probability that they have one in common."""
        d, C = self.stayed(moved | np.isin(np.arange(self.points), points)).displaced(points)
        freedom = d.size - d.shape[1]
        if freedom == 0:
            return d, 1.0
        P = np.linalg.pinv(C.reshape(d.size, -1), rcond=1e-10, hermitian=True)
        Z = np.tile(np.eye(d.shape[1]), (len(d), 1))
        v = d.ravel() - Z @ np.linalg.solve(Z.T @ P @ Z, Z.T @ (P @ d.ravel()))
        unknown = max(1 / each.freedom + 1 / self.freedom, 1e-9)
        return d, fisher_tail(max(float(v @ P @ v), 0.0) / freedom / each.variance, freedom, 1 / unknown)

    def agreement(self, points: Index, moved: Mask, each: Factor) -> Array:
        """(m,) of points that moved, two or more, the probability of each to share the mean displacement of the rest.

        each  of the variances of single points
        """
        from scipy.special import fdtrc

        d, C = self.stayed(moved).displaced(points)
        m, dof = d.shape
        # of each its displacement less the mean of the others: (m d_i - sum) / (m - 1)
        u = (m * d - d.sum(axis=0)) / (m - 1)
        row, at = C.sum(axis=2), np.arange(m)
        S = m**2 * C[at, :, at, :] - m * (row + row.swapaxes(1, 2)) + row.sum(axis=0)
        F, _ = self.tested(u / np.sqrt(each.variance), S / (m - 1) ** 2)
        return np.asarray(fdtrc(dof, 1 / max(1 / each.freedom + 1 / self.freedom, 1e-9), F))

    def displacements(self, moved: Mask) -> tuple[Array, Array]:
        """(k, n, 3) displacements in the datum of points that stayed, and their joint covariance (k, n, 3, k, n, 3)."""
        rows = self.rows(np.flatnonzero(~moved)).ravel()
        B, Q = self.B, self.Q
        Bs = B[rows]
        # the datum by the points that stayed, all alike: displacements of the others refer to these
        A = np.linalg.pinv(Bs)
        X = A @ Q[rows]
        C = Q - B @ X - X.T @ B.T + B @ (X[:, rows] @ A.T) @ B.T
        d = (self.d - B @ (A @ self.d[rows])).reshape(self.later, self.points, 3)
        return d, C.reshape(self.later, self.points, 3, self.later, self.points, 3)

    def detectable(self, moved: Mask, alpha: float) -> Array:
        """(n,) smallest displacement of the last epoch that is found [m], in the direction known worst."""
        _, S = self.stayed(moved).compared()
        S[moved] = np.linalg.inv(S[moved])
        return np.array([self._least(each, alpha) for each in S])

    def covariances(self, moved: Mask) -> Array:
        """(n, 3 k, 3 k) of the displacement of each point against those that stayed."""
        _, S = self.stayed(moved).compared()
        S[~moved] = np.linalg.pinv(S[~moved], rcond=1e-10, hermitian=True)
        return S

    def _least(self, information: Array, alpha: float, freedom: float = np.inf) -> float:
        """Length of the smallest displacement of the last epoch that is found [m], by the weights (3 k, 3 k) of one."""
        from scipy.special import chdtri, chndtrinc, fdtri

        dof = 3 * self.later
        shift2 = float(chndtrinc(float(chdtri(dof, alpha)), dof, 1 - POWER))
        if np.isfinite(freedom):  # the limit of F against that of a known variance
            shift2 *= dof * float(fdtri(dof, freedom, 1 - alpha)) / float(chdtri(dof, alpha))
        least = float(np.linalg.eigvalsh(information[-3:, -3:])[0])
        return float(np.sqrt(shift2 / least)) if least > 0 else float("inf")


@dataclass(frozen=True, slots=True, kw_only=True)
class Stayed:
    """Points that stayed, with displacements of the others as unknowns of their own."""

    model: Model
    moved: Mask
    points: Index
    """that moved, in the order in which they were taken out"""
    rows: Index
    """of these"""
    inverse: Array
    """inverse' inverse is the covariance of their displacements"""
    taken: Array
    """(rows, 3 n k) what they take from the weights of all: W - taken' taken is what the others weigh without them"""
    own: Array
    """(n, 3 k, 3 k) of each point its part of these"""
    free: Array
    """(points, 3 k, 3 k) of each point that moved its part of the covariance"""
    size: Array
    """(rows,) of which the squares are what those that moved take from the square sum"""
    changes: int = 0
    """Points taken out and put back since the weights were factored"""

    @property
    def square_sum(self) -> float:
        """Weighted sum of squares of the differences of those that stayed."""
        return max(float(self.model.d @ self.model.misfit) - float(self.size @ self.size), 0.0)

    @property
    def misfit(self) -> Array:
        """(3 n k) weighted differences without those that moved; 0 of these."""
        return self.model.misfit - self.taken.T @ self.size

    def beside(self, points: Index) -> Stayed:
        """With more points that moved."""
        m, r = self.model, len(self.rows)
        mine, q = m.rows(points).ravel(), 3 * m.later
        half = self.taken[:, mine]
        root = _root(m.weights[np.ix_(mine, mine)] - half.T @ half)
        taken = root @ (m.weights[mine] - half.T @ self.taken)
        inverse = np.zeros((r + len(mine), r + len(mine)))
        inverse[:r, :r], inverse[r:, :r], inverse[r:, r:] = self.inverse, -(root @ (half.T @ self.inverse)), root
        free = np.concatenate([self.free, np.zeros((len(points), q, q))])
        moved = self.moved.copy()
        moved[points] = True
        return replace(
            self, moved=moved, points=np.append(self.points, points), rows=np.append(self.rows, mine), inverse=inverse,
            taken=np.concatenate([self.taken, taken]), own=self.own - _squares(taken[:, m.rows(np.arange(m.points))]),
            free=free + _squares(inverse[r:].reshape(len(mine), -1, q)), changes=self.changes + 1,
            size=np.append(self.size, root @ (m.misfit[mine] - half.T @ self.size)),
        )  # fmt: skip

    def without(self, points: Index) -> Stayed:
        """With these less.

        Any rotation of the rows of `inverse` and `taken` leaves their squares: that which leaves but as many rows of
        `inverse` with something of the points' columns as these are (a block reflection).
        """
        m, gone = self.model, np.isin(self.points, points)
        mine, kept = (np.flatnonzero(np.repeat(g, 3 * m.later)) for g in (gone, ~gone))
        q = len(mine)
        U = np.linalg.qr(self.inverse[:, mine])[0]
        left, values, right = np.linalg.svd(U[:q])
        U[:q] += left @ right
        middle = np.linalg.inv(np.eye(q) + right.T @ (values[:, None] * right))

        def turned(a: Array) -> Array:
            return a - U @ (middle @ (U.T @ a))

        inverse, taken, size = turned(self.inverse), turned(self.taken), turned(self.size)
        moved = self.moved.copy()
        moved[points] = False
        free = self.free - _squares(inverse[:q].reshape(q, -1, 3 * m.later))
        return replace(
            self, moved=moved, points=self.points[~gone], rows=self.rows[kept], inverse=inverse[q:, kept],
            taken=taken[q:], own=self.own + _squares(taken[:q, m.rows(np.arange(m.points))]),
            free=free[~gone], size=size[q:], changes=self.changes + 1,
        )  # fmt: skip

    def weights(self, rows: Index, others: Index) -> Array:
        """What differences weigh without those that moved."""
        return self.model.weights[np.ix_(rows, others)] - self.taken[:, rows].T @ self.taken[:, others]

    def compared(self) -> tuple[Array, Array]:
        """Of each point a vector (n, 3 k) and its covariance.

        Of points that moved how far they lie from where those that stayed have them; of those that stayed what they
        weigh in the misfit.
        """
        m = self.model
        u, S = self.misfit[m.rows(np.arange(m.points))], self.own.copy()
        # the displacements of points that moved, by least squares
        u[self.points] = (self.inverse.T @ self.size).reshape(-1, u.shape[1])
        S[self.points] = self.free
        return u, S

    def displaced(self, points: Index) -> tuple[Array, Array]:
        """(m, 3 k) displacements of points that moved, and their joint covariance (m, 3 k, m, 3 k)."""
        m = self.model
        size = 3 * m.later
        own = np.searchsorted(np.flatnonzero(self.moved), points)
        mine = self.inverse[:, (size * own[:, None] + np.arange(size)).ravel()]
        d = mine.T @ (self.inverse @ m.misfit[self.rows])
        return d.reshape(-1, size), (mine.T @ mine).reshape(len(points), size, len(points), size)

    def shifts(self, family: Family, areas: Index) -> tuple[Array, Array]:
        """What common displacements (h, 3 k) of the points of areas weigh in the misfit, and their weights.

        Of points that stayed: those that moved have displacements of their own, and weigh nothing.
        """
        Z = family.sums[areas]
        some = np.flatnonzero(Z.any(axis=0))
        each, Z = self.model.rows(some), Z[:, some]
        u = Z @ self.misfit[each]
        S = family.weights(self.model)[areas]
        for part in np.array_split(self.taken, len(self.taken) // TOGETHER + 1):
            S = S - _squares(np.einsum("hn,rni->rhi", Z, part[:, each], optimize=True))
        return u, S


@dataclass(frozen=True, slots=True, kw_only=True)
class Family:
    """Areas that are tested, each with its limit."""

    areas: tuple[Hypothesis, ...]
    sums: Array
    """(h, n)"""
    limits: Array
    of_model: list[tuple[Model, Array]]
    """the last model and the weights in it"""
    factors: Array
    """(h,) by which variances of their mean displacements are larger than those of the adjustment"""
    freedom: Array
    """(h,) with which these are known"""
    single: Factor
    """of points alone"""

    @classmethod
    def of(
        cls, areas: Sequence[Hypothesis], points: int, limits: Sequence[float],
        factors: Mapping[int, Factor] | None = None,
    ) -> Family:  # fmt: skip
        """Of areas; factors: of the variances of means of so many points, 1 without."""
        size = [len(a.points) for a in areas]
        by = sorted((factors or {1: Factor(1.0, np.inf)}).items())
        at = [k for k, _ in by]
        return cls(
            areas=tuple(areas), sums=sums_of(areas, points), limits=np.array(limits), of_model=[],
            factors=np.interp(size, at, [f.variance for _, f in by]),
            freedom=1 / np.maximum(np.interp(size, at, [1 / f.freedom for _, f in by]), 1e-9), single=by[0][1],
        )  # fmt: skip

    def weights(self, model: Model) -> Array:
        """(h, 3 k, 3 k) of common displacements, if no point moved."""
        if not self.of_model or self.of_model[0][0] is not model:
            each, Z = model.rows(np.arange(model.points)), self.sums
            found = np.zeros((len(Z), each.shape[1], each.shape[1]))
            for a, b in zip(*np.triu_indices(each.shape[1]), strict=True):
                some = Z @ model.weights[np.ix_(each[:, a], each[:, b])]
                found[:, a, b] = found[:, b, a] = np.einsum("hn,hn->h", some, Z)
            self.of_model[:] = [(model, found)]
        return self.of_model[0][1]


def _root(A: Array) -> Array:
    """R of the inverse R' R of a positive definite matrix; raises InputError for another one."""
    from scipy.linalg import get_lapack_funcs

    if not len(A):
        return A
    potrf, trtri = get_lapack_funcs(("potrf", "trtri"), (A,))
    L, failed = potrf(A, lower=True, clean=True)
    if failed:
        raise InputError("epochs.covariance_singular")
    return np.ascontiguousarray(trtri(L, lower=True)[0])


def _squares(rows: Array) -> Array:
    """Sums (n, i, i) of squares of rows (r, n, i)."""
    each = rows.transpose(1, 0, 2)
    return each.transpose(0, 2, 1) @ each


def _squared(u: Array, S: Array) -> Array:
    """U' S^-1 u (h,) of vectors (h, i); directions in which S (h, i, i) is singular are left out."""
    n, found = u.shape[1], np.zeros(len(u))
    trace = np.maximum(np.trace(S, axis1=1, axis2=2), 1e-300)
    with np.errstate(invalid="ignore", over="ignore"):
        # the smallest eigenvalue is at least the determinant over what the others can be together
        least = np.linalg.det(S / trace[:, None, None]) * (n - 1.0) ** (n - 1)
    safe = (least > 2 * SINGULAR) & (least < 1)
    found[safe] = np.einsum("hi,hi->h", u[safe], np.linalg.solve(S[safe], u[safe, :, None])[:, :, 0])
    v, P = u[~safe], np.linalg.pinv(S[~safe], rcond=SINGULAR, hermitian=True)
    found[~safe] = np.einsum("hi,hij,hj->h", v, P, v)
    return found
