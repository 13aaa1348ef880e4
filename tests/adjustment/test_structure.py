"""Structure in residuals: none in simulated blocks, found where the interior orientation was not the same."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.structure import residual_structure, structure_notice
from raybundle.block.simulate import AerialStrips, Survey, aerial_scene, simulate


@pytest.fixture(scope="module")
def block():
    scene = aerial_scene(AerialStrips(strips=2, images_per_strip=5, points_per_image=1500, relief=150.0))
    survey = Survey(
        orientation="exact", points="exact", interior="exact", image_sigma_px=0.2, control=8,
        control_sigma=(0.02, 0.02, 0.02),
    )  # fmt: skip
    return simulate(scene, survey).observed


def adjusted(block):
    return adjust_block(block, AdjustmentOptions(threads=1, tolerance=1e-3))


def test_independent_errors_show_no_structure(block):
    found = residual_structure(adjusted(block))
    assert found.pairs > 5000
    # the adjustment itself correlates residuals a little
    assert abs(found.correlation) < 0.01
    assert found.factor < 1.1
    assert structure_notice(adjusted(block)) is None


def test_a_lens_that_differs_between_images_is_noticed_with_the_images(block):
    o = block.observations
    camera = block.cameras[0]
    half = np.array([camera.width_px, camera.height_px]) / 2
    x = (o.xy_px - half) / half[0]
    # the distortion of three images is another one: 3 px at the edge
    wrong = np.isin(o.image, [2, 5, 7])
    xy = o.xy_px + np.where(wrong[:, None], 3 * x * (x**2).sum(axis=1, keepdims=True), 0.0)
    result = adjusted(replace(block, observations=replace(o, xy_px=xy)))
    found = residual_structure(result)
    assert found.correlation > 0.1
    assert found.factor > 1.5
    notice = structure_notice(result)
    assert notice is not None
    assert set(notice.ids) <= {block.images.ids[i] for i in range(10)}
    named = {block.images.ids[i] for i in (2, 5, 7)}
    assert len(named & set(notice.ids)) >= 2
    assert "too small, by a factor of" in notice.message


def test_few_points_give_no_answer(block):
    from raybundle.block.select import with_rows

    few = with_rows(block, np.isin(block.observations.point, np.arange(60)))
    assert residual_structure(adjusted(few)) is None
