"""Rows of the design matrix that queries ask for, against differences of the residuals that are adjusted."""

import numpy as np
import pytest

from raybundle.adjustment.evaluation.joint_cofactors import design_rows, whitening
from raybundle.adjustment.system.assemble import packed_whitening
from tests.native.cases import block_of, correlated, held_images, per_image, single_image_camera
from tests.native.test_kernels import setting
from tests.sensors.test_spline import BLOCKS as SPLINES

BLOCKS = {
    "brown": lambda: block_of(control=6),
    "correlated": lambda: correlated(block_of("fisheye", control=5, control_sigma=(1e-4, 0.0, 1e-4))),
    "per image": lambda: per_image(block_of(control=8)),
    "single image": lambda: single_image_camera(block_of(control=8, scale_bars=1)),
    "held images": lambda: held_images(block_of()),
    "splines": SPLINES["with another model"],
}


def image_design(system, state):
    """Whitened design matrix of all image observations: unknowns of nodes, then of points."""
    m, n = len(system.rows), int(system.offsets[-1])
    A = np.zeros((m, 2, n + 3 * len(system.points_used)))
    by_point, columns, by_node = design_rows(system, state, np.arange(m))
    row, at = np.nonzero(columns >= 0)
    A[row, :, columns[row, at]] = by_node[row, :, at]
    point, k = system.block.observations.point[system.rows], np.arange(m)
    for axis in range(3):
        A[k, :, n + 3 * point + axis] = np.where(system.held[point, axis, None], 0.0, by_point[:, :, axis])
    return A.reshape(2 * m, -1)


@pytest.mark.parametrize("name", BLOCKS)
def test_rows_are_derivatives(name):
    normals, state = setting(BLOCKS[name](), compiled=True, threads=1)
    system = normals.system
    normals.reduce(state)
    rng = np.random.default_rng(3)
    rows = np.sort(rng.choice(len(system.rows), 8, replace=False))
    by_point, columns, by_node = design_rows(system, state, rows)
    o = system.block.observations
    N = int(system.offsets[-1])
    A = np.zeros((len(rows), 2, N + 1))
    k = np.arange(len(rows))[:, None]
    for axis in range(2):
        np.add.at(A[:, axis], (k, np.where(columns >= 0, columns, N)), by_node[:, axis])
    A = A[..., :N]
    still = np.zeros_like(state.xyz)
    asked = np.unique(columns[columns >= 0])
    for unknown in rng.permutation(asked)[:24]:
        size = 1e-2 / np.sqrt(normals.diagonal[unknown])
        step = np.zeros(N)
        step[unknown] = size
        up, down = (normals.residuals(system.updated(state, s, still))[0][rows] for s in (step, -step))
        difference = (up - down) / (2 * size)
        np.testing.assert_allclose(A[:, :, unknown], difference, atol=1e-4 * np.abs(difference).max())
    nothing = np.setdiff1d(np.arange(N), asked)
    assert not A[:, :, nothing].any()
    for n, row in enumerate(rows.tolist()):
        point = int(o.point[system.rows[row]])
        for axis in np.flatnonzero(~system.held[point] & (system.point_node[point] < 0)):
            step = still.copy()
            step[point, axis] = 1e-5
            up, down = (normals.residuals(system.updated(state, np.zeros(N), s))[0][row] for s in (step, -step))
            np.testing.assert_allclose(by_point[n, :, axis], (up - down) / 2e-5, rtol=1e-4, atol=1e-2)


def test_whitened_image_points_have_the_unit_matrix():
    """Of correlated coordinates in pixels that are not square, y counted downward: W C W' = I in mm."""
    rng = np.random.default_rng(4)
    root = rng.normal(size=(30, 2, 2))
    C = root @ np.swapaxes(root, 1, 2)
    pixel = np.array([0.006, -0.004])
    packed = np.stack([C[:, 0, 0], C[:, 1, 1], C[:, 0, 1]], axis=1)
    for given in (pixel, np.tile(pixel, (30, 1))):
        W = whitening(packed_whitening(packed, given))
        unit = W @ (C * np.outer(pixel, pixel)) @ np.swapaxes(W, 1, 2)
        np.testing.assert_allclose(unit, np.broadcast_to(np.eye(2), unit.shape), atol=1e-9)
