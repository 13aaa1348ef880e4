"""Ids that a reader takes: checked before anything is written, so that what is written can be read."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from raybundle.block import Block
from raybundle.errors import InputError


def check_ids(what: str, ids: Sequence[str], file: Path) -> None:
    """Raise InputError for an id that is empty, and for one that two of them have.

    what  they are ids of: "image", "point"
    file  that was to be written
    """
    first: dict[str, int] = {}
    for k, name in enumerate(ids, 1):
        if not name:
            raise InputError("id.empty", kind=what, number=k, n=len(ids), file=file)
        if first.setdefault(name, k) != k:
            raise InputError("id.twice", kind=what, first=first[name], second=k, id=name, file=file)


def repeated(names: Iterable[str]) -> str:
    """The first value that occurs a second time; raises ValueError where all differ."""
    seen = set[str]()
    for name in names:
        if name in seen:
            return name
        seen.add(name)
    raise ValueError("all differ")


def check_ids_of(block: Block, file: Path) -> None:
    """The same for cameras, images, points and instruments of a block."""
    check_ids("camera", [c.id for c in block.cameras], file)
    check_ids("image", block.images.ids, file)
    check_ids("point", block.points.ids, file)
    check_ids("instrument", [i.id for i in block.instruments], file)
