"""Affinity and shear are free where a sensor can have them; beyond that they are held, and it is said."""

from dataclasses import replace

import pytest

from raybundle.adjustment.blunders.pixel_shape import UNLIKELY, shape_limit, under_its_noise
from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import Severity
from raybundle.calibration.quality import calibration_qualities
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Ring, TargetField, brown_camera, field_scene, ring_scene
from tests.adjustment.test_joint_interior import chosen, simulated

EVERY = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S")


def decided(shape, estimate="auto", options=None, seed=0):
    """A field of targets seen by a camera of this affinity and shear."""
    plan = TargetField(camera=brown_camera(values=shape), rows=8, columns=10, stations=6)
    survey = Survey(seed=seed, orientation="exact", points="exact", image_sigma_px=0.1)
    block = simulate(field_scene(plan), survey).observed
    camera = block.cameras[0]
    camera = replace(camera, estimate=estimate, values={**camera.values, "A": 0.0, "S": 0.0})
    return decide(replace(block, cameras=(camera,)), options or AdjustmentOptions(jobs=1, noise="white"))


def told(result):
    return [n for n in result.notices if n.code == "pixel_shape"]


@pytest.mark.parametrize("shape", [{"A": 2e-4, "S": 0.8e-4}, {"A": -2e-4}, {"S": -0.9e-4}])
def test_what_a_sensor_can_have_is_free(shape):
    result = decided(shape)
    assert not told(result)
    p = result.interior[0].parameters
    for s, value in shape.items():
        assert abs(p[s].value - value) < 4 * p[s].std


@pytest.mark.parametrize(("symbol", "value"), [("S", 1e-3), ("A", -2e-3)])
def test_what_no_sensor_has_is_held_and_said(symbol, value):
    result = decided({symbol: value})
    (notice,) = told(result)
    assert notice.ids[1] == symbol
    assert notice.severity is Severity.WARNING
    assert notice.values["limit"] == shape_limit(result.given.cameras[0], symbol)
    assert notice.values["shear"] == (symbol == "S")
    assert result.interior[0].parameters[symbol].value == 0
    assert symbol not in result.interior[0].free


def test_what_these_photographs_know_worse_than_a_sensor_is_stated_once():
    """It is held for what sensors have, whether it is significant or not."""
    result = chosen(simulated(3, cameras=2), "fields", "sensor")
    held = [n.ids for n in result.notices if n.code == "shape_held"]
    assert held
    for camera, symbol in held:
        (interior,) = [i for i in result.interior if i.camera == camera]
        assert interior.parameters[symbol].status == "held"
        assert f"{symbol} (camera {camera})" not in result.not_significant


def test_where_it_is_nonsense_nothing_is_told_of_the_camera():
    result = decided({"A": -0.03, "S": 0.02})
    assert {n.severity for n in told(result)} == {Severity.FAULT}
    (quality,) = calibration_qualities(result)
    assert quality.grade == "not determinable"
    assert quality.reasons[0] == told(result)[0].text


@pytest.mark.parametrize(
    ("estimate", "options"),
    [(EVERY, None), ("auto", AdjustmentOptions(jobs=1, noise="white", pixel_shape="any"))],
    ids=["named", "any"],
)
def test_a_scan_keeps_its_freedom(estimate, options):
    result = decided({"S": 1e-3}, estimate, options)
    assert not told(result)
    p = result.interior[0].parameters["S"]
    assert abs(p.value - 1e-3) < 4 * p.std


@pytest.mark.parametrize(("ratio", "code"), [(1.0, "pixel_shape"), (3.0, "pixel_shape"), (60.0, "shape_held")])
def test_what_is_said_rests_on_the_noise_that_the_result_has(ratio, code):
    result = decided({"S": 1e-3})
    (white,) = told(result)
    assert 3 * white.critical * white.std < 9e-4 < 60 * white.critical * white.std
    wider = under_its_noise(replace(result, noise=replace(result.noise, kind="fields", ratio_interior=ratio)))
    (notice,) = [n for n in wider.notices if "S" in n.ids]
    assert notice.code == code
    if code == "pixel_shape":
        assert notice.std == pytest.approx(ratio * white.std)
    else:
        assert notice.severity is Severity.NOTE
        assert notice.values["sigma"] == pytest.approx(60 * white.std)


def few(seed, stations, shape=None):
    """A dozen points in few photographs, half a pixel of noise: redundancy 0 to 60 under an automatic choice."""
    camera = brown_camera(values={"K2": 0.0, "K3": 0.0, "P1": 0.0, "P2": 0.0, **(shape or {})})
    scene = field_scene(TargetField(camera=camera, rows=3, columns=5, stations=stations))
    block = simulate(scene, Survey(seed=seed, orientation="exact", points="exact", image_sigma_px=0.5)).observed
    camera = replace(block.cameras[0], estimate="auto", values={**block.cameras[0].values, "A": 0.0, "S": 0.0})
    return decide(replace(block, cameras=(camera,)), AdjustmentOptions(jobs=1, noise="white"))


@pytest.mark.parametrize("runs", [10, pytest.param(120, marks=pytest.mark.long)])
def test_of_clean_blocks_with_little_redundancy_nothing_is_said(runs):
    """One of a thousand may be; at 2.6 standard deviations it was one of ten."""
    said, redundancies = 0, set()
    for stations in (2, 3, 4):
        for seed in range(runs):
            result = few(seed, stations)
            said += bool(told(result))
            redundancies.add(result.redundancy)
    assert said == 0
    assert min(redundancies) < 15 < max(redundancies)


@pytest.mark.parametrize("seed", range(4))
def test_a_value_beyond_the_sensor_by_chance_or_not_is_held_and_nothing_alarming_said(seed):
    """Between the 99 percent at which it is no sensor's and the one of a thousand blocks at which that is told."""
    shear = 1e-4 + 3.3 * decided({}, EVERY).interior[0].parameters["S"].std
    result = decided({"S": shear}, seed=seed)
    said = [n for n in result.notices if "S" in n.ids]
    p = result.interior[0].parameters["S"]
    assert ("S" in result.interior[0].free) == (not said)
    assert not said or p.value == 0
    if p.value:
        assert p.value - 1e-4 <= UNLIKELY * p.std


@pytest.mark.parametrize("seed", range(1, 4))
def test_a_picture_resized_by_a_percent_is_found_where_few_photographs_tell(seed):
    (notice,) = told(few(seed, 6, {"A": 0.01}))
    assert notice.ids[1] == "A"


def turntable(seed):
    """Photographs about one axis, all upright and square to it: an affinity and c can hardly be told apart."""
    camera = brown_camera(
        values={"c": 60.0, "x0": 0.1, "y0": -0.2, "K1": 0.0, "K2": 0.0, "K3": 0.0, "P1": 0.0, "P2": 0.0}
    )
    ring = Ring(
        camera=replace(camera, estimate="auto"), rings=1, roll_deg=(0.0,), stations=20, height=1.0, distance=5.0
    )
    return simulate(
        ring_scene(ring), Survey(seed=seed, image_sigma_px=0.5, points="approximate", interior="exact")
    ).observed


@pytest.mark.parametrize("seed", range(1, 5))
def test_an_affinity_that_the_photographs_know_worse_than_a_sensor_is_held(seed):
    result = decide(turntable(seed), AdjustmentOptions(jobs=1, pixel_shape="sensor"))
    (interior,) = result.interior
    assert "A" not in interior.free
    assert abs(interior.parameters["c"].value - 60.0) < 4 * interior.parameters["c"].std
    wide = decide(turntable(seed), AdjustmentOptions(jobs=1, pixel_shape="any"))
    if "A" in wide.interior[0].free:  # what it would cost
        assert wide.interior[0].parameters["c"].std > 3 * interior.parameters["c"].std
