"""What is written of a surface, beside photographs and known points: three of the portal, half size."""

import json
from dataclasses import replace

import cv2
import numpy as np
import pytest
import trimesh
from scipy.spatial import KDTree

from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import PixelFrame
from raybundle.commands.surface import surface
from raybundle.errors import InputError, phrase
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.formats import las as las_format
from raybundle.io.formats.las import steps_for
from raybundle.io.reading.trees import read_toml
from raybundle.surfaces import product_grids
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.orthophoto_files import tiles_of
from tests.messages import coded, refused
from tests.workflows.half_portal import PORTAL

rasterio = pytest.importorskip("rasterio")
laspy = pytest.importorskip("laspy")
CELL, PIXEL, MESH, SIDE = 0.05, 0.02, 0.1, 0.1
WINDOW = (-0.2, -0.2, 0.2, 0.2)
ASKED = {"density": "4", "dsm": CELL, "ortho": PIXEL, "mesh": MESH, "las": True, "depths": True}


@pytest.fixture(scope="module")
def made(half, copy_of_surface, tmp_path_factory):
    """All products."""
    out = copy_of_surface(tmp_path_factory.mktemp("made") / "s")
    return surface(half / "block", out, photos=(half,), jobs=1, **ASKED), out


@pytest.fixture(scope="module")
def cloud(made):
    return np.concatenate([c.xyz for c in made[0].surface.parts()])


def test_all_are_written_and_told(made):
    done, _ = made
    names = [name for name, _ in done.written]
    assert names == ["", "depths", "dsm", "las", "mesh", "ortho"]
    for _, w in done.written:
        assert all(f.exists() for f in w.files)
    found = {name: coded(w.reported) for name, w in done.written}
    plan = found["ortho"]["product.orthophoto_sigma"]
    assert (
        plan["unit"] == found["dsm"]["product.heights"]["sigma_unit"] == found["mesh"]["product.mesh"]["unit"] == "mm"
    )
    assert 0 < plan["median"] < plan["most"]
    assert found["dsm"]["product.heights"]["sigma"] > 0
    assert found["mesh"]["product.mesh"]["sigma"] > 0
    assert 0 < found["ortho"]["product.orthophoto_gaps"]["share"] < found["ortho"]["product.orthophoto"]["share"]
    assert "3 depth maps" in " ".join(done.written[1][1].reported)


@pytest.mark.long
def test_a_file_that_is_stored_turned_gives_the_same_orthophoto(made, half, tmp_path):
    block = read_block(half / "block")
    k, camera = 0, block.cameras[0]
    for i, name in enumerate(block.images.file):
        picture = cv2.imread(str(half / name))
        cv2.imwrite(str(tmp_path / name), cv2.rotate(picture, cv2.ROTATE_180) if i == k else picture)
    frame = PixelFrame(turned=180, width_px=camera.width_px, height_px=camera.height_px)
    write_block(replace(block, images=replace(block.images, frames={k: frame})), tmp_path / "block")
    done = surface(tmp_path / "block", tmp_path / "s", photos=(tmp_path,), jobs=1, density="4", dsm=CELL, ortho=PIXEL)
    assert not done.surface.left_out
    for name in ("orthophoto.tif", "orthophoto_sigma.tif"):
        with rasterio.open(made[1] / name) as one, rasterio.open(tmp_path / "s" / name) as other:
            assert np.array_equal(one.read(), other.read(), equal_nan=True)


def test_a_pixel_of_the_orthophoto_has_the_colour_of_what_is_there(made, half):
    """Known points: the photograph that is named shows at their places what the orthophoto shows at theirs."""
    done, out = made
    block = done.surface.block
    truth = read_block(PORTAL / "truth")
    plane = done.surface.heights.grid.plane
    with rasterio.open(out / "orthophoto.tif") as f:
        picture, pixel = np.moveaxis(f.read(), 0, 2), f.transform
        assert f.colorinterp[3].name == "alpha"
        assert pixel.a == PIXEL
    with rasterio.open(out / "orthophoto_sigma.tif") as f:
        right, _, number = f.read()
        assert f.descriptions[2] == "photograph"
    uv = plane.coordinates(truth.points.xyz)[:, :2]
    column, row = (uv[:, 0] - pixel.c) / PIXEL, (pixel.f - uv[:, 1]) / PIXEL
    inside = (column > 4) & (column < right.shape[1] - 5) & (row > 4) & (row < right.shape[0] - 5)
    seen = {True: [], False: []}
    grey = picture[..., :3].astype(float).mean(axis=2)
    greys = {
        k: cv2.GaussianBlur(cv2.imread(str(half / f), cv2.IMREAD_GRAYSCALE).astype(float), (0, 0), 1.5)
        for k, f in enumerate(block.images.file)
    }
    for p in np.flatnonzero(inside):
        j, i = int(row[p]), int(column[p])
        k = number[j, i]
        if not np.isfinite(k):
            continue
        x, y = predicted_px(block, int(k), truth.points.xyz[p : p + 1])[0]
        shown = greys[int(k)][int(y), int(x)]
        for near in (True, False):
            seen[near].append((shown, grey[j, i] if near else grey[j + 4, i - 4]))
    right_place, beside = (np.corrcoef(np.array(seen[near]).T)[0, 1] for near in (True, False))
    assert len(seen[True]) > 200
    assert right_place > 0.85
    assert beside < right_place - 0.15


def test_what_is_not_seen_is_transparent_and_what_is_has_a_standard_deviation(made):
    _, out = made
    with rasterio.open(out / "orthophoto.tif") as f:
        alpha = f.read(4)
    with rasterio.open(out / "orthophoto_sigma.tif") as f:
        right, up, number = f.read()
    seen = alpha == 255
    assert 0.1 < seen.mean() < 1
    assert (alpha[~seen] == 0).all()
    for band in (right, up, number):
        assert (np.isfinite(band) == seen).all()
    # a pixel of a photograph shows 11 mm: tenths of it, and at steps as much as the step
    assert 1e-4 < np.median(np.hypot(right, up)[seen]) < 0.01
    about = read_toml(out / "orthophoto.toml").tree().mapping()
    assert about["unit"].value == "m"
    shares = about["shares"].mapping()
    assert sum(v.number() for v in shares.values()) == pytest.approx(1)
    assert {int(k) for k in about["photographs"].mapping()} == set(np.unique(number[seen]).astype(int))


def test_the_orthophoto_is_made_again_to_the_same_bits(made, half):
    done, out = made
    before = [(t.colours, t.sigma, t.image) for t in tiles_of(done.surface)]
    for key in [*done.surface.orthophoto.parts.values(), *done.surface.orthophoto.choice.values()]:
        file = next((out / "work").rglob(f"*{key.rsplit('-', 1)[1]}*.npz"))
        file.write_bytes(file.read_bytes()[:100])  # as a full disk leaves it
    again = surface(half / "block", out, photos=(half,), jobs=2, **ASKED)
    for old, new in zip(before, tiles_of(again.surface), strict=True):
        for a, b in zip(old, (new.colours, new.sigma, new.image), strict=True):
            assert np.array_equal(a, b, equal_nan=a.dtype.kind == "f")


def test_laz_holds_the_points_with_all_that_is_known_of_them(made):
    done, out = made
    las = laspy.read(out / "points.laz")
    c = [c for c in done.surface.parts() if len(c)]
    assert len(las) == len(done.surface)
    xyz = np.concatenate([p.xyz for p in c])
    assert np.abs(las.xyz - xyz).max() <= 0.51 * las.header.scales.max()
    sigma = np.concatenate([p.sigma for p in c])
    assert las.header.scales.max() < np.median(sigma) / 9
    for k, axis in enumerate("xyz"):
        assert np.allclose(las[f"sigma_{axis}"], sigma[:, k])
    assert np.array_equal(las["rays"], np.concatenate([p.views for p in c]))
    assert np.array_equal(las["maps"], np.concatenate([p.confirmed for p in c]))
    assert np.allclose(las["incidence"], np.concatenate([p.incidence for p in c]))
    normal = np.stack([las[f"Normal{a}"] for a in "XYZ"], axis=1)
    assert np.allclose(normal, np.concatenate([p.normal for p in c]), atol=1e-6)
    assert np.array_equal(las.green // 257, np.concatenate([p.colour for p in c])[:, 1])


def test_points_in_a_map_carry_their_system(tmp_path):
    pyproj = pytest.importorskip("pyproj")
    system = pyproj.CRS("EPSG:25832")
    xyz = np.array([[500000.1234, 5.4e6, 100.5], [500010.0, 5400020.5, 90.25]])
    offsets, steps = steps_for(xyz.min(axis=0), xyz.max(axis=0), 0.002, degrees=False)
    assert steps == pytest.approx([1e-4] * 3)
    part = las_format.LasPoints(
        xyz=xyz, colours=np.full((2, 3), 7, np.uint8), rays=np.array([3, 300]),
        extra={"sigma_x": np.array([0.1, 0.2], np.float32)},
    )  # fmt: skip
    las_format.write_las(tmp_path / "p.las", [part, part], offsets=offsets, steps=steps, system=system)
    las = laspy.read(tmp_path / "p.las")
    assert las.header.parse_crs().to_epsg() == 25832
    assert np.abs(las.xyz[2:] - xyz).max() < 0.51e-4
    assert las.user_data.tolist() == [3, 255, 3, 255]
    wide = steps_for(np.zeros(3), np.full(3, 1e6), 1e-9, degrees=False)[1]
    assert (1e6 / wide < 2**31).all()


def test_depths_give_the_points_back(made, half):
    done, out = made
    about = read_toml(out / "depths/depths.toml").tree().mapping()
    block = done.surface.block
    for image in done.surface.maps:
        name = f"{block.images.ids[image]}.tif"
        told = about[name].mapping()
        with rasterio.open(out / "depths" / name) as f:
            depth, sigma, flags = f.read()
        known = np.isfinite(depth)
        assert (np.isfinite(sigma) == known).all()
        assert np.isfinite(flags).all()
        row, column = np.nonzero(known)
        step = told["step"].number()
        xy = np.column_stack([told["left"].number() + (column + 0.5) * step, told["top"].number() + (row + 0.5) * step])
        xyz = ReferenceRays.of(block, image).points(xy, 1 / depth[known].astype(float))
        own = next(c for (i, _), c in zip(done.surface.clouds, done.surface.parts(), strict=True) if i == image)
        assert KDTree(xyz).query(own.xyz)[0].max() < 1e-5


def test_the_mesh_opens_and_lies_on_the_points(made, cloud):
    done, out = made
    meshes = {n: trimesh.load(out / f"mesh.{n}", force="mesh", process=False) for n in ("ply", "obj", "glb")}
    ply = meshes["ply"]
    assert len(ply.faces) > 200
    distance = KDTree(cloud).query(ply.vertices)[0]
    assert np.quantile(distance, 0.9) < CELL
    turned = np.asarray(meshes["glb"].vertices)[:, [0, 2, 1]] * [1, -1, 1]
    assert np.allclose(turned, ply.vertices, atol=1e-4)
    assert np.allclose(meshes["obj"].vertices, ply.vertices, atol=1e-5)
    assert meshes["obj"].visual.kind == meshes["glb"].visual.kind == "texture"
    assert ply.visual.kind == "vertex"
    sigma = ply.metadata["_ply_raw"]["vertex"]["data"]["sigma"]
    assert (sigma > 0).all()
    plane = done.surface.heights.grid.plane
    z = plane.coordinates(np.asarray(ply.vertices))[:, 2][ply.faces]
    assert np.ptp(z, axis=1).max() <= 3 * MESH  # nothing over steps
    normals = np.asarray(ply.face_normals) @ np.array(plane.axes[2])
    assert (normals > 0).all()
    # the picture on it has the colours of its vertices
    uv = np.asarray(meshes["obj"].visual.uv)
    picture = cv2.imread(str(out / "mesh.jpg"))[..., ::-1]
    h, w = picture.shape[:2]
    there = picture[((1 - uv[:, 1]) * h).astype(int).clip(0, h - 1), (uv[:, 0] * w).astype(int).clip(0, w - 1)]
    assert np.median(np.abs(there.astype(int) - ply.visual.vertex_colors[:, :3])) < 4


def test_of_each_cube_the_best_point_stays(made, half, tmp_path, cloud):
    done = surface(half / "block", made[1], photos=(half,), jobs=1, density="4", thin=SIDE, las=True)
    best = {}
    for c in done.surface.parts():
        for cube, s in zip(
            map(tuple, np.floor(c.xyz / SIDE).astype(int)), np.linalg.norm(c.sigma, axis=1), strict=True
        ):
            best[cube] = min(best.get(cube, np.inf), s)
    las = laspy.read(made[1] / "points.laz")
    assert len(las) == len(best) < len(cloud) / 4
    sigma = np.sqrt(sum(np.asarray(las[f"sigma_{a}"]) ** 2 for a in "xyz"))
    assert np.allclose(np.sort(sigma), np.sort(list(best.values())))
    assert f"element vertex {len(best)}\n".encode() in (made[1] / "points.ply").read_bytes()[:2000]
    with pytest.raises(InputError, match=r"surface\.too_many_cubes"):
        surface(half / "block", made[1], photos=(half,), jobs=1, density="4", thin=1e-9)


@pytest.mark.long
def test_points_of_an_earlier_run_are_told_with_what_they_were_thinned_by(half, tmp_path):
    """Of a part of the portal, both ways: thinned before and not now, and the other way round."""

    def run(**more):
        return surface(half / "block", tmp_path / "s", photos=(half,), jobs=1, density="4", extent=WINDOW, **more)

    def las():
        return len(laspy.read(tmp_path / "s/points.laz"))

    thin = run(thin=SIDE, las=True)
    few, page = las(), tmp_path / "s/surface.html"
    whole = run()
    assert las() == few < len(whole.surface)
    points = {"names": ["points.laz"], "setting": "las"}
    assert phrase("surface_remark.otherwise_thinned", length=SIDE, now=0.0, **points) in whole.remarks
    assert not any("points.laz" in r for r in thin.remarks)
    assert phrase("report_surface.earlier_points", thinned=True, length=SIDE) in page.read_text()
    run(las=True)
    assert las() == len(whole.surface)
    assert phrase("surface_remark.otherwise_thinned", length=0.0, now=SIDE, **points) in run(thin=SIDE).remarks
    assert phrase("surface_remark.earlier", names=["points.laz"]) in run().remarks
    (tmp_path / "s/surface.pdf").write_bytes(b"%PDF of a run that noted nothing")
    assert phrase("surface_remark.removed", names=["surface.pdf"], setting="pdf") in run().remarks
    assert not (tmp_path / "s/surface.pdf").exists()


@pytest.mark.long
def test_a_pdf_of_the_same_points_stays_and_is_told(half, tmp_path, monkeypatch):
    monkeypatch.setattr("raybundle.report.paper.needed.check_typesetter", lambda: None)
    monkeypatch.setattr("raybundle.surfaces.page.set_document", lambda *_: b"a page")

    def run(**more):
        more = {"extent": WINDOW, **more}
        return surface(half / "block", tmp_path / "s", photos=(half,), jobs=1, density="4", **more)

    pdf = tmp_path / "s/surface.pdf"
    assert not any("surface.pdf" in r for r in run(pdf=True).remarks)
    values = {"names": ["surface.pdf"], "setting": "pdf", "length": 0.0, "now": SIDE}
    assert phrase("surface_remark.earlier", names=["surface.pdf"]) in run().remarks
    assert phrase("surface_remark.otherwise_thinned", **values) in run(thin=SIDE).remarks
    assert pdf.exists()
    left, bottom, right, top = WINDOW
    other = run(extent=(left, bottom, right - 0.05, top))
    assert phrase("surface_remark.removed", names=["surface.pdf"], setting="pdf") in other.remarks
    assert not pdf.exists()


def test_what_cannot_be_is_refused_before_it_is_computed(half, tmp_path, monkeypatch):
    def ask(**given):
        return surface(half / "block", tmp_path / "s", photos=(half,), density="4", **given)

    with refused("picture.pixel_too_large", pixel=50, setting="ortho"):
        ask(ortho=50.0)
    with refused("picture.too_large", limit_px=400_000_000, setting="ortho"):
        ask(ortho=1e-5)
    with refused("picture.too_large", limit_px=2_000_000, setting="mesh"):
        ask(mesh=1e-4)
    with pytest.raises(InputError, match=r"ortho=.*mesh="):
        ask(axis=("A", "B"))
    monkeypatch.setitem(__import__("sys").modules, "laspy", None)
    with pytest.raises(InputError, match=r"raybundle\[las\]"):
        ask(las=True)
    monkeypatch.setitem(__import__("sys").modules, "rasterio", None)
    for name, value in (("ortho", 0.02), ("depths", True)):
        with pytest.raises(InputError, match=r"raybundle\[geo\]"):
            ask(**{name: value})
    assert not (tmp_path / "s").exists()


def test_the_cells_of_heights_follow_the_points_where_nobody_says(made):
    block = made[0].surface.block

    class Wall:
        extent = np.array([-2.0, -1.0, 2.0, 1.0])
        origin = np.array([0.0, 0.0, 1.7])
        axes = np.array([[1.0, 0, 0], [0, 0, 1.0], [0, -1.0, 0]])

    def grids(**given):
        asked = {"heights": None, "orthophoto": None, "mesh": None, **given}
        return product_grids.grids_over(block, Wall(), None, density=2, reported=(), **asked)

    pixel = product_grids.usual_pixel(block, Wall())
    found = grids(orthophoto=0.001)
    assert found.heights.grid.pixel == pytest.approx(4 * pixel, rel=0.1)
    assert found.orthophoto.width == pytest.approx(4000, abs=100)
    assert grids(orthophoto=0.5).heights.grid.pixel == 0.5
    assert grids(mesh=0.1).orthophoto.pixel == pytest.approx(pixel)
    assert grids(heights=0.1).orthophoto is None
    fine = 1.5 * pixel
    (told,) = grids(heights=fine).reported
    assert [m.code for m in told.messages] == ["surface_remark.fine_cells"]
    assert told.message.values["cell"] == fine
    assert told.message.values["pixel"] == pixel
    assert not grids(heights=4 * pixel).reported


def test_gltf_says_what_it_holds(made):
    data = (made[1] / "mesh.glb").read_bytes()
    length = int.from_bytes(data[12:16], "little")
    told = json.loads(data[20 : 20 + length])
    assert told["asset"]["extras"]["unit"] == "m"
    assert int.from_bytes(data[8:12], "little") == len(data)
    assert (made[1] / "mesh.jpg").read_bytes() in data  # not encoded once more


def test_a_full_disk_is_told_and_leaves_nothing_half_written(made, half, monkeypatch):
    def full(*_args):
        raise OSError(28, "No space left on device")

    before = (made[1] / "mesh.obj").read_bytes()
    monkeypatch.setattr("raybundle.surfaces.products.mesh._write_glb", full)
    with pytest.raises(InputError, match=r"No.*file\.not_writable"):
        surface(half / "block", made[1], photos=(half,), jobs=1, **{**ASKED, "mesh": 0.2})
    assert (made[1] / "mesh.obj").read_bytes() == before
    assert not list(made[1].glob(".*.partial"))
