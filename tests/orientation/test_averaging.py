"""The start from all pairs at once: places of simulated blocks with blunders, disagreeing pairs, wrong cameras."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block.select import with_rows
from raybundle.errors import NoOrientation
from raybundle.numerics.transform import similarity
from raybundle.orientation.averaging import average_start
from raybundle.orientation.projective.camera_constant import checked_by_pairs
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, Ring, aerial_scene, brown_camera, ring_scene
from tests.orientation.scenes import room

NOTHING = Survey(
    orientation="absent", points="absent", interior="exact", image_sigma_px=0.5, gross_share=0.03, gross_px=100.0
)


def wide_angle():
    values = {"c": 18.0, "x0": 0.0, "y0": 0.0, "K1": 0.0, "K2": 0.0, "K3": 0.0, "P1": 0.0, "P2": 0.0}
    return brown_camera(values=values, size_px=(6000, 4000), pixel_mm=0.006, estimate=())


def placed(found, truth):
    """Largest error of the projection centres after a similarity, as a share of their extent."""
    ok = found.images.oriented
    here, there = found.images.centre[ok], truth.images.centre[ok]
    t = similarity(here, there)
    return np.linalg.norm(t.points(here) - there, axis=1).max() / np.ptp(there, axis=0).max()


@pytest.mark.parametrize(
    "scene", [aerial_scene(AerialStrips(strips=3)), ring_scene(Ring(stations=20))], ids=["strips", "ring"]
)
def test_all_images_are_placed_in_spite_of_blunders(scene):
    s = simulate(scene, NOTHING)
    found = average_start(s.observed)
    assert found.images.oriented.all()
    assert placed(found, s.truth) < 0.01
    known = np.isfinite(found.points.xyz).all(axis=1)
    assert known.mean() > 0.8


def test_pairs_that_contradict_the_others_have_no_say():
    s = simulate(aerial_scene(AerialStrips(strips=3)), NOTHING)
    o = s.observed.observations
    # in one image the points are mirrored: its pairs have relative orientations that fit no third image
    mine = o.image == 7
    xy = o.xy_px.copy()
    xy[mine, 0] = 10_000 - xy[mine, 0]
    found = average_start(replace(s.observed, observations=replace(o, xy_px=xy)))
    others = np.arange(len(s.truth.images)) != 7
    assert found.images.oriented[others].all()
    keep = replace(found, images=replace(found.images, centre=np.where(others[:, None], found.images.centre, np.nan)))
    assert placed(keep, s.truth) < 0.01


def test_parts_without_common_points_do_not_mix():
    s = simulate(aerial_scene(AerialStrips(strips=2)), NOTHING)
    o = s.observed.observations
    n = len(s.truth.images)
    # the points between the two strips are gone
    strip = o.image >= n // 2
    both = np.isin(o.point, np.intersect1d(o.point[strip], o.point[~strip]))
    found = average_start(with_rows(s.observed, ~both))
    assert found.images.oriented[: n // 2].all() != found.images.oriented[n // 2 :].all()


def test_a_camera_constant_far_off_is_corrected_by_pairs():
    # views that all meet in one axis would not determine it (Sturm et al. 2005)
    s = simulate(room(wide_angle(), 24, seed=5, points=1500), NOTHING)
    camera = s.observed.cameras[0]
    c = camera.values["c"]
    off = replace(camera, values={**camera.values, "c": 1.35 * c}, estimate=("c",))
    assert checked_by_pairs(s.observed.with_cameras(off)).cameras[0].values["c"] == pytest.approx(c, rel=0.05)
    right = replace(camera, estimate=("c",))
    assert checked_by_pairs(s.observed.with_cameras(right)).cameras[0].values["c"] == pytest.approx(c, rel=0.03)
    held = replace(off, estimate=())
    assert checked_by_pairs(s.observed.with_cameras(held)).cameras[0].values["c"] == 1.35 * c


def test_images_without_any_relative_orientation_are_refused():
    """Points that are nowhere the same: chance alone."""
    s = simulate(ring_scene(Ring(stations=4)), NOTHING)
    o = s.observed.observations
    xy = np.random.default_rng(3).uniform(0, (6000, 4000), (len(o), 2))
    with pytest.raises(NoOrientation, match=r"orientation\.no_pair"):
        average_start(replace(s.observed, observations=replace(o, xy_px=xy)))
