"""Where products are kept: archives of arrays in a folder, each whole or not there, under the hash of its inputs."""

from __future__ import annotations

import contextlib
import errno
import sqlite3
import struct
import uuid
import zipfile
import zlib
from collections import OrderedDict
from collections.abc import Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from threading import Lock
from typing import BinaryIO

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

Product = Mapping[str, Array]
"""What a task or a stage gives, as it is kept."""
KEY = "__key__"
"""Array of a product that holds the key under which it was kept."""
DAMAGED = (
    OSError, ValueError, EOFError, zipfile.BadZipFile, zlib.error, struct.error, KeyError, MemoryError, OverflowError,
    RuntimeError, SyntaxError, TypeError,
)  # fmt: skip
"""What reading a damaged archive of arrays can raise; unsupported and too deep ones are RuntimeErrors."""
FULL = {errno.ENOSPC, errno.EDQUOT} if hasattr(errno, "EDQUOT") else {errno.ENOSPC}
HELD_BYTES = 200e6
"""Arrays that tasks of one process hold in memory, the latest ones."""


@dataclass(frozen=True, slots=True)
class Folder:
    """A store of archives in a folder."""

    path: Path
    _held: OrderedDict[str, dict[str, Array]] = field(default_factory=OrderedDict[str, dict[str, Array]], repr=False)
    _lock: Lock = field(default_factory=Lock, repr=False, compare=False)

    def _path(self, key: str) -> Path:
        return self.path / key[-2:] / f"{key}.npz"

    def has(self, key: str) -> bool:
        """Whether a product is there and whole, by its check sums; a damaged one is removed."""
        path = self._path(key)
        with contextlib.suppress(*DAMAGED), zipfile.ZipFile(path) as file:
            if file.testzip() is None:
                return True
        with contextlib.suppress(OSError):
            path.unlink()
        return False

    def load(self, key: str, names: Sequence[str] = ()) -> dict[str, Array] | None:
        """A product, or only some of its arrays; None where it is missing or damaged."""
        path = self._path(key)
        try:
            with path.open("rb") as opened, np.load(opened, allow_pickle=False) as file:
                if str(file[KEY]) != key:
                    raise ValueError(path.name)  # another product under this name
                return {name: file[name] for name in names or file.files if name != KEY}
        except FileNotFoundError:
            return None
        except DAMAGED:
            with contextlib.suppress(OSError):
                path.unlink()
            return None

    def wanted(self, key: str, names: Sequence[str] = ()) -> dict[str, Array]:
        """A product that was there before; raises InputError where it is not: the folder was changed meanwhile."""
        found = self.load(key, names)
        if found is None:
            kind = key.rpartition("-")[0]
            raise InputError(
                f"a product of the {kind} stage is damaged or gone; run the same command again", file=self.path
            )
        return found

    def held(self, key: str) -> dict[str, Array]:
        """The same, from memory where it was read lately: for what many tasks ask for; not to be written into."""
        with self._lock:
            if key in self._held:
                self._held.move_to_end(key)
                return self._held[key]
        found = self.wanted(key)
        with self._lock:
            self._held[key] = found
            while len(self._held) > 2 and sum(a.nbytes for p in self._held.values() for a in p.values()) > HELD_BYTES:
                self._held.popitem(last=False)
        return found

    def release(self) -> None:
        """Let go of what is held in memory."""
        with self._lock:
            self._held.clear()

    def store(self, key: str, product: Product) -> None:
        """Keep a product; it appears whole or not at all."""
        path = self._path(key)
        with writing(self.path.parent):  # which people know
            path.parent.mkdir(parents=True, exist_ok=True)
            temporary = path.with_name(f".{key}.{uuid.uuid4().hex[:8]}")
            try:
                with temporary.open("wb") as file:
                    _write_arrays(file, {**product, KEY: np.array(key)})
                temporary.replace(path)
            finally:
                temporary.unlink(missing_ok=True)

    def remove(self, key: str) -> None:
        """Remove a product, where it is there."""
        with contextlib.suppress(OSError):
            self._path(key).unlink()

    def forget_kind(self, kind: str) -> None:
        """Remove all products whose key begins with this word."""
        for path in self.path.glob(f"*/{kind}-*.npz"):
            with contextlib.suppress(OSError):
                path.unlink()


def _write_arrays(file: BinaryIO, product: Product) -> None:
    """Write an archive of arrays as np.savez does, and let go of it where the disk is full.

    np.savez before NumPy 2 leaves the archive open then; when it is collected it prints a traceback.
    """
    with zipfile.ZipFile(file, "w") as archive:
        for name, values in product.items():
            with archive.open(f"{name}.npy", "w", force_zip64=True) as member:
                np.lib.format.write_array(member, np.asanyarray(values), allow_pickle=False)


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
