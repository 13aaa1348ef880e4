"""What is generated evaluates the condition that a model states, near the image point and away from it."""

import numpy as np
import pytest

from raybundle.platforms import Carried
from raybundle.sensors import sensor_models
from tests.sensors.test_contract import scene

STATED = [m for m in sensor_models.values() if not isinstance(m, Carried) and not m.local_width]


@pytest.mark.parametrize("model", STATED, ids=str)
def test_the_condition_is_the_stated_one(model):
    points, rng = scene(model, 30), np.random.default_rng(2)
    image, _ = model.project(points, model.typical)
    values = (model.typical * rng.uniform(0.9, 1.1, (30, len(model.symbols)))).T
    stated = np.stack([np.broadcast_to(v, 30) for v in type(model).condition(*image, *points, *values)])
    np.testing.assert_allclose(model.condition_at(image, points, values), stated, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(
        model.condition_and_jacobian(*image, *points, *values)[0], stated, rtol=1e-12, atol=1e-12
    )
