"""Folders that are written whole or not at all."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

from raybundle.errors import InputError


@contextmanager
def new_folder(path: Path) -> Generator[Path]:
    """A temporary sibling of `path` that takes its name when the body ends without an error.

    What stands at `path` is replaced only then; whether it may be is for the caller to find out before.
    Raises InputError where nothing can be written there.
    """
    path = path.absolute()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        temporary = Path(tempfile.mkdtemp(prefix=f".{path.name}.", suffix=".partial", dir=path.parent))
    except OSError as error:
        raise InputError(f"cannot be written: {error.strerror}; choose another folder", file=path) from None
    try:
        yield temporary
        temporary.chmod(0o755)
        _take_name(temporary, path)
    except OSError as error:
        raise InputError(
            f"cannot be written: {error.strerror}; free space or choose another folder", file=path
        ) from None
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def _take_name(new: Path, path: Path) -> None:
    if not path.exists():
        new.rename(path)
        return
    old = Path(tempfile.mkdtemp(prefix=f".{path.name}.", suffix=".old", dir=path.parent))
    path.rename(old)  # over the empty folder
    try:
        new.rename(path)
    except OSError:
        old.rename(path)
        raise
    shutil.rmtree(old, ignore_errors=True)
