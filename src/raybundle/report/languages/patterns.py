"""Templates of sentences: literal words with places between them, and the texts that they fit."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

WORD = re.compile(r"[^\W\d_⁰¹²³⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉]{2,}")
PLACE = re.compile(r"\{(\d*)(?::(\w+)|((?:\|[^{}|]*)+))?\}")
"""{}, {0}, {0:dative}, {0|one|many}: the second, third word by the number at the place"""
MOST_WAYS = 60
"""Ways in which a text is laid into a template; the first ones are the shortest"""
LETTERS = 3
"""Letters that a place within a word may hold: the s of a plural"""


@dataclass(frozen=True)
class Template:
    """A sentence in English and in another language."""

    english: str
    other: str

    @cached_property
    def literals(self) -> tuple[str, ...]:
        """What stands between the places of the English sentence."""
        return tuple(self.english.split("{}"))

    @cached_property
    def words(self) -> frozenset[str]:
        """Its words, those that touch no place."""
        found: set[str] = set()
        last = len(self.literals) - 1
        for k, part in enumerate(self.literals):
            for m in WORD.finditer(part):
                whole = (m.start() > 0 or k == 0) and (m.end() < len(part) or k == last)
                if whole:
                    found.add(m[0])
        return frozenset(found)

    @cached_property
    def size(self) -> int:
        """Letters of its own: of two that fit, the one with more states more."""
        return sum(len(part) for part in self.literals)

    @cached_property
    def pieces(self) -> tuple[tuple[str, int, str, tuple[str, ...]], ...]:
        """The other sentence: text, place behind it (-1: none), its case, its words by number."""
        made: list[tuple[str, int, str, tuple[str, ...]]] = []
        at = 0
        for count, m in enumerate(PLACE.finditer(self.other)):
            place = int(m[1]) if m[1] else count
            forms = tuple(m[3].split("|")[1:]) if m[3] else ()
            made.append((self.other[at : m.start()], place, m[2] or "", forms))
            at = m.end()
        return (*made, (self.other[at:], -1, "", ()))

    @cached_property
    def reported(self) -> frozenset[int]:
        """Places whose words stand in the other sentence."""
        return frozenset(place for _, place, _, forms in self.pieces if place >= 0 and not forms)

    def ways(self, text: str) -> Iterator[tuple[str, ...]]:
        """What of a text stands at each place, the shortest first, in every way in which the template fits."""
        parts = self.literals
        first, last = parts[0], parts[-1]
        if not text.startswith(first) or not text.endswith(last) or len(text) < len(first) + len(last):
            return
        for k, way in enumerate(self._ways(text[len(first) : len(text) - len(last)], 1)):
            if k >= MOST_WAYS:
                return
            yield way

    def _ways(self, text: str, k: int) -> Iterator[tuple[str, ...]]:
        """Ways of the rest of a text from place k on."""
        before, last = self.literals[k - 1], len(self.literals) - 1
        if k == last:
            if _fits(before, text, self.literals[k]):
                yield (text,)
            return
        part = self.literals[k]
        for at in _positions(text, part):
            if _fits(before, text[:at], part):
                for rest in self._ways(text[at + len(part) :], k + 1):
                    yield (text[:at], *rest)


def _fits(before: str, text: str, behind: str) -> bool:
    """Whether a place may hold a text: within a word only the letters of its ending."""
    if before and before[-1].isalpha() and text[:1].isalpha():
        return len(text) <= LETTERS and text.isalpha()
    return not (behind and behind[0].isalpha() and text and text[-1].isalpha() and not text.isalpha())


def _positions(text: str, part: str) -> Iterator[int]:
    """Where a literal stands; where two places touch, between words."""
    if not part:
        yield from (k for k in range(len(text) + 1) if k in (0, len(text)) or not (text[k].isalnum() or text[k] == "."))
        return
    at = text.find(part)
    while at >= 0:
        yield at
        at = text.find(part, at + 1)
