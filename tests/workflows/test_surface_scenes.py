"""The surface of satellite scenes, from a block with control to heights in a map, beside the terrain they show."""

import numpy as np
import pytest
from pyproj import CRS

from raybundle.commands.surface import surface
from raybundle.surfaces.depths.depth_map import DepthMap
from raybundle.surfaces.depths.rays.scene import HEIGHT
from raybundle.surfaces.files.heights import read_heights
from tests.surface.scene_pair import write_scenes

rasterio = pytest.importorskip("rasterio")
SIZE = 260


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("scenes")
    terrain = write_scenes(folder, size=SIZE)
    done = surface(
        folder / "block", folder / "surface", photos=(folder,), density="2", dsm=1.5, depths=True, las=True, ortho=1.5,
        jobs=1,
    )  # fmt: skip
    return folder, terrain, done


def errors_of(model, done, terrain):
    """Heights less those of the terrain; NaN where there are none."""
    row, column = np.nonzero(model.known)
    grid = done.surface.heights.grid
    xyz = grid.points_at(column + 0.5, row + 0.5, model.heights.height[row, column].astype(float))
    found = np.full(model.shape, np.nan)
    found[row, column] = xyz[:, 2] - terrain.points(xyz[:, 0], xyz[:, 1])[:, 2]
    return found


def test_heights_of_scenes_have_true_standard_deviations(made):
    folder, terrain, done = made
    model, _ = read_heights(folder / "surface")
    e = errors_of(model, done, terrain)
    known = model.known
    assert known.sum() > 3000
    # what is wrong from cell to cell, by noise and roughness; orientation moves all together
    local = (e - np.median(e[known]))[known] / model.local[known]
    assert 0.8 < np.mean(local**2) < 1.25
    assert np.mean(np.abs(local) < 1.96) > 0.92
    assert np.mean(np.abs(local) > 5) < 5e-3
    # all parts, by the joint covariance of cells so far apart that windows do not overlap
    apart = int(3 * model.length) + 1
    some = np.zeros(known.shape, bool)
    some[::apart, ::apart] = True
    cells = np.flatnonzero(some & known)
    C = model.covariance(*np.meshgrid(cells, cells, indexing="ij"))
    free = np.linalg.solve(np.linalg.cholesky(C), e.ravel()[cells])
    n = len(free)
    assert n > 50
    assert abs((free**2).sum() - n) < 4 * np.sqrt(2 * n)
    share = np.median(model.heights.orientation[known] ** 2 / model.sigma[known] ** 2)
    assert share > 0.5  # five control points of 15 cm say less than the grey values


def test_heights_of_scenes_lie_in_a_map(made):
    folder, _, done = made
    with rasterio.open(folder / "surface/heights.tif") as raster:
        system = CRS(raster.crs.to_wkt())
        assert system.to_2d().to_epsg() == 32633  # of the middle at 15 degrees east, where none is named
        assert len(system.axis_info) == 3  # above the ellipsoid, which the file beside it says
        assert raster.descriptions == (HEIGHT,)
        east = raster.xy(raster.height // 2, raster.width // 2)[0]
        assert 490_000 < east < 510_000
        assert abs(np.nanmedian(raster.read(1)) - 300) < 60  # above the ellipsoid
    assert any("EPSG:32633" in r for r in done.remarks)
    with rasterio.open(folder / "surface/orthophoto.tif") as raster:
        assert raster.crs.to_epsg() == 32633
        pixels = raster.read()
    seen = pixels[-1] > 0
    assert seen.mean() > 0.4
    assert pixels[0][seen].std() > 20  # eleven bits are stretched
    colour = np.concatenate([c.colour for c in done.surface.parts()])
    assert colour.std() > 20


def test_an_orthophoto_of_scenes_shows_the_ground_where_it_is(made):
    folder, terrain, done = made
    model, _ = read_heights(folder / "surface")
    with rasterio.open(folder / "surface/orthophoto.tif") as raster:
        pixels, transform = raster.read(), raster.transform
    row, column = np.nonzero(pixels[-1] > 0)
    plane = done.surface.heights.grid.plane
    east, north = transform.c + transform.a * (column + 0.5), transform.f + transform.e * (row + 0.5)
    uvh = np.column_stack([east, north, np.full(len(east), np.nanmedian(model.heights.height))])
    xyz = plane.points(uvh)
    truth = terrain.at(terrain.grey, np.float32(xyz[None, :, 0]), np.float32(xyz[None, :, 1]))[0]
    shown = pixels[0][row, column].astype(float)
    assert np.corrcoef(truth, shown)[0, 1] > 0.85


def test_depth_maps_of_scenes_hold_heights(made):
    folder, _, done = made
    about = (folder / "surface/depths/depths.toml").read_text()
    assert about.count(f'"depth" = "{HEIGHT}"') == 3
    key = done.surface.maps[0]
    given = done.surface.store.wanted(dict(done.surface.clouds)[0], ("place",))["place"]
    found = DepthMap.of_arrays(done.surface.store.wanted(key)).sure(given)
    with rasterio.open(folder / "surface/depths/ahead.tif") as raster:
        depth, sigma, _ = raster.read()
    good = np.isfinite(found.t)
    assert good.mean() > 0.7
    assert np.ptp(depth[good] - found.t[good]) < 1e-3
    assert (sigma[good] > 0).all()


@pytest.mark.long
def test_tasks_in_other_processes_know_the_scenes(made, tmp_path):
    folder = made[0]
    again = surface(folder / "block", tmp_path / "s", photos=(folder,), density="4", dsm=3.0, jobs=2)
    assert len(again.surface) > 500
    assert again.surface.block.cameras[0].is_scene
