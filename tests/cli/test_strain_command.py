"""`raybundle strain`: tables, maps and figures of rendered images of many kinds; refusals by their codes."""

import csv
import json

import numpy as np
import pytest
from PIL import Image
from tests.cli.reported import reported, values_of
from tests.matching.specimen import HEIGHT, WIDTH, deformed, image, motion
from tests.messages import refused

import raybundle as rb
from raybundle.errors import InputError

MOTION = motion(3.0, strain=(0.004, -0.002, 0.001), shift=(1.4, -0.6))
FEW = {"step": 24, "window": 21, "gauge": 3}


@pytest.fixture(scope="module")
def series(tmp_path_factory):
    """Reference and two images as grey PNG, colour PNG and TIFF of 16 bit; the last has lost a part."""
    folder = tmp_path_factory.mktemp("series")
    Image.fromarray(image(1)).save(folder / "load-00.png")
    first = deformed(2, *MOTION)
    Image.fromarray(np.repeat(first[..., None], 3, axis=2)).save(folder / "load-01.png")
    last = deformed(3, *MOTION).astype(np.uint16) * 200 + 3000
    last[HEIGHT - 110 :, WIDTH - 110 :] = 20000
    Image.fromarray(last).save(folder / "load-02.tif")
    return folder


def rows_of(path):
    with path.open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def test_a_series_of_several_kinds_of_files(series, tmp_path, capsys):
    out = tmp_path / "strains"
    done = reported(
        capsys, "strain", str(series / "load-00.png"), str(series / "load-01.png"), str(series / "load-02.tif"),
        "--out", str(out), "--step", "24", "--window", "21", "--gauge", "3", "--scale", "0.5",
    )  # fmt: skip
    counts = [{k: v for k, v in i.items() if k != "name"} for i in done["images"]]
    assert all(sum(c.values()) == done["subsets"] for c in counts)
    assert set(counts[0]) == {"followed", "outside"}
    assert counts[0]["followed"] > 0.9 * done["subsets"]
    lost = values_of(done)["strain.not_followed"]
    assert (lost["name"], lost["images"], lost["n"]) == ("load-02.tif", 2, done["subsets"] - counts[1]["followed"])
    assert {"unsteady", "unlike"} & set(counts[1])
    rows = rows_of(out / "displacements.csv")
    assert len(rows) == 2 * done["subsets"]
    assert {r["state"] for r in rows if r["u_px"]} == {"followed"}
    assert all(not r["sd_u_px"] for r in rows if r["state"] != "followed")
    for r in [r for r in rows if r["u_px"]][:5]:
        assert float(r["u_mm"]) == pytest.approx(0.5 * float(r["u_px"]), abs=1e-4)
    F = MOTION[0]
    E = (F.T @ F - np.eye(2)) / 2
    strains = rows_of(out / "strain.csv")
    found, sigma = (
        np.array([[float(r[f"{k}e{a}"]) for a in ("xx", "yy", "xy")] for r in strains]) for k in ("", "sd_")
    )
    # some twenty planes share no subset, and both images have the noise of the reference in common
    assert 0.75 < np.mean(((found - [E[0, 0], E[1, 1], E[0, 1]]) / sigma) ** 2) < 1.25
    contents = json.loads((out / "result.json").read_text())
    assert contents["strain_gauge_px"] == 69
    assert contents["images"][0]["rigid_motion"]["rotation_deg"] == pytest.approx(3.0, abs=0.01)
    assert [w["code"] for w in contents["warnings"]] == ["strain.not_followed"]
    maps = sorted(p.name for p in (out / "maps").iterdir())
    assert len(maps) == 16
    with Image.open(out / "maps" / "1-load-01-exx.png") as drawn:
        assert min(drawn.size) > 450


def test_python_gives_what_the_command_writes(series, tmp_path):
    done = rb.strain(series / "load-00.png", series / "load-01.png", tmp_path / "o", extent=(50, 40, 300, 260), **FEW)
    x, y = done.grid.xy_px.T
    assert (x.min(), y.min()) >= (60, 50)
    assert (x.max(), y.max()) <= (290, 250)
    assert len(rows_of(tmp_path / "o/displacements.csv")) == len(x)
    assert done.settings.scale is None


def test_areas_have_their_mean_displacement_and_strain(series, tmp_path, capsys):
    names = [str(series / f"load-0{k}") for k in ("0.png", "1.png", "2.tif")]
    given = ["--area", "left:30,30,160,260", "--area", "corner:0,0,40,40", "--step", "24", "--window", "21"]
    done = reported(capsys, "strain", *names, "--out", str(tmp_path / "o"), *given, "--gauge", "3", "--scale", "0.5")
    assert values_of(done)["strain.area"]["name"] == "left"
    assert values_of(done)["strain.area_empty"]["area"] == "corner"
    F, rows = MOTION[0], rows_of(tmp_path / "o/areas.csv")
    assert [(r["image"], r["area"]) for r in rows] == [("load-01.png", "left"), ("load-02.tif", "left")]
    E = (F.T @ F - np.eye(2)) / 2
    for r in rows:
        assert float(r["exx"]) == pytest.approx(E[0, 0], abs=4 * float(r["sd_exx"]))
        assert float(r["eyy"]) == pytest.approx(E[1, 1], abs=4 * float(r["sd_eyy"]))
        assert float(r["u_mm"]) == pytest.approx(0.5 * float(r["u_px"]), abs=1e-3)
        assert float(r["rotation_deg"]) == pytest.approx(3.0, abs=0.1)
        assert float(r["misfit"]) < 1.3
    for text, code in (("left", "area_text"), ("a:1,2,3", "area_text"), ("a:1,2,x,4", "area_text"),
                       ("a:9,2,3,4", "empty_extent"), ("a:9,2,9999,40", "area_outside")):  # fmt: skip
        with pytest.raises(InputError, match=rf"strain\.{code}"):
            rb.strain(names[0], names[1], tmp_path / "p", area=(text,))


def test_an_area_across_a_crack_has_no_standard_deviation_and_is_warned_of_first(series, tmp_path, capsys):
    apart, torn = motion(0.0, shift=(1.4, 0.0)), deformed(4, *motion(0.0))
    torn[:, WIDTH // 2 :] = deformed(4, *apart)[:, WIDTH // 2 :]
    Image.fromarray(torn).save(tmp_path / "torn.png")
    across = f"across:30,30,{WIDTH - 30},{HEIGHT - 30}"
    given = ("--area", across, "--area", f"left:30,30,{WIDTH // 2 - 40},{HEIGHT - 30}", "--step", 24, "--window", 21)
    done = reported(capsys, "strain", series / "load-00.png", tmp_path / "torn.png", "--out", tmp_path / "o", *given)
    stated = values_of(done)
    assert stated["strain.area"]["name"] == "left"
    assert stated["strain.area_not_one"]["name"] == "across"
    assert not any(name.startswith("s_") for name in stated["strain.area_not_one"])
    assert done["warnings"][0]["code"] == "strain.area_uneven"


def test_a_mask_leaves_out_what_is_black(series, tmp_path):
    mask = np.zeros((HEIGHT, WIDTH), np.uint8)
    mask[:, : WIDTH // 2] = 255
    Image.fromarray(mask).save(tmp_path / "mask.png")
    done = rb.strain(
        series / "load-00.png", series / "load-01.png", tmp_path / "o", mask=tmp_path / "mask.png",
        shape="quadratic", **FEW,
    )  # fmt: skip
    assert done.grid.xy_px[:, 0].max() < WIDTH / 2 - 10


def save(path, grey):
    Image.fromarray(grey).save(path)
    return path


def test_what_cannot_be_compared_is_refused(series, tmp_path):
    reference, out = series / "load-00.png", tmp_path / "o"
    small = save(tmp_path / "small.png", image(2)[:-20])
    with refused("strain.other_size", file="small.png", height_px=HEIGHT - 20, reference_height_px=HEIGHT):
        rb.strain(reference, small, out, **FEW)
    with refused("strain.other_size", file="small.png"):
        rb.strain(reference, series / "load-01.png", out, mask=small, **FEW)
    with refused("strain.same_image", reference="load-00.png"):
        rb.strain(reference, save(tmp_path / "copy.png", image(1)), out, **FEW)
    with refused("strain.nothing_followed", names=["other.png"]):
        rb.strain(reference, save(tmp_path / "other.png", image(2, lambda xy: xy + 900)), out, **FEW)
    with refused("strain.no_subset", window=301):
        rb.strain(reference, series / "load-01.png", out, window=301)
    with refused("strain.empty_extent"):
        rb.strain(reference, series / "load-01.png", out, extent=(50, 10, 20, 90))
    (tmp_path / "broken.tif").write_bytes((series / "load-02.tif").read_bytes()[:5000])
    with pytest.raises(rb.InputError) as caught:
        rb.strain(reference, tmp_path / "broken.tif", out, **FEW)
    assert caught.value.code
    assert not out.exists()


def test_an_image_of_another_object_costs_that_image_only(series, tmp_path):
    other = save(tmp_path / "other.png", image(2, lambda xy: xy + 900))
    done = rb.strain(series / "load-00.png", [other, series / "load-01.png"], tmp_path / "o", **FEW)
    assert not np.isfinite(done.images[0].displacement).any()
    assert np.isfinite(done.images[1].displacement).mean() > 0.85
    assert {m.code for m in done.reported} == {"strain.not_followed", "strain.no_strain"}
    contents = json.loads((tmp_path / "o/result.json").read_text())
    assert contents["images"][0]["median_sd_px"] == contents["images"][0]["median_strain"] is None


def test_images_without_noise_or_texture(tmp_path, series):
    """Rendered without noise and shifted by whole pixels: nothing is divided by zero; a blank reference is refused."""
    x = image(1, noise=0.0)
    a, b = save(tmp_path / "a.png", x[:, :-4]), save(tmp_path / "b.png", x[:, 4:])
    done = rb.strain(a, b, tmp_path / "o", **FEW)
    good = np.isfinite(done.images[0].displacement[:, 0])
    np.testing.assert_allclose(done.images[0].displacement[good], np.tile([-4.0, 0.0], (good.sum(), 1)), atol=1e-3)
    blank = save(tmp_path / "blank.png", np.full((HEIGHT, WIDTH), 90, np.uint8))
    with refused("strain.nothing_followed"):
        rb.strain(blank, series / "load-01.png", tmp_path / "p", **FEW)


def test_a_texture_that_repeats_and_subsets_that_contradict_their_neighbours_are_reported(tmp_path):
    y, x = np.mgrid[:200, :240].astype(float)
    rng = np.random.default_rng(4)
    for name, shift in (("a.png", 0.0), ("b.png", 7.0)):
        grid = 128 + 50 * np.cos(2 * np.pi * (x - shift) / 12) + 40 * np.cos(2 * np.pi * (y - shift) / 12)
        Image.fromarray(np.clip(grid + rng.normal(0, 2, grid.shape), 0, 255).astype(np.uint8)).save(tmp_path / name)
    done = rb.strain(tmp_path / "a.png", tmp_path / "b.png", tmp_path / "o", **FEW)
    found = {m.code: m for m in done.reported}
    assert found["strain.repeated"].values["period_px"] == pytest.approx(12, abs=0.1)
    assert found["strain.jumps"].severity == "fault"


def test_images_that_are_no_new_photographs_are_named(series, tmp_path):
    reference, other = series / "load-00.png", series / "load-01.png"
    with refused("strain.image_twice"):
        rb.strain(reference, [other, other], tmp_path / "o", **FEW)
    pages = [Image.open(p).convert("L") for p in (reference, other)]
    pages[0].save(tmp_path / "load-01.tif", save_all=True, append_images=pages[1:])
    (tmp_path / "second").mkdir()
    pages[1].save(tmp_path / "second" / "load-01.tif")
    white = Image.fromarray(np.full((HEIGHT, WIDTH), 255, np.uint8))
    white.save(tmp_path / "white.png")
    files = [tmp_path / "load-01.tif", tmp_path / "second" / "load-01.tif"]
    done = rb.strain(reference, files, tmp_path / "o", mask=tmp_path / "white.png", **FEW)
    assert [i.name for i in done.images] == [f"{tmp_path.name}/load-01.tif", "second/load-01.tif"]
    found = {m.code: m.values for m in done.reported}
    assert found["strain.pages"]["names"] == ["load-01.tif"]
    assert found["strain.same_content"]["names"] == [done.images[0].name]
    assert found["strain.mask_empty"]["name"] == "white.png"
    assert not {"strain.jumps", "strain.repeated", "strain.saturated"} & set(found)
