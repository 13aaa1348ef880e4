"""The fundamental matrix: a true covariance, wrong correspondences, and where it says nothing."""

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.errors import NoOrientation
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.orientation import fundamental_matrix

SIGMA = 0.3
CONSTANTS = np.array([2100.0, 3000.0])
MIDDLE = np.array([[1510.0, 990.0], [1480.0, 1015.0]])


def pair(rng, n=120, noise=SIGMA, *, flat=False):
    """Image points (2, n, 2) of a body seen by two cameras that converge and do not stand alike."""
    X = rng.uniform(-1, 1, (n, 3)) * [1.0, 0.8, 0.0 if flat else 0.7]
    seen = []
    for k, (turn, at) in enumerate(
        (([0.05, -0.35, 0.1], [1.6, 0.2, 4.4]), ([-0.3, 0.30, -0.2], [-1.6, -1.5, 5.6]))
    ):  # fmt: skip
        U, V, W = rotation_from_vector(np.array([turn]))[0] @ (X - at).T
        seen.append(MIDDLE[k] + CONSTANTS[k] * np.stack([-U / W, V / W], axis=1) + rng.normal(0, noise, (n, 2)))
    return np.array(seen)


def truth():
    """F of exact points."""
    return fundamental_matrix(*pair(np.random.default_rng(0), noise=1e-9), sigma_px=0.01).matrix


def test_the_covariance_is_true():
    true, rng = truth().ravel(), np.random.default_rng(1)
    shrink = np.diag([1e3, 1e3, 1.0])  # elements of like size: the rank can be told
    scale = np.kron(shrink, shrink)
    squares, sums = [], []
    for _ in range(150):
        found = fundamental_matrix(*pair(rng), sigma_px=SIGMA)
        d = scale @ (found.matrix.ravel() - true * np.sign(found.matrix.ravel() @ true))
        C = scale @ found.covariance @ scale / found.sigma0**2
        squares.append(d @ np.linalg.pinv(C, rcond=1e-9, hermitian=True) @ d)
        sums.append(found.sigma0**2 * found.redundancy)
    low, high = chi2.ppf([0.0005, 0.9995], 150 * 7)
    assert low < sum(squares) < high
    low, high = chi2.ppf([0.0005, 0.9995], 150 * 113)
    assert low < sum(sums) < high


def test_wrong_correspondences_leave():
    p, q = pair(np.random.default_rng(2))
    rng = np.random.default_rng(3)
    q[:30] = rng.uniform(0, 3000, (30, 2))
    q[30] += 3.0  # 10 sigma, mostly across the epipolar line
    found = fundamental_matrix(p, q, sigma_px=SIGMA)
    line = found.lines(p)
    across = np.abs((line[:, :2] * q).sum(axis=1) + line[:, 2])
    assert across[:30][found.inliers[:30]].max(initial=0) < 5 * SIGMA  # what chance put onto its line
    assert found.inliers[:30].sum() < 4
    assert found.inliers[31:].mean() > 0.97


def test_camera_constants_of_both_images():
    rng = np.random.default_rng(4)
    squares = []
    for _ in range(100):
        c, C = fundamental_matrix(*pair(rng), sigma_px=SIGMA).camera_constants(MIDDLE)
        squares.append((c - CONSTANTS) @ np.linalg.solve(C, c - CONSTANTS))
    low, high = chi2.ppf([0.0005, 0.9995], 200)
    assert low < sum(squares) < high


def test_epipoles_lie_on_all_lines():
    p, q = pair(np.random.default_rng(5), noise=1e-9)
    found = fundamental_matrix(p, q, sigma_px=0.01)
    line = found.lines(p)
    assert np.abs((line[:, :2] * q).sum(axis=1) + line[:, 2]).max() < 1e-5
    assert np.abs(line[:, :2] @ found.epipoles[1] + line[:, 2]).max() < 1e-5


def test_what_says_nothing_is_refused():
    p, q = pair(np.random.default_rng(6), flat=True)
    with pytest.raises(NoOrientation, match=r"fundamental\.homography"):
        fundamental_matrix(p, q, sigma_px=SIGMA)
    with pytest.raises(NoOrientation, match=r"8.*fundamental\.too_few_points"):
        fundamental_matrix(p[:7], q[:7], sigma_px=SIGMA)
    rng = np.random.default_rng(7)
    with pytest.raises(NoOrientation, match=r"fundamental\.too_few_inliers"):
        fundamental_matrix(rng.uniform(0, 3000, (12, 2)), rng.uniform(0, 3000, (12, 2)), sigma_px=1e-4)
