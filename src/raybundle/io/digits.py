"""With how many digits a number is written: those that it deserves.

What an adjustment reads again (a block, a list of positions, a calibration) is written so that it reads back equal:
`EVERY`.  What came of one is written so that rounding is lost in what is not known anyway: a number with a standard
deviation is moved by no more than `PART` of it.  The numbers are rounded here, to the nearest that has so many digits;
written shortest, as `raybundle.io.rows` does, they have no others.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, cast

import numpy as np

from raybundle.numerics.arrays import Array
from raybundle.numerics.deviations import PAIRS

PART = 1e-3
"""Of its standard deviation, by which rounding may move a number: it adds less than PART^2 to the variance of what is
computed from the number, and nothing that shows to the difference of two results."""
NETWORK = 1e-10
"""Of the extent of a network along an axis, by which rounding may move a point of it."""
LEAST = 1e-12
"""Least eigenvalue of a correlation matrix that is taken for more than rounding."""
EXACT = 2.0**53
"""Above it floating-point numbers are whole, and there is nothing to round."""
EARTH_M = 6378137.0
"""Largest geocentric coordinate of a point on the earth"""
ROUNDING = 2.0**-48
"""Of the largest of several numbers, by which some ten operations may be wrong in each"""
FINEST = 22
"""Places to which numbers are rounded by a power of ten, which up to this one are exact."""
_POWERS = np.array([float(f"1e{k}") for k in range(FINEST + 1)])


class Digits(Protocol):
    """How the numbers of a column are rounded."""

    def of(self, values: Array, rows: slice = slice(None)) -> Array:
        """The rounded numbers (n,) that stand in these rows of the column; NaN stays."""
        ...


@dataclass(frozen=True, slots=True)
class Every:
    """All digits: the numbers read back equal."""

    def of(self, values: Array, rows: slice = slice(None)) -> Array:
        """The numbers themselves."""
        del rows
        return values


@dataclass(frozen=True, slots=True)
class Places:
    """So many decimal places, more where a number would have fewer than `figures` significant digits."""

    places: int
    figures: int = 0

    def of(self, values: Array, rows: slice = slice(None)) -> Array:
        """The rounded numbers (n,)."""
        del rows
        if not self.figures:
            return _to_places(values, np.full(len(values), float(self.places)))
        return _significant(values, self.figures, self.places)


@dataclass(frozen=True, slots=True)
class Figures:
    """So many significant digits."""

    figures: int

    def of(self, values: Array, rows: slice = slice(None)) -> Array:
        """The rounded numbers (n,)."""
        del rows
        return _significant(values, self.figures, None)


@dataclass(frozen=True, slots=True, eq=False)
class Within:
    """As few places as change no number by more than its limit; all digits where the limit is 0 or not known."""

    limit: Array
    """(rows,) of the whole column"""

    def of(self, values: Array, rows: slice = slice(None)) -> Array:
        """The rounded numbers (n,)."""
        return _to_places(values, _places(self.limit[rows]))


EVERY = Every()
COUNT = Places(0)
STD = Figures(6)
"""Standard deviations and smallest detectable blunders: of the redundancy r they are known to 1 / sqrt(2 r), and six
digits are below that up to r = 10^10."""
REDUNDANCY = Places(5, figures=3)
"""Redundancy numbers lie between 0 and 1; where one is small, w = v / (s sqrt r) hangs on its first digits."""
TEST = Places(3)
"""Normed residuals, t, F: their standard deviation is 1, so that the third place is PART of it."""
PROBABILITY = Places(5, figures=3)
SETTING = Places(3)
"""Directions to which something is to be set [deg]: 4 seconds, below what a tripod's level shows."""
PIXEL = Places(5)
"""Image coordinates of a result, which stand in its block with all digits: 10^-5 px is a hundredth of what the best
targets are measured to, and of noise in results from different weights the same point stays the same."""
SHORT = Figures(12)
"""What was given, and was converted since from the unit of its file; figures of which some are coordinates of maps."""
SHARE = Figures(8)
"""What programs are compared by, sigma0 first, and numbers without a standard deviation: ratios, sums."""


def exacts(values: Sequence[float] | Array) -> str:
    """Numbers in brackets, as TOML and Python have them, that read back equal."""
    return f"[{', '.join(exact(v) for v in values)}]"


def by_sigma(sigma: Array, part: float = PART) -> Within:
    """Numbers with the standard deviations sigma (n,)."""
    return Within(part * np.abs(sigma))


def of_places(xyz: Array, at: Array) -> Within:
    """Places (n, 3) from which `at` (n, 3) is looked at: no camera is set up to a millionth of the distance."""
    return Within(0.5e-6 * np.linalg.norm(at - xyz, axis=1))


def of_residual(v: Array, w: Array) -> Digits:
    """Residuals v (n,) with their normed ones w: v / w is the standard deviation of v.

    Where nothing controls the observation w is NaN, and v is rounding: all digits.
    """
    with np.errstate(all="ignore"):
        return by_sigma(np.where(w != 0, v / w, np.nan))


def jointly(covariance: Array) -> list[Within]:
    """Rules for the k numbers of each row with covariances (n, k, k): all together are moved by no more than PART.

    A number that is strongly correlated with others is rounded by what would remain of its standard deviation if they
    were known: what is computed from all of them may be known far better than each.  With P the inverse, rounding e
    moves no function by more than sqrt(e P e) <= sum |e_i| sqrt(P_ii) of its standard deviation.
    """
    alone = _alone(covariance)
    count = max(alone.shape[1], 1)
    return [by_sigma(alone[:, k], PART / count) for k in range(alone.shape[1])]


def in_network(rules: Sequence[Within], xyz: Array) -> list[Within]:
    """The same rules for the coordinates (n, 3) of points of one network, of which distances are taken.

    What lies between points may be known far better than where they are: the scale of a weak datum, as of a receiver
    held in the hand, is in the standard deviation of each, and in that of no distance.  No network is known better than
    to one in a million of its extent, and PART of that, and as much again for sums of many, is NETWORK.
    """
    known = xyz[np.isfinite(xyz).all(axis=1)]
    least = NETWORK * np.ptp(known, axis=0) if len(known) else np.zeros(len(rules))
    return [Within(np.fmin(rule.limit, v)) for rule, v in zip(rules, least.tolist(), strict=True)]


def computed(rules: Sequence[Within], values: Array) -> list[Within]:
    """The same rules for numbers (n, k) that were computed: what is below the rounding of the largest is lost."""
    least = ROUNDING * float(np.nanmax(np.abs(values), initial=0.0))
    return [Within(np.maximum(rule.limit, least)) for rule in rules]


def brought(count: int, unit: float) -> Within:
    """Coordinates that were brought from a system of the earth to a local frame and back; one is `unit` metres.

    What was given stands there again: geocentric coordinates on the way lose what is below their rounding.
    """
    return Within(np.full(count, ROUNDING * EARTH_M / unit))


def of_correlations(covariance: Array) -> Array:
    """(n,) by how much correlation coefficients of matrices (n, k, k) may change: no standard deviation then by PART.

    Coefficients each wrong by d change a variance by less than k d / (least eigenvalue) of it.
    """
    R = _correlations(covariance)
    least = np.linalg.eigvalsh(R)[:, 0] if R.size else np.ones(len(R))
    return 2 * PART * np.maximum(least, LEAST) / max(R.shape[1], 1)


def of_pairs(covariance: Array) -> list[Within]:
    """Rules for the three correlation coefficients of covariances (n, 3, 3), in the order of `PAIRS`."""
    limit = of_correlations(covariance)
    return [Within(limit)] * len(PAIRS)


def of_covariances(covariance: Array) -> list[Within]:
    """Rules for the three covariances of (n, 3, 3), in the order of `PAIRS`."""
    limit = of_correlations(covariance)
    std = np.sqrt(np.maximum(np.diagonal(covariance, axis1=1, axis2=2), 0))
    return [Within(limit * std[:, i] * std[:, j]) for i, j in PAIRS]


def one(value: float, digits: Digits) -> float:
    """A single number, rounded."""
    return float(digits.of(np.array([value], float))[0])


def reported(value: Any, digits: Digits = SHARE) -> Any:
    """A nested value as files of figures show it: all its numbers that are not whole rounded."""
    if isinstance(value, Mapping):
        return {k: reported(v, digits) for k, v in cast("Mapping[Any, Any]", value).items()}
    if isinstance(value, list | tuple):
        return [reported(v, digits) for v in cast("Sequence[Any]", value)]
    return one(float(cast("float", value)), digits) if isinstance(value, float | np.floating) else value


def exact(value: float) -> str:
    """A number as a text that reads back equal: the shortest one."""
    return repr(float(value))


def _places(limit: Array) -> Array:
    """(n,) places to which rounding changes a number by no more than its limit; NaN where there is none."""
    with np.errstate(all="ignore"):
        places = np.ceil(-np.log10(2 * limit) - 1e-9)
    return np.where(np.isfinite(places), places, np.nan)


def _significant(values: Array, figures: int, least: int | None) -> Array:
    """Rounded to significant digits, or to `least` places where that is more."""
    size = np.abs(values)
    with np.errstate(all="ignore"):
        places = figures - 1 - np.floor(np.log10(size))
    if least is not None:
        places = np.maximum(places, least)
    found = _to_places(values, np.where(np.isfinite(places), places, np.nan))
    for k in np.flatnonzero((places > FINEST) & (size > 0) & np.isfinite(size)).tolist():
        found[k] = float(f"{values[k]:.{figures - 1}e}")
    return found


def _to_places(values: Array, places: Array) -> Array:
    """The nearest numbers with so many places (n,), negative ones before the point; as they are where that is NaN.

    A whole number divided by an exact power of ten is the floating-point number nearest to the decimal fraction, which
    therefore is its shortest text.
    """
    known = np.isfinite(places) & np.isfinite(values)
    p = np.where(known, np.clip(places, -FINEST, FINEST), 0).astype(np.int64)
    power = _POWERS[np.abs(p)]
    with np.errstate(over="ignore", invalid="ignore"):
        scaled = values * power
        found = np.rint(scaled) / power
        if (p < 0).any():
            scaled = np.where(p < 0, values / power, scaled)
            found = np.where(p < 0, np.rint(scaled) * power, found)
        good = known & (places <= FINEST) & (np.abs(scaled) < EXACT)
    return np.where(good, found + 0.0, values)  # no -0


def _correlations(covariance: Array) -> Array:
    """Correlation matrices (n, k, k); what is held or not known is correlated with nothing."""
    std = np.sqrt(np.maximum(np.nan_to_num(np.diagonal(covariance, axis1=1, axis2=2)), 0))
    with np.errstate(all="ignore"):
        R = covariance / (std[:, :, None] * std[:, None, :])
    R = np.where(np.isfinite(R), R, 0.0)
    k = np.arange(R.shape[1])
    R[:, k, k] = 1.0
    return R


def _alone(covariance: Array) -> Array:
    """(n, k) standard deviations that numbers would have if the others of their row were known; 0 where held."""
    std = np.sqrt(np.maximum(np.nan_to_num(np.diagonal(covariance, axis1=1, axis2=2)), 0))
    if not std.size:
        return std
    values, vectors = np.linalg.eigh(_correlations(covariance))
    inverse = np.sum(vectors**2 / np.maximum(values, LEAST)[:, None, :], axis=2)
    return std / np.sqrt(inverse)


def rounded(values: Sequence[str] | Array, digits: Digits, rows: slice) -> Sequence[str] | Array:
    """Rows of a column: texts as they are, numbers rounded."""
    part = values[rows]
    return digits.of(np.asarray(part, float), rows) if isinstance(part, np.ndarray) else part
