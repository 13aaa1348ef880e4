"""Where products are kept: archives of arrays, each whole or not there, under the hash of its inputs.

Their files lie in a folder, or in an object store (`objects`): a `Place`.  What is there is known by the length of its
file; an array is verified by its check sum when a process reads it the first time.  A damaged product is removed, and
made again by whoever wants it.
"""

from __future__ import annotations

import contextlib
import errno
import shutil
import sqlite3
import uuid
from collections import OrderedDict
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from threading import Lock
from typing import BinaryIO

import numpy as np

from raybundle.errors import InputError
from raybundle.io.copies import FULL, StoreLost
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
from raybundle.pipeline.place import FileMark, Place, Product, ProductGone, mark_of

KEY = "__key__"
"""Array of a product that holds the key under which it was kept."""
SHORT = {errno.EMFILE, errno.ENFILE, errno.ENOMEM}
"""What a system answers that is short of files or memory: the file itself may be whole"""
HELD = 256
"""Archives that tasks of one process have mapped, the latest ones: their memory is the system's to take back."""
WRITES = 3
"""Times that a product is written whose file another process swept away while it was."""
READS = 8
"""Times that a file is opened that others take away before: copies of a store that is full of them come and go."""


@dataclass(frozen=True, slots=True)
class Files:
    """Files in a folder that all who need them see."""

    path: Path
    cut: set[str] = field(default_factory=set[str], repr=False, compare=False)
    """keys of those that were found cut"""

    @property
    def name(self) -> str:
        """The folder."""
        return str(self.path)

    @property
    def shared(self) -> bool:
        """By its path."""
        return True

    def check(self) -> None:
        """Who opens a project has written there."""

    def _path(self, key: str) -> Path:
        return self.path / key[-2:] / f"{key}.npz"

    def has(self, key: str) -> bool:
        """Whether a file is there in its whole length; one that was cut is removed.  Its numbers are not read."""
        which = mark_of(self._path(key))  # before it is read: what is made again meanwhile stays
        if which is None:
            return False
        if is_complete(self._path(key)):
            return True
        self.cut.add(key)
        self._forget_this(key, which)
        return False

    def those(self, keys: Sequence[str]) -> set[str]:
        """Those that are there."""
        return {key for key in keys if self.has(key)}

    def file(self, key: str) -> Path | None:
        """The file itself."""
        path = self._path(key)
        return path if path.exists() else None

    def damaged(self, key: str, again: bool, which: FileMark | None) -> None:  # noqa: FBT001
        """Remove it."""
        del again
        self._forget_this(key, which)

    def _forget_this(self, key: str, which: FileMark | None) -> None:
        """Remove a file, not the one that another process or thread has put in its place since.

        It is moved aside before it is looked at: no other can take its place between the look and the removal.
        """
        path = self._path(key)
        if which is not None and mark_of(path) != which:
            return
        aside = path.with_name(f".{key}.{uuid.uuid4().hex[:8]}")
        with contextlib.suppress(OSError):
            path.rename(aside)
            if which is not None and mark_of(aside) != which and not path.exists():
                aside.rename(path)
            else:
                aside.unlink()

    def keep(self, key: str, product: Product) -> None:
        """Write beside its place, and rename."""
        path = self._path(key)
        with writing(self.path.parent):  # which people know
            path.parent.mkdir(parents=True, exist_ok=True)
            for left in reversed(range(WRITES)):
                temporary = path.with_name(f".{key}.{uuid.uuid4().hex[:8]}")
                try:
                    with temporary.open("wb") as file:
                        write_archive(file, product)
                    temporary.replace(path)
                    break
                except FileNotFoundError:  # a run that began meanwhile took it for that of a killed one
                    if not left:
                        raise
                finally:
                    temporary.unlink(missing_ok=True)

    def keys_of_kind(self, kind: str) -> list[str]:
        """By the names of the files."""
        return sorted(path.stem for path in self.path.glob(f"*/{kind}-*.npz"))

    def forget(self, *keys: str) -> None:
        """Remove files."""
        for key in keys:
            with contextlib.suppress(OSError):
                self._path(key).unlink()

    def text(self, name: str) -> str | None:
        """Of a file in the folder; raises OSError, UnicodeDecodeError."""
        try:
            return (self.path / name).read_text(encoding="utf-8")
        except FileNotFoundError:
            return None

    def keep_text(self, name: str, text: str) -> str:
        """Write beside its place, and rename."""
        path = self.path / name
        with writing(self.path.parent):
            self.path.mkdir(parents=True, exist_ok=True)
            temporary = self.path / f".{name}.{uuid.uuid4().hex[:8]}"
            try:
                temporary.write_text(text, encoding="utf-8")
                temporary.replace(path)
            finally:
                temporary.unlink(missing_ok=True)
        return str(path)

    def forget_text(self, name: str) -> None:
        """Remove a file."""
        with contextlib.suppress(OSError):
            (self.path / name).unlink()

    def clear(self) -> None:
        """Remove the folder."""
        shutil.rmtree(self.path, ignore_errors=True)


def whole_url(url: str) -> str:
    """The same for processes that work in another folder: a path that is relative to this one is made whole."""
    path = url.removeprefix("file://")
    relative = path not in {"", url} and not path.startswith(("/", "~")) and not Path(path).is_absolute()
    return f"file://{Path(path).absolute().as_posix()}" if relative else url


def place_at(path: Path, url: str, cut: set[str] | None = None) -> Place:
    """Where products lie: at a URL, or in a folder where that is empty; `cut` as of `Files`."""
    if not url:
        return Files(path, set() if cut is None else cut)
    from raybundle.pipeline.objects import objects_at

    return objects_at(url)


@dataclass(frozen=True, slots=True)
class Folder:
    """A store of archives in a folder, or with a folder for what belongs to it beside them."""

    path: Path
    url: str = ""
    """of the object store in which the archives lie; empty: they lie in the folder"""
    place: Place = field(init=False, repr=False, compare=False)
    makers: dict[str, Callable[[], object]] = field(
        default_factory=dict[str, Callable[[], object]], repr=False, compare=False
    )
    """how the products of this run are made again, by their keys, when one is found damaged"""
    mended: set[str] = field(default_factory=set[str], repr=False, compare=False)
    """keys of products that were found damaged, or gone though they had been there"""
    _held: OrderedDict[str, dict[str, Array]] = field(
        default_factory=OrderedDict[str, dict[str, Array]], repr=False, compare=False
    )
    _verified: dict[str, tuple[FileMark | None, set[int]]] = field(
        default_factory=dict[str, tuple[FileMark | None, set[int]]], repr=False, compare=False
    )
    """of each product its file (number, time, length), and where arrays begin whose sums were right"""
    _lock: Lock = field(default_factory=Lock, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Where the archives lie."""
        object.__setattr__(self, "url", whole_url(self.url))  # the class is frozen
        object.__setattr__(self, "place", place_at(self.path, self.url, self.mended))

    def check_shared(self) -> None:
        """Raise InputError where other processes do not see it."""
        if not self.place.shared:
            raise InputError(
                "store.in_memory",
                file=self.place.name,
            )

    def has(self, key: str) -> bool:
        """Whether a product is there in its whole length; one that was cut is removed.  Its numbers are not read."""
        return self.place.has(key)

    def those(self, keys: Sequence[str]) -> set[str]:
        """Those of many products that are there."""
        return self.place.those(keys)

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
        damaged = False
        for _ in range(READS):
            path = self.place.file(key)
            if path is None:
                break
            which = None
            try:
                with path.open("rb") as file:
                    which = mark_of(file.fileno())
                    members = members_of(file)
                    if str(read_member(file, members[KEY])) != key:
                        raise ValueError(path.name)  # another product under this name
                    wanted = [name for name in names or members if name != KEY]
                    return dict(zip(wanted, read(file, [members[name] for name in wanted]), strict=True))
            except FileNotFoundError:
                continue
            except DAMAGED as error:
                if isinstance(error, OSError) and error.errno in SHORT:
                    raise StoreLost(
                        "store.not_readable",
                        detail=error.strerror or str(error),
                        file=self.place.name,
                    ) from None
                self.place.damaged(key, damaged, which)
                damaged = True
        if damaged:  # not a copy alone
            self.mended.add(key)
        return None

    def _known(self, key: str, number: int) -> set[int]:
        """Where the arrays of a file begin that this process has verified."""
        file = mark_of(number)
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
        if found is None:
            self.mended.add(key)
        if found is None and key in self.makers:
            self.makers[key]()
            found = read()
        if found is None:
            raise ProductGone(key, self.place.name)
        return found

    def release(self) -> None:
        """Let go of what is mapped."""
        with self._lock:
            self._held.clear()

    def store(self, key: str, product: Product) -> None:
        """Keep a product; it appears whole or not at all."""
        self.place.keep(key, {**product, KEY: np.array(key)})

    def keys_of_kind(self, kind: str) -> list[str]:
        """Keys of all products whose key begins with this word, in order."""
        return self.place.keys_of_kind(kind)

    def forget(self, key: str) -> None:
        """Remove a product."""
        self.place.forget(key)

    def forget_kind(self, kind: str) -> None:
        """Remove all products whose key begins with this word."""
        self.place.forget(*self.keys_of_kind(kind))


def store_at(folder: str, url: str) -> Folder:
    """A store, the same one for all tasks of this process: what was verified need not be again."""
    if (folder, url) not in _stores:
        _stores[folder, url] = Folder(Path(folder), url)
    return _stores[folder, url]


_stores: dict[tuple[str, str], Folder] = {}


@contextmanager
def writing(folder: Path) -> Generator[None]:
    """Turn a full disk, a read-only folder and the like into a message that states what to do."""
    try:
        yield
    except (OSError, sqlite3.OperationalError) as error:
        full = getattr(error, "errno", None) in FULL or "full" in str(error)
        detail = str(getattr(error, "strerror", None) or error)
        cause = "full" if full else "other"
        if isinstance(error, IsADirectoryError | NotADirectoryError | FileExistsError):
            cause, detail = "occupied", f"{error.filename2 or error.filename}: {detail}"
        kept = folder.is_dir() and any(folder.rglob("*.npz"))
        raise InputError("project.not_writable", cause=cause, detail=detail, kept=kept, file=folder) from None
