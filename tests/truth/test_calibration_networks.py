"""Rolls and convergence do what the literature says, degenerate networks are named, and stated sigmas are scatters."""

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.block.calibration_networks import ROLLS, FlatField, flat_field_scene
from raybundle.block.simulate import Survey, simulate

OPTIONS = AdjustmentOptions(threads=1)


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


@pytest.mark.parametrize("tilt", [5.0, 20.0, 40.0])
def test_the_stated_sigma_of_c_is_its_scatter(tilt):
    plan = FlatField(tilt_deg=tilt, rolls_deg=ROLLS)
    quick = AdjustmentOptions(threads=1, statistics=False, tolerance=1e-3)
    c = [calibrated(plan, seed, quick).adjusted.cameras[0].values["c"] for seed in range(80)]
    first = calibrated(plan)
    stated = first.interior[0].parameters["c"].std / first.sigma0
    # a standard deviation from 80 runs is good to 8 %
    assert 0.8 < stated / np.std(c, ddof=1) < 1.25
