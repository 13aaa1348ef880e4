"""What orientation does to heights is linear between nodes: shifts and tilts within a block, and across its edges."""

import numpy as np
import pytest

from raybundle.surfaces import nodes as n
from raybundle.workflows.height_files import read_heights
from tests.surface.height_models import BLOCK, folder_of, made

SHAPE = (70, 100)


def each(shape, moved):
    """(rows, columns, q) of every cell, by hand."""
    return np.stack([n.at_cells(moved[..., k], BLOCK, shape) for k in range(moved.shape[2])], axis=2)


def drawn(q=3, shape=SHAPE, seed=1):
    rows, columns = (-(-k // BLOCK) + 1 for k in shape)
    return np.random.default_rng(seed).normal(size=(rows, columns, q))


def test_cells_lie_linearly_between_nodes():
    r, c = np.mgrid[:4, :5] * float(BLOCK)
    found = n.at_cells(2 + 0.3 * c - 0.1 * r, BLOCK, SHAPE)
    rows, columns = np.mgrid[: SHAPE[0], : SHAPE[1]] + 0.5
    assert np.abs(found - (2 + 0.3 * columns - 0.1 * rows)).max() < 1e-9


def test_sums_variances_and_covariances_are_those_of_single_cells():
    moved, rng = drawn(), np.random.default_rng(2)
    cells, w = each(SHAPE, moved), rng.normal(size=SHAPE)
    assert np.allclose(np.einsum("rc,rcq->q", w, cells), np.einsum("rc,rcq->q", n.splat(w, moved, BLOCK), moved))
    assert np.allclose(n.variances(moved, BLOCK, SHAPE), (cells**2).sum(axis=2))
    P = np.cov(rng.normal(size=(3, 9)))
    assert np.allclose(n.variances(moved, BLOCK, SHAPE, P), np.einsum("rcq,qp,rcp->rc", cells, P, cells))
    weights = np.square(w)
    assert np.allclose(n.information(moved, BLOCK, weights), np.einsum("rc,rcq,rcp->qp", weights, cells, cells))
    one, other = (rng.integers(0, np.array(SHAPE)[:, None], (2, 500)) for _ in range(2))
    found = n.covariances(moved, BLOCK, tuple(one), tuple(other))
    assert np.allclose(found, (cells[tuple(one)] * cells[tuple(other)]).sum(axis=1))


def test_a_tilt_within_a_block_has_a_standard_deviation():
    model = made(np.zeros(SHAPE), common=1e-3)
    one, other = np.zeros(SHAPE), np.zeros(SHAPE)
    one[3:7, 10:14], other[25:29, 10:14] = 1 / 16, 1 / 16
    # the second error tilts by half of 1 mm over a block
    assert model.sum_of(one - other).orientation == pytest.approx(0.5e-3 * 22 / BLOCK, rel=1e-5)
    across = np.roll(one, 24, axis=0)  # as far apart, over the edge of a block
    assert model.sum_of(other - np.roll(across, 22, axis=0)).orientation == pytest.approx(0.5e-3 * 24 / BLOCK, rel=1e-5)
    number = np.array([5 * 100 + 11]), np.array([27 * 100 + 11])
    joint = model.covariance(*number)[0]
    cells = each(SHAPE, model.moved.astype(float))
    assert joint == pytest.approx(float(cells[5, 11] @ cells[27, 11]), rel=1e-5)


def test_nodes_are_found_from_points_of_blocks():
    """What shifts and tilts in the mean of a tile's points, some of its blocks half empty and one in a single line."""
    rng = np.random.default_rng(3)
    coefficients = rng.normal(size=(3, 2))
    known = np.ones((64, 128), bool)
    known[:20, :45] = False
    known[32:, 64:96] = False
    known[40, 64:96] = True
    r, c = np.nonzero(known)
    block = r // BLOCK * 4 + c // BLOCK
    order = np.argsort(block, kind="stable")
    r, c, block = r[order], c[order], block[order]
    values = np.stack([np.ones(len(r)), (c + 0.5) / BLOCK, (r + 0.5) / BLOCK], axis=1) @ coefficients
    _, begin = np.unique(block, return_index=True)
    fitted = n.fits((c + 0.5) / BLOCK % 1 - 0.5, (r + 0.5) / BLOCK % 1 - 0.5, values, begin)
    sums = n.NodeSums.of((64, 128), BLOCK, 2)
    sums.add((0, 0), fitted.reshape(2, 4, 3, 2), known, BLOCK)
    y, x = np.mgrid[:3, :5].astype(float)
    exact = np.stack([np.ones(x.shape), x, y], axis=2) @ coefficients
    assert np.abs(sums.nodes - exact).max() < 0.02 * np.abs(coefficients).max()
    there = each((64, 128), sums.nodes)[known]
    assert np.abs(there - each((64, 128), exact)[known]).max() < 0.01 * np.abs(coefficients).max()


def test_nodes_near_no_height_are_as_the_nearest():
    sums = n.NodeSums.of((128, 128), BLOCK, 1)
    known = np.zeros((32, 32), bool)
    assert not sums.nodes.any()
    sums.add((0, 0), np.full((1, 1, 3, 1), [[[2.0], [0.0], [0.0]]]), ~known, BLOCK)
    assert np.allclose(sums.nodes, 2)


def test_one_value_for_each_block_is_that_of_its_middle():
    r, c = np.mgrid[:3, :4] + 0.5
    values = np.stack([1 + 2 * c - r, r * 0 + 3], axis=2)
    values[1, 1] = 0  # nothing was measured there
    found = n.of_blocks(values)
    y, x = np.mgrid[:4, :5]
    exact = np.stack([1.0 + 2 * x - y, x * 0 + 3.0], axis=2)
    assert np.abs(found - exact)[:, 3:].max() < 1e-9
    assert np.isfinite(found).all()
    assert n.of_blocks(np.full((1, 1, 2), 4.0)).tolist() == [[[4.0, 4.0]] * 2] * 2
    assert not n.of_blocks(np.zeros((2, 2, 1))).any()


def test_older_files_are_read(tmp_path):
    pytest.importorskip("rasterio")
    model = made(np.zeros(SHAPE), common=1e-3)
    folder = folder_of(model, tmp_path / "s")
    path = folder / "heights_orientation.npz"
    with np.load(path) as kept:
        old = {k: kept[k] for k in kept if k != "nodes"}
    middles = (model.moved[1:, 1:] + model.moved[:-1, 1:] + model.moved[1:, :-1] + model.moved[:-1, :-1]) / 4
    np.savez_compressed(path, moved=middles, **old)
    found, _ = read_heights(folder)
    assert np.allclose(found.moved, model.moved, atol=1e-9)


def test_no_errors_of_orientation_at_all():
    moved = drawn(0)
    assert n.splat(np.ones(SHAPE), moved, BLOCK).sum() == pytest.approx(SHAPE[0] * SHAPE[1])
    assert not n.variances(moved, BLOCK, SHAPE).any()
    assert n.information(moved, BLOCK, np.ones(SHAPE)).shape == (0, 0)
    cells = np.zeros(4, int), np.arange(4)
    assert n.covariances(moved, BLOCK, cells, cells).tolist() == [0.0] * 4
    assert n.at_places(moved, np.arange(3.0), np.arange(2.0)).shape == (3, 2, 0)
    assert n.of_blocks(np.zeros((2, 3, 0))).shape == (3, 4, 0)
    assert n.fits(np.zeros(2), np.zeros(2), np.zeros((2, 0)), np.array([0])).shape == (1, 3, 0)
