"""What two results have in common of their observations, and what their differences have for a variance by that.

Of estimates from the same observations the errors are nearly the same, and cancel in the difference: that of two
independent results, s1^2 + s2^2, is far too large.  Where the observations of one are part of the other's, with the
same weights, the larger one is the best linear unbiased estimate from all of them, so that its covariance with the
other is its own variance, and the difference has s2^2 - s1^2 (Hausman 1978; of parameters that one holds, alike).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, cast

import numpy as np

from raybundle.errors import Message, Text, note, phrase
from raybundle.numerics.arrays import Array
from raybundle.report.comparison.sameness import all_same
from raybundle.results.folder import ResultFolder

UNCERTAIN = 1.1
"""Factor of a standard deviation below which it is good for every use (GUM 7.2.6, as `severity.NEARLY`)."""
ALONE = (UNCERTAIN**2 - 1) / (UNCERTAIN**2 + 1)
"""Share of what the smaller one has alone, by what the larger one has, up to which it counts as part of the larger.

Of means of n1 and n2 values, a and b of them in one alone, the difference has the variance (a + b) / (n1 n2), and
s2^2 - s1^2 is (b - a) / (n1 n2): the ratio is that factor squared at a / b of this."""
LEAST_VARIANCE = 1e-3
"""Share of a variance below which a difference of two variances shows nothing: they are linearised at two places."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Shared:
    """What of their image observations two results share, those that take part."""

    common: int
    """in both, with the same weights"""
    used: tuple[int, int]
    part: Literal["", "first", "second"]
    """which of the two rests on a part of the other's observations; "": neither does"""
    sigma0: tuple[float, float] = (1.0, 1.0)
    """noise factors that the standard deviations carry"""
    noise: tuple[Message, ...] = ()
    """on noise models that differ"""
    same: bool = False
    """whether all tables of the two are the same to the last bit"""

    @property
    def too_large(self) -> bool:
        """Whether the root of the sum of both variances is too large to be used, by more than `UNCERTAIN`.

        Of means: (n1 + n2) / (n1 + n2 - 2 common), squared.
        """
        alone = sum(self.used) - 2 * self.common
        return not self.same and not self.part and sum(self.used) > UNCERTAIN**2 * alone

    @property
    def meaning(self) -> Message:
        """What the standard deviations of the tables are."""
        return note("report_compare.sigma_meaning", part=bool(self.part))

    def std(self, first: Array, second: Array) -> Array:
        """Standard deviations of differences, from those of both; NaN where nothing is to be expected or is known."""
        one, two = first**2, second**2
        if not self.part:
            return np.sqrt(one + two)
        s = self.sigma0
        whole = 1 if self.part == "first" else 0
        factors = [(s[whole] / k) ** 2 if k > 0 and s[whole] > 0 else 1.0 for k in s]
        parts = (factors[0] * one, factors[1] * two)
        more = parts[1 - whole] - parts[whole]
        return np.sqrt(np.where(more > LEAST_VARIANCE * parts[1 - whole], more, np.nan))

    @property
    def sentences(self) -> tuple[Text, ...]:
        """What the head of the page has of it."""
        if self.same:
            return (phrase("report_compare.same"),)
        found: list[Text] = []
        first, second = self.used
        if self.part:
            found.append(
                phrase(
                    "report_compare.part_of_other", n=self.common, used_first=first, used_second=second, part=self.part
                )
            )
        elif self.too_large:
            found.append(phrase("report_compare.not_independent", n=self.common, used_first=first, used_second=second))
        return (*found, *([Text.of(*self.noise)] if self.noise else []))


def shared_of(first: ResultFolder, second: ResultFolder) -> Shared:
    """What two results share.

    The observations of one are part of the other's where it has no others to speak of (`ALONE`), all else that was
    observed and the datum are the same, no parameter is free that the other holds the other way round, and errors of
    image coordinates count as independent in both: what smooth errors add to variances is no estimate's own.
    """
    a, b = _weights(first), _weights(second)
    common = sum(1 for k in a.keys() & b.keys() if math.isclose(a[k], b[k], rel_tol=UNCERTAIN - 1))
    used = len(a), len(b)
    alone = used[0] - common, used[1] - common
    kinds = [str(_noise(r).get("kind", "white")) for r in (first, second)]
    part: Literal["", "first", "second"] = ""
    if common and kinds == ["white", "white"] and _beside(first) == _beside(second):
        free = _free(first), _free(second)
        if alone[0] <= ALONE * alone[1] and free[0] >= free[1] and (any(alone) or free[0] != free[1]):
            part = "first"
        elif alone[1] <= ALONE * alone[0] and free[1] >= free[0] and (any(alone) or free[0] != free[1]):
            part = "second"
    s = [float(r.result.get("sigma0") or math.nan) for r in (first, second)]
    noise = _noise_notes(first, second)
    named = first.block.points.ids == second.block.points.ids
    same = named and not noise and all_same(first.path, second.path)
    return Shared(common=common, used=used, part=part, sigma0=(s[0], s[1]), noise=noise, same=same)


def _weights(folder: ResultFolder) -> dict[tuple[str, int, int], float]:
    """Standard deviation [px] of each image observation that takes part, by image and place to 0.01 px."""
    o = folder.observations
    x, y = (np.rint(100 * o.number[n]).astype(np.int64).tolist() for n in ("x_px", "y_px"))
    sigma = np.sqrt(o.number["sx_px"] * o.number["sy_px"]).tolist()
    rows = zip(o.text["image"], x, y, o.text["rejected"], sigma, strict=True)
    return {(i, j, k): s for i, j, k, rejected, s in rows if not rejected}


def _beside(folder: ResultFolder) -> tuple[object, ...]:
    """What was observed beside image points, as far as it has to be the same, and the datum."""
    r, p, d = folder.result, folder.block.points, folder.block.distances
    control = np.flatnonzero(np.asarray(p.is_control).any(axis=1)).tolist()
    others = float(r.get("observations") or 0) - 2 * float(r.get("image_points_used") or 0)
    sigma = sorted((p.ids[k], *np.nan_to_num(p.sigma[k]).tolist()) for k in control)
    bars = sorted(
        zip([p.ids[k] for k in d.start.tolist()], [p.ids[k] for k in d.end.tolist()], d.sigma.tolist(), strict=True)
    )
    return r.get("datum"), others, sigma, bars


def _noise(folder: ResultFolder) -> Mapping[str, Any]:
    return cast("Mapping[str, Any]", folder.result.get("noise") or {})


def _noise_notes(first: ResultFolder, second: ResultFolder) -> tuple[Message, ...]:
    """What noise models that differ do to standard deviations; () where they do not."""
    a, b = (str(_noise(r).get("kind", "white")) for r in (first, second))
    factors = [float(_noise(r).get("ratio_points") or 1.0) for r in (first, second)]
    if a == b and max(factors) <= UNCERTAIN * min(factors):
        return ()
    return (
        note("report_compare.noise_models", same=a == b, first=a, second=b),
        note("report_compare.noise_ratios", first=factors[0], second=factors[1]),
    )


def _free(folder: ResultFolder) -> frozenset[tuple[str, str]]:
    """Camera and symbol of the parameters that were estimated."""
    cameras = cast("Mapping[str, Mapping[str, Mapping[str, Any]]]", folder.result.get("cameras") or {})
    return frozenset(
        (c, s) for c, values in cameras.items() for s, p in values.items() if float(p.get("std") or 0.0) > 0
    )
