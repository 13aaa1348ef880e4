"""Coordinate systems: known geocentric points, round trips, scale of the grid, heights said plainly."""

import struct

import numpy as np
import pytest
from pyproj import Transformer

from raybundle.errors import InputError
from raybundle.io.geo import coordinate_systems
from raybundle.io.geo.coordinate_systems import LocalFrame, _vertical, frame_from_mapping, height_remarks, local_frame
from raybundle.io.geo.parsed_names import parsed_system
from raybundle.io.geo.parsed_systems import parse_crs, system_name

BONN = (7.0, 50.7, 100.0)
SYSTEMS = {
    # system: (origin, 1 m in its plan units)
    "EPSG:25832": ((365_000.0, 5_620_000.0, 120.0), 1.0),
    "EPSG:32632": ((500_000.0, 5_400_000.0, 500.0), 1.0),
    "EPSG:2056": ((2_600_000.0, 1_200_000.0, 550.0), 1.0),
    "EPSG:4979": (BONN, 1 / 111_000),
    "EPSG:4326": (BONN, 1 / 111_000),
    "EPSG:4978": ((4_018_000.0, 493_000.0, 4_913_000.0), 1.0),
    "EPSG:2263": ((980_000.0, 200_000.0, 30.0), 3.28),
    "+proj=utm +zone=11 +ellps=WGS84 +datum=WGS84 +units=m +no_defs": ((235_263.0, 3_811_208.0, 0.0), 1.0),
}
GEOID, RHINE = "EPSG:25832+7837", (365_000.0, 5_620_000.0, 120.0)


@pytest.mark.parametrize("crs", SYSTEMS)
def test_there_and_back(crs):
    origin, metre = SYSTEMS[crs]
    frame = local_frame(crs, origin)
    rng = np.random.default_rng(1)
    xyz = np.array(origin) + rng.uniform(-1, 1, (50, 3)) * np.array([3000 * metre, 3000 * metre, 200])
    local = frame.local_from_crs(xyz)
    np.testing.assert_allclose(frame.local_from_crs(frame.crs_from_local(local)), local, rtol=0, atol=1e-6)
    metres = (frame.crs_from_local(local) - xyz) / [metre, metre, 1]
    np.testing.assert_allclose(metres, 0, atol=1e-6)
    np.testing.assert_allclose(frame.local_from_crs(np.array([origin])), 0, atol=1e-8)


class _Numbers:
    """pyproj with NumPy before 2.4: arrays of one value are taken for numbers, and numbers come back."""

    def __init__(self, transformer):
        self.transformer = transformer

    def transform(self, *columns, **words):
        if all(np.size(c) == 1 for c in columns):
            columns = [float(np.reshape(c, -1)[0]) for c in columns]
        return self.transformer.transform(*columns, **words)


@pytest.mark.parametrize("crs", ["EPSG:32632", "EPSG:4326", "EPSG:4979"])
def test_one_point_is_converted_as_many_are_with_every_numpy(crs, monkeypatch):
    for name in ("_plan", "_to_wgs84"):
        made = getattr(coordinate_systems, name)
        monkeypatch.setattr(coordinate_systems, name, lambda crs, made=made: _Numbers(made(crs)))
    place = (500_000.0, 5_400_000.0, 400.0) if crs == "EPSG:32632" else (9.0, 48.75, 400.0)
    frame = local_frame(crs, place)
    points = np.array([[10.0, 20.0, 3.0], [-40.0, 15.0, -2.0]])
    for there in (frame.crs_from_local, frame.wgs84_from_local):
        np.testing.assert_array_equal(there(points[:1]), there(points)[:1])
    for back, given in ((frame.local_from_crs, frame.crs_from_local(points)),
                        (frame.local_from_wgs84, frame.wgs84_from_local(points))):  # fmt: skip
        np.testing.assert_allclose(back(given[:1]), back(given)[:1], atol=1e-9)


def test_known_geocentric_points():
    """Equator and pole of WGS 84 (NIMA TR8350.2: a = 6 378 137 m, b = 6 356 752.3142 m)."""
    frame = local_frame("EPSG:4978", (6378137.0, 0.0, 0.0))
    east_north_up = frame.local_from_crs(
        np.array([[6378137.0, 10.0, 0.0], [6378137.0, 0.0, 10.0], [6378147.0, 0.0, 0.0]])
    )
    np.testing.assert_allclose(east_north_up, np.eye(3) * 10, atol=1e-9)
    pole = local_frame("EPSG:4979", (0.0, 90.0, 0.0)).local_from_crs(np.array([[0.0, 0.0, 0.0]]))
    np.testing.assert_allclose(np.abs(pole[0]), [0.0, 6378137.0, 6356752.3142], atol=1e-4)


def test_a_geographic_and_a_geocentric_system_make_the_same_frame():
    geographic = local_frame("EPSG:4979", BONN)
    at = np.array([[7.001, 50.702, 130.0]])
    from pyproj import Transformer

    change = Transformer.from_crs("EPSG:4979", "EPSG:4978", always_xy=True)
    geocentric = local_frame("EPSG:4978", change.transform(*BONN))
    expected = geographic.local_from_crs(at)
    np.testing.assert_allclose(geocentric.local_from_crs(np.array([change.transform(*at[0])])), expected, atol=1e-6)


def test_the_scale_of_the_grid_is_seen():
    frame = local_frame("EPSG:32632", (500_000.0, 5_400_000.0, 0.0))
    on_the_meridian, off = frame.scale_and_convergence(np.array([[500_000.0, 5_400_000, 0], [600_000, 5_400_000, 0]]))
    np.testing.assert_allclose(on_the_meridian, [0.9996, 0.0], atol=1e-8)
    # k = k0 (1 + (x / k0)^2 / 2 R^2), R the mean radius of curvature
    assert off[0] == pytest.approx(0.9996 * (1 + (1e5 / 0.9996) ** 2 / 2 / 6_382_000**2), abs=2e-7)
    assert off[1] > 0.01
    line = frame.local_from_crs(np.array([[500_000.0, 5_400_000, 0], [501_000, 5_400_000, 0]]))
    assert np.linalg.norm(line[1] - line[0]) == pytest.approx(1000 / 0.9996, abs=1e-3)
    high = frame.scale_and_convergence(np.array([[500_000.0, 5_400_000, 1000.0]]))
    assert high[0, 0] == pytest.approx(0.9996 * (1 - 1000 / 6_382_000), abs=1e-6)


def test_the_frame_turns_with_the_place():
    frame = local_frame("EPSG:4979", BONN)
    R = frame.local_from_enu(np.array([BONN, (7.1, 50.7, 100.0)]))
    np.testing.assert_allclose(R[0], np.eye(3), atol=1e-12)
    # up there leans to the east by about 0.1 deg cos(latitude)
    assert R[1, 0, 2] == pytest.approx(np.radians(0.1) * np.cos(np.radians(50.7)), rel=1e-4)


def test_attitudes_in_the_grid():
    """The convergence is the difference of the azimuths in the local frame and in the grid."""
    frame = local_frame("EPSG:32632", (600_000.0, 5_400_000.0, 0.0))
    at = np.array([[600_000.0, 5_400_000.0, 0.0]])
    grid_from_local = frame.crs_from_local_rotation(at)[0]
    north_of_grid = grid_from_local.T @ [0, 1, 0]
    assert np.arctan2(north_of_grid[0], north_of_grid[1]) == pytest.approx(frame.scale_and_convergence(at)[0, 1])


@pytest.mark.parametrize("crs", ["EPSG:32632", "EPSG:4979", "EPSG:2263"])
def test_covariances_go_both_ways_and_agree_with_simulation(crs):
    origin, metre = SYSTEMS[crs]
    frame = local_frame(crs, origin)
    at = np.add([origin], [[2000 * metre, 1000 * metre, 50.0]])
    rng = np.random.default_rng(3)
    A = rng.normal(size=(3, 3)) * np.array([[metre], [metre], [1.0]]) * 0.01
    given = (A @ A.T)[None]
    local = frame.local_covariance(at, given)
    np.testing.assert_allclose(frame.crs_covariance(at, local), given, rtol=1e-9, atol=1e-25)
    draws = frame.local_from_crs(at + rng.multivariate_normal(np.zeros(3), given[0], 20_000))
    np.testing.assert_allclose(np.cov(draws.T), local[0], atol=0.04 * np.abs(local).max())


def test_plan_without_heights():
    frame = local_frame("EPSG:32611", (235_263.0, 3_811_208.0, np.nan))
    assert any(r.messages[0].code == "crs.origin_height_unknown" for r in frame.remarks)
    plan = np.array([[235_269.88, 3_811_198.11, np.nan], [236_263.0, 3_812_208.0, np.nan]])
    local = frame.local_from_crs(plan)
    assert np.isnan(local[:, 2]).all()
    np.testing.assert_allclose(np.diff(local[:, :2], axis=0), np.diff(plan[:, :2], axis=0), rtol=0.05)
    np.testing.assert_allclose(frame.crs_from_local(local)[:, :2], plan[:, :2], atol=1e-6)
    C = np.diag([0.01, 0.04, np.nan])[None]
    turned = frame.local_covariance(plan[:1], C)[0]
    assert np.isfinite(turned[:2, :2]).all()
    assert np.isnan(turned[2]).all()


@pytest.mark.parametrize(
    ("crs", "advice"),
    [
        ("EPSG:25832", ("EPSG:25832+ellipsoid", "EPSG:25832+5773")),
        ("EPSG:25832+ellipsoid", None),
        ("EPSG:4979", None),
        ("EPSG:4978", None),
    ],
)
def test_heights_are_said_plainly(crs, advice):
    remarks = local_frame(crs, SYSTEMS[crs.removesuffix("+ellipsoid")][0]).remarks
    assert [(r.messages[0].values["ellipsoidal"], r.messages[0].values["sea"]) for r in remarks] == [advice] * bool(
        advice
    )


def test_a_given_undulation_raises_the_frame():
    crs, origin = GEOID, RHINE
    frame = local_frame(crs, origin, undulation_m=46.0)
    assert "46" in frame.remarks[0]
    line = np.array([origin, (origin[0] + 10_000, origin[1], origin[2])])
    length = np.linalg.norm(np.diff(frame.local_from_crs(line), axis=0))
    flat = np.linalg.norm(np.diff(local_frame("EPSG:25832", origin).local_from_crs(line), axis=0))
    assert length / flat - 1 == pytest.approx(46.0 / 6_385_000, rel=0.01)
    assert frame.wgs84_from_local(np.zeros((1, 3)))[0, 2] == pytest.approx(166.0, abs=1e-6)


def test_longitude_and_latitude():
    frame = local_frame("EPSG:32632", (500_000.0, 5_400_000.0, 300.0))
    lon, lat, h = frame.wgs84_from_local(np.zeros((1, 3)))[0]
    assert lon == pytest.approx(9.0, abs=1e-10)
    assert 48.7 < lat < 48.8
    assert h == pytest.approx(300.0, abs=1e-6)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("WGS84 UTM 11N", "WGS 84 / UTM zone 11N"),
        ("WGS84 UTM 32S", "WGS 84 / UTM zone 32S"),
        ("EPSG:25832", "ETRS89 / UTM zone 32N"),
    ],
)
def test_names_of_systems(text, name):
    assert parse_crs(text).name == name


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("nonsense", r"crs\.unknown"),
        ("EPSG:5773", r"crs\.not_on_earth"),
        ("WGS84 UTM 61N", r"1.*60.*crs\.utm_zone"),
    ],
)
def test_what_is_no_system_is_refused(text, words):
    with pytest.raises(InputError, match=words):
        parse_crs(text)


def test_a_place_outside_is_refused():
    with pytest.raises(InputError, match=r"crs\.not_transformed"):
        local_frame("EPSG:32632", (1e9, 1e9, 0.0))


def test_a_frame_is_stored_and_made_again():
    frame = local_frame("EPSG:32632", (500_000.0, 5_400_000.0, 300.0), undulation_m=40.0)
    assert frame_from_mapping(frame.as_mapping()) == frame
    with pytest.raises(InputError, match=r"crs\.incomplete"):
        frame_from_mapping({"crs": "EPSG:32632"})


@pytest.fixture
def no_geoid():
    if _vertical(GEOID)[0] is not None:
        pytest.skip("this machine has the geoid")


@pytest.mark.usefixtures("no_geoid")
def test_heights_above_a_missing_geoid_are_refused():
    with pytest.raises(InputError, match=r"DHHN2016.*crs\.geoid_missing"):
        local_frame(GEOID, RHINE)
    with pytest.raises(InputError, match=r"crs\.geoid_missing"):
        LocalFrame(crs=GEOID, origin=RHINE).local_from_crs(np.array([RHINE]))
    with pytest.raises(InputError, match=r"crs\.geoid_missing"):  # stored where the grid was there
        frame_from_mapping({"crs": GEOID, "origin": list(RHINE)})
    ellipsoidal = local_frame("EPSG:25832", RHINE)
    assert ellipsoidal.remarks[0].messages[0].code == "crs.heights_assumed"
    assert ellipsoidal.wgs84_from_local(np.zeros((1, 3)))[0, 2] == pytest.approx(120.0, abs=1e-6)


@pytest.mark.usefixtures("no_geoid")
def test_an_undulation_of_zero_is_a_statement():
    frame = local_frame(GEOID, RHINE, undulation_m=0.0)
    assert frame.wgs84_from_local(np.zeros((1, 3)))[0, 2] == pytest.approx(120.0, abs=1e-6)
    assert frame_from_mapping(frame.as_mapping()) == frame
    assert "undulation_m" not in local_frame("EPSG:25832", RHINE).as_mapping()


def test_heights_go_through_the_geoid_where_it_is(monkeypatch):
    """A vertical grid of its own making: 40 m everywhere."""
    from raybundle.io.geo import coordinate_systems

    class Grid:
        def transform(self, x, y, z, direction=None):
            there = Transformer.from_crs("EPSG:25832", "EPSG:4258", always_xy=True)
            if direction is None:
                return (*there.transform(x, y), z + 40)
            return (*there.transform(x, y, direction=direction), z - 40)

    monkeypatch.setattr(coordinate_systems, "_vertical", lambda _: (Grid(), ""))
    coordinate_systems._place.cache_clear()
    frame = local_frame(GEOID, RHINE)
    assert frame.remarks == ()
    assert frame.wgs84_from_local(np.zeros((1, 3)))[0, 2] == pytest.approx(160.0, abs=1e-6)
    np.testing.assert_allclose(frame.crs_from_local(np.zeros((1, 3)))[0], RHINE, atol=1e-6)
    coordinate_systems._place.cache_clear()


def test_heights_above_the_ellipsoid_are_those_of_the_plan_system():
    origin = SYSTEMS["EPSG:25832"][0]
    plain, told = local_frame("EPSG:25832", origin), local_frame("EPSG:25832+ellipsoid", origin)
    xyz = np.array([[30.0, -40.0, 5.0]])
    np.testing.assert_allclose(told.crs_from_local(xyz), plain.crs_from_local(xyz), atol=1e-9)
    assert told.units_m == plain.units_m
    assert parsed_system(told.crs).to_epsg() == 25832
    feet = local_frame("EPSG:2263+ellipsoid", (985000.0, 195000.0, 100.0))
    assert feet.units_m == pytest.approx((1200 / 3937,) * 2)
    for wrong in ("EPSG:25832+7837+ellipsoid", "EPSG:4979+ellipsoid"):
        with pytest.raises(InputError, match=r"crs\.heights_twice"):
            parse_crs(wrong)


def geoid_file(path, undulation):
    """A grid of one undulation around Hamburg, in the format gtx."""
    head = struct.pack(">ddddii", 52.0, 8.0, 0.05, 0.05, 61, 61)
    path.write_bytes(head + np.full((61, 61), undulation).astype(">f4").tobytes())
    return path


def test_a_proj_string_names_its_own_geoid(tmp_path):
    grid = geoid_file(tmp_path / "own.gtx", 40.0)
    crs = f"+proj=utm +zone=32 +ellps=GRS80 +units=m +geoidgrids={grid} +vunits=m +no_defs +type=crs"
    frame = local_frame(crs, (565_000.0, 5_933_000.0, 31.5))
    plain = local_frame("EPSG:25832+ellipsoid", (565_000.0, 5_933_000.0, 71.5))
    xyz = np.array([[30.0, -40.0, 5.0]])
    np.testing.assert_allclose(plain.crs_from_local(xyz) - frame.crs_from_local(xyz), [[0, 0, 40.0]], atol=1e-6)
    assert not frame.remarks
    assert system_name(crs) == "UTM zone 32N (PROJ string, heights by own.gtx)"
    (tmp_path / "own.gtx").unlink()
    lost = crs.replace("own", "lost")
    with pytest.raises(InputError, match=r"lost\.gtx.*crs\.geoid_missing"):
        local_frame(lost, (565_000.0, 5_933_000.0, 31.5))


@pytest.mark.parametrize(
    ("crs", "name"),
    [
        ("+proj=utm +zone=11 +datum=WGS84 +units=m +no_defs", "EPSG:32611"),
        ("+proj=tmerc +lat_0=0 +lon_0=9.3 +k=1 +x_0=5e5 +ellps=bessel +units=m", "Transverse Mercator (PROJ string)"),
        ("EPSG:25832+7837", "EPSG:25832+7837"),
    ],
)
def test_a_proj_string_has_a_readable_name(crs, name):
    assert system_name(crs) == name


@pytest.mark.parametrize(("crs", "at"), [("EPSG:31256", (16.37, 48.2)), ("EPSG:27700", (-2.0, 52.6))])
def test_the_height_of_a_geoid_counts_from_the_earth_s_ellipsoid(crs, at):
    """Of an older datum, too, whose own ellipsoid lies tens of metres off it; there and back."""
    pyproj = pytest.importorskip("pyproj")
    x, y = pyproj.Transformer.from_crs("EPSG:4326", crs, always_xy=True).transform(*at)
    frame = local_frame(crs, (x, y, 100.0), undulation_m=45.0)
    lon, lat, h = frame.wgs84_from_local(np.zeros((1, 3)))[0]
    assert (lon, lat) == pytest.approx(at, abs=1e-6)
    assert h == pytest.approx(145.0, abs=1e-3)
    there = frame.local_from_crs(np.array([[x + 500.0, y - 300.0, 180.0]]))
    np.testing.assert_allclose(frame.crs_from_local(there), [[x + 500.0, y - 300.0, 180.0]], atol=1e-3)
    assert any("(WGS 84)" in r for r in frame.remarks)
    with pytest.raises(InputError, match=r"crs\.undulation_of_ellipsoid"):
        local_frame(crs + "+ellipsoid", (x, y, 100.0), undulation_m=45.0)


def test_advice_on_heights_does_not_rest_on_an_option_that_a_command_may_not_have():
    (remark,) = height_remarks("+proj=tmerc +lat_0=47 +lon_0=8 +ellps=WGS84 +units=m")
    assert remark.messages[0].values["coded"] is False
