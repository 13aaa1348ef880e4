"""`raybundle targets`: sheet, choose, detect."""

import csv
import re

import cv2
import numpy as np
import pytest
from PIL import Image

from raybundle.cli.main import main
from raybundle.commands.calibrate import wanted_targets
from raybundle.errors import InputError
from raybundle.targets.codes import read_table
from raybundle.targets.families import families
from raybundle.targets.marks import MarkOptions, detect, target
from raybundle.targets.sidecar import read_sidecar
from tests.cli.reported import reported, values_of
from tests.targets.render import shot
from tests.targets.test_sheets import PX, raster


def photographs(folder):
    folder.mkdir()
    f = families["aicon12"]
    rng = np.random.default_rng(7)
    centres = {}
    for k, name in ((4, "a.png"), (30, "b.png")):
        s = shot(rng, 9.0, 0.3, bits=12, code=int(f.codes[k]), size=120)
        Image.fromarray(s.image).save(folder / name)
        centres[name] = (k + 1, s.centre)
    return centres


def test_detect_writes_tables_and_pictures(tmp_path, capsys):
    centres = photographs(tmp_path / "photos")
    out, block, pictures = tmp_path / "targets.csv", tmp_path / "observations.csv", tmp_path / "found"
    files = ["--out", out, "--observations", block, "--overlay", pictures]
    found = reported(capsys, "targets", "detect", tmp_path / "photos", "--target", "aicon12", "--dots", *files)
    points = values_of(found)["target_seen.points"]
    assert points == {"photographs": 2, "n": 2, "target": families["aicon12"].title}
    with out.open() as file:
        table = csv.DictReader(file)
        rows = [r for r in table if r["code"]]
    columns = "image,family,code,x_px,y_px,sx_px,sy_px,sxy_px2,radius_px,gate"
    assert table.fieldnames == columns.split(",")
    assert [(r["image"], int(r["code"]), r["family"]) for r in rows] == [
        (n, c[0], "aicon12") for n, c in centres.items()
    ]
    for r in rows:
        assert np.hypot(*(np.array([float(r["x_px"]), float(r["y_px"])]) - centres[r["image"]][1])) < 0.05
        assert 0 < float(r["sx_px"]) < 0.05
        assert 0 < float(r["gate"]) < 0.08
        assert 8 < float(r["radius_px"]) < 9.2
    assert block.read_text().startswith(f"image,point,x_px,y_px,sx_px,sy_px,sxy_px2\na.png,{rows[0]['code']},")
    assert sorted(p.name for p in pictures.iterdir()) == ["a.png", "b.png"]
    assert np.array(Image.open(pictures / "a.png")).shape == (120, 120, 3)


def test_nothing_found_is_status_two(tmp_path, capsys):
    (tmp_path / "photos").mkdir()
    noise = np.random.default_rng(1).normal(120, 3, (90, 120)).astype(np.uint8)
    Image.fromarray(noise).save(tmp_path / "photos" / "blank.png")
    for family in ("agisoft20", "chessboard-7x5", "circles-5x4", "photomodeler-sheet", "apriltag-36h11"):
        found = values_of(reported(capsys, "targets", "detect", tmp_path / "photos", "--target", family, status=2))
        assert found["target_seen.photograph"] == {"name": "blank.png", "n": 0, "points": ""}


def test_the_family_must_be_named(tmp_path, capsys):
    photographs(tmp_path / "photos")
    assert main(["targets", "detect", str(tmp_path / "photos")]) == 2
    assert "[target.family_missing]" in capsys.readouterr().err


def test_sheet_and_choose(tmp_path, capsys):
    out = tmp_path / "sheet.pdf"
    assert (
        main(["targets", "sheet", "--target", "aicon14", "--count", "20", "--dot-radius", "4mm", "--out", str(out)])
        == 0
    )
    assert "20 targets" in capsys.readouterr().out
    ids = [t.name for t in read_sidecar(out.with_suffix(".toml")).targets]
    assert main(["targets", "choose", "--target", "aicon14", "--count", "20"]) == 0
    assert ", ".join(ids) in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--target", "aicon14"], "[option.one_of]"),
        (["--target", "aicon14", "--codes", "3-1"], "[target.code_twice]"),
        (["--target", "aicon14", "--codes", "x"], "'x' is neither a number nor a range. [target.code_form]"),
        (["--target", "aicon14", "--codes", "600"], "no id 600"),
        (["--target", "aicon14", "--count", "2", "--dot-radius", "5miles"], "not a length"),
        (["--target", "chessboard-9x6"], "[sheet.spacing_missing]"),
        (["--target", "chessboard-9x6", "--spacing", "18", "--count", "3"], "[sheet.board_without_numbers]"),
        (["--target", "apriltag-36h11", "--spacing", "30mm"], "[option.one_of]"),
        (["--table", "absent.csv", "--count", "2"], "[target.table_settings]"),
    ],
)
def test_bad_usage(tmp_path, capsys, arguments, message):
    assert main(["targets", "sheet", *arguments, "--out", str(tmp_path / "s.svg")]) == 2
    assert message in capsys.readouterr().err


def test_sheets_of_boards_and_tags(tmp_path, capsys):
    for arguments, text in (
        (
            ["chessboard-9x6", "--spacing", "24mm", "--lying"],
            "54 points of chessboard",
        ),
        (["apriltag-36h11", "--spacing", "40mm", "--codes", "0-3"], "16 points of"),
        (["aruco-4x4_50", "--spacing", "4cm", "--count", "2"], "8 points of"),
    ):
        out = tmp_path / f"{arguments[0]}.pdf"
        assert main(["targets", "sheet", "--target", *arguments, "--out", str(out)]) == 0
        printed = capsys.readouterr().out
        assert printed.startswith(text)
        assert printed.splitlines()[0].endswith(" on 1 page A4.")


def test_table_of_ones_own(tmp_path, capsys):
    table = tmp_path / "rings.txt"
    table.write_text("1 15\n2 51\n")
    arguments = ["--table", str(table), "--bits", "8", "--codes", "1,2", "--out", str(tmp_path / "s.svg")]
    assert main(["targets", "sheet", *arguments]) == 0
    assert "8 bits" in capsys.readouterr().out


def test_the_file_of_another_sheet_stays(tmp_path, capsys):
    arguments = ["targets", "sheet", "--target", "aicon12"]
    assert main([*arguments, "--codes", "1-9", "--out", str(tmp_path / "w.pdf")]) == 0
    before = (tmp_path / "w.toml").read_bytes()
    assert main([*arguments, "--codes", "2-9", "--out", str(tmp_path / "w.svg")]) == 2
    told = capsys.readouterr().err
    assert "w.toml: " in told
    assert "[file.exists]" in told
    assert (tmp_path / "w.toml").read_bytes() == before
    assert not (tmp_path / "w.svg").exists()
    assert main([*arguments, "--codes", "1-9", "--out", str(tmp_path / "w.svg")]) == 0  # the same sheet


def test_a_table_of_ones_own_goes_with_its_sheet(tmp_path, capsys):
    """The file beside a sheet of rings by a table is enough to read its targets; tables may have a header."""
    table = tmp_path / "Rings.csv"
    table.write_text("code,id\n51,7\n85,3\n119,4\n")
    out = tmp_path / "own.svg"
    assert main(["targets", "sheet", "--table", str(table), "--bits", "8", "--codes", "3,7", "--out", str(out)]) == 0
    capsys.readouterr()
    beside = read_sidecar(tmp_path / "own.toml")
    marks = detect(cv2.GaussianBlur(raster(out), (0, 0), 0.8), beside.target)
    assert sorted(marks.name) == ["3", "7"]
    assert beside.scaled(1.001).target.title == beside.target.title
    plain = read_table(table, 8)
    assert dict(zip(plain.ids.tolist(), plain.codes.tolist(), strict=True)) == {7: 51, 3: 85, 4: 119}


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (("bits = 8", "bits = 30"), "value.not_whole"),
        (("ring_radii_mm = [10.0, 15.0]", "ring_radii_mm = [15.0]"), "value.count"),
        (("ring_radii_mm = [10.0, 15.0]", "ring_radii_mm = [15.0, 10.0]"), "[sheet.ring_radii]"),
        (("ring_radii_mm = [10.0, 15.0]", 'ring_radii_mm = "wide"'), "value.no_list"),
        (("code = 51", "code = 256"), "value.not_whole"),
        (("code = 51", "code = 30"), "[sheet.same_ring]"),
    ],
)
def test_damaged_codes_beside_a_sheet(tmp_path, change, message):
    table = tmp_path / "rings.txt"
    table.write_text("1 15\n2 51\n")
    arguments = ["--table", str(table), "--bits", "8", "--codes", "1,2", "--out", str(tmp_path / "s.svg")]
    assert main(["targets", "sheet", *arguments]) == 0
    file = tmp_path / "s.toml"
    file.write_text(file.read_text().replace(*change))
    with pytest.raises(InputError, match=re.escape(message)):
        read_sidecar(file)


def test_dots_are_printed(tmp_path, capsys):
    for polarity, number in (("dark", 117), ("light", 108)):
        out = tmp_path / f"{polarity}.svg"
        arguments = ["--target", "dots", "--spacing", "20mm", "--polarity", polarity, "--out", str(out)]
        sheet = values_of(reported(capsys, "targets", "sheet", *arguments))["target_sheet.printed"]
        assert (sheet["n"], sheet["points"]) == (number, True)
        found = detect(cv2.GaussianBlur(raster(out), (0, 0), 0.8), "dots", MarkOptions(polarity=polarity))
        place = np.array([(t.x_mm, 297 - t.y_mm) for t in read_sidecar(out.with_suffix(".toml")).targets]) * PX
        away = np.linalg.norm(found.xy_px[:, None] - place, axis=2)
        assert len(found) == len(place) == number
        assert away.min(axis=0).max() < 0.1
    for more, message in (
        (["--spacing", "20mm", "--count", "200"], "[sheet.too_many_dots]"),
        (["--spacing", "10mm"], "[sheet.dots_too_large]"),
        (["--spacing", "20mm", "--codes", "1-3"], "[sheet.dots_without_numbers]"),
    ):
        assert main(["targets", "sheet", "--target", "dots", *more, "--out", str(tmp_path / "x.svg")]) == 2
        assert message in capsys.readouterr().err


def test_a_sheet_for_calibration_is_printed(tmp_path, capsys):
    out = tmp_path / "c.svg"
    arguments = ["--target", "photomodeler-sheet", "--spacing", "18mm", "--out", str(out)]
    assert main(["targets", "sheet", *arguments]) == 2
    printed = capsys.readouterr().err
    assert " 3.0 mm" in printed
    assert "--dot-radius" in printed
    assert main(["targets", "sheet", *arguments, "--dot-radius", "3mm"]) == 0
    marks = detect(cv2.GaussianBlur(raster(out), (0, 0), 0.8), "photomodeler-sheet")
    place = {t.name: (t.x_mm, 297 - t.y_mm) for t in read_sidecar(out.with_suffix(".toml")).targets}
    assert set(marks.name) == set(place)
    assert {"1001", "1002", "1003", "1004"} < set(place)
    assert abs(marks.xy_px / PX - np.array([place[n] for n in marks.name])).max() < 0.05


def test_what_calibrate_refuses_before_it_looks(tmp_path, capsys):
    table = tmp_path / "rings.csv"
    table.write_text("id,code\n1,15\n2,51\n")
    begin = ["calibrate", str(tmp_path), "--out", str(tmp_path / "out")]
    for more, message in (
        (["--model", "panorama"], "[camera.not_by_targets]"),
        (
            ["--model", "brown_mounted"],
            "aicon, brown, brown_harmonic, division, eucm, field_of_view, fisheye, kannala_brandt, radial",
        ),
        (["--model", "antenna"], "[camera.calibration_model_unknown]"),
        (["--table", str(table)], "[target.table_settings]"),
        (["--table", str(table), "--bits", "8", "--target", "aicon12"], "[target.table_settings]"),
    ):
        assert main([*begin, *more]) == 2
        assert message in capsys.readouterr().err
    (wanted,) = wanted_targets((), table, 8, None)
    assert not isinstance(wanted, str)
    assert wanted.title.endswith("rings.csv")
    assert "8 bits" in wanted.title
    assert target(wanted) is wanted
