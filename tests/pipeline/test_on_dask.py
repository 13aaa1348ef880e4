"""Tasks on a cluster by Dask: the same bits, whoever dies meanwhile."""

import contextlib
import errno
import itertools
import json
import os
import random
import re
import signal
import socket
import subprocess
import sys
import threading
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.io.photos.photo import find_photos
from raybundle.matching.methods import feature_method
from raybundle.numerics.progress import Remark
from raybundle.pipeline.clusters import cluster_at, signature, token_of
from raybundle.pipeline.executors import Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from raybundle.ties.points import find_features, match_pairs
from raybundle.words import headline
from tests.barriers import DEADLINE_S, wait_for
from tests.messages import coded, printed, refused
from tests.pipeline.graph import NO_MATRIX, done_by, executions, tasks_of
from tests.pipeline.machines import Line, Machines, processes_of

pytest.importorskip("distributed", reason="the extra [cluster] is not installed")
pytestmark = pytest.mark.skipif(os.name == "nt", reason="processes are killed as on POSIX systems")
LEAVES = 16
PORTAL = Path(__file__).resolve().parents[2] / "demo_data/portal/photos"


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    store = Folder(tmp_path_factory.mktemp("store"))
    return done_by(Threads(1), tasks_of(LEAVES), store)


@pytest.fixture
def machines(tmp_path):
    found = Machines(tmp_path / "cluster")
    yield found
    found.close()


def on(folder, **more):
    from raybundle.pipeline.on_dask import Dask

    return Dask(cluster_at(str(folder)), **more)


def test_one_worker_and_the_ways_in_which_it_is_refused(machines, tmp_path, expected, monkeypatch):
    """One cluster for all of this: it takes seconds to begin."""
    machines.scheduler()
    machines.worker()
    store = Folder(tmp_path / "s")
    assert done_by(on(machines.folder), tasks_of(LEAVES), store) == expected
    # bad input, and errors
    tasks = tasks_of(4, crash={0: "bad input", 1: "some error"}, small=False)
    ended = {d.task.name: d.failed for d in on(machines.folder).run(tasks, Folder(tmp_path / "t/s"))}
    assert ended["leaf 0"].values == {"detail": NO_MATRIX}
    assert (ended["leaf 1"].code, ended["leaf 1"].values["n"]) == ("task.failed_repeatedly", 3)
    assert [d.values for d in ended["leaf 1"].details] == [{"kind": "RuntimeError", "detail": "some error"}]
    assert "some error" in (tmp_path / "t/failed-tasks.log").read_text()
    assert ended["node 4"].code == "task.needs_failed"
    assert not ended["node 5"]
    # tasks of which many go in one message
    assert done_by(on(machines.folder), tasks_of(LEAVES, cost=0.02), Folder(tmp_path / "m/s")) == expected
    # another folder under the same name
    other = Folder(tmp_path / "u" / "s")
    token = token_of(other)
    (other.path / "token").write_text("another")
    from raybundle.pipeline import on_dask

    hands = on_dask._Workers(cluster_at(str(machines.folder)), other, token, 30.0)
    try:
        monkeypatch.setattr("raybundle.pipeline.clusters.APPEAR_S", 0.0)
        found = on_dask._elsewhere([b""], str(other.path), "", token, False, ".")
        with pytest.raises(InputError, match=r"cluster\.worker_blind"):
            hands._checked(tasks[0], *found)
    finally:
        hands.client.close()
    # certificates of another cluster, or none
    foreign = machines.also_at(
        tmp_path / "foreign", json.loads((machines.folder / "scheduler.json").read_text())["address"]
    )
    for name in ("ca.pem", "cert.pem", "key.pem"):
        (foreign / name).unlink()
    with pytest.raises(InputError, match=r"ca\.pem.*cert\.pem.*key\.pem.*cluster\.certificates_missing"):
        on(foreign)
    from raybundle.pipeline.dask_machines import make_certificates

    make_certificates(foreign)
    with pytest.raises(InputError, match=r"cluster\.foreign_certificate"):
        list(on(foreign).run(tasks, store))
    (foreign / "ca.pem").write_bytes((machines.folder / "ca.pem").read_bytes())
    with pytest.raises(InputError, match=r"cluster\.certificate_refused"):
        list(on(foreign).run(tasks, store))
    monkeypatch.setattr("raybundle.pipeline.clusters.ANSWER_S", 1.0)
    with pytest.raises(InputError, match=r"cluster\.timeout"):
        list(on(f"tcp://127.0.0.1:{machines.port}").run(tasks, store))


def test_short_tasks_go_together_and_long_ones_by_themselves():
    from raybundle.pipeline.on_dask import MOST_TOGETHER, together

    tasks = [replace(t, cost=cost) for t, cost in zip(tasks_of(4), (0.4, 0.4, 0.4, 2.0, 0.1, 0.1), strict=False)]
    assert [len(m) for m in together(tasks)] == [2, 1, 1, 2]
    assert [t for m in together(tasks) for t in m] == tasks
    many = [replace(tasks[0], cost=0.0)] * (MOST_TOGETHER + 1)
    assert [len(m) for m in together(many)] == [MOST_TOGETHER, 1]
    assert together([]) == []


def test_a_worker_of_another_version_gets_nothing_and_is_named(machines, tmp_path, monkeypatch):
    machines.scheduler()
    machines.worker()
    monkeypatch.setattr("raybundle.pipeline.on_dask.signature", lambda: "raybundle 9.9 (000000000000)")
    there = {"version": "raybundle 9.9 (000000000000)", "others": [f"127.0.0.1: {signature()}"]}
    with refused("cluster.no_worker", n=1, **there):
        list(on(machines.folder, patience=3.0).run(tasks_of(2), Folder(tmp_path / "s")))
    facts, found = machines.folder / "scheduler.json", "raybundle 0.0.9 (123)"
    facts.write_text(json.dumps({**json.loads(facts.read_text()), "raybundle": found}))
    differs = printed("cluster.other_version", found=found, version=signature())
    with pytest.raises(AssertionError, match=re.escape(differs.splitlines()[0])):
        machines.worker()


@pytest.mark.long
def test_a_task_that_kills_its_worker_costs_itself_alone(machines, tmp_path):
    """Beside others in one message: each worker that dies takes all of them with it, and they are done again."""
    machines.scheduler()
    machines.worker()
    tasks = tasks_of(4, crash={2: "exit"}, small=False, cost=0.02)
    ended = {d.task.name: d.failed for d in on(machines.folder).run(tasks, Folder(tmp_path / "d/s"))}
    assert (ended["leaf 2"].code, ended["leaf 2"].values["n"]) == ("task.failed_repeatedly", 3)
    assert [d.code for d in ended["leaf 2"].details] == ["task.process_died"]
    assert not any(ended[name] for name in ("leaf 0", "leaf 1", "leaf 3"))


@pytest.mark.long
@pytest.mark.parametrize("workers", [2, 4])
def test_the_same_bits_with_so_many_workers(machines, tmp_path, expected, workers):
    machines.scheduler()
    machines.worker(jobs=workers)
    log = tmp_path / "log"
    tasks = tasks_of(LEAVES, log=log)
    assert done_by(on(machines.folder), tasks, Folder(tmp_path / "s")) == expected
    assert set(executions(log).values()) == {1}


@pytest.mark.long
def test_twenty_workers_that_are_killed_cost_the_tasks_in_work_alone(machines, tmp_path, expected):
    machines.scheduler()
    worker = machines.worker(jobs=2)
    log, kills, rng = tmp_path / "log", [], random.Random(1)
    left = 5  # tasks to be done before the next kill

    def kill():
        nonlocal left
        left -= 1
        alive = [p for p in processes_of(worker) if p.pid not in kills]
        if left <= 0 and alive:
            with contextlib.suppress(Exception):
                alive[0].kill()
                kills.append(alive[0].pid)
                left = rng.randint(6, 16)

    store, begun = Folder(tmp_path / "s"), np.zeros(2, int)
    while len(kills) < 20:
        tasks = tasks_of(LEAVES, log=log, seconds=0.3)
        for t in tasks:
            store.forget(t.key)
        begun += np.array([not t.small for t in tasks]).sum(), len(tasks)
        assert done_by(on(machines.folder), tasks, store, meanwhile=kill) == expected
    found = executions(log)
    # with each kill the task in work; and small numbers, which no store keeps, that were on their way to the driver
    assert sum(n for k, n in found.items() if int(k) < 10_000) <= begun[0] + len(kills)
    assert sum(found.values()) <= begun[1] + 2 * len(kills)


@pytest.mark.long
def test_a_scheduler_that_is_killed_is_told_and_what_is_finished_is_kept(machines, tmp_path, expected):
    scheduler = machines.scheduler()
    worker = machines.worker(jobs=2)
    log, store = tmp_path / "log", Folder(tmp_path / "p" / "s")
    tasks = tasks_of(LEAVES, log=log, seconds=0.3)
    running = on(machines.folder, patience=3.0).run(tasks, store)
    ended = [next(running).task.key for _ in range(5)]
    scheduler.kill()
    with pytest.raises(InputError, match=r"cluster\.connection_lost") as error:
        ended += [done.task.key for done in running]
    assert "cluster.connection_lost" in str(error.value)
    wait_for(lambda: not processes_of(worker), "workers end with their scheduler")
    kept = [t for t in tasks if not t.small and store.has(t.key)]
    assert len(kept) >= 3
    with pytest.raises(InputError, match=r"cluster\.no_answer"):
        list(on(machines.folder).run(tasks, store))
    # a new one elsewhere: the workers find it by themselves
    machines.scheduler()
    left = [t for t in tasks if t.small or not store.has(t.key)]
    small = {d.task.key: d.product for d in on(machines.folder).run(left, store) if d.task.small}
    from tests.pipeline.graph import digest

    assert digest(store, tasks, small) == expected
    large = {n: k for n, k in executions(log).items() if int(n) < 10_000}
    assert sum(large.values()) <= len(large) + 2
    assert worker.poll() is None


DRIVER = """
import sys
from pathlib import Path
from raybundle.pipeline.choosing import executor_for
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from tests.pipeline.graph import tasks_of
project = Project.open(Path(sys.argv[1]))
means = Means(project=project, executor=executor_for(sys.argv[3], 1, 1e9), progress=lambda *_: print("one", flush=True))
try:
    assert not means.do(tasks_of(16, log=Path(sys.argv[2]), seconds=0.3), "graph")
finally:
    project.close()
"""


@pytest.mark.bench
def test_ten_drivers_that_are_killed_go_on_with_nothing_lost(machines, tmp_path, expected):
    from tests.pipeline.test_faults import made

    machines.scheduler()
    machines.worker(jobs=2)
    words = [sys.executable, "-c", DRIVER, str(tmp_path / "p"), str(tmp_path / "log"), str(machines.folder)]
    kills = 0
    for _ in range(10):
        with subprocess.Popen(words, stdout=subprocess.PIPE, cwd=os.getcwd()) as driver:  # noqa: PTH109
            for _ in range(3):
                driver.stdout.readline()
            kills += driver.poll() is None
            driver.send_signal(signal.SIGKILL)
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
    assert kills >= 5
    assert made(tmp_path) == expected
    large = {n: k for n, k in executions(tmp_path / "log").items() if int(n) < 10_000}
    assert sum(large.values()) <= len(large) + 2 * kills


@pytest.mark.bench
def test_a_line_that_is_cut_between_worker_and_scheduler_costs_the_tasks_in_work(machines, tmp_path, expected):
    machines.scheduler()
    line = Line(machines.port)
    try:
        machines.worker(machines.also_at(tmp_path / "far", line.address))
        log, store, small = tmp_path / "log", Folder(tmp_path / "s"), {}
        tasks = tasks_of(LEAVES, log=log, seconds=0.1)
        for k, done in enumerate(on(machines.folder).run(tasks, store)):
            assert not done.failed
            small |= {done.task.key: done.product} if done.task.small else {}
            if k in {4, 11, 20}:
                line.cut()
                threading.Timer(1.5, lambda: setattr(line, "open", True)).start()
    finally:
        line.close()
    from tests.pipeline.graph import digest

    assert digest(store, tasks, small) == expected
    assert sum(executions(log).values()) <= len(tasks) + 3


def _ip(*words):
    subprocess.run(["ip", *words], check=True, capture_output=True)


@pytest.fixture
def namespace():
    """A network of its own with one line to this one: scheduler at 10.77.0.1, worker at 10.77.0.2."""
    name = f"rb{os.getpid() % 10000}"
    try:
        _ip("netns", "add", name)
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("network namespaces need root and iproute2")
    try:
        _ip("link", "add", f"{name}a", "type", "veth", "peer", "name", f"{name}b", "netns", name)
        _ip("addr", "add", "10.77.0.1/24", "dev", f"{name}a")
        _ip("link", "set", f"{name}a", "up")
        _ip("-n", name, "addr", "add", "10.77.0.2/24", "dev", f"{name}b")
        _ip("-n", name, "link", "set", f"{name}b", "up")
        _ip("-n", name, "link", "set", "lo", "up")
        yield name
    finally:
        _ip("netns", "del", name)


@pytest.mark.bench
def test_a_network_that_is_silent_for_a_while(machines, tmp_path, expected, namespace):
    """Nothing is refused and nothing comes back, as where a cable is pulled: for 20 s, and a worker beside goes on."""
    machines.scheduler(host="10.77.0.1")
    machines.worker(namespace=namespace)
    machines.worker()
    log, store, small = tmp_path / "log", Folder(tmp_path / "s"), {}
    tasks = tasks_of(LEAVES, log=log, seconds=0.3)
    for k, done in enumerate(on(machines.folder).run(tasks, store)):
        assert not done.failed
        small |= {done.task.key: done.product} if done.task.small else {}
        if k == 6:
            _ip("link", "set", f"{namespace}a", "down")
            threading.Timer(20, lambda: _ip("link", "set", f"{namespace}a", "up")).start()
    from tests.pipeline.graph import digest

    assert digest(store, tasks, small) == expected


@pytest.mark.long
@pytest.mark.skipif(not PORTAL.is_dir(), reason="demo_data/portal is part of the repository")
def test_features_and_pairs_of_photographs_are_those_of_this_process(machines, tmp_path):
    machines.scheduler()
    machines.worker(jobs=2)
    found = find_photos([PORTAL / f"portal_{k:02d}.jpg" for k in (2, 3, 4)]).photos
    method, products = feature_method("rootsift"), []
    for name, executor in (("here", Threads(2)), ("there", on(machines.folder))):
        project = Project.open(tmp_path / name)
        try:
            means = Means(project=project, executor=executor)
            store, failed = find_features(means, found, method, 500)
            pairs = match_pairs(means, found, store, method, [(0, 1), (0, 2), (1, 2)])
            assert not failed
            files = {k: project.products.place._path(k).read_bytes() for k in store.keys}
            products.append((files, [p.matches.tolist() for p in pairs]))
        finally:
            project.close()
    assert products[0] == products[1]


@pytest.mark.long
def test_a_worker_that_somebody_else_started_becomes_ours_by_a_preload(machines, tmp_path, expected):
    """As dask-jobqueue and dask-kubernetes start them; one without it gets nothing."""
    machines.scheduler()
    address = json.loads((machines.folder / "scheduler.json").read_text())["address"]
    ca, cert, key = (str(machines.folder / f"{name}.pem") for name in ("ca", "cert", "key"))
    words = [
        sys.executable, "-m", "distributed.cli.dask_worker", address, "--tls-ca-file", ca, "--tls-cert", cert,
        "--tls-key", key, "--nthreads", "1", "--nworkers", "1", "--no-dashboard", "--local-directory", str(tmp_path),
    ]  # fmt: skip
    env = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    silent = {"env": env, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    begun = [subprocess.Popen([*words, *more], **silent) for more in ([], ["--preload", "raybundle.pipeline.on_dask"])]
    try:
        assert done_by(on(machines.folder), tasks_of(LEAVES), Folder(tmp_path / "s")) == expected
    finally:
        for process in begun:
            process.terminate()
            process.wait()


def ended(folder, *words):
    """Exit status, and what a command says that ends by itself."""
    done = subprocess.run(
        [sys.executable, "-m", "raybundle", *map(str, words)], capture_output=True, text=True, timeout=DEADLINE_S,
        cwd=folder, check=False, env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])},
    )  # fmt: skip
    return done.returncode, done.stderr


def test_a_scheduler_that_cannot_be_says_why_and_leaves_nothing(machines, tmp_path):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        status, shown = ended(tmp_path, "scheduler", "new", "--host", "127.0.0.1", "--port", port)
    assert status == 2
    assert f"127.0.0.1, port {port} (" in shown
    assert os.strerror(errno.EADDRINUSE).lower() in shown.lower()
    assert not (tmp_path / "new").exists()
    (tmp_path / "old").mkdir()
    status, shown = ended(tmp_path, "scheduler", "old", "--host", "no-such-host.invalid")
    assert status == 2
    assert "no-such-host.invalid" in shown
    assert "[cluster.cannot_listen]" in shown
    assert not list((tmp_path / "old").iterdir())
    # a second one, where one answers
    machines.scheduler()
    facts = (machines.folder / "scheduler.json").read_text()
    status, shown = ended(tmp_path, "scheduler", machines.folder, "--host", "127.0.0.1")
    assert status == 2
    assert printed("cluster.second_scheduler", address=f"tls://127.0.0.1:{machines.port}") in shown
    assert (machines.folder / "scheduler.json").read_text() == facts


def test_certificates_that_are_none_or_over_are_named(tmp_path, capsys, monkeypatch):
    from raybundle.cli.main import main
    from raybundle.pipeline import clusters
    from raybundle.pipeline.dask_machines import make_certificates

    folder = tmp_path / "cluster"
    make_certificates(folder)
    (folder / "scheduler.json").write_text(json.dumps({"address": "tls://127.0.0.1:9", "raybundle": signature()}))
    words = [["scheduler", str(folder)], ["worker", "--cluster", str(folder)]]
    with monkeypatch.context() as later:
        day = clusters.dt.datetime.now(clusters.dt.UTC) + clusters.dt.timedelta(days=400)

        class Later(clusters.dt.datetime):
            @classmethod
            def now(cls, tz=None):
                del tz
                return day

        later.setattr(clusters.dt, "datetime", Later)
        for each in words:
            assert main(each) == 2
            assert "[cluster.certificates_expired]" in capsys.readouterr().err
    ca = (folder / "ca.pem").read_bytes()
    (folder / "ca.pem").write_bytes(b"")
    for each in words:
        assert main(each) == 2
        shown = capsys.readouterr().err
        assert "ca.pem: " in shown
        assert "[cluster.no_certificate]" in shown
    (folder / "ca.pem").write_bytes(ca)
    (folder / "key.pem").unlink()
    others, names = ["ca.pem", "cert.pem"], ["key.pem"]
    assert main(words[0]) == 2
    assert printed("cluster.certificates_incomplete", names=names) in capsys.readouterr().err
    assert main(words[1]) == 2
    assert printed("cluster.certificates_missing", names=names, others=others, n=2) in capsys.readouterr().err
    for name in others:
        (folder / name).unlink()
    assert main(words[1]) == 2  # what an earlier scheduler wrote stands there alone
    assert printed("cluster.certificates_missing", names=others + names, others=[], n=0) in capsys.readouterr().err


def test_a_worker_leaves_no_project_aside_and_waits_for_no_folder_without_end(tmp_path, capsys, monkeypatch):
    from raybundle.cli.main import main

    monkeypatch.setattr("raybundle.pipeline.dask_machines.FOLDER_S", 1.5)
    monkeypatch.setattr("raybundle.pipeline.dask_machines.LOOK_S", 0.1)
    seconds = itertools.count()  # one passes between two looks at the clock
    monkeypatch.setattr("raybundle.pipeline.dask_machines.time", SimpleNamespace(monotonic=lambda: next(seconds)))
    (tmp_path / "cluster").mkdir()
    assert main(["worker", str(tmp_path), "--cluster", str(tmp_path / "cluster")]) == 2
    assert printed("worker.project_of_cluster", project=str(tmp_path)) in capsys.readouterr().err
    none = tmp_path / "none"
    assert main(["worker", "--cluster", str(none)]) == 2
    out, err = capsys.readouterr()
    assert str(none) in out
    assert " 1.5 s" in out
    assert printed("cluster.no_folder", wait_s=1.5, folder=str(none)) in err
    assert not none.exists()


def test_a_run_says_that_it_waits_for_a_worker_and_a_worker_for_a_scheduler(machines, tmp_path, monkeypatch):
    monkeypatch.setattr("raybundle.pipeline.on_dask.SAY_S", 0.5)
    waits = headline("cluster.waits_for_scheduler", {})
    waiting = machines.command("worker", "--cluster", machines.folder, wait=waits)
    machines.scheduler()
    assert len(list(on(machines.folder).run(tasks_of(4), Folder(tmp_path / "s")))) == 11
    waiting.send_signal(signal.SIGTERM)
    waiting.wait(DEADLINE_S)
    waiting.reader.join(DEADLINE_S)
    assert "11 tasks" in waiting.stated[0]

    class Told(Exception):
        """That somebody is waited for."""

    def progress(text, share):
        if list(coded([text])) == ["cluster.no_fitting_worker", "cluster.waiting"]:
            assert coded([text])["cluster.no_fitting_worker"] == {"n": 0}
            assert isinstance(share, Remark)
            raise Told

    with pytest.raises(Told):
        list(on(machines.folder, progress=progress).run(tasks_of(2), Folder(tmp_path / "t")))
    with pytest.raises(InputError, match=r"cluster\.no_worker"):
        list(on(machines.folder, patience=0.0).run(tasks_of(2), Folder(tmp_path / "t")))
