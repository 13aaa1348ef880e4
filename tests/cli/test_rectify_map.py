"""`raybundle rectify --horizontal` of a georeferenced result: marks on the ground lie at their map coordinates."""

import sys
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image
from scipy.spatial import KDTree
from tests.messages import coded, refused

import raybundle as rb
from raybundle import adjust
from raybundle.block import Role
from raybundle.errors import InputError
from raybundle.io.geo.coordinate_systems import in_other_projection, local_frame
from raybundle.io.pictures.geotiff import overview_levels
from raybundle.io.pictures.undistort import camera_plane
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.report.write import write_result

FRAME = local_frame("EPSG:32632", (700_000.0, 5_400_000.0, 400.0))
"""2.0 degrees of convergence: over a metre the grid leaves the local axes by 7 pixels"""
FEET = local_frame("EPSG:2263", (984_000.0, 207_000.0, 100.0))
PIXEL = 0.005
RADIUS = 0.03
"""Of the marks [m]"""


@pytest.fixture(scope="module")
def ground(tmp_path_factory):
    """The result of photographs of dark marks on light level ground, and the places of the marks."""
    folder = tmp_path_factory.mktemp("ground")
    small = brown_camera(size_px=(600, 400), pixel_mm=0.04)
    scene = field_scene(TargetField(camera=small, columns=7, rows=5, stations=4, frontal=1, depth=0.0))
    truth = simulate(scene, Survey(interior="exact", orientation="exact", points="exact", image_sigma_px=0.01)).observed
    marks, level = truth.points.xyz, truth.points.xyz[0, 2]
    np.testing.assert_allclose(marks[:, 2], level, atol=1e-12)
    tree = KDTree(marks[:, :2])
    (folder / "photos").mkdir()
    files = tuple(f"{k}.png" for k in range(len(truth.images)))
    y, x = np.mgrid[0:800, 0:1200] / 2 + 1 / 4  # four rays a pixel
    pixels = np.stack([x.ravel(), y.ravel()], axis=1)
    values, camera = truth.cameras[0].values, truth.cameras[0]
    ideal = camera.image_from_pixel(camera_plane(camera, pixels)).T
    rays = np.stack([ideal[0] - values["x0"], ideal[1] - values["y0"], np.full(ideal.shape[1], -values["c"])])
    for k, file in enumerate(files):
        ray = truth.images.rotation[k].T @ rays
        at = truth.images.centre[k][:, None] + (level - truth.images.centre[k, 2]) / ray[2] * ray
        away = tree.query(at[:2].T, distance_upper_bound=RADIUS)[0]
        grey = np.where(away < RADIUS, 20.0, 220.0).reshape(400, 2, 600, 2).mean(axis=(1, 3))
        Image.fromarray(np.repeat(grey[..., None].round().astype(np.uint8), 3, axis=2)).save(folder / "photos" / file)
    fixed = replace(truth, images=replace(truth.images, file=files), points=replace(
        truth.points, role=np.full(len(marks), Role.CONTROL, np.int32), sigma=np.full((len(marks), 3), 1e-4),
    ))  # fmt: skip
    result = adjust(fixed)
    write_result(result, folder / "result", report="none", additions={"frame": FRAME.as_mapping()}, frame=FRAME)
    plain = in_other_projection(FRAME, "EPSG:4326")
    write_result(result, folder / "feet", report="none", additions={"frame": FEET.as_mapping()}, frame=FEET)
    write_result(result, folder / "degrees", report="none", additions={"frame": plain.as_mapping()}, frame=plain)
    return folder, marks


def rectified(folder, out, *, source="result", **more):
    return rb.rectify(folder / source, out, photos=folder / "photos", pixel=PIXEL, **more)


def check_marks(picture, rgb, marks, frame=FRAME, pixel=PIXEL):
    """Centres of gravity of the marks that are wholly in the picture lie within a pixel of their coordinates."""
    dark = np.clip(220.0 - rgb[0].astype(float), 0, None)
    half, found = int(1.6 * RADIUS / PIXEL), 0
    for x, y, _ in frame.crs_from_local(marks):
        column, row = (x - picture.transform.c) / pixel, (picture.transform.f - y) / pixel
        i, j = int(row), int(column)
        window = (slice(i - half, i + half + 1), slice(j - half, j + half + 1))
        if min(i, j) < half or i + half >= picture.height or j + half >= picture.width or not rgb[3][window].all():
            continue
        weight = dark[window]
        r, c = np.mgrid[window]
        centre = np.array([(weight * r).sum(), (weight * c).sum()]) / weight.sum() + 0.5
        np.testing.assert_allclose(centre, (row, column), rtol=0, atol=0.2)
        found += 1
    assert found >= 15  # those on the border are cut


def test_a_geotiff_has_marks_at_their_coordinates(ground, tmp_path):
    rasterio, (folder, marks) = pytest.importorskip("rasterio"), ground
    done = rectified(folder, tmp_path / "g.tif", horizontal=True)
    assert done.unit == "m"
    assert coded(done.remarks)["picture.in_map"] == {"system": "EPSG:32632"}
    with rasterio.open(tmp_path / "g.tif") as picture:
        assert picture.crs.to_epsg() == 32632
        assert picture.profile["compress"] == "deflate"
        assert [c.name for c in picture.colorinterp] == ["red", "green", "blue", "alpha"]
        assert picture.overviews(1) == overview_levels(picture.width, picture.height)
        left, top = picture.transform.c, picture.transform.f
        assert left / PIXEL == pytest.approx(round(left / PIXEL), abs=1e-4)
        assert top / PIXEL == pytest.approx(round(top / PIXEL), abs=1e-4)
        check_marks(picture, picture.read(), marks)
        assert (picture.read(4) == 0).any() == (done.picture.seen.mean() < 1)
    world = [float(v) for v in (tmp_path / "g.tfw").read_text().split()]
    assert world == pytest.approx([PIXEL, 0, 0, -PIXEL, left + PIXEL / 2, top - PIXEL / 2], rel=0, abs=1e-9)
    told = (tmp_path / "g.toml").read_text()
    assert 'system = "EPSG:32632"' in told
    assert "normal" not in told
    assert not (tmp_path / "g.tif.aux.xml").exists()


@pytest.mark.parametrize("name", ["g.tif", "g.png", "g.jpg"])
def test_without_geotiff_the_system_stands_beside(name, ground, tmp_path, monkeypatch):
    folder, marks = ground
    with monkeypatch.context() as m:
        m.setitem(sys.modules, "rasterio", None)
        done = rectified(folder, tmp_path / name, horizontal=True)
    beside = coded(done.remarks)["conversion.system_beside"]
    assert beside == {"name": f"{name}.aux.xml", "tiff": name.endswith(".tif")}
    rasterio = pytest.importorskip("rasterio")
    with rasterio.open(tmp_path / name) as picture:
        assert picture.crs.to_epsg() == 32632
        rgb = picture.read()
        check_marks(picture, rgb if len(rgb) == 4 else np.vstack([rgb, np.full_like(rgb[:1], 255)]), marks)


def test_an_area_is_one_of_the_map(ground, tmp_path):
    rasterio, (folder, _) = pytest.importorskip("rasterio"), ground
    middle = FRAME.crs_from_local(np.zeros((1, 3)))[0]
    area = (middle[0] - 0.5, middle[1] - 0.25, middle[0] + 0.5, middle[1] + 0.25)
    rectified(folder, tmp_path / "g.tif", horizontal=True, extent=area)
    with rasterio.open(tmp_path / "g.tif") as picture:
        assert tuple(picture.bounds) == pytest.approx(area, abs=1e-6)
    with refused("picture.area_far_away", west=-0.5, east=0.5, south=-0.5, north=0.5):
        rectified(folder, tmp_path / "h.tif", horizontal=True, extent=(-0.5, -0.5, 0.5, 0.5))  # of the plane


def test_a_map_in_feet_has_pixels_in_feet(ground, tmp_path):
    rasterio, (folder, marks) = pytest.importorskip("rasterio"), ground
    foot, pixel = 1200 / 3937, PIXEL / (1200 / 3937)
    metres = rb.rectify(folder / "result", tmp_path / "m.tif", photos=folder / "photos", horizontal=True)
    feet = rb.rectify(folder / "feet", tmp_path / "f.tif", photos=folder / "photos", horizontal=True)
    assert feet.unit == "US survey foot"
    assert feet.grid.pixel * foot == pytest.approx(metres.grid.pixel, rel=0.1)  # rounded to two digits each
    rb.rectify(folder / "feet", tmp_path / "g.tif", photos=folder / "photos", horizontal=True, pixel=pixel)
    with rasterio.open(tmp_path / "g.tif") as picture:
        assert picture.crs.to_epsg() == 2263
        check_marks(picture, picture.read(), marks, FEET, pixel)


def test_a_wall_stays_in_its_plane(ground, tmp_path):
    folder, _ = ground
    done = rectified(folder, tmp_path / "g.png")  # not asked to be level: a plane as that of a facade
    assert done.remarks == ()
    assert "normal" in (tmp_path / "g.toml").read_text()
    assert sorted(p.name for p in tmp_path.iterdir()) == ["g.pgw", "g.png", "g.toml"]
    assert abs(float((tmp_path / "g.pgw").read_text().split()[4])) < 10


def test_a_system_in_degrees_leaves_the_picture_in_the_local_plane(ground, tmp_path):
    folder, _ = ground
    done = rectified(folder, tmp_path / "g.tif", source="degrees", horizontal=True)
    assert coded(done.remarks)["picture.local_plane"] == {"system": "EPSG:4326"}
    assert abs(float((tmp_path / "g.tfw").read_text().split()[4])) < 10


def test_nothing_beside_is_overwritten(ground, tmp_path):
    folder, _ = ground
    (tmp_path / "g.png.aux.xml").write_text("mine")
    with pytest.raises(InputError, match=r"file\.exists"):
        rectified(folder, tmp_path / "g.png", horizontal=True)


def test_overviews_end_below_512_pixels():
    assert overview_levels(512, 300) == []
    assert overview_levels(513, 300) == [2]
    assert overview_levels(6189, 5938) == [2, 4, 8, 16]
