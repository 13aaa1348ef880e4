"""Differences at check points are held against what the result says of itself."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.special import chdtri

from raybundle import adjust
from raybundle.adjustment.evaluation.check_points import check_differences
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of

OPTIONS = AdjustmentOptions(jobs=1)
SIGMA = 1e-4


def block_with_checks(seed=1, shift=(0.0, 0.0, 0.0), count=6):
    """Five control points and some check points, whose given coordinates are off by this and by their sigma."""
    scene = field_scene(TargetField(stations=6, frontal=0, camera=brown_camera(estimate=())))
    survey = Survey(
        seed=seed, orientation="exact", points="exact", interior="exact", control=5, control_sigma=(SIGMA,) * 3
    )
    done = simulate(scene, survey)
    block, truth = done.observed, done.truth
    tie = np.flatnonzero(~block.points.is_control.any(axis=1))[5 : 5 + count]
    role, xyz, sigma = block.points.role.copy(), block.points.xyz.copy(), block.points.sigma.copy()
    role[tie] = Role.CHECK
    xyz[tie] = truth.points.xyz[tie] + shift + np.random.default_rng(seed).normal(0, SIGMA, (count, 3))
    sigma[tie] = SIGMA
    return replace(block, points=replace(block.points, role=role, xyz=xyz, sigma=sigma))


def told(result):
    return [n for n in result.notices if n.code == "check_points_apart"]


@pytest.mark.parametrize("seed", range(5))
def test_differences_as_stated_say_nothing(seed):
    result = adjust(block_with_checks(seed), OPTIONS)
    assert np.isfinite(check_differences(result)[1]).sum() == 18
    assert not told(result)


def test_gross_differences_are_a_fault_that_the_headline_hears():
    result = adjust(block_with_checks(shift=(0.0, 0.02, 0.0)), OPTIONS)
    (notice,) = told(result)
    assert notice.severity.value == "fault"
    assert notice.values["axes"] == ["Y"]
    assert verdict(view_of(result)).headline.messages[-1].code == "verdict.faults"


def test_differences_that_only_uncorrelated_errors_would_not_make_are_a_caution():
    result = adjust(block_with_checks(shift=(0.0, 0.0, 3.2 * SIGMA), count=12), OPTIONS)
    (notice,) = told(result)
    assert notice.severity.value == "warning"


def test_points_are_named_with_their_value_and_limit_where_they_are_beyond_it():
    block = block_with_checks()
    xyz = block.points.xyz.copy()
    bad = np.flatnonzero(block.points.role == Role.CHECK)[2]
    xyz[bad, 1] += 0.02
    (notice,) = told(adjust(replace(block, points=replace(block.points, xyz=xyz)), OPTIONS))
    assert notice.ids == (block.points.ids[bad],)
    (point,) = [d.values for d in notice.details if d.code == "check_points_apart.point"]
    assert (point["point"], point["axis"]) == (block.points.ids[bad], "Y")
    assert point["limit"] == pytest.approx(np.sqrt(chdtri(1, 1e-3 / 3 / 6)))


def loosened(block, sigma=np.nan):
    """The block whose control is given with these standard deviations alone, NaN for what is not."""
    role, sigmas = block.points.role.copy(), block.points.sigma.copy()
    control = role == Role.CONTROL
    sigmas[control] = sigma
    if np.isnan(sigmas[control]).all():
        role[control] = Role.TIE
    return replace(block, points=replace(block.points, role=role, sigma=sigmas))


def test_where_the_datum_is_arbitrary_nothing_is_compared_and_that_is_said():
    result = adjust(loosened(block_with_checks(shift=(0.0, 0.02, 0.0))), OPTIONS)
    assert not told(result)
    assert not np.isfinite(check_differences(result)[1]).any()
    (said,) = [n for n in result.notices if n.code == "check_points_open"]
    assert said.values["axes"] == ["X", "Y", "Z"]
    assert "scale" in {d.values.get("part") for d in said.details}


def test_what_is_determined_is_compared_beside_what_is_open():
    """Control in plan alone leaves the height open, and X and Y of check points are as good as ever."""
    block = loosened(block_with_checks(shift=(0.02, 0.0, 5.0)), (SIGMA, SIGMA, np.nan))
    result = adjust(block, OPTIONS)
    assert result.datum_defect == ("position Z",)
    (notice,) = told(result)
    assert notice.values["axes"] == ["X"]
    (said,) = [n for n in result.notices if n.code == "check_points_open"]
    assert said.values["axes"] == ["Z"]
    assert said.values["part"] == "position_z"


@pytest.mark.parametrize("left", [0, 1])
def test_a_check_point_with_too_few_rays_takes_no_part_by_name(left):
    block = block_with_checks()
    o = block.observations
    k = int(np.flatnonzero(block.points.role == Role.CHECK)[0])
    keep = np.ones(len(o), bool)
    keep[np.flatnonzero(o.point == k)[left:]] = False
    o = replace(o, image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep], cov_px2=o.cov_px2[keep])
    result = adjust(replace(block, observations=o), OPTIONS)
    (said,) = [n for n in result.notices if n.code == "check_unseen"]
    assert said.ids == (block.points.ids[k],)
    assert not np.isfinite(check_differences(result)[1][0]).any()
    assert np.isfinite(check_differences(result)[1][1:]).all()
