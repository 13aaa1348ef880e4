"""Onto positions of the photographs: flights with shifts of their own, lever arms, what is too near."""

from dataclasses import replace

import numpy as np
import pytest
from pyproj import Transformer

from raybundle.block.select import with_rows
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.numerics.geodesy import LocalPlace
from raybundle.placing.georeference import georeference
from raybundle.placing.marks import Given
from raybundle.workflows.orienting.connected_components import place_components
from tests.workflows.free_flight import PLACE, adjusted, codes, flight, in_degrees, with_gps

__all__ = ["flight"]


def test_gps_places_the_block(flight):
    placed = georeference(flight.free, with_gps(flight), Given())
    assert placed.frame is not None
    assert "gps" in codes(placed)
    assert [i.estimate for i in placed.block.instruments] == [()]  # its shift is free once control is marked
    base = np.linalg.norm(placed.block.images.centre[0] - placed.block.images.centre[-1])
    true = np.linalg.norm(flight.truth.images.centre[0] - flight.truth.images.centre[-1])
    assert base == pytest.approx(true, rel=1e-3)


def test_one_control_point_suffices_beside_positions_and_finds_their_shift(flight):
    shift = np.array([0.8, -0.5, 1.7])
    photos = with_gps(flight, shift=shift)
    placed = georeference(flight.free, photos, Given(control=(in_degrees(flight, [0]),)))
    assert placed.block.instruments[-1].estimate == ("sx", "sy", "sz")
    result = adjusted(placed)
    antenna = next(r for r in result.interior if r.camera == "gnss")
    for s, true in zip(("sx", "sy", "sz"), shift, strict=True):
        p = antenna.parameters[s]
        assert abs(p.value - true) < 4 * p.std
        assert p.std < 0.2
    local = placed.frame.local_from_wgs84(LocalPlace(origin=PLACE).geographic_from_local(flight.truth.images.centre))
    apart = result.adjusted.images.centre - local
    assert np.all(np.abs(apart) < 5 * result.precision.image_std[:, :3])


def test_every_flight_has_its_shift(flight):
    photos = with_gps(flight, shift=(0.3, 0.2, 0.5), pause=10)
    placed = georeference(flight.free, photos, Given(control=(in_degrees(flight, [0, 1, 2, 3]),)))
    result = adjusted(placed)
    found = {r.camera: r.parameters["sz"] for r in result.interior if r.camera.startswith("gnss")}
    assert set(found) == {"gnss-1", "gnss-2"}
    for name, true in (("gnss-1", 0.5), ("gnss-2", -0.5)):
        assert abs(found[name].value - true) < 4 * found[name].std
    without = georeference(flight.free, photos, Given(control=(in_degrees(flight, [0, 1, 2, 3]),), shift=False))
    assert without.block.stations.antenna is None


def part_of(block, mine):
    """The block with these images (n,) oriented alone."""
    images = replace(
        block.images,
        centre=np.where(mine[:, None], block.images.centre, np.nan),
        rotation=np.where(mine[:, None, None], block.images.rotation, np.nan),
    )
    o = block.observations
    rays = np.bincount(o.point[mine[o.image]], minlength=len(block.points))
    thin = with_rows(block, mine[o.image] & (rays > 1)[o.point])
    return replace(thin, images=images)


def test_parts_of_two_flights_keep_their_antennas(flight):
    photos = with_gps(flight, shift=(0.3, 0.2, 0.5), pause=10)
    first = np.arange(len(photos)) < 10
    blocks = (part_of(flight.free, first), part_of(flight.free, ~first))
    given = Given(control=(in_degrees(flight, [0, 1, 2, 3, 4, 5]),))
    whole, apart = place_components(blocks, photos, given)
    assert not apart
    stations = whole.block.stations
    names = [whole.block.instruments[a].id for a in stations.antenna.tolist()]
    assert names == ["gnss-1" if first[i] else "gnss-2" for i in stations.image.tolist()]
    alone, _ = place_components(blocks[:1], photos, given)
    assert [i.id for i in alone.block.instruments] == ["gnss-1"]


def test_a_lever_arm_is_held_or_observed(flight):
    given = Given(lever_arm=((0.1, -0.05, 0.3), 0.0))
    (held,) = georeference(flight.free, with_gps(flight), given).block.instruments
    assert held.estimate == ()
    assert held.values["az"] == 0.3
    given = replace(given, lever_arm=((0.1, -0.05, 0.3), 0.02))
    (observed,) = georeference(flight.free, with_gps(flight), given).block.instruments
    assert observed.sigma == {"ax": 0.02, "ay": 0.02, "az": 0.02}


def test_positions_too_near_each_other_are_not_used(flight):
    extent = np.ptp(flight.truth.images.centre, axis=0).max()
    placed = georeference(flight.free, with_gps(flight, noise=float(extent)), Given())
    assert "gps_too_near" in codes(placed)
    assert placed.frame is None
    assert len(placed.block.stations) == 0


def test_the_place_is_stated_with_its_hemisphere(flight):
    photos = with_gps(flight)
    (notice,) = [n for n in georeference(flight.free, photos, Given()).notices if n.code == "place"]
    assert (notice.severity, notice.values["of"]) == ("note", "positions")
    assert "50.0038° N, 8.0111° E (WGS 84)" in notice.text
    for p in photos:
        p.metadata.gps.latitude_deg *= -1
        p.metadata.gps.longitude_deg *= -1
    (notice,) = [n for n in georeference(flight.free, photos, Given()).notices if n.code == "place"]
    assert notice.values["latitude"] < 0
    assert "S, 8.0111° W" in notice.text
    given = Given(control=(in_degrees(flight, [0, 1, 2, 3]),))
    (notice,) = [n for n in georeference(flight.free, flight.photos, given).notices if n.code == "place"]
    assert notice.values["of"] == "control"
    assert notice.values["latitude"] == pytest.approx(50.0, abs=0.01)
    assert "place" not in codes(georeference(flight.free, flight.photos, Given()))


def test_positions_without_standard_deviations_name_those_that_are_assumed(flight):
    photos = with_gps(flight)
    assert "positions_assumed" not in codes(georeference(flight.free, photos, Given()))
    for p in photos[:3]:
        p.metadata.gps.sigma_m = None
    (notice,) = [n for n in georeference(flight.free, photos, Given()).notices if n.code == "positions_assumed"]
    assert notice.severity == "note"
    assert notice.values == {"n": 3, "plan_m": 5.0, "height_m": 10.0}


def test_positions_in_a_grid_keep_it(flight):
    photos = with_gps(flight)
    geographic = georeference(flight.free, photos, Given())
    lon, lat, h = geographic.frame.wgs84_from_local(np.zeros((1, 3)))[0]
    centre = local_frame("EPSG:4979", (lon, lat, h))
    x, y = Transformer.from_crs("EPSG:4979", "EPSG:32632", always_xy=True).transform(lon, lat)
    grid = local_frame("EPSG:32632+ellipsoid", (x, y, h))
    placed = georeference(flight.free, photos, Given(positions_frame=grid))
    assert placed.frame is grid
    by_grid = placed.frame.crs_from_local(placed.block.images.centre)
    by_hand = Transformer.from_crs("EPSG:4979", "EPSG:32632", always_xy=True).transform(
        *centre.wgs84_from_local(geographic.block.images.centre).T[:2]
    )
    np.testing.assert_allclose(by_grid[:, :2], np.transpose(by_hand), atol=2e-3)
    control = in_degrees(flight, [0, 1, 2, 3])
    assert georeference(flight.free, photos, Given(control=(control,), positions_frame=grid)).frame.crs == control.crs
