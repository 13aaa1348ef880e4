"""What an open datum is called: by the motions of the object that leave everything observed as it is."""

import numpy as np
import pytest

from raybundle.adjustment.system.datum import ABOUT_LINE, NAMES, open_names, point_generators
from raybundle.numerics.rotation import rotation_from_vector

X = np.random.default_rng(4).normal(size=(6, 3)) * 30


def basis_of(*generators):
    return np.linalg.qr(np.array(generators, float).T)[0]


def test_generators_are_what_a_small_motion_does_to_points():
    centre, extent, step = np.array([5.0, -2.0, 7.0]), 12.0, 1e-5
    G = point_generators(X, centre, extent)
    for k in range(7):
        turn = np.eye(3)[k - 3] * step if 3 <= k < 6 else np.zeros(3)
        scale = 1 + step * (k == 6)
        shift = np.eye(3)[k] * step * extent if k < 3 else np.zeros(3)
        moved = centre + scale * (X - centre) @ rotation_from_vector(turn[None])[0].T + shift
        sign = np.sign(np.sum((moved - X) * G[:, :, k]))  # the sense of a rotation is free
        np.testing.assert_allclose(sign * G[:, :, k], (moved - X) / step, atol=1e-2)


AXIS, THROUGH = np.array([0.6, 0.64, 0.48]), np.array([0.3, -0.5, 0.1])
LINE = np.concatenate([np.cross(THROUGH, AXIS), AXIS, [0.0]])
"""A rotation about the line through a point shifts the middle at right angles to the axis."""


@pytest.mark.parametrize("pure", [(), (0,), (6,), (2, 6), (0, 1, 2, 6)])
def test_pure_generators_are_named(pure):
    assert open_names(np.eye(7)[:, list(pure)]) == tuple(NAMES[k] for k in pure)


def test_a_rotation_about_a_line_is_named_also_beside_an_open_scale():
    assert open_names(basis_of(LINE)) == (ABOUT_LINE,)
    assert open_names(basis_of(LINE, np.eye(7)[6])) == (NAMES[6], ABOUT_LINE)


@pytest.mark.parametrize("along", [[*0.3 * AXIS, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.2]])
def test_a_rotation_that_shifts_along_its_axis_or_scales_is_a_combination(along):
    motion = np.concatenate([np.zeros(3), AXIS, [0.0]]) + along
    (name,) = open_names(basis_of(motion))
    assert name.startswith("1 combination of ")
    assert {n for n in NAMES if n in name} == {n for n, v in zip(NAMES, motion, strict=True) if v}


def test_several_mixtures_are_counted():
    rng = np.random.default_rng(0)
    (name,) = open_names(basis_of(*rng.normal(size=(2, 7))))
    assert name.startswith("2 combinations of ")
    assert all(n in name for n in NAMES)
