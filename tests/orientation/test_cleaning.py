"""Cleaning of tie points: wrong rays leave, right ones stay, wrong weights do not matter."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import free_parameters
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.orientation.cleaning import clean, sizes
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene


@pytest.mark.parametrize("stated", [1.0, 7.0])
def test_wrong_rays_leave_whatever_the_weights(stated):
    survey = Survey(gross_share=0.05, gross_px=60, image_sigma_px=0.2, scale_bars=1)
    simulation = simulate(field_scene(TargetField(rows=12, columns=14)), survey)
    block = simulation.observed
    block = replace(block, points=replace(block.points, xyz=simulation.truth.points.xyz + 0.002))
    o = block.observations
    block = replace(block, observations=replace(o, cov_px2=o.cov_px2 * stated**2))
    free = {c.id: free_parameters(c) for c in block.parametrised}
    found = clean(block, AdjustmentOptions(jobs=1), free)
    assert found.rejected[simulation.gross].mean() > 0.98
    assert found.rejected[~simulation.gross].mean() < 0.02
    assert found.scale * stated == pytest.approx(1.0, abs=0.15)
    kept = ~found.rejected
    assert np.median(sizes(found.block)[kept]) * stated < 1.5
