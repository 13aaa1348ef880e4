"""A text of the report in another language: matched against the templates of a catalogue, its places in turn."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from datetime import datetime
from functools import cache
from typing import Any

from raybundle.errors import Text
from raybundle.report.languages import ENGLISH, Said, catalogue, checked_language
from raybundle.report.languages.patterns import PLACE, WORD, Template
from raybundle.report.text.numbers import MINUS, unbroken
from raybundle.words import Reader, reader

NUMBER = re.compile(r"(?<![\w.])(\d[\d\u202f]*)\.(\d+)(?=[eE][-+]\d|°|[^\w.]|\.(?!\d)|$)")
VALUE = r"[\u2212-]?\d[\d\u202f ]*(?:[.,]\d+)?(?: × 10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?"
DATE = re.compile(r"(?<![\w-])(\d{4})-(\d\d)-(\d\d)(?![\w-])")
MEASURE = re.compile(
    rf"(?:± ?)?{VALUE}(?: ± {VALUE})?(?:[ \u00a0](?:px|mm|cm|km|m|µm|ms|s|°|%))?[ \u00a0](?![\d×])(\S.*)", re.DOTALL
)
LIST = re.compile(r"(,\d+(?:[ \u00a0]\w{1,2})?), (?=(?:[A-Za-z][ \u00a0])?[\u2212\d])")
"""Of numbers with commas in a list, the commas between them"""
COUNT = re.compile(rf"({VALUE})[ \u00a0](\S.*)", re.DOTALL)
SEPARATORS = re.compile(r"((?<=\.)\s+|; |: |, | \(|\) |\)|\( |\(| \[|\]| … | and | or | – | / |\n+| = )")
CODE = re.compile(
    r"--[\w-]+|[\w.-]*\w[._/\\][\w./\\-]*\w|[\w-]+=\S*|\w*\d\w*(?:[-.]\w*\d\w*)*|\w+:\d\w*(?:\+\w+)*|[A-Z0-9]{2,}s?|\w+_\w+|[a-z][A-Z]|\w+(?:-\w*\d\w*)+"
)
FLAG = re.compile(r"--[\w-]+(?: \S+){0,4}|\w+=(?:\([^)]*\)|\S*)")
"""A setting with its values, as messages name it"""
NEGATIVE = re.compile(r"(?<![^\s(±=])-(?=\d)")
"""The sign of a number in a sentence"""
SENTENCES = re.compile(r"((?<=\.)\s+)")
OWN = 0.2
"""Share of a text's letters that a template must have of its own, before the text is cut"""
MOST_CLAUSES, LONGEST = 80, 14
"""Clauses of a text that is cut, and those of a sentence that may be one entry"""
UNITS = frozenset(["px", "mm", "cm", "km", "ha", "µm", "um", "nm", "ms", "rad", "gon", "deg", "MB", "GB", "kB", "Hz"])
PLAIN = re.compile(r"[\d⁰¹²³⁴⁵⁶⁷⁸⁹⁻\s.,:;×%°′″±|<>=/()\[\]{}+*·…–\u2212-]*")
ENDS = ".,;:"
BOUND = "±\u00a0"
"""As `unbroken` sets it"""
DOUBT = 0.01
"""Letters that a text costs of which only one begun with a capital is known: so may be what it becomes"""
Way = tuple[str, float]
"""A text, and how many of its letters are still English"""


@dataclass(slots=True, eq=False)
class Language:
    """The reader's language: English leaves every text as it is."""

    code: str = ENGLISH
    names: frozenset[str] = frozenset()
    """names of cameras, images, points, files and people: they stay"""
    _book: Book | None = None
    _known: dict[tuple[str, str], Way] = field(default_factory=dict[tuple[str, str], Way])
    _parts: frozenset[str] = frozenset()

    @property
    def english(self) -> bool:
        """Whether nothing is translated."""
        return self._book is None

    def text(self, english: str) -> str:
        """A text as the reader reads it."""
        if isinstance(english, Text):
            return Said(NEGATIVE.sub(MINUS, unbroken(english.by(Reader(self.code, flags=reader().flags)))))
        if self._book is None or not english or isinstance(english, Said):
            return english
        if english in self._book.exact:
            return Said(self._book.exact[english])
        return Said(self._sound(english.replace(BOUND, "± ")).replace("± ", BOUND))

    def _sound(self, english: str) -> str:
        """A text whose sentences are in the one language or in the other: none is translated word by word.

        A sentence of which English words stay, and not names alone, has no translation, whatever joins its parts.
        """
        made, cost = self._said(english)
        if cost < 1 or not self._mixed(english, made):
            return made
        parts = SENTENCES.split(english)
        if len(parts) == 1:
            return english
        return "".join(self._sound(sentence) if sentence else "" for sentence in parts)

    def _mixed(self, english: str, made: str) -> bool:
        """Whether words stand in both texts that are English to the catalogue, and neither a name nor of the other."""
        assert self._book is not None
        stayed = set(WORD.findall(made)) & set(WORD.findall(english)) & self._book.words
        return bool(stayed - self._book.others - self._parts - UNITS)

    def left(self, english: str) -> float:
        """Letters of a text that stay English."""
        if self._book is None or isinstance(english, Said | Text) or english in self._book.exact:
            return 0.0
        return self._said(english.replace(BOUND, "± "))[1]

    def heading(self, english: str) -> str:
        """The same with places at which a long word may be divided."""
        made = self.text(english)
        if self._book is None:
            return made
        return Said(" ".join(self._book.divided.get(w, w) for w in made.split(" ")))

    def cell(self, english: str) -> str:
        """A cell of a table: a name, as a rule, or a number."""
        if isinstance(english, Text):
            return self.text(english)
        if self._book is None or isinstance(english, Said) or english in self.names:
            return english
        return self._book.cells.get(english) or self.text(english)

    def moment(self, when: datetime) -> str:
        """A date with its time."""
        return when.strftime("%Y-%m-%d %H:%M" if self._book is None else f"{self._book.date} %H:%M")

    def _said(self, text: str, case: str = "") -> Way:
        """A text or a part of one, and how much of it is still English."""
        key = (text, case)
        if key not in self._known:
            self._known[key] = (text, float(len(text)))  # a template of places alone meets itself again
            self._known[key] = self._outer(text, case)
        return self._known[key]

    def _outer(self, text: str, case: str) -> Way:
        """Blanks at the ends apart."""
        core = text.strip()
        if not core:
            return text, 0.0
        head, _, tail = text.partition(core)
        made, cost = self._inner(core, case)
        return head + made + tail, cost

    def _inner(self, text: str, case: str) -> Way:
        if PLAIN.fullmatch(text):
            return self._numbers(text), 0.0
        best = self._whole(text, case)
        if best[1] == 0.0:
            return best
        for other in (
            self._without_stop, self._in_sentences, self._in_clauses, self._ended, self._loosely, self._recased,
            self._numbered,
        ):  # fmt: skip
            way = other(text, case)
            if way[1] < best[1]:
                best = way
            if best[1] == 0.0:
                break
        return best

    def _whole(self, text: str, case: str) -> Way:
        """A text as one name, one entry, one number with its noun, or one template."""
        book = self._book
        assert book is not None
        if text in self.names:
            return text, 0.0
        if text in book.exact:
            return book.exact[text], 0.0
        counted = self._counted(text, case)
        if counted is not None:
            return counted
        best = self._words(text)
        return best if best[1] == 0.0 else self._fitted(text, best, OWN * len(text))

    def _fitted(self, text: str, best: Way, least: float) -> Way:
        """A text laid into the templates that have so many letters of their own, where that is better."""
        assert self._book is not None
        for t in self._book.candidates(text):
            if t.size < least:
                break
            for way in t.ways(text):
                made, cost = self._set(t, way, best[1])
                if cost < best[1]:
                    best = made, cost
                if cost == 0.0:
                    return best
        return best

    def _loosely(self, text: str, case: str) -> Way:  # noqa: ARG002  (one of several ways)
        """A text laid into templates of few words."""
        return self._fitted(text, (text, float("inf")), 0.0)

    def _recased(self, text: str, case: str) -> Way:
        """The same text begun with a letter of the other size."""
        if not text[:1].isalpha() or not text[1:2].islower():
            return text, float("inf")
        swapped = text[0].swapcase() + text[1:]
        made, cost = self._whole(swapped, case)
        if text[0].isupper():
            return made[:1].upper() + made[1:], cost
        return made, cost + DOUBT

    def _without_stop(self, text: str, case: str) -> Way:
        """A sentence of which the catalogue has the words without its stop."""
        if len(text) < 2 or text[-1] not in ENDS:
            return "", float("inf")
        made, cost = self._whole(text[:-1], case)
        return made + text[-1], cost

    def _ended(self, text: str, case: str) -> Way:
        """A text without the stop at its end, or in quotation marks or brackets."""
        if len(text) > 1 and text[-1] in ENDS:
            made, cost = self._said(text[:-1], case)
            return made + text[-1], cost
        for a, b in ("()", "“”", '""', "[]"):
            if text[0] == a and text[-1] == b and len(text) > 2 and a not in text[1:-1]:
                made, cost = self._said(text[1:-1], case)
                return ("„" + made + "“" if a == "“" else a + made + b), cost
        return text, float("inf")

    def _in_sentences(self, text: str, case: str) -> Way:
        """A text of several sentences."""
        return self._cut(SENTENCES.split(text), case, self._said)

    def _in_clauses(self, text: str, case: str) -> Way:
        """A text of several clauses."""
        return self._cut(SEPARATORS.split(text), case, self._span)

    def _cut(self, parts: list[str], case: str, one: Callable[[str, str], Way]) -> Way:
        """A text cut so that the least stays English.

        parts  what can stand alone, and between it what joins
        one    how a single part is translated; several together are one entry or none
        """
        assert self._book is not None
        clauses, joints = parts[0::2], parts[1::2]
        n = len(clauses)
        if n < 2 or n > MOST_CLAUSES:
            return "", float("inf")
        best: list[Way] = [("", 0.0)]
        for end in range(1, n + 1):
            found: Way = ("", float("inf"))
            for begin in range(end - 1, max(0, end - LONGEST) - 1, -1):
                if begin == 0 and end == n:
                    continue
                span = "".join(c + j for c, j in zip(clauses[begin:end], [*joints[begin : end - 1], ""], strict=True))
                before, cost = best[begin]
                if cost >= found[1]:
                    continue
                whole = (one if end - begin == 1 else self._span)(span, case)
                if cost + whole[1] < found[1]:
                    joint = self._book.joints.get(joints[begin - 1], joints[begin - 1]) if begin else ""
                    found = before + joint + whole[0], cost + whole[1]
            best.append(found)
        return best[n]

    def _span(self, text: str, case: str) -> Way:
        """A clause or several that may be one entry."""
        key = (text, f"span {case}")
        if key not in self._known:
            core = text.strip()
            if not core or PLAIN.fullmatch(core):
                made: Way = (self._numbers(text), 0.0)
            else:
                made = self._whole(core, case)
                if made[1] > 0.0:
                    other = self._recased(core, case)
                    made = other if other[1] < made[1] else made
                if made[1] > 0.0 and core[-1] in ENDS and len(core) > 1:
                    other = self._whole(core[:-1], case)
                    made = (other[0] + core[-1], other[1]) if other[1] < made[1] else made
                if made[1] > 0.0:
                    other = self._numbered(core, case)
                    made = other if other[1] < made[1] else made
                head, _, tail = text.partition(core)
                made = head + made[0] + tail, made[1]
            self._known[key] = made
        return self._known[key]

    def _counted(self, text: str, case: str) -> Way | None:
        """A number and its noun."""
        assert self._book is not None
        m = COUNT.fullmatch(text)
        if m is None:
            return None
        number, noun = m.groups()
        one, verb = number == "1", ""
        for ours, theirs in self._book.verbs.items():
            if noun.endswith(ours):
                noun, verb = noun.removesuffix(ours), theirs
                break
        forms = self._book.noun(noun, one=one)
        if forms is None:
            return None
        word = forms[0] if one and not case else forms[3] if one else forms[2] if case == "dative" else forms[1]
        return f"{self._numbers(text[: m.start(2)])}{word}{verb}", 0.0

    def _numbered(self, text: str, case: str) -> Way:
        """A number and words that are no noun."""
        m = MEASURE.fullmatch(text)
        if m is None:
            return text, float("inf")
        made, cost = self._said(m[1], case)
        return f"{self._numbers(text[: m.start(1)])}{made}", cost

    def _set(self, t: Template, way: tuple[str, ...], limit: float) -> Way:
        """A template's other sentence with what stands at its places; given up where it is no better than the limit."""
        cost = 0.0
        made: list[str] = []
        for words, place, case, forms in t.pieces:
            made.append(words)
            if place < 0:
                continue
            if forms:
                one = re.match(r"1(?![\d.,\u202f])", way[place].strip()) is not None
                made.append(forms[0] if one else forms[-1])
                continue
            stated, more = self._said(way[place], case)
            made.append(stated)
            cost += more
            if cost >= limit:
                return "", float("inf")
        return "".join(made), cost

    def _words(self, text: str) -> Way:
        """A text of names, codes and numbers; what else is in it stays English."""
        cost = 0.0
        if FLAG.fullmatch(text):
            return text, 0.0
        for token in re.split(r"[\s,;()\[\]“”\"'|]+", text):
            t = token.strip(".:…!?")
            if len(t) < 2 or t in self.names or t in self._parts or t in UNITS or CODE.fullmatch(t):
                continue
            cost += sum(len(w) for w in WORD.findall(t) if w not in UNITS)
        return self._numbers(text), cost

    def _numbers(self, text: str) -> str:
        """Numbers and dates as they are written."""
        assert self._book is not None
        y, m, d = r"\1", r"\2", r"\3"
        text = DATE.sub(self._book.date.replace("%Y", y).replace("%m", m).replace("%d", d), text)
        text = NUMBER.sub(rf"\1{self._book.decimal}\2", text)
        return LIST.sub(r"\1; ", text) if self._book.decimal == "," else text


@dataclass(frozen=True, eq=False)
class Book:
    """The catalogue of a language, ready to be looked up."""

    decimal: str
    date: str
    exact: Mapping[str, str]
    cells: Mapping[str, str]
    """words that stand alone in a table"""
    words: frozenset[str]
    """all that its English texts have"""
    others: frozenset[str]
    """all that its own texts have"""
    joints: Mapping[str, str]
    verbs: Mapping[str, str]
    """behind a number and its noun"""
    divided: Mapping[str, str]
    nouns: Mapping[str, tuple[str, str, str, str]]
    index: Mapping[str, list[Template]]

    def noun(self, english: str, *, one: bool) -> tuple[str, str, str, str] | None:
        """Singular, plural, dative of both of a noun that stands behind a number; None: it is not known."""
        if one and english in self.nouns:
            return self.nouns[english]
        for end, back in (("ies", "y"), ("s", ""), ("es", "")):
            if english.endswith(end) and english.removesuffix(end) + back in self.nouns:
                return self.nouns[english.removesuffix(end) + back]
        return None

    def candidates(self, text: str) -> list[Template]:
        """Templates all of whose words the text has, those of most letters first."""
        words = frozenset(WORD.findall(text))
        found = [t for w in words for t in self.index.get(w, ()) if t.words <= words]
        return sorted([*found, *self.index.get("", ())], key=lambda t: -t.size)


@cache
def book_of(code: str) -> Book:
    """The catalogue of a language."""
    c: dict[str, Any] = catalogue(code)
    texts: dict[str, str] = parted(c["texts"])
    templates = [Template(e, o) for e, o in texts.items() if "{}" in e]
    frequent = Counter(w for t in templates for w in t.words)
    index: dict[str, list[Template]] = {}
    for t in templates:
        index.setdefault(min(t.words, key=lambda w: frequent[w], default=""), []).append(t)
    return Book(
        decimal=c["decimal"], date=c["date"], exact={e: o for e, o in texts.items() if "{}" not in e},
        cells=c["cells"], words=frozenset(w for e in texts for w in WORD.findall(e)),
        others=frozenset(w for o in texts.values() for w in WORD.findall(PLACE.sub(" ", o))), joints=c["joints"],
        verbs=c["verbs"], nouns={e: _forms(o) for e, o in c["nouns"].items()}, index=index,
        divided={w.replace("-", ""): w.replace("-", "\u00ad") for w in c["divided"]},
    )  # fmt: skip


def parted(texts: Mapping[str, str]) -> dict[str, str]:
    """The entries, and those that follow: sentences of several, what is joined to a sentence without its joint."""
    more: dict[str, str] = {}
    for english, other in texts.items():
        for begin, end in ((". ", ""), ("; ", ""), (", ", ""), (": ", ""), ("(", ")"), ("(", ")."), ("; ", ".")):
            if english.startswith(begin) and english.endswith(end) and other.startswith(begin) and other.endswith(end):
                n = len(end)
                more[english[len(begin) : len(english) - n]] = other[len(begin) : len(other) - n]
        if "{0" in other or "{1" in other:
            continue
        ours, theirs = (re.split(r"(?<=\.)\s+", t) for t in (english, other))
        if len(ours) == len(theirs) > 1 and all(
            a.count("{") == b.count("{") for a, b in zip(ours, theirs, strict=True)
        ):
            more.update(zip(ours, theirs, strict=True))
    return {**more, **texts}


def _forms(words: str) -> tuple[str, str, str, str]:
    """Singular, plural, dative plural, dative singular of a noun; the last two follow from the others if not given."""
    parts = [w.strip() for w in words.split(",")]
    one, many = parts[0], parts[1] if len(parts) > 1 else parts[0]
    dative = parts[2] if len(parts) > 2 else many if many[-1] in "ns" else f"{many}n"
    return one, many, dative, parts[3] if len(parts) > 3 else one


def language_of(code: str = ENGLISH, names: Iterable[str] = ()) -> Language:
    """The language of this code; raises InputError for one that there is not."""
    checked_language(code)
    if code == ENGLISH:
        return Language()
    kept = frozenset(n for n in names if n)
    parts = frozenset(w.strip(".:…!?") for n in kept for w in re.split(r"[\s,;()\[\]“”\"'|]+", n))
    book = book_of(code)
    return Language(code=code, names=kept, _book=book, _parts=parts - book.words)
