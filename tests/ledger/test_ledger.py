"""The ledger: its sets, its statistics, and whether they notice standard deviations that are 10 % wrong."""

import json
import os
import re
import signal
import sys
from dataclasses import replace
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "benchmarks"))

from ledger.errors import Errors  # noqa: E402
from ledger.judges import JUDGES, judge_named  # noqa: E402
from ledger.page import PAGE, failure, page  # noqa: E402
from ledger.sets import BadSet, NotHere, Places, read_set, read_sets  # noqa: E402
from ledger.statistics import coordinates_needed, pooled, statistics  # noqa: E402

from ledger import RESULTS, SETS, results  # noqa: E402

OWN = read_sets([SETS])
WRONG = 1.1


def normal(rng, *, sets=8, n=60, runs=10, module="orientation", factor=1.0):
    """Errors of sets whose stated standard deviations are the true ones times a factor."""
    groups = {}
    for k in range(sets):
        ratio = rng.normal(size=n * runs) / factor
        errors = Errors(module=module, ratio=ratio, sigma=np.ones(n * runs), draw=np.repeat(np.arange(runs), n))
        groups[str(k)] = [statistics(errors)]
    return groups


def holds(interval):
    return interval[1] <= 1 <= interval[2]


def test_there_are_forty_sets_and_twenty_with_independent_truth():
    assert len(OWN) >= 40
    assert sum(one.independent for one in OWN) >= 20
    assert {module for one in OWN for module in one.judged} >= {
        "orientation", "interior orientation", "object points", "tie points", "means", "volumes", "movements"
    }  # fmt: skip


@pytest.mark.parametrize("one", OWN, ids=lambda one: one.name)
def test_every_set_has_a_judge_and_what_it_needs(one):
    assert one.judge in JUDGES
    if one.source["kind"] == "files":
        assert one.source["checksums"]
        assert all(len(s) >= 16 for s in one.source["checksums"].values())
    else:
        assert isinstance(one.source["seed"], int)


def test_no_two_simulated_sets_draw_the_same_errors():
    seeds = [one.source["seed"] for one in OWN if one.source["kind"] == "simulated"]
    assert len(set(seeds)) == len(seeds)


def test_a_set_with_a_field_wrong_is_refused(tmp_path):
    text = (SETS / "ring.toml").read_text()
    for before, after, reason in (
        ('judged = ["orientation"', 'judged = ["beauty"', "beauty"),
        ('name = "ring"', 'name = "rung"', "that of the file"),
        ('licence = "own"\n', "", "licence"),
        ("split = false", "split = true", "independent truth"),
    ):
        assert before in text
        (tmp_path / "ring.toml").write_text(text.replace(before, after))
        with pytest.raises(BadSet, match=reason):
            read_set(tmp_path / "ring.toml")


def test_files_that_differ_from_their_checksums_are_not_judged(tmp_path):
    one = next(one for one in OWN if one.name == "prague-s1")
    places = Places(data=(tmp_path,), cache=tmp_path)
    with pytest.raises(NotHere, match=re.escape(one.source["folder"])):
        places.files(one)
    folder = tmp_path / one.source["folder"]
    folder.mkdir(parents=True)
    for name in one.source["checksums"]:
        (folder / name).write_text("")
    with pytest.raises(NotHere, match="checksum"):
        places.files(one)


def test_true_standard_deviations_hold_and_wrong_ones_do_not():
    rng = np.random.default_rng(46)
    for _ in range(5):
        found = pooled(normal(rng))
        assert found["chi_square"][0] == pytest.approx(1, abs=0.06)
        assert found["coverage_95"][0] == pytest.approx(0.95, abs=0.01)
    for factor in (1 / WRONG, WRONG):
        found = pooled(normal(rng, factor=factor))
        assert not holds(found["chi_square"])
        assert found["chi_square"][0] == pytest.approx(factor**-2, rel=0.06)
        assert abs(found["coverage_95"][0] - 0.95) > 0.01


def test_intervals_hold_the_truth_as_often_as_they_state():
    rng, inside = np.random.default_rng(5), []
    for _ in range(200):
        common = 1 + 0.2 * rng.normal(size=(12, 1))  # what all errors of a run share
        ratio = (common * rng.normal(size=(12, 40)) / np.sqrt(1.04)).ravel()
        errors = Errors(module="surface", ratio=ratio, sigma=np.ones(480), draw=np.repeat(np.arange(12), 40))
        low, high = statistics(errors)["chi_square_interval"]
        inside.append(low <= 1 <= high)
    assert 0.88 < np.mean(inside) < 0.99


def test_number_of_coordinates_that_a_wrong_sigma_takes():
    n = coordinates_needed(WRONG)
    rng = np.random.default_rng(1)
    square = rng.normal(size=(4000, n)) ** 2
    low, high = np.quantile(square.mean(axis=1), [0.025, 0.975])
    for factor in (WRONG**2, WRONG**-2):
        found = square.mean(axis=1) * factor
        assert np.mean((found < low) | (found > high)) > 0.87
    fewer = square[:, : n // 4].mean(axis=1)
    low, high = np.quantile(fewer, [0.025, 0.975])
    assert np.mean((fewer * WRONG**2 < low) | (fewer * WRONG**2 > high)) < 0.7


SMALL = {
    "ring": {"runs": 8, "scene": {"kind": "ring", "points": 80, "stations": 8, "rings": 1}},
    "field-inner": {"runs": 8, "scene": {"kind": "field", "rows": 6, "columns": 8, "stations": 8}},
    "field-control": {"runs": 8, "scene": {"kind": "field", "rows": 6, "columns": 9, "stations": 7}},
}
SCATTER = 0.1
"""Chi-square of some hundred coordinates may differ by this from one"""


def judged(name, tmp_path, **options):
    one = next(one for one in OWN if one.name == name)
    one = replace(one, options={**one.options, **options})
    return judge_named(one.judge)(one, Places(data=(), cache=tmp_path))


def noticed(errors):
    """Joint chi-square and its interval: as stated, with all sigmas 10 % too small and too large."""
    found = []
    for factor in (1.0, 1 / WRONG, WRONG):
        s = statistics(errors.wrong(factor))
        low, high = s["joint_interval"] if "joint_interval" in s else s["chi_square_interval"]
        found.append(low <= 1 <= high)
    return found


def test_ten_percent_is_noticed_through_the_judge_of_networks(tmp_path):
    """Each module of one network with enough runs, by its whole covariance."""
    options = {**SMALL["field-inner"], "runs": 60}
    every = {e.module: e for e in judged("field-inner", tmp_path, **options)}
    assert set(every) == {"orientation", "interior orientation", "object points"}
    for module, errors in every.items():
        degrees = sum(d for _, d in errors.joint)
        assert degrees >= 400, module
        assert noticed(errors)[1:] == [False, False], module
        assert statistics(errors)["joint_chi_square"] == pytest.approx(1, abs=5 * np.sqrt(2 / degrees)), module


def test_ten_percent_is_noticed_in_movements(tmp_path):
    (errors,) = judged("moved-drawn-1", tmp_path, runs=12)
    assert noticed(errors)[1:] == [False, False]


@pytest.mark.long
def test_ten_percent_is_noticed_in_means_of_surfaces(tmp_path):
    one = judged("heights-means-no-tilt", tmp_path, runs=900)
    assert noticed(one[0])[1:] == [False, False]


def test_sets_of_a_folder_outside_are_read_and_judged_without_a_change(tmp_path):
    outside = tmp_path / "outside"
    outside.mkdir()
    text = (SETS / "ring.toml").read_text().replace('name = "ring"', 'name = "elsewhere"')
    assert "runs = 40" in text
    (outside / "elsewhere.toml").write_text(text.replace("runs = 40", "runs = 2"))
    (one,) = read_sets([outside])
    found = results.run(one, Places(data=(outside,), cache=tmp_path / "cache"))
    assert not found["reason"]
    path = results.write(found, outside / "results")
    assert json.loads(path.read_text())["groups"]
    lines = page([one], results.read(outside / "results")).splitlines()
    rows = [[c.strip() for c in line.split("|")[1:4]] for line in lines]
    assert any(row[:2] == [one.name, "simulation"] and row[2].startswith("orientation") for row in rows)


def test_what_could_not_run_is_a_row_with_its_reason(tmp_path):
    one = next(one for one in OWN if one.name == "prague-s1")
    found = results.run(one, Places(data=(), cache=tmp_path))
    assert found["reason"].startswith(one.source["folder"])
    assert found["reason"] in page([one], {one.name: found})
    broken = replace(one, judge="network")  # its options are not those of this judge
    assert results.run(broken, Places(data=(), cache=tmp_path))["reason"].startswith("KeyError")


def test_a_killed_worker_is_a_row_and_the_others_go_on(tmp_path, monkeypatch, capfd):
    run_all, killed = import_module("ledger.__main__")._run_all, "killed"
    sets = [replace(OWN[0], name=name) for name in (killed, "other")]
    monkeypatch.setattr(results, "run", _killed_or_not)
    assert run_all(sets, Places(data=(), cache=tmp_path), tmp_path / "results", 1, redo=False) == 1
    kept = results.read(tmp_path / "results")
    assert "killed" in kept[killed]["reason"]
    assert not kept["other"]["reason"]
    shown = capfd.readouterr().err
    assert len(shown.splitlines()) == 2
    assert "Traceback" not in shown


def _killed_or_not(one, places):
    del places
    if one.name == "killed":
        os.kill(os.getpid(), signal.SIGKILL)
    return {**results.killed(one, 0.0), "reason": ""}


def test_failures_stand_first_and_nothing_is_left_out():
    rng = np.random.default_rng(3)
    good = statistics(Errors(module="tie points", label="smooth", ratio=rng.normal(size=500), sigma=np.ones(500)))
    bad = statistics(Errors(module="tie points", label="step", ratio=3 * rng.normal(size=500), sigma=np.ones(500)))
    tails = statistics(Errors(module="tie points", label="rim", ratio=np.r_[np.zeros(200), 9, 9], sigma=np.ones(202)))
    assert [failure(g) for g in (good, bad, tails)] == [False, True, True]
    one = next(one for one in OWN if one.name == "terrain-a11")
    words = page([one], {one.name: {"groups": [good, bad, tails], "cpu_s": 1.0, "reason": "", "means": "rendering"}})
    first, rest = words.split("## Sets without a result")
    step, rim, smooth = (f"tie points: {label}" for label in ("step", "rim", "smooth"))
    assert [name in first for name in (step, rim, smooth)] == [True, True, False]
    assert smooth in rest


def test_the_page_is_that_of_the_result_files():
    assert PAGE.read_text(encoding="utf-8") == page(OWN, results.read(RESULTS))
