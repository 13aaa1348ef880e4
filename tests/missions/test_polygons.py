"""Polygons: what is none is refused with the place; what lies within; where lines enter and leave."""

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.missions.polygons import (
    along,
    checked_ring,
    distance_to,
    inside,
    longest_direction,
    signed_area,
    widened,
    within,
)
from raybundle.numerics.planes import hull

NOTCHED = np.array([[0.0, 0], [10, 0], [10, 10], [5, 3], [0, 10]])


def test_what_is_no_area_is_refused():
    bow = [[0.0, 0], [10, 10], [10, 0], [0, 10]]
    with pytest.raises(InputError, match=r"the area crosses itself: the edge after corner 1 .* 5\.0, 5\.0"):
        checked_ring(np.array(bow), "the area")
    with pytest.raises(InputError, match="has no extent"):
        checked_ring(np.array([[0.0, 0], [5, 5], [10, 10]]), "the area")
    with pytest.raises(InputError, match="2 different corners"):
        checked_ring(np.array([[0.0, 0], [5, 5], [5, 5]]), "the area")


def test_corners_run_counter_clockwise_and_once():
    ring = checked_ring(np.array([[0.0, 0], [0, 10], [10, 10], [10, 10], [10, 0]]), "the area")
    assert len(ring) == 4
    assert signed_area(ring) == pytest.approx(100)


def test_within():
    assert inside(NOTCHED, np.array([[5.0, 2], [5, 4], [1, 9], [-1, 5]])).tolist() == [True, False, False, False]
    parts = within([NOTCHED], np.array([-5.0, 5]), np.array([15.0, 5]))
    np.testing.assert_allclose(parts, [(0.25, 0.25 + 25 / 7 / 20), (0.75 - 25 / 7 / 20, 0.75)])
    assert distance_to(NOTCHED, np.array([[5.0, -2], [12, 5]])) == pytest.approx([2, 2])


def test_a_strip_is_covered_as_far_as_the_area_reaches_in_it():
    np.testing.assert_allclose(along(NOTCHED, 4.0, 6.0), [(0, 5 - 5 / 7), (5 + 5 / 7, 10)])
    np.testing.assert_allclose(along(NOTCHED, 0.5, 2.0), [(0, 10)])


@pytest.mark.parametrize("azimuth", [0.0, 20.0, 75.0, 130.0])
def test_lines_run_along_the_longer_side(azimuth):
    a = np.radians(azimuth)
    u, v = np.array([np.sin(a), np.cos(a)]), np.array([np.cos(a), -np.sin(a)])
    ring = np.array([0 * u, 30 * u, 30 * u + 10 * v, 10 * v])
    assert np.degrees(longest_direction(ring)) == pytest.approx(azimuth)


def test_a_widened_outline_is_as_far_away_as_asked():
    ring = widened(NOTCHED, 2.0)
    assert distance_to(ring, hull(NOTCHED)).min() >= 2.0 - 1e-9
    assert distance_to(ring, hull(NOTCHED)).max() < 2.1
