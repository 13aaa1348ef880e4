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
    "two metres": (exif(*FINE), dji("47.5001187", "8.2500876"), (47.5000987, 8.2500876), "positions_differ"),
    "a copy of EXIF is no second witness": (
        exif((48, 1, 0), (8, 15, 0)), dji("47.5000987", "8.2500876") | copy("47,30N", "8,15E"), None, "contradict",
    ),
    "across the date line": (exif((10, 0, 0), (179, 59, 59.99)), dji("10.0000", "-179.9999"), (10.0, -179.9999), ""),
    "datum Tokyo": (exif((35, 42, 0), (139, 42, 0), tags={18: "TOKYO"}), {}, (35.7032350, 139.6967710), "moved by 46"),
    "datum of the Earth's centre": (exif(*FINE, tags={18: "ETRS89"}), {}, (47.5000987, 8.2500876), "moved by 0 m"),
    "datum of an acronym": (exif(*FINE, tags={18: "CGCS2000"}), {}, (47.5000987, 8.2500876), "EPSG:4490"),
    "datum ED50 beside XMP": (
        exif((47, 30, 3.7), (8, 15, 4.3), tags={18: "ED-50"}), dji("47.50008", "8.25003"), (47.50008, 8.25003), "ED-50",
    ),
    "datum in XMP": (Tags(), copy("35,42,0.00N", "139,42,0.00E") | {"exif:GPSMapDatum": "Tokyo"},
        (35.7032350, 139.6967710), "moved by 46"),
    "datum blank": (exif(*FINE, tags={18: "  "}), {}, (47.5000987, 8.2500876), ""),
    "datum unknown, XMP": (exif(*FINE, tags={18: "BESSEL"}), dji("47.5", "8.25"), (47.5, 8.25), "no transformation"),
    "void, XMP": (exif((48, 1, 0), (8, 15, 0), tags={9: "V"}), dji("47.5", "8.25"), (47.5, 8.25), "GPSStatus V"),
    "active": (exif(*FINE, tags={9: "A", 10: "3"}), {}, (47.5000987, 8.2500876), ""),
    "datum WGS 84": (exif(*FINE, tags={18: "WGS-84"}), {}, (47.5000987, 8.2500876), ""),
}  # fmt: skip

NONE = {
    "no reference": (exif(*HERE, None, None), {}, "no_hemisphere: EXIF GPSLatitudeRef, GPSLongitudeRef"),
    "no latitude reference": (exif(*HERE, None, "E"), {}, "GPSLatitudeRef missing"),
    "blank reference": (exif(*HERE, "N", " "), {}, "GPSLongitudeRef missing"),
    "exchanged references": (exif(*HERE, "E", "N"), {}, "no_hemisphere: EXIF GPSLatitudeRef, GPSLongitudeRef"),
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
    "datum unknown": (exif(*FINE, tags={18: "Datum of my own"}), {}, "no transformation from GPSMapDatum"),
    "datum alike": (exif(*FINE, tags={18: "Pulkovo"}), {}, "no transformation from GPSMapDatum Pulkovo"),
    "datum that is a system": (exif(*FINE, tags={18: "+proj=longlat +ellps=bessel"}), {}, "no transformation"),
    "void": (exif(*FINE, tags={9: "V"}), {}, "EXIF position is not used: GPSStatus V"),
    "void in XMP": (Tags(), copy("47,30.5N", "8,15.25E") | {"exif:GPSStatus": "V"}, "GPSStatus V"),
    "four numbers": (exif((47, 30, 0, 0), (8, 15, 0)), {}, "4 numbers"),
}


def shown(remark):
    """A remark with its codes and their values."""
    found = [f"{m.code.partition('.')[2]}: {' '.join(map(value, m.values.values()))}" for m in remark.messages]
    return f"{remark} [{'; '.join(found)}]"


def value(v):
    return ", ".join(v) if isinstance(v, list) else f"{v:g}" if isinstance(v, float) else str(v)


@pytest.mark.parametrize("name", USED)
def test_the_position_that_is_used(name):
    tags, entries, right, remark = USED[name]
    found, remarks = recorded_position(tags, entries)
    if right is None:
        assert found is None
    else:
        assert found.angles == pytest.approx(right, abs=1.5e-7)
    assert any(remark in shown(r) for r in remarks) if remark else not remarks


@pytest.mark.parametrize("name", NONE)
def test_no_position_and_the_reason(name):
    tags, entries, remark = NONE[name]
    found, remarks = recorded_position(tags, entries)
    assert found is None
    assert any(remark in shown(r) for r in remarks)


def height(metres, reference=0.0, **tags):
    return exif(*FINE, tags={6: (metres,), 5: (reference,)} | {int(k[1:]): v for k, v in tags.items()})


def of_dji(metres, kind=""):
    return {"drone-dji:AbsoluteAltitude": metres} | ({"drone-dji:AltitudeType": kind} if kind else {})


def of_copy(metres, reference="0", **more):
    return {"exif:GPSAltitude": metres, "exif:GPSAltitudeRef": reference} | more


SEA, ABOVE = "sea level", "ellipsoid"
HEIGHTS = {
    "EXIF": (height(123.45), {}, (123.45, SEA), ""),
    "below the sea": (height(12.0, 1.0), {}, (-12.0, SEA), ""),
    "above the ellipsoid": (height(123.45, 2.0), {}, (123.45, ABOVE), ""),
    "the same": (height(123.45), of_dji("+123.45"), (123.45, SEA), ""),
    "the same, rounded": (height(123.0), of_dji("+123.45"), (123.45, SEA), ""),
    "the same, RTK": (height(123.45), of_dji("+123.45", "RtkAlt"), (123.45, ABOVE), ""),
    "a geoid between": (height(123.45, 2.0), of_dji("+76.20"), (76.2, SEA), ""),
    "a geoid between, RTK": (height(76.2), of_dji("+123.45", "RtkAlt"), (123.45, ABOVE), ""),
    "800 m": (height(123.45), of_dji("+923.45"), (None, ""), "altitudes_contradict"),
    "800 m, a geoid between": (height(123.45, 2.0), of_dji("+923.45"), (None, ""), "altitudes_contradict"),
    "12 m": (height(123.45), of_dji("+135.45"), (135.45, SEA), "altitudes_differ: XMP"),
    "no fix in EXIF": (height(0.0), of_dji("+123.45"), (123.45, SEA), ""),
    "no fix in XMP": (height(123.45), of_dji("+0.00"), (123.45, SEA), ""),
    "sea level": (height(0.0), {}, (0.0, SEA), ""),
    "XMP copy": (exif(*FINE), of_copy("12345/100"), (123.45, SEA), ""),
    "XMP copy below the sea": (exif(*FINE), of_copy("12345/100", "1"), (-123.45, SEA), ""),
    "XMP copy, no fraction": (exif(*FINE), of_copy("123.45"), (123.45, SEA), ""),
    "XMP copy, x/0": (exif(*FINE), of_copy("12345/0"), (None, ""), ""),
    "a copy is no second witness": (height(123.45), of_copy("500/1"), (123.45, SEA), ""),
    "in plan alone": (height(123.45, t10="2"), {}, (None, ""), "GPSMeasureMode 2"),
    "in plan alone, XMP copy": (exif(*FINE), of_copy("99/1", **{"exif:GPSMeasureMode": "2"}), (None, ""), "Mode 2"),
    "in plan alone, a barometer": (height(123.45, t10="2"), of_dji("+130.00"), (130.0, SEA), "GPSMeasureMode 2"),
    "in space": (height(123.45, t10="3"), {}, (123.45, SEA), ""),
    "weak": (height(123.45, t11=(25.0,)), {}, (123.45, SEA), "dop: 25 10"),
    "weak, with a sigma": (height(123.45, t11=(25.0,), t31=(1.5,)), {}, (123.45, SEA), ""),
    "usual": (height(123.45, t11=(2.5,)), {}, (123.45, SEA), ""),
}


@pytest.mark.parametrize("name", HEIGHTS)
def test_the_altitude_that_is_used(name, monkeypatch):
    tags, entries, right, remark = HEIGHTS[name]
    monkeypatch.setattr("raybundle.io.photos.read_metadata.read_tags", lambda _: tags)
    monkeypatch.setattr("raybundle.io.photos.read_metadata.read_xmp", lambda _: (entries, ()))
    found = read_metadata(b"EXIF", b"XMP")[0]
    assert (found.gps.altitude_m, found.gps.altitude_reference) == right
    assert any(remark in shown(r) for r in found.remarks) if remark else not found.remarks


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
    assert any(remark in shown(r) for r in found.remarks) if remark else not found.remarks
