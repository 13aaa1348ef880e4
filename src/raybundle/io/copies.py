"""Copies of products on this machine, of those that lie in an object store: so many bytes, those used last.

    RAYBUNDLE_PRODUCTS/STORE/xx/KEY.npz  a copy, whole or not there; STORE is what a store is known by
    RAYBUNDLE_PRODUCTS/held              bytes that were promised to copies, at least those that they take

Several processes work in the folder at once.  Who needs room asks for it under a lock (flock; not on Windows, where the
bound holds for each process by itself); who reads a copy that another takes away meanwhile keeps what is mapped.
"""

from __future__ import annotations

import errno
import os
import shutil
import time
import uuid
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from raybundle.errors import InputError
from raybundle.io.reading.words import number_of, quoted, whole_of
from raybundle.io.user_folders import made_again_folder

FULL = {errno.ENOSPC, errno.EDQUOT} if hasattr(errno, "EDQUOT") else {errno.ENOSPC}
VARIABLE, VARIABLE_GB = "RAYBUNDLE_PRODUCTS", "RAYBUNDLE_PRODUCTS_GB"
SHARE = 0.5
"""Of the disk's free space, as it would be without copies, that they take where nothing is stated."""
AT_ONCE = 1 / 16
"""Of the bound that is freed at least when room is needed: all copies are looked at for it."""
ABANDONED_S = 24 * 3600.0
"""Age from which on a copy that was begun counts as that of a killed process."""


class StoreLost(InputError):
    """Products can be neither read nor written any more: no task can be done, and none is to blame."""


def copies_folder() -> Path:
    """Where copies are: RAYBUNDLE_PRODUCTS, or the place for what can be made again (`made_again_folder`)."""
    given = os.environ.get(VARIABLE, "")
    return Path(given) if given else made_again_folder() / "products"


def check_copies() -> None:
    """Raise InputError where the folder of copies is none, or their bound is no number."""
    bytes_given()
    folder = copies_folder()
    stands = next(p for p in (folder, *folder.absolute().parents) if p.exists())
    if not stands.is_dir():
        raise InputError("store.copies_no_folder", folder=str(folder), place=str(stands), variable=VARIABLE)


def bytes_given() -> float | None:
    """Bytes that copies may take by RAYBUNDLE_PRODUCTS_GB; None: nothing is stated.  Raises InputError."""
    text = os.environ.get(VARIABLE_GB, "")
    if not text:
        return None
    found = number_of(text, 1e9)
    if found is None or found < 0.0:
        raise InputError("store.copies_size", variable=VARIABLE_GB, value=quoted(text))
    return found


@dataclass(frozen=True, slots=True)
class Copies:
    """Copies of the products of one store."""

    folder: Path
    """of the copies of all stores"""
    store: str
    """by what this one is known"""
    suffix: str = ".npz"
    """of files"""

    def _path(self, key: str) -> Path:
        return self.folder / self.store / key[-2:] / f"{key}{self.suffix}"

    def find(self, key: str) -> Path | None:
        """A copy, which counts as used; None: there is none."""
        path = self._path(key)
        try:
            os.utime(path, ns=(time.time_ns(), path.stat().st_mtime_ns))
        except FileNotFoundError:
            return None
        except OSError:  # of another user: it is read all the same
            return path
        return path

    def forget(self, key: str) -> None:
        """Remove a copy."""
        with suppress(OSError):
            self._path(key).unlink()

    def clear(self) -> None:
        """Remove all copies of this store."""
        shutil.rmtree(self.folder / self.store, ignore_errors=True)

    def make(self, key: str, size: int, write: Callable[[Path], None], then: Callable[[Path], None]) -> Path:
        """Make a copy.

        size    bytes that it will take, at most
        write   writes it into a file
        then    what is done with the whole file before it becomes the copy
        raises  StoreLost where the disk is full
        """
        path = self._path(key)
        for last in (False, True):
            temporary = path.with_name(f".{key}.{uuid.uuid4().hex[:8]}")
            try:
                with self._saying():
                    path.parent.mkdir(parents=True, exist_ok=True)
                    self._reserve(size, everything=last)
                try:
                    write(temporary)
                except OSError as error:
                    if error.errno in FULL and not last:  # others took what was free: all copies can go
                        continue
                    with self._saying():
                        raise
                then(temporary)
                with self._saying():
                    temporary.replace(path)
            finally:
                with suppress(OSError):
                    temporary.unlink(missing_ok=True)
            return path
        raise AssertionError

    @contextmanager
    def _saying(self) -> Generator[None]:
        """Turn a full or read-only disk into a message that states what to do."""
        try:
            yield
        except InputError:
            raise
        except OSError as error:
            full = error.errno in FULL
            raise StoreLost(
                "store.copies_not_writable",
                variable=VARIABLE,
                full=full,
                detail=error.strerror or str(error),
                file=self.folder,
            ) from None

    def _reserve(self, size: int, *, everything: bool) -> None:
        """Promise room, and make it where there is none, as far as there are copies."""
        with _alone(self.folder / "lock"):
            record = self.folder / "held"
            held = None
            with suppress(OSError):
                held = whole_of(record.read_text())
            if held is not None and held < 0:  # nobody's count
                held = None
            most = self._most(held or 0)
            if held is None or held + size > most or everything:
                held = self._freed(0.0 if everything else max(min(most - size, most * (1 - AT_ONCE)), 0.0))
            record.write_text(str(held + size))

    def _most(self, held: int) -> float:
        """Bytes that copies may take."""
        given = bytes_given()
        return SHARE * (shutil.disk_usage(self.folder).free + held) if given is None else given

    def _freed(self, wanted: float) -> int:
        """Remove copies, those first that were used longest ago, until they take no more than that; what they take."""
        found: list[tuple[int, int, str]] = []
        held = 0
        for store in _entries(self.folder):
            for part in _entries(store.path) if store.is_dir(follow_symlinks=False) else ():
                for copy in _entries(part.path) if part.is_dir(follow_symlinks=False) else ():
                    with suppress(OSError):
                        about = copy.stat(follow_symlinks=False)
                        begun = copy.name.startswith(".")
                        if begun and time.time() - about.st_mtime < ABANDONED_S:
                            held += about.st_size  # in work
                        else:
                            found.append((0 if begun else about.st_atime_ns, about.st_size, copy.path))
        held += sum(size for _, size, _ in found)
        for _, size, path in sorted(found):
            if held <= wanted:
                break
            with suppress(OSError):
                os.unlink(path)  # noqa: PTH108  (of many)
                held -= size
        return held


def _entries(folder: Path | str) -> list[os.DirEntry[str]]:
    try:
        with os.scandir(folder) as entries:
            return list(entries)
    except OSError:
        return []


@contextmanager
def _alone(file: Path) -> Generator[None]:
    """One process at a time, where the system has such locks."""
    try:
        import fcntl
    except ImportError:
        yield
        return
    number = os.open(file, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        with suppress(OSError):  # a file system without locks
            fcntl.flock(number, fcntl.LOCK_EX)
        yield
    finally:
        os.close(number)
