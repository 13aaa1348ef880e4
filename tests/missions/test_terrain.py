"""Heights of the ground, and ways that follow them: over SRTM of a real ridge, within a metre.

jacksboro.tif: 90 x 90 cells of SRTM, 3 seconds of arc, Tennessee (NASA and USGS, public domain), as it comes with the
sample data of matplotlib (jacksboro_fault_dem.npz).
"""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.missions.cases import VEHICLE, mission

from raybundle.errors import InputError
from raybundle.io import raster_library
from raybundle.io.geo.rasters import read_heights
from raybundle.io.missions.areas import in_crs
from raybundle.missions.mission import exposures
from raybundle.missions.report import mission_facts, warnings
from raybundle.missions.terrain import Climbing, ground_of, profile
from raybundle.objects.heights import HeightGrid

SRTM = Path(__file__).with_name("jacksboro.tif")
CRS = "EPSG:32616"
MIDDLE = in_crs(np.array([[-84.255, 36.6]]), "EPSG:4326", CRS)[0]
BOX = np.array([MIDDLE - 1500, MIDDLE + 1500])


def grid(heights, **more):
    given = {"origin": (0.0, 0.0), "column": (10.0, 0.0), "row": (0.0, -10.0)}
    return HeightGrid(heights=np.asarray(heights, float), **{**given, **more})


def test_heights_between_cells():
    g = grid([[1, 2, 3], [4, 5, 6], [7, 8, 9]])
    assert g.at(np.array([[5.0, -5], [20, -20], [0, 0], [-1, 0], [10, 1]])).tolist()[:3] == [3.0, 9.0, 1.0]
    assert np.isnan(g.at(np.array([[-1.0, 0], [10, 1], [0, -20.1]]))).all()
    np.testing.assert_allclose(g.gradient(np.array([[10.0, -10]])), [[0.1, -0.3]])
    assert np.tan(g.slope(np.array([[10.0, -10]]))) == pytest.approx([np.hypot(0.1, 0.3)])
    assert g.cell_m == pytest.approx(10)
    np.testing.assert_allclose(g.place(g.xy(np.array([[1.25, 0.5]]))), [[1.25, 0.5]])


def test_a_turned_grid_is_the_same_plane():
    a, step = np.radians(30), 2.0
    column, row = (step * np.cos(a), step * np.sin(a)), (step * np.sin(a), -step * np.cos(a))
    g = grid(np.zeros((20, 30)), origin=(100.0, 200.0), column=column, row=row)
    xy = g.centres()
    g = replace(g, heights=3 + 0.1 * xy[..., 0] - 0.2 * xy[..., 1])
    at = g.xy(np.random.default_rng(1).uniform([1, 1], [18, 28], (50, 2)))
    np.testing.assert_allclose(g.at(at), 3 + 0.1 * at[:, 0] - 0.2 * at[:, 1])
    np.testing.assert_allclose(g.gradient(at), np.broadcast_to([0.1, -0.2], (50, 2)), atol=1e-9)


def test_holes_are_told_with_place_and_size():
    h = np.ones((6, 8))
    h[1:3, 1:4] = h[5, 7] = np.nan
    g = grid(h)
    large, small = g.holes()
    assert (large.cells, large.xy, large.size_m) == (6, (20.0, -15.0), (30.0, 20.0))
    assert small.cells == 1
    assert g.holes(np.arange(48).reshape(6, 8) >= 40)[0].cells == 1
    assert np.isnan(g.at(np.array([[15.0, -10]])))
    assert g.at(np.array([[40.0, -10]])) == 1  # on a cell with a height, whatever lies beside it
    with pytest.raises(InputError, match=r"15\.0.*-15\.0.*1.*terrain\.void_below_flight"):
        ground_of(g)(np.array([[50.0, -30], [15, -15]]))
    with pytest.raises(InputError, match=r"500\.0.*0\.0.*70\.0.*terrain\.flight_beyond"):
        ground_of(g)(np.array([[500.0, 0]]))


@pytest.mark.parametrize("bad", [{"heights": np.ones(4)}, {"heights": np.full((3, 3), np.nan)}, {"row": (20.0, 0.0)}])
def test_what_is_no_grid(bad):
    with pytest.raises(InputError, match=r"height_grid\.empty|height_grid\.no_cell_area|height_grid\.too_small"):
        grid(**{"heights": np.ones((3, 3)), **bad})


@pytest.fixture(scope="module")
def ridge():
    return read_heights(SRTM, CRS, BOX)


def test_a_raster_in_degrees_is_brought_over(ridge):
    rasterio = pytest.importorskip("rasterio")
    assert ridge.remarks[-1].message.code == "raster.transformed"
    assert ridge.remarks[-1].message.values["system"] == "degrees"
    assert ridge.cell_m == pytest.approx(83.1, abs=0.5)  # 3" at 36.6 deg: 92.6 m by 74.5 m
    with rasterio.open(SRTM) as source:
        table, t = source.read(1).astype(float), source.transform
    rng = np.random.default_rng(2)
    xy = rng.uniform(BOX[0] + 200, BOX[1] - 200, (200, 2))
    lonlat = in_crs(xy, CRS, "EPSG:4326")
    own = HeightGrid(heights=table, origin=(t.c + t.a / 2, t.f + t.e / 2), column=(t.a, t.d), row=(t.b, t.e))
    off = ridge.at(xy) - own.at(lonlat)
    # interpolated twice: a few metres on slopes of cells as large as these, none in the mean
    assert abs(off.mean()) < 0.5
    assert np.sqrt(np.mean(off**2)) < 0.05 * np.ptp(table) / 4


@pytest.mark.parametrize("pattern", ["nadir", "double-grid", "oblique-grid", "corridor"])
def test_the_way_keeps_its_height_above_a_real_ridge_to_one_metre(ridge, pattern):
    ground = ground_of(ridge)
    if pattern == "corridor":
        outline = MIDDLE + np.array([[-500.0, -300], [200, 0], [500, 500]])
    else:
        outline = MIDDLE + np.array([[-400.0, -300], [400, -300], [400, 300], [-400, 300]])
    vehicle = replace(VEHICLE, minutes=400.0, climb=8.0, descent=8.0)
    m = mission(
        pattern, ground=ground, outline=outline, crs=CRS, vehicle=vehicle, speed=8.0, terrain="srtm", ground_step=5.0,
        take_off=tuple(outline[0]), more={"width": 100.0},
    )  # fmt: skip
    relief = np.ptp(ground(outline))
    assert relief > 30
    w = m.way_points
    asked = CAMERA_ABOVE[pattern]
    for line in range(len(m.lines)):
        xyz = w.xyz[w.line == line]
        way = np.append(0, np.cumsum(np.linalg.norm(np.diff(xyz[:, :2], axis=0), axis=1)))
        s = np.arange(0, way[-1], 2.0)
        fine = np.stack([np.interp(s, way, xyz[:, j]) for j in range(3)], axis=1)
        above = fine[:, 2] - ground(fine[:, :2])
        tilted = np.degrees(w.pitch[w.line == line][0]) > -89
        np.testing.assert_allclose(above, asked * (np.cos(np.radians(35)) if tilted else 1.0), atol=1.0)
    # on the way between lines as well nothing is hit
    assert (w.xyz[:, 2] - ground(w.xyz[:, :2])).min() > asked * np.cos(np.radians(35)) - 3


CAMERA_ABOVE = dict.fromkeys(("nadir", "double-grid", "oblique-grid", "corridor"), 3751.0 * 0.02)


def test_few_points_do_on_a_plane_and_none_climbs_too_steeply():
    xy = np.array([[0.0, 0], [400, 0]])
    plane = profile(xy, np.array([50.0, 50]), lambda p: 0.2 * p[:, 0], Climbing(up=0.5, down=0.5))
    assert len(plane.xyz) == 2
    assert plane.raised < 1e-9
    step = profile(xy, np.array([50.0, 50]), lambda p: np.where(p[:, 0] > 200, 60.0, 0.0), Climbing(up=0.5, down=0.3))
    slope = np.diff(step.xyz[:, 2]) / np.diff(step.xyz[:, 0])
    assert slope.max() < 0.51
    assert step.raised == pytest.approx(60, abs=2.6)  # at the foot of the step the way is as high as above it
    fine = np.linspace(0, 400, 401)
    assert (
        np.interp(fine, step.xyz[:, 0], step.xyz[:, 2]) - np.where(fine > 200, 60, 0)
    ).min() > 47.4  # a wall between two places that are looked at, 5 m apart


def test_what_a_slow_climber_cannot_follow_is_told(ridge):
    slow = replace(VEHICLE, climb=0.5, descent=0.5, minutes=400.0)
    outline = MIDDLE + np.array([[-400.0, -300], [400, -300], [400, 300], [-400, 300]])
    m = mission("nadir", ground=ground_of(ridge), outline=outline, crs=CRS, vehicle=slow, take_off=tuple(outline[0]))
    assert "mission.ground_too_steep" in [r.message.code for r in m.remarks]
    e = exposures(m)
    assert (e.xyz[:, 2] - ridge.at(e.xyz[:, :2])).min() > CAMERA_ABOVE["nadir"] - 1


def test_the_least_overlap_over_high_ground_is_told(ridge):
    """A flight of one height over a ridge: the overlap there is that of the smaller height."""
    outline = MIDDLE + np.array([[-400.0, -300], [400, -300], [400, 300], [-400, 300]])
    low = float(ridge.at(outline).min())
    m = mission("nadir", ground=lambda xy: np.full(len(xy), low), outline=outline, crs=CRS, take_off=tuple(outline[0]),
                vehicle=replace(VEHICLE, minutes=400.0), more={"distance": 400.0})  # fmt: skip
    facts = mission_facts(m, ridge.at)
    e = exposures(m)
    least = (e.xyz[:, 2] - ridge.at(e.xyz[:, :2])).min()
    expected = 1 - m.base / (least * m.camera.height_px / m.camera.c_px)
    assert expected < facts.along.low < expected + 0.15  # the summit is a part of the photograph alone
    assert facts.along.high > 0.79
    assert any(w.code == "mission.overlap_low" for w in warnings(m, facts))


def raster(path, heights, **more):
    rasterio = pytest.importorskip("rasterio")
    given = {
        "driver": "GTiff", "height": heights.shape[0], "width": heights.shape[1], "count": 1, "dtype": heights.dtype,
        "crs": "EPSG:32632", "transform": rasterio.Affine(10, 0, 364_000, 0, -10, 5_552_000),
    }  # fmt: skip
    unit = more.pop("unit", None)
    with rasterio.open(path, "w", **{**given, **more}) as f:
        f.write(heights, 1)
        if unit:
            f.set_band_unit(1, unit)
    return path


HERE = np.array([[364_050.0, 5_551_700], [364_250, 5_551_900]])


def test_a_raster_of_the_same_system_is_taken_as_it_is(tmp_path):
    table = np.random.default_rng(3).uniform(90, 110, (60, 50)).astype(np.float32)
    g = read_heights(raster(tmp_path / "a.tif", table, unit="m"), "EPSG:32632", HERE)
    assert g.remarks == ()
    assert g.heights.size < table.size
    assert g.at(np.array([[364_105.0, 5_551_795]])) == pytest.approx(table[20, 10])


def test_feet_become_metres_and_are_asked_for_where_nobody_says(tmp_path):
    table = np.full((60, 50), 328.0, np.float32)
    path = raster(tmp_path / "feet.tif", table, unit="ft")
    g = read_heights(path, "EPSG:32632", HERE)
    assert np.nanmax(g.heights) == pytest.approx(328 * 0.3048)
    assert g.remarks[0].message.code == "raster.feet"
    with pytest.raises(InputError, match=r"dem_unit.*raster\.unit_differs"):
        read_heights(path, "EPSG:32632", HERE, unit="m")
    rasterio = pytest.importorskip("rasterio")
    xy = in_crs(np.array([[-84.0, 36.0]]), "EPSG:4326", "EPSG:2274")[0]  # Tennessee, US survey feet
    t = rasterio.Affine(30, 0, xy[0] - 1000, 0, -30, xy[1] + 1000)
    path = raster(tmp_path / "state.tif", np.full((80, 80), 328.0, np.float32), crs="EPSG:2274", transform=t)
    middle = in_crs(xy[None], "EPSG:2274", CRS)[0]
    with pytest.raises(InputError, match=r"dem_unit.*raster\.dem_unit_missing"):
        read_heights(path, CRS, np.array([middle - 100, middle + 100]))
    g = read_heights(path, CRS, np.array([middle - 100, middle + 100]), unit="us-ft")
    assert g.at(middle[None]) == pytest.approx(328 * 1200 / 3937, abs=1e-4)
    assert g.cell_m == pytest.approx(30 * 1200 / 3937, rel=1e-3)


def test_rasters_that_are_of_no_use(tmp_path):
    table = np.full((60, 50), 100.0, np.float32)
    with pytest.raises(InputError, match=r"raster\.no_system"):
        read_heights(raster(tmp_path / "n.tif", table, crs=None), "EPSG:32632", HERE)
    with pytest.raises(InputError, match=r"raster\.no_overlap"):
        read_heights(raster(tmp_path / "f.tif", table), "EPSG:32632", HERE + 10_000)
    holes = table.copy()
    holes[20:25, 10:20] = -9999
    with pytest.raises(InputError, match=r"raster\.impossible_heights"):
        read_heights(raster(tmp_path / "h.tif", holes), "EPSG:32632", HERE)
    g = read_heights(raster(tmp_path / "h2.tif", holes, nodata=-9999), "EPSG:32632", HERE)
    assert g.holes()[0].cells == 50
    with pytest.raises(InputError, match=r"3.*1.*raster\.band_missing"):
        read_heights(tmp_path / "f.tif", "EPSG:32632", HERE, band=3)
    (tmp_path / "x.tif").write_bytes(b"II*\0 nothing")
    with pytest.raises(InputError, match=r"raster\.not_readable"):
        read_heights(tmp_path / "x.tif", "EPSG:32632", HERE)
    with pytest.raises(InputError, match=r"raster\.unit_unknown"):
        read_heights(raster(tmp_path / "u.tif", table, unit="fathom"), "EPSG:32632", HERE)
    with pytest.raises(InputError, match=r"file\.missing"):
        read_heights(tmp_path / "none.tif", "EPSG:32632", HERE)


def test_a_missing_library_is_told(monkeypatch):
    def without(name):
        raise ImportError(name)

    monkeypatch.setattr(raster_library, "import_module", without)
    with pytest.raises(InputError, match=r"package\.rasterio_missing"):
        read_heights(SRTM, CRS, BOX)
