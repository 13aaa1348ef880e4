"""The NumPy twin of what the kernels do with image points: residuals, partial derivatives and projection."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np

from raybundle.adjustment.system.assemble import State, System
from raybundle.numerics.arrays import Array, Mask
from raybundle.platforms.station import sensor_from_object
from raybundle.sensors import SensorModel

BEHIND, LOST = 1, 2
"""Flags of an image observation: point not in front of the sensor; no image point fulfils the condition."""


@cache
def is_explicit(model: SensorModel) -> bool:
    """Whether the condition reads x - f(X, Y, Z, parameters), so that projection needs no iteration."""
    if model.explicit is not None:
        return model.explicit
    with np.errstate(all="ignore"):
        _, J = model.condition_and_jacobian(1.3, 0.7, 0.3, 0.2, -1.5, *np.linspace(0.4, 0.6, len(model.symbols)))
    return bool(np.array_equal(J[:, :2], np.eye(2)))


def residuals_and_partials(
    model: SensorModel, xy: Array, points: Array, values: Array, *, corrected: bool
) -> tuple[Array, Array, Mask]:
    """V (n, 2) [mm], d v / d (point, parameters) (n, 2, 3 + k), and which observations have no projection (n,).

    xy (n, 2) measured, points (3, n) in the sensor frame, values (k, n)
    measured: v = projection - measured, D = -B^-1 dg at the projection; corrected: v = -g, D = -dg at the measured
    point.  Without a projection the corrected form stands in, as in the compiled kernels.
    """
    measured = xy.T
    g, J = model.condition_and_jacobian(*measured, *points, *values)
    v, D = -g, -J[:, 2:]
    lost = np.zeros(len(xy), bool)
    if not (corrected or is_explicit(model)):
        with np.errstate(all="ignore"):
            image, J, lost = project_from(lambda at: model.condition_and_jacobian(*at, *points, *values), measured)
            found = -inverse2(J[:, :2], J[:, 2:])
        v = np.where(lost, v, image - measured)
        D = np.where(lost, D, found)
    return np.ascontiguousarray(v.T), np.ascontiguousarray(np.moveaxis(D, 2, 0)), lost


def project_from(evaluate: Callable[[Array], tuple[Array, Array]], measured: Array) -> tuple[Array, Array, Mask]:
    """Newton from the measured point: image (2, n), Jacobian (2, 5 + k, n) there, and where it fails (n,).

    evaluate  g (2, n) and its Jacobian at image points (2, n)
    """
    image, lost = measured.copy(), np.zeros(measured.shape[1], bool)
    relative = np.full(measured.shape[1], np.inf)
    for _ in range(25):
        g, J = evaluate(image)
        step = inverse2(J[:, :2], g[:, None])[:, 0]
        size, scale = np.abs(step).sum(axis=0), np.abs(image).sum(axis=0) + 1
        lost |= ~(size < 1e3 * scale) | ~(_det2(J) > 0)
        image = np.where(lost, measured, image - step)
        relative = np.where(lost, 0.0, size / scale)
        if relative.max(initial=0.0) < 1e-13:
            break
    lost |= relative > 1e-9
    image = np.where(lost, measured, image)
    return image, evaluate(image)[1], lost


def _det2(J: Array) -> Array:
    return J[0, 0] * J[1, 1] - J[0, 1] * J[1, 0]


def inverse2(B: Array, right: Array) -> Array:
    """B^-1 right for B (2, 2, n) and right (2, k, n)."""
    x = B[1, 1] * right[0] - B[0, 1] * right[1]
    y = B[0, 0] * right[1] - B[1, 0] * right[0]
    return np.stack([x, y]) / _det2(B)


def image_residuals(
    system: System, state: State, image: Array, point: Array, xy: Array
) -> tuple[Array, Array, Array, Array]:
    """Image observations at a state, before whitening.

    image, point  (m,) positions;  xy (m, 2) measured [mm, image frame]
    returns       v (m, 2) [mm]; d v / d (sensor-frame point, interior) (m, 2, 3 + stride); the sensor-frame
                  points P (m, 3); flags (m,), BEHIND + LOST
    """
    m = len(image)
    P = sensor_from_object(state.rotation[image], state.centre[image], state.xyz[point])
    v, D, flags = np.zeros((m, 2)), np.zeros((m, 2, 3 + system.stride)), np.zeros(m, np.uint8)
    models = list(dict.fromkeys(row.sensor for row in system.interior if row.camera >= 0))
    model_of_row = np.array([models.index(row.sensor) if row.camera >= 0 else -1 for row in system.interior])
    row = system.interior_of_image[image]
    corrected = system.corrected[system.block.images.camera[image]]
    for code, model in enumerate(models):
        k = len(model.symbols)
        for form in (False, True):
            mine = np.flatnonzero((model_of_row[row] == code) & (corrected == form))
            if not len(mine):
                continue
            values, local = state.interior[row[mine], :k].T, P[:, mine]
            v[mine], D[mine, :, : 3 + k], lost = residuals_and_partials(model, xy[mine], local, values, corrected=form)
            flags[mine] = BEHIND * ~model.in_front(local, xy[mine].T, values) + LOST * lost
    return v, D, P.T, flags
