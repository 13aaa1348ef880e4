"""Runs that are killed, interrupted or find torn files: the same numbers in the end, and nothing done twice."""

import json
import os
import shutil
import signal
import sqlite3
import subprocess
import sys
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raybundle.cli.main import main
from raybundle.commands.status import status_of
from raybundle.pipeline.project import Project
from raybundle.workflows.orient import stages
from tests.barriers import SIGNALLED

PORTAL = Path(__file__).resolve().parents[2] / "demo_data/portal/photos"
pytestmark = [
    pytest.mark.skipif(not PORTAL.is_dir(), reason="demo_data/portal is part of the repository, not of the package"),
    pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="there is no kill -9 here"),
]
NUMBERS = (2, 3, 4)
INSTANTS = np.random.default_rng(20).uniform(0.12, 1.0, 10)
"""Ten random instants, as shares of the progress that an uninterrupted run tells."""


@pytest.fixture(scope="module")
def photos(tmp_path_factory):
    """Three photographs of half the size."""
    folder = tmp_path_factory.mktemp("half")
    for k in NUMBERS:
        with Image.open(PORTAL / f"portal_{k:02d}.jpg") as image:
            image.reduce(2).save(folder / f"portal_{k:02d}.jpg", quality=92, exif=image.info["exif"])
    return folder


def command(photos, out, *more):
    options = ["--feature-count", "600", "--jobs", "2", "--no-report"]
    return ["orient", str(photos), "--out", str(out), *options, *more]


def signalled(stage, name, photos, out):
    """A run that gets a signal at the first progress of a stage."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # tests in the background; the run would inherit it
        signal.signal(signal.SIGINT, signal.default_int_handler)
    words = [sys.executable, "-c", SIGNALLED, stage, name, *command(photos, out)]
    return subprocess.run(
        words, capture_output=True, text=True, check=False, env={**os.environ, "PYTHONPATH": str(PORTAL.parents[2])}
    )


def begun(photos, out, *more, **pipes):
    return subprocess.Popen([sys.executable, "-m", "raybundle", *command(photos, out, *more)], text=True, **pipes)


@pytest.fixture(scope="module")
def done(photos, tmp_path_factory):
    """An uninterrupted run, and how many lines of progress it told."""
    out = tmp_path_factory.mktemp("done") / "project"
    with begun(photos, out, "--progress", "json", stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as running:
        told = running.stderr.readlines()
    assert running.returncode == 0, told
    return out, len(told)


def result_of(project):
    """All tables, the block, and result.json without what a clock or the cache says."""
    folder = project / "result"
    result = json.loads((folder / "result.json").read_text())
    del result["seconds"], result["stages"]
    return result, {p.name: p.read_bytes() for p in sorted(folder.rglob("*.csv"))}


def kept(project):
    """Names of the products and verified pairs that a project holds, whole."""
    if not (project / "project.db").exists():
        return set()
    products = {p.stem for p in (project / "cache").glob("*/[!.]*.npz")}
    with closing(sqlite3.connect(f"{(project / 'project.db').as_uri()}?mode=ro", uri=True)) as db:
        try:
            return products | {key for (key,) in db.execute("SELECT key FROM pairs")}
        except sqlite3.OperationalError:  # killed before the tables were made
            return products


def killed(photos, project, lines):
    """Run until so much progress was told and kill; whether the run ended by itself before."""
    told = []
    with begun(photos, project, "--progress", "json", stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as running:
        for line in running.stderr:
            told.append(line)
            if len(told) > lines:
                running.kill()
                return False
    assert running.returncode == 0, told
    return True


@pytest.mark.long
def test_killed_at_ten_random_instants_it_continues_with_nothing_lost_and_gives_the_same(done, photos, tmp_path):
    reference, lines = done
    expected = result_of(reference)
    round_, before, ended = 0, set(), 0
    for share in INSTANTS:
        project = tmp_path / str(round_) / reference.name
        if killed(photos, project, share * lines):
            assert result_of(project) == expected
            round_, before, ended = round_ + 1, set(), ended + 1
            continue
        now = kept(project)
        assert before <= now, "what was finished is lost"
        before = now
    assert ended <= 6, "hardly any run was killed in its work"
    project = tmp_path / str(round_) / reference.name
    assert main(command(photos, project)) == 0
    assert result_of(project) == expected
    assert kept(project) == kept(reference)
    assert not [p for p in project.rglob(".*") if p.is_file()]


@pytest.fixture(scope="module")
def stopped(done, photos, tmp_path_factory):
    """A project whose run was killed when its pairs were in the journal of the database only."""
    project = tmp_path_factory.mktemp("stopped") / done[0].name
    ended = signalled("least-squares matching", "SIGKILL", photos, project)
    assert ended.returncode == -signal.SIGKILL, ended.stderr
    assert (project / "project.db-wal").stat().st_size > 0
    return project


def cut(path):
    path.write_bytes(path.read_bytes()[: path.stat().st_size * 2 // 3])


def overwritten(path):
    data = bytearray(path.read_bytes())
    data[len(data) // 2 : len(data) // 2 + 64] = bytes(64)
    path.write_bytes(data)


def lengthened(path):
    path.write_bytes(path.read_bytes() + np.random.default_rng(1).bytes(9000))


def emptied(path):
    path.write_bytes(b"")


@pytest.mark.parametrize("accident", [cut, overwritten, lengthened, emptied, Path.unlink])
def test_a_torn_journal_costs_at_most_what_it_held(stopped, done, photos, tmp_path, accident):
    project = Path(shutil.copytree(stopped, tmp_path / stopped.name))
    accident(project / "project.db-wal")
    opened, whole = Project.open(project), Project.open(done[0], create=False)
    try:
        assert opened.db.execute("PRAGMA integrity_check").fetchone() == ("ok",)
        keys = [key for (key,) in whole.db.execute("SELECT key FROM pairs")]
        expected = whole.small(keys)
        for key, product in opened.small(keys).items():
            assert product.keys() == expected[key].keys()
            for name, values in product.items():
                np.testing.assert_array_equal(values, expected[key][name])
    finally:
        opened.close()
        whole.close()
    if accident is cut:
        assert main(command(photos, project)) == 0
        assert result_of(project) == result_of(done[0])


def test_torn_products_are_made_again(done, photos, tmp_path):
    project = Path(shutil.copytree(done[0], tmp_path / done[0].name))
    for path in sorted((project / "cache").glob("*/*.npz"))[::2]:
        cut(path)
    assert main(command(photos, project)) == 0
    assert result_of(project) == result_of(done[0])
    assert kept(project) == kept(done[0])


def test_a_deleted_database_costs_the_pairs_only(done, photos, tmp_path):
    project = Path(shutil.copytree(done[0], tmp_path / done[0].name))
    (project / "project.db").unlink()
    assert main(command(photos, project)) == 0
    assert result_of(project) == result_of(done[0])
    stages = {s["name"]: s["from_cache"] for s in json.loads((project / "result/result.json").read_text())["stages"]}
    assert {name for name, cached in stages.items() if cached} == {"features", "start", "precision"}


def test_a_damaged_database_says_what_to_do(done, photos, tmp_path, capsys):
    project = Path(shutil.copytree(done[0], tmp_path / done[0].name))
    path = project / "project.db"
    data = bytearray(path.read_bytes())
    data[4096:] = b"\xff" * (len(data) - 4096)
    path.write_bytes(data)
    for call in (command(photos, project), ["status", str(project)]):
        assert main(call) == 2
        told = capsys.readouterr().err
        assert "project.db: " in told
        assert "[project.not_readable]" in told


def test_an_interrupted_run_says_that_it_can_be_continued(photos, tmp_path):
    ended = signalled("features", "SIGINT", photos, tmp_path / "project")
    assert ended.returncode == 130
    assert ended.stdout == ""
    assert str(tmp_path / "project") in ended.stderr.splitlines()[-1]


def test_two_runs_do_not_work_in_one_project(photos, tmp_path, capsys):
    out = tmp_path / "project"
    first = Project.open(out)
    try:
        assert main(command(photos, out)) == 2
        assert "[project.in_use]" in capsys.readouterr().err
        assert main(["status", str(out)]) == 0  # looking is allowed
    finally:
        first.close()


def test_a_new_run_clears_away_what_a_killed_one_had_begun(tmp_path):
    project = Project.open(tmp_path)
    key = f"start-{'1' * 40}"
    project.products.store(key, {"a": np.zeros(3)})
    project.close()
    begun = tmp_path / ".result.0123abcd.partial"
    begun.mkdir()
    (begun / "points.csv").write_text("point\n")
    (tmp_path / f"cache/11/.{key}.0123abcd").write_bytes(b"half")
    (tmp_path / ".project.toml.0123abcd").write_text("half")
    project = Project.open(tmp_path)
    try:
        assert not list(tmp_path.rglob(".*"))
        assert project.products.load(key) is not None
    finally:
        project.close()


@pytest.mark.parametrize(("word", "first"), [("match", "matching"), ("report", "report"), ("A", "adjustment")])
def test_from_a_stage_by_the_beginning_of_its_name(done, photos, tmp_path, capsys, word, first):
    project = Path(shutil.copytree(done[0], tmp_path / done[0].name))
    assert main(command(photos, project, "--from-stage", word)) == 0
    assert result_of(project) == result_of(done[0])
    capsys.readouterr()
    assert main(["status", str(project)]) == 0
    lines = capsys.readouterr().out.splitlines()
    stated = {name: line for line in lines if line and (name := line.split()[0]) in stages()}
    assert not status_of(project).store
    assert list(stated) == [s for s in stages() if s != "wide baselines"]  # not needed
    cached = {name for name, line in stated.items() if "from cache" in line}
    wanted = set(stages()[: stages().index(first)]) - {"photographs", "adjustment", "wide baselines"}
    assert cached == wanted
    assert not [name for name, line in stated.items() if "not done" in line]
    assert f'redo_from = "{first}"' in (project / "project.toml").read_text()


@pytest.mark.parametrize("word", ["p", "nothing", ""])
def test_a_beginning_that_says_too_little_is_refused(photos, tmp_path, capsys, word):
    assert main(command(photos, tmp_path / "project", "--from-stage", word)) == 2
    assert "photographs" in capsys.readouterr().err
    assert not (tmp_path / "project").exists()
