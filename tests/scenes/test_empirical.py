"""Empirical models: published scatter on real scenes, lack of fit said, derivatives, true covariances."""

import numpy as np
import pytest

from raybundle.errors import InputError, RankDefect
from raybundle.io.scenes import read_scene
from raybundle.numerics.geodesy import LocalPlace
from raybundle.scenes.empirical import empirical_models, fit_empirical

SKYSAT = "rpc/20191015_073816_ssc1d3_0011_basic_l1a_panchromatic_dn_RPC.TXT"


def scene_points(rpc, n=20_000, seed=0):
    """Points uniform over the image, heights within 100 m around the height offset, east-north-up."""
    rng = np.random.default_rng(seed)
    xy = rpc.image_offset + rpc.image_scale * rng.uniform(-1, 1, (n, 2))
    ground = rpc.localise(xy, rpc.ground_offset[2] + rng.uniform(-50, 50, n))
    return LocalPlace(origin=tuple(rpc.ground_offset)).local_from_geographic(ground), xy


@pytest.mark.parametrize(
    ("file", "column", "row"), [("rpc/rpc_IKONOS.txt", 0.364, 0.123), (SKYSAT, 0.127, 0.057)], ids=["IKONOS", "SkySat"]
)
def test_affine_on_real_scenes(sensors, file, column, row):
    fit = fit_empirical("affine", *scene_points(read_scene(sensors / file).rpc), sigma_px=0.5)
    assert fit.standard_deviation_px == pytest.approx([column, row], rel=0.1)
    assert fit.adequate
    assert "agree" in fit.reason


@pytest.mark.parametrize("file", ["rpc/rpc_WV3.xml", "rpc/rpc_PLEIADES.xml", "maxar/wv_test1.xml"])
def test_affine_is_called_inadequate(sensors, file):
    points = scene_points(read_scene(sensors / file).rpc, 500)
    fit = fit_empirical("affine", *points, sigma_px=0.5)
    assert not fit.adequate
    assert fit.reason.startswith("affine is not adequate for this scene")
    assert fit.sigma0 > 10


def test_second_order_is_enough_where_affine_is_not(sensors):
    points = scene_points(read_scene(sensors / "rpc/rpc_WV3.xml").rpc, 500)
    assert fit_empirical("affine2", *points, sigma_px=0.5).adequate
    assert not fit_empirical("dlt", *points, sigma_px=0.5).adequate


def cube(n=40, seed=1):
    return np.random.default_rng(seed).uniform([-500, -400, -60], [500, 400, 60], (n, 3)) + np.array([1000, 0, 300])


def made(name, xyz, seed=2):
    """Image points that fulfil a model exactly, with parameters like those of an oblique view."""
    rng = np.random.default_rng(seed)
    model = empirical_models[name]
    low, high = xyz.min(axis=0), xyz.max(axis=0)
    X = (xyz - (low + high) / 2) / ((high - low).max() / 2)
    values = rng.uniform(-0.05, 0.05, len(model.symbols))
    first = {"affine2": (0, 10), "parallel-perspective": (0, 8), "plane-affine": (0, 4), "plane-projective": (0, 4)}
    values[list(first.get(name, (0, 5)))] = 0.9
    if not name.startswith("plane"):
        third = {"affine2": (2, 11), "parallel-perspective": (2, 9)}
        values[list(third.get(name, (2, 6)))] = 0.4
    return model.evaluate(X, values)[0] * 1000 + 2000


@pytest.mark.parametrize("name", empirical_models)
def test_exact_data_are_reproduced(name):
    xyz = cube()
    xy = made(name, xyz)
    fit = fit_empirical(name, xyz, xy, sigma_px=0.5)
    assert np.abs(fit.residuals_px).max() < 1e-6
    assert np.abs(fit.project(xyz) - xy).max() < 1e-6
    assert fit.redundancy == 80 - len(empirical_models[name].symbols)


@pytest.mark.parametrize("name", empirical_models)
def test_derivatives(name):
    xyz = cube()
    fit = fit_empirical(name, xyz, made(name, xyz), sigma_px=0.5)
    _, by_point, by_values = fit.project_with_partials(xyz)
    for axis in range(3):
        step = np.zeros(3)
        step[axis] = 0.5
        numeric = fit.project(xyz + step) - fit.project(xyz - step)
        assert np.abs(numeric - by_point[:, :, axis]).max() < 1e-6 * np.abs(by_point).max()
    model, n = fit.model, fit.normalisation
    X = (xyz - n.object_offset) / n.object_scale
    for k in range(len(model.symbols)):
        step = np.zeros(len(model.symbols))
        step[k] = 1e-5
        numeric = (model.evaluate(X, fit.values + step)[0] - model.evaluate(X, fit.values - step)[0]) / 2e-5
        assert np.abs(numeric * n.image_scale - by_values[:, :, k]).max() < 1e-6 * np.abs(by_values).max()


@pytest.mark.parametrize("name", empirical_models)
def test_stated_covariance_is_true(name):
    from scipy.stats import chi2, kstest

    xyz = cube(25)
    exact = made(name, xyz)
    rng = np.random.default_rng(7)
    check = cube(3, 8)
    true = fit_empirical(name, xyz, exact, sigma_px=0.5)
    squares, sums = [], []
    for _ in range(200):
        fit = fit_empirical(name, xyz, exact + rng.normal(0, 0.5, exact.shape), sigma_px=0.5)
        image, _, J = fit.project_with_partials(check)
        J = J.reshape(6, -1)
        error = (image - true.project(check)).reshape(-1)
        squares.append(error @ np.linalg.solve(J @ fit.covariance @ J.T, error))
        sums.append(fit.sigma0**2 * fit.redundancy)
    assert kstest(squares, chi2(6).cdf).pvalue > 1e-3
    assert kstest(sums, chi2(true.redundancy).cdf).pvalue > 1e-3
    assert kstest(np.array(squares) * 1.2**2, chi2(6).cdf).pvalue < 1e-3


def test_points_in_a_plane():
    xyz = cube()
    xyz[:, 2] = 300 + 0.1 * xyz[:, 0]
    with pytest.raises(RankDefect, match="lie in a plane"):
        fit_empirical("dlt", xyz, made("affine", xyz), sigma_px=0.5)
    # the models of a plane ask for no third dimension
    assert fit_empirical("plane-projective", xyz, made("plane-projective", xyz), sigma_px=0.5).adequate


def test_bad_input():
    xyz = cube(4)
    with pytest.raises(InputError, match="known: affine, affine2, parallel-perspective, dlt, sdlt, plane-affine"):
        fit_empirical("spline", xyz, xyz[:, :2], sigma_px=1.0)
    with pytest.raises(InputError, match="need at least 6"):
        fit_empirical("dlt", xyz, xyz[:, :2], sigma_px=1.0)
    with pytest.raises(InputError, match="must be positive"):
        fit_empirical("affine", xyz, xyz[:, :2], sigma_px=-1.0)
    exact = fit_empirical("affine", xyz, made("affine", xyz), sigma_px=1.0)
    assert exact.redundancy == 0
    assert "no redundancy" in exact.reason
