"""An adjustment within the memory that is allowed: the same figures, nothing left behind, a full disk told."""

import errno
import gc
import mmap
import os
from contextlib import suppress
from dataclasses import fields, replace
from functools import partial

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.evaluation.queries import covariance
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import Severity
from raybundle.block.select import with_rows
from raybundle.blocking.memory import Serial
from raybundle.blocking.normals import Parts
from raybundle.blocking.normals_in_parts import in_parts
from raybundle.cli.main import main
from raybundle.commands.adjust import AdjustSettings, run_adjust
from raybundle.errors import InputError, NotSolvable
from raybundle.io.block.arrays import arrays_of_block
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.folders import continued_folder
from raybundle.numerics import large
from raybundle.numerics.machine import available_memory
from raybundle.pipeline.executors import Staying
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.words import headline
from raybundle.workflows.adjust import adjust
from raybundle.workflows.unfinished_parts import bytes_in, left_beside
from raybundle.workflows.within_memory import BASE, IN_MEMORY, within_memory
from tests.adjustment.test_noise import with_fields
from tests.blocking.networks import flight
from tests.messages import refused

OPTIONS = AdjustmentOptions(jobs=1)


def with_known_wrong(block, rows):
    o = block.observations
    return replace(block, rejected=tuple((block.images.ids[o.image[k]], block.points.ids[o.point[k]]) for k in rows))


def in_file(values):
    """Whether an array lies in a file."""
    while isinstance(values, np.ndarray):
        values = values.base
    return isinstance(values, mmap.mmap | memoryview)


@pytest.fixture
def all_large(monkeypatch):
    monkeypatch.setattr(large, "LEAST", 1)
    monkeypatch.setattr(large, "PIECE", 700)
    monkeypatch.setattr("raybundle.workflows.within_memory.in_parts", partial(in_parts, 60))


def within(block, options, out, memory_gb):
    with within_memory(block, out, memory_gb) as (kept, room):
        return adjust(kept, options), room


@pytest.mark.parametrize(
    ("make", "options"),
    [
        (flight, OPTIONS),
        (lambda: flight(control=0, observed=False), OPTIONS),
        (flight, replace(OPTIONS, reject="snooping", estimate="auto")),
    ],
    ids=["control", "inner constraints", "decisions"],
)
def test_the_same_figures_in_files_and_in_parts(tmp_path, all_large, make, options):
    block = make()
    one = adjust(block, options)
    few, room = within(block, options, tmp_path / "result", 0.01)
    assert room.parts > 3
    assert room.arrays_in_files
    assert in_file(few.image_observations.t)
    assert in_file(few.given.observations.xy_px)
    assert few.image_observations.rejected == one.image_observations.rejected
    assert [n.code for n in few.notices] == [n.code for n in one.notices]
    for name in ("residuals_px", "redundancy", "w", "t", "mdb_px", "external", "least_control"):
        a, b = getattr(one.image_observations, name), getattr(few.image_observations, name)
        np.testing.assert_allclose(b, a, rtol=1e-4, atol=1e-4 * np.nanmax(np.abs(a)))
    std = one.precision.object_point_std
    np.testing.assert_allclose(few.precision.object_point_std, std, rtol=1e-7)
    assert np.nanmax(np.abs(few.adjusted.points.xyz - one.adjusted.points.xyz) / np.nanmean(std)) < 1e-5
    for name in ("rays", "stations_per_point", "pair_images", "pair_points"):
        assert np.array_equal(getattr(one.network, name), getattr(few.network, name))
    np.testing.assert_allclose(few.network.coverage, one.network.coverage)
    np.testing.assert_allclose(few.network.base_to_depth, one.network.base_to_depth, rtol=1e-7)
    # questions that are asked later are answered from the parts, which stay for as long as the result
    names = [f"image:{i}" for i in one.given.images.ids[:2]]
    np.testing.assert_allclose(covariance(few, names).matrix, covariance(one, names).matrix, rtol=1e-6, atol=1e-14)
    assert [p.name.startswith(".result.") for p in tmp_path.iterdir()] == [True]
    del few, room
    gc.collect()
    assert not list(tmp_path.iterdir())


def test_noise_fields_are_those_of_one_piece(tmp_path, all_large):
    block, options = with_fields(flight(), 0.3), replace(OPTIONS, noise="fields")
    one = adjust(block, options)
    few, room = within(block, options, tmp_path / "result", 0.01)
    assert room.parts > 3
    assert few.noise.kind == one.noise.kind == "fields"
    assert few.noise.tau_px == pytest.approx(one.noise.tau_px, rel=1e-6)
    np.testing.assert_allclose(few.precision.object_point_std, one.precision.object_point_std, rtol=1e-6)
    np.testing.assert_allclose(few.precision.image_std, one.precision.image_std, rtol=1e-6)
    assert [n.code for n in few.notices] == [n.code for n in one.notices]


def smooth_errors():
    """A flight whose images have smooth errors of their own, which white noise does not know."""
    strips = AerialStrips(images_per_strip=9, points_per_image=120)
    made = simulate(
        aerial_scene(strips), Survey(image_sigma_px=0.3, control=6, control_sigma=(0.02, 0.02, 0.02), seed=2)
    )
    return with_fields(made.observed, 0.6)


def factors(notice):
    """What standard deviations of object points are to be multiplied by."""
    return notice.values["ratio_points"]


def test_errors_that_image_points_of_large_blocks_share_are_noticed_by_a_sample(tmp_path, monkeypatch):
    block = smooth_errors()
    options = replace(OPTIONS, noise="auto")
    one = adjust(block, options)
    monkeypatch.setattr("raybundle.workflows.adjust.LOOKED_AT", 1000)
    few, room = within(block, options, tmp_path / "result", 0.01)
    assert room.parts
    (whole,) = (n for n in one.notices if n.code == "residual_structure")
    (part,) = (n for n in few.notices if n.code == "residual_structure")
    assert "residual_structure.sample" in {d.code for d in part.details}
    assert part.severity is Severity.WARNING
    assert factors(whole) > 1.3
    assert factors(part) == pytest.approx(factors(whole), rel=0.3)


def test_with_enough_memory_it_is_the_one_piece_bit_by_bit(tmp_path):
    block = flight()
    one = adjust(block, OPTIONS)
    much, room = within(block, OPTIONS, tmp_path / "result", 8.0)
    assert not room.parts
    assert not room.notices()
    assert np.array_equal(much.image_observations.t, one.image_observations.t, equal_nan=True)
    assert not list(tmp_path.iterdir())


def test_the_command_says_what_it_did(tmp_path):
    write_block(flight(), tmp_path / "block")
    done = run_adjust(AdjustSettings(block=tmp_path / "block", out=tmp_path / "out", memory=0.1, report=False))
    told = next(n for n in done.notices if n.code == "in_parts")
    assert told.variant == "least"
    assert told.values["allowed_gb"] == pytest.approx(0.1)
    assert told.values["needed_gb"] > 0
    assert told.values["least_gb"] > 0.1
    assert done.converged


@pytest.mark.parametrize("memory", [0.01, 8.0])
def test_a_folder_of_columns_is_read_in_pieces_where_it_has_to_be(tmp_path, all_large, monkeypatch, memory):
    pytest.importorskip("pyarrow", reason="the extra [parquet] is not installed")
    block = with_known_wrong(flight(), [3, 70])
    write_block(block, tmp_path / "block", tables="parquet")
    whole = read_block(tmp_path / "block")
    with within_memory(tmp_path / "block", tmp_path / "out", memory) as (found, room):
        assert room.arrays_in_files == (memory < 1)
        assert in_file(found.observations.xy_px) == (memory < 1)
        for f in fields(whole.observations):
            assert np.array_equal(getattr(found.observations, f.name), getattr(whole.observations, f.name))
        assert found.rejected == whole.rejected
        assert len(whole.rejected) == 2
        assert found.points.ids == whole.points.ids
        assert arrays_of_block(found).keys() == arrays_of_block(whole).keys()


def test_what_is_free_decides_where_nothing_is_asked_for(tmp_path, monkeypatch):
    block = flight()
    assert 1e7 < available_memory() < 1e14
    need = BASE + IN_MEMORY * len(block.observations)
    monkeypatch.setattr("raybundle.workflows.within_memory.ALWAYS", 0.0)
    for free, parts in ((0.5 * need, True), (2.0 * need + 1e9, False)):
        monkeypatch.setattr("raybundle.workflows.within_memory.available_memory", lambda free=free: free)
        with within_memory(block, tmp_path / "out", 0.0) as (kept, room):
            assert bool(adjust(kept, OPTIONS) and room.parts) == parts


def test_a_small_block_is_one_piece_however_little_is_free(tmp_path, monkeypatch):
    monkeypatch.setattr("raybundle.workflows.within_memory.available_memory", lambda: 1e6)
    with within_memory(flight(), tmp_path / "out", 0.0) as (kept, room):
        assert adjust(kept, OPTIONS).converged
        assert not room.parts


def test_a_limit_of_a_container_counts(tmp_path, monkeypatch):
    monkeypatch.setattr("raybundle.numerics.machine.CGROUP", tmp_path)
    for name, text in (("max", "3000000\n"), ("current", "2500000\n"), ("stat", "anon 5\ninactive_file 400000\n")):
        (tmp_path / f"memory.{name}").write_text(text)
    assert available_memory() == 900_000
    (tmp_path / "memory.max").write_text("max\n")
    assert available_memory() > 1e7


def test_a_full_disk_is_told_before_anything_is_written(tmp_path, monkeypatch):
    def full(*_):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "posix_fallocate", full, raising=False)
    with large.in_files(tmp_path), refused("memory.no_room", size_mb=8.0, detail=os.strerror(errno.ENOSPC)):
        large.zeros(1_000_000)
    assert not list(tmp_path.iterdir())


def test_arrays_in_files_where_room_cannot_be_asked_for(tmp_path, monkeypatch):
    monkeypatch.delattr(os, "posix_fallocate", raising=False)
    with large.in_files(tmp_path):
        found = large.zeros((300_001, 1))
        found[-1] = 3.0
    assert in_file(found)
    assert found.sum() == 3.0
    assert not in_file(large.zeros((300_001, 1)))


def test_a_folder_is_there_for_the_next_run_where_one_was_cut_short(tmp_path):
    with continued_folder(tmp_path / "a", lambda: False) as left:
        (left / "x").write_text("of a run that was cut short")
        with continued_folder(tmp_path / "a", lambda: True) as other:
            assert other != left
        assert not other.exists()
    with continued_folder(tmp_path / "a", lambda: True) as again:
        assert (again / "x").exists()
    assert not list(tmp_path.iterdir())


class Stopped:
    """Does some tasks, and is interrupted."""

    def __init__(self, most):
        self.done, self.most = [], most

    def run(self, tasks, store):
        for done in Serial().run(tasks, store):
            self.done.append(done.task.name)
            yield done
            if len(self.done) == self.most:
                raise KeyboardInterrupt


def test_a_run_that_is_cut_short_goes_on(tmp_path, all_large):
    block, counts = flight(), []
    for most in (40, 1_000_000):
        worker = Stopped(most)
        stopped = None
        with suppress(KeyboardInterrupt), within_memory(block, tmp_path / "result", 0.01) as (kept, room):
            room.executor, stopped = worker, room
            few = adjust(kept, OPTIONS)
        counts.append(len(worker.done))
        del stopped, room, kept
        gc.collect()
        assert (tmp_path / ".result.parts").exists()
    whole = Stopped(1_000_000)
    with within_memory(block, tmp_path / "other", 0.01) as (kept, room):
        room.executor = whole
        wanted = adjust(kept, OPTIONS)
    assert np.array_equal(few.image_observations.t, wanted.image_observations.t, equal_nan=True)
    assert len(whole.done) <= sum(counts) <= len(whole.done) + 12  # the sweep that was cut needs what was let go
    del few, wanted, kept, room
    gc.collect()
    assert not list(tmp_path.iterdir())


@pytest.mark.long
def test_what_cannot_be_solved_leaves_nothing(tmp_path, all_large):
    block = flight(control=0, observed=False, bar=False)
    camera = replace(block.cameras[0], estimate=("c", "x0", "y0", "affinity", "shear", "K1", "K2", "K3"))
    level = replace(block.points, xyz=np.where([True, True, False], block.points.xyz, 0.0))
    o = block.observations
    order = np.lexsort((o.image, o.point))
    first = np.searchsorted(o.point[order], o.point[order])
    two_rays = np.isin(np.arange(len(o)), order[np.arange(len(o)) - first < 2])
    poor = with_rows(replace(block, cameras=(camera,), points=level), two_rays)
    with pytest.raises(NotSolvable) as error, within_memory(poor, tmp_path / "result", 0.01) as (kept, room):
        decide(kept, OPTIONS)
    assert room.stores
    del kept, room, error
    gc.collect()
    assert not list(tmp_path.iterdir())


@pytest.mark.long
def test_processes_take_part_where_memory_allows(tmp_path, all_large, monkeypatch):
    monkeypatch.setattr("raybundle.workflows.within_memory.PROCESS", 1.0)
    block, results = flight(), []
    allowed = (BASE + 500.0 * len(block.observations)) / 1e9
    for jobs in (1, 2):
        with within_memory(block, tmp_path / "result", allowed, jobs=jobs) as (kept, room):
            results.append(adjust(kept, OPTIONS))
            assert isinstance(room.executor, Staying) == (jobs == 2)
            assert room.parts > 3
    a, b = (r.image_observations for r in results)
    assert np.array_equal(a.t, b.t, equal_nan=True)


def test_shards_are_refused(tmp_path):
    with (
        pytest.raises(InputError, match=r"cluster\.no_shards"),
        within_memory(flight(), tmp_path / "r", 8.0, cluster="shards"),
    ):
        pass


def interrupted(monkeypatch, *words):
    """Exit status of an adjustment that is interrupted when its first sweep is done."""
    with monkeypatch.context() as patch:
        made = Parts.noted

        def noted(self, name, about, find):
            if name == "tried":
                raise KeyboardInterrupt
            return made(self, name, about, find)

        patch.setattr(Parts, "noted", noted)
        return main([str(w) for w in words])


def test_what_a_run_takes_away_meanwhile_does_not_count(tmp_path, monkeypatch):
    for name in ("a", "b"):
        (tmp_path / "parts" / name).mkdir(parents=True)
        (tmp_path / "parts" / name / "x").write_bytes(bytes(100))
    walk = os.walk

    def changing(folder):
        for found in walk(folder):
            (tmp_path / "parts/a/x").unlink(missing_ok=True)
            yield found

    monkeypatch.setattr("raybundle.workflows.unfinished_parts.os.walk", changing)
    assert bytes_in(tmp_path / "parts") == 100


def test_an_interrupt_says_where_parts_are_and_a_later_run_removes_them(tmp_path, monkeypatch, capsys):
    pytest.importorskip("fsspec", reason="the extra [cluster] is not installed")
    monkeypatch.setenv("RAYBUNDLE_PRODUCTS", str(tmp_path / "products"))
    write_block(flight(), tmp_path / "block")
    words = ["adjust", tmp_path / "block", "--out", tmp_path / "result", "--no-report", "--jobs", "1"]
    left = tmp_path / ".result.parts"
    for store in ("", f"file://{tmp_path}/bucket"):
        status = interrupted(monkeypatch, *words, "--memory", "0.01", *(["--store", store] if store else []))
        assert status == 130
        gc.collect()
        said = capsys.readouterr().err
        assert headline("interruption.kept", {"folder": str(left)}).removesuffix(".") in said
        assert store in said
        assert left_beside(tmp_path / "result")[0].bytes > 0
    assert list((tmp_path / "bucket").rglob("*.npz"))
    assert main(["status", str(tmp_path / "result")]) == 0
    said = capsys.readouterr().out
    assert f"{left}: " in said
    assert f"file://{tmp_path}/bucket" in said
    gc.collect()
    assert main([str(w) for w in words]) == 0  # all in memory
    assert not left.exists()
    assert not list((tmp_path / "bucket").rglob("*.npz"))
