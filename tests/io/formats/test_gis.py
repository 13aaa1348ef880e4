"""GeoPackage, DXF, LAS and PLY of a georeferenced result: what other programs read stands where map.csv says."""

import csv
import struct
import sys
from dataclasses import replace

import numpy as np
import pytest
from tests.messages import coded

from raybundle import adjust
from raybundle.block import Distances, Role
from raybundle.cli.convert import command
from raybundle.errors import InputError
from raybundle.io.block.folder import write_block
from raybundle.io.formats import Displaced, Export, write_format
from raybundle.io.formats.surveyed import surveyed
from raybundle.io.geo.coordinate_systems import in_other_projection, local_frame
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.observations.alignment import Levels, Lines, Planes, PlumbLines
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, TargetField, aerial_scene, brown_camera, field_scene
from raybundle.report.write import write_result
from raybundle.workflows.sources import read_source

FRAMES = {
    "projected": local_frame("EPSG:32632", (700_000.0, 5_400_000.0, 400.0)),
    "with heights": local_frame("EPSG:25832+7837", (700_000.0, 5_400_000.0, 400.0), undulation_m=46.5),
    "feet": local_frame("EPSG:2263", (984_000.0, 207_000.0, 100.0)),
}
"""2.0 degrees of convergence in the first two"""
ODD = ('a<>/\\":;?*|=`,b', "%%d ^J", "Stück 3")


def convert(*words):
    command.main([str(w) for w in words], standalone_mode=False)


@pytest.fixture(scope="module")
def adjusted():
    survey = Survey(control=6, check=2, control_sigma=(0.02, 0.02, 0.03))
    block = simulate(aerial_scene(AerialStrips(images_per_strip=4, points_per_image=30)), survey).observed
    tie = np.flatnonzero(np.asarray(block.points.role) == Role.TIE)[:9]
    names = list(block.points.ids)
    for k, name in zip(tie, (*ODD, "P10", "P2", "t7", "t8", "t9", "t10"), strict=True):
        names[k] = name
    return adjust(replace(block, points=replace(block.points, ids=tuple(names))))


@pytest.fixture(scope="module", params=FRAMES)
def georeferenced(request, adjusted, tmp_path_factory):
    frame, folder = FRAMES[request.param], tmp_path_factory.mktemp("map") / "result"
    write_result(adjusted, folder, report="none", additions={"frame": frame.as_mapping()}, frame=frame)
    return folder, frame


def map_csv(folder):
    """Coordinates and standard deviations (6,) of images and points, by kind of row and id."""
    with (folder / "map.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {
        ("image" if r["kind"] == "image" else "point", r["id"]): np.array(
            [float(r[c] or "nan") for c in ("X", "Y", "Z", "sX", "sY", "sZ")]
        )
        for r in rows
    }


def test_a_geopackage_has_the_coordinates_and_sigmas_of_the_map(georeferenced, tmp_path):
    raw, (folder, frame) = pytest.importorskip("pyogrio").raw, georeferenced
    convert(folder, "--to", "gpkg", "--out", tmp_path / "a.gpkg")
    expected = map_csv(folder)
    layers = {}
    for name, kind in (("points", "point"), ("stations", "image"), ("control", "point")):
        meta, _, geometry, data = raw.read(tmp_path / "a.gpkg", layer=name)
        assert parse_crs(meta["crs"]).equals(parse_crs(frame.crs), ignore_axis_order=True)
        columns = layers[name] = dict(zip(meta["fields"], data, strict=True))
        for k, (id_, shape) in enumerate(zip(columns["id"], geometry, strict=True)):
            want = expected[kind, id_]
            at = struct.unpack("<BIddd", shape)[2:]
            np.testing.assert_allclose(at, want[:3], rtol=0, atol=1e-6)
            np.testing.assert_allclose([columns[a][k] for a in ("E", "N", "h")], want[:3], rtol=0, atol=1e-6)
            np.testing.assert_allclose([columns[a][k] for a in ("sE", "sN", "sh")], want[3:], rtol=1e-9)
    roles = layers["points"]["role"].tolist()
    assert roles == ["control"] * 6 + ["check"] * 2 + ["tie"] * (len(roles) - 8)
    named = layers["points"]["id"].tolist()[8:]
    assert named.index("P2") + 1 == named.index("P10")
    assert named[-4:] == ["t7", "t8", "t9", "t10"]  # names of programs come last
    assert len(layers["control"]["id"]) == 8
    assert np.isfinite([layers["control"][d] for d in ("dE", "dN", "dh")]).all()


def test_differences_of_control_are_those_of_the_result_turned_into_the_map(georeferenced, tmp_path):
    folder, frame = georeferenced
    with (folder / "check.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    check = {r["point"]: np.array([float(r[c]) for c in ("dX", "dY", "dZ")]) for r in rows}
    told = 1e-3 * max(float(r[c]) for r in rows for c in ("sX", "sY", "sZ"))  # of the table's digits
    s = surveyed(read_source(folder)[0])
    at = {n: k for k, n in enumerate(s.names)}
    for name, local in check.items():
        k = at[name]
        turned = np.linalg.solve(frame.jacobian(s.xyz[k : k + 1])[0], local)
        np.testing.assert_allclose(s.differences[k], turned, rtol=1e-4, atol=4 * told)  # of feet
    assert np.isnan(s.differences[at["P2"]]).all()


def test_angles_are_those_to_the_grid(georeferenced, tmp_path):
    """A metre along each axis of an image lies where the angles of the station say."""
    folder, frame = georeferenced
    export, _ = read_source(folder)
    s = surveyed(export)
    R = rotation_from_angles(np.radians(s.angles))
    for k in range(3):
        ahead = s.scene.centre + s.scene.rotation[:, k, :]
        step = frame.crs_from_local(ahead) - s.stations
        np.testing.assert_allclose(step / np.linalg.norm(step, axis=1)[:, None], R[:, k, :], atol=6e-4)  # m = 1 +- 6e-4
    turned = np.degrees(frame.scale_and_convergence(s.stations)[:, 1])
    apart = s.angles[:, 2] - np.degrees(export.block.images.angles[s.scene.source, 2])
    np.testing.assert_allclose(np.abs((apart + 180) % 360 - 180), np.abs(turned), atol=0.02)


def test_a_drawing_has_the_coordinates_of_the_map(georeferenced, tmp_path):
    ezdxf, (folder, frame) = pytest.importorskip("ezdxf"), georeferenced
    convert(folder, "--to", "dxf", "--out", tmp_path / "a.dxf")
    drawing = ezdxf.readfile(tmp_path / "a.dxf")
    assert not drawing.audit().errors
    assert dict(drawing.header.custom_vars)["coordinate system"] == frame.crs
    assert drawing.header["$INSUNITS"] == (21 if frame.crs == "EPSG:2263" else 6)
    expected, found = map_csv(folder), {}
    for point in drawing.modelspace().query("POINT"):
        data = point.get_xdata("RAYBUNDLE")
        name = data[0].value.removeprefix("name=").replace("%%%%%%", "%%").replace("^ ", "^")
        numbers = dict(zip((t.value for t in data[1::2]), (t.value for t in data[2::2]), strict=True))
        kind = "image" if point.dxf.layer == "stations" else "point"
        found[kind, name] = point.dxf.layer
        want = expected[kind, name]
        np.testing.assert_allclose(tuple(point.dxf.location), want[:3], rtol=0, atol=1e-6)
        np.testing.assert_allclose([numbers[a] for a in ("sE", "sN", "sh")], want[3:], rtol=1e-9)
    assert set(found) == set(expected)
    assert found["point", "P2"] == "points-named"
    assert found["point", "t7"] == "points-tie"
    words = [t.plain_text() for t in drawing.modelspace().query("TEXT[layer=='points-named-names']")]
    assert {ODD[0], "%%d ^J", "Stück 3"} <= {w.replace("%%%%", "%%") for w in words} | {"%%d ^J"}
    assert words.index("P2") + 1 == words.index("P10")
    assert "t7" not in words


def test_las_and_ply_have_the_coordinates_of_the_map(georeferenced, tmp_path):
    laspy, (folder, frame) = pytest.importorskip("laspy"), georeferenced
    convert(folder, "--to", "las", "--out", tmp_path / "a.las")
    convert(folder, "--to", "ply", "--out", tmp_path / "a.ply")
    expected = np.array([v for (kind, _), v in map_csv(folder).items() if kind == "point"])
    cloud = laspy.read(tmp_path / "a.las")
    assert cloud.header.parse_crs().equals(parse_crs(frame.crs), ignore_axis_order=True)
    text = next(v.string for v in cloud.header.vlrs if v.record_id == 2112)
    assert text.startswith("COMPD_CS[" if "+" in frame.crs else "PROJCS[")  # OGC 01-009, not its successor
    np.testing.assert_allclose(cloud.xyz, expected[:, :3], rtol=0, atol=0.51e-4)
    np.testing.assert_allclose(np.stack([cloud.sigma_x, cloud.sigma_y, cloud.sigma_z], 1), expected[:, 3:], rtol=1e-6)
    head, _, body = (tmp_path / "a.ply").read_bytes().partition(b"end_header\n")
    assert f"comment crs {frame.crs}\n".encode() in head
    row = np.dtype([("xyz", "<f8", 3), ("rgb", "u1", 3), ("sigma", "<f4", 3), ("rays", "<i4")])
    np.testing.assert_allclose(np.frombuffer(body, row)["xyz"], expected[:, :3], rtol=0, atol=1e-6)


@pytest.mark.parametrize("name", FRAMES)
def test_displacements_are_in_the_axes_of_the_map(name, adjusted, tmp_path):
    raw, frame = pytest.importorskip("pyogrio").raw, FRAMES[name]
    xyz, vector = np.array([[10.0, -20, 5], [40, 3, 0], [np.nan] * 3]), np.array([[0.4, 0.1, -0.3]] * 3)
    moved = Displaced(
        point=("A", "B", "C"), start=("2026-05-01",) * 3, end=("2026-06-01",) * 3, xyz=xyz, vector=vector,
        covariance=np.tile(np.diag([4e-6, 1e-6, 9e-6]), (3, 1, 1)), p=np.zeros(3), verdict=("moved",) * 3,
    )  # fmt: skip
    write_format("gpkg", Export(block=adjusted.adjusted, frame=frame, displaced=moved), tmp_path / "a.gpkg")
    meta, _, geometry, data = raw.read(tmp_path / "a.gpkg", layer="displacements")
    columns = dict(zip(meta["fields"], data, strict=True))
    assert columns["id"].tolist() == ["A", "B"]
    start, end = frame.crs_from_local(xyz[:2]), frame.crs_from_local((xyz + vector)[:2])
    np.testing.assert_allclose([struct.unpack("<BIddd", g)[2:] for g in geometry], start, rtol=0, atol=1e-6)
    unit = 0.3048006 if name == "feet" else 1.0
    d = np.stack([columns[f"d{a}"] for a in ("E", "N", "h")], axis=1)
    np.testing.assert_allclose(d, (end - start) * unit, rtol=2e-3, atol=1e-4)
    sigma = np.stack([columns[f"sd{a}"] for a in ("E", "N", "h")], axis=1)
    np.testing.assert_allclose(np.sum(sigma**2, axis=1), 14e-6, rtol=1e-6)
    np.testing.assert_allclose(sigma[:, 2], 3e-3, rtol=1e-4)


def test_footprints_are_where_photographs_look(adjusted, tmp_path):
    raw = pytest.importorskip("pyogrio").raw
    block = adjusted.adjusted
    write_format("gpkg", Export(block=block), tmp_path / "a.gpkg")
    _, _, geometry, (ids, _) = raw.read(tmp_path / "a.gpkg", layer="footprints")
    assert ids.tolist() == list(block.images.ids)
    known = np.isfinite(block.points.xyz).all(axis=1)
    for k, shape in enumerate(geometry):
        count = struct.unpack("<BIII", shape[:13])[3]
        ring = np.frombuffer(shape, "<f8", offset=13).reshape(count, 3)
        np.testing.assert_array_equal(ring[0], ring[-1])
        seen = np.unique(block.observations.point[block.observations.image == k])
        inside = _inside(ring[:, :2], block.points.xyz[:, :2])
        assert inside[seen].mean() > 0.9  # relief moves points over the border
        away = known & (
            np.linalg.norm(block.points.xyz - block.images.centre[k], axis=1) > 3 * np.ptp(ring, axis=0).max()
        )
        assert not inside[away].any()
        area = np.sum(ring[:-1, 0] * ring[1:, 1] - ring[1:, 0] * ring[:-1, 1]) / 2
        assert area > 0


def _inside(ring, xy):
    a, b = ring[:-1], ring[1:]
    crosses = (a[:, 1] > xy[:, None, 1]) != (b[:, 1] > xy[:, None, 1])
    with np.errstate(divide="ignore", invalid="ignore"):
        x = a[:, 0] + (xy[:, None, 1] - a[:, 1]) * (b[:, 0] - a[:, 0]) / (b[:, 1] - a[:, 1])
    return (crosses & (x > xy[:, None, 0])).sum(axis=1) % 2 == 1


# ---- local blocks, figures


def wall():
    """A block in mm without a system, with figures of all kinds."""
    block = simulate(field_scene(TargetField(camera=brown_camera(), stations=4, frontal=1, rows=5, columns=6)),
                     Survey()).truth  # fmt: skip
    row, sigma = np.arange(5, dtype=np.int32), np.full(5, 0.5)
    return replace(block, length_unit="mm").having(
        Lines(figure=("eaves",) * 5, point=row, sigma=sigma),
        PlumbLines(figure=("a/b:c",) * 5, point=row + 5, sigma=sigma),
        Levels(figure=("L",) * 5, point=row * 3, sigma=sigma),
        Planes(figure=("floor",) * 5, point=row * 4 + 1, sigma=sigma),
        Distances(start=row[:1], end=row[4:], length=np.array([100.0]), sigma=np.array([0.1])),
    )


def test_figures_are_lines_and_outlines_of_their_kind_and_name(tmp_path):
    ezdxf, block = pytest.importorskip("ezdxf"), wall()
    write_format("dxf", Export(block=block), tmp_path / "a.dxf")
    drawing = ezdxf.readfile(tmp_path / "a.dxf")
    assert not drawing.audit().errors
    assert drawing.header["$INSUNITS"] == 4
    assert dict(drawing.header.custom_vars) == {"block": block.name, "coordinate system": "local", "unit": "mm"}
    space = drawing.modelspace()
    lines = {e.dxf.layer: (np.array(e.dxf.start), np.array(e.dxf.end)) for e in space.query("LINE")}
    np.testing.assert_allclose(lines["distances"], block.points.xyz[[0, 4]], atol=1e-12)
    start, end = lines["plumb line a_b_c"]
    np.testing.assert_array_equal(start[:2], end[:2])
    assert "straight line eaves" in lines
    outlines = {e.dxf.layer: e for e in space.query("POLYLINE")}
    assert outlines["plane floor"].is_closed
    assert len({round(v.dxf.location.z, 9) for v in outlines["level L"].vertices}) == 1
    assert outlines["level L"].get_xdata("RAYBUNDLE")[0].value == "name=L"


def test_a_local_block_says_so_and_in_what_unit(tmp_path):
    pyogrio, block = pytest.importorskip("pyogrio"), wall()
    written = write_format("gpkg", Export(block=block), tmp_path / "a.gpkg")
    assert coded(written.remarks)["conversion.no_system"] == {"unit": "mm"}
    layers = [name for name, _ in pyogrio.list_layers(tmp_path / "a.gpkg")]
    assert "control" not in layers  # nothing is in it
    info = pyogrio.read_info(tmp_path / "a.gpkg", layer="figures")
    assert info["features"] == 5
    assert 'UNIT["millimetre",0.001]' in info["crs"]
    assert {"X", "Y", "Z", "sX"} <= set(pyogrio.read_info(tmp_path / "a.gpkg", layer="points")["fields"])


def test_a_block_without_points_has_empty_layers(tmp_path):
    pyogrio, block = pytest.importorskip("pyogrio"), wall()
    without = replace(block, tables={}, points=replace(block.points, xyz=np.full(block.points.xyz.shape, np.nan)))
    write_format("gpkg", Export(block=without), tmp_path / "a.gpkg")
    assert pyogrio.read_info(tmp_path / "a.gpkg", layer="points")["features"] == 0
    assert pyogrio.read_info(tmp_path / "a.gpkg", layer="stations")["features"] == len(block.images)
    pytest.importorskip("ezdxf")
    write_format("dxf", Export(block=without), tmp_path / "a.dxf")
    nothing = Export(block=without, nominal=np.ones(len(block.images), bool))
    for name in ("gpkg", "dxf"):
        with pytest.raises(InputError, match=r"block\.nothing_to_write"):
            write_format(name, nothing, tmp_path / f"b.{name}")


# ---- another projection, degrees, what is missing


def test_a_result_is_told_in_another_projection_of_the_same_datum(adjusted, tmp_path, capsys):
    raw = pytest.importorskip("pyogrio").raw
    frame = FRAMES["projected"]
    write_result(adjusted, tmp_path / "r", report="none", additions={"frame": frame.as_mapping()}, frame=frame)
    convert(tmp_path / "r", "--to", "gpkg", "--out", tmp_path / "a.gpkg", "--crs", "EPSG:32633")
    _, _, geometry, data = raw.read(tmp_path / "a.gpkg", layer="points")
    expected = map_csv(tmp_path / "r")
    from pyproj import Transformer

    change = Transformer.from_crs("EPSG:32632", "EPSG:32633", always_xy=True)
    for id_, shape in zip(data[0], geometry, strict=True):
        x, y, z = expected["point", id_][:3]
        np.testing.assert_allclose(struct.unpack("<BIddd", shape)[2:], (*change.transform(x, y), z), rtol=0, atol=1e-5)
    for crs in ("EPSG:31467", "EPSG:25832", "EPSG:32632+3855"):  # another datum, another datum, other heights
        with pytest.raises(InputError, match=r"crs\.other_datum"):
            convert(tmp_path / "r", "--to", "gpkg", "--out", tmp_path / "b.gpkg", "--crs", crs)
    with pytest.raises(InputError, match=r"crs\.unknown"):
        convert(tmp_path / "r", "--to", "gpkg", "--out", tmp_path / "b.gpkg", "--crs", "EPSG:1")


def test_longitude_and_latitude(adjusted, tmp_path):
    laspy = pytest.importorskip("laspy")
    frame = in_other_projection(FRAMES["projected"], "EPSG:4326")
    write_result(adjusted, tmp_path / "r", report="none", additions={"frame": frame.as_mapping()}, frame=frame)
    expected = np.array([v for (kind, _), v in map_csv(tmp_path / "r").items() if kind == "point"])
    convert(tmp_path / "r", "--to", "las", "--out", tmp_path / "a.las")
    cloud = laspy.read(tmp_path / "a.las")
    np.testing.assert_allclose(cloud.xyz[:, :2], expected[:, :2], rtol=0, atol=0.51e-9)  # 0.06 mm
    np.testing.assert_allclose(cloud.xyz[:, 2], expected[:, 2], rtol=0, atol=0.51e-4)
    std = adjusted.precision.object_point_std
    np.testing.assert_allclose(cloud.sigma_x, std[:, 0], rtol=1e-5)
    convert(tmp_path / "r", "--to", "ply", "--out", tmp_path / "a.ply")
    head, _, body = (tmp_path / "a.ply").read_bytes().partition(b"end_header\n")
    assert b"comment crs local east-north-up frame at " in head
    row = np.dtype([("xyz", "<f8", 3), ("rgb", "u1", 3), ("sigma", "<f4", 3), ("rays", "<i4")])
    np.testing.assert_allclose(np.frombuffer(body, row)["xyz"], adjusted.adjusted.points.xyz, atol=1e-9)
    pytest.importorskip("ezdxf")
    with pytest.raises(InputError, match=r"4326.*format\.degrees"):
        convert(tmp_path / "r", "--to", "dxf", "--out", tmp_path / "a.dxf")
    convert(tmp_path / "r", "--to", "dxf", "--out", tmp_path / "a.dxf", "--crs", "EPSG:32632")


@pytest.mark.parametrize(("name", "library"), [("gpkg", "pyogrio"), ("dxf", "ezdxf")])
def test_without_its_extra_the_extra_is_named(name, library, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, library, None)
    write_block(wall(), tmp_path / "b")
    with pytest.raises(InputError, match=r"package\.ezdxf_missing|package\.pyogrio_missing") as told:
        convert(tmp_path / "b", "--to", name, "--out", tmp_path / f"a.{name}")
    assert ".partial" not in str(told.value)
    assert [p.name for p in tmp_path.iterdir()] == ["b"]


@pytest.mark.parametrize("name", ["gpkg", "dxf"])
def test_a_free_scale_is_refused_or_told(name, tmp_path):
    pytest.importorskip({"gpkg": "pyogrio", "dxf": "ezdxf"}[name])
    free = Export(block=replace(wall(), free_scale=True))
    with pytest.raises(InputError, match=r"format\.free_scale"):
        write_format(name, free, tmp_path / f"a.{name}")
    write_format(name, free, tmp_path / f"a.{name}", free_scale=True)
    if name == "dxf":
        import ezdxf

        assert ezdxf.readfile(tmp_path / "a.dxf").header["$INSUNITS"] == 0


SYSTEMS = {
    "geocentric": ("EPSG:4978", (4.2e6, 6.7e5, 4.7e6), None),
    "heights in feet": ("EPSG:26918+6360", (5e5, 4.5e6, 100.0), -30.0),
    "datum of its own": ("+proj=utm +zone=33 +ellps=bessel +towgs84=598.1,73.7,418.2,0.2,0.045,-2.455,6.7 +units=m",
                         (5e5, 5.4e6, 400.0), None),
    "PROJ": ("+proj=utm +zone=11 +ellps=WGS84 +datum=WGS84 +units=m +no_defs", (5e5, 3.8e6, 0.0), None),
    "kilometres": ("+proj=utm +zone=32 +datum=WGS84 +units=km", (500.0, 5400.0, 0.4), None),
    "axes north, east": ("EPSG:31467", (3.5e6, 5.4e6, 400.0), None),
    "axes south, west": ("EPSG:5514", (-6e5, -1.1e6, 300.0), None),
}  # fmt: skip


@pytest.mark.parametrize("case", SYSTEMS.values(), ids=SYSTEMS)
def test_systems_of_all_kinds(case, adjusted, tmp_path):
    crs, origin, undulation = case
    frame = local_frame(crs, origin, undulation_m=undulation)
    export = Export(block=adjusted.adjusted, frame=frame)
    expected = frame.crs_from_local(adjusted.adjusted.points.xyz)
    laspy, ezdxf = pytest.importorskip("laspy"), pytest.importorskip("ezdxf")
    write_format("las", export, tmp_path / "a.las")
    cloud = laspy.read(tmp_path / "a.las")
    np.testing.assert_allclose(cloud.xyz, expected, rtol=0, atol=0.51 * cloud.header.scales.max())
    assert cloud.header.scales.max() <= 1e-4
    assert cloud.header.parse_crs().axis_info[0].unit_conversion_factor == pytest.approx(
        parse_crs(crs).axis_info[0].unit_conversion_factor
    )
    remarks = coded(write_format("dxf", export, tmp_path / "a.dxf").remarks)
    space = ezdxf.readfile(tmp_path / "a.dxf").modelspace()
    points = np.array([tuple(p.dxf.location) for p in space.query("POINT") if p.dxf.layer != "stations"])
    np.testing.assert_allclose(np.sort(points, axis=0), np.sort(expected, axis=0), rtol=0, atol=1e-6)
    assert remarks.get("conversion.dxf_unit") == ({"unit": "kilometre"} if "km" in crs else None)
    assert remarks.get("conversion.height_unit", {}).get("heights") == ("US survey foot" if "6360" in crs else None)
    system = remarks["conversion.system"]["system"]
    assert (system == "EPSG:32611") == ("zone=11" in crs)
    assert "unknown" not in system
    raw = pytest.importorskip("pyogrio").raw
    if "km" in crs:
        with pytest.raises(InputError, match=r"32632.*geopackage\.other_unit"):
            write_format("gpkg", export, tmp_path / "a.gpkg")
        return
    write_format("gpkg", export, tmp_path / "a.gpkg")
    _, _, geometry, _ = raw.read(tmp_path / "a.gpkg", layer="points")
    points = np.array([struct.unpack("<BIddd", g)[2:] for g in geometry])
    np.testing.assert_allclose(np.sort(points, axis=0), np.sort(expected, axis=0), rtol=0, atol=1e-6)


@pytest.mark.parametrize("extent", [1e-3, 1e-6])
def test_small_objects_fit_into_las(extent, tmp_path):
    laspy, block = pytest.importorskip("laspy"), wall()
    xyz = 0.999 + extent * block.points.xyz
    small = replace(block, tables={}, length_unit="m", points=replace(block.points, xyz=xyz))
    write_format("las", Export(block=small), tmp_path / "a.las")
    np.testing.assert_allclose(laspy.read(tmp_path / "a.las").xyz, xyz, rtol=0, atol=0.51e-9)
