"""Every format holds every pattern, read back to 1e-6, and opened by readers that were not written here."""

import json
import math
import zipfile
from dataclasses import replace
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from tests.missions.cases import CRS, LEVEL, mission

from raybundle.errors import InputError
from raybundle.io.missions import mission_formats, routes_of
from raybundle.io.missions.areas import in_crs, read_shapes
from raybundle.io.missions.mission_file import read_mission, write_mission
from raybundle.missions.mission import Trigger, exposures
from raybundle.missions.patterns import patterns

COLUMNS = ("height", "pitch_deg", "speed", "base")


@pytest.fixture(scope="module", params=list(patterns))
def planned(request):
    return mission(request.param)


@pytest.mark.parametrize("by", ["distance", "interval"])
@pytest.mark.parametrize("form", mission_formats)
def test_a_plan_reads_back(planned, form, by, tmp_path):
    (route,) = routes_of(replace(planned, trigger_by=by))
    entry = mission_formats[form]
    path = tmp_path / f"plan{entry.suffix}"
    entry.write(route, path)
    back = entry.read(path)
    np.testing.assert_allclose(back.latitude_deg, route.latitude_deg, atol=1e-9)  # 0.1 mm
    np.testing.assert_allclose(back.longitude_deg, route.longitude_deg, atol=1e-9)
    for name in COLUMNS:
        np.testing.assert_allclose(getattr(back, name), getattr(route, name), atol=1e-6, err_msg=name)
    turn = (back.heading_deg - route.heading_deg + 180) % 360 - 180
    assert np.abs(turn).max() <= max(1e-6, entry.heading_step_deg / 2 + 1e-6)
    assert (back.trigger == route.trigger).all()
    if form != "kml" and (route.trigger == Trigger.START).any():
        assert back.trigger_by == by
    if form != "litchi":
        np.testing.assert_allclose(back.home[:2], route.home[:2], atol=1e-9)


def test_a_mission_file_loses_nothing(planned, tmp_path):
    write_mission(planned, tmp_path / "mission.toml")
    back = read_mission(tmp_path)
    for name in ("xyz", "speed", "trigger", "base", "line", "flight"):
        np.testing.assert_array_equal(getattr(back.way_points, name), getattr(planned.way_points, name))
    np.testing.assert_allclose(back.way_points.heading, planned.way_points.heading, atol=1e-14)
    np.testing.assert_allclose(back.way_points.pitch, planned.way_points.pitch, atol=1e-14)
    np.testing.assert_array_equal(back.outline, planned.outline)
    for name in (
        "camera",
        "vehicle",
        "lines",
        "take_off",
        "crs",
        "gsd",
        "overlap",
        "base",
        "spacing",
        "remarks",
        "closed",
    ):
        assert getattr(back, name) == getattr(planned, name)
    np.testing.assert_array_equal(exposures(back).xyz, exposures(planned).xyz)


def test_headings_are_turned_to_true_north():
    """Two degrees of longitude west of the meridian grid north lies east of true north by 1.5 degrees at 50 deg."""
    m = mission("nadir", more={"direction": 0.0})
    (route,) = routes_of(m)
    on = route.trigger == Trigger.START
    lonlat = in_crs(m.way_points.xyz[:, :2], CRS, "EPSG:4326")
    expected = math.degrees(math.atan(math.tan(math.radians(lonlat[0, 0] - 9)) * math.sin(math.radians(lonlat[0, 1]))))
    true = (route.heading_deg[on] + 90) % 180 - 90
    np.testing.assert_allclose(true, expected, atol=0.01)
    assert abs(expected) > 1


def test_heights_count_from_the_take_off():
    m = mission("nadir", ground=lambda xy: np.full(len(xy), 812.5))
    (route,) = routes_of(m)
    assert route.home[2] == 812.5
    assert route.height.max() == pytest.approx(3751 * 0.02, rel=0.01)
    with pytest.raises(InputError, match=r"mission\.no_crs"):
        routes_of(replace(m, crs=""))


def written(form, tmp_path, pattern="nadir", by="distance"):
    (route,) = routes_of(mission(pattern, trigger_by=by), LEVEL)
    path = tmp_path / f"plan{mission_formats[form].suffix}"
    mission_formats[form].write(route, path)
    return route, path


@pytest.mark.parametrize("pattern", patterns)
def test_mavlink_s_own_loader_reads_wpl(pattern, tmp_path):
    mavwp = pytest.importorskip("pymavlink.mavwp")
    route, path = written("wpl", tmp_path, pattern)
    loader = mavwp.MAVWPLoader()
    count = loader.load(str(path))
    items = [loader.wp(k) for k in range(count)]
    places = [i for i in items[1:] if i.command == 16]
    np.testing.assert_allclose([i.x for i in places], route.latitude_deg, atol=1e-6)
    np.testing.assert_allclose([i.y for i in places], route.longitude_deg, atol=1e-6)
    np.testing.assert_allclose([i.z for i in places], route.height, atol=1e-4)  # float32 there
    assert {i.frame for i in places} == {3}
    assert items[1].command == 22
    assert items[-1].command == 20
    starts = [i.param1 for i in items if i.command == 206 and i.param1 > 0]
    np.testing.assert_allclose(starts, route.base[route.trigger == Trigger.START], atol=1e-4)
    assert sum(i.command == 2000 for i in items) == (route.trigger == Trigger.HERE).sum()


@pytest.mark.parametrize("pattern", patterns)
def test_kml_is_valid_by_the_schema_of_ogc_and_read_by_gdal(pattern, tmp_path):
    validator = pytest.importorskip("fastkml.validator")
    route, path = written("kml", tmp_path, pattern)
    assert validator.validate(file_to_validate=path)
    raw = pytest.importorskip("pyogrio.raw")
    _, _, geometry, fields = raw.read(path, layer="way points", columns=["height", "pitch_deg"])
    assert len(geometry) == len(route)
    np.testing.assert_allclose([float(v) for v in fields[0]], route.height, atol=1e-6)
    place = np.array([np.frombuffer(g[-24:], "<f8") for g in geometry])
    np.testing.assert_allclose(place[:, :2], np.stack([route.longitude_deg, route.latitude_deg], axis=1), atol=1e-9)
    assert "absolute" in path.read_text()


def test_a_plan_has_what_qgroundcontrol_documents(tmp_path):
    """The keys of its developer guide, "Plan File Format"; no schema is published."""
    route, path = written("qgc", tmp_path)
    plan = json.loads(path.read_text())
    assert plan["fileType"] == "Plan"
    assert plan["version"] == 1
    assert set(plan) == {"fileType", "geoFence", "groundStation", "mission", "rallyPoints", "version"}
    m = plan["mission"]
    assert {
        "cruiseSpeed",
        "firmwareType",
        "hoverSpeed",
        "items",
        "plannedHomePosition",
        "vehicleType",
        "version",
    } <= set(m)
    assert m["version"] == 2
    for k, item in enumerate(m["items"]):
        assert item["type"] == "SimpleItem"
        assert item["doJumpId"] == k + 1
        assert len(item["params"]) == 7
        if item["command"] in {16, 22}:
            assert item["AltitudeMode"] == 1
            assert item["frame"] == 3
    np.testing.assert_allclose(m["plannedHomePosition"][:2], route.home[:2])


WPML, KML = "{http://www.dji.com/wpmz/1.0.2}", "{http://www.opengis.net/kml/2.2}"
CONFIG = {
    "flyToWaylineMode": {"safely", "pointToPoint"},
    "finishAction": {"goHome", "noAction", "autoLand", "gotoFirstWaypoint"},
    "exitOnRCLost": {"goContinue", "executeLostAction"},
    "executeRCLostAction": {"goBack", "landing", "hover"},
    "takeOffSecurityHeight": (2, 1500), "globalTransitionalSpeed": (0, 15), "globalRTHHeight": (2, 1500),
}  # fmt: skip
ACTIONS = {
    "takePhoto": {"payloadPositionIndex", "fileSuffix", "useGlobalPayloadLensIndex"},
    "gimbalRotate": {
        "payloadPositionIndex", "gimbalHeadingYawBase", "gimbalRotateMode",
        *(f"gimbal{axis}Rotate{what}" for axis in ("Pitch", "Roll", "Yaw") for what in ("Enable", "Angle")),
        "gimbalRotateTimeEnable", "gimbalRotateTime",
    },
}  # fmt: skip
"""What DJI's description calls required, with the values that it allows (Cloud API, DJI WPML, waylines.wpml and common
elements)."""


def text(element, name):
    found = element.find(WPML + name)
    assert found is not None, name
    return found.text or ""


@pytest.mark.parametrize("by", ["distance", "interval"])
@pytest.mark.parametrize("pattern", patterns)
def test_wpml_holds_what_dji_requires(pattern, by, tmp_path):
    route, path = written("wpml", tmp_path, pattern, by)
    with zipfile.ZipFile(path) as archive:
        assert sorted(archive.namelist()) == ["wpmz/template.kml", "wpmz/waylines.wpml"]
        roots = [ET.fromstring(archive.read(n)) for n in sorted(archive.namelist())]  # noqa: S314  (written here)
    for root in roots:
        config = root.find(f"{KML}Document/{WPML}missionConfig")
        for name, allowed in CONFIG.items():
            value = text(config, name)
            if isinstance(allowed, set):
                assert value in allowed
            else:
                assert allowed[0] <= float(value) <= allowed[1]
        assert text(config.find(WPML + "droneInfo"), "droneEnumValue") == "77"
        assert text(config.find(WPML + "payloadInfo"), "payloadEnumValue") == "66"
    folder = roots[1].find(f"{KML}Document/{KML}Folder")
    assert text(folder, "executeHeightMode") == "relativeToStartPoint"
    assert 0 < float(text(folder, "autoFlightSpeed")) <= 15
    marks = folder.findall(KML + "Placemark")
    assert [int(text(m, "index")) for m in marks] == list(range(len(route)))
    groups = []
    for mark in marks:
        heading, turn = mark.find(WPML + "waypointHeadingParam"), mark.find(WPML + "waypointTurnParam")
        assert text(heading, "waypointHeadingMode") == "smoothTransition"
        assert -180 <= int(text(heading, "waypointHeadingAngle")) <= 180
        assert text(heading, "waypointHeadingPathMode") == "followBadArc"
        through = text(turn, "waypointTurnMode") == "toPointAndPassWithContinuityCurvature"
        assert (float(text(turn, "waypointTurnDampingDist")) > 0) == through
        assert text(mark, "useStraightLine") == "1"
        assert 0 < float(text(mark, "waypointSpeed")) <= 15
        groups += mark.findall(WPML + "actionGroup")
    assert [int(text(g, "actionGroupId")) for g in groups] == list(range(len(groups)))
    for group in groups:
        first, last = int(text(group, "actionGroupStartIndex")), int(text(group, "actionGroupEndIndex"))
        assert 0 <= first <= last < len(route)
        kind = text(group.find(WPML + "actionTrigger"), "actionTriggerType")
        assert kind in {"reachPoint", "multipleDistance" if by == "distance" else "multipleTiming"}
        for k, action in enumerate(group.findall(WPML + "action")):
            assert int(text(action, "actionId")) == k
            values = {e.tag.removeprefix(WPML) for e in action.find(WPML + "actionActuatorFuncParam")}
            assert ACTIONS[text(action, "actionActuatorFunc")] <= values


def test_equal_plans_are_equal_files(tmp_path):
    for form in mission_formats:
        _, one = written(form, tmp_path)
        first = one.read_bytes()
        assert written(form, tmp_path)[1].read_bytes() == first


def told(read, path):
    """The file that a message names; "" where there is nothing to tell."""
    try:
        read(path)
    except InputError as error:
        return error.file
    return ""


BAD = {
    "qgc": [
        ("{}", r"qgc\.no_plan"),
        ('{"fileType": "Plan", "mission": {"items": [{"type": "ComplexItem"}]}}', r"qgc\.complex_item"),
        ('{"fileType": "Plan", "mission": {"items": [], "plannedHomePosition": [1, 2, 3]}}', r"mission\.no_way_point"),
    ],
    "wpl": [
        ("QGC WPL 100\n", r"wpl\.no_header"),
        ("QGC WPL 110\n0\t1\t0\t16\t0\t0\n", r"6.*12.*value\.count"),
        ("QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t50\t7\tx\t1\n", r"value\.not_finite"),
        ("QGC WPL 110\n0 1 0 16 0 0 0 0 50 7 0 1\n1 0 0 16 0 0 0 0 50 7 9 1\n", r"0.*mission\.height_reference"),
    ],
    "litchi": [
        ("a,b\n1,2\n", r"table\.columns_missing"),
        ("latitude,longitude,altitude(ft),gimbalpitchangle\n", r"litchi\.feet"),
        ("latitude,longitude,altitude(m),gimbalpitchangle,altitudemode\n50,7,10,-90,1\n", r"mission\.height_reference"),
    ],
    "kml": [
        ('<kml xmlns="x"><Document><name>a</name></Document></kml>', r"mission\.no_folder"),
        ("<kml><Document><Folder><Placemark/></Folder></Document></kml>", r"xml\.element_missing"),
    ],
    "wpml": [("PK nothing", r"archive\.not_unpacked")],
}  # fmt: skip


@pytest.mark.parametrize("form", mission_formats)
def test_what_is_no_plan_is_told(form, tmp_path):
    path = tmp_path / f"bad{mission_formats[form].suffix}"
    for content, words in BAD[form]:
        path.write_text(content)
        with pytest.raises(InputError, match=words):
            mission_formats[form].read(path)


@pytest.mark.parametrize("form", mission_formats)
def test_a_damaged_plan_ends_in_a_message(form, tmp_path):
    _, path = written(form, tmp_path, "corridor")
    whole = path.read_bytes()
    rng = np.random.default_rng(5)
    for _ in range(60):
        data = bytearray(whole)
        for at in rng.integers(0, len(data), 3):
            data[at] = rng.integers(0, 256)
        path.write_bytes(bytes(data[: rng.integers(len(data) // 2, len(data) + 1)]))
        assert told(mission_formats[form].read, path) in {"", str(path)}


def test_a_damaged_mission_file_ends_in_a_message(tmp_path):
    path = tmp_path / "mission.toml"
    write_mission(mission("corridor"), path)
    lines = path.read_text().split("\n")
    for k, line in enumerate(lines):
        for other in ("", line.replace("0", "x"), line + "]", line[: len(line) // 2]):
            path.write_text("\n".join([*lines[:k], other, *lines[k + 1 :]]))
            assert told(read_mission, path) in {"", str(path), None}
    path.write_text("name = 1\n")
    with pytest.raises(InputError, match=r"way_points.*mission\.no_table"):
        read_mission(path)


def locked(path, name, method=0):
    """An archive whose member is said to be encrypted, or packed by a method that nobody knows."""
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(name, "<kml/>")
    data = bytearray(path.read_bytes())
    for start, flag, packed in ((data.find(b"PK\x03\x04"), 6, 8), (data.find(b"PK\x01\x02"), 8, 10)):
        data[start + flag] |= 0 if method else 1
        data[start + packed] = method
    path.write_bytes(data)
    return path


@pytest.mark.parametrize("method", [0, 97], ids=["encrypted", "packed otherwise"])
def test_archives_that_cannot_be_unpacked_are_told(tmp_path, method):
    with pytest.raises(InputError, match=r"archive\.not_unpacked"):
        read_shapes(str(locked(tmp_path / "area.kmz", "doc.kml", method)))
    with pytest.raises(InputError, match=r"archive\.not_unpacked"):
        mission_formats["wpml"].read(locked(tmp_path / "flight.kmz", "wpmz/waylines.wpml", method))
