"""What a rule of network design is: what is stated, by whom, the networks that show it, figures and where it ends."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar

from raybundle.numerics.arrays import Array


@dataclass(frozen=True, slots=True, kw_only=True)
class Source:
    """Where a rule stands."""

    who: str
    """Authors and year"""
    what: str
    """Title and place"""
    states: str
    """What it states of the matter, in our words"""
    read: str
    """As far as it was at hand, as "abstract": what it states beyond that is not vouched for"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Curve:
    """A line of a chart, or a row of marks."""

    name: str
    x: Array
    """(n,)"""
    y: Array
    """(n,); NaN where there is no figure: not determinable"""
    dashed: bool = False
    """A law of the literature, or what is compared with"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Chart:
    """Figures over one quantity; who draws it decides how."""

    title: str
    x_label: str
    y_label: str
    curves: tuple[Curve, ...]
    logarithmic: tuple[bool, bool] = (False, False)
    """Whether the axes x and y are"""


Cell = str | float


@dataclass(frozen=True, slots=True, kw_only=True)
class Figures:
    """Rows of names and figures."""

    header: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    """NaN: not determinable"""
    decimals: tuple[int, ...] = ()
    """Of each column behind the first; () shows three significant digits"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Evidence:
    """What the covariances of a rule's networks say."""

    charts: tuple[Chart, ...]
    figures: Figures
    numbers: Mapping[str, float]
    """Name -> the factors that the rule's sentences quote and its limits hold"""


Limits = tuple[float, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class Words:
    """The sentences of a rule; numbers stand in braces and are put in by name, as `{four_eight:.2f}`."""

    statement: str
    network: str
    """What was computed"""
    finding: str
    ends: str
    """Where the rule ends"""
    costs: str
    """What following it costs: photographs, minutes, as plans count them"""


class Rule(ABC):
    """One summarising rule of the literature, shown by the covariance of networks; each subclass registers itself.

    Nothing here is one noisy run: figures are those of `planning.predicted`.
    """

    registry: ClassVar[dict[str, Rule]] = {}

    name: ClassVar[str]
    """Of its file, figure and anchor"""
    title: ClassVar[str]
    order: ClassVar[int]
    """Place on the page"""
    sources: ClassVar[Sequence[Source]]
    words: ClassVar[Words]
    example: ClassVar[str]
    """Python that prints figures of a row of the table, to be tried and changed"""
    limits: ClassVar[Mapping[str, Limits]]
    """Number -> between which values it lies where the rule is true, and why that is derived stands beside it"""

    def __init_subclass__(cls) -> None:
        """Register the rule."""
        super().__init_subclass__()
        if cls.name in Rule.registry:
            raise TypeError(f"there are two rules of the name {cls.name!r}")
        Rule.registry[cls.name] = cls()

    @abstractmethod
    def evidence(self) -> Evidence:
        """Compute the networks; seconds."""

    def broken(self, evidence: Evidence) -> list[str]:
        """Numbers outside their limits, in words; [] where the rule holds."""
        return [
            f"{self.name}: {key} = {evidence.numbers[key]:.4g}, not between {low:g} and {high:g}"
            for key, (low, high) in self.limits.items()
            if not low <= evidence.numbers[key] <= high
        ]


def reported(rule: Rule, evidence: Evidence) -> Words:
    """The rule's sentences with the numbers in them."""
    w = rule.words
    return Words(**{name: _filled(getattr(w, name), evidence.numbers) for name in w.__slots__})


def _filled(sentence: str, numbers: Mapping[str, float]) -> str:
    return re.sub(r"(?<=\d)%", " %", sentence.format(**numbers))


def in_order() -> list[Rule]:
    """All rules as the page has them."""
    return sorted(Rule.registry.values(), key=lambda r: r.order)
