"""Every error raybundle raises on purpose.

    RaybundleError
      InputError            bad input; exit status 2; names file, line and column where there are any
        UnknownSensorModel
      NotSolvable           the input is well formed but has no solution as given; exit status 3
        DatumDefect         position, orientation or scale of object space is not determined
        RankDefect          something else is not determined; the message names it
        NoConvergence
        NoOrientation       approximate values could not be found

Each message says what is wrong, in which object, the number against its limit, and what to do next.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path


class RaybundleError(Exception):
    """Base of all errors raised on purpose; `exit_status` is what the command line returns."""

    exit_status = 1


class InputError(RaybundleError):
    """Bad input, with the place where it stands."""

    exit_status = 2

    def __init__(
        self, message: str, *, file: Path | str | None = None, line: int | None = None, column: str | None = None
    ) -> None:
        self.file = None if file is None else str(file)
        self.line = line
        self.column = column
        place = "" if file is None else f"{file}"
        if line is not None:
            place += f", line {line}"
        if column is not None:
            place += f", column {column}"
        super().__init__(f"{place}: {message}" if place else message)


class UnknownSensorModel(InputError):
    """No sensor model of this name is registered."""

    def __init__(self, name: str, *, known: Iterable[str], file: Path | str | None = None) -> None:
        super().__init__(f"unknown sensor model {name!r}; known: {', '.join(sorted(known))}", file=file)


class NotSolvable(RaybundleError):
    """Well-formed input without a solution."""

    exit_status = 3


class DatumDefect(NotSolvable):
    """Position, orientation or scale of object space is left open."""


class RankDefect(NotSolvable):
    """Unknowns that the observations do not determine, named in words."""


class NoConvergence(NotSolvable):
    """The iteration did not reach a minimum."""


class NoOrientation(NotSolvable):
    """Approximate values were not found; names the images and why."""

    def __init__(self, message: str, *, images: Mapping[str, str] | None = None) -> None:
        super().__init__(message)
        self.images: Mapping[str, str] = dict(images or {})
        """Images that could not be oriented, with the reason; the others could be."""
