"""Images whose points lie on one line are named; points beside it, or an observed position, determine them."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.blunders.collinear_points import any_in_line
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Stations
from raybundle.errors import RankDefect
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene

OPTIONS = AdjustmentOptions(jobs=1)


def block_of(beside, seed=1):
    """Points along a line, two of them so far beside it [m]."""
    scene = field_scene(TargetField(stations=6, frontal=0, camera=brown_camera(estimate=())))
    xyz = np.linspace(-1, 1, 30)[:, None] * np.array([1.0, 0.2, 0.0])
    xyz[[5, 20]] += beside * np.array([[-0.2, 1.0, 0.5], [0.2, -1.0, 0.5]])
    survey = Survey(seed=seed, orientation="exact", points="exact", interior="exact", image_sigma_px=0.1)
    block = simulate(replace(scene, xyz=xyz, normal=None), survey).observed
    noise = np.random.default_rng(seed).normal(0, 1e-4, xyz.shape)  # approximate values are never straight
    return replace(block, points=replace(block.points, xyz=block.points.xyz + noise))


@pytest.mark.parametrize("seed", range(3))
def test_images_of_a_line_are_named(seed):
    block = block_of(0.0, seed)
    with pytest.raises(RankDefect) as caught:  # in the solution, or already in the iteration that leads there
        adjust(block, OPTIONS)
    assert set(caught.value.names("image")) == set(block.images.ids)


def test_a_line_in_the_solution_says_what_is_missing():
    with pytest.raises(RankDefect, match=r"Measure.*image\.points_in_line"):
        adjust(block_of(0.0, 0), OPTIONS)


def test_two_points_beside_the_line_are_enough():
    result = adjust(block_of(0.1), OPTIONS)
    assert result.converged
    assert np.sqrt(np.einsum("ikk->ik", result.precision.images)[:, 3:]).max() < 0.05  # rad


def test_an_observed_position_tells_where_an_image_stands():
    block = block_of(0.0)
    n = len(block.images)
    stations = Stations(image=np.arange(n, dtype=np.int32), xyz=block.images.centre, sigma=np.full((n, 3), 1e-3))
    assert adjust(block.having(stations), OPTIONS).converged


@pytest.mark.parametrize(("beside", "asked"), [(0.09, True), (0.11, False)])
def test_points_within_a_tenth_of_their_length_are_asked_whether_they_lie_on_a_line(beside, asked):
    """Standard deviations across over those along; a point far off, as at infinity, is left out."""
    block = block_of(0.0)
    t = np.linspace(-1, 1, len(block.points))
    across = np.where(np.arange(len(t)) % 2, 1, -1) * beside * t.std()
    xyz = np.stack([t, across, np.zeros(len(t))], axis=1) @ np.linalg.qr(np.arange(9.0).reshape(3, 3) ** 2)[0]
    used = np.ones(len(block.observations), bool)
    assert any_in_line(replace(block, points=replace(block.points, xyz=xyz)), used) is asked
    xyz[3] *= 1e4
    assert any_in_line(replace(block, points=replace(block.points, xyz=xyz)), used) is asked
    one = used & (block.observations.image == 2)
    assert any_in_line(replace(block, points=replace(block.points, xyz=xyz)), one) is asked
