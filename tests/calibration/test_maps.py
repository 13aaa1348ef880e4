"""Uncertainty of projection against calibrations of simulated observations; difference of calibrations."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Camera
from raybundle.calibration.maps import calibration_difference, projection_uncertainty, scaled, uncertainty_of
from raybundle.errors import InputError
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene

RUNS = 300


def calibrated(seed):
    scene = field_scene(TargetField(rows=6, columns=8, stations=8, frontal=2))
    survey = Survey(seed=seed, orientation="exact", points="exact", interior="exact", image_sigma_px=0.1)
    return adjust_block(simulate(scene, survey).observed, AdjustmentOptions(jobs=1, tolerance=1e-3))


@pytest.mark.long
@pytest.mark.parametrize("distance", [None, 2.0])
def test_the_map_is_the_scatter_of_repeated_calibrations(distance):
    first = calibrated(0)
    truth = first.given.cameras[0]
    stated = projection_uncertainty(
        truth, first.interior[0].free, first.precision.interior[truth.id] / first.sigma0**2, distance=distance,
        columns=12, rows=8,
    )  # fmt: skip
    shifts = np.array(
        [
            calibration_difference(
                truth, calibrated(k).adjusted.cameras[0], distance=distance, columns=12, rows=8
            ).shift_px
            for k in range(1, RUNS + 1)
        ]
    )
    scatter = np.sqrt((shifts**2).sum(axis=3).mean(axis=0) / 2)
    # a standard deviation from 300 runs of two correlated coordinates is good to 3 to 4 %
    assert np.abs(stated.std / scatter - 1).max() < 0.16
    assert abs(np.median(stated.std / scatter) - 1) < 0.05


def test_a_rotation_of_the_camera_is_no_difference():
    values = {"c": 24.0, "x0": 0.1, "y0": -0.1, "K1": -1e-4, "K2": 1e-7, "K3": 0.0, "P1": 1e-5, "P2": 0.0}
    a = brown_camera(values=values)
    d = calibration_difference(a, a)
    assert d.largest < 1e-9
    # a shift of the principal point by 5 um is nearly a rotation by 5 um / c
    b = replace(a, values={**values, "x0": 0.105})
    d = calibration_difference(a, b)
    assert abs(np.linalg.norm(d.rotation) - 0.005 / 24) < 0.3 * 0.005 / 24
    assert d.largest < 0.9 * 0.005 / a.pixel_mm[0]


def test_a_longer_camera_constant_enlarges_the_image():
    brown = brown_camera(values={"c": 40.0, "x0": 0, "y0": 0, "K1": 0, "K2": 0, "K3": 0, "P1": 0, "P2": 0})
    moved = replace(brown, values={**brown.values, "c": 40.4})
    d = calibration_difference(brown, moved)
    # one per cent of c is one per cent of the distance from the middle
    half = np.array([brown.width_px, brown.height_px]) / 2
    np.testing.assert_allclose(d.shift_px, 0.01 * (d.xy_px - half), atol=1e-6 * half[0])


def test_at_a_distance_a_translation_is_taken_up_as_well():
    values = {"c": 24.0, "x0": 0.0, "y0": 0.0, "K1": 0.0, "K2": 0.0, "K3": 0.0, "P1": 0.0, "P2": 0.0}
    a, b = brown_camera(values=values), brown_camera(values={**values, "c": 24.24})
    # a longer camera constant and a smaller distance are the same for points at one depth, and much alike on a sphere
    far = calibration_difference(a, b)
    near = calibration_difference(a, b, distance=2.0)
    assert near.rms < 0.35 * far.rms
    assert abs(near.translation[2]) == pytest.approx(0.02, rel=0.5)


def test_what_cannot_be_compared_is_refused():
    a = brown_camera()
    with pytest.raises(InputError, match=r"calibration\.formats_differ"):
        calibration_difference(a, replace(a, width_px=a.width_px // 2))
    half = scaled(a, a.width_px // 2, a.height_px // 2)
    assert half.pixel_mm == pytest.approx((2 * a.pixel_mm[0], 2 * a.pixel_mm[1]))
    with pytest.raises(InputError, match=r"calibration\.cropped_format"):
        scaled(a, a.width_px // 2, a.height_px)
    with pytest.raises(InputError, match=r"calibration\.not_estimated"):
        uncertainty_of(calibrated(1), "missing")


def test_a_wide_map_is_quick_and_empty_beyond_the_lens():
    fish = Camera(
        id="f", model="fisheye", width_px=3000, height_px=3000, pixel_mm=(0.005, 0.005),
        values={"c": 4.0, "x0": 0.0, "y0": 0.0, "K1": 0.0, "K2": 0.0, "K3": 0.0, "P1": 0.0, "P2": 0.0},
    )  # fmt: skip
    found = projection_uncertainty(fish, ("c",), np.array([[1e-6]]))
    assert found.covariance.shape == (40, 60, 2, 2)
    assert np.nanmin(found.std) < 0.05 * found.largest
