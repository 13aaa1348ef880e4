"""Drawing sheets: true to scale in the rendered PDF, with words of all letters; drawings lie on pictures."""

import csv
import json
import re
import shutil
import subprocess
import tomllib
from dataclasses import replace
from datetime import UTC, datetime

import ezdxf
import numpy as np
import pyogrio
import pytest
from PIL import Image
from pypdf import PdfReader
from scipy.spatial import KDTree
from tests.cli.reported import codes_of, reported, values_of
from tests.messages import coded, refused

import raybundle as rb
from raybundle import adjust
from raybundle.block import Role
from raybundle.block.transform import transform_block
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.io.pictures.undistort import camera_plane
from raybundle.numerics.transform import SimilarityTransform
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, TargetField, aerial_scene, brown_camera, field_scene
from raybundle.report.write import write_result
from raybundle.words import headline
from raybundle.workflows.object_plane import plane_of

needs_poppler = pytest.mark.skipif(shutil.which("pdftoppm") is None, reason="pdftoppm of poppler renders the sheets")
DOT = 0.03
"""Radius of a dot [m]"""


@pytest.fixture(scope="module")
def wall(tmp_path_factory):
    """A result of photographs of an upright wall with black dots at its points."""
    folder = tmp_path_factory.mktemp("wall")
    small = brown_camera(size_px=(900, 600), pixel_mm=0.0267)
    scene = field_scene(TargetField(camera=small, columns=6, rows=4, stations=4, frontal=1, depth=0.0))
    exact = Survey(interior="exact", orientation="exact", points="exact", image_sigma_px=0.01)
    flat = simulate(scene, exact).observed
    stand = SimilarityTransform(
        scale=1.0, rotation=np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]), translation=np.zeros(3)
    )
    truth = transform_block(flat, stand, observed="stay")
    plane = plane_of(truth)
    (folder / "photos").mkdir()
    files = tuple(f"{k}.png" for k in range(len(truth.images)))
    y, x = np.mgrid[0:600, 0:900] + 0.5
    camera = truth.cameras[0]
    ideal = camera.image_from_pixel(camera_plane(camera, np.stack([x.ravel(), y.ravel()], axis=1))).T
    v = camera.values
    inner = np.stack([ideal[0] - v["x0"], ideal[1] - v["y0"], np.full(ideal.shape[1], -v["c"])])
    places = plane.coordinates(truth.points.xyz)[:, :2]
    for k, file in enumerate(files):
        ray = truth.images.rotation[k].T @ inner
        centre = truth.images.centre[k]
        at = centre[:, None] + ((plane.origin - centre) @ plane.axes[2]) / (plane.axes[2] @ ray) * ray
        uv = plane.coordinates(at.T)[:, :2]
        away, _ = KDTree(places).query(uv)
        grey = np.clip(255 * (0.5 + (away - DOT) / 0.01), 0, 255)
        Image.fromarray(grey.reshape(600, 900).round().astype(np.uint8)).save(folder / "photos" / file)
    ids = tuple(f"Müller {k}" if k < 3 else f"P{k}" for k in range(len(truth.points)))
    points = replace(
        truth.points, ids=ids, role=np.full(len(ids), Role.CONTROL, np.int32), sigma=np.full((len(ids), 3), 1e-4)
    )
    block = replace(truth, images=replace(truth.images, file=files), points=points)
    write_result(adjust(block), folder / "result", report="none")
    rb.rectify(
        folder / "result", folder / "wall.tif", photos=(folder / "photos",), pixel=0.005, vertical=True,
        plane=(ids[0], ids[20]), origin=ids[0], axis=(ids[0], ids[20]),
    )  # fmt: skip
    return folder


def dot_in(picture, x, y, reach):
    """Centre of the dark dot near a place of a picture [px], columns and rows from its outer corner."""
    i, j = int(y), int(x)
    top, left = max(i - reach, 0), max(j - reach, 0)
    part = picture[top : i + reach + 1, left : j + reach + 1].astype(float)
    dark = np.clip(255 - part, 0, None)
    dark[dark < 100] = 0
    rows, columns = np.mgrid[0 : part.shape[0], 0 : part.shape[1]] + 0.5
    return left + (dark * columns).sum() / dark.sum(), top + (dark * rows).sum() / dark.sum()


def drawn_points(file):
    """Places of the points of a drawing by their names."""
    found = {}
    for entity in ezdxf.readfile(file).modelspace().query("POINT"):
        words = [v for code, v in entity.get_xdata("RAYBUNDLE") if code == 1000]
        if entity.dxf.layer.startswith("points-"):
            found[words[0].removeprefix("name=")] = np.array(entity.dxf.location)
    return found


@pytest.mark.long
def test_a_drawing_in_the_axes_of_a_picture_lies_on_it_within_a_pixel(wall, tmp_path):
    out = tmp_path / "wall.dxf"
    words = ["convert", str(wall / "result"), "--to", "dxf", "--in", str(wall / "wall.toml"), "--out", str(out)]
    assert main(words) == 0
    points = drawn_points(out)
    left, top, pixel = (float(line.split("=")[1]) for line in (wall / "wall.toml").read_text().splitlines()[:3])
    picture = np.asarray(Image.open(wall / "wall.tif").convert("L"))
    checked = 0
    for place in points.values():
        assert abs(place[2]) < 1e-3
        x, y = (place[0] - left) / pixel, (top - place[1]) / pixel
        if min(x, y) > 10 and x < picture.shape[1] - 10 and y < picture.shape[0] - 10:
            assert dot_in(picture, x, y, 9) == pytest.approx((x, y), abs=0.5)
            checked += 1
    assert checked >= 8
    assert points["Müller 0"] == pytest.approx([0, 0, 0], abs=1e-3)
    assert points["P20"][1] == pytest.approx(0, abs=1e-3)
    assert ezdxf.readfile(out).header.custom_vars.get("coordinate system").startswith("plane: X right")


def test_a_geopackage_takes_these_axes_and_other_formats_say_that_they_do_not(wall, tmp_path):
    done = rb.convert(wall / "result", tmp_path / "wall.gpkg", to="gpkg", within=wall / "wall.toml")
    assert "conversion.plane_axes" in coded(done.remarks)
    with refused("format.not_in_plane", format="ply"):
        rb.convert(wall / "result", tmp_path / "wall.ply", to="ply", within=wall / "wall.toml")
    (tmp_path / "turned.toml").write_text((wall / "wall.toml").read_text().replace("right = [", "right = [0.5, ", 1))
    with pytest.raises(InputError, match=r"3.*value\.count"):
        rb.convert(wall / "result", tmp_path / "w.dxf", to="dxf", within=tmp_path / "turned.toml")


DPI = 600
"""Poppler draws a picture to whole pixels of its own, outwards: half as fine, that alone is 0.1 mm"""


def rendered(pdf, folder, dpi=DPI):
    """Its pages as grey pictures."""
    subprocess.run(["pdftoppm", "-r", str(dpi), "-gray", str(pdf), str(folder / "page")], check=True)
    return [np.asarray(Image.open(p)) for p in sorted(folder.glob("page-*.pgm"))]


def chart(folder, name="chart.png", *, pixel=0.002, beside="world"):
    """A picture of 2.0 x 1.2 m with dots at known places, and these (n, 2) [m]."""
    places = np.array([[0.1, 0.1], [1.9, 0.1], [0.1, 1.1], [1.9, 1.1], [1.0, 0.6]])
    rows, columns = np.mgrid[0 : round(1.2 / pixel), 0 : round(2.0 / pixel)]
    x, y = (columns + 0.5) * pixel, 1.2 - (rows + 0.5) * pixel
    away = np.min([np.hypot(x - a, y - b) for a, b in places], axis=0)
    Image.fromarray(np.where(away < 0.02, 0, 255).astype(np.uint8)).save(folder / name)
    if beside == "world":
        lines = [pixel, 0, 0, -pixel, pixel / 2, 1.2 - pixel / 2]
        (folder / name).with_suffix(".pgw").write_text("\n".join(map(str, lines)))
    return folder / name, places


def on_paper(done, page, places, dpi):
    """Where places should lie on a rendered first sheet, and where they do [mm]."""
    wanted = done.corner_mm + (places - done.corner) * done.millimetres
    found = []
    for x, y in wanted:
        column, row = x / 25.4 * dpi, page.shape[0] - y / 25.4 * dpi
        c, r = dot_in(page, column, row, round(1.4 * 0.02 * done.millimetres / 25.4 * dpi))
        found.append((c / dpi * 25.4, (page.shape[0] - r) / dpi * 25.4))
    return wanted, np.array(found)


@needs_poppler
@pytest.mark.parametrize(("scale", "paper"), [(10, "A3"), (20, "A4")])
def test_a_sheet_is_true_to_scale(tmp_path, scale, paper):
    picture, places = chart(tmp_path)
    done = rb.drawing_sheet(picture, tmp_path / "sheet.pdf", scale=scale, paper=paper, grid=0)
    assert done.scale == scale
    assert done.millimetres == pytest.approx(1000 / scale)
    (page,) = rendered(tmp_path / "sheet.pdf", tmp_path)
    wanted, found = on_paper(done, page, places, DPI)
    assert np.abs(found - wanted).max() < 0.1
    long, should = (np.linalg.norm(p[3] - p[0]) for p in (found, places * done.millimetres))
    assert long == pytest.approx(should, abs=0.1)
    height, width = (n / DPI * 25.4 for n in page.shape)
    assert sorted((width, height)) == pytest.approx({"A4": [210, 297], "A3": [297, 420]}[paper],
                                                    abs=0.1)  # fmt: skip


@needs_poppler
def test_sheets_that_are_joined_show_all_at_scale(tmp_path):
    picture, places = chart(tmp_path)
    done = rb.drawing_sheet(picture, tmp_path / "sheet.pdf", scale=5, paper="A4", several=True, grid=0)
    assert done.sheets == done.columns * done.rows > 1
    assert (done.low <= 0).all()
    assert (done.high >= [2.0, 1.2]).all()
    pages = rendered(tmp_path / "sheet.pdf", tmp_path)
    assert len(pages) == done.sheets
    here = places[2:3]  # above, on the left: the first sheet
    wanted, found = on_paper(done, pages[0], here, DPI)
    assert np.abs(found - wanted).max() < 0.1


def text_of(pdf):
    """The words of a sheet; a program that draws it is not needed for that."""
    return "\n".join(page.extract_text() for page in PdfReader(pdf).pages)


@needs_poppler
def test_words_of_all_letters_stand_in_the_title_block_with_their_fonts(tmp_path):
    picture, _ = chart(tmp_path)
    out = tmp_path / "sheet.pdf"
    done = rb.drawing_sheet(
        picture, out, title="Bürgerhaus Ägidienstraße", place="Θεσσαλονίκη", client="Ł. Żółć, Москва",
        operator="Ola <script>alert(1)</script> & Söhne", object="a\x00b\tc\nd \u202e e", rights="日本",
    )  # fmt: skip
    told = text_of(out)
    for words in ("Bürgerhaus Ägidienstraße", "Θεσσαλονίκη", "Ł. Żółć, Москва", "<script>alert(1)</script> & Söhne",
                  "1 : 10", "A3 landscape", "1 of 1", "??"):  # fmt: skip
        assert words in told, words
    fonts = subprocess.run(["pdffonts", str(out)], capture_output=True, text=True, check=True).stdout.splitlines()[2:]
    assert fonts
    assert all(line.split()[-5] == "yes" for line in fonts), fonts  # embedded
    assert not any("title" in r for r in done.remarks)


def test_letters_that_the_font_lacks_are_told(tmp_path):
    done = rb.drawing_sheet(
        [chart(tmp_path)[0]], tmp_path / "s.pdf", operator="\u05e9\u05dc\u05d5\u05dd", client="Weiß"
    )
    assert coded(done.remarks)["drawing_sheet.letters"] == {"letters": ["\u05e9", "\u05dc", "\u05d5", "\u05dd"]}
    assert "????" in text_of(tmp_path / "s.pdf")
    done = rb.drawing_sheet([chart(tmp_path, "b.png")[0]], tmp_path / "t.pdf", operator="Ω Ж ß")
    assert "drawing_sheet.letters" not in coded(done.remarks)


def test_words_that_are_too_long_are_cut_and_that_is_told(tmp_path):
    picture, _ = chart(tmp_path)
    long = "Donaudampfschifffahrtsgesellschaft" * 40
    done = rb.drawing_sheet(picture, tmp_path / "a.pdf", title=long, client=long, paper="A4")
    assert coded(done.remarks)["drawing_sheet.shortened"] == {"names": ["title", "client"]}
    once = rb.drawing_sheet(picture, tmp_path / "b.pdf", title="Ein sehr langer Titel " * 8, paper="A4")
    assert "drawing_sheet.shortened" not in coded(once.remarks)


def test_the_largest_usual_scale_that_fits_is_taken(tmp_path, capsys):
    picture, _ = chart(tmp_path)
    found = reported(capsys, "sheet", picture, "--paper", "A3", "--out", tmp_path / "s.pdf")
    drawn = values_of(found)["drawing_sheet.sheets"]
    assert (drawn["scale"], drawn["paper"], drawn["n"]) == (10, "A3 landscape", 1)
    assert "drawing_sheet.metres_assumed" in codes_of(found, ["notes"])
    assert rb.drawing_sheet(picture, tmp_path / "p.pdf", paper="A3", portrait=True).scale == 10
    assert rb.drawing_sheet(picture, tmp_path / "q.pdf", paper="A0").scale == 2
    assert rb.drawing_sheet(picture, tmp_path / "r.pdf", extent=(0, 0, 0.1, 0.05)).scale == 1


def test_the_same_drawing_gives_the_same_bytes_of_a_sensible_size(tmp_path, monkeypatch):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1750000000")
    picture, _ = chart(tmp_path, pixel=0.0005)  # 4000 x 2400 px, on 200 x 120 mm at 1 : 10
    for name in ("a.pdf", "b.pdf"):
        rb.drawing_sheet(picture, tmp_path / name, scale=10)
    assert (tmp_path / "a.pdf").read_bytes() == (tmp_path / "b.pdf").read_bytes()
    assert (tmp_path / "a.pdf").stat().st_size < 1_000_000
    assert b"(D:20250615150640+00'00')" in (tmp_path / "a.pdf").read_bytes()


def test_a_sheet_says_who_made_it_and_when(tmp_path, monkeypatch):
    monkeypatch.delenv("SOURCE_DATE_EPOCH", raising=False)
    picture, _ = chart(tmp_path, pixel=0.002)
    rb.drawing_sheet(picture, tmp_path / "a.pdf", scale=10, operator="A. Mason")
    file = (tmp_path / "a.pdf").read_bytes()
    assert b"/Author (A. Mason)" in file
    made = datetime.strptime(re.search(rb"/CreationDate \(D:(\d{14})", file)[1].decode() + "Z", "%Y%m%d%H%M%S%z")
    assert abs((datetime.now(UTC) - made).total_seconds()) < 86_400


def test_a_sheet_is_in_the_language_of_its_project(wall, tmp_path):
    project = tmp_path / "project"
    shutil.copytree(wall / "result", project / "result")
    asked = {"vertical": True, "date": "2026-05-01", "object": "Mill, the old one", "client": "Control & Sons"}

    def words(name, **more):
        rb.drawing_sheet(project / "result", tmp_path / name, **asked, **more)
        return " ".join(page.extract_text() for page in PdfReader(tmp_path / name).pages)

    english = words("en.pdf")
    assert "landscape" in english
    assert "2026-05-01" in english
    (project / "project.toml").write_text('[orient]\nlanguage = "de"\n', encoding="utf-8")
    german = words("de.pdf")
    for told in ("Querformat", "01.05.2026", "Auftraggeber", "Maßstab", "1 von 1", "Lotrechte Ebene", "X nach rechts"):
        assert told in german
    for kept in ("Mill, the old one", "Control & Sons"):
        assert kept in german
    for left in ("landscape", "client", "Plumb plane", "degrees", "Standard deviation", "X right"):
        assert left not in german
    assert "landscape" in words("again.pdf", language="en")
    with refused("report.unknown_language", language="xx"):
        rb.drawing_sheet(project / "result", tmp_path / "x.pdf", language="xx", **asked)


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        ({"scale": 1}, r"(?s)A3 at 1:1\..*scale=10.*several=True.*drawing\.does_not_fit"),
        ({"scale": 5}, r"(?s)scale=10.*paper=\"?A2\"?.*several=True.*drawing\.does_not_fit"),
        ({"grid": 0.001}, r"grid=.*drawing\.grid_too_dense"),
        ({"landscape": True, "portrait": True}, r"option\.exclusive"),
        ({"plane": ("A", "B", "C")}, r"drawing\.plane_of_picture"),
        ({"extent": (1, 1, 0, 0)}, r"drawing\.no_area"),
        ({"scale": 1, "several": True, "extent": (0, 0, 1e4, 1e4)}, "with 200 sheets"),
    ],
)
def test_what_cannot_be_drawn_is_told_with_what_would_help(tmp_path, settings, told):
    picture, _ = chart(tmp_path)
    with pytest.raises(InputError, match=told):
        rb.drawing_sheet(picture, tmp_path / "sheet.pdf", **settings)
    assert not (tmp_path / "sheet.pdf").exists()


def test_a_picture_without_a_plane_is_refused(tmp_path, wall):
    picture, _ = chart(tmp_path, beside="")
    with pytest.raises(InputError, match=r"chart\.toml.*chart\.pgw.*picture\.no_scale"):
        rb.drawing_sheet(picture, tmp_path / "sheet.pdf")
    picture.with_suffix(".pgw").write_text("0.002\n0.1\n0\n-0.002\n0\n0\n")
    with pytest.raises(InputError, match=r"world_file\.rotated"):
        rb.drawing_sheet(picture, tmp_path / "sheet.pdf")
    picture.with_suffix(".pgw").write_text("a\n")
    with pytest.raises(InputError, match=r"world_file\.six_numbers"):
        rb.drawing_sheet(picture, tmp_path / "sheet.pdf")
    picture.with_suffix(".pgw").write_text("0.002\n0\n0\n-0.002\n0.001\n1.199\n")
    with pytest.raises(InputError, match=r"\.toml.*picture\.world_file_only"):
        rb.drawing_sheet([picture, wall / "result"], tmp_path / "sheet.pdf")
    (tmp_path / "no.txt").write_text("")
    for source in (tmp_path / "no.txt", tmp_path / "none.tif"):
        with pytest.raises(InputError):
            rb.drawing_sheet(source, tmp_path / "sheet.pdf")
    for kept in (tmp_path / "sheet.svg", picture):
        with pytest.raises(InputError):
            rb.drawing_sheet(picture, kept)


def test_a_broken_picture_is_told(tmp_path):
    picture, _ = chart(tmp_path)
    picture.write_bytes(picture.read_bytes()[:200])
    with pytest.raises(InputError, match=r"sheet|picture\.|file\."):
        rb.drawing_sheet(picture, tmp_path / "sheet.pdf")


@needs_poppler
def test_picture_and_points_of_a_result_on_one_sheet(wall, tmp_path, capsys):
    out = tmp_path / "wall.pdf"
    words = [str(wall / "wall.tif"), str(wall / "result"), "--title", "Südwand", "--paper", "A4"]
    found = reported(capsys, "sheet", *words, "--out", out)
    assert values_of(found)["drawing_sheet.content"] == {"pictures": 1, "points": 22, "lines": 0}
    told = text_of(out)
    for part in (
        "Müller 0", "P20", "control point", "Pixel of the picture: 5", "Plumb plane by 2 points",
        "origin at Müller 0, right from Müller 0 towards P20", "Standard deviation of the 22 named points",
    ):  # fmt: skip
        assert part in told, part


@needs_poppler
def test_measured_lengths_stand_at_their_lines(tmp_path):
    exact = Survey(points="exact", image_sigma_px=0.05, scale_bars=1, scale_bar_sigma=5e-5)
    block = simulate(field_scene(TargetField(columns=6, rows=4, stations=4, depth=0.0)), exact).observed
    done = adjust(block)
    write_result(done, tmp_path / "r", report="none")
    d, xyz = block.distances, done.adjusted.points.xyz
    length = float(np.linalg.norm(xyz[d.start[0]] - xyz[d.end[0]]))
    rb.drawing_sheet(tmp_path / "r", tmp_path / "a.pdf", paper="A3")
    raw = ["pdftotext", "-raw", str(tmp_path / "a.pdf"), "-"]  # words along a line stand there letter by letter
    told = "".join(subprocess.run(raw, capture_output=True, text=True, check=True).stdout.split())
    found = re.search(r"([0-9]\.[0-9]+)m±([0-9.]+)mm", told)
    assert float(found[1]) == pytest.approx(length, abs=1e-5)
    (group,) = [g for g in done.groups if g.kind == "distance"]
    std = done.sigma0 * 0.05 * np.sqrt(1 - group.redundancy[0])
    assert float(found[2]) == pytest.approx(std, rel=0.05)
    assert headline("drawing_sheet.lengths", {}) in " ".join(text_of(tmp_path / "a.pdf").split())
    rb.drawing_sheet(tmp_path / "r", tmp_path / "b.pdf", paper="A3", lengths=False)
    assert "±" not in text_of(tmp_path / "b.pdf")


def rewritten(table, change):
    """The table with what a function says of each of its rows."""
    with table.open(newline="") as file:
        rows = list(csv.DictReader(file))
    with table.open("w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows({**row, **change(row)} for row in rows)


def moved(result, folder, scale, **told):
    """A result folder in which everything stands elsewhere, and what its result.json says besides."""
    again = folder / "again"
    shutil.copytree(result, again)
    for table in ("points.csv", "images.csv", "block/points.csv", "block/images.csv"):
        rewritten(again / table, lambda row: {a: repr(scale * float(row[a])) for a in "XYZ" if row[a]})
    known = json.loads((again / "result.json").read_text())
    (again / "result.json").write_text(json.dumps({**known, **told}))
    return again


def test_points_of_another_adjustment_are_not_drawn_on_a_picture(wall, tmp_path, capsys):
    again = moved(wall / "result", tmp_path, 2.0)
    with pytest.raises(InputError, match=r"picture\.earlier_adjustment"):
        rb.drawing_sheet([wall / "wall.tif", again], tmp_path / "s.pdf")
    out = str(tmp_path / "s.dxf")
    assert main(["convert", str(again), "--to", "dxf", "--in", str(wall / "wall.toml"), "--out", out]) == 2
    assert "[picture.earlier_adjustment]" in capsys.readouterr().err
    same = moved(wall / "result", tmp_path / "near", 1.0 + 1e-5)  # far below a pixel
    assert rb.drawing_sheet([wall / "wall.tif", same], tmp_path / "s.pdf").points == 22


def test_a_result_that_is_not_to_be_used_yet_says_so_in_all_that_is_made_of_it(wall, tmp_path, capsys):
    notice = {"code": "control_contradicts", "severity": "fault", "message": "P1 lies 3 m away", "ids": ["P1"]}
    bad = moved(wall / "result", tmp_path, 1.0, warnings=[notice], accuracy_class={"kept": False})
    faults, lost = headline("state.faults", {"n": 1}), headline("state.accuracy_not_kept", {})
    told = f"{faults} P1 lies 3 m away {lost}"
    picture, photos = tmp_path / "wall.tif", str(wall / "photos")
    codes = ["state.faults", "state.fault_text", "state.accuracy_not_kept"]
    found = reported(capsys, "rectify", bad, "--photos", photos, "--pixel", 0.02, "--out", picture)
    assert codes_of(found, ["faults"]) == codes
    assert values_of(found)["state.fault_text"] == {"text": "P1 lies 3 m away"}
    with Image.open(picture) as opened:
        assert told in opened.tag_v2[270]
    assert tomllib.loads(picture.with_suffix(".toml").read_text())["state"] == told
    assert codes_of(reported(capsys, "convert", bad, "--to", "gpkg,dxf", "--out", tmp_path / "d"), ["faults"]) == codes
    drawing = ezdxf.readfile(tmp_path / "d.dxf")
    assert told in str([v for _, v in drawing.header.custom_vars])
    about = pyogrio.read_info(tmp_path / "d.gpkg", layer="points")
    assert told in str(about)
    for k, sources in enumerate(([bad], [picture, bad], [picture])):
        found = reported(capsys, "sheet", *sources, "--out", tmp_path / f"{k}.pdf")
        assert values_of(found, ["faults"])["state.fault_text"]["text"].startswith(f"{faults} P1 lies 3 m away")
        assert faults in text_of(tmp_path / f"{k}.pdf")


def test_points_off_the_plane_are_said_to_lie_beside_their_image(wall, tmp_path):
    told = tomllib.loads((wall / "wall.toml").read_text())
    assert told["displacement_rms"] == pytest.approx(told["slope_rms"] * told["points_rms"])
    off = moved(wall / "result", tmp_path, 1.0)
    rewritten(off / "points.csv", lambda row: {"Y": repr(float(row["Y"]) + 0.5)} if row["point"] == "P20" else {})
    rb.drawing_sheet([wall / "wall.tif", off], tmp_path / "s.pdf")
    words = " ".join(text_of(tmp_path / "s.pdf").split())
    assert headline("drawing_sheet.beside", {}) in words
    size = re.search(r"P20: ([0-9]+) mm\.", words)
    assert float(size[1]) == pytest.approx(500 * told["slope_rms"], rel=0.01)


def test_points_alone_on_a_plane_of_their_own(wall, tmp_path):
    done = rb.drawing_sheet(wall / "result", tmp_path / "points.pdf", vertical=True)
    assert (done.pictures, done.points, done.sheets) == (0, 22, 1)
    none = rb.drawing_sheet(wall / "result", tmp_path / "none.pdf", draw_points="none")
    assert none.points == 0


def test_pictures_of_two_planes_make_no_sheet(wall, tmp_path):
    picture, _ = chart(tmp_path)
    with pytest.raises(InputError, match=r"wall\.toml.*drawing\.planes_differ"):
        rb.drawing_sheet([wall / "wall.tif", picture], tmp_path / "two.pdf")


@needs_poppler
def test_level_ground_of_a_map_has_its_system_and_a_north_arrow(tmp_path):
    frame = local_frame("EPSG:25832+7837", (700_000.0, 5_400_000.0, 400.0), undulation_m=46.5)
    survey = Survey(control=6, control_sigma=(0.02, 0.02, 0.03))
    block = simulate(aerial_scene(AerialStrips(images_per_strip=4, points_per_image=30)), survey).observed
    more = {"frame": frame.as_mapping()}
    write_result(adjust(block), tmp_path / "flight", report="none", additions=more, frame=frame)
    done = rb.drawing_sheet(tmp_path / "flight", tmp_path / "map.pdf", horizontal=True)
    assert (done.low < [700_500, 5_400_500]).all()
    assert (done.high > [700_500, 5_400_500]).all()
    told = text_of(tmp_path / "map.pdf")
    for words in ("EPSG:25832+7837", "ETRS89 / UTM zone 32N", "DHHN2016", "level ground at height", "E 699", "N 539"):
        assert words in told, words
