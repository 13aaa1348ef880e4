"""Folders and files that are written whole or not at all."""

from __future__ import annotations

import contextlib
import ctypes
import errno
import os
import re
import shutil
import uuid
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import Literal

from raybundle.errors import InputError

_overwriting: ContextVar[bool] = ContextVar("overwriting", default=False)
AT_FDCWD, RENAME_EXCHANGE = -100, 2  # linux/fcntl.h, linux/fs.h
NAME_BYTES = 200
"""Of a name that is kept in that of its temporary sibling; file systems allow 255."""
_SIBLING = r"\.[0-9a-f]{8}\.(?:partial|old)"
_SCHEME = re.compile(r"[A-Za-z][A-Za-z0-9+.:-]+:")
"""First part of a path that was given as a URL; one letter is a drive of Windows."""
_ANY_SIBLING = re.compile(r"(?:\..+)?" + _SIBLING)


@contextmanager
def new_folder(path: Path, *, replacing: bool = False) -> Generator[Path]:
    """A temporary sibling of `path` that takes its name when the body ends without an error.

    replacing  what stands at `path` when the body begins is replaced then; whether it may be is for the caller to find
               out before.  Otherwise nothing but an empty folder may stand there
    raises     InputError where nothing can be written there, and where something has come to stand there meanwhile,
               as of another run: it stays, and nothing is left of this one
    A process that is killed leaves `path` as it was, and a folder `.NAME.*.partial` beside it, which the next one that
    writes there deletes.
    """
    path = place_of(path)
    make_parent(path)
    stood = _identity(path) if replacing else None
    with _sibling(path) as temporary:
        yield temporary
        with _named_failure(path):
            if stood is None:
                _take_free_name(temporary, path)
            else:
                _take_name(temporary, path, stood)


@contextmanager
def continued_folder(path: Path, ended: Callable[[], bool]) -> Generator[Path]:
    """A sibling `.NAME.parts` of `path` for what a run that is cut short leaves to the next one under the same name.

    ended  whether, in the end, nothing is left to be continued: then it is deleted
    Where another run works there it is `.NAME.parts1`, and so on.
    """
    path = place_of(path)
    make_parent(path)
    stem = os.fsdecode(os.fsencode(path.name)[:NAME_BYTES])
    with _named_failure(path):
        folder, lock = _free(path.parent / f".{stem}.parts")
    try:
        yield folder
    finally:
        if ended():
            shutil.rmtree(folder, ignore_errors=True)
        unlock(lock)


def _free(first: Path) -> tuple[Path, int | None]:
    """The first folder of this name, or of this name with a number, that nobody else has locked."""
    folder, number = first, 0
    while True:
        folder.mkdir(exist_ok=True)
        lock = lock_of(folder)
        if lock is not None or os.name == "nt":
            return folder, lock
        number += 1
        folder = first.with_name(f"{first.name}{number}")


def make_parent(path: Path) -> None:
    """Make the folder in which a file or folder is to stand; raises InputError where that cannot be."""
    with _named_failure(path):
        missing = [path.parent]
        while not missing[-1].exists():
            missing.append(missing[-1].parent)
        for folder in reversed(missing):  # pathlib's own way calls itself for each of thousands of parts
            folder.mkdir(exist_ok=True)


def place_of(path: Path) -> Path:
    """Where a path leads: a link stays, and what is written under its name goes where it points.

    raises  InputError for a link that leads back to itself, and for a URL
    """
    if not path.is_absolute() and path.parts and _SCHEME.fullmatch(path.parts[0]):
        raise InputError("folder.url", scheme=path.parts[0], file=path)
    with _named_failure(path):
        place = Path(os.path.realpath(path))
        if any(part.is_symlink() for part in (place, *place.parents)):
            raise InputError("file.link_loop", file=path)
    return place


def check_place(path: Path, wanted: Literal["file", "folder", "either"] = "either") -> None:
    """Raise InputError where nothing can be written under a name, before something is computed for it.

    wanted  what is to stand there: what stands there already and is something else is refused, whatever its use
    A folder is made, and deleted, where the first folder that `new_folder` would have to make is to stand: what the
    system refuses, it refuses here (permissions are no measure: to the superuser they say yes everywhere).
    """
    with _named_failure(path):
        place = place_of(path)
        if place.exists():  # or it is a name that is too long
            _check_kind(path, place, wanted)
        parent = place.parent
        while not parent.exists():
            parent = parent.parent
        if not parent.is_dir():
            raise InputError("folder.parent_is_a_file", parent=str(parent), file=path)
        probe = parent / f".{uuid.uuid4().hex[:8]}.partial"
        probe.mkdir()
        probe.rmdir()


@contextmanager
def overwriting() -> Generator[None]:
    """Within it files that stand at a name are replaced; folders are not."""
    before = _overwriting.set(True)
    try:
        yield
    finally:
        _overwriting.reset(before)


def check_new_file(path: Path) -> None:
    """Raise InputError where a file stands under a name, unless files are being overwritten."""
    if path.exists() and not _overwriting.get():
        raise InputError("file.exists", file=path)


def check_free(path: Path) -> None:
    """Raise InputError where something stands under a name that would be lost: a file, a folder that holds something.

    The one rule of all writers: what stands there is not overwritten.  A file is, where that is asked for
    (`overwriting`); a result folder or a page that this program made itself is replaced by a newer one of its kind,
    since it can be computed again; a project is continued; any other folder is left to whoever filled it.
    """
    if path.is_dir():
        check_new_folder(path)
    else:
        check_new_file(path)


def check_new_folder(path: Path) -> None:
    """Raise InputError where no new folder can be written under a name; one that holds nothing may stand there.

    For what does not replace a folder of its own kind: nothing that stands there is lost.
    """
    check_place(path, "folder")
    with _named_failure(path):
        place = place_of(path)
        if place.exists() and names_in(place):
            raise InputError("folder.exists", file=path)


def _check_kind(path: Path, place: Path, wanted: Literal["file", "folder", "either"]) -> None:
    if not (place.is_file() or place.is_dir()):
        raise InputError("folder.special_file", file=path)
    if wanted == "file" and place.is_dir():
        raise InputError("file.is_a_folder", file=path)
    if wanted == "folder" and place.is_file():
        raise InputError("folder.is_a_file", file=path)


@contextmanager
def new_files(*paths: Path) -> Generator[tuple[Path, ...]]:
    """Files of other places that take the names `paths` when the body ends without an error, in this order.

    They have the same names and stand in a temporary folder beside the last one; what stands at a path is replaced.
    What the body has not written is passed over.  Raises InputError where nothing can be written there.
    """
    target = place_of(paths[-1])
    if target.is_dir():
        raise InputError("file.is_a_folder", file=paths[-1])
    with _sibling(target) as temporary:
        yield tuple(temporary / p.name for p in paths)
        for path in paths:
            with _named_failure(path):
                if (temporary / path.name).exists():
                    (temporary / path.name).replace(place_of(path))


@contextmanager
def _named_failure(path: Path) -> Generator[None]:
    """Turn what the system refuses into a message."""
    try:
        yield
    except OSError as error:
        refused = error.errno in {errno.EROFS, errno.EACCES, errno.EPERM}
        detail = error.strerror or str(error)
        raise InputError("file.not_writable", detail=detail, refused=refused, file=path) from None


@contextmanager
def _sibling(path: Path) -> Generator[Path]:
    """A new folder beside a path, locked while it is in use, deleted in the end."""
    stem = os.fsdecode(os.fsencode(path.name)[:NAME_BYTES])
    with _named_failure(path):
        for left in _left_beside(path.parent, stem):
            shutil.rmtree(left, ignore_errors=True)
        temporary = path.parent / f".{stem}.{uuid.uuid4().hex[:8]}.partial"
        temporary.mkdir()
        lock = lock_of(temporary)
    try:
        with _named_failure(path):
            yield temporary
    finally:
        unlock(lock)
        shutil.rmtree(temporary, ignore_errors=True)


def _left_beside(parent: Path, stem: str) -> Iterator[Path]:
    """Temporary siblings whose writer is gone: nobody holds their lock."""
    return _left(parent, re.compile(re.escape(f".{stem}") + _SIBLING))


def _left(parent: Path, ours: re.Pattern[str]) -> Iterator[Path]:
    for entry in parent.iterdir():
        if ours.fullmatch(entry.name) and not entry.is_symlink() and entry.is_dir():
            lock = lock_of(entry)
            if lock is not None:
                unlock(lock)
                yield entry


def names_in(folder: Path) -> set[str]:
    """What stands in a folder, by name, without what writers of this program, that were killed or work now, have begun.

    Who looks for what is not of this program takes the folder as this states.
    """
    return {e.name for e in folder.iterdir() if not (_ANY_SIBLING.fullmatch(e.name) and e.is_dir())}


def clear_left(folder: Path) -> None:
    """Delete what writers that were killed have left in a folder, under whatever name they wrote."""
    with _named_failure(folder):
        for left in _left(folder, _ANY_SIBLING):
            shutil.rmtree(left, ignore_errors=True)


def lock_of(folder: Path) -> int | None:
    """A file descriptor that locks a folder; None where another process holds it, or the system has no such lock."""
    try:
        import fcntl
    except ImportError:
        return None
    try:
        number = os.open(folder, os.O_RDONLY)
    except OSError:
        return None
    try:
        fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(number)
        return None
    return number


def unlock(lock: int | None) -> None:
    """Give a lock back."""
    if lock is not None:
        with contextlib.suppress(OSError):
            os.close(lock)


def _identity(path: Path) -> tuple[int, int] | None:
    """Which folder stands under a name; None where none does."""
    try:
        found = path.stat()
    except FileNotFoundError:
        return None
    return found.st_dev, found.st_ino


def _meanwhile(path: Path) -> InputError:
    return InputError("file.created_meanwhile", file=path)


def _take_free_name(new: Path, path: Path) -> None:
    """The system refuses to rename onto a folder that holds something, or onto a file."""
    if path.is_dir():
        clear_left(path)
    if os.name == "nt" and path.is_dir():
        with contextlib.suppress(OSError):
            path.rmdir()
    try:
        new.rename(path)
    except OSError:
        if path.exists():
            raise _meanwhile(path) from None
        raise


def _take_name(new: Path, path: Path, stood: tuple[int, int]) -> None:
    """Replace the folder that stood there, and no other."""
    if _identity(path) is None:
        new.rename(path)
    elif not exchange(new, path):
        # two steps where the system has no exchange: for an instant only the old one under its other name exists
        old = new.with_suffix(".old")
        path.rename(old)
        try:
            if _identity(old) != stood:
                raise _meanwhile(path)
            new.rename(path)
        except (OSError, InputError):
            old.rename(path)
            raise
        shutil.rmtree(old, ignore_errors=True)
    elif _identity(new) != stood:
        exchange(new, path)
        raise _meanwhile(path)


def exchange(a: Path, b: Path) -> bool:
    """Swap two folders' names at one stroke; False where the system or the file system cannot (renameat2, Linux)."""
    try:
        renameat2 = ctypes.CDLL(None, use_errno=True).renameat2
    except (AttributeError, OSError, TypeError):
        return False
    return renameat2(AT_FDCWD, os.fsencode(a), AT_FDCWD, os.fsencode(b), RENAME_EXCHANGE) == 0


def short_names(folders: Sequence[Path]) -> list[str]:
    """Names of folders that differ, as short as may be: of result/ and block/ that of the folder around."""
    short = [p.parent.name if p.name in {"result", "block"} and p.parent.name else p.name or str(p) for p in folders]
    return short if len(set(short)) == len(short) else [str(p) for p in folders]
