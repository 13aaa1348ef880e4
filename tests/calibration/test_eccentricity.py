"""The image of a circle: its ellipse's centre against ellipses through projected points, and in an adjustment."""

from dataclasses import replace

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.predict import predicted_px
from raybundle.calibration.eccentricity import eccentricity_px, radius_scale
from raybundle.planning.network.calibration_networks import ROLLS, FlatField, flat_field_scene
from raybundle.planning.simulate import Survey, simulate

EXACT = Survey(orientation="exact", points="exact", interior="exact", image_sigma_px=1e-6)


def conic_centre(xy):
    """Centre of the ellipse through points (n, 2)."""
    middle = xy.mean(axis=0)
    scale = np.abs(xy - middle).max()
    x, y = ((xy - middle) / scale).T
    A = np.stack([x * x, x * y, y * y, x, y, np.ones_like(x)], axis=1)
    a, b, c, d, e, _ = np.linalg.svd(A)[2][-1]
    return middle + scale * np.linalg.solve([[2 * a, b], [b, 2 * c]], [-d, -e])


def test_without_distortion_it_is_the_centre_of_the_ellipse():
    plan = FlatField(tilt_deg=35.0, rolls_deg=ROLLS, points=4)
    block = simulate(flat_field_scene(plan), EXACT).observed
    o, radius = block.observations, 0.02
    offset = eccentricity_px(block, np.full(16, radius), np.tile([0.0, 0.0, 1.0], (16, 1)))
    a = np.linspace(0, 2 * np.pi, 200, endpoint=False)[:, None]
    circle = radius * np.concatenate([np.cos(a), np.sin(a), 0 * a], axis=1)
    for row in range(0, len(o), 7):
        X = block.points.xyz[o.point[row]]
        expected = conic_centre(predicted_px(block, int(o.image[row]), X + circle))
        plain = predicted_px(block, int(o.image[row]), X[None])[0]
        np.testing.assert_allclose(offset[row], expected - plain, atol=1e-7)
        assert np.abs(offset[row]).max() > 0.01


def test_it_is_some_hundredths_of_a_pixel_at_usual_sizes_and_zero_seen_squarely():
    block = simulate(flat_field_scene(FlatField(tilt_deg=30.0, rolls_deg=ROLLS)), EXACT).observed
    normal = np.tile([0.0, 0.0, 1.0], (len(block.points), 1))
    # a dot of 3 mm radius at 1.5 m is 8 px large: 0.0139 px were found for 8 px and 30 degrees at f = 2000
    offset = eccentricity_px(block, np.full(len(block.points), 0.003), normal)
    size = np.linalg.norm(offset, axis=1)
    assert 0.002 < np.median(size) < 0.02
    assert not eccentricity_px(block, np.full(len(block.points), np.nan), normal).any()
    square = simulate(flat_field_scene(FlatField(tilt_deg=0.0, shift=0.01, points=3, size=0.01)), EXACT).observed
    small = eccentricity_px(square, np.full(9, 0.003), np.tile([0.0, 0.0, 1.0], (9, 1)))
    assert np.abs(small).max() < 1e-3


def test_an_adjustment_with_ellipse_centres_is_right_after_the_correction():
    block = simulate(flat_field_scene(FlatField(tilt_deg=35.0, rolls_deg=ROLLS)), EXACT).observed
    radius, normal = np.full(len(block.points), 0.008), np.tile([0.0, 0.0, 1.0], (len(block.points), 1))
    o = block.observations
    measured = replace(block, observations=replace(o, xy_px=o.xy_px + eccentricity_px(block, radius, normal)))
    options = AdjustmentOptions(jobs=1)
    c = block.cameras[0].values["c"]
    biased = adjust_block(measured, options)
    assert biased.sigma0 > 100  # in units of the 1e-6 px of the simulation
    corrected = measured
    for _ in range(2):
        place = adjust_block(corrected, options).adjusted
        here = replace(measured, cameras=place.cameras, images=place.images, points=place.points)
        shift = eccentricity_px(here, radius, normal)
        corrected = replace(measured, observations=replace(o, xy_px=measured.observations.xy_px - shift))
    result = adjust_block(corrected, options)
    assert result.sigma0 < 10
    assert abs(result.adjusted.cameras[0].values["c"] - c) < 0.02 * abs(biased.adjusted.cameras[0].values["c"] - c)


def dotted(radius, used, sigma_px):
    """Photographs of dots adjusted with radii `used` where `radius` is true; the result and its offsets."""
    plan = FlatField(tilt_deg=40.0, rolls_deg=ROLLS, photographs=16)
    seen = simulate(flat_field_scene(plan), replace(EXACT, image_sigma_px=sigma_px)).observed
    normal = np.tile([0.0, 0.0, 1.0], (len(seen.points), 1))
    count = len(seen.points)
    offset = eccentricity_px(seen, np.full(count, used), normal)
    true = eccentricity_px(seen, np.full(count, radius), normal)
    o = seen.observations
    block = replace(seen, observations=replace(o, xy_px=o.xy_px + true - offset))
    return adjust_block(block, AdjustmentOptions(jobs=1)), offset


def test_large_dots_tell_their_radius():
    for used in (0.03, 0.027, 0.033):
        found = radius_scale(*dotted(0.03, used, 0.005))
        assert found.determinable
        assert abs(found.value - 0.03 / used) < 4 * found.std
        assert found.significant == (used != 0.03)


def test_small_dots_do_not():
    found = radius_scale(*dotted(0.004, 0.004, 0.1))
    assert not found.determinable
    assert not found.significant


def test_without_circles_there_is_no_radius():
    result, offset = dotted(0.0, 0.0, 0.1)
    assert radius_scale(result, offset) is None
