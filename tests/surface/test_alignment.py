"""Older models without photographs: aligned by what is stable, or refused; their noise; files through the door."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.ndimage import map_coordinates

from raybundle.cli.heights.alignment import alignment_warnings
from raybundle.surfaces.heights.alignment import aligned
from raybundle.surfaces.heights.displacement import movements
from raybundle.surfaces.heights.resampling import difference
from tests.cli.reported import refusal, reported, values_of
from tests.messages import refused
from tests.surface.height_models import folder_of, made
from tests.surface.quarry import CELL, DATES, LEFT, PILES, PLACED, SHAPE, TOP, exact, measured, older, written

rasterio = pytest.importorskip("rasterio")
R, C = np.mgrid[: SHAPE[0], : SHAPE[1]].astype(float)


def moved_by(old):
    return lambda plan: map_coordinates(
        old, [R + plan[1] / CELL, C - plan[0] / CELL], order=1, mode="constant", cval=np.nan
    )


@pytest.mark.parametrize("date", [0, 2])
def test_shift_and_tilts_are_found_with_their_standard_deviations(date):
    rng, z, shares = np.random.default_rng(21 + date), [], []
    for _ in range(6):
        *both, a = aligned(moved_by(older(rng)), measured(date, rng))
        shares.append(a.share)
        z.append((a.values - PLACED) / a.sigma)
        assert a.noise.common == pytest.approx(0.03, rel=0.25)
        assert a.noise.reach == pytest.approx(6.0, rel=0.4)
    # mean squares of 30 values that are nearly independent: 99.9 % lie below 2
    assert 0.3 < np.mean(np.square(z)) < 2.2
    # what chance makes large is not left out: else the noise that neighbours share would be too small
    assert np.mean(shares) > (0.8 if date else 0.998)
    # 2 cm of orientation of the surface move the older model along, and are in no difference
    assert a.sigma[0] > 0.02
    d = difference(*both)
    still = np.zeros(SHAPE)
    still[100:115, 20:140] = 1 / (15 * 120)
    assert d.sum_of(still).orientation < 0.01
    found = movements(d)
    if not date:
        assert not found.regions
        return
    places = {name: (round(SHAPE[0] - y / CELL), round(x / CELL)) for name, (x, y) in PILES.items()}
    at = {name: [r for r in found.regions if r.cells[row, column]] for name, (row, column) in places.items()}
    assert at["gravel"][0].amount == pytest.approx(1.1, abs=0.1)
    assert at["sand"][0].amount == pytest.approx(-0.8, abs=0.1)


def test_nearly_half_may_have_moved():
    rng = np.random.default_rng(31)
    later = exact(0) + np.where(0.44 * SHAPE[1] > C, 2.0, 0.0)
    *_, a = aligned(moved_by(older(rng)), measured(0, rng, later))
    assert np.abs((a.values - PLACED) / a.sigma).max() < 4
    assert not a.stable[:, : int(0.4 * SHAPE[1])].any()
    (narrow,) = alignment_warnings(a)
    assert narrow.code == "old_heights.narrow"
    assert not alignment_warnings(replace(a, given=True))
    assert not alignment_warnings(replace(a, share=0.8))


def test_halves_of_which_either_may_be_stable_are_refused():
    rng = np.random.default_rng(31)
    later = exact(0) + np.where(0.5 * SHAPE[1] > C, 2.0, 0.0)
    with refused("old_heights.ambiguous"):
        aligned(moved_by(older(rng)), measured(0, rng, later))


def test_a_given_stable_area_is_taken():
    rng = np.random.default_rng(32)
    later = exact(0) + np.where(0.7 * SHAPE[1] > C, 0.5, 0.0)
    old, new = older(rng), measured(0, rng, later)
    *_, a = aligned(moved_by(old), new, 0.75 * SHAPE[1] < C)
    assert np.abs((a.values - PLACED) / a.sigma).max() < 4
    assert not a.stable[0.75 * SHAPE[1] >= C].any()


def test_what_a_stable_area_does_not_determine_is_refused_with_its_direction():
    rng = np.random.default_rng(33)
    # valleys from west to east show no shift along them: 90 degrees from up
    valleys = 100 + 0.5 * np.sin(R / 6) + 0 * C
    with refused("old_heights.plan_undetermined", direction_deg=pytest.approx(90, abs=3), limit=CELL):
        aligned(moved_by(older(rng, valleys)), measured(0, rng, valleys))
    flat = 100 + 0 * C
    with refused("old_heights.plan_undetermined", limit=CELL):
        aligned(moved_by(older(rng, flat)), measured(0, rng, flat))
    with refused("old_heights.too_few", needed=100):
        aligned(moved_by(older(rng)), measured(0, rng), (R < 5) & (C < 5))


@pytest.fixture(scope="module")
def quarry(tmp_path_factory):
    folder = tmp_path_factory.mktemp("quarry")
    written(folder)
    return folder


def test_a_raster_is_compared_with_a_surface(quarry, tmp_path, capsys):
    surface = quarry / DATES[2] / "surface"
    found = reported(capsys, "heights", "difference", quarry / "dsm-2019.tif", surface, "--out", tmp_path / "old")
    a = found["alignment"]
    names = ("up", "tilt_right", "tilt_up", "right", "above")
    assert max(abs(a[n] - p) / a[f"{n}_sigma"] for n, p in zip(names, PLACED, strict=True)) < 4
    assert 2 <= len(found["regions"]) <= 3
    printed = values_of(found)
    assert {"heights.aligned", "heights.noise_estimated"} <= printed.keys()
    assert "heights.whole" not in printed
    aligned_lines = {k: v for k, v in printed.items() if k.startswith(("heights.aligned", "heights.noise"))}
    assert len(aligned_lines) == 4
    with rasterio.open(tmp_path / "old/detectable.tif") as file:
        assert file.descriptions[0].startswith("detectable over")
        assert file.shape == SHAPE
    for name in ("detectable.png", "difference.png"):
        assert (tmp_path / "old" / name).stat().st_size > 5000
    pile = f"{LEFT + 11} {TOP - 39}, {LEFT + 33} {TOP - 39}, {LEFT + 33} {TOP - 17}, {LEFT + 11} {TOP - 17}"
    found = reported(capsys, "heights", "volume", surface, "--outline", pile, "--above", quarry / "dsm-2019.tif")
    assert {k: v for k, v in values_of(found).items() if k in aligned_lines} == aligned_lines
    assert found["alignment"] == a
    volume = found["net"]
    inside = (np.abs((C + 0.5) * CELL - 22) < 11) & (np.abs((SHAPE[0] - R - 0.5) * CELL - 32) < 11)
    true = float((exact(2) - exact(0))[inside].sum()) * CELL**2
    assert volume["value"] == pytest.approx(true, abs=4 * volume["sigma"])
    assert volume["sigma"] < 10


def changed(quarry, path, change, dtype="float32"):
    """The older model with other heights."""
    with rasterio.open(quarry / "dsm-2019.tif") as file:
        about, heights = file.profile, file.read(1)
    with rasterio.open(path, "w", **(about | {"dtype": dtype})) as file:
        file.write(change(heights).astype(dtype), 1)
    return path


def test_the_later_of_both_may_be_the_one_without_photographs(quarry, capsys):
    old, surface = quarry / "dsm-2019.tif", quarry / DATES[2] / "surface"
    forth = reported(capsys, "heights", "difference", old, surface)
    back = reported(capsys, "heights", "difference", surface, old)
    assert back["alignment"] == forth["alignment"]
    assert [r["amount"] for r in back["regions"]] == pytest.approx([-r["amount"] for r in forth["regions"]], abs=1e-6)
    assert [r["volume"] for r in back["regions"]] == pytest.approx([-r["volume"] for r in forth["regions"]], abs=1e-4)


def test_a_file_in_place_of_a_surface_is_named_with_what_it_is_good_for(quarry, tmp_path, capsys):
    old, surface = quarry / "dsm-2019.tif", quarry / DATES[0] / "surface"
    for given in (("volume", old, "--above", 100), ("difference", old, old), ("contours", old, "--interval", 1,
                  "--out", tmp_path / "c.dxf")):  # fmt: skip
        assert refusal(capsys, "heights", *given) == ("height_grid.file", {"model": True})
    heights = surface / "heights.tif"
    assert refusal(capsys, "heights", "volume", heights, "--above", 100)[1]["model"] is False


@pytest.mark.parametrize("system", [32633, 25833, 32632])
def test_whole_numbers_with_scale_and_offset_are_heights(quarry, tmp_path, capsys, system):
    """As GDAL writes them: stored number times scale plus offset; in another system they are resampled first."""
    from rasterio.warp import Resampling, reproject, transform_bounds

    with rasterio.open(quarry / "dsm-2019.tif") as file:
        about, heights = file.profile, file.read(1)
        if system == 32632:
            left, low, right, top = transform_bounds(file.crs, f"EPSG:{system}", *file.bounds)
            t, w, h = rasterio.Affine(CELL, 0, left, 0, -CELL, top), *(int(x / CELL) for x in (right - left, top - low))
            there = np.full((h, w), np.nan, np.float32)
            reproject(heights, there, src_transform=file.transform, src_crs=file.crs, dst_transform=t,
                      dst_crs=f"EPSG:{system}", dst_nodata=np.nan, resampling=Resampling.cubic)  # fmt: skip
            heights, about = there, about | {"transform": t, "width": w, "height": h}
    about |= {"dtype": "int16", "nodata": -32768, "crs": f"EPSG:{system}"}
    stored = np.where(np.isfinite(heights), np.round((heights - 100) / 0.001), -32768).astype(np.int16)
    old = tmp_path / "scaled.tif"
    with rasterio.open(old, "w", **about) as file:
        file.write(stored, 1)
        file.scales, file.offsets = [0.001], [100.0]
    surface = quarry / DATES[0] / "surface"
    found = reported(capsys, "heights", "difference", old, surface)["alignment"]
    assert abs(found["up"] - PLACED[0]) < 4 * found["up_sigma"]


@pytest.mark.filterwarnings("error::RuntimeWarning")
def test_infinite_heights_are_void_and_a_wrong_datum_is_reported(quarry, tmp_path, capsys):
    hole = (slice(60, 66), slice(70, 76))

    def change(heights):
        heights[hole] = np.inf
        return heights - 150

    old = changed(quarry, tmp_path / "old.tif", change)
    volume = ("heights", "volume", quarry / DATES[0] / "surface", "--above", old, "--fill", 0, "--extent")
    found = values_of(reported(capsys, *volume, LEFT + 2, TOP - 20, LEFT + 20, TOP - 2))
    assert found["old_heights.far"]["up"] == pytest.approx(150 + PLACED[0], abs=0.2)
    assert refusal(capsys, *volume, LEFT + 30, TOP - 40, LEFT + 50, TOP - 20)[0] == "volume.no_height"


@pytest.mark.parametrize("dtype", ["int16", "float32"])
def test_heights_rounded_to_whole_units_are_refused(quarry, tmp_path, capsys, dtype):
    old = changed(quarry, tmp_path / "old.tif", np.round, dtype)
    surface = quarry / DATES[0] / "surface"
    assert refusal(capsys, "heights", "difference", old, surface)[0] == "old_heights.whole_units"


def test_heights_in_feet_are_refused(quarry, tmp_path, capsys):
    old = changed(quarry, tmp_path / "old.tif", lambda z: (z - np.nanmean(z)) / 0.3048 + np.nanmean(z))
    surface = quarry / DATES[2] / "surface"
    code, values = refusal(capsys, "heights", "difference", old, surface)
    assert (code, values["feet"]) == ("old_heights.other_unit", "yes")
    assert values["ratio"] == pytest.approx(3.28, rel=0.1)


def test_a_point_cloud_is_compared_with_a_surface(quarry, tmp_path, capsys):
    laspy = pytest.importorskip("laspy")
    rng = np.random.default_rng(34)
    header = laspy.LasHeader(point_format=3, version="1.4")
    header.offsets, header.scales = [LEFT, TOP, 0], [1e-3] * 3
    cloud = laspy.LasData(header)
    old = older(rng)
    cloud.x, cloud.y = (LEFT + (C + 0.5) * CELL).ravel(), (TOP - (R + 0.5) * CELL).ravel()
    cloud.z = old.ravel()
    path = tmp_path / "old.las"
    cloud.write(str(path))
    area = f"{LEFT + 40} {TOP - 59}, {LEFT + 79} {TOP - 59}, {LEFT + 79} {TOP - 1}, {LEFT + 40} {TOP - 1}"
    surface = quarry / DATES[0] / "surface"
    found = reported(capsys, "heights", "difference", path, surface, "--stable", area)
    assert found["alignment"]["stable"] == pytest.approx(0.48, abs=0.03)
    assert abs(found["alignment"]["right"] - PLACED[3]) < 4 * found["alignment"]["right_sigma"]
    path.write_bytes(path.read_bytes()[:300])
    assert refusal(capsys, "heights", "difference", path, surface)[0] == "old_heights.cloud_cut_off"


def test_what_needs_no_alignment_or_has_no_map_is_refused(quarry, tmp_path, capsys):
    surface = quarry / DATES[0] / "surface"
    stable = ("--stable", f"{LEFT} {TOP - 60}, {LEFT + 80} {TOP - 60}, {LEFT + 80} {TOP}")
    assert refusal(capsys, "heights", "difference", surface, surface, *stable)[0] == "old_heights.not_needed"
    assert refusal(capsys, "heights", "volume", surface, "--above", 100, *stable)[0] == "old_heights.not_needed"
    wall = folder_of(made(np.zeros((40, 48)), rng=np.random.default_rng(1)), tmp_path / "wall")
    assert refusal(capsys, "heights", "difference", quarry / "dsm-2019.tif", wall)[0] == "old_heights.no_map"
