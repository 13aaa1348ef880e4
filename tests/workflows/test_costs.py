"""What an adjustment of a given size takes: sizes of parts, constants, formulas, the command."""

import json
import re
from dataclasses import replace
from pathlib import Path

import msgspec
import numpy as np
import pytest
from PIL import Image

import raybundle as rb
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.blocking.columns import InFiles
from raybundle.blocking.memory import Serial
from raybundle.blocking.network import cut
from raybundle.blocking.stored import adjust_columns
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.pipeline.store import Folder
from raybundle.workflows.costs import constants, measure, photographs
from raybundle.workflows.costs.adjustment import KINDS, adjustment, parts_of, task_of
from raybundle.workflows.costs.cutting import cut_flight
from raybundle.workflows.costs.estimate import estimate
from raybundle.workflows.costs.recording import TaskRecord
from raybundle.workflows.costs.stages import Asked
from tests.blocking.networks import flight
from tests.cli.reported import reported, values_of
from tests.messages import refused

C = constants.shipped()
DRIVER, FRONT, PRECISION = "memory of the driver", "memory of the largest front", "memory of precision"
"""Identifiers of limits."""
A = Asked(
    images=10_000, megapixels=20.0, overlap=12.5, image_points=1139.0, iterations=6, workers=1, memory_gb=8.0,
    network_gbit=1.0, store_gbit=10.0, latency_ms=0.5,
)  # fmt: skip


def test_parts_hold_every_image_and_image_point():
    for images, overlap in ((50, 12.5), (10_000, 12.5), (1_000_000, 6.0)):
        sizes = cut_flight(images, overlap, 1000.0)
        assert sum(s.count * s.own for s in sizes) == pytest.approx(images)
        assert sum(s.count * s.points for s in sizes) == pytest.approx(1000.0 * images)
        assert [s.depth for s in sizes] == sorted(s.depth for s in sizes)
        below = np.zeros(len(sizes))
        for s in sizes:
            for half in s.halves:
                below[half] += s.count
        assert below[1:].tolist() == [s.count for s in sizes[1:]]


def test_what_hangs_together_too_closely_is_not_cut():
    (only,) = cut_flight(300, 300.0, 1000.0)
    assert only.leaf
    assert only.columns == pytest.approx(6 * 300 + 8)


@pytest.mark.parametrize(("images", "overlap", "leaf"), [((10, 40), (0.75, 0.4), 300), ((16, 16), (0.8, 0.6), 300)])
def test_parts_are_those_of_a_flight_that_is_cut(images, overlap, leaf, monkeypatch):
    """Within a third: leaves, largest front, and what all fronts hold."""
    strips, each = images
    plan = replace(measure.AerialStrips(), forward_overlap=overlap[0], side_overlap=overlap[1])
    monkeypatch.setattr(measure, "AerialStrips", lambda **given: replace(
        plan, **{n: v for n, v in given.items() if "overlap" not in n}
    ))  # fmt: skip
    block = measure.made_flight(strips, each, 60)
    free = {block.cameras[0].id: measure.FREE}
    network = cut(block, AdjustmentOptions(jobs=1), free, np.zeros(len(block.observations), bool), leaf)
    size = np.array([f.size for f in network.fronts], float)
    shown = 1 / ((1 - overlap[0]) * (1 - overlap[1]))
    sizes = cut_flight(strips * each, shown, 60.0, leaf=leaf)
    leaves = sum(not c for c in network.tree.children)
    assert 2 / 3 < sum(s.count for s in sizes if s.leaf) / leaves < 3 / 2
    assert 2 / 3 < max(s.columns + s.rows for s in sizes) / size.max() < 3 / 2
    assert 2 / 3 < sum(s.count * (s.columns + s.rows) ** 2 for s in sizes) / (size**2).sum() < 3 / 2


def test_cpu_time_is_that_of_the_formulas_and_not_of_the_workers():
    sizes = parts_of(A)
    one, many = (adjustment(replace(A, workers=w), C, sizes) for w in (1, 64))
    assert [s.cpu_s for s in one] == [s.cpu_s for s in many]
    up = one[1]
    works = [task_of(s, "up", C.up) for s in sizes]
    tasks = 7 * sum(s.count for s in sizes)
    assert up.tasks == tasks
    assert up.cpu_s == pytest.approx(7 * sum(w.count * w.cpu_s for w in works) + 1e-3 * C.driver_task_ms * tasks)
    assert sum(s.wall_s for s in one) == pytest.approx(sum(s.cpu_s for s in one))
    for a, b in zip(one[1:], many[1:], strict=True):
        assert a.wall_s / 64 < b.wall_s < a.wall_s
    assert one[0].wall_s == many[0].wall_s == many[0].serial_s  # what the driver does alone


def test_a_slow_store_takes_longer_and_no_network_none():
    walls = [
        sum(s.wall_s for s in adjustment(replace(A, workers=64, network_gbit=n, store_gbit=g), C, parts_of(A)))
        for n, g in ((0.0, 10.0), (1.0, 100.0), (1.0, 1.0))
    ]
    assert walls[0] < walls[1] < walls[2]


def test_the_estimate_is_near_a_measured_adjustment():
    """Ten thousand images, by the figures of benchmarks/scaling.py, and the constants that come with the package."""
    path = Path(__file__).parents[2] / "benchmarks/results/scaling.json"
    found = json.loads(path.read_text())["adjustment of 10000"]
    a = replace(A, image_points=found["image points"] / 10_000, iterations=found["iterations"], memory_gb=1.0)
    stages = adjustment(a, C, parts_of(a))
    assert sum(s.cpu_s for s in stages) == pytest.approx(found["CPU s"]["measured"], rel=0.3)
    assert max(s.memory_mb for s in stages) == pytest.approx(found["peak MB"]["measured"], rel=0.3)
    assert sum(s.disk_gb for s in stages) == pytest.approx(found["disk GB"]["measured"], rel=0.3)


def test_start_decisions_and_report_are_near_the_records():
    """Within 30 %: few image points of up to 8000 photographs, and many of few."""
    results = Path(__file__).parents[2] / "benchmarks/results"
    stages = {
        "start, parts": (photographs.start,),
        "adjustment": (photographs.decisions,),
        "results and report": (photographs.results,),
    }
    for of in json.loads((results / "stages_at_size.json").read_text())["rows"]:
        a = replace(A, images=of["images"], image_points=of["image points"] / of["images"])
        for name, (stage,) in stages.items():
            measured = of["stages"][name]
            own = adjustment(a, C, parts_of(a)) if name == "adjustment" else ()
            assert stage(a, C).cpu_s + sum(s.cpu_s for s in own) == pytest.approx(measured["cpu_s"], rel=0.3), of
            if name != "results and report":  # its record holds connections as a square of the photographs
                assert stage(a, C).memory_mb == pytest.approx(measured["peak_mb"], rel=0.3), of
    of = json.loads((results / "many_images.json").read_text())["many_images"]
    a = replace(A, images=of["photographs"], image_points=of["observations"] / 2 / of["photographs"])
    measured = {s["name"]: s for s in of["stages"]}
    start, decided = photographs.start(a, C), photographs.decisions(a, C)
    assert start.cpu_s == pytest.approx(measured["start"]["cpu_seconds"], rel=0.3)
    assert start.memory_mb == pytest.approx(measured["start"]["peak_memory_mb"], rel=0.3)
    cpu_s = decided.cpu_s + sum(s.cpu_s for s in adjustment(a, C, parts_of(a)))
    assert cpu_s == pytest.approx(measured["adjustment"]["cpu_seconds"], rel=0.3)
    assert decided.memory_mb == pytest.approx(measured["adjustment"]["peak_memory_mb"], rel=0.3)


def test_the_memory_of_features_is_that_of_measured_ones():
    """By the figures of benchmarks/features_memory.py: never less, and little more where the finest octave counts."""
    path = Path(__file__).parents[2] / "benchmarks/results/features_memory.json"
    found = json.loads(path.read_text())
    for name, of in found.items():
        estimated = photographs.features(replace(A, megapixels=of["megapixels"]), C).memory_mb
        assert estimated > of["MB after all"], name
        if name.endswith("soft"):
            assert estimated == pytest.approx(of["MB after all"], rel=0.15), name
    # docs/how-to/cluster.md
    assert photographs.features(replace(A, megapixels=24.0), C).memory_mb == pytest.approx(530, abs=20)
    assert photographs.features(replace(A, megapixels=150.0), C).memory_mb < 2000


def test_features_are_among_what_may_give_way():
    small = estimate(replace(A, images=10, memory_gb=0.4), C, disk_gb=1e9)
    assert small.limits[0].what.endswith(" features")
    assert small.limits[0].share > 1


def test_what_is_tightest_stands_first():
    found = estimate(A, C, disk_gb=1.0)
    assert found.limits[0].what == "disk"
    assert found.limits[0].share > 1
    assert [x.share for x in found.limits] == sorted((x.share for x in found.limits), reverse=True)
    large = estimate(replace(A, images=1_000_000, memory_gb=4.0), C, disk_gb=1e9)
    over = {x.what for x in large.limits if x.share > 1}
    assert {DRIVER, FRONT} <= over
    small = estimate(replace(A, images=100), C, disk_gb=1e9)
    assert all(x.share < 1 for x in small.limits)
    assert small.dominant.cpu_s == max(s.cpu_s for s in small.stages)


def test_few_photographs_are_all_matched_and_many_by_twelve():
    assert photographs.pairs_of(60) == 60 * 59 / 2
    assert photographs.pairs_of(10_000) == 120_000
    assert photographs.choice_of_pairs(replace(A, images=60), C).cpu_s == 0
    times = [photographs.matching(replace(A, images=n), C).cpu_s for n in (1000, 2000)]
    assert times[1] == pytest.approx(2 * times[0])


def test_many_photographs_share_start_and_precision_and_few_do_not():
    for images, stage, shared in (
        (599, "tracks and start", False),
        (600, "tracks and start", True),
        (20, "precision", True),
    ):
        one, many = (
            next(
                s for s in estimate(replace(A, images=images, workers=w, network_gbit=0.0), C).stages if s.name == stage
            )
            for w in (1, 10**6)
        )
        assert one.cpu_s == many.cpu_s == pytest.approx(one.wall_s)
        assert (many.wall_s < one.wall_s) == shared
        if shared:  # with so many workers, one task of each and what one process does
            tasks = one.tasks - 1
            assert many.wall_s == pytest.approx(many.serial_s + (one.cpu_s - one.serial_s) / tasks)


def test_constants_of_a_sweep_are_found_again():
    rng = np.random.default_rng(1)
    own, points = rng.uniform(50, 900, 40), rng.uniform(0, 2e5, 40)
    sizes = measure.Fronts(own=own, size=own + rng.uniform(100, 2000, 40), points=points)
    of = replace(C.up, read_point=30.0, read_element=7.0, written_point=2.0, written_element=6.0)
    seconds = (
        of.task_s + 1e-6 * of.point_us * points + 1e-9 * of.element_ns * sizes.size**2
        + 1e-12 * of.operation_ns * sizes.operations("up")
    )  # fmt: skip
    records = [
        TaskRecord(
            name="up", node=t, key=f"{t}", inputs=(), seconds=float(seconds[t]),
            read=round(30 * points[t] + 7 * sizes.size[t] ** 2), written=round(2 * points[t] + 6 * sizes.size[t] ** 2),
        )
        for t in range(40)
        for _ in range(3)
    ]  # fmt: skip
    found = measure.sweep_of(
        records, sizes, "up", operation_ns=of.operation_ns, element_ns=of.element_ns, tasks=KINDS["up"]
    )
    for name in ("task_s", "point_us", "read_point", "read_element", "written_point", "written_element"):
        assert getattr(found, name) == pytest.approx(getattr(of, name), rel=1e-4), name


def test_recording_changes_nothing_and_counts_everything(tmp_path):
    block = flight()
    free = {"1": ("c", "x0", "y0")}
    columns = InFiles.of(block, tmp_path / "columns")
    plain = adjust_columns(columns, measure.OPTIONS, free, Folder(tmp_path / "plain"), Serial(), leaf=60)
    of = measure.recorded(columns, free, 60, tmp_path / "recorded")
    assert of.found.sigma0 == plain.sigma0
    nodes = len(plain.network.tree)
    assert {r.name for r in of.records} <= set(measure.SWEEP_OF)
    assert sum(r.name == "reported" for r in of.records) == nodes
    assert sum(r.name == "up" for r in of.records) == nodes * (of.found.iterations + 1)
    assert all(r.seconds >= 0 and r.written > 0 for r in of.records if r.name in {"up", "down", "reported"})
    assert 0 < of.cutting_s < of.seconds
    held = {r.key for r in of.records if (tmp_path / "recorded" / r.key[-2:] / f"{r.key}.npz").exists()}
    assert of.disk > sum(r.written for r in of.records if r.key in held) > 0


def test_constants_are_kept_for_this_version_and_processor(tmp_path, monkeypatch):
    monkeypatch.setenv("RAYBUNDLE_CACHE", str(tmp_path))
    assert constants.kept() is None
    mine = replace(C, processor=constants.processor(), version=constants.version())
    assert constants.keep(mine)
    assert constants.kept() == mine
    for other in (replace(mine, processor="another"), replace(mine, version="0"), replace(mine, revision=0)):
        constants.keep(other)
        assert constants.kept() is None
    constants.cache_file().write_text("{")
    assert constants.kept() is None
    monkeypatch.setenv("RAYBUNDLE_CACHE", str(constants.cache_file()))  # a file, and no folder
    assert not constants.keep(mine)


def test_the_command_measures_once(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("RAYBUNDLE_CACHE", str(tmp_path))
    done = []

    def measured(progress):
        done.append(progress)
        return replace(C, processor=constants.processor(), version=constants.version(), measured="today")

    monkeypatch.setattr(measure, "measure", measured)
    words = ["estimate-cost", "--images", "500", "--disk", "1000"]
    assert main(words) == 0
    assert values_of(reported(capsys, *words))["costs.measured"]["date"] == "today"
    assert len(done) == 1
    assert main([*words, "--measure"]) == 0
    assert len(done) == 2
    assert values_of(reported(capsys, *words, "--no-measure"))["costs.measured"]["date"] == C.measured


def test_the_table_and_what_gives_way(capsys):
    words = ["estimate-cost", "--images", "1000000", "--flight-overlap", "0.8", "0.6", "--workers", "256"]
    assert main([*words, "--memory", "4", "--disk", "1000", "--no-measure"]) == 0
    said = capsys.readouterr().out
    rows = said.splitlines()[1:]
    assert not [line for line in rows if re.search(r"\d (s|min|h|d|[MGT]B)[\d<]", line)]  # columns stand apart
    for stage in ("features", "matching", "precision", "reduction up", "solution down", "covariances", "statistics"):
        assert f"\n{stage} " in said
    found = reported(capsys, *words, "--memory", 4, "--disk", 1000, "--no-measure")
    assert values_of(found)["costs.assumed"]["overlap"] == pytest.approx(12.5)
    exceeded = {m["values"]["what"] for m in found["warnings"] if m["code"] == "costs.exceeded"}
    assert {"disk", DRIVER} <= exceeded
    told = reported(capsys, *words, "--no-measure")
    assert told["asked"]["images"] == 1_000_000
    assert told["core_hours"] == pytest.approx(sum(s["cpu_s"] for s in told["stages"]) / 3600)
    assert told["limits"][0]["share"] > 1


def test_photographs_are_counted_by_their_headers(tmp_path, capsys):
    for k in range(3):
        Image.new("L", (400, 300 + k)).save(tmp_path / f"{k}.png")
    (tmp_path / "broken.jpg").write_bytes(b"\xff\xd8\xff")
    (tmp_path / "notes.txt").write_text("no photograph")
    found = rb.estimate_cost(tmp_path, shipped=True)
    assert found.asked.images == 3
    assert found.asked.megapixels == pytest.approx(400 * 301 / 1e6)
    assert found.unread == ("broken.jpg",)
    printed = values_of(reported(capsys, "estimate-cost", tmp_path, "--no-measure"))
    assert printed["costs.estimated"]["n"] == 3
    assert printed["costs.assumed"]["overlap"] == 3  # no more than there are
    assert printed["costs.unread"] == {"n": 1, "names": ["broken.jpg"]}
    (tmp_path / "0.png").unlink()
    (tmp_path / "1.png").unlink()
    with pytest.raises(InputError, match=r"1.*broken\.jpg.*photograph\.too_few"):
        rb.estimate_cost(tmp_path, shipped=True)


def test_what_cannot_be_is_told(tmp_path):
    with pytest.raises(InputError, match=r"costs\.no_photographs"):
        rb.estimate_cost(shipped=True)
    with pytest.raises(InputError, match=r"images=5.*costs\.photographs_and_number"):
        rb.estimate_cost(tmp_path, images=5, shipped=True)
    with pytest.raises(InputError, match=r"photograph\.too_few"):
        rb.estimate_cost(tmp_path, shipped=True)
    with pytest.raises(InputError, match=r"folder\.missing_itself"):
        rb.estimate_cost(tmp_path / "none", shipped=True)
    with pytest.raises(InputError, match=r"costs\.measure_and_shipped"):
        rb.estimate_cost(images=5, shipped=True, measure=True)
    with refused("costs.overlap_too_small", n=1.25, needed=2.0):
        rb.estimate_cost(images=5, shipped=True, flight_overlap=(0.2, 0.0))
    with pytest.raises(InputError, match="flight_overlap"):
        rb.estimate_cost(images=5, shipped=True, flight_overlap=(0.8, 1.0))


@pytest.mark.long
def test_this_machine_is_measured():
    told = []
    found = measure.measure(lambda _, share: told.append(share))
    assert told == sorted(told)
    assert found.processor == constants.processor()
    again = msgspec.json.decode(msgspec.json.encode(found), type=constants.Constants)
    assert again == found
    for sweep in constants.SWEEPS:
        assert getattr(found, sweep).point_us > 0
        assert getattr(found, sweep).read_element == getattr(C, sweep).read_element
    assert found.up.operation_ns > 0
    assert found.feature_mpx_s > 0


def test_memory_is_that_of_this_machine_and_what_helps_is_said(capsys, monkeypatch):
    words = ["estimate-cost", "--images", "10000", "--megapixels", "20", "--disk", "10", "--no-measure"]
    monkeypatch.setattr("raybundle.numerics.machine.available_memory", lambda: 12.5e9)
    found = reported(capsys, *words)
    printed = values_of(found)
    exceeded = {m["values"]["what"]: m["values"]["given"] for m in found["warnings"]}
    assert exceeded[PRECISION] == "12.5 GB"
    assert exceeded["disk"] == "10.0 GB"
    assert found["next"]["code"] == "costs.memory_remedy"
    assert {"costs.precision_remedy", "costs.disk_remedy", "costs.largest_matrix", "costs.not_included"} <= set(printed)
    together = "memory of driver and workers together"
    for more, known in ((("--network", 0), True), ((), False)):
        found = reported(capsys, *words, "--workers", 16, *more, "--memory", 2)
        assert (together in {m["values"].get("what") for m in found["warnings"]}) == known
