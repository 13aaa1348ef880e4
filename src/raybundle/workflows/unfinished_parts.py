"""What adjustments that were cut short left beside their results: parts of normal equations, to go on from."""

from __future__ import annotations

import os
import re
import shutil
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from raybundle.errors import InputError
from raybundle.io.folders import NAME_BYTES, lock_of, place_of, unlock
from raybundle.pipeline.clusters import TOKEN
from raybundle.pipeline.confirmed_stores import is_confirmed
from raybundle.pipeline.running import works
from raybundle.pipeline.store import Folder

NOTES, STORES = "notes", "stores"
"""Store of the numbers of sweeps; its text that states where else parts lie: a line for each store, number and URL"""
OF_STAGES = "adjustment"
"""Within a project, beside what the parts of its own adjustments stand, as beside a result"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Left:
    """A folder of parts."""

    folder: Path
    bytes: int
    stores: tuple[str, ...]
    """URLs of what lies elsewhere"""
    in_use: bool
    """by a run that works there now"""


def part_store(folder: Path, number: int, url: str, token: str) -> Folder:
    """One of the stores of a folder of parts; at a URL by a name that no other folder has."""
    name = f"parts-{number}"
    return Folder(folder / name, url and f"{url.rstrip('/')}/{token}-{name}")


def note_store(notes: Folder, number: int, url: str) -> None:
    """Note that parts lie at a URL, for whoever removes them."""
    stated = notes.place.text(STORES) or ""
    line = f"{number} {url}\n"
    if line not in stated:
        notes.place.keep_text(STORES, stated + line)


def left_beside(out: Path) -> tuple[Left, ...]:
    """What runs left beside a result, or are working on."""
    place = place_of(out)
    stem = os.fsdecode(os.fsencode(place.name)[:NAME_BYTES])
    ours = re.compile(re.escape(f".{stem}.parts") + r"\d*")
    try:
        there = sorted(place.parent.iterdir())
    except OSError:  # there is none, or it cannot be looked into
        return ()
    return tuple(_left(p) for p in there if ours.fullmatch(p.name) and p.is_dir())


def _left(folder: Path) -> Left:
    urls = dict.fromkeys(url for _, url in _noted(folder))
    return Left(folder=folder, bytes=bytes_in(folder), stores=tuple(urls), in_use=works(folder))


def bytes_in(folder: Path) -> int:
    """Bytes of all files in a folder."""
    total = 0
    for at, _, names in os.walk(folder):  # which passes over what a run takes away meanwhile
        for name in names:
            with suppress(OSError):
                total += (Path(at) / name).lstat().st_size
    return total


def _noted(folder: Path) -> list[tuple[int, str]]:
    found: list[tuple[int, str]] = []
    with suppress(OSError, ValueError):
        for line in (folder / NOTES / STORES).read_text(encoding="utf-8").splitlines():
            number, _, url = line.partition(" ")
            found.append((int(number), url))
    return found


def forget_stores(folder: Path) -> None:
    """Remove what a folder of parts has elsewhere."""
    with suppress(OSError, UnicodeDecodeError):
        token = (folder / NOTES / TOKEN).read_text(encoding="utf-8")
        for number, url in _noted(folder):
            with suppress(InputError):  # it cannot be reached
                if is_confirmed(url):  # the folder may come from somebody else
                    part_store(folder, number, url, token).place.clear()


def forget_left(out: Path) -> None:
    """Remove what earlier runs left beside a result that is made now, and what they left elsewhere."""
    for left in left_beside(out):
        lock = lock_of(left.folder)
        if lock is None:
            continue
        try:
            forget_stores(left.folder)
            shutil.rmtree(left.folder, ignore_errors=True)
        finally:
            unlock(lock)
