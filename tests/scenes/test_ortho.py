"""Orthorectification: where each pixel looks, against the RPC itself and against GDAL's warp over the same heights."""

import warnings

import numpy as np
import pytest
from pyproj import Transformer

import raybundle as rb
from raybundle.cli.main import main
from raybundle.errors import InputError, code_of
from raybundle.io.geo.ground import opened_ground
from raybundle.io.pictures.resampling import between, sampled
from raybundle.io.scenes.pictures import ArrayPicture
from raybundle.workflows.scenes.ortho import ground_of_rays, ortho_of
from tests.cli.reported import reported, values_of
from tests.conftest import DATA
from tests.messages import coded

rasterio = pytest.importorskip("rasterio")
pytest.importorskip("rasterio.warp")
UTM = "EPSG:32637"
SIZE = (420, 360)


@pytest.fixture(scope="module")
def part(rpc):
    """A part of the scene, 60 cm of the ground a pixel."""
    return rpc.shifted(np.array(SIZE) / 2 - [3950.0, 3500.0]).spread_over(np.array(SIZE))


def texture(x, y):
    """Grey values of places [m], with no detail finer than ten metres."""
    return 900 + 300 * np.sin(x / 9) * np.cos(y / 13) + 250 * np.sin((x + 2 * y) / 31) + 150 * np.cos((x - y) / 71)


def hills(x, y):
    """Heights above the ellipsoid [m]: up to 90 m of relief within 400 m, slopes of up to 40 degrees."""
    return 420 + 30 * np.sin(x / 60) + 25 * np.cos(y / 45) + 5 * np.sin((x + y) / 20)


def write(path, values, *, crs=UTM, transform=None, **more):
    values = values if values.ndim == 3 else values[None]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with rasterio.open(
            path, "w", driver="GTiff", width=values.shape[2], height=values.shape[1], count=len(values),
            dtype=values.dtype, crs=crs, transform=transform or rasterio.Affine.identity(), **more,
        ) as raster:  # fmt: skip
            raster.write(values)
    return path


@pytest.fixture(scope="module")
def middle(part):
    x, y = Transformer.from_crs("EPSG:4979", UTM, always_xy=True).transform(
        *part.localise([np.array(SIZE) / 2], 420.0)[0, :2]
    )
    return np.floor(np.array([x, y]))


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("ortho")


@pytest.fixture(scope="module")
def dem(folder, middle):
    """Heights in UTM, cells of 2 m."""
    x0, y0 = middle - 500
    x, y = np.meshgrid(x0 + 2 * np.arange(500) + 1, y0 + 1000 - 2 * np.arange(500) - 1)
    z = hills(x - middle[0], y - middle[1]).astype("float32")
    return write(folder / "dem.tif", z, transform=rasterio.Affine(2, 0, x0, 0, -2, y0 + 1000), nodata=-9999)


@pytest.fixture(scope="module")
def scene_file(folder, part, middle, dem):
    """What the RPC sees of the hills, in two bands."""
    rows, columns = np.indices(SIZE[::-1])
    pixels = np.stack([columns.ravel() + 0.5, rows.ravel() + 0.5], axis=1)
    with opened_ground(dem) as ground:
        places, known = ground_of_rays(part, ground, pixels)
    assert known.all()
    x, y = Transformer.from_crs("EPSG:4979", UTM, always_xy=True).transform(*places[:, :2].T)
    grey = texture(x - middle[0], y - middle[1]).reshape(SIZE[::-1])
    file = write(folder / "scene.tif", np.stack([grey, 2000 - grey]).astype("uint16"), crs=None)
    with rasterio.open(file, "r+") as raster:
        raster.rpcs = part.to_rasterio()
    return file


def exact_places(part, done_or_grid, middle):
    """Where the RPC itself sees the centres of the pixels of a map over the hills."""
    g = done_or_grid
    x, y = np.meshgrid(g.left + (np.arange(g.width) + 0.5) * g.pixel, g.top - (np.arange(g.height) + 0.5) * g.pixel)
    return x, y


def test_the_truth(scene_file, dem, middle):
    """The map shows the texture where it is: the geometry is right as a whole."""
    done = rb.rpc_ortho(scene_file, dem, crs=UTM, pixel=0.5)
    assert done.crs == UTM
    assert done.values.shape == (2, done.height, done.width)
    x, y = exact_places(None, done, middle)
    seen = done.values[0] > 0
    assert seen.mean() == pytest.approx(done.share)
    assert done.share > 0.6
    true = texture(x - middle[0], y - middle[1])
    off = (done.values[0] - true)[seen]
    # 60 cm pixels of a texture whose steepest slope is 60 grey values a metre; rounding to integers on both ways
    assert np.sqrt(np.mean(off**2)) < 1.5
    assert np.abs((done.values[0] + done.values[1].astype(int))[seen] - 2000).max() <= 3


def test_places_are_those_of_the_rpc(scene_file, dem, part, middle):
    """Interpolated at every pixel, against the RPC at each of them: a hundredth of a pixel at most."""
    with opened_ground(dem) as ground:
        plan = ortho_of(part, SIZE, ground, crs=UTM, pixel=0.5, area=None, kernel="cubic")
        to_wgs84 = Transformer.from_crs(UTM, "EPSG:4979", always_xy=True)
        largest = 0.0
        for tile in plan.tiles():
            column, row, width, height = tile
            found = plan.places(*tile)
            x, y = np.meshgrid(
                plan.grid.left + (column + np.arange(width) + 0.5) * 0.5,
                plan.grid.top - (row + np.arange(height) + 0.5) * 0.5,
            )
            xy = np.stack([x.ravel(), y.ravel()], axis=1)
            h = ground.at(ground.cells(xy))
            lon, lat, _ = to_wgs84.transform(*xy.T, np.zeros(len(xy)))
            there = np.isfinite(h)
            exact = part.project(np.stack([lon, lat, h], axis=1)[there])
            largest = max(largest, np.abs(found.reshape(-1, 2)[there] - exact).max())
        assert largest < 0.01


def warped(scene_file, dem, done, kernel="bilinear", **more):
    """What GDAL makes of the same scene, heights and map, without approximation."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with rasterio.open(scene_file) as source:
            bands = np.zeros((done.bands, done.height, done.width), "uint16")
            values, _ = rasterio.warp.reproject(
                source.read(), bands, rpcs=source.rpcs, src_crs="EPSG:4326", dst_transform=done.transform,
                dst_crs=done.crs, resampling=rasterio.enums.Resampling[kernel], tolerance=0, RPC_DEM=str(dem),
                RPC_DEMINTERPOLATION="bilinear", **more,
            )  # fmt: skip
    return values


@pytest.mark.parametrize("kernel", ["nearest", "bilinear", "cubic"])
def test_gdal_makes_the_same_map(scene_file, dem, kernel):
    """Grey values and, by the gradient, places."""
    done = rb.rpc_ortho(scene_file, dem, crs=UTM, pixel=0.5, resampling=kernel)
    peer = warped(scene_file, dem, done, kernel)
    both = (done.values[0] > 0) & (peer[0] > 0)
    assert both.mean() > 0.99 * done.share
    off = (done.values[0].astype(float) - peer[0])[both]
    if kernel == "nearest":
        assert (off == 0).mean() > 0.99
        return
    assert np.abs(off.mean()) < 0.1
    assert np.sqrt(np.mean(off**2)) < 1.0  # of 1800 grey values
    gradient = np.stack(np.gradient(peer[0].astype(float)), axis=-1)[both]
    shift = np.linalg.lstsq(gradient, off, rcond=None)[0]
    assert np.abs(shift).max() < 0.01  # px of the map


def test_heights_in_degrees_and_above_a_geoid(scene_file, folder, dem, middle):
    """The same ground, its heights told in another system and above a geoid: the same map."""
    done = rb.rpc_ortho(scene_file, dem, crs=UTM, pixel=0.5)
    area = (done.left, done.top - done.height * 0.5, done.left + done.width * 0.5, done.top)
    to_map = Transformer.from_crs("EPSG:4326", UTM, always_xy=True)
    west, south = Transformer.from_crs(UTM, "EPSG:4326", always_xy=True).transform(*(middle - 520))
    step = 1e-5
    lon, lat = np.meshgrid(west + step * (np.arange(1250) + 0.5), south + 0.0095 - step * (np.arange(950) + 0.5))
    x, y = to_map.transform(lon, lat)
    low = (hills(x - middle[0], y - middle[1]) - 17.25).astype("float32")
    transform = rasterio.Affine(step, 0, west, 0, -step, south + 0.0095)
    file = write(folder / "degrees.tif", low, crs="EPSG:4326", transform=transform)
    other = rb.rpc_ortho(scene_file, file, crs=UTM, pixel=0.5, undulation=17.25, extent=area)
    assert (other.width, other.height) == (done.width, done.height)
    both = (done.values[0] > 0) & (other.values[0] > 0)
    assert both.mean() > 0.95 * done.share
    assert np.sqrt(np.mean((done.values[0].astype(float) - other.values[0])[both] ** 2)) < 3
    wrong = rb.rpc_ortho(scene_file, file, crs=UTM, pixel=0.5, extent=area)  # as if they were ellipsoidal
    assert np.sqrt(np.mean((done.values[0].astype(float) - wrong.values[0])[both] ** 2)) > 20
    assert any("EPSG:4326+5773" in r for r in wrong.remarks)


def test_a_geoid_by_its_system(folder, scene_file, dem, capsys):
    """Through PROJ where its grid is installed; else an error that says where it is got, and nothing is written."""
    words = [
        "rpc",
        "ortho",
        str(scene_file),
        "--dem",
        str(dem),
        "--geoid",
        "EPSG:5773",
        "--out",
        str(folder / "g.tif"),
    ]
    status = main(words)
    captured = capsys.readouterr()
    assert status in {0, 2}
    if status == 2:
        assert "[crs.geoid_missing]" in captured.err
        assert not (folder / "g.tif").exists()
    with pytest.raises(InputError, match=r"raster\.geoid_unknown"):
        rb.rpc_ortho(scene_file, dem, geoid="EPSG:32637")
    with pytest.raises(InputError, match=r"raster\.geoid_and_undulation"):
        rb.rpc_ortho(scene_file, dem, geoid="EPSG:5773", undulation=3.0)
    place = rasterio.Affine(9, 0, 5e5, 0, -9, 4.5e6)
    compound = write(folder / "egm.tif", np.full((50, 50), 400.0), crs="EPSG:32637+5773", transform=place)
    with pytest.raises(InputError, match=r"crs\.geoid_missing"):
        rb.rpc_ortho(scene_file, compound)
    with pytest.raises(InputError, match=r"EGM96.*EGM2008.*raster\.geoid_differs"):
        rb.rpc_ortho(scene_file, compound, geoid="EPSG:3855")


@pytest.mark.parametrize("how", ["the raster says it", "geoid"])
def test_the_geoid_goes_through_its_grid(how, scene_file, folder, dem, middle, geoid_grid):
    """Heights above EGM96, whose grid is one of our own making, give the map of those above the ellipsoid."""
    want = rb.rpc_ortho(scene_file, dem, crs=UTM, pixel=0.5)
    with rasterio.open(dem) as raster:
        z, transform = raster.read(1), raster.transform
    x, y = np.meshgrid(transform.c + 2 * np.arange(500) + 1, transform.f - 2 * np.arange(500) - 1)
    lon, lat = Transformer.from_crs(UTM, "EPSG:4326", always_xy=True).transform(x.ravel(), y.ravel())
    above = z - geoid_grid(np.stack([lon, lat], axis=1)).reshape(z.shape)
    stated = how != "geoid"
    file = write(
        folder / f"egm{stated}.tif", above.astype("float32"), crs=f"{UTM}+5773" if stated else UTM, transform=transform
    )
    found = rb.rpc_ortho(scene_file, file, crs=UTM, pixel=0.5, geoid=None if stated else "EPSG:5773")
    assert not found.remarks
    off = found.values.astype(int) - want.values
    assert np.abs(off).max() <= 2
    assert np.abs(off.mean()) < 0.01


def test_written_by_tiles(folder, scene_file, dem, capsys):
    out = folder / "ortho.tif"
    words = ["rpc", "ortho", str(scene_file), "--dem", str(dem), "--crs", UTM, "--pixel", "0.5", "--out", str(out)]
    found = reported(capsys, *words)
    assert values_of(found, ["summary"])["scene.ortho"]["crs"] == UTM
    assert "picture.hidden_places" in values_of(found, ["notes"])
    done = rb.rpc_ortho(scene_file, dem, crs=UTM, pixel=0.5)
    with rasterio.open(out) as raster:
        assert np.array_equal(raster.read(), done.values)
        assert raster.transform == done.transform
        assert raster.crs.to_epsg() == 32637
        assert (raster.nodata, raster.profile["tiled"], raster.profile["compress"]) == (0, True, "deflate")
        assert raster.overviews(1)
        assert raster.tags()["AREA_OR_POINT"] == "Area"
    assert main(words) == 2
    assert "[file.exists]" in capsys.readouterr().err
    assert main([*words[:-1], str(folder / "a.png")]) == 2
    assert "[file.suffix]" in capsys.readouterr().err
    assert main(words[:-2]) == 2
    assert "--out FILE.tif" in capsys.readouterr().err


def test_usual_system_pixel_and_area(scene_file, dem):
    done = rb.rpc_ortho(scene_file, dem)
    assert done.crs == UTM
    assert 0.5 < done.pixel < 1.0
    assert done.left / done.pixel == pytest.approx(round(done.left / done.pixel), abs=1e-6)
    assert done.share > 0.6


def test_larger_pixels_are_means(scene_file, dem, middle):
    """Eight pixels of the scene in one of the map: averaged before, not every eighth taken."""
    done = rb.rpc_ortho(scene_file, dem, crs=UTM, pixel=5.0)
    x, y = exact_places(None, done, middle)
    steps = np.linspace(-2.4, 2.4, 9)
    fine = np.mean([texture(x - middle[0] + a, y - middle[1] + b) for a in steps for b in steps], axis=0)
    inner = np.s_[4:-4, 4:-4]
    seen = done.values[0][inner] > 0
    off = (done.values[0][inner] - fine[inner])[seen]
    assert np.sqrt(np.mean(off**2)) < 15  # of a texture of +- 700


def test_holes_and_the_edge_of_heights(scene_file, folder, dem, middle):
    with rasterio.open(dem) as raster:
        z, transform = raster.read(1), raster.transform
    z[240:260, 240:260] = -9999
    file = write(folder / "holes.tif", z, transform=transform, nodata=-9999)
    done = rb.rpc_ortho(scene_file, file, crs=UTM, pixel=0.5)
    x, y = exact_places(None, done, middle)
    hole = (np.abs(x - middle[0]) < 18) & (np.abs(y - middle[1]) < 18)
    assert (done.values[0][hole] == 0).all()
    assert (done.values[0][~hole & (np.abs(x - middle[0]) < 60) & (np.abs(y - middle[1]) < 60)] > 0).mean() > 0.8
    far = write(folder / "far.tif", z, transform=rasterio.Affine(2, 0, 4e5, 0, -2, 4e6), nodata=-9999)
    with pytest.raises(InputError, match=r"scene\.not_covered"):
        rb.rpc_ortho(scene_file, far)
    odd = write(folder / "odd.tif", np.where(z < 0, 99999, z), transform=transform)
    with pytest.raises(InputError, match=r"raster\.impossible_heights"):
        rb.rpc_ortho(scene_file, odd)
    nowhere = write(folder / "nowhere.tif", z, crs=None, transform=transform)
    with pytest.raises(InputError, match=r"raster\.no_system"):
        rb.rpc_ortho(scene_file, nowhere)
    with pytest.raises(InputError, match=r"scene\.outside_map"):
        rb.rpc_ortho(scene_file, dem, crs=UTM, pixel=0.5, extent=(5e5, 4e6, 5.001e5, 4.0001e6))
    with pytest.raises(InputError, match=r"crs\.plane_needed"):
        rb.rpc_ortho(scene_file, dem, crs="EPSG:32637+5773")


def test_heights_that_the_rpc_was_not_made_for_are_told(scene_file, folder, dem, part):
    with rasterio.open(dem) as raster:
        z, transform = raster.read(1), raster.transform
    feet = write(folder / "feet.tif", (z / 0.3048).astype("float32"), transform=transform)
    done = rb.rpc_ortho(scene_file, feet, crs=UTM, pixel=2)
    found = coded(done.remarks)["scene.ground_outside_heights"]
    assert (found["lowest_m"], found["highest_m"]) == pytest.approx((-100, 900))
    with rasterio.open(feet, "r+") as raster:
        raster.units = ("ft",)
    done = rb.rpc_ortho(scene_file, feet, crs=UTM, pixel=2)
    assert not any("the RPC holds" in r for r in done.remarks)
    assert "raster.feet" in map(code_of, done.remarks)
    want = rb.rpc_ortho(scene_file, dem, crs=UTM, pixel=2)
    assert np.abs(done.values.astype(int) - want.values).max() <= 2


def test_pixels_of_the_scene_that_mean_nothing(scene_file, folder, dem, part):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with rasterio.open(scene_file) as raster:
            values = raster.read()
    values[:, 250:300, 300:350] = 7
    file = write(folder / "nothing.tif", values, crs=None, nodata=7)
    done = rb.rpc_ortho(file, dem, crs=UTM, pixel=0.5, rpc=part)
    full = rb.rpc_ortho(scene_file, dem, crs=UTM, pixel=0.5)
    assert done.nodata == 7
    lost = (done.values[0] == 7) & (full.values[0] > 0)
    across, along = np.linalg.norm(part.pixel_on_ground(), axis=1) / 0.5
    assert lost.sum() == pytest.approx(53 * 53 * across * along, rel=0.1)  # and what would be made of them
    seen = (done.values[0] != 7) & (full.values[0] > 0)
    assert np.array_equal(done.values[:, seen], full.values[:, seen])  # nothing of them is mixed in
    with pytest.raises(InputError, match=r"uint16.*scene\.no_data_type"):
        rb.rpc_ortho(file, dem, rpc=part, nodata=-1)
    floats = write(folder / "floats.tif", values.astype("float32"), crs=None)
    assert np.isnan(rb.rpc_ortho(floats, dem, rpc=part, pixel=4).nodata)


def test_objects_of_rasterio_and_rioxarray_in_and_out(scene_file, dem, part, folder):
    rioxarray = pytest.importorskip("rioxarray")
    want = rb.rpc_ortho(scene_file, dem, crs=UTM, pixel=0.5)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with rasterio.open(scene_file) as scene, rasterio.open(dem) as heights:
            found = rb.rpc_ortho(scene, heights, crs=UTM, pixel=0.5)
            assert np.array_equal(found.values, want.values)
        array, ground = rioxarray.open_rasterio(scene_file), rioxarray.open_rasterio(dem, masked=True)
        found = rb.rpc_ortho(array, ground, crs=UTM, pixel=0.5)
        assert np.array_equal(found.values, want.values)
        moved = array.copy()
        moved.encoding = {}
        with pytest.raises(InputError, match=r"RPC.*scene\.object_without_rpc"):
            rb.rpc_ortho(moved, ground)
        for rpc in (part, part.to_rasterio(), scene_file):
            found = rb.rpc_ortho(moved, ground, crs=UTM, pixel=0.5, rpc=rpc)
            assert np.array_equal(found.values, want.values)
        out = want.to_rioxarray()
        assert out.rio.crs.to_epsg() == 32637
        assert out.rio.transform() == want.transform
        assert out.rio.nodata == 0
        assert np.array_equal(out.values, want.values)
        written = rb.rpc_ortho(scene_file, dem, folder / "rio.tif", crs=UTM, pixel=0.5)
        assert written.values is None
        assert np.array_equal(written.to_rioxarray().values, want.values)


# the resampler


def test_values_between_pixels():
    rng = np.random.default_rng(1)
    rows, columns = np.indices((40, 50))
    plane = 3.0 * columns + 2.0 * rows + 10
    xy = rng.uniform([3, 3], [46, 36], (20, 30, 2))
    for kernel in ("bilinear", "cubic"):
        values, seen = sampled(plane, xy, kernel)
        assert seen.all()
        exact = 3.0 * (xy[..., 0] - 0.5) + 2.0 * (xy[..., 1] - 0.5) + 10
        assert np.abs(values - exact).max() < 1e-10
    parabola = 0.1 * (columns - 20.0) ** 2 - 0.2 * rows * columns
    x, y = xy[..., 0] - 0.5, xy[..., 1] - 0.5
    values, _ = sampled(parabola, xy, "cubic")
    assert np.abs(values - (0.1 * (x - 20) ** 2 - 0.2 * y * x)).max() < 1e-10
    values, _ = sampled(plane, np.floor(xy) + 0.5, "cubic")
    assert np.abs(values - (3.0 * np.floor(xy[..., 0]) + 2.0 * np.floor(xy[..., 1]) + 10)).max() < 1e-6


@pytest.mark.parametrize("dtype", ["uint8", "uint16", "int16", "int32", "uint32", "float32", "float64"])
@pytest.mark.parametrize("bands", [1, 3, 4, 8])
def test_every_kind_of_picture(dtype, bands):
    rng = np.random.default_rng(2)
    picture = rng.integers(0, 120, (30, 40, bands)).astype(dtype)
    rows, columns = np.indices((30, 40))
    values, seen = sampled(picture, np.stack([columns + 0.5, rows + 0.5], axis=2), "cubic")
    assert values.dtype == picture.dtype
    assert seen.all()
    assert np.array_equal(values, picture)
    one, _ = sampled(picture[..., 0], np.full((2, 2, 2), 3.2))
    assert one.shape == (2, 2)


@pytest.mark.parametrize(("kernel", "reach"), [("nearest", (0, 0)), ("bilinear", (0, 1)), ("cubic", (-1, 2))])
def test_nothing_is_made_of_what_means_nothing(kernel, reach):
    picture, known = np.full((20, 20), 5.0), np.ones((20, 20), bool)
    picture[10, 10], known[10, 10] = np.nan, False
    fine = np.linspace(4.0, 16.0, 97)
    xy = np.stack(np.meshgrid(fine, fine), axis=2)
    values, seen = sampled(picture, xy, kernel, known)
    assert np.isfinite(values[seen]).all()
    base = np.floor(xy - 0.5) if kernel != "nearest" else np.floor(xy)
    touched = ((base + reach[0] <= 10) & (base + reach[1] >= 10)).all(axis=2)
    assert np.array_equal(~seen, touched)
    edge, known = np.full((5, 5), 5.0), np.ones((5, 5), bool)
    edge[0, 0], known[0, 0] = np.nan, False  # repeated beyond the picture
    fine = np.linspace(0.0, 5.0, 41)
    values, seen = sampled(edge, np.stack(np.meshgrid(fine, fine), axis=2), kernel, known)
    assert np.isfinite(values[seen]).all()


def test_beside_the_picture_there_is_nothing():
    xy = np.array([[[-0.01, 5], [0.0, 5.0], [10.0, 5], [10.01, 5], [np.nan, 5]]])
    values, seen = sampled(np.ones((10, 10)), xy)
    assert seen.tolist() == [[False, True, True, False, False]]
    assert (values[seen] == 1).all()


def test_between_corners():
    corners = np.stack(np.meshgrid(np.arange(4.0), np.arange(3.0)), axis=2)
    fine = between(corners, 16)
    assert fine.shape == (32, 48, 2)
    assert np.abs(fine[..., 0] - np.arange(48) / 16).max() < 1e-12
    assert np.abs(fine[:, 0, 1] - np.arange(32) / 16).max() < 1e-12


def test_means_of_an_array():
    values = np.arange(2 * 7 * 9, dtype="float32").reshape(2, 7, 9)
    values[:, 0, 0] = np.nan
    picture = ArrayPicture(values)
    found, seen = picture.window(0, 0, 9, 7, 2)
    assert found.shape == (4, 5, 2)
    assert not seen[0, 0]
    assert seen.sum() == 19
    assert found[1, 1, 0] == values[0, 2:4, 2:4].mean()


# real pictures over the surfaces that were made of them


@pytest.mark.parametrize(("name", "count"), [("pair", 2), ("triplet", 3)])
def test_pictures_of_s2p_over_its_own_surface(name, count):
    """Each view shows the same in the map, to the pointing errors of about a pixel that s2p takes off; GDAL agrees."""
    folder = DATA / "sensors/s2p"
    if not folder.is_dir():
        pytest.skip("the files of s2p are not there")
    surface = folder / f"expected_output/{name}/dsm.tif"
    with rasterio.open(surface) as raster:
        crs, bounds = raster.crs.to_string(), tuple(raster.bounds)
    maps = []
    for k in range(1, count + 1):
        picture = folder / f"input_{name}/img_0{k}.tif"
        done = rb.rpc_ortho(picture, surface, crs=crs, pixel=0.5, extent=bounds, resampling="bilinear")
        peer = warped(picture, surface, done)[0].astype(float)
        mine = done.values[0].astype(float)
        both = (mine > 0) & (peer > 0)
        inner = both & np.roll(both, 3, 0) & np.roll(both, -3, 0) & np.roll(both, 3, 1) & np.roll(both, -3, 1)
        assert np.sqrt(np.mean((mine - peer)[inner] ** 2)) < 0.02 * mine[inner].std()
        maps.append(mine)
    for other in maps[1:]:
        best = 0.0
        for shift in [(dy, dx) for dx in range(-2, 3) for dy in range(-2, 3)]:
            moved = np.roll(other, shift, (0, 1))
            shared = (maps[0] > 0) & (moved > 0)
            best = max(best, np.corrcoef(maps[0][shared], moved[shared])[0, 1])
        assert best > 0.94
