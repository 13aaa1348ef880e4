"""The disk and the output: nothing foreign is touched, results are whole, nobody sees a traceback."""

import errno
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
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.project import Project
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
    with pytest.raises(InputError, match=r"project\.folder_not_empty"):
        Project.open(tmp_path / "p")
    assert sorted(str(p) for p in tmp_path.rglob("*")) == before


def test_a_project_without_its_database_goes_on(tmp_path):
    project = Project.open(tmp_path / "p")
    project.products.store(KEY, {"a": np.arange(3)})
    project.close()
    for file in (tmp_path / "p").glob("project.db*"):
        file.unlink()
    project = Project.open(tmp_path / "p")
    assert project.products.has(KEY)
    project.close()
    shutil.rmtree(tmp_path / "p" / "cache")
    (tmp_path / "p" / "project.db").unlink()
    (tmp_path / "p" / "project.toml").write_text('[orient]\nphotos = ["a"]\n')
    Project.open(tmp_path / "p").close()


def test_a_run_sweeps_its_own_leftovers_and_nothing_else(tmp_path):
    folder = tmp_path / "p"
    project = Project.open(folder)
    project.products.store(KEY, {"a": np.arange(3)})
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
    project.products.store(KEY, product)
    path = next((tmp_path / "p" / "cache").glob("*/*.npz"))
    good = path.read_bytes()
    missing = 0
    for data in npz_damages(good):
        path.write_bytes(data)
        found = project.products.load(KEY)
        missing += found is None
        if found is not None:
            np.testing.assert_array_equal(found["a"], product["a"])
        path.write_bytes(data)
        assert project.products.has(KEY) in {True, False}
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
    with new_folder(tmp_path / "r", replacing=True) as folder:
        (folder / "a").write_text("a")
    assert not left.exists()
    assert all(p.exists() for p in foreign)


def two_at_once(path):
    with new_folder(path) as first:
        (first / "a").write_text("1")
        with new_folder(path) as second:
            (second / "a").write_text("2")
        assert (first / "a").read_text() == "1"


def test_a_writer_that_still_works_is_left_alone(tmp_path):
    with pytest.raises(InputError, match=r"file\.created_meanwhile"):
        two_at_once(tmp_path / "r")
    assert (tmp_path / "r" / "a").read_text() == "2"  # who is first has the name
    assert [p.name for p in tmp_path.iterdir()] == ["r"]


def broken_off(*paths):
    with new_files(*paths) as (one, *_):
        one.write_text("new")
        raise OSError(28, "No space left on device")


def test_files_are_replaced_together_or_not_at_all(tmp_path):
    a, b = tmp_path / "a.toml", tmp_path / "a.pdf"
    a.write_text("old")
    with pytest.raises(InputError, match=r"file\.not_writable"):
        broken_off(a, b)
    assert a.read_text() == "old"
    with new_files(a, b) as (one, two):
        one.write_text("new")
        two.write_text("new")
    assert (a.read_text(), b.read_text()) == ("new", "new")
    assert sorted([p.name for p in tmp_path.iterdir()]) == ["a.pdf", "a.toml"]
    with pytest.raises(InputError, match=r"file\.is_a_folder"), new_files(tmp_path):
        pass


@pytest.mark.parametrize("length", [180, 250, 300, 5000])
@pytest.mark.parametrize(
    "command",
    [
        ("adjust", "BLOCK", "--no-report", "--out"), ("compare", "R", "R", "--out"), ("simulate", "--out"),
        ("convert", "BLOCK", "--to", "ply", "--out"), ("targets", "sheet", "--target", "aicon14", "--out"),
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
    assert f"({os.strerror(errno.ENOSPC)})" in done.stderr
    assert (tmp_path / "r" / "result.json").is_file()


def test_out_of_memory_anywhere_is_a_message(monkeypatch, capsys, block, tmp_path):
    def nothing_left(*_a, **_k):
        raise MemoryError

    monkeypatch.setattr("raybundle.workflows.adjust.adjust", nothing_left)
    assert main(["adjust", str(block), "--out", str(tmp_path / "r")]) == 2
    assert capsys.readouterr().err.startswith("MemoryError: ")


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
    with pytest.raises(InputError, match=r"photograph\.changed"):
        read(photo)


# --- where results go


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("d/" * 3000 + "r", "too long"), ("file/r", "[folder.parent_is_a_file]"), ("file", "[folder.is_a_file]"),
        ("circle", "[file.link_loop]"), ("circle/r", ""), ("/proc/nothing/r", ""),
    ],
    ids=["nested", "below a file", "a file", "circle", "below a circle", "proc"],
)  # fmt: skip
def test_what_cannot_be_written_is_found_before_anything_is_computed(tmp_path, block, capsys, monkeypatch, name, words):
    (tmp_path / "file").write_text("x")
    (tmp_path / "circle").symlink_to(tmp_path / "circle")
    monkeypatch.setattr("raybundle.workflows.adjust.adjust", lambda *_: pytest.fail("it was adjusted first"))
    out = name if name[0] == "/" else str(tmp_path / name)
    before = sorted(p.name for p in tmp_path.iterdir())
    assert main(["adjust", str(block), "--out", out]) == 2
    told = capsys.readouterr().err
    assert words in told
    assert "internal" not in told
    assert sorted(p.name for p in tmp_path.iterdir()) == before


def test_many_nested_folders_are_made(tmp_path):
    deep = tmp_path.joinpath(*["d"] * 1200)
    try:
        with new_folder(deep) as folder:
            (folder / "a").write_text("b")
        assert (deep / "a").read_text() == "b"
    finally:  # shutil.rmtree, with which pytest cleans up, calls itself for each of them
        (deep / "a").unlink(missing_ok=True)
        while deep != tmp_path:
            deep.rmdir()
            deep = deep.parent


@pytest.mark.parametrize("there", [False, True], ids=["dangling", "to an older result"])
def test_a_result_goes_where_a_link_points(tmp_path, block, there):
    real, link = tmp_path / "disk" / "result", tmp_path / "link"
    link.symlink_to(real)
    if there:
        assert main(["adjust", str(block), "--out", str(real), "--no-report"]) == 0
        (real / "result.json").touch()
        before = (real / "result.json").stat().st_ino
    assert main(["adjust", str(block), "--out", str(link), "--no-report"]) == 0
    assert link.is_symlink()
    assert (real / "result.json").is_file()
    assert not there or (real / "result.json").stat().st_ino != before
    file = tmp_path / "page.html"
    file.symlink_to(tmp_path / "disk" / "page.html")
    with new_files(file) as (temporary,):
        temporary.write_text("page")
    assert file.is_symlink()
    assert (tmp_path / "disk" / "page.html").read_text() == "page"


@pytest.mark.parametrize("table", ["block.toml", "images.csv", "observations.csv", "points.csv"])
@pytest.mark.parametrize("kind", ["pipe", "folder", "device"])
def test_what_is_no_file_is_refused_not_waited_for(tmp_path, block, capsys, table, kind):
    copy = tmp_path / "b"
    shutil.copytree(block, copy)
    (copy / table).unlink(missing_ok=True)
    if kind == "pipe":
        os.mkfifo(copy / table)
    elif kind == "folder":
        (copy / table).mkdir()
    else:
        (copy / table).symlink_to(os.devnull)
    assert main(["adjust", str(copy), "--out", str(tmp_path / "r")]) == 2
    told = capsys.readouterr().err
    assert table in told
    assert f"a {kind}" in told
    assert "[file.not_a_file]" in told


@pytest.mark.parametrize("table", ["block.toml", "images.csv", "observations.csv", "points.csv", "distances.csv"])
@pytest.mark.parametrize("kind", ["to nothing", "to itself"])
def test_a_broken_link_is_refused_not_taken_for_absent(tmp_path, block, capsys, table, kind):
    copy = tmp_path / "b"
    shutil.copytree(block, copy)
    (copy / table).unlink(missing_ok=True)
    (copy / table).symlink_to(tmp_path / "gone.csv" if kind == "to nothing" else copy / table)
    assert main(["adjust", str(copy), "--out", str(tmp_path / "r")]) == 2
    told = capsys.readouterr().err
    assert table in told
    assert ("[file.link_broken]" if kind == "to nothing" else "[file.link_loop]") in told


def test_a_folder_is_not_called_missing(tmp_path, capsys):
    assert main(["rpc", "info", str(tmp_path)]) == 2
    assert "[file.not_a_file]" in capsys.readouterr().err
    assert main(["rpc", "info", str(tmp_path / "nothing")]) == 2
    assert "[file.missing]" in capsys.readouterr().err


def test_a_comparison_replaces_a_comparison_alone(tmp_path, block, capsys):
    result, page = str(tmp_path / "r"), tmp_path / "c.html"
    assert main(["adjust", str(block), "--out", result, "--no-report"]) == 0
    page.write_text("mine")
    assert main(["compare", result, result, "--out", str(page)]) == 2
    assert "[comparison.path_taken]" in capsys.readouterr().err
    assert page.read_text() == "mine"
    page.unlink()
    for _ in range(2):
        assert main(["compare", result, result, "--out", str(page)]) == 0


def test_nothing_to_orient_leaves_no_project(tmp_path, capsys):
    (tmp_path / "photo.jpg").write_bytes(b"no photograph")
    out = tmp_path / "project"
    assert main(["orient", str(tmp_path / "photo.jpg"), "--out", str(out)]) == 2
    assert "0 usable photographs" in capsys.readouterr().err
    assert not out.exists()
    out.mkdir()
    assert main(["orient", str(tmp_path / "photo.jpg"), "--out", str(out)]) == 2
    assert (out / "project.db").exists()  # the folder was there before: its owner's


@pytest.mark.parametrize(
    ("number", "words"),
    [("1e30", "[value.too_large]"), ("1e999", "[value.too_large]"), ("nan", "[value.not_finite]")],
)
def test_a_number_beyond_the_limit_is_told_the_limit(tmp_path, block, capsys, number, words):
    copy = tmp_path / "b"
    shutil.copytree(block, copy)
    lines = (copy / "observations.csv").read_text().splitlines()
    cells = lines[1].split(",")
    (copy / "observations.csv").write_text(
        "\n".join([lines[0], ",".join([*cells[:2], number, *cells[3:]]), *lines[2:]])
    )
    assert main(["adjust", str(copy), "--out", str(tmp_path / "r")]) == 2
    assert words in capsys.readouterr().err
    cells[4] = "1e-300"
    (copy / "observations.csv").write_text("\n".join([lines[0], ",".join(cells), *lines[2:]]))
    assert main(["adjust", str(copy), "--out", str(tmp_path / "r")]) == 2
    assert "[cell.counts_as_zero]" in capsys.readouterr().err
