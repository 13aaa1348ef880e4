"""How images of fixed rays move by the errors of an interior orientation."""

from __future__ import annotations

import numpy as np

from raybundle.block import Camera
from raybundle.numerics.arrays import Array


def derivatives(camera: Camera, image: Array, points: Array) -> tuple[Array, Array, Array]:
    """dg/d(x, y) (n, 2, 2), dg/d(X, Y, Z) (n, 2, 3) and dg/dp (n, 2, u) at image (2, n) and points (3, n)."""
    values, n = camera.parameters, image.shape[1]
    _, J = camera.sensor.condition_and_jacobian(*image, *points, *np.repeat(values[:, None], n, axis=1))
    J = np.moveaxis(np.broadcast_to(J, (2, 5 + len(values), n)), 2, 0)
    return J[:, :, :2], J[:, :, 2:5], J[:, :, 5:]


def in_pixels(camera: Camera, B: Array, by: Array) -> Array:
    """(n, 2, k) motion of image points in the pixel frame, by dg/d(x, y) (n, 2, 2) and dg/d... (n, 2, k)."""
    return -np.linalg.solve(B, by) / (np.array(camera.pixel_mm) * [1, -1])[:, None]
