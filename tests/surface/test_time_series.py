"""Volumes of several dates: joint covariance, tests, levels of detection, files."""

import csv
import json
import re
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from raybundle.errors import phrase
from raybundle.surfaces.heights.cut_and_fill import Signs
from raybundle.surfaces.heights.height_model import SumOfHeights
from raybundle.surfaces.heights.resampling import difference
from raybundle.surfaces.heights.time_series import RegionWeights, intervals, time_series
from raybundle.surfaces.heights.volumes import volume
from tests.cli.reported import refusal, reported, values_of
from tests.surface.height_models import folder_of, made
from tests.surface.quarry import CELL, DATES, SHAPE, exact, measured, of_one, written

rasterio = pytest.importorskip("rasterio")
SMALL = (40, 48)
INNER = np.pad(np.ones((24, 32)), 8)
RING = np.array([[8.0, 8], [40, 8], [40, 32], [8, 32]])


def dated(rng, count=3, shape=SMALL, **more):
    return [made(np.zeros(shape), rng=rng, cell=1.0, sigma=0.02, **{"common": 0.01, **more}) for _ in range(count)]


def one(models, base=0.0, **more):
    (found,) = time_series(models, [RegionWeights(name="a", parts=((INNER, base),))], 0.05, **more)
    return found


@pytest.mark.parametrize("base", [0.0, (RING,)])
def test_volumes_and_changes_are_those_of_single_commands(base):
    models = dated(np.random.default_rng(1))
    found = one(models, base)
    first = volume(models[0], INNER, base if isinstance(base, float) else list(base)).net
    assert found.volumes[0] == pytest.approx(first.value, abs=1e-9)
    assert found.sigma[0] == pytest.approx(first.sigma, rel=1e-6)
    for c in found.changes:
        d = difference(models[c.begin], models[c.end]).sum_of(INNER)
        assert c.net.value == pytest.approx(d.value, abs=1e-4)
        assert c.net.sigma == pytest.approx(d.sigma, rel=1e-6)
        less = np.eye(3)[c.end] - np.eye(3)[c.begin]
        assert less @ found.volumes == pytest.approx(d.value, abs=1e-4)
        # the base is one: no change depends on it
        assert less @ found.covariance @ less == pytest.approx(d.sigma**2, rel=1e-6)
        assert c.fill.value - c.cut.value == pytest.approx(c.net.value)


def test_a_base_that_is_one_of_the_surfaces_has_no_volume_above_itself():
    models = dated(np.random.default_rng(2))
    found = one(models, below=models[0])
    assert found.volumes[0] == 0
    assert found.sigma[0] == 0
    assert found.sigma[1] == pytest.approx(found.changes[0].net.sigma)
    other = one(models[1:], below=models[0])
    assert other.volumes == pytest.approx(found.volumes[1:])
    assert other.sigma == pytest.approx(found.sigma[1:])


def test_errors_of_one_adjustment_count_once():
    rng = np.random.default_rng(3)
    plain = dated(rng, common=None)
    models = of_one(plain, rng.normal(size=6), common=0.05, own=0.004)
    together = one(models)
    apart = one([replace(m, errors="") for m in models])
    area = float(INNER.sum())
    assert together.changes[0].net.orientation == pytest.approx(area * 0.004 * np.sqrt(2), rel=1e-4)
    assert apart.changes[0].net.orientation > 10 * together.changes[0].net.orientation
    assert together.sigma == pytest.approx(apart.sigma)


def test_cells_of_one_measurement_have_not_changed():
    a, b = dated(np.random.default_rng(4), 2)
    h = b.heights
    height, local = (np.where(np.arange(48) < 24, getattr(a.heights, k), getattr(h, k)) for k in ("height", "local"))
    half = replace(b, heights=replace(h, height=height, local=local))
    found = one([a, half]).changes[0].net
    assert found.local < 0.8 * one([a, b]).changes[0].net.local


def test_what_did_not_change_is_neither_cut_nor_filled():
    """The sign of a cell alone would make both too large by 0.4 sigma of a cell: here 13 of their sigmas."""
    rng = np.random.default_rng(5)
    z = {"fill": [], "cut": []}
    for _ in range(30):
        (c,) = one(dated(rng, 2, common=None)).changes
        for name, found in z.items():
            q = getattr(c, name)
            found.append(q.value / q.sigma)
        assert min(c.fill.value, c.cut.value) >= 0
        assert c.fill.value - c.cut.value == pytest.approx(c.net.value)
    for found in z.values():
        assert abs(np.mean(found)) < 1
        assert np.mean(np.square(found)) < 1.8


def test_volumes_against_another_surface_are_not_too_large_where_both_coincide():
    rng, z = np.random.default_rng(8), []
    for _ in range(20):
        d = difference(*dated(rng, 2, common=None))
        v = volume(d, INNER, 0.0)
        assert v.above.value - v.below.value == pytest.approx(v.net.value)
        z += [v.above.value / v.above.sigma, v.below.value / v.below.sigma]
    assert abs(np.mean(z)) < 1


def test_cut_and_fill_are_as_precise_as_stated_where_noise_decides_signs():
    """Without the part by signs their variance is 1.25 times as large as stated."""
    rng, w = np.random.default_rng(12), np.ones((60, 60))
    true = np.zeros(w.shape)
    true[:12, :24], true[-12:, :24] = 9.0, -9.0  # so that neither is ever negative
    z = []
    for _ in range(400):
        d = true + rng.normal(size=w.shape)

        def summed(u, d=d):
            return SumOfHeights(value=float((u * d).sum()), local=float(np.linalg.norm(u)), moved=np.zeros(0))

        _, *parts = Signs.of(d, w, 0.6).cut_and_fill(w, summed)
        z += [(q.value - 9.0 * 12 * 24) / q.local for q in parts]
    # of 400 draws with two values that are nearly independent: four standard deviations
    assert 0.8 < np.mean(np.square(z)) < 1.2
    assert abs(np.mean(z)) < 0.25


@pytest.mark.parametrize("base", [0.0, [RING]])
def test_volumes_above_a_height_or_the_rim_are_not_too_large_where_both_coincide(base):
    rng, z = np.random.default_rng(13), []
    for _ in range(20):
        v = volume(dated(rng, 1, common=None)[0], INNER, base)
        assert v.above.value - v.below.value == pytest.approx(v.net.value)
        z += [v.above.value / v.above.sigma, v.below.value / v.below.sigma]
    assert abs(np.mean(z)) < 1  # by the signs of cells: 10


def test_neither_cut_nor_fill_is_certain_to_be_none():
    d = np.full(SMALL, 0.5)
    a, b = dated(np.random.default_rng(9), 2, common=None)
    higher = replace(b, heights=replace(b.heights, height=(b.heights.height + d).astype(np.float32)))
    (c,) = one([a, higher]).changes
    assert c.cut.value == 0
    assert 0 < c.cut.sigma < c.fill.sigma
    assert not c.significant(c.cut)


def test_signs_are_those_of_the_surroundings_unless_certain():
    d, sigma = np.full(SMALL, -0.01), np.full(SMALL, 0.02)
    d[:, 24:] = 0.01
    d[20, 5], d[20, 6], d[3, 3] = 0.05, 0.2, np.nan
    found = Signs.of(d, sigma, 0.8).risen
    assert not found[20, 5]
    assert found[20, 6]
    assert not found[:, :14][np.arange(40) != 20].any()
    assert found[:, 34:].all()


def test_a_change_below_its_level_of_detection_is_not_significant():
    rng = np.random.default_rng(6)
    hits = {0.5: 0, 1.0: 0, 1.6: 0}
    level = one(dated(rng, 2)).changes[0].detectable
    for share in hits:
        for _ in range(30):
            a, b = dated(rng, 2)
            up = b.heights.height + np.float32(share * level) * (INNER > 0) / np.float32(INNER.sum())
            raised = replace(b, heights=replace(b.heights, height=up.astype(np.float32)))
            (c,) = one([a, raised]).changes
            hits[share] += c.significant(c.net)
    # by the normal distribution 17 %, 80 % and 99.7 %; three standard deviations of 30
    assert hits[0.5] <= 12
    assert 17 <= hits[1.0] <= 29
    assert hits[1.6] >= 28


def test_intervals():
    assert intervals(2) == [(0, 1)]
    assert intervals(4) == [(0, 1), (1, 2), (2, 3), (0, 3)]


@pytest.fixture(scope="module")
def quarry(tmp_path_factory):
    folder = tmp_path_factory.mktemp("quarry")
    written(folder)
    return folder


def series(quarry, *more):
    return ("heights", "time-series", *(quarry / d / "surface" for d in DATES), "--outline", quarry / "piles.geojson",
            *more)  # fmt: skip


def test_the_command_writes_volumes_changes_and_a_picture(quarry, tmp_path, capsys):
    found = reported(capsys, *series(quarry, "--out", tmp_path / "growth"))
    assert found["dates"] == list(DATES)
    assert [r["name"] for r in found["regions"]] == ["gravel", "sand", "all"]
    gravel, sand, _ = found["regions"]
    y, x = np.mgrid[: SHAPE[0], : SHAPE[1]][:, ::-1] * CELL
    inside = (np.abs(x - 21.75) < 11) & (np.abs(y - 31.75) < 11)
    for c, (a, b) in zip(gravel["changes"], intervals(3), strict=True):
        true = float((exact(b) - exact(a))[inside].sum()) * CELL**2
        assert c["net"]["value"] == pytest.approx(true, abs=3.5 * c["net"]["sigma"])
        assert c["net"]["significant"]
    assert not sand["changes"][0]["net"]["significant"]
    assert sand["rate"]["p_constant"] < 0.05 < gravel["rate"]["p_constant"]
    printed = values_of(found)
    assert (printed["heights.series"]["n"], printed["heights.series"]["total"]) == (5, 9)
    assert printed["heights.series_orientations"]["common"] == "independent"
    out = tmp_path / "growth"
    assert json.loads((out / "volumes.json").read_text())["regions"] == found["regions"]
    rows = list(csv.DictReader((out / "changes.csv").read_text().splitlines()[1:]))
    assert [(r["region"], r["net_significant"]) for r in rows if r["from"] == DATES[0] and r["to"] == DATES[1]] == [
        ("gravel", "1"), ("sand", "0"), ("all", "0")
    ]  # fmt: skip
    assert float(rows[0]["net"]) == pytest.approx(gravel["changes"][0]["net"]["value"], rel=1e-6)
    picture = (out / "volumes.svg").read_text()
    assert picture.count("<circle") == 9
    assert all(word in picture for word in (*DATES, "gravel", "sand"))
    with Image.open(out / "volumes.png") as image:
        pixels = np.asarray(image.convert("RGB")).astype(int)
    # the same drawing, twice as fine: dots and bands lie where they lie in the drawing
    assert pixels.shape[:2] == tuple(2 * int(re.search(rf' {n}="(\d+)"', picture)[1]) for n in ("height", "width"))
    for x, y in re.findall(r'cx="([\d.]+)" cy="([\d.]+)"', picture):
        assert pixels[round(2 * float(y)), round(2 * float(x))] == pytest.approx((18, 54, 92), abs=12)
    band = np.array(re.search(r'class="band"[^>]*points="([^"]*)"', picture)[1].replace(",", " ").split(), float)
    x, y = band.reshape(-1, 2).mean(axis=0)
    assert (np.abs(pixels[round(2 * y) - 9 : round(2 * y) + 9, round(2 * x)] - (205, 219, 233)).max(axis=1) < 12).any()
    features = json.loads((out / "regions.geojson").read_text())["features"]
    assert [f["properties"]["region"] for f in features] == ["gravel", "sand"]
    assert 12.9 < features[0]["geometry"]["coordinates"][0][0][0] < 13.1
    assert (out / "regions.gpkg").is_file()


def test_bases_and_dates(quarry, capsys):
    level = reported(capsys, *series(quarry, "--above", 100))
    rim = reported(capsys, *series(quarry))
    first = reported(capsys, *series(quarry, "--above", quarry / DATES[0] / "surface"))
    changes = [[c["net"]["value"] for c in f["regions"][0]["changes"]] for f in (level, rim, first)]
    assert changes[0] == pytest.approx(changes[1])
    assert changes[0] == pytest.approx(changes[2])
    assert first["regions"][0]["volume"][0] == 0
    given = [w for d in ("2025-05-01", "2025-05-03", "2025-05-07") for w in ("--date", d)]
    assert reported(capsys, *series(quarry, *given))["dates"] == given[1::2]


def test_fill_and_cut_that_balance_are_no_missing_change(quarry, tmp_path, capsys):
    """A region of both piles, of which one grew and one shrank; its name is that of the sum."""
    piles = json.loads((quarry / "piles.geojson").read_text())
    piles["features"][0]["properties"]["name"] = "all"
    path = tmp_path / "piles.geojson"
    path.write_text(json.dumps(piles))
    days = [quarry / d / "surface" for d in (DATES[0], DATES[2])]
    found = reported(capsys, "heights", "time-series", *days, "--outline", path)
    assert [r["name"] for r in found["regions"]] == ["all", "sand", "all regions"]
    (change,) = found["regions"][2]["changes"]
    assert change["fill"]["significant"]
    assert change["cut"]["significant"]
    values = values_of(found)["heights.series_region"]
    assert values["parts"] == "both"
    text = phrase("heights.series_region", **values)
    assert f"no significant net change; fill {values['fill']}, cut {values['cut']} significant" in text


def test_what_makes_no_time_series_is_refused(quarry, tmp_path, capsys):
    surface = quarry / DATES[0] / "surface"
    outline = ("--outline", quarry / "piles.geojson")
    assert refusal(capsys, "heights", "time-series", surface, *outline)[0] == "time_series.one_surface"
    assert refusal(capsys, *series(quarry)[:-2])[0] == "time_series.no_outline"
    assert refusal(capsys, *series(quarry, "--date", DATES[0]))[0] == "time_series.dates_not_paired"
    old = quarry / "dsm-2019.tif"
    assert refusal(capsys, "heights", "time-series", old, surface, *outline)[0] == "height_grid.file"
    assert refusal(capsys, *series(quarry, "--above", old))[0] == "height_grid.file"
    back = [w for d in DATES[::-1] for w in ("--date", d)]
    assert refusal(capsys, *series(quarry, *back))[0] == "time_series.dates_not_ascending"
    assert refusal(capsys, "heights", "time-series", surface, surface, *outline)[0] == "height_grid.identical"
    hole = measured(1, np.random.default_rng(1))
    height = hole.heights.height.copy()
    height[40:90, 30:60] = np.nan
    hollow = folder_of(
        replace(hole, heights=replace(hole.heights, height=height)), tmp_path / "hollow", left=360000.0, top=5650060.0,
        wkt=rasterio.crs.CRS.from_epsg(32633).to_wkt(),
    )  # fmt: skip
    assert refusal(capsys, "heights", "time-series", surface, hollow, *outline)[0] == "volume.no_height"
