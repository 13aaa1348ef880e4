"""Large dots seen through strong distortion calibrate the camera to what the covariance states."""

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.block import Role
from raybundle.calibration.eccentricity import EDGE, circle_images, ellipses_of_grey_values
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Scene
from raybundle.targets.centre import fit_dots
from raybundle.workflows.calibrate import CalibrateOptions, calibrate
from tests.targets.photographs import (
    FAMILY,
    FREE,
    SheetNetwork,
    first_order_images,
    normalised_error,
    photograph,
    photographed,
    places,
    stations,
    true_camera,
)

pytestmark = pytest.mark.long
PLANS = [
    SheetNetwork(width_px=1000, height_px=750, barrel_px=25.0, radius_mm=8.0, photographs=8, seed=s) for s in (3, 4)
]
OPTIONS = CalibrateOptions(targets=(FAMILY,), estimate=FREE, shear=True)


@pytest.fixture(scope="module")
def networks(tmp_path_factory):
    folder = tmp_path_factory.mktemp("dots")
    return [(folder / str(p.seed), photographed(p, folder / str(p.seed))) for p in PLANS]


def squared_error(networks):
    found = [normalised_error(calibrate([folder], OPTIONS), camera) for folder, camera in networks]
    return sum(e for e, _ in found), sum(n for _, n in found)


def test_the_camera_is_within_its_covariance(networks):
    error, degrees = squared_error(networks)
    low, high = chi2(degrees).interval(0.999)
    assert low < error < high


def test_the_formula_of_first_order_would_be_noticed(networks, monkeypatch):
    monkeypatch.setattr("raybundle.calibration.eccentricity.circle_images", first_order_images)
    monkeypatch.setattr("raybundle.workflows.calibrating.target_block.circle_images", first_order_images)
    error, degrees = squared_error(networks)
    assert error > 2 * chi2(degrees).interval(0.999)[1]


def test_centres_are_where_the_fit_of_grey_values_finds_them():
    """Without a network in between: measured dots against the prediction by the true camera and orientations."""
    plan = SheetNetwork(width_px=1000, height_px=750, barrel_px=25.0, radius_mm=9.0, noise=0.3, seed=5)
    camera = true_camera(plan)
    centre, rotation = stations(plan)
    xyz = np.concatenate([places(plan), np.zeros((35, 1))], axis=1)
    scene = Scene(camera=camera, centre=centre[:1], rotation=rotation[:1], xyz=xyz, name="sheet")
    survey = Survey(orientation="exact", points="exact", interior="exact", image_sigma_px=1e-9, least_rays=1)
    block = simulate(scene, survey).observed
    assert (block.points.role == Role.TIE).all()
    rows = np.arange(len(block.observations))
    normal = np.tile([0.0, 0.0, 1.0], (len(rows), 1))
    radius = np.full(len(rows), plan.radius_mm)
    said = circle_images(block, rows, radius, normal)
    image = photograph(plan, camera, centre[0], rotation[0], np.random.default_rng(1))
    at = block.observations.xy_px + said.offset_px
    ellipse = np.eye(2)[None] * said.radius_px[:, None, None] ** 2
    dots = fit_dots(image, at, ellipse, np.full(len(rows), 1.6))
    away = (dots.xy_px - at)[dots.measured]
    assert dots.measured.sum() > 20
    assert np.sqrt(np.mean(away**2)) < 0.003
    plain = first_order_images(block, rows, radius, normal).offset_px - said.offset_px
    assert np.linalg.norm(plain, axis=1).max() > 0.03
    ratio = np.sqrt(np.linalg.det(dots.ellipse[dots.measured])) / said.radius_px[dots.measured] ** 2
    np.testing.assert_allclose(ratio, 1, atol=0.01)


def test_an_ellipse_is_found_again():
    rng = np.random.default_rng(2)
    t = 2 * np.pi * np.arange(EDGE) / EDGE
    for _ in range(20):
        M, c = rng.normal(size=(2, 2)) + 2 * np.eye(2), rng.normal(size=2)
        # steps along a perspective image are not equal in its own angle
        s = t + 0.05 * np.sin(t + rng.uniform(0, 6))
        edge = c + np.stack([np.cos(s), np.sin(s)], axis=1) @ M.T
        found, radius = ellipses_of_grey_values(edge[None])
        np.testing.assert_allclose(found[0], c, atol=1e-7)
        np.testing.assert_allclose(radius[0], np.sqrt(abs(np.linalg.det(M))), rtol=1e-7)
