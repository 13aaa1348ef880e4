"""Image points outside the format are counted and the farthest is told; those at its border are not."""

from dataclasses import replace

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from tests.adjustment.test_wrong_control import CORNERS, network

OPTIONS = AdjustmentOptions(jobs=1)


def outside(result):
    return [n for n in result.notices if n.code == "outside_format"]


def test_the_farthest_is_told_with_its_image_and_format():
    block, _ = network(CORNERS)
    o = block.observations
    assert not outside(decide(block, OPTIONS))
    camera = block.cameras[0]
    smaller = replace(camera, width_px=camera.width_px - 2000)
    xy = o.xy_px - [1000, 0]  # the middle of the format stays
    small = replace(block, cameras=(smaller,), observations=replace(o, xy_px=xy))
    (notice,) = outside(decide(small, OPTIONS))
    beyond = np.maximum(-xy, xy - [smaller.width_px, smaller.height_px])
    k = beyond.max(axis=1).argmax()
    assert notice.severity == "warning"
    assert notice.values["n"] == (beyond > 1.1).any(axis=1).sum()
    assert notice.values["image"] == block.images.ids[o.image[k]]
    assert notice.values["width_px"] == smaller.width_px


def test_half_a_pixel_of_another_origin_is_not_told():
    block, _ = network(CORNERS)
    o = block.observations
    xy = o.xy_px.copy()
    k = xy[:, 0].argmin()
    xy[k, 0] = -0.5
    assert not outside(decide(replace(block, observations=replace(o, xy_px=xy)), OPTIONS))
