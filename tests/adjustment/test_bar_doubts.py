"""A scale bar that contradicts the others is named with its length in the block, and nothing else is accused."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Ring, TargetField, field_scene, ring_scene

PLAIN = AdjustmentOptions(jobs=1)
SNOOPING = replace(PLAIN, reject="snooping")
SCENES = {"testfield": lambda: field_scene(TargetField(stations=4)), "ring": lambda: ring_scene(Ring())}
UNITS = [(1e3, "mm"), (1e2, "cm"), (1 / 0.3048, "feet"), (1 / 0.0254, "inches")]


def simulation(kind="testfield", **survey):
    return simulate(SCENES[kind](), Survey(seed=3, **{"scale_bars": 3, **survey}))


def with_factors(block, factors):
    d = block.distances
    factor = np.ones(len(d))
    for k, f in factors.items():
        factor[k] = f
    return block.having(replace(d, length=np.asarray(d.length) * factor, sigma=np.asarray(d.sigma) * factor))


def names(block, rows):
    ids, d = block.points.ids, block.distances
    return tuple(f"{ids[d.start[k]]}-{ids[d.end[k]]}" for k in rows)


def only_fault(result):
    (notice,) = [n for n in result.notices if n.severity == "fault"]
    return notice


def is_right(result, simulated):
    """Whether the distances between the points are those of the truth, to 1e-3."""
    xyz, true = result.adjusted.points.xyz, simulated.truth.points.xyz
    own, right = (np.linalg.norm(x - x.mean(axis=0), axis=1) for x in (xyz, true))
    return np.allclose(own, right, rtol=1e-3, atol=1e-3)


ONE = [
    *(("testfield", factor, PLAIN) for factor in (1e3, 1e2, 1 / 0.3048, 1.3, 1.05, 0.7, 0.001)),
    *(("testfield", factor, SNOOPING) for factor in (1e3, 1.3, 0.01)),
    *(("ring", factor, PLAIN) for factor in (1e3, 1.05)),
]


@pytest.mark.parametrize(("kind", "factor", "options"), ONE)
def test_one_bar_of_three_is_named_and_the_rest_is_right(kind, factor, options):
    simulated = simulation(kind)
    block = with_factors(simulated.observed, {1: factor})
    result = adjust(block, options)
    notice = only_fault(result)
    assert (notice.code, notice.ids) == ("distance_suspect", names(block, [1]))
    assert notice.values["given"] == pytest.approx(factor * notice.values["shown"], rel=1e-3)
    assert result.sigma0 < 1.1
    assert sum(r is not None for r in result.image_observations.rejected) <= 2
    assert is_right(result, simulated)


@pytest.mark.parametrize(("factor", "unit"), UNITS)
def test_two_of_three_bars_in_another_unit_are_named_and_not_the_third(factor, unit):
    simulated = simulation()
    block = with_factors(simulated.observed, {0: factor, 2: factor})
    result = adjust(block, PLAIN)
    notice = only_fault(result)
    assert notice.ids == names(block, [0, 2])
    assert notice.values["likely"] == unit
    assert is_right(result, simulated)


@pytest.mark.parametrize("end", [0, 7, 20])
def test_a_bar_with_a_misnamed_end_is_named_and_not_the_right_ones(end):
    simulated = simulation()
    block, d = simulated.observed, simulated.observed.distances
    free = [k for k in range(len(block.points)) if k not in {*d.start, *d.end}]
    start = np.asarray(d.start).copy()
    start[2] = free[end]
    block = block.having(replace(d, start=start))
    result = adjust(block, PLAIN)
    assert only_fault(result).ids == names(block, [2])
    assert is_right(result, simulated)


def test_of_two_bars_the_one_that_approximate_values_contradict_is_named():
    block = with_factors(simulation(scale_bars=2).observed, {0: 1.5})
    assert only_fault(adjust(block, PLAIN)).ids == names(block, [0])


def test_of_two_bars_without_approximate_values_both_are_named():
    block = with_factors(simulation(scale_bars=2, orientation="absent").observed, {0: 1.5})
    notice = next(n for n in adjust(block, PLAIN).notices if n.severity == "fault")
    assert notice.ids == names(block, [0, 1])
    assert notice.variant == "contradict"


def test_control_shows_which_of_two_bars_is_wrong():
    block = with_factors(simulation(scale_bars=2, control=6, control_sigma=(1e-3, 1e-3, 1e-3)).observed, {1: 2.0})
    assert only_fault(adjust(block, PLAIN)).ids == names(block, [1])


@pytest.mark.parametrize("factor", [1.0, 1.0002, 0.9998])
@pytest.mark.parametrize("kind", list(SCENES))
def test_right_bars_are_not_accused(kind, factor):
    block = with_factors(simulation(kind, scale_bar_sigma=3e-4).observed, {1: factor})
    assert not [n for n in adjust(block, PLAIN).notices if n.severity == "fault"]


@pytest.mark.parametrize(("kind", "factor", "unit"), [*(("testfield", *u) for u in UNITS), ("ring", *UNITS[2])])
def test_bars_of_another_unit_than_the_approximate_values_are_named(kind, factor, unit):
    block = with_factors(simulation(kind).observed, dict.fromkeys(range(3), factor))
    result = adjust(block, PLAIN)
    cautions = [n for n in result.notices if n.severity in ("warning", "fault")]
    assert [n.code for n in cautions] == ["approximate_scale"]
    assert [cautions[0].values[k] for k in ("of", "likely", "unit")] == ["bars", unit, "m"]


def test_approximate_values_of_another_unit_are_named():
    block = simulation().observed
    block = replace(block, images=replace(block.images, centre=block.images.centre * 1e3))
    (notice,) = [n for n in adjust(block, PLAIN).notices if n.code == "approximate_scale"]
    assert [notice.values[k] for k in ("of", "likely", "unit")] == ["start", "mm", "m"]


@pytest.mark.parametrize("factor", [0.5, 0.8, 1.2, 2.0, 7.0, 60.0, 730.0])
def test_approximate_values_in_a_unit_of_their_own_are_no_caution(factor):
    block = simulation().observed
    block = replace(block, images=replace(block.images, centre=block.images.centre * factor))
    assert "approximate_scale" not in {n.code for n in adjust(block, PLAIN).notices}


@pytest.mark.parametrize(("kind", "pair"), [("testfield", (0, 1)), ("testfield", (1, 3)), ("ring", (0, 1))])
def test_exchanged_control_accuses_no_bar(kind, pair):
    """The other way round all bars fit: what the tests of single values show of them is its doing."""
    block = simulation(kind, scale_bars=2, control=4, control_sigma=(3e-4, 3e-4, 3e-4)).observed
    xyz, rows = block.points.xyz.copy(), np.flatnonzero(block.points.is_control.all(axis=1))[[*pair]]
    xyz[rows] = xyz[rows[::-1]]
    result = adjust(replace(block, points=replace(block.points, xyz=xyz)), PLAIN)
    accused = {n.code: n.ids for n in result.notices if n.severity == "fault"}
    assert set(accused) <= {"control_contradicts", "global_test", "weak_convergence"}
    assert set(accused["control_contradicts"]) == {block.points.ids[k] for k in rows}
