"""Project folders: one SQLite file and a cache by content hash, safe to be killed at any instant.

    PROJECT/project.toml     inputs and settings, as given
    PROJECT/project.db       stages, photographs, verified pairs (SQLite)
    PROJECT/cache/xx/KEY.npz products of stages; a key holds the hash of everything that the product depends on
    PROJECT/result/          the result folder

Nothing is ever changed in place: a product is written beside its place and renamed, a row is inserted in a
transaction.  What is there is complete; what is missing or damaged is made again.  One run at a time works in a
project: its folder is locked while it is open (flock; not on Windows).
"""

from __future__ import annotations

import contextlib
import errno
import hashlib
import json
import os
import re
import shutil
import sqlite3
import struct
import time
import uuid
import zipfile
import zlib
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.trees import json_of, read_toml
from raybundle.numerics.arrays import Array

SCHEMA = 1
OWN = {"project.db", "project.db-wal", "project.db-shm", "project.toml", "cache", "result"}
_LEFTOVER = re.compile(r"\.result\.[0-9a-f]{8}\.(?:partial|old)|\.project\.toml\.[0-9a-f]{8}")
"""Names under which a killed run leaves what it had begun to write."""
_PRODUCT = re.compile(
    r"[A-Za-z0-9_ -]+-[0-9a-f]{40}\.npz|\.[A-Za-z0-9_ -]+-[0-9a-f]{40}\.[0-9a-f]{8}|\.pixels-[a-z0-9_]{8}"
)
"""Names of products, and of those that a killed run had begun."""
KEY = "__key__"
"""Array of a product that holds the key under which it was kept."""
DAMAGED = (
    OSError, ValueError, EOFError, zipfile.BadZipFile, zlib.error, struct.error, KeyError, MemoryError, OverflowError,
    RuntimeError, SyntaxError, TypeError,
)  # fmt: skip
"""What reading a damaged archive of arrays can raise; unsupported and too deep ones are RuntimeErrors."""
FULL = {errno.ENOSPC, errno.EDQUOT} if hasattr(errno, "EDQUOT") else {errno.ENOSPC}
_TABLES = """
CREATE TABLE IF NOT EXISTS about (name TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS stages (
  position INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, key TEXT NOT NULL, seconds REAL NOT NULL,
  cpu_seconds REAL NOT NULL, peak_memory_mb REAL NOT NULL, from_cache INTEGER NOT NULL, finished TEXT NOT NULL,
  summary TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS pairs (key TEXT PRIMARY KEY, facts TEXT NOT NULL, matches BLOB NOT NULL) WITHOUT ROWID;
"""


def key_of(kind: str, *parts: object) -> str:
    """The kind of a product and the hash of everything it depends on: texts, numbers, arrays, mappings of them."""
    text = json.dumps(parts, sort_keys=True, ensure_ascii=False, allow_nan=True, separators=(",", ":"), default=_plain)
    return f"{kind}-{hashlib.sha256(text.encode('utf-8', 'surrogatepass')).hexdigest()[:40]}"


def _write_arrays(file: BinaryIO, product: Mapping[str, Array]) -> None:
    """Write an archive of arrays as np.savez does, and let go of it where the disk is full.

    np.savez before NumPy 2 leaves the archive open then; when it is collected it prints a traceback.
    """
    with zipfile.ZipFile(file, "w") as archive:
        for name, values in product.items():
            with archive.open(f"{name}.npy", "w", force_zip64=True) as member:
                np.lib.format.write_array(member, np.asanyarray(values), allow_pickle=False)


def _plain(value: object) -> object:
    if isinstance(value, Mapping):
        return dict(value)
    if isinstance(value, np.ndarray):
        return hashlib.sha256(np.ascontiguousarray(value).tobytes()).hexdigest()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, Path):
        return str(value)
    raise TypeError(f"{type(value).__name__} cannot be part of a key")


@dataclass(frozen=True, slots=True, kw_only=True)
class StageRecord:
    """What a stage took, and when."""

    name: str
    key: str
    seconds: float
    cpu_seconds: float
    """of all threads of this process"""
    peak_memory_mb: float
    """of the process up to the end of the stage"""
    from_cache: bool
    finished: str = ""
    summary: str = ""


@dataclass(slots=True)
class Stage:
    """A stage in work; `from_cache` and `summary` are set by its body."""

    name: str
    key: str = ""
    from_cache: bool = True
    summary: str = ""


@dataclass(slots=True)
class Project:
    """An open project folder."""

    folder: Path
    db: sqlite3.Connection
    records: list[StageRecord] = field(default_factory=list[StageRecord])
    """of this run"""

    lock: int | None = None
    """file descriptor that holds the lock"""

    @classmethod
    def open(cls, folder: Path, *, create: bool = True) -> Project:
        """Open a project folder for a run, or begin one; `create=False` only looks at one, and changes nothing.

        raises  InputError where something else stands there, another run works there, or nothing can be written
        """
        file = folder / "project.db"
        if not create:
            return cls(folder, _opened(file, _connection_to_read))
        if not file.exists() and folder.exists() and not _begun(folder):
            raise InputError("exists and is neither empty nor a project folder; choose another --out", file=folder)
        with writing(folder):
            folder.mkdir(parents=True, exist_ok=True)
            lock = _locked(folder)
            try:
                _sweep(folder, locked=lock is not None)
                db = _opened(file, _connection_to_write)
                try:
                    (folder / "cache").mkdir(exist_ok=True)  # after the database, by which the folder is known
                except BaseException:
                    db.close()
                    raise
                return cls(folder, db, lock=lock)
            except BaseException:
                _unlock(lock)
                raise

    def close(self) -> None:
        """Close the database and give the lock back."""
        self.db.close()
        _unlock(self.lock)
        self.lock = None

    # products

    def _path(self, key: str) -> Path:
        return self.folder / "cache" / key[-2:] / f"{key}.npz"

    def has(self, key: str) -> bool:
        """Whether a product is there and whole, by its check sums; a damaged one is removed."""
        path = self._path(key)
        try:
            with zipfile.ZipFile(path) as file:
                if file.testzip() is None:
                    return True
        except FileNotFoundError:
            return False
        except DAMAGED:
            pass
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

    def store(self, key: str, product: Mapping[str, Array]) -> None:
        """Keep a product; it appears whole or not at all."""
        path = self._path(key)
        with writing(self.folder):
            path.parent.mkdir(parents=True, exist_ok=True)
            temporary = path.with_name(f".{key}.{uuid.uuid4().hex[:8]}")
            try:
                with temporary.open("wb") as file:
                    _write_arrays(file, {**product, KEY: np.array(key)})
                temporary.replace(path)
            finally:
                temporary.unlink(missing_ok=True)

    def forget_kind(self, kind: str) -> None:
        """Remove all products whose key begins with this word."""
        for path in (self.folder / "cache").glob(f"*/{kind}-*.npz"):
            with contextlib.suppress(OSError):
                path.unlink()

    # pairs

    def pairs(self, keys: Sequence[str]) -> dict[str, tuple[dict[str, Any], Array]]:
        """The verified pairs among these keys: facts and matches (k, 2)."""
        found: dict[str, tuple[dict[str, Any], Array]] = {}
        for begin in range(0, len(keys), 500):
            part = keys[begin : begin + 500]
            marks = ",".join("?" * len(part))
            with _reading(self.folder / "project.db"):
                rows = self.db.execute(
                    f"SELECT key, facts, matches FROM pairs WHERE key IN ({marks})",  # noqa: S608
                    part,
                ).fetchall()
            for key, facts, blob in rows:
                with contextlib.suppress(ValueError, TypeError, InputError):  # a damaged row is missing
                    found[key] = (
                        json_of(facts, self.folder / "project.db"),
                        np.frombuffer(blob, np.int32).reshape(-1, 2),
                    )
        return found

    def store_pairs(self, rows: Sequence[tuple[str, Mapping[str, Any], Array]]) -> None:
        """Keep verified pairs, all or none."""
        with writing(self.folder), self._transaction():
            self.db.executemany(
                "INSERT OR REPLACE INTO pairs VALUES (?, ?, ?)",
                [(key, json.dumps(facts), np.ascontiguousarray(m, np.int32).tobytes()) for key, facts, m in rows],
            )

    def forget_pairs(self) -> None:
        """Remove all verified pairs."""
        with writing(self.folder):
            self.db.execute("DELETE FROM pairs")

    # stages

    @contextmanager
    def stage(self, name: str) -> Generator[Stage]:
        """Time a stage and record it when its body ends without an error."""
        began, cpu = time.perf_counter(), _cpu_seconds()
        stage = Stage(name)
        yield stage
        record = StageRecord(
            name=name,
            key=stage.key,
            seconds=time.perf_counter() - began,
            cpu_seconds=_cpu_seconds() - cpu,
            peak_memory_mb=_peak_memory_mb(),
            from_cache=stage.from_cache,
            finished=time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime()),
            summary=stage.summary,
        )
        self.records.append(record)
        with writing(self.folder), self._transaction():
            # the first stage of a run begins the list anew
            self.db.execute("DELETE FROM stages WHERE name = ? OR position >= ?", (name, len(self.records)))
            self.db.execute(
                "INSERT INTO stages VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
                (
                    len(self.records), name, record.key, record.seconds, record.cpu_seconds, record.peak_memory_mb,
                    int(record.from_cache), record.finished, record.summary,
                ),
            )  # fmt: skip

    def stages(self) -> list[StageRecord]:
        """The stages of the last run, in order."""
        with _reading(self.folder / "project.db"):
            rows = self.db.execute(
                "SELECT name, key, seconds, cpu_seconds, peak_memory_mb, from_cache, finished, summary FROM stages "
                "ORDER BY position"
            ).fetchall()
        return [
            StageRecord(
                name=r[0], key=r[1], seconds=r[2], cpu_seconds=r[3], peak_memory_mb=r[4], from_cache=bool(r[5]),
                finished=r[6], summary=r[7],
            )
            for r in rows
        ]  # fmt: skip

    def write_settings(self, text: str) -> None:
        """project.toml, whole or not at all."""
        with writing(self.folder):
            temporary = self.folder / f".project.toml.{uuid.uuid4().hex[:8]}"
            try:
                temporary.write_text(text, encoding="utf-8")
                temporary.replace(self.folder / "project.toml")
            finally:
                temporary.unlink(missing_ok=True)

    @contextmanager
    def _transaction(self) -> Generator[None]:
        self.db.execute("BEGIN IMMEDIATE")
        try:
            yield
        except BaseException:
            if self.db.in_transaction:  # a full disk has ended it already
                self.db.execute("ROLLBACK")
            raise
        self.db.execute("COMMIT")


def discard_empty(folder: Path) -> None:
    """Delete a project folder that a run began and that holds no product: there is nothing to continue."""
    held = {str(p.relative_to(folder)) for p in folder.rglob("*") if not p.is_dir()}
    if held <= {"project.db", "project.db-wal", "project.db-shm", "project.toml"}:
        shutil.rmtree(folder, ignore_errors=True)


@contextmanager
def writing(folder: Path) -> Generator[None]:
    """Turn a full disk, a read-only folder and the like into a message that says what to do."""
    try:
        yield
    except (OSError, sqlite3.OperationalError) as error:
        full = getattr(error, "errno", None) in FULL or "full" in str(error)
        what = "no space is left" if full else str(getattr(error, "strerror", None) or error)
        advice = "free space and run the same command again" if full else "choose a folder that can be written"
        raise InputError(
            f"cannot be written: {what}; {advice}. What is finished is kept, the run continues there", file=folder
        ) from None


@contextmanager
def _reading(file: Path, *, writes: bool = False) -> Generator[None]:
    """Turn a damaged database into a message that says what to do."""
    try:
        yield
    except (sqlite3.DatabaseError, UnicodeDecodeError) as error:
        text = "malformed text" if isinstance(error, UnicodeDecodeError) else str(error)
        if isinstance(error, sqlite3.OperationalError) and writes and "locked" not in text and "malformed" not in text:
            raise  # nothing can be written: for `writing` to say
        if any(word in text for word in ("malformed", "not a database", "encrypted", "corrupt")):
            advice = "delete this file and run the same command again: features are kept, pairs are matched again"
        else:
            advice = "close other programs that use the project, or choose another --out"
        raise InputError(f"cannot be read: {text}; {advice}", file=file) from None


def _opened(file: Path, connect: Callable[[Path], sqlite3.Connection]) -> sqlite3.Connection:
    """A connection whose schema is ours; raises InputError."""
    with _reading(file, writes=connect is _connection_to_write):
        db = connect(file)
        try:
            found = db.execute("SELECT value FROM about WHERE name = 'schema'").fetchone()
        except BaseException:
            db.close()
            raise
    schema = "none" if found is None else found[0]
    if schema != str(SCHEMA):
        db.close()
        raise InputError(
            f"was written by another version (schema {schema}, this program reads {SCHEMA}); orient into a new folder",
            file=file.parent,
        )
    return db


def _connection_to_write(file: Path) -> sqlite3.Connection:
    db = sqlite3.connect(file, timeout=30, isolation_level=None, check_same_thread=False)
    try:
        db.execute("PRAGMA journal_mode=WAL")
        db.execute("PRAGMA synchronous=NORMAL")
        db.execute("PRAGMA trusted_schema=OFF")
        db.executescript(_TABLES)
        db.execute("INSERT OR IGNORE INTO about VALUES ('schema', ?)", (str(SCHEMA),))
    except BaseException:
        db.close()
        raise
    return db


def _connection_to_read(file: Path) -> sqlite3.Connection:
    """A connection that changes nothing, also where the folder cannot be written."""
    if not file.is_file():
        raise InputError(
            "is no project folder (project.db is missing); begin one with `raybundle orient PHOTOS --out`",
            file=file.parent,
        )
    running = file.with_name("project.db-wal").exists()
    for mode in ("mode=ro", "mode=ro&immutable=1")[not running :]:  # the second takes no locks and writes nothing
        db = sqlite3.connect(f"{file.absolute().as_uri()}?{mode}", uri=True, timeout=30, isolation_level=None)
        try:
            db.execute("PRAGMA trusted_schema=OFF")
            db.execute("SELECT name FROM about").fetchall()
        except sqlite3.OperationalError as error:
            db.close()
            if mode != "mode=ro" or "unable to open" not in str(error):
                raise
        except BaseException:
            db.close()
            raise
        else:
            return db
    raise AssertionError


def _begun(folder: Path) -> bool:
    """Whether a folder is empty, or a project whose database was deleted: its settings or products are ours."""
    if not folder.is_dir():
        return False
    names = {p.name for p in folder.iterdir() if not _LEFTOVER.fullmatch(p.name)}
    if not names:
        return True
    products = [p for place in (folder / "cache").glob("*") for p in (place.iterdir() if place.is_dir() else [place])]
    ours = all(_PRODUCT.fullmatch(p.name) for p in products)
    return names <= OWN and ours and (bool(products) or _has_settings(folder / "project.toml"))


def _has_settings(file: Path) -> bool:
    try:
        return file.is_file() and read_toml(file).tree().has("orient")
    except InputError:
        return False


def _sweep(folder: Path, *, locked: bool) -> None:
    """Remove what a killed run had begun to write, known by its whole name; nobody else is writing here."""
    if not locked:
        return
    begun = [p for p in folder.iterdir() if _LEFTOVER.fullmatch(p.name)]
    begun += [p for p in (folder / "cache").glob("??/.*") if _PRODUCT.fullmatch(p.name)]
    for path in begun:
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path, ignore_errors=True)
        else:
            with contextlib.suppress(OSError):
                path.unlink()


def _locked(folder: Path) -> int | None:
    """A file descriptor that locks the folder; None where the system has no such lock."""
    try:
        import fcntl  # noqa: PLC0415  (not on Windows)
    except ImportError:
        return None
    number = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(number)
        raise InputError(
            "another run works in this project; wait for it, or choose another --out", file=folder
        ) from None
    except OSError:  # a file system without locks
        os.close(number)
        return None
    return number


def _unlock(lock: int | None) -> None:
    if lock is not None:
        os.close(lock)


def _cpu_seconds() -> float:
    t = os.times()
    return t.user + t.system + t.children_user + t.children_system


def _peak_memory_mb() -> float:
    try:
        import resource  # noqa: PLC0415  (not on Windows)
    except ImportError:
        return 0.0
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def photographs_of(result: Path) -> tuple[Path, ...]:
    """Folders of the photographs that a result folder, or its project, was made from, as far as they are there."""
    for folder in (result, result.parent):
        file = folder / "project.toml"
        if not file.is_file():
            continue
        try:
            asked = read_toml(file).tree().get("orient").get("photos").items()
            paths = [Path(p.text()) for p in asked]
        except InputError:
            continue
        return tuple(dict.fromkeys(p if p.is_dir() else p.parent for p in paths if p.exists()))
    return ()
