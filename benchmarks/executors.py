"""What handing tasks over costs, and keeping their products: processes beside Dask, archives beside those of np.savez.

    python benchmarks/executors.py [--products 10000] [--empty 2000] [--long 40] [--many 100000] [--quick]

Two workers each.  Engines are compared by the time that passes, on a machine that does nothing else; archives by CPU
seconds, medians of five.  `--many`: peak memory of a driver that hands over so many empty tasks.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
import zipfile
from collections.abc import Callable
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.pipeline.clusters import cluster_at
from raybundle.pipeline.executors import Processes
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task

HERE = Path(__file__).resolve().parent


@dataclass(frozen=True, slots=True, kw_only=True)
class Busy:
    """Options of a task."""

    number: int
    cpu_s: float = 0.0


def busy(store: Folder, options: Busy):
    """Use the processor for so long; a small product."""
    del store
    end = time.process_time() + options.cpu_s
    while time.process_time() < end:
        pass
    return {"number": np.array(options.number), "matches": np.zeros((0, 2), np.int32)}


def tasks_of(count: int, cpu_s: float) -> list[Task]:
    return [
        Task(
            key=key_of("busy", k, count, cpu_s), function="executors:busy", options=Busy(number=k, cpu_s=cpu_s),
            small=True,
        )
        for k in range(count)
    ]  # fmt: skip


@contextmanager
def cluster(folder: Path, workers: int = 2):
    """A scheduler and some workers on this machine."""
    env = {**os.environ, "PYTHONPATH": str(HERE)}
    program = [sys.executable, "-m", "raybundle"]
    words = [
        [*program, "scheduler", str(folder), "--host", "127.0.0.1"],
        [*program, "worker", "--cluster", str(folder), "--jobs", str(workers)],
    ]
    running = []
    try:
        for command in words:
            running.append(subprocess.Popen(command, env=env, stdout=subprocess.PIPE))
            running[-1].stdout.readline()
        for _ in range(workers - 1):  # the other workers
            running[-1].stdout.readline()
        yield
    finally:
        for process in reversed(running):
            process.terminate()
            process.wait()


def wall_s(executor, tasks: list[Task], folder: Path) -> float:
    began = time.perf_counter()
    assert not any(d.failed for d in executor.run(tasks, Folder(folder / "cache")))
    return time.perf_counter() - began


def engines(empty: int, long: int, folder: Path) -> dict[str, float]:
    """Time of empty tasks, and of some of a second, by both."""
    from raybundle.pipeline.on_dask import Dask

    found: dict[str, float] = {}
    with cluster(folder / "cluster"):
        both = {"processes": Processes(2), "dask": Dask(cluster_at(str(folder / "cluster")))}
        for name, executor in both.items():
            wall_s(executor, tasks_of(4, 0.0), folder)
            found[f"{name}: ms an empty task"] = wall_s(executor, tasks_of(empty, 0.0), folder) / empty * 1e3
        times: dict[str, list[float]] = {name: [] for name in both}
        for _ in range(3):  # alternately
            for name, executor in both.items():
                times[name].append(wall_s(executor, tasks_of(long, 1.0), folder))
        for name, seconds in times.items():
            found[f"{name}: s for {long} tasks of 1 s"] = statistics.median(seconds)
        found["dask over processes"] = statistics.median(
            d / p for d, p in zip(times["dask"], times["processes"], strict=True)
        )
    return found


MANY = """
import sys; sys.path.insert(0, sys.argv[1])
import resource
from pathlib import Path
from executors import tasks_of
from raybundle.pipeline.clusters import cluster_at
from raybundle.pipeline.on_dask import Dask
from raybundle.pipeline.store import Folder
count = sum(1 for d in Dask(cluster_at(sys.argv[2])).run(tasks_of(int(sys.argv[4]), 0.0), Folder(Path(sys.argv[3]))))
print(count, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""


def many(count: int, folder: Path) -> dict[str, float]:
    """Peak memory of a driver with many tasks."""
    with cluster(folder / "cluster"):
        began = time.perf_counter()
        said = subprocess.run(
            [sys.executable, "-c", MANY, str(HERE), str(folder / "cluster"), str(folder / "many"), str(count)],
            check=True, capture_output=True, text=True,
        )  # fmt: skip
    done, kilobytes = map(int, said.stdout.split())
    assert done == count
    return {
        f"driver of {count} tasks: MB": kilobytes / 1024,
        f"driver of {count} tasks: ms each": (time.perf_counter() - began) / count * 1e3,
    }


def cpu_s(function: Callable[[], object]) -> float:
    """Median CPU seconds of five."""
    taken = []
    for _ in range(5):
        before = resource.getrusage(resource.RUSAGE_SELF)
        function()
        after = resource.getrusage(resource.RUSAGE_SELF)
        taken.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return statistics.median(taken)


def archives(count: int, folder: Path) -> dict[str, float]:
    """Ours beside archives of np.savez, which say by their check sums alone whether they are whole."""
    rng = np.random.default_rng(1)
    product = {"xy": rng.normal(size=(500, 2)), "scale": rng.normal(size=500), "words": rng.bytes(100)}
    product["words"] = np.frombuffer(product["words"], np.uint8)
    store, plain = Folder(folder / "ours"), folder / "plain"
    keys = [key_of("features", k) for k in range(count)]

    def path(key: str) -> Path:
        return plain / key[-2:] / f"{key}.npz"

    def write() -> None:
        for key in keys:
            path(key).parent.mkdir(parents=True, exist_ok=True)
            np.savez(path(key), **product, __key__=np.array(key))

    def whole() -> None:
        for key in keys:
            with zipfile.ZipFile(path(key)) as file:
                assert file.testzip() is None

    def read() -> None:
        for key in keys:
            with np.load(path(key)) as file:
                assert str(file["__key__"]) == key
                assert len(file["xy"]) == len(file["scale"])

    found = {}
    for name, ours, theirs in (
        ("write", lambda: [store.store(k, product) for k in keys], write),
        ("has", lambda: [store.has(k) for k in keys], whole),
        ("read two arrays", lambda: [store.load(k, ["xy", "scale"]) for k in keys], read),
        ("map two arrays", lambda: [store.mapped(k, ["xy", "scale"]) for k in keys], read),
    ):
        found |= {f"{count} products, {name}: CPU s": cpu_s(ours), f"{count} products, {name}: np.savez": cpu_s(theirs)}
    large = {"a": rng.normal(size=25_000_000), "b": rng.normal(size=100)}
    (key,) = keys = [key_of("large", 1)]
    product = large
    store.store(key, large)
    write()
    part = slice(1_000_000, 1_100_000)

    def small_part_of(all_of: Callable[[], np.ndarray]) -> Callable[[], float]:
        return lambda: float(all_of()[part].sum())

    for name, ours, theirs in (
        ("write", lambda: store.store(key, large), write),
        ("has", lambda: store.has(key), whole),
        ("the other array", lambda: store.load(key, ["b"]), lambda: np.load(path(key))["b"]),
        (
            "a slice",
            small_part_of(lambda: store.mapped(key, ["a"])["a"]),
            small_part_of(lambda: np.load(path(key))["a"]),
        ),
    ):
        found |= {f"200 MB, {name}: CPU s": cpu_s(ours), f"200 MB, {name}: np.savez": cpu_s(theirs)}
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--products", type=int, default=10_000)
    parser.add_argument("--empty", type=int, default=2000)
    parser.add_argument("--long", type=int, default=40)
    parser.add_argument("--many", type=int, default=100_000)
    parser.add_argument("--only", choices=["archives", "engines", "many"])
    asked = parser.parse_args()
    folder = Path(tempfile.mkdtemp(prefix="executors-"))
    sys.path.insert(0, str(HERE))
    os.environ["PYTHONPATH"] = str(HERE)
    found: dict[str, float] = {}
    try:
        if asked.only in {None, "archives"}:
            found |= archives(asked.products, folder)
        if asked.only in {None, "engines"}:
            found |= engines(asked.empty, asked.long, folder)
        if asked.only in {None, "many"}:
            found |= many(asked.many, folder)
    finally:
        shutil.rmtree(folder)
    for name, value in found.items():
        print(f"{name:50} {value:10.4g}")
    print(json.dumps(found))


if __name__ == "__main__":
    main()
