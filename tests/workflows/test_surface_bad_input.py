"""A surface of what shows none, of what does not fit together, on a full disk, and in a folder that was used before."""

import errno
import hashlib
import json
import os
import re
import shutil
from dataclasses import replace

import cv2
import numpy as np
import pytest

from raybundle.block.select import select_block
from raybundle.cli.main import main
from raybundle.commands.surface import surface
from raybundle.errors import InputError, phrase
from raybundle.io.block.folder import read_block, write_block
from raybundle.measuring.session import adjusted_again
from raybundle.pipeline import store as stores
from raybundle.report.write import write_result
from raybundle.surfaces.files.heights import read_heights
from raybundle.surfaces.photographs import photographs_there
from raybundle.words import headline
from raybundle.workflows.photograph_contents import contents_of, other_contents
from tests.messages import failed

BOX = (-0.6, -0.4, 0.5, 0.5)


def picture(kind, shape, rng):
    """Grey values (h, w) of what shows the same in no two photographs."""
    h, w = shape
    sky = np.linspace(90, 200, h)[:, None] * np.ones((1, w)) + rng.normal(0, 1.5, shape)
    if kind == "sky":
        return sky
    sizes = {"water": ((3, 3, 12), (8, 8, 15), (30, 30, 20)), "swell": ((40, 6, 25),), "leaves": ((2, 2, 35),)}
    for down, across, strength in sizes[kind]:
        small = rng.normal(0, 1, (h // down + 2, w // across + 2))
        sky += strength * cv2.resize(small, (w, h), interpolation=cv2.INTER_CUBIC)
    return sky


@pytest.mark.parametrize(
    ("kind", "density"),
    [("sky", "4"), ("leaves", "4"), pytest.param("water", "2", marks=pytest.mark.long),
     pytest.param("swell", "2", marks=pytest.mark.long)],
)  # fmt: skip
def test_water_and_sky_are_no_surface(half, tmp_path, capsys, kind, density):
    rng = np.random.default_rng(5)
    for path in half.glob("*.png"):
        grey = picture(kind, cv2.imread(str(path)).shape[:2], rng)
        cv2.imwrite(str(tmp_path / path.name), np.clip(grey, 0, 255).astype(np.uint8))
    words = [
        "surface", str(half / "block"), "--photos", str(tmp_path), "--density", density, "--out", str(tmp_path / "s"),
    ]  # fmt: skip
    assert main([*words, "--jobs", "1", "--json"]) == 2
    found = failed(capsys)
    assert (found.code, found.values["region"]) == ("surface.nothing_measured", False)
    assert not (tmp_path / "s/points.ply").exists()


@pytest.mark.parametrize("kind", ["black", "other"])
def test_a_photograph_without_a_point_costs_itself_alone(half, tmp_path, capsys, kind):
    paths = sorted(half.glob("*.png"))
    for path in paths:
        cv2.imwrite(str(tmp_path / path.name), cv2.imread(str(path)))
    shape = cv2.imread(str(paths[1])).shape[:2]
    grey = np.zeros(shape) if kind == "black" else picture("leaves", shape, np.random.default_rng(6))
    cv2.imwrite(str(tmp_path / paths[1].name), np.clip(grey, 0, 255).astype(np.uint8))
    words = ["surface", str(half / "block"), "--photos", str(tmp_path), "--density", "4", "--out", str(tmp_path / "s")]
    assert main([*words, "--dsm", "0.03", "--jobs", "1"]) == 0, capsys.readouterr().err
    model, _ = read_heights(tmp_path / "s")
    assert model.known.sum() > 100
    assert len(np.unique(model.heights.image[model.known])) < 3
    w = model.known / model.known.sum()
    assert 0 < model.sum_of(w).orientation < 0.01


def test_photographs_without_overlap_are_named(half, tmp_path, capsys):
    block = read_block(half / "block")
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    few = np.isin(np.arange(len(rays)), np.flatnonzero(rays == 3)[::12][:10])  # hold the photographs, and no more
    write_block(select_block(block, "point", few), tmp_path / "block")
    words = ["surface", str(tmp_path / "block"), "--photos", str(half), "--out", str(tmp_path / "s"), "--free-scale"]
    assert main(words) != 0
    assert "[surface.no_pair]" in capsys.readouterr().err
    assert not (tmp_path / "s").exists()


def without_scale(block):
    """The block without all that fixes its scale."""
    p = block.points
    points = replace(p, role=np.zeros_like(p.role), sigma=np.full_like(p.sigma, np.nan))
    images = replace(block.images, held=np.zeros_like(block.images.held))
    return replace(block, points=points, images=images, tables={})


def test_what_is_adjusted_fixes_the_scale_whatever_a_folder_says(half, tmp_path):
    write_block(replace(read_block(half / "block"), free_scale=True), tmp_path / "block")
    done = surface(tmp_path / "block", tmp_path / "s", photos=(half,), density="4", jobs=1, extent=BOX)
    assert done.unit == "m"
    assert b"comment unit m" in done.points.read_bytes()[:2000]


def test_without_a_scale_metres_are_refused_and_products_say_so(half, tmp_path, capsys):
    pytest.importorskip("rasterio")
    pytest.importorskip("laspy")
    write_block(without_scale(read_block(half / "block")), tmp_path / "block")
    assert "free" not in (tmp_path / "block/block.toml").read_text()
    words = [
        "surface", str(tmp_path / "block"), "--photos", str(half), "--density", "4", "--dsm", "0.05", "--mesh", "0.1",
        "--las", "--extent", *map(str, BOX), "--out", str(tmp_path / "s"),
    ]  # fmt: skip
    assert main(words) == 2
    assert re.search(r"(?s)surface\.scale_free.*--free-scale", capsys.readouterr().err)
    assert not (tmp_path / "s").exists()
    assert main([*words, "--free-scale", "--jobs", "1", "--verbose"]) == 0
    shown = capsys.readouterr().out
    assert "scale arbitrary" in shown
    assert headline("product.las_without_unit", {}) in shown
    s = tmp_path / "s"
    assert b'comment scale = "free"' in (s / "points.ply").read_bytes()[:2000]
    assert b'comment scale = "free"' in (s / "mesh.ply").read_bytes()[:2000]
    assert 'scale = "free"' in (s / "heights.toml").read_text()
    assert "scale is free" in (s / "mesh.obj").read_text()[:200]


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        ({"extent": (0.0, 0.0, 0.001, 0.001)}, r"0\.001.*surface\.region_too_small"),
        ({"region": ("0 0, 1 1",)}, r"0.*1.*surface\.region_not_readable"),
        ({"region": ("",)}, r"surface\.region_not_readable"),
        ({"region": ("nan nan, 1 1, 0 1",)}, r"1.*0.*surface\.region_not_readable"),
        ({"region": ("1 0, 0 1, 0 0, 1 1",)}, r"1.*0.*surface\.region_invalid"),
        ({"region": ("nothing.geojson",)}, r"nothing\.geojson.*file\.missing"),
        ({"region": ("plan.geojson",)}, r"plan\.geojson.*EPSG.*25832.*outline\.heights_in_no_map"),
        ({"jobs": 10**9}, r"jobs = 1e\+09 .*1 024\..*\[setting\.too_large\]"),
    ],
)  # fmt: skip
def test_a_part_that_is_none_is_told_before_anything_is_measured(half, tmp_path, monkeypatch, asked, told):
    monkeypatch.chdir(tmp_path)
    ring = [[-0.3, -0.3], [0.3, -0.3], [0.3, 0.3], [-0.3, -0.3]]
    system = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::25832"}}
    feature = {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [ring]}}
    shapes = {"type": "FeatureCollection", "crs": system, "features": [feature]}
    (tmp_path / "plan.geojson").write_text(json.dumps(shapes))
    with pytest.raises(InputError, match=told):
        surface(half / "block", tmp_path / "s", photos=(half,), density="4", **asked)
    assert not (tmp_path / "s").exists()


def test_a_folder_without_a_result_is_told(half, tmp_path):
    with pytest.raises(InputError, match=r"result\.json.*block\.toml.*project\.db.*result\.none_in_folder"):
        surface(tmp_path, tmp_path / "s", photos=(half,))


def test_a_full_disk_is_told_and_what_is_finished_is_kept(half, tmp_path, capsys, monkeypatch):
    words = [
        "surface", str(half / "block"), "--photos", str(half), "--density", "4", "--extent", *map(str, BOX),
        "--out", str(tmp_path / "s"), "--jobs", "1",
    ]  # fmt: skip
    written, count = stores.write_archive, [0]

    def full(file, product):
        count[0] += "slopes" in product
        if count[0] > 1:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        written(file, product)

    monkeypatch.setattr(stores, "write_archive", full)
    assert main(words) == 2
    assert "[project.not_writable]" in capsys.readouterr().err
    monkeypatch.undo()
    kept = {p.name: p.stat().st_mtime_ns for p in tmp_path.glob("s/work/cache/*/depth map-*.npz")}
    assert len(kept) == 1
    assert not (tmp_path / "s/points.ply").exists()
    assert main(words) == 0
    after = {p.name: p.stat().st_mtime_ns for p in tmp_path.glob("s/work/cache/*/depth map-*.npz")}
    assert kept.items() < after.items()


@pytest.mark.long
def test_products_of_an_earlier_run_stay_while_they_are_of_the_same_points(half, tmp_path):
    pytest.importorskip("rasterio")

    def run(**more):
        return surface(
            half / "block", tmp_path / "s", photos=(half,), density="4", jobs=1, **{"extent": BOX, **more}
        )  # fmt: skip

    run(dsm=0.05, depths=True)
    names = {"heights.tif", "heights_sigma.tif", "heights.toml", "heights_orientation.npz"}
    left = tmp_path / "s/.heights_orientation.npz.2cfa3545.partial"
    left.mkdir()  # as a run leaves it that was killed while it wrote
    same = run()
    assert os.name == "nt" or not left.exists()
    kept = [m for r in same.remarks for m in getattr(r, "messages", ()) if m.code == "surface_remark.earlier"]
    assert names in [set(m.values["names"]) for m in kept]
    assert names <= {p.name for p in (tmp_path / "s").iterdir()}
    other = run(extent=(-0.5, -0.4, 0.5, 0.5), depths=True)
    gone = [m for r in other.remarks for m in getattr(r, "messages", ()) if m.code == "surface_remark.removed"]
    assert ("heights_orientation.npz", "dsm") in [(m.values["names"][-1], m.values["setting"]) for m in gone]
    there = {p.name for p in (tmp_path / "s").iterdir()}
    assert not names & there
    assert any(n.startswith("depth") for n in there)
    shutil.rmtree(tmp_path / "s/work")
    assert any("depth" in r and "removed" in r for r in run().remarks)
    with pytest.raises(InputError, match=r"region=.*extent=.*option\.exclusive"):
        run(region=("0 0, 1 0, 1 1",))


def test_a_photograph_without_a_point_is_told_where_nothing_confirms_it(half, tmp_path, capsys):
    words = ["surface", str(half / "block"), "--density", "4", "--jobs", "1", "--photos"]
    rng = np.random.default_rng(5)
    for path in half.glob("*.png"):
        shown = cv2.imread(str(path))
        if path.stem == "portal_08":
            shown = np.clip(picture("leaves", shown.shape[:2], rng), 0, 255).astype(np.uint8)
        cv2.imwrite(str(tmp_path / path.name), shown)
    assert main([*words, str(tmp_path), *map(str, ("--extent", *BOX)), "--verbose", "--out", str(tmp_path / "s")]) == 0
    (line,) = [x for x in capsys.readouterr().out.splitlines() if "portal_08: " in x]
    begins = (
        headline("surface_remark.too_few_confirmed", {"share": 0.0, "needed": 0.0}).split("0")[0],
        headline("surface_remark.no_depth", {"region": True}),
    )
    assert line.partition("portal_08: ")[2].startswith(begins)


def without(half, folder, gone):
    """The photographs without some of them."""
    folder.mkdir()
    for path in sorted(half.glob("*.png"))[gone:]:
        shutil.copy(path, folder)
    return sorted(p.name for p in half.glob("*.png"))[:gone]


def test_photographs_that_are_gone_are_named(half, tmp_path, capsys):
    names = without(half, tmp_path / "photos", 2)
    words = ["surface", str(half / "block"), "--photos", str(tmp_path / "photos"), "--out", str(tmp_path / "s")]
    assert main(words) == 2
    stated = capsys.readouterr().err
    assert "[surface.too_few_photographs]" in stated
    assert phrase("surface.photographs_lost", n=2, photographs=3).message.headline() in stated
    assert f"{', '.join(names)}: {phrase('photograph.in_no_folder')}" in stated
    assert "--photos" in stated
    assert phrase("depths.no_common_points") not in stated
    assert not (tmp_path / "s").exists()


def test_a_surface_without_some_photographs_says_so_first(half, tmp_path, capsys):
    (name,) = without(half, tmp_path / "photos", 1)
    words = ["surface", str(half / "block"), "--photos", str(tmp_path / "photos"), "--out", str(tmp_path / "s")]
    assert main([*words, "--density", "4", "--jobs", "1", "--extent", *map(str, BOX), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    (gone,) = [w for w in found["warnings"] if w["code"] == "surface.photographs_lost"]
    assert gone["values"] == {"n": 1, "photographs": 3}
    assert [d["place"]["file"] for d in gone["details"]] == [name]
    page = (tmp_path / "s/surface.html").read_text()
    assert phrase("report_surface.photographs_lost", n=1) in page
    assert f"{name}: {phrase('photograph.in_no_folder')}" in page


def test_lost_photographs_are_told_where_the_others_show_nothing_together(half, tmp_path, capsys):
    block = read_block(half / "block")
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    few = np.isin(np.arange(len(rays)), np.flatnonzero(rays == 3)[::12][:10])
    write_block(select_block(block, "point", few), tmp_path / "block")
    (name,) = without(half, tmp_path / "photos", 1)
    words = ["surface", str(tmp_path / "block"), "--photos", str(tmp_path / "photos"), "--free-scale"]
    assert main([*words, "--out", str(tmp_path / "s")]) == 2
    stated = capsys.readouterr().err
    assert "[surface.no_pair]" in stated
    assert phrase("surface.photographs_lost", n=1, photographs=3).message.headline() in stated
    assert f"{name}: {phrase('photograph.in_no_folder')}" in stated


def with_contents(half, folder):
    """A result that knows what its photographs hold."""
    known = {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in half.glob("*.png")}
    write_result(adjusted_again(half / "block"), folder, report="none", additions={"photographs_sha256": known})
    return folder


def test_photographs_under_the_names_of_others_are_the_first_reason(half, tmp_path, capsys):
    paths = sorted(half.glob("*.png"))
    (tmp_path / "photos").mkdir()
    for k, path in enumerate(paths):
        shutil.copy(paths[(k + 1) % 3], tmp_path / "photos" / path.name)
    words = [
        "surface", str(with_contents(half, tmp_path / "r")), "--photos", str(tmp_path / "photos"), "--density", "4",
    ]  # fmt: skip
    assert main([*words, "--jobs", "1", "--extent", *map(str, BOX), "--json"]) == 2
    found = failed(capsys)
    assert (found.code, found.values["region"]) == ("surface.other_photographs", True)
    assert f"{paths[0].name}: {paths[1].name}" in found.text()


@pytest.mark.long
def test_photographs_with_other_bytes_are_told_and_used(half, tmp_path, capsys):
    """As after other metadata were written into them."""
    (tmp_path / "photos").mkdir()
    for path in half.glob("*.png"):
        shutil.copy(path, tmp_path / "photos")
    other = tmp_path / "photos/portal_02.png"
    cv2.imwrite(str(other), cv2.imread(str(other)), [cv2.IMWRITE_PNG_COMPRESSION, 1])
    source = with_contents(half, tmp_path / "r")
    words = ["surface", str(source), "--photos", str(tmp_path / "photos"), "--density", "4", "--jobs", "1"]
    assert main([*words, "--extent", *map(str, BOX)]) == 0
    (line,) = [x for x in capsys.readouterr().out.splitlines() if x.endswith("[surface.photographs_replaced]")]
    assert "portal_02.png" in line
    shown = line.removeprefix("warning: ").partition(" [")[0]
    assert shown in (source / "surface/surface.html").read_text()
    as_they_were, _ = photographs_there(read_block(half / "block"), [half])
    assert not other_contents(as_they_were.values(), contents_of(source))
