"""`raybundle targets`: sheet, choose, detect."""

import csv

import numpy as np
import pytest
from PIL import Image

from raybundle.cli.main import main
from raybundle.targets.families import families
from raybundle.targets.sidecar import read_sidecar
from tests.targets.render import shot


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
    files = ["--out", str(out), "--observations", str(block), "--overlay", str(pictures)]
    assert main(["targets", "detect", str(tmp_path / "photos"), "--family", "aicon12", "--dots", *files]) == 0
    assert "2 photographs, 2 points of AICON (Schneider), 12 bits" in capsys.readouterr().out
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
        assert main(["targets", "detect", str(tmp_path / "photos"), "--family", family]) == 2
        assert "blank.png: 0 points" in capsys.readouterr().out


def test_the_family_must_be_named(tmp_path, capsys):
    photographs(tmp_path / "photos")
    assert main(["targets", "detect", str(tmp_path / "photos")]) == 2
    assert "must be named" in capsys.readouterr().err


def test_sheet_and_choose(tmp_path, capsys):
    out = tmp_path / "sheet.pdf"
    assert (
        main(["targets", "sheet", "--family", "aicon14", "--count", "20", "--dot-radius", "4mm", "--out", str(out)])
        == 0
    )
    assert "20 targets" in capsys.readouterr().out
    ids = [t.name for t in read_sidecar(out.with_suffix(".toml")).targets]
    assert main(["targets", "choose", "--family", "aicon14", "--count", "20"]) == 0
    assert ", ".join(ids) in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--family", "aicon14"], "either --codes or --count"),
        (["--family", "aicon14", "--codes", "3-1"], "twice, or a range runs downwards"),
        (["--family", "aicon14", "--codes", "x"], "neither a number nor a range"),
        (["--family", "aicon14", "--codes", "600"], "no id 600"),
        (["--family", "aicon14", "--count", "2", "--dot-radius", "5miles"], "not a length"),
        (["--family", "chessboard-9x6"], "give --spacing"),
        (["--family", "chessboard-9x6", "--spacing", "18", "--count", "3"], "no numbers to choose from"),
        (["--family", "apriltag-36h11", "--spacing", "30mm"], "either --codes or --count"),
        (["--table", "absent.csv", "--count", "2"], "--table goes with --bits"),
    ],
)
def test_bad_usage(tmp_path, capsys, arguments, message):
    assert main(["targets", "sheet", *arguments, "--out", str(tmp_path / "s.svg")]) == 2
    assert message in capsys.readouterr().err


def test_sheets_of_boards_and_tags(tmp_path, capsys):
    for arguments, text in (
        (
            ["chessboard-9x6", "--spacing", "24mm", "--lying"],
            "54 points of chessboard of 9 x 6 inner corners on 1 page A4",
        ),
        (["apriltag-36h11", "--spacing", "40mm", "--codes", "0-3"], "16 points of square tags apriltag-36h11"),
        (["aruco-4x4_50", "--spacing", "4cm", "--count", "2"], "8 points of square tags aruco-4x4_50"),
    ):
        assert main(["targets", "sheet", "--family", *arguments, "--out", str(tmp_path / "s.pdf")]) == 0
        assert text in capsys.readouterr().out


def test_table_of_ones_own(tmp_path, capsys):
    table = tmp_path / "rings.txt"
    table.write_text("1 15\n2 51\n")
    arguments = ["--table", str(table), "--bits", "8", "--codes", "1,2", "--out", str(tmp_path / "s.svg")]
    assert main(["targets", "sheet", *arguments]) == 0
    assert "rings of 8 bits" in capsys.readouterr().out
