"""The compiled kernels against their NumPy twins, and a model of the user's own."""

import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment import normals as normals_module
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.block.simulate import Survey, TargetField, field_scene, simulate
from raybundle.numerics import native
from raybundle.sensors import Parameter, SensorModel, sensor_models

pytestmark = pytest.mark.skipif(not native.available(), reason="the kernels are not compiled")
SCENE = field_scene(TargetField(rows=4, columns=5, stations=4, frontal=1))
FREE = {
    "brown": ("c", "x0", "y0", "K1", "P1"),
    "fisheye": ("c", "x0", "y0", "K1"),
    "panorama": ("c", "y0"),
    "radial": ("c", "k1"),
    "aicon": ("c", "x0", "y0", "K1"),
}


def block_of(model="brown", **survey):
    m = sensor_models[model]
    values = dict(zip(m.symbols, m.typical, strict=True)) | {"c": 20.4}
    camera = replace(SCENE.camera, model=model, values=values, estimate=FREE.get(model, (m.symbols[0],)))
    return simulate(
        replace(SCENE, camera=camera), Survey(points="exact", orientation="exact", interior="exact", **survey)
    ).observed


def both(block, monkeypatch, options=None):
    options = options or AdjustmentOptions(tolerance=1e-7)
    compiled = adjust_block(block, options)
    monkeypatch.setattr(normals_module.native, "module", lambda: None)
    monkeypatch.setattr(normals_module.native, "sensor_models", frozenset)
    twin = adjust_block(block, options)
    monkeypatch.undo()
    assert type(twin.work.normals.solver).__module__ == "raybundle.adjustment.twin"
    assert type(compiled.work.normals.solver).__module__ != "raybundle.adjustment.twin"
    return compiled, twin


def close(a, b, tolerance=2e-6):
    scale = np.nanmax(np.abs(a)) if np.size(a) else 1.0
    np.testing.assert_allclose(a, b, rtol=0, atol=tolerance * scale, equal_nan=True)


def same(a, b):
    assert a.sigma0 == pytest.approx(b.sigma0, rel=1e-10)
    close(a.precision.object_points, b.precision.object_points)
    close(a.precision.images, b.precision.images)
    for key in a.precision.interior:
        close(a.precision.interior[key], b.precision.interior[key])
    close(a.image_observations.residuals_px, b.image_observations.residuals_px)
    close(a.image_observations.redundancy, b.image_observations.redundancy)
    close(a.image_observations.external, b.image_observations.external, 1e-5)
    for g, h in zip(a.groups, b.groups, strict=True):
        close(g.redundancy, h.redundancy)


@pytest.mark.parametrize("model", sorted(sensor_models))
def test_every_model(model, monkeypatch):
    same(*both(block_of(model, control=6), monkeypatch))


@pytest.mark.parametrize(
    "survey",
    [
        {},
        {"control": 5, "control_sigma": (1e-4, 1e-4, 0.0)},
        {"scale_bars": 2},
        {"station_sigma": 1e-3},
        {"control": 4, "scale_bars": 1},
    ],
    ids=str,
)
def test_every_kind_of_datum(survey, monkeypatch):
    same(*both(block_of(**survey), monkeypatch))


def test_interior_orientation_per_image(monkeypatch):
    block = block_of(control=8)
    camera = replace(block.cameras[0], interior="per_image", estimate=("c",))
    same(*both(replace(block, cameras=(camera,)), monkeypatch))


def test_held_images_and_observed_parameters(monkeypatch):
    block = block_of()
    held = np.zeros(len(block.images), bool)
    held[:2] = True
    camera = replace(block.cameras[0], sigma={"c": 0.01})
    same(*both(replace(block, cameras=(camera,), images=replace(block.images, held=held)), monkeypatch))


def test_correlated_image_coordinates_and_both_residuals(monkeypatch):
    block = block_of(control=5)
    cov = block.observations.cov_px2 * [1.0, 2.0, 0.0]
    cov[:, 2] = 0.5 * np.sqrt(cov[:, 0] * cov[:, 1])
    block = replace(block, observations=replace(block.observations, cov_px2=cov))
    same(*both(block, monkeypatch))
    same(*both(block, monkeypatch, AdjustmentOptions(residuals="corrected", tolerance=1e-7)))


def test_a_robust_start_ends_in_the_same_least_squares(monkeypatch):
    block = block_of(gross_share=0.02, gross_px=8)
    robust, twin = both(block, monkeypatch, AdjustmentOptions(robust_start=True, tolerance=1e-7))
    same(robust, twin)
    assert adjust_block(block, AdjustmentOptions(tolerance=1e-7)).sigma0 == pytest.approx(robust.sigma0, rel=1e-9)


def test_a_model_of_the_users_own_equals_the_compiled_one():
    brown = sensor_models["brown"]
    mine = type(
        "Mine",
        (SensorModel,),
        {
            "name": "my-brown",
            "parameters": tuple(
                Parameter(p.symbol, p.unit, p.meaning, p.default, kind=p.kind) for p in brown.parameters
            ),
            "condition": staticmethod(type(brown).condition),
            "__doc__": "Brown's model once more.",
        },
    )
    try:
        assert not sensor_models["my-brown"].native
        block = block_of(control=5)
        own = block.with_cameras(replace(block.cameras[0], model="my-brown"))
        same(
            adjust_block(block, AdjustmentOptions(tolerance=1e-7)), adjust_block(own, AdjustmentOptions(tolerance=1e-7))
        )
        mixed = replace(
            block,
            cameras=(block.cameras[0], replace(own.cameras[0], id="2")),
            images=replace(block.images, camera=np.arange(len(block.images), dtype=np.int32) % 2),
        )
        two = replace(mixed, cameras=(block.cameras[0], replace(block.cameras[0], id="2")))
        same(
            adjust_block(two, AdjustmentOptions(tolerance=1e-7)), adjust_block(mixed, AdjustmentOptions(tolerance=1e-7))
        )
    finally:
        del sensor_models["my-brown"]
    assert mine.name == "my-brown"


def test_it_works_and_says_so_without_the_kernels():
    code = (
        "from raybundle.numerics import native; assert not native.available(); "
        "assert native.instruction_set() == 'none'; import raybundle"
    )
    subprocess.run([sys.executable, "-c", code], check=True, env={**os.environ, "RAYBUNDLE_NATIVE": "0"})


def test_the_kernels_name_their_instruction_set_and_models():
    assert native.instruction_set() in {"baseline", "avx2", "avx512"}
    assert native.sensor_models() == frozenset(
        n for n, m in sensor_models.items() if type(m).__module__.startswith("raybundle.")
    )


def test_import_is_light():
    code = (
        "import sys, raybundle; bad = {'scipy', 'sympy', 'cv2', 'matplotlib'} & set(sys.modules); assert not bad, bad"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_the_same_numbers_on_one_and_two_threads():
    block = block_of()
    one, two = (adjust_block(block, AdjustmentOptions(threads=t, tolerance=1e-7)) for t in (1, 2))
    same(one, two)
