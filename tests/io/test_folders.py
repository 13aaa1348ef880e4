"""Folders appear whole or not at all, even when the writer is killed."""

import random
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from tests.barriers import wait_for

from raybundle.errors import InputError
from raybundle.io import folders
from raybundle.io.folders import (
    check_new_folder,
    clear_left,
    exchange,
    lock_of,
    names_in,
    new_files,
    new_folder,
    unlock,
)


def write(path, content):
    with new_folder(path, replacing=True) as folder:
        for k in range(5):
            (folder / str(k)).write_text(content)


def read(path):
    assert sorted(p.name for p in path.iterdir()) == list("01234")
    contents = {p.read_text() for p in path.iterdir()}
    assert len(contents) == 1
    return contents.pop()


@pytest.mark.parametrize("can_exchange", [True, False])
def test_a_folder_is_replaced(tmp_path, monkeypatch, can_exchange):
    if not can_exchange:
        monkeypatch.setattr(folders, "exchange", lambda _a, _b: False)
    write(tmp_path / "a" / "b", "old")
    write(tmp_path / "a" / "b", "new")
    assert read(tmp_path / "a" / "b") == "new"
    assert [p.name for p in (tmp_path / "a").iterdir()] == ["b"]


def test_an_error_in_the_body_changes_nothing(tmp_path):
    write(tmp_path / "a", "old")
    with pytest.raises(ZeroDivisionError):
        write_half(tmp_path / "a")
    assert read(tmp_path / "a") == "old"
    assert len(list(tmp_path.iterdir())) == 1


def write_half(path):
    with new_folder(path, replacing=True) as folder:
        (folder / "0").write_text("new")
        raise ZeroDivisionError


def test_of_two_writers_of_one_new_folder_the_second_is_told(tmp_path):
    path = tmp_path / "a"
    with pytest.raises(InputError, match=r"file\.created_meanwhile"), new_folder(path) as late:  # noqa: PT012
        (late / "0").write_text("late")
        write(path, "early")
    assert read(path) == "early"
    assert [p.name for p in tmp_path.iterdir()] == ["a"]
    with pytest.raises(InputError, match=r"file\.created_meanwhile"), new_folder(path):
        pass
    assert read(path) == "early"


@pytest.mark.parametrize("can_exchange", [True, False])
def test_of_two_that_replace_one_folder_the_second_is_told(tmp_path, monkeypatch, can_exchange):
    if not can_exchange:
        monkeypatch.setattr(folders, "exchange", lambda _a, _b: False)
    path = tmp_path / "a"
    write(path, "old")
    with pytest.raises(InputError, match=r"file\.created_meanwhile"), new_folder(path, replacing=True) as late:  # noqa: PT012
        (late / "0").write_text("late")
        write(path, "early")
    assert read(path) == "early"
    assert [p.name for p in tmp_path.iterdir()] == ["a"]


def test_an_empty_folder_is_filled(tmp_path):
    (tmp_path / "a").mkdir()
    with new_folder(tmp_path / "a") as folder:
        (folder / "0").write_text("new")
    assert (tmp_path / "a" / "0").read_text() == "new"


def test_where_nothing_can_be_written_is_an_input_error(tmp_path):
    (tmp_path / "file").write_text("x")
    with pytest.raises(InputError, match=r"file\.not_writable"):
        write(tmp_path / "file" / "a", "new")


def test_exchange_says_when_it_cannot(tmp_path):
    (tmp_path / "a").mkdir()
    assert not exchange(tmp_path / "a", tmp_path / "missing")


WRITER = """
import sys, pathlib
sys.path.insert(0, {root!r})
from tests.io.test_folders import write
path = pathlib.Path({path!r})
for k in range(10**6):
    write(path, str(k))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux exchanges two folders at one stroke")
def test_a_writer_that_is_killed_leaves_a_whole_folder(tmp_path):
    path = tmp_path / "result"
    write(path, "-1")
    root = str(Path(__file__).parents[2])
    rng = random.Random(1)
    seen = set()
    for _ in range(6):
        before = read(path)
        process = subprocess.Popen([sys.executable, "-c", WRITER.format(root=root, path=str(path))])
        for _ in range(rng.randint(1, 3)):  # then the kill comes anywhere within what is written next
            before = wait_for(lambda known=(before, None): (now := read_or_none(path)) not in known and now, "written")
        process.send_signal(signal.SIGKILL)
        process.wait()
        seen.add(read(path))
    assert "-1" not in seen


def read_or_none(path):
    """The content, or None while the folder changes under the reader."""
    try:
        return read(path)
    except (AssertionError, OSError):
        return None


@pytest.mark.skipif(sys.platform == "win32", reason="without locks nobody knows whose writer is gone")
def test_what_a_killed_writer_left_in_a_folder_is_nothing_foreign_and_goes(tmp_path):
    """Also under names that nobody writes there again; not what somebody writes there now, and no file of a user."""
    folder = tmp_path / "a"
    left = [folder / n for n in (".heights.npz.2cfa3545.partial", ".b.0123abcd.old", ".0123abcd.partial")]
    for path in left:
        path.mkdir(parents=True)
        (path / "0").write_text("half")
    assert names_in(folder) == set()
    check_new_folder(folder)
    with new_files(folder / "c") as (file,):
        lock = lock_of(left[0])
        clear_left(folder)
        assert left[0].exists()
        unlock(lock)
        file.write_text("new")
        clear_left(folder)
        assert len(list(folder.iterdir())) == 1
        assert names_in(folder) == set()
    assert names_in(folder) == {"c"}
    (folder / ".d.2cfa3545.partial").write_text("of a user")
    assert names_in(folder) == {"c", ".d.2cfa3545.partial"}
    for path in folder.iterdir():
        path.unlink()
    left[0].mkdir()
    write(folder, "new")
    assert read(folder) == "new"


@pytest.mark.skipif(sys.platform == "win32", reason="without locks nobody knows whose writer is gone")
def test_a_new_folder_takes_the_name_of_one_with_nothing_but_leftovers(tmp_path):
    (tmp_path / "a/.b.2cfa3545.partial").mkdir(parents=True)
    with new_folder(tmp_path / "a") as folder:
        (folder / "0").write_text("new")
    assert [p.name for p in (tmp_path / "a").iterdir()] == ["0"]
