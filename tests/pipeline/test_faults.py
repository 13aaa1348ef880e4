"""Tasks under faults on one machine: processes and drivers that are killed, full disks, cut products, interrupts."""

import json
import os
import random
import signal
import subprocess
import sys
from multiprocessing import active_children
from pathlib import Path

import pytest

from raybundle.numerics.progress import Counted
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from tests.messages import refused
from tests.pipeline.graph import digest, done_by, executions, tasks_of

LEAVES = 16
ROOT = Path(__file__).parents[2]

DRIVER = """
import json, os, signal, sys
from pathlib import Path
from raybundle.pipeline.executors import Processes
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from tests.pipeline.graph import tasks_of

def interrupted(number, frame):
    os.write(1, b"interrupted\\n")
    signal.default_int_handler(number, frame)

if __name__ == "__main__":
    signal.signal(signal.SIGINT, interrupted)
    project = Project.open(Path(sys.argv[1]))
    means = Means(project=project, executor=Processes(2), progress=lambda w, s: print(json.dumps([w, s]), flush=True))
    gate, free = (Path(sys.argv[5]), int(sys.argv[6])) if len(sys.argv) > 5 else (None, 0)
    tasks = tasks_of(int(sys.argv[3]), log=Path(sys.argv[2]), seconds=float(sys.argv[4]), gate=gate, free=free)
    print("begun", flush=True)
    try:
        failed = means.do(tasks, "graph")
    finally:
        project.close()
    sys.exit(len(failed))
"""


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    """What an undisturbed run in this process makes."""
    store = Folder(tmp_path_factory.mktemp("store"))
    return done_by(Threads(1), tasks_of(LEAVES), store)


def begun(tmp_path, seconds, *gate, **more):
    program = tmp_path / "driver.py"
    program.write_text(DRIVER)
    return subprocess.Popen(
        [sys.executable, str(program), str(tmp_path / "p"), str(tmp_path / "log"), str(LEAVES),
         str(seconds), *map(str, gate)],
        stdout=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": str(ROOT)}, **more,
    )  # fmt: skip


def made(tmp_path):
    """The digest of what lies in a project."""
    tasks = tasks_of(LEAVES)
    project = Project.open(tmp_path / "p")
    try:
        return digest(project.products, tasks, project.small([t.key for t in tasks if t.small]))
    finally:
        project.close()


@pytest.mark.parametrize("executor", [Threads(3), Processes(1), Processes(2)], ids=str)
def test_the_same_bits_whoever_does_them(tmp_path, expected, executor):
    assert done_by(executor, tasks_of(LEAVES), Folder(tmp_path / "s")) == expected


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="there is no kill -9 here")
@pytest.mark.parametrize("most", [2, pytest.param(20, marks=pytest.mark.long)])
def test_processes_that_are_killed_cost_the_tasks_in_work_alone(tmp_path, expected, most):
    log, kills, rng = tmp_path / "log", [], random.Random(3)
    left = (
        3  # tasks to be done before a kill: who is killed again before others are done is guilty for all that is known
    )

    def kill():
        nonlocal left
        left -= 1
        children = active_children()
        if left <= 0 and len(kills) < most and children:
            child = rng.choice(children)
            child.kill()
            child.join()
            kills.append(child.pid)
            left = rng.randint(2, 3)

    tasks = tasks_of(LEAVES, log=log, seconds=0.05)
    assert done_by(Processes(2), tasks, Folder(tmp_path / "s"), meanwhile=kill) == expected
    assert len(kills) >= min(most, 8)
    # a broken pool ends both of its processes
    assert sum(executions(log).values()) <= len(tasks) + 2 * len(kills)


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="there is no kill -9 here")
def test_a_task_that_kills_its_process_is_told_from_those_beside_it(tmp_path):
    tasks = tasks_of(4, crash={2: "exit"}, small=False)
    ended = {d.task.name: d.failed for d in Processes(2).run(tasks, Folder(tmp_path / "s"))}
    assert (ended["leaf 2"].code, ended["leaf 2"].values["n"]) == ("task.failed_repeatedly", 3)
    assert [d.code for d in ended["leaf 2"].details] == ["task.process_died"]
    assert ended["node 5"].details == (ended["leaf 2"],)
    assert not any(ended[name] for name in ("leaf 0", "leaf 1", "leaf 3", "node 4"))


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="there is no kill -9 here")
def test_a_driver_that_is_killed_goes_on_with_nothing_lost(tmp_path, expected):
    kills = 3
    for k in range(kills):
        with begun(tmp_path, 0.05, tmp_path / "gate", 4 * (k + 1)) as driver:  # it can do four tasks more, and no other
            assert all(driver.stdout.readline() for _ in range(4))
            driver.kill()
            driver.stdout.read()  # to its end: its processes do not outlive it
    with begun(tmp_path, 0.0) as driver:
        driver.communicate()
    assert driver.returncode == 0
    assert made(tmp_path) == expected
    # of each killed driver the two tasks in work, and small products of the last two seconds
    again = sum(n - 1 for name, n in executions(tmp_path / "log").items() if int(name) < 10_000)
    assert again <= 2 * kills


@pytest.mark.skipif(os.name == "nt", reason="an interrupt is sent as a signal")
def test_an_interrupt_keeps_what_is_finished(tmp_path, expected):
    gate = tmp_path / "gate"
    with begun(tmp_path, 0.0, gate, 4, stderr=subprocess.PIPE) as driver:
        for _ in range(3):  # tasks without a gate are done, the others wait
            driver.stdout.readline()
        driver.send_signal(signal.SIGINT)
        while driver.stdout.readline() != "interrupted\n":
            assert driver.poll() is None
        gate.touch()
        _, told = driver.communicate()
    assert driver.returncode != 0
    assert told.rstrip().endswith("KeyboardInterrupt")  # of this driver's own; its processes say nothing
    assert "Process Spawn" not in told
    before = executions(tmp_path / "log")
    with begun(tmp_path, 0.0) as driver:
        said, _ = driver.communicate()
    assert driver.returncode == 0
    assert made(tmp_path) == expected
    large = {n for n in before if int(n) < 10_000}
    assert large
    assert all(executions(tmp_path / "log")[n] == 1 for n in large)
    assert json.loads(said.splitlines()[-1]) == ["graph", 1.0]


@pytest.mark.parametrize("executor", [Threads(2), Processes(2)], ids=str)
def test_products_that_were_damaged_are_made_again_in_the_same_run(tmp_path, expected, executor):
    """Leaves are altered, which only a reader notices, or cut."""
    tasks = tasks_of(LEAVES)
    leaves, rest = tasks[:LEAVES], tasks[LEAVES:]
    project = Project.open(tmp_path / "p")
    try:
        means = Means(project=project, executor=executor)
        assert means.do(leaves, "leaves") == {}
        for k, t in enumerate(leaves[:6]):
            path = project.products.place._path(t.key)
            data = bytearray(path.read_bytes())
            data[len(data) // 2] ^= 255
            path.write_bytes(data[:-30] if k % 2 else data)
        told = []
        means.progress = lambda what, share: told.append((what, share.done, share.total, share.seconds_left))
        assert means.do(rest, "rest") == {}
        small = {t.key: means.small(t.key) for t in rest if t.small}
        assert digest(project.products, tasks, small) == expected
        assert [t[1:3] for t in told] == [(k + 1, len(rest)) for k in range(len(rest))]
        assert told[-1][3] == 0.0
    finally:
        project.close()


def test_a_full_disk_says_what_to_do_and_the_same_run_goes_on(tmp_path, expected):
    disk = tmp_path / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=256k", "none", disk], check=False).returncode:
        pytest.skip("no small disk can be made here")
    try:
        store = Folder(disk / "cache")
        with refused("project.not_writable", cause="full"):
            list(Processes(2).run(tasks_of(LEAVES), store))
        assert not list(disk.rglob(".*"))
        subprocess.run(["mount", "-o", "remount,size=64m", disk], check=True)
        assert done_by(Processes(2), tasks_of(LEAVES), store) == expected
    finally:
        subprocess.run(["umount", "-l", disk], check=True)


def test_a_share_that_is_counted_is_a_share():
    share = Counted(0.25, 1, 4, 30.0)
    assert (share, share.done, share.total, share.seconds_left) == (0.25, 1, 4, 30.0)
    assert min(max(share, 0.0), 1.0) == 0.25
    assert round(share, 1) == 0.2


def test_what_was_done_before_counts_as_done(tmp_path):
    project = Project.open(tmp_path / "p")
    told = []
    try:
        tasks = tasks_of(4, small=False)
        means = Means(project=project, executor=Threads(1), progress=lambda _, s: told.append((s.done, s.total)))
        means.do(tasks[:4], "leaves")
        means.do(tasks, "all")
    finally:
        project.close()
    assert told == [(1, 4), (2, 4), (3, 4), (4, 4), (5, 7), (6, 7), (7, 7)]
