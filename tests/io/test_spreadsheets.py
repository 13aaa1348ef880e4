"""Tables as spreadsheets of other countries save them: semicolons or tabs, decimal commas, marks of encoding."""

import ast
import csv
import io
import re
from pathlib import Path

import numpy as np
import pytest
from tests.io.spreadsheets import READERS
from tests.sources import trees

import raybundle
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.reading.dialects import dialect_of, header_cells, without_groups
from raybundle.io.tables import Column, read_table

SOURCE = Path(raybundle.__file__).parent
NUMBER = re.compile(r"[-+]?[0-9]*\.[0-9]+(?:[eE][-+]?[0-9]+)?")
WAYS = {
    "Excel in German, UTF-8": (";", "utf-8-sig", "\r\n", ""),
    "Excel in French": (";", "cp1252", "\r\n", ""),
    "LibreOffice in Dutch": (";", "utf-8", "\n", ""),
    "tabs": ("\t", "utf-8", "\r\n", ""),
    "said in a first line": (";", "utf-8-sig", "\r\n", "sep=;"),
}
UNSAID = {"codes", "outline"}
"""Readers of lists without a header, in which no line says the separator"""


def saved(text: str, separator: str, above: str) -> str:
    """A table as a spreadsheet with decimal commas saves it."""
    out = io.StringIO()
    writer = csv.writer(out, delimiter=separator, lineterminator="\n")
    for row in csv.reader(io.StringIO(text)):
        writer.writerow([c.replace(".", ",") if NUMBER.fullmatch(c) else c for c in row])
    return (f"{above}\n" if above else "") + out.getvalue()


def same(a: object, b: object) -> bool:
    if isinstance(a, np.ndarray):
        return np.array_equal(a, b, equal_nan=a.dtype.kind == "f")
    if isinstance(a, tuple):
        return len(a) == len(b) and all(map(same, a, b))
    return a == b


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", READERS)
def test_a_table_is_the_same_however_it_was_saved(tmp_path, name, way):
    reader = READERS[name]
    separator, encoding, end, above = WAYS[way]
    if name in UNSAID and (above or encoding == "cp1252"):
        above, encoding = "", "utf-8"
    for folder in ("plain", "saved"):
        (tmp_path / folder).mkdir()
        for file, text in reader.files.items():
            if folder == "plain" or not file.endswith(".csv"):
                data = text.encode()
            else:
                data = saved(text, separator, above).replace("\n", end).encode(encoding)
            (tmp_path / folder / file).write_bytes(data)
    assert same(reader.read(tmp_path / "plain"), reader.read(tmp_path / "saved"))


def test_every_module_that_reads_tables_of_users_is_tested():
    """Tables of raybundle itself are read with own=True; all others stand in `tests.io.spreadsheets`."""
    found = set()
    for name, tree in trees("read_table"):
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "read_table":
                own = any(k.arg == "own" for k in node.keywords)
                found |= set() if own else {name}
    assert found - {r.module for r in READERS.values()} == {"commands/calibrate.py", "commands/target_settings.py"}
    # these two call the reader of targets/codes.py


COLUMNS = (
    Column(name="point", kind="id"), Column(name="X", kind="number", empty=True),
    Column(name="sX", kind="number", optional=True, empty=True, limit=">= 0"),
)  # fmt: skip


def table(tmp_path, data, **how):
    path = tmp_path / "t.csv"
    path.write_bytes(data if isinstance(data, bytes) else data.encode())
    return read_table(path, COLUMNS, **how)


def test_with_semicolons_and_points_points_are_decimal():
    assert dialect_of(["point;X"]).separator == ";"
    assert dialect_of(['"a;b;c",X']).separator == ","
    assert dialect_of(["point\tX;Y\tZ"]).separator == "\t"
    assert header_cells('\ufeffsep=;\r\n"point";X\r\n') == ["point", "X"]


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("point;X\na;1,234\nb;2\n", [1.234, 2]),
        ("point;X\na;1.234\nb;2\n", [1.234, 2]),
        ("point;X\na;-,5\nb;1e3\n", [-0.5, 1000]),
        ("point;X\na;1,5E-3\nb;\n", [0.0015, np.nan]),
        ('"point";"X"\n"a;1";"1,5"\n"b";"2,5"\n', [1.5, 2.5]),
        ("sep=,\npoint,X\na,1.5\nb,2\n", [1.5, 2]),
    ],
)
def test_what_a_sign_means(tmp_path, text, values):
    np.testing.assert_array_equal(table(tmp_path, text).number["X"], values)


@pytest.mark.parametrize(
    ("text", "line", "column", "words"),
    [
        ("point;X;sX\na;1,234;0.5\nb;2;0\n", 2, "sX", r"2.*1.*234.*X.*table\.two_decimal_signs"),
        ("point;X\na;2.5\nb;1.234.567\n", 3, "X", r"1234567.*cell\.grouped_thousands"),
        ("point;X\na;1.234,56\nb;2\n", 2, "X", r"56.*1234.*cell\.grouped_thousands"),
        ("point;X\na;1,234,567\nb;2\n", 2, "X", r"1234567.*cell\.grouped_thousands"),
        ("point;X\na;1 234,5\nb;2\n", 2, "X", r"5.*1234.*cell\.grouped_thousands"),
        ("point;X\na;1\u202f234,5\nb;2\n", 2, "X", r"5.*1234.*cell\.grouped_thousands"),
        ("point,X\na,1'234.5\nb,2\n", 2, "X", r"1234\.5.*cell\.grouped_thousands"),
        ('point,X\na,"1,234.5"\nb,2\n', 2, "X", r"1234\.5.*cell\.grouped_thousands"),
        ('point,X\na,"1,5"\nb,2\n', 2, "X", r"cell\.not_a_number"),
        ("point;X\na;1,5\nb;x\n", 3, "X", r"cell\.not_a_number"),
        ("sep=;\npoint;X\na;1,5\nb;x\n", 4, "X", r"cell\.not_a_number"),
        ("sep=;\npoint;Y\na;1,5\n", 2, "Y", r"table\.unknown_column"),
        ("sep=|\npoint|X\na|1,5\n", 1, None, r"table\.separator_unknown"),
        ("point;X;sX\na;1,5;-0,1\n", 2, "sX", r"0.*1.*cell\.negative_sigma"),
        ("point;X\na;1;5\n", 2, None, r"2.*table\.cell_count"),
        ("point;X\na;1,5\na;2,5\n", 3, "point", r"2.*cell\.id_twice"),
        ("sep=;\npoint;X\na;1,5\na;2,5\n", 4, "point", r"3.*cell\.id_twice"),
    ],
)  # fmt: skip
def test_what_could_be_read_in_two_ways_is_refused(tmp_path, text, line, column, words):
    with pytest.raises(InputError, match=words) as caught:
        table(tmp_path, text)
    assert (caught.value.line, caught.value.column) == (line, column)
    assert str(tmp_path / "t.csv") in str(caught.value)


def test_bytes_that_are_neither_utf8_nor_windows(tmp_path):
    assert table(tmp_path, "point;X\nMünze;1,5\n".encode("cp1252")).text["point"] == ("Münze",)
    for data in (b"point;X\na\x81;1,5\n", "point;X\nü;1\n".encode() + b"\xfc;2\n", b"point;X\na\x00;1\n"):
        with pytest.raises(InputError, match=r"file\.control_character|file\.not_utf8"):
            table(tmp_path, data)


@pytest.mark.parametrize(
    ("cell", "plain"),
    [
        ("1.234,5", "1234,5"), ("1 234", "1234"), ("12'345.6", "12345.6"), ("1,234", ""), ("1.234", ""), ("1234.5", ""),
        ("-1,234,567.25e3", "-1234567.25e3"), ("1.234 567", ""), ("1 23", ""), ("x 234", ""), ("1,234,5", ""),
    ],
)  # fmt: skip
def test_numbers_with_signs_between_thousands(cell, plain):
    assert without_groups(cell) == plain


def test_tables_of_blocks_stay_as_the_format_says(tmp_path):
    from tests.hostile.readers.blocks import small_block

    write_block(small_block().observed, tmp_path / "b")
    file = tmp_path / "b" / "points.csv"
    file.write_text(saved(file.read_text(), ";", ""))
    with pytest.raises(InputError, match=r"table\.unknown_column"):
        read_block(tmp_path / "b")
