"""`raybundle convert`: between block and result folders and foreign formats, with what was assumed printed."""

import json
import shutil
import subprocess
import sys
from dataclasses import replace

import click
import numpy as np
import pytest
from tests.cli.reported import codes_of, reported, texts_of, values_of

import raybundle as rb
from raybundle import adjust
from raybundle.block import Distances, Role
from raybundle.cli.convert import command
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.block.scenes import local_in
from raybundle.io.formats import read_format
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, TargetField, aerial_scene, brown_camera, field_scene
from raybundle.report.write import write_result

LENS = {"K1": 3e-5, "K2": -4e-8, "K3": 0.0, "P1": 2e-6, "P2": -1e-6}
FIELD = TargetField(camera=brown_camera(values=LENS), stations=4, frontal=1, rows=4, columns=5)
SMALL = brown_camera(values=LENS | {"x0": 0.1}, size_px=(600, 400), pixel_mm=0.04)


def convert(*words):
    command.main([str(w) for w in words], standalone_mode=False)


def converted(capsys, *words):
    """What a conversion reports."""
    return reported(capsys, "convert", *words)


@pytest.fixture(scope="module")
def block():
    return simulate(field_scene(FIELD), Survey()).truth


@pytest.fixture
def folder(block, tmp_path):
    write_block(block, tmp_path / "b")
    return tmp_path / "b"


def test_there_and_back_by_the_command_line(folder, block, tmp_path, capsys):
    found = converted(capsys, folder, "--to", "colmap", "--out", tmp_path / "model")
    counts = {"images": 5, "points": len(block.points), "observations": len(block.observations)}
    assert values_of(found)["block.converted"] == {**counts, "formats": ["colmap"]}
    fitted = values_of(found, ["notes"])["conversion.camera_fitted"]
    assert fitted["model"] in {"OPENCV", "FULL_OPENCV"}
    assert 0 < values_of(found)["block.cameras_fitted"]["largest_px"] < 0.1
    convert(tmp_path / "model", "--to", "block", "--out", tmp_path / "again")
    again = read_block(tmp_path / "again")
    np.testing.assert_allclose(again.images.centre, block.images.centre, atol=1e-12)
    assert len(again.observations) == len(block.observations)
    assert adjust(again).sigma0 < 0.05


@pytest.mark.parametrize(
    ("target", "name", "named", "observed"),
    [("metashape", "c.xml", True, True), ("nerfstudio", "t.json", False, False), ("ply", "p.ply", False, False),
     ("opensfm", "r.json", False, True)],
)  # fmt: skip
def test_what_stands_in_the_file_is_counted(target, name, named, observed, block, folder, tmp_path, capsys):
    kept = block.points.role != Role.TIE if named else np.full(len(block.points), True)
    points, rows = int(kept.sum()), int(kept[block.observations.point].sum()) if observed else 0
    found = converted(capsys, folder, "--to", target, "--out", tmp_path / name)
    counts = values_of(found)["block.converted"]
    assert (counts["points"], counts["observations"]) == (points, rows)
    left = {"points": len(block.points) - points, "observations": len(block.observations) - rows}
    assert values_of(found).get("conversion.not_held") == (left if any(left.values()) else None)
    if observed:
        again = read_format(target, tmp_path / name).block
        assert (len(again.points), len(again.observations)) == (points, rows)


@pytest.mark.parametrize(
    ("target", "name"),
    [("opf", "p"), ("metashape", "c.xml"), ("nerfstudio", "t.json"), ("opensfm", "r.json"), ("colmap-text", "m")],
)
def test_inputs_are_recognised(target, name, folder, tmp_path, capsys):
    convert(folder, "--to", target, "--out", tmp_path / "x" / name)
    found = converted(capsys, tmp_path / "x" / name, "--to", "ply", "--out", tmp_path / "again.ply")
    assert values_of(found)["block.converted"]["images"] == 5
    assert (tmp_path / "again-stations.ply").is_file()


def test_a_result_gives_its_adjusted_values(tmp_path, capsys):
    plan = replace(FIELD, rows=7, columns=9, stations=8)
    given = simulate(field_scene(plan), Survey(gross_share=0.02, gross_px=50)).observed
    from raybundle import AdjustmentOptions

    result = adjust(given, AdjustmentOptions(reject="snooping"))
    write_result(result, tmp_path / "r", report="none")
    found = converted(capsys, tmp_path / "r", "--to", "ply", "--out", tmp_path / "p.ply")
    left_out = values_of(found, ["notes"])["conversion.rejected_observations"]
    assert left_out["n"] == (~result.image_observations.used).sum() > 0
    data = (tmp_path / "p.ply").read_bytes()
    head, _, body = data.partition(b"end_header\n")
    assert b"property float sigma_x" in head
    row = np.dtype([("xyz", "<f8", 3), ("rgb", "u1", 3), ("sigma", "<f4", 3), ("rays", "<i4")])
    vertices = np.frombuffer(body, row)
    np.testing.assert_allclose(vertices["xyz"], result.adjusted.points.xyz, atol=1e-12)
    np.testing.assert_allclose(vertices["sigma"], result.precision.object_point_std, rtol=1e-4)
    used = result.image_observations.used
    assert vertices["rays"].sum() == used.sum() < len(given.observations)


def flight():
    """A block whose coordinates stand in UTM zone 32."""
    block = simulate(aerial_scene(AerialStrips(images_per_strip=4, points_per_image=30)), Survey()).truth
    shift = np.array([500_000.0, 5_400_000.0, 400.0])
    return replace(
        block,
        images=replace(block.images, centre=block.images.centre + shift),
        points=replace(block.points, xyz=block.points.xyz + shift),
    )


def test_stations_on_a_map(tmp_path, capsys):
    write_block(flight(), tmp_path / "b")
    out = tmp_path / "s.geojson"
    found = converted(capsys, tmp_path / "b", "--to", "geojson", "--out", out, "--crs", "EPSG:32632")
    assert values_of(found, ["notes"])["conversion.local_frame"]["system"] == "EPSG:32632"
    assert "EPSG:32632+ellipsoid" in texts_of(found, ["notes"])
    stations = json.loads((tmp_path / "s.geojson").read_text())["features"]
    from pyproj import Transformer

    change = Transformer.from_crs("EPSG:4326", "EPSG:32632", always_xy=True)
    block = read_block(tmp_path / "b")
    for k, station in enumerate(stations):
        lon, lat, h = station["geometry"]["coordinates"]
        np.testing.assert_allclose(change.transform(lon, lat), block.images.centre[k, :2], atol=1e-4)
        assert h == pytest.approx(block.images.centre[k, 2], abs=1e-3)
        assert station["properties"]["nadir_deg"] < 10
    convert(tmp_path / "b", "--to", "kml", "--out", tmp_path / "s.kml", "--crs", "EPSG:32632")
    from raybundle.io.reading.xml import read_xml

    marks = list(read_xml(tmp_path / "s.kml", "kml").get("Document").all("Placemark"))
    assert len(marks) == len(stations)
    assert marks[0].get("Point", "coordinates").content.startswith("9.0")


def test_las_with_its_system(tmp_path):
    laspy = pytest.importorskip("laspy", reason="LAS needs the extra [las]")
    write_block(flight(), tmp_path / "b")
    convert(tmp_path / "b", "--to", "las", "--out", tmp_path / "p.las", "--crs", "EPSG:32632")
    cloud = laspy.read(tmp_path / "p.las")
    block = read_block(tmp_path / "b")
    np.testing.assert_allclose(cloud.xyz, block.points.xyz, atol=1e-3)
    assert cloud.header.parse_crs().to_epsg() == 32632


def test_las_without_its_extra_names_the_extra_and_no_temporary_path(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "laspy", None)
    write_block(flight(), tmp_path / "b")
    with pytest.raises(InputError, match=r"package\.laspy_missing") as told:
        convert(tmp_path / "b", "--to", "las", "--out", tmp_path / "p.las", "--crs", "EPSG:32632")
    assert ".partial" not in str(told.value)


@pytest.fixture
def photographs(tmp_path):
    """Photographs of a block: grey ramps, so that every pixel says where it lay."""
    from PIL import Image

    block = simulate(field_scene(replace(FIELD, camera=SMALL)), Survey()).truth
    names = tuple(f"{k}.png" for k in range(len(block.images)))
    block = replace(block, images=replace(block.images, file=names))
    (tmp_path / "photos").mkdir()
    x, y = np.meshgrid(np.arange(600), np.arange(400))
    pixels = np.stack([x * 255 / 599, y * 255 / 399, np.full(x.shape, 90)], axis=2)
    for name in names[1:]:
        Image.fromarray(np.rint(pixels).astype(np.uint8)).save(tmp_path / "photos" / name)
    write_block(block, tmp_path / "b")
    return block


def test_photographs_without_distortion(photographs, tmp_path, capsys):
    found = converted(
        capsys, tmp_path / "b", "--to", "colmap-text", "--out", tmp_path / "dense" / "sparse",
        "--photos", tmp_path / "photos", "--undistort", "inside",
    )  # fmt: skip
    assert values_of(found, ["notes"])["conversion.photograph_left_out"] == {"name": "0.png"}
    from PIL import Image

    cameras = (tmp_path / "dense" / "sparse" / "cameras.txt").read_text().split("\n")[1].split()
    assert cameras[1] == "PINHOLE"
    straight = np.asarray(Image.open(tmp_path / "dense" / "images" / "1.png")).astype(float)
    assert straight.shape[:2] == (int(cameras[3]), int(cameras[2]))
    # a pixel of the new image shows what its ray showed in the photograph
    from raybundle.io.pictures.undistort import undistorted

    change = undistorted(photographs.cameras[0])
    for row, column in ((5, 7), (200, 300), (380, 590)):
        expected = [(change.map_x[row, column] - 0.5) * 255 / 599, (change.map_y[row, column] - 0.5) * 255 / 399, 90]
        np.testing.assert_allclose(straight[row, column], expected, atol=1.5)
    assert straight[..., 2].min() >= 89


def test_points_take_their_colours_from_the_photographs(photographs, tmp_path):
    convert(tmp_path / "b", "--to", "ply", "--out", tmp_path / "p.ply", "--photos", tmp_path / "photos")
    body = (tmp_path / "p.ply").read_bytes().partition(b"end_header\n")[2]
    row = np.dtype([("xyz", "<f8", 3), ("rgb", "u1", 3), ("sigma", "<f4", 3), ("rays", "<i4")])
    o = photographs.observations
    seen = o.image > 0
    for k, colour in enumerate(np.frombuffer(body, row)["rgb"]):
        xy = o.xy_px[seen & (o.point == k)]
        assert colour[2] == 90
        assert abs(colour[0] - np.floor(xy[:, 0]).mean() * 255 / 599) < 1.5


def test_an_oriented_project_knows_where_its_photographs_are(photographs, tmp_path):
    folder = json.dumps(str(tmp_path / "photos"))
    (tmp_path / "project.toml").write_text(f'[orient]\nphotos = ["nowhere", {folder}]\n')
    convert(tmp_path / "b", "--to", "ply", "--out", tmp_path / "p.ply")
    body = (tmp_path / "p.ply").read_bytes().partition(b"end_header\n")[2]
    row = np.dtype([("xyz", "<f8", 3), ("rgb", "u1", 3), ("sigma", "<f4", 3), ("rays", "<i4")])
    assert np.all(np.frombuffer(body, row)["rgb"][:, 2] == 90)


def test_a_project_is_converted_as_its_result(free_and_fixed, tmp_path):
    project = tmp_path / "project"
    shutil.copytree(free_and_fixed / "fixed", project / "result")
    (project / "project.db").touch()
    convert(project, "--to", "colmap-text", "--out", tmp_path / "a", "--approximate")
    convert(free_and_fixed / "fixed", "--to", "colmap-text", "--out", tmp_path / "b", "--approximate")
    for file in sorted(p.name for p in (tmp_path / "b").iterdir()):
        assert (tmp_path / "a" / file).read_bytes() == (tmp_path / "b" / file).read_bytes()
    shutil.rmtree(project / "result")
    with pytest.raises(InputError, match=r"project\.no_result"):
        convert(project, "--to", "colmap", "--out", tmp_path / "c")


KILLED = """
import os, sys
import raybundle as rb
from raybundle.workflows import convert
convert.written = lambda *_, **__: os._exit(9)
rb.convert(sys.argv[1], sys.argv[2] + "/model", to="colmap", photos=sys.argv[3], undistort="inside")
"""


def test_pictures_and_model_are_written_together_or_not_at_all(photographs, tmp_path, monkeypatch):
    del photographs
    out = tmp_path / "new"
    out.mkdir()
    words = [sys.executable, "-c", KILLED, tmp_path / "b", out, tmp_path / "photos"]
    assert subprocess.run(words, check=False).returncode == 9
    assert [p.name for p in out.iterdir() if not p.name.startswith(".")] == []

    def refused(*_, **__):
        raise InputError("refused")

    words = ["--to", "colmap", "--out", out / "model", "--undistort", "inside", "--photos", tmp_path / "photos"]
    with monkeypatch.context() as m:
        m.setattr("raybundle.workflows.convert.written", refused)
        with pytest.raises(InputError, match="refused"):
            convert(tmp_path / "b", *words)
    assert list(out.iterdir()) == []
    convert(tmp_path / "b", *words)
    assert sorted(p.name for p in out.iterdir()) == ["images", "model"]


def test_of_several_formats_what_can_be_written_is(folder, tmp_path, capsys):
    block = rb.read_block(folder)
    placed = replace(block, place=local_in("EPSG:4326", (10.0, 50.0, 100.0)))
    rb.write_block(placed, tmp_path / "degrees")
    out = tmp_path / "delivery"
    found = reported(capsys, "convert", tmp_path / "degrees", "--to", "gpkg,dxf,las,ply", "--out", out, status=2)
    (failed,) = found["details"]
    assert "dxf" in json.dumps(failed)
    assert str(out.with_suffix(".gpkg")) in json.dumps(found["values"])
    for suffix, there in ((".gpkg", True), (".dxf", False), (".las", True), (".ply", True)):
        assert out.with_suffix(suffix).exists() == there


def test_a_file_gets_the_ending_of_its_format(folder, tmp_path):
    for name, file in (("plan", "plan.ply"), ("plan-1.2", "plan-1.2.ply"), ("own.ply", "own.ply")):
        done = rb.convert(folder, tmp_path / name, to="ply")
        assert done.written[0][1] == tmp_path / file
        assert (tmp_path / file).is_file()


CASES = {
    "stands there": (["{b}", "--to", "colmap", "--out", "{b}"], r"file\.read_by_command"),
    "no input": (["{b}x", "--to", "colmap", "--out", "{o}"], "no such file"),
    "not recognised": (["{b}/images.csv", "--to", "colmap", "--out", "{o}"], "not recognised"),
    "suffix": (["{b}", "--to", "kml", "--out", "{o}.txt", "--crs", "EPSG:32632"], "ends in .kml"),
    "no system": (["{b}", "--to", "kml", "--out", "{o}.kml"], "crs="),
    "origin alone": (
        ["{b}", "--to", "ply", "--out", "{o}.ply", "--frame-origin", "1", "2", "3"],
        r"crs\.needed_by_settings",
    ),
    "no photographs": (["{b}", "--to", "colmap", "--out", "{o}", "--undistort", "all"], "photos=FOLDER"),
    "wrong folder": (
        ["{b}", "--to", "colmap", "--out", "{o}", "--undistort", "all", "--photos", "{b}"],
        r"photograph\.none_readable",
    ),
    "system": (["{b}", "--to", "kml", "--out", "{o}.kml", "--crs", "EPSG:1"], r"crs\.unknown"),
}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_what_is_wrong_is_said_and_nothing_is_left(case, folder, tmp_path):
    words, message = case
    words = [w.format(b=folder, o=tmp_path / "out") for w in words]
    before = sorted(p.name for p in tmp_path.rglob("*"))
    with pytest.raises(InputError, match=message):
        convert(*words)
    assert sorted(p.name for p in tmp_path.rglob("*")) == before


def test_a_block_needs_observations(folder, tmp_path):
    convert(folder, "--to", "nerfstudio", "--out", tmp_path / "t.json")
    with pytest.raises(InputError, match="no image"):
        convert(tmp_path / "t.json", "--to", "block", "--out", tmp_path / "again")


# ---- a scale that nothing fixes


@pytest.fixture(scope="module")
def free_and_fixed(tmp_path_factory):
    """Results of the same observations without any length, and with one distance."""
    folder = tmp_path_factory.mktemp("scale")
    simulated = simulate(field_scene(replace(FIELD, rows=7, columns=9, stations=8)), Survey())
    given, xyz = simulated.observed, simulated.truth.points.xyz
    without = given.having(Distances.empty())
    write_block(without, folder / "free-block")
    write_result(adjust(without), folder / "free", report="none")
    a, b = np.array([0], np.int32), np.array([len(given.points) - 1], np.int32)
    length = np.linalg.norm(xyz[a] - xyz[b], axis=1)
    bar = Distances(start=a, end=b, length=length, sigma=np.array([1e-4]))
    write_result(adjust(without.having(bar)), folder / "fixed", report="none")
    return folder


def test_a_free_scale_is_called_free(free_and_fixed):
    """By the datum of the adjustment; a distance makes it fixed."""
    for name in ("free", "fixed"):
        contents = json.loads((free_and_fixed / name / "result.json").read_text())
        assert contents["scale"] == name
        assert ("scale" in contents["datum_defect"]) == (name == "free")
        assert read_block(free_and_fixed / name / "block").free_scale == (name == "free")
    head = (free_and_fixed / "free" / "block" / "block.toml").read_text()
    assert '\nscale = "free"\n' in head
    assert "scale =" not in (free_and_fixed / "fixed" / "block" / "block.toml").read_text()
    # what an adjustment says, not what stood in the block: a distance that is added later fixes the scale
    again = read_block(free_and_fixed / "free" / "block")
    bar = read_block(free_and_fixed / "fixed" / "block").distances
    write_result(adjust(again.having(bar)), free_and_fixed / "mended", report="none")
    assert not read_block(free_and_fixed / "mended" / "block").free_scale


def test_formats_in_metres_want_a_length(free_and_fixed, tmp_path, capsys):
    pytest.importorskip("laspy")
    for name in ("free", "free/block"):
        with pytest.raises(InputError, match=r"free_scale.*format\.free_scale"):
            convert(free_and_fixed / name, "--to", "las", "--out", tmp_path / "a.las")
    assert not (tmp_path / "a.las").exists()
    with pytest.raises(InputError, match=r"format\.free_scale"):
        convert(free_and_fixed / "free", "--to", "kml", "--out", tmp_path / "a.kml", "--crs", "EPSG:25832",
                "--frame-origin", "500000", "5400000", "100")  # fmt: skip
    free = converted(capsys, free_and_fixed / "free", "--to", "las", "--out", tmp_path / "a.las", "--free-scale")
    assert "conversion.free_scale" in codes_of(free, ["notes"])
    fixed = converted(capsys, free_and_fixed / "fixed", "--to", "las", "--out", tmp_path / "b.las")
    assert "conversion.free_scale" not in codes_of(fixed)


def test_exchange_formats_carry_a_free_scale(free_and_fixed, tmp_path, capsys):
    found = [converted(capsys, free_and_fixed / "free", "--to", "ply", "--out", tmp_path / "p.ply")]
    assert b'comment scale = "free"\n' in (tmp_path / "p.ply").read_bytes()
    found.append(converted(capsys, free_and_fixed / "free", "--to", "nerfstudio", "--out", tmp_path / "t.json"))
    assert json.loads((tmp_path / "t.json").read_text())["scale"] == "free"
    found.append(converted(capsys, free_and_fixed / "free", "--to", "colmap", "--out", tmp_path / "m"))
    assert all("conversion.free_scale" in codes_of(f, ["notes"]) for f in found)
    convert(free_and_fixed / "free", "--to", "block", "--out", tmp_path / "b")
    assert read_block(tmp_path / "b").free_scale
    convert(free_and_fixed / "fixed", "--to", "ply", "--out", tmp_path / "q.ply")
    assert b"comment" not in (tmp_path / "q.ply").read_bytes()


def test_a_scale_is_one_of_two_words(free_and_fixed, tmp_path):
    import shutil

    shutil.copytree(free_and_fixed / "free-block", tmp_path / "b")
    path = tmp_path / "b" / "block.toml"
    path.write_text(f'scale = "unknown"\n{path.read_text()}')
    with pytest.raises(InputError, match=r"value\.not_supported"):
        read_block(tmp_path / "b")


def test_a_table_is_no_format_and_where_it_is_is_said(tmp_path):
    (tmp_path / "block").mkdir()
    with pytest.raises(click.BadParameter, match=r"points\.csv"):
        convert(tmp_path / "block", "--to", "csv", "--out", tmp_path / "out")


def test_several_formats_are_files_that_begin_alike(tmp_path, capsys):
    pytest.importorskip("laspy", reason="LAS needs the extra [las]")
    write_block(flight(), tmp_path / "b")
    out = tmp_path / "pit"
    found = converted(capsys, tmp_path / "b", "--to", "las,ply", "--out", out, "--crs", "EPSG:32632")
    assert found["files"] == {name: f"{out}.{name}" for name in ("las", "ply")}
    assert (tmp_path / "pit.las").stat().st_size
    assert (tmp_path / "pit.ply").stat().st_size
    with pytest.raises(InputError, match=r"pit\.ply.*file\.exists"):
        rb.convert(tmp_path / "b", tmp_path / "pit", to="geojson,ply", crs="EPSG:32632")
    assert not (tmp_path / "pit.geojson").exists()
    with pytest.raises(InputError, match=r"export\.not_one_file"):
        rb.convert(tmp_path / "b", tmp_path / "other", to="colmap,ply")
    with pytest.raises(InputError, match=r"export\.not_one_file"):
        rb.convert(tmp_path / "b", tmp_path / "other", to="foo,ply")


def test_elements_passed_over_are_printed_and_data(tmp_path, capsys):
    head = {"w": 800, "h": 600, "fl_x": 400.0, "rolling_shutter": [0, 0, 0.03]}
    frames = [{"file_path": n, "mask_path": "m", "transform_matrix": np.eye(4).tolist()} for n in ("a", "b")]
    (tmp_path / "t.json").write_text(json.dumps({**head, "frames": frames}))
    given = tmp_path / "t.json"
    for to, out in (("nerfstudio", tmp_path / "again.json"), ("colmap", tmp_path / "m")):
        found = converted(capsys, given, "--to", to, "--out", out)
        kinds = ["2 frames.mask_path", "1 rolling_shutter"]
        assert values_of(found, ["notes"])["import.not_read"] == {"n": 3, "kinds": kinds}
        assert found["not_read"] == {"frames.mask_path": 2, "rolling_shutter": 1}
    own = converted(capsys, tmp_path / "again.json", "--to", "colmap", "--out", tmp_path / "own")
    assert "import.not_read" not in codes_of(own)


def test_blocks_and_results_in_memory_are_converted_as_their_folders(tmp_path):
    block = simulate(field_scene(FIELD), Survey(scale_bars=1)).observed
    result = adjust(block)
    for name, thing in (("block", block), ("result", result)):
        done = rb.convert(thing, tmp_path / f"{name}.ply", to="ply")
        assert [p for _, p in done.written] == [tmp_path / f"{name}.ply"]
    write_result(result, tmp_path / "folder", report="none")
    rb.convert(tmp_path / "folder", tmp_path / "of-folder.ply", to="ply")
    assert (tmp_path / "result.ply").read_bytes() == (tmp_path / "of-folder.ply").read_bytes()
    assert (tmp_path / "result.ply").read_bytes() != (tmp_path / "block.ply").read_bytes()
