"""Dots without a code in several measurements: one by their place, never by their running number."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.fields import SMALL

import raybundle as rb
from raybundle.block.points import dot_name, dot_number
from raybundle.commands.merge import merge_projects
from raybundle.commands.moved import moved_points
from raybundle.io.block.folder import read_block
from raybundle.metrology.best_fit import Nominal, best_fit
from raybundle.metrology.dots import dots_alike
from raybundle.metrology.point_set import PointSet
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import field_scene
from raybundle.report.write import write_result


def measured(xyz, codes, order, name, scale=1.0):
    """A measurement of so many coded targets and dots, which are numbered in this order, in axes of its own."""
    turn = rotation_from_vector(np.array([0.4, -0.2, 1.1]) * len(name))
    at = np.concatenate([np.arange(codes), codes + np.asarray(order, int)])
    ids = (*(str(k + 1) for k in range(codes)), *(dot_name(k) for k in range(len(order))))
    n = len(at)
    return PointSet(name=name, ids=ids, xyz=scale * xyz[at] @ turn.T + 3.0, covariance=1e-10 * np.eye(3 * n))


@pytest.fixture
def places():
    rng = np.random.default_rng(2)
    grid = np.stack(np.meshgrid(np.arange(5), np.arange(6)), axis=-1).reshape(-1, 2) * 0.2
    return np.concatenate([rng.uniform(0, 1, (8, 3)), np.column_stack([grid, 0 * grid[:, 0]])])


def test_the_names_of_dots():
    assert dot_name(0) == "dot 1"
    assert [dot_number(n) for n in ("dot 1", "dot 12", "dot 0", "dots", "12", "dot 1a", "Dot 3")] == [0, 11, *[-1] * 5]


def test_dots_get_the_numbers_of_the_first_measurement(places):
    first = measured(places, 8, np.arange(30), "a")
    order = np.random.default_rng(5).permutation(30)
    second = measured(places, 8, order, "other", scale=1000.0)
    sets, by_place = dots_alike([first, second])
    assert sets[1].ids[8:] == tuple(dot_name(k) for k in order)
    assert len(by_place) == 30
    np.testing.assert_array_equal(sets[1].xyz, second.xyz)


def test_a_dot_that_moved_is_the_same_up_to_half_of_the_way_to_the_next(places):
    first = measured(places, 8, np.arange(30), "a")
    moved = places.copy()
    moved[8 + 7] += [0.06, 0.0, 0.0]
    moved[8 + 20] += [0.11, 0.0, 0.0]
    sets, by_place = dots_alike([first, measured(moved, 8, np.arange(30), "later")])
    assert dot_name(7) in by_place
    assert dot_name(20) not in by_place
    assert sets[1].ids[8 + 7] == dot_name(7)
    assert sets[1].ids[8 + 20] == dot_name(30)  # a number of its own
    assert len(set(sets[1].ids)) == 38


def test_dots_that_one_measurement_lacks_are_none_of_another(places):
    first = measured(places, 8, [0, 1, 2, 10, 11], "a")
    second = measured(places, 8, [2, 25, 10, 0], "later")
    sets, by_place = dots_alike([first, second])
    assert set(by_place) == {dot_name(0), dot_name(2), dot_name(3)}
    assert sets[1].ids[8:] == (dot_name(2), dot_name(5), dot_name(3), dot_name(0))


def test_a_third_measurement_knows_the_dots_of_the_second(places):
    a, b, c = (measured(places, 8, order, name) for order, name in (([0, 1], "a"), ([5, 1], "bb"), ([1, 5, 0], "ccc")))
    sets, _ = dots_alike([a, b, c])
    assert sets[1].ids[8:] == (dot_name(2), dot_name(1))
    assert sets[2].ids[8:] == (dot_name(1), dot_name(2), dot_name(0))


def test_without_common_names_no_dot_is_the_same(places):
    a = measured(places, 2, np.arange(30), "a")
    sets, by_place = dots_alike([a, measured(places, 2, np.arange(30), "bb")])
    assert by_place == ()
    assert not set(sets[1].ids[2:]) & set(a.ids)


def test_sets_without_dots_stay(places):
    a = measured(places, 8, [], "a")
    sets, by_place = dots_alike([a, a])
    assert sets == [a, a]
    assert by_place == ()


def test_nominal_dots_are_found_by_their_place(places):
    order = np.random.default_rng(5).permutation(30)
    m = measured(places, 8, order, "a")
    ids = (*(str(k + 1) for k in range(8)), *(dot_name(k) for k in range(30)), "dot 99")
    nominal = Nominal(
        ids=ids, xyz=np.vstack([places, [[5.0, 5.0, 5.0]]]), sigma=np.full((39, 3), 1e-6),
        tolerance=np.full(39, 1e-3),
    )  # fmt: skip
    fit = best_fit(m, nominal, by=("1", "2", "3", "4", "dot 1"))
    assert np.linalg.norm(fit.deviation, axis=1).max() < 1e-6
    assert len(fit.ids) == 38
    assert fit.missing == ("dot 99 (nominal)",)
    first = dot_name(int(np.flatnonzero(order == 0)[0]))  # what the file calls dot 1
    assert first in [i for i, f in zip(fit.ids, fit.fitted, strict=True) if f]


@pytest.fixture(scope="module")
def epochs(tmp_path_factory):
    """Two results of a field of which the last ten targets are dots, numbered the other way round; one moved."""
    folder = tmp_path_factory.mktemp("epochs")
    scene = field_scene(SMALL)
    for seed, name in ((3, "spring"), (4, "autumn")):
        xyz = scene.xyz.copy()
        if name == "autumn":
            xyz[-1, 1] += 0.004
        survey = Survey(seed=seed, image_sigma_px=0.3, scale_bars=1, scale_bar_sigma=1e-5)
        block = simulate(replace(scene, xyz=xyz), survey).observed
        n = len(scene.xyz)
        numbers = np.arange(10) if name == "spring" else 9 - np.arange(10)
        ids = (*block.points.ids[: n - 10], *(dot_name(k) for k in numbers.tolist()), *block.points.ids[n:])
        block = replace(block, points=replace(block.points, ids=ids))
        write_result(rb.adjust(block, rb.AdjustmentOptions(jobs=1)), folder / name, report="none")
    return folder


def test_moved_finds_the_dot_that_moved_and_no_other(epochs, tmp_path):
    done = moved_points([epochs / "spring", epochs / "autumn"], tmp_path / "out", report=False)
    assert [i for i, m in zip(done.ids, done.moved, strict=True) if m] == ["dot 10"]
    assert len(done.by_place) == 10
    some = moved_points(
        [epochs / "spring", epochs / "autumn"],
        tmp_path / "some",
        report=False,
        points=("1", "2", "3", "4", "5", "dot 10"),
    )
    assert some.ids == ("1", "2", "3", "4", "5", "dot 10")
    assert some.moved.tolist() == [False] * 5 + [True]


def test_merge_joins_dots_by_their_place(epochs, tmp_path):
    done = merge_projects([epochs / "spring", epochs / "autumn"], tmp_path / "both")
    assert any(r.values.get("n") == 10 and "dots" in r.code for r in done.remarks)
    block = read_block(tmp_path / "both")
    assert sum(dot_number(i) >= 0 for i in block.points.ids) in (10, 11)  # the one that moved may stand twice
    assert Path(tmp_path / "both").is_dir()
