"""Latitude and longitude exchanged, heights in feet: of positions and of control, and right data of every shape."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block import Points, Role
from raybundle.numerics.geodesy import LocalPlace
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.placing.exchanged_axes import control_as_read, misread_axes
from raybundle.placing.georeference import georeference
from raybundle.placing.marks import Given
from tests.workflows.free_flight import PLACE, codes, control, flight, in_degrees, with_gps

__all__ = ["flight"]

FOOT = 0.3048
WGS84 = "EPSG:4979"
FAULTS = {"positions_axes", "positions_unit", "control_unit", "control_mirrored"}
SHAPES = {
    "relief": (100, 80, 30), "flat": (100, 80, 0), "small": (10, 8, 3), "strip": (300, 20, 2), "line": (200, 0, 0),
    "tower": (5, 5, 60), "facade": (60, 0, 25), "large": (2000, 1500, 200),
}  # fmt: skip


def places(rng, shape, n, place=PLACE):
    """Places of a shape in degrees, and as photographs alone have them."""
    xyz = rng.uniform(-0.5, 0.5, (n, 3)) * SHAPES[shape]
    turned = 0.02 * xyz @ rotation_from_angles(rng.uniform(-3, 3, 3)).T
    return turned, LocalPlace(origin=place), xyz


@pytest.mark.parametrize(("wrong", "mend"), [((1, 0, 2), "axes_exchanged"), ((0, 1, 2), "heights_in_feet")])
@pytest.mark.parametrize("shape", ["relief", "small", "large"])
def test_the_mend_is_found(shape, wrong, mend):
    source, place, xyz = places(np.random.default_rng(3), shape, 8)
    given = place.geographic_from_local(xyz)[:, wrong] / [1, 1, FOOT if mend == "heights_in_feet" else 1]
    found = misread_axes(source, given, 0.05, WGS84)
    assert found.mend == mend
    assert found.after < 0.02
    assert found.before > 0.2


def test_an_exchange_over_flat_ground_is_found_by_the_stretch_of_degrees():
    source, place, xyz = places(np.random.default_rng(3), "flat", 8)
    assert misread_axes(source, place.geographic_from_local(xyz)[:, [1, 0, 2]], 0.05, WGS84).mend == "axes_exchanged"


def test_heights_in_feet_over_a_grid_and_in_no_system_are_found():
    rng = np.random.default_rng(3)
    source, _, xyz = places(rng, "relief", 8)
    local = xyz / [1, 1, FOOT]
    assert misread_axes(source, local, 0.05, None).mend == "heights_in_feet"
    assert misread_axes(source, local + np.array([5e5, 5.2e6, 0]), 0.05, "EPSG:25832").mend == "heights_in_feet"


def test_easting_and_northing_exchanged_over_relief_are_found():
    source, _, xyz = places(np.random.default_rng(3), "relief", 8)
    grid = xyz + np.array([4.5e5, 5.5e5, 0])  # either order is a place of the grid
    assert misread_axes(source, grid[:, [1, 0, 2]], 0.05, "EPSG:25832").mend == "axes_exchanged"


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("place", [PLACE, (80.0, 5.0, 10.0), (-70.0, -33.0, 900.0), (25.0, 70.0, 3000.0)], ids=str)
def test_right_positions_never_look_misread(shape, place):
    """Errors in all directions, in one alone, and a gross one; photographs that are bent or scattered."""
    rng = np.random.default_rng(6)
    for noise in ((0.02,) * 3, (1, 1, 5), (5, 5, 10), (0.1, 5, 0.1), (5, 0.1, 0.1)):
        for n in (4, 6, 11, 40):
            for bent in (0.0, 0.05):
                source, at, xyz = places(rng, shape, n, place)
                source = source + bent * np.sum(source**2, axis=1, keepdims=True) * [0, 0, 1]
                given = xyz + rng.normal(0, 1, (n, 3)) * noise
                gross = given + (np.arange(n) == 0)[:, None] * rng.normal(0, 100, 3)
                for tried in (given, gross):
                    degrees = at.geographic_from_local(tried)
                    assert misread_axes(source, degrees, float(np.mean(noise)), WGS84) is None
                    assert misread_axes(source, tried, float(np.mean(noise)), None) is None


def exchanged(photos):
    for p in photos:
        g = p.metadata.gps
        g.latitude_deg, g.longitude_deg = g.longitude_deg, g.latitude_deg
    return photos


def test_exchanged_positions_are_named_and_not_used(flight):
    placed = georeference(flight.free, exchanged(with_gps(flight)), Given())
    (notice,) = [n for n in placed.notices if n.code in FAULTS]
    assert (notice.code, notice.severity) == ("positions_axes", "fault")
    assert notice.values["after_m"] < notice.values["before_m"]
    assert not placed.fixed
    assert not len(placed.block.stations)
    assert not FAULTS & codes(georeference(flight.free, with_gps(flight), Given()))


def raised(flight):
    """The flight with its control on towers, and the same as the photographs have it."""
    rng = np.random.default_rng(4)
    return flight.xyz + np.ptp(flight.xyz[:, 0]) * 0.1 * rng.uniform(0, 1, (6, 1)) * [0, 0, 1]


def test_exchanged_degrees_of_control_are_named_and_take_no_part(flight):
    right = in_degrees(flight, list(range(6)))
    wrong = replace(right, xyz=right.xyz[:, [1, 0, 2]])
    placed = georeference(flight.free, flight.photos, Given(control=(wrong,)))
    (notice,) = [n for n in placed.notices if n.code in FAULTS]
    assert (notice.code, notice.severity) == ("control_mirrored", "fault")
    assert (notice.variant, notice.values["geographic"]) == ("axes", True)
    assert not placed.block.points.is_control.any()
    assert not FAULTS & codes(georeference(flight.free, flight.photos, Given(control=(right,))))


def test_heights_of_control_in_feet_are_named(flight):

    xyz = raised(flight)
    feet = xyz / [1, 1, FOOT]
    file = control(flight, feet)
    points = Points(ids=file.ids, role=np.full(6, Role.CONTROL, np.int32), xyz=feet, sigma=np.full((6, 3), 0.01))
    block, (notice,) = control_as_read(replace(flight.free, points=points), 0.02 * xyz, (file,), None)
    assert (notice.code, notice.severity) == ("control_unit", "fault")
    assert notice.values["after_m"] < notice.values["before_m"]
    assert not block.points.is_control.any()
    right = replace(flight.free, points=replace(points, xyz=xyz))
    assert not control_as_read(right, 0.02 * xyz, (control(flight, xyz),), None)[1]
