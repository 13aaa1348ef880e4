"""Sheets at true size: what a file shows is what its TOML says, and it can be read."""

import re
from xml.etree import ElementTree as ET

import cv2
import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.targets.detect import DetectionOptions, detect_targets
from raybundle.targets.families import families
from raybundle.targets.layout import SheetOptions, design, paper_size, tiles
from raybundle.targets.layout_boards import design_board, design_tags
from raybundle.targets.marks import detect, target
from raybundle.targets.sheets import write_sheet
from raybundle.targets.sidecar import read_sidecar

SVG = "{http://www.w3.org/2000/svg}"
PX = 4.0
"""Pixels of a raster per millimetre."""


def raster(path):
    """The shapes of an SVG file, drawn in their order; text is left out."""
    root = ET.parse(path).getroot()  # noqa: S314  (our own file)
    _, _, w, h = map(float, root.get("viewBox").split())
    assert root.get("width") == f"{w:g}mm"
    fine = 4
    image = np.full((int(h * PX * fine), int(w * PX * fine)), 255, np.uint8)
    for e in root:
        grey = 0 if e.get("fill") == "#000" else 255
        if e.tag == SVG + "polygon":
            xy = np.array([[float(v) for v in p.split(",")] for p in e.get("points").split()])
        elif e.tag == SVG + "circle":
            t = np.linspace(0, 2 * np.pi, 180)
            xy = np.array([float(e.get("cx")), float(e.get("cy"))])
            xy = xy + float(e.get("r")) * np.stack([np.cos(t), np.sin(t)], axis=1)
        else:
            continue
        cv2.fillPoly(image, [np.round((xy * PX * fine - 0.5) * 16).astype(np.int32)], grey, cv2.LINE_AA, 4)
    return cv2.resize(image, None, fx=1 / fine, fy=1 / fine, interpolation=cv2.INTER_AREA)


@pytest.mark.parametrize(("name", "polarity"), [("aicon12", "dark"), ("aicon20", "light"), ("agisoft14", "dark")])
def test_printed_targets_can_be_read(tmp_path, name, polarity):
    f = families[name]
    ids = f.ids[[3, 40, 77, 100, 140]]
    sheet = design(f, ids, SheetOptions(dot_radius_mm=4, polarity=polarity))
    written = write_sheet(sheet, tmp_path / "sheet.svg")
    assert [p.name for p in written] == ["sheet.svg", "sheet.toml"]
    beside = read_sidecar(tmp_path / "sheet.toml")
    assert (beside.family, beside.dot_radius_mm, beside.polarity, beside.bar_mm) == (name, 4, polarity, 100)
    found = detect_targets(raster(tmp_path / "sheet.svg"), f, DetectionOptions(uncoded="none"))
    assert found.id.tolist() == sorted(ids.tolist())
    assert set(found.polarity.tolist()) == {-1 if polarity == "dark" else 1}
    (page,) = sheet.pages
    assert {t.page for t in beside.targets} == {1}
    place = {int(t.name): (t.x_mm, page.height - t.y_mm) for t in beside.targets}
    assert abs(found.xy_px / PX - np.array([place[i] for i in found.id])).max() < 0.02
    radius = np.sqrt(np.sqrt(np.linalg.det(found.ellipse))) / PX
    assert abs(radius - 4).max() < 0.06  # the raster's polygons are half a fine pixel too large


@pytest.mark.long
@pytest.mark.parametrize("polarity", ["dark", "light"])
@pytest.mark.parametrize("name", ["aicon12", "aicon14", "agisoft12", "agisoft14"])
def test_every_ring_survives_print_and_turn(tmp_path, name, polarity):
    f = families[name]
    sheet = design(f, f.ids, SheetOptions(dot_radius_mm=1.6, paper="A3", polarity=polarity))
    (path, *_) = write_sheet(sheet, tmp_path / "all.svg")
    read = set()
    pages = [path, *sorted(tmp_path.glob("all-*.svg"))]
    for k, page in enumerate(pages):
        image = raster(page)
        middle = np.array(image.shape[::-1]) / 2
        side = int(np.hypot(*image.shape)) + 10
        for turn in (12.0 + k, 287.3):
            M = cv2.getRotationMatrix2D(tuple(middle - 0.5), turn, 1.0)
            M[:, 2] += side / 2 - middle
            seen = cv2.warpAffine(cv2.GaussianBlur(image, (0, 0), 0.5), M, (side, side), borderValue=255)
            found = detect_targets(seen, f, DetectionOptions(uncoded="none"))
            expected = {int(t.name) for t in sheet.pages[k].targets}
            assert set(found.id.tolist()) == expected
            assert len(found) == len(expected)
            read |= expected
    assert read == set(f.ids.tolist())


def test_pdf_has_its_size_and_its_words(tmp_path):
    sheet = design(families["aicon14"], np.arange(1, 41), SheetOptions())
    write_sheet(sheet, tmp_path / "sheet.pdf")
    data = (tmp_path / "sheet.pdf").read_bytes()
    boxes = re.findall(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+)", data)
    assert len(boxes) == len(sheet.pages) == 2
    assert np.allclose([float(v) * 25.4 / 72 for v in boxes[0]], [210, 297], atol=0.01)
    write_sheet(sheet, tmp_path / "again.pdf")
    assert (tmp_path / "again.pdf").read_bytes() == data
    words = [s.text for p in sheet.pages for s in p.shapes if hasattr(s, "text")]
    assert {f"aicon14  {i}" for i in range(1, 41)} <= set(words)


def test_tiles_show_everything_once_or_twice(tmp_path):
    f = families["aicon12"]
    sheet = design(f, f.ids[:9], SheetOptions(dot_radius_mm=20, paper="A2", tile="A4"))
    (page,) = [p for p in sheet.pages if p.targets][:1]
    parts = tiles(page, "A4")
    assert len(parts) * len(sheet.pages) == len(sheet.printed)
    assert all((p.width, p.height) == paper_size("A4") for p in parts)
    # the middle of each target is on at least one part, within its margins
    discs = [s for p in parts for s in p.shapes if hasattr(s, "radius") and 10 <= s.x <= 200 and 10 <= s.y <= 287]
    assert len(page.targets) <= len(discs) <= 4 * len(page.targets)
    assert tiles(page, "A2") == [page]


def test_what_does_not_fit(tmp_path):
    f = families["aicon14"]
    with pytest.raises(InputError, match=r"24.*sheet\.target_too_large"):
        design(f, np.array([1]), SheetOptions(dot_radius_mm=40))
    with pytest.raises(InputError, match=r"sheet\.dot_radius_not_positive"):
        design(f, np.array([1]), SheetOptions(dot_radius_mm=0))
    sheet = design(f, np.array([1]), SheetOptions())
    with pytest.raises(InputError, match=r"sheet\.file_type"):
        write_sheet(sheet, tmp_path / "sheet.png")
    with pytest.raises(InputError, match=r"file\.not_writable"):
        write_sheet(sheet, tmp_path / "absent" / "sheet.svg")


def test_beside_a_sheet(tmp_path):
    sheet = design(families["aicon14"], np.arange(1, 41), SheetOptions())
    write_sheet(sheet, tmp_path / "sheet.pdf")
    read = read_sidecar(tmp_path / "sheet.toml")
    assert [t.name for t in read.targets] == [str(i) for i in range(1, 41)]
    assert {t.page for t in read.targets} == {1, 2}
    assert np.isnan(read.spacing_mm)
    larger = read.scaled(1.002)
    assert (larger.dot_radius_mm, larger.bar_mm) == pytest.approx((5.01, 1.002 * read.bar_mm))
    assert larger.targets[3].x_mm == pytest.approx(1.002 * read.targets[3].x_mm)
    with pytest.raises(InputError, match=r"1\.100.*sheet\.print_factor"):
        read.scaled(1.1)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("family = ", r"toml\.invalid"),
        ('family = "aicon12"', r"sheet\.no_sidecar"),
        ('family = "aicon12"\npages = [1]', r"pages\.0.*value\.no_table"),
        ('family = "aicon12"\npages = [{targets = [{x_mm = 1}]}]', r"pages\.0\.targets\.0.*value\.key_missing"),
        ('family = "a"\npages = [{targets = [{name = "1", x_mm = "2"}]}]', r"2.*value\.not_finite"),
        (
            'family = "a"\npages = [{targets = [{name = "1", x_mm = 2, y_mm = 3}, {name = "1", x_mm = 1, y_mm = 3}]}]',
            r"1.*sheet\.target_twice",
        ),
    ],
)
def test_damaged_files_beside_sheets(tmp_path, text, message):
    (tmp_path / "s.toml").write_text(text)
    with pytest.raises(InputError, match=message):
        read_sidecar(tmp_path / "s.toml")
    with pytest.raises(InputError, match=r"file\.missing"):
        read_sidecar(tmp_path / "absent.toml")


@pytest.mark.parametrize(
    ("family", "lying"),
    [("chessboard-9x6", True), ("charuco-8x6-5x5_100", True), ("circles-7x9", False), ("acircles-4x9", False)],
)
def test_printed_boards_can_be_measured(tmp_path, family, lying):
    t = target(family)
    spacing = 24.0 if family.startswith(("chess", "charuco")) else 20.0
    options = SheetOptions(dot_radius_mm=5, orientation="lying" if lying else "upright")
    sheet = design_board(t, spacing, options)
    write_sheet(sheet, tmp_path / "board.svg")
    beside = read_sidecar(tmp_path / "board.toml")
    assert (beside.family, beside.spacing_mm) == (family, spacing)
    assert np.isnan(beside.dot_radius_mm) == ("circles" not in family)
    place = {p.name: (p.x_mm, sheet.pages[0].height - p.y_mm) for p in beside.targets}
    marks = detect(cv2.GaussianBlur(raster(tmp_path / "board.svg"), (0, 0), 0.8), t)
    assert set(marks.name) == set(t.objects)
    e = marks.xy_px / PX - np.array([place[n] for n in marks.name])
    if t.turns > 1 and abs(e).max() > 5:
        e = marks.xy_px / PX - np.array([place[n] for n in marks.name])[::-1]
    assert abs(e).max() < 0.05


def test_printed_tags_can_be_measured(tmp_path):
    t = target("apriltag-36h11")
    sheet = design_tags(t, [0, 5, 17], 40.0, SheetOptions())
    write_sheet(sheet, tmp_path / "tags.svg")
    place = {p.name: (p.x_mm, 297 - p.y_mm) for p in read_sidecar(tmp_path / "tags.toml").targets}
    sharp = raster(tmp_path / "tags.svg")
    assert set(detect(sharp, t).name) == set(place)
    marks = detect(cv2.GaussianBlur(sharp, (0, 0), 0.8), t)
    assert set(marks.name) == set(place)
    # fillPoly fills the pixels on an edge, too: one of 16 in a millimetre
    assert abs(marks.xy_px / PX - np.array([place[n] for n in marks.name])).max() < 0.08


def test_boards_that_cannot_be_printed():
    o = SheetOptions()
    for family, spacing, message in (
        ("chessboard-9x6", 30.0, r"19\.0.*sheet\.board_too_large"),
        ("chessboard-9x6", 0.0, r"0.*sheet\.spacing_not_positive"),
        ("circles-5x4", 10.0, r"5.*10.*3\.8.*sheet\.dots_too_large"),
        ("photomodeler-sheet", 10.0, r"1\.6.*dot_radius.*sheet\.dots_too_large"),
    ):
        with pytest.raises(InputError, match=message):
            design_board(target(family), spacing, o)
    light = SheetOptions(polarity="light")
    with pytest.raises(InputError, match=r"sheet\.boards_are_dark"):
        design_board(target("circles-5x4"), 20.0, light)
    for ids, side, message in (
        ([600], 30.0, r"600.*sheet\.no_such_tag"),
        ([1], 400.0, r"sheet\.tag_too_large"),
        ([1], 0.0, r"0.*sheet\.side_not_positive"),
    ):
        with pytest.raises(InputError, match=message):
            design_tags(target("apriltag-36h11"), ids, side, o)


@pytest.mark.parametrize("count", [1, 2, 3, 5, 8])
def test_few_targets_are_spread_over_the_page(count):
    """Four or more reach over the page, and none comes closer to another than on a full page."""
    sheet = design(families["aicon12"], np.arange(1, count + 1), SheetOptions(dot_radius_mm=5.0))
    [page] = sheet.pages
    xy = np.array([[t.x_mm, t.y_mm] for t in page.targets])
    reach = 5.0 * families["aicon12"].ring[1]
    assert (xy - reach > 0).all()
    assert (xy + reach < [page.width, page.height]).all()
    apart = np.linalg.norm(xy[:, None] - xy, axis=2) + 1e9 * np.eye(count)
    assert apart.min() > 2 * families["aicon12"].ground * 5.0 - 1e-6
    if count >= 4:
        assert (np.ptp(xy, axis=0) > 0.3 * np.array([page.width, page.height])).all()
    assert abs(xy.mean(axis=0)[0] - page.width / 2) < 0.2 * page.width


def test_a_full_page_is_as_close_as_it_can_be():
    page = design(families["aicon12"], np.arange(1, 61), SheetOptions(dot_radius_mm=5.0)).pages[0]
    xy = np.array([[t.x_mm, t.y_mm] for t in page.targets])
    steps = np.diff(np.unique(xy[:, 0].round(6)))
    assert steps == pytest.approx(2 * families["aicon12"].ground * 5.0)


def test_few_tags_are_spread_too():
    sheet = design_tags(target("apriltag-36h11"), range(4), 40.0, SheetOptions())
    [page] = sheet.pages
    first = np.array([[t.x_mm, t.y_mm] for t in page.targets[::4]])
    assert np.ptp(first[:, 0]) > 0.4 * page.width
    assert np.ptp(first[:, 1]) > 0.4 * page.height
