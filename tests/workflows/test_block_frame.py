"""A block whose [frame] names a coordinate system is adjusted, converted and drawn in it."""

import csv
import json
from dataclasses import replace

import numpy as np
import pytest

from raybundle.block import Role
from raybundle.cli.adjust import command as adjust_command
from raybundle.cli.convert import command as convert_command
from raybundle.cli.sheet import command as sheet_command
from raybundle.commands.plane_settings import plane_in
from raybundle.commands.rectify import RectifySettings
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.block.scenes import local_in, projected
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.workflows.block_frame import in_block_frame
from raybundle.workflows.object_plane import MapLevel
from raybundle.workflows.sources import read_source

SYSTEMS = {
    "metres": ("EPSG:25832", (565_000.0, 5_933_000.0, 31.5)),
    "feet": ("EPSG:2263", (985_000.0, 195_000.0, 100.0)),
}


def run(command, *words):
    command.main([str(w) for w in words], standalone_mode=False)


@pytest.fixture(scope="module")
def observed():
    survey = Survey(control=6, check=2, control_sigma=(0.02, 0.02, 0.03))
    return simulate(aerial_scene(AerialStrips(images_per_strip=4, points_per_image=30)), survey).observed


def in_the_map(block, frame):
    """Coordinates, orientations and standard deviations as a surveyor gives them: in the map and its units."""
    images, points = block.images, block.points
    centre = frame.crs_from_local(images.centre)
    turn = frame.crs_from_local_rotation(centre)
    plan, height = frame.units_m
    return replace(
        block,
        images=replace(images, centre=centre, rotation=images.rotation @ np.swapaxes(turn, -1, -2)),
        points=replace(
            points, xyz=frame.crs_from_local(points.xyz), sigma=points.sigma / [plan, plan, height]
        ),
        place=projected(frame.crs, frame.origin),
    )  # fmt: skip


@pytest.fixture(scope="module", params=SYSTEMS)
def folders(request, observed, tmp_path_factory):
    """The frame; the block about the origin, and the same in the map, as block folders and as results."""
    frame = local_frame(*SYSTEMS[request.param])
    at = tmp_path_factory.mktemp("frame")
    write_block(replace(observed, place=local_in(frame.crs, frame.origin)), at / "local")
    write_block(in_the_map(observed, frame), at / "map")
    for name in ("local", "map"):
        run(adjust_command, at / name, "--out", at / f"{name}-r")
    return frame, at


def map_table(folder):
    with (folder / "map.csv").open(newline="", encoding="utf-8") as file:
        return {(r["kind"], r["id"]): [float(r[c] or "nan") for c in ("X", "Y", "Z", "sX", "sY", "sZ")]
                for r in csv.DictReader(file)}  # fmt: skip


def test_adjusted_coordinates_stand_in_the_map(folders):
    frame, at = folders
    tables = [map_table(at / f"{name}-r") for name in ("local", "map")]
    assert tables[0].keys() == tables[1].keys()
    a, b = (np.array(list(t.values())) for t in tables)
    known = np.isfinite(a)
    assert np.abs(a - b)[known].max() < 2e-4  # deviations of control lose their turn in the file
    given = in_the_map(read_block(at / "local"), frame).points
    control = np.flatnonzero(np.asarray(given.role) == Role.CONTROL)
    for k in control:
        own = np.array(tables[0][("control", given.ids[k])][:3])
        assert np.abs((own - given.xyz[k]) * frame.units_m[0]).max() < 0.1  # 20 and 30 mm


def test_the_report_and_the_result_name_the_system(folders):
    frame, at = folders
    for name in ("local", "map"):
        told = json.loads((at / f"{name}-r" / "result.json").read_text(encoding="utf-8"))
        assert told["frame"]["crs"] == frame.crs
        assert told["frame"]["origin"] == list(frame.origin)
        assert frame.crs in (at / f"{name}-r" / "report.html").read_text(encoding="utf-8")
        again = read_block(at / f"{name}-r" / "block")
        assert again.place.crs == frame.crs


@pytest.mark.parametrize("suffix", ["", "-r"])
@pytest.mark.parametrize("name", ["local", "map"])
def test_it_is_converted_to_maps(name, suffix, folders, tmp_path):
    pytest.importorskip("pyogrio")
    pytest.importorskip("ezdxf")
    pytest.importorskip("laspy")
    frame, at = folders
    run(convert_command, at / f"{name}{suffix}", "--to", "gpkg,dxf,las,geojson,kml", "--out", tmp_path / "out")
    import pyogrio

    info = pyogrio.read_info(tmp_path / "out.gpkg", layer="points")
    assert info["crs"] == frame.crs
    east = info["total_bounds"][0] if info["total_bounds"] else pyogrio.read_bounds(tmp_path / "out.gpkg")[1].min()
    assert abs(east - frame.origin[0]) < 1e4
    told = json.loads((tmp_path / "out.geojson").read_text(encoding="utf-8"))
    longitude, latitude = told["features"][0]["geometry"]["coordinates"][:2]
    home = frame.wgs84_from_local(np.zeros((1, 3)))[0]
    assert abs(longitude - home[0]) < 0.1
    assert abs(latitude - home[1]) < 0.1


@pytest.mark.parametrize("name", ["local", "local-r", "map", "map-r"])
def test_level_ground_lies_in_the_map(name, folders, tmp_path):
    frame, at = folders
    export, _ = read_source(at / name)
    plane, _ = plane_in(at / name, export, RectifySettings(source=at / name, out=tmp_path / "x.tif", horizontal=True))
    assert isinstance(plane, MapLevel)
    assert plane.frame.crs == frame.crs
    run(sheet_command, at / name, "--out", tmp_path / "sheet.pdf", "--horizontal", "--scale", "2000", "--paper", "A0")
    assert (tmp_path / "sheet.pdf").stat().st_size > 0


def test_a_block_keeps_its_frame_through_its_folder(observed, tmp_path):
    place = local_in("EPSG:25832", (565_000.0, 5_933_000.0, 31.5), 40.0)
    write_block(replace(observed, place=place), tmp_path / "block")
    assert read_block(tmp_path / "block").place == place


def test_coordinates_from_the_origin_are_no_map_coordinates(observed, tmp_path):
    place = projected("EPSG:25832", (565_000.0, 5_933_000.0, 31.5))
    write_block(replace(observed, place=place), tmp_path / "block")
    with pytest.raises(InputError, match=r"object_frame\.far_from_origin"):
        in_block_frame(read_block(tmp_path / "block"))


def test_other_blocks_stay_as_they_are(observed):
    assert in_block_frame(observed) == (observed, None, ())
