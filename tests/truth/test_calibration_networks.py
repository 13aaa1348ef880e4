"""Rolls and convergence do what the literature says, degenerate networks are named, and stated sigmas are scatters."""

import functools

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.planning.network.calibration_networks import ROLLS, FlatField, flat_field_scene
from raybundle.planning.simulate import Survey, simulate
from tests.truth.bands import assert_true_to_ten_percent, whitener

OPTIONS = AdjustmentOptions(jobs=1)


def calibrated(plan, seed=1, options=OPTIONS):
    survey = Survey(seed=seed, orientation="exact", points="exact", interior="exact", image_sigma_px=0.05)
    return adjust_block(simulate(flat_field_scene(plan), survey).observed, options)


def sigmas(plan):
    result = calibrated(plan)
    pixel = result.given.cameras[0].pixel_mm[0]
    p = result.interior[0].parameters
    c, x0, y0 = (p[s].std / result.sigma0 / pixel for s in ("c", "x0", "y0"))
    return c, float(np.hypot(x0, y0) / np.sqrt(2)), result.not_determinable


def test_convergence_determines_the_camera_constant():
    weak, strong = sigmas(FlatField(tilt_deg=10.0)), sigmas(FlatField(tilt_deg=45.0))
    assert weak[0] > 5 * strong[0]
    assert not strong[2]


@pytest.mark.parametrize(("tilt", "factor"), [(20.0, 10), (30.0, 4)])
def test_rolls_determine_the_principal_point(tilt, factor):
    without, with_rolls = (sigmas(FlatField(tilt_deg=tilt, rolls_deg=r)) for r in ((0.0,), ROLLS))
    assert without[1] > factor * with_rolls[1]


@pytest.mark.parametrize("distances", [(1.5,), (1.2, 1.5, 1.8)])
def test_square_views_of_a_flat_field_are_called_not_determinable(distances):
    lost = sigmas(FlatField(tilt_deg=0.0, shift=0.1, distances=distances))[2]
    assert any(name.startswith("c (") for name in lost)


def test_walking_round_without_rolls_is_called_not_determinable():
    lost = sigmas(FlatField(tilt_deg=30.0, up_to_centre=True))[2]
    assert {name.split()[0] for name in lost} == {"c", "y0"}


TILTS = (5.0, 20.0, 40.0)
RUNS = 80


@functools.cache
def interior_errors(tilt):
    """Errors (runs, k) of the interior orientation in so many calibrations, and the covariance before sigma0."""
    plan = FlatField(tilt_deg=tilt, rolls_deg=ROLLS)
    quick = AdjustmentOptions(jobs=1, statistics=False, tolerance=1e-3)
    first = calibrated(plan)
    free, true = first.interior[0].free, plan.camera.values
    found = [calibrated(plan, seed, quick).adjusted.cameras[0].values for seed in range(RUNS)]
    assert first.precision is not None
    Q = first.precision.interior[first.interior[0].camera] / first.sigma0**2
    return free, np.array([[values[s] - true[s] for s in free] for values in found]), Q


@pytest.mark.parametrize("tilt", TILTS)
def test_the_stated_sigma_of_c_is_its_scatter(tilt):
    free, errors, Q = interior_errors(tilt)
    k = free.index("c")
    low, high = chi2(RUNS).interval(0.999)  # 80 runs: 26 % of a standard deviation; all together below
    assert low < np.sum(errors[:, k] ** 2) / Q[k, k] < high


def test_stated_interior_orientations_are_true_to_ten_percent():
    d2 = [float(np.sum((whitener(Q) @ e) ** 2)) for _, errors, Q in map(interior_errors, TILTS) for e in errors]
    degrees = {len(free) for free, _, _ in map(interior_errors, TILTS)}
    assert_true_to_ten_percent(d2, degrees.pop(), "interior orientation")
    assert not degrees
