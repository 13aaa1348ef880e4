"""Misalignment and lever arm from simulated GNSS and INS, against their truth and their stated sigma."""

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.numerics.attitude import NADIR_FROM_BODY
from raybundle.numerics.rotation import rotation_from_vector, vector_from_rotation
from raybundle.orientation.boresight import boresight, comparison, lever_arm
from raybundle.planning.flights.uav_networks import Flight, flight_scene

ARM = np.array([0.12, -0.05, 0.31])
SHIFT = np.array([0.4, -0.2, 0.1])
TURN = np.radians([0.8, -0.5, 1.9])
SIGMA = np.array([0.02, 0.02, 0.03])
ATTITUDE = np.radians(0.02)


def flown(seed, *, alternating=True, shift=0.0):
    scene = flight_scene(Flight(seed=seed, alternating=alternating, points=2))
    rng = np.random.default_rng(seed)
    n = len(scene.centre)
    gnss = scene.centre + np.swapaxes(scene.rotation, -1, -2) @ ARM + shift * SHIFT + rng.normal(0, 1, (n, 3)) * SIGMA
    mount = rotation_from_vector(TURN) @ NADIR_FROM_BODY
    body = mount.T @ rotation_from_vector(rng.normal(0, ATTITUDE, (n, 3))) @ scene.rotation
    return scene, gnss, np.tile(SIGMA, (n, 1)), body


def test_the_misalignment_is_found_within_its_sigma():
    normalised = []
    for seed in range(60):
        scene, _, _, body = flown(seed)
        found = boresight(scene.rotation, body, NADIR_FROM_BODY)
        mount = rotation_from_vector(TURN) @ NADIR_FROM_BODY
        normalised.append(vector_from_rotation(found.image_from_body @ mount.T) / found.std)
        assert found.sigma == pytest.approx(ATTITUDE, rel=0.4)
    # 180 values: the mean square of a normal variable is good to 11 %
    assert np.mean(np.square(normalised)) == pytest.approx(1, abs=0.35)
    np.testing.assert_allclose(found.misalignment, TURN, atol=5e-4)


def test_the_lever_arm_is_found_within_its_sigma():
    normalised = []
    for seed in range(60):
        scene, gnss, sigma, _ = flown(seed, shift=1.0)
        found = lever_arm(scene.centre, scene.rotation, gnss, sigma, shift=True)
        # headings to both sides part the lever arm and the shift in plan; in height the tilts hardly do
        assert found.not_determinable == ()
        truth = np.concatenate([ARM, SHIFT])
        normalised.append((found.values - truth) / found.std)
        assert found.sigma0 == pytest.approx(1, abs=0.4)
    assert np.mean(np.square(normalised)) == pytest.approx(1, abs=0.35)
    plain = lever_arm(*(v for v in (scene.centre, scene.rotation)), *flown(59)[1:3])
    np.testing.assert_allclose(plain.values, ARM, atol=0.03)
    assert (plain.std < 0.01).all()


def test_equal_headings_do_not_part_lever_arm_and_shift():
    scene = flight_scene(Flight(height_jitter=0.0, angle_jitter_deg=0.0, points=2))
    n = len(scene.centre)
    gnss = scene.centre + np.swapaxes(scene.rotation, -1, -2) @ ARM
    found = lever_arm(scene.centre, scene.rotation, gnss, np.tile(SIGMA, (n, 1)), shift=True)
    assert set(found.not_determinable) == {"ax", "ay", "az", "sx", "sy", "sz"}
    assert np.isnan(found.values).all()
    level = flight_scene(Flight(height_jitter=0.0, angle_jitter_deg=0.0, points=2, alternating=True))
    found = lever_arm(level.centre, level.rotation, gnss, np.tile(SIGMA, (n, 1)), shift=True)
    assert set(found.not_determinable) == {"az", "sz"}


def test_the_comparison_names_what_differs():
    scene, gnss, _, body = flown(3)
    text = comparison(scene.centre, scene.rotation, gnss, body, NADIR_FROM_BODY)
    rows = {line.split("  ")[0].strip().removeprefix("turn about "): line for line in text.splitlines()}
    assert float(rows["Z [m]"].split()[2]) == pytest.approx(0.31, abs=0.03)
    assert float(rows["image z [deg]"].split()[5]) == pytest.approx(-1.9, abs=0.05)
    assert "32 photographs" in text


def test_nothing_in_common_is_refused():
    nothing = np.full((3, 3), np.nan)
    with pytest.raises(InputError, match=r"0.*mounting\.lever_arm"):
        lever_arm(nothing, np.full((3, 3, 3), np.nan), nothing, nothing)
    with pytest.raises(InputError, match=r"mounting\.no_attitudes|mounting\.no_positions"):
        boresight(np.full((3, 3, 3), np.nan), np.full((3, 3, 3), np.nan))
    with pytest.raises(InputError, match=r"mounting\.no_attitudes|mounting\.no_positions"):
        comparison(nothing, np.full((3, 3, 3), np.nan), nothing)
