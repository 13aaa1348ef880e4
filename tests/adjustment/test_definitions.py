"""Statistics by their definitions, on small numbers of which the answer is known otherwise."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.adjustment.blunders.identical_control import _largest_scale
from raybundle.adjustment.evaluation.image_interiors import OwnInteriors, groups_of
from raybundle.adjustment.records.figures import VarianceComponent
from raybundle.adjustment.statistics.components import settled_components
from raybundle.adjustment.statistics.reliability import _of_piece
from raybundle.adjustment.system.datum import well_spread
from raybundle.numerics.statistics import DELTA0
from tests.native.cases import block_of


def test_tests_of_correlated_image_points_are_those_of_their_matrices():
    rng = np.random.default_rng(1)
    n = 60
    a, b, c = 10 ** rng.uniform(-3, 3, n), rng.normal(size=n), 10 ** rng.uniform(-3, 3, n)
    b *= a
    c[:20], a[:20] = 10 ** rng.uniform(-0.3, 0.3, (2, 20))
    W = np.zeros((n, 2, 2))
    W[:, 0, 0], W[:, 1, 0], W[:, 1, 1] = a, b, c
    half = rng.normal(size=(n, 2, 2))
    R = half @ half.transpose(0, 2, 1)
    R /= 2 * np.trace(R, axis1=1, axis2=2)[:, None, None]
    R[::5] *= 1e-11  # not controlled
    H = np.eye(2) - R
    v = rng.normal(size=(n, 2))
    effects = rng.normal(size=(n, 3, 2))
    pixel = np.tile([0.005, -0.004], (n, 1))
    system = SimpleNamespace(whiten=np.stack([a, b, c], axis=1), pixel_mm=pixel)
    hat = np.stack([H[:, 0, 0], H[:, 1, 1], H[:, 1, 0]], axis=1)
    found = _of_piece(system, v, SimpleNamespace(hat=hat, effect=effects), 2.0, slice(None))
    mm = np.linalg.solve(W, v[:, :, None])[:, :, 0]
    np.testing.assert_allclose(found["residuals_px"], mm / pixel, rtol=1e-9)
    P = W.transpose(0, 2, 1) @ W
    Qvv = np.linalg.solve(W, np.linalg.solve(W, R.transpose(0, 2, 1)).transpose(0, 2, 1))
    sure = np.arange(n) % 5 > 0
    redundancy = np.einsum("nij,nji->ni", Qvv, P)
    np.testing.assert_allclose(
        found["redundancy"][sure], redundancy[sure], rtol=1e-6, atol=1e-6 * np.abs(redundancy).max()
    )
    np.testing.assert_allclose(found["least_control"][sure], np.linalg.eigvalsh(R)[sure, 0], atol=1e-12)
    variance = np.einsum("nij,njk,nki->ni", P, Qvv, P)
    for name in ("w", "t", "mdb_px", "external"):
        assert np.isnan(found[name][~sure]).all()
    w = (P @ mm[:, :, None])[:, :, 0] / np.sqrt(variance) * [1, -1]
    np.testing.assert_allclose(found["w"][sure], w[sure], rtol=1e-5)
    np.testing.assert_allclose(found["t"][sure], w[sure] / 2, rtol=1e-5)
    mdb = DELTA0 / np.sqrt(variance)
    np.testing.assert_allclose(found["mdb_px"][sure], (mdb / np.abs(pixel))[sure], rtol=1e-5)
    moved = np.abs(effects @ W).max(axis=1) * mdb
    np.testing.assert_allclose(found["external"][sure], moved[sure], rtol=1e-5)


def test_groups_that_two_parameters_show_together_alone_are_found():
    rng, n = np.random.default_rng(0), 24
    C = np.array([[1.0, 0.9], [0.9, 1.0]])
    covariance = np.kron(np.eye(n), C)
    values = rng.multivariate_normal([0, 0], C, n)
    assert groups_of(OwnInteriors(images=np.arange(n), difference_px=values, covariance=covariance)) is None
    second = np.arange(n) % 2 == 1
    values[second] += [1.6, -1.6]
    images = np.arange(n) + 100
    found = groups_of(OwnInteriors(images=images, difference_px=values, covariance=covariance))
    assert found is not None
    assert sorted(i.tolist() for i in found.images) == [images[~second].tolist(), images[second].tolist()]
    assert found.probability < 1e-2
    j = 0 if found.symbol == "c" else 1
    means = [values[np.isin(images, i), j].mean() for i in found.images]
    np.testing.assert_allclose(found.means_px, means)
    within = sum(((values[np.isin(images, i), j] - m) ** 2).sum() for i, m in zip(found.images, means, strict=True))
    assert np.isclose(found.scatter_px, np.sqrt(within / (n - 2)))


def test_the_largest_scale_of_photographs_of_two_known_points_is_that_of_these():
    block = block_of(control=8)
    o = block.observations
    first = int(o.image[0])
    rows = o.point[np.flatnonzero(o.image == first)[:2]]
    mine = np.isin(o.point, rows) & (o.image == first)
    block = replace(block, observations=o.rows(mine | ~np.isin(o.point, rows)))
    far = np.linalg.norm(np.diff(block.points.xyz[rows], axis=0))
    apart = np.linalg.norm(np.diff(o.xy_px[mine], axis=0))
    assert _largest_scale(block, rows, far / 2) == pytest.approx(apart / far)
    assert _largest_scale(block, rows, 2 * far) == 0


@pytest.mark.parametrize("significant", [False, True])
def test_components_are_iterated_where_one_is_significant(significant):
    kinds = [
        VarianceComponent(kind=kind, group="all", count=90, redundancy=60.0, ratio=ratio, significant=is_significant)
        for kind, ratio, is_significant in (("image observations", 1.1, False), ("control", 0.9, significant))
    ]

    class Asked(Exception):
        pass

    def adjusted(block):
        raise Asked

    if significant:
        with pytest.raises(Asked):
            settled_components(block_of(control=4), tuple(kinds), adjusted)
    else:
        assert settled_components(block_of(control=4), tuple(kinds), adjusted) == tuple(kinds)
    alone = (replace(kinds[0], significant=True),)
    assert settled_components(block_of(), alone, adjusted) == alone


def test_the_datum_is_carried_by_points_of_many_rays_that_are_not_far_off():
    rng, n = np.random.default_rng(5), 240
    xyz, rays = rng.normal(size=(n, 3)), rng.permutation(n)
    xyz[rays > 220] *= 1000
    datum = SimpleNamespace(defect=7, centre=np.zeros(3), extent=1.5, basis=np.eye(7))
    given = np.zeros((n, 3), bool)
    given[:, 2] = rays % 2 == 0
    points, axes, share = well_spread(xyz, rays, given, datum)
    assert len(points) == 7
    assert share > 0.01
    near = np.flatnonzero(np.linalg.norm(xyz, axis=1) < 4.5)
    assert np.isin(points, near[np.argsort(-rays[near])[:60]]).all()
    assert not given[points, axes].any()
    assert well_spread(xyz[:2], rays[:2], given[:2], datum)[2] == 0
