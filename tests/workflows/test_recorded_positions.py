"""Positions that fit better than stated; what several cameras' metadata leave open."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.statistics.network import classed
from raybundle.block import Role
from raybundle.io.photos.cameras import camera_groups
from raybundle.io.photos.metadata import Metadata
from raybundle.io.photos.photo import Photo
from raybundle.placing.recorded_positions import camera_notices, with_relative_precision
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.report.text.summary import details


def flight(real, stated, shift=0.0):
    """Positions with errors of one size that state another, all shifted."""
    scene = aerial_scene(AerialStrips(strips=3, images_per_strip=6))
    survey = Survey(image_sigma_px=0.3, station_sigma=real, points="approximate")
    block = simulate(scene, survey).observed
    stations = replace(block.stations, xyz=block.stations.xyz + shift, sigma=np.full_like(block.stations.sigma, stated))
    return block.having(stations)


def told(block):
    found = [n for n in with_relative_precision(adjust_block(block)).notices if n.code == "relative_positions"]
    return found[0] if found else None


def test_relative_precision_and_a_common_shift_are_told_apart():
    notice = told(flight(0.27, 5.0, shift=3.0))
    plan, height = notice.details
    assert [d.values["direction"] for d in notice.details] == ["plan", "height"]
    assert plan.values["sigma_m"] == pytest.approx(0.27, rel=0.35)
    assert height.values["sigma_m"] == pytest.approx(0.27, rel=0.5)
    assert plan.values["stated_m"] == 5.0
    assert notice.values["control"] is False


def test_control_that_is_there_is_not_asked_for():
    block = flight(0.27, 5.0)
    assert told(block).values["control"] is False
    xyz, role, sigma = block.points.xyz, np.array(block.points.role), np.array(block.points.sigma)
    corners = [int(f(xyz[:, 0] + a * xyz[:, 1])) for a in (-1, 1) for f in (np.argmin, np.argmax)]
    role[corners], sigma[corners] = Role.CONTROL, 50.0
    placed = replace(block, points=replace(block.points, role=role, sigma=sigma))
    assert told(placed).values["control"] is True


@pytest.mark.parametrize("sigma", [0.05, 1.0])
def test_positions_as_precise_as_stated_say_nothing(sigma):
    assert told(flight(sigma, sigma)) is None
    assert told(flight(2 * sigma, sigma)) is None


def test_remarks_of_several_cameras_are_one_notice():
    copy = Metadata(model="X", exif_width=4608, exif_height=3456, focal_mm=5.0)
    photos = [
        Photo(path=p, name=p, width_px=2304, height_px=1728, sha256=p, metadata=replace(copy, serial=s))
        for p, s in (("a.jpg", "1"), ("b.jpg", "1"), ("c.jpg", "2"))
    ]
    notices = camera_notices(camera_groups(photos))
    (copy,) = [n for n in notices if n.words == "camera_start.copy"]
    assert copy.code == "camera"
    assert len(copy.ids) == 2
    assert copy.details[0].values == {"cameras": list(copy.ids), "n": 2, "photographs": 3}


def test_classes_of_precision_are_those_of_targets():
    block = flight(1.0, 1.0)
    assert classed(block)
    natural = replace(block, points=replace(block.points, ids=tuple(f"t{k + 1}" for k in range(len(block.points)))))
    assert not classed(natural)
    result = adjust_block(block)
    for adjusted, found in ((result, result.network.precision_class), (adjust_block(natural), "none")):
        (line,) = [m.values for m in details(adjusted) if m.code == "summary.relative_precision"]
        assert line["class_name"] == found
