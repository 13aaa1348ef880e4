"""Photographs that hang on one connection are named, by points that a program found alone."""

from dataclasses import replace

import pytest

from raybundle import adjust
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene

FIELD = TargetField(camera=brown_camera(size_px=(3000, 2000), pixel_mm=0.008), stations=4, rows=5, columns=5)


@pytest.mark.parametrize(("name", "told"), [("t", True), ("p", False)])
def test_few_common_points_are_told_of_found_points_alone(name, told):
    block = simulate(field_scene(FIELD), Survey()).observed  # 25 points: no two images have 30 in common
    block = replace(block, points=replace(block.points, ids=tuple(f"{name}{i}" for i in block.points.ids)))
    notices = [n for n in adjust(block).notices if n.code == "weak_photographs"]
    assert bool(notices) is told
    assert not told or set(notices[0].ids) == set(block.images.ids)
    assert not told or notices[0].severity == "fault"  # the whole block hangs on few points
    assert not told or notices[0].values == {"weak": 8, "photographs": 8, "common": 30}
