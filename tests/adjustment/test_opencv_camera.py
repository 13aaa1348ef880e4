"""Cameras as OpenCV has them: exact for its own models; errors are as large as the covariances say."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from raybundle import AdjustmentOptions, adjust
from raybundle.block import Camera
from raybundle.cameras.conversions import EXACT, camera_rays, exact_forward, exact_measured, grid_px
from raybundle.cameras.forward_camera import forward_pixels
from raybundle.cameras.opencv import opencv_camera
from raybundle.errors import InputError
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.sensors import sensor_models
from tests.messages import refused

OPTIONS = AdjustmentOptions(jobs=1)
VALUES = {
    "rational": {"k1": -0.1, "k2": 0.02, "k3": 0.001, "k4": 0.01, "p1": 3e-4, "p2": -2e-4, "A": 2e-4},
    "thin_prism": {"k1": -0.1, "k2": 0.02, "p1": 3e-4, "s1": 8e-4, "s2": -3e-4, "s3": -6e-4, "s4": 2e-4, "A": 2e-4},
    "kannala_brandt": {"k1": -0.03, "k2": 0.004, "k3": -5e-4, "k4": 1e-5, "A": 1e-4},
    "radial": {"k1": -0.1, "k2": 0.02},
    "brown": {"K1": 2e-4, "K2": -3e-7, "P1": 1e-5, "P2": -2e-5},
}


def camera(model, **more):
    symbols = sensor_models[model].symbols
    values = {"c": 24.5, "x0": 0.12, "y0": -0.08, **VALUES[model]}
    values = {s: values.get(s, 0.0) for s in symbols}
    return Camera(id="1", model=model, width_px=3000, height_px=2000, pixel_mm=(0.008, 0.008), values=values, **more)


def cv2_pixels(cv, points):
    """Pixels as raybundle counts them of points in the camera's system, y down, z away, by OpenCV."""
    zero = np.zeros(3)
    if cv.fisheye:
        xy, _ = cv2.fisheye.projectPoints(points[:, None], zero, zero, cv.K, cv.distortion)
    else:
        xy, _ = cv2.projectPoints(points, zero, zero, cv.K, cv.distortion)
    return xy.reshape(-1, 2) + 0.5


@pytest.mark.parametrize("model", sorted(EXACT))
def test_opencv_itself_images_rays_where_the_model_does(model):
    made = camera(model)
    pixels = grid_px(made.width_px, made.height_px)
    cv = opencv_camera(made)
    assert cv.deviation_px == 0
    assert np.isnan(cv.covariance).all()
    rays = camera_rays(made, pixels).T * [1, -1, -1]
    assert np.abs(cv2_pixels(cv, rays) - pixels.T).max() < 1e-8


def test_of_a_brown_camera_it_is_a_fit_whose_misfit_is_said():
    made = camera("brown")
    cv = opencv_camera(made)
    pixels = grid_px(made.width_px, made.height_px)
    off = np.linalg.norm(cv2_pixels(cv, camera_rays(made, pixels).T * [1, -1, -1]) - pixels.T, axis=1).max()
    assert 0.001 < off < 0.1
    assert off == pytest.approx(cv.deviation_px, rel=0.05)
    assert len(opencv_camera(made, coefficients=8).distortion) == 8


@pytest.mark.parametrize("model", sorted(EXACT))
def test_there_and_back_is_the_same_camera(model):
    made = camera(model)
    back = exact_measured(exact_forward(made), replace(made, values={**made.values}), model)
    for symbol, value in made.values.items():
        assert back.values[symbol] == pytest.approx(value, rel=1e-12, abs=1e-15)
    pixels = grid_px(made.width_px, made.height_px)
    assert np.abs(forward_pixels(exact_forward(made), camera_rays(made, pixels)) - pixels).max() < 1e-9


def field(model, seed, free):
    scene = field_scene(TargetField(camera=camera(model, estimate=free), columns=9, rows=7))
    return simulate(scene, Survey(image_sigma_px=0.2, seed=seed, scale_bars=1)).observed


FREE = {
    "rational": ("c", "x0", "y0", "k1", "k2", "p1", "p2", "A"),
    "thin_prism": ("c", "x0", "y0", "k1", "k2", "p1", "p2", "s1", "s3", "A"),
    "kannala_brandt": ("c", "x0", "y0", "k1", "k2", "A"),
    "brown": ("c", "x0", "y0", "K1", "K2", "P1", "P2"),
}
COUNT = {"rational": 5, "thin_prism": 12, "kannala_brandt": 4, "brown": 5}


@pytest.mark.parametrize("model", sorted(FREE))
def test_errors_of_k_and_distortion_are_as_large_as_their_covariance_says(model):
    """Normalised squares over draws: with rank u, the mean of e' C^+ e is u."""
    truth, sizes = opencv_camera(camera(model), coefficients=COUNT[model]), []
    for seed in range(12):
        cv = adjust(field(model, seed, FREE[model]), OPTIONS).opencv(coefficients=COUNT[model])
        e = np.array(list(cv.values.values())) - np.array(list(truth.values.values()))
        scale = np.sqrt(np.diag(cv.covariance))
        here = scale > 0
        e, C = e[here] / scale[here], cv.covariance[np.ix_(here, here)] / np.outer(scale[here], scale[here])
        value, axes = np.linalg.eigh(C)
        kept = value > 1e-8 * value.max()
        rank = int(kept.sum())
        sizes.append(float((((axes.T @ e) ** 2)[kept] / value[kept]).sum()) / rank)
    assert rank == min(len(FREE[model]), len(e))
    assert 0.6 < np.mean(sizes) < 1.5, sizes  # of 12 draws of 7 to 10 values


def test_what_was_held_has_no_variance():
    result = adjust(field("rational", 1, ("c", "x0", "y0", "k1")), OPTIONS)
    cv = result.opencv(coefficients=5)
    assert cv.held == ("k2", "p1", "p2", "k3")
    assert cv.std["k2"] == 0
    (interior,) = result.interior
    assert cv.std["k1"] == pytest.approx(interior.parameters["k1"].std, rel=1e-9)
    assert cv.std["fx"] == pytest.approx(interior.parameters["c"].std / 0.008, rel=1e-9)
    assert cv.std["cy"] == pytest.approx(interior.parameters["y0"].std / 0.008, rel=1e-9)
    assert "fx 3062" in repr(cv) or "fx 3061" in repr(cv) or "fx 3063" in repr(cv)


def test_what_cannot_be_is_said():
    with pytest.raises(InputError, match=r"OpenCV.*6.*4.*5.*camera\.opencv_coefficients"):
        opencv_camera(camera("rational"), coefficients=6)
    with pytest.raises(InputError, match=r"OpenCV.*8.*camera\.opencv_coefficients"):
        opencv_camera(camera("kannala_brandt"), coefficients=8)
    strong = replace(camera("brown"), values={**camera("brown").values, "K1": 2e-3, "K2": 4e-6})
    with pytest.raises(InputError, match=r"OpenCV.*4.*0\.1.*camera\.opencv_deviation"):
        opencv_camera(strong, coefficients=4)
    result = adjust(field("rational", 1, ("c",)), OPTIONS)
    with pytest.raises(InputError, match=r"camera\.unknown"):
        result.opencv("x")
    with pytest.raises(InputError, match=r"camera\.no_interior_of_image"):
        result.opencv(image="y")


def test_parameters_of_single_images_and_shared_ones_count_together():
    """c of each image, the others shared: the covariance of both, and no camera of all images."""
    block = simulate(field_scene(TargetField()), Survey(scale_bars=2)).observed
    (camera,) = block.cameras
    white = replace(OPTIONS, noise="white")
    shared, zoomed = adjust(block, white), adjust(replace(block, cameras=(replace(camera, per_image=("c",)),)), white)
    with refused("camera.interior_per_image", camera="1"):
        zoomed.opencv()
    one, all_of_them = zoomed.opencv(image=block.images.ids[0]), shared.opencv()
    assert one.values["fx"] == pytest.approx(all_of_them.values["fx"], rel=1e-3)
    for name in ("cx", "cy", "k1", "p1"):
        assert 0.8 * all_of_them.std[name] < one.std[name] < 5 * all_of_them.std[name]
