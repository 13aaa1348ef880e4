"""A single position far off is left out with a fault; right ones, and whole sets that do not fit, stay."""

import numpy as np
import pytest

from raybundle.placing.georeference import georeference
from raybundle.placing.marks import Given
from tests.workflows.free_flight import adjusted, codes, flight, with_gps

__all__ = ["flight"]


def moved(photos, k, degrees):
    photos[k].metadata.gps.latitude_deg += degrees
    return photos


@pytest.mark.parametrize("k", [0, 7, 17])
def test_one_wrong_position_is_left_out(flight, k):
    placed = georeference(flight.free, moved(with_gps(flight), k, 0.003), Given())
    (notice,) = [n for n in placed.notices if n.code == "position_left_out"]
    assert (notice.ids, notice.severity) == ((flight.free.images.ids[k],), "fault")
    assert notice.values["distance"] == pytest.approx(333.6, rel=0.01)
    assert k not in placed.block.stations.image
    assert len(placed.block.stations) == 17
    assert not [n for n in adjusted(placed).notices if n.severity == "fault"]


def test_two_wrong_positions_are_left_out(flight):
    placed = georeference(flight.free, moved(moved(with_gps(flight), 3, 0.003), 9, -0.004), Given())
    left = {n.ids[0] for n in placed.notices if n.code == "position_left_out"}
    assert left == {flight.free.images.ids[k] for k in (3, 9)}


def test_right_positions_stay(flight):
    for noise in (0.001, 0.02, 1.0, 20.0):
        placed = georeference(flight.free, with_gps(flight, noise=noise), Given())
        assert "position_left_out" not in codes(placed)


def test_positions_of_which_most_are_wrong_stay(flight):
    rng = np.random.default_rng(3)
    photos = with_gps(flight)
    for p in photos[:9]:
        p.metadata.gps.latitude_deg += rng.uniform(-0.01, 0.01)
    assert "position_left_out" not in codes(georeference(flight.free, photos, Given()))


def test_shifts_of_two_flights_are_no_wrong_positions(flight):
    for shift in ((3.0, 2.0, 5.0), (0.0, 0.0, 150.0)):
        photos = with_gps(flight, shift=shift, pause=16)
        assert "position_left_out" not in codes(georeference(flight.free, photos, Given()))
