"""Cleaning of tie points, ray by ray: who leaves, who returns, who may stay alone."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.orientation.cleaning import _rejected, _without_single_rays, clean, sizes
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene

OPTIONS = AdjustmentOptions(jobs=1)
CAMERA = brown_camera(estimate=("c", "K1"))
FREE = {"1": ("c", "K1")}


def simulation(**survey):
    scene = field_scene(TargetField(camera=CAMERA, rows=6, columns=8, stations=8, frontal=2))
    plan = {"orientation": "exact", "points": "exact", "interior": "exact", "image_sigma_px": 0.3, **survey}
    return simulate(scene, Survey(**plan))


def test_a_clean_block_loses_hardly_a_ray():
    s = simulation()
    found = clean(s.observed, OPTIONS, FREE)
    assert found.rejected.mean() < 0.002
    assert 0.7 < found.scale < 1.6


def test_from_poor_approximate_values_too():
    s = simulation(gross_share=0.08, gross_px=40.0, orientation="approximate", points="approximate", approximate=0.01)
    found = clean(s.observed, OPTIONS, FREE)
    assert found.rejected[s.gross].mean() > 0.97
    assert found.rejected[~s.gross].mean() < 0.02
    assert abs(found.block.cameras[0].values["c"] / CAMERA.values["c"] - 1) < 1e-3


def test_what_was_rejected_before_returns_where_it_fits():
    s = simulation(gross_share=0.03)
    wrongly = np.random.default_rng(1).random(len(s.gross)) < 0.15
    found = clean(s.observed, OPTIONS, FREE, rejected=wrongly, first=4.5)
    assert found.rejected[wrongly & ~s.gross].mean() < 0.03
    assert found.rejected[s.gross].mean() > 0.97


def test_the_arguments_are_left_as_they_are():
    s = simulation(gross_share=0.05)
    before = np.zeros(len(s.gross), bool)
    xy = s.observed.observations.xy_px.copy()
    clean(s.observed, OPTIONS, FREE, rejected=before)
    assert not before.any()
    np.testing.assert_array_equal(s.observed.observations.xy_px, xy)


def test_no_tie_point_is_left_with_one_ray():
    s = simulation(gross_share=0.4, gross_px=60.0)
    found = clean(s.observed, OPTIONS, FREE)
    rays = np.bincount(found.block.observations.point[~found.rejected], minlength=len(found.block.points))
    assert not (rays == 1).any()


def test_progress_ends_with_the_whole():
    told = []
    clean(simulation().observed, OPTIONS, FREE, progress=lambda name, share: told.append((name, share)))
    assert {name for name, _ in told} == {"cleaning"}
    shares = [share for _, share in told]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0


def test_sizes_are_residuals_in_units_of_their_sigma():
    s = simulation()
    block, o = s.truth, s.truth.observations
    assert sizes(block).max() < 1e-6
    moved = o.xy_px.copy()
    moved[5] += [0.9, -0.1]
    cov = o.cov_px2.copy()
    cov[5] = [0.3**2, 0.02**2, 0.0]
    changed = replace(block, observations=replace(o, xy_px=moved, cov_px2=cov))
    assert sizes(changed)[5] == pytest.approx(0.1 / 0.02, rel=0.05)
    nowhere = replace(block.points, xyz=np.where(np.arange(len(block.points))[:, None] == 3, np.nan, block.points.xyz))
    size = sizes(replace(block, points=nowhere))
    assert np.isinf(size[o.point == 3]).all()
    assert np.isfinite(size[o.point != 3]).all()


def three_rays(size, before=(False, False, False)):
    """Rows of one point that would leave at a bound of 5; the other points' rays are small."""
    block = simulation().observed
    rows = np.flatnonzero(block.observations.point == 0)[: len(size)]
    sizes_, mask = np.ones(len(block.observations)), np.zeros(len(block.observations), bool)
    sizes_[rows], mask[rows] = size, before
    found = _rejected(block, sizes_, 5.0, mask)
    others = np.delete(found, rows)
    assert not others.any()
    return found[rows].tolist()


def test_of_a_point_the_worst_ray_leaves_first():
    assert three_rays([9.0, 12.0, 6.0]) == [False, True, False]


def test_rays_far_beyond_leave_together():
    assert three_rays([21.0, 40.0, 6.0]) == [True, True, False]


def test_a_rejected_ray_returns_only_well_within_the_bound():
    assert three_rays([3.9, 4.1, 1.0], before=[True, True, False]) == [False, True, False]


@pytest.mark.parametrize(("role", "sigma", "stays"), [(Role.TIE, np.nan, False), (Role.CONTROL, 0.01, True)])
def test_a_ray_alone_stays_only_at_a_control_point(role, sigma, stays):
    block = simulation().observed
    p = block.points
    roles, sigmas = p.role.copy(), p.sigma.copy()
    roles[2], sigmas[2] = role, sigma
    block = replace(block, points=replace(p, role=roles, sigma=sigmas))
    rows = np.flatnonzero(block.observations.point == 2)
    mask = np.zeros(len(block.observations), bool)
    mask[rows[1:]] = True
    assert _without_single_rays(block, mask)[rows[0]] != stays
