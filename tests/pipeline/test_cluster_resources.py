"""Workers that are awaited, the memory that they announce, the CPU time that they report, and Dask's own pages."""

import importlib.util
import json
import os
import socket
import subprocess
import sys
from dataclasses import replace
from types import SimpleNamespace
from urllib.request import urlopen

import pytest

from raybundle.errors import code_of
from raybundle.numerics.progress import Remark
from raybundle.pipeline.choosing import await_workers
from raybundle.pipeline.clusters import cluster_at, signature
from raybundle.pipeline.executors import Processes, Threads
from raybundle.pipeline.processor_time import cpu_seconds
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from tests.barriers import wait_for
from tests.messages import refused
from tests.pipeline.graph import done_by, executions, tasks_of
from tests.pipeline.machines import Machines, end

pytest.importorskip("distributed", reason="the extra [cluster] is not installed")
pytestmark = pytest.mark.skipif(os.name == "nt", reason="processes are killed as on POSIX systems")
LEAVES = 8
PLAIN_WORKER = """
import asyncio, sys
from distributed import Security, Worker
async def work(address, ca, cert, key, resource):
    security = Security(require_encryption=True, tls_ca_file=ca, tls_worker_cert=cert, tls_worker_key=key)
    async with Worker(address, nthreads=1, security=security, resources={resource: 1}, dashboard=False) as worker:
        print("worker of", address, flush=True)
        await worker.finished()
if __name__ == "__main__":
    asyncio.run(work(*sys.argv[1:]))
"""
"""A worker as Dask starts one, which offers our version and announces no memory."""


@pytest.fixture
def machines(tmp_path):
    found = Machines(tmp_path / "cluster")
    yield found
    found.close()


def on(folder, **more):
    from raybundle.pipeline.on_dask import Dask

    return Dask(cluster_at(str(folder)), **more)


def worker_with(machines, gigabytes, jobs=1):
    return machines.command(
        "worker", "--cluster", machines.folder, "--jobs", jobs, "--memory", gigabytes, wait="worker of tls://"
    )


def worker_of_dask(machines):
    files = [machines.folder / name for name in ("ca.pem", "cert.pem", "key.pem")]
    address = json.loads((machines.folder / "scheduler.json").read_text())["address"]
    process = subprocess.Popen(
        [sys.executable, "-c", PLAIN_WORKER, address, *map(str, files), signature()], stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, text=True, start_new_session=True,
    )  # fmt: skip
    machines.running.append(process)
    assert "worker of" in process.stdout.readline()
    return process


def remarks_of(run):
    """Codes of the remarks of what is done with a progress."""
    found = []
    run(lambda what, at: found.append(code_of(what)) if isinstance(at, Remark) else None)
    return found


def test_workers_are_awaited_and_their_number_is_named(machines, tmp_path):
    machines.scheduler()
    where = str(machines.folder)
    with refused("cluster.too_few_workers", n=0, wanted=1, wait_s=0.5, others=[], differing=0):
        await_workers(where, 1, 0.5)
    worker_with(machines, 1)
    await_workers(where, 1, 0.5)
    heard = []
    progress = lambda what, at: heard.append((code_of(what), type(at)))  # noqa: E731
    with refused("cluster.too_few_workers", n=1, wanted=3, wait_s=1.0, others=[], differing=0):
        await_workers(where, 3, 1.0, progress)
    assert heard[0] == ("cluster.workers_awaited", Remark)
    await_workers("", 0, 1.0)
    for nobody in ("", "shards"):
        with refused("cluster.nothing_awaited"):
            await_workers(nobody, 1, 1.0)
    # one of another version does not count
    from raybundle.pipeline import on_dask

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(on_dask, "signature", lambda: "raybundle 9.9 (0)")
        others = [f"127.0.0.1: {signature()}"]
        with refused("cluster.too_few_workers", n=0, wanted=1, wait_s=0.5, others=others, differing=1):
            await_workers(where, 1, 0.5)


def test_a_task_goes_where_its_memory_is_and_a_killed_worker_loses_nothing(machines, tmp_path):
    """The large worker alone may take the leaves; when it is killed, the small one takes them, as nobody else can."""
    machines.scheduler()
    log, gate = tmp_path / "log", tmp_path / "gate"
    expected = done_by(Threads(1), tasks_of(LEAVES), Folder(tmp_path / "here"))
    tasks = [
        replace(t, memory=3e9 if t.name.startswith("leaf") else 0.0)
        for t in tasks_of(LEAVES, log=log, gate=gate, free=2)
    ]
    large, small = worker_with(machines, 4), worker_with(machines, 2, jobs=2)
    await_workers(str(machines.folder), 3, 60.0)
    killed = []

    def meanwhile():
        if not killed:
            wait_for(lambda: len(log.read_text().splitlines()) >= 3, "the first leaf waits for the gate")
            killed.append({line.split()[1] for line in log.read_text().splitlines()[:3]})
            end(large)
            machines.running.remove(large)
            gate.touch()

    store = Folder(tmp_path / "store")
    found = remarks_of(
        lambda progress: killed.append(done_by(on(machines.folder, progress=progress), tasks, store, meanwhile))
    )
    processes, digest = killed
    assert digest == expected
    assert len(processes) == 1, "leaves were begun by the large worker alone"
    assert "cluster.workers_lost" in found
    assert "cluster.memory_short" in found
    assert all(n <= 2 for n in executions(log).values())
    assert small.poll() is None


def test_workers_that_announce_no_memory_are_not_asked_for_it(machines, tmp_path):
    machines.scheduler()
    expected = done_by(Threads(1), tasks_of(LEAVES), Folder(tmp_path / "here"))
    tasks = [replace(t, memory=3e9) for t in tasks_of(LEAVES)]
    worker_of_dask(machines)
    digests = []

    def run(progress):
        dask = on(machines.folder, progress=progress)
        digests.extend(done_by(dask, tasks, Folder(tmp_path / name)) for name in ("a", "b"))

    assert remarks_of(run) == ["cluster.memory_unknown"], "once, for both lists of tasks"
    assert digests == [expected, expected]


def test_a_preloaded_worker_announces_the_limit_of_dask(monkeypatch):
    from raybundle.pipeline.on_dask import MEMORY, dask_setup

    def announced(limit, **given):
        state = SimpleNamespace(total_resources=dict(given), available_resources=dict(given))
        dask_setup(SimpleNamespace(state=state, memory_manager=SimpleNamespace(memory_limit=limit)))
        assert state.total_resources == state.available_resources
        return state.total_resources

    assert announced(8e9) == {signature(): 1, MEMORY: 8e9}
    assert announced(None) == {signature(): 1}
    assert announced(8e9, memory=2e9) == {signature(): 1, MEMORY: 2e9}


def burnt(executor, folder):
    """CPU seconds that a stage states whose tasks take 0.3 s each."""
    project = Project.open(folder)
    try:
        tasks = tasks_of(4, burn=0.3)
        with project.stage("work"):
            assert not Means(project=project, executor=executor).do(tasks, "work")
        return project.records[0].cpu_seconds
    finally:
        project.close()


def test_cpu_time_is_that_of_all_who_did_tasks(machines, tmp_path):
    least = 4 * 0.3
    before = cpu_seconds()
    threads = burnt(Threads(2), tmp_path / "threads")
    assert least <= threads < least + 2.0
    assert cpu_seconds() - before == pytest.approx(threads, abs=0.5)
    assert least <= burnt(Processes(2), tmp_path / "processes") < least + 10.0  # which take some to begin
    machines.scheduler()
    machines.worker()
    assert least <= burnt(on(machines.folder), tmp_path / "dask") < least + 5.0


def test_dasks_own_pages_are_shown_where_they_are_asked_for(machines, tmp_path):
    from raybundle.pipeline.dask_machines import schedule

    for given in ("here", ":8787", "host:port", "70000"):
        with refused("cluster.dashboard_address", given=given):
            schedule(tmp_path / "c", "127.0.0.1", 0, print, given)
    if importlib.util.find_spec("bokeh") is None:
        with refused("cluster.dashboard_package", package="bokeh"):
            schedule(tmp_path / "c", "127.0.0.1", 0, print, "0")
        assert not (tmp_path / "c").exists()
        pytest.skip("bokeh is not installed")
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    process = machines.command(
        "scheduler", machines.folder, "--host", "127.0.0.1", "--dashboard", port, wait="scheduler: tls://"
    )
    page = f"http://127.0.0.1:{port}/status"
    assert urlopen(page).status == 200
    end(process)
    machines.running.remove(process)
    assert process.stated == [f" dashboard: {page}\n"]
