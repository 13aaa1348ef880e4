"""Figures of docs/explanation/scale.md are those of the shipped constants and of benchmarks/results/scaling.json."""

import importlib
import json
from pathlib import Path

import pytest

import raybundle as rb
from raybundle.numerics.counting import grouped, significant

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/explanation/scale.md"
BEFORE = ("features", "choice of pairs", "matching", "tracks and start", "precision", "decisions", "report")
SHARES = "efficiency of the sweeps", "with the driver", "if the work were shared evenly"
SECONDS = "sweeps s", "fronts in tiles s", "what is made stays s", "no network s", "least for the store s"
DRIVER, FRONT = "memory of the driver", "memory of the largest front"


def figures():
    return json.loads((ROOT / "benchmarks/results/scaling.json").read_text())


def measured():
    """Rows of the estimate beside the measurement."""
    found = figures()["adjustment of 10000"]
    yield "| | estimated | measured | ratio |"
    yield "|---|---|---|---|"
    for name, of in found["stages"].items():
        yield f"| {name}, CPU s | {of['estimated s']:.1f} | {of['measured s']:.1f} | {of['ratio']:.2f} |"
    for name, words, digits in (
        ("CPU s", "all, CPU s", 0), ("peak MB", "peak memory, MB", 0), ("disk GB", "disk, GB", 1),
        ("moved GB", "bytes moved, GB", 0), ("leaves", "leaves", 0), ("largest front", "largest front, unknowns", 0),
    ):  # fmt: skip
        of = found[name]
        yield f"| {words} | {of['estimated']:.{digits}f} | {of['measured']:.{digits}f} | {of['ratio']:.2f} |"


def memory_of_features():
    """Rows of what a process takes that finds features."""
    found = json.loads((ROOT / "benchmarks/results/features_memory.json").read_text())
    yield "| megapixels | sharp, MB | with few features, MB | estimated, MB |"
    yield "|---|---|---|---|"
    for name in [n.removesuffix(", sharp") for n in found if n.endswith("sharp")]:
        sharp, soft = (found[f"{name}, {how}"] for how in ("sharp", "soft"))
        figures = sharp["MB after all"], soft["MB after all"], soft["reckoned with, MB"]
        yield row(name.removesuffix(" megapixels"), [significant(f, 3) for f in figures])


def before():
    """Rows of the stages before."""
    yield "| | estimated | measured | ratio |"
    yield "|---|---|---|---|"
    for name, of in figures()["stages before"]["stages"].items():
        yield f"| {name}, CPU s | {of['estimated']:.1f} | {of['measured']:.1f} | {of['ratio']:.2f} |"


def walls():
    """Rows of wall time."""
    yield "| workers | estimated wall, s | simulated, s | ratio |"
    yield "|---|---|---|---|"
    for w, of in figures()["wall time of 10000"].items():
        yield f"| {w} | {of['estimated']:.0f} | {of['measured']:.0f} | {of['ratio']:.2f} |"


def estimates(workers=1):
    """Estimates of the sizes that the page shows."""
    for images in (1000, 10_000, 100_000, 1_000_000):
        yield rb.estimate_cost(
            images=images, flight_overlap=(0.8, 0.6), points_per_image=8000, workers=workers, shipped=True, memory=64.0,
            disk=10_000.0,
        )  # fmt: skip


def row(words, values):
    return f"| {words} | {' | '.join(values)} |"


def sizes():
    """Rows of sizes."""
    found, many = list(estimates()), list(estimates(256))
    yield row("images", [grouped(e.asked.images) for e in found])
    yield "|---|---|---|---|---|"
    for words, of in (("photographs to start, and report", True), ("adjustment", False)):
        hours = [sum(s.cpu_s for s in e.stages if (s.name in BEFORE) == of) / 3600 for e in found]
        yield row(f"{words}, core hours", [significant(h, 3) for h in hours])
    for words, of in (("photographs to start, and report", True), ("adjustment", False)):
        hours = [sum(s.wall_s for s in e.stages if (s.name in BEFORE) == of) / 3600 for e in many]
        yield row(f"{words}, hours with 256 workers", [significant(h, 3) for h in hours])
    yield row("largest front, unknowns", [grouped(e.largest_front) for e in found])
    for what, words in (
        (FRONT, "memory of a process that adjusts, GB"), (DRIVER, "of the driver"),
        ("memory of tracks and start", "of tracks and start"), ("memory of precision", "of precision"),
        ("memory of the report", "of the report"),
    ):  # fmt: skip
        yield row(words, [significant(next(x.needed for x in e.limits if x.what == what), 3) for e in found])
    yield row("disk, GB", [significant(e.disk_gb, 3) for e in found])
    yield row("bytes moved, GB", [significant(e.moved_gb, 3) for e in found])


def breaks():
    """Rows of what gives way first."""
    yield "| images | too large, the worst first | needed, GB | there, GB |"
    yield "|---|---|---|---|"
    for e in estimates():
        over = [x for x in e.limits if x.share > 1]
        if not over:
            yield row(grouped(e.asked.images), ["nothing", "", ""])
        for x in over:
            yield row(grouped(e.asked.images), [x.what, significant(x.needed, 3), significant(x.given, 3)])


def workers():
    """Rows of many workers."""
    found = figures()["workers, from the tasks of 10000"]
    yield (
        "| images a worker | workers | images | efficiency | with the driver | evenly shared | sweeps, s | "
        "in tiles, s | what is made stays, s | without network, s | least for the store, s |"
    )
    yield "|---|---|---|---|---|---|---|---|---|---|---|"
    for load in ("160 images a worker", "640 images a worker"):
        for w, of in found[load].items():
            shares, seconds = [f"{of[n]:.2f}" for n in SHARES], [f"{of[n]:.0f}" for n in SECONDS]
            yield row(load.split()[0], [w, grouped(of["images"]), *shares, *seconds])


@pytest.mark.parametrize(
    "table", [measured, memory_of_features, before, sizes, breaks, workers, walls], ids=lambda t: t.__name__
)
def test_tables_of_the_page(table):
    text = PAGE.read_text()
    rows = "\n".join(table())
    assert rows in text, rows


def test_the_estimate_of_ten_thousand_is_within_thirty_per_cent():
    """Acceptance of the estimate: an adjustment of 10 000 images, out of core."""
    found = figures()["adjustment of 10000"]
    assert found["images"] == 10_000
    assert found["image points"] > 1e7
    for name in ("CPU s", "peak MB", "disk GB", "moved GB"):
        assert 0.7 < found[name]["ratio"] < 1.3, name


@pytest.fixture
def simulated(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "benchmarks"))
    return importlib.import_module("simulated_workers")


def test_simulated_workers_wait_share_a_line_and_each_other(simulated):
    job, took = simulated.Job, simulated.elapsed
    message = 4 * simulated.LATENCY
    chain = [job(seconds=1, read=0, written=0), job(seconds=2, read=0, written=0, waits=(0,))]
    assert took(chain, 8) == pytest.approx(3 + 2 * message)
    alone = job(seconds=1, read=simulated.WORKER, written=0)  # a second on its own line
    assert took([alone] * 8, 8) == pytest.approx(2 + message)
    assert took([alone] * 8, 4) == pytest.approx(2 * (2 + message))
    assert took([alone] * 40, 40) == pytest.approx(1 + 4 * (1 + 2 * simulated.LATENCY) + message / 2, rel=2e-2)


def test_tiles_do_the_work_of_the_front_and_hand_on_the_same_bytes(simulated):
    of = simulated.Sweep(
        task_s=0.0, point_us=0.0, element_ns=20.0, operation_ns=25.0, read_point=0.0, read_element=0.0,
        written_point=0.0, written_element=0.0,
    )  # fmt: skip
    size = simulated.Size(depth=1, count=1, own=70.0, boundary=200.0)
    whole = simulated.Job(seconds=5.0, read=0.0, written=0.0, waits=(0,))
    jobs = [simulated.Job(seconds=0, read=0, written=0)]
    last = simulated.in_tiles(jobs, whole, size, 1e6, of)
    tiles = simulated.PANELS * (simulated.PANELS + 1) // 2
    assert len(jobs) == 2 + simulated.PANELS + tiles
    assert len(last) == tiles
    assert sum(j.seconds for j in jobs) == pytest.approx(5.0)
    assert sum(jobs[k].written for k in last) == pytest.approx(simulated.message(size))
    alone, shared = (simulated.elapsed(jobs, w, worker=1e15, store=1e18) for w in (1, 64))
    assert shared < alone


def test_shares_of_stages_are_those_that_were_measured():
    found = json.loads((ROOT / "benchmarks/results/stage_shares.json").read_text())
    shipped = rb.estimate_cost(images=10, megapixels=1.0, shipped=True).constants
    for name in ("start", "precision"):
        assert getattr(shipped, f"{name}_shared") == pytest.approx(found[name]["share"], abs=5e-3)
