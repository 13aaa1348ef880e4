"""From light to files, and the truth beside them."""

import json
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from renderer.camera import camera
from renderer.classes import BORDER, CLUTTER, CURVED, NAMES, RIDGE, SMOOTH, STEP
from renderer.height_field import HeightField
from renderer.judging import Points, fitted, nearest_ways, read_points, robust_chi_square, statistics
from renderer.network import photographs
from renderer.sensor import Sensor, camera_tables, demosaiced, mosaic, write_photograph
from renderer.sets import SetSettings, render_set
from renderer.terrain import terrain
from renderer.texture import WEAK_CONTRAST
from renderer.truth import Surface, read_surface
from renderer.truth_folder import CONTROL_PLACES, visible, write_cameras

GSD = 0.002
CELL = GSD / 2


@pytest.mark.parametrize(("quality", "subsampling", "first"), [(80, "4:2:0", 6), (95, "4:4:4", 2)])
def test_jpeg_has_the_tables_of_its_quality(tmp_path, quality, subsampling, first):
    """The first number of the table of ITU-T T.81 is 16; libjpeg scales it by (200 - 2 quality) / 100."""
    sensor = Sensor(quality=quality, subsampling=subsampling)
    cam = camera("A", 64, 48)
    light = np.random.default_rng(1).uniform(0, 0.5, (3, 48, 64)).astype(np.float32)
    write_photograph(sensor.developed(light, np.random.default_rng(2)), tmp_path / "a.jpg", cam, sensor, 0)
    with Image.open(tmp_path / "a.jpg") as image:
        assert image.quantization[0][0] == first
        assert image.layer[0][1:3] == ((2, 2) if subsampling == "4:2:0" else (1, 1))
        exif = image.getexif()
        assert exif[0x0110] == "Rendering A"
        folder = exif.get_ifd(0x8769)
        assert folder[0xA405] == round(1.1 * 36 * np.hypot(36, 24) / np.hypot(36, 27))
        assert float(folder[0x920A]) == pytest.approx(cam.interior.c, abs=0.01)


def test_demosaicing_keeps_what_is_grey_and_level_or_steady():
    """The filters of Malvar, He and Cutler reproduce a ramp that all colours share."""
    y, x = np.mgrid[:20, :30].astype(np.float32)
    ramp = np.stack([0.1 + 0.01 * x + 0.02 * y] * 3).astype(np.float32)
    np.testing.assert_allclose(demosaiced(mosaic(ramp))[:, 4:-4, 4:-4], ramp[:, 4:-4, 4:-4], atol=1e-6)
    red = np.zeros((3, 20, 30), np.float32)
    red[0] = 0.4
    assert (mosaic(red) > 0).sum() == 150
    assert mosaic(red)[0, 0] == pytest.approx(0.4)


def test_noise_is_that_of_electrons():
    light = np.full((3, 200, 200), 0.25, dtype=np.float32)
    raw = Sensor(full_well=10_000, read_noise=5)._exposed(light[1], np.random.default_rng(1))
    assert raw.mean() == pytest.approx(0.25, abs=2e-4)
    assert raw.std() == pytest.approx(np.sqrt(2500 + 25) / 10_000, rel=0.02)


def surface(heights, classes=None):
    n = heights.shape[0]
    half = CELL * (n // 2)
    codes = np.full((n // 2, n // 2), SMOOTH, np.int8) if classes is None else classes
    field = HeightField(heights.astype(np.float32), np.array([-half, -half]), CELL)
    return Surface(field=field, classes=codes, class_step=2, core=np.array([0.15, 0.15]), gsd=GSD)


GRID = CELL * (np.arange(401) - 200)


def test_distances_from_a_plane_are_along_its_normal():
    true = surface(0.6 * GRID[None, :] + 0.0 * GRID[:, None])
    points = np.array([[0.01, 0.02, 0.006], [0.03, -0.05, 0.018], [-0.04, 0.0, -0.024]])
    normal = np.array([-0.6, 0, 1]) / np.hypot(0.6, 1)
    off = np.array([0.003, -0.011, 0.0])
    moved = points + off[:, None] * normal
    mean, normals = true.window_planes(moved, 6 * GSD)
    np.testing.assert_allclose(normals, np.tile(normal, (3, 1)), atol=1e-4)
    np.testing.assert_allclose(true.distances(moved, normals), off, atol=2e-6)
    np.testing.assert_allclose(true.window_distances(moved, normals, 6 * GSD), off, atol=2e-6)
    np.testing.assert_allclose(mean, 0.6 * moved[:, 0], atol=2e-6)


def test_distances_from_a_sphere_and_from_its_mean():
    radius = 0.3
    true = surface(np.sqrt(radius**2 - GRID[:, None] ** 2 - GRID[None, :] ** 2) - radius)
    points = np.array([[0.0, 0.0, 0.001]])
    _, normals = true.window_planes(points, 6 * GSD)
    np.testing.assert_allclose(true.distances(points, normals), 0.001, atol=1e-6)
    # The mean of (x^2 + y^2) / 2 R over a window of 25 by 25 nodes is the variance of its nodes over R.
    lower = np.mean((CELL * np.arange(-12, 13)) ** 2) / radius
    np.testing.assert_allclose(true.window_distances(points, normals, 6 * GSD), 0.001 + lower, rtol=0.01)


def test_the_nearest_crossing_counts():
    """Above a groove the surface is met three times by a slanted line."""
    true = surface(np.where(np.abs(GRID) < 0.01, -0.05, 0.0)[None, :] * np.ones((401, 1)))
    normal = np.array([[1.0, 0.0, 1.0]]) / np.sqrt(2)
    assert true.distances(np.array([[0.012, 0.0, 0.001]]), normal).item() == pytest.approx(0.001 * np.sqrt(2), abs=1e-6)


def test_classes_are_those_of_the_whole_window():
    codes = np.full((200, 200), SMOOTH, np.int8)
    codes[:, 100:] = CLUTTER
    codes[30, :] = RIDGE
    codes[150, :60] = STEP
    true = surface(np.zeros((401, 401)), codes)
    at = np.array([[50, 100], [150, 100], [97, 100], [150, 33], [20, 153]]) - 100.0
    points = np.column_stack([2 * CELL * at, np.zeros(5)])
    np.testing.assert_array_equal(true.classes_at(points, 6 * GSD), [SMOOTH, CLUTTER, BORDER, RIDGE, STEP])


def test_true_sigmas_have_a_chi_square_of_one():
    rng = np.random.default_rng(1)
    sigma = rng.uniform(1e-4, 1e-3, 20_000)
    error = sigma * rng.standard_normal(20_000)
    found = statistics(error, sigma)
    assert found["chi_square"] == pytest.approx(1, abs=0.06)
    assert found["beyond_5_sigma"] == 0
    assert found["spearman"] > 0.3
    assert robust_chi_square(1.2 * error / sigma) == pytest.approx(1.44 * found["chi_square"])


def test_points_of_a_result_are_read(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text(
        "point,role,X,Y,Z,sX,sY,sZ,rays,flag\nC1,control,0,0,0,,,,3,\n1,tie,1,2,3,0.001,0.002,0.003,4,\n"
        "2,tie,1,2,3,0.001,0.002,0.003,4,rough\n"
    )
    points = read_points(path)
    assert list(points.names) == ["1", "2"]
    assert list(points.flagged) == [False, True]
    np.testing.assert_allclose(points.sigma_along(np.array([[0.6, 0, 0.8]] * 2)), np.hypot(0.6e-3, 2.4e-3))


def test_correlations_enter_the_sigma_along_a_direction():
    points = Points(
        names=np.array(["1"]),
        coordinates=np.zeros((1, 3)),
        sigma=np.array([[1.0, 1.0, 2.0]]),
        correlation=np.array([[0.0, -0.5, 0.0]]),
        rays=np.array([3.0]),
        flagged=np.array([False]),
    )
    Q = np.array([[1, 0, -1], [0, 1, 0], [-1, 0, 4.0]])
    n = np.array([[0.6, 0, 0.8]])
    np.testing.assert_allclose(points.sigma_along(n), np.sqrt(n[0] @ Q @ n[0]))


def test_the_way_to_a_plane_is_the_shortest_by_the_covariance():
    rng = np.random.default_rng(4)
    normals = rng.normal(size=(50, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    A = rng.normal(size=(50, 3, 3)) * [1, 1, 5]
    C = A @ A.swapaxes(1, 2)
    ways, sigma = nearest_ways(normals, C)
    np.testing.assert_allclose(np.linalg.norm(ways, axis=1), 1)
    distance = 0.7
    to_plane = distance / np.einsum("pi,pi->p", ways, normals)
    across = np.sqrt(np.einsum("pi,pij,pj->p", normals, C, normals))
    np.testing.assert_allclose(to_plane / sigma, distance / across)
    other = rng.normal(size=(50, 3))
    other /= np.linalg.norm(other, axis=1, keepdims=True)
    steps = distance / np.einsum("pi,pi->p", other, normals)
    lengths = np.sqrt(np.einsum("pi,pij,pj->p", other, np.linalg.inv(C), other))
    assert (np.abs(steps) * lengths >= to_plane / sigma - 1e-9).all()


def test_a_normal_that_leans_at_a_step_is_no_error_of_its_point():
    lean = np.radians(70)
    normal = np.array([[np.sin(lean), 0, np.cos(lean)]])
    C = np.diag([0.02, 0.02, 0.1])[None] ** 2
    ways, sigma = nearest_ways(normal, C)
    assert np.degrees(np.arccos(ways[0, 2])) < 7
    assert sigma[0] == pytest.approx(0.1, rel=0.15)


@pytest.fixture(scope="module")
def scene():
    return terrain(3, 440 * GSD, GSD)


def test_a_terrain_has_all_classes_and_its_files_hold_it(scene, tmp_path):
    (tmp_path / "truth").mkdir()
    scene.write(tmp_path / "truth" / "surface.npz")
    true = read_surface(tmp_path)
    share = np.bincount(true.classes.ravel(), minlength=len(NAMES)) / true.classes.size
    assert (share[:CURVED] > 1e-3).all()
    points = np.array([[0.1, 0.1, 0.0]])
    np.testing.assert_allclose(true.field.at(points[:, 0], points[:, 1]), scene.surface.at(points[:, 0], points[:, 1]))
    j, i = (scene.classes == CLUTTER).nonzero()[::-1]
    clutter = scene.surface.heights[2 * i, 2 * j]
    assert 3 * GSD < np.std(clutter) < 15 * GSD


def test_weak_texture_has_the_contrast_that_is_stated(scene):
    i, j = (part[::40] for part in (scene.classes == NAMES.index("weak")).nonzero())
    x, y = scene.surface.origin[:, None] + 2 * CELL * np.stack([j, i])
    green = scene.texture.at(x, y, scene.surface.at(x, y))[1]
    assert 0.5 * WEAK_CONTRAST < green.std() / green.mean() < 1.2 * WEAK_CONTRAST


def test_marks_are_on_points_that_are_seen(scene, tmp_path):
    taken = photographs(camera("A", 440, 330), 14, GSD, np.random.default_rng(1))
    points = scene.control(CONTROL_PLACES, np.random.default_rng(2))
    assert len(points) >= 4
    np.testing.assert_allclose(scene.surface.at(points[:, 0], points[:, 1]), points[:, 2], atol=1e-7)
    pixels, seen = visible(scene, taken[0], points)
    assert seen.any()
    origins, directions = taken[0].rays(pixels[:, 0], pixels[:, 1])
    share = (points[:, 2] - origins[:, 2]) / directions[:, 2]
    np.testing.assert_allclose(origins + share[:, None] * directions, points, atol=1e-9)
    below = points - np.array([0, 0, 0.05])
    assert not visible(scene, taken[0], below)[1].any()
    write_cameras(taken, tmp_path / "cameras.json")
    assert '"K1": -0.00011' in (tmp_path / "cameras.json").read_text()


def test_a_fit_finds_the_datum(scene):
    true = Surface(field=scene.surface, classes=scene.classes, class_step=2, core=scene.core, gsd=GSD)
    rng = np.random.default_rng(5)
    x, y = rng.uniform(-1, 1, (2, 4000)) * scene.core[:, None]
    points = np.stack([x, y, scene.surface.at(x, y)], axis=-1)
    moved = 1.0003 * points + np.array([0.0, 0.0, 0.001]) + np.cross([0.0005, -0.0003, 0.0], points)
    back, used = fitted(moved, true, 6 * GSD, np.full((4000, 3), 1e-4))
    assert used.sum() > 300
    assert np.abs(back - points)[:, 2].max() < 1e-4


def test_tables_of_a_camera_are_written(tmp_path):
    sensor = Sensor(quality=90, tables="camera", subsampling="4:2:2")
    cam = camera("B", 64, 48)
    write_photograph(np.full((48, 64, 3), 90, np.uint8), tmp_path / "b.jpg", cam, sensor, 3700)
    with Image.open(tmp_path / "b.jpg") as image:
        assert image.quantization[0] == camera_tables(90)[0]
        assert image.layer[0][1:3] == (2, 1)
        assert image.getexif().get_ifd(0x8769)[0x9003] == "2026:06:01 11:01:40"


def test_ground_moves_with_its_texture():
    """At the second date the ground stands elsewhere, by what `moved` states, and looks the same."""
    scene, later = (terrain(3, 200 * GSD, GSD, (), date) for date in (1, 2))
    lift = later.moved.heights
    np.testing.assert_allclose(later.surface.heights, scene.surface.heights + lift, atol=1e-6)
    assert lift.max() == pytest.approx(3 * GSD, rel=1e-3)
    assert lift.min() == pytest.approx(-2 * GSD, rel=1e-2)
    i, j = np.mean((lift > 0.999 * lift.max()).nonzero(), axis=1)
    place = scene.surface.origin + CELL * np.array([j, i])

    def below(scene):
        origins = np.broadcast_to([*place, 1.0], (24, 24, 3))
        return scene.seen(origins, np.broadcast_to([0.0, 0.0, -1.0], (24, 24, 3)))[:, 0, 0]

    np.testing.assert_allclose(below(later), below(scene), rtol=0.02)


@pytest.mark.parametrize(("scene", "quality", "names"), [("terrain", 0, "A001.png"), ("facade", 85, "A001.jpg")])
def test_a_set_is_a_folder(tmp_path, scene, quality, names):
    """Photographs, control with marks, truth; each mark is a photograph's."""
    settings = SetSettings(scene=scene, width=96, photographs=4, gsd=0.005, sensor=Sensor(quality=quality))
    render_set(settings, tmp_path / "set")
    files = sorted(path.name for path in (tmp_path / "set" / "photos").iterdir())
    assert len(files) == 4
    assert files[0] == names
    with Image.open(tmp_path / "set" / "photos" / names) as image:
        assert image.size == (96, 72)
        assert image.format == ("JPEG" if quality else "PNG")
        assert 60 < np.asarray(image).mean() < 180
    truth = json.loads((tmp_path / "set" / "truth" / "cameras.json").read_text())
    assert [row["name"] for row in truth] == files
    assert json.loads((tmp_path / "set" / "truth" / "settings.json").read_text())["scene"] == scene
    assert read_surface(tmp_path / "set").gsd == 0.005
    with pytest.raises(FileExistsError):
        render_set(settings, tmp_path / "set")
