"""Values as Fluent takes them, and the functions of catalogues.

    { $n }                       a whole number in groups of three digits; a real one with three significant digits
    { NUM($x, digits: 5) }       with so many significant digits; decimals: so many decimals
    { PERCENT($share) }          a share in per cent, without the sign
    { P($p) }                    a probability behind its letter: p 0.35
    { LIST($names, most: 3) }    the first of a list, and how many more there are; { $names } shows five
    { OPTION("crs", "EPSG") }    a setting: a flag with its value on the command line, crs=EPSG in Python

A truth value is the word yes or no, by which an entry chooses its words.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from babel import Locale
from fluent.runtime import FluentBundle
from fluent.runtime.resolver import CurrentEnvironment, Pattern, ResolverEnvironment
from fluent.runtime.types import FluentType

from raybundle.words.numbers import grouped, probability, short
from raybundle.words.options import option_words

NAME = 1000
"""Characters of a name that a message shows"""
MOST = 5
"""Names of a list that a message shows"""


class Whole(int, FluentType):
    """A whole number."""

    def format(self, locale: Locale) -> str:
        """In groups of three digits."""
        del locale
        return grouped(int(self))


class Real(float, FluentType):
    """A number of so many significant digits, or of so many decimals where these are set."""

    digits = 3
    decimals: int | None = None

    def format(self, locale: Locale) -> str:
        """With the decimal sign of the language."""
        text = short(float(self), self.digits) if self.decimals is None else f"{float(self):.{self.decimals}f}"
        return text.replace(".", _decimal(locale))


class Chance(float, FluentType):
    """A probability behind its letter."""

    def format(self, locale: Locale) -> str:
        """With the decimal sign of the language."""
        return probability(float(self)).replace(".", _decimal(locale))


class Names(FluentType):
    """The first names or numbers of a list, and how many more there are."""

    def __init__(self, items: Sequence[Any], most: int = MOST) -> None:
        self.items, self.most = items, most

    def format(self, locale: Locale) -> str:
        """With commas between; semicolons between numbers that have commas."""
        most = self.most if len(self.items) > self.most + 1 else len(self.items)  # the last is as short as its count
        items = [value(v) for v in self.items[:most]]
        shown = [v.format(locale) if isinstance(v, FluentType) else str(v) for v in items]
        if len(self.items) > len(shown):
            shown[-1] += f" (+{len(self.items) - len(shown)})"
        commas = _decimal(locale) == "," and any(isinstance(v, Real) for v in items)
        return ("; " if commas else ", ").join(shown)


class Bundle(FluentBundle):
    """Entries of one language; its own numbers stay those of this module (Fluent makes them anew)."""

    def __init__(self, language: str, *, flags: bool) -> None:
        super().__init__([language], functions=functions(flags=flags), use_isolating=False)

    def written(self, pattern: Pattern, values: Mapping[str, Any]) -> tuple[str, list[Exception]]:
        """A pattern with values in it, and what it lacks."""
        errors: list[Exception] = []
        current = CurrentEnvironment(args={name: value(v) for name, v in values.items()})
        return str(pattern(ResolverEnvironment(context=self, current=current, errors=errors))), errors


def _decimal(locale: Locale) -> str:
    return str(locale.number_symbols["latn"]["decimal"])


def value(v: Any) -> FluentType | str:
    """A value of a message as Fluent takes it; long names lose their middle."""
    match v:
        case FluentType():
            return v
        case bool():
            return "yes" if v else "no"
        case int():
            return Whole(v)
        case float():
            return Real(v)
        case str():
            return v if len(v) <= NAME else f"{v[: NAME // 2]}...{v[-NAME // 3 :]}"
        case None:
            return ""
        case Sequence():
            return Names(v)
        case _:
            return str(v)


def number(v: float, digits: int = 3, decimals: int | None = None) -> FluentType:
    """NUM."""
    made = Real(v)
    made.digits = int(digits)
    made.decimals = None if decimals is None else int(decimals)
    return made


def percent(v: float, digits: int = 2) -> FluentType:
    """PERCENT."""
    return number(100 * float(v), digits)


def names(v: Names, most: int = MOST) -> FluentType:
    """LIST."""
    return Names(v.items, int(most))


def functions(*, flags: bool) -> dict[str, Callable[..., Any]]:
    """The functions of catalogues by name, for a reader who writes settings as flags or as arguments."""

    def setting(name: str, *values: Any, flag: str = "") -> str:
        return option_words(name, *map(_typed, values), flag=flag, flags=flags)

    return {"NUM": number, "PERCENT": percent, "LIST": names, "P": Chance, "OPTION": setting}


def _typed(v: Any) -> object:
    """What stands in a catalogue as a value of a setting."""
    match v:
        case "True" | "False":
            return v == "True"
        case int():
            return int(v)
        case float():
            return float(v)
        case _:
            return v
