"""What asks for a shear: the read-out of a rolling shutter, or the pixels."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta

import numpy as np
import pytest

from raybundle.adjustment.decide import decide
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.result import Notice
from raybundle.adjustment.severity import Severity
from raybundle.block.simulate import AerialStrips, Survey, aerial_scene, brown_camera, measured, simulate
from raybundle.workflows.read_out import _rolling, read_out, velocities, with_cause

SECONDS = 0.030
INTERVAL = 2.0
LENS = {"c": 12.0, "x0": 0.0, "y0": 0.0, "K1": 0.0, "K2": 0.0, "K3": 0.0, "P1": 0.0, "P2": 0.0}


def flight(read_out_s=0.0, shear=0.0, seed=1):
    """Strips there and back; the camera sideways, so that the read-out shears; what it measures, and the times."""
    camera = brown_camera(values={**LENS, "S": shear}, size_px=(4000, 3000), pixel_mm=0.004, estimate=())
    plan = AerialStrips(camera=camera, height=80.0, relief=20.0, strips=4, images_per_strip=7, points_per_image=150)
    scene = aerial_scene(plan)
    # the aircraft does not turn at the end of a strip: velocities in the axes of the camera change their sign
    level = np.diag([-1.0, -1.0, 1.0])
    back = (np.arange(28) // 7) % 2 == 1
    rotation = np.where(back[:, None, None], scene.rotation @ level, scene.rotation)
    scene = replace(scene, rotation=rotation)
    truth = simulate(scene, Survey(seed=seed, control=0, interior="exact")).truth
    start = datetime(2026, 5, 1, 12, tzinfo=UTC)
    gap = INTERVAL * (np.arange(28) + 3 * (np.arange(28) // 7))
    when = {n: start + timedelta(seconds=float(s)) for n, s in zip(truth.images.ids, gap, strict=True)}
    seen = truth
    if read_out_s:
        velocity, timed = velocities(truth, 0, when)
        assert timed
        seen = _rolling(truth, 0, velocity)
        rolling = replace(seen.cameras[0], values={**seen.cameras[0].values, "r": read_out_s / 12.0})
        seen = replace(seen, cameras=(rolling,))
    observed = measured(seen, 0.2)
    rng = np.random.default_rng(seed)
    xy = observed.observations.xy_px + rng.normal(0, 0.2, observed.observations.xy_px.shape)
    values = {**truth.cameras[0].values, "S": 0.0}
    plain = replace(truth.cameras[0], values=values, estimate="auto")
    block = replace(
        observed, cameras=(plain,), observations=replace(observed.observations, xy_px=xy),
        images=replace(observed.images, interior={}),
    )  # fmt: skip
    return block, when


class _Photo:
    def __init__(self, name, taken):
        self.name, self.metadata = name, type("M", (), {"taken": taken})()


def adjusted(block):
    return decide(block, AdjustmentOptions(threads=1))


def test_a_rolling_shutter_is_named_with_its_read_out_time():
    block, when = flight(SECONDS)
    result = adjusted(block)
    found = read_out(result, "1", when)
    assert found is not None
    assert found.rolling
    assert abs(found.seconds - SECONDS) < max(4 * found.std, 0.1 * SECONDS)
    if not any(n.code == "pixel_shape" for n in result.notices):
        result = replace(result, notices=(Notice(code="pixel_shape", message="", ids=("1", "S")),))
    told = with_cause(result, [_Photo(n, t) for n, t in when.items()])
    codes = [n.code for n in told.notices]
    assert "rolling_shutter" in codes
    assert "pixel_shape" not in codes
    notice = told.notices[codes.index("rolling_shutter")]
    assert "brown_rolling" in notice.message
    assert notice.severity in {Severity.FAULT, Severity.CAUTION}


def test_a_shear_of_the_pixels_is_not_taken_for_one():
    block, when = flight(shear=1.5e-3)
    result = adjusted(block)
    assert any(n.code == "pixel_shape" for n in result.notices)
    found = read_out(result, "1", when)
    assert found is None or not found.rolling
    told = with_cause(result, [_Photo(n, t) for n, t in when.items()])
    assert [n.code for n in told.notices] == [n.code for n in result.notices]


@pytest.mark.parametrize("seed", range(1, 4))
def test_a_global_shutter_raises_no_alarm(seed):
    block, when = flight(seed=seed)
    result = adjusted(block)
    assert read_out(result, "1", when) is None
    assert with_cause(result, [_Photo(n, t) for n, t in when.items()]) is not None
    assert not any(n.code == "rolling_shutter" for n in with_cause(result, []).notices)


def test_without_times_the_interval_is_the_unit():
    block, when = flight(SECONDS)
    found = read_out(adjusted(block), "1", dict.fromkeys(when))
    assert found is not None
    assert not found.timed
    assert "of the interval between two photographs" in found.notice().message


def test_no_velocity_is_taken_across_a_turn_or_a_gap():
    block, when = flight()
    velocity, _ = velocities(block, 0, when)
    assert np.isfinite(velocity).all()  # the ends of strips by their own side
    close = {n: t - timedelta(seconds=6 * (k // 7)) for k, (n, t) in enumerate(when.items())}  # turned at once
    at_once, _ = velocities(block, 0, close)
    assert at_once == pytest.approx(velocity)
    few = {n: t + timedelta(hours=k % 2) for k, (n, t) in enumerate(when.items())}
    assert not np.isfinite(velocities(replace(block, images=shuffled(block.images)), 0, few)[0]).all()


def shuffled(images):
    order = np.random.default_rng(1).permutation(len(images))
    return replace(images, centre=images.centre[order])
