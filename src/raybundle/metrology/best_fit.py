"""Measured points brought onto nominal coordinates: deviations, how sure they are, and whether tolerances are kept.

Least squares with the joint covariance, or with all coordinates alike as metrology programs do it.  Verdicts on
tolerances after ISO 14253-1: a deviation proves to be within or beyond its tolerance by its expanded uncertainty.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from raybundle.block.points import dot_number
from raybundle.errors import InputError
from raybundle.metrology.dots import Dots
from raybundle.metrology.misfit import Misfit, in_one_line, misfit
from raybundle.metrology.point_set import PointSet, datum_directions
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.statistics import joint_test
from raybundle.numerics.transform import SimilarityTransform, similarity

Verdict = Literal["within", "beyond", "undecided", ""]
Weighting = Literal["covariance", "equal"]
LEAST = 3
COVERAGE = 2.0
"""Standard deviations of an expanded uncertainty: 95 %"""
ROUNDS = 10
STILL = 1e-12
"""Change of coordinates, as a share of the size of all, by which a fit has come to its end"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Nominal:
    """Coordinates that points are to have."""

    ids: tuple[str, ...]
    xyz: Array
    """(n, 3) [m]"""
    tolerance: Array
    """(n,) largest length of a deviation [m]; NaN where none is asked for"""
    sigma: Array
    """(n, 3) standard deviations of the nominal coordinates themselves [m]; 0: they are exact"""

    def rows(self, at: Sequence[int]) -> Nominal:
        """Some of the points."""
        k = list(at)
        return Nominal(
            ids=tuple(self.ids[i] for i in k), xyz=self.xyz[k], tolerance=self.tolerance[k], sigma=self.sigma[k]
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class BestFit:
    """Measured points in the axes of the nominal ones; arrays over the points that both have."""

    ids: tuple[str, ...]
    fitted: Mask
    """(n,) points by which the axes were fitted"""
    xyz: Array
    """(n, 3) measured, in nominal axes [m]"""
    deviation: Array
    """(n, 3) measured - nominal [m]"""
    covariance: Array
    """(n, 3, 3) of the deviations, the fit's errors included [m^2]"""
    p_value: Array
    """(n,) probability of a larger deviation by errors of measurement alone, of this point alone; NaN where the fit
    leaves nothing to test"""
    limit: float
    """Probability below which a deviation is significant: family-wise over the points"""
    tolerance: Array
    """(n,) [m]"""
    transform: SimilarityTransform
    """Of the measured axes into the nominal ones"""
    scale_sigma: float
    """Standard deviation of the scale, as a share of it; 0 where it was kept"""
    rms: float
    """Of the coordinates' deviations of the fitted points [m]"""
    weighting: Weighting
    missing: tuple[str, ...]
    """Nominal points that were not measured"""
    freedom: float
    asked: tuple[str, ...]
    """Points by which the axes were to be fitted; those of them that do not agree with the others took no part, unless
    they were named"""
    misfit: Misfit
    """How the points of `asked`, in their order, fit"""

    @property
    def turn(self) -> Array:
        """(3, 3) covariance of the rotation vector about the nominal axes, by the misfit of the fitted points [rad^2].

        Limits: the part of it that an error shared by all nominal points has.
        """
        target = self.xyz - self.deviation
        return similarity(self.xyz[self.fitted], target[self.fitted], scale=1.0).covariance[3:6, 3:6]

    @property
    def length(self) -> Array:
        """(n,) of the deviations [m]."""
        return np.linalg.norm(self.deviation, axis=1)

    @property
    def length_sigma(self) -> Array:
        """(n,) their standard deviations along themselves [m]."""
        u = self.deviation / np.maximum(self.length, 1e-300)[:, None]
        return np.sqrt(np.maximum(np.einsum("ni,nij,nj->n", u, self.covariance, u), 0))

    @property
    def verdict(self) -> tuple[Verdict, ...]:
        """(n,) whether tolerances are kept, as far as the uncertainty lets it be stated; "" where none is asked for."""
        uncertain = COVERAGE * self.length_sigma
        rows = zip(self.length.tolist(), uncertain.tolist(), self.tolerance.tolist(), strict=True)
        return tuple(_verdict(*row) for row in rows)

    @property
    def significant(self) -> Mask:
        """(n,) deviations that errors of measurement do not explain."""
        return self.p_value < self.limit


def _called(measured: PointSet, nominal: Nominal) -> dict[str, str]:
    """Measured names of nominal dots; one that lies at no measured one states that it is of the file."""
    if not any(dot_number(i) >= 0 for i in nominal.ids):
        return {}
    names = Dots.of(measured.ids, measured.xyz).names(nominal.ids, nominal.xyz)
    there = set(measured.ids)
    return {old: new if new in there else f"{old} (nominal)" for old, new in names.items()}


def best_fit(
    measured: PointSet, nominal: Nominal, *, by: Sequence[str] = (), scale: bool = False,
    weighting: Weighting = "covariance", significance: float = 0.05,
) -> BestFit:  # fmt: skip
    """Fit measured points onto nominal ones.

    by      points by which axes are fitted, by their names in `nominal`; (): all that both have
    scale   whether the scale is fitted as well
    Points that do not agree with the others, by the scatter of these, take no part in the fit unless `by` names them.
    Dots without a code, numbered anew in each measurement, are the same by their place (`dots`), under their measured
    names.
    raises  InputError for fewer than three points in common, or points in a line
    Limits: by which points axes ought to be fitted; a deviation of few fitted points spreads over all.
    """
    called = _called(measured, nominal)
    nominal = replace(nominal, ids=tuple(called.get(i, i) for i in nominal.ids))
    by = [called.get(i, i) for i in by]
    names, missing, fitted = _in_both(measured, nominal, by)
    m = measured.named(names)
    place = {name: k for k, name in enumerate(nominal.ids)}
    at = np.array([place[i] for i in names])
    target, own = nominal.xyz[at], nominal.sigma[at]
    free = scale or m.free_scale
    asked = tuple(i for i, f in zip(names, fitted.tolist(), strict=True) if f)
    _check_places(m.xyz[fitted], target[fitted], asked)
    found = misfit(
        m.xyz[fitted],
        target[fitted],
        scale_sigma=None if free else m.rows(np.flatnonzero(fitted)).scale_sigma(own[fitted]),
    )
    wrong: list[int] = [] if by or found.mirrored or found.scattered else np.flatnonzero(fitted)[found.wrong].tolist()
    fitted[wrong] = False
    here, transform, gain, G = _fit(m, target, own, fitted, scale=free, weighting=weighting)
    C, p = _deviations(here, target, own, fitted, G, gain)
    back = [k for k in wrong if not p[k] < significance / len(names)]
    if back:  # as the others scatter they are far off, by what they state themselves they are not
        fitted[back] = True
        here, transform, gain, G = _fit(m, target, own, fitted, scale=free, weighting=weighting)
        C, p = _deviations(here, target, own, fitted, G, gain)
        found = replace(found, fits=found.fits | np.isin(asked, [names[k] for k in back]))
    deviation, Q = here.xyz - target, here.covariance + np.diag((own**2).ravel())
    tolerance = nominal.tolerance[at]
    of_scale = G.shape[1] == 7
    size = float(np.sqrt(np.mean(np.sum((here.xyz[fitted] - here.xyz[fitted].mean(axis=0)) ** 2, axis=1))))
    K = gain @ Q[np.ix_(np.repeat(fitted, 3), np.repeat(fitted, 3))] @ gain.T
    return BestFit(
        ids=names, fitted=fitted, xyz=here.xyz, deviation=deviation, covariance=C, p_value=p,
        limit=significance / max(int(np.isfinite(p).sum()), 1), tolerance=tolerance, transform=transform,
        scale_sigma=float(np.sqrt(max(K[6, 6], 0.0))) / size if of_scale else 0.0,
        rms=float(np.sqrt(np.mean(deviation[fitted] ** 2))), weighting=weighting, missing=missing, freedom=m.freedom,
        asked=asked, misfit=found,
    )  # fmt: skip


def _in_both(
    measured: PointSet, nominal: Nominal, by: Sequence[str]
) -> tuple[tuple[str, ...], tuple[str, ...], Mask]:  # fmt: skip
    """Names that both have, those that were not measured, and by which of the first (n,) axes are to be fitted."""
    names = tuple(i for i in nominal.ids if i in set(measured.ids))
    missing = tuple(i for i in nominal.ids if i not in set(measured.ids))
    strange = [i for i in by if i not in names]
    if strange:
        raise InputError("fit.unknown_points", names=strange)
    if by and len(set(by)) < LEAST:
        raise InputError("fit.too_few_selected", n=len(set(by)), names=by, least=LEAST)
    if len(names) < LEAST:
        raise InputError("fit.too_few_common", n=len(names), nominal=len(nominal.ids), least=LEAST, missing=missing)
    return names, missing, np.isin(names, list(by)) if by else np.ones(len(names), bool)


def _check_places(measured: Array, nominal: Array, names: Sequence[str]) -> None:
    for what, xyz in (("measured", measured), ("nominal", nominal)):
        if in_one_line(xyz):
            raise InputError("fit.points_in_line", n=len(xyz), names=names, kind=what)


def _deviations(here: PointSet, target: Array, own: Array, fitted: Mask, G: Array, gain: Array) -> tuple[Array, Array]:
    """(n, 3, 3) covariances of the deviations, and their probabilities (n,)."""
    n = len(target)
    Q = here.covariance + np.diag((own**2).ravel())
    S = np.eye(3 * n)
    S[:, np.repeat(fitted, 3)] -= G @ gain
    C = (S @ Q @ S.T).reshape(n, 3, n, 3)[np.arange(n), :, np.arange(n), :]
    d = here.xyz - target
    return C, np.array([joint_test(e, c, here.freedom)[1] for e, c in zip(d, C, strict=True)])


def _verdict(length: float, uncertain: float, tolerance: float) -> Verdict:
    if not np.isfinite(tolerance):
        return ""
    if length + uncertain <= tolerance:
        return "within"
    return "beyond" if length - uncertain > tolerance else "undecided"


def _fit(
    m: PointSet, target: Array, own: Array, fitted: Mask, *, scale: bool, weighting: Weighting
) -> tuple[PointSet, SimilarityTransform, Array, Array]:
    """Points in nominal axes, how they came there, the parameters' gain (g, rows) and their directions (3 n, g)."""
    start = similarity(m.xyz[fitted], target[fitted], scale=None if scale else 1.0)
    transform = SimilarityTransform(scale=start.scale, rotation=start.rotation, translation=start.translation)
    rows = np.repeat(fitted, 3)
    here, gain, G = m, np.zeros((0, 0)), np.zeros((0, 0))
    for _ in range(ROUNDS):
        here = m.moved(transform)
        size = float(np.sqrt(np.mean(np.sum((target - target.mean(axis=0)) ** 2, axis=1))))
        G = datum_directions(here.xyz, scale=scale, about=fitted).reshape(len(rows), -1)
        gain = _gain(here, own, G, rows, weighting)
        if weighting == "equal":
            break  # the closed form is the end
        wanted = here.xyz.ravel() - G @ (gain @ (here.xyz - target).ravel()[rows])
        step = similarity(here.xyz, wanted.reshape(-1, 3), scale=None if scale else 1.0)
        transform = SimilarityTransform(
            scale=step.scale * transform.scale, rotation=step.rotation @ transform.rotation,
            translation=step.scale * step.rotation @ transform.translation + step.translation,
        )  # fmt: skip
        if np.abs(wanted - here.xyz.ravel()).max() < STILL * size:
            break
    return here, transform, gain, G


def _gain(here: PointSet, own: Array, G: Array, rows: Mask, weighting: Weighting) -> Array:
    Gf = G[rows]
    if weighting == "equal":
        return np.linalg.pinv(Gf)
    Q = here.covariance[np.ix_(rows, rows)] + np.diag((own**2).ravel()[rows])
    Q = Q + Gf @ Gf.T * (np.trace(Q) / max(float(np.trace(Gf @ Gf.T)), 1e-300))
    try:
        half = np.linalg.inv(np.linalg.cholesky(Q))
    except np.linalg.LinAlgError:
        raise InputError("fit.covariance_singular") from None
    return np.linalg.pinv(half @ Gf) @ half
