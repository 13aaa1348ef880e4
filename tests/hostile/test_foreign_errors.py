"""What libraries raise for damaged archives, databases, addresses and coordinate systems is bad input, never a bug."""

import contextlib
import io
import sqlite3
import warnings
import zipfile

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.io.datasets import known_datasets
from raybundle.io.missions.areas import read_shapes
from raybundle.io.missions.wpml import read as read_wpml
from raybundle.measuring.journal import state_of
from raybundle.pipeline.clusters import cluster_at
from raybundle.surfaces.files.heights import read_heights as read_height_model
from tests.conftest import DATA

KML = (
    b'<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><Placemark><Polygon><outerBoundaryIs>'
    b"<LinearRing><coordinates>11,48 11.1,48 11.1,48.1 11,48</coordinates></LinearRing></outerBoundaryIs></Polygon>"
    b"</Placemark></kml>"
)  # fmt: skip
HOSTILE = DATA / "hostile"


def archive(name, method=zipfile.ZIP_DEFLATED):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", method) as file:
        file.writestr(name, KML)
    return out.getvalue()


def damaged_archives(name):
    """Archives whose directory, names, flags, methods or data are damaged."""
    for method in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA):
        data = archive(name, method)
        local, central = data.index(b"PK\3\4"), data.index(b"PK\1\2")
        begin = local + 30 + len(name)

        def put(at, value, data=data):
            return data[:at] + bytes(value) + data[at + len(value) :]

        yield put(local + 6, b"\x00\x08")[: central + 8] + b"\x00\x08" + data[central + 10 :]  # names are UTF-8
        yield put(local + 30, b"\xed\xa0")
        yield put_at(data, central + 46, b"\xed")
        yield put_at(put_at(put_at(data, central + 9, b"\x08"), local + 7, b"\x08"), local + 30, b"\xed\xa0")
        for k in range(0, 40, 3):
            yield put(begin + k, b"\xff\x00\xff")
        yield put(local + 8, b"\x63\x00")
        yield put_at(put_at(data, local + 8, b"\x63\x00"), central + 10, b"\x63\x00")
        yield put_at(data, central + 8, b"\x01")  # encrypted
        yield put_at(data, central + 16, b"\0\0\0\0")  # check sum
        yield put_at(data, central + 24, b"\xff\xff\x00\x00")  # size
        yield put_at(data, central + 42, b"\xff\xff\x00\x00")  # place
        yield data[: len(data) // 2]
        yield data[:-10]
        yield b""


def put_at(data, at, value):
    return data[:at] + value + data[at + len(value) :]


@pytest.mark.parametrize(("read", "name"), [(read_shapes, "doc.kml"), (read_wpml, "wpmz/waylines.wpml")])
def test_damaged_archives(read, name, tmp_path):
    refused = 0
    for data in damaged_archives(name):
        (tmp_path / "a.kmz").write_bytes(data)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # of zipfile, about names that stand twice
                read(tmp_path / "a.kmz")
        except InputError as error:
            assert "a.kmz" in str(error)  # noqa: PT017
            refused += 1
    assert refused > 40


ADDRESSES = [
    "http://[::1/", "http://[/", "http://[]/", "http://[v1.]/", "http://a[b]/", "https:///x/", "http://", "http://:80/",
    "http://host:port/", "http://host:99999/", "http://host:-1/", "http://[::1]x/", "http://\u2100/", "ftp://host/",
    "//host/", "http://host", "", "http://[fe80::1%25]:x/",
]  # fmt: skip


@pytest.mark.parametrize("address", ADDRESSES)
def test_addresses_that_are_none(address, tmp_path):
    (tmp_path / "d.toml").write_text(
        f'[a]\nabout = "x"\nsource = "x"\nbase = "{address}"\nlicence = "x"\nfiles = [["a", 1, "{"0" * 64}"]]\n'
    )
    with pytest.raises(InputError, match=r"dataset\.address"):
        known_datasets(tmp_path / "d.toml")


@pytest.mark.parametrize("address", ["tcp://[::1", "tcp://[", "tcp://[]:1", "tcp://a[b]:1", "tls://[v1.]:8786"])
def test_addresses_of_no_scheduler(address):
    with pytest.raises(InputError):
        cluster_at(address)


VALUES = [None, 1, 1.5, b"\xff", b"{}", "", "{", "[]", "1", "null", '"x"', "[" * 10_000]
"""What SQLite may keep in a column of texts"""


@pytest.mark.parametrize("column", ["id", "time", "author", "verb", "arguments"])
@pytest.mark.parametrize("value", VALUES, ids=lambda v: repr(v)[:12])
def test_values_of_other_kinds_in_a_journal(column, value, tmp_path):
    """The table without the constraints that ours has, as another program makes it."""
    path = tmp_path / "block.measured.db"
    with contextlib.closing(sqlite3.connect(path)) as db, db:
        db.execute("CREATE TABLE about (name, value)")
        db.execute("INSERT INTO about VALUES ('schema', '1')")
        db.execute("CREATE TABLE actions (seq INTEGER PRIMARY KEY, id, time, author, verb, arguments)")
        row = {"id": "a", "time": "2026-01-01T00:00:00.000+00:00", "author": "", "verb": "undo", "arguments": "{}"}
        row[column] = value
        db.execute("INSERT INTO actions VALUES (1, :id, :time, :author, :verb, :arguments)", row)
    if isinstance(value, str) and column in {"id", "time", "author"}:
        with contextlib.suppress(InputError):  # it holds no action to undo
            state_of(path)
        return
    with pytest.raises(InputError):
        state_of(path)


WKT = (
    'PROJCS["WGS 84 / UTM zone 32N",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
    'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],'
    'PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",9],PARAMETER["scale_factor",0.9996],'
    'PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1]]'
)
SYSTEMS = {
    "ellipsoid": WKT.replace("6378137,", "0.5,"), "no inverse": WKT.replace("0.9996", "0"),
    "negative scale": WKT.replace("0.9996", "-1"), "huge scale": WKT.replace("0.9996", "1e300"),
    "flattening": WKT.replace("298.257223563", "0.5"), "negative ellipsoid": WKT.replace("6378137,", "-6378137,"),
    "unit": WKT.replace('UNIT["metre",1]', 'UNIT["metre",0]'), "latitude": WKT.replace('origin",0', 'origin",1e9'),
    "meridian": WKT.replace('meridian",9', 'meridian",1e308'), "projection": WKT.replace("Transverse_Mercator", "X"),
    "parameter": WKT.replace("central_meridian", "azimuth"), "nan": WKT.replace("0.9996", "nan"),
    "degrees": WKT.replace("0.0174532925199433", "0"), "cut": WKT[:200], "empty": "",
}  # fmt: skip


@pytest.mark.parametrize("what", [*SYSTEMS, "bytes", "bytes in a name", "nul"])
def test_coordinate_systems_of_rasters(what, tmp_path, capsys):
    pytest.importorskip("rasterio", reason="the extra [geo] is not installed")
    (tmp_path / "d.asc").write_text(
        "ncols 8\nnrows 8\nxllcorner 648500\nyllcorner 5317500\ncellsize 500\n" + ("400 " * 8 + "\n") * 8
    )
    wkt = SYSTEMS.get(what, WKT).encode()
    more = {"bytes": b"\x8c\xff" + wkt, "bytes in a name": wkt.replace(b"zone", b"z\xf6ne"), "nul": wkt + b"\0x"}
    (tmp_path / "d.prj").write_bytes(more.get(what, wkt))
    (tmp_path / "f.geojson").write_text(
        '{"type":"Polygon","coordinates":[[[11.0,48.0],[11.002,48.0],[11.002,48.001],[11.0,48.001],[11.0,48.0]]]}'
    )
    words = ["plan", "mission", str(tmp_path / "f.geojson"), "--vehicle", "mavic-3e", "--gsd", "0.02"]
    status = main([*words, "--dem", str(tmp_path / "d.asc"), "--out", str(tmp_path / "m")])
    assert status in {0, 2, 3, 4}, capsys.readouterr().err
    assert "internal error" not in capsys.readouterr().err


@pytest.mark.parametrize("shape", [(), (1,), (4,), (2, 3), (0,), (0, 0), (1, 1, 1, 1, 1), (2, 2, 0)])
def test_arrays_of_other_shapes_beside_heights(shape, tmp_path):
    pytest.importorskip("rasterio", reason="the extra [geo] is not installed")
    folder = HOSTILE / "heights-npz"
    if not folder.is_dir():
        pytest.skip("no public data: set RAYBUNDLE_DATA")
    for path in folder.iterdir():
        (tmp_path / path.name).write_bytes(path.read_bytes())
    with np.load(folder / "heights_orientation.npz") as kept:
        arrays = dict(kept)
    for name, values in arrays.items():
        np.savez(tmp_path / "heights_orientation.npz", **{**arrays, name: np.zeros(shape, values.dtype)})
        with pytest.raises(InputError):
            read_height_model(tmp_path)


@pytest.mark.parametrize(
    "words",
    [
        ("mark", "list", "journal-null/block"), ("heights", "volume", "heights-npz"),
        ("datasets", "list", "--listing", "datasets-ipv6/d.toml"),
        ("datasets", "list", "--listing", "datasets-ipv6-b/d.toml"),
        ("plan", "mission", "area-kmz-name/a.kmz", "--vehicle", "mavic-3e", "--gsd", "0.02", "--out", "OUT"),
        ("plan", "mission", "mission-wpml-zlib/a.kmz", "--vehicle", "mavic-3e", "--gsd", "0.02", "--out", "OUT"),
    ],
    ids=lambda w: w[2],
)  # fmt: skip
def test_inputs_that_ended_in_internal_errors(words, tmp_path, capsys):
    if not HOSTILE.is_dir():
        pytest.skip("no public data: set RAYBUNDLE_DATA")
    places = [str(HOSTILE / w) if (HOSTILE / w).exists() else w.replace("OUT", str(tmp_path / "out")) for w in words]
    assert main(places) == 2
    assert "internal error" not in capsys.readouterr().err
