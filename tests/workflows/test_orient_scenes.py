"""Satellite scenes to an oriented block: right, stopped and continued, with photographs, and with wrong RPCs."""

import csv
import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from scipy.stats import chi2

from raybundle.cli.main import main
from raybundle.errors import InputError, phrase
from raybundle.io.block.folder import read_block
from raybundle.io.scenes import Scene
from raybundle.io.scenes.rpc_text import write_rpc_text
from raybundle.scenes.simulate import OrbitPlan, orbit_scene
from raybundle.workflows.orient import OrientOptions, orient
from raybundle.workflows.scenes import block as scene_block
from raybundle.workflows.scenes import ties as scene_ties
from tests.messages import failed
from tests.scenes.render import ORIGIN, PLACE, Terrain, render_scene, scene_rpc
from tests.scenes.render_sets import MARK_PX, PITCH, SHIFTS, Made, make_photos, make_scenes, write_control

COUNT = 1500
SIZE = 950


def command(folder, out, *more):
    options = ["--feature-count", str(COUNT), "--jobs", "2", "--no-report", "--mark-sigma", str(MARK_PX)]
    return ["orient", str(folder), "--out", str(out), *options, *more]


@pytest.fixture(scope="module")
def terrain():
    return Terrain.made(half=900.0)


@pytest.fixture(scope="module")
def three(tmp_path_factory, terrain):
    """Three scenes in a folder."""
    folder = tmp_path_factory.mktemp("three")
    return folder, make_scenes(folder, ("ahead", "behind", "nadir"), terrain, SIZE)


@pytest.fixture(scope="module")
def pair(tmp_path_factory, three):
    """Two of them, with three control points and twelve check points."""
    folder = tmp_path_factory.mktemp("pair")
    take(three[0], folder, "ahead", "behind")
    made = Made(three[1].terrain, rpcs={n: three[1].rpcs[n] for n in ("ahead", "behind")})
    control = write_control(tmp_path_factory.mktemp("control") / "gcp.csv", made)
    return folder, control, made


@pytest.fixture(scope="module")
def done(pair, tmp_path_factory):
    folder, control, _ = pair
    out = tmp_path_factory.mktemp("pair") / "project"
    assert main(command(folder, out, "--control", str(control))) == 0
    return out


@pytest.fixture
def project(done, tmp_path):
    return Path(shutil.copytree(done, tmp_path / done.name))


def told(project):
    return json.loads((project / "result/result.json").read_text())


def take(source, folder, *names):
    """Copy scenes with their RPCs."""
    for name in names:
        for file in source.glob(f"{name}*"):
            shutil.copy(file, folder)


def numbers(project):
    result = told(project)
    return {k: v for k, v in result.items() if k not in {"seconds", "stages"}}


def rows(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def table(path, *names):
    return np.array([[float(r[n]) for n in names] for r in rows(path)])


def check_points_are_inside(project):
    found = table(project / "result/check.csv", "dX", "dY", "dZ", "sX", "sY", "sZ")
    assert len(found) == 12
    square = (found[:, :3] / found[:, 3:]) ** 2
    # the differences of one set are correlated through the shifts: the limit is that of a single point, for each
    assert square.sum(axis=1).max() < chi2(3).isf(0.001 / 12)
    assert square.mean() < 3


def shifts_are_found(project, limit=4.5, std=0.5):
    cameras = told(project)["cameras"]
    for name, shift in SHIFTS.items():
        if f"{name}.tif" not in cameras:
            continue
        for symbol, true in zip(("A0", "B0"), shift, strict=True):
            p = cameras[f"{name}.tif"][symbol]
            assert p["std"] < std
            assert abs(p["value"] - true) < limit * p["std"]


def test_the_pair_is_right(done):
    result = told(done)
    assert result["images"] == {"given": 2, "oriented": 2, "not_oriented": []}
    assert result["image_sigma_px"] < 0.3
    assert result["sigma0"] == pytest.approx(1.0, abs=0.15)
    assert result["frame"]["crs"] == "EPSG:4979"
    assert sum(r["role"] == "tie" for r in rows(done / "result/points.csv")) > 300
    check_points_are_inside(done)
    shifts_are_found(done)


def test_the_result_is_a_block_that_can_be_adjusted_again(done, tmp_path):
    block = read_block(done / "result/block")
    assert [c.model for c in block.cameras] == ["rpc", "rpc"]
    assert main(["adjust", str(done / "result/block"), "--out", str(tmp_path / "again"), "--no-report"]) == 0
    again = json.loads((tmp_path / "again/result.json").read_text())
    assert again["cameras"]["ahead.tif"]["A0"]["value"] == pytest.approx(
        told(done)["cameras"]["ahead.tif"]["A0"]["value"], abs=0.02
    )


def test_a_second_run_is_taken_from_the_cache(project, pair):
    before = numbers(project)
    assert main(command(pair[0], project, "--control", str(pair[1]))) == 0
    cached = [s["name"] for s in told(project)["stages"] if s["from_cache"]]
    assert cached == ["features", "matching", "start", "precision"]
    assert numbers(project) == before


def test_a_stage_can_be_done_again(project, pair):
    assert main(command(pair[0], project, "--control", str(pair[1]), "--from-stage", "precision")) == 0
    cached = [s["name"] for s in told(project)["stages"] if s["from_cache"]]
    assert cached == ["features", "matching", "start"]
    shifts_are_found(project)


def test_a_killed_run_continues_and_leaves_nothing_behind(project, pair, monkeypatch):
    before = numbers(project)
    for path in (*project.glob("cache/*/scene_precision-*.npz"), *project.glob("cache/*/scene_start-*.npz")):
        path.unlink()
    left = project / "cache/00/.pixels-a1b2c3d4"
    left.mkdir(parents=True)
    monkeypatch.setattr(scene_block, "refine", lambda *_: (_ for _ in ()).throw(KeyboardInterrupt))
    assert main(command(pair[0], project, "--control", str(pair[1]))) == 130
    monkeypatch.undo()
    assert not left.exists()
    assert main(command(pair[0], project, "--control", str(pair[1]))) == 0
    assert numbers(project) == before
    assert not list(project.glob("cache/*/.*"))


def test_a_scene_that_is_added_is_matched_alone(project, three, monkeypatch):
    count = {"features": 0, "pairs": 0}

    def counting(module, name, key):
        original = getattr(module, name)

        def counted(*arguments, **options):
            count[key] += 1
            return original(*arguments, **options)

        monkeypatch.setattr(module, name, counted)

    counting(scene_ties, "scene_features", "features")
    counting(scene_ties, "matched", "pairs")
    result = orient([three[0]], project, OrientOptions(feature_count=COUNT, jobs=2, precise=False))
    assert count == {"features": 1, "pairs": 2}
    assert result.oriented_scenes == 3
    assert result.adjustment.given.ray_count.max() == 3


def quick(folder, out, capsys, *more):
    """The error of a command, and its exit status."""
    status = main([*command(folder, out, *more), "--quick", "--json"])
    return status, failed(capsys)


@pytest.fixture
def damaged(pair, tmp_path):
    return Path(shutil.copytree(pair[0], tmp_path / "damaged"))


WRONG = {
    "that of another scene": (lambda: scene_rpc(PITCH["nadir"], SIZE), "scene.pair_scattered", {}),
    "another place": (
        lambda: scene_rpc(PITCH["ahead"], SIZE).shifted(np.array([90.0, 0])),
        "scene.pair_shifted",
        {"times": 4},
    ),
    "another height": (
        lambda: scene_rpc(PITCH["ahead"], SIZE).shifted(np.array([0, 700.0])),
        "scene.pair_height",
        {"low_m": 100, "high_m": 500},
    ),
}


@pytest.mark.parametrize(("rpc", "code", "values"), WRONG.values(), ids=WRONG)
def test_an_rpc_of_another_image_is_noticed_before_the_adjustment(damaged, project, capsys, rpc, code, values):
    write_rpc_text(rpc(), damaged / "ahead_RPC.TXT")
    status, found = quick(damaged, project, capsys)
    assert (status, found.code) == (2, "scene.pair_contradicts")
    assert found.values == {"first": "ahead.tif", "second": "behind.tif"}
    (why,) = found.details
    assert why.code == code
    assert values.items() <= why.values.items()


def test_an_image_of_another_size_is_refused(damaged, tmp_path, capsys):
    write_rpc_text(scene_rpc(PITCH["ahead"], 8 * SIZE), damaged / "behind_RPC.TXT")
    write_rpc_text(scene_rpc(PITCH["ahead"], SIZE // 8), damaged / "ahead_RPC.TXT")
    status, found = quick(damaged, tmp_path / "project", capsys)
    assert status == 2
    (why,) = (d.values for d in found.details if d.code == "rpc.other_image")
    covered = [why[f"{which}_{axis}"] for axis in ("column", "row") for which in ("first", "last")]
    assert covered == [0, SIZE // 8, 0, SIZE // 8]


def test_control_that_contradicts_a_scene_is_noticed(pair, damaged, project, capsys):
    write_rpc_text(scene_rpc(PITCH["ahead"], SIZE).shifted(np.array([0, 90.0])), damaged / "ahead_RPC.TXT")
    status, found = quick(damaged, project, capsys, "--control", str(pair[1]))
    assert (status, found.code, Path(found.place.file).name) == (2, "scene.control_shifted", "ahead.tif")
    assert (found.values["n"], found.values["model"]) == (3, "ahead_RPC.TXT")
    assert (found.values["dx_px"], found.values["dy_px"]) == pytest.approx((0, -90), abs=0.5)


def test_control_without_a_system_asks_for_it(pair, tmp_path, capsys, project):
    control = tmp_path / "plane.csv"
    control.write_text("point,X,Y,Z\nA,500000,5316000,300\nB,500100,5316000,300\n")
    status, found = quick(pair[0], project, capsys, "--control", str(control))
    assert (status, found.code) == (2, "scene.control_without_system")
    assert found.values["longitude_deg"] == pytest.approx(15, abs=1e-3)


def test_control_in_a_projected_system(pair, tmp_path, project):
    from pyproj import Transformer

    to_utm = Transformer.from_crs("EPSG:4979", "EPSG:32633", always_xy=True)
    lines = rows(pair[1])
    with (tmp_path / "utm.csv").open("w") as file:
        file.write("point,X,Y,Z,sX,sY,sZ,role\n")
        for r in lines:
            x, y = to_utm.transform(float(r["X"]), float(r["Y"]))
            file.write(f"{r['point']},{x:.4f},{y:.4f},{r['Z']},{r['sX']},{r['sY']},{r['sZ']},{r['role']}\n")
    shutil.copy(pair[1].with_name("gcp-measurements.csv"), tmp_path / "utm-measurements.csv")
    before = told(project)["cameras"]
    assert main(command(pair[0], project, "--control", str(tmp_path / "utm.csv"), "--crs", "EPSG:32633")) == 0
    assert told(project)["frame"]["crs"] == "EPSG:32633"
    for name, parameters in told(project)["cameras"].items():
        for symbol, p in parameters.items():
            assert p["value"] == pytest.approx(before[name][symbol]["value"], abs=0.02)


def test_without_control_the_vendors_accuracy_is_that_of_the_points(pair, tmp_path):
    result = orient([pair[0]], tmp_path / "free", OrientOptions(feature_count=600, jobs=2))
    std = result.adjustment.precision.object_point_std
    assert result.adjustment.datum == "control"
    assert 3 < np.median(std[:, 0]) < 12  # metres; ERR_BIAS is 8


def test_scenes_without_anything_in_common(pair, project, tmp_path, capsys):
    folder = tmp_path / "apart"
    folder.mkdir()
    shutil.copy(pair[0] / "ahead.tif", folder)
    shutil.copy(pair[0] / "behind.tif", folder)
    far = scene_rpc(PITCH["ahead"], SIZE)
    moved = {**{f: getattr(far, f) for f in far.__slots__}, "ground_offset": far.ground_offset + np.array([1.0, 0, 0])}
    write_rpc_text(type(far)(**moved), folder / "ahead_RPC.TXT")
    status, found = quick(folder, project, capsys)
    assert (status, found.code, found.values) == (3, "scene.no_tie_points", {"n": 2, "pairs": 0})
    (middle,) = (d.values for d in found.details if d.values["scene"] == "ahead.tif")
    assert (middle["longitude_deg"], middle["latitude_deg"]) == pytest.approx((16, 48), abs=5e-4)


def test_an_empty_rpc_costs_its_scene(pair, tmp_path, capsys):
    folder = tmp_path / "empty"
    folder.mkdir()
    take(pair[0], folder, "ahead", "behind")
    (folder / "ahead_RPC.TXT").write_text("")
    status, found = quick(folder, tmp_path / "project", capsys)
    assert (status, found.code) == (2, "scene.single")
    assert [(d.place.file, d.code.partition(".")[2]) for d in found.details] == [("ahead.tif", "empty")]


def test_control_whose_coordinates_are_exchanged(pair, tmp_path, project, capsys):
    text = rows(pair[1])
    with (tmp_path / "gcp.csv").open("w") as file:
        file.write("point,X,Y,Z,sX,sY,sZ,role\n")
        file.writelines(f"{r['point']},{r['Y']},{r['X']},{r['Z']},0.1,0.1,0.1,{r['role']}\n" for r in text)
    shutil.copy(pair[1].with_name("gcp-measurements.csv"), tmp_path)
    crs = ("--crs", "EPSG:4979")
    status, found = quick(pair[0], project, capsys, "--control", str(tmp_path / "gcp.csv"), *crs)
    assert (status, found.code, Path(found.place.file).name) == (2, "scene.control_far_away", "ahead.tif")
    (why,) = found.details
    assert (why.values["n"], why.values["total"], why.values["exchanged"]) == (3, 3, True)


def test_heights_above_a_geoid_whose_grid_is_missing(pair, project, capsys, monkeypatch):
    from raybundle.io.geo import coordinate_systems

    monkeypatch.setattr(coordinate_systems, "_vertical", lambda _: (None, "some_geoid.tif"))
    status, found = quick(pair[0], project, capsys, "--control", str(pair[1]), "--crs", "EPSG:4326+5773")
    assert (status, found.code, found.values["grid"]) == (2, "crs.geoid_missing", "some_geoid.tif")


@pytest.mark.long
def test_photographs_and_scenes_in_one_project(tmp_path, project, three):
    """Three scenes and four photographs, joined by control that is marked in both and by common points."""
    folder = tmp_path / "mixed"
    folder.mkdir()
    made = Made(three[1].terrain, rpcs=three[1].rpcs)
    take(three[0], folder, "ahead", "behind", "nadir")
    make_photos(folder, made, 4, size=(630, 490))
    control = write_control(tmp_path / "gcp.csv", made, control=4, half=300.0)
    out = project  # where two of the scenes are matched already
    assert main(command(folder, out, "--control", str(control))) == 0
    result = told(out)
    assert result["images"] == {"given": 7, "oriented": 7, "not_oriented": []}
    assert result["components"] == 1
    assert any(n["code"] == "scene_joins" for n in result["warnings"])
    shifts_are_found(out)
    check_points_are_inside(out)
    assert result["frame"]["origin"][:2] == pytest.approx([15.0, 48.0], abs=0.01)
    photographs_are_found(out, made)


def photographs_are_found(project, made):
    """Projection centres within their standard deviations."""
    placed = {r["file"]: r for r in rows(project / "result/images.csv")}
    for name, view in made.views.items():
        found = np.array([float(placed[name][k]) for k in "XYZ"])
        std = np.array([float(placed[name][f"s{k}"]) for k in "XYZ"])
        true = local(told(project)["frame"]["origin"], view.centre)
        assert (np.abs(found - true) < 5 * std + 0.05).all()


def local(origin, xyz):
    """Local coordinates at another origin."""
    from raybundle.numerics.places import Local
    from tests.scenes.render import PLACE

    return Local(origin=tuple(origin)).block_from_geographic(PLACE.geographic_from_block(xyz[None]))[0]


@pytest.fixture(scope="module")
def single(tmp_path_factory, three):
    """One scene and two photographs."""
    folder = tmp_path_factory.mktemp("single")
    take(three[0], folder, "ahead")
    made = Made(three[1].terrain, rpcs={"ahead": three[1].rpcs["ahead"]})
    make_photos(folder, made, 4, of=(1, 2))
    return folder, made, tmp_path_factory.mktemp("single") / "project"


@pytest.mark.parametrize(("control", "check"), [(4, 3), (2, 0)])
def test_one_scene_and_two_photographs(tmp_path, single, control, check):
    """Two of the control points show in both photographs, the others in one; two alone leave a turn to the scene."""
    folder, made, out = single
    file = write_control(tmp_path / "gcp.csv", made, control=control, check=check, half=300.0)
    assert main(command(folder, out, "--control", str(file))) == 0
    result = told(out)
    assert result["images"]["oriented"] == 3
    assert result["components"] == 1
    photographs_are_found(out, made)
    shifts_are_found(out)


def test_a_scene_that_nothing_joins_is_left_out(single, capsys):
    folder, _, out = single
    assert main(command(folder, out)) == 0
    result = told(out)
    assert result["images"]["oriented"] == 2
    assert result["images"]["not_oriented"][0]["file"] == "ahead.tif"
    assert result["images"]["not_oriented"][0]["code"] == "not_oriented.not_joined"
    assert phrase("summary.scenes", oriented=0, of=1) in capsys.readouterr().out


@pytest.mark.long
def test_rigorous_scenes_without_an_rpc(terrain, tmp_path, monkeypatch):
    """The geometry is that of an orbit; its attitude is corrected."""
    lines = {
        n: orbit_scene(OrbitPlan(target=ORIGIN, pitch_deg=p, width_px=700, height_px=700)) for n, p in PITCH.items()
    }
    folder = tmp_path / "lines"
    folder.mkdir()
    for k, name in enumerate(("ahead", "behind")):
        pixels = render_scene(lines[name], terrain, 700, seed=k)
        Image.fromarray(pixels).save(folder / f"{name}.tif")
        write_rpc_text(scene_rpc(PITCH[name], SIZE), folder / f"{name}_RPC.TXT")
    monkeypatch.setattr(
        "raybundle.workflows.scenes.images.read_scene",
        lambda path: Scene(file=path, format="orbit", rigorous=lines[path.name.split("_")[0]]),
    )
    result = orient([folder], tmp_path / "project", OrientOptions(feature_count=700, jobs=2))
    assert [c.model for c in result.adjustment.given.cameras] == ["linescan", "linescan"]
    assert result.adjustment.given.cameras[0].estimate[:2] == ("rx0", "ry0")
    assert result.sigma_px < 0.1
    used = result.adjustment.precision.object_point_std
    # the attitude is known to 12 m on the ground, in both scenes
    assert 4 < np.nanmedian(used[:, 0]) < 16  # points that were left out have none
    truth = terrain.points(*PLACE.block_from_geographic(geographic(result)).T[:2])
    error = PLACE.block_from_geographic(geographic(result)) - truth
    assert np.isfinite(used[:, 0]).mean() > 0.9
    assert np.abs(np.median(error[:, 2])) < np.nanmedian(used[:, 2])
    assert np.std(error[:, 2]) < 0.2
    assert "scene_prior.orbit" in {n.data.code for n in result.adjustment.notices}


def geographic(result):
    """Longitude, latitude, height of the tie points, whatever the frame."""
    return result.adjustment.given.place.geographic_from_block(result.adjustment.adjusted.points.xyz)


def test_one_scene_alone_is_too_little(pair, tmp_path):
    with pytest.raises(InputError, match=r"scene\.single"):
        orient([pair[0] / "ahead.tif"], tmp_path / "one")


def test_corrected_rpcs_and_points_can_be_taken_elsewhere(done, pair, tmp_path, capsys):
    from raybundle.io.scenes import read_scene

    assert main(["convert", str(done / "result"), "--to", "rpc", "--out", str(tmp_path / "rpc")]) == 0
    cameras = told(done)["cameras"]
    for name, true in pair[2].rpcs.items():
        rpc = read_scene(tmp_path / f"rpc/{name}_RPC.TXT").rpc
        given = true.shifted(-np.array(SHIFTS[name]))
        shift = [cameras[f"{name}.tif"][s]["value"] for s in ("A0", "B0")]
        ground = given.localise(np.array([[300.0, 400.0]]), 320.0)
        np.testing.assert_allclose(rpc.project(ground), given.project(ground) + shift, atol=1e-6)
        # ERR_BIAS is what the adjustment says of the shift, on the ground
        std = [cameras[f"{name}.tif"][s]["std"] for s in ("A0", "B0")]
        gsd = np.linalg.norm(given.pixel_on_ground(), axis=1)
        assert rpc.err_bias_m == pytest.approx(np.sqrt(np.mean((std * gsd) ** 2)), rel=0.05)
        assert rpc.err_rand_m == given.err_rand_m
    assert main(["convert", str(done / "result"), "--to", "ply", "--out", str(tmp_path / "points.ply")]) == 0
    pyogrio = pytest.importorskip("pyogrio")
    assert main(["convert", str(done / "result"), "--to", "gpkg", "--out", str(tmp_path / "points.gpkg")]) == 0
    assert pyogrio.read_info(tmp_path / "points.gpkg", layer="points")["features"] > 0
    assert pyogrio.read_info(tmp_path / "points.gpkg", layer="stations")["features"] == 0  # 600 km up
    assert "footprints" not in [name for name, _ in pyogrio.list_layers(tmp_path / "points.gpkg")]
    assert main(["convert", str(done / "result"), "--to", "block", "--out", str(tmp_path / "block")]) == 0
    assert [c.values["A0"] for c in read_block(tmp_path / "block").cameras] == [0, 0]  # what was observed
    capsys.readouterr()
    for target in ("colmap", "bingo", "metashape", "kml"):
        out = tmp_path / f"out{ {'metashape': '.xml', 'kml': '.kml'}.get(target, '') }"
        assert main(["convert", str(done / "result"), "--to", target, "--out", str(out)]) == 2
        assert re.search(f"Format {target} .*format.no_scenes", capsys.readouterr().err)
        assert not out.exists()
