"""Project folders: one SQLite file and a cache by content hash, safe to be killed at any instant.

    PROJECT/project.toml     inputs and settings, as given
    PROJECT/project.db       stages, photographs, verified pairs (SQLite)
    PROJECT/cache/xx/KEY.npz products of stages; a key holds the hash of everything that the product depends on.
                             Of a run with an object store they lie there (`objects`), which project.toml remembers
    PROJECT/result/          the current result folder
    PROJECT/results/         earlier ones (`raybundle.results.project_results`)
    PROJECT/block/           the photographs alone, where they are measured by hand and `orient` made no result
    PROJECT/running.json     how far a stage in work is
    PROJECT/failed-tasks.log what tasks stated that failed three times
    PROJECT/surface/         dense points of `surface`, with what is kept for its next run
    PROJECT/film/            what is known of the film that the photographs are scans of
    PROJECT/measured.db      what was measured by hand (`raybundle.measuring.journal`)
    PROJECT/measured-masks/  masks drawn by hand as pictures, with those that were given, as the last run took them

Nothing is ever changed in place: a product is written beside its place and renamed, a row is inserted in a
transaction.  What is there is complete; what is missing or damaged is made again.  One run at a time works in a
project: its folder is locked while it is open (flock; not on Windows).
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import shutil
import sqlite3
import sys
import time
import uuid
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError, Text, joined_texts
from raybundle.io.photos.remote import url_of
from raybundle.io.reading.trees import json_of, read_json, read_toml
from raybundle.numerics.arrays import Array
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product, kind_of
from raybundle.pipeline.processor_time import cpu_seconds
from raybundle.pipeline.store import Folder, writing

SCHEMA = 1
HERE = "project"
"""Name of a store: the project folder itself."""
OWN = {
    "project.db", "project.db-wal", "project.db-shm", "project.toml", "cache", "result", "results", "block", "film",
    "surface", "measured.db", "measured.db-wal", "measured.db-shm", "measured-masks", "failed-tasks.log",
    "running.json",
}  # fmt: skip
_LEFTOVER = re.compile(r"\.result\.[0-9a-f]{8}\.(?:partial|old)|\.(?:project\.toml|running\.json)\.[0-9a-f]{8}")
"""Names under which a killed run leaves what it had begun to write."""
_PRODUCT = re.compile(
    r"[A-Za-z0-9_ -]+-[0-9a-f]{40}\.npz|\.[A-Za-z0-9_ -]+-[0-9a-f]{40}\.[0-9a-f]{8}|\.pixels-[a-z0-9_]{8}"
    r"|tasks\.jsonl|token|\.(?:tasks\.jsonl|token)\.[0-9a-f]{8}"
)
"""Names of products, of lists of tasks, and of what a killed run had begun of them."""
_TABLES = """
CREATE TABLE IF NOT EXISTS about (name TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS stages (
  position INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, key TEXT NOT NULL, seconds REAL NOT NULL,
  cpu_seconds REAL NOT NULL, peak_memory_mb REAL NOT NULL, from_cache INTEGER NOT NULL, finished TEXT NOT NULL,
  summary TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS pairs (key TEXT PRIMARY KEY, facts TEXT NOT NULL, matches BLOB NOT NULL) WITHOUT ROWID;
"""


@dataclass(frozen=True, slots=True, kw_only=True)
class StageRecord:
    """What a stage took, and when."""

    name: str
    key: str
    seconds: float
    cpu_seconds: float
    """of this process, and of those here and elsewhere that did tasks"""
    peak_memory_mb: float
    """of the process up to the end of the stage"""
    from_cache: bool
    finished: str = ""
    summary: str = ""

    def and_then(self, later: StageRecord) -> StageRecord:
        """This one and the next as one line."""
        return StageRecord(
            name=self.name,
            key=key_of(self.name, self.key, later.key),
            seconds=self.seconds + later.seconds,
            cpu_seconds=self.cpu_seconds + later.cpu_seconds,
            peak_memory_mb=max(self.peak_memory_mb, later.peak_memory_mb),
            from_cache=self.from_cache and later.from_cache,
            finished=later.finished,
            summary=_joined(self.summary, later.summary),
        )


def _joined(first: str, second: str) -> str:
    """Two summaries as one."""
    if isinstance(first, Text) and isinstance(second, Text):
        return joined_texts(first, second)
    return first if not second else second if not first else f"{first}; {second}"


@dataclass(slots=True)
class Timed:
    """A stage in work; `key`, `from_cache` and `summary` are set by its body."""

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
    store: str = ""
    """where the products lie, as `store_given` states"""
    products: Folder = field(init=False)

    def __post_init__(self) -> None:
        """The store of this folder."""
        self.products = products_of(self.folder, self.store)

    @classmethod
    def open(cls, folder: Path, *, create: bool = True, store: str = "") -> Project:
        """Open a project folder for a run, or begin one; `create=False` only looks at one, and changes nothing.

        store   URL of the object store of its products; "project": they lie in the folder; empty: that of the last
                run
        raises  InputError where something else stands there, another run works there, or nothing can be written
        """
        if url := url_of(folder):
            raise InputError("project.at_url", file=url)
        file = folder / "project.db"
        if not create:
            return cls(folder, _opened(file, _connection_to_read), store=store)
        if not file.exists() and folder.exists() and not _begun(folder):
            raise InputError("project.folder_not_empty", file=folder)
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
                return cls(folder, db, lock=lock, store=store)
            except BaseException:
                _unlock(lock)
                raise

    def close(self) -> None:
        """Close the database and give the lock back."""
        self.db.close()
        _unlock(self.lock)
        self.lock = None

    # products

    def forget_kind(self, kind: str) -> None:
        """Remove all products whose key begins with this word."""
        self.products.forget_kind(kind)
        with writing(self.folder):
            self.db.execute("DELETE FROM pairs WHERE key LIKE ? || '-%'", (kind,))

    # small products: some numbers and texts (arrays of no dimension) and whole numbers in two columns, "matches"

    def _rows(self, columns: str, keys: Sequence[str]) -> list[tuple[Any, ...]]:
        found: list[tuple[Any, ...]] = []
        for begin in range(0, len(keys), 500):
            part = keys[begin : begin + 500]
            marks = ",".join("?" * len(part))
            with _reading(self.folder / "project.db"):
                found += self.db.execute(
                    f"SELECT {columns} FROM pairs WHERE key IN ({marks})",  # noqa: S608
                    part,
                ).fetchall()
        return found

    def small(self, keys: Sequence[str]) -> dict[str, dict[str, Array]]:
        """The small products among these keys; a damaged one is missing."""
        found: dict[str, dict[str, Array]] = {}
        for key, facts, blob in self._rows("key, facts, matches", keys):
            with contextlib.suppress(ValueError, TypeError, AttributeError, InputError):
                numbers = json_of(facts, self.folder / "project.db")
                found[key] = {
                    **{name: np.array(np.nan if value is None else value) for name, value in numbers.items()},
                    "matches": np.frombuffer(blob, np.int32).reshape(-1, 2),
                }
        return found

    def store_small(self, rows: Sequence[tuple[str, Product]]) -> None:
        """Keep small products, all or none."""
        if not rows:
            return
        written = [
            (
                key,
                json.dumps(small_of(product)),
                np.ascontiguousarray(product["matches"], np.int32).tobytes(),
            )
            for key, product in rows
        ]
        with writing(self.folder), self._transaction():
            self.db.executemany("INSERT OR REPLACE INTO pairs VALUES (?, ?, ?)", written)

    # stages

    @contextmanager
    def stage(self, name: str) -> Generator[Timed]:
        """Time a stage and record it when its body ends without an error.

        Stages of one name that follow each other are one line of the record.
        """
        began, cpu = time.perf_counter(), cpu_seconds()
        stage = Timed(name)
        yield stage
        record = StageRecord(
            name=name,
            key=stage.key,
            seconds=time.perf_counter() - began,
            cpu_seconds=cpu_seconds() - cpu,
            peak_memory_mb=_peak_memory_mb(),
            from_cache=stage.from_cache,
            finished=time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime()),
            summary=stage.summary,
        )
        if self.records and self.records[-1].name == name:
            record = self.records.pop().and_then(record)
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


def small_of(product: Mapping[str, Array]) -> dict[str, Any]:
    """The numbers and texts of a small product; None for what is not a number, which JSON cannot say."""
    values = {name: value.item() for name, value in product.items() if name != "matches"}
    return {name: None if value != value else value for name, value in values.items()}  # noqa: PLR0124  (NaN)


def discard_empty(folder: Path, cheap: str = "") -> None:
    """Delete a project folder that a run began and that holds no product, or none but of the kind `cheap`."""
    files = (p for p in folder.rglob("*") if not p.is_dir())
    held = {str(p.relative_to(folder)) for p in files if not cheap or kind_of(p.stem) != cheap}
    if held <= {"project.db", "project.db-wal", "project.db-shm", "project.toml", "running.json"}:
        shutil.rmtree(folder, ignore_errors=True)


@contextmanager
def _reading(file: Path, *, writes: bool = False) -> Generator[None]:
    """Turn a damaged database into a message that states what to do."""
    try:
        yield
    except (sqlite3.DatabaseError, UnicodeDecodeError) as error:
        text = "malformed text" if isinstance(error, UnicodeDecodeError) else str(error)
        if isinstance(error, sqlite3.OperationalError) and writes and "locked" not in text and "malformed" not in text:
            raise  # nothing can be written: for `writing` to say
        damaged = any(word in text for word in ("malformed", "not a database", "encrypted", "corrupt"))
        raise InputError("project.not_readable", detail=text, damaged=damaged, file=file) from None


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
            "project.schema",
            found=schema,
            read=SCHEMA,
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
            "project.no_database",
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
    begun += [p for place in ("??/.*", ".*") for p in (folder / "cache").glob(place) if _PRODUCT.fullmatch(p.name)]
    for path in begun:
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path, ignore_errors=True)
        else:
            with contextlib.suppress(OSError):
                path.unlink()


def _locked(folder: Path) -> int | None:
    """A file descriptor that locks the folder; None where the system has no such lock."""
    try:
        import fcntl
    except ImportError:
        return None
    number = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(number)
        raise InputError("project.in_use", file=folder) from None
    except OSError:  # a file system without locks
        os.close(number)
        return None
    return number


def _unlock(lock: int | None) -> None:
    if lock is not None:
        os.close(lock)


def _peak_memory_mb() -> float:
    try:
        import resource
    except ImportError:
        return 0.0
    unit = 1024**2 if sys.platform == "darwin" else 1024  # macOS counts bytes, Linux kilobytes
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / unit


PHOTOGRAPHS_IN = "photographs_in"
"""Of result.json, of a result that stands apart from its project: folders of its photographs"""


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
    try:
        named = read_json(result / "result.json").get(PHOTOGRAPHS_IN).items()
        return tuple(p for p in (Path(n.text()) for n in named) if p.is_dir())
    except InputError:
        return ()


def store_given(folder: Path) -> str:
    """Where the products of a project lie, as its last run was reported: a URL, HERE, or nothing."""
    file = folder / "project.toml"
    if not file.is_file():
        return ""
    try:
        tree = read_toml(file).tree()
        asked = [tree.get(command) for command in ("orient", "surface") if tree.has(command)]
        return next((a.get("store").text() for a in asked if a.has("store")), "")
    except InputError:
        return ""


def products_of(folder: Path, store: str = "") -> Folder:
    """The products of a project; `store` as for `Project.open`.

    raises  InputError for a URL that project.toml names and the user has not confirmed
    """
    url = store or store_given(folder)
    if not store and url not in {"", HERE}:
        from raybundle.pipeline.confirmed_stores import check_confirmed

        check_confirmed(url, folder / "project.toml")
    return Folder(folder / "cache", "" if url == HERE else url)


def masks_given(result: Path) -> Path | None:
    """The folder of masks that the run of a project, or of its result folder, was given; None: none."""
    for folder in (result, result.parent):
        file = folder / "project.toml"
        if not file.is_file():
            continue
        try:
            found = Path(read_toml(file).tree().get("orient").get("masks").text())
        except InputError:
            return None
        return found if found.is_dir() else None
    return None
