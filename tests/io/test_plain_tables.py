"""The compiled CSV reader: what it reads is what the cell-by-cell reader reads, and what it leaves, that one tells."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from raybundle.errors import InputError
from raybundle.io import tables
from raybundle.io.tables import Column, Table, read_table
from raybundle.numerics import native

pytestmark = pytest.mark.skipif(not native.available(), reason="the kernels are not compiled")
NUMBERS = ("1", "-2.5", "+3", ".5", "5.", "1e3", "1E-3", "-0", "1e400", "1e-400", "1e301", "1e-310", "0x1", "1_0",
           "nan", "inf", "", " 1", "1 ", "--1", "+-1", "1.2.3", "e5", "１", "0" * 70 + "1.25")  # fmt: skip
TEXTS = ("a", "b", "c", "point 7", "ö", "", " a", "a ", '"a"', '"a,b"', "x\ty", "\x00", "\u2028", "z" * 70000)
ENDS = ("\n", "\r\n")


def columns() -> tuple[Column, ...]:
    """One of each kind."""
    return (
        Column(name="id", kind="id"),
        Column(name="known", kind="reference", known={"a": 0, "b": 1, "ö": 2}, where="the list"),
        Column(name="new", kind="new_reference", known={"b": 0}),
        Column(name="text", kind="text", empty=True),
        Column(name="x", kind="number"),
        Column(name="y", kind="number", empty=True, limit=">= 0"),
        Column(name="s", kind="number", optional=True, empty=True, limit="> 0"),
    )


def read(path: Path, module: ModuleType | None, monkeypatch: pytest.MonkeyPatch) -> tuple[object, ...]:
    """What comes of a file: the table and the new names, or the message."""

    def there() -> ModuleType | None:
        return module

    with monkeypatch.context() as patch:
        patch.setattr(tables.native, "module", there)
        asked = columns()
        try:
            found: Table = read_table(path, asked, unique=("known", "new"))
        except InputError as error:
            return (str(error),)
        numbers = {k: v.tobytes() for k, v in found.number.items()}
        index = {k: (v.dtype, v.tolist()) for k, v in found.index.items()}
        return found.rows, found.text, numbers, index, list(asked[2].known.items())


good = st.sampled_from(("1", "-2.5", "+3", ".5", "5.", "1e3", "-0", "123456.7890123")).map(str)
rows = st.lists(
    st.tuples(
        st.sampled_from(("a", "b", "ö")),
        st.sampled_from(("a", "b", "c", "point 7")),
        st.sampled_from(("", "a", "ö", " a")),
        good, st.sampled_from(("", "0", "2.5", "1e-310")),
    ),
    max_size=9,
)  # fmt: skip
odd = st.one_of(
    st.none(),
    st.tuples(st.integers(0, 8), st.integers(0, 5), st.sampled_from(NUMBERS + TEXTS)),
)


@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(rows=rows, odd=odd, end=st.sampled_from(ENDS), tail=st.sampled_from(("", "\n", "\r\n\n", "1,2")))
def test_both_readers_say_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, rows: list[tuple[str, ...]], odd: tuple[int, int, str] | None,
    end: str, tail: str,
) -> None:  # fmt: skip
    """Tables with one odd cell, or none: numbers to the bit, names in their order, messages to the letter."""
    cells = [[f"p{k}", *row] for k, row in enumerate(rows)]
    if odd is not None and odd[0] < len(cells):
        cells[odd[0]][odd[1]] = odd[2]
    path = tmp_path / "t.csv"
    path.write_bytes(
        (end.join([",".join(r) for r in [["id", "known", "new", "text", "x", "y"], *cells]]) + tail).encode()
    )
    monkeypatch.setattr(tables, "PIECE_BYTES", 37)
    assert read(path, native.module(), monkeypatch) == read(path, None, monkeypatch)


def test_the_compiled_reader_is_the_one_that_reads(tmp_path: Path) -> None:
    """Ordinary tables of every ending take the short way, quoted ones the other."""
    for end in ENDS:
        path = tmp_path / "t.csv"
        path.write_bytes(f"id,known,new,text,x,y{end}p,a,c,,1.5,{end}q,b,c,t,-2,3{end}".encode())
        found = tables._read_plain(path, columns(), ())
        assert found is not None
        assert found.text == {"id": ("p", "q"), "text": ("", "t")}
        np.testing.assert_array_equal(found.number["y"], [np.nan, 3])
        path.write_bytes(path.read_bytes().replace(b",t,", b',"t",'))
        assert tables._read_plain(path, columns(), ()) is None


def test_wrong_calls_are_exceptions() -> None:
    """Columns that are not there."""
    module = native.module()
    assert module is not None
    with pytest.raises(ValueError, match="number of columns"):
        module.Columns([])
    reader = module.Columns([True, False])
    assert reader.add(b"1,a\n2,b")
    assert reader.rows == 2
    for wrong in (
        lambda: reader.number(1),
        lambda: reader.text(0),
        lambda: reader.text(9),
        lambda: reader.different(0),
    ):
        with pytest.raises(ValueError, match="no such column"):
            wrong()
    assert not reader.add(b"1")
    assert not module.Columns([True, True]).add(b"")
