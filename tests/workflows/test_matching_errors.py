"""Displacements by wrong image points: shares are estimated, false alarms as stated, what moved is detected."""

import numpy as np
import pytest
from scipy.special import chdtrc

from raybundle.workflows.epochs.matching_errors import MatchingErrors, Shares

WRONG, SCALE = 0.03, 3.0


def rays(rng, places, count, wrong=WRONG):
    """Drawn image points of places: rows of each, image of each row, centres of images, y and A."""
    centre = np.column_stack([np.linspace(-4, 4, count), rng.normal(0, 0.3, count), np.full(count, -6.0)])
    way = -centre / np.linalg.norm(centre, axis=1)[:, None]
    across = np.array([np.linalg.svd(w[None])[2][1:] for w in way])
    A = np.tile(across / 0.01, (places, 1, 1))
    y = rng.normal(size=(places * count, 2)) * np.where(rng.random(places * count) < wrong, SCALE, 1)[:, None]
    rows = {k: np.arange(k * count, (k + 1) * count) for k in range(places)}
    return rows, np.tile(np.arange(count), places), centre, y, A


def errors(rows, y, A, shares):
    return MatchingErrors(rows=rows, y=y, A=A, metres=1.0, shares=shares)


KNOWN = Shares(images=np.array([1 - WRONG, WRONG, 0.0]), places=np.array([1.0, 0.0, 0.0]))


def displaced(m, k):
    """Displacement of place 2 k + 1 against 2 k by all rays, and its covariance."""
    both = []
    for p in (2 * k, 2 * k + 1):
        A, y = m.A[m.rows[p]].reshape(-1, 3), m.y[m.rows[p]].ravel()
        C = np.linalg.inv(A.T @ A)
        both.append((C @ A.T @ y, C))
    return both[1][0] - both[0][0], both[0][1] + both[1][1]


def test_shares_are_those_of_the_image_points():
    rng = np.random.default_rng(1)
    rows, image, centre, y, A = rays(rng, 400, 4)
    found = errors(rows, y, A, KNOWN).estimated(rows, image, centre).shares
    assert found.images[1:].sum() == pytest.approx(WRONG, abs=0.02)
    assert found.places[0] > 0.95
    # errors that the rays of a half share
    common = np.repeat(rng.normal(size=(400, 2, 2)) * np.where(rng.random((400, 2, 1)) < 0.2, 5, 0), 2, axis=1)
    found = errors(rows, y + common.reshape(-1, 2), A, KNOWN).estimated(rows, image, centre).shares
    assert found.places[1:].sum() > 0.1


@pytest.mark.parametrize("count", [2, 3])
def test_false_alarms_are_as_stated(count):
    rows, _, _, y, A = rays(np.random.default_rng(count), 1200, count, wrong=0.1)
    m = errors(rows, y, A, Shares(images=np.array([0.9, 0.1, 0.0]), places=np.array([1.0, 0.0, 0.0])))
    normal, own = [], []
    for k in range(600):
        d, C = displaced(m, k)
        normal.append(chdtrc(3, d @ np.linalg.solve(C, d)))
        own.append(m.probability([2 * k, 2 * k + 1], d, C))
    assert np.mean(np.array(normal) < 0.001) > 0.05
    assert np.mean(np.array(own) < 0.001) <= 0.006  # bands of 99.9 % of 600 draws
    assert np.mean(np.array(own) < 0.01) <= 0.023


def test_what_moved_farther_than_an_error_reaches_is_detected():
    rows, _, _, y, A = rays(np.random.default_rng(5), 40, 2, wrong=0.0)
    m = errors(rows, y, A, KNOWN)
    found = []
    for k in range(20):
        d, C = displaced(m, k)
        size, way = np.linalg.eigh(C)
        d = d + way[:, -1] * m.detectable([2 * k, 2 * k + 1], C, 1e-5)
        assert m.detectable([2 * k, 2 * k + 1], C, 1e-5) > 1.5 * 5.5 * np.sqrt(size[-1])
        found.append(m.probability([2 * k, 2 * k + 1], d, C) < 1e-5)
    assert np.mean(found) >= 0.5
