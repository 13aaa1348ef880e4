"""Heights whose files do not belong together, through the door: refused with the file and the number, status 2."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.io.geo.parsed_names import plan_system, system_with_heights
from raybundle.io.pictures.geotiff import system_text
from raybundle.surfaces.files.heights import read_heights
from raybundle.words import headline
from tests.messages import failed
from tests.surface.height_models import file_of, folder_of, made
from tests.workflows.half_portal import PORTAL

rasterio = pytest.importorskip("rasterio")
SHAPE = (40, 64)
RAMP = np.tile(np.linspace(0, 0.05, SHAPE[1]), (SHAPE[0], 1))
UTM = rasterio.crs.CRS.from_epsg(32632).to_wkt()


def mapped(folder, system, height=0.0):
    """Heights in a map; system: "" where heights.toml says none."""
    plane = {"system": system} if system else {}
    return folder_of(made(np.full(SHAPE, height)), folder, wkt=UTM, plane=plane, left=5e5, top=5.2e6)


def refused(capsys, *words):
    """File, code and values of the error of a command."""
    capsys.readouterr()
    assert main([*map(str, words), "--json"]) == 2
    found = failed(capsys)
    return Path(found.place.file if found.place else "").name, found.code, found.values


@pytest.fixture
def wall(tmp_path):
    return folder_of(made(np.zeros(SHAPE)), tmp_path / "wall")


@pytest.mark.parametrize(
    ("one", "other", "datum", "other_datum"),
    [
        ("EPSG:32632+5773", "EPSG:32632+ellipsoid", "EGM96 height (EPSG:5773)", "ellipsoid"),
        ("EPSG:32632+3855", "EPSG:32632+5773", "EGM2008 height (EPSG:3855)", "EGM96 height (EPSG:5773)"),
        ("EPSG:32632+5773", "EPSG:32632", "EGM96 height (EPSG:5773)", "unknown"),
        ("", "EPSG:32632+ellipsoid", "unknown", "ellipsoid"),
    ],
)
def test_heights_that_count_from_different_things_are_not_compared(tmp_path, capsys, one, other, datum, other_datum):
    first, second = mapped(tmp_path / "one", one), mapped(tmp_path / "other", other, 47.0)
    for command in (("difference", first, second), ("difference", second, first), ("volume", first, "--above", second)):
        _, code, values = refused(capsys, "heights", *command)
        assert code == "surface_files.vertical_datums_differ"
        found = {(values["system"], values["datum"]), (values["other_system"], values["other_datum"])}
        assert found == {(one or "none", datum), (other or "none", other_datum)}


@pytest.mark.parametrize("system", ["", "EPSG:32632", "EPSG:32632+5773", "EPSG:32632+ellipsoid"])
def test_heights_that_count_from_the_same_are_compared(tmp_path, capsys, system):
    one, other = mapped(tmp_path / "one", system), mapped(tmp_path / "other", system, 0.1)
    assert main(["heights", "difference", str(one), str(other), "--out", str(tmp_path / "d")]) == 0


def test_an_older_text_of_the_same_heights_is_the_same(tmp_path, capsys):
    system = rasterio.crs.CRS.from_user_input("EPSG:32632+5773").to_wkt()
    one, other = mapped(tmp_path / "one", "EPSG:32632+5773"), mapped(tmp_path / "other", system)
    assert main(["heights", "volume", str(one), "--above", str(other)]) == 0


@pytest.mark.parametrize("name", ["heights.tif", "heights_sigma.tif"])
def test_a_raster_that_was_cropped_or_moved_is_refused(wall, capsys, name):
    path = wall / name
    whole = path.read_bytes()
    with rasterio.open(path) as file:
        profile, values = file.profile, file.read()
    t = profile["transform"]

    def kept(values, transform):
        shape = {"height": values.shape[1], "width": values.shape[2]}
        with rasterio.open(path, "w", **{**profile, **shape, "transform": transform}) as file:
            file.write(values)
        return refused(capsys, "heights", "volume", wall, "--above", 0)

    size = {"columns": 56, "rows": 36, "about": "heights.toml", "needed_columns": 64, "needed_rows": 40}
    shown = kept(values[:, 4:, 8:], t @ rasterio.Affine.translation(8, 4))
    assert shown == (name, "surface_files.size_differs", size)
    for change, quantity, value, needed in (
        (rasterio.Affine.translation(8, 0), "left", 0.08, 0.0), (rasterio.Affine.scale(1.01), "width", 0.0101, 0.01),
    ):  # fmt: skip
        *shown, values_of = kept(values, t @ change)
        assert shown == [name, "surface_files.place_differs"]
        place = {"quantity": quantity, "value": pytest.approx(value), "about": "heights.toml", "needed": needed}
        assert values_of == place
    path.write_bytes(whole[:4])
    assert refused(capsys, "heights", "volume", wall, "--above", 0)[0] == name
    path.write_bytes(whole[:-40])
    *shown, values_of = refused(capsys, "heights", "volume", wall, "--above", 0)
    assert shown == [name, "surface_files.place_differs"]
    assert (values_of["quantity"], values_of["value"]) == ("top", 0.0)


def test_a_raster_of_another_system_is_refused(tmp_path, capsys):
    folder = mapped(tmp_path / "one", "EPSG:25832+7837")
    _, code, values = refused(capsys, "heights", "volume", folder, "--above", 0)
    assert code == "surface_files.system_differs"
    assert values == {"system": "EPSG:32632", "about": "heights.toml", "needed": "EPSG:25832+7837"}


def test_a_system_of_ones_own_is_read_again(tmp_path):
    """What a GeoTIFF keeps of it has another name, and nothing of the shift of its datum."""
    system = (
        "+proj=tmerc +lat_0=46 +lon_0=7.5 +k=0.9999 +x_0=500000 +ellps=bessel +towgs84=674,15,405 +units=m +type=crs"
    )
    wkt = rasterio.crs.CRS.from_user_input(system).to_wkt()
    folder = folder_of(made(np.zeros(SHAPE)), tmp_path / "own", wkt=wkt, plane={"system": system}, left=5e5, top=2e5)
    assert read_heights(folder)[1].left == 5e5


@pytest.mark.parametrize(
    ("was", "now", "code", "value"),
    [
        ("pixel = 0.01", "pixel = 0.0", "number.too_small", 0.0),
        ("pixel = 0.01", "pixel = -0.01", "number.too_small", -0.01),
        ("pixel = 0.01", "pixel = nan", "value.not_finite", "nan"),
        ('unit = "m"', 'unit = "parsec"', "surface_files.unit_unknown", "parsec"),
        ("width_px = 64", "width_px = 0", "value.not_whole", "0"),
    ],
)
def test_a_place_that_no_grid_has_is_refused(wall, capsys, was, now, code, value):
    path = wall / "heights.toml"
    text = path.read_text()
    assert was in text
    path.write_text(text.replace(was, now))
    *shown, values = refused(capsys, "heights", "volume", wall, "--above", 0)
    assert shown == ["heights.toml", code]
    assert value in values.values()


@pytest.mark.parametrize(
    "damage", ["empty", "cut off", "text", "array", "of another surface", "of one as large", "without nodes"]
)
def test_damaged_orientation_is_refused(wall, tmp_path, capsys, damage):
    path = wall / "heights_orientation.npz"
    whole = path.read_bytes()
    if damage == "of another surface":
        other = folder_of(made(np.zeros((200, 300))), tmp_path / "other")
        whole = (other / path.name).read_bytes()
        code, values = "surface_files.node_count", {"nodes": [8, 11], "rows": 40, "columns": 64, "needed": [3, 3]}
    elif damage == "of one as large":
        other = folder_of(made(np.zeros(SHAPE), common=1e-3), tmp_path / "other")
        whole = (other / path.name).read_bytes()
        code, values = "surface_files.other_surface", {"about": "heights.toml"}
    elif damage == "without nodes":
        code, values = "surface_files.entry_missing", {"name": "moved"}
    else:
        code, values = "surface_files.damaged", {}
    if damage in {"array", "without nodes"}:
        with path.open("wb") as file:
            np.save(file, np.zeros(3)) if damage == "array" else np.savez(file, block=np.array(32))
    else:
        path.write_bytes(
            {"empty": b"", "cut off": whole[: len(whole) // 2], "text": b"nothing of this\n"}.get(damage, whole)
        )
    assert refused(capsys, "heights", "volume", wall, "--above", 0) == (path.name, code, values)


def test_the_end_of_a_file_is_no_interruption(wall, capsys, monkeypatch):
    def ended(folder):
        raise EOFError("end")

    monkeypatch.setattr("raybundle.surfaces.files.input.read_heights", ended)
    assert main(["heights", "volume", str(wall), "--above", "0"]) == 1
    assert "EOFError: end" in capsys.readouterr().err


@pytest.mark.parametrize("system", ["EPSG:32632+ellipsoid", "EPSG:25832+ellipsoid", "EPSG:2926+6360"])
def test_a_system_that_stands_beside_the_raster_is_its_own(tmp_path, system):
    """As `surface` writes it for heights above the ellipsoid, and a system in feet."""
    wkt = plan_system(system).to_wkt()
    height = made(np.zeros(SHAPE))
    folder = folder_of(height, tmp_path / "one", wkt=wkt, plane={"system": system}, left=5e5, top=5.2e6)
    (folder / "heights.tif.aux.xml").write_text(system_text(system_with_heights(system).to_wkt()))
    assert read_heights(folder)[1].system == system


def changed(path, change):
    """Values of a raster put through a function, all else as it was; written as another program writes it."""
    with rasterio.open(path) as file:
        profile, values = file.profile, file.read()
    values = np.asarray(change(values), values.dtype)
    with rasterio.open(path, "w", **profile) as file:
        file.write(values)


def bump(values):
    values[0, 10:14, 20:30] += 0.5
    return values


def spike(values):
    values[0, 5, 5] = np.nan
    return values


@pytest.mark.parametrize("edit", [bump, spike])
def test_heights_that_were_edited_are_taken_with_a_caution(tmp_path, capsys, edit):
    wall = folder_of(made(RAMP), tmp_path / "wall")
    changed(wall / "heights.tif", edit)
    for words in (
        ("volume", wall, "--above", 0), ("section", wall, "--line", "0 0.2, 0.6 0.2"), ("ground", wall),
        ("difference", folder_of(made(np.zeros(SHAPE)), tmp_path / "flat"), wall),
        ("contours", wall, "--interval", 0.01, "--out", tmp_path / "c.geojson"),
    ):  # fmt: skip
        capsys.readouterr()
        assert main(["heights", *map(str, words)]) == 0, capsys.readouterr().err
        shown = capsys.readouterr().out
        assert shown.count(headline("heights.changed_values", {"name": str(wall / "heights.tif")})) == 1
        assert shown.count("[heights.changed_values]") == 1


def test_lossless_copies_are_as_good(wall, tmp_path, capsys):
    """In another form, with another sign for nothing; heights, too, that hold NaN already."""
    changed(wall / "heights.tif", lambda v: v)
    sparse = np.zeros(SHAPE)
    sparse[:4] = np.nan
    holed = folder_of(made(sparse), tmp_path / "holed")
    for folder in (wall, holed):
        for name in ("heights.tif", "heights_sigma.tif"):
            with rasterio.open(folder / name) as file:
                profile, values = file.profile, file.read()
            values[np.isnan(values)] = -9999
            profile |= {"compress": "lzw", "nodata": -9999, "tiled": False, "dtype": "float64"}
            with rasterio.open(folder / name, "w", **profile) as file:
                file.write(values.astype(float))
        capsys.readouterr()
        assert main(["heights", "volume", str(folder), "--above", "0"]) == 0
        assert "warning" not in capsys.readouterr().out
    assert not read_heights(holed)[0].known[:4].any()


def test_standard_deviations_of_other_heights_are_refused(wall, tmp_path, capsys):
    other = folder_of(made(np.zeros(SHAPE), sigma=2e-3), tmp_path / "other")
    (wall / "heights_sigma.tif").write_bytes((other / "heights_sigma.tif").read_bytes())
    found = refused(capsys, "heights", "volume", wall, "--above", 0)
    assert found == ("heights_sigma.tif", "surface_files.other_surface", {"about": "heights.toml"})


@pytest.mark.parametrize(
    ("band", "value", "kind", "name"),
    [
        (0, np.nan, "missing", "sigma"), (0, 0.0, "zero", "sigma"),
        (1, -1e-3, "negative", "sigma of noise and roughness"), (3, np.inf, "infinite", "sigma of orientation"),
        (2, np.nan, "", ""),
    ],
)  # fmt: skip
def test_standard_deviations_that_are_none_are_counted_without_check_sums_too(wall, capsys, band, value, kind, name):
    def spoilt(values):
        values[band, 7, 3:6] = value
        return values

    changed(wall / "heights_sigma.tif", spoilt)
    about = wall / "heights.toml"
    about.write_text("".join(t for t in about.read_text().splitlines(keepends=True) if "sha256" not in t))
    if not kind:  # earlier files lack steps
        assert main(["heights", "volume", str(wall), "--above", "0"]) == 0
        return
    *shown, values = refused(capsys, "heights", "volume", wall, "--above", 0)
    assert shown == ["heights_sigma.tif", "surface_files.impossible_sigmas"]
    assert {"n": 3, "cells": 2560, "band": name, kind: 3}.items() <= values.items()


def test_heights_without_end_are_counted(wall, capsys):
    def endless(values):
        values[0, :2, 4] = np.inf
        return values

    changed(wall / "heights.tif", endless)
    found = refused(capsys, "heights", "volume", wall, "--above", 0)
    assert found == ("heights.tif", "surface_files.infinite_heights", {"n": 2})


def test_heights_of_a_result_that_was_adjusted_again_are_told(tmp_path, capsys):
    """By what stands around them, of the ground within them too; not of a result that is as it was."""
    from raybundle.results.fingerprint import FINGERPRINT, fingerprint

    project = tmp_path / "p"
    shutil.copytree(PORTAL / "truth", project / "result/block")
    (project / "result/result.json").write_text("{}")
    (project / "project.db").touch()
    plane = {**file_of(made(np.zeros(SHAPE))).plane, FINGERPRINT: fingerprint(project)}
    wall = folder_of(made(RAMP), project / "surface", plane=plane)
    away = folder_of(made(RAMP), tmp_path / "away", plane=plane)
    ground = ("heights", "volume", str(wall / "ground"), "--above", "0")
    assert main(["heights", "ground", str(wall)]) == 0
    assert main([*ground]) == 0
    assert "warning" not in capsys.readouterr().out
    images = project / "result/block/images.csv"
    images.write_text(images.read_text().replace("1", "2"))
    for command in (["heights", "volume", str(wall), "--above", "0"], ground):
        assert main([*command]) == 0
        shown = capsys.readouterr().out
        assert "warning: " in shown
        assert f": {headline('heights.adjusted_since', {'name': 'p'})} [heights.adjusted_since]" in shown
    assert main(["heights", "volume", str(away), "--above", "0"]) == 0
    assert "warning" not in capsys.readouterr().out
