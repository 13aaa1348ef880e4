"""The matrices of an adjustment: they give its covariances, its square sum and its datum defect back."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.io import mmread

import raybundle as rb
from raybundle import AdjustmentOptions, adjust
from raybundle.block import Distances
from raybundle.errors import InputError
from tests.adjustment.test_antennas import SHIFT, flight
from tests.adjustment.test_variance_groups import survey, with_bar

OPTIONS = AdjustmentOptions(jobs=1, datum="auto")


@pytest.fixture(scope="module")
def fixed():
    return adjust(survey(), OPTIONS)


@pytest.fixture(scope="module")
def free():
    return adjust(with_bar(survey(), 0.05), OPTIONS)


def scaled_normal(m):
    """N with a diagonal of ones, and the scale."""
    N = m.normal.toarray()
    s = 1 / np.sqrt(np.diag(N))
    return N * np.outer(s, s), s


def test_rows_and_columns_are_those_of_the_adjustment_and_their_names(fixed):
    m = rb.matrices(fixed)
    assert m.design.shape == (fixed.observations, fixed.unknowns) == (len(m.observations), len(m.unknowns))
    assert len(set(m.unknowns)) == len(m.unknowns)
    block = fixed.given
    i, p = block.images.ids[0], block.points.ids[int(block.observations.point[0])]
    assert {f"image {i}:X0", f"image {i}:kappa", f"point {p}:Z"} <= set(m.unknowns)
    assert {f"{block.images.ids[block.observations.image[0]]}/{p}:x"} <= set(m.observations)
    assert sum(n.startswith("control ") for n in m.observations) == 90


@pytest.mark.parametrize("which", ["fixed", "free"])
def test_square_sum_and_stationarity(which, request):
    result = request.getfixturevalue(which)
    m = rb.matrices(result)
    assert m.residuals @ (m.weights @ m.residuals) == pytest.approx(result.weighted_square_sum, rel=1e-9)
    gradient = m.design.T @ (m.weights @ m.residuals)
    assert np.abs(gradient / np.sqrt(m.normal.diagonal())).max() < 1e-4


def test_the_inverse_of_n_is_the_covariance(fixed):
    m = rb.matrices(fixed)
    Ns, s = scaled_normal(m)
    Q = np.linalg.inv(Ns) * np.outer(s, s) * fixed.variance_factor
    ids, at = fixed.given.images.ids, m.unknowns.index
    for i in range(len(ids)):
        k = at(f"image {ids[i]}:X0")
        np.testing.assert_allclose(Q[k : k + 6, k : k + 6], fixed.precision.images[i], rtol=1e-8)
    for p in (0, 17, 60):
        k = [at(f"point {fixed.given.points.ids[p]}:{a}") for a in "XYZ"]
        np.testing.assert_allclose(Q[np.ix_(k, k)], fixed.precision.object_points[p], rtol=1e-8)


def test_what_nothing_fixes_is_the_null_space_of_n_and_distances_have_their_variance(free):
    m = rb.matrices(free)
    Ns, s = scaled_normal(m)
    value, vector = np.linalg.eigh(Ns)
    assert np.count_nonzero(value < 1e-11) == len(free.datum_defect) == 6
    ids, x = free.given.points.ids, free.adjusted.points.xyz
    e = (x[30] - x[10]) / np.linalg.norm(x[30] - x[10])
    g = np.zeros(len(m.unknowns))
    for p, sign in ((10, -1), (30, 1)):
        for k, axis in enumerate("XYZ"):
            g[m.unknowns.index(f"point {ids[p]}:{axis}")] = sign * e[k]
    kept = value > 1e-11
    ours = float(((vector.T @ (g * s))[kept] ** 2 / value[kept]).sum()) * free.variance_factor
    names = [f"point:{ids[p]}" for p in (10, 30)]
    C = np.block([[free.covariance(a, b) for b in names] for a in names])
    assert ours == pytest.approx(float(np.r_[-e, e] @ C @ np.r_[-e, e]), rel=1e-8)


def test_instruments_and_distances_have_their_rows():
    block = flight(SHIFT, control=4)
    xyz = block.points.xyz
    bars = Distances(
        start=np.array([0], np.int32), end=np.array([5], np.int32), length=np.array([np.linalg.norm(xyz[0] - xyz[5])]),
        sigma=np.array([0.01]),
    )  # fmt: skip
    result = adjust(block.adding(bars), OPTIONS)
    m = rb.matrices(result)
    assert m.design.shape == (result.observations, result.unknowns)
    assert f"camera line1:{SHIFT[0]}" in m.unknowns
    assert sum(n.startswith("station ") for n in m.observations) == 36
    assert sum(n.startswith("distance ") for n in m.observations) == 1
    Ns, s = scaled_normal(m)
    Q = np.linalg.inv(Ns) * np.outer(s, s) * result.variance_factor
    k = [m.unknowns.index(f"camera line2:{c}") for c in SHIFT]
    np.testing.assert_allclose(Q[np.ix_(k, k)], result.covariance("camera:line2"), rtol=1e-7)


def test_they_are_written_for_other_programs(fixed, tmp_path):
    m = rb.matrices(fixed)
    rb.write_matrices(m, tmp_path / "m")
    A, P = mmread(tmp_path / "m/design.mtx").tocsr(), mmread(tmp_path / "m/weights.mtx").tocsr()
    assert abs(A - m.design).max() == 0
    assert abs(P - m.weights).max() <= 1e-12 * abs(m.weights).max()
    names = (tmp_path / "m/unknowns.txt").read_text(encoding="utf-8").splitlines()
    assert tuple(names) == m.unknowns
    rb.write_matrices(m, tmp_path / "m.npz")
    with np.load(tmp_path / "m.npz") as kept:
        assert tuple(kept["unknowns"]) == m.unknowns
        np.testing.assert_array_equal(kept["design_data"], m.design.data)
    with pytest.raises(InputError, match=r"file\.exists"):
        rb.write_matrices(m, tmp_path / "m.npz")


def test_covariances_of_several_things_have_names(fixed):
    ids = fixed.given.points.ids
    found = rb.covariance(fixed, [f"point:{ids[3]}", f"point:{ids[9]}"])
    assert found.names == tuple(f"point:{i}:{a}" for i in (ids[3], ids[9]) for a in "XYZ")
    np.testing.assert_allclose(found.matrix[:3, :3], fixed.precision.object_points[3], rtol=1e-9)
    np.testing.assert_allclose(found.matrix, found.matrix.T, rtol=1e-9)
    assert found.std[f"point:{ids[3]}:Z"] == pytest.approx(np.sqrt(found.matrix[2, 2]))


def test_a_copy_has_none(fixed):
    with pytest.raises(InputError, match=r"adjustment\.no_statistics"):
        rb.matrices(replace(fixed, handle=type(fixed.handle)()))
