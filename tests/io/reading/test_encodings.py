"""Text as Windows' editors and spreadsheets save it: with a byte order mark, or as UTF-16."""

import codecs

import numpy as np
import pytest
from tests.conftest import DATA

from raybundle.errors import InputError
from raybundle.io.calibrations import read_calibrations
from raybundle.io.cells import Column
from raybundle.io.geo.control_files import read_control
from raybundle.io.reading.files import as_utf8, read_text
from raybundle.io.scenes import read_scene
from raybundle.io.scenes.rpc_text import write_rpb, write_rpc_text
from raybundle.io.tables import header_of, read_table
from raybundle.scenes.rpc import rpc_of

REPORTS = DATA / "reports"
ENCODINGS = {
    "UTF-8": lambda t: t.encode(),
    "UTF-8 with a mark": lambda t: codecs.BOM_UTF8 + t.encode(),
    "UTF-16 LE": lambda t: codecs.BOM_UTF16_LE + t.encode("utf-16-le"),
    "UTF-16 BE": lambda t: codecs.BOM_UTF16_BE + t.encode("utf-16-be"),
    "UTF-16 LE without a mark": lambda t: t.encode("utf-16-le"),
    "UTF-16 BE without a mark": lambda t: t.encode("utf-16-be"),
}
LINES = {"\n": lambda t: t, "\r\n": lambda t: t.replace("\n", "\r\n")}


@pytest.fixture(params=ENCODINGS)
def encoded(request):
    return ENCODINGS[request.param]


@pytest.fixture(scope="module")
def rpc():
    c = np.zeros((4, 20))
    c[0, 2], c[1, 0], c[2, 1], c[3, 0] = 1.0, 1.0, 1.0, 1.0
    return rpc_of(
        coefficients=c, ground_offset=np.array([8.0, 47.0, 500.0]), ground_scale=np.array([0.1, 0.1, 500.0]),
        image_offset=np.array([500.0, 400.0]), image_scale=np.array([500.0, 400.0]),
    )  # fmt: skip


@pytest.mark.parametrize("end", LINES)
@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_tables(tmp_path, encoded, separator, end):
    text = "point,X\nP1,1.5\nÖ 2,2.5\n".replace(",", separator)
    file = tmp_path / "t.csv"
    file.write_bytes(encoded(LINES[end](text)))
    table = read_table(file, [Column(name="point", kind="id"), Column(name="X", kind="number")])
    assert table.text["point"] == ("P1", "Ö 2")
    assert table.number["X"].tolist() == [1.5, 2.5]
    assert header_of(file)[0].startswith("point")


def test_a_table_of_many_pieces(tmp_path):
    rows = 200_000
    file = tmp_path / "t.csv"
    file.write_bytes(("point,X\n" + "".join(f"P{k},{k}.5\n" for k in range(rows))).encode("utf-16"))
    table = read_table(file, [Column(name="point", kind="id"), Column(name="X", kind="number")])
    assert len(table.text["point"]) == rows
    assert table.number["X"][-1] == rows - 0.5


@pytest.mark.parametrize("write", [write_rpc_text, write_rpb])
def test_rpcs(tmp_path, encoded, rpc, write):
    file = tmp_path / ("a_RPC.TXT" if write is write_rpc_text else "a.RPB")
    write(rpc, file)
    file.write_bytes(encoded(file.read_text()))
    assert np.array_equal(read_scene(file).rpc.image_offset, rpc.image_offset)


def test_control_lists(tmp_path, encoded):
    file = tmp_path / "gcp_list.txt"
    file.write_bytes(encoded("EPSG:32633\n500010.5 5400020.25 123.5 1000.5 800.25 a.jpg g1\n"))
    assert read_control(file).ids == ("g1",)


def test_calibrations(tmp_path, encoded):
    file = tmp_path / "a.yaml"
    file.write_bytes(encoded("image_width: 640\nimage_height: 360\nK: [600, 0, 320, 0, 600, 180, 0, 0, 1]\n"))
    assert read_calibrations(file)[0].camera.fx == 600


def test_what_is_damaged_stays_an_error(tmp_path):
    file = tmp_path / "a.txt"
    for data in (b"\xff\xfea", b"a,b\n\xff\xfe", codecs.BOM_UTF16_LE + b"\x00\xd8a\x00"):
        file.write_bytes(data)
        with pytest.raises(InputError, match=r"file\.not_utf8"):
            read_text(file)
    assert as_utf8(b"a,b\n1,2\n") == b"a,b\n1,2\n"
    assert as_utf8(b"\0" * 20) == b"\0" * 20
    assert as_utf8("a,b,c,d,e\n".encode("utf-16")[:-1], whole=False) == b"a,b,c,d,e"


@pytest.mark.skipif(not REPORTS.is_dir(), reason="no public data: set RAYBUNDLE_DATA to the folder of reports/")
def test_the_reported_rpc():
    assert read_scene(REPORTS / "rpc-text-bom" / "x_RPC.TXT").rpc is not None
