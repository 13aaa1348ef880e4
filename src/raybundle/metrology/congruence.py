"""Which points have moved between epochs: the congruence test in one datum of the points that stayed, which it finds.

Pelzer 1971 and Niemeier 1981 test the whole network and take points out of the datum one at a time; Caspary 1987.  Here
the test of a single point is that of a block of coordinates (as data snooping of a blunder of three coordinates): the
global test alone overlooks a point that moved among many that stayed.  Limits are for all points together (Bonferroni).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.errors import InputError
from raybundle.metrology.areas import SMALLEST, AreaTest, Hypothesis, groups_of, patches_of, sums_of
from raybundle.metrology.consensus import stable_starts
from raybundle.metrology.point_set import PointSet, datum_directions
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import cross_matrix
from raybundle.numerics.statistics import fisher_tail
from raybundle.numerics.transform import SimilarityTransform, robust_similarity, similarity

LEAST = 4
"""Common points that a datum and a test need: three carry the datum, one can be tested against them"""
SIGNIFICANCE = 0.05
"""Probability that some point is called moved where none did"""
POWER = 0.8
"""Probability with which the smallest detectable displacement is found"""
AGREE = 5.0
"""Standard deviations by which points may differ in the search for those that stayed, before their datum is known"""
CONTRADICTED = 0.001
"""Probability of the global test below which points that stayed contradict each other: what moved is not explained"""
ROUNDS = 4
"""Fits of the axes of an epoch to those of the first: turns are small after each"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Alternative:
    """A point that may have moved in place of one that is stated to have: without it the rest agrees as well."""

    point: str
    other: str
    F: float
    """Global test of the points that stayed, if it was the other"""
    p: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Congruence:
    """What moved between epochs; arrays over the common points, in the axes of the first epoch."""

    epochs: tuple[str, ...]
    ids: tuple[str, ...]
    """Common points"""
    xyz: Array
    """(n, 3) in the first epoch [m]"""
    moved: Mask
    """(n,)"""
    displacement: Array
    """(k - 1, n, 3) of each epoch after the first against it, in the datum of the points that stayed [m]"""
    covariance: Array
    """(k - 1, n, 3, 3) of the displacements, the datum's errors included [m^2]"""
    statistic: Array
    """(n,) of each point against those that stayed: where it stayed too, F with 3 (k - 1) and `freedom` degrees of
    freedom"""
    p_value: Array
    """(n,) probability of a larger one, of this point alone"""
    limit: float
    """Probability below which a point has moved: the significance over the number of points"""
    detectable: Array
    """(n,) length of the smallest displacement of one epoch found with `POWER`, in the direction known worst [m]"""
    before: tuple[float, float]
    """Global test of all points as if none had moved: F and its probability"""
    after: tuple[float, float]
    """The same of the points that stayed"""
    freedom: float
    """Degrees of freedom of the variance factor"""
    significance: float
    scale: bool
    """Whether epochs may differ in scale"""
    transforms: tuple[SimilarityTransform, ...]
    """Of each epoch after the first into the axes of the first, by the points that stayed"""
    alternatives: tuple[Alternative, ...] = ()
    """Points that may have moved in place of others"""
    reported: tuple[Notice, ...] = ()
    """What is wrong with the epochs, or weak, as notices"""
    by_place: tuple[str, ...] = ()
    """Dots without a code that are taken as one by their place, not by a name (`metrology.dots`)"""
    detectable_before: Array | None = None
    """(n,) `detectable` if all points stayed, as it is known before anything is tested [m]"""
    areas: tuple[AreaTest, ...] = ()
    """Points tested together by their mean displacement: groups of the user, then patches that moved"""
    in_area: Mask | None = None
    """(n,) points that moved with an area, not by their own test"""
    patch_sizes: tuple[tuple[int, float, float], ...] = ()
    """Of patches of so many neighbours the smallest mean displacement that is found with `POWER`, median, if nothing
    moved and with what moved [m]"""

    @property
    def stayed(self) -> Mask:
        """(n,) the points that carry the datum."""
        return ~self.moved

    @property
    def largest(self) -> float:
        """Length of the largest displacement of a point that moved; of any where none did [m]."""
        length = np.linalg.norm(self.displacement, axis=2).max(axis=0)
        return float(length[self.moved].max() if self.moved.any() else length.max())

    def in_axes(self, by: SimilarityTransform, turn: Array | None = None) -> Congruence:
        """The same in other axes, into which `by` leads those of the first epoch.

        turn  (3, 3) covariance of its rotation vector about the new axes [rad^2]; None: free of error
        Tests do not change.  Covariances of displacements get what an error of the turn does to each: it is the same
        turn for all of them.
        """
        A = by.scale * by.rotation
        d, C = self.displacement @ A.T, A @ self.covariance @ A.T
        if turn is not None:
            K = cross_matrix(d.reshape(-1, 3)).reshape(*d.shape, 3)
            C = C + K @ turn @ np.swapaxes(K, -1, -2)
        return replace(
            self, xyz=by.points(self.xyz), displacement=d, covariance=C,
            detectable=by.scale * self.detectable, transforms=tuple(by.after(t) for t in self.transforms),
        )  # fmt: skip


def congruence(
    epochs: Sequence[PointSet], *, significance: float = SIGNIFICANCE, scale: bool | None = None,
    datum: Sequence[str] = (), joint: Array | None = None, groups: Mapping[str, Sequence[str]] | None = None,
    patches: bool = False, others: int = 0,
) -> Congruence:  # fmt: skip
    """Test which common points moved between two epochs or more.

    epochs   at least two, each in its own datum; points are the same by their names
    scale    whether epochs may differ in scale; None: where one of them has none
    datum    points that are known to have stayed; (): all can have moved, those that stayed are found
    joint    (e, 3 n, e, 3 n) covariance of the points of all epochs, which all have the same points in one order:
             common cameras and control make epochs dependent [m^2]; None: epochs are independent
    groups   points that are tested together by their mean displacement, by names of the groups
    patches  whether patches of neighbours are tested so, too
    others   further tests that share the significance
    raises   InputError for fewer than four common points, points in a line, or covariances that test nothing
    Variance factors of epochs that are estimated are taken as one.  Limits: a motion that all points
    share, and of points of which more than half moved alike, which half it was.
    """
    ids = common_ids(epochs)
    if joint is not None and any(e.ids != ids for e in epochs):
        raise InputError("epochs.joint_order", epochs=[e.name for e in epochs])
    sets = [e.named(ids) for e in epochs]
    first, n = sets[0], len(ids)
    free_scale = any(e.free_scale for e in epochs) if scale is None else scale
    known = np.isin(ids, list(datum))
    if datum and known.sum() < len(datum):
        raise InputError("epochs.datum_points_missing", names=sorted(set(datum) - set(ids)))
    alike = known if datum else _alike(first, sets[1:], scale=free_scale)
    named, patch = groups_of(ids, groups or {}), patches_of(first.xyz) if patches else ()
    # half of the significance is that of points and groups, half that of patches
    alpha = (significance / 2 if patch else significance) / (n + len(named) + others)
    family = _Family.of(
        (*named, *patch), n, [alpha] * len(named) + [significance / 2 / max(len(patch), 1)] * len(patch)
    )
    model = _model(first, sets[1:], alike, scale=free_scale, joint=joint)
    starts = (
        [alike]
        if datum or not patch
        else [alike, *stable_starts(model, [p.points for p in patch if len(p.points) == SMALLEST])]
    )
    states = [_moved(model, _State.of(~s, family, model, alpha), alpha, known, family) for s in starts]
    if patch and not datum:  # as well may the others have moved
        best = max(states, key=lambda s: _merit(model, s))
        if LEAST <= best.moved.sum() < n - LEAST:
            with suppress(InputError):  # too few of them, or in a line
                states.append(_moved(model, _State.of(~best.moved, family, model, alpha), alpha, known, family))
    # of those that leave no contradiction the one in which most stayed
    state = max(states, key=lambda s: _merit(model, s))
    for _ in range(ROUNDS):  # in the axes of those that stayed
        model = _model(first, sets[1:], ~state.moved, scale=free_scale, joint=joint)
        again = _moved(model, state, alpha, known, family)
        if (again.moved == state.moved).all():
            break
        state = again
    moved = state.moved
    F, p = model.tests(moved)
    d, C = model.displacements(moved)
    none = np.zeros(n, bool)
    shown = [(a, alpha) for a in named] + [
        (family.areas[k], family.limits[k]) for k in state.active if not family.areas[k].given
    ]
    return Congruence(
        epochs=tuple(e.name for e in epochs), ids=ids, xyz=first.xyz, moved=moved, displacement=d, covariance=C,
        statistic=F, p_value=p, limit=alpha, detectable=model.detectable(moved, alpha),
        detectable_before=model.detectable(none, alpha),
        before=model.whole(none), after=model.whole(moved),
        freedom=model.freedom, significance=significance, scale=free_scale,
        transforms=tuple(_axes(s, first, ~moved, scale=free_scale) for s in sets[1:]),
        alternatives=() if joint is not None else _alternatives(model, moved, known, ids, (alpha, significance)),
        areas=tuple(model.area(a, moved, limit) for a, limit in shown), in_area=moved & ~state.own,
        patch_sizes=model.patch_sizes(patch, moved, significance / 2 / max(len(patch), 1)),
    )  # fmt: skip


def common_ids(epochs: Sequence[PointSet]) -> tuple[str, ...]:
    """Names of points that all epochs have, in the order of the first; raises InputError for fewer than four."""
    if len(epochs) < 2:
        raise InputError("epochs.only_one")
    both = set(epochs[0].ids).intersection(*(e.ids for e in epochs[1:]))
    if len(both) < LEAST:
        raise InputError("epochs.too_few_common", epochs=[e.name for e in epochs], n=len(both), least=LEAST)
    return tuple(i for i in epochs[0].ids if i in both)


def probability_to_find(shift: float, count: int, significance: float = SIGNIFICANCE, dof: int = 3) -> float:
    """Power of the test of one among `count` points that moved by `shift` standard deviations of its difference.

    Limits: the part of a shift that the datum of few points takes up.
    """
    from scipy.special import chndtr

    return 1 - float(chndtr(_chi_square(significance / count, dof), dof, shift**2))


def _chi_square(tail: float, dof: int) -> float:
    from scipy.special import chdtri

    return float(chdtri(dof, tail))


def _alike(first: PointSet, later: Sequence[PointSet], *, scale: bool) -> Mask:
    """(n,) points that agree in all epochs in the axes of most: the start of the search."""
    alike = np.ones(len(first.ids), bool)
    for e in later:
        size = np.sqrt(np.linalg.eigvalsh(first.own + e.own)[:, -1])
        tolerance = AGREE * float(np.median(size[size > 0])) if (size > 0).any() else 0.0
        if tolerance == 0:
            raise InputError("epochs.no_sigmas", first=first.name, second=e.name)
        alike &= robust_similarity(e.xyz, first.xyz, tolerance, scale=None if scale else 1.0)[1]
    return alike if alike.sum() >= LEAST - 1 else np.ones(len(first.ids), bool)


def _axes(e: PointSet, first: PointSet, by: Mask, *, scale: bool) -> SimilarityTransform:
    """Of an epoch onto the first, by some points, weighted by their mean variances."""
    variance = np.trace(first.own + e.own, axis1=1, axis2=2)
    weights = 1 / np.maximum(variance, 1e-3 * np.median(variance))
    fit = similarity(e.xyz[by], first.xyz[by], weights[by] / weights[by].max(), scale=None if scale else 1.0)
    return SimilarityTransform(scale=fit.scale, rotation=fit.rotation, translation=fit.translation)


def _model(
    first: PointSet, later: Sequence[PointSet], stayed: Mask, *, scale: bool, joint: Array | None = None
) -> _Model:
    n, k = len(first.ids), len(later)
    axes = [_axes(e, first, stayed, scale=scale) for e in later]
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
    return _Model.of(
        np.concatenate([(e.xyz - first.xyz).ravel() for e in here]), Q, np.kron(np.eye(k), G), n,
        float("inf") if np.isinf(freedom).any() else float(sum(freedom)),
    )  # fmt: skip


def _of_differences(joint: Array, turns: Sequence[Array]) -> Array:
    """Covariance (3 n k, 3 n k) of the differences of later epochs against the first, each turned into its axes."""
    e, u = joint.shape[:2]
    A = np.stack([np.eye(3), *turns])
    C = joint.reshape(e, u // 3, 3, e, u // 3, 3)
    C = np.einsum("aij,apjbqk,blk->apibql", A, C, A, optimize=True).reshape(e, u, e, u)
    Q = C[1:, :, 1:] - C[1:, :, :1] - C[:1, :, 1:] + C[:1, :, :1]
    Q = Q.reshape((e - 1) * u, -1)
    return (Q + Q.T) / 2


@dataclass(frozen=True, slots=True, kw_only=True)
class _Model:
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

    @classmethod
    def of(cls, d: Array, Q: Array, B: Array, points: int, freedom: float) -> _Model:
        """Of differences; raises InputError where their covariance is singular beyond the datum."""
        # what lies in the datum of Q is filled up: B t takes it away again
        fill = np.trace(Q) / max(float(np.trace(B @ B.T)), 1e-300)
        try:
            half = np.linalg.inv(np.linalg.cholesky(Q + fill * B @ B.T))
        except np.linalg.LinAlgError:
            raise InputError("epochs.covariance_singular") from None
        HB = np.linalg.qr(half @ B)[0]
        W = half.T @ (half - HB @ (HB.T @ half))
        W = (W + W.T) / 2
        return cls(d=d, Q=Q, B=B, weights=W, misfit=W @ d, points=points, freedom=freedom)

    @property
    def later(self) -> int:
        return len(self.d) // (3 * self.points)

    def rows(self, points: Index) -> Index:
        """(len(points), 3 later) rows of points."""
        at = (3 * points[:, None] + np.arange(3)[None])[:, None, :]
        return (at + 3 * self.points * np.arange(self.later)[None, :, None]).reshape(len(points), 3 * self.later)

    def stayed(self, moved: Mask) -> _Stayed:
        """The points that have not moved, those that moved free; raises InputError where they test nothing."""
        rows = self.rows(np.flatnonzero(moved)).ravel()
        try:
            L = np.linalg.cholesky(self.weights[np.ix_(rows, rows)])
        except np.linalg.LinAlgError:
            raise InputError("epochs.covariance_singular") from None
        inverse = np.linalg.inv(L)
        return _Stayed(model=self, moved=moved, rows=rows, inverse=inverse, taken=inverse @ self.weights[rows])

    def whole(self, moved: Mask) -> tuple[float, float]:
        """Global test of the points that have not moved: F and its probability."""
        freedom = len(self.d) - 3 * self.later * int(moved.sum()) - self.B.shape[1]
        rest = self.stayed(moved).square_sum
        F = rest / max(freedom, 1)
        return F, fisher_tail(F, freedom, self.freedom)

    def tests(self, moved: Mask) -> tuple[Array, Array]:
        """(n,) F of each point against those that stayed, without it; and its probability."""
        u, S = self.stayed(moved).compared()
        return self.tested(u, S)

    def tested(self, u: Array, S: Array) -> tuple[Array, Array]:
        """F (h,) of hypotheses by their vectors (h, 3 k) and covariances or weights, and their probabilities."""
        from scipy.special import chdtrc, fdtrc

        dof = 3 * self.later
        F = np.einsum("hi,hij,hj->h", u, np.linalg.pinv(S, rcond=1e-10, hermitian=True), u) / dof
        return F, np.asarray(chdtrc(dof, F * dof) if np.isinf(self.freedom) else fdtrc(dof, self.freedom, F))

    def together(self, family: _Family, moved: Mask) -> Array:
        """(h,) probability of the mean displacement of the points of areas that have not moved; NaN: too few."""
        found = np.full(len(family.areas), np.nan)
        inside = family.sums @ (~moved)
        some = np.flatnonzero((inside > 1) & ((~moved).sum() - inside >= max(LEAST, self.points // 3)))
        if len(some):
            found[some] = self.tested(*self.stayed(moved).shifts(family, some))[1]
        return found

    def patch_sizes(
        self, patches: Sequence[Hypothesis], moved: Mask, alpha: float
    ) -> tuple[tuple[int, float, float], ...]:  # fmt: skip
        """Of patches by their sizes, the medians of their smallest detectable mean displacements, before and after."""
        found: list[tuple[int, float, float]] = []
        for size in sorted({len(p.points) for p in patches}):
            family = _Family.of([p for p in patches if len(p.points) == size], self.points, [])
            every = np.arange(len(family.areas))
            least = [
                [self._least(S, alpha) for S in self.stayed(m).shifts(family, every)[1]]
                for m in (np.zeros(self.points, bool), moved)
            ]  # fmt: skip
            found.append((size, float(np.median(least[0])), float(np.median(least[1]))))
        return tuple(found)

    def area(self, area: Hypothesis, moved: Mask, alpha: float) -> AreaTest:
        """The test of an area as a whole: its mean displacement against all else that stayed."""
        none = np.zeros(self.points, bool)
        back = moved.copy()
        back[area.points] = False
        one = _Family.of([area], self.points, [])
        (u,), (S,) = self.stayed(back).shifts(one, np.arange(1))
        F, p = self.tested(u[None], S[None])
        C = np.linalg.pinv(S, rcond=1e-10, hermitian=True)
        found = (C @ u).reshape(self.later, 3)
        at = np.arange(self.later)
        return AreaTest(
            name=area.name, given=area.given, points=area.points, displacement=found,
            covariance=C.reshape(self.later, 3, self.later, 3)[at, :, at, :], F=float(F[0]), p_value=float(p[0]),
            moved=bool(p[0] < alpha),
            detectable=self._least(S, alpha),
            detectable_before=self._least(self.stayed(none).shifts(one, np.arange(1))[1][0], alpha),
        )  # fmt: skip

    def displacements(self, moved: Mask) -> tuple[Array, Array]:
        """(k, n, 3) displacements in the datum of the points that stayed, and their covariances (k, n, 3, 3)."""
        rows = self.rows(np.flatnonzero(~moved)).ravel()
        B, Q = self.B, self.Q
        Bs = B[rows]
        # the datum by the points that stayed, all alike: displacements of the others refer to these
        A = np.linalg.pinv(Bs)
        S = np.eye(len(Q))
        S[:, rows] -= B @ A
        C = S @ Q @ S.T
        d = (S @ self.d).reshape(self.later, self.points, 3)
        C = C.reshape(self.later, self.points, 3, self.later, self.points, 3)
        j, i = np.meshgrid(np.arange(self.later), np.arange(self.points), indexing="ij")
        return d, C[j, i, :, j, i, :]

    def detectable(self, moved: Mask, alpha: float) -> Array:
        """(n,) smallest displacement of the last epoch that is found [m], in the direction known worst."""
        _, S = self.stayed(moved).compared()
        S[moved] = np.linalg.inv(S[moved])
        return np.array([self._least(each, alpha) for each in S])

    def _least(self, information: Array, alpha: float) -> float:
        """Length of the smallest displacement of the last epoch that is found [m], by the weights (3 k, 3 k) of one."""
        from scipy.special import chdtri, chndtrinc

        dof = 3 * self.later
        shift2 = float(chndtrinc(float(chdtri(dof, alpha)), dof, 1 - POWER))
        least = float(np.linalg.eigvalsh(information[-3:, -3:])[0])
        return float(np.sqrt(shift2 / least)) if least > 0 else float("inf")


@dataclass(frozen=True, slots=True, kw_only=True)
class _Stayed:
    """Points that stayed, with displacements of the others as unknowns of their own."""

    model: _Model
    moved: Mask
    rows: Index
    """of the points that moved"""
    inverse: Array
    """of the lower triangle of their weights"""
    taken: Array
    """(rows, 3 n k) what they take from the weights of all: W - taken' taken is what the others weigh without them"""

    @property
    def square_sum(self) -> float:
        """Weighted sum of squares of the differences of those that stayed."""
        m = self.model
        return max(float(m.d @ m.misfit) - float(((self.inverse @ m.misfit[self.rows]) ** 2).sum()), 0.0)

    @property
    def misfit(self) -> Array:
        """(3 n k) weighted differences without those that moved; 0 of these."""
        return self.model.misfit - self.taken.T @ (self.inverse @ self.model.misfit[self.rows])

    def weights(self, rows: Index, others: Index) -> Array:
        """What differences weigh without those that moved."""
        return self.model.weights[np.ix_(rows, others)] - self.taken[:, rows].T @ self.taken[:, others]

    def compared(self) -> tuple[Array, Array]:
        """Of each point a vector (n, 3 k) and its covariance.

        Of points that moved how far they lie from where those that stayed have them; of those that stayed what they
        weigh in the misfit.
        """
        m = self.model
        each = m.rows(np.arange(m.points))
        v = self.misfit
        u = v[each]
        S = m.weights[each[:, :, None], each[:, None, :]] - np.einsum(
            "mhi,mhj->hij", self.taken[:, each], self.taken[:, each], optimize=True
        )
        # the displacements of points that moved, by least squares
        C = self.inverse.T @ self.inverse
        u[self.moved] = (C @ m.misfit[self.rows]).reshape(-1, each.shape[1])
        own = np.arange(len(self.rows)).reshape(-1, each.shape[1])
        S[self.moved] = C[own[:, :, None], own[:, None, :]]
        return u, S

    def shifts(self, family: _Family, areas: Index) -> tuple[Array, Array]:
        """What common displacements (h, 3 k) of the points of areas weigh in the misfit, and their weights.

        Of points that stayed: those that moved have displacements of their own, and weigh nothing.
        """
        m = self.model
        each = m.rows(np.arange(m.points))
        Z = family.sums[areas]
        u = Z @ self.misfit[each]
        S = family.weights(m)[areas]
        if len(self.rows):
            A = np.tensordot(Z, self.taken[:, each], (1, 1))
            S = S - np.einsum("hri,hrj->hij", A, A, optimize=True)
        return u, S


@dataclass(frozen=True, slots=True, kw_only=True)
class _Family:
    """Areas that are tested, each with its limit."""

    areas: tuple[Hypothesis, ...]
    sums: Array
    """(h, n)"""
    limits: Array
    of_model: list[tuple[_Model, Array]]
    """the last model and the weights in it"""

    @classmethod
    def of(cls, areas: Sequence[Hypothesis], points: int, limits: Sequence[float]) -> _Family:
        return cls(areas=tuple(areas), sums=sums_of(areas, points), limits=np.array(limits), of_model=[])

    def weights(self, model: _Model) -> Array:
        """(h, 3 k, 3 k) of common displacements, if no point moved."""
        if not self.of_model or self.of_model[0][0] is not model:
            each = model.rows(np.arange(model.points))
            found: list[Array] = []
            for a in self.areas:
                some = model.weights[each[a.points]].sum(axis=0)
                found.append(some[:, each[a.points]].sum(axis=1))
            self.of_model[:] = [(model, np.array(found).reshape(-1, each.shape[1], each.shape[1]))]
        return self.of_model[0][1]


@dataclass(frozen=True, slots=True, kw_only=True)
class _State:
    """What has moved: points by their own tests, and areas."""

    own: Mask
    active: tuple[int, ...]
    family: _Family

    @property
    def moved(self) -> Mask:
        """(n,) all of them."""
        found = self.own.copy()
        for k in self.active:
            found[self.family.areas[k].points] = True
        return found

    @classmethod
    def of(cls, moved: Mask, family: _Family, model: _Model, alpha: float) -> _State:
        """A start: the points that moved by their own tests, and areas of points of which most did."""
        if not len(family.areas) or not moved.any():
            return cls(own=moved, active=(), family=family)
        _, p = model.tests(moved)
        inside = family.sums @ moved
        size = family.sums.sum(axis=1)
        active: list[int] = []
        left = moved.copy()
        # the largest first: the fewest pieces that explain what moved
        for k in np.lexsort((-inside, -(inside / size))).tolist():
            points = family.areas[k].points
            if inside[k] < 0.8 * size[k] or not left[points].any() or family.areas[k].given:
                continue
            back = moved.copy()
            back[points] = False
            if model.tested(*model.stayed(back).shifts(family, np.array([k])))[1][0] < family.limits[k]:
                active.append(k)
                left[points] = False
        return cls(own=moved & (p < alpha), active=tuple(active), family=family)


def _merit(model: _Model, state: _State) -> tuple[float, int]:
    """How good an explanation is: whether those that stayed contradict each other, then how many they are."""
    return min(model.whole(state.moved)[1], CONTRADICTED), int((~state.moved).sum())


def _alternatives(
    model: _Model, moved: Mask, fixed: Mask, ids: Sequence[str], levels: tuple[float, float]
) -> tuple[Alternative, ...]:  # fmt: skip
    """Points that explain as well what a moved one does: without them it, and all that stayed together, agree.

    levels  of a single point, and of all together
    """
    found: list[Alternative] = []
    each, dof = model.rows(np.arange(model.points)), 3 * model.later
    for i in np.flatnonzero(moved).tolist():
        back = moved.copy()
        back[i] = False
        s = model.stayed(back)
        freedom = len(model.d) - len(s.rows) - model.B.shape[1] - dof
        if freedom <= 0:
            continue
        v, mine, total = s.misfit, each[i], s.square_sum
        for j in np.flatnonzero(~back & ~fixed & (np.arange(model.points) != i)).tolist():
            r = each[j]
            inverse = np.linalg.pinv(s.weights(r, r), rcond=1e-10, hermitian=True)
            gain = s.weights(mine, r) @ inverse
            u = v[mine] - gain @ v[r]
            S = s.weights(mine, mine) - gain @ s.weights(r, mine)
            own = float(u @ np.linalg.pinv(S, rcond=1e-8, hermitian=True) @ u) / dof
            rest = total - float(v[r] @ inverse @ v[r])
            F = max(rest, 0.0) / freedom
            p = fisher_tail(F, freedom, model.freedom)
            if fisher_tail(own, dof, model.freedom) >= levels[0] and p >= levels[1]:
                found.append(Alternative(point=ids[i], other=ids[j], F=F, p=p))
    return tuple(found)


def _moved(model: _Model, state: _State, alpha: float, fixed: Mask, family: _Family) -> _State:
    """What moved: from a start, the worst is added while it is significant, the best let go while it is not.

    Points first; where none is significant, the worst of the areas.
    """
    state = replace(state, own=state.own & ~fixed)
    free = (family.sums @ fixed) == 0
    seen = set[tuple[bytes, tuple[int, ...]]]()
    while (key := (state.own.tobytes(), state.active)) not in seen:
        seen.add(key)
        own, moved = state.own, state.moved
        _, p = model.tests(moved)
        back = np.where(own, p, -1.0)
        if back.max() >= alpha:  # it fits those that stayed
            own = own.copy()
            own[int(back.argmax())] = False
            state = replace(state, own=own)
            continue
        weak = [(_without(model, state, k), k) for k in state.active]
        if weak and max(weak)[0] >= 1.0:
            state = replace(state, active=tuple(k for k in state.active if k != max(weak)[1]))
            continue
        worst = np.where(moved | fixed, np.inf, p)
        if worst.min() < alpha and (~moved).sum() > LEAST - 1:
            own = own.copy()
            own[int(worst.argmin())] = True
            state = replace(state, own=own)
            continue
        if not len(family.areas):
            break
        ratio = np.where(free, model.together(family, moved) / family.limits, np.inf)
        ratio = np.where(np.isnan(ratio), np.inf, ratio)
        if ratio.min() < 1.0:
            state = replace(state, active=(*state.active, int(ratio.argmin())))
    return state


def _without(model: _Model, state: _State, area: int) -> float:
    """Probability of an active area over its limit, if what belongs to it alone had stayed."""
    rest = replace(state, active=tuple(k for k in state.active if k != area)).moved
    points = state.family.areas[area].points
    if (~rest[points]).sum() < 2:
        return float("inf")
    p = model.tested(*model.stayed(rest).shifts(state.family, np.array([area])))[1][0]
    return float(p / state.family.limits[area])
