"""Whole adjustments by the compiled kernels and by their NumPy twins, and with a model of the user's own."""

import json
import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system import normals as normals_module
from raybundle.numerics import native
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.platforms import Carried
from raybundle.sensors import sensor_models
from tests.native.cases import CASES, block_of, own_model, same, two_cameras

pytestmark = pytest.mark.skipif(not native.available(), reason="the kernels are not compiled")
TIGHT = AdjustmentOptions(tolerance=1e-8)
ADJUST = """
import json
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.numerics import native
from tests.native.cases import block_of
result = adjust_block(block_of("fisheye", control=5, scale_bars=1), AdjustmentOptions(tolerance=1e-8))
trace = [float(c[0, 0] + c[1, 1] + c[2, 2]) for c in result.precision.object_points]
print(json.dumps([native.instruction_set(), result.sigma0, *trace]))
"""


def both(block, monkeypatch, options=TIGHT):
    compiled = adjust_block(block, options)
    monkeypatch.setattr(normals_module.native, "module", lambda: None)
    monkeypatch.setattr(normals_module.native, "sensor_models", frozenset)
    twin = adjust_block(block, options)
    monkeypatch.undo()
    assert type(twin.handle.work.normals.solver).__module__ == "raybundle.adjustment.system.normals_numpy"
    assert type(compiled.handle.work.normals.solver).__module__ != "raybundle.adjustment.system.normals_numpy"
    return compiled, twin


@pytest.mark.parametrize("model", sorted(sensor_models))
def test_every_model(model, monkeypatch):
    same(*both(block_of(model, control=6), monkeypatch))


@pytest.mark.parametrize("case", CASES)
def test_every_kind_of_block(case, monkeypatch):
    same(*both(CASES[case](), monkeypatch))


def test_a_robust_start_ends_in_the_same_least_squares(monkeypatch):
    block = block_of(gross_share=0.02, gross_px=8)
    compiled, twin = both(block, monkeypatch, replace(TIGHT, robust_start=True))
    same(compiled, twin)
    assert adjust_block(block, TIGHT).sigma0 == pytest.approx(compiled.sigma0, rel=1e-9)


def test_the_same_numbers_on_one_and_three_threads():
    block = block_of(scale_bars=1)
    same(*(adjust_block(block, replace(TIGHT, jobs=t)) for t in (1, 3)))


def test_sums_have_the_same_bits_for_any_number_of_threads():
    """Also of so many image points that each thread has work: pieces are cut by the block alone."""
    survey = Survey(control=8, orientation="exact", points="exact", interior="exact")
    block = simulate(aerial_scene(AerialStrips(strips=4, images_per_strip=10, points_per_image=500)), survey).observed
    assert len(block.observations) > 16_000
    one, *others = (adjust_block(block, replace(TIGHT, jobs=t)) for t in (1, 2, 5))
    for other in others:
        assert other.sigma0 == one.sigma0
        for found in (lambda a: a.adjusted.points.xyz, lambda a: a.adjusted.images.centre, points_of):
            np.testing.assert_array_equal(found(other), found(one))


def points_of(adjustment):
    """Cofactors of object points, as the statistics give them."""
    return np.asarray(adjustment.precision.object_points)


@pytest.fixture
def mine():
    model = own_model()
    yield model
    del sensor_models[model.name]


def test_a_model_of_the_users_own_equals_the_compiled_one(mine):
    assert not mine.native
    block = block_of(control=5)
    own = block.with_cameras(replace(block.cameras[0], model=mine.name))
    same(adjust_block(block, TIGHT), adjust_block(own, TIGHT))


def test_a_compiled_and_an_own_model_in_one_block(mine):
    block = block_of(control=5)
    same(
        adjust_block(two_cameras(block, "brown"), TIGHT),
        adjust_block(two_cameras(block, mine.name), TIGHT),
    )


def in_a_process(code, **environment):
    done = subprocess.run(
        [sys.executable, "-c", code], check=True, env={**os.environ, **environment}, capture_output=True, text=True
    )
    return done.stdout


def test_the_same_numbers_with_every_instruction_set_and_with_none():
    found = [json.loads(in_a_process(ADJUST, RAYBUNDLE_NATIVE=limit)) for limit in ("1", "avx2", "baseline", "0")]
    widest = found[0][0]
    order = ["baseline", "avx2", "avx512"]
    assert found[1][0] == min(widest, "avx2", key=order.index)
    assert [f[0] for f in found[2:]] == ["baseline", "none"]
    for other in found[1:]:
        assert other[1] == pytest.approx(found[0][1], rel=1e-10)
        assert other[2:] == pytest.approx(found[0][2:], rel=1e-8)


def test_it_works_where_the_extension_was_not_built():
    code = "import sys; sys.modules['raybundle._native'] = None\n" + ADJUST
    name, sigma0, *_ = json.loads(in_a_process(code, RAYBUNDLE_NATIVE="1"))
    assert name == "none"
    assert 0.8 < sigma0 < 1.2


def test_every_shipped_model_is_compiled():
    own = {n: m.sensor if isinstance(m, Carried) else m for n, m in sensor_models.items()}
    while any(isinstance(m, Carried) for m in own.values()):  # a platform on a platform
        own = {n: m.sensor if isinstance(m, Carried) else m for n, m in own.items()}
    shipped = {n for n, m in own.items() if type(m).__module__.startswith("raybundle.") and not m.local_width}
    assert native.sensor_models() == shipped


def test_import_is_light():
    code = "import sys, raybundle; print(sorted({'scipy', 'sympy', 'cv2', 'matplotlib'} & set(sys.modules)))"
    assert in_a_process(code).strip() == "[]"


def test_a_choice_of_kernels_that_there_is_not_is_refused():
    """Who means to switch them off and mistypes it hears of it."""
    done = subprocess.run(
        [sys.executable, "-m", "raybundle", "demo"], env={**os.environ, "RAYBUNDLE_NATIVE": "zzz"}, capture_output=True,
        text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 2
    assert "[environment.native_unknown]" in done.stderr
    assert "Traceback" not in done.stderr
