"""A kind whose rows hold one, two or three quantities: residuals and partial derivatives of those that take part."""

from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.observations.kind import Rows
from raybundle.observations.residual import ResidualKind


class Coordinates(ResidualKind, registered=False):
    """So many coordinates of a point, times 1, 2, 3."""

    name = "coordinates of a test"

    def residual(self, row, at):
        X = at.point(row.point) * np.array([1.0, 2.0, 3.0])
        return X[:, : len(self.called)] - row.value if self.called else X[:, 0] - row.value[:, 0]


def table_of(point, value):
    return SimpleNamespace(point=point, value=value, rows=lambda items: table_of(point[items], value[items]))


@pytest.mark.parametrize("called", [(), ("X", "Y"), ("X", "Y", "Z")])
def test_each_quantity_has_its_residual_and_its_derivatives(called, monkeypatch):
    monkeypatch.setattr(Coordinates, "called", called)
    rng, width = np.random.default_rng(0), max(len(called), 1)
    xyz, value, point = rng.normal(size=(9, 3)), rng.normal(size=(5, width)), np.array([7, 2, 0, 8, 2])
    used = rng.random((5, width)) < 0.7
    item, component = np.nonzero(used)
    rows = Rows.of(item, component, value[used], np.ones(used.sum()))
    values, scope = SimpleNamespace(xyz=xyz), SimpleNamespace(shift=np.zeros(3))
    found = Coordinates().observed(table_of(point, value), rows, scope, values)
    np.testing.assert_allclose(found.residual, xyz[point[item], component] * (component + 1) - value[used])
    D = np.zeros((len(item), 9, 3))
    for part in found.partials:
        assert part.of == "point"
        np.add.at(D, (part.row, part.item, part.component), part.value)
    expected = np.zeros_like(D)
    expected[np.arange(len(item)), point[item], component] = component + 1
    np.testing.assert_allclose(D, expected)


def test_residuals_of_another_shape_are_refused(monkeypatch):
    monkeypatch.setattr(Coordinates, "called", ("X", "Y"))
    monkeypatch.setattr(Coordinates, "residual", lambda _, row, at: at.point(row.point))
    rows = Rows.of(np.array([0]), np.array([1]), np.zeros(1), np.ones(1))
    with pytest.raises(TypeError, match="residual must return"):
        Coordinates().observed(
            table_of(np.array([1]), np.zeros((1, 2))), rows, SimpleNamespace(shift=np.zeros(3)),
            SimpleNamespace(xyz=np.zeros((2, 3))),
        )  # fmt: skip
