"""Flights with RTK: the precision that headings and tilted cross strips bring, and what one height lacks."""

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.block.uav_networks import Flight, flight_block

OPTIONS = AdjustmentOptions(threads=1)
SEEDS = 3


def adjusted(**plan):
    return adjust_block(flight_block(Flight(**plan)), OPTIONS)


def rms_mm(result):
    """Root mean square over the points of the a-priori standard deviations in X, Y, Z."""
    return 1e3 * np.sqrt(np.mean((result.precision.object_point_std / result.sigma0) ** 2, axis=0))


# the benchmark benchmarks/uav_precision.py takes ten seeds
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


def test_the_stated_precision_is_the_scatter_of_the_points():
    """Errors of the points in 10 flights against the stated standard deviations of one; good to some 10 %."""
    plan = {"alternating": True, "cross_tilt_deg": 30.0, "points": 8}
    result = adjusted(**plan)
    stated = np.sqrt(np.mean((result.precision.object_point_std / result.sigma0) ** 2, axis=0))
    quick = AdjustmentOptions(threads=1, statistics=False, tolerance=1e-3)
    errors: list[np.ndarray] = []
    for seed in range(10):
        block = flight_block(Flight(seed=seed, **plan))
        errors.append(adjust_block(block, quick).adjusted.points.xyz - block.points.xyz)
    ratio = np.sqrt(np.mean(np.square(errors), axis=(0, 1))) / stated
    assert (np.abs(ratio - 1) < 0.3).all()
