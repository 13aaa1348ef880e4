"""Control of scenes from tables, GeoJSON, GeoPackage and lists, in any coordinate system."""

import json

import numpy as np
import pytest
from pyproj import Transformer

import raybundle as rb
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.formats.gpkg import points_wkb
from raybundle.io.scenes.control import read_scene_control, scene_key
from raybundle.io.scenes.rpc_text import write_rpc_text

SHIFT = np.array([4.5, -2.25])
UTM = "EPSG:32637"
"""The zone of the scene, 36 E."""


@pytest.fixture
def given(rpc, tmp_path):
    """The RPC as a file, and eight points on the ground and in the image."""
    write_rpc_text(rpc, tmp_path / "scene_RPC.TXT")
    rng = np.random.default_rng(1)
    ground = rpc.ground_offset + rpc.ground_scale * rng.uniform(-0.7, 0.7, (8, 3))
    return tmp_path, ground, rpc.project(ground) + SHIFT


def utm(ground, crs=UTM):
    return np.stack(Transformer.from_crs("EPSG:4979", crs, always_xy=True).transform(*ground.T), axis=1)


def rows(names, *columns):
    table = [",".join(names)]
    for k, values in enumerate(zip(*columns, strict=True)):
        cells = [v if isinstance(v, str) else repr(float(v)) for part in values for v in np.atleast_1d(part).tolist()]
        table.append(",".join([f"P{k}", *cells]))
    return "\n".join(table) + "\n"


def same(control, ground, xy, tolerance_m=1e-4):
    assert control.ids == tuple(f"P{k}" for k in range(len(ground)))
    away = (control.geographic - ground) * [85e3, 111e3, 1.0]
    assert np.abs(away).max() < tolerance_m
    assert np.abs(control.xy_px - xy).max() < 1e-6


def test_a_table_in_a_map(given):
    folder, ground, xy = given
    table = folder / "utm.csv"
    table.write_text(rows(["point", "X", "Y", "Z", "x_px", "y_px"], utm(ground), xy))
    same(read_scene_control(table, crs=UTM), ground, xy)
    said = rb.rpc_correct(folder / "scene_RPC.TXT", table, crs=UTM)
    assert said.fit.values == pytest.approx(SHIFT, abs=1e-3)
    with pytest.raises(InputError, match=r"EPSG.*scene_control\.not_degrees"):
        read_scene_control(table)


def test_two_tables_and_roles(given, capsys):
    folder, ground, xy = given
    table, points = folder / "gcp.csv", folder / "marks.csv"
    roles = ["check" if k > 5 else "control" for k in range(8)]
    table.write_text(rows(["point", "X", "Y", "Z", "role"], utm(ground), roles))
    marks = ["image,point,x_px,y_px", *(f"scene.tif,P{k},{x!r},{y!r}" for k, (x, y) in enumerate(xy.tolist()))]
    points.write_text("\n".join([*marks, "other.tif,P0,5,5"]) + "\n")
    words = ["rpc", "correct", str(folder / "scene_RPC.TXT"), str(table), "--crs", UTM]
    assert main([*words, "--image-points", str(points)]) == 0
    assert "2 check points" in capsys.readouterr().out
    assert main(words) == 2
    assert "[scene_control.no_image_point]" in capsys.readouterr().err
    (folder / "gcp-measurements.csv").write_text(points.read_text())  # beside it, as orient takes it
    assert main(words) == 0
    control = read_scene_control(table, crs=UTM)
    assert control.of("scene_RPC.TXT").check.tolist() == [False] * 6 + [True] * 2
    with pytest.raises(InputError, match=r"b\.tif.*scene\.tif.*other\.tif.*scene_control\.other_images"):
        control.of("b.tif", alone=True)


def test_standard_deviations_follow_the_axes(given):
    """A third of a metre to the north of the grid is one to the north, turned by the convergence."""
    folder, ground, xy = given
    table = folder / "utm.csv"
    sigma = np.tile([0.0, 0.3, 0.5], (8, 1))
    table.write_text(rows(["point", "X", "Y", "Z", "sX", "sY", "sZ", "x_px", "y_px"], utm(ground), sigma, xy))
    found = read_scene_control(table, crs=UTM).sigma_m
    lon, lat = np.radians(ground[:, :2]).T
    convergence = np.arctan(np.tan(lon - np.radians(39)) * np.sin(lat))
    assert found[:, 0] == pytest.approx(0.3 * np.abs(np.sin(convergence)), abs=2e-3)
    assert found[:, 1] == pytest.approx(0.3 * np.cos(convergence), rel=2e-3)
    assert found[:, 2] == pytest.approx(0.5, rel=1e-3)
    assert read_scene_control(table, crs=UTM).of("scene.tif").sigma_m is not None


def test_heights_above_a_geoid(given, capsys):
    """By a stated undulation; by a grid that is not there it is an error, never ellipsoidal in silence."""
    folder, ground, xy = given
    table = folder / "utm.csv"
    orthometric = utm(ground) - [0, 0, 21.5]
    table.write_text(rows(["point", "X", "Y", "Z", "x_px", "y_px"], orthometric, xy))
    same(read_scene_control(table, crs=UTM, undulation=21.5), ground, xy)
    words = ["rpc", "correct", str(folder / "scene_RPC.TXT"), str(table), "--verbose", "--crs"]
    assert main([*words, UTM, "--undulation", "21.5"]) == 0
    assert " 21.5 m" in capsys.readouterr().out
    assert main([*words, f"{UTM}+5773"]) in {0, 2}  # with the grid of EGM96, or without
    captured = capsys.readouterr()
    assert "[crs.geoid_missing]" in captured.err or "EGM96" not in captured.err


def test_the_geoid_goes_through_its_grid(given, geoid_grid):
    """EGM96 by PROJ, whose grid is one of our own making: 21.5 m, rising to the east."""
    folder, ground, xy = given
    table = folder / "utm.csv"
    orthometric = utm(ground) - np.column_stack([np.zeros((8, 2)), geoid_grid(ground)])
    table.write_text(rows(["point", "X", "Y", "Z", "x_px", "y_px"], orthometric, xy))
    same(read_scene_control(table, crs=f"{UTM}+5773"), ground, xy, 1e-3)
    content = geojson(ground - np.column_stack([np.zeros((8, 2)), geoid_grid(ground)]), xy)
    (folder / "a.geojson").write_text(json.dumps(content))
    same(read_scene_control(folder / "a.geojson", crs="EPSG:4326+5773"), ground, xy, 1e-3)


def geojson(ground, xy, **more):
    features = [
        {
            "type": "Feature", "properties": {"name": f"P{k}", "x_px": x, "y_px": y} | more,
            "geometry": {"type": "Point", "coordinates": g},
        }
        for k, (g, (x, y)) in enumerate(zip(ground.tolist(), xy.tolist(), strict=True))
    ]  # fmt: skip
    return {"type": "FeatureCollection", "features": features}


def test_geojson(given):
    folder, ground, xy = given
    file = folder / "a.geojson"
    file.write_text(json.dumps(geojson(ground, xy)))
    same(read_scene_control(file), ground, xy)
    old = geojson(utm(ground), xy) | {"crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32637"}}}
    file.write_text(json.dumps(old))
    same(read_scene_control(file), ground, xy)
    with pytest.raises(InputError, match=r"37N.*38N.*scene_control\.other_system"):
        read_scene_control(file, crs="EPSG:32638")
    same(read_scene_control(file, crs=UTM, undulation=0.0), ground, xy)  # the same system, with its heights
    flat = geojson(ground[:, :2], xy)
    file.write_text(json.dumps(flat))
    with pytest.raises(InputError, match=r"8.*P0.*scene_control\.no_height"):
        read_scene_control(file)
    for feature, h in zip(flat["features"], ground[:, 2].tolist(), strict=True):
        feature["properties"]["h_m"] = h
    file.write_text(json.dumps(flat))
    same(read_scene_control(file), ground, xy)
    marks = folder / "marks.csv"
    marks.write_text("\n".join(["image,point,x_px,y_px", *(f"s.tif,P{k},{x},{y}" for k, (x, y) in enumerate(xy))]))
    for feature in flat["features"]:
        del feature["properties"]["x_px"]
    file.write_text(json.dumps(flat))
    with pytest.raises(
        InputError, match=r"features\.0.*x_px.*y_px.*name.*y_px.*h_m.*scene_control\.no_image_attributes"
    ):
        read_scene_control(file)
    same(read_scene_control(file, image_points=marks), ground, xy)
    flat["features"][0]["geometry"] = {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}
    file.write_text(json.dumps(flat))
    with pytest.raises(InputError, match=r"LineString.*scene_control\.not_a_point"):
        read_scene_control(file)


def test_pixels_as_orthority_counts_them(given):
    folder, ground, xy = given
    content = geojson(ground, xy)
    for feature, p in zip(content["features"], xy.tolist(), strict=True):
        feature["properties"] = {"id": feature["properties"]["name"], "ji": [p[0] - 0.5, p[1] - 0.5]}
    (folder / "a.geojson").write_text(json.dumps(content))
    same(read_scene_control(folder / "a.geojson"), ground, xy)


def as_array(values):
    found = np.empty(len(values), object)
    found[:] = values
    return found


def write_gpkg(path, xyz, crs, columns, layer="control", *, geometry=True, append=False):
    pyogrio = pytest.importorskip("pyogrio")
    data = [as_array(v) if isinstance(v[0], str) else np.asarray(v, float) for v in columns.values()]
    pyogrio.raw.write(
        str(path), as_array(points_wkb(xyz)) if geometry else None, data, list(columns),
        geometry_type="Point Z" if geometry else None, crs=crs if geometry else None, driver="GPKG", layer=layer,
        append=append,
    )  # fmt: skip


def test_geopackage(given):
    folder, ground, xy = given
    file, names = folder / "a.gpkg", [f"P{k}" for k in range(8)]
    columns = {"point": names, "x_px": xy[:, 0], "y_px": xy[:, 1], "role": ["control"] * 7 + ["check"]}
    write_gpkg(file, utm(ground), UTM, columns)
    control = read_scene_control(file)
    same(control, ground, xy)
    assert control.check.tolist() == [False] * 7 + [True]
    assert rb.rpc_correct(folder / "scene_RPC.TXT", file).checked.rms_px.max() < 1e-3


def test_geopackage_with_a_table_of_image_points(given):
    folder, ground, xy = given
    file, names = folder / "a.gpkg", [f"P{k}" for k in range(8)]
    write_gpkg(file, utm(ground), UTM, {"name": names})
    marks = {"image": ["scene.tif"] * 8, "point": names, "x_px": xy[:, 0], "y_px": xy[:, 1]}
    write_gpkg(file, ground, None, marks, "image_points", geometry=False, append=True)
    control = read_scene_control(file, image_points=file)
    same(control, ground, xy)
    assert set(control.image) == {"scene.tif"}
    with pytest.raises(InputError, match=r"x_px.*y_px.*scene_control\.no_image_attributes"):
        read_scene_control(file)


def test_a_list_with_its_own_system(given):
    folder, ground, xy = given
    lines = [UTM]
    for k, (g, (x, y)) in enumerate(zip(utm(ground).tolist(), xy.tolist(), strict=True)):
        lines.append(f"{g[0]!r} {g[1]!r} {g[2]!r} {x!r} {y!r} scene.tif P{k}")
    (folder / "gcp_list.txt").write_text("\n".join(lines) + "\n")
    same(read_scene_control(folder / "gcp_list.txt"), ground, xy)


def test_longitude_and_latitude_without_a_system_are_said(given):
    folder, ground, xy = given
    table = folder / "a.csv"
    table.write_text(rows(["point", "X", "Y", "Z", "x_px", "y_px"], ground, xy))
    control = read_scene_control(table)
    same(control, ground, xy)
    assert [m.code for m in control.remarks[0].messages] == ["scene_control.wgs84_assumed"]
    own = folder / "b.csv"
    own.write_text(rows(["point", "lon_deg", "lat_deg", "h_m", "x_px", "y_px"], ground, xy))
    with pytest.raises(InputError, match=r"lon_deg.*lat_deg.*h_m.*scene_control\.geographic_columns"):
        read_scene_control(own, crs=UTM)
    same(read_scene_control(own), ground, xy)


@pytest.mark.parametrize(
    ("name", "key"),
    [("A.tif", "a"), ("a_RPC.TXT", "a"), ("x/a.RPB", "a"), ("a.b.TIF", "a.b"), ("a.tif.aux.xml", "a.tif"), ("a", "a")],
)
def test_files_of_one_scene(name, key):
    assert scene_key(name) == key


def test_damaged_geopackage(tmp_path):
    pytest.importorskip("pyogrio")
    (tmp_path / "a.gpkg").write_bytes(b"SQLite format 3\0" + b"x" * 100)
    with pytest.raises(InputError, match=r"file\.not_readable"):
        read_scene_control(tmp_path / "a.gpkg")


@pytest.mark.parametrize(
    ("header", "code"),
    [
        ("name,lon,lat,height,x,y", "scene_control.columns_missing"),
        ("point;lon;lat;h;x_px;y_px", "scene_control.columns_missing"),
        ("point,X,Y,Z,col,row", "scene_control.columns_missing"),
        ("point,easting,northing,height,x_px,y_px", "scene_control.columns_missing"),
        ("id,lon_deg,lat_deg,h_m,x_px,y_px", "scene_control.columns_missing"),
        (None, "table.no_header"),
    ],
)
def test_columns_of_another_name_are_listed_beside_those_that_are_needed(given, header, code):
    folder, ground, xy = given
    lines = rows(["point", "lon_deg", "lat_deg", "h_m", "x_px", "y_px"], ground, xy).splitlines()[1:]
    if header is not None:
        lines.insert(0, header.replace(";", ","))
    separator = ";" if header and ";" in header else ","
    table = folder / "control.csv"
    table.write_text("\n".join(lines).replace(",", separator) + "\n")
    with pytest.raises(InputError) as error:
        read_scene_control(table)
    values = error.value.message.values
    assert error.value.code == code
    if header is None:
        assert values["header"][0] == "P0"
        assert values["needed"] == ["point", "lon_deg", "lat_deg", "h_m", "x_px", "y_px"]
        return
    assert values["header"] == header.replace(";", ",").split(",")
    assert values["geographic"] == ["point", "lon_deg", "lat_deg", "h_m", "x_px", "y_px"]
    assert values["grid"] == ["point", "X", "Y", "Z", "x_px", "y_px"]


def test_a_list_without_a_coordinate_system_shows_the_form_of_its_lines(given):
    folder, ground, xy = given
    table = folder / "control.txt"
    table.write_text(rows(["point", "lon", "lat", "h", "x", "y"], ground, xy).replace(",", " "))
    with pytest.raises(InputError, match=r"gcp_list\.no_system"):
        read_scene_control(table)
