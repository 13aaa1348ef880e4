"""Images whose points lie on one line are named; points beside it, or an observed position, determine them."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
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
