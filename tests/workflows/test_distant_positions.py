"""A list of positions held against the positions that the photographs themselves record."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raybundle.io.photos.metadata import Gps, Metadata
from raybundle.io.photos.photo import Photo
from raybundle.io.trajectories import Trajectory, read_trajectory
from raybundle.numerics.geodesy import LocalPlace
from raybundle.pipeline.stage import Means
from raybundle.placing.distant_positions import distant_positions
from raybundle.workflows.orienting.stages.photographs import Inputs, search

WGS84 = "EPSG:4979"
PLACES = {
    "Europe": (8.0, 47.0, 500.0), "equator": (9.7, 0.5, 20.0), "south": (-70.0, -33.0, 600.0),
    "near": (9.9, 10.4, 300.0),
}  # fmt: skip


def flown(place, n=6, missing=0):
    """Photographs along a line whose receivers are off by metres, and the list of their true positions."""
    rng = np.random.default_rng(n)
    xyz = rng.uniform(-100, 100, (n, 3)) * [1, 1, 0.1]
    frame = LocalPlace(origin=place)
    true, single = frame.geographic_from_local(xyz), frame.geographic_from_local(xyz + rng.normal(0, 5, (n, 3)))
    photos = [
        Photo(
            name=f"p{k}.jpg", path=Path(f"p{k}.jpg"), width_px=1, height_px=1, sha256="",
            metadata=Metadata(
                gps=None if k < missing else Gps(longitude_deg=single[k, 0], latitude_deg=single[k, 1])
            ),
        )
        for k in range(n)
    ]  # fmt: skip
    positions = Trajectory(
        path=Path("geo.txt"), names=tuple(p.name for p in photos), xyz=true, sigma=np.full((n, 3), np.nan), crs=WGS84
    )
    return photos, positions


def swapped(positions):
    return replace(positions, xyz=positions.xyz[:, [1, 0, 2]])


@pytest.mark.parametrize("place", PLACES)
def test_a_list_with_exchanged_columns_is_a_fault_that_names_them(place):
    photos, positions = flown(PLACES[place])
    notice, exchanged = distant_positions(photos, swapped(positions), None)
    assert exchanged
    assert (notice.code, notice.severity) == ("positions_axes", "fault")
    assert notice.values["geographic"] is True
    assert notice.values["exchanged"] < 30
    assert notice.values["distance"] > 35_000


def test_easting_and_northing_of_a_grid_are_exchanged():
    from raybundle.io.geo.coordinate_systems import local_frame

    photos, positions = flown((9.2, 6.0, 100.0))
    frame = local_frame("EPSG:32632", (520_000.0, 663_000.0, 0.0))
    grid = replace(positions, xyz=frame.crs_from_local(frame.local_from_wgs84(positions.xyz)), crs="EPSG:32632")
    assert distant_positions(photos, grid, None) == (None, False)
    notice, exchanged = distant_positions(photos, swapped(grid), None)
    assert exchanged
    assert notice.values["geographic"] is False


@pytest.mark.parametrize("moved", [(5.0, 0.0), (0.0, -2.0), (0.5, 0.0)])
def test_a_list_of_another_place_is_a_fault_without_a_mend(moved):
    photos, positions = flown(PLACES["Europe"])
    elsewhere = replace(positions, xyz=positions.xyz + np.array((*moved, 0)))
    notice, exchanged = distant_positions(photos, elsewhere, None)
    assert not exchanged
    assert (notice.code, notice.severity) == ("positions_distant", "fault")


@pytest.mark.parametrize("place", PLACES)
def test_right_lists_have_no_fault(place):
    photos, positions = flown(PLACES[place])
    assert distant_positions(photos, positions, None) == (None, False)
    datum = replace(positions, xyz=positions.xyz + np.array((0.01, 0.005, 40)))  # a shift of a kilometre
    assert distant_positions(photos, datum, None) == (None, False)


def test_single_photographs_that_record_another_place_accuse_no_list():
    photos, positions = flown(PLACES["Europe"], n=7)
    off = replace(photos[0].metadata, gps=Gps(longitude_deg=116.4, latitude_deg=39.9))
    photos[:3] = [replace(p, metadata=off) for p in photos[:3]]
    assert distant_positions(photos, positions, None) == (None, False)
    photos, positions = flown(PLACES["Europe"], missing=4)
    assert distant_positions(photos, swapped(positions), None) == (None, False)


@pytest.mark.parametrize("wrong", [False, True])
def test_photographs_keep_their_own_positions_beside_an_exchanged_list(tmp_path, wrong):
    folder = tmp_path / "photos"
    folder.mkdir()
    lines = ["EPSG:4326"]
    for k in range(4):
        exif = Image.Exif()
        exif.get_ifd(0x8825).update({1: "N", 2: (47.0, 30.0, float(k)), 3: "E", 4: (8.0, 15.0, float(k))})
        Image.fromarray(np.full((60, 80), 20 * k + 9, np.uint8)).save(folder / f"p{k}.jpg", exif=exif)
        place = [8.25 + (k + 0.001) / 3600, 47.5 + k / 3600]
        lines.append(" ".join([f"p{k}.jpg", *(f"{v:.8f}" for v in (place[::-1] if wrong else place)), "450"]))
    (tmp_path / "geo.txt").write_text("\n".join(lines) + "\n")
    given = Inputs(paths=(folder,), control=(), positions=read_trajectory(tmp_path / "geo.txt"), crs=None)
    found = search(given, Means(project=None))
    assert [n.code for n in found.notices] == (["positions_axes"] if wrong else [])
    for p in found.found.photos:
        g = p.metadata.gps
        assert (g.latitude_deg, g.longitude_deg) == pytest.approx((47.5, 8.25), abs=0.01)
        assert (g.altitude_m is None) == wrong
