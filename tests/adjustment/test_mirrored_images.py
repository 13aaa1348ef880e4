"""Image axes of the other hand are named by the given orientation, and beside control that may be mirrored instead."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import NotSolvable, message
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, Ring, TargetField, aerial_scene, field_scene, ring_scene

OPTIONS = AdjustmentOptions(jobs=1)
SCENES = {
    "testfield": lambda: (field_scene(TargetField(stations=4)), {"scale_bars": 2}),
    "ring": lambda: (ring_scene(Ring()), {"scale_bars": 2}),
    "aerial": lambda: (aerial_scene(AerialStrips()), {"control": 8, "control_sigma": (0.02, 0.02, 0.03)}),
}
MENDS = {
    "y_up": lambda xy, size: xy * [1, -1] + [0, size[1]],
    "x_left": lambda xy, size: xy * [-1, 1] + [size[0], 0],
    "xy": lambda xy, _: xy[:, ::-1],
    "xy_negative": lambda xy, size: size[::-1] - xy[:, ::-1],
}


def simulated(kind, **survey):
    scene, given = SCENES[kind]()
    return simulate(scene, Survey(seed=2, **given, **survey)).observed


def with_images(block, mend):
    camera, o = block.cameras[0], block.observations
    size = np.array([camera.width_px, camera.height_px], float)
    return replace(block, observations=replace(o, xy_px=np.ascontiguousarray(MENDS[mend](o.xy_px, size))))


def answer(block):
    try:
        result = adjust(block, OPTIONS)
    except NotSolvable as error:
        return str(error)
    return " ".join(n.text for n in result.notices if n.severity == "fault")


@pytest.mark.parametrize(
    ("kind", "mend"),
    [*(("testfield", m) for m in MENDS), ("ring", "y_up"), ("aerial", "y_up")],
)
def test_mirrored_image_points_are_named_by_their_mend(kind, mend):
    found = answer(with_images(simulated(kind), mend))
    assert message("images_mirrored.mend", mend=mend).text() in found


def test_without_orientation_images_and_control_may_be_mirrored():
    block = with_images(simulated("aerial", orientation="absent"), "y_up")
    found = answer(block)
    for cause in (message("control_contradicts.mend", mend="xy"), message("images_mirrored.mend", mend="y_up")):
        assert cause.text() in found


@pytest.mark.parametrize("kind", list(SCENES))
@pytest.mark.parametrize("orientation", ["approximate", "exact", "absent"])
def test_right_image_points_are_not_accused(kind, orientation):
    assert "mirror" not in answer(simulated(kind, orientation=orientation))
