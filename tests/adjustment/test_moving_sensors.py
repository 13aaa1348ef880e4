"""Sensors that move while they measure, cameras on a rig, stitched panoramas: parameters of single images and shared
stations, in the compiled kernels and their NumPy twin.
"""

import functools
from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Camera
from raybundle.errors import InputError, RankDefect
from raybundle.io.block.folder import read_block, write_block
from raybundle.numerics import native
from raybundle.planning.simulate import measured
from raybundle.planning.synthetic_networks import look_at
from raybundle.platforms.rig import mounting_of, orientation_of
from raybundle.sensors import sensor_models
from tests.truth.bands import assert_true_to_ten_percent
from tests.truth.mixed_blocks import (
    MonteCarlo,
    block_of,
    control_table,
    errors_and_joint,
    mixed,
    two_camera_rig,
)
from tests.truth.twins import assert_the_twin_agrees

RATES = ("vx", "vy", "vz", "wx", "wy", "wz")
READ_OUT = 0.028 / 12.0


def rolling(estimate=RATES, sigma=None, stations=8):
    """A drone with a rolling shutter, 12 mm high format read in 28 ms, at 3 m/s and up to 0.2 rad/s."""
    rng = np.random.default_rng(41)
    xyz = np.column_stack([rng.uniform(-25, 25, (120, 2)), rng.uniform(0, 6, 120)])
    xyz[:5, :2] = [[-20, -20], [20, -20], [20, 20], [-20, 20], [0, 0]]
    centre = np.column_stack(
        [np.linspace(-12, 12, stations), 6 * np.cos(np.arange(stations)), rng.uniform(38, 44, stations)]
    )
    rotation = look_at(centre, centre * [0.6, 0.5, 0], rng.uniform(0, 6.28, stations), up=np.array([0.0, 1.0, 0.0]))
    values = dict.fromkeys(sensor_models["brown_rolling"].symbols, 0.0) | {"c": 11.0, "K1": -2e-4, "r": READ_OUT}
    camera = Camera(
        id="drone", model="brown_rolling", width_px=4000, height_px=3000, pixel_mm=(0.004, 0.004), values=values,
        estimate=estimate, per_image=RATES, sigma=sigma or {},
    )  # fmt: skip
    own = {}
    for i in range(stations):
        v, w = rng.normal(0, 3, 3) * [1, 1, 0.2], rng.normal(0, 0.1, 3)
        own[i] = dict(zip(RATES, (*v, *w), strict=True))
    block = block_of(
        [camera], np.zeros(stations), centre, rotation, xyz, *control_table(120, 5, 10, 0.01), interior=own
    )
    return measured(block, 0.3)


def observed(block, seed=1):
    return MonteCarlo.of(block).noisy(np.random.default_rng(seed))


SIGMA = {"vx": 0.3, "vy": 0.3, "vz": 0.3}
"""Velocities as a flight record tells them [m/s]."""


def test_a_rolling_shutter_gives_motion():
    truth = rolling(sigma=SIGMA)
    result = adjust_block(observed(truth))
    assert 0.9 < result.sigma0 < 1.1
    own = [i for i in result.interior if i.image is not None]
    assert len(own) == len(truth.images)
    assert set(own[0].parameters) == set(RATES)
    shared = next(i for i in result.interior if i.image is None)
    assert shared.parameters["c"].status == "held"
    assert "vx" not in shared.parameters


@pytest.mark.parametrize("free", [RATES, ("r", *RATES)], ids=["motion", "motion and read-out time"])
def test_sigmas_of_a_rolling_shutter_are_true_to_ten_percent(free):
    sigma = SIGMA if "r" not in free else {**SIGMA, "wx": 2e-3, "wy": 2e-3, "wz": 2e-3}
    for name, (d2, degrees) in errors_and_joint(rolling(free, sigma=sigma), 25, seed=3)[1].items():
        assert_true_to_ten_percent(d2, degrees, name)


def test_neglected_motion_is_noticed():
    result = adjust_block(
        replace(observed(rolling(sigma=SIGMA)), cameras=(replace(rolling().cameras[0], estimate=()),))
    )
    still = {i: dict.fromkeys(RATES, 0.0) for i in range(8)}
    block = observed(rolling(sigma=SIGMA))
    block = replace(
        block, cameras=(replace(block.cameras[0], estimate=(), sigma={}),), images=replace(block.images, interior=still)
    )
    neglected = adjust_block(block)
    assert neglected.global_test[1] > 3 * neglected.global_test[2]
    assert result.redundancy == neglected.redundancy


def test_the_read_out_time_is_estimated_where_the_motion_is_known():
    truth = rolling(("r", *RATES), sigma={**SIGMA, "wx": 2e-3, "wy": 2e-3, "wz": 2e-3})
    block = observed(truth)
    start = replace(
        block, cameras=(replace(block.cameras[0], values={**block.cameras[0].values, "r": 0.8 * READ_OUT}),)
    )
    p = next(i for i in adjust_block(start).interior if i.image is None).parameters["r"]
    assert p.status == "estimated"
    assert abs(p.value - READ_OUT) < 4.5 * p.std < 0.4 * READ_OUT


def test_the_read_out_time_is_called_not_determinable_without_known_motion():
    with pytest.raises(RankDefect, match=r"rank\.not_determined"):
        adjust_block(observed(rolling(("r", *RATES))))


def test_motion_of_single_images_goes_through_a_block_folder(tmp_path):
    block = observed(rolling(sigma=SIGMA))
    write_block(block, tmp_path / "block")
    again = read_block(tmp_path / "block")
    assert again.cameras == block.cameras
    assert again.images.interior == {k: dict(v) for k, v in block.images.interior.items()}
    assert adjust(again).sigma0 == pytest.approx(adjust_block(block).sigma0, rel=1e-6)
    text = (tmp_path / "block" / "interior.csv").read_text(encoding="utf-8")
    (tmp_path / "block" / "interior.csv").write_text(text.replace(",vx,", ",c_mm,", 1), encoding="utf-8")
    with pytest.raises(InputError, match=r"c_mm.*interior\.shared"):
        read_block(tmp_path / "block")


def test_the_offset_of_a_rig_is_found():
    truth = two_camera_rig()
    result = adjust_block(observed(truth))
    right = next(i for i in result.interior if i.camera == "right").parameters
    for symbol in ("bx", "by", "bz", "om", "ph", "ka"):
        assert right[symbol].status == "estimated"
        assert abs(right[symbol].value - truth.cameras[1].values[symbol]) < 4.5 * right[symbol].std
    assert right["bx"].std < 1e-3
    both = result.adjusted.images
    np.testing.assert_array_equal(both.centre[0], both.centre[1])
    # a calibrated offset counts as observed
    held = replace(truth, cameras=(truth.cameras[0], replace(truth.cameras[1], sigma={"bx": 1e-4, "ph": 1e-5})))
    calibrated = next(i for i in adjust_block(observed(held)).interior if i.camera == "right").parameters
    assert calibrated["bx"].status == "observed"
    assert calibrated["bx"].std < 1.1e-4


def test_a_free_rig_needs_a_scale(tmp_path):
    """Without control or distances the offsets scale with the object: scale is open, and inner constraints take it."""
    truth = two_camera_rig()
    points = replace(
        truth.points, role=np.zeros_like(truth.points.role), sigma=np.full_like(truth.points.sigma, np.nan)
    )
    free = adjust_block(replace(observed(truth), points=points))
    assert "scale" in free.datum_defect
    held = replace(truth.cameras[1], estimate=("om", "ph", "ka"))
    fixed = adjust_block(replace(observed(truth), points=points, cameras=(truth.cameras[0], held)))
    assert "scale" not in fixed.datum_defect


def test_a_rig_goes_through_a_block_folder(tmp_path):
    block = observed(two_camera_rig())
    write_block(block, tmp_path / "block")
    again = read_block(tmp_path / "block")
    np.testing.assert_array_equal(again.images.station, block.images.station)
    assert adjust_block(again).sigma0 == pytest.approx(adjust_block(block).sigma0, rel=1e-6)


def test_images_of_a_station_that_differ_are_refused():
    block = two_camera_rig()
    centre = block.images.centre.copy()
    centre[1] += 0.1
    with pytest.raises(InputError, match=r"1.*2.*station\.orientations_differ"):
        adjust_block(replace(block, images=replace(block.images, centre=centre)))


def test_mountings_and_orientations_are_inverse():
    rng = np.random.default_rng(3)
    centre, rotation = np.array([1.0, -2.0, 3.0]), look_at(np.array([[1.0, 2.0, 3.0]]), np.zeros((1, 3)), 0.3)[0]
    mounting = dict(zip(("bx", "by", "bz", "om", "ph", "ka"), rng.normal(0, 0.3, 6), strict=True))
    C, R = orientation_of(centre, rotation, mounting)
    back = mounting_of(centre, rotation, C, R)
    assert back == pytest.approx(mounting)
    X = np.array([0.3, 0.2, -9.0])
    mounted, brown = sensor_models["brown_mounted"], sensor_models["brown"]
    values = np.array([20.0, *np.zeros(9), *mounting.values()])
    image = mounted.project((rotation @ (X - centre))[:, None], values)[0]
    np.testing.assert_allclose(image, brown.project((R @ (X - C))[:, None], values[:10])[0], atol=1e-12)


@functools.cache
def panoramas(*, free):
    """Spherical panoramas of one spot each, the points' scale from control."""
    rng = np.random.default_rng(7)
    xyz = rng.uniform(0, 1, (60, 3)) * [10, 8, 4]
    c = 8000 / (2 * np.pi) * 0.01
    camera = Camera(
        id="sphere", model="spherical", width_px=8000, height_px=4000, pixel_mm=(0.01, 0.01),
        values={"c": c, "y0": 0.02}, estimate=("y0",) if free else (),
    )  # fmt: skip
    centre = np.array([[2.5, 2.0, 1.5], [7.5, 2.2, 1.6], [5.0, 6.0, 1.4]])
    rotation = look_at(centre, centre + np.array([1.0, 0.2, 0.0]))
    return measured(block_of([camera], np.zeros(3), centre, rotation, xyz, *control_table(60, 4, 8, 0.002)), 0.5)


@pytest.mark.parametrize("free", [True, False])
def test_stitched_panoramas(free):
    truth = panoramas(free=free)
    assert (np.bincount(truth.observations.image) > 55).all()
    assert 0.8 < adjust_block(observed(truth)).sigma0 < 1.2


@pytest.mark.parametrize("free", [True, False])
def test_sigmas_of_stitched_panoramas_are_true_to_ten_percent(free):
    for name, (d2, degrees) in errors_and_joint(panoramas(free=free), 120, seed=3)[1].items():
        assert_true_to_ten_percent(d2, degrees, name)


@pytest.mark.skipif(not native.available(), reason="the kernels are not compiled")
def test_the_twin_agrees_on_a_rolling_shutter(monkeypatch):
    assert_the_twin_agrees(observed(rolling(sigma=SIGMA)), monkeypatch)


def test_parameters_are_chosen_in_a_mixed_block_and_motion_stays():
    """`auto` chooses among the lens parameters; what the block names of the others stays estimated."""
    result = decide(observed(mixed()), AdjustmentOptions(estimate="auto", jobs=1))
    assert 0.9 < result.sigma0 < 1.1
    push = [i for i in result.interior if i.camera == "pushbroom" and i.image is not None]
    assert all(set(i.free) == set(RATES) for i in push)
    assert not any("pushbroom, image" in name for name in result.not_determinable)
    assert {i.camera: i.free for i in result.interior}["forward"] == ("A0", "B0")
