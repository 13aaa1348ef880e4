"""The reader's language: texts from catalogues, numbers and dates as that language writes them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from datetime import date, datetime

from raybundle.errors import Text
from raybundle.report.languages import ENGLISH, Localised, checked_language, divided_words
from raybundle.report.text.numbers import MINUS, unbroken
from raybundle.words import Reader, headline, reader

NUMBER = re.compile(r"(?<![\w.])(\d[\d\u202f]*)\.(\d+)(?=[eE][-+]\d|°|[^\w.]|\.(?!\d)|$)")
DATE = re.compile(r"(?<![\w-])(\d{4})-(\d\d)-(\d\d)(?![\w-])")
LIST = re.compile(r"(,\d+(?:[ \u00a0]\w{1,2})?), (?=(?:[A-Za-z][ \u00a0])?[\u2212\d])")
"""Of numbers with commas in a list, the commas between them"""
NEGATIVE = re.compile(r"(?<![^\s(±=])-(?=\d)")
"""The sign of a number in a sentence"""
UNITS = re.compile(r"(\[|\d[ \u00a0])units\b")
"""Lengths of a block without a scale"""


@dataclass(slots=True, eq=False)
class Language:
    """The reader's language: English leaves what is no message as it is."""

    code: str = ENGLISH
    names: frozenset[str] = frozenset()
    """names of cameras, images, points, files and people: they stay as they are"""
    decimal: str = "."
    _units: str = "units"
    _divided: Mapping[str, str] = field(default_factory=dict[str, str])

    @property
    def english(self) -> bool:
        """Whether numbers and dates stay as they are."""
        return self.code == ENGLISH

    def text(self, text: str) -> str:
        """A text as the reader reads it: messages in the language, numbers and dates of others as it writes them."""
        if isinstance(text, Text):
            return Localised(NEGATIVE.sub(MINUS, unbroken(text.by(Reader(self.code, flags=reader().flags)))))
        if self.english or not text or isinstance(text, Localised):
            return text
        text = NUMBER.sub(rf"\1{self.decimal}\2", DATE.sub(self._date, UNITS.sub(rf"\1{self._units}", text)))
        return Localised(LIST.sub(r"\1; ", text) if self.decimal == "," else text)

    def cell(self, text: str) -> str:
        """A cell of a table: a name, a number, or a text."""
        return text if text in self.names and not isinstance(text, Text) else self.text(text)

    def heading(self, text: str) -> str:
        """The same with places at which a long word may be divided."""
        return Localised(" ".join(self._divided.get(w, w) for w in self.text(text).split(" ")))

    def moment(self, when: datetime) -> str:
        """A date with its time."""
        return f"{f'{when:%Y-%m-%d}' if self.english else self.day(when)} {when:%H:%M}"

    def day(self, when: date) -> str:
        """A date."""
        from babel.dates import format_date

        return format_date(when, "medium", locale=self.code)

    def _date(self, found: re.Match[str]) -> str:
        try:
            return self.day(date.fromisoformat(found[0]))
        except ValueError:
            return found[0]


def language_of(code: str = ENGLISH, names: Iterable[str] = ()) -> Language:
    """The language of this code; raises InputError for one that there is not."""
    checked_language(code)
    if code == ENGLISH:
        return Language()
    from babel.numbers import get_decimal_symbol

    known = frozenset(n for n in names if n)
    return Language(
        code=code, names=known, decimal=get_decimal_symbol(code), _divided=divided_words(code),
        _units=headline("label.free_unit", {}, Reader(code)),
    )  # fmt: skip
