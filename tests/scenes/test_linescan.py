"""Line sensors: derivatives, round trips, corrections; vendors' orbits against the vendors' own RPC."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.errors import InputError, NoConvergence, NotSolvable
from raybundle.io.scenes import read_scene
from raybundle.numerics.geodesy import geocentric_from_geographic
from raybundle.scenes.light import C_LIGHT, apparent_direction, refraction_shift
from raybundle.scenes.scan import observe_line
from raybundle.scenes.trajectory import CorrectionModel, Trajectory, lagrange, rotation_from_quaternion
from tests.scenes.conftest import make_scene

FULL = CorrectionModel(position_degree=2, attitude_degree=2)


def image_points(scene, n, seed=0):
    return np.random.default_rng(seed).uniform(0, [scene.width_px, scene.height_px], (n, 2))


def corrections(seed=1):
    rng = np.random.default_rng(seed)
    return np.concatenate([rng.normal(0, 20, 9), rng.normal(0, 1e-4, 9)])


@pytest.mark.parametrize("kind", ["full", "no aberration", "no refraction", "neither"])
def test_there_and_back(scene, kind):
    one = replace(
        scene, aberration=kind not in {"no aberration", "neither"}, refraction=kind not in {"no refraction", "neither"}
    )
    xy = image_points(one, 500)
    heights = np.random.default_rng(2).uniform(-100, 4000, 500)
    ground = one.localise(xy, heights, FULL, corrections())
    again = one.observe_geocentric(geocentric_from_geographic(ground), FULL, corrections()).xy_px
    assert np.abs(again - xy).max() < 1e-6


def test_all_partials_of_an_observation(scene, place):
    values = corrections()
    xyz = place.local_from_geographic(scene.localise(image_points(scene, 60), 300.0, FULL, values))
    seen = observe_line(scene, place, xyz, FULL, values)
    assert seen.by_parameters.shape == (60, 2, len(FULL.symbols))
    for axis in range(3):
        step = np.zeros(3)
        step[axis] = 2.0
        one, two = (observe_line(scene, place, xyz + s * step, FULL, values).xy_px for s in (1, -1))
        assert np.abs((one - two) / 4 - seen.by_point[:, :, axis]).max() < 1e-6 * np.abs(seen.by_point).max()
    for k, symbol in enumerate(FULL.symbols):
        step = np.zeros(len(values))
        step[k] = 1e-6 if symbol.startswith("r") else 0.2
        one, two = (observe_line(scene, place, xyz, FULL, values + s * step).xy_px for s in (1, -1))
        J = seen.by_parameters[:, :, k]
        assert np.abs((one - two) / (2 * step[k]) - J).max() < 1e-6 * np.abs(J).max(), symbol


def test_a_model_without_corrections_has_no_parameters(scene, place):
    xyz = place.local_from_geographic(scene.localise(image_points(scene, 3), 300.0))
    seen = observe_line(scene, place, xyz, CorrectionModel(), np.zeros(0))
    assert seen.by_parameters.shape == (3, 2, 0)
    constant = observe_line(scene, place, xyz, CorrectionModel(attitude_degree=0), np.zeros(3))
    assert np.abs(constant.xy_px - seen.xy_px).max() < 1e-9


def test_projection_is_where_the_ray_says(scene):
    plain = scene.without_corrections()
    xy = image_points(plain, 40)
    P, d = plain.rays(xy)
    X = P + d * np.linspace(6e5, 7e5, 40)[:, None]
    assert np.abs(plain.observe_geocentric(X).xy_px - xy).max() < 1e-7


def test_aberration_turns_towards_the_velocity():
    rng = np.random.default_rng(3)
    d = rng.normal(size=(50, 3))
    d /= np.linalg.norm(d, axis=1)[:, None]
    beta = rng.normal(0, 7500 / C_LIGHT, (50, 3))
    u, by_d, by_beta = apparent_direction(d, beta)
    assert np.abs(np.linalg.norm(u, axis=1) - 1).max() < 1e-14
    back = u - beta
    assert np.abs(back / np.linalg.norm(back, axis=1)[:, None] - d).max() < 1e-14
    for axis in range(3):
        step = np.zeros(3)
        step[axis] = 1e-6
        numeric = (apparent_direction(d + step, beta)[0] - apparent_direction(d - step, beta)[0]) / 2e-6
        assert np.abs(numeric - by_d[:, :, axis]).max() < 1e-8
        numeric = (apparent_direction(d, beta + step)[0] - apparent_direction(d, beta - step)[0]) / 2e-6
        assert np.abs(numeric - by_beta[:, :, axis]).max() < 1e-8


def test_refraction_by_its_formula():
    # at 45 degrees from the zenith and at sea level: (n0 - 1) 8400 m tan z / cos^2 z = 2.9e-4 x 8400 m x 2
    X, up = np.array([[6.4e6, 0.0, 0.0]]), np.array([[1.0, 0.0, 0.0]])
    sensor = X + np.array([[6e5, 6e5, 0.0]])
    shift = refraction_shift(X, sensor, np.zeros(1), up)[0][0]
    assert shift == pytest.approx([0, -2 * 2.9e-4 * 8400, 0], rel=1e-12)
    assert np.abs(refraction_shift(X, X + np.array([[6e5, 0, 0]]), np.zeros(1), up)[0]).max() == 0
    thin = refraction_shift(X, sensor, np.full(1, 8400.0), up)[0][0]
    assert thin == pytest.approx(shift / np.e, rel=1e-12)


@pytest.mark.parametrize("name", ["wv_test1", "wv_test2", "dg_example1"])
def test_rigorous_model_and_vendors_rpc(sensors, name):
    s = read_scene(sensors / "maxar" / f"{name}.xml")
    size = np.minimum([s.width_px, s.height_px], s.rpc.image_offset + s.rpc.image_scale)
    steps = (np.arange(25) + 0.5) / 25
    heights = s.rpc.ground_offset[2] + s.rpc.ground_scale[2] * np.array([-0.8, 0.0, 0.8])
    x, y, h = (a.ravel() for a in np.meshgrid(steps * size[0], steps * size[1], heights))
    xy = np.stack([x, y], axis=1)
    difference = xy - s.rpc.project(s.rigorous.localise(xy, h))
    assert (np.abs(difference.mean(axis=0)) < 0.35).all()
    assert (difference.std(axis=0) < 0.25).all()
    bare = xy - s.rpc.project(s.rigorous.without_corrections().localise(xy, h))
    assert np.linalg.norm(bare.mean(axis=0)) > 10


def test_published_facts_of_dg_example1(sensors):
    line = read_scene(sensors / "maxar/dg_example1.xml").rigorous
    path = line.trajectory
    assert len(path.positions) == 840
    assert path.positions[0] == pytest.approx([-1150529.111070304, -4900037.170821411, 4673402.253879593], abs=1e-6)
    first, last = line.time(np.array([0.5, 23708.5]))[0]
    assert last - first == pytest.approx(1.975667, abs=1e-9)
    # the first element lies at the detector's origin, the principal distance is 7949.165 mm, the pitch 0.008 mm
    psi, slope = line.look(np.array([0.5]))
    assert psi[0] == pytest.approx(np.array([0.05372, 140.71193]) / 7949.165, rel=1e-9)
    assert slope[0, 1] == pytest.approx(-0.008 / 7949.165, rel=1e-9)


def test_lagrange_returns_the_table_and_polynomials():
    t = np.sort(np.random.default_rng(4).uniform(0, 10, 30))
    values = np.stack([t**5 - 3 * t**2, 7 + 0 * t], axis=1)
    p = lagrange(t, values)
    assert np.abs(p(t) - values).max() < 1e-9
    between = (t[1:] + t[:-1]) / 2
    assert np.abs(p(between)[:, 0] - (between**5 - 3 * between**2)).max() < 1e-5
    straight = lagrange(t, 3 * values[:, 1:] + t[:, None], beyond=1)
    assert straight(t[-1] + 1.0)[0] == pytest.approx(22 + t[-1], abs=1e-6)
    assert straight(t[0] - 1.0)[0] == pytest.approx(20 + t[0], abs=1e-6)


def test_rotation_and_its_rate():
    s = make_scene()
    t = np.linspace(-0.3, 0.3, 50)
    R, dR = s.trajectory.rotation(t)
    assert np.abs(R @ np.swapaxes(R, 1, 2) - np.eye(3)).max() < 1e-12
    numeric = (s.trajectory.rotation(t + 1e-5)[0] - s.trajectory.rotation(t - 1e-5)[0]) / 2e-5
    assert np.abs(numeric - dR).max() < 1e-7
    q = s.trajectory.quaternions
    flipped = replace(s.trajectory, quaternions=q * np.where(np.arange(len(q)) % 3 == 0, -2.0, 1.0)[:, None])
    assert np.abs(flipped.rotation(t)[0] - R).max() < 1e-12
    assert (
        np.abs(rotation_from_quaternion(np.array([[0.0, 0, 1, 1]]))[0] - [[0, -1, 0], [1, 0, 0], [0, 0, 1]]).max()
        < 1e-15
    )


def test_polynomial_and_its_slope():
    shape, _ = CorrectionModel(position_degree=2).shapes(np.array([2.0]))
    value, slope = shape(np.array([[1.0, 0, 0], [2, 0, 0], [3, 1, 0]]))
    assert value[0].tolist() == [17, 4, 0]
    assert slope[0].tolist() == [14, 4, 0]


def test_a_line_scanned_backwards(scene):
    back = replace(scene, line_times=scene.line_times[::-1].copy())
    xy = image_points(back, 20)
    ground = back.localise(xy, 100.0)
    assert np.abs(back.project(ground) - xy).max() < 1e-6
    mirrored = np.column_stack([xy[:, 0], scene.height_px + 1 - xy[:, 1]])
    assert np.abs(scene.project(ground) - mirrored).max() < 1e-6


def test_what_the_scene_did_not_see(scene):
    middle = scene.localise(np.array([[4000.0, 3500.0]]), 0.0)
    with pytest.raises(NoConvergence, match=r"1.*line_scene\.point_not_seen"):
        scene.project(np.concatenate([middle, middle + np.array([0, 3, 0])]))


def test_a_ray_past_the_earth():
    s = make_scene(pitch=1.3)
    with pytest.raises(NotSolvable, match=r"10\.00.*20\.00.*line_scene\.ray_misses_body"):
        s.localise(np.array([[10.0, 20.0]]), 0.0)


def test_ephemeris_with_a_gap_or_too_short(scene):
    path = scene.trajectory
    keep = np.abs(path.position_times - 0.1) > 0.05
    with pytest.raises(InputError, match=r"trajectory\.gap"):
        make_scene(trajectory=replace(path, position_times=path.position_times[keep], positions=path.positions[keep]))
    keep = path.attitude_times < 0.2
    with pytest.raises(InputError, match=r"2.*0\.18.*trajectory\.not_covered"):
        make_scene(
            trajectory=replace(path, attitude_times=path.attitude_times[keep], quaternions=path.quaternions[keep])
        )


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"positions": np.zeros((5, 3))}, r"5.*trajectory\.count"),
        ({"position_times": np.zeros(201)}, r"trajectory\.time_order"),
        ({"quaternions": np.zeros((201, 4))}, r"trajectory\.zero_quaternion"),
        ({"positions": np.full((201, 3), np.nan)}, r"trajectory\.not_finite"),
    ],
)
def test_tables_that_cannot_be_interpolated(scene, changes, message):
    with pytest.raises(InputError, match=message):
        replace(scene.trajectory, **changes)


def test_line_and_detector_tables(scene):
    with pytest.raises(InputError, match=r"line_scene\.table_order"):
        replace(scene, detector_x=np.array([10.0, 0.0]))
    with pytest.raises(InputError, match=r"line_scene\.times_not_monotonic"):
        replace(scene, line_y=np.array([0.0, 1, 2]), line_times=np.array([0.0, 0.1, 0.05]))
    with pytest.raises(InputError, match=r"position_degree.*3.*trajectory\.degree"):
        CorrectionModel(position_degree=3)
    with pytest.raises(InputError, match=r"18.*trajectory\.parameter_count"):
        FULL.split(np.zeros(4))


def test_times_by_pieces(scene):
    # the clock runs at half speed in the second half of the image
    y = np.array([0.5, 3500.5, 7000.5])
    pieces = replace(scene, line_y=y, line_times=np.array([-0.3, 0.0, 0.15]))
    t, slope = pieces.time(np.array([1750.5, 5250.5]))
    assert t == pytest.approx([-0.15, 0.075])
    assert slope == pytest.approx([0.3 / 3500, 0.15 / 3500])
    assert isinstance(pieces.trajectory, Trajectory)
