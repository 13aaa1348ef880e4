"""Points are carried neither through a camera nor through infinity; those whose rays diverge leave by name."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.far_points import FAR, FARTHEST, diverging, retracted, turned_about
from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Role
from raybundle.block.rejection import RejectionKind
from raybundle.planning.simulate import Simulation, Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene

RAYS = np.array([[0.0, 0.0, 10.0], [3.0, -4.0, 0.0], [1.0, 1.0, 1.0]])


@pytest.mark.parametrize("share", [-0.5, -1.0, -3.0, -1e6])
def test_no_step_carries_a_point_through_its_camera(share):
    which, ray = retracted(RAYS, share * RAYS)
    assert which.tolist() == [0, 1, 2]
    assert np.allclose(ray, RAYS / (1 - share))
    assert (np.einsum("ij,ij->i", ray, RAYS) > 0).all()


def test_a_step_away_is_taken_as_it_is():
    assert len(retracted(RAYS, 50 * RAYS)[0]) == 0


def test_a_short_step_is_the_linear_one_to_second_order():
    step = -0.03 * RAYS + 0.01 * np.roll(RAYS, 1, axis=1)
    which, ray = retracted(RAYS, step)
    assert len(which) >= 2
    assert np.abs(ray - (RAYS + step)[which]).max() < 2 * np.abs(step).max() ** 2


def test_a_point_behind_is_placed_before_on_the_same_ray():
    new = turned_about(RAYS, 5.0)
    assert np.allclose(np.linalg.norm(new, axis=1), 5.0 * FAR)
    assert np.allclose(np.einsum("ij,ij->i", new, RAYS), -5.0 * FAR * np.linalg.norm(RAYS, axis=1))


def test_only_what_is_beyond_the_farthest_diverges():
    rays = np.vstack([np.tile(RAYS[:1], (9, 1)), [[0, 0, 0.9 * FARTHEST * 10]], [[0, 0, 1.1 * FARTHEST * 10]]])
    assert diverging(rays).tolist() == [10]
    assert len(diverging(np.zeros((0, 3)))) == 0


def with_diverging_rays(survey: Simulation, count: int):
    """The block with wrong matches, rays of `count` tie points that meet behind their cameras, and the points."""
    truth, block = survey.truth, survey.observed
    o, C = block.observations, truth.images.centre
    xy, found = o.xy_px.copy(), []
    for k in np.flatnonzero(block.points.role == Role.TIE):
        rows = np.flatnonzero(o.point == k)
        first = C[o.image[rows[0]]]
        ray = truth.points.xyz[k] - first
        # inverse distance -0.3 of what it is
        new = np.array(
            [predicted_px(truth, int(i), (C[i] + 1e6 * (ray - 0.3 * (first - C[i])))[None])[0] for i in o.image[rows]]
        )
        if len(rows) > 2 and np.isfinite(new).all() and len(found) < count:
            xy[rows], found = new, [*found, k]
    return replace(block, observations=replace(o, xy_px=xy)), np.array(found)


@pytest.mark.parametrize("points", ["approximate", "exact"])
def test_points_whose_rays_diverge_leave_by_name_and_the_others_keep_their_place(points):
    survey = simulate(aerial_scene(AerialStrips()), Survey(control=8, points=points, orientation="approximate"))
    good = adjust_block(survey.observed, AdjustmentOptions())
    wrong, mine = with_diverging_rays(survey, 3)
    result = adjust_block(wrong, AdjustmentOptions())
    rejected = np.array([r.kind if r else "" for r in result.image_observations.rejected])
    of_them = np.isin(wrong.observations.point, mine)
    assert len(mine) == 3
    assert set(rejected[of_them]) == {RejectionKind.RAYS_DIVERGE}
    assert set(rejected[~of_them]) == {""}
    notice = next(n for n in result.notices if n.code == "rays_diverge")
    assert set(notice.ids) == {wrong.points.ids[k] for k in mine}
    assert result.sigma0 == pytest.approx(good.sigma0, rel=0.05)
