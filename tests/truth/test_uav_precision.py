"""Flights with RTK: the precision that headings and tilted cross strips bring, and what one height lacks."""

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.planning.flights.uav_networks import Flight, flight_block
from tests.truth.bands import assert_true_to_ten_percent, points_together

OPTIONS = AdjustmentOptions(jobs=1)
SEEDS = 3


def adjusted(**plan):
    return adjust_block(flight_block(Flight(**plan)), OPTIONS)


def rms_mm(result):
    """Root mean square over the points of the a-priori standard deviations in X, Y, Z."""
    return 1e3 * np.sqrt(np.mean((result.precision.object_point_std / result.sigma0) ** 2, axis=0))


# the benchmark benchmarks/uav_precision.py takes ten seeds
@pytest.mark.long
@pytest.mark.parametrize(
    ("plan", "low", "high"),
    [
        ({}, (24, 24, 58), (24, 24, 58)),
        ({"alternating": True}, (14, 16, 57), (14, 16, 57)),
        ({"alternating": True, "cross_tilt_deg": 30.0}, (8, 8, 8), (10, 10, 11)),
    ],
)
def test_precision_of_a_flight(plan, low, high):
    results = [adjusted(seed=seed, **plan) for seed in range(1, SEEDS + 1)]
    mean = np.mean([rms_mm(r) for r in results], axis=0)
    assert all(not r.not_determinable for r in results)
    assert (mean > 0.85 * np.array(low)).all()
    assert (mean < 1.15 * np.array(high)).all()


@pytest.mark.parametrize(
    ("alternating", "lost"), [(True, {"c"}), (False, {"c", "x0", "y0"})], ids=["alternating", "equal"]
)
def test_a_flight_at_exactly_one_height_does_not_determine_the_camera(alternating, lost):
    result = adjusted(alternating=alternating, height_jitter=0.0, angle_jitter_deg=0.0)
    assert {name.split()[0] for name in result.not_determinable} == lost


def test_tilted_cross_strips_determine_it():
    result = adjusted(alternating=True, cross_tilt_deg=30.0, height_jitter=0.0, angle_jitter_deg=0.0)
    assert not result.not_determinable
    pixel = result.given.cameras[0].pixel_mm[0]
    assert result.interior[0].parameters["c"].std / result.sigma0 / pixel < 0.5


@pytest.mark.long
def test_the_stated_precision_is_the_scatter_of_the_points():
    """Errors of all points of 12 flights against the covariance that each states, before sigma0."""
    d2, degrees = [], 0
    for seed in range(12):
        block = flight_block(Flight(seed=seed, alternating=True, cross_tilt_deg=30.0, points=8))
        result = adjust_block(block, OPTIONS)
        points, W = points_together(result.handle.work)
        stated = result.precision.object_points[points] / result.sigma0**2
        np.testing.assert_allclose(stated, result.handle.work.found.points[points], rtol=1e-9, atol=1e-15)
        error = (result.adjusted.points.xyz - block.points.xyz)[points].ravel()
        d2.append(float(np.sum((W @ error) ** 2)))
        degrees = len(W)
    assert_true_to_ten_percent(d2, degrees, "points of a flight")
