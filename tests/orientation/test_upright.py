"""Up by how photographs were held: the kind, its probability, and a vertical whose standard deviation is true."""

import numpy as np
import pytest

from raybundle.numerics.rotation import rotation_from_vector
from raybundle.orientation.upright import _log_density, habits
from tests.orientation.upright_cases import CASES, UP, one_strip


def found(case, seed):
    """The habits of a case in a frame of any rotation, and the true vertical there."""
    rng = np.random.default_rng(seed)
    right, upward, centre, distance = case(rng)
    turn = rotation_from_vector(rng.normal(size=(1, 3)))[0]
    return habits(right @ turn.T, upward @ turn.T, centre @ turn.T, distance), turn @ UP


@pytest.mark.parametrize("name", CASES)
def test_each_way_to_photograph_is_recognised(name):
    case, kind = CASES[name]
    for seed in range(5):
        h, up = found(case, seed)
        assert kind in {h.kind, None}  # 20 degrees downwards is between two kinds, and up the same in both
        assert not h.ambiguous
        assert np.degrees(np.arccos(np.clip(h.up @ up, -1, 1))) < (6 if name in {"facade", "nadir"} else 2)


def test_the_stated_sigma_of_the_vertical_is_its_scatter():
    """Errors over their standard deviations, for cameras that round an object: about one, and not a third."""
    case, _ = CASES["round_about"]
    ratio = []
    for seed in range(30):
        h, up = found(case, seed)
        ratio.append(np.linalg.norm(np.cross(h.up, up)) / h.sigma / np.sqrt(2))
    assert 0.4 < np.sqrt(np.mean(np.square(ratio))) < 1.3


def test_one_strip_square_to_a_plane_is_ambiguous():
    ambiguous = [found(one_strip, seed)[0].ambiguous for seed in range(10)]
    assert np.mean(ambiguous) > 0.8


def test_photographs_of_one_session_are_no_independent_draws():
    """Ten alike say as much as 10 / (1 + 9 / 10) = 5.3 of different sessions, not as ten."""
    x, y, place = np.array([[1.0, 0, 0]]), np.array([[0, np.sin(1.4), np.cos(1.4)]]), np.zeros((1, 3))
    z = np.array([[0.0, 0.0, 1.0], [0.3, 0.0, np.sqrt(1 - 0.09)]])

    def told(n):
        value = _log_density("aerial", z, np.tile(x, (n, 1)), np.tile(y, (n, 1)), np.tile(place, (n, 1)))
        return value[0] - value[1]

    assert told(10) / told(1) == pytest.approx(10 / 1.9, rel=0.1)


def test_the_turn_of_the_camera_matters():
    """Photographs of a facade whose files state no quarter turn, half of them on their side, stand upright as well."""
    rng = np.random.default_rng(3)
    right, upward, centre, distance = CASES["facade"][0](rng)
    turned = np.arange(len(right)) < 4
    x = np.where(turned[:, None], upward, right)
    y = np.where(turned[:, None], -right, upward)
    h = habits(x, y, centre, distance)
    assert h.kind == "terrestrial"
    assert np.degrees(np.arccos(h.up @ UP)) < 6
