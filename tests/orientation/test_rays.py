"""Rays that meet."""

import numpy as np

from raybundle.orientation.rays import intersect_linear


def test_rays_that_are_no_numbers_take_no_part():
    """As of image points that a lens does not reach: they have no ray, and the others of their point meet."""
    origin = np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 0, 0]])
    direction = np.array([[0, 0, 1.0], [-np.sqrt(0.5), 0, np.sqrt(0.5)], [np.nan] * 3, [0, 0, 1]])
    xyz, rays, _ = intersect_linear(origin, direction, np.array([0, 0, 0, 1]), 2)
    np.testing.assert_allclose(xyz[0], [0, 0, 1], atol=1e-9)
    assert rays.tolist() == [2, 1]
