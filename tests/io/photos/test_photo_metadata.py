"""EXIF and XMP: 64 files with expected values, tags of our own, and rubbish."""

import csv
import math
import struct
from datetime import UTC, datetime

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.conftest import DATA

from raybundle.errors import InputError
from raybundle.io.photos.exif import read_tags
from raybundle.io.photos.photo import read_photo
from raybundle.io.photos.read_metadata import read_metadata
from raybundle.io.photos.xmp import read_xmp

EXIF = DATA / "calibration/exif"


def tiff(*directories, order="<"):
    """A TIFF structure: each directory a list of (tag, type, count, value); the caller links them."""
    out = bytearray((b"II*\0" if order == "<" else b"MM\0*") + struct.pack(order + "I", 8))
    offset = 8
    for entries in directories:
        body = struct.pack(order + "H", len(entries))
        tail = b""
        start_of_tail = offset + 2 + 12 * len(entries) + 4
        for tag, kind, count, raw in entries:
            value = raw.ljust(4, b"\0")
            if len(raw) > 4:
                value = struct.pack(order + "I", start_of_tail + len(tail))
                tail += raw
            body += struct.pack(order + "HHI", tag, kind, count) + value
        out += body + b"\0\0\0\0" + tail
        offset = len(out)
    return bytes(out)


def rational(*pairs, order="<"):
    return b"".join(struct.pack(order + "II", *p) for p in pairs)


def text(value):
    raw = value.encode() + b"\0"
    return 2, len(raw), raw


# ---- the files with expected values


# the readers of the table look for no lens in XMP and for no EXIF entry in the main directory
BEYOND_THE_TABLE = [
    ("jpg__Nikon_D70.jpg", "LensModel", "", "100.0 mm f/2.8"),
    ("jpg__tests__11-tests.jpg", "DigitalZoomRatio", "", 1.0),
]
NUMBERS = {
    "FocalLength": lambda m: m.focal_mm,
    "FocalLengthIn35mmFilm": lambda m: m.focal35_mm,
    "ExifImageWidth": lambda m: m.exif_width,
    "ExifImageHeight": lambda m: m.exif_height,
    "DigitalZoomRatio": lambda m: m.zoom_ratio,
    "SubjectDistance": lambda m: m.subject_distance_m,
    "GPSLatitude": lambda m: m.gps and m.gps.latitude_deg,
    "GPSLongitude": lambda m: m.gps and m.gps.longitude_deg,
    "GPSAltitude": lambda m: m.gps and m.gps.altitude_m,
}


def expected_number(name, cell):
    """None for empty, 0 and x/0; a position without a fix is written as 0, 0."""
    if not cell or "/" in cell or cell in {"inf", "nan"}:
        return None
    value = float(cell)
    if name.startswith("GPS"):
        return value
    return value if value > 0 and not (name == "SubjectDistance" and value > 4e6) else None


def rows():
    if not (EXIF / "expected.csv").exists():
        return []
    with (EXIF / "expected.csv").open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def read_all():
    if not rows():
        pytest.skip("no public data: set RAYBUNDLE_DATA to the folder that holds calibration/exif")
    pytest.importorskip("pi_heif", reason="needs the extra raybundle[heic]")
    result = {}
    for row in rows():
        try:
            result[row["file"]] = read_photo(EXIF / "files" / row["file"])
        except InputError:
            result[row["file"]] = None
    return result


def test_every_file_but_one_is_read(read_all):
    assert len(read_all) == 64
    assert [name for name, photo in read_all.items() if photo is None] == ["jpg__invalid__image01980.jpg"]  # 25 px high


def test_all_expected_values_agree(read_all):
    compared, wrong = 0, []
    for row in rows():
        photo = read_all[row["file"]]
        if photo is None:
            continue
        m = photo.metadata
        found = {name: get(m) for name, get in NUMBERS.items()}
        for name, value in found.items():
            expected = expected_number(name, row[name])
            compared += expected is not None
            same = (
                value is None if expected is None else value is not None and math.isclose(value, expected, rel_tol=1e-6)
            )
            if not same:
                wrong.append((row["file"], name, row[name], value))
        for name, value in (("Make", m.make), ("Model", m.model), ("LensModel", m.lens)):
            compared += bool(row[name].strip())
            if value != " ".join(row[name].split()):
                wrong.append((row["file"], name, row[name], value))
        if photo.kind != "heic":
            size = photo.width_px, photo.height_px
            compared += 2
            if size != (int(row["width"]), int(row["height"])):
                wrong.append((row["file"], "size", row["width"], size))
            if photo.orientation != int(row["Orientation"] or 1):
                wrong.append((row["file"], "Orientation", row["Orientation"], photo.orientation))
        unit = {"2": 25.4, "3": 10.0, "": 25.4}[row["FocalPlaneResolutionUnit"]]
        expected = expected_number("", row["FocalPlaneXResolution"])
        plane = m.focal_plane_px_per_mm
        compared += expected is not None
        if (plane is None) != (expected is None) or (
            plane and not math.isclose(plane[0] * unit, expected, rel_tol=1e-6)
        ):
            wrong.append((row["file"], "FocalPlaneXResolution", row["FocalPlaneXResolution"], plane))
    assert wrong == BEYOND_THE_TABLE
    assert compared >= 378


# ---- tags of our own


def test_a_phone_photo_with_position_time_zone_and_error():
    entries = [
        (0x010F, *text("Maker")),
        (0x0110, *text("Phone 1")),
        (0x0112, 3, 1, struct.pack("<H", 6)),
    ]
    main = [*entries, (0x8769, 4, 1, b""), (0x8825, 4, 1, b"")]
    exif = [
        (0x9003, *text("2026:03:05 14:30:15")),
        (0x9291, *text("25")),
        (0x9011, *text("+02:00")),
        (0x920A, 5, 1, rational((425, 100))),
        (0xA405, 3, 1, struct.pack("<H", 26)),
    ]
    gps = [
        (1, *text("S")),
        (2, 5, 3, rational((33, 1), (30, 1), (36, 1))),
        (3, *text("E")),
        (4, 5, 3, rational((151, 1), (15, 1), (0, 1))),
        (5, 1, 1, b"\1"),
        (6, 5, 1, rational((25, 10))),
        (31, 5, 1, rational((303, 100))),
    ]
    first = len(tiff(main))
    second = len(tiff(main, exif))
    main[3:] = [(0x8769, 4, 1, struct.pack("<I", first)), (0x8825, 4, 1, struct.pack("<I", second))]
    m, orientation = read_metadata(tiff(main, exif, gps), None)
    assert orientation == 6
    assert (m.make, m.model, m.focal_mm, m.focal35_mm) == ("Maker", "Phone 1", 4.25, 26)
    assert m.taken.astimezone(UTC) == datetime(2026, 3, 5, 12, 30, 15, 250000, tzinfo=UTC)
    assert m.gps.latitude_deg == pytest.approx(-33.51)
    assert m.gps.longitude_deg == pytest.approx(151.25)
    assert m.gps.altitude_m == -2.5
    assert m.gps.sigma_m[:2] == pytest.approx((2.0, 2.0))
    assert math.isnan(m.gps.sigma_m[2])
    assert m.remarks == ()


@pytest.mark.parametrize("order", ["<", ">"])
def test_zero_and_x_by_zero_are_not_known(order):
    entries = [
        (0x920A, 5, 1, rational((0, 1), order=order)),
        (0x9206, 5, 1, rational((7, 0), order=order)),
        (0xA20E, 5, 1, rational((4000, 0), order=order)),
        (0xA405, 3, 1, struct.pack(order + "H", 0)),
    ]
    m, _ = read_metadata(tiff(entries, order=order), None)
    assert (m.focal_mm, m.subject_distance_m, m.focal_plane_px_per_mm, m.focal35_mm) == (None,) * 4


def test_directories_that_point_at_each_other_end():
    loop = tiff([(0x8769, 4, 1, struct.pack("<I", 8)), (0x8825, 4, 1, struct.pack("<I", 8))])
    m, _ = read_metadata(loop, None)
    assert "read already" in " ".join(m.remarks)


def test_a_count_beyond_the_data_is_damage_and_the_rest_is_read():
    m, _ = read_metadata(tiff([(0x010F, 2, 0xFFFFFFFF, b"abc"), (0x0110, *text("Body"))]), None)
    assert m.model == "Body"
    assert "1 of 2 entries" in m.remarks[0]


DJI = b"""<?xpacket begin="" id="W5M0MpCehiHzreSzNTczkc9d"?><x:xmpmeta xmlns:x="adobe:ns:meta/">
<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"><rdf:Description rdf:about="DJI Meta Data"
 xmlns:drone-dji="http://www.dji.com/drone-dji/1.0/" xmlns:tiff="http://ns.adobe.com/tiff/1.0/"
 drone-dji:GpsLatitude="+47.123456789" drone-dji:GpsLongtitude="+8.987654321" drone-dji:AbsoluteAltitude="+512.345"
 drone-dji:AltitudeType="RtkAlt" drone-dji:RtkFlag="50" drone-dji:RtkStdLon="0.01021" drone-dji:RtkStdLat="0.00986"
 drone-dji:RtkStdHgt="0.02345" drone-dji:GimbalYawDegree="-12.50" drone-dji:GimbalPitchDegree="-89.90"
 drone-dji:GimbalRollDegree="+0.00" drone-dji:FlightYawDegree="-13.1" drone-dji:FlightPitchDegree="1.5"
 drone-dji:FlightRollDegree="-0.5" drone-dji:DewarpData="2024-01-31;3650.1,3651.2,-10.5,4.2,-0.27,0.11,0.0001,0,-0.03">
<tiff:Make>DJI</tiff:Make><tiff:Model><rdf:Seq><rdf:li>FC6310R</rdf:li></rdf:Seq></tiff:Model>
</rdf:Description></rdf:RDF></x:xmpmeta><?xpacket end="w"?>"""


def test_dji_xmp_gives_rtk_sigmas_fix_and_attitude():
    m, _ = read_metadata(None, DJI)
    assert (m.make, m.model) == ("DJI", "FC6310R")
    assert (m.gps.latitude_deg, m.gps.longitude_deg, m.gps.altitude_m) == (47.123456789, 8.987654321, 512.345)
    assert m.gps.altitude_reference == "ellipsoid"
    assert m.gps.fix == "rtk fixed"
    assert m.gps.sigma_m == (0.01021, 0.00986, 0.02345)
    assert m.gimbal == (-12.5, -89.9, 0)
    assert m.flight == (-13.1, 1.5, -0.5)


@pytest.mark.parametrize(
    "declaration",
    [b'<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;">]>', b'<!DOCTYPE x SYSTEM "file:///etc/passwd">'],
)
def test_xmp_with_a_document_type_is_refused(declaration):
    entries, remarks = read_xmp(declaration + DJI.partition(b"?>")[2])
    assert entries == {}
    assert "not allowed" in remarks[0]


def test_xmp_cut_short_keeps_what_was_read():
    entries, remarks = read_xmp(DJI[: DJI.index(b"<tiff:Make>")])
    assert entries["drone-dji:RtkFlag"] == "50"
    assert len(remarks) == 1


@settings(max_examples=200, deadline=None)
@given(st.binary(max_size=300), st.booleans())
def test_no_bytes_make_the_readers_fail(data, header):
    read_metadata((b"II*\0\x08\0\0\0" if header else b"") + data, data)
    read_tags(data)


@settings(max_examples=200, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 400), st.integers(0, 255)), max_size=8))
def test_no_change_of_some_bytes_makes_the_readers_fail(changes):
    exif = bytearray(tiff([(0x010F, *text("Maker")), (0x8769, 4, 1, b"\x60"), (0x920A, 5, 1, rational((5, 1)))], []))
    xmp = bytearray(DJI)
    for at, value in changes:
        exif[at % len(exif)] = value
        xmp[at * 7 % len(xmp)] = value
    m, orientation = read_metadata(bytes(exif), bytes(xmp))
    assert 1 <= orientation <= 8
    assert m.focal_mm is None or m.focal_mm > 0


def test_text_where_numbers_are_due_is_told():
    """What an aircraft wrote and cannot be used is named; a photograph is no worse off than without it."""
    packet = (
        '<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">'
        '<rdf:Description xmlns:drone-dji="http://www.dji.com/drone-dji/1.0/" drone-dji:GpsLatitude="north" '
        'drone-dji:GpsLongitude="11.5" drone-dji:RtkStdLat="nan" drone-dji:GimbalYawDegree="+12.5"/>'
        "</rdf:RDF></x:xmpmeta>"
    )
    metadata, _ = read_metadata(None, packet.encode())
    assert metadata.gps is None
    assert {(r.message.code, r.message.values["entry"], r.message.values["value"]) for r in metadata.remarks} == {
        ("photo_entry.xmp_no_number", "drone-dji:GpsLatitude", "'north'"),
        ("photo_entry.xmp_no_number", "drone-dji:RtkStdLat", "'nan'"),
    }
