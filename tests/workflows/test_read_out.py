"""What asks for a shear: the read-out of a rolling shutter, or the pixels."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import Severity
from raybundle.block import Stations
from raybundle.io.photos.metadata import Metadata
from raybundle.io.photos.read_out_times import read_out_time
from raybundle.planning.simulate import Survey, measured, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene, brown_camera
from raybundle.workflows.orienting.read_out import _rolling, read_out, rolling_shutters, velocities, with_cause

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
        self.name, self.metadata = name, Metadata(make="DJI", model="FC330", taken=taken)


def photographs(when):
    return [_Photo(n, t) for n, t in when.items()]


def adjusted(block):
    return decide(block, AdjustmentOptions(jobs=1))


def placed(block, sigma=0.02):
    """The block with observed projection centres, which fix its scale."""
    n = len(block.images)
    rng = np.random.default_rng(11)
    xyz = block.images.centre + rng.normal(0, sigma, (n, 3))
    return block.having(Stations(image=np.arange(n, dtype=np.int32), xyz=xyz, sigma=np.full((n, 3), sigma)))


def test_a_rolling_shutter_that_is_told_stands_in_the_model():
    block, when = flight(SECONDS)
    block = placed(block)
    plain = adjusted(block)
    found = rolling_shutters(plain, block, photographs(when))
    assert [n.code for n in found.notices] == ["read_out"]
    assert "33 ms" in found.notices[0].text  # what others have measured with such a camera
    assert found.block.cameras[0].model == "brown_rolling"
    result = adjusted(found.block)
    r = next(i.parameters["r"] for i in result.interior if i.image is None)
    assert r.status == "estimated"
    assert abs(r.value * 12.0 - SECONDS) < 4 * r.std * 12.0 + 0.02 * SECONDS  # velocities are those of the neighbours
    assert result.weighted_square_sum < 0.8 * plain.weighted_square_sum
    assert result.sigma0 == pytest.approx(1, abs=0.05)
    assert not rolling_shutters(result, found.block, photographs(when)).notices  # it is there


def test_a_known_read_out_is_observed():
    block, when = flight(SECONDS)
    block = placed(block)
    found = rolling_shutters(adjusted(block), block, photographs(when), SECONDS)
    camera = found.block.cameras[0]
    assert camera.values["r"] * 12.0 == pytest.approx(SECONDS)
    assert camera.sigma["r"] == pytest.approx(0.1 * camera.values["r"])
    result = adjusted(found.block)
    assert result.interior[0].parameters["r"].status == "observed"
    assert not any(n.code == "parameter_suspect" for n in result.notices)
    wrong = adjusted(rolling_shutters(adjusted(block), block, photographs(when), 2.5 * SECONDS).block)
    assert any(n.code == "parameter_suspect" for n in wrong.notices)


def test_no_camera_is_taken_for_rolling_without_evidence():
    for seed, read_out_s, shear in ((1, 0.0, 0.0), (2, 0.0, 0.0), (3, 0.0, 1.5e-3)):
        block, when = flight(read_out_s, shear, seed)
        assert rolling_shutters(adjusted(placed(block)), placed(block), photographs(when)).block is None
    block, when = flight(SECONDS)
    result = adjusted(block)  # nothing fixes its scale: a velocity is no length there
    assert rolling_shutters(result, block, photographs(when)).block is None
    assert rolling_shutters(adjusted(placed(block)), placed(block), photographs(when), 0).block is None


def test_a_known_read_out_that_is_of_no_use_says_why():
    block, when = flight(SECONDS)
    (notice,) = rolling_shutters(adjusted(block), block, photographs(when), SECONDS).notices
    assert notice.code == "read_out_unused"
    assert [d.values["lacking"] for d in notice.details] == ["scale"]
    (notice,) = rolling_shutters(
        adjusted(placed(block)), placed(block), photographs(dict.fromkeys(when)), SECONDS
    ).notices
    assert [d.values["lacking"] for d in notice.details] == ["times"]


@pytest.mark.parametrize(
    ("make", "model", "seconds"),
    [
        ("DJI", "FC330", 0.033),
        ("Hasselblad", "L1D-20c", 0.056),
        ("NIKON CORPORATION", "NIKON D800", None),
        ("", "", None),
    ],
)
def test_read_out_times_of_known_cameras(make, model, seconds):
    assert read_out_time(Metadata(make=make, model=model)) == seconds


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
    assert notice.variant == ""
    assert notice.severity in {Severity.FAULT, Severity.WARNING}


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
    assert [d.code for d in found.notice().details] == ["read_out.share"]


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
