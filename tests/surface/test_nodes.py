"""What orientation does to heights is linear between nodes: shifts and tilts within a block, and across its edges."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.surfaces.files.heights import read_heights
from raybundle.surfaces.heights import node_sums as m
from raybundle.surfaces.heights import nodes as n
from tests.surface.height_models import BLOCK, folder_of, made

SHAPE = (70, 100)


def each(shape, moved, factors=None):
    """(rows, columns, q) of every cell, by hand."""
    return np.stack([n.at_cells(moved[..., k], BLOCK, shape, factors) for k in range(moved.shape[3])], axis=2)


def drawn(q=3, shape=SHAPE, seed=1, parts=1):
    rows, columns = (-(-k // BLOCK) + 1 for k in shape)
    return np.random.default_rng(seed).normal(size=(rows, columns, parts, q))


def test_cells_lie_linearly_between_nodes():
    r, c = np.mgrid[:4, :5] * float(BLOCK)
    found = n.at_cells((2 + 0.3 * c - 0.1 * r)[..., None], BLOCK, SHAPE)
    rows, columns = np.mgrid[: SHAPE[0], : SHAPE[1]] + 0.5
    assert np.abs(found - (2 + 0.3 * columns - 0.1 * rows)).max() < 1e-9


@pytest.mark.parametrize("parts", [1, 4])
def test_sums_variances_and_covariances_are_those_of_single_cells(parts):
    moved, rng = drawn(parts=parts), np.random.default_rng(2)
    factors = None if parts == 1 else rng.normal(size=(*SHAPE, parts))
    cells, w = each(SHAPE, moved, factors), rng.normal(size=SHAPE)
    shares = n.splat(w, moved, BLOCK, factors)
    assert np.allclose(np.einsum("rc,rcq->q", w, cells), np.einsum("rck,rckq->q", shares, moved))
    assert np.allclose(n.variances(moved, BLOCK, SHAPE, factors=factors), (cells**2).sum(axis=2))
    P = np.cov(rng.normal(size=(3, 9)))
    by_cells = np.einsum("rcq,qp,rcp->rc", cells, P, cells)
    assert np.allclose(n.variances(moved, BLOCK, SHAPE, P, factors), by_cells)
    weights = np.square(w)
    by_cells = np.einsum("rc,rcq,rcp->qp", weights, cells, cells)
    assert np.allclose(n.information(moved, BLOCK, weights, factors), by_cells)
    one, other = (rng.integers(0, np.array(SHAPE)[:, None], (2, 500)) for _ in range(2))
    found = n.covariances(moved, BLOCK, tuple(one), tuple(other), factors)
    assert np.allclose(found, (cells[tuple(one)] * cells[tuple(other)]).sum(axis=1))


def test_parts_are_each_linear_between_nodes():
    moved, rng = drawn(parts=4), np.random.default_rng(5)
    factors = rng.normal(size=(*SHAPE, 4))
    apart = [each(SHAPE, moved[:, :, k : k + 1]) for k in range(4)]
    assert np.allclose(
        each(SHAPE, moved, factors),
        sum(f[..., None] * m for f, m in zip(np.moveaxis(factors, 2, 0), apart, strict=True)),
    )


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
    plane = 500 + 0.3 * (c + 0.5) / BLOCK
    none = np.zeros_like(values)
    found = m.moments((c + 0.5) / BLOCK % 1 - 0.5, (r + 0.5) / BLOCK % 1 - 0.5, plane, (values, none, 2 + none), begin)
    sums = m.NodeSums.of((64, 128), BLOCK, 2)
    whole = replace(
        found, products=found.products.reshape(2, 4, 4, 4), sums=found.sums.reshape(2, 4, 10, 2),
        base=found.base.reshape(2, 4),
    )  # fmt: skip
    sums.add((0, 0), whole, known, BLOCK)
    nodes, levels = sums.solved(1.0)
    y, x = np.mgrid[:3, :5].astype(float)
    exact = np.stack([np.ones(x.shape), x, y], axis=2) @ coefficients
    assert np.abs(nodes[:, :, 0] - exact).max() < 0.02 * np.abs(coefficients).max()
    # a plane tells nothing of a change with the height
    assert np.abs(nodes[:, :, 1]).max() < 0.01 * np.abs(coefficients).max()
    assert np.abs(nodes[:, :, 2:] - [[[[0.0] * 2, [2.0] * 2]]]).max() < 1e-5
    assert np.abs(levels - 500 - 0.3 * x).max() < 0.01
    there = each((64, 128), nodes[:, :, :1])[known]
    assert np.abs(there - each((64, 128), exact[:, :, None])[known]).max() < 0.01 * np.abs(coefficients).max()


def test_nodes_near_no_height_are_as_the_nearest():
    sums = m.NodeSums.of((128, 128), BLOCK, 1)
    assert not sums.solved(1.0)[0].any()
    at, two = np.array([-0.4, 0.4, -0.4, 0.4]), np.full((4, 1), 2.0)
    found = m.moments(at, at[[0, 0, 1, 1]], np.full(4, 3.0), (two, 0 * two, 0 * two), np.array([0]))
    one = replace(found, products=found.products[None], sums=found.sums[None], base=found.base[None])
    sums.add((0, 0), one, np.ones((32, 32), bool), BLOCK)
    nodes, levels = sums.solved(1.0)
    assert np.allclose(nodes[:, :, 0], 2)
    assert np.allclose(nodes[:, :, 1:], 0)
    assert np.allclose(levels, 3)


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
    about = folder / "heights.toml"  # of those without check sums
    about.write_text("".join(x for x in about.read_text().splitlines(keepends=True) if "sha256" not in x))
    nodes = model.moved[:, :, 0]
    middles = (nodes[1:, 1:] + nodes[:-1, 1:] + nodes[1:, :-1] + nodes[:-1, :-1]) / 4
    for by in ({"moved": middles}, {"nodes": nodes}):
        np.savez_compressed(path, **by, **old)
        found, _ = read_heights(folder)
        assert np.allclose(found.moved, model.moved, atol=1e-9)
        assert found.factors is None


def test_no_errors_of_orientation_at_all():
    moved = drawn(0)
    assert n.splat(np.ones(SHAPE), moved, BLOCK).sum() == pytest.approx(SHAPE[0] * SHAPE[1])
    assert not n.variances(moved, BLOCK, SHAPE).any()
    assert n.information(moved, BLOCK, np.ones(SHAPE)).shape == (0, 0)
    cells = np.zeros(4, int), np.arange(4)
    assert n.covariances(moved, BLOCK, cells, cells).tolist() == [0.0] * 4
    assert n.at_places(moved, np.arange(3.0), np.arange(2.0)).shape == (3, 2, 1, 0)
    assert n.of_blocks(np.zeros((2, 3, 0))).shape == (3, 4, 0)
    none = np.zeros((2, 0))
    assert m.moments(np.zeros(2), np.zeros(2), np.zeros(2), (none, none, none), np.array([0])).sums.shape == (1, 10, 0)
    assert m.moments(*np.zeros((3, 0)), (none[:0],) * 3, np.zeros(0, int)).sums.shape == (0, 10, 0)
