"""Folders that are written whole or not at all."""

from __future__ import annotations

import ctypes
import os
import shutil
import uuid
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

from raybundle.errors import InputError

AT_FDCWD, RENAME_EXCHANGE = -100, 2  # linux/fcntl.h, linux/fs.h


@contextmanager
def new_folder(path: Path) -> Generator[Path]:
    """A temporary sibling of `path` that takes its name when the body ends without an error.

    What stands at `path` is replaced only then; whether it may be is for the caller to find out before.  A
    process that is killed leaves `path` as it was, and a folder `.NAME.*.partial` beside it that may be deleted.
    Raises InputError where nothing can be written there.
    """
    path = path.absolute()
    temporary = path.parent / f".{path.name}.{uuid.uuid4().hex[:8]}.partial"
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        temporary.mkdir()
    except OSError as error:
        raise _cannot(path, error) from None
    try:
        yield temporary
        _take_name(temporary, path)
    except OSError as error:
        raise _cannot(path, error) from None
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def _cannot(path: Path, error: OSError) -> InputError:
    return InputError(f"cannot be written: {error.strerror}; free space or choose another folder", file=path)


def _take_name(new: Path, path: Path) -> None:
    if not path.exists():
        new.rename(path)
    elif not exchange(new, path):
        # two steps where the system has no exchange: for an instant only the old one under its other name exists
        old = new.with_suffix(".old")
        path.rename(old)
        try:
            new.rename(path)
        except OSError:
            old.rename(path)
            raise
        shutil.rmtree(old, ignore_errors=True)


def exchange(a: Path, b: Path) -> bool:
    """Swap two folders' names at one stroke; False where the system or the file system cannot (renameat2, Linux)."""
    try:
        renameat2 = ctypes.CDLL(None, use_errno=True).renameat2
    except (AttributeError, OSError, TypeError):
        return False
    return renameat2(AT_FDCWD, os.fsencode(a), AT_FDCWD, os.fsencode(b), RENAME_EXCHANGE) == 0
