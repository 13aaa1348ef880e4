"""Rolls about the viewing axes are those against the other images, whatever the object looks like."""

import numpy as np
import pytest

from raybundle.adjustment.statistics.network import rolls_of


def image(view, up, roll_deg=0.0):
    """sensor_from_object of an image that looks along `view`, its upper side towards `up`, then rolled."""
    z = -np.asarray(view, float) / np.linalg.norm(view)
    x = np.cross(up, z)
    x /= np.linalg.norm(x)
    y = np.cross(z, x)
    r = np.radians(roll_deg)
    return np.stack([np.cos(r) * x + np.sin(r) * y, np.cos(r) * y - np.sin(r) * x, z])


def facade(rolls, seed=0):
    """A camera in the hand that walks along a facade: up to 25 degrees aside, tilted and rolled by some degrees."""
    rng = np.random.default_rng(seed)
    aside, tilt = np.radians(rng.uniform(-25, 25, len(rolls))), np.radians(rng.normal(0, 3, len(rolls)))
    views = np.stack([np.sin(aside), np.cos(aside), tilt], axis=1)
    return np.array([image(v, (0, 0, 1), r + rng.normal(0, 2)) for v, r in zip(views, rolls, strict=True)])


def ring(below_deg, rolls):
    """Round an object, the views inclined by this."""
    turn, below = 2 * np.pi * np.arange(len(rolls)) / len(rolls), np.radians(below_deg)
    views = np.stack([-np.cos(turn), -np.sin(turn), np.full(len(turn), -np.tan(below))], axis=1)
    return np.array([image(v, (0, 0, 1), r) for v, r in zip(views, rolls, strict=True)])


def apart_deg(found, expected):
    """Largest difference of angles [deg], in either sense of rotation."""
    return min(np.degrees(np.abs(np.angle(np.exp(1j * (s * found - np.radians(expected)))))).max() for s in (1, -1))


@pytest.mark.parametrize("seed", range(5))
def test_upright_photographs_of_a_facade_have_no_roll(seed):
    assert apart_deg(rolls_of(facade(np.zeros(14), seed)), np.zeros(14)) < 15


@pytest.mark.parametrize("seed", range(5))
def test_rolled_photographs_of_a_facade_are_near_a_quarter(seed):
    rolls = np.where(np.arange(14) % 4 == 3, 90, 0)
    assert apart_deg(rolls_of(facade(rolls, seed)), rolls) < 15


@pytest.mark.parametrize("below", [0, 30, 60, 80])
def test_a_ring_is_upright_about_its_axis(below):
    assert apart_deg(rolls_of(ring(below, np.zeros(24))), np.zeros(24)) < 1e-6
    rolls = np.where(np.arange(24) % 5 == 0, 90, 0)
    assert apart_deg(rolls_of(ring(below, rolls)), rolls) < 1e-3


@pytest.mark.parametrize("seed", range(5))
def test_strips_flown_both_ways_are_half_a_turn_apart(seed):
    rng = np.random.default_rng(seed)
    back = np.arange(20) >= 9
    tilt = rng.normal(0, 0.03, (20, 2))
    R = np.array([image((*t, -1), (np.cos(0.3), np.sin(0.3), 0), 180 * b) for t, b in zip(tilt, back, strict=True)])
    assert apart_deg(rolls_of(R), 180 * ~back) < 10 or apart_deg(rolls_of(R), 180 * back) < 10


def test_the_object_frame_does_not_matter():
    R = facade(np.where(np.arange(14) % 4 == 3, 90, 0))
    turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)
    assert apart_deg(rolls_of(R @ turn), np.degrees(rolls_of(R))) < 1e-3


def test_a_single_image_has_no_roll():
    assert abs(rolls_of(image((0, 1, 0), (0, 0, 1))[None])[0]) < 1e-9
