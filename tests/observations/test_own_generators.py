"""How unknowns of a kind follow a small motion of the object: a complex step through `own_placed`."""

import numpy as np
import pytest

from raybundle.observations.residual import ResidualKind


class Spot(ResidualKind, registered=False):
    """Points of the kind's own."""

    name = "spot"
    own_width = 3

    def residual(self, row, at):
        raise NotImplementedError

    def own_placed(self, values, scale, R, shift):
        return np.column_stack((scale * values @ R.T + shift).T)


class RealSpot(Spot, registered=False):
    """A kind that loses what is not real."""

    def own_placed(self, values, scale, R, shift):
        return np.real(super().own_placed(values, scale, R, shift))


def test_generators_are_those_of_points():
    """Shift, rotation about the centre, and scale from there."""
    rng = np.random.default_rng(8)
    X, centre = rng.normal(size=(5, 3)), rng.normal(size=3)
    found = Spot().own_generators(X, centre)
    assert found.shape == (5, 3, 7)
    for k, axis in enumerate(np.eye(3)):
        np.testing.assert_allclose(found[:, :, k], np.broadcast_to(axis, X.shape), atol=1e-15)
        np.testing.assert_allclose(found[:, :, 3 + k], np.cross(axis, X - centre), atol=1e-14)
    np.testing.assert_allclose(found[:, :, 6], X - centre, atol=1e-14)


def test_a_kind_that_loses_the_step_is_refused():
    with pytest.raises(TypeError, match="complex"):
        RealSpot().own_generators(np.zeros((1, 3)), np.zeros(3))
