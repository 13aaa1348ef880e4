"""Position lists of other programs: geo.txt, Pix4D, Metashape, RTKLIB."""

import re

import numpy as np
import pytest
from tests.messages import coded, refused

from raybundle.errors import InputError, code_of
from raybundle.io.geo.control_files import read_control
from raybundle.io.trajectories import in_wgs84, matched, read_trajectory, trajectory_formats, write_trajectory
from raybundle.io.trajectories.base import WGS84_HEIGHT

HERE = (8.25, 47.5, 450.0)
EAST = (151.25, -33.5, 450.0)
UTM = (500010.5, 5400020.25, 450.0)
WKT = (
    'GEOGCS["WGS 84",DATUM["World Geodetic System 1984",SPHEROID["WGS 84",6378137,298.257223563]],'
    'PRIMEM["Greenwich",0],UNIT["degree",0.01745329251994328],AUTHORITY["EPSG","4326"]]'
)
META = "#Label,X/Longitude,Y/Latitude,Z/Altitude,Yaw,Pitch,Roll,Error_(m),X_error,X_est,Y_est,Z_est\n"

GRID = "500010.5,5400020.25,450"
W, PROJ = WGS84_HEIGHT, "+proj=utm +zone=33 +datum=WGS84 +units=m"
OWN = (0.02, 0.02, 0.03)
PIX4D = (
    "imagename,latitude [decimal degrees],longitude [decimal degrees],altitude [meter],accuracy horizontal [meter],"
    "accuracy vertical [meter]"
)
ACCURACY = "#Label,X/Easting,Y/Northing,Z/Altitude,Accuracy_X_(m),Accuracy_Y_(m),Accuracy_Z_(m)"
BARE = "b.jpg,,,,,,,,,8.2,47.4,449\n"
FULL = "a.jpg,8.25,47.5,450,1,2,3,0.1,0.1,8.2,47.4,449\n"

GEO_TXT = {  # text, place, system, standard deviations
    "degrees": ("EPSG:4326\na.jpg 8.25 47.5 450\n", HERE, W, None),
    "WGS84": ("WGS84\na.jpg 8.25 47.5 450\n", HERE, W, None),
    "UTM": (f"WGS84 UTM 33N\na.jpg {GRID.replace(',', ' ')}\n", UTM, "WGS84 UTM 33N", None),
    "PROJ string": (f"{PROJ}\na.jpg {GRID.replace(',', ' ')}\n", UTM, PROJ, None),
    "angles and accuracies": ("EPSG:4326\na.jpg 8.25 47.5 450 12 0 1 0.02 0.03\n", HERE, W, OWN),
    "no heights": ("EPSG:4326\na.jpg 8.25 47.5\n", (8.25, 47.5, np.nan), W, None),
    "blanks in a name": ("EPSG:4326\nmy a.jpg 8.25 47.5 450\n", HERE, W, None),
    "tabs": ("EPSG:4326\nmy a\t8.25\t47.5\t450\n", HERE, W, None),
    "comments": ("# made by hand\n\nEPSG:4326\n\na.jpg 8.25 47.5 450\n", HERE, W, None),
    "a mark": ("\ufeffEPSG:4326\r\na.jpg 8.25 47.5 450\r\n", HERE, W, None),
}
TABLES = {
    "Pix4D": (f"{PIX4D}\na.jpg,47.5,8.25,450,0.02,0.03\n", HERE, W, OWN),
    "Pix4D without names": ("a.jpg,47.5,8.25,450,0.02,0.03\n", HERE, W, OWN),
    "Pix4D with angles": ("a.jpg\t-33.5\t151.25\t450\t1\t2\t3\t0.02\t0.03\n", EAST, W, OWN),
    "Pix4D in a grid": (f"a.jpg,{GRID}\n", UTM, None, None),
    "Pix4D, grid with names": (f"#imagename,X,Y,Z\na.jpg,{GRID}\n", UTM, None, None),
    "decimal commas": ("image name;Latitude;Longitude;Altitude\na.jpg;47,5;8,25;450\n", HERE, W, None),
    "blanks, decimal commas": ("a.jpg -33,5 151,25 450\n", EAST, W, None),
    "blanks": ("my a.jpg 47.5 8.25 450\n", HERE, W, None),
    "longitude first": ("filename,lon,lat,alt\na.jpg,8.25,47.5,450\n", HERE, W, None),
    "longitude first, no names": ("a.jpg,151.25,-33.5,450\n", EAST, W, None),
    "easting, northing": (f"Photo;Easting;Northing;Height\na.jpg;{GRID.replace(',', ';')}\n", UTM, None, None),
    "Metashape": (f"# Cameras (1)\n# CoordinateSystem: {WKT}\n{META}{FULL}", HERE, W, None),
    "Metashape in a grid": (
        f"# CoordinateSystem: EPSG:32633\n{ACCURACY}\na.jpg,{GRID},0.01,0.02,0.03\n", UTM, "EPSG:32633",
        (0.01, 0.02, 0.03),
    ),
    "Metashape, no position": (f"{META}{BARE}{FULL}", HERE, W, None),
    "Metashape, tabs": ("#Label\tX/Longitude\tY/Latitude\tZ/Altitude\na\t8.25\t47.5\t450\n", HERE, W, None),
}  # fmt: skip
LISTS = {("geo.txt", "geo-txt", name): case for name, case in GEO_TXT.items()} | {
    ("list.csv", "image-list", name): case for name, case in TABLES.items()
}


def values_of(remark):
    """Values of a remark."""
    return remark.message.values if code_of(remark) else {}


@pytest.mark.parametrize("key", LISTS, ids=lambda k: f"{k[1]}, {k[2]}")
def test_position_lists(tmp_path, key):
    text, place, crs, sigma = LISTS[key]
    file, format_, name = key
    path = tmp_path / file
    path.write_bytes(text.encode())
    head = text.removeprefix("\ufeff")
    assert [n for n, f in trajectory_formats.items() if f.recognises(head, path.suffix)] == [format_]
    found = read_trajectory(path)
    (row,) = matched(found, ["my a.jpg" if "my a" in text else "a.jpg"])
    np.testing.assert_allclose(found.xyz[row], place)
    assert found.crs == crs
    np.testing.assert_allclose(found.sigma[row], sigma or (np.nan,) * 3)
    if name in {"Metashape", "angles and accuracies"}:
        assert any("yaw" in kind.lower() for kind in coded(found.remarks)["import.not_read"]["kinds"])
    if crs is not None:
        assert np.isfinite(in_wgs84(found, None).xyz[row, :2]).all()


@pytest.mark.parametrize(
    ("file", "text", "words"),
    [
        ("geo.txt", "EPSG:4326\na.jpg 8.25 47.5 450\na.jpg 8.26 47.5 450\n", r"3.*a\.jpg.*2.*cell\.id_twice"),
        ("geo.txt", "EPSG:4326\na.jpg 47.5 98.25 450\n", r"2.*98\.25.*90.*position\.beyond_degrees"),
        ("geo.txt", "EPSG:4326\na.jpg 8.25 47.5 450\nb.jpg 8.25\n", r"3.*2.*line\.too_few_cells"),
        ("geo.txt", "EPSG:999999\na.jpg 8.25 47.5 450\n", r"line 1: .*crs\.unknown"),
        ("geo.txt", "EPSG:4326\na.jpg 8.25 47.5 high\n", r"2.*Z.*value\.not_finite"),
        ("p.csv", "imagename,latitude,longitude,altitude\na.jpg,47.5,x,450\n", r"2.*value\.not_finite"),
        ("p.csv", "imagename,latitude,longitude,altitude\na.jpg,47.5\n", r"2.*line\.too_few_cells"),
        ("p.csv", "imagename,latitude,longitude,altitude\n", r"trajectory\.no_position"),
        ("p.csv", "a.jpg,47.5,8.25,450\nb.jpg,47.5\n", r"2.*line\.too_few_cells"),
        (
            "e.pos",
            "% GPST latitude(d'\") longitude(d'\") height(m)\n2024/05/01 10:00:01.237 47 30 0 8 15 0 450\n",
            r"rtklib\.not_decimal_degrees",
        ),
    ],
)
def test_bad_lists_are_named(tmp_path, file, text, words):
    path = tmp_path / file
    path.write_text(text)
    with pytest.raises(InputError, match=words):
        read_trajectory(path)


def test_positions_without_a_fix_are_none(tmp_path):
    path = tmp_path / "geo.txt"
    path.write_text("EPSG:4326\na.jpg 8.25 47.5 450\nb.jpg 0 0 0\n")
    found = read_trajectory(path)
    assert np.isnan(found.xyz[1]).all()
    assert any((code_of(r), values_of(r)) == ("position_list.no_fix", {"n": 1, "of": 2}) for r in found.remarks)


HEAD = (
    "% program   : RTKPOST\n%  GPST                  latitude(deg) longitude(deg)  height(m)   Q  ns   sdn(m)   sde(m) "
    "sdu(m)  sdne(m)  sdeu(m)  sdun(m) age(s)  ratio\n"
)
TAIL = "47.500000000 8.250000000 450.0000 1 12 0.0040 0.0030 0.0090 0.0010 -0.0010 0.0000 0.00 99.0\n"
POS = {
    "date": HEAD + "".join(f"2024/05/01 10:00:{k:02d}.{237 + 11 * k}   {TAIL}" for k in range(3)),
    "week": HEAD + "".join(f"2312 295200.{237 + 11 * k}   {TAIL}" for k in range(3)),
}


@pytest.mark.parametrize("name", ["date", "week"])
def test_rtklib_events(tmp_path, name):
    path = tmp_path / "flight_events.pos"
    path.write_text(POS[name])
    found = read_trajectory(path)
    np.testing.assert_allclose(found.xyz, np.tile(HERE, (3, 1)))
    np.testing.assert_allclose(found.sigma, np.tile((0.003, 0.004, 0.009), (3, 1)))
    np.testing.assert_allclose(found.correlation[0], (1e-6 / 1.2e-5, -1e-6 / 2.7e-5, 0.0), rtol=1e-6)
    assert found.fix == ("rtk fixed",) * 3
    assert matched(found, ["IMG_0103.jpg", "IMG_0099.jpg", "IMG_0101.jpg"]).tolist() == [2, 0, 1]
    with pytest.raises(InputError, match=r"3.*2.*trajectory\.count_differs"):
        matched(found, ["a.jpg", "b.jpg"])


def test_rtklib_from_the_earths_centre(tmp_path):
    path = tmp_path / "a.pos"
    head = "%  GPST  x-ecef(m)  y-ecef(m)  z-ecef(m)  Q  ns\n"
    path.write_text(head + "2312 295200.237 4273000.0 619500.0 4680000.0 2 9\n")
    found = read_trajectory(path)
    assert found.xyz[0, :2] == pytest.approx((8.249, 47.5), abs=0.1)
    assert found.fix == ("rtk float",)


ECEF_HEAD = "%  GPST  x-ecef(m)  y-ecef(m)  z-ecef(m)  Q  ns  sdx(m)  sdy(m)  sdz(m)  sdxy(m)  sdyz(m)  sdzx(m)\n"
PLACES = [(0.0, 0.0), (90.0, 0.0), (8.25, 47.5), (-70.5, -33.5), (151.25, 10.0), (180.0, 45.0), (-0.1, 89.0)]


@pytest.mark.parametrize("place", PLACES)
def test_rtklib_covariances_from_the_earths_centre(tmp_path, place):
    """East, north, up of a covariance of x, y, z is the turned one; the file holds signed roots."""
    C = np.array([[4.0, -1.5, 0.5], [-1.5, 9.0, 2.0], [0.5, 2.0, 1.0]]) * 1e-4
    lon, lat = np.radians(place)
    so, co, sa, ca = np.sin(lon), np.cos(lon), np.sin(lat), np.cos(lat)
    R = np.array([[-so, co, 0], [-sa * co, -sa * so, ca], [ca * co, ca * so, sa]])
    xyz = 6.378e6 * R[2]
    roots = [C[0, 0], C[1, 1], C[2, 2], C[0, 1], C[1, 2], C[2, 0]]
    words = [*xyz, 1, 9, *(np.sign(v) * abs(v) ** 0.5 for v in roots)]
    path = tmp_path / "a.pos"
    path.write_text(f"{ECEF_HEAD}2312 295200.237 {' '.join(f'{v:.10f}' for v in words)}\n")
    found = read_trajectory(path)
    right = R @ C @ R.T
    np.testing.assert_allclose(found.sigma[0], np.diag(right) ** 0.5, rtol=2e-2)  # geodetic and spherical latitude
    s = np.diag(right) ** 0.5
    np.testing.assert_allclose(
        found.correlation[0], (right / np.outer(s, s))[(0, 0, 1), (1, 2, 2)], atol=0.03
    )  # fmt: skip
    path.write_text(f"{ECEF_HEAD.replace('sdy(m)  sdz', 'sdz(m)  sdy')}2312 295200.237 {' '.join(map(str, words))}\n")
    other = read_trajectory(path)
    assert np.isnan(other.sigma).all()
    assert any(code_of(r) == "position_list.sigma_columns" for r in other.remarks)


BRACKETS = {  # names of latitude, longitude, height, accuracy; the quantity whose unit is refused, or nothing
    "latitude [decimal degrees],longitude [decimal degrees],altitude [meter],accuracy horizontal [meter]": "",
    "Latitude (deg),Longitude (deg),Height (m),Sigma XY (m)": "",
    "latitude (WGS84),longitude (WGS84),ellipsoidal height (m),accuracy horizontal": "",
    "latitude,longitude,altitude (ellipsoidal) [m],accuracy horizontal": "",
    "latitude,longitude,altitude [feet],accuracy horizontal": "height",
    "latitude,longitude,altitude (ft),accuracy horizontal": "height",
    "latitude,longitude,height (US survey ft),accuracy horizontal": "height",
    "latitude,longitude,altitude (MSL),accuracy horizontal": "height",
    "latitude,longitude,height [m] (EGM96),accuracy horizontal": "height",
    "latitude,longitude,altitude (orthometric),accuracy horizontal": "height",
    "latitude (rad),longitude (rad),altitude,accuracy horizontal": "angle",
    "latitude (gon),longitude (gon),altitude,accuracy horizontal": "angle",
    "latitude,longitude,altitude,accuracy horizontal [cm]": "length",
}


@pytest.mark.parametrize("names", BRACKETS)
def test_units_of_columns(tmp_path, names):
    path = tmp_path / "list.csv"
    text = f"imagename,{names}\na.jpg,47.5,8.25,450,0.02\n"
    path.write_text(text)
    if BRACKETS[names]:
        with refused("image_list.unit", quantity=BRACKETS[names]):
            read_trajectory(path)
    else:
        np.testing.assert_allclose(read_trajectory(path).xyz, [HERE])
    system = "# CoordinateSystem: EPSG:4326+5773\n"
    path.write_text(system + text)
    if "MSL" in names or "EGM96" in names or "orthometric" in names:
        assert read_trajectory(path).crs == "EPSG:4326+5773"


STATED = {  # a line of the header and what it gives: a remark, none, or the reason of a refusal
    "% (lat/lon/height=WGS84/ellipsoidal,Q=1:fix,2:float,ns=# of satellites)": "",
    "% (lat/lon/height=WGS-84 / Ellipsoidal, Q=1:fix)": "",
    "% height: ellipsoidal": "",
    "% height    : ellipsoid": "",
    "% antenna height: none": "does not state what its heights count from",
    "% height: 1.5 m": "does not state what its heights count from",
    "% pos mode  : Kinematic": "does not state what its heights count from",
    "% (lat/lon/height=WGS84/geodetic,Q=1:fix,2:float,ns=# of satellites)": r"rtklib\.heights",
    "% (lat/lon/height=wgs84/geodetic)": r"rtklib\.heights",
    "% height: geodetic": r"rtklib\.heights",
    "% height    : orthometric": r"orthometric.*rtklib\.heights",
    "% (lat/lon/height=Tokyo/ellipsoidal,Q=1:fix)": r"Tokyo.*rtklib\.datum",
    "% (lat/lon/height=Tokyo/geodetic,Q=1:fix)": r"Tokyo.*rtklib\.datum",
    "% (lat/lon/height=CGCS2000/ellipsoidal,Q=1:fix)": r"CGCS2000.*rtklib\.datum",
    "% (x/y/z-ecef=Tokyo,Q=1:fix)": r"Tokyo.*rtklib\.datum",
}


@pytest.mark.parametrize("stated", STATED)
def test_rtklib_states_datum_and_heights(tmp_path, stated):
    path = tmp_path / "a_events.pos"
    path.write_text(f"{stated}\n{POS['date']}")
    right = STATED[stated]
    if "rtklib" in right:
        with pytest.raises(InputError, match=f"line 1: .*{right}"):
            read_trajectory(path)
        return
    found = read_trajectory(path)
    assert found.crs == W
    assert any(code_of(r) == "position_list.heights_open" for r in found.remarks) == bool(right)


@pytest.mark.parametrize("clock", ["GPST", "UTC ", "JST ", "BDT "])
def test_rtklib_states_its_times(tmp_path, clock):
    path = tmp_path / "a_events.pos"
    path.write_text(POS["date"].replace("GPST", clock))
    assert (read_trajectory(path).time is None) == (clock != "GPST")


def test_rtklib_columns_by_name(tmp_path):
    path = tmp_path / "a_events.pos"
    path.write_text(POS["date"].replace("latitude(deg) longitude(deg)", "longitude(deg) latitude(deg)"))
    with pytest.raises(InputError, match=r"rtklib\.columns"):
        read_trajectory(path)
    path.write_text(POS["date"].replace("sdn(m)   sde(m)", "sde(m)   sdn(m)"))
    found = read_trajectory(path)
    assert np.isnan(found.sigma).all()
    assert any(code_of(r) == "position_list.sigma_columns" for r in found.remarks)


@pytest.mark.parametrize("step", [0.05, 0.1, 0.2, 1.0, 5.0])
def test_a_track_is_no_list_of_exposures(tmp_path, step):
    path = tmp_path / "rover.pos"
    path.write_text(HEAD + "".join(f"2312 {295200 + k * step:.3f}   {TAIL}" for k in range(20)))
    with pytest.raises(InputError, match=r"20.*rtklib\.track"):
        read_trajectory(path)


def test_formats_that_are_only_read(tmp_path):
    path = tmp_path / "geo.txt"
    path.write_text("EPSG:4326\na.jpg 8.25 47.5 450\n")
    with pytest.raises(InputError, match=r"format\.only_read"):
        write_trajectory(read_trajectory(path), tmp_path / "b.txt", name="geo-txt")


NUMBERS = "8.25,47.5,450"
HEADERS = {  # names, and the place; None: refused
    "#Label,X_est,Y_est,Z_est": (None, HERE),
    "#Label,Longitude_est,Latitude_est,Altitude_est": (W, HERE),
    "#Label,X/Longitude,Y/Latitude,Z/Altitude": (W, HERE),
    "#Image,Local X,Local Y,Local Z": (None, HERE),
    "Label,pos_x,pos_y,pos_z": (None, HERE),
    "Photo,GPSLongitude,GPSLatitude,GPSAltitude": (W, HERE),
    "Photo,Camera X (m),Camera Y (m),Camera Z (m)": (None, HERE),
    "photo,X/East,Y/North,Z/Up": (None, HERE),
    "photo,East [m],North [m],Elev [m]": (None, HERE),
    "photo,Rechtswert,Hochwert,Hoehe": (None, HERE),
    "file,xcoordinate,ycoordinate,zcoordinate": (None, HERE),
    "#Label,Links,Hoch,Auf": "'Links', 'Hoch', 'Auf'",
    "photo,abscissa,ordinate,height": "'abscissa', 'ordinate'",
    "photo,first,second,third": "'first', 'second', 'third'",
    "photo,X/Latitude,Y/Longitude,Z": "'X/Latitude', 'Y/Longitude'",
    "photo,Y/Easting,X/Northing,Z": "'Y/Easting', 'X/Northing'",
    "#Label,X_var,Y_var,Z_var": "'X_var', 'Y_var', 'Z_var'",
    "foto,a,b,c": "'foto', 'a', 'b', 'c'",
    "photo,latitude,easting,height": "'photo', 'latitude', 'easting', 'height'",
}


@pytest.mark.parametrize("names", HEADERS)
def test_names_of_columns_are_understood_or_refused(tmp_path, names):
    path = tmp_path / "list.csv"
    for comment in ("", "# a list by hand\n# of 2024\n"):
        path.write_text(f"{comment}{names}\na.jpg,{NUMBERS}\nb.jpg,{NUMBERS}\n")
        if isinstance(HEADERS[names], str):
            with pytest.raises(InputError, match=r"image_list\.unknown_columns"):
                read_trajectory(path)
            continue
        crs, place = HEADERS[names]
        found = read_trajectory(path)
        assert found.crs == crs
        np.testing.assert_allclose(found.xyz[0], place)
        assert any(code_of(r) == "position_list.estimated" for r in found.remarks) == ("_est" in names)


NAMELESS = {  # lines, and latitude, longitude ("lat"), longitude, latitude ("lon"), X, Y ("xy"), a place; "": refused
    "a.jpg,47.5,8.25,450": "47.5 N, 8.25 E",
    "a.jpg,8.25,47.5,450": "8.25 N, 47.5 E",
    "a.jpg,12.5,47.5,45\nb.jpg,22.5,40.5,45": "",
    "a.jpg,12.5,120.5,45\nb.jpg,22.5,140.5,45": "",
    "a.jpg,-33.5,-70.25,450": "33.5 S, 70.25 W",
    "# site north\na.jpg,0,0,0\nb.jpg,3,3,0": "",
    "a.jpg,-33.5,151.25,450": "lat",
    "a.jpg,40.1,-105.2,450\nb.jpg,40.2,-105.3,450": "lat",
    "# by hand, in 2024, on site\na.jpg,40.1,-105.2,450": "lat",
    "a.jpg,-105.2,40.1,450": "lon",
    "a.jpg,312.5,47.5,45": "xy",
    "a.jpg,95.5,120.5,45": "xy",
    "#crs: EPSG:32632\na.jpg,512.5,470.5,45": "xy",
    "#crs: EPSG:4326\na.jpg,12.5,47.5,45": "12.5 N, 47.5 E",
    "#crs: EPSG:4326\na.jpg,12.5,147.5,45\nb.jpg,22.5,147.5,45": "lat",
}


@pytest.mark.parametrize("lines", NAMELESS)
def test_lists_without_names_are_read_where_numbers_decide(tmp_path, lines):
    path = tmp_path / "list.csv"
    path.write_text(f"{lines}\n")
    if not NAMELESS[lines]:
        with pytest.raises(InputError, match=r"image_list\.order_unclear"):
            read_trajectory(path)
        return
    if "," in NAMELESS[lines]:
        (remark,) = (r for r in read_trajectory(path).remarks if code_of(r) == "position_list.order_of_pix4d")
        assert remark.endswith(f" {NAMELESS[lines]}.")
        return
    order = {"lat": "latitude_longitude", "lon": "longitude_latitude", "xy": "xyz"}[NAMELESS[lines]]
    assert [values_of(r) for r in read_trajectory(path).remarks if code_of(r) == "position_list.unnamed"] == [
        {"order": order}
    ]


@pytest.mark.parametrize("name", ["", " ", "\t"])
def test_an_empty_name_is_refused(tmp_path, name):
    path = tmp_path / "list.csv"
    path.write_text(f"imagename,latitude,longitude,altitude\na.jpg,47.5,8.25,450\n{name},47.5,8.26,450\n")
    with pytest.raises(InputError, match=r"3.*name\.missing"):
        read_trajectory(path)


def test_numbers_as_names_of_photographs(tmp_path):
    path = tmp_path / "geo.txt"
    path.write_text("EPSG:4326\n0001 8.25 47.5 450\n12 8.26 47.5 450\n")
    with pytest.raises(InputError, match=r"2.*0001.*geo_txt\.name_is_number"):
        read_trajectory(path)
    path = tmp_path / "list.csv"
    path.write_text("0001,47.5,8.25,450\n")
    with pytest.raises(InputError, match=r"trajectory\.format_unknown"):
        read_trajectory(path)


ORDERS = {  # system, coordinates, and what is wrong with them: nothing, a remark, or a refusal
    "EPSG:32632 443550.5 5261000.25": "",
    "EPSG:32632 5261000.25 443550.5": "refused: exchanged",
    "WGS84 UTM 32N 5261000.25 443550.5": "refused: exchanged",
    "+proj=utm +zone=32 +datum=WGS84 5261000.25 443550.5": "refused: exchanged",
    "EPSG:32632+5773 5261000.25 443550.5": "refused: exchanged",
    "EPSG:2056 1200000 2600000": "refused: exchanged",
    "EPSG:2056+5728 1200000 2600000": "refused: exchanged",
    "EPSG:31467 5261000 3450000": "refused: exchanged",
    "EPSG:2263 200000 980000": "refused: exchanged",
    "EPSG:4258 48.1 11.5": "refused: exchanged",
    "EPSG:4258 11.5 48.1": "",
    "EPSG:4807 2.5 54.0": "",  # grads from Paris
    "EPSG:27572 600000 2200000": "",
    "EPSG:2056 2600000 1200000": "",
    "EPSG:31467 3450000 5261000": "",
    "EPSG:2263 980000 200000": "",
    "EPSG:27700 530000 180000": "",
    "WGS84 UTM 19S 330000.5 6243000.25": "",
    "EPSG:32760 830000 8200000": "",  # beside the date line
    "EPSG:3857 918000 6000000": "",
    "EPSG:4978 4272570 619515": "",
    "EPSG:25833 1010000 7800000": "outside the area of use",  # all of Norway
    "EPSG:32632 250000 985000": "",
    "EPSG:2056 8530183.7 3937007.9": "refused: feet",
    "EPSG:32632 1451443.6 17260498.7": "refused: feet",
    "EPSG:21781 2600000 1200000": "refused: feet",  # of EPSG:2056
    "EPSG:2056 600000 200000": "refused: system",
    "EPSG:25833 1150000 7900000": "outside the area of use",
    "EPSG:32633 985000 195000": "outside the area of use.*exchanged",
    "EPSG:32632 8.25 47.5": "refused: degrees",
    "EPSG:32632 47.5 8.25": "refused: degrees",
    "WGS84 500010.5 5400020.25": "refused: longitude 180",
    "EPSG:4258 11.5 95.0": "refused: latitude 90 swapped",
    "EPSG:4258 190.0 48.0": "refused: longitude 180",
    "EPSG:4258 48.0 111.0": "refused: latitude 90 swapped",
    "+proj=tmerc +lat_0=0 +lon_0=27 +k=1 +x_0=500000 +y_0=0 +ellps=bessel +units=m 500010.5 5400020.25": "",
}


def beyond_circle(values):
    swapped = " swapped" if values.get("swapped") else ""
    return f"{values.get('quantity', 'longitude')} {values.get('limit', 0):g}{swapped}"


@pytest.mark.parametrize("line", ORDERS)
def test_order_of_coordinates_in_a_named_system(tmp_path, line):
    system, x, y = line.rsplit(" ", 2)
    geo, gcp = tmp_path / "geo.txt", tmp_path / "gcp_list.txt"
    geo.write_text(f"{system}\na.jpg {x} {y} 450\n")
    gcp.write_text(f"{system}\n{x} {y} 450 10 20 a.jpg p1\n")
    right = ORDERS[line]
    for path, read in ((geo, read_trajectory), (gcp, read_control)):
        if right.startswith("refused: "):
            with pytest.raises(InputError) as caught:
                read(path)
            assert caught.value.line == 2
            assert re.match(r"crs\.(outside_area|beyond_circle)$|position\.", caught.value.code)
            values = caught.value.message.values
            assert values.get("hint", beyond_circle(values)) == right.removeprefix("refused: ")
            continue
        beyond = [r for r in read(path).remarks if "outside the area of use" in r]
        assert len(beyond) == bool(right)
        assert all(re.search(right, r) for r in beyond)


def test_order_of_coordinates_in_a_system_that_the_user_names(tmp_path):
    path = tmp_path / "list.csv"
    path.write_text("name,X,Y,Z\na.jpg,5261000.25,443550.5,450\n")
    with refused("crs.outside_area", hint="exchanged"):
        in_wgs84(read_trajectory(path), "EPSG:32632")
    path.write_text("name,X,Y,Z\na.jpg,443550.5,5261000.25,450\n")
    assert not any("outside" in r for r in in_wgs84(read_trajectory(path), "EPSG:32632").remarks)


@pytest.mark.parametrize("word", ["0", "1", "False", "true", ""])
def test_positions_that_the_list_disables(tmp_path, word):
    path = tmp_path / "list.csv"
    path.write_text(
        f"#Label,Enable,X/Longitude,Y/Latitude,Z/Altitude\na.jpg,1,8.25,47.5,450\nb.jpg,{word},8.26,47.5,450\n"
    )
    found = read_trajectory(path)
    off = word in {"0", "False"}
    assert np.isnan(found.xyz[1, :2]).all() == off
    assert (
        any((code_of(r), values_of(r)) == ("position_list.disabled", {"n": 1, "of": 2}) for r in found.remarks) == off
    )
    assert "import.not_read" not in coded(found.remarks)
