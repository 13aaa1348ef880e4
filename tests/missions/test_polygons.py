"""Polygons: what is none is refused with the place; what lies within; where lines enter and leave."""

from time import process_time

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.missions.polygons import (
    along,
    astray,
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
    with pytest.raises(InputError, match=r"1.*5\.0.*flight_area\.crosses_itself"):
        checked_ring(np.array(bow), "area")
    with pytest.raises(InputError, match=r"flight_area\.no_area"):
        checked_ring(np.array([[0.0, 0], [5, 5], [10, 10]]), "area")
    with pytest.raises(InputError, match=r"2.*flight_area\.too_few_corners"):
        checked_ring(np.array([[0.0, 0], [5, 5], [5, 5]]), "area")


def test_corners_run_counter_clockwise_and_once():
    ring = checked_ring(np.array([[0.0, 0], [0, 10], [10, 10], [10, 10], [10, 0]]), "area")
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


def test_outlines_of_thirty_thousand_corners_are_checked_in_seconds():
    turn = np.arange(30_000) / 30_000 * 2 * np.pi
    far = 1200 + 100 * np.sin(900 * turn)
    ring = np.stack([far * np.cos(turn), far * np.sin(turn)], axis=1)
    begin = process_time()
    assert len(checked_ring(ring, "area")) == 30_000
    ring[20_000] *= -1
    with pytest.raises(InputError, match=r"flight_area\.crosses_itself"):
        checked_ring(ring, "area")
    assert process_time() - begin < 30


def test_crossings_are_those_of_all_pairs_of_edges():
    """The first along the polygon, as looking at each pair finds it."""
    rng = np.random.default_rng(3)
    for _ in range(30):
        ring = rng.uniform(0, 1, (12, 2))
        after, first = np.roll(ring, -1, axis=0), None
        for i in range(12):
            for j in range(i + 2, 12 - (i == 0)):
                (t,), (s,) = np.linalg.solve(
                    np.stack([after[i] - ring[i], ring[j] - after[j]], axis=1), (ring[j] - ring[i])[:, None]
                )
                if first is None and 0 <= t <= 1 and 0 <= s <= 1:
                    first = i, j
        assert first is not None
        with pytest.raises(InputError, match=rf"\b{first[0] + 1} and {first[1] + 1}\b.*flight_area\.crosses_itself"):
            checked_ring(ring, "area")


@pytest.mark.parametrize("inner", [False, True])
def test_places_astray_are_told(inner):
    area, hole = np.array([[0.0, 0], [10, 0], [10, 10], [0, 10]]), np.array([[8.0, 4], [12, 4], [12, 9], [8, 9]])
    found = astray(hole, area, within=inner)
    assert found is not None
    assert (found[0] < 10) == inner
    beside = np.array([[0.0, 2], [5, 2], [5, 4], [0, 4]])
    assert astray(beside, area, within=False) is None
    assert astray(area, area, within=inner) is None
