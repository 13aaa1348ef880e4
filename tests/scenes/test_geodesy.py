"""Geographic, geocentric and local coordinates: known points, round trips, derivatives."""

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.numerics.geodesy import (
    WGS84,
    Ellipsoid,
    LocalPlace,
    geocentric_from_geographic,
    geographic_from_geocentric,
    geographic_partials,
)


def points(n=2000, high=1e6):
    rng = np.random.default_rng(1)
    return np.stack([rng.uniform(-180, 180, n), rng.uniform(-90, 90, n), rng.uniform(-1e4, high, n)], axis=1)


def test_points_that_need_no_formula():
    geographic = np.array([[0.0, 0, 0], [90, 0, 100], [0, 90, 0], [0, -90, 10]])
    expected = [[WGS84.a, 0, 0], [0, WGS84.a + 100, 0], [0, 0, WGS84.b], [0, 0, -WGS84.b - 10]]
    assert np.abs(geocentric_from_geographic(geographic) - expected).max() < 2e-9


def test_agrees_with_pyproj():
    from pyproj import Transformer

    geographic = points(200)
    expected = Transformer.from_crs("EPSG:4979", "EPSG:4978", always_xy=True).transform(*geographic.T)
    assert np.abs(geocentric_from_geographic(geographic) - np.stack(expected, axis=1)).max() < 1e-8


@pytest.mark.parametrize("ellipsoid", [WGS84, Ellipsoid(1e6, 1e6), Ellipsoid(3396190.0, 3376200.0)])
def test_there_and_back_to_1e_9_degrees(ellipsoid):
    geographic = points()
    back = geographic_from_geocentric(geocentric_from_geographic(geographic, ellipsoid), ellipsoid)
    assert np.abs(back - geographic)[:, :2].max() < 1e-9
    assert np.abs(back - geographic)[:, 2].max() < 1e-7


def test_local_frame_there_and_back():
    place = LocalPlace(origin=(7.0, 50.7, 100.0))
    geographic = np.array([7.0, 50.7, 100.0]) + np.random.default_rng(2).uniform(-0.2, 0.2, (500, 3)) * [1, 1, 5000]
    local = place.local_from_geographic(geographic)
    assert np.abs(place.geographic_from_local(local) - geographic)[:, :2].max() < 1e-9
    assert place.local_from_geographic(np.array([[7.0, 50.7, 107.0]]))[0] == pytest.approx([0, 0, 7], abs=1e-8)
    north = place.local_from_geographic(np.array([[7.0, 50.701, 100.0]]))[0]
    assert abs(north[0]) < 1e-6
    assert 111 < north[1] < 112


def test_derivatives():
    geographic = points(50, 3000.0)
    geographic[:, 1] *= 0.9
    xyz = geocentric_from_geographic(geographic)
    J = geographic_partials(geographic)
    for axis in range(3):
        step = np.zeros(3)
        step[axis] = 10.0
        numeric = (geographic_from_geocentric(xyz + step) - geographic_from_geocentric(xyz - step)) / 20
        assert (np.abs(numeric - J[:, :, axis]) < 1e-7 * np.abs(J).max(axis=(0, 2))).all()
    place = LocalPlace(origin=(7.0, 50.7, 100.0))
    local = place.local_from_geographic(geographic)
    up = np.array([0, 0, 10.0])
    numeric = (place.geographic_from_local(local + up) - place.geographic_from_local(local - up)) / 20
    assert (np.abs(numeric - place.geographic_partials(geographic)[:, :, 2]) < 1e-7 * np.abs(J).max(axis=(0, 2))).all()


@pytest.mark.parametrize("axes", [(0.0, 0.0), (1.0, 2.0), (float("nan"), 1.0)])
def test_no_body(axes):
    with pytest.raises(InputError, match=r"ellipsoid\.semi_axes"):
        Ellipsoid(*axes)
