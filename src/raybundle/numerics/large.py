"""Large arrays: in memory, or in files where memory is short.

An array with a row for each image observation of a large block is as large as what many machines have, and an
adjustment makes a dozen of them.  Within `in_files` they lie in files, of which the system keeps in memory what is
used; they are arrays like all others.
"""

from __future__ import annotations

import mmap
import os
import tempfile
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

PIECE = 250_000
"""Rows that are worked on at once: what is needed in between is a fraction of what is kept."""
LEAST = 1 << 20
"""Bytes from which an array is large."""
_folder: ContextVar[Path | None] = ContextVar("folder of large arrays", default=None)


@contextmanager
def in_files(folder: Path | None) -> Generator[None]:
    """Large arrays that are made meanwhile lie in files of this folder, without a name; None: in memory.

    They are gone with the last array that looks at them, also where the process is killed.
    """
    before = _folder.set(folder)
    try:
        yield
    finally:
        _folder.reset(before)


def zeros(shape: int | tuple[int, ...], dtype: Any = float) -> Array:
    """An array of zeros; raises InputError where there is no room for it in the folder."""
    folder, kind = _folder.get(), np.dtype(dtype)
    size = int(np.prod(shape, dtype=np.int64)) * kind.itemsize
    if folder is None or size < LEAST:
        return np.zeros(shape, kind)
    return np.frombuffer(_file(folder, size), kind).reshape(shape)


def full(shape: int | tuple[int, ...], value: float) -> Array:
    """An array (float64) of one value."""
    found = zeros(shape)
    found[...] = value
    return found


def kept(values: Array) -> Array:
    """The values, in a file where large arrays lie in files."""
    if _folder.get() is None or values.nbytes < LEAST:
        return values
    found = zeros(values.shape, values.dtype)
    found[...] = values
    return found


def pieces(count: int) -> Iterator[slice]:
    """So many rows, some at a time."""
    for begin in range(0, count, PIECE):
        yield slice(begin, min(begin + PIECE, count))


def _file(folder: Path, size: int) -> mmap.mmap:
    """Bytes of a file that has no name, all of them there: a disk that is full must not be found out by writing."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder) as file:
            if hasattr(os, "posix_fallocate"):
                os.posix_fallocate(file.fileno(), 0, size)
            else:
                none = bytes(1 << 20)
                for begin in range(0, size, len(none)):
                    file.write(none[: size - begin])
                file.flush()
            return mmap.mmap(file.fileno(), size)
    except OSError as error:
        raise InputError(
            "memory.no_room",
            size_mb=size / 1e6,
            detail=error.strerror or str(error),
            file=folder,
        ) from None
