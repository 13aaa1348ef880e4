"""The disk and the output: nothing foreign is touched, results are whole, nobody sees a traceback."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.folders import new_files, new_folder
from raybundle.io.photos.photo import read_colour, read_grey, read_photo
from raybundle.io.project import Project, key_of
from tests.hostile.readers.blocks import block_seeds

KEY = key_of("features", 1)


def run(*arguments, then=""):
    """A command of its own; `then` follows it, as >/dev/full."""
    words = [sys.executable, "-m", "raybundle", *map(str, arguments)]
    line = " ".join(f"'{w}'" for w in words) + " " + then
    done = subprocess.run(
        ["/bin/sh", "-c", line], capture_output=True, text=True, check=False,
        env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
    )  # fmt: skip
    for sign in ("Traceback", "internal error", "Exception ignored"):
        assert sign not in done.stderr + done.stdout, done.stderr
    return done


@pytest.fixture(scope="module")
def block(tmp_path_factory):
    top = tmp_path_factory.mktemp("block")
    block_seeds(top)
    return top / "0"


# --- projects


@pytest.mark.parametrize(
    "names",
    [
        ("cache/",),
        ("cache/", "result/"),
        ("cache/thumbnails/1.npz",),
        ("cache/ab/notes.txt",),
        ("project.toml",),
        ("result/",),
    ],
    ids=" ".join,
)
def test_a_folder_of_somebody_else_is_no_project(tmp_path, names):
    for name in names:
        place = tmp_path / "p" / name
        place.mkdir(parents=True) if name.endswith("/") else place.parent.mkdir(parents=True, exist_ok=True)
        if not name.endswith("/"):
            place.write_text("[tool]\nmine = 1\n")
    before = sorted(str(p) for p in tmp_path.rglob("*"))
    with pytest.raises(InputError, match="neither empty nor a project folder"):
        Project.open(tmp_path / "p")
    assert sorted(str(p) for p in tmp_path.rglob("*")) == before


def test_a_project_without_its_database_goes_on(tmp_path):
    project = Project.open(tmp_path / "p")
    project.store(KEY, {"a": np.arange(3)})
    project.close()
    for file in (tmp_path / "p").glob("project.db*"):
        file.unlink()
    project = Project.open(tmp_path / "p")
    assert project.has(KEY)
    project.close()
    shutil.rmtree(tmp_path / "p" / "cache")
    (tmp_path / "p" / "project.db").unlink()
    (tmp_path / "p" / "project.toml").write_text('[orient]\nphotos = ["a"]\n')
    Project.open(tmp_path / "p").close()


def test_a_run_sweeps_its_own_leftovers_and_nothing_else(tmp_path):
    folder = tmp_path / "p"
    project = Project.open(folder)
    project.store(KEY, {"a": np.arange(3)})
    product = next((folder / "cache").glob("*/*.npz"))
    project.close()
    foreign = [
        folder / ".result.swp", folder / ".project.toml.swp", folder / ".result.notes", folder / ".git" / "x",
        product.parent / ".mine-1", product.parent / f".{KEY}.txt", folder / "cache" / ".hidden-file",
    ]  # fmt: skip
    own = [
        folder / ".result.0123abcd.partial" / "r",
        folder / ".project.toml.0123abcd",
        product.parent / f".{KEY}.0123abcd",
    ]
    for file in (*foreign, *own):
        file.parent.mkdir(exist_ok=True)
        file.write_text("x")
    Project.open(folder).close()
    assert all(f.exists() for f in foreign)
    assert not any(f.exists() for f in own)
    assert not (folder / ".result.0123abcd.partial").exists()


def npz_damages(data):
    rng = np.random.default_rng(3)
    for _ in range(150):
        out = bytearray(data)
        for at in rng.integers(0, len(out), rng.integers(1, 6)).tolist():
            out[at] = rng.integers(0, 256)
        yield bytes(out[: rng.integers(1, len(out))]) if rng.random() < 0.3 else bytes(out)


def test_damaged_products_are_made_again(tmp_path):
    project = Project.open(tmp_path / "p")
    product = {"a": np.arange(50.0), "names": np.array(["x", "yy"])}
    project.store(KEY, product)
    path = next((tmp_path / "p" / "cache").glob("*/*.npz"))
    good = path.read_bytes()
    missing = 0
    for data in npz_damages(good):
        path.write_bytes(data)
        found = project.load(KEY)
        missing += found is None
        if found is not None:
            np.testing.assert_array_equal(found["a"], product["a"])
        path.write_bytes(data)
        assert project.has(KEY) in {True, False}
    assert missing > 100
    project.close()


# --- files and folders that are written


def leave(path, *, held=False):
    """A temporary folder as a killed writer leaves it; held: its writer still works."""
    with new_folder(path) as folder:
        (folder / "half").write_text("x")
        copy = folder.with_name(f".{path.name}.00000000.partial")
        shutil.copytree(folder, copy)
    return copy


def test_leftovers_of_a_killed_writer_are_removed_by_the_next(tmp_path):
    left = leave(tmp_path / "r")
    foreign = [tmp_path / ".r.partial", tmp_path / ".r.mine.partial", tmp_path / ".other.00000000.partial"]
    for place in foreign:
        place.mkdir()
    assert left.exists()
    with new_folder(tmp_path / "r") as folder:
        (folder / "a").write_text("a")
    assert not left.exists()
    assert all(p.exists() for p in foreign)


def test_a_writer_that_still_works_is_left_alone(tmp_path):
    with new_folder(tmp_path / "r") as first:
        (first / "a").write_text("1")
        with new_folder(tmp_path / "r") as second:
            (second / "a").write_text("2")
        assert (first / "a").read_text() == "1"
    assert (tmp_path / "r" / "a").read_text() == "1"
    assert [p.name for p in tmp_path.iterdir()] == ["r"]


def broken_off(*paths):
    with new_files(*paths) as (one, *_):
        one.write_text("new")
        raise OSError(28, "No space left on device")


def test_files_are_replaced_together_or_not_at_all(tmp_path):
    a, b = tmp_path / "a.toml", tmp_path / "a.pdf"
    a.write_text("old")
    with pytest.raises(InputError, match="cannot be written: No space"):
        broken_off(a, b)
    assert a.read_text() == "old"
    with new_files(a, b) as (one, two):
        one.write_text("new")
        two.write_text("new")
    assert (a.read_text(), b.read_text()) == ("new", "new")
    assert sorted([p.name for p in tmp_path.iterdir()]) == ["a.pdf", "a.toml"]
    with pytest.raises(InputError, match="is a folder"), new_files(tmp_path):
        pass


@pytest.mark.parametrize("length", [180, 250, 300, 5000])
@pytest.mark.parametrize(
    "command",
    [
        ("adjust", "BLOCK", "--no-report", "--out"), ("compare", "R", "R", "--out"), ("simulate", "--out"),
        ("convert", "BLOCK", "--to", "ply", "--out"), ("targets", "sheet", "--family", "aicon14", "--out"),
        ("orient", "BLOCK", "--out"),
    ],
    ids=lambda c: c[0],
)  # fmt: skip
def test_long_names(tmp_path, block, capsys, command, length):
    suffix = {"compare": ".html", "convert": ".ply", "targets": ".svg"}.get(command[0], "")
    out = tmp_path / ("x" * (length - len(suffix)) + suffix)
    words = [str(block) if w == "BLOCK" else str(tmp_path) if w == "R" else w for w in command]
    status = main([*words, str(out)])
    told = capsys.readouterr()
    assert "internal error" not in told.err + told.out
    assert status in {0, 2}
    assert status == 2 or out.exists()
    assert len(told.err) < 7000


# --- where output goes


@pytest.mark.parametrize("shell", [">&-", "2>&-", ">&- 2>&-", "</dev/null >&- 2>&-", "2>/dev/full", "| true"])
def test_closed_streams_cost_no_result(block, tmp_path, shell):
    run("adjust", block, "--out", tmp_path / "r", "--no-report", "--progress", "json", then=shell)
    assert (tmp_path / "r" / "result.json").is_file()
    assert [p.name for p in tmp_path.iterdir()] == ["r"]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no /dev/full")
def test_a_full_disk_behind_the_output_is_told(block, tmp_path):
    done = run("adjust", block, "--out", tmp_path / "r", "--no-report", then=">/dev/full")
    assert done.returncode == 2
    assert "the output could not be shown (No space left on device)" in done.stderr
    assert (tmp_path / "r" / "result.json").is_file()


def test_out_of_memory_anywhere_is_a_message(monkeypatch, capsys, block, tmp_path):
    def nothing_left(*_a, **_k):
        raise MemoryError

    monkeypatch.setattr("raybundle.workflows.adjust.adjust", nothing_left)
    assert main(["adjust", str(block), "--out", str(tmp_path / "r")]) == 2
    assert "not enough memory" in capsys.readouterr().err


# --- photographs


@pytest.mark.parametrize("read", [read_grey, read_colour])
def test_a_photograph_exchanged_for_one_of_the_same_size_is_noticed(tmp_path, read):
    rng = np.random.default_rng(0)
    path = tmp_path / "a.png"
    Image.fromarray(rng.integers(0, 255, (64, 64, 3), np.uint8)).save(path, compress_level=0)
    photo = read_photo(path)
    read(photo)
    size = path.stat().st_size
    Image.fromarray(rng.integers(0, 255, (64, 64, 3), np.uint8)).save(path, compress_level=0)
    assert path.stat().st_size == size
    with pytest.raises(InputError, match="was exchanged during the work: its content"):
        read(photo)
