"""Position of a photograph from EXIF and XMP: what is taken, and what is left out with a remark."""

import math

import pytest
from tests.conftest import DATA

from raybundle.io.photos.exif import Tags
from raybundle.io.photos.photo import find_photos
from raybundle.io.photos.read_metadata import read_metadata
from raybundle.io.photos.recorded_position import recorded_position

NAN = math.nan
REPORTS = DATA / "reports"


def exif(latitude, longitude, north="N", east="E", **more):
    """A GPS directory; a reference that is None is missing."""
    gps = {2: tuple(map(float, latitude)), 4: tuple(map(float, longitude)), **more.get("tags", {})}
    gps |= {tag: letter for tag, letter in ((1, north), (3, east)) if letter is not None}
    return Tags(gps=gps)


def dji(latitude, longitude, prefix="Gps"):
    return {f"drone-dji:{prefix}Latitude": latitude, f"drone-dji:{prefix}Longitude": longitude}


def copy(latitude, longitude):
    return {"exif:GPSLatitude": latitude, "exif:GPSLongitude": longitude}


HERE = ((47, 30, 0), (8, 15, 0))
FINE = ((47, 30, 0.3553), (8, 15, 0.3154))
ZERO = ((0, 0, 0), (0, 0, 0))

USED = {
    # receivers without a fix
    "EXIF 0, 0 beside XMP": (exif(*ZERO), dji("+47.5000000", "+8.2500000"), (47.5, 8.25), "no fix"),
    "XMP 0, 0 beside EXIF": (exif(*FINE), dji("0.0000000", "0.0000000"), (47.5000987, 8.2500876), "no fix"),
    "XMP 1e-8 beside EXIF": (exif(*FINE), dji("1e-8", "-1e-8"), (47.5000987, 8.2500876), "no fix"),
    "on the equator": (exif((0, 0, 0), (8, 15, 0)), {}, (0.0, 8.25), ""),
    "on the meridian of Greenwich": (exif((51, 28, 40.1), (0, 0, 0)), {}, (51.47780556, 0.0), ""),
    # names in XMP, digits
    "Latitude, Longitude of XMP": (exif(*HERE), dji("47.5000987", "8.2500876", ""), (47.5000987, 8.2500876), ""),
    "XMP alone": (Tags(), dji("47.5000987", "8.2500876", ""), (47.5000987, 8.2500876), ""),
    "finer EXIF": (exif(*FINE), dji("47.5001", "8.2501"), (47.5000987, 8.2500876), ""),
    "misspelt longitude": (
        exif(*HERE), {"drone-dji:GpsLatitude": "47.5000987", "drone-dji:GpsLongtitude": "8.2500876"},
        (47.5000987, 8.2500876), "",
    ),
    "copy in XMP": (Tags(), copy("47,30.5N", "8,15.25W"), (47.5083333, -8.2541667), "rounded"),
    "copy in XMP, seconds": (Tags(), copy("33,30,36S", "151,15,0E"), (-33.51, 151.25), ""),
    # parts that are not known
    "seconds 0/0": (exif((47, 30, NAN), (8, 15, NAN)), {}, (47.5, 8.25), "rounded to"),
    "seconds 0/0, decimals": (exif((47, 30.0059, NAN), (8, 15.0053, NAN)), {}, (47.5000983, 8.2500883), ""),
    "decimal degrees": (exif((47.5000987, NAN, NAN), (8.2500876, NAN, NAN)), {}, (47.5000987, 8.2500876), ""),
    "decimal degrees and zeros": (exif((47.5000987, 0, 0), (8.2500876, 0, 0)), {}, (47.5000987, 8.2500876), ""),
    "one number": (exif((47.5000987,), (8.2500876,)), {}, (47.5000987, 8.2500876), ""),
    "degrees x/0": (exif((NAN, 30, 0), (8, 15, 0)), dji("47.5", "8.25"), (47.5, 8.25), "x/0"),
    # hemispheres
    "south and west": (exif(*HERE, "S", "W"), {}, (-47.5, -8.25), ""),
    "words": (exif(*HERE, "South", "west"), {}, (-47.5, -8.25), ""),
    "signed degrees": (exif((-47.5, 0, 0), (-8.25, 0, 0), None, None), {}, (-47.5, -8.25), "rounded"),
    "hemisphere of XMP": (exif(*FINE, None, None), dji("-47.5001", "-8.2501"), (-47.5000987, -8.2500876), ""),
    # disagreement
    "two metres": (exif(*FINE), dji("47.5001187", "8.2500876"), (47.5000987, 8.2500876), "positions differ"),
    "a copy of EXIF is no second witness": (
        exif((48, 1, 0), (8, 15, 0)), dji("47.5000987", "8.2500876") | copy("47,30N", "8,15E"), None, "contradict",
    ),
    "across the date line": (exif((10, 0, 0), (179, 59, 59.99)), dji("10.0000", "-179.9999"), (10.0, -179.9999), ""),
    "datum": (exif(*FINE, tags={18: "TOKYO"}), {}, (47.5000987, 8.2500876), "'TOKYO'"),
    "datum WGS 84": (exif(*FINE, tags={18: "WGS-84"}), {}, (47.5000987, 8.2500876), ""),
}  # fmt: skip

NONE = {
    "no reference": (exif(*HERE, None, None), {}, "without hemisphere is not used, GPSLatitudeRef and GPSLongitudeRef"),
    "no latitude reference": (exif(*HERE, None, "E"), {}, "GPSLatitudeRef missing"),
    "blank reference": (exif(*HERE, "N", " "), {}, "GPSLongitudeRef missing"),
    "exchanged references": (exif(*HERE, "E", "N"), {}, "GPSLatitudeRef and GPSLongitudeRef missing"),
    "no reference, contradiction": (exif(*HERE, None, None), dji("0", "0"), "without hemisphere"),
    "south of the equator, signed north": (exif((-47.5, 0, 0), (8.25, 0, 0)), {}, "contradicts the reference N"),
    "59 km": (exif((48, 1, 46.0), (8, 15, 0.0)), dji("47.5000987", "8.2500876"), "none is used"),
    "other side": (exif(*FINE, "S", "E"), dji("47.5000987", "8.2500876"), "none is used"),
    "0, 0": (exif(*ZERO), {}, "no fix"),
    "minutes above 60": (exif((47, 75, 0), (8, 15, 0)), {}, "not within 0 to 60"),
    "decimals twice": (exif((47.5, 30, 0), (8.25, 15, 0)), {}, "a part with decimals"),
    "beyond the pole": (exif((97, 30, 0), (8, 15, 0)), {}, "beyond 90"),
    "latitude and longitude exchanged": (Tags(), dji("151.25", "-33.51"), "no place on the earth"),
    "half of XMP": (Tags(), {"drone-dji:GpsLatitude": "47.5"}, "its longitude is missing"),
    "four numbers": (exif((47, 30, 0, 0), (8, 15, 0)), {}, "4 numbers"),
}


@pytest.mark.parametrize("name", USED)
def test_the_position_that_is_used(name):
    tags, entries, right, remark = USED[name]
    found, remarks = recorded_position(tags, entries)
    if right is None:
        assert found is None
    else:
        assert found.angles == pytest.approx(right, abs=1.5e-7)
    assert any(remark in r for r in remarks) if remark else not remarks


@pytest.mark.parametrize("name", NONE)
def test_no_position_and_the_reason(name):
    tags, entries, remark = NONE[name]
    found, remarks = recorded_position(tags, entries)
    assert found is None
    assert any(remark in r for r in remarks)


def test_a_rounded_position_has_the_standard_deviation_of_its_rounding():
    found, _ = recorded_position(exif((47, 30, NAN), (8, 15, NAN)), {})
    assert found.rounding_m == pytest.approx((362, 536), abs=1)  # a minute is 1 855 m; a uniform one over 12


def test_nothing_is_nothing():
    assert recorded_position(Tags(), {}) == (None, ())
    assert read_metadata(None, None)[0].gps is None


@pytest.mark.skipif(not REPORTS.is_dir(), reason="no public data: set RAYBUNDLE_DATA to the folder of reports/")
@pytest.mark.parametrize(
    ("name", "right", "remark"),
    [
        ("xmp-position-dropped/zero-exif.jpg", (47.5, 8.25), "no fix"),
        ("xmp-position-dropped/latitude-attr.jpg", (47.5000987, 8.2500876), ""),
        ("xmp-position-dropped/seconds-0-0.jpg", (47.5, 8.25), "rounded"),
        ("gps-reference-missing/a.jpg", None, "hemisphere"),
    ],
)
def test_reported_photographs(name, right, remark):
    found = find_photos([REPORTS / name])
    gps = found.photos[0].metadata.gps
    assert right is None if gps is None else (gps.latitude_deg, gps.longitude_deg) == pytest.approx(right)
    assert any(remark in r for r in found.remarks) if remark else not found.remarks
