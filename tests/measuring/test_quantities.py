"""Quantities of points: derivatives against differences, forms against points that are exactly of them."""

import numpy as np
import pytest

from raybundle.commands.marks_settings import QuerySettings
from raybundle.errors import InputError
from raybundle.measuring.quantities import QUANTITIES, expected_extent
from raybundle.settings import settings_of

STEP = 1e-6


def points_for(quantity, seed=0):
    """Points on which a quantity is well defined, far from the origin."""
    rng = np.random.default_rng(seed)
    q = QUANTITIES[quantity]
    n = max(q.least, min(q.most, 7))
    size = [5, 0.1, 0.1] if "line" in quantity else [5, 3, 0.1]
    xyz = rng.normal(size=(n, 3)) * size
    if quantity.startswith("to_"):
        xyz[0] += [0.3, 0.4, 2.0]
    return xyz + np.array([1000, -200, 50])


@pytest.mark.parametrize("quantity", QUANTITIES)
def test_derivatives_are_those_of_the_values(quantity):
    q, xyz = QUANTITIES[quantity], points_for(quantity)
    found = q.of(xyz)
    n = len(xyz)
    assert found.by_points.shape == (len(found.values), 3 * n)
    assert len(q.names([str(k) for k in range(n)])) == len(found.values)
    for k in range(3 * n):
        step = np.zeros(3 * n)
        step[k] = STEP
        moved = step.reshape(n, 3)
        difference = (q.of(xyz + moved).values - q.of(xyz - moved).values) / (2 * STEP)
        np.testing.assert_allclose(found.by_points[:, k], difference, rtol=0, atol=1e-5)


def test_every_quantity_is_a_setting():
    assert {s.name for s in settings_of(QuerySettings)} == set(QUANTITIES)


@pytest.mark.parametrize(("quantity", "flat"), [("plane", [1, 1, 0]), ("line", [1, 0, 0])])
def test_the_extent_of_a_perfect_form_is_that_of_its_errors(quantity, flat):
    rng = np.random.default_rng(3)
    exact = rng.normal(size=(8, 3)) * 4 * flat
    A = rng.normal(size=(24, 24)) * 1e-3
    C = A @ A.T
    drawn = rng.multivariate_normal(np.zeros(24), C, size=2000).reshape(-1, 8, 3)
    question = QUANTITIES[quantity]
    seen = np.mean([question.of(exact + e).values[0] for e in drawn])
    told = expected_extent(question.of(exact + 1e-9 * rng.normal(size=exact.shape)), C)
    assert told == pytest.approx(seen, rel=0.05)
    assert expected_extent(question.of(exact + 1e-9 * rng.normal(size=exact.shape)), 1.21 * C) > 1.05 * seen


def test_what_is_no_form_is_refused():
    row = np.arange(5.0)[:, None] * [1, 2, 3] + [1e6, 2e6, 0]
    with pytest.raises(InputError, match=r"quantity\.in_line"):
        QUANTITIES["plane"].of(row)
    with pytest.raises(InputError, match=r"quantity\.in_line"):
        QUANTITIES["to_plane"].of(row)
    with pytest.raises(InputError, match=r"quantity\.coincide"):
        QUANTITIES["line"].of(np.ones((4, 3)))
    with pytest.raises(InputError, match=r"quantity\.coincide"):
        QUANTITIES["length"].of(np.ones((2, 3)))


def test_deviations_of_a_floor_are_positive_upwards():
    floor = np.array([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0], [2, 2, 0.1]])
    found = QUANTITIES["plane"].of(floor)
    assert found.values[0] == pytest.approx(0.1)
    assert found.values[5] == pytest.approx(0.08)
    assert found.values[1:5] == pytest.approx([-0.02] * 4)
