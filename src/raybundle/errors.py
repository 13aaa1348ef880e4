"""Every error raybundle raises on purpose.

    RaybundleError
      InputError            bad input; exit status 2; names file, line and column where there are any
        UnknownSensorModel
      NotSolvable           the input is well formed but has no solution as given; exit status 3
        DatumDefect         position, orientation or scale of object space is not determined
        RankDefect          something else is not determined; the message names it
          TooFewObservations
        NoConvergence
        NoOrientation       approximate values could not be found
      TasksWaiting          nothing is wrong: others are to do tasks first; exit status 5

An error has a message: a code and values, of which `raybundle.words` makes the text: what is wrong, in which object,
the number against its limit, and what to do next.  What else a program needs of a defect stands beside it as data
(`undetermined`, `open_names`, `images`): nothing reads words.

Exit status of the command line:

    0    what was asked for is written.  Of an adjustment: there is a result, not that it is good; its faults are
         printed and stand in result.json (`warnings`, severity "fault"), and `converged` there states whether the
         iteration came to an end
    1    an internal error, to be reported
    2    bad input or usage (InputError); nothing is written
    3    not solvable as given (NotSolvable); nothing is written, an older result stays
    4    what was checked is not enough: of a flight, something is to be flown again (plan check)
    5    tasks wait to be done elsewhere (TasksWaiting); the same command goes on when they are
    130  interrupted
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

from raybundle import words
from raybundle.readable import without_controls

if TYPE_CHECKING:
    from raybundle.words import Reader

WHOLE, WORD, PATH = 2000, 200, 1000
"""Characters that a message, a word without blanks in it, and a path may have; what is foreign may be of any length."""
_CODE = re.compile(r"[a-z][a-z0-9]*[._][a-z0-9_.]+")
Value = int | float | str | bool | None | Sequence["int | float | str"]
"""A number, a name, an identifier, one of some words, or a list of these; the unit is in its name: `sigma_px`"""


class Severity(StrEnum):
    """What a message asks of its reader, the gravest first."""

    ERROR = "error"
    """There is no result."""
    FAULT = "fault"
    """The result, or its standard deviations, are wrong in some part until someone decides."""
    WARNING = "warning"
    """The result stands; part of it is weaker, or less, than it might be taken for."""
    NOTE = "note"
    """What was done or chosen."""

    @classmethod
    def _missing_(cls, value: object) -> Severity | None:
        """Names of earlier results."""
        return {"caution": cls.WARNING, "remark": cls.NOTE}.get(str(value))


@dataclass(frozen=True, slots=True)
class Place:
    """Where something stands in files."""

    file: str = ""
    line: int | None = None
    """From 1"""
    column: str | None = None
    rows: bool = False
    """Whether the file has rows and no lines, as Parquet; `line` is then that of the table written as text"""

    def text(self, reader: Reader | None = None) -> str:
        """File, line and column; empty where there are none."""
        reader = reader or words.reader()
        parts = [_bounded(self.file, PATH, PATH)]
        if self.line is not None and not self._rows:
            parts.append(words.headline("place.line", {"line": self.line}, reader))
        elif self.line is not None and self.line > 1:
            parts.append(words.headline("place.row", {"row": self.line - 1}, reader))
        if self.column is not None:
            parts.append(words.headline("place.column", {"column": _bounded(self.column, WORD)}, reader))
        return without_controls(", ".join(filter(None, parts)))

    @property
    def _rows(self) -> bool:
        return self.rows or self.file.endswith(".parquet")


@dataclass(frozen=True, slots=True, kw_only=True)
class Message:
    """What happened, as data; its words are those of the catalogues in `raybundle.words`."""

    code: str
    """subject.problem, in snake case: scale.single_bar"""
    values: Mapping[str, Value] = field(default_factory=dict[str, Value])
    severity: Severity = Severity.ERROR
    details: tuple[Message, ...] = ()
    """One for each object, where there are several."""
    place: Place | None = None
    """Of a detail."""

    def headline(self, reader: Reader | None = None) -> str:
        """What happened, in one line."""
        return words.headline(self.code, self.values, reader or words.reader())

    def text(self, reader: Reader | None = None) -> str:
        """What happened, why it matters and what to do; details in lines of their own."""
        reader = reader or words.reader()
        place = f"{self.place.text(reader)}: " if self.place else ""
        lines = [place + words.sentences(self.code, self.values, reader)]
        for detail in self.details:
            lines += [f"  {line}" for line in detail.text(reader).splitlines()]
        return "\n".join(lines)

    def json(self) -> dict[str, Any]:
        """Code, severity and values, and those of the details, for JSON."""
        more: dict[str, Any] = {"details": [d.json() for d in self.details]} if self.details else {}
        if self.place:
            more["place"] = asdict(self.place)
        return {"code": self.code, "severity": self.severity.value, "values": plain(self.values), **more}


def message(code: str, /, *, details: Iterable[Message] = (), **values: Value) -> Message:
    """A message of a code and its values by name."""
    return Message(code=code, values=plain(values), details=tuple(details))


def note(code: str, /, *, details: Iterable[Message] = (), **values: Value) -> Message:
    """What was done, found or chosen, as a message."""
    return replace(message(code, details=details, **values), severity=Severity.NOTE)


def warning(code: str, /, *, details: Iterable[Message] = (), **values: Value) -> Message:
    """What makes part of a result weaker than it looks, as a message."""
    return replace(message(code, details=details, **values), severity=Severity.WARNING)


def content(code: str | Message, values: Mapping[str, Value]) -> str | Message:
    """The message of a code and its values; a text as it stands."""
    if isinstance(code, str) and _CODE.fullmatch(code):
        return Message(code=code, values=plain(values))
    return code


def as_detail(error: Exception) -> Message:
    """The message of an error with its place, as a detail of another; the words of what is no RaybundleError."""
    if not isinstance(error, RaybundleError) or error.message is None:
        return Message(code="error.other", values={"detail": str(error)})
    place = getattr(error, "place", None)
    return replace(error.message, place=place) if place is not None and place.text() else error.message


def as_error(found: Message) -> InputError:
    """The error of which `as_detail` gave the message."""
    place = found.place or Place()
    if found.code == "error.other":
        return InputError(str(found.values["detail"]))
    return InputError(replace(found, place=None), file=place.file or None, line=place.line, column=place.column)


def plain(value: Any) -> Any:
    """A value of a message, or several, as JSON has them: numbers of NumPy as those of Python, tuples as lists."""
    match value:
        case Mapping():
            return {str(k): plain(v) for k, v in cast("Mapping[Any, Any]", value).items()}
        case str() | bool() | int() | None:
            return value
        case float():
            return float(value)
        case Iterable():
            return [plain(v) for v in cast("Iterable[Any]", value)]
        case _:
            return plain(value.item()) if hasattr(value, "item") else str(value)


def message_of(found: Mapping[str, Any]) -> Message:
    """The message that `Message.json` gave."""
    return Message(
        code=str(found["code"]), values=dict(found.get("values") or {}), severity=Severity(found["severity"]),
        details=tuple(map(message_of, found.get("details") or ())),
        place=Place(**found["place"]) if found.get("place") else None,
    )  # fmt: skip


class Text(str):
    """The text of messages for the reader of this process, who may be another in the end: they stay with it."""

    __slots__ = ("messages",)
    messages: tuple[Message, ...]

    @classmethod
    def of(cls, *messages: Message) -> Text:
        """One message after the other."""
        made = cls(" ".join(m.text() for m in messages))
        made.messages = messages
        return made

    def with_text(self, text: str) -> Text:
        """The same messages with their text in another form."""
        made = type(self)(text)
        made.messages = self.messages
        return made

    def by(self, reader: Reader) -> str:
        """The same for another reader."""
        return " ".join(m.text(reader) for m in self.messages)

    @property
    def message(self) -> Message:
        """All messages as one: the first, with the others as its details."""
        first, *others = self.messages
        return replace(first, details=(*first.details, *others))


def joined_texts(*texts: Text) -> Text:
    """The messages of several texts, one after the other."""
    return Text.of(*(m for text in texts for m in text.messages))


def text_of_error(error: RaybundleError) -> str:
    """An error as a reason in a list, with its place; its words where it has no message."""
    return str(error) if error.message is None else Text.of(as_detail(error))


def without_file(text: str, file: Path) -> str:
    """A reason without the file that its list names."""
    if not isinstance(text, Text):
        return text.removeprefix(f"{file}: ")
    first, *others = text.messages
    if first.place is not None and first.place.file == str(file):
        place = replace(first.place, file="")
        first = replace(first, place=place if place.text() else None)
    return Text.of(first, *others)


def code_of(text: str) -> str:
    """The code of the message of a text; empty where it has only words."""
    return text.message.code if isinstance(text, Text) else ""


def text_json(text: str) -> dict[str, Any]:
    """Code, values and details of a text, for JSON; {} where it has only words."""
    if not isinstance(text, Text):
        return {}
    found = text.message.json()
    return {name: found[name] for name in ("code", "values", "details") if name in found}


def message_of_text(text: str) -> Message:
    """The message of a text, as a detail of another; words alone as a value."""
    return text.message if isinstance(text, Text) else message("reason.text", text=text)


def excluded(refused: Sequence[tuple[str, str]], remarks: Iterable[str] = (), most: int = 20) -> list[Message]:
    """Names of what takes no part with the reasons, and what else there is to say, as details of an error."""
    more = [message("reason.more", n=len(refused) - most)] if len(refused) > most else []
    return [*(named(*r) for r in refused[:most]), *more, *map(message_of_text, remarks)]


def named(name: str, text: str) -> Message:
    """A reason after the name of its object, as a detail of an error."""
    return replace(message_of_text(text), place=Place(file=name))


def phrase(code: str, /, **values: Value) -> Text:
    """A text of a report, of the catalogue's entry and its values, for whatever reader."""
    return Text.of(Message(code=code, values=plain(values), severity=Severity.NOTE))


def worded(code: str, /, **values: Value) -> str:
    """A text of the catalogue; of what has no entry there, as of a model of one's own, the words themselves."""
    return phrase(code, **values) if code in words.text_codes() else code


def printable(text: str) -> str:
    """A text with everything escaped that would move a terminal's cursor or cannot be seen; lines stay lines."""
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() or c == "\n" else repr(c)[1:-1] for c in text)


def _bounded(text: str, limit: int, word: int = WORD) -> str:
    """A printable text of bounded length: long words lose their ends, a long text its middle."""
    text = printable(text)
    if len(text) > word:
        text = re.sub(rf"\S{{{word},}}", lambda found: found[0][: word // 2] + "...", text)
    return text if len(text) <= limit else f"{text[: limit // 2]} ... {text[-limit // 4 :]}"


class RaybundleError(Exception):
    """Base of all errors raised on purpose; `exit_status` is what the command line returns."""

    exit_status = 1
    message: Message | None = None
    """None of an error that has only a text."""

    def __init__(self, code: str | Message = "", /, *, details: Iterable[Message] = (), **values: Value) -> None:
        """With a message, or its code and values by name; or with a text."""
        if isinstance(code, Text):
            code = code.message
        if isinstance(code, Message):
            self.message = code
        elif _CODE.fullmatch(code):
            self.message = Message(code=code, values=plain(values), details=tuple(details))
        super().__init__(code)

    def __str__(self) -> str:
        return super().__str__() if self.message is None else f"{self.text()} [{self.code}]"

    def text(self, reader: Reader | None = None) -> str:
        """The whole message for a reader."""
        return str(self) if self.message is None else self.message.text(reader)

    def json(self) -> dict[str, Any]:
        """Its message as data; {} where it has only a text."""
        return {} if self.message is None else self.message.json()

    @property
    def code(self) -> str:
        """The code of its message; empty: it has only a text."""
        return "" if self.message is None else self.message.code

    @property
    def headline(self) -> str:
        """The first line of the message, where a table has room for no more, with the next where it ends in a colon."""
        if self.message is not None:
            return self.message.headline()
        first, _, rest = str(self).partition("\n")
        return f"{first} {rest.partition(chr(10))[0].strip()}" if first.endswith(":") and rest else first


class InputError(RaybundleError):
    """Bad input, with the place where it stands."""

    exit_status = 2

    def __init__(
        self, code: str | Message, /, *, file: Path | str | None = None, line: int | None = None,
        column: str | None = None, details: Iterable[Message] = (), **values: Value,
    ) -> None:  # fmt: skip
        self.file = None if file is None else str(file)
        self.line = line
        self.column = column
        if isinstance(code, Message | Text) or _CODE.fullmatch(code):
            super().__init__(code, details=details, **values)
            return
        place, text = self.place.text(), _bounded(code, WHOLE)
        super().__init__(without_controls(f"{place}: {text}" if place else text))

    @property
    def place(self) -> Place:
        """Where it stands."""
        return Place(self.file or "", self.line, self.column)

    def text(self, reader: Reader | None = None) -> str:
        """The whole message for a reader, after its place."""
        text, place = super().text(reader), self.place.text(reader)
        return f"{place}: {text}" if self.message is not None and place else text

    @property
    def headline(self) -> str:
        """What happened, in one line, after its place."""
        head, place = super().headline, self.place.text()
        return f"{place}: {head}" if self.message is not None and place else head

    def json(self) -> dict[str, Any]:
        """Its message and place as data."""
        place = {k: v for k, v in asdict(self.place).items() if v and k != "rows"}
        return {**super().json(), **({"place": place} if place else {})}

    def at(self, file: Path | str | None = None, line: int | None = None, column: str | None = None) -> InputError:
        """The same error with a place, of which the parts that it has stay."""
        other = type(self).__new__(type(self))
        other.__dict__.update(self.__dict__)
        other.args = self.args
        if self.message is None:
            InputError.__init__(other, str(self), file=file, line=line, column=column)
            return other
        other.file = self.file if file is None or self.file is not None else str(file)
        other.line = line if self.line is None else self.line
        other.column = column if self.column is None else self.column
        return other


class TasksWaiting(RaybundleError):
    """Tasks are written down for others to do; the same command goes on when they are done."""

    exit_status = 5


class UnknownSensorModel(InputError):
    """No sensor model of this name is registered."""

    def __init__(
        self, name: str, *, known: Iterable[str], file: Path | str | None = None, line: int | None = None
    ) -> None:
        super().__init__("model.unknown_sensor", name=name, known=sorted(known), file=file, line=line)


@dataclass(frozen=True, slots=True, kw_only=True)
class Undetermined:
    """An object whose unknowns the observations do not determine, or hardly."""

    kind: Literal["parameter", "image", "point", "other"]
    name: str
    """Camera, image or point."""
    symbol: str = ""
    """Of a parameter."""
    image: str = ""
    """Of a parameter that each image has for itself."""
    share: float = 1.0
    """Share of its scaled unknowns in what is not determined: 1 = it is not determined by itself."""


class NotSolvable(RaybundleError):
    """Well-formed input without a solution; names what is not determined, where that is known, the worst first."""

    exit_status = 3

    def __init__(
        self,
        code: str | Message,
        /,
        *,
        undetermined: Sequence[Undetermined] = (),
        details: Iterable[Message] = (),
        **values: Value,
    ) -> None:
        super().__init__(code, details=details, **values)
        self.undetermined: tuple[Undetermined, ...] = tuple(undetermined)

    def names(self, kind: str) -> tuple[str, ...]:
        """What is not determined of one kind: the names of images or points, the worst first."""
        return tuple(u.name for u in self.undetermined if u.kind == kind)

    def worded(self, message: str | Message) -> NotSolvable:
        """The same defect with another message."""
        other = type(self)(message)
        other.undetermined = self.undetermined
        return other


class DatumDefect(NotSolvable):
    """Position, orientation or scale of object space is left open."""

    def __init__(
        self, code: str | Message, /, *, open_names: Sequence[str] = (), undetermined: Sequence[Undetermined] = (),
        details: Iterable[Message] = (), **values: Value,
    ) -> None:  # fmt: skip
        super().__init__(code, undetermined=undetermined, details=details, **values)
        self.open_names: tuple[str, ...] = tuple(open_names)
        """"X", "rotation about Z", "scale" ..., where known."""


class RankDefect(NotSolvable):
    """Unknowns that the observations do not determine, named in words and as data."""


class TooFewObservations(RankDefect):
    """Fewer observations than unknowns, whatever they are."""


class NoConvergence(NotSolvable):
    """The iteration did not reach a minimum."""


class NoOrientation(NotSolvable):
    """Approximate values were not found; names the images and why."""

    def __init__(
        self, code: str | Message, /, *, images: Mapping[str, str] | None = None,
        undetermined: Sequence[Undetermined] = (), details: Iterable[Message] = (), **values: Value,
    ) -> None:  # fmt: skip
        super().__init__(code, undetermined=undetermined, details=details, **values)
        self.images: Mapping[str, str] = dict(images or {})
        """Images that could not be oriented, with the reason; the others could be."""
