"""Sets of photographs that are made on the spot, for tutorials: one file in `sets/` is one set.

A module there has ABOUT, a line for the help, and make(folder, progress), which writes the set into an empty folder and
returns what is to be reported of it.
"""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules
from typing import Protocol, cast

from raybundle.commands.demonstrations import sets
from raybundle.errors import InputError
from raybundle.numerics.progress import Progress, silent


class MadeSet(Protocol):
    """What a module in `sets/` has."""

    ABOUT: str

    def make(self, folder: Path, progress: Progress) -> tuple[str, ...]:
        """Write the set into an empty folder; lines to be reported of it."""
        ...


def set_names() -> tuple[str, ...]:
    """Of the sets that there are."""
    return tuple(sorted(m.name for m in iter_modules(sets.__path__)))


def set_named(name: str) -> MadeSet:
    """The set of this name; raises InputError."""
    if name not in set_names():
        raise InputError("dataset.unknown", name=name, known=list(set_names()))
    return cast("MadeSet", import_module(f"{sets.__name__}.{name}"))


def make_set(name: str, out: str | Path, progress: Progress = silent) -> tuple[str, ...]:
    """Write a set of photographs into a new folder, and say what is there; the same bytes each time on one machine.

    raises  InputError for a name that there is not, and where `out` holds something already
    """
    from raybundle.io.folders import check_new_folder, new_folder

    made = set_named(name)
    check_new_folder(Path(out))
    with new_folder(Path(out)) as folder:
        return made.make(folder, progress)
