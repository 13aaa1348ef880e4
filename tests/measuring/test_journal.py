"""The journal: nothing acknowledged is lost, nothing counts twice, whatever kills the process that writes."""

import json
import os
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import threading

import pytest

import raybundle as rb
from raybundle.errors import InputError
from raybundle.measuring.actions.verbs import VERBS, Move, Put, Redo, SetBar, Undo, action_of
from raybundle.measuring.journal import Journal, entries_of, journal_path, measured_result, state_of
from raybundle.measuring.names import Known

KNOWN = Known.of_photos({"a.jpg": (400, 300), "b.jpg": (400, 300)})
WRITER = """
import sys
from raybundle.measuring.actions.verbs import Put
from raybundle.measuring.journal import Journal
from raybundle.measuring.names import Known

path, first = sys.argv[1], int(sys.argv[2])
journal = Journal.open(path, Known.of_photos({"a.jpg": (400, 300)}))
print("ready", flush=True)
for k in range(first, first + 100_000):
    seq = journal.append(Put(image="a.jpg", point=f"p{k}", x_px=k % 400, y_px=7), id=f"sent-{k}")
    print(k, seq, flush=True)
"""


def put(point, image="a.jpg", x=10.0):
    return Put(image=image, point=point, x_px=x, y_px=20.0)


@pytest.fixture
def journal(tmp_path):
    with Journal.open(tmp_path / "measured.db", KNOWN) as j:
        yield j


def killed_while_writing(path, kills, seed):
    """Kill writers after some acknowledgements, each sending again what was not acknowledged; returns what was.

    The writer goes on while the kill is on its way: it comes anywhere within an action.
    """
    rng, acknowledged, first = random.Random(seed), {}, 0
    for _ in range(kills):
        p = subprocess.Popen([sys.executable, "-c", WRITER, str(path), str(first)], stdout=subprocess.PIPE, text=True)
        assert p.stdout.readline() == "ready\n"
        lines = [p.stdout.readline() for _ in range(rng.randint(0, 20))]
        os.kill(p.pid, signal.SIGKILL)
        for line in (*lines, *p.stdout):
            if line.endswith("\n"):  # a line cut short was not received
                k, seq = map(int, line.split())
                assert acknowledged.setdefault(k, seq) == seq
        p.stdout.close()
        p.wait()
        first = len(acknowledged)
    return acknowledged


def check_kept(path, acknowledged):
    """Every acknowledged action stands there once, in order; at most one more that was on its way."""
    rows = entries_of(path)
    ids = [e.id for e in rows]
    assert len(set(ids)) == len(ids)
    assert {f"sent-{k}": seq for k, seq in acknowledged.items()}.items() <= {e.id: e.seq for e in rows}.items()
    assert ids == [f"sent-{k}" for k in range(len(ids))]
    assert len(ids) - len(acknowledged) <= 1
    assert len(state_of(path).marks) == len(ids)


@pytest.mark.long
def test_killed_at_random_instants_nothing_acknowledged_is_lost_or_counts_twice(tmp_path):
    path = tmp_path / "measured.db"
    acknowledged = killed_while_writing(path, 30, seed=1)
    assert len(acknowledged) > 30
    check_kept(path, acknowledged)


def test_undo_and_redo_are_actions_and_unlimited(journal):
    for k in range(50):
        journal.append(put(f"p{k}"))
    for _ in range(50):
        journal.append(Undo())
    assert not journal.state.marks
    assert not journal.state.points
    with pytest.raises(InputError, match=r"journal\.nothing_to_undo"):
        journal.append(Undo())
    for _ in range(50):
        journal.append(Redo())
    assert len(journal.state.marks) == 50
    assert journal.seq == 150
    journal.append(Undo())
    journal.append(put("other"))
    assert "p49" not in journal.state.points
    with pytest.raises(InputError, match=r"journal\.nothing_to_redo"):
        journal.append(Redo())
    assert journal.state == state_of(journal.path)


def test_an_action_sent_twice_counts_once(journal):
    first = journal.append(put("p"), id="one")
    assert journal.append(put("p"), id="one") == first
    assert journal.seq == first
    undo = journal.append(Undo(), id="two")
    assert journal.append(Undo(), id="two") == undo
    with pytest.raises(InputError, match=r"journal\.id_used"):
        journal.append(put("q"), id="one")


def test_rows_are_never_changed_nor_deleted(journal):
    journal.append(put("p"), author="A; DROP TABLE actions")
    for sql in ("UPDATE actions SET author = ''", "DELETE FROM actions"):
        with pytest.raises(sqlite3.IntegrityError, match="never"):
            journal.db.execute(sql)
    (entry,) = journal.entries()
    assert entry.author == "A; DROP TABLE actions"
    assert entry.time.endswith("+00:00")
    assert entry.action == put("p")


def test_a_refused_action_leaves_no_row(journal):
    with pytest.raises(InputError, match=r"c\.jpg.*2.*mark\.unknown_image"):
        journal.append(put("p", image="c.jpg"))
    assert journal.entries() == []


def test_several_may_write_at_once(tmp_path):
    path = tmp_path / "measured.db"
    errors = []

    def write(n):
        try:
            with Journal.open(path, KNOWN) as j:
                for k in range(25):
                    j.append(put(f"p{n}-{k}"), author=str(n))
        except Exception as error:  # noqa: BLE001
            errors.append(error)

    threads = [threading.Thread(target=write, args=(n,)) for n in range(4)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert not errors
    assert len(state_of(path).marks) == 100
    assert [e.seq for e in entries_of(path)] == list(range(1, 101))


def test_an_open_journal_sees_what_others_add(tmp_path, journal):
    with Journal.open(journal.path, KNOWN) as other:
        other.append(put("p"))
        with pytest.raises(InputError, match=r"a\.jpg.*mark\.exists"):
            journal.append(put("p"))
        journal.append(Move(image="a.jpg", point="p", x_px=1, y_px=1))
        assert other.state.marks["a.jpg", "p"].x_px == 1


def test_actions_by_verb_and_json(journal):
    journal.append_verb("put", json.loads('{"image": "a.jpg", "point": "A", "x_px": 3, "y_px": 4}'))
    journal.append(put("B"))
    seq = journal.append_verb("bar", {"start": "A", "end": "B", "length": 2.5, "sigma": 0.001})
    assert journal.entries(seq - 1)[0].action == SetBar(start="A", end="B", length=2.5, sigma=0.001)
    for verb, arguments, words in (
        ("drop", {}, r"action\.unknown_verb"),
        ("put", {"image": "a.jpg"}, r"action\.arguments"),
        ("undo", {"n": 2}, r"action\.unknown_argument"),
        ("put", {"image": "a.jpg", "point": 7, "x_px": 1, "y_px": 1}, r"action\.arguments"),
    ):
        with pytest.raises(InputError, match=words):
            journal.append_verb(verb, arguments)


@pytest.mark.parametrize("verb", VERBS)
def test_every_verb_knows_itself(verb):
    assert VERBS[verb].verb == verb
    with pytest.raises(InputError):
        action_of(verb, {"what": 1})


def test_where_the_journal_is(tmp_path, monkeypatch):
    project = tmp_path / "facade"
    project.mkdir()
    assert journal_path(project) == tmp_path / "facade.measured.db"
    (project / "project.db").touch()
    assert journal_path(project) == project / "measured.db"
    (project / "project.db").unlink()
    monkeypatch.chdir(project)
    assert journal_path(".") == tmp_path / "facade.measured.db"


def test_a_project_has_one_journal_by_whatever_name(tmp_path):
    project = tmp_path / "facade"
    (project / "result" / "block").mkdir(parents=True)
    (project / "project.db").touch()
    for folder in (project, project / "result", project / "result" / "block"):
        assert journal_path(folder) == project / "measured.db"
        assert measured_result(folder) == project / "result"
    assert journal_path(project / "result-2") == project / "result-2.measured.db"
    (project / "result.measured.db").touch()
    with pytest.raises(InputError, match=r"journal\.two_journals"):
        journal_path(project / "result")
    assert journal_path(project) == project / "measured.db"


@pytest.mark.parametrize("content", [b"no database at all, only text that is long enough", b""])
def test_files_that_are_no_journal(tmp_path, content):
    path = tmp_path / "measured.db"
    path.write_bytes(content)
    if content:
        with pytest.raises(InputError, match=r"measured\.db.*journal\.not_usable"):
            Journal.open(path, KNOWN)
    else:
        Journal.open(path, KNOWN).close()


def test_a_foreign_database_is_refused(tmp_path):
    db = sqlite3.connect(tmp_path / "x.db")
    db.execute("CREATE TABLE people (name)")
    db.close()
    with pytest.raises(InputError, match=r"journal\.other_database"):
        Journal.open(tmp_path / "x.db", KNOWN)


def test_a_folder_that_is_not_there(tmp_path):
    with pytest.raises(InputError, match=r"journal\.not_usable"):
        Journal.open(tmp_path / "none" / "measured.db", KNOWN)


def test_nothing_is_added_to_a_journal_that_went_away(tmp_path):
    """Moved, deleted or exchanged under an open one: what cannot be found again is not acknowledged."""
    path = tmp_path / "measured.db"
    with Journal.open(path, KNOWN) as journal:
        assert journal.append(put("A")) == 1
        path.rename(tmp_path / "elsewhere.db")
        with pytest.raises(InputError, match=r"journal\.moved"):
            journal.append(put("B"))
        shutil.copy(tmp_path / "elsewhere.db", path)
        with pytest.raises(InputError, match=r"journal\.moved"):
            journal.append(put("B"))
        path.unlink()
        (tmp_path / "elsewhere.db").rename(path)
        assert journal.append(put("B")) == 2


@pytest.mark.parametrize("place", ["/", "/nowhere-to-be-found"])
def test_the_root_is_no_place_to_measure_in(place):
    with pytest.raises(InputError, match=r"journal\.no_place"):
        rb.marks(place)
