"""Which points have moved between epochs: the congruence test in one datum of the points that stayed, which it finds.

Pelzer 1971 and Niemeier 1981 test the whole network and take points out of the datum one at a time; Caspary 1987.  Here
the test of a single point is that of a block of coordinates (as data snooping of a blunder of three coordinates): the
global test alone overlooks a point that moved among many that stayed.  Limits are for all points together (Bonferroni).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.errors import InputError
from raybundle.metrology.areas import SMALLEST, AreaTest, groups_of, patches_of
from raybundle.metrology.congruence_model import LEAST, Factor, Family, Model, axes_onto, model_of
from raybundle.metrology.consensus import stable_starts
from raybundle.metrology.point_set import PointSet
from raybundle.metrology.surface_strain import SurfaceStrain, surface_strains
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import cross_matrix
from raybundle.numerics.statistics import fisher_tail
from raybundle.numerics.transform import SimilarityTransform, robust_similarity

SIGNIFICANCE = 0.05
"""Probability that some point is called moved where none did"""
AGREE = 5.0
"""Standard deviations by which points may differ in the search for those that stayed, before their datum is known"""
CONTRADICTED = 0.001
"""Probability of the global test below which points that stayed contradict each other: what moved is not explained"""
STRAINED = 2 * SMALLEST - 1
"""Points of the patches of which strains are stated: three times what a plane of displacements needs"""
STARTS = 4
"""From areas: of a part that moved and one that stayed, both are tried"""
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
    untested: Mask | None = None
    """(n,) displaced points that a wrong measurement explains as well: neither moved nor stable"""
    in_area: Mask | None = None
    """(n,) points that moved with an area, not by their own test"""
    strains: tuple[SurfaceStrain, ...] = ()
    """Of the surface at patches of `STRAINED` neighbours and groups of the user, from the first epoch to each other"""
    rival: Mask | None = None
    """(n,) points that moved by another explanation, with other stable points, that fits as well; None: none does"""
    patch_sizes: tuple[tuple[int, float, float], ...] = ()
    """Of patches of so many neighbours the smallest mean displacement that is found with `POWER`, median, if nothing
    moved and with what moved [m]"""

    @property
    def stayed(self) -> Mask:
        """(n,) the points that carry the datum."""
        return ~self.moved if self.untested is None else ~self.moved & ~self.untested

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
            strains=tuple(s.in_axes(by) for s in self.strains),
        )  # fmt: skip


class PointErrors(Protocol):
    """Displacements of points by wrong measurements."""

    def probability(self, point: int, d: Array, C: Array) -> float:
        """Probability of a larger displacement d (3 k), with covariance C without wrong measurements."""
        ...

    def detectable(self, point: int, C: Array, alpha: float) -> float:
        """Length of the smallest displacement that wrong measurements do not explain."""
        ...


def congruence(
    epochs: Sequence[PointSet], *, significance: float = SIGNIFICANCE, scale: bool | None = None,
    datum: Sequence[str] = (), joint: Array | None = None, groups: Mapping[str, Sequence[str]] | None = None,
    patches: bool = False, others: int = 0, errors: PointErrors | None = None,
    factors: Mapping[int, Factor] | None = None,
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
    errors   probability of a displacement by wrong measurements of the point; None: the normal distribution alone
    factors  of the variances of means of so many points that are patches or groups; None: 1, known
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
    own = significance / 2 / max(len(patch), 1)
    family = Family.of((*named, *patch), n, [alpha] * len(named) + [own] * len(patch), factors)
    model = model_of(first, sets[1:], alike, scale=free_scale, joint=joint)
    starts = (
        [alike]
        if datum or not patch
        else [alike, *stable_starts(model, [p.points for p in patch if len(p.points) == SMALLEST])]
    )
    starts = list({s.tobytes(): s for s in starts}.values())
    begun = [_State.of(~s, family, model, alpha) for s in starts]
    if patch and not datum:
        begun += _of_areas(model, family, alpha)
    states = [_moved(model, s, alpha, known, family) for s in begun]
    if patch and not datum:  # as well may the others have moved
        best = max(states, key=lambda s: _merit(model, s))
        if LEAST <= best.moved.sum() < n - LEAST:
            with suppress(InputError):  # too few of them, or in a line
                states.append(_moved(model, _State.of(~best.moved, family, model, alpha), alpha, known, family))
    state = max(states, key=lambda s: _merit(model, s))
    rival = None if datum else _rival(model, states, state, significance)
    for _ in range(ROUNDS):  # in the axes of those that stayed
        model = model_of(first, sets[1:], ~state.moved, scale=free_scale, joint=joint)
        again = _moved(model, state, alpha, known, family)
        if (again.moved == state.moved).all():
            break
        state = again
    moved = state.moved
    F, p = model.tests(moved)
    untested = np.zeros(n, bool)
    if errors is not None and state.own.any():
        p = _with_errors(model, moved, state.own, p, errors)
        untested = state.own & (p >= alpha) & ~replace(state, own=untested).moved
    d, joined = model.displacements(moved)
    j, i = np.meshgrid(np.arange(len(d)), np.arange(n), indexing="ij")
    strained = [k for k, a in enumerate(family.areas) if a.given or len(a.points) == STRAINED]
    pieces = [
        (k, replace(a, points=_piece(model, state, k, alpha))) for k in state.active if not (a := family.areas[k]).given
    ]
    limits = [*family.limits[: len(named)].tolist(), *(float(family.limits[k]) for k, _ in pieces)]
    shown = Family.of((*named, *(a for _, a in pieces)), n, limits, factors)
    least, least_before = model.detectable(moved, alpha), model.detectable(np.zeros(n, bool), alpha)
    if errors is not None:
        each = model.covariances(moved)
        least = np.maximum(least, [errors.detectable(i, C, alpha) for i, C in enumerate(each)])
    return Congruence(
        epochs=tuple(e.name for e in epochs), ids=ids, xyz=first.xyz, moved=moved & ~untested,
        displacement=d, covariance=joined[j, i, :, j, i, :],
        strains=surface_strains(
            first.xyz, d, joined, [family.areas[k] for k in strained], family.factors[strained],
            1 / np.maximum(1 / family.freedom[strained] + 1 / model.freedom, 1e-9),
        ),
        statistic=F, p_value=p, limit=alpha, detectable=least,
        detectable_before=least_before, untested=untested,
        before=model.whole(np.zeros(n, bool)), after=model.whole(moved),
        freedom=model.freedom, significance=significance, scale=free_scale,
        transforms=tuple(axes_onto(s, first, ~moved, scale=free_scale) for s in sets[1:]),
        alternatives=() if joint is not None else _alternatives(model, moved, known, ids, (alpha, significance)),
        areas=tuple(model.area(shown, k, moved, significance / len(limits)) for k in range(len(limits))),
        in_area=moved & ~state.own, rival=rival, patch_sizes=model.patch_sizes(family, moved, own),
    )  # fmt: skip


def patch_variances(epochs: Sequence[PointSet], joint: Array, *, scale: bool) -> dict[int, Factor]:
    """Of patches by their sizes, the mean F of their mean displacements, without points that are displaced alone.

    epochs, joint  as of `congruence`, of points that did not move: 1 by the covariances, more by errors that
                   neighbours share
    """
    sets, n = list(epochs), len(epochs[0].ids)
    alike, none = _alike(sets[0], sets[1:], scale=scale), np.zeros(n, bool)
    model = model_of(sets[0], sets[1:], alike, scale=scale, joint=joint)
    empty, alpha = Family.of([], n, []), SIGNIFICANCE / n
    moved = _moved(model, _State(own=none, active=(), family=empty, stay=none), alpha, none, empty).moved
    family = Family.of(patches_of(sets[0].xyz), n, [])
    sizes = np.array([len(a.points) for a in family.areas])
    some = np.flatnonzero(family.sums @ ~moved > 1)
    F = model.of_areas(family, some, moved)[0] if len(some) else np.zeros(0)
    stayed = int((~moved).sum())
    found = {1: Factor(model.whole(moved)[0], 3.0 * model.later * stayed)}
    for k in np.unique(sizes[some]).tolist():
        found[k] = Factor(float(F[sizes[some] == k].mean()), 3.0 * model.later * stayed / k)
    return found


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


@dataclass(frozen=True, slots=True, kw_only=True)
class _State:
    """What has moved: points by their own tests, and areas."""

    own: Mask
    active: tuple[int, ...]
    family: Family
    stay: Mask
    """(n,) points of active areas that stayed: where they lie fits no movement, and not that of their areas"""

    @property
    def moved(self) -> Mask:
        """(n,) all of them."""
        found = np.zeros_like(self.own)
        for k in self.active:
            found[self.family.areas[k].points] = True
        return (found & ~self.stay) | self.own

    @classmethod
    def of(cls, moved: Mask, family: Family, model: Model, alpha: float) -> _State:
        """A start: the points that moved by their own tests, and areas of points of which most did."""
        if not len(family.areas) or not moved.any():
            return cls(own=moved, active=(), family=family, stay=np.zeros_like(moved))
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
            if model.of_areas(family, np.array([k]), back)[1][0] < family.limits[k]:
                active.append(k)
                left[points] = False
        return cls(own=moved & (p < alpha), active=tuple(active), family=family, stay=np.zeros_like(moved))


def _with_errors(model: Model, moved: Mask, own: Mask, p: Array, errors: PointErrors) -> Array:
    """Probabilities of points, of those that moved by their own tests with regard to wrong measurements."""
    d, C = model.stayed(moved).compared()
    found = p.copy()
    for i in np.flatnonzero(own).tolist():
        found[i] = max(p[i], errors.probability(i, d[i], C[i]))
    return found


def _merit(model: Model, state: _State) -> tuple[float, float]:
    """How good an explanation is: whether those that stayed contradict each other, then Schwarz's criterion.

    Displacements are its parameters: of explanations that fit alike the one in which most stayed.
    """
    p, rest = model.whole(state.moved)[1], model.stayed(state.moved).square_sum
    return min(p, CONTRADICTED), -rest - 3 * model.later * float(state.moved.sum()) * float(np.log(len(model.d)))


def _rival(model: Model, states: Sequence[_State], chosen: _State, significance: float) -> Mask | None:
    """What moved by another explanation that leaves no contradiction either; None: there is none.

    Most points stayed by both, but what moved is another part: nothing shows which did.  It is a state that was found,
    or what follows if what moved had stayed.
    """
    stayed = ~chosen.moved
    others = [s.moved for s in states]
    if chosen.moved.sum() >= LEAST:
        with suppress(InputError):  # in a line
            others.append(stayed & (model.tests(stayed)[1] < significance))
    fits = [
        moved
        for moved in others
        if 2 * moved.sum() < model.points
        and 2 * (chosen.moved & moved).sum() < min(chosen.moved.sum(), moved.sum())
        and model.whole(moved)[1] >= CONTRADICTED
    ]
    return min(fits, key=np.sum) if fits else None


def _of_areas(model: Model, family: Family, alpha: float) -> list[_State]:
    """Starts from areas that have no point in common, the most significant ones if nothing else moved."""
    none = np.zeros(model.points, bool)
    ratio = model.together(family, none) / family.limits
    found, taken = list[_State](), none.copy()
    for k in np.argsort(ratio).tolist():  # what is not tested is NaN, and last
        points = family.areas[k].points
        if not ratio[k] < 1.0 or len(found) == STARTS:
            break
        if not taken[points].any():
            taken[points] = True
            moved = none.copy()
            moved[points] = True
            own = moved & (model.tests(moved)[1] < alpha)
            found.append(_State(own=own, active=(k,), family=family, stay=none))
    return found


def _alternatives(
    model: Model, moved: Mask, fixed: Mask, ids: Sequence[str], levels: tuple[float, float]
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


def _moved(model: Model, state: _State, alpha: float, fixed: Mask, family: Family) -> _State:
    """What moved: from a start, the worst is added while it is significant, the best let go while it is not.

    Points first; where none is significant, the worst of the areas.
    """
    state = replace(state, own=state.own & ~fixed)
    free = (family.sums @ fixed) == 0
    seen = set[tuple[bytes, tuple[int, ...], bytes]]()
    while (key := (state.own.tobytes(), state.active, state.stay.tobytes())) not in seen:
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
        if (other := _not_of_its_area(model, state, p, alpha)) is not None:
            stay = state.stay.copy()
            stay[other] = True
            state = replace(state, stay=stay)
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
        ratio[list(state.active)] = np.inf
        if ratio.min() < 1.0:
            k = int(ratio.argmin())
            stay = state.stay.copy()
            stay[family.areas[k].points] = False
            state = replace(state, active=(*state.active, k), stay=stay)
    return state


def _not_of_its_area(model: Model, state: _State, p: Array, alpha: float) -> int | None:
    """The point that moved with areas alone, fits no movement, and agrees least with the movement of any of them."""
    best = np.full(model.points, -1.0)
    for k in state.active:
        points = _piece(model, state, k, alpha)
        if len(points) > 1:
            agreement = model.agreement(points, state.moved, state.family.single)
            best[points] = np.maximum(best[points], agreement)
    best[state.own | (p < alpha) | (best < 0)] = np.inf
    worst = int(best.argmin())
    return worst if best[worst] < alpha else None


def _piece(model: Model, state: _State, area: int, alpha: float) -> Index:
    """Points of an active area that moved, without those that moved by their own tests and not as the others."""
    moved = state.moved
    points = state.family.areas[area].points
    points = points[moved[points]]
    while len(points) > 2 and state.own[points].any():
        p = np.where(state.own[points], model.agreement(points, moved, state.family.single), np.inf)
        if p.min() >= alpha:
            break
        points = np.delete(points, p.argmin())
    return points


def _without(model: Model, state: _State, area: int) -> float:
    """Probability of an active area over its limit, if what belongs to it alone had stayed."""
    rest = replace(state, active=tuple(k for k in state.active if k != area)).moved
    points = state.family.areas[area].points
    if (~rest[points]).sum() < 2:
        return float("inf")
    p = model.of_areas(state.family, np.array([area]), rest)[1][0]
    return float(p / state.family.limits[area])
