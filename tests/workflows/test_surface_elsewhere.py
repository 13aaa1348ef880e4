"""A surface by threads, processes, workers of a cluster and shards, in a folder and in a store: the same bits.

A part of three photographs of the portal, at half their size.
"""

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.commands.surface import surface
from raybundle.pipeline.store import Folder
from raybundle.surfaces.files.heights import read_heights
from raybundle.surfaces.heights.resampling import difference
from tests.barriers import HELD, kill_where_held
from tests.cli.reported import reported, values_of
from tests.pipeline.machines import Machines

pytestmark = pytest.mark.skipif(os.name == "nt", reason="processes are killed as on POSIX systems")
ROOT = Path(__file__).parents[2]
BOX = ("-0.6", "-0.4", "0.5", "0.5")


def words(half, out, *more):
    return [
        "surface", str(half / "block"), "--photos", str(half), "--density", "4", "--extent", *BOX, "--dsm", "0.05",
        "--out", str(out), *more,
    ]  # fmt: skip


def times_of(store):
    """When each product of a store was made."""
    return {p.name: p.stat().st_mtime_ns for p in store.rglob("*.npz")}


def products_of(out, store=""):
    """Arrays of all that is kept, and the files that were written."""
    kept = Folder(out / "work/cache", store)
    kinds = ("depth map", "surface shifts", "surface sigma", "surface points", "surface above", "surface heights")
    keys = [k for kind in kinds for k in kept.keys_of_kind(kind)]
    written = {n: (out / n).read_bytes() for n in ("points.ply", "heights.tif", "heights.toml")}
    return {k: kept.wanted(k) for k in keys}, written


def same(one, other):
    assert one[0].keys() == other[0].keys()
    assert len(one[0]) > 10
    for k, arrays in one[0].items():
        for name, a in arrays.items():
            b = other[0][k][name]
            assert a.dtype == b.dtype
            assert np.array_equal(a, b, equal_nan=a.dtype.kind == "f"), (k, name)
    assert one[1] == other[1]


@pytest.fixture(scope="module")
def here(half, tmp_path_factory):
    """By one thread."""
    out = tmp_path_factory.mktemp("here") / "s"
    assert main(words(half, out, "--jobs", "1")) == 0
    return products_of(out)


@pytest.mark.long
def test_processes_and_a_store_elsewhere(half, here, tmp_path, capsys):
    url = f"file://{tmp_path}/store"
    assert main(words(half, tmp_path / "s", "--jobs", "2", "--store", url)) == 0
    assert not list((tmp_path / "s/work/cache").rglob("*.npz"))
    same(here, products_of(tmp_path / "s", url))
    # it is remembered, and all is there
    capsys.readouterr()
    made = times_of(tmp_path / "store")
    assert main(words(half, tmp_path / "s")) == 0
    assert made
    assert times_of(tmp_path / "store") == made
    assert f'store = "{url}"' in (tmp_path / "s/work/project.toml").read_text()
    assert not list((tmp_path / "s/work/cache").rglob("*.npz"))


def test_a_store_that_cannot_be_is_refused_before_anything_is_measured(half, tmp_path, capsys, monkeypatch):
    for url, told in (("nowhere", "[store.no_url]"), (f"file://{tmp_path}/s/work/x", "[store.not_separate]")):
        assert main(words(half, tmp_path / "s", "--store", url)) == 2
        assert told in capsys.readouterr().err
    monkeypatch.setattr("raybundle.measuring.session.adjusted_again", lambda *_: pytest.fail("adjusted before"))
    assert main(words(half, tmp_path / "s", "--cluster", str(tmp_path / "none"))) == 2
    assert "none" in capsys.readouterr().err
    assert not (tmp_path / "s/work/cache").exists() or not list((tmp_path / "s/work/cache").rglob("*.npz"))


def test_a_cluster_that_does_not_answer_leaves_no_folder(half, tmp_path, capsys):
    pytest.importorskip("distributed", reason="the extra [cluster] is not installed")
    assert main(words(half, tmp_path / "s", "--cluster", "tcp://127.0.0.1:1")) == 2
    assert "tcp://127.0.0.1:1" in capsys.readouterr().err
    assert not (tmp_path / "s").exists()


@pytest.mark.long
def test_workers_of_a_cluster(half, here, tmp_path):
    pytest.importorskip("distributed", reason="the extra [cluster] is not installed")
    machines = Machines(tmp_path / "cluster")
    try:
        machines.scheduler()
        machines.worker(jobs=2)
        done = surface(
            half / "block", tmp_path / "s", photos=(half,), density="4", extent=tuple(map(float, BOX)), dsm=0.05,
            cluster=str(machines.folder),
        )  # fmt: skip
        assert len(done.surface) > 500
    finally:
        machines.close()
    same(here, products_of(tmp_path / "s"))


@pytest.mark.long
def test_shards(half, here, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("raybundle.pipeline.shards.ALONE_S", 0.0)  # as with photographs that take longer
    monkeypatch.setattr("raybundle.pipeline.shards.TOGETHER_S", 0.0)
    rounds = 0
    for _ in range(12):
        status = main(words(half, tmp_path / "s", "--cluster", "shards"))
        if status == 0:
            break
        assert status == 5
        assert "task.shards_waiting" in capsys.readouterr().err
        rounds += 1
        for k in (1, 0):
            shard = subprocess.run(
                [sys.executable, "-m", "raybundle", "worker", str(tmp_path / "s/work"), "--shard", f"{k}/2"],
                cwd="/", check=False, capture_output=True, text=True,
            )  # fmt: skip
            assert shard.returncode == 0, shard.stderr
    assert 2 <= rounds < 12
    same(here, products_of(tmp_path / "s"))


@pytest.mark.long
def test_a_run_that_is_killed_goes_on_to_the_same_bits(half, here, tmp_path):
    out = tmp_path / "s"
    for kind in ("depth map", "surface points"):
        command = [sys.executable, "-c", HELD, f"cache/{kind}-", "1", *words(half, out, "--jobs", "1")]
        kill_where_held(command, cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT)})
    made = {p.name: p.stat().st_mtime_ns for p in (out / "work/cache").glob("*/depth map-*.npz")}
    assert made
    assert not (out / "points.ply").exists()
    assert main(words(half, out, "--jobs", "1")) == 0
    after = {p.name: p.stat().st_mtime_ns for p in (out / "work/cache").glob("*/depth map-*.npz")}
    assert made.items() <= after.items()
    same(here, products_of(out))
    assert not [p for p in out.rglob(".*") if p.is_file()]


@pytest.mark.long
def test_two_surfaces_of_one_adjustment_move_by_the_same_errors(half, tmp_path, capsys):
    pytest.importorskip("rasterio")
    for name, other in (("a", "portal_03"), ("b", "portal_08")):
        photos = tmp_path / f"photos-{name}"
        photos.mkdir()
        for stem in ("portal_02", other):
            (photos / f"{stem}.png").write_bytes((half / f"{stem}.png").read_bytes())
        given = words(half, tmp_path / name, "--photos", str(photos), "--jobs", "1")
        given.remove(str(half))
        given.remove("--photos")
        assert main(given) == 0
    a, b = (read_heights(tmp_path / name)[0] for name in "ab")
    assert a.errors
    assert a.errors == b.errors
    assert a.moved.shape == b.moved.shape
    shown = values_of(reported(capsys, "heights", "difference", tmp_path / "a", tmp_path / "b"))
    assert shown["heights.one_adjustment"]["common"] == "known"
    found = difference(a, b)
    some = found.known / found.known.sum()
    apart = difference(replace(a, errors=""), b)
    assert found.sum_of(some).orientation < apart.sum_of(some).orientation
    # and what they differ by is what that lets expect
    mean = found.sum_of(some)
    assert abs(mean.value) < 4 * mean.sigma
