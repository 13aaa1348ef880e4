"""Held control that is wrong is named: by the force that holds it, and where nothing fits, by leaving it out."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import minimize_scalar
from scipy.stats import f

from raybundle import adjust
from raybundle.adjustment.blunders.control_tests import ControlTests, control_tests
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role, Stations
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene

OPTIONS = AdjustmentOptions(jobs=1)


def observed(seed=1, *, sigma=(0.0, 0.0, 0.0), control=5, bars=0, estimate=()):
    scene = field_scene(TargetField(stations=6, frontal=0, camera=brown_camera(estimate=estimate)))
    survey = Survey(
        seed=seed, orientation="exact", points="exact", interior="exact", control=control, control_sigma=sigma,
        scale_bars=bars,
    )  # fmt: skip
    return simulate(scene, survey).observed


def moved(block, name, by):
    xyz = block.points.xyz.copy()
    xyz[block.points.ids.index(name)] += by
    return replace(block, points=replace(block.points, xyz=xyz))


def let_go(block, name):
    """The block in which the point's coordinates are free."""
    k = block.points.ids.index(name)
    sigma, role = block.points.sigma.copy(), block.points.role.copy()
    sigma[k], role[k] = np.nan, Role.TIE
    return replace(block, points=replace(block.points, sigma=sigma, role=role))


def control_names(block):
    return [name for name, c in zip(block.points.ids, block.points.is_control.any(axis=1), strict=True) if c]


@pytest.mark.parametrize(
    ("sigma", "bars", "estimate"),
    [
        ((0, 0, 0), 0, ()),
        ((0, 0, np.nan), 0, ()),
        ((0, 1e-4, 0), 2, ()),
        ((1e-4, 1e-4, 2e-4), 2, ()),
        ((0, 0, 0), 2, ("c", "x0", "y0", "K1")),
    ],
)
def test_the_force_says_what_letting_the_point_go_would_gain(sigma, bars, estimate):
    block = observed(sigma=sigma, bars=bars, estimate=estimate)
    name = control_names(block)[2]
    block = moved(block, name, [2e-5, -3e-5, 1e-5])
    result = adjust(block, OPTIONS)
    free = adjust(let_go(block, name), OPTIONS)
    k = block.points.ids.index(name)
    test = next(t for t in control_tests(result) if t.point == k)
    gained = result.weighted_square_sum - free.weighted_square_sum
    assert test.directions == sum(np.isfinite(sigma))
    assert test.square == pytest.approx(gained, rel=1e-3)
    held = np.isfinite(sigma)
    assert test.shift[held] == pytest.approx(
        (free.adjusted.points.xyz[k] - block.points.xyz[k])[held], rel=2e-3, abs=3e-7
    )
    assert (test.shift[~held] == 0).all()


def test_the_test_keeps_its_probability():
    """Right coordinates: the probabilities are uniform.  With sigma0 10 % off in F's denominator they were not."""
    p = [t.probability for seed in range(30) for t in control_tests(adjust(observed(seed, control=4), OPTIONS))]
    assert len(p) == 120
    assert abs(np.mean(p) - 0.5) < 4 * np.sqrt(1 / 12 / 30)  # tests of one block are correlated
    assert np.mean(np.array(p) < 0.05) < 0.15


def test_a_held_point_that_is_wrong_is_named():
    block = observed()
    name = control_names(block)[1]
    result = adjust(moved(block, name, [0.0, 4e-4, 0.0]), OPTIONS)
    (notice,) = [n for n in result.notices if n.code == "control_suspect"]
    assert notice.ids == (name,)
    assert notice.severity == "fault"
    assert notice.values["n"] == 1
    assert not [n for n in adjust(block, OPTIONS).notices if n.code == "control_suspect"]


def without_orientation(block):
    images = block.images
    blank = replace(images, centre=np.full_like(images.centre, np.nan), rotation=np.full_like(images.rotation, np.nan))
    return replace(block, images=blank)


@pytest.mark.parametrize("sigma", [0.0, 1e-12, 1e-4])
@pytest.mark.parametrize("begun", [True, False])
def test_control_far_off_is_named_where_nothing_fits(sigma, begun):
    """10 m off in a field of 2 m: the adjustment with it bends everything; without it the others fit."""
    block = observed(sigma=(sigma,) * 3)
    name = control_names(block)[2]
    wrong = moved(block, name, [10.0, 0.0, 0.0])
    result = adjust(wrong if begun else without_orientation(wrong), OPTIONS)
    (notice,) = [n for n in result.notices if n.code == "control_contradicts"]
    assert notice.ids == (name,)
    assert notice.severity == "fault"
    assert (notice.variant, notice.values["names"]) == ("points", [name])
    assert not [n for n in result.notices if n.code == "control_suspect"]


def test_two_wrong_ones_are_both_named_and_all_where_none_explains_it():
    block = observed(control=7)
    names = control_names(block)
    two = moved(moved(block, names[1], [3.0, 0.0, 0.0]), names[4], [0.0, -2.0, 1.0])
    (notice,) = [n for n in adjust(two, OPTIONS).notices if n.code == "control_contradicts"]
    assert set(notice.ids) == {names[1], names[4]}
    xyz = block.points.xyz.copy()
    rows = [block.points.ids.index(n) for n in names]
    xyz[rows] = xyz[rows] + np.random.default_rng(1).normal(0, 2.0, (len(rows), 3))
    (notice,) = [
        n
        for n in adjust(replace(block, points=replace(block.points, xyz=xyz)), OPTIONS).notices
        if n.code == "control_contradicts"
    ]
    assert notice.ids == tuple(names)
    assert notice.variant == "unexplained"


@pytest.mark.parametrize("control", [4, 7])
def test_what_is_exchanged_in_the_control_is_named(control):
    block = observed(control=control)
    names = control_names(block)
    i, j = (block.points.ids.index(names[k]) for k in (0, 2))
    xyz = block.points.xyz.copy()
    xyz[[i, j]] = xyz[[j, i]]
    (notice,) = [
        n
        for n in adjust(replace(block, points=replace(block.points, xyz=xyz)), OPTIONS).notices
        if n.code == "control_contradicts"
    ]
    assert notice.ids == (names[0], names[2])
    assert (notice.variant, notice.values["names"]) == ("exchanged", [names[0], names[2]])
    xyz = block.points.xyz.copy()
    rows = [block.points.ids.index(n) for n in names]
    xyz[rows] = xyz[rows][:, [1, 0, 2]]  # as in a list by northing and easting: a mirrored object
    (notice,) = [
        n
        for n in adjust(replace(block, points=replace(block.points, xyz=xyz)), OPTIONS).notices
        if n.code == "control_contradicts"
    ]
    assert notice.values["mends"] == ["xy"]


def test_photographs_that_contradict_themselves_are_not_laid_on_control():
    block = observed()
    o = block.observations
    rng = np.random.default_rng(3)
    noisy = replace(block, observations=replace(o, xy_px=o.xy_px + rng.normal(0, 3.0, o.xy_px.shape)))
    result = adjust(noisy, OPTIONS)
    assert result.sigma0 > 3
    assert not [n for n in result.notices if n.code.startswith("control_")]


def test_projection_centres_in_another_datum_are_told_from_wrong_control():
    """The photographs fit either; the search for a better start ends, although nothing fits both."""
    block = observed(sigma=(1e-4, 1e-4, 1e-4))
    n = len(block.images)
    centre = block.images.centre
    rng = np.random.default_rng(1)
    stations = Stations(
        image=np.arange(n, dtype=np.int32), xyz=centre + np.array([0.0, 0.0, 40.0]) + rng.normal(0, 1e-3, (n, 3)),
        sigma=np.full((n, 3), 1e-3),
    )  # fmt: skip
    block = block.having(stations)
    result = adjust(block, OPTIONS)
    (told,) = [m for m in result.notices if m.code == "control_contradicts"]
    assert told.severity.value == "fault"
    assert told.variant == "centres"
    assert told.details[2].values["axis"] == "Z"
    assert told.details[2].values["apart"] == pytest.approx(40.0, abs=0.1)


@pytest.mark.parametrize("T", [30.0, 120.0, 900.0])
@pytest.mark.parametrize("n", [8, 90])
def test_larger_errors_of_all_are_preferred_where_their_likelihood_is_larger(T, n):
    """Errors of f times the size in k directions against gross ones of two points; a parameter costs ln k (Schwarz)."""
    k, of, variance, freedom = 3 * n, 6, 1.7, 400
    best = minimize_scalar(lambda f: k * np.log(f**2) + T / f**2, bounds=(0.05, 50), method="bounded")
    fall = T - best.fun - np.log(k)  # of -2 ln L by one factor for all
    few = variance * (fall + of * np.log(k) + 2 * np.log(n * (n - 1) / 2))
    for share, as_well in ((0.999, True), (1.001, False)):
        tests = SimpleNamespace(
            _seen=range(n), count=n, result=SimpleNamespace(weighted_square_sum=T * variance + freedom * variance,
                                                            redundancy=freedom + k),
            let_go=lambda chosen, share=share: (T * variance, k, None) if len(chosen) == n else (share * few, of, None),
        )  # fmt: skip
        assert ControlTests._all_as_well(tests, [1, 5]) is (as_well if few > 0 else not as_well)


def test_what_each_of_two_wrong_points_explains_is_what_adjustments_without_it_show():
    block = observed(control=8)
    names = control_names(block)
    wrong = (names[2], names[5])
    block = moved(moved(block, wrong[0], [4e-4, 0, 1e-4]), wrong[1], [0, -3e-4, 2e-4])
    result = adjust(block, OPTIONS)
    found = {p.name: p for p in ControlTests(result).contradiction.wrong}
    assert set(found) == set(wrong)
    both = adjust(let_go(let_go(block, wrong[0]), wrong[1]), OPTIONS)
    left = both.weighted_square_sum / both.redundancy
    tests = result.observations + 3 * len(names)  # of held coordinates as of all others
    for name, other in (wrong, wrong[::-1]):
        alone = adjust(let_go(block, other), OPTIONS)
        point, k = found[name], block.points.ids.index(name)
        assert point.w == pytest.approx(
            np.sqrt((alone.weighted_square_sum - both.weighted_square_sum) / left), rel=1e-2
        )
        assert point.limit == pytest.approx(
            np.sqrt(3 * f.isf(OPTIONS.significance / tests, 3, both.redundancy)), rel=1e-2
        )
        first = adjust(let_go(block, name), OPTIONS)
        assert point.square == pytest.approx(result.weighted_square_sum - first.weighted_square_sum, rel=1e-2)
        np.testing.assert_allclose(point.shift, both.adjusted.points.xyz[k] - block.points.xyz[k], rtol=1e-2, atol=3e-6)
    assert not {*found[wrong[0]].others, *found[wrong[1]].others}
