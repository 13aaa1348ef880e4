"""Chapters of a report: each states what it follows and makes its sections, or none; a file in `sections` adds some."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from importlib import import_module
from pkgutil import iter_modules
from typing import TYPE_CHECKING, TypeVar

from raybundle.report.appendix import Appendix
from raybundle.report.arrangement import PartName
from raybundle.report.languages.language import Language
from raybundle.report.parts import Section
from raybundle.report.view import View

if TYPE_CHECKING:
    from raybundle.calibration.quality import CalibrationQuality
    from raybundle.report.delivery import Delivery
    from raybundle.report.facts import PhotographFacts
    from raybundle.report.text.words import Verdict

OfView = TypeVar("OfView", bound="Callable[[View], Section | None]")


@dataclass(frozen=True, slots=True, kw_only=True)
class Occasion:
    """What a report is written of."""

    view: View
    reported: Verdict
    appendix: Appendix = "none"
    """What is printed of it"""
    photographs: PhotographFacts | None = None
    """what is known of the photographs; None: the adjustment does not come from any"""
    qualities: tuple[CalibrationQuality, ...] = ()
    """verdicts on calibrated cameras"""
    delivery: Delivery | None = None
    """who it is for, in which system, and whether it is as good as was asked for; None: nobody stated"""
    language: Language = field(default_factory=Language)
    """in which the report will be set: chapters are made in English, but for what is cut to its length"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Chapter:
    """Sections that belong together."""

    name: str
    after: str
    """the chapter that it follows; empty: it begins the report"""
    make: Callable[[Occasion], tuple[Section, ...]]
    part: PartName = "specialist"
    """who reads it"""


_chapters: dict[str, Chapter] = {}


def chapter(
    name: str, *, after: str, part: PartName = "specialist"
) -> Callable[[Callable[[Occasion], tuple[Section, ...]]], Callable[[Occasion], tuple[Section, ...]]]:
    """Register a function as the chapter of this name.

    part  client: what stands first, on a page of its own in print, without numbers; specialist: numbered sections,
          of which long tables and what is folded go to the appendix; appendix: what is looked up, behind all others
    """

    def add(make: Callable[[Occasion], tuple[Section, ...]]) -> Callable[[Occasion], tuple[Section, ...]]:
        _chapters[name] = Chapter(name=name, after=after, make=make, part=part)
        return make

    return add


def section(name: str, *, after: str, part: PartName = "specialist") -> Callable[[OfView], OfView]:
    """Register a function of a view as a chapter of one section; None: nothing is to be stated."""

    def add(make: OfView) -> OfView:
        def chapter_of(o: Occasion) -> tuple[Section, ...]:
            made = make(o.view)
            return () if made is None else (made,)

        _chapters[name] = Chapter(name=name, after=after, make=chapter_of, part=part)
        return make

    return add


def chapters() -> tuple[Chapter, ...]:
    """All chapters as they are read: each behind the one that it follows, of several there the shortest train first."""
    from raybundle.report import sections

    for module in iter_modules(sections.__path__):
        import_module(f"{sections.__name__}.{module.name}")
    behind: dict[str, list[Chapter]] = {}
    for c in _chapters.values():
        if c.after and c.after not in _chapters:
            raise TypeError(f"the chapter {c.name} of the report follows {c.after}, which is none")
        behind.setdefault(c.after, []).append(c)

    def train(name: str) -> list[Chapter]:
        trains = sorted(([c, *train(c.name)] for c in behind.get(name, [])), key=lambda t: (len(t), t[0].name))
        return [c for t in trains for c in t]

    return tuple(train(""))
