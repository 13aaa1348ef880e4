"""Image points that tell no block are refused, and by their median: neither great noise nor some gross errors are."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.defects import SCATTERED
from raybundle.errors import NoConvergence
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene


def field(share, gross=0.0):
    """A field whose image points have errors of this share of the diagonal, some of them of three times the limit."""
    scene = field_scene(TargetField(stations=6, frontal=0, camera=brown_camera(estimate=())))
    block = simulate(scene, Survey(orientation="exact", points="exact", interior="exact", control=8)).observed
    camera, o = block.cameras[0], block.observations
    diagonal = np.hypot(camera.width_px, camera.height_px)
    rng = np.random.default_rng(2)
    e = share * diagonal * rng.normal(size=o.xy_px.shape)
    e[rng.random(len(e)) < gross] += 3 * SCATTERED * diagonal
    return replace(block, observations=replace(o, xy_px=o.xy_px + e))


@pytest.mark.parametrize(("share", "gross"), [(0.01, 0.0), (1e-5, 0.05)])
def test_a_result_is_given(share, gross):
    result = adjust(field(share, gross), AdjustmentOptions(jobs=1))
    assert "global_test" in {n.code for n in result.notices}
    assert result.sigma0 > 3


def test_what_tells_no_block_is_refused_with_its_figure_and_limit():
    with pytest.raises(NoConvergence, match=r"5.*adjustment\.image_points_contradict"):
        adjust(field(3 * SCATTERED), AdjustmentOptions(jobs=1))
