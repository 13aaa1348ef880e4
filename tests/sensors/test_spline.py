"""The spline model: its surfaces, its sparse columns in the compiled solver, and what a calibration with it says."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.interpolate import BSpline

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import assemble
from raybundle.block.boards import spline_camera
from raybundle.calibration.maps import calibration_difference, uncertainty_of
from raybundle.errors import InputError
from raybundle.numerics import native
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.sensors import sensor_models
from raybundle.sensors.spline import _basis
from tests.native.cases import block_of, close, correlated
from tests.native.test_adjustments import both
from tests.native.test_kernels import blocks_agree, setting

SPLINE = sensor_models["spline"]
compiled_only = pytest.mark.skipif(not native.available(), reason="the kernels are not compiled")


def test_what_is_evaluated_is_the_stated_condition():
    """The NumPy function of this model is written by hand."""
    rng = np.random.default_rng(4)
    image, points = rng.uniform(-12, 12, (2, 30)), np.stack([*rng.normal(0, 5, (2, 30)), rng.uniform(-20, 2, 30)])
    values = (SPLINE.typical * rng.uniform(0.9, 1.1, (30, len(SPLINE.symbols)))).T
    stated = np.stack(type(SPLINE).condition(*image, *points, *values))
    np.testing.assert_allclose(SPLINE.condition_at(image, points, values), stated, rtol=0, atol=1e-12)


def test_points_up_to_120_degrees_off_the_axis_are_seen():
    off, turn = np.radians([0, 60, 119, 121, 180]), np.linspace(0, 6, 5)
    ways = np.stack([np.sin(off) * np.cos(turn), np.sin(off) * np.sin(turn), -np.cos(off)])
    for far in (0.1, 40.0):
        assert SPLINE.in_front(far * ways).tolist() == [True, True, True, False, False]


@pytest.mark.parametrize("count", [12, 9])
def test_splines_add_up_to_one_and_their_slopes_are_differences_to_half_a_cell_beyond_the_field(count):
    cell = 1 / (count - 3)
    t = np.linspace(-0.5 - 1.5 * cell, 0.5 + 1.5 * cell, 400)
    first, value, slope = _basis(t, count)
    np.testing.assert_allclose(value.sum(axis=0), 1, atol=1e-12)
    assert first.min() == 0
    assert first.max() == count - 4
    knots = np.random.default_rng(0).normal(size=count)

    def curve(t):
        first, value, _ = _basis(t, count)
        return (value * knots[first + np.arange(4)[:, None]]).sum(axis=0)

    found = (slope * knots[first + np.arange(4)[:, None]]).sum(axis=0)
    inside = np.abs(np.abs(t) - 0.5 - cell / 2) > 1e-4
    np.testing.assert_allclose(found[inside], ((curve(t + 1e-6) - curve(t - 1e-6)) / 2e-6)[inside], atol=1e-5)
    beyond = np.abs(t) > 0.5 + 0.51 * cell
    assert not found[beyond].any()
    np.testing.assert_allclose(curve(t[beyond]), curve(np.sign(t[beyond]) * (0.5 + cell / 2)))


def second_is_spline(block):
    """Images in turn by the block's camera and by one of the spline model."""
    cameras = (block.cameras[0], replace(spline_camera(block.cameras[0], sigma_px=5), id="2"))
    turn = np.arange(len(block.images), dtype=np.int32) % 2
    return replace(block, cameras=cameras, images=replace(block.images, camera=turn))


def one_image_is_spline(block):
    """The first image alone has the spline camera."""
    block = second_is_spline(block)
    turn = (np.arange(len(block.images)) == 0).astype(np.int32)
    return replace(block, images=replace(block.images, camera=turn))


BLOCKS = {
    "all": lambda: replace(block_of(control=6), cameras=(spline_camera(block_of(control=6).cameras[0], sigma_px=5),)),
    "with another model": lambda: second_is_spline(correlated(block_of(control=6, control_sigma=(1e-4, 0.0, 1e-4)))),
    "retained points": lambda: second_is_spline(block_of(control=5, scale_bars=3)),
    "inner constraints": lambda: second_is_spline(block_of()),
    "held": lambda: replace(
        BLOCKS["all"](), cameras=tuple(replace(c, estimate=(), sigma={}) for c in BLOCKS["all"]().cameras)
    ),
    "one image": lambda: one_image_is_spline(block_of(control=8)),
}


@compiled_only
@pytest.mark.parametrize("name", BLOCKS)
def test_normal_equations_are_those_of_the_twin(name):
    (compiled, state), (twin, _) = (setting(BLOCKS[name](), compiled=c) for c in (True, False))
    assert compiled.external.any()
    a, b = (n.reduce(state, damping=1e-3, huber=1.5) for n in (compiled, twin))
    assert a[0] == pytest.approx(b[0], rel=1e-11)
    blocks_agree(compiled, twin, compiled.values, twin.values, 1e-10)
    close(compiled.right, twin.right, 1e-9)
    a, b = (n.step(state, damping=1e-3, huber=1.5) for n in (compiled, twin))
    close(a[0], b[0], 1e-6)
    close(a[1], b[1], 1e-6)


@pytest.mark.long
@compiled_only
@pytest.mark.parametrize("name", ["with another model", "retained points", "one image"])
def test_adjustments_are_those_of_the_twin(name, monkeypatch):
    a, b = both(BLOCKS[name](), monkeypatch)
    assert a.sigma0 == pytest.approx(b.sigma0, rel=1e-9)
    assert a.redundancy == b.redundancy
    std = np.maximum(a.precision.object_point_std, 1e-9)
    assert np.nanmax(np.abs(a.adjusted.points.xyz - b.adjusted.points.xyz) / std) < 1e-3
    close(a.precision.object_points, b.precision.object_points, 1e-6)
    for key in a.precision.interior:
        close(a.precision.interior[key], b.precision.interior[key], 1e-6)
    for g, h in ((a.image_observations, b.image_observations), *zip(a.groups, b.groups, strict=True)):
        np.testing.assert_allclose(g.redundancy, h.redundancy, rtol=0, atol=1e-6)
    close(a.image_observations.external, b.image_observations.external, 1e-5)


def test_local_derivatives_are_all_that_there_are():
    rng = np.random.default_rng(1)
    points = np.stack([*rng.normal(0, 3, (2, 50)), -rng.uniform(2, 5, 50)])
    image, _ = SPLINE.project(points, SPLINE.typical)
    g, near, touched = SPLINE.local(image, points, SPLINE.typical)
    whole, J = SPLINE.condition_and_jacobian(*image, *points, *SPLINE.typical)
    np.testing.assert_allclose(g, whole, atol=1e-12)
    assert np.count_nonzero(J[:, 5:]) <= np.count_nonzero(near[:, 5:])
    for k in range(50):
        np.testing.assert_array_equal(J[:, 5 + touched[k], k], near[:, 5:, k])


@pytest.mark.long
def test_a_lens_that_no_formula_has_is_calibrated_with_true_sigma():
    """A wavy lens, which Brown's model leaves at several pixels; the spline brings it to the noise."""
    width, height = 24.0, 16.0
    brown = field_scene(TargetField()).camera
    lens = spline_camera(brown)
    knots = [p.symbol for p in SPLINE.parameters if p.symbol.startswith("s")]
    rng = np.random.default_rng(2)
    waves = dict(zip(knots, rng.normal(0, 0.01, len(knots)).tolist(), strict=True))
    truth = replace(lens, values={**lens.values, **waves})
    field = TargetField(camera=truth, rows=12, columns=16, stations=16, frontal=4, depth=0.5)
    survey = Survey(points="exact", orientation="exact", interior="exact", seed=3)
    block = simulate(field_scene(field), survey).observed
    start = replace(lens, estimate=lens.estimate, sigma=dict.fromkeys(knots, 0.02))
    result = adjust_block(replace(block, cameras=(start,)))
    assert 0.9 < result.sigma0 < 1.1
    plain = adjust_block(replace(block, cameras=(brown,)))
    assert plain.sigma0 > 5
    adjusted = result.adjusted.cameras[0]
    difference = calibration_difference(adjusted, truth)
    sigma = uncertainty_of(result, adjusted.id).std
    seen = (np.abs(difference.xy_px[..., 0] - 3000) < 2400) & (np.abs(difference.xy_px[..., 1] - 2000) < 1500)
    ratio = difference.shift_px[seen] / sigma[seen][:, None]
    assert 0.5 < np.sqrt(np.mean(ratio**2)) < 1.5
    assert np.median(sigma[seen]) < 0.1
    assert (adjusted.size_mm == [width, height]).all()


@pytest.mark.long
def test_a_knot_without_observations_keeps_its_sigma():
    scene = field_scene(TargetField(rows=5, columns=5, size=(0.5, 0.5), stations=6, frontal=1))
    block = simulate(scene, Survey(points="exact", orientation="exact", interior="exact")).observed
    camera = spline_camera(block.cameras[0], sigma_px=4)
    held = replace(camera, estimate=tuple(s for s in camera.estimate if s not in {"c", "x0", "y0", "K1", "K2", "K3"}))
    result = adjust_block(replace(block, cameras=(held,)))
    corner = result.interior[0].parameters["sx0101"]
    assert corner.std == pytest.approx(4 * 0.004 * result.sigma0, rel=1e-3)
    assert corner.status == "observed"
    assert corner.value == pytest.approx(0, abs=1e-6)
    middle = result.interior[0].parameters["sx0605"]
    assert middle.std < 0.8 * corner.std


def test_a_spline_of_each_image_is_refused():
    block = BLOCKS["all"]()
    camera = replace(block.cameras[0], interior="per_image")
    with pytest.raises(InputError, match=r"camera\.parameters_of_image"):
        assemble(
            replace(block, cameras=(camera,)),
            AdjustmentOptions(),
            np.zeros(len(block.observations), bool),
            {"1": ("c",)},
        )


@pytest.mark.parametrize("count", [9, 12])
def test_splines_are_those_of_scipy_within_and_constant_from_half_a_cell_beyond(count):
    cells = count - 3
    t = np.linspace(-0.5 - 0.49 / cells, 0.5 + 0.49 / cells, 401)
    first, value, slope = _basis(t, count)
    knots = np.arange(-3, count + 1.0)  # one a cell, the field from 0 to `cells`
    rng = np.random.default_rng(2)
    coefficients = rng.normal(size=count)
    truth = BSpline(knots, coefficients, 3, extrapolate=True)
    at = first[None] + np.arange(4)[:, None]
    np.testing.assert_allclose((value * coefficients[at]).sum(axis=0), truth((t + 0.5) * cells), atol=1e-12)
    np.testing.assert_allclose((slope * coefficients[at]).sum(axis=0), cells * truth((t + 0.5) * cells, 1), atol=1e-10)
    ends = np.array([-0.5, 0.5]) * (1 + 1 / cells)
    border = _basis(ends * (1 - 1e-12), count)
    for factor in (1 + 1e-9, 1.3, 4.0):
        first, value, slope = _basis(ends * factor, count)
        np.testing.assert_array_equal(first, border[0])
        np.testing.assert_allclose(value, border[1], atol=1e-9)
        assert not slope.any()
