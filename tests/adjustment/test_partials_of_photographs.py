"""Partial derivatives of photographs that could be taken, of every sensor model, against differences of residuals."""

from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.adjustment.evaluation.additions import _partials
from raybundle.adjustment.system.external import local_residuals_and_partials
from raybundle.adjustment.system.images_numpy import residuals_and_partials
from raybundle.platforms import Carried
from raybundle.sensors import sensor_models
from tests.sensors.test_contract import scene

MODELS = [m for m in sensor_models.values() if not isinstance(m, Carried)]


def residuals(camera, xy, points, values):
    model = camera.sensor
    if model.local_width:
        return local_residuals_and_partials(model, xy, points, values)[0]
    return residuals_and_partials(model, xy, points, np.repeat(values[:, None], len(xy), axis=1), corrected=False)[0]


@pytest.mark.parametrize("model", MODELS, ids=str)
def test_they_are_derivatives_of_the_residuals(model):
    camera = SimpleNamespace(sensor=model, parameters=model.typical)
    points = np.ascontiguousarray(scene(model, 12)[:, 1:])
    xy = np.ascontiguousarray(model.project(points, model.typical)[0].T) + 0.001
    D = _partials(camera, xy, points, corrected=False)
    assert D.shape == (11, 2, 3 + len(model.symbols))
    for k in range(3 + len(model.symbols)):
        if model.local_width and k >= 3 and not D[:, :, k].any():
            continue
        moved = []
        size = 1e-4 if k < 3 else max((1e-3 if model.local_width else 1e-4) * abs(model.typical[k - 3]), 1e-9)
        for s in (size, -size):
            step = np.zeros(3 + len(model.symbols))
            step[k] = s
            moved.append(residuals(camera, xy, points + step[:3, None], model.typical + step[3:]))
        scale = np.abs(D[:, :, k]).max() + 1e-6
        np.testing.assert_allclose(
            D[:, :, k], (moved[0] - moved[1]) / (2 * size), rtol=0, atol=2e-5 * scale + 1e-15 / size
        )
