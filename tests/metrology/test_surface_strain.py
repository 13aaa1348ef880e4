"""Strain of a surface between epochs: that of the surface, however it moves, with a true covariance."""

import numpy as np
import pytest
from scipy.stats import chi2, kstest

from raybundle.metrology.areas import Hypothesis
from raybundle.metrology.congruence import STRAINED, congruence
from raybundle.metrology.point_set import PointSet
from raybundle.metrology.surface_strain import surface_strains
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.numerics.statistics import mahalanobis2

RNG = np.random.default_rng(3)
PLANE = np.column_stack([RNG.uniform(-1, 1, (12, 2)), np.zeros(12)])
STRETCH = np.array([0.01, -0.004, 0.003])


def stretched(xyz, e=STRETCH):
    """Of a plane with Green-Lagrange strains xx, yy, xy of it along X and Y."""
    U = np.linalg.cholesky(np.eye(2) + 2 * np.array([[e[0], e[2]], [e[2], e[1]]])).T
    return np.column_stack([xyz[:, :2] @ U.T, xyz[:, 2]])


def whole(points):
    return [Hypothesis(name="all", points=np.arange(points), given=True)]


def strains(xyz, d, C=None, factor=1.0):
    n = len(xyz)
    C = 1e-6 * np.eye(3 * n) if C is None else C
    return surface_strains(xyz, d[None], C.reshape(1, n, 3, 1, n, 3), whole(n), np.array([factor]), np.array([1e9]))


@pytest.mark.parametrize("turn", [(0.0, 0.0, 0.0), (0.3, -1.1, 0.4), (2.0, 0.5, 0.1)])
def test_strain_is_that_of_the_surface_however_it_is_turned_before_and_after(turn):
    before, after = rotation_from_vector(np.array(turn)), rotation_from_vector(np.array([0.2, 0.4, -0.3]))
    xyz = PLANE @ before.T
    d = stretched(PLANE) @ (after @ before).T + [1.0, 2.0, 3.0] - xyz
    (s,) = strains(xyz, d)
    values, vectors = np.linalg.eigh(np.array([[STRETCH[0], STRETCH[2]], [STRETCH[2], STRETCH[1]]]))
    np.testing.assert_allclose(s.principal, values[::-1], atol=1e-12)
    along = before @ [*vectors[:, 1], 0.0]
    assert abs(s.direction @ along) == pytest.approx(1, abs=1e-9)
    assert np.abs(s.axes @ s.axes.T - np.eye(3)).max() < 1e-12
    assert abs(s.axes[2] @ before[:, 2]) == pytest.approx(1)


def test_the_joint_covariance_is_that_of_errors():
    xyz = PLANE @ rotation_from_vector(np.array([0.3, 0.2, 0.1])).T
    n, rng = len(xyz), np.random.default_rng(5)
    # neighbours share most of their errors
    apart = np.linalg.norm(xyz[:, None] - xyz[None], axis=2)
    C = np.kron(np.exp(-(apart**2)), np.diag([1.0, 2.0, 4.0])) * 1e-8 + 1e-10 * np.eye(3 * n)
    L = np.linalg.cholesky(C)
    found = [strains(xyz, (L @ rng.normal(size=3 * n)).reshape(n, 3), C)[0] for _ in range(500)]
    d2 = mahalanobis2(np.array([s.strain for s in found]), np.array([s.cov for s in found]))
    assert kstest(d2, chi2(3).cdf).pvalue > 1e-3
    assert kstest(d2 / 1.1**2, chi2(3).cdf).pvalue < 1e-3
    assert kstest([s.p_value for s in found], "uniform").pvalue > 1e-3
    wide, narrow = strains(xyz, 0 * xyz, C, 4.0)[0], strains(xyz, 0 * xyz, C)[0]
    np.testing.assert_allclose(wide.cov, 4 * narrow.cov)


def test_points_in_a_line_and_bodies_have_no_surface():
    line = np.column_stack([np.linspace(0, 1, 9), np.zeros(9), np.zeros(9)])
    assert strains(line, 0 * line) == ()
    body = RNG.uniform(-1, 1, (30, 3))
    assert strains(body, 0 * body) == ()
    assert strains(PLANE[:3], 0 * PLANE[:3]) == ()


def test_epochs_show_where_a_surface_is_strained():
    """A slab of which a part is stretched by 0.2 %; the datum is that of the rest."""
    x, y = (a.ravel() for a in np.meshgrid(np.arange(10.0), np.arange(6.0)))
    rng, sigma = np.random.default_rng(8), 2e-4
    xyz = np.column_stack([x, y, 0.2 * np.sin(x)])
    d = np.zeros_like(xyz)
    d[:, 0] = 0.002 * np.maximum(x - 6, 0)
    ids = tuple(f"p{k}" for k in range(len(xyz)))
    sets = [
        PointSet(
            name=n, ids=ids, xyz=p + rng.normal(0, sigma, p.shape), covariance=sigma**2 * np.eye(p.size), freedom=np.inf
        )
        for n, p in (("before", xyz), ("after", xyz + d))
    ]
    found = congruence(
        sets, groups={"end": [i for i, a in zip(ids, x, strict=True) if a >= 6]}, patches=True, scale=False
    )
    end = next(s for s in found.strains if s.given)
    assert end.name == "end"
    assert end.p_value < 1e-6
    assert end.principal[0] == pytest.approx(0.002, abs=4 * end.principal_std[0] + 1e-4)
    patches = [s for s in found.strains if not s.given]
    assert {len(s.points) for s in patches} == {STRAINED}
    still = [s for s in patches if x[s.points].max() < 6]
    assert len(still) > 10
    assert np.mean([s.strain @ np.linalg.solve(s.cov, s.strain) / 3 for s in still]) == pytest.approx(1, abs=0.5)
