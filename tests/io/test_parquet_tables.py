"""Parquet tables: the same rows and complaints as CSV, bit by bit, and nothing that a damaged file could do."""

import contextlib
import re
from dataclasses import replace

import numpy as np
import pytest
from click.testing import CliRunner

from raybundle import adjust, convert, read_result, write_result
from raybundle.block import Block
from raybundle.blocking.columns import InMemory
from raybundle.cli.main import cli
from raybundle.errors import InputError
from raybundle.io import parquet, table_files
from raybundle.io.block.arrays import arrays_of_block
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.block.pieces import read_in_pieces
from raybundle.io.reading.parquet_pages import row_groups
from raybundle.io.tables import Column, read_table, write_table
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene

pa = pytest.importorskip("pyarrow", reason="Parquet tables need pyarrow")
pq = pytest.importorskip("pyarrow.parquet")


@pytest.fixture(scope="module")
def block() -> Block:
    survey = Survey(control=8, station_sigma=0.05, points="approximate")
    return simulate(aerial_scene(AerialStrips(points_per_image=60)), survey).observed


def same(a, b):
    a, b = arrays_of_block(a), arrays_of_block(b)
    assert a.keys() == b.keys()
    for name in a:
        assert np.asarray(a[name]).tobytes() == np.asarray(b[name]).tobytes(), name


def test_blocks_are_read_as_from_csv_bit_by_bit(block, tmp_path):
    rejected = ((block.images.ids[0], block.points.ids[int(block.observations.point[0])]),)
    o = block.observations
    block = replace(block, rejected=rejected, observations=replace(o, cov_px2=o.cov_px2 + np.array([0.0, 0.0, 1e-3])))
    for tables in ("csv", "parquet"):
        write_block(block, tmp_path / tables, tables=tables)
    assert {p.suffix for p in (tmp_path / "parquet").iterdir()} == {".toml", ".parquet"}
    read = read_block(tmp_path / "parquet")
    same(read, read_block(tmp_path / "csv"))
    write_block(read, tmp_path / "again", tables="parquet")  # standard deviations: sqrt(s s) = s in binary numbers
    same(read, read_block(tmp_path / "again"))
    for name in ("observations", "points"):
        assert (tmp_path / "again" / f"{name}.parquet").read_bytes() == (
            tmp_path / "parquet" / f"{name}.parquet"
        ).read_bytes()


def test_groups_of_rows_make_no_difference(block, tmp_path, monkeypatch):
    write_block(block, tmp_path / "one", tables="parquet")
    monkeypatch.setattr(parquet, "GROUP_ROWS", 37)
    write_block(block, tmp_path / "many", tables="parquet")
    assert pq.ParquetFile(tmp_path / "many/observations.parquet").num_row_groups > 10
    same(read_block(tmp_path / "one"), read_block(tmp_path / "many"))


def test_a_large_table_is_parquet_by_itself(block, tmp_path, monkeypatch):
    write_block(block, tmp_path / "small")
    assert {p.suffix for p in (tmp_path / "small").iterdir()} == {".toml", ".csv"}
    monkeypatch.setattr(table_files, "SHEET_ROWS", len(block.observations) - 1)
    write_block(block, tmp_path / "large")
    names = {p.name for p in (tmp_path / "large").iterdir()}
    assert {"observations.parquet", "points.csv", "images.csv"} <= names
    same(read_block(tmp_path / "small"), read_block(tmp_path / "large"))
    monkeypatch.setattr(table_files, "find_spec", dict[str, None]().get)
    write_block(block, tmp_path / "without")
    assert (tmp_path / "without/observations.csv").exists()


def test_both_formats_of_one_table_are_refused(block, tmp_path):
    write_block(block, tmp_path / "b", tables="parquet")
    (tmp_path / "b/points.csv").write_text("point,role,X,Y,Z,sX,sY,sZ\n")
    with pytest.raises(InputError, match=r"points\.parquet.*points\.csv.*table\.csv_and_parquet"):
        read_block(tmp_path / "b")


def test_without_pyarrow_it_is_said_what_to_install(block, tmp_path, monkeypatch):
    write_block(block, tmp_path / "b", tables="parquet")

    def none(name):
        raise ImportError(name)

    monkeypatch.setattr(parquet, "import_module", none)
    with pytest.raises(InputError, match=r"package\.pyarrow_missing"):
        read_block(tmp_path / "b")
    with pytest.raises(InputError, match=r"package\.pyarrow_missing"):
        write_block(block, tmp_path / "c", tables="parquet")
    assert not (tmp_path / "c").exists()


COLUMNS = (
    Column(name="id", kind="id"),
    Column(name="ref", kind="reference", known={"a": 0, "b": 1}, where="the list"),
    Column(name="x", kind="number"),
    Column(name="s", kind="number", empty=True, limit="> 0"),
    Column(name="note", kind="text", optional=True, empty=True),
)
GOOD = {"id": ["p", "q", "r"], "ref": ["a", "b", "a"], "x": [1.0, -0.0, 1e-7], "s": [0.5, None, 2.0]}
BAD = {
    "id": (["p", "q", "p"], ["p", None, "r"], ["p", " q", "r"], ["p", "q\x01", "r"]),
    "ref": (["a", "z", "a"], ["a", "b", None]),
    "x": ([1.0, None, 2.0], [1.0, 2.0, float("inf")], [1e19, 1.0, 2.0]),
    "s": ([0.5, 0.0, 2.0], [-1.0, None, 2.0], [1.0, 1e-200, 1.0]),
}


@pytest.mark.parametrize(("name", "values"), [(k, v) for k, all_ in BAD.items() for v in all_])
def test_complaints_are_those_of_csv_with_rows_for_lines(name, values, tmp_path):
    table = {**GOOD, name: values}
    pq.write_table(pa.table(table), tmp_path / "t.parquet")
    cells = [["" if v is None else v if isinstance(v, str) else repr(v) for v in column] for column in table.values()]
    lines = [",".join(table), *map(",".join, zip(*cells, strict=True))]
    (tmp_path / "t.csv").write_text("\n".join(lines) + "\n", newline="\n")
    said = []
    for file in ("t.csv", "t.parquet"):
        with pytest.raises(InputError) as found:
            read_table(tmp_path / file, COLUMNS, own=True)
        said.append(str(found.value).replace(str(tmp_path / file), ""))
    lines_as_rows = re.sub(r"\bline (\d+)", lambda m: f"row {int(m[1]) - 1}", said[0])
    assert said[1] == lines_as_rows


def test_a_pair_that_stands_twice_is_told_by_its_rows(block, tmp_path, monkeypatch):
    write_block(block, tmp_path / "b", tables="parquet")
    file = tmp_path / "b/observations.parquet"
    table = pq.read_table(file)
    pq.write_table(pa.concat_tables([table, table.slice(4, 1)]), file)
    with pytest.raises(InputError, match=r"984.*5.*table\.pair_twice"):
        read_block(tmp_path / "b")
    with pytest.raises(InputError, match=r"984.*5.*table\.pair_twice"):
        read_in_pieces(tmp_path / "b")


def test_unknown_and_missing_columns(tmp_path):
    pq.write_table(pa.table({**GOOD, "y": [1.0, 2.0, 3.0]}), tmp_path / "t.parquet")
    with pytest.raises(
        InputError,
        match=r"t\.parquet.*table\.unknown_column",
    ):
        read_table(tmp_path / "t.parquet", COLUMNS)
    pq.write_table(pa.table({k: v for k, v in GOOD.items() if k != "x"}), tmp_path / "t.parquet")
    with pytest.raises(InputError, match=r"table\.columns_missing"):
        read_table(tmp_path / "t.parquet", COLUMNS)


def test_what_other_programs_write_is_read(tmp_path):
    """Numbers as ids, whole and short numbers, texts by a dictionary, large texts, other codecs and page versions."""
    known = Column(name="ref", kind="reference", known={"1": 0, "2": 1}, where="the list")
    columns = (COLUMNS[0], known, *COLUMNS[2:])
    table = pa.table({
        "id": pa.array(["p", "q", "r"], pa.large_string()), "ref": pa.array([2, 1, 2], pa.int64()),
        "x": pa.array([1, 2, 3], pa.int16()), "s": pa.array([0.5, None, 2.0], pa.float32()),
        "note": pa.array(["n", None, "n"]).dictionary_encode(),
    })  # fmt: skip
    for codec, version in (("snappy", "1.0"), ("gzip", "2.0"), ("none", "2.0"), ("zstd", "1.0")):
        pq.write_table(table, tmp_path / "t.parquet", compression=codec, data_page_version=version)
        read = read_table(tmp_path / "t.parquet", columns)
        assert read.text == {"id": ("p", "q", "r"), "note": ("n", "", "n")}
        assert read.index["ref"].tolist() == [1, 0, 1]
        np.testing.assert_array_equal(read.numbers("x", "s"), [[1, 0.5], [2, np.nan], [3, 2]])


def test_columns_of_other_kinds_are_refused(tmp_path):
    for values in ([[1.0], [2.0], [3.0]], ["1", "2", "3"], [{"a": 1}] * 3, [b"1"] * 3):
        pq.write_table(pa.table({**GOOD, "x": values}), tmp_path / "t.parquet")
        with pytest.raises(InputError, match=r"t\.parquet.*parquet\.column_type"):
            read_table(tmp_path / "t.parquet", COLUMNS)


def test_damaged_files_are_refused_or_read_as_they_were(block, tmp_path):
    write_block(block, tmp_path / "b", tables="parquet")
    file = tmp_path / "b/observations.parquet"
    data, right = file.read_bytes(), read_block(tmp_path / "b")
    rng = np.random.default_rng(3)
    told = []
    for k in range(150):
        damaged = bytearray(data)
        at = int(rng.integers(len(data)))
        damaged = damaged[:at] if k % 3 == 0 else damaged
        if k % 3:
            damaged[at] ^= int(rng.integers(1, 256))
        file.write_bytes(bytes(damaged))
        try:
            same(read_block(tmp_path / "b"), right)  # statistics and versions are not read
        except InputError as error:
            told.append(str(error))
    assert len(told) > 100
    assert all("observations.parquet" in words for words in told)


def test_foreign_files_are_refused(tmp_path):
    file = tmp_path / "t.parquet"
    for data in (
        b"",
        b"id,ref,x,s\np,a,1,\n",
        b"PAR1" + bytes(40) + b"PAR1",
        b"PAR1" * 3,
        b"x" * 20 + b"\xff" * 4 + b"PAR1",
    ):
        file.write_bytes(data)
        with pytest.raises(InputError, match=r"parquet\.footer_too_large|parquet\.no_footer|parquet\.not_readable"):
            read_table(file, COLUMNS)


def test_what_would_unfold_beyond_memory_is_refused_before_it_is(tmp_path, monkeypatch):
    file = tmp_path / "t.parquet"
    rows = 200_000
    table = {"id": [f"p{k}" for k in range(rows)], "ref": ["a"] * rows, "x": np.zeros(rows), "s": np.ones(rows)}
    pq.write_table(pa.table(table), file)
    monkeypatch.setattr(parquet, "MOST_GROUP_ROWS", rows - 1)
    with pytest.raises(InputError, match=r"parquet\.group_too_large"):
        read_table(file, COLUMNS)
    monkeypatch.setattr(parquet, "MOST_GROUP_ROWS", rows)
    monkeypatch.setattr(parquet, "MOST_GROUP_BYTES", 1_000_000)  # the head of each page says more
    with pytest.raises(InputError, match=r"parquet\.group_too_large"):
        read_table(file, COLUMNS)
    monkeypatch.undo()
    pq.write_table(pa.table(GOOD), file, use_dictionary=False, column_encoding={"id": "DELTA_BYTE_ARRAY"})
    with pytest.raises(InputError, match=r"DELTA_BYTE_ARRAY.*parquet\.encoding"):
        read_table(file, COLUMNS)
    constant = {"ref": ["a"] * 3_000_000, "x": np.zeros(3_000_000)}
    pq.write_table(pa.table(constant), file, compression="zstd")
    with pytest.raises(InputError, match=r"parquet\.too_many_rows"):
        read_table(file, COLUMNS[1:3])


def test_a_page_that_says_more_than_the_footer_is_found(tmp_path):
    """The size that is believed is that of the page's head: a footer that lies does not hide it."""
    file = tmp_path / "t.parquet"
    pq.write_table(pa.table({"x": np.zeros(1 << 19)}), file, use_dictionary=False, compression="zstd")
    told = pq.ParquetFile(file).metadata.row_group(0).column(0)
    with file.open("rb") as raw:
        found = list(parquet.pages(raw, told.data_page_offset, told.total_compressed_size))
    assert sum(p.unpacked for p in found) >= 8 << 19
    assert {p.encoding for p in found} == {0}


def test_sizes_in_the_footer_are_those_that_pyarrow_reads(block, tmp_path, monkeypatch):
    monkeypatch.setattr(parquet, "GROUP_ROWS", 100)
    write_block(block, tmp_path / "b", tables="parquet")
    for path in sorted((tmp_path / "b").glob("*.parquet")):
        known = pq.ParquetFile(path).metadata
        with path.open("rb") as raw:
            found = row_groups(parquet._footer(raw))
        assert [rows for rows, _ in found] == [known.row_group(k).num_rows for k in range(known.num_row_groups)]
        for k, (_, chunks) in enumerate(found):
            columns = [known.row_group(k).column(j) for j in range(known.num_columns)]  # of a file that is whole
            assert [c.name for c in chunks] == [c.path_in_schema for c in columns]
            assert [c.length for c in chunks] == [c.total_compressed_size for c in columns]
            begins = [c.dictionary_page_offset if c.has_dictionary_page else c.data_page_offset for c in columns]
            assert [c.begin for c in chunks] == begins


def test_a_footer_whose_sizes_contradict_the_schema_is_refused(block, tmp_path):
    """pyarrow ends the process when it is asked for such a column."""
    write_block(block, tmp_path / "b", tables="parquet")
    path = tmp_path / "b/images.parquet"
    data = path.read_bytes()
    at = len(data) - 8 - int.from_bytes(data[-8:-4], "little")
    for k in range(at, len(data) - 8, 3):
        for byte in (0, 255, data[k] ^ 2):
            path.write_bytes(data[:k] + bytes([byte]) + data[k + 1 :])
            with contextlib.suppress(InputError):
                read_block(tmp_path / "b")


def test_a_block_is_read_in_pieces(block, tmp_path, monkeypatch):
    monkeypatch.setattr(parquet, "GROUP_ROWS", 100)
    some = replace(block, points=block.points)
    write_block(some, tmp_path / "b", tables="parquet")
    read, whole = read_in_pieces(tmp_path / "b"), InMemory(read_block(tmp_path / "b"))
    same(replace(read.bare), whole.bare)
    assert (read.points, read.observations) == (whole.points, whole.observations)
    pieces = list(read.pieces_of_observations())
    assert [begin for begin, _ in pieces] == list(range(0, read.observations, 100))
    o = whole.block.observations
    for name in ("image", "point", "xy_px", "cov_px2"):
        joined = np.concatenate([getattr(p, name) for _, p in pieces])
        assert joined.tobytes() == getattr(o, name).tobytes()
    (_, points), *rest = read.pieces_of_points()
    assert rest == []
    assert points.ids == whole.block.points.ids
    at = np.array([1, 5, 6])
    assert read.points_at(at).ids == whole.points_at(at).ids
    write_block(block, tmp_path / "csv", tables="csv")
    with pytest.raises(InputError, match=r"observations\.csv.*block\.observations_not_parquet"):
        read_in_pieces(tmp_path / "csv")


def test_new_tie_points_have_the_order_of_their_rows(block, tmp_path, monkeypatch):
    for tables in ("csv", "parquet"):
        monkeypatch.setattr(parquet, "GROUP_ROWS", 50)
        write_block(block, tmp_path / tables, tables=tables)
        (tmp_path / tables / f"points.{tables}").unlink()
        for name in ("distances", "coordinates"):
            (tmp_path / tables / f"{name}.{tables}").unlink(missing_ok=True)
    same(read_block(tmp_path / "csv"), read_block(tmp_path / "parquet"))
    assert read_in_pieces(tmp_path / "parquet").every_point.ids == read_block(tmp_path / "csv").points.ids


def test_result_folders_say_the_same_in_both(block, tmp_path):
    result = adjust(block)
    for tables in ("csv", "parquet"):
        write_result(result, tmp_path / tables, tables=tables)
        write_result(result, tmp_path / tables, tables=tables)  # over an older one
    assert {"observations.parquet", "points.parquet", "block", "report.html"} <= {
        p.name for p in (tmp_path / "parquet").iterdir()
    }
    csv, columns = read_result(tmp_path / "csv"), read_result(tmp_path / "parquet")
    same(csv.block, columns.block)
    for name in ("images", "points", "observations", "control", "check", "distances", "stations"):
        a, b = getattr(csv, name), getattr(columns, name)
        assert a.text == b.text, name
        for column in a.number:
            assert a.number[column].tobytes() == b.number[column].tobytes(), (name, column)


def test_numbers_keep_their_digits_and_ids_their_texts(tmp_path):
    x = np.array([0.1, -2.5, np.nan, 1e-7, 123456.789])
    at = np.array([1, 1, 0, 2, 0])
    columns = {"id": table_files.Named(("ä", "b,c", 'd"e'), at), "x": x, "t": ["", "a", "", "", "b"]}
    for suffix in ("csv", "parquet"):
        write_table(tmp_path / f"t.{suffix}", columns, parquet.EVERY)
        kinds = (Column(name="id", kind="text"), Column(name="x", kind="number", empty=True),
                 Column(name="t", kind="text", empty=True))  # fmt: skip
        read = read_table(tmp_path / f"t.{suffix}", kinds, own=True)
        assert read.text == {"id": tuple(columns["id"]), "t": tuple(columns["t"])}
        assert read.number["x"].tobytes() == x.tobytes()


def test_commands_write_and_read_what_is_asked_for(block, tmp_path):
    write_block(block, tmp_path / "b")

    def run(*words):
        done = CliRunner().invoke(cli, [str(w) for w in words])
        assert done.exit_code == 0, done.output

    run("convert", tmp_path / "b", "--to", "block", "--tables", "parquet", "--out", tmp_path / "c")
    same(read_block(tmp_path / "b"), read_block(tmp_path / "c"))
    run("adjust", tmp_path / "c", "--tables", "parquet", "--no-report", "--out", tmp_path / "r")
    assert (tmp_path / "r/points.parquet").exists()
    run("convert", tmp_path / "r", "--to", "ply", "--out", tmp_path / "p.ply")
    run("compare", tmp_path / "r", tmp_path / "r", "--out", tmp_path / "compared.html")
    run("adjust", tmp_path / "r/block", "--tables", "csv", "--no-report", "--out", tmp_path / "r")
    assert (tmp_path / "r/points.csv").exists()
    assert not (tmp_path / "r/points.parquet").exists()
    with pytest.raises(InputError, match=r"tables=.*ply.*format\.no_tables"):
        convert(tmp_path / "b", tmp_path / "q.ply", to="ply", tables="csv")
