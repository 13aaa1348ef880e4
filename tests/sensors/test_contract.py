"""Laws every registered sensor model obeys; a new model is tested by existing."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from raybundle.numerics import native
from raybundle.numerics.derive import derive
from raybundle.platforms import Carried, platforms
from raybundle.sensors import Parameter, ProjectionDiverged, SensorModel, sensor_models
from tests.barriers import DEADLINE_S

ROOT = Path(__file__).resolve().parents[2]
FORMAT = 12.0, 8.0
KINDS = {"harmonic", "scale", "principal point", "radial", "decentring", "affinity", "read-out", "other"}
models = pytest.mark.parametrize("model", sensor_models.values(), ids=str)


def scene(model, count=400):
    rng = np.random.default_rng(20)
    points = rng.normal(0.0, 1.0, (3, count))
    points[2] = -rng.uniform(4.0, 20.0, count)
    points[:2, 0] = 1e-9  # on the axis
    return points


@models
def test_statement(model):
    assert len(set(model.symbols)) == len(model.symbols)
    assert all(p.kind in KINDS and p.meaning and p.unit for p in model.parameters)
    assert model.parameters[0].kind == "scale"
    assert model.__doc__
    assert type(model).condition.__doc__
    assert all(p.typical or p.default for p in model.parameters), "a contract at zero proves nothing"
    assert np.isfinite(model.defaults).all()
    assert model.defaults[0] > 0


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
        # coefficients of a curve: most points touch little of one, and rounding by a short step is more than that
        share = 1e-3 if model.local_width else 1e-4
        size = 1e-4 if k < 5 else max(share * abs(model.typical[k - 5]), 1e-9)
        # of a curve's coefficient those that it touches, and some others
        at = np.flatnonzero(jacobian[:, k].any(axis=0) | (np.arange(points.shape[1]) % 8 == 0))
        up, down = ([a[at] + s if i == k else a[at] for i, a in enumerate(arguments)] for s in (size, -size))
        difference = (model.condition_and_jacobian(*up)[0] - model.condition_and_jacobian(*down)[0]) / (2 * size)
        scale = np.abs(jacobian[:, k]).max() + 1e-6
        np.testing.assert_allclose(jacobian[:, k, at], difference, rtol=1e-5, atol=1e-5 * scale)


@models
def test_ray_inverts_the_projection(model):
    points = scene(model)
    image, _ = model.project(points, model.typical)
    ray = model.ray(image, np.repeat(model.typical[:, None], points.shape[1], axis=1))
    if any(p.unit.startswith("length") for p in model.parameters):
        assert np.abs(model.condition_at(image, ray, model.typical)).max() < 1e-9
        return
    expected = points / np.linalg.norm(points, axis=0)
    np.testing.assert_allclose(ray, expected, atol=1e-10)


@models
def test_a_ray_in_closed_form_is_the_one_that_newton_finds(model):
    if not model.by_image:
        pytest.skip("its rays are found by iteration")
    image = np.stack([a.ravel() for a in np.meshgrid(*(np.linspace(-1, 1, 9) * n for n in FORMAT))])
    start = np.stack([*image, np.full(image.shape[1], -model.typical[0])])
    found = model.ray(image, model.typical)
    np.testing.assert_allclose(found, model.ray(image, model.typical, start), atol=1e-14)
    each = np.repeat(model.typical[:, None], image.shape[1], axis=1)
    np.testing.assert_array_equal(found, model.ray(image, each))


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
def test_what_vanishes_behind_is_not_in_front(model):
    """The condition is often fulfilled by the mirrored point as well; then `in_front` has to tell the two apart."""
    points = scene(model)
    values = np.where([p.unit.startswith("length") for p in model.parameters], model.defaults, model.typical)
    image, _ = model.project(points, values)
    fulfilled = np.abs(model.condition_at(image, -points, values)).max(axis=0) < 1e-9
    assert not model.in_front(-points, image, values)[fulfilled].any()
    frame_like = model.name in {"brown", "radial", "aicon"}
    assert not frame_like or fulfilled.all()


@pytest.mark.parametrize("name", ["spherical", "panorama"])
def test_what_turned_has_points_in_front_all_round(name):
    model = sensor_models[name]
    turn, height = (a.ravel() for a in np.meshgrid(np.linspace(-3.1, 3.1, 37), (-3.0, 0.5, 4.0)))
    points = np.stack([10 * np.sin(turn), height, -10 * np.cos(turn)])
    image, _ = model.project(points, model.typical)
    assert model.in_front(points, image, model.typical).all()
    assert not model.in_front(points * [[-1], [1], [-1]], image, model.typical).any()


@models
def test_start_and_in_front_take_one_value_or_one_for_each_point(model):
    points = scene(model)
    each = np.repeat(model.typical[:, None], points.shape[1], axis=1)
    image, by_point = model.project(points, model.typical)
    np.testing.assert_array_equal(model.start(points, each), model.start(points, model.typical))
    np.testing.assert_array_equal(model.in_front(points, image, each), model.in_front(points, image, model.typical))
    np.testing.assert_allclose(model.project(points, each)[0], image, rtol=0, atol=1e-13)
    assert by_point.shape == (2, 3, points.shape[1])


alone = pytest.mark.parametrize("model", [m for m in sensor_models.values() if not isinstance(m, Carried)], ids=str)


@alone
def test_the_first_guess_is_the_image_that_nothing_distorts(model):
    values = np.where([p.symbol == "w" for p in model.parameters], 1e-6, model.defaults)
    points = scene(model)
    np.testing.assert_allclose(model.start(points, values), model.project(points, values)[0], rtol=0, atol=1e-9)


@alone
def test_which_points_may_have_an_image_where_none_was_measured(model):
    points = scene(model)
    assert model.in_front(points).all()
    behind_and_centre = np.column_stack([-points, np.zeros(3)])
    all_round = model.name in {"fisheye", "kannala_brandt", "panorama", "spherical"}
    assert model.in_front(behind_and_centre).tolist() == [all_round] * points.shape[1] + [False]


def test_what_a_panorama_sees_begins_at_its_eccentricity():
    """The projection centre stands before the axis by e: what is nearer to the axis lies behind it."""
    model = sensor_models["panorama"]
    turn = np.linspace(-3, 3, 7)
    image = np.stack([turn * model.typical[0], np.zeros(7)])
    ahead = model.typical[model.symbols.index("e")] * np.stack([np.sin(turn), np.zeros(7), -np.cos(turn)])
    assert [model.in_front(f * ahead, image, model.typical).any() for f in (-2.0, -0.5, 0.5)] == [False] * 3
    assert model.in_front(1.5 * ahead, image, model.typical).all()


@models
def test_the_residual_is_the_way_to_the_projection(model):
    """To first order -B^-1 g at a nearby point leads to the projection, with the weights' B (Gauss-Helmert)."""
    points = scene(model)
    image, _ = model.project(points, model.typical)
    offset = np.array([[3e-5], [-2e-5]])
    values = np.repeat(model.typical[:, None], points.shape[1], axis=1)
    g, J = model.condition_and_jacobian(*(image + offset), *points, *values)
    v = -np.linalg.solve(np.moveaxis(J[:, :2], 2, 0), g.T[..., None])[..., 0].T
    np.testing.assert_allclose(v, np.broadcast_to(-offset, v.shape), rtol=0, atol=1e-9)


@models
def test_it_is_compiled(model):
    if not native.available():
        pytest.skip("the kernels are not compiled")
    assert model.native != bool(model.local_width), "a model of many parameters is evaluated in NumPy"


DERIVED = [
    pytest.param(m, marks=pytest.mark.bench) if isinstance(m, Carried) and m.sensor.name != "brown" else m
    for m in sensor_models.values()
]
"""The chain of sensor and platform is the same code for all: with one sensor it is looked at in every run, the
others, of which the largest takes a minute, by `make bench`; all of them against differences above."""


@pytest.mark.parametrize("model", DERIVED, ids=str)
def test_the_derivation_is_what_was_generated(model):
    """The committed NumPy function against one derived anew."""
    if model.local_width:
        pytest.skip("its Jacobian is written by hand; against differences above")
    points = scene(model, 20)
    image, _ = model.project(points, model.typical)
    arguments = (*image, *points, *np.repeat(model.typical[:, None], 20, axis=1))
    g, J = derive(type(model).condition, model.symbols)(*arguments)
    generated = model.condition_and_jacobian(*arguments)
    np.testing.assert_allclose(generated[0], g, rtol=0, atol=1e-12)
    np.testing.assert_allclose(generated[1], J, rtol=1e-12, atol=1e-12)


def test_generated_files_are_what_the_generator_writes():
    done = subprocess.run(
        [sys.executable, "tools/generate_kernels.py", "--check"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout


NEW_MODEL = """
from raybundle.sensors import Parameter, SensorModel


class Division(SensorModel):
    \"\"\"Division model of radial distortion (Fitzgibbon 2001).\"\"\"

    name = "own_division"
    parameters = (
        Parameter("c", "mm", "camera constant", 20.0, kind="scale"),
        Parameter("L", "mm^-2", "radial distortion", typical=1e-4, kind="radial"),
    )

    @staticmethod
    def condition(x, y, X, Y, Z, c, L):
        \"\"\"Undistorted image point minus central projection.\"\"\"
        scale = 1 / (1 + L * (x * x + y * y))
        return x * scale + c * X / Z, y * scale + c * Y / Z
"""
USE_IT = """
import importlib, sys
import numpy as np
import raybundle.sensors as sensors
import raybundle.platforms
before = set(sensors.sensor_models)
sensors.__path__.append(sys.argv[1])
importlib.import_module("raybundle.sensors.own_division")
new = set(sensors.sensor_models) - before
assert new == {"own_division", *("own_division_" + p for p in (
    "mounted", "rolling", "rolling_mounted", "trajectory", "trajectory_mounted"
))}, new
from dataclasses import replace
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.adjustment.engine import adjust_block
scene = field_scene(TargetField(rows=4, columns=5, stations=4, frontal=1))
camera = replace(scene.camera, model="own_division", values={"c": 20.4, "L": 2e-4}, estimate=("c", "L"))
survey = Survey(control=6, points="exact", orientation="exact", interior="exact")
block = simulate(replace(scene, camera=camera), survey).observed
result = adjust_block(block)
found = result.interior[0].parameters["L"]
assert abs(found.value - 2e-4) < 4 * found.std < 1e-4, found
assert 0.7 < result.sigma0 < 1.3, result.sigma0
print("adjusted")
"""


def test_a_new_file_is_a_new_model(tmp_path):
    """One file among the sensors: registered, derived and adjusted without any other change."""
    (tmp_path / "own_division.py").write_text(NEW_MODEL)
    done = subprocess.run(
        [sys.executable, "-c", USE_IT, str(tmp_path)], capture_output=True, text=True, check=False, timeout=DEADLINE_S
    )
    assert done.stdout.strip() == "adjusted", done.stderr


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


def test_a_parameter_that_would_hide_a_derived_name_is_refused():
    parameters = (Parameter("c", "mm", "camera constant", 20.0, kind="scale"), Parameter("g", "1", "something"))
    condition = staticmethod(lambda x, y, X, Y, Z, c, g: (x + X + g, y + Z + c))  # noqa: ARG005
    with pytest.raises(TypeError, match="cannot be called g"):
        type("Hidden", (SensorModel,), {"name": "hidden", "parameters": parameters, "condition": condition})
    assert "hidden" not in sensor_models


def test_every_frame_sensor_stands_on_every_platform():
    frames = {n for n, m in sensor_models.items() if m.frame and not isinstance(m, Carried)}
    assert {"brown", "fisheye", "rational", "spline", "spherical"} <= frames
    for name in frames:
        assert f"{name}_mounted" in sensor_models
        rolling = sensor_models[name].one_exposure
        moving = [f"{name}_{p}{rig}" for p in ("rolling", "trajectory") for rig in ("", "_mounted")]
        assert [n in sensor_models for n in moving] == [rolling] * 4
    assert not any(n.startswith(("panorama_", "pushbroom_")) for n in sensor_models)
    assert set(platforms) == {"mounted", "rolling", "trajectory"}


def test_no_sensor_moves_twice():
    """A read-out and a trajectory are both motion: neither stands on the other."""

    def motions(model):
        return model.platform.moves + motions(model.sensor) if isinstance(model, Carried) else 0

    assert {name for name, model in sensor_models.items() if motions(model) > 1} == set()


def test_a_line_is_a_model_on_a_trajectory_alone():
    assert "line" not in sensor_models
    assert [n for n, m in sensor_models.items() if isinstance(m, Carried) and m.sensor.line] == ["pushbroom"]
    push, frame = sensor_models["pushbroom"], sensor_models["brown_trajectory"]
    assert push.platform is frame.platform
    assert push.defaults[push.symbols.index("vy")] > 0
    assert not frame.defaults[[frame.symbols.index(s) for s in frame.platform.symbols]].any()
    values = dict(zip(push.symbols, push.typical, strict=True)) | {"vy": 0.0}
    objection = push.objection(values, 24.0, ())
    assert objection is not None
    assert objection.code == "camera.no_motion"
    assert not push.objection(values, 24.0, ("vy",))
    assert not frame.objection(dict(zip(frame.symbols, frame.defaults, strict=True)), 24.0, ())


@pytest.mark.parametrize("model", [m for m in sensor_models.values() if isinstance(m, Carried)], ids=str)
def test_points_on_a_ray_are_all_seen_at_its_image_point(model):
    """Of a sensor that moves or is mounted the ray starts beside the station: it is no direction times a distance."""
    rng = np.random.default_rng(3)
    image = rng.uniform(-1, 1, (2, 60)) * np.array([FORMAT]).T / 2
    values = np.repeat(model.typical[:, None], 60, axis=1)
    near, far = (model.point_on_ray(image, values, distance) for distance in (3.0, 50.0))
    for points in (near, far):
        assert np.abs(model.condition_at(image, points, values)).max() < 1e-9
    np.testing.assert_allclose(np.linalg.norm(far - near, axis=0), 47.0)


def test_a_quadratic_way_is_the_linear_one_of_a_rolling_shutter_where_nothing_changes():
    """A trajectory at v = -r times the velocity of a read-out is that read-out."""
    points = scene(None, 50)
    rolling, way = sensor_models["brown_rolling"], sensor_models["brown_trajectory"]
    r, motion = rolling.typical[10], rolling.typical[11:]
    values = np.concatenate([rolling.typical[:10], -r * motion[:3], np.zeros(3), -r * motion[3:], np.zeros(3)])
    np.testing.assert_allclose(
        way.project(points, values)[0], rolling.project(points, rolling.typical)[0], rtol=0, atol=1e-12
    )


def test_a_sensor_at_rest_in_the_middle_of_its_platform_is_itself():
    points = scene(None, 50)
    for name, model in sensor_models.items():
        if isinstance(model, Carried) and not isinstance(model.sensor, Carried) and not model.sensor.line:
            values = np.concatenate([model.sensor.typical, np.zeros(len(model.platform.parameters))])
            own, _ = model.sensor.project(points, model.sensor.typical)
            np.testing.assert_allclose(model.project(points, values)[0], own, rtol=0, atol=1e-12, err_msg=name)
