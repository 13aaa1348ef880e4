"""Figures of interior orientations: effects by projecting again, determinability and F tests by dense algebra."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import f

import raybundle as rb
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.interior import image_effects, image_shifts, plausible_std
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.sensors import sensor_models

MODELS = ["brown", "fisheye", "panorama", "eucm", "brown_rolling", "brown_mounted"]


@pytest.fixture(scope="module")
def result():
    scene = field_scene(TargetField(rows=5, columns=6, stations=5, frontal=1))
    free = ("c", "x0", "y0", "K1", "K2", "P1", "P2", "A")
    camera = replace(scene.camera, estimate=free, sigma={"x0": 0.05})
    survey = Survey(points="exact", orientation="exact", interior="exact", control=8, control_sigma=(1e-3,) * 3)
    return adjust_block(simulate(replace(scene, camera=camera), survey).observed, AdjustmentOptions(jobs=1))


@pytest.mark.parametrize("name", MODELS)
def test_an_effect_is_how_far_image_points_move_where_their_rays_stay(result, name):
    model, distance = sensor_models[name], 1.0 if name == "panorama" else 7.0
    values = dict(zip(model.symbols, model.typical, strict=True)) | {"c": 20.4}
    camera = replace(result.given.cameras[0], model=name, values=values, estimate=())
    shifts = image_shifts(model, camera, camera.parameters, distance)
    half = camera.size_mm / 2
    x, y = (a.ravel() for a in np.meshgrid(*(np.linspace(-1, 1, 9) * h for h in half)))
    points = model.point_on_ray(np.stack([x, y]), np.repeat(camera.parameters[:, None], 81, axis=1), distance)
    for k in range(len(model.symbols)):
        size = 1e-2 / max(np.abs(shifts[:, :, k]).max(), 1e-9)
        ends = [camera.parameters + sign * size * np.eye(len(model.symbols))[k] for sign in (-1, 1)]
        low, high = (model.project(points, v, np.stack([x, y]))[0] for v in ends)
        moved = (high - low) / (2 * size) / np.abs(camera.pixel_mm[0])
        np.testing.assert_allclose(np.abs(shifts[:, :, k].T), np.abs(moved), atol=1e-3 * max(np.abs(moved).max(), 1))
        largest = np.hypot(*moved).max()
        assert image_effects(model, camera, camera.parameters, distance)[k] == pytest.approx(largest, rel=1e-3)


def test_figures_of_parameters(result):
    (interior,) = result.interior
    camera = result.adjusted.cameras[0]
    m = rb.matrices(result)
    N = m.normal.toarray()
    s = 1 / np.sqrt(np.diag(N))
    Q = np.linalg.inv(N * np.outer(s, s)) * np.outer(s, s)
    at = {u.rpartition(":")[2]: i for i, u in enumerate(m.unknowns) if u.startswith("camera ")}
    effects = image_effects(camera.sensor, camera, camera.parameters)
    for symbol, p in interior.parameters.items():
        k = camera.sensor.symbols.index(symbol)
        assert p.value == camera.values[symbol]
        kind = camera.sensor.parameters[k].kind
        assert p.effect_px == (None if kind == "scale" else pytest.approx(effects[k] * abs(p.value)))
        if symbol not in interior.free:
            assert (p.status, p.std, p.t) == ("held", None, None)
            continue
        i = at[symbol]
        assert p.status == ("observed" if symbol == "x0" else "estimated")
        assert p.std == pytest.approx(np.sqrt(Q[i, i] * result.variance_factor), rel=1e-6)
        assert p.determinability == pytest.approx(1 / (Q[i, i] * N[i, i]), rel=1e-6)
        assert p.effect_std_px == pytest.approx(effects[k] * p.std)
        assert p.t == (None if kind == "scale" else pytest.approx(abs(p.value) / p.std))
    C = np.array([[Q[at[a], at[b]] for b in interior.free] for a in interior.free])
    d = np.sqrt(np.diag(C))
    np.testing.assert_allclose(interior.correlations, C / np.outer(d, d), atol=1e-6)
    assert {"K1 K2", "P1 P2"} <= set(interior.joint_tests)
    for name, (F, p) in interior.joint_tests.items():
        k = [interior.free.index(symbol) for symbol in name.split()]
        x = np.array([interior.parameters[symbol].value for symbol in name.split()])
        expected = x @ np.linalg.solve(C[np.ix_(k, k)] * result.variance_factor, x) / len(x)
        assert pytest.approx(expected, rel=1e-5) == F
        assert p == pytest.approx(f.sf(expected, len(x), result.redundancy), rel=1e-4, abs=1e-300)


def test_what_one_knows_beforehand_of_a_camera(result):
    """A twentieth of c, 2 % of the longer side for the principal point, 5 % of half the diagonal for corrections."""
    camera = result.given.cameras[0]
    symbols = camera.sensor.symbols
    effects = image_effects(camera.sensor, camera, camera.parameters)

    def limit(symbol):
        return plausible_std(camera, camera.parameters, symbols.index(symbol), lambda: effects)

    assert limit("c") == pytest.approx(0.05 * camera.values["c"])
    assert limit("x0") == limit("y0") == pytest.approx(0.02 * camera.size_mm.max())
    diagonal = np.hypot(camera.width_px, camera.height_px)
    for symbol in ("K1", "K3", "P1", "A"):
        assert limit(symbol) * effects[symbols.index(symbol)] == pytest.approx(0.05 * diagonal / 2)
