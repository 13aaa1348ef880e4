"""A wanted accuracy: figures in metres or a class of ASPRS, and whether the check points keep it.

ASPRS Positional Accuracy Standards for Digital Geospatial Data, Edition 2, Version 2 (2024): a class is the largest
RMSE_H or RMSE_V, in centimetres; a product is *tested* by 30 check points or more (`accuracy.required_check_points`),
else it is *produced to meet* its class, which is stated where nothing that is known of the result denies it.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from typing import Literal

from scipy.special import chdtri

from raybundle.adjustment.blunders.accuracy import Accuracy
from raybundle.errors import InputError

FEWEST = 5
"""Check points below which figures in metres are not called kept: a standard deviation from four or fewer is uncertain
by more than 40 % of itself (GUM, table E.1)."""
LEVEL = 0.05
"""Probability with which too few check points deny an accuracy that is kept"""
_UNITS = {"": 1.0, "m": 1.0, "cm": 0.01, "mm": 0.001}
_LENGTH = re.compile(r"([0-9]*\.?[0-9]+(?:[eE]-?[0-9]+)?)\s*(m|cm|mm|)")
_ASPRS = "asprs:"

Part = Literal["horizontal", "vertical"]
Why = Literal["", "none", "few", "untested", "unsurveyed", "heights", "precision", "left out"]


@dataclass(frozen=True, slots=True, kw_only=True)
class AccuracyClass:
    """The largest RMSE that is allowed [m]."""

    horizontal: float | None
    """of the plan, both axes together; None: nothing is asked for"""
    vertical: float | None
    asprs: bool
    """whether it is a class of ASPRS"""


def accuracy_class(text: str) -> AccuracyClass | None:
    """What a setting asks for; None where it is empty.

    text    "0.03", "0.03,0.05" (plan, height; metres, or with mm or cm), "-,0.05" (height alone), "asprs:2.5cm,5cm"
    raises  InputError for anything else
    """
    words = text.strip()
    if not words:
        return None
    asprs = words.lower().startswith(_ASPRS)
    parts = [p.strip() for p in (words[len(_ASPRS) :] if asprs else words).split(",")]
    parts = parts * 2 if len(parts) == 1 else parts
    lengths = [None if p == "-" else _length(p) for p in parts]
    if asprs and any(p != "-" and p[-1:].isdigit() for p in parts):
        raise InputError("accuracy_class.no_unit", text=text)
    if len(lengths) != 2 or lengths == [None, None] or any(v is not None and not 0 < v < 1e6 for v in lengths):
        raise InputError("accuracy_class.not_readable", text=text)
    return AccuracyClass(horizontal=lengths[0], vertical=lengths[1], asprs=asprs)


def _length(word: str) -> float:
    found = _LENGTH.fullmatch(word)
    return float(found[1]) * _UNITS[found[2]] if found else math.nan


@dataclass(frozen=True, slots=True, kw_only=True)
class Judged:
    """Plan or height against what is wanted."""

    part: Part
    wanted: float
    """[m]"""
    found: float
    """RMSE with that of the check points [m]; NaN where there are none"""
    points: int
    needed: int
    """check points without which nothing is called kept"""
    kept: bool | None
    """None: it cannot be judged"""
    why: Why
    """why it cannot: no check point has it, too few, of ASPRS fewer than make a test, no height was given; or what
    denies it in place of check points: standard deviations, control left out"""
    stated: float = math.nan
    """RMSE that standard deviations promise, of the better half of the object points at least [m]"""
    left_out: float = math.nan
    """RMSE of control had each point taken no part [m]; NaN below FEWEST of them"""

    @property
    def claimable(self) -> bool:
        """Whether a result may be stated to be made for it: nothing that is known of it states otherwise."""
        if self.kept:
            return True
        known = [v for v in (self.found, self.stated, self.left_out) if math.isfinite(v)]
        return self.kept is None and self.why != "heights" and bool(known) and max(known) <= self.wanted


def judged(accuracy: Accuracy, wanted: AccuracyClass, *, heights: bool = True) -> tuple[Judged, ...]:
    """Whether the result keeps what is wanted, the plan first.

    heights  whether any height was given; where none was, nothing is stated of them

    Kept: RMSE, the check points' own standard deviations in it, is no larger than wanted, of enough check points.  Not
    kept: it is larger at FEWEST check points or more, and with fewer so much larger that errors of the wanted size
    would make it with a probability of 5 % at most (chi-square of as many degrees of freedom as there are
    differences).  Where check points cannot judge, a result is denied by its own standard deviations: those of half of
    its object points are larger than wanted.  Else it cannot be judged; control left out (FEWEST points or more) then
    states whether it may be claimed (`Judged.claimable`).
    """
    metres = 0.001 if accuracy.result.given.length_unit == "mm" else 1.0
    reported: list[Judged] = []
    parts: tuple[tuple[Part, float | None], ...] = (("horizontal", wanted.horizontal), ("vertical", wanted.vertical))
    for part, limit in parts:
        if limit is None:
            continue
        j = _by_check_points(accuracy, part, limit, metres, asprs=wanted.asprs)
        if part == "vertical" and not heights:
            reported.append(replace(j, kept=None, why="heights", found=math.nan, points=0))
            continue
        stated, left_out = metres * accuracy.promised(part), metres * accuracy.rmse_left_out(part, FEWEST)
        j = replace(j, stated=stated, left_out=left_out)
        if j.kept is None and stated > limit:
            j = replace(j, kept=False, why="precision")
        elif j.kept is None and left_out > limit and not j.points:
            j = replace(j, why="left out")
        reported.append(j)
    return tuple(reported)


def _by_check_points(accuracy: Accuracy, part: Part, limit: float, metres: float, *, asprs: bool) -> Judged:
    t = accuracy.tested
    needed, axes = accuracy.needed if asprs else FEWEST, 2 if part == "horizontal" else 1
    n = 0 if t is None else t.horizontal if part == "horizontal" else t.vertical
    found = math.nan if t is None or not n else metres * (t.rmse_h if part == "horizontal" else t.rmse_v)
    kept, why = _verdict(found, limit, n, needed, axes, asprs=asprs)
    stated = t is not None and (t.stated_h if part == "horizontal" else t.stated_v)
    if kept and asprs and not stated:
        kept, why = None, "unsurveyed"  # the standard adds how well they were surveyed
    return Judged(part=part, wanted=limit, found=found, points=n, needed=needed, kept=kept, why=why)


def _verdict(found: float, limit: float, n: int, needed: int, axes: int, *, asprs: bool) -> tuple[bool | None, Why]:
    if not n:
        return None, "none"
    if n >= needed:
        return found <= limit, ""
    fewer = 1.0 if n >= FEWEST else math.sqrt(float(chdtri(axes * n, LEVEL)) / (axes * n))
    if found > limit * fewer:
        return False, ""
    return None, "untested" if asprs else "few"


def all_kept(parts: tuple[Judged, ...]) -> bool | None:
    """Whether all is kept: False where any part is not, None where any cannot be judged."""
    if any(p.kept is False for p in parts):
        return False
    return None if any(p.kept is None for p in parts) else True
