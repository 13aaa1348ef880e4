"""Project folders under stress: killed writes, damaged files, full disks, other programs."""

import contextlib
import errno
import os
import signal
import sqlite3
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.project import Project
from raybundle.pipeline.store import writing

WRITER = """
import sys
from pathlib import Path
import numpy as np
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.project import Project
project = Project.open(Path(sys.argv[1]))
print("begun", flush=True)
k = 0
while True:
    with project.stage("features") as stage:
        stage.summary = str(k)
        project.products.store(key_of("features", k % 40), {"a": np.full((40_000,), k % 40), "b": np.arange(k % 40)})
        rows = [(f"{k}-{i}", {"candidates": np.array(k), "matches": np.full((k % 50, 2), i)}) for i in range(20)]
        project.store_small(rows)
    print(k, flush=True)
    k += 1
"""


@pytest.fixture
def project(tmp_path):
    opened = Project.open(tmp_path / "p")
    yield opened
    opened.close()


def leftovers(folder):
    return [p for p in folder.rglob(".*") if p.is_file()]


@pytest.mark.parametrize("rounds", [0, 7, 50])
@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="there is no kill -9 here")
def test_a_killed_writer_leaves_whole_products_only(tmp_path, rounds):
    folder = tmp_path / "p"
    with subprocess.Popen([sys.executable, "-c", WRITER, str(folder)], stdout=subprocess.PIPE) as writer:
        assert writer.stdout is not None
        assert writer.stdout.readline() == b"begun\n"
        for k in range(rounds):
            assert writer.stdout.readline() == b"%d\n" % k
        writer.send_signal(signal.SIGKILL)
        writer.wait()
    project = Project.open(folder)
    try:
        there = [k for k in range(40) if project.products.has(key_of("features", k))]
        assert len(there) >= min(rounds, 40), "what was finished is lost"
        for k in there:
            product = project.products.load(key_of("features", k))
            assert product is not None
            np.testing.assert_array_equal(product["a"], np.full(40_000, k))
            np.testing.assert_array_equal(product["b"], np.arange(k))
        rows = project.db.execute("SELECT key FROM pairs").fetchall()
        by_round = {}
        for (key,) in rows:
            by_round.setdefault(key.split("-")[0], []).append(key)
        assert all(len(keys) == 20 for keys in by_round.values())
        assert len(by_round) >= rounds
        for key, found in project.small([key for (key,) in rows]).items():
            assert found["matches"].shape == (found["candidates"] % 50, 2)
            assert (found["matches"] == int(key.split("-")[1])).all()
        assert len(project.stages()) <= 1
        assert project.db.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    finally:
        project.close()


def test_a_write_that_is_broken_off_leaves_the_product_before_it(project, monkeypatch):
    key = key_of("start", 1)
    project.products.store(key, {"a": np.arange(3)})

    def broken(self, target):
        raise KeyboardInterrupt

    monkeypatch.setattr(Path, "replace", broken)
    with pytest.raises(KeyboardInterrupt):
        project.products.store(key, {"a": np.arange(9)})
    monkeypatch.undo()
    np.testing.assert_array_equal(project.products.load(key)["a"], np.arange(3))
    assert not leftovers(project.folder / "cache")


def damaged(whole):
    """A product's bytes after various accidents."""
    yield "cut", whole[: len(whole) // 2]
    yield "without its end", whole[:-20]
    yield "empty", b""
    yield "zeros", bytes(len(whole))
    yield "text", b"this is no product\n" * 50
    for at in range(40, len(whole), len(whole) // 40):
        yield f"byte {at}", whole[:at] + bytes([whole[at] ^ 0x55]) + whole[at + 1 :]


def test_a_damaged_product_is_never_taken_for_another(project):
    key = key_of("features", "x")
    product = {"xy": np.random.default_rng(1).normal(size=(60, 2)), "names": np.array(["a", "bc"])}
    project.products.store(key, product)
    path = project.products.place._path(key)
    whole = path.read_bytes()
    for what, data in damaged(whole):
        path.write_bytes(data)
        found = project.products.load(key)
        if found is not None:
            for name, a in product.items():
                np.testing.assert_array_equal(found[name], a, err_msg=what)
        else:
            assert not path.exists(), what
    project.products.store(key, product)
    np.testing.assert_array_equal(project.products.load(key)["xy"], product["xy"])


def test_a_product_is_never_unpickled(project):
    key = key_of("features", "pickle")
    path = project.products.place._path(key)
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("wb") as file:
        np.savez(file, a=np.array([{"an": "object"}], dtype=object))
    assert project.products.load(key) is None


@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EACCES, errno.EROFS, errno.EIO])
def test_a_write_that_fails_says_what_to_do_and_keeps_what_is_there(project, monkeypatch, number):
    key = key_of("start", 1)
    project.products.store(key, {"a": np.arange(3)})

    def failing(*_, **__):
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(np.lib.format, "write_array", failing)
    with pytest.raises(InputError, match=r"project\.not_writable") as caught:
        project.products.store(key, {"a": np.arange(9)})
    assert (caught.value.message.values["cause"] == "full") == (number == errno.ENOSPC)
    assert str(project.folder) in str(caught.value)
    assert caught.value.exit_status == 2
    monkeypatch.undo()
    np.testing.assert_array_equal(project.products.load(key)["a"], np.arange(3))
    assert not leftovers(project.folder)


def test_a_full_database_keeps_the_pairs_before_it(project):
    project.store_small([("first", {"candidates": np.array(1), "matches": np.array([[1, 2]])})])
    pages = project.db.execute("PRAGMA page_count").fetchone()[0]
    project.db.execute(f"PRAGMA max_page_count = {pages}")
    rows = [(f"k{i}", {"candidates": np.array(9), "matches": np.zeros((500, 2))}) for i in range(50)]
    with pytest.raises(InputError, match=r"project\.not_writable"):
        project.store_small(rows)
    assert set(project.small(["first", *(k for k, *_ in rows)])) == {"first"}
    project.db.execute("PRAGMA max_page_count = 100000")
    project.store_small(rows)
    assert len(project.small([k for k, *_ in rows])) == 50


def test_settings_are_written_whole_or_not_at_all(project, monkeypatch):
    project.write_settings("jobs = 1\n")

    def full(self, *_, **__):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(Path, "write_text", full)
    with pytest.raises(InputError, match=r"project\.not_writable"):
        project.write_settings("jobs = 2\n")
    monkeypatch.undo()
    assert (project.folder / "project.toml").read_text() == "jobs = 1\n"
    assert not leftovers(project.folder)


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="nothing is read-only for root")
def test_a_read_only_folder_is_named(tmp_path):
    tmp_path.chmod(0o500)
    try:
        with pytest.raises(InputError, match=r"project\.not_writable"):
            Project.open(tmp_path / "p")
    finally:
        tmp_path.chmod(0o700)


def test_a_folder_that_cannot_be_made_is_named(tmp_path, monkeypatch):
    def refused(self, *_, **__):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr(Path, "mkdir", refused)
    with pytest.raises(InputError, match=r"project\.not_writable"):
        Project.open(tmp_path / "p")


def test_a_file_in_place_of_the_folder_stays_as_it_is(tmp_path):
    file = tmp_path / "p"
    file.write_text("a letter")
    with pytest.raises(InputError, match=r"project\.folder_not_empty"):
        Project.open(file)
    assert file.read_text() == "a letter"


@pytest.mark.parametrize("content", [b"SQLite format 3\0" + b"\xff" * 4000, b"no database " * 500])
def test_a_damaged_database_is_named_and_left_as_it_is(tmp_path, content):
    folder = tmp_path / "p"
    folder.mkdir()
    (folder / "project.db").write_bytes(content)
    with pytest.raises(InputError, match=r"project\.db.*project\.not_readable"):
        Project.open(folder)
    assert (folder / "project.db").read_bytes() == content


def test_a_project_of_another_version_is_refused(tmp_path):
    Project.open(tmp_path / "p").close()
    with contextlib.closing(sqlite3.connect(tmp_path / "p/project.db")) as db, db:
        db.execute("UPDATE about SET value = '99' WHERE name = 'schema'")
    with pytest.raises(InputError, match=r"99.*project\.schema"):
        Project.open(tmp_path / "p")


def test_a_damaged_pair_is_matched_again(project):
    product = {"candidates": np.array(1), "matches": np.array([[1, 2], [3, 4]])}
    project.store_small([(k, product) for k in ("good", "bad")])
    project.db.execute("UPDATE pairs SET matches = x'010203' WHERE key = 'bad'")
    assert set(project.small(["good", "bad"])) == {"good"}


def test_more_keys_than_a_query_takes(project):
    keys = [f"k{i}" for i in range(1203)]
    project.store_small([(k, {"n": np.array(i), "matches": np.full((i % 4, 2), i)}) for i, k in enumerate(keys)])
    found = project.small(keys)
    assert len(found) == 1203
    assert all(found[k]["n"] == i and len(found[k]["matches"]) == i % 4 for i, k in enumerate(keys))


def test_many_threads_may_write_one_product(project):
    key, errors = key_of("features", 1), []

    def work(n):
        try:
            for _ in range(10):
                project.products.store(key, {"a": np.full(1000, n)})
                a = project.products.load(key)["a"]
                assert (a == a[0]).all()
        except Exception as error:  # noqa: BLE001  (shown below)
            errors.append(error)

    threads = [threading.Thread(target=work, args=(n,)) for n in range(4)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert errors == []
    assert not leftovers(project.folder / "cache")


def test_a_kind_is_forgotten_and_the_others_stay(project):
    for kind in ("features", "start"):
        for k in range(3):
            project.products.store(key_of(kind, k), {"a": np.zeros(1)})
    project.forget_kind("features")
    assert not any(project.products.has(key_of("features", k)) for k in range(3))
    assert all(project.products.has(key_of("start", k)) for k in range(3))


def test_stages_of_a_later_run_replace_those_of_an_earlier_one(tmp_path):
    for names in (("photographs", "features", "precision"), ("photographs", "features")):
        project = Project.open(tmp_path / "p")
        for name in names:
            with project.stage(name) as stage:
                stage.summary = f"of {len(names)}"
        records = {r.name: r.summary for r in project.stages()}
        project.close()
    assert records["photographs"] == records["features"] == "of 2"


def test_keys_do_not_depend_on_the_order_of_mappings_or_the_kind_of_number():
    assert key_of("a", {"x": 1, "y": [2.5]}) == key_of("a", {"y": [2.5], "x": 1})
    assert key_of("a", np.float64(2.5), np.int32(3)) == key_of("a", 2.5, 3)
    array = np.arange(12.0).reshape(3, 4)
    assert key_of("a", array.T) == key_of("a", np.ascontiguousarray(array.T))
    assert key_of("a", "ä 雪") != key_of("a", "a")


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ((1,), (2,)),
        ((1,), (1, None)),
        (("ab", "c"), ("a", "bc")),
        (("1",), (1,)),
        ((np.array([1.0, 2.0]),), (np.array([2.0, 1.0]),)),
        ((np.nextafter(1.0, 2.0),), (1.0,)),
        (({"a": 1},), ({"a": 2},)),
    ],
)
def test_keys_differ_where_something_differs(one, other):
    assert key_of("a", *one) != key_of("a", *other)


def test_other_errors_pass_unchanged(tmp_path):
    with pytest.raises(ZeroDivisionError), writing(tmp_path):
        1 / 0


@pytest.mark.parametrize("where", ["product", "cache"])
def test_what_stands_where_a_product_is_to_be_is_named(tmp_path, where):
    folder = tmp_path / "project"
    key = "features-" + "0" * 40
    project = Project.open(folder)
    at = folder / "cache" / "00" / f"{key}.npz" if where == "product" else folder / "cache"
    if where == "product":
        at.mkdir(parents=True)
        with pytest.raises(InputError, match=r"project\.not_writable") as error:
            project.products.store(key, {"a": np.zeros(3)})
        project.close()
    else:
        project.close()
        at.rmdir()
        at.write_text("something else")
        with pytest.raises(InputError, match=r"project\.not_writable") as error:
            Project.open(folder)
    assert error.value.message.values["detail"].startswith(f"{at}: ")
    assert error.value.message.values["cause"] == "occupied"
