"""Redundancy numbers, test values and detectable blunders by dense algebra of A, P and v (Baarda 1968)."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import norm

import raybundle as rb
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.platforms.station import sensor_from_object
from tests.native.cases import CASES

DELTA0 = norm.isf(0.0005) + norm.ppf(0.8)
CHOSEN = (
    "weighted control, heights held", "scale bar and control", "stations", "interior orientation per image",
    "held images, observed c", "correlated image coordinates", "corrected residuals",
)  # fmt: skip


@pytest.fixture(scope="module", params=CHOSEN)
def dense(request):
    """Result, A, P, v, and a generalised inverse of N: what is estimable is the same in each."""
    result = adjust_block(CASES[request.param](), AdjustmentOptions(jobs=1))
    m = rb.matrices(result)
    # rows of the image points in the order of the block
    o, block, at = result.given.observations, result.given, {n: i for i, n in enumerate(m.observations)}
    used = np.flatnonzero(result.image_observations.used)
    names = [f"{block.images.ids[o.image[k]]}/{block.points.ids[o.point[k]]}" for k in used]
    first = [at[f"{name}:{axis}"] for name in names for axis in "xy"]
    order = np.array([*first, *range(len(first), len(at))])
    A, P = m.design.toarray()[order], m.weights.toarray()[np.ix_(order, order)]
    m = replace(m, residuals=m.residuals[order], observations=tuple(m.observations[i] for i in order))
    N = A.T @ P @ A
    s = 1 / np.sqrt(np.diag(N))
    Q = np.linalg.pinv(N * np.outer(s, s), rcond=1e-11, hermitian=True) * np.outer(s, s)
    return result, m, A, P, Q


def test_residuals_are_projections_less_what_was_observed(dense):
    result, m, *_ = dense
    block, o = result.adjusted, result.given.observations
    for k, row in enumerate(np.flatnonzero(result.image_observations.used)[:40]):
        i, p = o.image[row], o.point[row]
        camera = block.cameras[block.images.camera[i]]
        values = dict(zip(camera.sensor.symbols, camera.parameters, strict=True))
        own = next((r for r in result.interior if r.image == block.images.ids[i]), None)
        values |= {} if own is None else {n: q.value for n, q in own.parameters.items()}
        values = np.array([values[n] for n in camera.sensor.symbols])
        P = sensor_from_object(block.images.rotation[i][None], block.images.centre[i][None], block.points.xyz[p][None])
        seen = camera.pixel_from_image(camera.sensor.project(P.reshape(3, 1), values)[0].T)[0]
        v = result.image_observations.residuals_px[row]
        np.testing.assert_allclose(v, seen - o.xy_px[row], atol=1e-3)  # of corrections at the measured point, too
        np.testing.assert_allclose(m.residuals[2 * k : 2 * k + 2], v, atol=1e-9)


def test_statistics_of_all_observations(dense):
    result, m, A, P, Q = dense
    H = A @ Q @ A.T
    redundancy = 1 - np.einsum("ij,ji->i", H, P)
    test = np.diag(P - P @ H @ P)
    weighted = P @ m.residuals
    assert redundancy.sum() == pytest.approx(result.redundancy, abs=1e-5)
    s, used = result.image_observations, np.flatnonzero(result.image_observations.used)
    r, w, t, mdb = (x[used].ravel() for x in (s.redundancy, s.w, s.t, s.mdb_px))
    k = 2 * len(used)
    np.testing.assert_allclose(r, redundancy[:k], atol=1e-6)
    sure = test[:k] > 1e-5 * np.diag(P)[:k]
    assert sure.mean() > 0.8
    root = np.sqrt(test[:k][sure])
    np.testing.assert_allclose(w[sure], weighted[:k][sure] / root, rtol=1e-4, atol=1e-6)
    np.testing.assert_allclose(t[sure] * result.sigma0, w[sure], rtol=1e-12)
    np.testing.assert_allclose(mdb[sure], DELTA0 / root, rtol=1e-4)
    blocks = (np.eye(k) - H[:k, :k] @ P[:k, :k]).reshape(k // 2, 2, k // 2, 2)
    own = [np.linalg.eigvals(blocks[i, :, i]).real.min() for i in range(k // 2)]
    np.testing.assert_allclose(s.least_control[used], own, atol=1e-6)
    names = {n: i for i, n in enumerate(m.observations)}
    for g in result.groups:
        for j in np.flatnonzero(g.sigma > 0):
            i = next(v for n, v in names.items() if n.endswith(f"{g.ids[j]}:{g.component[j]}") and v >= k)
            assert g.residual[j] == pytest.approx(m.residuals[i], rel=1e-6, abs=1e-9)
            assert g.residual[j] == pytest.approx(g.adjusted[j] - g.given[j], rel=1e-6, abs=1e-9)
            assert g.redundancy[j] == pytest.approx(redundancy[i], abs=1e-6)
            assert g.square[j] == pytest.approx(m.residuals[i] * weighted[i], rel=1e-5, abs=1e-12)
            assert g.adjusted_std[j] == pytest.approx(np.sqrt(H[i, i] * result.variance_factor), rel=1e-5)
            if redundancy[i] > 1e-4:
                assert g.w[j] == pytest.approx(weighted[i] / np.sqrt(test[i]), rel=1e-4, abs=1e-6)
                assert g.mdb[j] == pytest.approx(DELTA0 / np.sqrt(test[i]), rel=1e-4)


def test_the_effect_of_a_blunder_on_its_own_point(dense):
    result, m, A, P, Q = dense
    if result.datum_defect:
        pytest.skip("it depends on the datum")
    o, s = result.given.observations, result.image_observations
    for k, row in enumerate(np.flatnonzero(s.used)):
        point = result.given.points.ids[o.point[row]]
        mine = [i for i, n in enumerate(m.unknowns) if n.startswith(f"point {point}:")]
        for axis in np.flatnonzero(s.redundancy[row] > 1e-3):
            moved = Q[mine] @ A.T @ P[:, 2 * k + axis] * s.mdb_px[row, axis]
            assert s.external[row, axis] == pytest.approx(np.abs(moved).max(initial=0.0), rel=1e-4, abs=1e-9)
