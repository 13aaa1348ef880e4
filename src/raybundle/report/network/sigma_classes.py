"""Classes of standard deviations for maps in colours: by what was wanted where something was, else by their number."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array

SHADES = ("#234b7a", "#3f8fa6", "#8fb58a", "#d9c15a", "#b8862d")
"""From small to large, where nothing states what is good: no red among them"""
GOOD, MISSED = SHADES[:3], ("#e0683f", "#a01c1c")
"""Up to what was wanted, and above it"""
UNKNOWN = "#999999"
STEPS = (1 / 2, 1 / math.sqrt(2), 1.0, math.sqrt(2))
"""Limits of the classes by what was wanted.  A standard deviation falls with the root of the observations: a step of
the root of two is that of twice as many photographs, half of what was wanted that of four times as many"""
PLACES = ("far_below", "below", "just_below", "above", "far_above")
DIGITS = 2
"""In print; what prints alike is one class"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Classes:
    """Colours of numbers."""

    limits: tuple[float, ...]
    """Of the classes but the last, rising; a number belongs to the first whose limit it does not exceed"""
    colours: tuple[str, ...]
    """Of the classes"""
    legend: tuple[tuple[str, str], ...]
    """Colour and words; "" for a line without a colour"""

    def reported(self) -> dict[str, Any]:
        """As the page takes it."""
        return {"limits": list(self.limits), "colours": list(self.colours), "legend": [list(x) for x in self.legend]}


def sigma_classes(values: Array, unit: str, wanted: float | None = None, unknown: str = "") -> Classes | None:
    """Classes of standard deviations of a coordinate (n,), NaN where there is none; None where there is none at all.

    wanted   what was wanted, in the unit of the values; None: nothing was
    unknown  why there may be none, for the legend; empty: nothing is stated of those
    The legend ends with the largest of them.
    """
    known = values[np.isfinite(values)]
    if not len(known):
        return None
    worst = float(known.max())
    found = _by_number(known, unit) if wanted is None else _by_wanted(known, unit, wanted)
    last: list[tuple[str, str]] = [("", phrase("sigma_class.worst", sigma=worst, unit=unit))]
    if unknown and len(known) < len(values):
        last.append((UNKNOWN, unknown))
    return Classes(limits=found.limits, colours=found.colours, legend=(*found.legend, *last))


def _by_number(known: Array, unit: str) -> Classes:
    """Five classes of equal number, less those whose limits print alike."""
    limits = list[tuple[float, float]]()
    top = _printed(float(known.max()))
    for share in (0.2, 0.4, 0.6, 0.8):
        value = float(np.quantile(known, share, method="lower"))
        shown = _printed(value)
        if shown != top and shown not in [v for v, _ in limits]:
            limits.append((shown, _last_alike(value)))
    n = len(limits)
    shades = tuple(SHADES[round(k * (len(SHADES) - 1) / max(n, 1))] for k in range(n + 1))
    words = [phrase("sigma_class.to", limit=v, unit=unit) for v, _ in limits]
    last = phrase("sigma_class.above", limit=limits[-1][0], unit=unit) if limits else (
        phrase("sigma_class.all", sigma=top, unit=unit)
    )  # fmt: skip
    legend = (("", phrase("sigma_class.head")), *zip(shades, [*words, last], strict=True))
    return Classes(limits=tuple(v for _, v in limits), colours=shades, legend=legend)


def _printed(value: float) -> float:
    """A number as it is printed."""
    return float(f"{value:.{DIGITS}g}")


def _last_alike(value: float) -> float:
    """The largest number that prints as this one does."""
    if value <= 0:
        return 0.0
    step = 10.0 ** (math.floor(math.log10(value)) - DIGITS + 1)
    return (round(value / step) + 0.5) * step * (1 - 1e-6)


def _by_wanted(known: Array, unit: str, wanted: float) -> Classes:
    """Three classes up to what was wanted and two above it; the legend has those that occur, and what was wanted."""
    # numbers are drawn in single precision
    limits = np.array(STEPS) * wanted * (1 + 1e-6)
    there = np.unique(np.searchsorted(limits, known, side="left"))
    colours = (*GOOD, *MISSED)
    words = [
        phrase("sigma_class.by_wanted", place=p, limit=s * wanted, unit=unit)
        for p, s in zip(PLACES, STEPS, strict=False)
    ]
    words.append(phrase("sigma_class.far_above"))
    legend = (
        ("", phrase("sigma_class.head_wanted", wanted=wanted, unit=unit)),
        *((colours[k], words[k]) for k in there.tolist()),
    )
    return Classes(limits=tuple(limits.tolist()), colours=colours, legend=legend)
