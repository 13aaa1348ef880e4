"""Aerial line scanners: the file, its signs against a simulated flight, boresight and clock in the adjustment."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import trapezoid
from scipy.stats import chi2

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.system.predict import image_points
from raybundle.errors import InputError, RankDefect
from raybundle.io.block.folder import read_block, write_block
from raybundle.io.digits import EVERY
from raybundle.io.scenes import read_scene
from raybundle.io.scenes.airborne import companions
from raybundle.io.tables import write_table
from raybundle.numerics.attitude import NADIR_FROM_BODY, opk_from_rotation, rotation_from_rpy
from raybundle.numerics.geodesy import (
    LocalPlace,
    enu_from_geocentric,
    geocentric_from_geographic,
    geographic_from_geocentric,
)  # fmt: skip
from raybundle.numerics.places import Local
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.simulate import measured
from raybundle.scenes.corrections import Fixes
from raybundle.scenes.kinds.linescan import LineSensor
from raybundle.scenes.light import refraction_shift
from raybundle.scenes.sensor import scene_camera, view_of
from raybundle.scenes.trajectory import CorrectionModel
from tests.truth.mixed_blocks import MonteCarlo, block_of, control_table

PLACE = (15.0, 48.0, 300.0)
LINES, INTERVAL = 5000, 0.002
LEVER, BORESIGHT, LATE = np.array([0.12, -0.35, 0.8]), np.array([0.004, -0.003, 0.006]), 0.013
HEAD = """
scanner = "simulated"
width_px = 8000
height_px = {lines}

[lens]
c_mm = 62.7
pixel_mm = 0.0065
y0_mm = {y0}

[lines]
first_s = {first}
interval_s = {interval}

[trajectory]
file = "{name}.csv"
lever_arm_m = [{lever[0]}, {lever[1]}, {lever[2]}]
boresight_deg = [0.0, 0.0, 0.0]
"""


def flight(heading_deg, *, unsteady=1.0, offset=0.0):
    """Times, geographic positions and rotations (east, north, up to image) of 12 s at 1200 m above the ground."""
    t = np.arange(-1.0, 11.0001, 0.01)
    h = np.radians(heading_deg)
    along = 60.0 * (t - 5.0) + unsteady * 4.0 * np.sin(0.9 * t)
    across = offset + unsteady * 3.0 * np.sin(0.6 * t + 1)
    local = np.stack(
        [
            along * np.sin(h) + across * np.cos(h),
            along * np.cos(h) - across * np.sin(h),
            1200 + unsteady * 2 * np.cos(t),
        ],
        axis=1,
    )
    geographic = LocalPlace(origin=PLACE).geographic_from_local(local)
    wave = np.stack([np.sin(1.1 * t), np.sin(0.8 * t + 2), np.sin(0.5 * t + 4)], axis=1)
    return t, geographic, rotation_from_rpy(unsteady * np.radians(0.8) * wave + [0.0, 0.0, h])


def write_strip(folder, name, heading, *, late=0.0, boresight=(0.0, 0.0, 0.0), unsteady=1.0, y0=0.0, offset=0.0):
    """A scene file whose table tells the flight as a clock that is late and an IMU that is askew do."""
    t, geographic, R = flight(heading, unsteady=unsteady, offset=offset)
    to_enu = enu_from_geocentric(geographic)
    P = geocentric_from_geographic(geographic) + np.einsum("nji,njk,k->ni", to_enu, np.swapaxes(R, 1, 2), LEVER)
    place = LocalPlace(origin=PLACE)
    antenna = place.geographic_from_local(place.local_from_geocentric(P))
    angles = np.degrees(opk_from_rotation(rotation_from_vector(-np.array(boresight)) @ R))
    columns = {"time_s": t + late}
    columns |= {n: antenna[:, k] for k, n in enumerate(("longitude_deg", "latitude_deg", "height_m"))}
    columns |= {n: angles[:, k] for k, n in enumerate(("omega_deg", "phi_deg", "kappa_deg"))}
    columns |= {n: np.full(len(t), 0.05) for n in ("sX", "sY", "sZ")}
    columns |= {n: np.full(len(t), 0.003) for n in ("somega_deg", "sphi_deg", "skappa_deg")}
    write_table(folder / f"{name}.csv", columns, EVERY)
    head = HEAD.format(name=name, lines=LINES, interval=INTERVAL, first=INTERVAL / 2, lever=LEVER, y0=y0)
    (folder / f"{name}.toml").write_text(head)
    return folder / f"{name}.toml"


def strips(folder, corrections, headings=(30.0, 210.0), *, smooth=None, sigma=None, estimate=None, control=8, **how):
    """A block of strips over the same ground, of points on it."""
    place, rng = Local(origin=PLACE), np.random.default_rng(3)
    cameras = []
    for k, heading in enumerate(headings):
        file = write_strip(folder, f"strip{k + 1}", heading, offset=150.0 * (k % 2), **how)
        sensor = LineSensor(read_scene(file).rigorous, place, corrections, PLACE[2], file, smooth)
        cameras.append(scene_camera(f"strip{k + 1}", sensor, sigma=sigma, estimate=estimate))
    across, along = rng.uniform(-330, 330, 70), rng.uniform(-280, 280, 70)
    h = np.radians(headings[0])
    xyz = np.column_stack(
        [along * np.sin(h) + across * np.cos(h), along * np.cos(h) - across * np.sin(h), rng.uniform(-30, 30, 70)]
    )
    views = [view_of(c) for c in cameras]
    return block_of(
        cameras, np.arange(len(cameras)), [v.centre for v in views], [v.rotation for v in views], xyz,
        *control_table(70, control, 10, 0.03), held=np.ones(len(cameras), bool), place=place,
    )  # fmt: skip


def noisy(block, sigma_px):
    """Image points of all points of a block, with errors."""
    block, rng = measured(block, sigma_px), np.random.default_rng(1)
    o = block.observations
    return replace(block, observations=replace(o, xy_px=o.xy_px + rng.normal(0, sigma_px, o.xy_px.shape)))


def test_a_strip_sees_the_ground_where_the_flight_says(tmp_path):
    line = read_scene(write_strip(tmp_path, "one", 30.0)).rigorous
    t, geographic, R = flight(30.0)
    ground = LocalPlace(origin=PLACE).geographic_from_local(np.array([[40.0, 20.0, 10.0], [-120.0, 160.0, -25.0]]))
    bare = line.without_corrections()
    for point, (x, y) in zip(ground, bare.project(ground), strict=True):
        k = np.argmin(np.abs(t - (y - 0.5) * INTERVAL - INTERVAL / 2))  # line y is taken at 1 ms + 2 ms (y - 1/2)
        d = geocentric_from_geographic(point[None]) - geocentric_from_geographic(geographic[k : k + 1])
        U, V, W = R[k] @ enu_from_geocentric(geographic[k : k + 1])[0] @ d[0]
        assert W < 0
        assert pytest.approx((x - 4000) * 0.0065, abs=0.02) == U / W * -62.7
        assert abs(62.7 * V / W) < 0.03  # the table's steps are 5 lines long
    xy = np.random.default_rng(1).uniform(0, [8000, LINES], (200, 2))
    assert np.abs(line.project(line.localise(xy, 310.0)) - xy).max() < 1e-6


def test_the_place_of_the_line_and_columns_to_the_left(tmp_path):
    file = write_strip(tmp_path, "one", 0.0, unsteady=0.0, y0=20.0)
    ahead = read_scene(file).rigorous
    _, d = ahead.rays(np.array([[4000.0, 2500.0]]))
    up, north = enu_from_geocentric(np.array([PLACE]))[0][[2, 1]]
    assert d[0] @ up < 0
    assert d[0] @ north / -(d[0] @ up) == pytest.approx(20 / 62.7, rel=1e-3)  # y0 > 0 looks ahead
    text = file.read_text()
    file.write_text(text.replace("pixel_mm = 0.0065", "pixel_mm = -0.0065"))
    xy = np.array([[1000.0, 600.0]])
    other = read_scene(file).rigorous.localise(xy, 300.0)
    assert np.abs(other - ahead.localise(8000 * np.array([[1, 0]]) + xy * [-1, 1], 300.0)).max() < 1e-9
    (tmp_path / "lens.csv").write_text("x_px,x_mm,y_mm\n0,-26,20\n4000,0,20\n8000,26,20\n")
    file.write_text(text.replace("pixel_mm = 0.0065\ny0_mm = 20.0", 'detector = "lens.csv"'))
    assert np.abs(read_scene(file).rigorous.localise(xy, 300.0) - ahead.localise(xy, 300.0)).max() < 1e-9


MODEL = CorrectionModel(attitude_degree=0, time_offset=True)


def test_boresight_and_clock_are_found_again(tmp_path):
    truth = noisy(strips(tmp_path, MODEL), 0.1)
    (tmp_path / "late").mkdir()
    block = strips(tmp_path / "late", MODEL, late=LATE, boresight=BORESIGHT)
    result = adjust_block(replace(block, observations=truth.observations, points=truth.points))
    assert result.sigma0 < 1.2  # the table is interpolated
    for interior in result.interior:
        p = interior.parameters
        for symbol, value in zip(("rx0", "ry0", "rz0", "dt"), (*BORESIGHT, LATE), strict=True):
            assert abs(p[symbol].value - value) < 4 * p[symbol].std < 0.2 * abs(value)
            assert p[symbol].status == "estimated"
    assert not result.not_determinable


@pytest.mark.long
def test_curves_boresight_and_clock_have_true_sigmas(tmp_path):
    """GNSS of 5 cm and INS of 0.003 degrees drift within the strips: fixes whose prior the table tells."""
    model = CorrectionModel(
        position_curve=Fixes(count=3), attitude_degree=0, attitude_curve=Fixes(count=5), time_offset=True
    )
    block = measured(strips(tmp_path, model), 0.3)
    sigma = block.cameras[0].sigma
    assert sigma["along_2"] == 0.05
    assert sigma["ry_3"] == pytest.approx(np.radians(0.003))
    assert not {"dt", "rx0"} & set(sigma)
    runs = 15
    found = MonteCarlo.of(block).errors(runs, seed=8)
    assert found[f"parameters of {block.cameras[0].id}"][1] == 9 + 3 + 15 + 1
    for kind, (d2, degrees) in found.items():
        low, high = chi2(degrees * runs).interval(0.999)
        assert low < d2.sum() < high, kind


def test_on_a_steady_flight_the_clock_is_not_told_from_a_shift(tmp_path):
    model = CorrectionModel(position_degree=0, time_offset=True)

    def strip(**how):
        return noisy(strips(tmp_path, model, (30.0,), unsteady=0.0, control=40, **how), 0.3)

    try:
        named = " ".join(adjust_block(strip(sigma={})).not_determinable)
    except RankDefect as error:
        named = str(error)
    assert "dt " in named
    assert "along0 " in named
    result = adjust_block(strip())  # positions of 5 cm tell the clock to 5 cm / 60 m/s
    assert result.interior[0].parameters["dt"].std / result.sigma0 == pytest.approx(0.05 / 60, rel=0.05)


@pytest.mark.long
def test_a_lever_arm_is_estimated_where_headings_differ(tmp_path):
    model = CorrectionModel(lever_arm=True)
    truth = noisy(strips(tmp_path, model, (30.0, 210.0, 120.0)), 0.1)
    for k in (1, 2, 3):
        file = tmp_path / f"strip{k}.toml"
        file.write_text(file.read_text().replace("lever_arm_m = [0.12, -0.35, 0.8]", "lever_arm_m = [0, 0, 0]"))
    place = Local(origin=PLACE)
    cameras = tuple(
        scene_camera(c.id, LineSensor(read_scene(c.scene.file).rigorous, place, model, PLACE[2], c.scene.file))
        for c in truth.cameras
    )
    views = [view_of(c) for c in cameras]
    images = replace(
        truth.images, centre=np.array([v.centre for v in views]), rotation=np.array([v.rotation for v in views])
    )
    result = adjust_block(replace(truth, cameras=cameras, images=images))
    for interior in result.interior:
        for symbol, value in zip(("ax", "ay", "az"), LEVER, strict=True):
            p = interior.parameters[symbol]
            assert abs(p.value - value) < 4 * p.std < 0.16


def test_strips_go_through_block_folders(tmp_path):
    model = CorrectionModel(
        position_degree=0, attitude_degree=0, attitude_curve=Fixes(count=5), time_offset=True, lever_arm=True
    )
    sigma = {"rx_3": 1e-5, "along0": 0.1} | {f"ry_{k}": 2e-5 for k in range(1, 6)}
    free = tuple(s for s in model.symbols if not s.startswith("a") or s == "along0")
    block = measured(strips(tmp_path, model, smooth={"rz": 1e-5}, sigma=sigma, estimate=free), 0.3)
    write_block(block, tmp_path / "block")
    again = read_block(tmp_path / "block")
    text = (tmp_path / "block" / "block.toml").read_text(encoding="utf-8")
    assert "attitude_fixes = 5" in text
    assert "ry = 2e-05" in text
    write_block(again, tmp_path / "twice")
    assert (tmp_path / "twice" / "block.toml").read_text(encoding="utf-8") == text
    for a, b in zip(block.cameras, again.cameras, strict=True):
        assert b.scene.corrections == model
        assert b.scene.smooth == {"rz": 1e-5}
        assert set(b.estimate) == set(a.estimate)
        assert (dict(b.sigma), b.relations) == (dict(a.sigma), a.relations)
        xy = np.array([[1000.0, 300.0], [7000.0, 4800.0]])
        assert (
            np.abs(b.scene.localise(xy, 300.0, b.parameters) - a.scene.localise(xy, 300.0, a.parameters)).max() < 1e-6
        )


def with_own_attitudes(folder, name, every=3, shift=0.004):
    """The strip's angles in a table of their own, at other times than the positions."""
    from raybundle.io.scenes.airborne import _table

    path = folder / f"{name}.csv"
    given = read_scene(folder / f"{name}.toml").rigorous.trajectory
    both = _table(path, "both")
    rows = [r.split(",") for r in path.read_text().splitlines()]
    keep = [k for k, n in enumerate(rows[0]) if not n.removeprefix("s").startswith(("omega", "phi", "kappa"))]
    path.write_text("\n".join(",".join(r[k] for k in keep) for r in rows) + "\n")
    t = np.arange(both.time[2], both.time[-3], 0.01 * every) + shift
    R = given.rotation(t)[0].swapaxes(1, 2)
    P = geographic_from_geocentric(given.position(t)[0])
    angles = np.degrees(opk_from_rotation(R @ np.swapaxes(enu_from_geocentric(P), 1, 2)))
    names = ("omega_deg", "phi_deg", "kappa_deg")
    write_table(folder / "ins.csv", {"time_s": t} | {n: angles[:, k] for k, n in enumerate(names)}, EVERY)
    toml = folder / f"{name}.toml"
    toml.write_text(toml.read_text().replace(f'file = "{name}.csv"', f'file = "{name}.csv"\nattitudes = "ins.csv"'))
    return toml


def test_angles_with_times_of_their_own(tmp_path):
    write_strip(tmp_path, "one", 40.0)
    before = read_scene(tmp_path / "one.toml").rigorous
    after = read_scene(with_own_attitudes(tmp_path, "one")).rigorous
    assert len(after.trajectory.attitude_times) < len(after.trajectory.position_times) / 2
    xy = np.array([[10.0, 10.0], [7990.0, 2500.0], [4000.0, 4990.0]])
    # 0.03 s between attitudes that swing with a period of 6 s
    np.testing.assert_allclose(after.project(before.localise(xy, 300.0)), xy, atol=0.02)
    names = {f.name for f in companions(tmp_path / "one.toml")}
    assert names == {"one.csv", "ins.csv"}


def test_a_table_of_angles_without_angles(tmp_path):
    write_strip(tmp_path, "one", 40.0)
    toml = with_own_attitudes(tmp_path, "one")
    (tmp_path / "ins.csv").write_text("time_s,omega_deg,phi_deg\n0,1,2\n1,1,2\n")
    with pytest.raises(InputError, match=r"ins\.csv.*1.*table\.three_angles"):
        read_scene(toml)
    (tmp_path / "ins.csv").write_text("time_s,X\n0,1\n1,1\n")
    with pytest.raises(InputError, match=r"ins\.csv.*1.*table\.unknown_column"):
        read_scene(toml)


UNEVEN = (0.0, 1.5, 2.0, 4.5, 7.0, 9.9)


def test_fixes_at_given_times_go_through_block_folders(tmp_path):
    """By a list, by the times of the trajectory's table and by a file with what is known there."""
    line = read_scene(write_strip(tmp_path, "one", 40.0)).rigorous
    text = BLOCK.format(fixes=f"attitude_fixes = {list(UNEVEN)}")
    block = one_strip(tmp_path, text)
    curve = block.cameras[0].scene.corrections.attitude_curve
    assert curve == line.fixes_at(np.array(UNEVEN))
    np.testing.assert_allclose([line.time_of_fix(t) for t in curve.at], UNEVEN, atol=1e-9)
    write_block(block, tmp_path / "again")
    written = (tmp_path / "again/block.toml").read_text()
    assert "attitude_fixes = [0.0, 1.5, 2.0, 4.5, 7.0, 9.9]" in written
    assert read_block(tmp_path / "again").cameras[0].scene.corrections == block.cameras[0].scene.corrections

    with pytest.raises(InputError, match=r"1\D?002.*orientation_fix\.count"):  # a hundred a second
        one_strip(tmp_path, BLOCK.format(fixes='position_fixes = "table"'))
    with_own_attitudes(tmp_path, "one", every=20)
    camera = one_strip(tmp_path, BLOCK.format(fixes='attitude_fixes = "table"')).cameras[0]
    scene = camera.scene.scene
    times = [scene.time_of_fix(t) for t in camera.scene.corrections.attitude_curve.at]
    given = scene.trajectory.attitude_times
    first, last = scene.time(np.array([0.0, float(scene.height_px)]))[0]
    assert times[0] <= first < times[1]
    assert times[-2] < last <= times[-1]
    np.testing.assert_allclose(times, given[np.isin(given.round(6), np.round(times, 6))], atol=1e-9)

    (tmp_path / "fixes.csv").write_text(
        "time_s,rx_rad,srx_rad,srz_rad\n0,1e-5,2e-6,\n2,,2e-6,3e-5\n5,3e-5,4e-6,3e-5\n9,0,2e-6,3e-5\n"
    )
    camera = one_strip(tmp_path, BLOCK.format(fixes='attitude_fixes = "fixes.csv"\nsigma = {rx_1 = 1e-6}')).cameras[0]
    assert (camera.values["rx_1"], camera.values["rx_2"], camera.values["rx_3"]) == (1e-5, 0.0, 3e-5)
    assert camera.sigma["rx_1"] == 1e-6  # block.toml stands before the file
    assert camera.sigma["rx_3"] == 4e-6
    assert camera.sigma["rz_2"] == 3e-5
    assert "rz_1" not in camera.sigma


@pytest.mark.parametrize(
    ("fixes", "message"),
    [
        ("[1.0]", r"block\.toml.*cameras\.one\.attitude_fixes.*1.*2.*orientation_fix\.count"),
        ("[1.0, 2.0, 2.0]", r"3.*2.*orientation_fix\.time_order"),
        ("[100.0, 200.0]", r"orientation_fix\.outside_image"),
        ('["a", 2.0]', r"value\.not_a_number"),
        ('"none.csv"', "none.csv"),
    ],
)
def test_fixes_that_are_none(tmp_path, fixes, message):
    write_strip(tmp_path, "one", 40.0)
    with pytest.raises(InputError, match=message):
        one_strip(tmp_path, BLOCK.format(fixes=f"attitude_fixes = {fixes}"))


BLOCK = """
name = "one"
length_unit = "m"
[frame]
kind = "local"
origin = [15.0, 48.0, 300.0]
[cameras.one]
model = "linescan"
scene = "one.toml"
height_m = 300.0
{fixes}
"""


def one_strip(folder, text):
    """A block folder of one scene, with one point."""
    (folder / "block.toml").write_text(text)
    (folder / "images.csv").write_text("image,camera,file,X,Y,Z,omega_deg,phi_deg,kappa_deg\none,one,,,,,,,\n")
    (folder / "observations.csv").write_text("image,point,x_px,y_px,sx_px,sy_px\none,a,4000,2500,0.3,0.3\n")
    (folder / "points.csv").write_text("point,role,X,Y,Z,sX,sY,sZ\na,control,0,0,0,0.1,0.1,0.1\n")
    return read_block(folder)


def test_refraction_from_the_air_and_its_derivatives():
    X, up = np.array([[6.4e6, 0.0, 0.0]]), np.array([[1.0, 0.0, 0.0]])

    def shift(sensor, at=X):
        height = at[:, 0] - 6.4e6
        return refraction_shift(at, sensor, height, at / np.linalg.norm(at, axis=1)[:, None])

    sensor = X + np.array([[3e3, 3e3, 0.0]])
    # the integral of n - n_sensor from the ground to 3 km, times tan z / cos^2 z
    z = np.linspace(0, 3e3, 20_001)
    n = 2.9e-4 * (np.exp(-z / 8400) - np.exp(-3e3 / 8400))
    assert shift(sensor)[0][0] == pytest.approx([0, -2 * trapezoid(n, z), 0], rel=1e-6, abs=1e-9)
    for axis in range(3):
        d = np.zeros((1, 3))
        d[0, axis] = 1.0
        numeric = (shift(sensor + d)[0] - shift(sensor - d)[0]) / 2
        assert np.abs(numeric - shift(sensor)[2][:, :, axis]).max() < 1e-9
    del up


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("first_s = 0.001", "first_s = 500.0", r"-1.*11 s.*trajectory\.not_covered"),
        ('file = "one.csv"', 'file = "../one.csv"', r"scene\.file_elsewhere"),
        ("c_mm = 62.7", "c_mm = 62.7\nf_mm = 3", r"f_mm.*toml\.unknown_key"),
        ("interval_s = 0.002", 'interval_s = 0.002\ntable = "lines.csv"', r"table.*scene\.keys_exclusive"),
        ("boresight_deg = [0.0, 0.0, 0.0]", "boresight_deg = 3", r"value\.count"),
        ("boresight_deg = [0.0, 0.0, 0.0]", 'crs = "EPSG:25833"', r"scene\.crs_superfluous"),
    ],
)
def test_scene_files_with_mistakes(tmp_path, old, new, message):
    file = write_strip(tmp_path, "one", 30.0)
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))
    with pytest.raises(InputError, match=message):
        read_scene(file)


def test_tables_with_mistakes(tmp_path):
    file = write_strip(tmp_path, "one", 30.0)
    table = tmp_path / "one.csv"
    lines = table.read_text().split("\n")
    table.write_text("\n".join([lines[0], lines[2], lines[1], *lines[3:]]))
    with pytest.raises(InputError, match=r"one\.csv.*3.*table\.time_order"):
        read_scene(file)
    table.write_text("\n".join(["kappa_deg".join(lines[0].split("kappa_deg")[:1]) + "yaw_deg", *lines[1:]]))
    with pytest.raises(InputError):
        read_scene(file)


def test_a_grid_and_true_north_are_told_apart(tmp_path):
    """The same flight in UTM coordinates with roll, pitch, yaw against true north."""
    from raybundle.io.geo.coordinate_systems import local_frame
    from raybundle.numerics.attitude import rpy_from_rotation

    one = read_scene(write_strip(tmp_path, "one", 30.0)).rigorous
    t, geographic, R = flight(30.0)
    frame = local_frame("EPSG:32633", (500000.0, 5316000.0, 300.0))
    place = LocalPlace(origin=PLACE)
    to_enu = enu_from_geocentric(geographic)
    P = geocentric_from_geographic(geographic) + np.einsum("nji,njk,k->ni", to_enu, np.swapaxes(R, 1, 2), LEVER)
    antenna = place.geographic_from_local(place.local_from_geocentric(P))
    xyz = frame.crs_from_local(frame.local_from_wgs84(antenna))
    rpy = np.degrees(rpy_from_rotation(R, NADIR_FROM_BODY))
    columns = {"time_s": t} | {n: xyz[:, k] for k, n in enumerate("XYZ")}
    columns |= {n: rpy[:, k] for k, n in enumerate(("roll_deg", "pitch_deg", "yaw_deg"))}
    write_table(tmp_path / "one.csv", columns, EVERY)
    file = tmp_path / "one.toml"
    file.write_text(file.read_text() + 'crs = "EPSG:32633"\n')
    two = read_scene(file).rigorous
    xy = np.array([[500.0, 100.0], [7500.0, 4900.0]])
    assert np.abs((one.localise(xy, 300.0) - two.localise(xy, 300.0)) * [7e4, 1.1e5, 1]).max() < 2e-3  # m


def test_what_a_strip_does_not_see_takes_nothing_from_the_others(tmp_path):
    """Nothing asked, points far beside and above the flight: NaN, and the seen ones where they are."""
    block = strips(tmp_path, MODEL)
    camera, R, X0 = block.cameras[0], block.images.rotation[0], block.images.centre[0]
    assert image_points(camera, R, X0, np.zeros((0, 3))).shape == (0, 2)
    near = block.points.xyz[:6]
    seen = image_points(camera, R, X0, near)
    assert np.isfinite(seen).all(axis=1).any()
    beyond = np.vstack([near, [[5e4, 0, 0], [0, 0, -7e5]]])
    found = image_points(camera, R, X0, beyond)
    np.testing.assert_allclose(found[:6], seen, atol=1e-9)
    assert np.isnan(found[6:]).all()
