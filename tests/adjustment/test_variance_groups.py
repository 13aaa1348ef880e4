"""Variance factors of groups of observations: what the residuals tell, and nothing of what they do not."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle import AdjustmentOptions, adjust
from raybundle.adjustment.decision.variance_groups import _contradicts, chance_to_see
from raybundle.adjustment.records.figures import VarianceComponent
from raybundle.adjustment.statistics.components import LEAST
from raybundle.block import Distances
from raybundle.errors import InputError
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, TargetField, aerial_scene, field_scene
from tests.truth.real_noise import with_smooth_errors

GROUPS = AdjustmentOptions(variance_groups=True, jobs=1)


def survey(seed=3, control=30, sigma=0.02):
    scene = aerial_scene(AerialStrips(strips=2, images_per_strip=5, points_per_image=60, relief=150.0))
    made = Survey(
        orientation="exact", points="exact", interior="exact", image_sigma_px=0.3, control=control,
        control_sigma=(sigma,) * 3, seed=seed,
    )  # fmt: skip
    return simulate(scene, made).observed


def restated(block, image=1.0, control=1.0):
    """The block with other standard deviations than those by which its errors were drawn."""
    o, p = block.observations, block.points
    return replace(
        block, observations=replace(o, cov_px2=o.cov_px2 * image**2), points=replace(p, sigma=p.sigma * control)
    )


def factor(result, kind):
    return next(g for g in result.group_factors if g.kind == kind)


def test_each_group_gets_the_factor_by_which_it_was_stated_wrongly():
    found = [adjust(restated(survey(seed), image=0.5, control=1 / 4), GROUPS) for seed in range(4)]
    image = [factor(r, "image observations").factor for r in found]
    control = [factor(r, "control").factor for r in found]
    assert np.mean(image) == pytest.approx(2, rel=0.03)
    assert np.mean(control) == pytest.approx(4, rel=0.15)
    for r in found:
        assert r.sigma0 == pytest.approx(1, abs=2e-3)
        assert not any(n.code == "global_test" for n in r.notices)
        assert [n.severity for n in r.notices if n.code == "group_less_precise"] == ["fault"]  # four times is no guess


def test_what_the_residuals_do_not_contradict_stays_as_given():
    result = adjust(restated(survey(), image=0.5), GROUPS)
    assert factor(result, "image observations").factor == pytest.approx(2, rel=0.05)
    assert not factor(result, "control").estimated
    np.testing.assert_array_equal(result.given.points.sigma, survey().points.sigma)


def with_bar(block, sigma):
    free = replace(block, points=replace(block.points, role=np.zeros_like(block.points.role)))
    xyz = free.points.xyz
    length = np.array([np.linalg.norm(xyz[3] - xyz[40])])
    return free.adding(
        Distances(start=np.array([3], np.int32), end=np.array([40], np.int32), length=length, sigma=np.array([sigma]))
    )


def test_a_scale_bar_without_redundancy_keeps_its_certificate():
    block = restated(with_bar(survey(), 0.05), image=0.5)
    common, groups = adjust(block, AdjustmentOptions(jobs=1)), adjust(block, GROUPS)
    (one,), (own,) = ([g for g in r.groups if g.kind == "distance"] for r in (common, groups))
    assert one.adjusted_std[0] == pytest.approx(0.05 * common.sigma0, rel=1e-6)
    assert common.sigma0 == pytest.approx(2, rel=0.05)
    assert own.adjusted_std[0] == pytest.approx(0.05, rel=1e-6)
    np.testing.assert_allclose(groups.adjusted.points.xyz, common.adjusted.points.xyz, atol=1e-4)


def test_covariances_are_those_of_the_factors_and_no_others():
    """The same as giving these standard deviations and a variance factor of one."""
    block = restated(survey(), image=0.5, control=1 / 4)
    groups = adjust(block, GROUPS)
    again = adjust(groups.given, AdjustmentOptions(jobs=1))
    np.testing.assert_allclose(
        groups.precision.object_points, again.precision.object_points / again.sigma0**2, rtol=1e-5, atol=1e-16
    )
    assert groups.variance_factor == 1
    assert again.variance_factor == again.sigma0**2


def test_it_is_said_in_the_notices():
    result = adjust(restated(survey(), image=0.5, control=1 / 4), GROUPS)
    (notice,) = [n for n in result.notices if n.code == "variance_groups"]
    (images,) = [d.values for d in notice.details if d.values["kind"] == "image_observations"]
    assert images["factor"] == pytest.approx(2, rel=0.1)
    assert notice.severity == "note"


def test_without_statistics_nothing_tells_factors():
    with pytest.raises(InputError, match=r"adjustment\.groups_without_statistics"):
        adjust(survey(), AdjustmentOptions(variance_groups=True, statistics=False))


def test_image_points_that_are_thousands_of_times_less_precise_are_said_to_be():
    """With factors of groups nothing else would widen what is stated."""
    result = adjust(restated(with_bar(survey(), 0.05), image=5e-4), GROUPS)
    assert factor(result, "image observations").factor == pytest.approx(2000, rel=0.1)
    right = adjust(with_bar(survey(), 0.05), GROUPS)
    ratio = np.nanmedian(result.precision.object_point_std / right.precision.object_point_std)
    assert ratio == pytest.approx(1, rel=0.01)


@pytest.mark.parametrize(("stated", "severity"), [(1 / 2, "warning"), (1 / 5, "fault")])
def test_a_group_that_is_less_precise_than_stated_is_said_to_be(stated, severity):
    result = adjust(restated(survey(), control=stated), GROUPS)
    (notice,) = [n for n in result.notices if n.code == "group_less_precise"]
    assert notice.severity == severity
    assert notice.ids == ("control",)
    assert notice.values["ratio"] == factor(result, "control").factor


def test_a_single_wrong_value_is_named_and_gives_its_group_no_factor():
    block = survey()
    xyz = block.points.xyz.copy()
    wrong = int(np.flatnonzero(block.points.is_control.all(axis=1))[0])
    xyz[wrong, 2] += 1.0
    result = adjust(restated(replace(block, points=replace(block.points, xyz=xyz)), image=0.5), GROUPS)
    (notice,) = [n for n in result.notices if n.code == "control_suspect"]
    assert notice.ids == (block.points.ids[wrong],)
    assert not factor(result, "control").estimated
    assert factor(result, "image observations").factor == pytest.approx(2, rel=0.1)


def test_positions_that_share_an_error_make_a_fault():
    """Positions with a common error of 8 sigma against right control: no factor makes such a result true."""
    from raybundle.block import Stations

    block = survey(sigma=0.02)
    place = np.array([0.16, -0.12, 0.3])
    centre = adjust(block, GROUPS).adjusted.images.centre
    n = len(block.images)
    stations = Stations(image=np.arange(n, dtype=np.int32), xyz=centre + place, sigma=np.full((n, 3), 0.02))
    result = adjust(block.adding(stations), GROUPS)
    assert any(n.severity == "fault" for n in result.notices), [n.text for n in result.notices]


@pytest.mark.parametrize(("bars", "least"), [(2, 0.35), (3, 0.5)])
def test_few_certificates_that_contradict_each_other_get_a_factor(bars, least):
    """Bars five times worse than stated: as often as their redundancy can see, no more."""
    scene = field_scene(TargetField(rows=5, columns=6, stations=8))
    told = []
    for k in range(8):
        block = simulate(
            scene, Survey(seed=100 + k, image_sigma_px=0.1, scale_bars=bars, scale_bar_sigma=5e-4)
        ).observed
        d = block.distances
        block = block.having(replace(d, sigma=np.full_like(d.sigma, 1e-4)))
        a = adjust(block, AdjustmentOptions(jobs=1, datum="inner", variance_groups=True))
        (own,) = [g for g in a.group_factors if g.kind == "distances"]
        named = any(n.code == "distance_suspect" for n in a.notices)
        told.append(own.factor > 2 or named)
        assert not (own.estimated and own.factor < 1)  # so few tell no certificate to be better than it says
    assert np.mean(told) >= least


def test_the_chances_of_the_docs():
    page = (Path(__file__).parents[2] / "docs" / "how-to" / "scale-bars.md").read_text()
    for factor in (2, 5):
        row = " | ".join(f"{100 * chance_to_see(factor, r):.0f} %" for r in (1, 2, 4, 10))
        assert f"| a factor of {factor} | {row} |" in page


@pytest.mark.parametrize(("control", "stated"), [(1.0, True), (1.7, False)])
def test_control_that_fits_better_than_sigma0_states_is_a_remark(control, stated):
    """Smooth errors raise sigma0, and with it what hangs on control; control that is as bad as sigma0 states is not."""
    block = with_smooth_errors(survey(control=60, sigma=0.1), np.random.default_rng(3), 2, 0.6)
    block = restated(block, control=1 / control)
    result = adjust(block, AdjustmentOptions(jobs=1, noise="fields"))
    assert result.noise.kind == "fields"
    found = [n for n in result.notices if n.code == "control_precise"]
    assert bool(found) == stated
    if stated:
        assert found[0].severity == "note"
        assert found[0].values["wider"] == pytest.approx(result.sigma0 / 1.14, rel=0.05)
        grouped = adjust(block, AdjustmentOptions(jobs=1, noise="fields", variance_groups=True))
        assert "control_precise" not in {n.code for n in grouped.notices}


@pytest.mark.parametrize("redundancy", [0.3, 0.7, 3.0, 40.0])
def test_a_stated_standard_deviation_is_contradicted_at_one_percent_two_sided(redundancy):
    """Of wrong values from a redundancy of one half on, of ones that fit too well where there is enough of it."""
    law = chi2(redundancy)
    component = VarianceComponent(
        kind="control", group="all", count=9, redundancy=redundancy, ratio=1.0, significant=False
    )
    low, high = (np.sqrt(law.ppf(p) / redundancy) for p in (0.005, 0.995))
    assert _contradicts(1.001 * high, component) is (redundancy >= 0.5)
    assert not _contradicts(0.999 * high, component)
    assert _contradicts(0.999 * low, component) is (redundancy >= LEAST)
    assert not _contradicts(1.001 * low, component)
    assert not _contradicts(9.0, None)
