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

Each message says what is wrong, in which object, the number against its limit, and what to do next.  What a program
needs to know of a defect stands beside it as data (`undetermined`, `open_names`, `images`): nothing reads words.

Exit status of the command line:

    0    what was asked for is written.  Of an adjustment: there is a result, not that it is good; its faults are
         printed and stand in result.json (`warnings`, severity "fault"), and `converged` there says whether the
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
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from raybundle.readable import without_controls

WHOLE, WORD, PATH = 2000, 200, 1000
"""Characters that a message, a word without blanks in it, and a path may have; what is foreign may be of any length."""


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

    @property
    def headline(self) -> str:
        """The first line of the message, where a table has room for no more, with the next where it ends in a colon."""
        first, _, rest = str(self).partition("\n")
        return f"{first} {rest.partition(chr(10))[0].strip()}" if first.endswith(":") and rest else first


def place_words(file: Path | str | None, line: int) -> str:
    """Where a row stands: its line from 1; in Parquet, which has no lines, its number from 1."""
    if not str(file).endswith(".parquet"):
        return f", line {line}"
    return f", row {line - 1}" if line > 1 else ""


class InputError(RaybundleError):
    """Bad input, with the place where it stands."""

    exit_status = 2

    def __init__(
        self, message: str, *, file: Path | str | None = None, line: int | None = None, column: str | None = None
    ) -> None:
        self.file = None if file is None else str(file)
        self.line = line
        self.column = column
        place = "" if file is None else _bounded(str(file), PATH, PATH)
        if line is not None:
            place += place_words(file, line)
        if column is not None:
            place += f", column {_bounded(column, WORD)}"
        text = _bounded(message, WHOLE)
        super().__init__(without_controls(f"{place}: {text}" if place else text))


class TasksWaiting(RaybundleError):
    """Tasks are written down for others to do; the same command goes on when they are done."""

    exit_status = 5


class UnknownSensorModel(InputError):
    """No sensor model of this name is registered."""

    def __init__(self, name: str, *, known: Iterable[str], file: Path | str | None = None) -> None:
        super().__init__(f"unknown sensor model {name!r}; known: {', '.join(sorted(known))}", file=file)


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

    def __init__(self, message: str, *, undetermined: Sequence[Undetermined] = ()) -> None:
        super().__init__(message)
        self.undetermined: tuple[Undetermined, ...] = tuple(undetermined)

    def names(self, kind: str) -> tuple[str, ...]:
        """What is not determined of one kind: the names of images or points, the worst first."""
        return tuple(u.name for u in self.undetermined if u.kind == kind)

    def worded(self, message: str) -> NotSolvable:
        """The same defect with other words."""
        other = type(self)(message)
        other.undetermined = self.undetermined
        return other


class DatumDefect(NotSolvable):
    """Position, orientation or scale of object space is left open."""

    def __init__(
        self, message: str, *, open_names: Sequence[str] = (), undetermined: Sequence[Undetermined] = ()
    ) -> None:
        super().__init__(message, undetermined=undetermined)
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
        self,
        message: str,
        *,
        images: Mapping[str, str] | None = None,
        undetermined: Sequence[Undetermined] = (),
    ) -> None:
        super().__init__(message, undetermined=undetermined)
        self.images: Mapping[str, str] = dict(images or {})
        """Images that could not be oriented, with the reason; the others could be."""
