"""Strains from displacements on a grid: right, invariant to rotation, with a true covariance, never across a gap."""

import numpy as np
import pytest
from scipy.stats import chi2, kstest

from raybundle.matching.subset_noise import overlap_correlation
from raybundle.matching.subsets import window_options
from raybundle.metrology.strain import area_strain, connected, rigid_motion, strain_field
from raybundle.numerics.statistics import mahalanobis2

STEP, GAUGE, HALF = 10, 2, 12
SHAPE = (9, 10)
CELL = np.stack(np.unravel_index(np.arange(SHAPE[0] * SHAPE[1]), SHAPE), axis=1)
XY = CELL[:, ::-1] * float(STEP)
RHO = overlap_correlation(window_options(HALF, quadratic=False), STEP, 2 * GAUGE)


def cov():
    """Of another size and direction at each place."""
    rng = np.random.default_rng(4)
    L = np.tril(rng.uniform(0.3, 1.0, (len(XY), 2, 2))) * 0.005
    return L @ L.swapaxes(1, 2)


def field(displacement, C=None):
    return strain_field(displacement, cov() if C is None else C, CELL, SHAPE, float(STEP), GAUGE, RHO)


def gradient(rotation_deg, xx, yy, xy):
    a = np.radians(rotation_deg)
    R = np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])
    return R @ np.array([[1 + xx, xy], [xy, 1 + yy]])


@pytest.mark.parametrize("rotation_deg", [0.0, 10.0, -120.0])
def test_strain_is_that_of_the_material_however_it_is_turned(rotation_deg):
    F = gradient(rotation_deg, 0.05, -0.02, 0.01)
    e = field(XY @ (F - np.eye(2)).T)
    E = (F.T @ F - np.eye(2)) / 2
    np.testing.assert_allclose(e.strain, np.tile([E[0, 0], E[1, 1], E[0, 1]], (len(XY), 1)), atol=1e-12)
    values, vectors = np.linalg.eigh(E)
    np.testing.assert_allclose(e.principal, np.tile(values[::-1], (len(XY), 1)), atol=1e-12)
    along = np.stack([np.cos(e.direction), np.sin(e.direction)], axis=1) @ vectors[:, 1]
    np.testing.assert_allclose(np.abs(along), 1, atol=1e-12)
    np.testing.assert_allclose(np.degrees(e.rotation), rotation_deg, atol=1e-9)


def drawn(F, C, runs):
    """Displacements of a field whose errors are correlated as subsets overlap."""
    at = np.abs(CELL[:, None] - CELL[None])
    full = overlap_correlation(window_options(HALF, quadratic=False), STEP, max(SHAPE))
    rho = full[max(SHAPE) + at[..., 0], max(SHAPE) + at[..., 1]]
    half = np.linalg.cholesky(rho + 1e-12 * np.eye(len(rho)))
    L = np.linalg.cholesky(C)
    rng, truth = np.random.default_rng(1), XY @ (F - np.eye(2)).T
    for _ in range(runs):
        yield truth + np.einsum("nij,nj->ni", L, half @ rng.normal(size=(len(XY), 2)))


def simulated(runs):
    """Errors of strains in the middle of a rotated field."""
    F, C = gradient(20.0, 0.03, 0.0, 0.01), cov()
    E, middle = (F.T @ F - np.eye(2)) / 2, len(XY) // 2 + SHAPE[1] // 2
    errors, stated = [], None
    for displacement in drawn(F, C, runs):
        e = field(displacement, C)
        errors.append(e.strain[middle] - [E[0, 0], E[1, 1], E[0, 1]])
        stated = e.cov[middle] if stated is None else stated
    return np.array(errors), np.tile(stated, (runs, 1, 1))


def test_the_covariance_is_true_and_a_tenth_would_show():
    errors, stated = simulated(600)
    d2 = mahalanobis2(errors, stated)
    assert kstest(d2, chi2(3).cdf).pvalue > 1e-3
    assert kstest(d2 * 1.1**2, chi2(3).cdf).pvalue < 1e-3
    assert kstest(d2 / 1.1**2, chi2(3).cdf).pvalue < 1e-3


def area(displacement, inside, C=None):
    far = overlap_correlation(window_options(HALF, quadratic=False), STEP, 3)
    return area_strain(displacement, cov() if C is None else C, CELL, SHAPE, float(STEP), inside, far)


def test_an_area_has_the_mean_displacement_and_strain_with_true_covariances():
    F, C, inside = gradient(20.0, 0.03, 0.0, 0.01), cov(), (CELL[:, 1] > 2) & (CELL[:, 0] != 4)
    E, middle = (F.T @ F - np.eye(2)) / 2, XY[inside].mean(axis=0) @ (F - np.eye(2)).T
    found = [area(d, inside, C) for d in drawn(F, C, 1500)]
    strains = np.array([a.strain.strain[0] - [E[0, 0], E[1, 1], E[0, 1]] for a in found])
    for errors, stated in (
        (strains, found[0].strain.cov[0]), (np.array([a.mean - middle for a in found]), found[0].mean_cov),
    ):  # fmt: skip
        d2, law = mahalanobis2(errors, np.tile(stated, (1500, 1, 1))), chi2(errors.shape[1]).cdf
        assert kstest(d2, law).pvalue > 1e-3
        assert kstest(d2 * 1.1**2, law).pvalue < 1e-3
        assert kstest(d2 / 1.1**2, law).pvalue < 1e-3
    assert found[0].strain.count == inside.sum()
    assert 0.7 < np.mean([a.misfit for a in found]) < 1


def test_an_area_of_several_strains_shows_it_and_a_line_has_none():
    every = np.ones(len(XY), bool)
    assert area(np.column_stack([(XY[:, 0] / 50) ** 2, 0 * XY[:, 0]]), every).misfit > 10
    assert area(0 * XY, CELL[:, 0] == 1) is None
    assert area(np.where(CELL[:, :1] == 1, 0.0, np.nan) + 0 * XY, every) is None


def test_no_plane_is_laid_across_a_gap():
    d = np.where(CELL[:, :1] < 5, [0.0, -2.0], [0.0, 2.0])
    d[CELL[:, 0] == 5] = np.nan
    e = field(d)
    known = np.isfinite(e.strain[:, 0])
    assert np.abs(e.strain[known]).max() < 1e-12
    assert not known[CELL[:, 0] == 5].any()
    assert known[CELL[:, 0] == 4].all()
    assert (e.count[CELL[:, 0] == 4][GAUGE:-GAUGE] == 15).all()


def test_what_touches_at_a_corner_is_not_connected():
    there = np.zeros((1, 5, 5), bool)
    there[0, 2, 2] = there[0, 1, 1] = there[0, 2, 3] = there[0, 2, 4] = True
    assert connected(there, 2).sum() == 3


def test_few_or_collinear_displacements_give_no_strain():
    d = np.full(XY.shape, np.nan)
    d[CELL[:, 0] == 3] = 0.0
    assert not np.isfinite(field(d).strain).any()


def test_the_common_motion_is_separated():
    F = gradient(7.0, 0.0, 0.0, 0.0)
    d = (XY - XY.mean(axis=0)) @ (F - np.eye(2)).T + [3.0, -1.0]
    r = rigid_motion(XY, d, cov(), 1.0)
    np.testing.assert_allclose([*r.shift, np.degrees(r.rotation)], [3.0, -1.0, 7.0], atol=1e-10)
    np.testing.assert_allclose(r.displacement(XY), d, atol=1e-10)


def test_the_covariance_of_the_common_motion_is_true():
    C, rng = cov(), np.random.default_rng(2)
    L, motions = np.linalg.cholesky(C), []
    for _ in range(800):
        r = rigid_motion(XY, np.einsum("nij,nj->ni", L, rng.normal(size=XY.shape)), C, 1.0)
        motions.append([*r.shift, r.rotation])
    d2 = mahalanobis2(np.array(motions), np.tile(r.cov, (800, 1, 1)))
    assert kstest(d2, chi2(3).cdf).pvalue > 1e-3
