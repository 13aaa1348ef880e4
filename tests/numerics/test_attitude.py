"""Attitudes of others against published or hand-computed values, and there and back."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from raybundle.numerics.attitude import (
    FRONT_FROM_BODY,
    GON,
    NADIR_FROM_BODY,
    body_from_ned,
    gimbal_from_rotation,
    opk_from_rotation,
    pok_from_rotation,
    rotation_from_gimbal,
    rotation_from_opk,
    rotation_from_pok,
    rotation_from_rpy,
    rpy_from_body,
    rpy_from_rotation,
)

EAST, NORTH, UP = np.eye(3)


def deg(*angles):
    return np.radians(angles)


def test_omega_phi_kappa_by_hand():
    # omega 90: the object's Y axis (north) becomes what the image's -z axis sees ... R1(90) = [1 0 0; 0 0 1; 0 -1 0]
    np.testing.assert_allclose(rotation_from_opk(deg(90, 0, 0)), [[1, 0, 0], [0, 0, 1], [0, -1, 0]], atol=1e-15)
    # published in BLOCK_FORMAT: R3(90) = [0 1 0; -1 0 0; 0 0 1]: kappa 90 turns the image's x axis to the north
    R = rotation_from_opk(deg(0, 0, 90))
    np.testing.assert_allclose(R.T @ [1, 0, 0], NORTH, atol=1e-15)


def test_kraus_matrix_of_omega_phi_kappa():
    """Kraus 2007, volume 1, appendix: rotation image to object of omega, phi, kappa; elements written out."""
    o, p, k = deg(1.5, -2.0, 50.0)
    D = rotation_from_opk(np.array([o, p, k])).T
    assert D[0, 0] == pytest.approx(np.cos(p) * np.cos(k), abs=1e-15)
    assert D[0, 1] == pytest.approx(-np.cos(p) * np.sin(k), abs=1e-15)
    assert D[0, 2] == pytest.approx(np.sin(p), abs=1e-15)
    assert D[1, 2] == pytest.approx(-np.sin(o) * np.cos(p), abs=1e-15)
    assert D[1, 0] == pytest.approx(np.cos(o) * np.sin(k) + np.sin(o) * np.sin(p) * np.cos(k), abs=1e-15)
    assert D[2, 2] == pytest.approx(np.cos(o) * np.cos(p), abs=1e-15)


def test_phi_omega_kappa_is_the_other_order():
    small = deg(0.3, -0.2, 40.0)
    phi_first = rotation_from_pok(small)
    omega_first = rotation_from_opk(small[[1, 0, 2]])
    # the two differ by the product of the tilts alone
    gap = Rotation.from_matrix(phi_first @ omega_first.T).magnitude()
    assert gap == pytest.approx(abs(small[0] * small[1]), rel=1e-3)
    np.testing.assert_allclose(rotation_from_pok(deg(20, 0, 0)), rotation_from_opk(deg(0, 20, 0)), atol=1e-15)
    assert pytest.approx(np.pi / 2) == 100 * GON


@pytest.mark.parametrize(
    ("angles", "forward", "right"),
    [
        ((0, 0, 0), NORTH, EAST),
        ((0, 0, 90), EAST, -NORTH),  # yaw clockwise from north
        ((0, 30, 0), np.cos(np.pi / 6) * NORTH + 0.5 * UP, EAST),  # nose up
        ((30, 0, 0), NORTH, np.cos(np.pi / 6) * EAST - 0.5 * UP),  # right wing down
        ((10, 0, 180), -NORTH, None),
    ],
)
def test_roll_pitch_yaw_of_an_aircraft(angles, forward, right):
    C = body_from_ned(np.radians(angles))  # rows: forward, right, down in north, east, down
    enu = C[:, [1, 0, 2]] * [1, 1, -1]
    np.testing.assert_allclose(enu[0], forward, atol=1e-15)
    if right is not None:
        np.testing.assert_allclose(enu[1], right, atol=1e-15)


def test_body_matrix_equals_the_intrinsic_zyx_of_scipy():
    angles = deg(5.0, -12.0, 213.0)
    theirs = Rotation.from_euler("ZYX", angles[::-1]).as_matrix()  # body to NED
    np.testing.assert_allclose(body_from_ned(angles), theirs.T, atol=1e-15)


def test_a_camera_below_an_aircraft_that_flies_north_has_all_angles_zero():
    np.testing.assert_allclose(rotation_from_rpy(deg(0, 0, 0)), np.eye(3), atol=1e-15)
    # heading east turns the image clockwise: kappa -90 degrees
    np.testing.assert_allclose(np.degrees(opk_from_rotation(rotation_from_rpy(deg(0, 0, 90)))), [0, 0, -90], atol=1e-12)
    # right wing down: the view goes to the left (west), phi is negative by how our phi turns
    R = rotation_from_rpy(deg(10, 0, 0))
    assert -R[2] @ EAST == pytest.approx(-np.sin(np.radians(10)))
    # nose up: the view goes forward
    R = rotation_from_rpy(deg(0, 10, 0))
    assert -R[2] @ NORTH == pytest.approx(np.sin(np.radians(10)))


@pytest.mark.parametrize(
    ("angles", "view", "upper"),
    [
        ((0, 0, 0), NORTH, UP),
        ((90, 0, 0), EAST, UP),
        ((90, -90, 0), -UP, EAST),  # nadir: yaw is the direction of the image's upper side
        ((0, -45, 0), (NORTH - UP) / np.sqrt(2), (NORTH + UP) / np.sqrt(2)),
        ((180, -90, 0), -UP, -NORTH),
        ((0, 0, 20), NORTH, None),
    ],
)
def test_gimbal_of_a_camera(angles, view, upper):
    R = rotation_from_gimbal(np.radians(angles))
    np.testing.assert_allclose(-R[2], view, atol=1e-15)
    if upper is not None:
        np.testing.assert_allclose(R[1], upper, atol=1e-15)


def test_a_recorded_gimbal_near_the_nadir():
    """Yaw 45, pitch -89.9, roll 0 as a drone recorded it: kappa -45 and the axis 0.1 degree to the north-east."""
    R = rotation_from_gimbal(deg(45.0, -89.9, 0.0))
    tilt = np.sin(np.radians(0.1)) / np.sqrt(2)
    np.testing.assert_allclose(-R[2], [tilt, tilt, -np.cos(np.radians(0.1))], atol=1e-12)
    assert np.degrees(opk_from_rotation(R)[2]) == pytest.approx(-45.0, abs=1e-3)


def test_nadir_and_gimbal_mounts_agree():
    """A camera that a gimbal points down from a level aircraft is the camera fixed below it."""
    np.testing.assert_allclose(rotation_from_gimbal(deg(37, -90, 0)), rotation_from_rpy(deg(0, 0, 37)), atol=1e-15)
    for mount in (NADIR_FROM_BODY, FRONT_FROM_BODY):
        np.testing.assert_allclose(mount @ mount.T, np.eye(3))
        assert np.linalg.det(mount) == pytest.approx(1)


ANGLE = st.floats(-3.1, 3.1)
MIDDLE = st.floats(-1.5, 1.5)


@given(a=ANGLE, b=MIDDLE, c=ANGLE)
def test_there_and_back(a, b, c):
    for to, back, angles in (
        (rotation_from_opk, opk_from_rotation, (a, b, c)),
        (rotation_from_pok, pok_from_rotation, (a, b, c)),
        (rotation_from_rpy, rpy_from_rotation, (a, b, c)),
        (body_from_ned, rpy_from_body, (a, b, c)),
        (rotation_from_gimbal, gimbal_from_rotation, (a, b, c)),
    ):
        np.testing.assert_allclose(back(to(np.array(angles))), angles, atol=1e-9)


@given(a=ANGLE, c=ANGLE, sign=st.sampled_from([-1, 1]))
def test_where_two_angles_are_one_the_rotation_comes_back(a, c, sign):
    for to, back in (
        (rotation_from_opk, opk_from_rotation),
        (rotation_from_pok, pok_from_rotation),
        (body_from_ned, rpy_from_body),
        (rotation_from_gimbal, gimbal_from_rotation),
    ):
        R = to(np.array([a, sign * np.pi / 2, c]))
        again = back(R)
        np.testing.assert_allclose(to(again), R, atol=1e-9)
        assert 0.0 in np.abs(again)
