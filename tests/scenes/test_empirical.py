"""Empirical models: published scatter on real scenes, lack of fit said, derivatives, true covariances."""

import numpy as np
import pytest

from raybundle.errors import InputError, RankDefect
from raybundle.io.scenes import read_scene
from raybundle.numerics.geodesy import LocalPlace
from raybundle.numerics.rotation import rotation_from_angles
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
    assert fit.residuals_px.std(axis=0) == pytest.approx([column, row], rel=0.1)
    assert fit.adequate
    assert fit.reason.code == "empirical.adequate"


@pytest.mark.parametrize("file", ["rpc/rpc_WV3.xml", "rpc/rpc_PLEIADES.xml", "maxar/wv_test1.xml"])
def test_affine_is_called_inadequate(sensors, file):
    points = scene_points(read_scene(sensors / file).rpc, 500)
    fit = fit_empirical("affine", *points, sigma_px=0.5)
    assert not fit.adequate
    assert (fit.reason.code, fit.reason.values["model"]) == ("empirical.not_adequate", "affine")
    assert fit.sigma0 > 10


def test_second_order_is_enough_where_affine_is_not(sensors):
    points = scene_points(read_scene(sensors / "rpc/rpc_WV3.xml").rpc, 500)
    assert fit_empirical("affine2", *points, sigma_px=0.5).adequate
    assert not fit_empirical("dlt", *points, sigma_px=0.5).adequate


def cube(n=40, seed=1):
    return np.random.default_rng(seed).uniform([-500, -400, -60], [500, 400, 60], (n, 3)) + np.array([1000, 0, 300])


LENS = np.array([-0.08, 0.02, -0.005, 0.003, -0.002])


def oblique_camera():
    """L1 .. L11 of a camera that looks obliquely, principal point (0.03, -0.02), c = 1.4, in normalised coordinates."""
    R = rotation_from_angles(np.radians([35.0, -20.0, 10.0]))
    P = np.array([[1.4, 0, -0.03], [0, 1.4, 0.02], [0, 0, -1.0]]) @ np.column_stack([R, [0.0, 0.0, -2.2]])
    return (P / P[2, 3]).ravel()[:11]


def made(name, xyz, seed=2):
    """Image points that fulfil a model exactly, with parameters like those of an oblique view."""
    rng = np.random.default_rng(seed)
    model = empirical_models[name]
    low, high = xyz.min(axis=0), xyz.max(axis=0)
    X = (xyz - (low + high) / 2) / ((high - low).max() / 2)
    if name == "dlt-brown":
        return model.evaluate(X, np.concatenate([oblique_camera(), LENS]))[0] * 1000 + 2000
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

    xyz = cube(80 if name == "dlt-brown" else 25)
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
    with pytest.raises(RankDefect, match=r"empirical\.not_determined"):
        fit_empirical("dlt", xyz, made("affine", xyz), sigma_px=0.5)
    # the models of a plane ask for no third dimension
    assert fit_empirical("plane-projective", xyz, made("plane-projective", xyz), sigma_px=0.5).adequate


def test_bad_input():
    xyz = cube(4)
    with pytest.raises(InputError, match=r"affine2.*empirical\.unknown_model"):
        fit_empirical("spline", xyz, xyz[:, :2], sigma_px=1.0)
    with pytest.raises(InputError, match=r"6.*empirical\.too_few_points"):
        fit_empirical("dlt", xyz, xyz[:, :2], sigma_px=1.0)
    with pytest.raises(InputError, match=r"image_point\.sigma_not_positive_px"):
        fit_empirical("affine", xyz, xyz[:, :2], sigma_px=-1.0)
    exact = fit_empirical("affine", xyz, made("affine", xyz), sigma_px=1.0)
    assert exact.redundancy == 0
    assert exact.reason.code == "empirical.no_redundancy"


def test_brown_corrections_at_the_image_point():
    """m + corrections(m - x0) = the DLT's image, by the formula of `sensors.brown` itself."""
    from raybundle.sensors.brown import Brown

    rng = np.random.default_rng(5)
    X = rng.uniform(-0.9, 0.9, (30, 3))
    L = oblique_camera()
    plain = empirical_models["dlt"].evaluate(X, L)[0]
    m = empirical_models["dlt-brown"].evaluate(X, np.concatenate([L, LENS]))[0]
    a, c = L[:8].reshape(2, 4)[:, :3], L[8:]
    x0 = a @ c / (c @ c)
    none = np.zeros(30)
    u, v = Brown.condition(*m.T, none, none, none - 1, 0.0, *x0, *LENS, 0.0, 0.0)
    assert np.abs(np.stack([u, v], axis=1) + x0 - plain).max() < 1e-12
    assert np.abs(m - plain).max() > 0.01


def test_closed_form_start_of_the_lens_is_near():
    xyz = cube(60)
    fit = fit_empirical("dlt-brown", xyz, made("dlt-brown", xyz), sigma_px=0.5)
    n = fit.normalisation
    start = fit.model.start(
        (xyz - n.object_offset) / n.object_scale, (made("dlt-brown", xyz) - n.image_offset) / n.image_scale
    )
    assert np.abs(start[:11] - fit.values[:11]).max() < 0.02
    assert start[11] == pytest.approx(fit.values[11], rel=0.3)


def test_parameters_that_are_left_out():
    xyz = cube(60)
    xy = made("dlt-brown", xyz) + np.random.default_rng(3).normal(0, 0.2, (60, 2))
    fit = fit_empirical("dlt-brown", xyz, xy, sigma_px=0.2, without=("K3", "P2"))
    assert fit.redundancy == 120 - 14
    assert fit.values[[13, 15]].tolist() == [0, 0]
    assert not fit.covariance[13].any()
    every = ("K1", "K2", "K3", "P1", "P2")
    bare = fit_empirical("dlt-brown", xyz, xy, sigma_px=0.2, without=every)
    assert np.abs(bare.values[:11] - fit_empirical("dlt", xyz, xy, sigma_px=0.2).values).max() < 1e-9
    assert not bare.adequate
    with pytest.raises(InputError, match=r"K1.*K2.*K3.*P1.*empirical\.no_additional_parameter"):
        fit_empirical("dlt-brown", xyz, xy, sigma_px=0.2, without=("L3",))
