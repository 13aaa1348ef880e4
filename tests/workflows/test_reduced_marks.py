"""Marks that were measured in reduced copies of photographs are recognised, and only these."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.placing.georeference import georeference
from raybundle.placing.marks import Given
from tests.workflows.free_flight import codes, control, error, flight

__all__ = ["flight"]


def placed_with(flight, xy, marks=None):
    marks = replace(marks or flight.marks, xy_px=xy)
    return georeference(flight.free, flight.photos, Given(control=(control(flight, marks=marks),), sigma_given=True))


def notice(placed):
    (found,) = [n for n in placed.notices if n.code == "marks_reduced"]
    return found


@pytest.mark.parametrize("side", [1280, 2400, 4096])
def test_marks_of_a_usual_size_are_brought_to_that_of_the_photographs(flight, side):
    full = max(flight.photos[0].width_px, flight.photos[0].height_px)
    rng = np.random.default_rng(3)
    reduced = flight.marks.xy_px * side / full + rng.normal(0, 0.1, flight.marks.xy_px.shape)
    placed = placed_with(flight, reduced)
    assert (notice(placed).values["side_px"], notice(placed).values["full_px"]) == (side, full)
    assert "mark_rejected" not in codes(placed)
    assert error(flight, placed) < 0.5
    o = placed.block.observations
    rows = placed.marked[o.point]
    assert np.allclose(o.cov_px2[rows, 0], (0.5 * full / side) ** 2)
    truth = np.sort(flight.marks.xy_px[:, 0])
    assert np.abs(np.sort(o.xy_px[rows, 0]) - truth).max() < 2 * full / side


def test_an_unusual_size_makes_marks_less_certain_along_their_distance(flight):
    full = max(flight.photos[0].width_px, flight.photos[0].height_px)
    rng = np.random.default_rng(4)
    side = 1747.0
    placed = placed_with(flight, flight.marks.xy_px * side / full + rng.normal(0, 0.1, flight.marks.xy_px.shape))
    assert notice(placed).values["side_px"] == pytest.approx(side, rel=0.02)
    assert not notice(placed).values["exact"]
    o = placed.block.observations
    rows = np.flatnonzero(placed.marked[o.point])
    assert (o.cov_px2[rows, 0] > (0.5 * full / side) ** 2).all()
    order = np.argsort(o.xy_px[rows, 0])
    assert (np.diff(o.cov_px2[rows, 0][order]) >= 0).all()
    assert error(flight, placed) < 0.5


def test_marks_in_photographs_as_they_are_stay(flight):
    placed = placed_with(flight, flight.marks.xy_px)
    assert "marks_reduced" not in codes(placed)


@pytest.mark.parametrize("seed", range(8))
def test_marks_that_agree_nowhere_stay_as_they_are(flight, seed):
    rng = np.random.default_rng(seed)
    size = flight.photos[0].width_px, flight.photos[0].height_px
    placed = placed_with(flight, rng.uniform(0, size, flight.marks.xy_px.shape))
    assert "marks_reduced" not in codes(placed)


def test_two_rays_each_for_two_points_are_not_enough_to_tell(flight):
    full = max(flight.photos[0].width_px, flight.photos[0].height_px)
    kept = np.concatenate([np.flatnonzero(flight.marks.point == k)[:2] for k in (0, 1)])
    few = replace(
        flight.marks, image=tuple(flight.marks.image[k] for k in kept), point=flight.marks.point[kept],
        line=flight.marks.line[kept],
    )  # fmt: skip
    rng = np.random.default_rng(1)
    xy = flight.marks.xy_px[kept] * 1024 / full + rng.normal(0, 3.0, (len(kept), 2))
    assert "marks_reduced" not in codes(placed_with(flight, xy, few))
