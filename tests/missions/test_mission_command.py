"""`raybundle plan mission`: areas from files of all kinds, cameras from what a user has, what is told of bad input."""

import json
import shutil
import zipfile
from pathlib import Path

import numpy as np
import pytest
from tests.cli.reported import reported, texts_of, values_of
from tests.conftest import DATA
from tests.missions.test_terrain import SRTM

import raybundle as rb
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.missions import mission_formats
from raybundle.io.missions.areas import in_crs, plane_crs, read_shapes
from raybundle.io.missions.cameras import mission_camera, vehicle_of
from raybundle.io.missions.mission_file import read_mission
from raybundle.missions.mission import exposures
from raybundle.missions.vehicle import KNOWN

UAV = DATA / "photos/copr-uav/images"
needs_uav = pytest.mark.skipif(not UAV.is_dir(), reason=f"{UAV} is absent")

FIELD = [[7.10, 50.10], [7.104, 50.1005], [7.1038, 50.103], [7.0995, 50.1022]]
LINE = [[7.10, 50.10], [7.102, 50.1005], [7.1025, 50.102]]


def geojson(path, kind, coordinates, **more):
    feature = {"type": "Feature", "properties": {}, "geometry": {"type": kind, "coordinates": coordinates}}
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [feature], **more}))
    return path


@pytest.fixture
def field(tmp_path):
    return geojson(tmp_path / "field.geojson", "Polygon", [[*FIELD, FIELD[0]]])


def run(capsys, *words):
    status = main(["plan", "mission", *map(str, words)])
    got = capsys.readouterr()
    return status, got.out, got.err


def test_a_field_from_end_to_end(field, tmp_path, capsys):
    out = tmp_path / "plan"
    every = ",".join(mission_formats)
    words = (field, "--vehicle", "mavic-3e", "--gsd", 0.02, "--to", every, "--out", out)
    found = values_of(reported(capsys, "plan", "mission", *words))
    ground = {"pixel": "20", "asked": "20", "above": "75.0", "along": "80 %", "across": "70 %"}
    assert found["flight.ground"] == ground
    assert found["flight.batteries"]["n"] == 1
    assert sorted(p.name for p in out.iterdir()) == [
        "mission.csv", "mission.kml", "mission.kmz", "mission.plan", "mission.svg", "mission.toml", "mission.waypoints",
    ]  # fmt: skip
    m = read_mission(out)
    assert m.crs == "EPSG:32632"
    assert m.settings["vehicle"] == "mavic-3e"
    for entry in mission_formats.values():
        route = entry.read(out / f"mission{entry.suffix}")
        xy = in_crs(np.stack([route.longitude_deg, route.latitude_deg], axis=1), "EPSG:4326", m.crs)
        np.testing.assert_allclose(xy, m.way_points.xyz[:, :2], atol=1e-4)
    assert (out / "mission.svg").read_text().count("<circle") == len(exposures(m))
    status, _, err = run(capsys, field, "--vehicle", "mavic-3e", "--out", out)
    assert status == 2
    assert "[folder.exists]" in err


@pytest.mark.parametrize(
    ("gsd", "unit"), [(1, "centimetres"), (2, "centimetres"), (3, "centimetres"), (20, "millimetres"), (1e4, "")]
)
def test_a_pixel_in_another_unit_is_refused(gsd, unit, field, tmp_path, capsys):
    status, _, said = run(capsys, field, "--vehicle", "mavic-3e", "--gsd", gsd, "--out", tmp_path / "plan")
    assert status == 2
    assert "[mission.gsd_too_large]" in said
    assert (f"probably in {unit}" in said) if unit else ("probably" not in said)
    assert "battery" not in said
    assert not (tmp_path / "plan").exists()


def test_python_does_the_same(field, tmp_path):
    done = rb.plan_mission(field, tmp_path / "a", vehicle="mavic-3e", gsd=0.02, to="wpml,kml")
    assert main(["plan", "mission", str(field), "--vehicle", "mavic-3e", "--gsd", "0.02", "--to", "wpml,kml",
                 "--out", str(tmp_path / "b")]) == 0  # fmt: skip
    for name in ("mission.toml", "mission.kmz", "mission.kml", "mission.svg"):
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()
    assert done.facts.seen_rarely == 0


@pytest.mark.parametrize("pattern", ["nadir", "double-grid", "oblique-grid", "corridor", "facade", "orbit"])
def test_every_pattern_by_the_command(pattern, field, tmp_path, capsys):
    line = geojson(tmp_path / "line.geojson", "LineString", LINE)
    place = geojson(tmp_path / "place.geojson", "Point", LINE[0])
    area = {"corridor": line, "facade": line, "orbit": place}.get(pattern, field)
    more = {
        "corridor": ("--width", 80), "facade": ("--heights", 0, 18, "--gsd", 0.005, "--side", "left"),
        "orbit": ("--heights", 0, 30, "--gsd", 0.005),
    }.get(pattern, ())  # fmt: skip
    words = (area, "--vehicle", "mavic-3e", "--pattern", pattern, *more, "--out", tmp_path / "p")
    assert values_of(reported(capsys, "plan", "mission", *words))["flight.mission"]["pattern"] == pattern


def test_a_ridge_is_followed_and_batteries_are_told(tmp_path, capsys):
    hill = geojson(
        tmp_path / "hill.geojson", "Polygon",
        [[[-84.26, 36.60], [-84.248, 36.60], [-84.248, 36.608], [-84.26, 36.608], [-84.26, 36.60]]],
    )  # fmt: skip
    found = reported(
        capsys, "plan", "mission", hill, "--vehicle", "mavic-3e", "--height", 100, "--dem", SRTM, "--speed", 10, "--to",
        "wpml,litchi,kml", "--out", tmp_path / "plan", "--take-off", -84.254, 36.604, "--battery", 30,
    )  # fmt: skip
    assert values_of(found)["flight.batteries"]["n"] >= 3
    assert "EPSG:32616" in texts_of(found, ["notes"])
    assert "Litchi takes 99" in texts_of(found)
    assert "mission.out_of_sight" in values_of(found, ["warnings"])
    m = read_mission(tmp_path / "plan")
    assert m.flights >= 3
    assert m.terrain == "jacksboro.tif"
    assert len(list((tmp_path / "plan").glob("*.kmz"))) == m.flights
    assert "absolute" in (tmp_path / "plan/mission-1.kml").read_text()


KML = """<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><Document><Folder><Placemark><Polygon>
<outerBoundaryIs><LinearRing><coordinates>{outer}</coordinates></LinearRing></outerBoundaryIs>
<innerBoundaryIs><LinearRing><coordinates>{inner}</coordinates></LinearRing></innerBoundaryIs>
</Polygon></Placemark></Folder></Document></kml>"""


def test_areas_of_every_kind_of_file(field, tmp_path):
    expected = np.array(FIELD)
    outer = " ".join(f"{x},{y},0" for x, y in [*FIELD, FIELD[0]])
    inner = "7.101,50.101 7.102,50.101 7.102,50.102 7.101,50.101"
    (tmp_path / "a.kml").write_text(KML.format(outer=outer, inner=inner))
    with zipfile.ZipFile(tmp_path / "a.kmz", "w") as archive:
        archive.write(tmp_path / "a.kml", "doc.kml")
    for given in (field, tmp_path / "a.kml", tmp_path / "a.kmz", ", ".join(f"{x} {y}" for x, y in FIELD)):
        (shape,) = read_shapes(str(given))
        assert shape.kind == "area"
        np.testing.assert_allclose(shape.xy, expected)
        assert plane_crs(shape) == "EPSG:32632"
    assert len(read_shapes(str(tmp_path / "a.kml"))[0].holes[0]) == 3
    assert read_shapes("7 50")[0].kind == "place"
    assert read_shapes("7 50; 7.1 50")[0].kind == "line"
    assert plane_crs(read_shapes("-60.1 -33")[0]) == "EPSG:32720"


@pytest.mark.parametrize("suffix", ["gpkg", "shp", "fgb"])
def test_areas_by_ogr(suffix, tmp_path):
    pyogrio = pytest.importorskip("pyogrio")
    import struct

    ring = np.array([[*FIELD, FIELD[0]]][0])
    xy = in_crs(ring, "EPSG:4326", "EPSG:25832")
    wkb = struct.pack("<BII", 1, 3, 1) + struct.pack("<I", len(xy)) + xy.astype("<f8").tobytes()
    path = tmp_path / f"area.{suffix}"
    pyogrio.raw.write(
        path, geometry=np.array([wkb], object), field_data=[np.array([1])], fields=["id"], geometry_type="Polygon",
        crs="EPSG:25832",
    )  # fmt: skip
    (shape,) = read_shapes(str(path))
    assert shape.kind == "area"
    assert plane_crs(shape) == shape.crs
    assert np.abs(np.sort(shape.xy, axis=0) - np.sort(xy[:-1], axis=0)).max() < 1e-6


def test_a_system_that_is_stated_counts(tmp_path):
    xy = in_crs(np.array(FIELD), "EPSG:4326", "EPSG:25832").tolist()
    path = geojson(
        tmp_path / "a.geojson", "Polygon", [[*xy, xy[0]]],
        crs={"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::25832"}},
    )  # fmt: skip
    assert read_shapes(str(path))[0].crs == "EPSG:25832"
    done = rb.plan_mission(path, tmp_path / "plan", vehicle="mavic-3e")
    assert done.mission.crs == "EPSG:25832"
    feet = in_crs(np.array([[-84.2, 36.0], [-84.19, 36.0], [-84.19, 36.01]]), "EPSG:4326", "EPSG:2274")
    text = ", ".join(f"{x} {y}" for x, y in feet.tolist())
    done = rb.plan_mission(text, tmp_path / "feet", vehicle="mavic-3e", crs="EPSG:2274")
    assert done.mission.crs == "EPSG:32616"


BAD = [
    (("--gsd", 0.02), "[mission.camera_missing]"),
    (("--vehicle", "kite"), "[mission.vehicle_unknown]"),
    (("--camera", "nothing.jpg"), "[mission.camera_unknown]"),
    (("--vehicle", "mavic-3e", "--gsd", 0.02, "--height", 80), "[option.exclusive]"),
    (("--vehicle", "mavic-3e", "--to", "wpml,gpx"), "[format.unknown]"),
    (("--vehicle", "mavic-3e", "--pattern", "corridor"), "[mission.shape]"),
    (("--vehicle", "mavic-3e", "--speed", 14, "--overlap", 0.9, 0.7), "[mission.camera_interval]"),
    (("--vehicle", "mavic-3e", "--battery", 1), "[mission.battery]"),
    (("--vehicle", "mavic-3e", "--pattern", "double-grid", "--tilt", 80), "[mission.view_to_horizon]"),
    (("--vehicle", "mavic-3e", "--dem", SRTM), "[raster.no_overlap]"),
    (("--vehicle", "mavic-3e", "--no-go", "FIELD"), "[mission.area_in_zones]"),
    (("--vehicle", "mavic-3e", "--name", "../plan"), "'../plan' is not possible as a file name. [mission.name]"),
    (("--vehicle", "mavic-3e", "--gsd", 1e-6), "[mission.too_many_parts]"),
    (
        ("--vehicle", "mavic-3e", "--gsd", 2e-4, "--battery", 1400, "--interval", 0.01),
        "[mission.too_many_photographs]",
    ),
    (("--vehicle", "mavic-3e", "--pattern", "orbit"), "[mission.heights_missing]"),
]


@pytest.mark.parametrize(("words", "told"), BAD, ids=[t[:30] for _, t in BAD])
def test_bad_input_is_told(words, told, field, tmp_path, capsys):
    words = [field if w == "FIELD" else w for w in words]
    status, _, err = run(capsys, field, *words, "--out", tmp_path / "plan")
    assert status == 2
    assert told in err
    assert not (tmp_path / "plan").exists()


@pytest.mark.parametrize(
    ("coordinates", "told"),
    [
        ("7 50, 7.01 50.01, 7.01 50, 7 50.01", "[flight_area.crosses_itself]"),
        ("7 50, 7.01 50, 7.02 50", "has no extent"),
        ("500000 5500000, 500100 5500000, 500100 5500100", "[area.not_degrees]"),
        ("7 88, 7.1 88, 7.1 88.1", "[area.no_utm]"),
        ("no file at all", "[file.missing]"),
    ],
)
def test_areas_that_are_none(coordinates, told, tmp_path, capsys):
    status, _, err = run(capsys, coordinates, "--vehicle", "mavic-3e", "--out", tmp_path / "plan")
    assert status == 2
    assert told in err


@pytest.mark.parametrize(
    ("content", "told"),
    [
        ('{"type": "FeatureCollection", "features": []}', "[area.none]"),
        ('{"type": "Polygon", "coordinates": [[[7, 50], [7, "x"]]]}', r"value\.not_a_number"),
        ('{"type": "Polygon", "coordinates": [[[7], [8]]]}', "[value.count]"),
        ('{"type": "Polygon"}', r"value\.key_missing"),
        ("nothing", r"json\.invalid"),
    ],
)
def test_files_without_an_area(content, told, tmp_path):
    (tmp_path / "a.geojson").write_text(content)
    with pytest.raises(InputError, match=told):
        read_shapes(str(tmp_path / "a.geojson"))


def test_typed_coordinates_are_what_the_pattern_needs(tmp_path):
    text = ", ".join(f"{x} {y}" for x, y in LINE)
    done = rb.plan_mission(text, tmp_path / "corridor", vehicle="mavic-3e", pattern="corridor", width=40)
    assert not done.mission.closed
    assert len(done.mission.outline) == 3
    assert rb.plan_mission(text, tmp_path / "nadir", vehicle="mavic-3e").mission.closed


def test_two_areas_are_not_one(tmp_path, capsys):
    second = [[x + 0.01, y] for x, y in FIELD]
    path = geojson(tmp_path / "two.geojson", "MultiPolygon", [[[*FIELD, FIELD[0]]], [[*second, second[0]]]])
    status, _, err = run(capsys, path, "--vehicle", "mavic-3e", "--out", tmp_path / "plan")
    assert status == 2
    assert "[mission.several_outlines]" in err


def test_heights_over_the_limit_are_a_fault(field, tmp_path, capsys):
    words = (field, "--vehicle", "mavic-3e", "--height", 150, "--out", tmp_path / "plan")
    faults = texts_of(reported(capsys, "plan", "mission", *words), ["faults"])
    assert "150 m" in faults
    assert "120 m" in faults


def test_holes_of_the_ground_are_named(field, tmp_path, capsys):
    rasterio = pytest.importorskip("rasterio")
    table = np.full((80, 80), 100.0, np.float32)
    west, north = in_crs(np.array([[7.096, 50.105]]), "EPSG:4326", "EPSG:32632")[0]
    table[40:43, 40:43] = -9999
    path = tmp_path / "dsm.tif"
    with rasterio.open(
        path, "w", driver="GTiff", height=80, width=80, count=1, dtype="float32", crs="EPSG:32632", nodata=-9999,
        transform=rasterio.Affine(10, 0, west, 0, -10, north),
    ) as f:  # fmt: skip
        f.write(table, 1)
    words = (field, "--vehicle", "mavic-3e", "--dem", path, "--out", tmp_path / "plan", "--verbose")
    status, told, err = run(capsys, *words)
    if status == 0:
        assert "1 hole" in told
    else:
        assert "[terrain.void_below_flight]" in err


def test_cameras_from_what_a_user_has(tmp_path):
    assert mission_camera("", "mavic-3e") is KNOWN["mavic-3e"][1]
    assert mission_camera("Zenmuse P1 35 mm").width_px == 8192
    figures = mission_camera("6000x4000,4500.5")
    assert (figures.width_px, figures.height_px, figures.c_px) == (6000, 4000, 4500.5)
    for vehicle, camera in KNOWN.values():
        assert vehicle_of(vehicle.name) == vehicle
        assert 0.5 < camera.c_px / camera.width_px < 1.1  # 20 to 35 mm of 36 mm
    (tmp_path / "camera.toml").write_text(
        '[cameras.rig]\nmodel = "brown"\nwidth_px = 5472\nheight_px = 3648\npixel_mm = [0.0024, 0.0024]\nc_mm = 8.8\n'
    )
    try:
        camera = mission_camera(str(tmp_path / "camera.toml"))
    except InputError as error:
        pytest.fail(str(error))
    assert camera.c_px == pytest.approx(8.8 / 0.0024)


@needs_uav
@pytest.mark.data
def test_a_photograph_tells_its_camera():
    photo = UAV / "IMG_0061.jpg"
    camera = mission_camera(str(photo))
    assert (camera.width_px, camera.height_px) == (2136, 1424)
    assert camera.c_px == pytest.approx(2843, rel=0.02)
    assert 0 < camera.exposure_s <= 0.01
    assert "IMG_0061.jpg" in camera.source


def test_a_facade_is_flown_on_the_side_that_was_asked_for(tmp_path):
    line = geojson(tmp_path / "line.geojson", "LineString", LINE[:2])
    sides = {}
    for side in ("left", "right"):
        done = rb.plan_mission(
            line, tmp_path / side, vehicle="mavic-3e", pattern="facade", heights=(0, 12), gsd=0.003, side=side
        )
        a, b = done.mission.outline
        d = exposures(done.mission).xyz[:, :2] - a
        sides[side] = np.sign((b - a)[0] * d[:, 1] - (b - a)[1] * d[:, 0])
    assert (sides["left"] == 1).all()
    assert (sides["right"] == -1).all()


def test_without_pyogrio(monkeypatch, tmp_path):
    from raybundle.io.missions import areas

    def without(name):
        raise ImportError(name)

    monkeypatch.setattr(areas, "import_module", without)
    (tmp_path / "a.gpkg").write_bytes(b"x")
    with pytest.raises(InputError, match=r"package\.pyogrio_missing"):
        read_shapes(str(tmp_path / "a.gpkg"))


def test_damaged_archives(tmp_path):
    (tmp_path / "a.kmz").write_bytes(b"PK\3\4 nothing")
    with pytest.raises(InputError, match=r"archive\.not_unpacked"):
        read_shapes(str(tmp_path / "a.kmz"))
    shutil.copy(Path(__file__), tmp_path / "a.shp")
    with pytest.raises(InputError, match=r"area\.not_readable"):
        read_shapes(str(tmp_path / "a.shp"))
