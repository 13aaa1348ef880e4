"""`raybundle heights`: what people compute from heights, through the door."""

import csv
import json
import re
from dataclasses import replace

import numpy as np
import pytest
from tests.cli.reported import refusal, reported, values_of
from tests.surface.height_models import folder_of, made, middles

from raybundle.cli.main import main
from raybundle.surfaces.files.heights import read_heights

rasterio = pytest.importorskip("rasterio")
SHAPE = (64, 96)


@pytest.fixture(scope="module")
def cone(tmp_path_factory):
    """A cone of 0.1 m on a wall, with drawn errors and a hole."""
    x, y = middles(SHAPE)
    shape = np.maximum(0.1 * (1 - np.hypot(x - 0.48, y - 0.32) / 0.2), 0.0)
    model = made(shape, rng=np.random.default_rng(1), common=5e-4, sigma=5e-4)
    height = model.heights.height.copy()
    height[10:14, 80:84] = np.nan
    height[20:50, 4:24] = np.nan
    return folder_of(replace(model, heights=replace(model.heights, height=height)), tmp_path_factory.mktemp("cone"))


def refused(capsys, *words):
    capsys.readouterr()
    assert main([*map(str, words)]) == 2
    return capsys.readouterr().err


def test_volume_of_a_cone(cone, capsys, tmp_path):
    found = reported(capsys, "heights", "volume", cone, "--extent", 0.25, 0.02, 0.95, 0.62, "--above", 0)
    exact = np.pi * 0.2**2 * 0.1 / 3
    assert found["net"]["value"] == pytest.approx(exact, abs=3 * found["net"]["sigma"])
    assert found["net"]["sigma"] == pytest.approx(
        np.hypot(found["net"]["sigma_local"], found["net"]["sigma_orientation"])
    )
    assert found["plan_area"] == pytest.approx(0.42)
    assert found["filled"] == pytest.approx(16e-4 / 0.42)
    assert found["unit"] == "m"
    ring = [[0.25, 0.02], [0.95, 0.02], [0.95, 0.62], [0.25, 0.62], [0.25, 0.02]]
    (tmp_path / "area.geojson").write_text(json.dumps({"type": "Polygon", "coordinates": [ring]}))
    (tmp_path / "area.csv").write_text("x,y\n" + "\n".join(f"{x},{y}" for x, y in ring[:4]) + "\n")
    for given in (tmp_path / "area.geojson", tmp_path / "area.csv", "0.25 0.02, 0.95 0.02, 0.95 0.62, 0.25 0.62"):
        again = reported(capsys, "heights", "volume", cone, "--outline", given, "--above", 0)
        assert again["net"] == pytest.approx(found["net"])
    rim = reported(capsys, "heights", "volume", cone, "--outline", tmp_path / "area.csv")
    assert rim["net"]["value"] == pytest.approx(exact, abs=3 * rim["net"]["sigma"])
    assert rim["net"]["sigma_orientation"] < found["net"]["sigma_orientation"] / 3
    printed = values_of(reported(capsys, "heights", "volume", cone, "--outline", tmp_path / "area.csv", "--above", 0))
    assert printed["heights.volume"]["base"] == "0"
    assert printed["heights.volume"]["above"].startswith("0.00419")  # exact: 0.004189
    assert printed["heights.volume_filled"]["share"] == pytest.approx(found["filled"])


def test_volume_between_two_surfaces(cone, capsys, tmp_path):
    other = folder_of(made(np.full(SHAPE, -0.01), common=5e-4, sigma=5e-4), tmp_path / "flat")
    found = reported(capsys, "heights", "volume", cone, "--extent", 0.25, 0.02, 0.95, 0.62, "--above", other)
    exact = np.pi * 0.2**2 * 0.1 / 3 + 0.42 * 0.01
    assert found["net"]["value"] == pytest.approx(exact, abs=3 * found["net"]["sigma"])
    level = reported(capsys, "heights", "volume", cone, "--extent", 0.25, 0.02, 0.95, 0.62, "--above", 0)
    assert found["net"]["sigma_orientation"] == pytest.approx(np.sqrt(2) * level["net"]["sigma_orientation"])


def test_bad_outlines_are_refused(cone, capsys, tmp_path):
    volume = ("heights", "volume", cone, "--above", 0)
    code, values = refusal(capsys, *volume, "--extent", 2, 2, 3, 3)
    assert code == "outline.beyond_heights"
    assert pytest.approx([values[k] for k in ("left", "bottom", "right", "top")]) == [0, 0, 0.96, 0.64]
    assert "is empty" in refused(capsys, *volume, "--extent", 0.5, 0.1, 0.2, 0.5)
    crossed = "0.3 0.1, 0.9 0.6, 0.9 0.1, 0.3 0.6"
    assert "[flight_area.crosses_itself]" in refused(capsys, *volume, "--outline", crossed)
    on_a_line = refused(capsys, *volume, "--outline", "0.1 0.1, 0.2 0.2, 0.3 0.3")
    assert "[flight_area.no_area]" in on_a_line
    assert "corridor" not in on_a_line
    ring = [[0.25, 0.02], [0.95, 0.02], [0.95, 0.62], [0.25, 0.62], [0.25, 0.02]]
    named = {"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}
    (tmp_path / "84.geojson").write_text(json.dumps({"type": "Polygon", "coordinates": [ring], "crs": named}))
    code, values = refusal(capsys, *volume, "--outline", tmp_path / "84.geojson")
    assert code == "outline.heights_in_no_map"
    assert any("CRS84" in str(v) for v in values.values())
    code, values = refusal(capsys, *volume, "--outline", "0.1 0.1, 0.2 0.2")
    assert code == "outline.too_few_corners"
    assert "0.1 0.1, 0.2 0.2" in values.values()
    assert "[outline.neither_file_nor_corners]" in refused(capsys, *volume, "--outline", "0,0 1,0 1,1")
    for empty in ("", " "):
        assert refusal(capsys, *volume, "--outline", empty) == ("outline.option_empty", {"name": "outline"})
    code, values = refusal(capsys, *volume, "--extent", 0.02, 0.1, 0.4, 0.5)
    assert (code, values["n"], values["fill"]) == ("volume.no_height", 200, "0.2")
    assert values["distance"] == pytest.approx(0.1, abs=0.005)
    wide = (*volume, "--extent", 0.02, 0.1, 0.4, 0.5, "--fill", 0.3)
    code, values = refusal(capsys, *wide)
    assert (code, values["limit_percent"]) == ("volume.filled_share", 20)
    assert reported(capsys, *wide, "--most-filled", 60)["filled_sigma"] > 0
    assert "[option.exclusive]" in refused(capsys, *volume, "--outline", crossed, "--extent", 0, 0, 1, 1)
    assert "--above nowhere" in refused(capsys, "heights", "volume", cone, "--above", "nowhere")
    assert "[volume.rim_needs_outline]" in refused(capsys, "heights", "volume", cone)
    (tmp_path / "area.kml").write_text("<kml/>")
    assert "area.kml" in refused(capsys, *volume, "--outline", tmp_path / "area.kml")
    assert "[folder.missing_itself]" in refused(capsys, "heights", "volume", tmp_path / "no")
    assert "heights.tif" in refused(capsys, "heights", "volume", tmp_path)


def square(low, high):
    return [[low, low], [high, low], [high, high], [low, high], [low, low]]


def test_areas_in_plan_are_those_of_their_outlines(tmp_path, capsys):
    folder = folder_of(made(np.zeros(SHAPE)), tmp_path / "s")
    file = tmp_path / "area.geojson"
    volume = ("heights", "volume", folder, "--above", 0, "--outline", file)

    def written(*rings):
        file.write_text(json.dumps({"type": "Polygon", "coordinates": rings}))

    turned = "0.312 0.101, 0.507 0.153, 0.455 0.348, 0.26 0.296"
    plan = reported(capsys, *volume[:-1], turned)["plan_area"]
    assert plan == pytest.approx(0.195**2 + 0.052**2, rel=1e-9)
    written(square(0.1234, 0.4321), square(0.2, 0.25), square(0.3, 0.377))
    exact = 0.3087**2 - 0.05**2 - 0.077**2
    assert reported(capsys, *volume)["plan_area"] == pytest.approx(exact, rel=1e-9)
    # a hole that touches the edge lies within
    written(square(0.1, 0.4), [[0.1, 0.2], [0.2, 0.2], [0.2, 0.3], [0.1, 0.3], [0.1, 0.2]])
    assert reported(capsys, *volume)["plan_area"] == pytest.approx(0.08, rel=1e-9)


@pytest.mark.parametrize(
    ("holes", "said"),
    [
        ([square(0.3, 0.5)], r"Hole 1 .* 0\.45, 0\.3\. .*outline\.hole_outside"),
        ([square(0.15, 0.2), square(0.5, 0.6)], r"Hole 2 .* 0\.55, 0\.5\. .*outline\.hole_outside"),
        ([square(0.15, 0.3), square(0.2, 0.35)], r"Holes 1 and 2 .*outline\.holes_overlap"),
        ([square(0.15, 0.3), square(0.2, 0.25)], r"Holes 1 and 2 .*outline\.holes_overlap"),
        ([square(0.2, 0.25), square(0.2, 0.25)], r"Holes 1 and 2 .* 0\.2, 0\.2\. .*outline\.holes_overlap"),
        ([square(0.1, 0.4)], r"outline\.only_holes"),
    ],
)
def test_holes_that_lie_not_within_their_area_are_refused(tmp_path, capsys, holes, said):
    """They would be added, or taken off twice."""
    folder = folder_of(made(np.zeros(SHAPE)), tmp_path / "s")
    file = tmp_path / "area.geojson"
    file.write_text(json.dumps({"type": "Polygon", "coordinates": [square(0.1, 0.4), *holes]}))
    assert re.search(said, refused(capsys, "heights", "volume", folder, "--above", 0, "--outline", file))


def test_holes_that_an_outline_or_the_edge_cuts_off_are_filled(tmp_path, capsys):
    """Of a tilted plane: a hole that is open to the edge of the grid, and one that goes on beyond the outline."""
    x, y = middles(SHAPE)
    model = made(0.2 * x + 0.1 * y, sigma=1e-4, rng=np.random.default_rng(4))
    height = model.heights.height.copy()
    height[0:6, 40] = np.nan
    height[30:60, 60:90] = np.nan
    folder = folder_of(replace(model, heights=replace(model.heights, height=height)), tmp_path / "s")
    volume = ("heights", "volume", folder, "--above", 0)
    whole = reported(capsys, *volume, "--extent", 0.3, 0.4, 0.5, 0.64)
    assert whole["filled"] == pytest.approx(6 / (20 * 24))
    exact = 0.2 * 0.24 * (0.2 * 0.4 + 0.1 * 0.52)
    assert whole["net"]["value"] == pytest.approx(exact, abs=3 * whole["net"]["sigma"] + 1e-7)
    # three columns of a hole that is 30 cells wide
    beside = reported(capsys, *volume, "--extent", 0.5, 0.1, 0.63, 0.3, "--most-filled", 30)
    assert beside["filled"] == pytest.approx(3 / 13)
    exact = 0.13 * 0.2 * (0.2 * 0.565 + 0.1 * 0.2)
    assert beside["net"]["value"] == pytest.approx(exact, abs=3 * beside["net"]["sigma"])
    code, values = refusal(capsys, *volume, "--extent", 0.5, 0.1, 0.7, 0.3)
    assert (code, values["n"], values["fill"]) == ("volume.no_height", 95, "0.2")
    assert reported(capsys, *volume, "--extent", 0.5, 0.1, 0.7, 0.3, "--fill", 0.2, "--most-filled", 60)[
        "filled"
    ] == pytest.approx(0.5)


def test_a_surface_differs_from_itself_by_nothing(cone, capsys):
    found = reported(capsys, "heights", "volume", cone, "--above", cone, "--extent", 0.3, 0.1, 0.7, 0.5)
    assert found["net"] == {"value": 0, "sigma": 0, "sigma_local": 0, "sigma_orientation": 0}


def test_volumes_are_told_with_the_digits_they_have():
    from raybundle.cli.heights.words import measured, plain

    assert measured(62995.3, 9812.0, "m", 3) == "63 000 m3 (sigma 9800)"
    assert measured(-62995.3, 98.12, "m", 3) == "-62 995 m3 (sigma 98)"
    assert measured(0.0123456, 1.234e-4, "m") == "0.01235 m (sigma 0.00012)"
    assert measured(0.0, 0.0, "m") == "0 m (sigma 0)"
    assert plain(40130.61) == "40 130.6"
    assert plain(1.5) == "1.5"
    assert plain(0.0) == "0"


@pytest.mark.parametrize("common", [None, 1e-3])
def test_surfaces_whose_orientation_is_held_have_no_errors_of_it(tmp_path, capsys, common):
    """With and without: every command bears both."""
    rng = np.random.default_rng(8)
    x, _ = middles(SHAPE)
    one, two = (
        folder_of(made(0.05 * np.sin(9 * x), rng=rng, sigma=4e-4, common=common), tmp_path / name) for name in "ab"
    )
    found = reported(capsys, "heights", "difference", one, two)
    assert not found["regions"]
    assert found["whole"]["shift_sigma"] > 0
    (cut,) = reported(capsys, "heights", "section", one, "--line", "0.1 0.1, 0.8 0.5", "--between", 0, 0.4)["sections"]
    assert cut["difference_sigma"] > 0
    for above in ("rim", "0", two):
        net = reported(capsys, "heights", "volume", one, "--extent", 0.1, 0.1, 0.5, 0.5, "--above", above)["net"]
        assert (net["sigma_orientation"] == 0) == (common is None)
    reported(capsys, "heights", "contours", one, "--interval", 0.02, "--out", tmp_path / "c.svg")
    reported(capsys, "heights", "ground", one, "--largest", 0.1, "--slope", 100)
    assert not reported(capsys, "heights", "difference", two, tmp_path / "a/ground", "--out", tmp_path / "d")["regions"]


def test_sections_are_written_as_table_picture_and_drawing(cone, capsys, tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    files = [tmp_path / f"cut.{e}" for e in ("csv", "svg", "dxf")]
    found = reported(
        capsys, "heights", "section", cone, "--line", "0.02 0.32, 0.9 0.32", "--line", "0.48 0.02, 0.48 0.6",
        *(w for f in files for w in ("--out", f)),
    )  # fmt: skip
    one, two = found["sections"]
    assert one["length"] == pytest.approx(0.88)
    assert two["with_height"] == 1
    assert 0.7 < one["with_height"] < 0.85
    with files[0].open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert {r["section"] for r in rows} == {"section 1", "section 2"}
    assert rows[0]["height [m]"] != ""
    assert any(not r["height [m]"] for r in rows)  # the hole
    assert {r["filled"] for r in rows if r["height [m]"]} == {"0"}
    for k, statistics_of in enumerate((one, two), 1):
        mine = [r for r in rows if r["section"] == f"section {k}"]
        d, h = (np.array([float(r[c] or "nan") for r in mine]) for c in ("distance [m]", "height [m]"))
        each, far = np.convolve(h, [0.5, 0.5], "valid"), np.diff(d)
        good = np.isfinite(each)
        assert statistics_of["mean"] == pytest.approx((each * far)[good].sum() / far[good].sum(), abs=1e-7)
        assert statistics_of["with_height"] == pytest.approx(far[good].sum() / d[-1], abs=1e-6)
    middle = min((r for r in rows if r["section"] == "section 2"), key=lambda r: abs(float(r["distance [m]"]) - 0.3))
    assert float(middle["height [m]"]) == pytest.approx(0.1, abs=5e-3)
    assert 0 < float(middle["sigma [m]"]) < 2e-3
    svg = files[1].read_text()
    assert svg.count('class="band"') == 3  # the hole parts the first
    assert "distance [m]" in svg
    drawing = ezdxf.readfile(files[2])
    assert {"PROFILE", "BAND_UPPER", "BAND_LOWER"} <= {layer.dxf.name for layer in drawing.layers}
    assert len(drawing.modelspace().query("LWPOLYLINE[layer=='PROFILE']")) == 3
    assert drawing.header["$INSUNITS"] == 6


def test_what_of_a_section_was_filled_is_reported(cone, capsys, tmp_path):
    table = tmp_path / "cut.csv"
    line = ("heights", "section", cone, "--line", "0.02 0.32, 0.9 0.32", "--fill", 0.4)
    (one,) = reported(capsys, *line, "--out", table)["sections"]
    assert one["with_height"] == 1
    with table.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    share = sum(r["filled"] == "1" for r in rows) / len(rows)
    assert one["filled"] == pytest.approx(share, abs=0.01)
    assert 0.2 < share < 0.3
    printed = values_of(reported(capsys, *line))
    assert printed["heights.section_precision"]["share"] == 1
    assert printed["heights.section_filled"]["share"] == pytest.approx(one["filled"])
    found = reported(capsys, "heights", "section", cone, "--line", "0.48 0.02, 0.48 0.6")
    assert "heights.section_filled" not in values_of(found)


def test_nothing_is_said_of_next_to_nothing_that_was_filled(tmp_path, capsys):
    """An outline that reaches into a cell of a hole by a ten-thousandth of its width."""
    model = made(np.zeros(SHAPE))
    height = model.heights.height.copy()
    height[20:24, 20:24] = np.nan
    folder = folder_of(replace(model, heights=replace(model.heights, height=height)), tmp_path / "s")
    volume = ["heights", "volume", str(folder), "--above", "0", "--extent", "0.239999", "0.3", "0.6", "0.5"]
    assert 0 < reported(capsys, *volume)["filled"] < 5e-5
    assert "heights.volume_filled" not in values_of(reported(capsys, *volume))


def test_differences_of_height_are_of_places_that_were_measured(cone, capsys):
    """Two places 0.1 m and 0.3 m from the beginning, the second at the top of the cone; and others in a hole."""
    line = ("heights", "section", cone, "--line", "0.48 0.02, 0.48 0.6")
    for step in ((), ("--step", 0.25)):
        (one,) = reported(capsys, *line, "--between", 0.102, 0.297, *step)["sections"]
        exact = 0.1 * (1 - np.hypot(0, 0.003) / 0.2) - 0.1 * (1 - (0.3 - 0.102) / 0.2)
        # between cells an edge as the top is a little too low
        assert one["difference"] == pytest.approx(exact, abs=4 * one["difference_sigma"] + 2e-3)
    hole = ("heights", "section", cone, "--line", "0.02 0.32, 0.9 0.32")
    code, values = refusal(capsys, *hole, "--between", 0.1, 0.5)
    assert (code, values["name"], values["unit"]) == ("section.no_height_at", "section 1", "m")
    place = [values[k] for k in ("at", "x", "y", "nearest", "distance")]
    assert place == pytest.approx([0.1, 0.12, 0.32, 0.01, 0.09], abs=1e-6)
    assert reported(capsys, *hole, "--between", 0.1, 0.5, "--fill", 0.4)["sections"][0]["difference_sigma"] > 0
    inside = ("heights", "section", cone, "--line", "0.08 0.3, 0.2 0.4", "--between", 0.01, 0.1)
    assert "[section.no_height]" in refused(capsys, *inside)
    assert refusal(capsys, *line, "--between", 0.2, 0.2) == ("section.same_place", {"at": 0.2})
    assert main([*map(str, hole)]) == 0
    assert "[section.partly_measured]" in capsys.readouterr().out


def test_bad_lines_are_refused(cone, capsys, tmp_path):
    section = ("heights", "section", cone)
    assert refusal(capsys, *section) == ("option.missing", {"setting": "line", "value": "CORNERS"})
    assert "[section.outside]" in refused(capsys, *section, "--line", "3 3, 4 4")
    assert "[outline.line_without_length]" in refused(capsys, *section, "--line", "0.1 0.1, 0.1 0.1")
    code, values = refusal(capsys, *section, "--line", "0 0, 0.5 0.5", "--between", 0, 9)
    assert (code, values["at"]) == ("section.beyond_end", 9)
    assert "[outline.neither_file_nor_corners]" in refused(capsys, *section, "--line", "0,0 1,0")
    assert "[outline.single_place]" in refused(capsys, *section, "--line", "0.2 0.2")
    twice = [tmp_path / "twice.csv"] * 2
    found = reported(capsys, *section, "--line", "0.3 0.1, 0.5 0.1", *(w for f in twice for w in ("--out", f)))
    assert found["files"] == [str(twice[0])]
    assert "[file.suffix]" in refused(capsys, *section, "--line", "0 0, 1 1", "--out", tmp_path / "a.png")
    code, values = refusal(capsys, *section, "--line", "0 0, 0.9 0.6", "--step", 1e-9)
    assert (code, values["most"]) == ("section.too_many_places", 1_000_000)


def test_contours_are_written_for_gis_and_cad(cone, capsys, tmp_path):
    pytest.importorskip("pyogrio")
    pytest.importorskip("contourpy")
    import pyogrio.raw

    files = [tmp_path / f"lines.{e}" for e in ("gpkg", "geojson", "dxf", "svg")]
    found = reported(capsys, "heights", "contours", cone, "--interval", 0.02, *(w for f in files for w in ("--out", f)))
    assert found["levels"] == pytest.approx([0.0, 0.02, 0.04, 0.06, 0.08])
    about_lines, _, shapes, fields = pyogrio.raw.read(files[0])
    assert about_lines["geometry_type"] == "LineString Z"
    assert len(shapes) == found["lines"]
    heights = fields[list(about_lines["fields"]).index("height")]
    assert set(np.round(heights, 6)) == {0.0, 0.02, 0.04, 0.06, 0.08}
    features = json.loads(files[1].read_text())["features"]
    top = next(f for f in features if abs(f["properties"]["height"] - 0.08) < 1e-9)
    xyz = np.array(top["geometry"]["coordinates"])
    assert np.abs(np.hypot(xyz[:, 0] - 0.48, xyz[:, 1] - 0.32) - 0.04).max() < 5e-3
    assert 'class="thick"' in files[3].read_text()
    level = folder_of(made(np.full(SHAPE, 0.3)), tmp_path / "level")
    assert "[contours.none]" in refused(
        capsys, "heights", "contours", level, "--interval", 0.2, "--out", tmp_path / "a.svg"
    )
    contours = ("heights", "contours", cone)
    assert refusal(capsys, *contours, "--interval", 1) == ("option.missing", {"setting": "out", "value": "FILE"})
    assert refusal(capsys, *contours) == ("option.missing", {"setting": "interval", "value": "HEIGHT"})
    fine = reported(capsys, *contours, "--interval", 0.0005, "--out", tmp_path / "fine.svg")
    assert values_of(fine, ["warnings"])["contours.interval_too_small"]["interval"] == 0.0005


def test_the_ground_is_a_surface_again(tmp_path, capsys):
    x, _ = middles((80, 100), 0.5)
    terrain = 0.05 * x
    things = np.zeros(terrain.shape)
    things[30:42, 40:55] = 3.0
    folder = folder_of(made(terrain + things, cell=0.5, sigma=0.02, rng=np.random.default_rng(2)), tmp_path / "s")
    found = reported(capsys, "heights", "ground", folder, "--largest", 9)
    assert found["standing"] == pytest.approx(180 / 8000, rel=0.05)
    model, file = read_heights(folder / "ground")
    assert file.unit == "m"
    assert model.holes is not None
    assert np.abs(model.heights.height - terrain)[30:42, 40:55].max() < 0.3
    filled = model.holes.filled
    assert filled[30:42, 40:55].all()
    assert found["filled_sigma"] > found["sigma"]
    with rasterio.open(folder / "ground/heights_sigma.tif") as bands:
        assert np.allclose(bands.read(1), model.sigma)
    above = reported(capsys, "heights", "volume", folder, "--extent", 18, 18, 29, 26, "--above", folder / "ground")
    assert above["net"]["value"] == pytest.approx(180 * 0.25 * 3.0, abs=4 * above["net"]["sigma"])
    assert "[folder.exists]" in refused(capsys, "heights", "ground", folder, "--largest", 9)
    ground = ("heights", "ground", folder, "--out", tmp_path / "g")
    code, values = refusal(capsys, *ground, "--largest", 1e-9)
    assert (code, values["cell"]) == ("terrain.object_below_cell", 0.5)
    assert "[terrain.slope_too_large]" in refused(capsys, *ground, "--largest", 9, "--slope", 1e9)
    assert "[terrain.object_too_wide]" in refused(
        capsys, "heights", "ground", folder, "--largest", 30, "--out", tmp_path / "g"
    )


def test_what_has_moved_is_written(tmp_path, capsys):
    pytest.importorskip("pyogrio")
    import pyogrio.raw

    rng = np.random.default_rng(3)
    relief = np.zeros(SHAPE)
    before = folder_of(made(relief, rng=rng, sigma=4e-4, common=1e-3), tmp_path / "before")
    relief[18:48, 30:60] += 3e-3
    after = folder_of(made(relief, rng=rng, sigma=4e-4, common=1e-3), tmp_path / "after")
    found = reported(capsys, "heights", "difference", before, after, "--out", tmp_path / "moved")
    (region,) = found["regions"]
    assert region["amount"] == pytest.approx(3e-3, abs=4 * region["amount_sigma"])
    assert region["mean"] == pytest.approx(region["volume"] / region["area"], rel=1e-9)
    assert region["area"] == pytest.approx(0.09, abs=4 * region["area_sigma"])
    with (tmp_path / "moved/moved.csv").open(encoding="utf-8") as file:
        assert next(file) == "# lengths in m\n"
        assert next(file).startswith("# mean: volume")
        (row,) = csv.DictReader(file)
    assert float(row["mean"]) == pytest.approx(float(row["volume"]) / float(row["area"]), rel=1e-6)
    assert float(row["amount"]) == pytest.approx(region["amount"], rel=1e-6)
    assert float(row["x"]) == pytest.approx(0.45, abs=0.02)
    assert float(row["y"]) == pytest.approx(0.64 - 0.33, abs=0.02)
    with rasterio.open(tmp_path / "moved/difference.tif") as bands:
        assert bands.descriptions[0] == "difference"
        assert (bands.read(6)[20:46, 32:58] == 1).all()
    about, _, shapes, _ = pyogrio.raw.read(tmp_path / "moved/moved.gpkg")
    assert len(shapes) == 1
    assert about["geometry_type"] == "Polygon Z"
    with (tmp_path / "moved/smallest.csv").open(encoding="utf-8") as file:
        assert next(file) == "# lengths in m\n"
        assert next(file).startswith("# of squares: ")
        assert next(file).startswith("# empty, or no row: not known")
        rows = list(csv.DictReader(file))
    assert [float(r["side"]) for r in rows] == pytest.approx([0.05, 0.1, 0.2])
    assert [float(r["amount"]) for r in rows] == pytest.approx([s["amount"] for s in found["smallest"]], rel=1e-3)
    assert 2e-4 < found["smallest"][-1]["amount"] < found["smallest"][0]["amount"] < 2e-3
    assert found["same"] == 0
    assert "[height_grid.identical]" in refused(capsys, "heights", "difference", before, before)
    again = reported(capsys, "heights", "difference", before, after)
    printed = values_of(again)
    assert printed["heights.moved"]["n"] == 1
    assert printed["heights.region"]["mean"].startswith("0.00")
    assert printed["heights.region_inner"]["amount"].startswith("0.00")
    assert printed["heights.region_inner"]["peak"] == pytest.approx(region["peak"])
    assert not again["warnings"]
    assert float(printed["heights.level_of_detection"]["amount"]) == pytest.approx(again["smallest"][-1]["amount"], 0.1)
    sides = [m["values"]["side"] for m in again["details"] if m["code"] == "heights.smallest"]
    assert sides == pytest.approx([0.05, 0.1, 0.2])


def test_surfaces_of_two_frames_are_not_compared(tmp_path, capsys):
    model = made(np.zeros(SHAPE))
    one = folder_of(model, tmp_path / "one")
    plane = {"origin": [0.0, 0.0, 0.0], "right": [1.0, 0.0, 0.0], "up": [0.0, 0.1, 0.995], "normal": [0.0, -0.995, 0.1]}
    tilted = folder_of(model, tmp_path / "tilted", plane=plane)
    code, values = refusal(capsys, "heights", "difference", one, tilted)
    assert (code, values["limit_cells"]) == ("surface_files.planes_differ", 0.1)
    assert values["off_cells"] == pytest.approx(0.48, abs=0.005)
    free = folder_of(model, tmp_path / "free", unit="")
    assert "[surface_files.units_differ]" in refused(capsys, "heights", "difference", one, free)
    mapped = folder_of(model, tmp_path / "map", wkt="EPSG:32633" and rasterio.crs.CRS.from_epsg(32633).to_wkt())
    assert "[surface_files.one_in_map]" in refused(capsys, "heights", "difference", one, mapped)
    coarse = folder_of(made(np.zeros(SHAPE), cell=0.05), tmp_path / "coarse")
    assert "[surface_files.cells_differ]" in refused(capsys, "heights", "difference", one, coarse)
    away = folder_of(model, tmp_path / "away", left=50.0)
    assert "[height_grid.no_common_cell]" in refused(capsys, "heights", "difference", one, away)


def test_a_plane_that_is_moved_by_little_is_the_same(tmp_path, capsys):
    """Of the same wall, above a plane that lies 2 cm behind and is tilted by a thousandth."""
    x, _ = middles(SHAPE)
    one = folder_of(made(0.01 * np.sin(9 * x)), tmp_path / "one")
    turn = np.array([[1.0, 0.0, -1e-3], [0.0, 1.0, 0.0], [1e-3, 0.0, 1.0]])
    axes = turn @ np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
    origin = np.array([0.0, 0.02, 0.0])
    plane = {"origin": origin.tolist(), **{k: v.tolist() for k, v in zip(("right", "up", "normal"), axes, strict=True)}}
    other = folder_of(made(0.01 * np.sin(9 * x) + 0.02 + 1e-3 * x), tmp_path / "other", plane=plane)
    found = reported(capsys, "heights", "difference", one, other)
    assert found["whole"]["shift"] == pytest.approx(0.0, abs=1e-4)
    assert max(np.abs(found["whole"]["tilt"])) < 1e-4
    assert not found["regions"]


def test_without_scale_lengths_have_no_unit(tmp_path, capsys):
    folder = folder_of(made(np.full(SHAPE, 0.1)), tmp_path / "free", unit="")
    printed = values_of(reported(capsys, "heights", "volume", folder, "--above", 0))
    assert "heights.scale_free" in printed
    assert " m3" not in printed["heights.volume"]["above"]


def test_the_difference_of_an_edited_copy_is_reported(tmp_path, capsys):
    model = made(np.zeros(SHAPE), rng=np.random.default_rng(9), sigma=4e-4, common=1e-3)
    height = model.heights.height.copy()
    height[20:40, 50:70] += 5e-3
    one = folder_of(model, tmp_path / "one")
    other = folder_of(replace(model, heights=replace(model.heights, height=height)), tmp_path / "other")
    printed = values_of(reported(capsys, "heights", "difference", one, other))
    whole = printed["heights.whole"]
    assert (whole["shift"], whole["chi2"], whole["significant"]) == ("0 m (sigma 0)", 0, False)
    assert printed["heights.tilts"]["tilts"] == ["0 (sigma 0)", "0 (sigma 0)"]
    assert printed["heights.same_measurement"]["share"] == pytest.approx(1 - 400 / (64 * 96), abs=1e-9)
    assert printed["heights.region"]["mean"].startswith("0.0050")


MOVED = {"one": [(5e-3, 20, 40, 50, 70)], "none": [], "two": [(5e-3, 6, 26, 8, 28), (-3e-3, 34, 60, 50, 80)]}


@pytest.mark.parametrize("which", MOVED)
def test_the_picture_shows_what_has_moved_and_mutes_all_else(tmp_path, capsys, which):
    from PIL import Image

    rng = np.random.default_rng(10)
    relief = np.zeros(SHAPE)
    one, other = (made(relief, rng=rng, sigma=4e-4, common=1e-3) for _ in range(2))
    height = other.heights.height.copy()
    for by, *box in MOVED[which]:
        height[box[0] : box[1], box[2] : box[3]] += by
    height[2:4, 40:60] = np.nan
    folders = [
        folder_of(m, tmp_path / name)
        for m, name in ((one, "one"), (replace(other, heights=replace(other.heights, height=height)), "other"))
    ]
    found = reported(capsys, "heights", "difference", *folders, "--out", tmp_path / "d")
    assert len(found["regions"]) == len(MOVED[which])
    with Image.open(tmp_path / "d/difference.png") as image:
        shown = np.asarray(image).astype(int)
    scale = 1400 / SHAPE[1]
    colour = {}
    for r in range(SHAPE[0]):
        for c in range(SHAPE[1]):
            colour[r, c] = shown[round(44 + (r + 0.5) * scale), round(96 + (c + 0.5) * scale)]
    still = np.ones(SHAPE, bool)
    for by, a, b, c, d in MOVED[which]:
        red, _, blue = colour[(a + b) // 2, (c + d) // 2]
        assert (red - blue) * np.sign(by) > 60
        # labels stand beside a region, and an outline may be off by cells
        still[max(0, a - 8) : b + 8, c - 8 : min(SHAPE[1], d + 30)] = False
    still[np.isnan(height)] = False
    pale = np.array([v for place, v in colour.items() if still[place]])
    assert np.ptp(pale, axis=1).max() < 60
    assert pale.min() > 170
    hatched = shown[round(44 + 2.1 * scale) : round(44 + 3.9 * scale), round(96 + 41 * scale) : round(96 + 59 * scale)]
    assert set(hatched.reshape(-1, 3)[:, 0].tolist()) == {150, 186}
