"""Files of positions and attitudes: by hand from the description, there and back, into a block, bad input."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from raybundle.errors import InputError, code_of
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.io.photos.metadata import Gps, Metadata
from raybundle.io.photos.photo import Photo
from raybundle.io.trajectories import (
    Trajectory,
    in_wgs84,
    matched,
    read_trajectory,
    rotations_in,
    stations_of,
    trajectory_formats,
    with_positions,
    write_trajectory,
)
from raybundle.io.trajectories.base import WGS84_HEIGHT
from raybundle.io.trajectories.photographs import frame_of_positions
from raybundle.numerics.attitude import opk_from_rotation, rotation_from_opk, rotation_from_rpy

MRK = (
    "1\t282401.669089\t[2404]\t   101,N\t   107,E\t   129,V\t22.77995359,Lat\t114.10089118,Lon\t139.231,Ellh\t"
    "0.002967, 0.003104, 0.007622\t50,Q\n"
    "2\t282404.1\t[2404]\t   -3,N\t   12,E\t   190,V\t114.10099118,Lon\t22.77996359,Lat\t139.4,Ellh\t"
    "0.5, 0.6, 1.2\t34,Q\n"
    "3\t282406.1\t[2404]\t0,N\t0,E\t0,V\t0.0,Lat\t0.0,Lon\t0.0,Ellh\t0, 0, 0\t0,Q\n"
)
FRAME = local_frame(WGS84_HEIGHT, (114.1009, 22.78, 60.0))


@pytest.fixture
def mrk(tmp_path):
    path = tmp_path / "flight_Timestamp.MRK"
    path.write_text(MRK)
    return path


def test_an_mrk_file_by_hand(mrk):
    t = read_trajectory(mrk)
    assert (t.names, t.numbered, t.crs) == (("1", "2", "3"), True, WGS84_HEIGHT)
    np.testing.assert_allclose(t.xyz[:2], [[114.10089118, 22.77995359, 139.231], [114.10099118, 22.77996359, 139.4]])
    assert np.isnan(t.xyz[2]).all()
    np.testing.assert_allclose(t.sigma[0], [0.003104, 0.002967, 0.007622])  # the file has north first
    np.testing.assert_allclose(t.offset[:2], [[0.107, 0.101, -0.129], [0.012, -0.003, -0.190]])
    assert t.fix == ("rtk fixed", "rtk float", "none")
    assert t.time[0] == pytest.approx(2404 * 604800 + 282401.669089)
    found = [(r.message.code, r.message.values) for r in t.remarks]
    assert ("position_list.not_fixed", {"n": 2, "of": 3}) in found
    assert ("position_list.exposures_without", {"n": 1, "of": 3}) in found


def test_numbers_find_their_photographs(mrk):
    t = read_trajectory(mrk)
    files = ["a/DJI_20240501101530_0002_V.JPG", "100_0001_0001.JPG", "DJI_0007.JPG", "cover.jpg"]
    assert matched(t, files).tolist() == [1, 0, -1, -1]
    with pytest.raises(InputError, match=r"2.*a_0002\.jpg.*b_0002\.jpg.*trajectory\.position_twice"):
        matched(t, ["a_0002.jpg", "b_0002.jpg"])


def test_positions_become_stations(mrk):
    t = read_trajectory(mrk)
    s = stations_of(t, ["DJI_0002.JPG", "DJI_0009.JPG", "DJI_0001.JPG", "DJI_0003.JPG"], FRAME)
    assert s.image.tolist() == [0, 2]
    np.testing.assert_allclose(s.xyz, FRAME.local_from_crs(t.xyz[[1, 0]]))
    np.testing.assert_allclose(s.sigma[1], t.sigma[0])
    with pytest.raises(InputError, match=r"1.*trajectory\.no_photograph_found"):
        stations_of(t, ["x.jpg"], FRAME)
    with pytest.raises(InputError, match=r"trajectory\.needs_local_frame"):
        stations_of(t, ["DJI_0002.JPG"], None)


def test_photographs_take_positions(mrk):
    blank = {"path": mrk, "width_px": 1, "height_px": 1, "sha256": ""}
    old = Gps(latitude_deg=1.0, longitude_deg=2.0)
    photos = [Photo(name=f"DJI_000{k}.JPG", metadata=Metadata(gps=old), **blank) for k in (1, 2, 3, 8)]
    t = read_trajectory(mrk)
    changed, remarks = with_positions(photos, t)
    gps = [p.metadata.gps for p in changed]
    assert (gps[0].latitude_deg, gps[0].altitude_reference, gps[0].fix) == (22.77995359, "ellipsoid", "rtk fixed")
    assert gps[0].sigma_m == (0.003104, 0.002967, 0.007622)
    assert gps[2] == gps[3] == old  # no position, no row
    assert remarks[0].message.code == "position_list.used"
    assert remarks[0].message.values == {"n": 2, "of": 4, "name": "flight_Timestamp.MRK"}
    with pytest.raises(InputError, match=r"1.*trajectory\.no_photograph_found"):
        with_positions(photos[3:], t)
    with pytest.raises(InputError, match=r"longitude_deg.*trajectory\.no_crs"):
        with_positions(photos, replace(t, crs=None))


def test_opk_by_hand(tmp_path):
    path = tmp_path / "eo.csv"
    path.write_text(
        "image,X,Y,Z,omega_gon,phi_gon,kappa_gon,sX,sY,sZ\na.tif,500000,5400000,1200,1,-2,100,0.02,0.02,0.04\n"
    )
    t = read_trajectory(path)
    np.testing.assert_allclose(np.degrees(opk_from_rotation(t.rotation)), [[0.9, -1.8, 90.0]])
    frame = local_frame("EPSG:32632", (500000.0, 5400000.0, 1200.0))
    # on the central meridian at the origin grid north is true north
    np.testing.assert_allclose(rotations_in(t, frame), t.rotation, atol=1e-9)
    np.testing.assert_allclose(stations_of(t, ["p/a.jpg"], frame).xyz, [[0, 0, 0]], atol=1e-6)
    np.testing.assert_allclose(stations_of(t, ["a.tif"], None).xyz, t.xyz)


@pytest.mark.parametrize("system", ["EPSG:25832+ellipsoid", "EPSG:25833+ellipsoid", WGS84_HEIGHT])
def test_positions_of_another_system_are_transformed(tmp_path, system):
    """A block in zone 32, its positions in another zone or in degrees: the same stations and rotations."""
    path = tmp_path / "eo.csv"
    path.write_text("image,X,Y,Z,omega_deg,phi_deg,kappa_deg\na,690000,5400000,700,1,-2,30\nb,690100,5400050,,0,0,0\n")
    frame = local_frame("EPSG:25832+ellipsoid", (690000.0, 5400000.0, 600.0))
    own = replace(read_trajectory(path), crs=frame.crs)
    xyz = own.xyz.copy()
    north = own.rotation @ frame.crs_from_local_rotation(own.xyz) @ frame.local_from_enu(own.xyz)
    other = in_wgs84(replace(own, crs=frame.crs), None)
    if system != WGS84_HEIGHT:
        there = local_frame(system, (250000.0, 5400000.0, 600.0))
        other = replace(other, xyz=there.crs_from_local(there.local_from_wgs84(other.xyz)), crs=system)
        assert other.true_north
    np.testing.assert_allclose(other.rotation, north, atol=1e-8)
    s = stations_of(other, ["a.jpg", "b.jpg"], frame)
    np.testing.assert_allclose(s.xyz, frame.local_from_crs(xyz), atol=1e-4)
    np.testing.assert_allclose(rotations_in(other, frame), rotations_in(own, frame), atol=1e-8)


@pytest.mark.parametrize("system", ["EPSG:4326", "EPSG:4258+ellipsoid"])
def test_degrees_of_any_system_need_a_frame(mrk, system):
    with pytest.raises(InputError, match=r"trajectory\.needs_local_frame"):
        stations_of(replace(read_trajectory(mrk), crs=system), ["DJI_0002.JPG"], None)


def test_rpy_against_true_north(tmp_path):
    """Heading 0 away from the central meridian: in the grid the image is turned by the convergence."""
    path = tmp_path / "ins.csv"
    path.write_text(
        "image,X,Y,Z,roll_deg,pitch_deg,yaw_deg\na,500000,5400000,1200,0,0,0\nb,600000,5400000,1200,0,0,0\n"
    )
    t = read_trajectory(path)
    assert t.true_north
    frame = local_frame("EPSG:32632", (500000.0, 5400000.0, 1200.0))
    kappa = np.degrees(opk_from_rotation(rotations_in(t, frame)))[:, 2]
    convergence = np.degrees(frame.scale_and_convergence(t.xyz)[:, 1])
    assert convergence[1] == pytest.approx(1.02, abs=0.02)
    # meridians converge: north at b leans to the west against the frame's Y axis, the image turns with it
    assert kappa[0] == pytest.approx(0, abs=1e-6)
    assert abs(kappa[1]) == pytest.approx(convergence[1], abs=0.01)
    north = np.linalg.inv(rotations_in(t, frame)[1]) @ [0, 1, 0]
    assert north[0] < 0
    with pytest.raises(InputError, match=r"trajectory\.north_needs_frame"):
        rotations_in(t, None)


def test_gimbal_columns(tmp_path):
    path = tmp_path / "gimbal.csv"
    path.write_text(
        "image,longitude_deg,latitude_deg,height_m,gimbal_yaw_deg,gimbal_pitch_deg,gimbal_roll_deg\n"
        "a,114.1009,22.78,139,90,-90,0\nb,114.1009,22.78,139,90,-60,0\nc,114.1009,22.78,139,,,\n"
    )
    t = read_trajectory(path)
    R = rotations_in(t, FRAME)
    np.testing.assert_allclose(R[0], rotation_from_rpy(np.radians([0, 0, 90])), atol=1e-9)
    np.testing.assert_allclose(-R[1, 2], [0.5, 0, -np.sqrt(0.75)], atol=1e-9)
    assert np.isnan(R[2]).all()


WRITTEN = sorted(n for n, f in trajectory_formats.items() if f.write is not None)


def trajectory(name, path):
    n = 5
    rng = np.random.default_rng(1)
    grid = name == "opk"
    size, origin = (100.0, (500000, 5400000, 100)) if grid else (1e-3, (9, 49, 200))
    xyz = rng.uniform(0, size, (n, 3)) + np.array(origin)
    sigma = rng.uniform(0.01, 0.05, (n, 3))
    xyz[3, 2], sigma[3, 2] = (np.nan, np.nan) if name != "mrk" else (xyz[3, 2], sigma[3, 2])
    rotation = rotation_from_opk(rng.uniform(-1, 1, (n, 3)))
    rotation[2] = np.nan
    return Trajectory(
        path=path,
        names=tuple(str(k + 1) for k in range(n)) if name == "mrk" else tuple(f"i,{k}.jpg" for k in range(n)),
        numbered=name == "mrk",
        xyz=xyz,
        sigma=sigma,
        crs=None if grid else WGS84_HEIGHT,
        rotation=None if name == "mrk" else rotation,
        rotation_sigma=None if name == "mrk" else rng.uniform(1e-4, 1e-3, (n, 3)),
        true_north=not grid,
        time=2300 * 604800.0 + np.arange(n) * 2.5,
        offset=np.round(rng.uniform(-0.2, 0.2, (n, 3)), 3) if name == "mrk" else None,
        fix=("rtk fixed", "rtk float", "single", "none", "rtk fixed") if name == "mrk" else (),
    )


@pytest.mark.parametrize("name", WRITTEN)
def test_what_is_written_reads_back(name, tmp_path):
    path = tmp_path / f"t.{'mrk' if name == 'mrk' else 'csv'}"
    given_ = trajectory(name, path)
    write_trajectory(given_, path, name=name)
    again = read_trajectory(path)
    placed = name in {"mrk", "positions"}
    assert (again.names, again.crs, again.true_north or placed) == (given_.names, given_.crs, name != "opk")
    tolerance = {"mrk": 1e-4}.get(name, 1e-12)
    np.testing.assert_allclose(again.xyz[:, :2], given_.xyz[:, :2], rtol=0, atol=1e-9)
    np.testing.assert_allclose(again.xyz, given_.xyz, rtol=0, atol=tolerance)
    np.testing.assert_allclose(again.sigma, given_.sigma, atol=1e-6)
    np.testing.assert_allclose(again.time, given_.time, rtol=0, atol=1e-6)
    if name == "mrk":
        assert again.fix == given_.fix
        np.testing.assert_allclose(again.offset, given_.offset, atol=1e-12)
    elif name == "positions":
        assert again.rotation is None
    else:
        np.testing.assert_allclose(again.rotation, given_.rotation, atol=1e-12)
        np.testing.assert_allclose(again.rotation_sigma, given_.rotation_sigma, rtol=1e-12)
    with pytest.raises(InputError, match=r"file\.exists"):
        write_trajectory(given_, path, name=name)


def test_what_cannot_be_written_is_refused(tmp_path):
    t = trajectory("opk", tmp_path / "x")
    with pytest.raises(InputError, match=r"mrk\.not_geographic"):
        write_trajectory(t, tmp_path / "a.mrk", name="mrk")
    with pytest.raises(InputError, match=r"trajectory\.attitude_reference"):
        write_trajectory(t, tmp_path / "a.csv", name="rpy")
    with pytest.raises(InputError, match=r"trajectory\.no_attitudes"):
        write_trajectory(replace(t, rotation=None), tmp_path / "a.csv", name="opk")
    with pytest.raises(InputError, match=r"format\.unknown"):
        read_trajectory(tmp_path / "x", name="doc")
    with pytest.raises(InputError, match=r"trajectory\.no_attitudes"):
        rotations_in(replace(t, rotation=None), None)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("101,N", "101", r"1.*mrk\.tag_missing"),
        ("22.77995359,Lat", "122.7,Lat", r"1.*90.*mrk\.out_of_range"),
        ("[2404]\t   -3", "\t   -3", r"2.*1.*3.*mrk\.line"),
        ("0.5, 0.6, 1.2", "0.5, 0.6", r"2.*mrk\.sigmas_missing"),
        ("0.5, 0.6, 1.2", "-0.5, 0.6, 1.2", r"mrk\.sigmas_out_of_range"),
        ("3\t282406", "2\t282406", r"3.*1.*2.*cell\.id_twice"),
        ("282401.669089", "982401.6", r"1.*2.*mrk\.second_of_week"),
        ("139.4,Ellh\t0.5, 0.6, 1.2\t34,Q", "139.4,El", r"2.*mrk\.tag_missing"),
    ],
)
def test_bad_mrk_files_are_named(mrk, old, new, words):
    assert old in MRK
    mrk.write_text(MRK.replace(old, new, 1))
    with pytest.raises(InputError, match=words):
        read_trajectory(mrk)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("image,X,Y,Z,omega_deg,phi_deg,kappa_deg\na,1,2,3,4,5,x\n", r"2.*kappa_deg.*cell\.not_a_number"),
        ("image,X,Y,omega_deg,phi_deg,kappa_deg\na,1,2,4,5,6\n", r"1.*table\.one_position"),
        ("image,X,Y,Z,omega_deg,phi_deg,kappa_deg,sX\na,1,2,3,4,5,6,-1\n", r"cell\.negative_sigma"),
        (
            "image,longitude_deg,latitude_deg,height_m,roll_deg,pitch_deg,yaw_deg\na,49,114,3,4,5,6\n",
            r"2.*latitude_deg.*114.*90.*position\.beyond_degrees",
        ),
        (
            "image,X,Y,Z,roll_deg,pitch_deg,yaw_deg,roll_rad,pitch_rad,yaw_rad\na,1,2,3,4,5,6,1,1,1\n",
            r"table\.three_angles",
        ),
        ("image,X,Y,Z,heading\na,1,2,3,4\n", r"trajectory\.format_unknown"),
        ("", r"trajectory\.format_unknown"),
    ],
)
def test_bad_tables_are_named(tmp_path, text, words):
    path = tmp_path / "t.csv"
    path.write_text(text)
    with pytest.raises(InputError, match=words):
        read_trajectory(path)


DAMAGE = st.lists(st.tuples(st.floats(0, 1), st.integers(0, 9), st.binary(max_size=6)), min_size=1, max_size=4)


@pytest.mark.parametrize("name", WRITTEN)
@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(damage=DAMAGE)
def test_damaged_files(name, tmp_path, damage):
    path = tmp_path / "t.x"
    path.unlink(missing_ok=True)
    write_trajectory(trajectory(name, path), path, name=name)
    data = path.read_bytes()
    for share, length, new in damage:
        at = int(share * len(data))
        data = data[:at] + new + data[at + length :]
    path.write_bytes(data)
    try:
        assert isinstance(read_trajectory(path, name=name), Trajectory)
    except InputError as error:
        assert str(path) in str(error)  # noqa: PT017


@pytest.mark.parametrize("beside", ["", ",antenna", ",X_adjusted,Y_adjusted,Z_adjusted,vX,vY,vZ,rX,rY,rZ,wX,wY,wZ"])
def test_positions_without_attitudes_as_the_stations_of_a_result(tmp_path, beside):
    file = tmp_path / "stations.csv"
    row = "a.jpg,1.5,2,3,0.1,0.2,0.3" + "," * beside.count(",")
    file.write_text(f"image,X,Y,Z,sX,sY,sZ{beside}\n{row}\n")
    t = read_trajectory(file)
    np.testing.assert_array_equal(t.xyz, [[1.5, 2, 3]])
    np.testing.assert_array_equal(t.sigma, [[0.1, 0.2, 0.3]])
    assert (t.names, t.crs, t.rotation) == (("a.jpg",), None, None)


def test_correlated_positions_become_correlated_stations(tmp_path):
    """A stations.csv of a block with its coefficients, there and back; photographs cannot keep them, which is said."""
    path = tmp_path / "ppk.csv"
    path.write_text(
        "image,longitude_deg,latitude_deg,height_m,sX,sY,sZ,rXY,rXZ,rYZ\n"
        "a.jpg,113.9,22.77,40,0.01,0.02,0.03,0.5,-0.25,0.125\nb.jpg,113.9,22.77,41,0.01,0.02,0.03,,,\n"
    )
    t = read_trajectory(path)
    s = stations_of(t, ["b.jpg", "a.jpg"], FRAME)
    np.testing.assert_array_equal(s.correlation, [[0, 0, 0], [0.5, -0.25, 0.125]])
    write_trajectory(t, tmp_path / "again.csv", name="positions")
    np.testing.assert_array_equal(read_trajectory(tmp_path / "again.csv").correlation, t.correlation)
    photo = Photo(name="a.jpg", metadata=Metadata(), path=path, width_px=1, height_px=1, sha256="")
    _, remarks = with_positions([photo], t)
    assert any(code_of(r) == "position_list.correlations" for r in remarks)


def test_a_list_in_a_grid_gives_the_frame_of_its_photographs(tmp_path):
    path = tmp_path / "geo.txt"
    path.write_text("EPSG:32632\na.jpg 500000 5300000 100\nb.jpg 500020 5300040 120\nfar.jpg 600000 5300000 0\n")
    photos = [
        Photo(path=tmp_path / n, name=n, width_px=4, height_px=3, sha256="", metadata=Metadata())
        for n in ("a.jpg", "b.jpg")
    ]
    frame = frame_of_positions(photos, read_trajectory(path))
    assert frame.crs == "EPSG:32632"
    assert frame.origin == pytest.approx((500010, 5300020, 110))
    path.write_text("EPSG:4326\na.jpg 9.1 47.2 100\nb.jpg 9.2 47.2 120\n")
    assert frame_of_positions(photos, read_trajectory(path)) is None
