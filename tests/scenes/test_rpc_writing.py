"""RPC into files: GDAL reads what is written and projects to the same place; what an RPC says of its errors."""

import json
import re
import shutil
import sys
import warnings
from dataclasses import replace

import numpy as np
import pytest

import raybundle as rb
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.scenes import read_scene
from raybundle.io.scenes.writing import files_before_the_tag, write_rpc
from raybundle.numerics.geodesy import metres_per_geographic
from raybundle.scenes.bias import bias_design
from raybundle.scenes.bias_blunders import solve_bias
from raybundle.scenes.bias_choice import choose_bias
from raybundle.scenes.rasterio_rpc import rpc_from_rasterio
from raybundle.scenes.rpc_errors import errors_of_covariance, ground_errors
from raybundle.words import headline
from tests.conftest import DATA
from tests.messages import refused
from tests.scenes.test_cli import control

rasterio = pytest.importorskip("rasterio")
pytest.importorskip("rasterio.shutil")
pytest.importorskip("rasterio.transform")
SAME_PX = 1e-9
SIZE = (8000, 7000)


@pytest.fixture
def picture(rpc, tmp_path):
    """A GeoTIFF of the whole scene, most of it empty blocks, with the RPC in its tag."""
    return write_picture(tmp_path / "scene.tif", rpc)


def write_picture(path, rpc, size=SIZE, dtype="uint16"):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with rasterio.open(
            path, "w", driver="GTiff", width=size[0], height=size[1], count=1, dtype=dtype, tiled=True, sparse_ok=True
        ) as raster:
            values = np.random.default_rng(1).integers(1, 2000, (64, 64)).astype(dtype)
            raster.write(values, 1, window=rasterio.windows.Window(64, 64, 64, 64))
            if rpc is not None:
                raster.rpcs = rpc.to_rasterio()
    return path


def of_gdal(path):
    """The RPC that GDAL finds for a picture."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with rasterio.open(path) as raster:
            return raster.rpcs


def gdal_px(rpcs, ground):
    with rasterio.transform.RPCTransformer(rpcs) as transformer:
        rows, columns = transformer.rowcol(*ground.T, op=lambda v: v)
    return np.stack([columns, rows], axis=1)


def ground_points(rpc, count=300):
    return rpc.ground_offset + rpc.ground_scale * np.random.default_rng(2).uniform(-0.9, 0.9, (count, 3))


def same_in_gdal(rpc, rpcs):
    """GDAL reads the same errors and projects to the same places."""
    ground = ground_points(rpc)
    assert np.abs(gdal_px(rpcs, ground) - rpc.project(ground)).max() < SAME_PX
    for theirs, mine in ((rpcs.err_bias, rpc.err_bias_m), (rpcs.err_rand, rpc.err_rand_m)):
        assert theirs in {None, -1} if mine is None else theirs == pytest.approx(mine, rel=1e-13)  # GDAL: 15 digits


@pytest.mark.parametrize("name", ["a.tif", "a_RPC.TXT", "a.RPB", "a.geom"])
def test_what_is_written_is_what_gdal_and_we_read(rpc, picture, tmp_path, name):
    mine = replace(rpc.shifted(np.array([1.23456789, -2.5])), err_bias_m=0.3712345678, err_rand_m=0.21)
    write_rpc(mine, tmp_path / name, picture)
    found = read_scene(tmp_path / name).rpc
    assert np.array_equal(found.coefficients, mine.coefficients)
    assert (found.err_bias_m, found.err_rand_m) == (mine.err_bias_m, mine.err_rand_m)
    assert np.abs(found.project(ground_points(mine)) - mine.project(ground_points(mine))).max() < SAME_PX
    if name.endswith("geom"):  # which GDAL does not read: its keys are those of the published one
        published = DATA / "sensors/shareloc/PHR1B_P_201709281038393_SEN_PRG_FC_178609-001.geom"
        if published.is_file():
            keys = {row.split(":")[0] for row in published.read_text().splitlines()}
            assert {row.split(":")[0] for row in (tmp_path / name).read_text().splitlines()} <= keys
        return
    if name != "a.tif":
        shutil.copy(picture, tmp_path / "a.tif")  # whose tag holds the old RPC: the file beside it goes first
    same_in_gdal(mine, of_gdal(tmp_path / "a.tif"))


def test_errors_that_are_not_known_stay_so(rpc, picture, tmp_path):
    assert rpc.err_bias_m is None
    write_rpc(rpc, tmp_path / "a.tif", picture)
    assert read_scene(tmp_path / "a.tif").rpc.err_bias_m is None
    assert of_gdal(tmp_path / "a.tif").err_bias in {None, -1}


def test_the_pixels_and_all_else_of_a_picture_stay(rpc, picture, tmp_path):
    with rasterio.open(picture, "r+") as raster:
        raster.update_tags(TIFFTAG_IMAGEDESCRIPTION="vendor")
        raster.nodata = 0
    write_rpc(rpc.shifted(np.array([3.0, 4.0])), tmp_path / "a.tif", picture)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with rasterio.open(picture) as before, rasterio.open(tmp_path / "a.tif") as after:
            assert before.profile == after.profile
            assert after.tags()["TIFFTAG_IMAGEDESCRIPTION"] == "vendor"
            window = rasterio.windows.Window(0, 0, 256, 256)
            assert np.array_equal(before.read(window=window), after.read(window=window))
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.tif", "scene.tif"]


def test_a_picture_that_is_no_tiff_becomes_one(rpc, tmp_path):
    small = replace(rpc, image_offset=np.array([100.0, 90.0]), image_scale=np.array([100.0, 90.0]))
    values = np.random.default_rng(1).integers(1, 255, (1, 180, 200)).astype("uint8")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with rasterio.open(
            tmp_path / "a.img", "w", driver="HFA", width=200, height=180, count=1, dtype="uint8"
        ) as raster:
            raster.write(values)
        write_rpc(small, tmp_path / "b.tif", tmp_path / "a.img")
        with rasterio.open(tmp_path / "b.tif") as raster:
            assert np.array_equal(raster.read(), values)
    same_in_gdal(small, of_gdal(tmp_path / "b.tif"))


def test_an_rpc_in_a_file_beside_goes_before_the_tag(rpc, picture, tmp_path):
    """GDAL looks there first: what would be written in vain is refused."""
    aux, *texts = files_before_the_tag(tmp_path / "a.tif")
    aux.write_text('<PAMDataset><Metadata domain="RPC"></Metadata></PAMDataset>')
    for stale in (aux, *texts):
        if stale != aux:
            write_rpc(rpc, tmp_path / ("x" + stale.suffix.upper().replace("TXT", "txt")))
            (tmp_path / ("x" + stale.suffix.upper().replace("TXT", "txt"))).rename(stale)
        with pytest.raises(InputError, match=rf"{stale.name}.*rpc\.file_precedes_tag"):
            write_rpc(rpc, tmp_path / "a.tif", picture)
        stale.unlink()
    assert not (tmp_path / "a.tif").exists()
    aux.write_text("<PAMDataset><PAMRasterBand band='1'></PAMRasterBand></PAMDataset>")  # statistics, as of QGIS
    write_rpc(rpc, tmp_path / "a.tif", picture)
    assert read_scene(tmp_path / "a.tif").rpc is not None


@pytest.mark.parametrize(("driver", "name"), [("NITF", "a.ntf"), ("VRT", "a.vrt")])
def test_pictures_that_tell_their_rpc_in_other_ways(rpc, tmp_path, driver, name):
    """Corrected into a GeoTIFF: pixels and RPC from one file."""
    part = rpc.shifted(np.array([-3600.0, -3200.0])).spread_over(np.array([300, 200]))
    source = write_picture(tmp_path / "s.tif", part, size=(300, 200))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        rasterio.shutil.copy(str(source), str(tmp_path / name), driver=driver)
        (tmp_path / f"{name}.aux.xml").unlink(missing_ok=True)
    own = read_scene(tmp_path / name).rpc  # NITF keeps few digits
    ground = own.localise(np.array([[20.0, 30.0], [250.0, 40.0], [120.0, 180.0]]), 400.0)
    rows = [f"P{k},{','.join(repr(v) for v in g)}" for k, g in enumerate(ground.tolist())]
    xy = own.project(ground) + np.array([3.0, -2.0]) + np.array([[0.1, 0.0], [-0.2, 0.1], [0.1, -0.1]])
    lines = [f"{r},{x!r},{y!r}" for r, (x, y) in zip(rows, xy.tolist(), strict=True)]
    (tmp_path / "c.csv").write_text("\n".join(["point,lon_deg,lat_deg,h_m,x_px,y_px", *lines]) + "\n")
    said = rb.rpc_correct(tmp_path / name, tmp_path / "c.csv", scene_bias="shift", out=tmp_path / "b.tif")
    assert said.fit.values == pytest.approx([3.0, -2.0], abs=1e-3)
    same_in_gdal(said.corrected, of_gdal(tmp_path / "b.tif"))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with rasterio.open(source) as before, rasterio.open(tmp_path / "b.tif") as after:
            assert np.array_equal(before.read(), after.read())


def test_without_a_picture_or_the_library(rpc, picture, tmp_path, monkeypatch):
    with pytest.raises(InputError, match=r"rpc\.geotiff_needs_picture"):
        write_rpc(rpc, tmp_path / "a.tif")
    monkeypatch.setitem(sys.modules, "rasterio", None)
    with pytest.raises(InputError, match=r"package\.rasterio_missing"):
        write_rpc(rpc, tmp_path / "a.tif", picture)


# corrections, written


def test_a_corrected_picture(rpc, picture, tmp_path, capsys):
    control(rpc, tmp_path / "control.csv")
    out = tmp_path / "corrected.tif"
    words = ["rpc", "correct", str(picture), str(tmp_path / "control.csv"), "--image-sigma", "0.2", "--verbose"]
    assert main([*words, "--out", str(out)]) == 0
    said = rb.rpc_correct(picture, tmp_path / "control.csv", image_sigma=0.2)
    same_in_gdal(said.corrected, of_gdal(out))
    same_in_gdal(said.corrected, said.corrected.to_rasterio())
    assert rpc_from_rasterio(said.corrected.to_rasterio()).err_bias_m == said.corrected.err_bias_m
    printed = capsys.readouterr().out
    assert "ERR_BIAS" in printed
    begin, _, end = headline("rpc.error_sources", {"east": 0.0, "north": 0.0}).partition("0 m ")
    assert begin in printed
    assert end.partition(" ")[0] in printed
    assert of_gdal(picture).err_bias in {None, -1}  # the original


def test_into_the_scene_itself(rpc, picture, tmp_path, capsys):
    control(rpc, tmp_path / "control.csv")
    words = ["rpc", "correct", str(picture), str(tmp_path / "control.csv"), "--into-scene"]
    assert main([*words, "--out", str(tmp_path / "b.tif")]) == 2
    assert "[option.exclusive]" in capsys.readouterr().err
    before = read_scene(picture).rpc
    assert main(words) == 0
    former = tmp_path / "scene-former_RPC.TXT"
    assert np.array_equal(read_scene(former).rpc.image_offset, before.image_offset)
    assert not np.array_equal(read_scene(picture).rpc.image_offset, before.image_offset)
    same_in_gdal(read_scene(picture).rpc, of_gdal(picture))
    assert main(words) == 2  # a second time nothing of the first is lost
    assert "[scene.original_rpc]" in capsys.readouterr().err
    write_rpc(rpc, tmp_path / "text_RPC.TXT")
    assert main(["rpc", "correct", str(tmp_path / "text_RPC.TXT"), *words[3:]]) == 2
    assert "[scene.no_geotiff]" in capsys.readouterr().err


def test_objects_of_rasterio_and_rioxarray(rpc, picture, tmp_path):
    control(rpc, tmp_path / "control.csv")
    points = tmp_path / "control.csv"
    want = rb.rpc_correct(picture, points)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with rasterio.open(picture) as raster:
            said = rb.rpc_correct(raster, points, out=tmp_path / "a.tif")
        assert said.fit.values == pytest.approx(want.fit.values, abs=1e-9)  # GDAL hands out 15 digits
        same_in_gdal(said.corrected, of_gdal(tmp_path / "a.tif"))
        bare = write_picture(tmp_path / "bare.tif", None)
        with rasterio.open(bare) as raster:
            with pytest.raises(InputError, match=r"50844.*rpc=FILE.*scene\.rpc_not_in_picture"):
                rb.rpc_correct(raster, points)
            for told in (rpc, rpc.to_rasterio(), picture):
                assert rb.rpc_correct(raster, points, rpc=told).fit.values == pytest.approx(want.fit.values, abs=1e-9)
        rioxarray = pytest.importorskip("rioxarray")
        array = rioxarray.open_rasterio(picture)
        said = rb.rpc_correct(array, points, out=tmp_path / "b.tif")
    assert np.array_equal(said.fit.values, want.fit.values)
    same_in_gdal(want.corrected, of_gdal(tmp_path / "b.tif"))
    with refused("setting.no_path", name="scene", type="float"):
        rb.rpc_correct(1.5, points)


def test_a_scene_stays_whole_where_writing_into_it_breaks_off(rpc, picture, tmp_path, monkeypatch):
    control(rpc, tmp_path / "control.csv")
    before = picture.read_bytes()

    def breaks(*_):
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr("raybundle.io.scenes.writing._check_written", breaks)
        with pytest.raises(KeyboardInterrupt):
            rb.rpc_correct(picture, tmp_path / "control.csv", into_scene=True)
    assert picture.read_bytes() == before
    left = sorted(p.name for p in tmp_path.iterdir())
    assert left == ["control.csv", "scene-former_RPC.TXT", "scene.tif"]
    (tmp_path / "scene-former_RPC.TXT").unlink()
    rb.rpc_correct(picture, tmp_path / "control.csv", into_scene=True)
    assert picture.read_bytes() != before


def test_points_outside_the_picture_are_named(rpc, picture, tmp_path, capsys):
    control(rpc, tmp_path / "control.csv")
    with (tmp_path / "control.csv").open("a") as file:
        lon, lat, h = rpc.localise(np.array([[9000.0, 100.0]]), 300.0)[0].tolist()
        file.write(f"far,{lon!r},{lat!r},{h!r},9000,100\n")
    assert main(["rpc", "correct", str(picture), str(tmp_path / "control.csv"), "--verbose"]) == 0
    assert re.search(r"far: .*9 ?000.*8 ?000 x 7 ?000 px", capsys.readouterr().out)


def test_an_rpc_of_another_file(rpc, tmp_path, capsys):
    """Beside the picture, or named: the tag of the new file takes it."""
    control(rpc, tmp_path / "control.csv")
    picture = write_picture(tmp_path / "scene.tif", None)
    write_rpc(rpc, tmp_path / "other.RPB")
    words = ["rpc", "correct", str(picture), str(tmp_path / "control.csv"), "--out", str(tmp_path / "a.tif")]
    assert main(words) == 2
    assert "--rpc FILE" in capsys.readouterr().err
    assert main([*words, "--rpc", str(tmp_path / "other.RPB")]) == 0
    write_rpc(rpc, tmp_path / "scene.RPB")
    assert main([*words[:-1], str(tmp_path / "b.tif")]) == 0
    a, b = (of_gdal(tmp_path / f"{n}.tif") for n in "ab")
    assert a.to_dict() == b.to_dict()


@pytest.mark.parametrize("kind", ["shift", "drift", "affine"])
def test_err_bias_is_the_sigma_of_the_correction(rpc, kind):
    """On the ground at the middle: from the covariance by hand, and by the scatter of corrections in simulation."""
    rng = np.random.default_rng(3)
    ground = rpc.ground_offset + rpc.ground_scale * rng.uniform(-0.8, 0.8, (30, 3))
    true, sigma, middle = rpc.project(ground), 0.4, rpc.ground_offset[None]
    by_ground = rpc.project_with_partials(middle)[1][0, :, :2] / metres_per_geographic(middle)[0, :2]
    at_middle = np.linalg.inv(by_ground) @ bias_design(kind, np.zeros((1, 2)))[0]
    uv, covariance = (true - rpc.image_offset) / rpc.image_scale, np.tile(np.eye(2) * sigma**2, (30, 1, 1))
    noise = rng.normal(0, sigma, (1000, 30, 2))
    wrong = [at_middle @ solve_bias(kind, uv, n, covariance)[0] for n in noise]
    advice = choose_bias(rpc, ground, true + noise[0], sigma_px=sigma)
    fit = next(f for f in advice.fits if f.kind == kind)
    assert fit.misfit == 1
    said = ground_errors(rpc, advice, fit)
    assert said.err_bias_m == pytest.approx(np.mean(np.square(wrong)) ** 0.5, rel=0.06)  # 2000 values: 1.6 % by chance
    C = at_middle @ fit.covariance @ at_middle.T
    assert said.covariance_m2 == pytest.approx(C)
    assert said.err_bias_m == pytest.approx(np.sqrt(np.trace(C) / 2), rel=1e-12)
    assert errors_of_covariance(rpc, kind, fit.covariance)[0] == pytest.approx(said.err_bias_m, rel=1e-12)
    written = said.of(rpc)
    assert (written.err_bias_m, written.err_rand_m) == (said.err_bias_m, said.err_rand_m)


def test_err_rand_is_the_scatter_of_the_points(rpc):
    rng = np.random.default_rng(4)
    ground = rpc.ground_offset + rpc.ground_scale * rng.uniform(-0.8, 0.8, (40, 3))
    xy = rpc.project(ground) + np.array([5.0, -3.0]) + rng.normal(0, 0.5, (40, 2))
    vendor = replace(rpc, err_bias_m=9.0, err_rand_m=0.123)
    advice = choose_bias(vendor, ground, xy, sigma_px=0.5)
    shift = next(f for f in advice.fits if f.kind == "shift")
    said = ground_errors(vendor, advice, shift)
    gsd = np.linalg.norm(rpc.pixel_on_ground(), axis=1)
    assert said.measured_rand
    assert said.err_rand_m == pytest.approx(0.5 * np.sqrt(np.mean(gsd**2)), rel=0.25)
    few = choose_bias(vendor, ground[:2], xy[:2], sigma_px=0.5)
    left = ground_errors(vendor, few, next(f for f in few.fits if f.kind == "shift"))
    assert (left.err_rand_m, left.measured_rand) == (0.123, False)
    unknown = ground_errors(rpc, few, next(f for f in few.fits if f.kind == "shift"))
    assert unknown.err_rand_m is None


def test_a_shift_that_is_left_is_an_error(rpc):
    rng = np.random.default_rng(5)
    ground = rpc.ground_offset + rpc.ground_scale * rng.uniform(-0.8, 0.8, (10, 3))
    xy = rpc.project(ground) + np.array([20.0, 0.0]) + rng.normal(0, 0.3, (10, 2))
    advice = choose_bias(rpc, ground, xy, sigma_px=0.3)
    none = next(f for f in advice.fits if f.kind == "none")
    gsd = np.linalg.norm(rpc.pixel_on_ground(), axis=1)[0]
    assert ground_errors(rpc, advice, none).err_bias_m == pytest.approx(20 * gsd / np.sqrt(2), rel=0.02)


def test_the_part_of_heights_and_what_a_height_moves(rpc):
    rng = np.random.default_rng(6)
    ground = rpc.ground_offset + rpc.ground_scale * rng.uniform(-0.8, 0.8, (10, 3))
    xy = rpc.project(ground) + np.array([5.0, -3.0])
    flat, high = (np.tile(s, (10, 1)) for s in ([0.3, 0.3, 0.0], [0.0, 0.0, 0.5]))

    def said(sigma_px, ground_m):
        advice = choose_bias(rpc, ground, xy, sigma_px=sigma_px, sigma_ground_m=ground_m)
        return ground_errors(rpc, advice, next(f for f in advice.fits if f.kind == "shift"))

    assert said(0.3, flat).height_share_m == 0
    alone, without = said(0.2, high), said(0.2, np.zeros((10, 3)))
    # ten independent heights: their effect along the ray, by the square root of ten
    assert alone.height_share_m == pytest.approx(0.5 * np.linalg.norm(alone.per_height) / np.sqrt(2 * 10), rel=0.02)
    assert alone.err_bias_m == pytest.approx(np.hypot(without.err_bias_m, alone.height_share_m), rel=0.02)
    middle = rpc.ground_offset[None]
    xy0 = rpc.project(middle)
    moved = rpc.localise(xy0, float(middle[0, 2]) + 1.0)
    metres = (moved - middle)[0, :2] * metres_per_geographic(middle)[0, :2]
    assert alone.per_height == pytest.approx(metres, rel=1e-3)


# of other programs


def test_rpc_of_gdal_as_xml_and_json(rpc, picture, tmp_path):
    mine = replace(rpc, err_bias_m=1.5, err_rand_m=0.25)
    write_rpc(mine, tmp_path / "a.tif", picture)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        rasterio.shutil.copy(str(tmp_path / "a.tif"), str(tmp_path / "a.vrt"), driver="VRT")
        with rasterio.open(tmp_path / "a.tif") as raster:
            values = raster.tags(ns="RPC")
            own = raster.rpcs.to_dict()
    gdalinfo = {"description": "a.tif", "size": list(SIZE), "metadata": {"": {}, "RPC": values}}
    (tmp_path / "info.json").write_text(json.dumps(gdalinfo))
    (tmp_path / "own.json").write_text(json.dumps({"rpcs": own}))
    aux = "".join(f'<MDI key="{k}">{v}</MDI>' for k, v in values.items())
    (tmp_path / "b.tif.aux.xml").write_text(f'<PAMDataset><Metadata domain="RPC">{aux}</Metadata></PAMDataset>')
    for name, sized in (("a.vrt", True), ("info.json", True), ("own.json", False), ("b.tif.aux.xml", False)):
        found = read_scene(tmp_path / name)
        assert (found.width_px, found.height_px) == (SIZE if sized else (None, None)), name
        assert np.abs(found.rpc.project(ground_points(rpc)) - rpc.project(ground_points(rpc))).max() < SAME_PX, name
        assert (found.rpc.err_bias_m, found.rpc.err_rand_m) == (1.5, 0.25), name
    broken = {**values, "SAMP_OFF": "east"}
    (tmp_path / "own.json").write_text(json.dumps({"metadata": {"RPC": broken}}))
    with pytest.raises(InputError, match=r"SAMP_OFF.*value\.not_finite"):
        read_scene(tmp_path / "own.json")
    del values["LAT_SCALE"], values["LINE_DEN_COEFF"]
    (tmp_path / "own.json").write_text(json.dumps({"metadata": {"RPC": values}}))
    with pytest.raises(InputError, match=r"LINE_DEN_COEFF.*0.*20.*rpc\.coefficient_count"):
        read_scene(tmp_path / "own.json")


def keys_of(rpc):
    """As GDAL has them, texts."""
    return {k: (" ".join(map(repr, v)) if isinstance(v, list) else repr(v))
            for k, v in rpc.to_rasterio().to_dict().items() if v is not None}  # fmt: skip


def gdal_xml(rpc):
    rows = "".join(f'<MDI key="{k.upper()}">{v}</MDI>' for k, v in keys_of(rpc).items())
    return (
        f'<VRTDataset rasterXSize="{SIZE[0]}" rasterYSize="{SIZE[1]}"><Metadata domain="RPC">{rows}</Metadata>'
        "</VRTDataset>"
    )


def gdal_json(rpc):
    values = {k.upper(): v for k, v in keys_of(rpc).items()}
    return json.dumps({"size": list(SIZE), "metadata": {"": {}, "RPC": values}})


def orthority(rpcs):
    rows = []
    for name, rpc in rpcs.items():
        rows += [f"{name}:", "    im_size: [8000, 7000]", "    rpc:"]
        own = rpc.to_rasterio().to_dict()
        rows += [f"        {key}: {value!r}" for key, value in own.items() if value is not None]
    return "\n".join(rows) + "\n"


def test_rpc_of_orthority_as_yaml(rpc, tmp_path):
    (tmp_path / "a.yaml").write_text(orthority({"a.tif": replace(rpc, err_bias_m=12.15, err_rand_m=0.3)}))
    found = read_scene(tmp_path / "a.yaml")
    assert (found.format, found.rpc.err_bias_m) == ("orthority", 12.15)
    assert np.array_equal(found.rpc.coefficients, rpc.coefficients)
    assert found.rpc.image_offset == pytest.approx(rpc.image_offset, abs=1e-9)
    (tmp_path / "two.yaml").write_text(orthority({"a.tif": replace(rpc, err_bias_m=1.0, err_rand_m=1.0)} | {
        "b.tif": replace(rpc, err_bias_m=1.0, err_rand_m=1.0)}))  # fmt: skip
    with pytest.raises(InputError, match=r"2.*a\.tif.*b\.tif.*rpc\.not_one"):
        read_scene(tmp_path / "two.yaml")


def test_the_published_quickbird(sensors):
    """RPC as YAML and control as GeoJSON as orthority writes them; the figures stand beside the data."""
    said = rb.rpc_correct(sensors / "qb2/rpc_param.yaml", sensors / "qb2/gcps.geojson", image_sigma=0.1)
    assert said.rpc.err_bias_m == 12.15
    assert said.fit.kind == "shift"
    assert said.fit.values == pytest.approx([-2.977, -2.090], abs=0.002)
    assert said.fit.rms == pytest.approx([0.075, 0.071], abs=0.008)


# the pictures of s2p


def s2p():
    found = sorted((DATA / "sensors/s2p").glob("input_*/img_*.tif"))
    return found or [pytest.param(None, marks=pytest.mark.skip("the files of s2p are not there"))]


@pytest.mark.parametrize("path", s2p(), ids=lambda p: f"{p.parent.name}-{p.stem}" if p else "none")
def test_pictures_of_s2p_corrected_written_and_read_back(path, tmp_path):
    """Each with a known shift: the control is the RPC's own, moved by it."""
    rpc = read_scene(path).rpc
    rng = np.random.default_rng(7)
    shift, sigma = np.array([6.25, -3.5]), 0.3
    xy = rng.uniform(30, 990, (12, 2))
    heights = rpc.ground_offset[2] + rpc.ground_scale[2] * rng.uniform(-0.3, 0.3, 12)
    ground = rpc.localise(xy, heights)
    rows = ["point,lon_deg,lat_deg,h_m,x_px,y_px"]
    measured = xy + shift + rng.normal(0, sigma, xy.shape)
    for k, (g, m) in enumerate(zip(ground.tolist(), measured.tolist(), strict=True)):
        rows.append(",".join([f"P{k}", *(repr(v) for v in (*g, *m))]))
    (tmp_path / "control.csv").write_text("\n".join(rows) + "\n")
    said = rb.rpc_correct(path, tmp_path / "control.csv", image_sigma=sigma, out=tmp_path / "a.tif")
    assert said.fit.kind == "shift"
    assert np.abs(said.fit.values - shift).max() < 4 * sigma / np.sqrt(12)
    rpcs = of_gdal(tmp_path / "a.tif")
    local = rpc.localise(rng.uniform(0, 1024, (200, 2)), float(rpc.ground_offset[2]))
    assert np.abs(gdal_px(rpcs, local) - said.corrected.project(local)).max() < SAME_PX
    assert np.abs(read_scene(tmp_path / "a.tif").rpc.project(local) - said.corrected.project(local)).max() < SAME_PX
    assert rpcs.err_bias == pytest.approx(said.errors.err_bias_m, rel=1e-13)
    assert rpcs.err_rand == pytest.approx(said.errors.err_rand_m, rel=1e-13)
    gsd = np.linalg.norm(rpc.pixel_on_ground(), axis=1)
    assert said.errors.err_bias_m == pytest.approx(
        said.fit.misfit * sigma / np.sqrt(12) * np.sqrt(np.mean(gsd**2)), rel=0.2
    )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with rasterio.open(path) as before, rasterio.open(tmp_path / "a.tif") as after:
            assert np.array_equal(before.read(), after.read())
