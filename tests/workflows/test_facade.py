"""`raybundle facade`: a wall with relief, drawn of three photographs of the portal at half their size."""

from dataclasses import replace

import cv2
import ezdxf
import numpy as np
import pytest

import raybundle as rb
from raybundle.adjustment.system.predict import predicted_px
from raybundle.block import Role
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.reading.trees import read_toml
from raybundle.numerics.planes import planes_of_most
from raybundle.surfaces.files.input import opened
from raybundle.surfaces.orthophoto_holes import fill_holes
from raybundle.surfaces.photographs import photographs_there
from raybundle.workflows.object_plane import PlaneAsked, plane_of
from raybundle.workflows.wall_extent import wall_extent
from tests.messages import refused

rasterio = pytest.importorskip("rasterio")
WINDOW, REACH = 8, 10
"""Pixels beside a point that are compared, and by which it may lie elsewhere"""


@pytest.fixture(scope="module")
def drawn(half, copy_of_surface, tmp_path_factory):
    """The facade, with depth maps made before."""
    out = tmp_path_factory.mktemp("facade") / "f"
    out.mkdir()
    copy_of_surface(out / "surface")
    return rb.facade(half / "block", out, photos=(half,), density="4", jobs=1, title="Portal", language="de")


def picture_of(done):
    with rasterio.open(done.folder / "facade.tif") as file:
        return np.ascontiguousarray(np.moveaxis(file.read(), 0, 2))


def test_picture_sheet_drawing_and_sections_are_written(drawn):
    names = {f.name for f in drawn.files}
    assert names == {"facade.tif", "sheet.pdf", "drawing.dxf", "sections.dxf", "sections.csv"}
    assert all(f.stat().st_size > 1000 for f in drawn.files)
    assert drawn.plane.kind == "vertical"
    assert drawn.relief[0] < -0.1 < 0.1 < drawn.relief[1]  # the niche and the columns
    assert drawn.unit == "m"
    assert drawn.sheet.paper.startswith("A")
    assert drawn.measured > 0.6
    about = read_toml(drawn.folder / "facade.toml").tree()
    assert about.get("measured").number() + about.get("filled").number() + drawn.white == pytest.approx(1)
    assert (picture_of(drawn)[..., 3] > 0).mean() == pytest.approx(drawn.measured + drawn.filled)


def test_points_in_front_of_the_plane_and_behind_stand_at_their_places(drawn, half):
    """Windows of photographs around tie points against the picture: within three standard deviations."""
    block, picture = drawn.surface.surface.block, picture_of(drawn)
    grey = cv2.cvtColor(picture[..., :3].copy(), cv2.COLOR_RGB2GRAY)
    at, axes = drawn.plane.coordinates(block.points.xyz), drawn.plane.axes
    grid = drawn.grid
    cells = grid.cells(at[:, :2])
    with rasterio.open(drawn.folder / "surface/orthophoto_sigma.tif") as file:
        whole = drawn.surface.surface.orthophoto.grid
        column, row = np.rint(whole.cells(np.array([[grid.left, grid.top]]))[0]).astype(int)
        window = rasterio.windows.Window(column, row, grid.width, grid.height)
        sigma = np.hypot(file.read(1, window=window), file.read(2, window=window))
    photos = [cv2.imread(str(half / f), cv2.IMREAD_GRAYSCALE) for f in block.images.file]
    rays = np.bincount(block.observations.point, minlength=len(at))
    inside = ((cells > WINDOW + REACH + 2) & (cells < [grid.width - 24, grid.height - 24])).all(axis=1)
    off, scaled = [], []
    for p in np.flatnonzero((rays > 2) & inside & (np.abs(at[:, 2]) > 0.05)):
        column, row = cells[p]
        s = sigma[int(row), int(column)]
        if not np.isfinite(s):
            continue
        step = np.arange(-WINDOW, WINDOW + 1) * grid.pixel
        u, v = np.meshgrid(step, -step)
        around = block.points.xyz[p] + u.reshape(-1, 1) * axes[0] + v.reshape(-1, 1) * axes[1]
        xy = predicted_px(block, 1, around).astype(np.float32).reshape(2 * WINDOW + 1, -1, 2)
        patch = cv2.remap(photos[1], xy[..., 0] - 0.5, xy[..., 1] - 0.5, cv2.INTER_LINEAR)
        far = np.arange(-WINDOW - REACH, WINDOW + REACH + 1)
        x, y = np.meshgrid(column - 0.5 + far, row - 0.5 + far)
        here = cv2.remap(grey, x.astype(np.float32), y.astype(np.float32), cv2.INTER_LINEAR)
        score = cv2.matchTemplate(here, patch, cv2.TM_CCOEFF_NORMED)
        j, i = np.unravel_index(score.argmax(), score.shape)
        if patch.std() > 10 and score[j, i] > 0.85:
            off.append(np.hypot(i - REACH, j - REACH) * grid.pixel)
            scaled.append(off[-1] / np.hypot(3 * s, 1.5 * grid.pixel))
    assert len(off) > 30
    assert np.mean(np.array(scaled) < 1) > 0.95
    assert np.median(off) < 1.5 * grid.pixel


def test_the_drawing_has_the_picture_below_it_in_its_place(drawn):
    drawing = ezdxf.readfile(drawn.folder / "drawing.dxf")
    first = next(iter(drawing.modelspace()))
    assert first.dxftype() == "IMAGE"
    assert first.image_def.dxf.filename == "facade.tif"
    g = drawn.grid
    assert np.allclose(tuple(first.dxf.insert)[:2], [g.left, g.top - g.height * g.pixel])
    assert first.dxf.u_pixel.magnitude == pytest.approx(g.pixel)
    assert not drawing.layers.get("stations").is_on()


def test_a_hole_is_filled_with_what_stands_there(drawn, half):
    s = drawn.surface.surface
    with rasterio.open(drawn.folder / "surface/orthophoto.tif") as file:
        whole = np.ascontiguousarray(np.moveaxis(file.read(), 0, 2))
    colours = whole.copy()
    middle = np.array(whole.shape[:2]) // 2
    part = tuple(slice(m - 20, m + 20) for m in middle)
    seen = colours[part][..., 3] > 0
    colours[part] = 0
    photos, _ = photographs_there(s.block, (half,))
    found = fill_holes(
        colours, s.orthophoto.grid, s.heights.grid, opened(drawn.folder / "surface").model, widest=0.2, block=s.block,
        photos=photos, masks=None, gains=s.orthophoto.gains,
    )  # fmt: skip
    assert found[part][seen].mean() > 0.9
    away = np.abs(colours[part][..., :3].astype(float) - whole[part][..., :3])[found[part] & seen]
    assert np.median(away) < 12


def test_without_a_scale_there_is_a_picture_and_no_sheet(half, tmp_path):
    block = read_block(half / "block")
    block, n = replace(block, tables={}), len(block.points)
    free = replace(block.points, role=np.full(n, Role.TIE, np.int32), sigma=np.full((n, 3), np.nan))
    write_block(replace(block, points=free), tmp_path / "block")
    done = rb.facade(
        tmp_path / "block", tmp_path / "f", photos=(half,), density="4", jobs=1, extent=(-0.4, -0.4, 0.4, 0.4)
    )  # fmt: skip
    assert done.sheet is None
    assert done.unit == ""
    assert next(m.code for m in done.warnings) == "facade.no_scale"
    assert (tmp_path / "f/facade.tif").is_file()
    assert not (tmp_path / "f/sheet.pdf").exists()


def test_rectify_refuses_relief_and_names_facade(half, tmp_path):
    with refused("picture.relief") as caught:
        rb.rectify(half / "block", tmp_path / "a.tif", photos=(half,), vertical=True)
    assert "raybundle facade" in str(caught.value)
    assert not list(tmp_path.iterdir())
    done = rb.rectify(half / "block", tmp_path / "a.tif", photos=(half,), vertical=True, relief=1.0)
    assert done.picture.seen.mean() > 0.5


def two_walls(rng):
    """A wall of 600 points, one of 300 around its corner, and cornices of the first."""
    one = np.column_stack([rng.uniform(0, 10, 600), np.zeros(600), rng.uniform(0, 6, 600)])
    other = np.column_stack([np.full(300, 10.0), rng.uniform(2, 8, 300), rng.uniform(0, 6, 300)])
    cornice = np.column_stack([rng.uniform(0, 10, 400), np.full(400, -0.4), rng.uniform(0, 6, 400)])
    return np.concatenate([one, other, cornice])


def test_the_second_wall_is_no_cornice_of_the_first():
    rng = np.random.default_rng(4)
    points = two_walls(rng) + rng.normal(0, 1e-3, (1300, 3))
    first, second = planes_of_most(points, np.full((1300, 3), 1e-3), 0.01, count=2, steep=np.array([0.0, 0.0, 1.0]))
    assert abs(first.normal[1]) > 0.999
    assert abs(second.normal[0]) > 0.999
    assert second.inliers[600:900].mean() > 0.98


def test_the_extent_leaves_out_what_lies_far_away(half):
    block = read_block(half / "block")
    plane = plane_of(block, PlaneAsked(vertical=True))
    extent, _ = wall_extent(plane, block.points.xyz)
    strays = plane.places(np.array([[60.0, 3.0], [61.0, 3.0], [-40.0, 0.0]]))
    again, _ = wall_extent(plane, np.concatenate([block.points.xyz, strays]))
    assert np.allclose(extent, again, atol=0.02)


def test_a_wall_that_is_not_there_is_refused(half):
    with pytest.raises(InputError) as caught:
        plane_of(read_block(half / "block"), PlaneAsked(vertical=True, wall=20))
    assert caught.value.message.code == "plane.no_such_wall"
