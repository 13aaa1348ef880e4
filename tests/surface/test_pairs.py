"""Which photographs measure a surface together."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.surfaces.depths.pairs import FLATTEST_DEG, LARGEST_SCALE, MOST_SOURCES, PairOfImages, sources_of_each


@pytest.fixture(scope="module")
def flight():
    return simulate(aerial_scene(AerialStrips(images_per_strip=7, points_per_image=60)), Survey(seed=3)).truth


def test_sources_stand_on_all_sides_of_a_reference(flight):
    found = sources_of_each(flight)
    assert len(found) == len(flight.images)
    inner = found[10]
    assert inner.reference not in inner.sources
    assert 2 <= len(inner.sources) <= MOST_SOURCES
    away = flight.images.centre[list(inner.sources)] - flight.images.centre[10]
    # two sources on one side tell less than one on each: some stand before, some behind along the line
    along = away @ (flight.images.centre[11] - flight.images.centre[10])
    assert along.min() < 0 < along.max()
    assert inner.seen > 0.9


def test_a_pair_tells_its_points_angle_and_scale(flight):
    o, xyz, centre = flight.observations, flight.points.xyz, flight.images.centre
    pair = next(p for p in sources_of_each(flight)[3].pairs if p.source == 4)
    common = np.intersect1d(o.point[o.image == 3], o.point[o.image == 4])
    assert pair.points == len(common)
    a, b = xyz[common] - centre[3], xyz[common] - centre[4]
    cosine = (a * b).sum(axis=1) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
    assert pair.angle_deg == pytest.approx(np.degrees(np.median(np.arccos(cosine))))
    assert pair.scale == pytest.approx(np.median(np.linalg.norm(b, axis=1) / np.linalg.norm(a, axis=1)))


def test_pairs_of_no_use_are_refused_with_the_number(flight):
    # image 11 moves to where image 10 stands
    centre = flight.images.centre.copy()
    centre[11] = centre[10] + [0.2, 0, 0]
    beside = replace(flight, images=replace(flight.images, centre=centre))
    found = sources_of_each(beside)[10]
    assert 11 not in found.sources
    (refused,) = [p for p in found.refused if p.source == 11]
    assert f"{FLATTEST_DEG:g}° are needed" in refused.refusal
    far = PairOfImages(reference=0, source=1, points=50, angle_deg=15.0, scale=2.5)
    assert f"2.5 (limit {LARGEST_SCALE:g})" in far.refusal
    assert not PairOfImages(reference=0, source=1, points=50, angle_deg=15.0, scale=1.2).refusal


def test_an_image_that_has_nothing_in_common_has_no_sources(flight):
    o = flight.observations
    alone = replace(flight, observations=o.rows(np.flatnonzero(o.image != 5)))
    found = sources_of_each(alone)
    assert found[5].sources == ()
    assert found[5].seen == 0.0
    assert all(5 not in f.sources for f in found)
