"""Fisheyes and panoramas from nothing: oriented, and as well as from true approximate values."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.orientation import approximate_values, rays
from raybundle.orientation.bearings import is_wide, relative_bearings, resect_bearings
from raybundle.orientation.rays import camera_rays
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import brown_camera
from raybundle.sensors import sensor_models
from raybundle.workflows.adjust import adjust
from tests.orientation.scenes import both, errors, fisheye, panorama, room

PLAIN = AdjustmentOptions(statistics=False)


def blocks(name, control, gross):
    survey = Survey(
        seed=5, image_sigma_px=0.3, control=control, orientation="absent", interior="exact", gross_share=gross,
        gross_px=300,
    )  # fmt: skip
    if name == "mixed":
        survey = replace(survey, least_rays=0)
        frame = brown_camera(estimate=("c", "K1"), size_px=(3000, 2000), pixel_mm=0.008)
        return both(simulate(room(fisheye(), 4, 5, 1200), survey), simulate(room(frame, 10, 6, 1200), survey))
    camera = fisheye() if name == "fisheye" else panorama()
    s = simulate(room(camera, 8, 5), survey)
    return s.truth, s.observed


@pytest.mark.parametrize("control", [0, 6])
@pytest.mark.parametrize("name", ["fisheye", "panorama", "mixed"])
def test_adjusts_from_nothing_as_from_the_truth(name, control):
    truth, observed = blocks(name, control, 0.0)
    found = adjust(observed, PLAIN)
    reference = adjust(replace(observed, images=truth.images), PLAIN)
    assert found.sigma0 == pytest.approx(reference.sigma0, rel=1e-6)
    assert 0.9 < found.sigma0 < 1.1


@pytest.mark.parametrize("control", [0, 6])
@pytest.mark.parametrize("name", ["fisheye", "panorama", "mixed"])
def test_gross_errors_do_not_hinder(name, control):
    truth, observed = blocks(name, control, 0.05)
    found = approximate_values(observed).block
    centre, angle = errors(truth, found)
    assert centre < 5e-3
    assert angle < np.radians(0.3)


def test_rays_of_a_panorama_all_round():
    camera = panorama()
    model = sensor_models["panorama"]
    x = np.linspace(1, camera.width_px - 1, 500)
    xy = np.stack([x, np.linspace(10, camera.height_px - 10, 500)], axis=1)
    d = camera_rays(camera, xy)
    values = np.array([camera.values.get(p.symbol, p.default) for p in model.parameters])
    image = camera.image_from_pixel(xy).T
    assert np.abs(model.condition_at(image, d.T, values)).max() < 1e-9
    np.testing.assert_allclose(np.arctan2(d[:, 0], -d[:, 2]), image[0] / values[0], atol=1e-9)


@pytest.mark.parametrize("camera", [panorama(), fisheye(), brown_camera()], ids=lambda c: c.model)
def test_rays_do_not_depend_on_how_many_are_looked_for_together(camera, monkeypatch):
    xy = np.random.default_rng(4).uniform((0, 0), (camera.width_px, camera.height_px), (100, 2))
    together = camera_rays(camera, xy)
    monkeypatch.setattr(rays, "AT_ONCE", 7)
    np.testing.assert_allclose(camera_rays(camera, xy), together, atol=1e-15)
    assert camera_rays(camera, xy[:0]).shape == (0, 3)


def all_round(n, seed):
    d = np.random.default_rng(seed).normal(size=(n, 3))
    return d / np.linalg.norm(d, axis=1)[:, None]


def test_resection_on_bearings_all_round_with_a_third_of_them_wrong():
    R, C = rotation_from_vector(np.array([0.4, -1.2, 2.0])), np.array([1.0, -2.0, 0.5])
    d = all_round(120, 1)
    xyz = C + (d @ R) * np.random.default_rng(2).uniform(2, 9, (120, 1))
    d[:40] = all_round(40, 3)
    assert is_wide(d)
    found = resect_bearings(d, xyz, 0.005)
    assert found is not None
    np.testing.assert_allclose(found[0], R, atol=1e-9)
    np.testing.assert_allclose(found[1], C, atol=1e-8)


def test_relative_orientation_on_bearings_all_round_with_a_third_of_them_wrong():
    R, C = rotation_from_vector(np.array([0.3, 0.5, -0.8])), np.array([0.6, 0.64, -0.48])
    first = all_round(150, 4)
    xyz = first * np.random.default_rng(5).uniform(2, 9, (150, 1))
    second = (xyz - C) @ R.T
    second /= np.linalg.norm(second, axis=1)[:, None]
    second[:50] = all_round(50, 6)
    found = relative_bearings(first, second, 0.005)
    np.testing.assert_allclose(found[0][0], R, atol=1e-3)
    np.testing.assert_allclose(found[0][1], C, atol=1e-3)


def test_bearings_without_a_pose_give_none_or_few_inliers():
    d = all_round(60, 7)
    found = resect_bearings(d, all_round(60, 8) * 5, 0.002)
    if found is not None:
        P = (all_round(60, 8) * 5 - found[1]) @ found[0].T
        cosine = np.einsum("ni,ni->n", P, d) / np.linalg.norm(P, axis=1)
        assert (cosine > np.cos(0.002)).sum() < 8
