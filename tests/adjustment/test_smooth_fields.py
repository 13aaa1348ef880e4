"""Shapes of smooth fields by differences of projections, and the score test of one image's field by its definition."""

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.stats import multivariate_normal

from raybundle.adjustment.statistics.field_test import own_fields
from raybundle.adjustment.statistics.fields import (
    COLUMNS,
    FOCUS,
    OWN,
    Scores,
    WithFields,
    WithOwnInterior,
    _cost,
    _falls,
    _floor_and_fields,
    field_shapes,
    independent_scores,
    smooth_px,
    variance_components,
)
from raybundle.planning.synthetic_networks import brown_camera

ZERO = dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2"), 0.0)
CAMERA = brown_camera(values={"c": 20.0, **ZERO}, size_px=(6000, 4000), pixel_mm=0.004, estimate=())
HALF = 3000


def points(count=40):
    rng = np.random.default_rng(6)
    return np.stack([*rng.uniform(-0.5, 0.5, (2, count)), -np.ones(count)])


@pytest.mark.parametrize("symbol", OWN)
def test_what_an_image_has_of_its_own_displaces_as_its_parameter_does(symbol):
    """By one pixel: of c and K1 at half the longer side of the format, of the principal point everywhere."""
    model, P = CAMERA.sensor, points()
    values = dict(zip(model.symbols, CAMERA.parameters, strict=True))

    def moved_px(to, of):
        image, _ = model.project(of, np.array([{**values, symbol: to}[s] for s in model.symbols]))
        start, _ = model.project(of, CAMERA.parameters)
        return (image - start) / np.abs(CAMERA.pixel_mm[0])

    edge = np.array([[HALF * CAMERA.pixel_mm[0] / 20.0], [0.0], [-1.0]])
    step = {"c": 1e-4, "x0": 1e-4, "y0": 1e-4, "K1": 1e-8}[symbol]
    to = values[symbol] + step
    largest = moved_px(to, edge)[int(symbol == "y0"), 0]
    x, y = model.project(P, CAMERA.parameters)[0]
    found = WithOwnInterior(CAMERA).displacements(x, y)[:, COLUMNS + OWN.index(symbol)] / CAMERA.pixel_mm[0]
    np.testing.assert_allclose(found, moved_px(to, P) / largest, atol=1e-3)


def grid(side=200):
    t = (np.arange(side) + 0.5) / side * 2 - 1
    return (a.ravel() for a in np.meshgrid(t, t))


def test_fields_are_orthogonal_and_fall_off_with_their_degree():
    x, y = grid()
    S = field_shapes(x, y)
    degree = [1, 1, 2, 2, 2]
    assert 2 * len(S) == COLUMNS
    np.testing.assert_allclose(S @ S.T / len(x), np.diag(1 / np.square(degree)), atol=1e-3)
    np.testing.assert_allclose(S.mean(axis=1), 0, atol=1e-4)
    px = HALF * CAMERA.pixel_mm[0]
    D = WithFields(CAMERA).displacements(x * px, y * px) / CAMERA.pixel_mm[0]
    for tau, focus in ((0.3, 0.0), (0.0, 0.5), (0.4, 0.2)):
        # the mean square over random fields is the sum of those of their columns
        square = tau**2 * (D**2).mean(axis=2).sum() / 2 + focus**2 * ((D.transpose(0, 2, 1) @ FOCUS) ** 2).mean()
        assert smooth_px(tau**2, focus**2) == pytest.approx(np.sqrt(square), rel=1e-3)
    along = D.transpose(0, 2, 1) @ FOCUS
    np.testing.assert_allclose(along, np.stack([x, y]), atol=1e-12)


@pytest.mark.parametrize("rank", [COLUMNS, 6])
def test_the_score_test_of_a_field_is_the_square_sum_that_it_would_take(rank):
    """T = s' M^+ s / sigma0^2; the rms of the field by one step is that of its displacements over the format."""
    rng = np.random.default_rng(rank)
    variance, images = 0.7, np.array([4, 9])
    A = [rng.normal(size=(40, rank)) @ rng.normal(size=(rank, COLUMNS)) * 5 for _ in images]
    M = np.zeros((2 * COLUMNS, 2 * COLUMNS))
    scores, fields = np.zeros(2 * COLUMNS), []
    for k, a in enumerate(A):
        at = slice(COLUMNS * k, COLUMNS * (k + 1))
        M[at, at] = a.T @ a
        b = rng.normal(size=COLUMNS) * 30
        scores[at] = M[at, at] @ b
        fields.append(np.linalg.pinv(M[at, at], rcond=1e-9) @ scores[at])
    x, y = grid()
    S = field_shapes(x, y)
    for found, image, a, b in zip(own_fields(images, M, scores, variance), images, A, fields, strict=True):
        assert found.image == image
        assert found.directions == rank
        assert found.square == pytest.approx(b @ a.T @ a @ b / variance, rel=1e-6)
        moved = np.stack([b[::2] @ S, b[1::2] @ S])
        assert found.rms_px == pytest.approx(np.sqrt((moved**2).sum(axis=0).mean()), rel=5e-3)


def drawn(phi, tau_square, focus_square, seed=0, n=120, images=8):
    """Scores of the covariance phi I + tau^2 diag(weight) + focus^2 B B'."""
    rng = np.random.default_rng(seed)
    weight, B = rng.uniform(1, 400, n), rng.normal(0, 6, (n, images))
    C = np.diag(phi + tau_square * weight) + focus_square * B @ B.T
    return Scores(y=np.linalg.cholesky(C) @ rng.normal(size=n), weight=weight, B=B)


@pytest.mark.parametrize("focus_square", [0.0, 0.01, 0.3])
def test_the_cost_is_minus_twice_the_log_likelihood(focus_square):
    samples = [drawn(1.5, 0.02, min(focus_square, 0.1), seed) for seed in (1, 2)]
    expected = 0.0
    for s in samples:
        C = np.diag(1.4 + 0.03 * s.weight) + focus_square * s.B @ s.B.T
        expected -= 2 * multivariate_normal(np.zeros(len(s.y)), C).logpdf(s.y) + len(s.y) * np.log(2 * np.pi)
    assert _cost(samples, 1.4, 0.03, focus_square) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("focus_square", [0.0, 0.02])
def test_a_little_of_a_wandering_focus_is_tried_where_it_makes_the_cost_less(focus_square):
    for seed in range(6):
        samples = [drawn(1.2, 0.02, focus_square, seed)]
        slope = (_cost(samples, 1.2, 0.02, 1e-7) - _cost(samples, 1.2, 0.02, 0.0)) / 1e-7
        assert _falls(samples, 1.2, 0.02) is bool(slope < 0)


@pytest.mark.parametrize("seed", [0, 2, 5, 6, 13, 20])
def test_floor_and_fields_are_where_the_likelihood_is_largest(seed):
    s = drawn(1.8, 0.05, 0.0, seed, n=300)
    phi, tau_square = _floor_and_fields(s.weight, s.y**2)
    at = minimize(
        lambda t: _cost([s], max(np.exp(t[0]), 1.0), np.exp(t[1]), 0.0), np.log([phi, tau_square]),
        method="Nelder-Mead", options={"xatol": 1e-5, "fatol": 1e-6},
    )  # fmt: skip
    assert _cost([s], phi, tau_square, 0.0) == pytest.approx(at.fun, abs=2e-3)
    np.testing.assert_allclose([phi, tau_square], [max(np.exp(at.x[0]), 1.0), np.exp(at.x[1])], rtol=0.02)


def test_white_noise_has_no_fields_and_blunders_count_in_part():
    s = drawn(1.0, 0.0, 0.0, 3, n=400)
    phi, tau_square = _floor_and_fields(s.weight, s.y**2)
    assert phi == pytest.approx(max(1.0, np.mean(s.y**2)), rel=0.05)
    assert tau_square * np.median(s.weight) < 0.2
    found = variance_components([s])
    assert (found.directions, found.chi_square) == (400, pytest.approx(np.mean(s.y**2)))
    assert found.focus_square == 0
    # one of them at a hundred standard deviations counts as thirty variances
    y = s.y.copy()
    y[7] = 100.0
    assert variance_components([Scores(y=y, weight=s.weight, B=s.B)]).phi < phi + 0.2


def test_the_parts_of_smooth_errors_are_found():
    """Mean over 5 draws of 2 samples, within three standard deviations of their mean."""
    found = [variance_components([drawn(1.5, 0.05, 0.2, 10 + 2 * k + j, n=160) for j in range(2)]) for k in range(5)]
    for name, truth, spread in (("phi", 1.5, 0.9), ("tau_square", 0.05, 0.02), ("focus_square", 0.2, 0.12)):
        assert np.mean([getattr(c, name) for c in found]) == pytest.approx(truth, abs=3 * spread / np.sqrt(5))
    none = variance_components([Scores(y=np.zeros(0), weight=np.zeros(0), B=np.zeros((0, 3)))])
    assert (none.phi, none.tau_square, none.focus_square, none.directions) == (1.0, 0.0, 0.0, 0)


@pytest.mark.parametrize(("images", "sampled"), [(3, None), (6, 2), (40, 2)])
def test_scores_have_the_covariance_that_is_stated_of_them(images, sampled):
    """y = W s with s of the covariance phi s0^2 M + M cov(fields) M, of all images or of some among all."""
    rng = np.random.default_rng(images)
    variance, phi, tau_square, focus_square = 0.6, 1.4, 0.03, 0.2
    F, A = rng.normal(size=(900, COLUMNS * images)), rng.normal(size=(900, 30))
    F[:, 5] = A[:, 0]  # a direction that the unknowns absorb
    M = F.T @ (F - A @ np.linalg.lstsq(A, F, rcond=None)[0])
    field = tau_square * np.eye(COLUMNS) + focus_square * np.outer(FOCUS, FOCUS)
    chosen = np.arange(COLUMNS * (sampled or images))
    across = M[chosen]
    of_scores = phi * variance * M[np.ix_(chosen, chosen)] + across @ np.kron(np.eye(images), field) @ across.T
    mine = M[np.ix_(chosen, chosen)]
    found = [independent_scores(mine, e, variance, across if sampled else None) for e in np.eye(len(chosen))]
    W = np.stack([s.y for s in found], axis=1)
    assert len(W) == len(chosen) - 1
    s = found[0]
    stated = phi * np.eye(len(W)) + tau_square * np.diag(s.weight) + focus_square * s.B @ s.B.T
    np.testing.assert_allclose(stated, W @ of_scores @ W.T, rtol=1e-6, atol=1e-6 * np.abs(stated).max())
