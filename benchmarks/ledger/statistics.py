"""Coverage, chi-square and their intervals, of one group of errors and pooled over sets."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from renderer.judging import robust_chi_square
from scipy.special import digamma
from scipy.stats import chi2, spearmanr, t

from .errors import Array, Errors

LEVELS = {"68": 0.6826894921370859, "95": 0.95, "99.7": 0.9973002039367398}
"""Probabilities whose intervals are judged: one, 1.96 and three standard deviations"""
WITHIN = {"68": 1.0, "95": 1.959963984540054, "99.7": 3.0}
FEWEST = 5
"""Runs, or sets, from which on their scatter gives an interval"""
BOUND = 1e-12
"""Least chi-square whose logarithm is taken"""


def statistics(errors: Errors) -> dict[str, Any]:
    """Figures of one group.

    Intervals are of 95 %.  That of chi-square comes from the scatter of the runs where there are five or more, and from
    the whole covariance of a single run where that is known; otherwise there is none, since errors of one run are
    correlated.  `degrees` is the number of independent errors that the group has at most.
    """
    size = np.abs(errors.ratio)
    runs = _by_draw(errors)
    degrees = _degrees(errors, len(runs))
    found: dict[str, Any] = {
        "module": errors.module, "label": errors.label, "method": errors.method, "flagged": errors.flagged,
        "n": len(size), "runs": len(runs), "degrees": degrees,
        "chi_square": _rounded(np.mean(size**2)), "robust_chi_square": _rounded(robust_chi_square(size)),
        "beyond_5": _rounded(np.mean(size > 5)), "sigma_median": float(f"{np.median(errors.sigma):.4g}"),
        "unit": errors.unit,
        "coverage": {name: _rounded(np.mean(size <= w), 5) for name, w in WITHIN.items()},
        "coverage_interval": {name: _share_interval(runs, w, degrees) for name, w in WITHIN.items()},
        "spearman": _rank(errors),
    }  # fmt: skip
    found["chi_square_interval"] = _chi_square_interval(errors, runs)
    if errors.joint:
        d2, d = np.array(errors.joint).sum(axis=0)
        found["joint_chi_square"] = _rounded(d2 / d)
        found["joint_interval"] = [_rounded(d2 / chi2(d).ppf(q)) for q in (0.975, 0.025)]
    names = np.array(errors.coordinate)
    if 1 < len(set(errors.coordinate)) <= 24:
        found["by_coordinate"] = {str(k): _rounded(np.mean(size[names == k] ** 2)) for k in dict.fromkeys(names)}
    return found


def _by_draw(errors: Errors) -> list[Array]:
    draw = errors.draw if len(errors.draw) else np.zeros(len(errors.ratio), np.int64)
    return [np.abs(errors.ratio[draw == k]) for k in np.unique(draw)]


def _degrees(errors: Errors, runs: int) -> int:
    """Independent errors at most: those of the whole covariances, or all coordinates."""
    return int(sum(d for _, d in errors.joint)) if len(errors.joint) == runs else len(errors.ratio)


def _share_interval(runs: Sequence[Array], within: float, degrees: int) -> list[float] | None:
    """Interval of a share: by the scatter of runs; of one run with a known covariance that of Wilson (1927)."""
    inside = np.array([(r <= within).sum() for r in runs], float)
    count = np.array([len(r) for r in runs], float)
    p = inside.sum() / count.sum()
    if len(runs) >= FEWEST:
        half = _half_of_ratio(inside, count)
        return [_rounded(max(p - half, 0), 5), _rounded(min(p + half, 1), 5)]
    if degrees >= count.sum():
        return None
    z = WITHIN["95"]
    middle, root = p + z**2 / 2 / degrees, z * np.sqrt(p * (1 - p) / degrees + z**2 / 4 / degrees**2)
    return [_rounded((middle + s * root) / (1 + z**2 / degrees), 5) for s in (-1, 1)]


def _chi_square_interval(errors: Errors, runs: Sequence[Array]) -> list[float] | None:
    total, count = np.array([(r**2).sum() for r in runs]), np.array([len(r) for r in runs], float)
    if len(runs) >= FEWEST:
        middle, half = total.sum() / count.sum(), _half_of_ratio(total, count)
        return [_rounded(max(middle - half, 0)), _rounded(middle + half)]
    if errors.joint:
        d2, d = np.array(errors.joint).sum(axis=0)
        scale = np.mean(errors.ratio**2) / (d2 / d)
        return [_rounded(scale * d2 / chi2(d).ppf(q)) for q in (0.975, 0.025)]
    return None


def _half_of_ratio(part: Array, whole: Array) -> float:
    """Half the 95 % interval of sum(part) / sum(whole) by the scatter of its clusters (linearised)."""
    n, ratio = len(part), part.sum() / whole.sum()
    off = part - ratio * whole
    variance = n / (n - 1) * float((off**2).sum()) / whole.sum() ** 2
    return float(t(n - 1).ppf(0.975) * np.sqrt(variance))


def _rank(errors: Errors) -> float | None:
    if len(errors.ratio) < 30 or np.ptp(errors.sigma) < 1e-9 * np.max(errors.sigma):
        return None
    if not errors.unit:  # quantities of several units have no common rank
        return None
    return _rounded(float(np.asarray(spearmanr(np.abs(errors.ratio * errors.sigma), errors.sigma))[0]), 3)


def pooled(groups: Mapping[str, Sequence[Mapping[str, Any]]]) -> dict[str, Any] | None:
    """Figures over sets, each with one vote: sets are the clusters, since errors within one are correlated.

    groups   set -> its groups (`statistics`) of one module, unflagged, of one method
    returns  means over the sets with 95 % intervals from the scatter between them; None for fewer than two sets

    Chi-squares are averaged as logarithms, so that one that is far off does not hide the others; the expectation of the
    logarithm for so few degrees of freedom is taken off.  Coverages are averaged as they are.
    """
    rows = [_together(of_set) for of_set in groups.values()]
    if len(rows) < 2:
        return None
    out: dict[str, Any] = {"sets": len(rows), "n": int(sum(r["n"] for r in rows))}
    for name in LEVELS:
        out[f"coverage_{name}"] = _mean_and_interval(np.array([r[name] for r in rows]))
    logs = np.array([r["log_chi_square"] for r in rows])
    out["chi_square"] = [_rounded(np.exp(x)) for x in _mean_and_interval(logs, 12)]
    logs = np.log(np.maximum([r["robust"] for r in rows], BOUND))
    out["robust_chi_square"] = [_rounded(np.exp(x)) for x in _mean_and_interval(logs, 12)]
    out["beyond_5"] = _rounded(np.mean([r["beyond_5"] for r in rows]), 5)
    return out


def _together(groups: Sequence[Mapping[str, Any]]) -> dict[str, float]:
    """All groups of one set, by their numbers of coordinates."""
    n = np.array([g["n"] for g in groups], float)

    def mean(values: Sequence[float]) -> float:
        return float((n * np.array(values)).sum() / n.sum())

    degrees = min(sum(g["degrees"] for g in groups), n.sum())
    bias = float(digamma(degrees / 2) - np.log(degrees / 2))
    chi = max(mean([g["chi_square"] for g in groups]), BOUND)
    return {
        "n": float(n.sum()), "log_chi_square": float(np.log(chi)) - bias,
        "robust": mean([g["robust_chi_square"] for g in groups]), "beyond_5": mean([g["beyond_5"] for g in groups]),
        **{name: mean([g["coverage"][name] for g in groups]) for name in LEVELS},
    }  # fmt: skip


def _mean_and_interval(values: Array, digits: int = 5) -> list[float]:
    n = len(values)
    middle = float(np.mean(values))
    half = float(t(n - 1).ppf(0.975) * np.std(values, ddof=1) / np.sqrt(n))
    return [_rounded(middle, digits), _rounded(middle - half, digits), _rounded(middle + half, digits)]


def coordinates_needed(wrong: float = 1.1, power: float = 0.9) -> int:
    """Independent coordinates at which chi-square (95 %, two-sided) detects a factor of all sigmas with this power."""
    for n in range(10, 100_000, 10):
        low, high = chi2(n).ppf(0.025), chi2(n).ppf(0.975)
        of_small = chi2(n).sf(high / wrong**2)  # sigma stated too small by the factor
        of_large = chi2(n).cdf(low * wrong**2)
        if min(of_small, of_large) >= power:
            return n
    raise ValueError(f"a factor of {wrong} needs more than 100 000 coordinates")


def _rounded(x: float, digits: int = 4) -> float:
    return float(f"{float(x):.{digits}g}") if digits < 12 else float(x)
