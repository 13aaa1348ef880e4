"""The journal of measuring: every action in one SQLite file, kept for good; it is the audit trail.

    PROJECT/measured.db            of a project folder, also where its result is named
    RESULT.measured.db             beside a result or block folder, which is replaced whole when it is written again

A row is an action: its number, an id that whoever sent it chose (the same action sent twice counts once), time, author,
verb, and arguments as JSON.  Rows are added and never changed; undo and redo are rows.  What they add up to is a
`State`.  Several processes may add at once: an action is checked against all rows before it, and added, in one
transaction, and `append` returns when it is on the disk (write-ahead log, synchronous=FULL).
"""

from __future__ import annotations

import contextlib
import json
import os
import sqlite3
import threading
import uuid
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from time import sleep
from typing import Any, Self

from raybundle.errors import InputError, Message, message
from raybundle.io.reading.trees import json_of
from raybundle.io.reading.words import quoted
from raybundle.measuring.actions.verbs import Action, action_of
from raybundle.measuring.names import Known
from raybundle.measuring.state import Fold, State
from raybundle.results.project_results import RESULT, project_of

SCHEMA = "1"
LONGEST_ID, LONGEST_AUTHOR = 200, 200
_TABLES = """
BEGIN IMMEDIATE;
CREATE TABLE IF NOT EXISTS about (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS actions (
  seq INTEGER PRIMARY KEY AUTOINCREMENT, id TEXT NOT NULL UNIQUE, time TEXT NOT NULL, author TEXT NOT NULL,
  verb TEXT NOT NULL, arguments TEXT NOT NULL);
CREATE TRIGGER IF NOT EXISTS actions_stay BEFORE UPDATE ON actions
  BEGIN SELECT RAISE(ABORT, 'actions are never changed'); END;
CREATE TRIGGER IF NOT EXISTS actions_are_kept BEFORE DELETE ON actions
  BEGIN SELECT RAISE(ABORT, 'actions are never deleted'); END;
INSERT OR IGNORE INTO about VALUES ('schema', '1');
COMMIT;
"""


def named_folder(folder: str | Path) -> Path:
    """A folder in full; raises InputError for the root, which has no name beside which something could stand."""
    whole = Path(folder).resolve()
    if not whole.name:
        raise InputError("journal.no_place", file=folder)
    return whole


def journal_path(folder: str | Path) -> Path:
    """Where the journal of a project, result or block folder is; raises InputError where there are two."""
    project, whole = project_of(folder), named_folder(folder)
    beside = whole.with_name(f"{whole.name}.measured.db")
    if project is None:
        return beside
    if project.resolve() != whole and beside.is_file():
        raise InputError(
            "journal.two_journals",
            other=str(project / "measured.db"),
            file=beside,
        )
    return project / "measured.db"


def measured_result(folder: str | Path) -> Path:
    """Where the result of what was measured is written by default: that of a project, else beside the folder."""
    if (project := project_of(folder)) is not None:
        return project / RESULT
    whole = named_folder(folder)
    return whole.with_name(f"{whole.name}-measured")


@dataclass(frozen=True, slots=True, kw_only=True)
class Entry:
    """One row of the journal."""

    seq: int
    id: str
    time: str
    """UTC, ISO 8601 with milliseconds"""
    author: str
    verb: str
    arguments: Mapping[str, Any]

    @property
    def action(self) -> Action:
        """The action."""
        try:
            return action_of(self.verb, self.arguments)
        except InputError as error:
            details = [error.message] if error.message else []
            raise InputError("journal.foreign_action", details=details, action=self.seq) from None


@dataclass(slots=True)
class Journal:
    """An open journal; it may be used by several threads."""

    path: Path
    known: Known
    """What actions may name; may be exchanged when the block changes"""
    db: sqlite3.Connection
    read_only: Message | None = None
    """why nothing can be added, and what to do; empty: actions are added"""
    _file: tuple[int, int] = (0, 0)
    """device and number of the file that was opened"""
    _fold: Fold = field(default_factory=Fold)
    _seq: int = 0
    _lock: threading.RLock = field(default_factory=threading.RLock)

    @classmethod
    def open(cls, path: str | Path, known: Known) -> Journal:
        """Open a journal, or begin one; raises InputError where it is no journal or cannot be written."""
        path = Path(path)
        with _named_failure(path):
            # autocommit: transactions are begun and ended here
            db = sqlite3.connect(path, timeout=30, isolation_level=None, check_same_thread=False)
            try:
                db.execute("PRAGMA trusted_schema=OFF")
                _write_ahead(db)
                db.execute("PRAGMA synchronous=FULL")
                _with_schema(db, path)
            except BaseException:
                db.close()
                raise
        opened = path.stat()
        return cls(path, known, db, _file=(opened.st_dev, opened.st_ino))

    @classmethod
    def open_or_look(cls, path: str | Path, known: Known) -> Journal:
        """The same; where its folder cannot be written, what is there to be looked at; `append` then raises the reason.

        raises  InputError where it is no journal, or the folder can be written and the journal cannot
        """
        path = Path(path)
        try:
            return cls.open(path, known)
        except InputError:
            if can_be_written(path) or not path.parent.is_dir():
                raise
        db = sqlite3.connect(":memory:", isolation_level=None, check_same_thread=False)
        _with_schema(db, path)
        rows = [(e.seq, e.id, e.time, e.author, e.verb, json.dumps(e.arguments)) for e in entries_of(path)]
        db.executemany("INSERT INTO actions VALUES (?, ?, ?, ?, ?, ?)", rows)
        return cls(path, known, db, read_only=message("journal.read_only", folder=str(path.parent)))

    def close(self) -> None:
        """Close the file."""
        with self._lock:
            self.db.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def seq(self) -> int:
        """Number of the last action; 0: none."""
        with self._lock:
            self._refresh()
            return self._seq

    @property
    def state(self) -> State:
        """What all actions add up to, those of other processes included."""
        with self._lock:
            self._refresh()
            return self._fold.state

    def append(self, action: Action, *, id: str = "", author: str = "") -> int:  # noqa: A002  (the column's name)
        """Add an action; returns its number when it is on the disk.

        id      chosen by the sender, the same if it is sent again; "": a new one
        raises  InputError where the action cannot be done, and where the id was used for another action
        """
        chosen = id or uuid.uuid4().hex
        for what, text, most in (("id", chosen, LONGEST_ID), ("author", author, LONGEST_AUTHOR)):
            if len(text) > most:
                raise InputError("journal.text_too_long", entry=what, text=quoted(text), n=len(text), most=most)
            if not text.isprintable():
                raise InputError("journal.text_not_printable", entry=what, text=quoted(text))
        if self.read_only:
            raise InputError(self.read_only)
        with self._lock, self._transaction():
            self._check_there()
            # all before it: nobody else can add until this transaction ends
            self._refresh()
            found = self.db.execute("SELECT seq, verb, arguments FROM actions WHERE id = ?", (chosen,)).fetchone()
            if found is not None:
                if not _same(action, found[1], found[2]):
                    raise InputError("journal.id_used", id=quoted(chosen), action=found[0], verb=found[1])
                return int(found[0])
            settled = action.settled(self._fold.state, self.known)
            time = datetime.now(UTC).isoformat(timespec="milliseconds")
            row = (chosen, time, author, action.verb, _json(settled))
            done = self.db.execute(
                "INSERT INTO actions (id, time, author, verb, arguments) VALUES (?, ?, ?, ?, ?)", row
            )
            return int(done.lastrowid or 0)

    def _check_there(self) -> None:
        """Raise InputError where the open file is no longer the one that stands at its path."""
        try:
            there = self.path.stat()
        except OSError:
            there = None
        if there is None or (there.st_dev, there.st_ino) != self._file:
            raise InputError(
                "journal.moved",
                file=self.path,
            )

    def append_verb(self, verb: str, arguments: Mapping[str, Any], *, id: str = "", author: str = "") -> int:  # noqa: A002
        """Add an action that is given as its verb and its arguments as JSON; see `append`."""
        return self.append(action_of(verb, arguments), id=id, author=author)

    def entries(self, after: int = 0) -> list[Entry]:
        """The rows with larger numbers, in order."""
        with self._lock, _named_failure(self.path):
            rows = self.db.execute(
                "SELECT seq, id, time, author, verb, arguments FROM actions WHERE seq > ? ORDER BY seq", (after,)
            ).fetchall()
        return [_entry(row, self.path) for row in rows]

    def _refresh(self) -> None:
        new = self.entries(self._seq)
        if new:
            self._fold.add([e.action for e in new])
            self._seq = new[-1].seq

    @contextmanager
    def _transaction(self) -> Generator[None]:
        with _named_failure(self.path):
            self.db.execute("BEGIN IMMEDIATE")
            try:
                yield
                self.db.execute("COMMIT")
            except BaseException:
                with contextlib.suppress(sqlite3.Error):
                    if self.db.in_transaction:  # a full disk has ended it already
                        self.db.execute("ROLLBACK")
                raise


def entries_of(path: str | Path) -> list[Entry]:
    """The rows of a journal that may not exist; nothing is written."""
    path = Path(path)
    if not path.exists():
        return []
    log = path.with_name(f"{path.name}-wal")
    # a log's index is a file that SQLite makes, also to read: where it cannot, nobody else writes either
    alone = not can_be_written(path) and not (log.exists() and log.stat().st_size)
    how = "immutable=1" if alone else "mode=ro"
    with _named_failure(path):
        db = sqlite3.connect(f"{path.absolute().as_uri()}?{how}", uri=True, timeout=30, isolation_level=None)
        try:
            rows = db.execute("SELECT seq, id, time, author, verb, arguments FROM actions ORDER BY seq").fetchall()
        finally:
            db.close()
    return [_entry(row, path) for row in rows]


def state_of(path: str | Path) -> State:
    """What a journal adds up to; nothing is written."""
    fold = Fold()
    fold.add([e.action for e in entries_of(path)])
    return fold.state


def _entry(row: tuple[Any, ...], path: Path) -> Entry:
    try:  # SQLite keeps any kind of value in any column
        texts = all(isinstance(value, str) for value in row[1:6])
        arguments = json_of(row[5], path) if texts and isinstance(row[0], int) else None
    except InputError:
        arguments = None
    if not isinstance(arguments, dict):
        raise InputError("journal.damaged", action=quoted(row[0]), file=path)
    return Entry(seq=row[0], id=row[1], time=row[2], author=row[3], verb=row[4], arguments=arguments)


def _same(action: Action, verb: str, arguments: str) -> bool:
    """Whether a row is this action sent before; of names only what the sender writes is compared."""
    found = {"image", "original"}  # an image may be sent by its file and is kept by its id

    def plain(values: Mapping[str, Any]) -> dict[str, Any]:
        return {k: v for k, v in values.items() if k not in found}

    sent, kept = (plain(json_of(text, Path("action"))) for text in (_json(action), arguments))
    return action.verb == verb and sent == kept


def _json(action: Action) -> str:
    try:
        return json.dumps(action.arguments, ensure_ascii=False, allow_nan=False, sort_keys=True)
    except ValueError:
        raise InputError("journal.number_not_finite", verb=action.verb) from None


def _write_ahead(db: sqlite3.Connection) -> None:
    """Turn the write-ahead log on; while another process does the same, SQLite does not wait by itself."""
    for attempt in range(100):
        try:
            db.execute("PRAGMA journal_mode=WAL")
        except sqlite3.OperationalError as error:
            if "locked" not in str(error) or attempt == 99:
                raise
            sleep(0.02)
        else:
            return


def _with_schema(db: sqlite3.Connection, path: Path) -> None:
    tables = {r[0] for r in db.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    if tables and not {"about", "actions"} <= tables:
        raise InputError("journal.other_database", file=path)
    if not tables:
        db.executescript(_TABLES)
    found = db.execute("SELECT value FROM about WHERE name = 'schema'").fetchone()
    if found is None or found[0] != SCHEMA:
        was = "none" if found is None else found[0]
        raise InputError("journal.schema", found=was, read=SCHEMA, file=path)


def can_be_written(path: Path) -> bool:
    """Whether a file, and others beside it, can be written; nothing is."""
    return os.access(path.parent, os.W_OK | os.X_OK) and (not path.exists() or os.access(path, os.W_OK))


@contextmanager
def _named_failure(path: Path) -> Generator[None]:
    """Turn what SQLite complains of into a message that states what to do."""
    try:
        yield
    except (sqlite3.Error, OSError) as error:
        text = str(error)
        if "locked" in text or "busy" in text:
            cause = "locked"
        elif "full" in text:
            cause = "full"
        elif any(w in text for w in ("malformed", "not a database", "corrupt", "no such")):
            cause = "damaged"
        elif "readonly" in text or (path.parent.is_dir() and not can_be_written(path)):
            cause = "read_only"
        else:
            cause = "other"
        raise InputError("journal.not_usable", cause=cause, detail=text, file=path) from None
