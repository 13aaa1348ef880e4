"""Which points have moved between epochs: the congruence test in one datum of the points that stayed, which it finds.

Pelzer 1971 and Niemeier 1981 test the whole network and take points out of the datum one at a time; Caspary 1987.  Here
the test of a single point is that of a block of coordinates (as data snooping of a blunder of three coordinates): the
global test alone overlooks a point that moved among many that stayed.  Limits are for all points together (Bonferroni).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.errors import InputError
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
    datum: Sequence[str] = (),
) -> Congruence:  # fmt: skip
    """Test which common points moved between two epochs or more.

    epochs  at least two, each in its own datum; points are the same by their names
    scale   whether epochs may differ in scale; None: where one of them has none
    datum   points that are known to have stayed; (): all can have moved, those that stayed are found
    raises  InputError for fewer than four common points, points in a line, or covariances that test nothing
    Variance factors of epochs that are estimated are taken as one.  Limits: a motion that all points
    share, and of points of which more than half moved alike, which half it was.
    """
    ids = common_ids(epochs)
    sets = [e.named(ids) for e in epochs]
    first, n = sets[0], len(ids)
    free_scale = any(e.free_scale for e in epochs) if scale is None else scale
    known = np.isin(ids, list(datum))
    if datum and known.sum() < len(datum):
        raise InputError("epochs.datum_points_missing", names=sorted(set(datum) - set(ids)))
    stayed = known if datum else _alike(first, sets[1:], scale=free_scale)
    model = _model(first, sets[1:], stayed, scale=free_scale)
    alpha = significance / n
    moved = _moved(model, ~stayed, alpha, fixed=known)
    for _ in range(ROUNDS):  # in the axes of those that stayed
        model = _model(first, sets[1:], ~moved, scale=free_scale)
        again = _moved(model, moved, alpha, fixed=known)
        if (again == moved).all():
            break
        moved = again
    F, p = model.tests(moved)
    d, C = model.displacements(moved)
    return Congruence(
        epochs=tuple(e.name for e in epochs), ids=ids, xyz=first.xyz, moved=moved, displacement=d, covariance=C,
        statistic=F, p_value=p, limit=alpha, detectable=model.detectable(moved, alpha),
        before=model.whole(np.zeros(n, bool)), after=model.whole(moved),
        freedom=model.freedom, significance=significance, scale=free_scale,
        transforms=tuple(_axes(s, first, ~moved, scale=free_scale) for s in sets[1:]),
        alternatives=_alternatives(model, moved, known, ids, (alpha, significance)),
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


def _model(first: PointSet, later: Sequence[PointSet], stayed: Mask, *, scale: bool) -> _Model:
    n, k = len(first.ids), len(later)
    here = [e.moved(_axes(e, first, stayed, scale=scale)) for e in later]
    G = datum_directions(first.xyz, scale=scale).reshape(3 * n, -1)
    Q = np.kron(np.ones((k, k)), first.covariance)
    for j, e in enumerate(here):
        s = slice(3 * n * j, 3 * n * (j + 1))
        Q[s, s] += e.covariance
    B = np.kron(np.eye(k), G)
    freedom = [e.freedom for e in (first, *later)]
    return _Model(
        d=np.concatenate([(e.xyz - first.xyz).ravel() for e in here]), Q=Q, B=B, points=n,
        freedom=float("inf") if np.isinf(freedom).any() else float(sum(freedom)),
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class _Model:
    """Differences d (3 n k) = datum B t, with covariance Q; the datum of Q itself is of no account."""

    d: Array
    Q: Array
    B: Array
    points: int
    freedom: float

    @property
    def later(self) -> int:
        return len(self.d) // (3 * self.points)

    def rows(self, points: Index) -> Index:
        """(len(points), 3 later) rows of points."""
        at = (3 * points[:, None] + np.arange(3)[None])[:, None, :]
        return (at + 3 * self.points * np.arange(self.later)[None, :, None]).reshape(len(points), -1)

    def stayed(self, moved: Mask) -> _Stayed:
        """The points that have not moved, with their datum free; raises InputError where they test nothing."""
        rows = self.rows(np.flatnonzero(~moved)).ravel()
        Q, B = self.Q[np.ix_(rows, rows)], self.B[rows]
        # what lies in the datum of Q is filled up: B t takes it away again
        fill = np.trace(Q) / max(float(np.trace(B @ B.T)), 1e-300)
        try:
            half = np.linalg.inv(np.linalg.cholesky(Q + fill * B @ B.T))
        except np.linalg.LinAlgError:
            raise InputError("epochs.covariance_singular") from None
        HB, R = np.linalg.qr(half @ B)
        weights = half.T @ (half - HB @ (HB.T @ half))
        return _Stayed(rows=rows, inverse=half.T @ half, by_datum=np.linalg.solve(R, HB.T @ half), R=R, fill=fill,
                       weights=(weights + weights.T) / 2)  # fmt: skip

    def whole(self, moved: Mask) -> tuple[float, float]:
        """Global test of the points that have not moved: F and its probability."""
        s = self.stayed(moved)
        freedom = len(s.rows) - self.B.shape[1]
        d = self.d[s.rows]
        F = float(d @ s.weights @ d) / max(freedom, 1)
        return F, fisher_tail(F, freedom, self.freedom)

    def tests(self, moved: Mask) -> tuple[Array, Array]:
        """(n,) F of each point against those that stayed, without it; and its probability."""
        dof = 3 * self.later
        u, S = self.compared(moved)
        F = np.array([float(a @ np.linalg.lstsq(C, a, rcond=1e-10)[0]) for a, C in zip(u, S, strict=True)]) / dof
        return F, np.array([fisher_tail(f, dof, self.freedom) for f in F])

    def compared(self, moved: Mask) -> tuple[Array, Array]:
        """Of each point a vector (n, 3 k) and its covariance.

        Of points that moved how far they lie from where those that stayed have them; of those that stayed what they
        weigh in the misfit.
        """
        s, each = self.stayed(moved), self.rows(np.arange(self.points))
        u, S = np.zeros(each.shape), np.zeros((*each.shape, each.shape[1]))
        place = np.full(len(self.d), -1)
        place[s.rows] = np.arange(len(s.rows))
        d = self.d[s.rows]
        v, t = s.weights @ d, s.by_datum @ d
        for i in np.flatnonzero(~moved):
            r = place[each[i]]
            u[i], S[i] = v[r], s.weights[np.ix_(r, r)]
        Bs = self.B[s.rows]
        RI = np.linalg.inv(s.R)
        for i in np.flatnonzero(moved):
            r = each[i]
            across = self.Q[np.ix_(r, s.rows)] + s.fill * self.B[r] @ Bs.T
            gain = across @ s.inverse
            open_ = (self.B[r] - gain @ Bs) @ RI
            u[i] = self.d[r] - self.B[r] @ t - gain @ (d - Bs @ t)
            S[i] = self.Q[np.ix_(r, r)] + s.fill * self.B[r] @ self.B[r].T - gain @ across.T + open_ @ open_.T
        return u, S

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
        from scipy.special import chdtri, chndtrinc

        dof = 3 * self.later
        shift2 = float(chndtrinc(float(chdtri(dof, alpha)), dof, 1 - POWER))
        _, S = self.compared(moved)
        found = np.full(self.points, np.nan)
        for i in range(self.points):
            information = np.linalg.inv(S[i]) if moved[i] else S[i]
            least = float(np.linalg.eigvalsh(information[-3:, -3:])[0])
            found[i] = np.sqrt(shift2 / least) if least > 0 else np.inf
        return found


@dataclass(frozen=True, slots=True, kw_only=True)
class _Stayed:
    """Points that stayed: rows of their differences, and what they weigh."""

    rows: Index
    inverse: Array
    """of their covariance, its datum filled up"""
    by_datum: Array
    """(g, rows) the datum's parameters by their differences"""
    R: Array
    """(g, g) upper triangle: the parameters' covariance is (R' R)^-1"""
    fill: float
    weights: Array
    """of differences, once the datum is free"""


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
        freedom = len(s.rows) - model.B.shape[1] - dof
        if freedom <= 0:
            continue
        place = np.full(len(model.d), -1)
        place[s.rows] = np.arange(len(s.rows))
        d = model.d[s.rows]
        v, mine = s.weights @ d, place[each[i]]
        for j in np.flatnonzero(~back & ~fixed & (np.arange(model.points) != i)).tolist():
            r = place[each[j]]
            inverse = np.linalg.pinv(s.weights[np.ix_(r, r)], rcond=1e-10, hermitian=True)
            gain = s.weights[np.ix_(mine, r)] @ inverse
            u = v[mine] - gain @ v[r]
            S = s.weights[np.ix_(mine, mine)] - gain @ s.weights[np.ix_(r, mine)]
            own = float(u @ np.linalg.pinv(S, rcond=1e-8, hermitian=True) @ u) / dof
            rest = float(d @ v) - float(v[r] @ inverse @ v[r])
            F = max(rest, 0.0) / freedom
            p = fisher_tail(F, freedom, model.freedom)
            if fisher_tail(own, dof, model.freedom) >= levels[0] and p >= levels[1]:
                found.append(Alternative(point=ids[i], other=ids[j], F=F, p=p))
    return tuple(found)


def _moved(model: _Model, start: Mask, alpha: float, fixed: Mask) -> Mask:
    """Points that moved: from a start, the worst is added while it is significant, the best let go while it is not."""
    moved = start & ~fixed
    seen = set[bytes]()
    while moved.tobytes() not in seen:
        seen.add(moved.tobytes())
        _, p = model.tests(moved)
        back = np.where(moved, p, -1.0)
        if back.max() >= alpha:  # it fits those that stayed
            moved = moved.copy()
            moved[int(back.argmax())] = False
            continue
        worst = np.where(moved | fixed, np.inf, p)
        if worst.min() < alpha and (~moved).sum() > LEAST - 1:
            moved = moved.copy()
            moved[int(worst.argmin())] = True
    return moved
