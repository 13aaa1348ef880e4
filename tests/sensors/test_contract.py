"""Laws every registered sensor model obeys; a new model is tested by existing."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from raybundle.sensors import ProjectionDiverged, SensorModel, sensor_models

ROOT = Path(__file__).resolve().parents[2]
FORMAT = 12.0, 8.0
KINDS = {"scale", "principal point", "radial", "decentring", "affinity", "other"}
models = pytest.mark.parametrize("model", sensor_models.values(), ids=str)


def scene(model, count=400):
    rng = np.random.default_rng(20)
    points = rng.normal(0.0, 1.0, (3, count))
    points[2] = -rng.uniform(4.0, 20.0, count)
    points[:2, 0] = 1e-9  # on the axis
    return points


def numeric(f, x, h):
    return (f(x + h) - f(x - h)) / (2 * h)


@models
def test_statement(model):
    assert len(set(model.symbols)) == len(model.symbols)
    assert all(p.kind in KINDS and p.meaning and p.unit for p in model.parameters)
    assert model.parameters[0].kind == "scale"
    assert model.__doc__
    assert type(model).condition.__doc__


@models
def test_projection_satisfies_the_condition(model):
    points = scene(model)
    image, _ = model.project(points, model.typical)
    assert np.abs(model.condition_at(image, points, model.typical)).max() < 1e-11


@models
def test_projection_jacobian_is_the_derivative(model):
    points = scene(model)
    _, by_point = model.project(points, model.typical)
    for axis in range(3):
        step = np.zeros((3, 1))
        step[axis] = 1e-4
        difference = (
            model.project(points + step, model.typical)[0] - model.project(points - step, model.typical)[0]
        ) / 2e-4
        np.testing.assert_allclose(by_point[:, axis], difference, rtol=0, atol=3e-6 * np.abs(by_point).max())


@models
def test_condition_jacobian_is_the_derivative(model):
    points = scene(model)
    image, _ = model.project(points, model.typical)
    arguments = [*(image + 0.01), *points, *np.repeat(model.typical[:, None], points.shape[1], axis=1)]
    _, jacobian = model.condition_and_jacobian(*arguments)
    for k in range(len(arguments)):
        size = 1e-4 if k < 5 else max(1e-4 * abs(model.typical[k - 5]), 1e-9)
        up = [a + size if i == k else a for i, a in enumerate(arguments)]
        down = [a - size if i == k else a for i, a in enumerate(arguments)]
        difference = (model.condition_and_jacobian(*up)[0] - model.condition_and_jacobian(*down)[0]) / (2 * size)
        scale = np.abs(jacobian[:, k]).max() + 1e-6
        np.testing.assert_allclose(jacobian[:, k], difference, rtol=1e-5, atol=1e-5 * scale)


@models
def test_ray_inverts_the_projection(model):
    points = scene(model)
    image, _ = model.project(points, model.typical)
    ray = model.ray(image, np.repeat(model.typical[:, None], points.shape[1], axis=1))
    if any(p.unit == "length" for p in model.parameters):
        assert np.abs(model.condition_at(image, ray, model.typical)).max() < 1e-9
        return
    expected = points / np.linalg.norm(points, axis=0)
    np.testing.assert_allclose(ray, expected, atol=1e-10)


@models
def test_the_weights_transform_without_a_fold(model):
    """B = dg / d(x, y) keeps its orientation over the format: the reparametrisation is one-to-one there."""
    x, y = (a.ravel() for a in np.meshgrid(np.linspace(-1, 1, 25) * FORMAT[0], np.linspace(-1, 1, 25) * FORMAT[1]))
    values = np.repeat(model.typical[:, None], x.size, axis=1)
    ray = model.ray(np.stack([x, y]), values)
    _, J = model.condition_and_jacobian(x, y, *ray, *values)
    assert (J[0, 0] * J[1, 1] - J[0, 1] * J[1, 0] > 0).all()


@models
def test_points_ahead_are_in_front(model):
    points = scene(model)
    image, _ = model.project(points, model.typical)
    assert model.in_front(points, image, model.typical).all()


@models
def test_it_is_compiled_and_its_kernel_up_to_date(model):
    from raybundle.numerics import native

    if native.available():
        assert model.native


def test_generated_files_are_what_the_generator_writes():
    done = subprocess.run(
        [sys.executable, "tools/generate_kernels.py", "--check"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout


def test_a_statement_that_contradicts_itself_is_refused():
    with pytest.raises(TypeError, match="condition takes"):
        type(
            "Wrong",
            (SensorModel,),
            {
                "name": "wrong",
                "parameters": (),
                "condition": staticmethod(lambda x, y, X, Y, Z, c: (x + X + Y, y + Z + c)),
            },
        )
    assert "wrong" not in sensor_models


def test_no_projection_is_said():
    brown = sensor_models["brown"]
    with pytest.raises(ProjectionDiverged), np.errstate(all="ignore"):
        brown.project(np.array([[30.0], [10.0], [0.0]]), brown.typical)
