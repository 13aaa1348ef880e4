"""Parts that others reduce: blunders and parameters as in one piece, the same bits, and runs that go on."""

import os
import subprocess
import sys
from collections import deque
from dataclasses import replace
from pathlib import Path
from weakref import WeakValueDictionary

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.factoring import made_by
from raybundle.blocking import tasks as blocking_tasks
from raybundle.blocking.memory import Serial
from raybundle.blocking.normals_in_parts import in_parts
from raybundle.errors import message
from raybundle.io.block.folder import write_block
from raybundle.numerics import native
from raybundle.pipeline.executors import Staying, Threads
from raybundle.pipeline.store import Folder
from tests.barriers import kill_where_held
from tests.blocking.networks import flight
from tests.messages import refused
from tests.pipeline.machines import Machines

OPTIONS = AdjustmentOptions(jobs=1, reject="snooping")
LEAF = 36


def doubtful(images=9):
    """Six blunders, and a camera whose parameters are to be chosen."""
    block = flight(interior="exact", images=images)
    o, rng = block.observations, np.random.default_rng(5)
    wrong = rng.choice(len(o), 6, replace=False)
    xy = o.xy_px.copy()
    xy[wrong] += rng.choice([-25.0, 25.0], (6, 2))
    camera = replace(block.cameras[0], estimate="auto")
    return replace(block, cameras=(camera,), observations=replace(o, xy_px=xy))


def stores(folder):
    """A folder for each system, and one for notes."""
    made = iter(range(1000))
    return (lambda: Folder(folder / f"parts-{next(made)}")), Folder(folder / "notes")


def adjusted(block, folder, executor, options=OPTIONS):
    """The block adjusted with all decisions, by whoever does the tasks."""
    store, notes = stores(folder)
    with made_by(in_parts(LEAF, store=store, executor=executor, notes=notes)):
        return decide(block, options)


def numbers(result):
    """What a result says, to the last bit."""
    o = result.image_observations
    parts = [o.residuals_px, o.redundancy, o.t, o.external, result.adjusted.points.xyz, result.precision.object_points]
    parts += [result.precision.images, *result.precision.interior.values()]
    return [np.asarray(p).tobytes() for p in parts], o.rejected, [n.text for n in result.notices]


class Counting:
    """Does tasks, and counts them; stops where it is told to."""

    def __init__(self, stop=np.inf):
        self.done, self.stop = [], stop

    def run(self, tasks, store):
        for done in Serial().run(tasks, store):
            self.done.append(done.task.key)
            yield done
            if len(self.done) >= self.stop:
                raise KeyboardInterrupt


def test_blunders_and_parameters_are_those_of_one_piece(tmp_path):
    block = doubtful(24)
    one, parts = decide(block, OPTIONS), adjusted(block, tmp_path, Serial())
    tree = parts.handle.work.normals.parts.network.tree
    assert sum(not c for c in tree.children) >= 8
    assert [r and r.kind for r in parts.image_observations.rejected] == [
        r and r.kind for r in one.image_observations.rejected
    ]
    assert sum(r is not None for r in parts.image_observations.rejected) >= 4
    assert [i.free for i in parts.interior] == [i.free for i in one.interior]
    assert [n.code for n in parts.notices] == [n.code for n in one.notices]
    std = one.precision.object_point_std
    moved = np.abs(parts.adjusted.points.xyz - one.adjusted.points.xyz) / np.where(std > 0, std, 1.0)
    assert np.nanmax(moved) < 1e-4
    np.testing.assert_allclose(parts.precision.object_point_std, std, rtol=1e-6)


@pytest.mark.long
def test_the_same_bits_by_whoever_does_the_tasks(tmp_path):
    block = doubtful()
    wanted = numbers(adjusted(block, tmp_path / "serial", Serial()))
    for name, executor in {"threads": Threads(2), "one": Staying(1), "two": Staying(2)}.items():
        assert numbers(adjusted(block, tmp_path / name, executor)) == wanted, name
        if isinstance(executor, Staying):
            executor.close()


@pytest.mark.long
def test_a_run_that_was_cut_short_goes_on_from_what_is_kept(tmp_path):
    block = doubtful()
    whole = Counting()
    wanted = numbers(adjusted(block, tmp_path / "whole", whole))
    done, rng = 0, np.random.default_rng(2)
    for stop in rng.integers(1, len(whole.done) // 4, 6):
        short = Counting(int(stop))
        with pytest.raises(KeyboardInterrupt):
            adjusted(block, tmp_path / "short", short)
        done += len(short.done)
    last = Counting()
    assert numbers(adjusted(block, tmp_path / "short", last)) == wanted
    # nothing but tasks in work is done again, and what a later sweep needs of the one that was cut
    assert done + len(last.done) <= 1.1 * len(whole.done)


def test_what_a_task_says_reaches_the_user(tmp_path):
    class Failing(Serial):
        def run(self, tasks, store):
            for done in super().run(tasks, store):
                yield replace(done, failed=message("task.failed_repeatedly", name="up 3", n=3, log="tasks.log"))

    with refused("task.failed_repeatedly", name="up 3", n=3):
        adjusted(flight(), tmp_path, Failing())


DRIVER = """
import sys
from functools import partial
from pathlib import Path

from raybundle.blocking.normals_in_parts import in_parts
from raybundle.commands.adjust import AdjustSettings, run_adjust
from raybundle.workflows import within_memory
from tests.barriers import hold

if __name__ == "__main__":
    within_memory.in_parts = partial(in_parts, 24)
    block, out, cluster, *notes = sys.argv[1:]
    if notes:
        hold("notes/", int(notes[0]))
    given = {"cluster": cluster, "memory": 4.0} if cluster else {"memory": 0.01}
    run_adjust(
        AdjustSettings(block=Path(block), out=Path(out), reject="snooping", jobs=1, report=False, **given)
    )
"""


@pytest.mark.long
@pytest.mark.skipif(os.name == "nt", reason="processes are killed as on POSIX systems")
def test_a_cluster_whose_driver_is_killed_gives_the_tables_of_one_process(tmp_path):
    pytest.importorskip("distributed", reason="the extra [cluster] is not installed")
    write_block(doubtful(), tmp_path / "block")
    (tmp_path / "driver.py").write_text(DRIVER)
    machines = Machines(tmp_path / "cluster")
    try:
        machines.scheduler()
        machines.worker(jobs=2)
        words = [sys.executable, str(tmp_path / "driver.py"), str(tmp_path / "block")]
        env = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
        subprocess.run([*words, str(tmp_path / "one"), ""], check=True, env=env)
        on_two = [*words, str(tmp_path / "two"), str(machines.folder)]
        for more in (6, 5, 7):
            kill_where_held([*on_two, str(more)], env=env)
        subprocess.run(on_two, check=True, env=env)
    finally:
        machines.close()
    one, two = ({f.name: f.read_bytes() for f in (tmp_path / n).glob("*.csv")} for n in ("one", "two"))
    assert len(one) > 3
    assert one == two
    assert not (tmp_path / ".two.parts").exists()


class ByTwin:
    """Does the tasks of every other list as a worker without compiled kernels would, with nothing but the store."""

    def __init__(self, monkeypatch):
        self.patch, self.lists = monkeypatch, 0

    def run(self, tasks, store):
        self.lists += 1
        with self.patch.context() as other:
            if self.lists % 2:
                without_kernels(other)
                other.setattr(blocking_tasks, "_known", WeakValueDictionary())
                other.setattr(blocking_tasks, "_read", deque(maxlen=2))
            done = list(Serial().run(tasks, store))
        yield from done


def without_kernels(patch):
    patch.setattr(native, "module", lambda: None)
    patch.setattr(native, "sensor_models", frozenset)


def same(one, other):
    """To the rounding by which kernels and their twins differ."""
    std = one.precision.object_point_std
    moved = np.abs(other.adjusted.points.xyz - one.adjusted.points.xyz) / np.where(std > 0, std, 1.0)
    assert np.nanmax(moved) < 1e-4
    np.testing.assert_allclose(other.precision.object_point_std, std, rtol=1e-6)
    assert [r and r.kind for r in other.image_observations.rejected] == [
        r and r.kind for r in one.image_observations.rejected
    ]


@pytest.mark.skipif(not native.available(), reason="there are no kernels to be without")
def test_a_worker_without_kernels_gives_the_same(tmp_path, monkeypatch):
    block = doubtful()
    one, mixed = adjusted(block, tmp_path / "one", Serial()), adjusted(block, tmp_path / "two", ByTwin(monkeypatch))
    assert len(one.handle.work.normals.parts.network.tree) > 3
    same(one, mixed)


@pytest.mark.long
@pytest.mark.skipif(not native.available(), reason="there are no kernels to be without")
@pytest.mark.parametrize("first", ["kernels", "twins"])
def test_a_run_goes_on_with_and_without_kernels(tmp_path, monkeypatch, first):
    """What was noted of finished sweeps is read, wherever the other solver keeps its values."""
    block = doubtful()
    whole = Counting()
    one = adjusted(block, tmp_path / "whole", whole)
    for stop in (0.4, 0.9):
        folder = tmp_path / f"{stop}"
        with monkeypatch.context() as other:
            if first == "twins":
                without_kernels(other)
            with pytest.raises(KeyboardInterrupt):
                adjusted(block, folder, Counting(int(stop * len(whole.done))))
        with monkeypatch.context() as other:
            if first == "kernels":
                without_kernels(other)
            same(one, adjusted(block, folder, Serial()))
