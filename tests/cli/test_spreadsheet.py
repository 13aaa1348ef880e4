"""Tables of results as a workbook: numbers as numbers, texts as texts, what does not fit told."""

import json

import openpyxl
import pytest

import raybundle as rb
from raybundle import spreadsheet
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io import workbook
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.write import write_result


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    folder = tmp_path_factory.mktemp("r") / "part 7"
    block = simulate(field_scene(TargetField(stations=4)), Survey(image_sigma_px=0.1)).observed
    write_result(rb.adjust(block, rb.AdjustmentOptions(jobs=1)), folder, report="none")
    return folder


def read(path):
    book = openpyxl.load_workbook(path)
    return book, {s.title: [[c.value for c in row] for row in s.iter_rows()] for s in book.worksheets}


def test_the_workbook_holds_what_the_tables_say(result, tmp_path, capsys):
    assert main(["spreadsheet", str(result), "--out", str(tmp_path / "t.xlsx"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["sheets"][0] == "points"
    book, sheets = read(tmp_path / "t.xlsx")
    assert book.properties.title == "part 7"
    for name, rows in sheets.items():
        given = list(workbook.rows_of(result / f"{name}.csv"))
        assert len(rows) == len(given) > 1
        assert rows[0] == given[0]
        for row, texts in zip(rows[1:], given[1:], strict=True):
            for value, text in zip(row, texts, strict=True):
                assert (
                    (value is None and not text)
                    or str(value) == text
                    or float(value) == pytest.approx(float(text), rel=1e-14)
                )
    sheet = book["points"]
    assert sheet.freeze_panes == "B2"
    column = [c.value for c in sheet[1]].index("X") + 1
    text = list(workbook.rows_of(result / "points.csv"))[1][column - 1]
    cell = sheet.cell(2, column)
    assert cell.data_type == "n"
    assert cell.number_format == "0." + "0" * len(text.partition(".")[2])


def test_names_and_what_looks_like_a_formula_stay_texts(tmp_path):
    table = tmp_path / "odd.csv"
    table.write_text('point,X,words\n007,1.50,"=1+1"\n=cmd,-2,"a, ""b"" c"\n+4,1e-05,\x07x\n', encoding="utf-8")
    assert workbook.write_workbook(tmp_path / "o.xlsx", [("a/b:c?", table), ("A b c ", table)]) == ["a b c", "A b c 2"]
    book, sheets = read(tmp_path / "o.xlsx")
    assert sheets["a b c"] == [
        ["point", "X", "words"], ["007", 1.5, "=1+1"], ["=cmd", -2, 'a, "b" c'],
        ["+4", 1e-05, "\N{REPLACEMENT CHARACTER}x"],
    ]  # fmt: skip
    assert [c.data_type for c in book["a b c"]["C"][:2]] == ["s", "s"]
    assert book["a b c"]["B4"].number_format == "0E+00"


def test_some_tables_and_a_project(result, tmp_path):
    done = spreadsheet(result, tmp_path / "s.xlsx", tables=("images", "points.csv"))
    assert done.sheets == ("images", "points")
    with pytest.raises(InputError, match=r"nothing.*workbook\.unknown_table"):
        spreadsheet(result, tmp_path / "n.xlsx", tables=("nothing",))


@pytest.mark.parametrize(("out", "message"), [("t.xls", r"file\.suffix"), ("there.xlsx", r"file\.exists")])
def test_bad_names_are_told_before_anything_is_read(result, tmp_path, out, message):
    (tmp_path / "there.xlsx").write_text("kept")
    with pytest.raises(InputError, match=message):
        spreadsheet(result, tmp_path / out)
    assert (tmp_path / "there.xlsx").read_text() == "kept"


def test_a_folder_without_tables_and_a_table_too_long_are_told(result, tmp_path, monkeypatch):
    (tmp_path / "empty").mkdir()
    with pytest.raises(InputError, match=r"session\.no_project"):
        spreadsheet(tmp_path / "empty", tmp_path / "e.xlsx")
    with pytest.raises(InputError, match=r"result\.no_folder"):
        spreadsheet(result / "points.csv", tmp_path / "e.xlsx")
    monkeypatch.setattr(workbook, "ROWS", 100)
    done = spreadsheet(result, tmp_path / "l.xlsx")
    assert any(told.startswith("observations.csv ") for told in done.left_out)
    assert "observations" not in done.sheets
    assert not (tmp_path / "e.xlsx").exists()
