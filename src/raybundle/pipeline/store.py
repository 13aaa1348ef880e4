"""Where products are kept: archives of arrays in a folder, each whole or not there, under the hash of its inputs.

What is there is known by the length of its file; an array is verified by its check sum when a process reads it the
first time.  A damaged product is removed, and made again by whoever wants it.
"""

from __future__ import annotations

import contextlib
import errno
import os
import sqlite3
import uuid
from collections import OrderedDict
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from threading import Lock
from typing import BinaryIO

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.pipeline.archives import (
    DAMAGED,
    Member,
    is_complete,
    mapped_members,
    members_of,
    read_member,
    write_archive,
)

Product = Mapping[str, Array]
"""What a task or a stage gives, as it is kept."""
KEY = "__key__"
"""Array of a product that holds the key under which it was kept."""
FULL = {errno.ENOSPC, errno.EDQUOT} if hasattr(errno, "EDQUOT") else {errno.ENOSPC}
HELD = 256
"""Archives that tasks of one process have mapped, the latest ones: their memory is the system's to take back."""
WRITES = 3
"""Times that a product is written whose file another process swept away while it was."""


class ProductGone(InputError):
    """A product that was there is damaged or gone: the folder was changed meanwhile."""

    def __init__(self, key: str, folder: Path) -> None:
        kind = key.rpartition("-")[0]
        super().__init__(f"a product of the {kind} stage is damaged or gone; run the same command again", file=folder)
        self.key = key


@dataclass(frozen=True, slots=True)
class Folder:
    """A store of archives in a folder."""

    path: Path
    makers: dict[str, Callable[[], object]] = field(
        default_factory=dict[str, Callable[[], object]], repr=False, compare=False
    )
    """how the products of this run are made again, by their keys, when one is found damaged"""
    _held: OrderedDict[str, dict[str, Array]] = field(
        default_factory=OrderedDict[str, dict[str, Array]], repr=False, compare=False
    )
    _verified: dict[str, tuple[tuple[int, int, int], set[int]]] = field(
        default_factory=dict[str, tuple[tuple[int, int, int], set[int]]], repr=False, compare=False
    )
    """of each product its file (number, time, length), and where arrays begin whose sums were right"""
    _lock: Lock = field(default_factory=Lock, repr=False, compare=False)

    def _path(self, key: str) -> Path:
        return self.path / key[-2:] / f"{key}.npz"

    def has(self, key: str) -> bool:
        """Whether a product is there in its whole length; one that was cut is removed.  Its numbers are not read."""
        path = self._path(key)
        if is_complete(path):
            return True
        with contextlib.suppress(OSError):
            path.unlink()
        return False

    def load(self, key: str, names: Sequence[str] = ()) -> dict[str, Array] | None:
        """A product, or only some of its arrays, to be changed at will; None where it is missing or damaged."""
        return self._read(key, names, lambda file, members: [read_member(file, m) for m in members])

    def mapped(self, key: str, names: Sequence[str] = ()) -> dict[str, Array] | None:
        """The same over the file itself: of an array no more is read than is used; not to be written into.

        The first time that a process maps an array it reads it once to verify it.
        """

        def read(file: BinaryIO, members: list[Member]) -> list[Array]:
            return mapped_members(file, members, self._known(key, file.fileno()))

        return self._read(key, names, read)

    def _read(
        self, key: str, names: Sequence[str], read: Callable[[BinaryIO, list[Member]], list[Array]]
    ) -> dict[str, Array] | None:
        """Arrays of a product, all where none is named, by this way to read them; a damaged product is removed."""
        path = self._path(key)
        try:
            with path.open("rb") as file:
                members = members_of(file)
                if str(read_member(file, members[KEY])) != key:
                    raise ValueError(path.name)  # another product under this name
                wanted = [name for name in names or members if name != KEY]
                return dict(zip(wanted, read(file, [members[name] for name in wanted]), strict=True))
        except FileNotFoundError:
            return None
        except DAMAGED:
            with contextlib.suppress(OSError):
                path.unlink()
            return None

    def _known(self, key: str, number: int) -> set[int]:
        """Where the arrays of a file begin that this process has verified."""
        now = os.fstat(number)
        file = now.st_ino, now.st_mtime_ns, now.st_size
        with self._lock:
            before, known = self._verified.get(key, (None, set[int]()))
            if before != file:
                known = set[int]()
                self._verified[key] = file, known
            return known

    def wanted(self, key: str, names: Sequence[str] = ()) -> dict[str, Array]:
        """A product that was there before; raises ProductGone where it is not and cannot be made again."""
        return self._again(key, lambda: self.load(key, names))

    def lent(self, key: str, names: Sequence[str] = ()) -> dict[str, Array]:
        """The same over the file itself, for as long as it is used; not to be written into."""
        return self._again(key, lambda: self.mapped(key, names))

    def held(self, key: str) -> dict[str, Array]:
        """The same, mapped, for what many tasks ask for; not to be written into."""
        with self._lock:
            if key in self._held:
                self._held.move_to_end(key)
                return self._held[key]
        found = self._again(key, lambda: self.mapped(key))
        with self._lock:
            self._held[key] = found
            while len(self._held) > HELD:
                self._held.popitem(last=False)
        return found

    def _again(self, key: str, read: Callable[[], dict[str, Array] | None]) -> dict[str, Array]:
        """What is read, after it was made again where it was damaged."""
        found = read()
        if found is None and key in self.makers:
            self.makers[key]()
            found = read()
        if found is None:
            raise ProductGone(key, self.path)
        return found

    def release(self) -> None:
        """Let go of what is mapped."""
        with self._lock:
            self._held.clear()

    def store(self, key: str, product: Product) -> None:
        """Keep a product; it appears whole or not at all."""
        path = self._path(key)
        with writing(self.path.parent):  # which people know
            path.parent.mkdir(parents=True, exist_ok=True)
            for left in reversed(range(WRITES)):
                temporary = path.with_name(f".{key}.{uuid.uuid4().hex[:8]}")
                try:
                    with temporary.open("wb") as file:
                        write_archive(file, {**product, KEY: np.array(key)})
                    temporary.replace(path)
                    break
                except FileNotFoundError:  # a run that began meanwhile took it for that of a killed one
                    if not left:
                        raise
                finally:
                    temporary.unlink(missing_ok=True)

    def write_text(self, name: str, text: str) -> Path:
        """Write a text that is no product, whole or not at all; the file."""
        path = self.path / name
        with writing(self.path.parent):
            self.path.mkdir(parents=True, exist_ok=True)
            temporary = self.path / f".{name}.{uuid.uuid4().hex[:8]}"
            try:
                temporary.write_text(text, encoding="utf-8")
                temporary.replace(path)
            finally:
                temporary.unlink(missing_ok=True)
        return path

    def keys_of_kind(self, kind: str) -> list[str]:
        """Keys of all products whose key begins with this word, in order."""
        return sorted(path.stem for path in self.path.glob(f"*/{kind}-*.npz"))

    def forget(self, key: str) -> None:
        """Remove a product."""
        with contextlib.suppress(OSError):
            self._path(key).unlink()

    def forget_kind(self, kind: str) -> None:
        """Remove all products whose key begins with this word."""
        for key in self.keys_of_kind(kind):
            self.forget(key)


@contextmanager
def writing(folder: Path) -> Generator[None]:
    """Turn a full disk, a read-only folder and the like into a message that says what to do."""
    try:
        yield
    except (OSError, sqlite3.OperationalError) as error:
        full = getattr(error, "errno", None) in FULL or "full" in str(error)
        what = "no space is left" if full else str(getattr(error, "strerror", None) or error)
        advice = "free space and run the same command again" if full else "choose a folder that can be written"
        if isinstance(error, IsADirectoryError | NotADirectoryError | FileExistsError):
            what = f"something else stands at {error.filename2 or error.filename} ({what})"
            advice = "move it away and run the same command again"
        text = f"cannot be written: {what}; {advice}. What is finished is kept, the run continues there"
        raise InputError(text, file=folder) from None
