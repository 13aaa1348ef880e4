"""Places at which photographs are counted fill the area to its outline, and so does the picture of them."""

import re

import numpy as np
import pytest
from scipy.spatial import cKDTree
from tests.missions.cases import LEVEL, OUTLINES, PLACE, mission

from raybundle.missions.places import places
from raybundle.missions.polygons import distance_to, inside, part_in_box, signed_area
from raybundle.missions.report import mission_facts
from raybundle.report.figures.mission import SEEN, plan_view

RINGS = {
    "field": OUTLINES["area"],
    "square on the grid": np.array([[0.0, 0], [100, 0], [100, 100], [0, 100]]) + PLACE,
    "angle": np.array([[0.0, 0], [200, 0], [200, 30], [30, 30], [30, 150], [0, 150]]) + PLACE,
    "thinner than a square": np.array([[0.0, 0], [200, 90], [201, 92], [1, 3]]) + PLACE,
    "smaller than a square": np.array([[1.0, 1], [3, 2], [2, 4]]) + PLACE,
}


@pytest.mark.parametrize("ring", RINGS.values(), ids=RINGS)
def test_parts_of_squares_are_the_area(ring):
    where = places(ring, 10.0, LEVEL)
    area = abs(signed_area(ring))
    assert where.area_m2() == pytest.approx(area, rel=1e-6)
    assert (where.part > 0).all()
    assert (where.part <= 1).all()
    # the places, weighted by their parts, have the centre of gravity of the area
    middle = part_in_box(ring, ring.min(axis=0), ring.max(axis=0))
    assert middle[0] == pytest.approx(area)
    weighted = np.average(where.xyz[:, :2], axis=0, weights=where.part)
    np.testing.assert_allclose(weighted, middle[1], atol=1e-4)
    assert np.abs(where.xyz[:, :2] - where.middle).max() <= 5.0


@pytest.mark.parametrize("ring", RINGS.values(), ids=RINGS)
def test_every_point_of_the_area_lies_in_a_square_of_the_picture(ring):
    where = places(ring, 10.0, LEVEL)
    rng = np.random.default_rng(5)
    low, high = ring.min(axis=0), ring.max(axis=0)
    xy = rng.uniform(low, high, (20_000, 2))
    xy = xy[inside(ring, xy) & (distance_to(ring, xy) > 1e-6)]
    off, _ = cKDTree(where.middle).query(xy, p=np.inf)
    assert off.max() <= 5.0 + 1e-6


def test_the_picture_is_cut_to_the_outline_and_nothing_in_it_looks_like_paper():
    m = mission("nadir")
    facts = mission_facts(m, LEVEL)
    assert facts.coverage.count.min() >= 6
    svg = plan_view(m, facts.coverage)
    clip = re.search(r'<clipPath id="outline"><path d="([^"]*)Z"/>', svg)
    drawn = re.search(r'<path class="area" d="([^"]*)"/>', svg)
    assert drawn[1].startswith(clip[1])  # the same corners, the drawn one closed by the first again
    inside_group = svg[svg.index('<g clip-path="url(#outline)">') :].split("</g>")[0]
    colours = set(re.findall(r'fill="(#\w+)"', inside_group))
    assert colours == {dict(SEEN)[5], dict(SEEN)[9]} or colours == {dict(SEEN)[9]}
    assert "#ffffff" not in dict(SEEN).values()


def test_what_no_outline_bounds_is_not_cut():
    from raybundle.missions.mission import exposures
    from raybundle.missions.places import free_places
    from raybundle.missions.views import coverage

    m = mission("corridor")
    where = free_places(np.column_stack([OUTLINES["line"], np.full(3, 100.0)]), 5.0)
    assert where.area_m2() == pytest.approx(75.0)
    assert "clipPath" not in plan_view(m, coverage(m.camera, exposures(m), where))
