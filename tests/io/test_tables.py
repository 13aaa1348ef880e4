"""The CSV reader: the same table and the same errors wherever the pieces of a file end."""

import math

import numpy as np
import pytest
from tests.messages import refused

from raybundle.errors import InputError
from raybundle.io import tables
from raybundle.io.digits import COUNT, EVERY, STD, by_sigma
from raybundle.io.tables import Column, read_table, write_table

ROWS = [(f"p{k}", k / 7, math.nan if k % 3 else -k / 3) for k in range(40)]


def columns(known=None):
    return (
        Column(name="point", kind="id"),
        Column(name="to", kind="new_reference", known={} if known is None else known),
        Column(name="x", kind="number"),
        Column(name="y", kind="number", empty=True),
    )


def text(rows=ROWS, end="\n"):
    lines = [
        "point,to,x,y",
        *(f"{p},t{k // 2},{x!r},{'' if math.isnan(y) else repr(y)}" for k, (p, x, y) in enumerate(rows)),
    ]
    return end.join(lines) + end


@pytest.fixture(params=[7, 33, 64, 4096])
def piece(request, monkeypatch):
    monkeypatch.setattr(tables, "PIECE_BYTES", request.param)
    return request.param


@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize("tail", ["", "\n\n\r\n"])
def test_the_table_does_not_depend_on_the_pieces(tmp_path, piece, end, tail):
    path = tmp_path / "t.csv"
    path.write_bytes((text(end=end) + tail).encode())
    known = {}
    table = read_table(path, columns(known))
    assert table.rows == len(ROWS)
    assert table.text["point"] == tuple(p for p, _, _ in ROWS)
    assert table.index["to"].tolist() == [k // 2 for k in range(len(ROWS))]
    assert list(known) == [f"t{k}" for k in range(len(ROWS) // 2)]
    np.testing.assert_array_equal(table.numbers("x", "y"), [[x, y] for _, x, y in ROWS])


def test_the_last_line_needs_no_end(tmp_path, piece):
    path = tmp_path / "t.csv"
    path.write_text(text().rstrip("\n"))
    assert read_table(path, columns()).rows == len(ROWS)


@pytest.mark.parametrize(
    ("old", "new", "column", "words"),
    [
        ("p31,", "p3,", "point", r"p3.*5.*cell\.id_twice"),
        ("p31,", '"p31,', None, r"table\.row_unreadable"),
        ("p31,t15,", "p31,", None, r"3.*table\.cell_count"),
        ("p31,t15,", "p31,t15,x", "x", r"cell\.not_a_number"),
        ("p31,", "\np31,", None, r"table\.empty_line"),
    ],
)
def test_the_line_of_an_error_does_not_depend_on_the_pieces(tmp_path, piece, old, new, column, words):
    path = tmp_path / "t.csv"
    assert old in text()
    path.write_text(text().replace(old, new))
    with pytest.raises(InputError, match=words) as caught:
        read_table(path, columns())
    assert (caught.value.line, caught.value.column) == (33, column)


def test_a_byte_that_is_not_utf8_is_found_in_any_piece(tmp_path, piece):
    path = tmp_path / "t.csv"
    path.write_bytes(text().encode().replace(b"p31", b"p\xe931"))
    with refused("file.not_utf8", line=33):
        read_table(path, columns())


def test_characters_of_several_bytes_may_lie_across_pieces(tmp_path, piece):
    path = tmp_path / "t.csv"
    path.write_text(text().replace("p", "Ünïçødé–𝔭").replace("Ünïçødé–𝔭oint", "point"), encoding="utf-8")
    assert read_table(path, columns()).text["point"][31] == "Ünïçødé–𝔭31"


def test_pairs_must_differ_across_pieces(tmp_path, piece):
    path = tmp_path / "t.csv"
    path.write_text("a,b\n" + "".join(f"i{k % 3},j{k // 3}\n" for k in range(30)) + "i1,j0\n")
    pair = (Column(name="a", kind="new_reference", known={}), Column(name="b", kind="new_reference", known={}))
    with pytest.raises(InputError, match=r"3.*table\.pair_twice") as caught:
        read_table(path, pair, unique=("a", "b"))
    assert caught.value.line == 32


def test_errors_beyond_the_fifth_are_only_mentioned(tmp_path):
    path = tmp_path / "t.csv"
    path.write_text(text().replace("\np", "\n,p"))
    with pytest.raises(InputError) as caught:
        read_table(path, columns())
    details = caught.value.message.details
    assert [d.code for d in details] == ["table.cell_count"] * 4 + ["table.more_errors"]
    assert len({d.place.line for d in details[:4]}) == 4


def test_a_folder_or_nothing_in_place_of_a_table(tmp_path):
    for path in (tmp_path, tmp_path / "missing.csv"):
        with pytest.raises(InputError, match=r"file\.missing|file\.not_a_file"):
            read_table(path, columns())


@pytest.mark.parametrize(
    "numbers",
    [
        [0.0, -0.0, 1.0, 10.0, 100.5, 0.1, 1 / 3, -2e-100, 1e18, 1e-99, 123456789012345680.0, 1e17, math.nan, 7.0],
        [math.nan, math.nan],
        [3.0],
    ],
)
def test_numbers_are_written_shortest_and_read_back_equal(tmp_path, numbers):
    path = tmp_path / "t.csv"
    write_table(path, {"id": [str(k) for k in range(len(numbers))], "v": np.array(numbers)}, EVERY)
    table = read_table(path, (Column(name="id", kind="id"), Column(name="v", kind="number", empty=True)))
    np.testing.assert_array_equal(table.number["v"], numbers)
    cells = [line.split(",")[1] for line in path.read_text().splitlines()[1:]]
    for cell, number in zip(cells, numbers, strict=True):
        assert len(cell) <= len(repr(number))
        assert not cell.endswith(".0")


def test_texts_are_quoted_where_they_must_be(tmp_path):
    path = tmp_path / "t.csv"
    texts = ["plain", "a,b", 'say "x"', "", "ü"]
    write_table(path, {"id": [str(k) for k in range(5)], "t": texts}, {})
    assert path.read_text(encoding="utf-8").splitlines()[1:4] == ["0,plain", '1,"a,b"', '2,"say ""x"""']
    table = read_table(path, (Column(name="id", kind="id"), Column(name="t", kind="text", empty=True)))
    assert list(table.text["t"]) == texts


def test_a_table_without_rows_may_be_allowed(tmp_path):
    path = tmp_path / "t.csv"
    write_table(path, {"point": [], "to": [], "x": np.zeros(0), "y": np.zeros(0)}, EVERY)
    table = read_table(path, columns(), least_rows=0)
    assert table.rows == 0
    assert table.numbers("x", "y").shape == (0, 2)
    assert table.text["point"] == ()
    assert table.index["to"].dtype == np.int32


def test_rows_written_by_parts_are_the_same_bytes(tmp_path, monkeypatch):
    """Quotes and empty cells in some parts only, a last part that is not full, a table of no rows."""
    rng = np.random.default_rng(1)
    text = ["a,b" if k == 13 else 'x"y' if k == 40 else f"p{k}" for k in range(101)]
    numbers = np.where(rng.random(101) < 0.2, np.nan, rng.normal(0, 1e6, 101))
    table = {"id": text, "value": numbers, "whole": np.arange(101.0)}
    digits = {"value": by_sigma(rng.uniform(1, 9, 101)), "whole": COUNT}
    write_table(tmp_path / "whole.csv", table, digits)
    for rows in (1, 7, 100, 101):
        monkeypatch.setattr("raybundle.io.tables.WRITTEN_ROWS", rows)
        write_table(tmp_path / "parts.csv", table, digits)
        assert (tmp_path / "parts.csv").read_bytes() == (tmp_path / "whole.csv").read_bytes()
    write_table(tmp_path / "none.csv", {k: v[:0] for k, v in table.items()}, EVERY)
    assert (tmp_path / "none.csv").read_bytes() == b"id,value,whole\n"
    with pytest.raises(ValueError, match="columns of .100, 101. rows"):
        write_table(tmp_path / "bad.csv", {"a": text, "b": numbers[:-1]}, EVERY)


def test_cells_are_not_made_all_at_once(tmp_path):
    """A table of 200 000 rows takes less than a fifth of what its cells would take as text."""
    import tracemalloc

    table = {f"n{k}": np.random.default_rng(k).normal(size=200_000) for k in range(10)}
    tracemalloc.start()
    write_table(tmp_path / "a.csv", table, STD)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 200_000 * 10 * 70 / 5
