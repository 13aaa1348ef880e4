"""RPC: derivatives, round trips, speed, bias; on a scene of our own and on published files."""

import csv
import time
from dataclasses import replace

import numpy as np
import pytest

from raybundle.errors import InputError, NoConvergence
from raybundle.io.scenes import read_scene
from raybundle.scenes.bias import BIAS_PARAMETERS
from raybundle.scenes.rpc import correct_image, observe_rpc
from raybundle.scenes.rpc_fit import fit_rpc
from raybundle.scenes.simulate import OrbitPlan, orbit_scene
from tests.messages import refused

TABLES = ("rpc/expected.csv", "maxar/expected_rpc.csv", "shareloc/expected_rpc.csv")
FILES = (
    "rpc/rpc_IKONOS.txt",
    "rpc/rpc_PLEIADES.xml",
    "rpc/rpc_WV3.xml",
    "rpc/20191015_073816_ssc1d3_0011_basic_l1a_panchromatic_dn_RPC.TXT",
    "maxar/wv_test1.xml",
    "shareloc/PHR1B_P_201709281038393_SEN_PRG_FC_178609-001.geom",
)


def inside(rpc, n, share=0.9, seed=0):
    """Ground points whose image points lie all over the scene, at heights near the middle of the range."""
    rng = np.random.default_rng(seed)
    xy = rpc.image_offset + rpc.image_scale * rng.uniform(-share, share, (n, 2))
    half = min(float(rpc.ground_scale[2]), 500.0)
    return rpc.localise(xy, rpc.ground_offset[2] + half * rng.uniform(-share, share, n))


def central_differences(function, at, step):
    columns = []
    for axis, width in enumerate(step):
        d = np.zeros(3)
        d[axis] = width
        columns.append((function(at + d) - function(at - d)) / (2 * width))
    return np.stack(columns, axis=2)


@pytest.mark.parametrize("table", TABLES)
def test_published_projections(sensors, table):
    path = sensors / table
    with path.open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) >= 5
    for row in rows:
        rpc = read_scene(path.parent / row["file"]).rpc
        xy = rpc.project(np.array([[float(row[k]) for k in ("lon_deg", "lat_deg", "h_m")]]))[0]
        # the table counts from the centre of the first pixel, and has six digits
        assert np.abs(xy - 0.5 - [float(row["col_px"]), float(row["row_px"])]).max() < 1e-6


def test_published_point_of_a_pleiades_scene(sensors):
    for file in sorted((sensors / "shareloc").glob("*PHR1B*")):
        xy = read_scene(file).rpc.project(np.array([[7.048662660737769592, 43.72774839443545858, 0.0]]))
        assert np.abs(xy - [100.5, 200.5]).max() < 0.01


@pytest.mark.parametrize("file", FILES)
def test_jacobian_and_round_trip_of_published_files(sensors, file):
    rpc = read_scene(sensors / file).rpc
    ground = inside(rpc, 300)
    xy, J = rpc.project_with_partials(ground)
    numeric = central_differences(rpc.project, ground, (1e-5, 1e-5, 1.0))
    assert (np.abs(numeric - J) / np.abs(J).max(axis=0)).max() < 1e-6
    assert np.abs(xy - rpc.project(ground)).max() < 1e-9
    back = rpc.localise(xy, ground[:, 2])
    assert np.abs(rpc.project(back) - xy).max() < 1e-9
    assert np.abs(back - ground)[:, :2].max() < 1e-12


def test_a_million_projections_with_jacobian_in_seconds(rpc):
    rng = np.random.default_rng(1)
    ground = rpc.ground_offset + rpc.ground_scale * rng.uniform(-0.9, 0.9, (1_000_000, 3))
    began = time.process_time()
    xy, J = rpc.project_with_partials(ground)
    seconds = time.process_time() - began
    assert xy.shape == (1_000_000, 2)
    assert J.shape == (1_000_000, 2, 3)
    assert seconds < 10.0


@pytest.mark.parametrize("kind", BIAS_PARAMETERS)
def test_all_partials_of_an_observation(rpc, place, kind):
    rng = np.random.default_rng(2)
    xyz = place.local_from_geographic(inside(rpc, 100))
    bias = rng.normal(0, 3, len(BIAS_PARAMETERS[kind]))
    seen = observe_rpc(rpc, place, xyz, kind, bias)
    numeric = central_differences(lambda at: observe_rpc(rpc, place, at, kind, bias).xy_px, xyz, (5.0, 5.0, 5.0))
    assert np.abs(numeric - seen.by_point).max() < 1e-6 * np.abs(seen.by_point).max()
    for k in range(len(bias)):
        step = np.zeros(len(bias))
        step[k] = 0.5
        one, two = (observe_rpc(rpc, place, xyz, kind, bias + s * step).xy_px for s in (1, -1))
        assert np.abs(one - two - seen.by_parameters[:, :, k]).max() < 1e-8


@pytest.mark.parametrize("kind", BIAS_PARAMETERS)
def test_bias_is_taken_off_for_rays(rpc, place, kind):
    xyz = place.local_from_geographic(inside(rpc, 50))
    bias = np.linspace(-4, 5, len(BIAS_PARAMETERS[kind]))
    measured = observe_rpc(rpc, place, xyz, kind, bias).xy_px
    assert np.abs(correct_image(rpc, measured, kind, bias) - rpc.project(place.geographic_from_local(xyz))).max() < 1e-8


def test_shift_baked_into_the_offsets_is_exact(rpc, place):
    xyz = place.local_from_geographic(inside(rpc, 50))
    seen = observe_rpc(rpc, place, xyz, "shift", np.array([2.5, -7.25])).xy_px
    assert np.abs(rpc.shifted(np.array([2.5, -7.25])).project(place.geographic_from_local(xyz)) - seen).max() < 1e-9


def test_across_the_date_line(rpc):
    ground = inside(rpc, 20)
    turn = 180 - rpc.ground_offset[0]
    moved = replace(rpc, ground_offset=rpc.ground_offset + np.array([turn, 0, 0]))
    there = (ground[:, 0] + turn + 180) % 360 - 180
    assert there.min() < -179.9
    assert there.max() > 179.9
    xy = moved.project(np.column_stack([there, ground[:, 1:]]))
    assert np.abs(xy - rpc.project(ground)).max() < 1e-6
    assert not moved.outside(np.column_stack([there, ground[:, 1:]])).any()


def test_pixel_on_the_ground(rpc, scene, place):
    by_hand = place.local_from_geographic(
        rpc.localise(rpc.image_offset + np.array([[0, 0], [1, 0], [0, 1]]), float(rpc.ground_offset[2]))
    )
    assert np.abs(rpc.pixel_on_ground() - (by_hand[1:] - by_hand[0])[:, :2]).max() < 1e-4
    assert rpc.bias_sigma_px() is None
    prior = replace(rpc, err_bias_m=10.0).bias_sigma_px()
    assert prior == pytest.approx(10 / np.linalg.norm(rpc.pixel_on_ground(), axis=1))


def test_outside_its_range(rpc):
    beyond = rpc.ground_offset + rpc.ground_scale * np.array([[0, 0, 1.2], [0, 0, -1.0], [1.3, 0, 0]])
    assert rpc.outside(beyond).tolist() == [True, False, True]


def test_zero_denominator_is_named(rpc):
    c = rpc.coefficients.copy()
    c[1, 3] = -2.0
    bad = replace(rpc, coefficients=c)
    with pytest.raises(InputError, match=r"rpc\.small_denominator"):
        bad.project(rpc.ground_offset + rpc.ground_scale * np.array([[0.0, 0, 0], [0, 0, 1.1]]))
    c[3, 0] = 0
    with pytest.raises(InputError, match=r"rpc\.zero_denominator"):
        replace(rpc, coefficients=c)


def test_no_ground_point_at_an_absurd_height(sensors):
    rpc = read_scene(sensors / "rpc/rpc_IKONOS.txt").rpc
    message = r"99\.50.*119\.50.*54.*110.*rpc\.no_ground_point"
    with pytest.raises(NoConvergence, match=message):
        rpc.localise(np.array([[120.0, 100.0]]), 4e7)


def test_ground_points_of_a_small_scene_over_a_wide_range_of_heights():
    """Rounding of 50 degrees of latitude is 1e-12 of such a scene, and its parallax several times its size."""
    rpc = small_scene()
    size = 2 * rpc.image_scale
    rng = np.random.default_rng(5)
    xy = np.concatenate([rng.uniform(0, size, (2000, 2)), [[0, 0], [0, size[1]], [size[0], 0], size]])
    for height in (-100.0, 100.0, 1000.0, 3000.0, 9000.0, rng.uniform(-500, 9000, len(xy))):
        ground = rpc.localise(xy, height)
        assert np.abs(rpc.project(ground) - xy).max() < 1e-6
        assert (ground[:, 2] == height).all()


def small_scene():
    """160 px of 0.5 m, seen at 35 degrees from the vertical, as an RPC of a vendor that scales by its scene."""
    plan = OrbitPlan(target=(15.0, 48.0, 300.0), pitch_deg=25.0, roll_deg=25.0, width_px=160, height_px=160)
    return fit_rpc(orbit_scene(plan).localise, (160, 160), (100.0, 500.0)).rpc


def test_points_without_a_place_cost_only_themselves(rpc):
    """A denominator that vanishes above the scene: below it every point is found, and what is found is one."""
    c = rpc.coefficients.copy()
    c[1, 3] = c[3, 3] = -0.9
    bent = replace(rpc, coefficients=c)
    xy = bent.image_offset + bent.image_scale * np.array([[0.0, 0.0], [0.3, -0.4]])
    heights = bent.ground_offset[2] + bent.ground_scale[2] * np.array([0.5, 1.5])
    found = bent.ground_where_any(xy, heights)
    assert np.isnan(found[:, 0]).tolist() == [False, True]
    assert np.abs(bent.project(found[:1]) - xy[:1]).max() < 1e-6
    with pytest.raises(NoConvergence, match=r"rpc\.no_ground_point"):
        bent.localise(xy, heights)


def test_points_far_away_and_exchanged_coordinates(rpc):
    ground = inside(rpc, 4)
    names = ("a", "b", "c", "d")
    rpc.check_near(ground, names)
    away = ground.copy()
    away[2, 0] += 9.0
    with refused("rpc.points_far_away", n=1, total=4, point="c", exchanged=False):
        rpc.check_near(away, names)
    with refused("rpc.points_far_away", n=4, exchanged=True):
        rpc.check_near(ground[:, [1, 0, 2]], names)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"ground_offset": np.array([15.0, 95.0, 0.0])}, r"95.*15.*rpc\.centre_out_of_range"),
        ({"coefficients": np.zeros((4, 19))}, r"coefficients .*rpc\.wrong_shape"),
        ({"ground_scale": np.array([1.0, 0.0, 1.0])}, r"ground_scale .*rpc\.not_positive"),
        ({"image_offset": np.array([1.0, np.nan])}, r"image_offset .*rpc\.wrong_shape"),
    ],
)
def test_no_rpc(rpc, changes, message):
    with pytest.raises(InputError, match=message):
        replace(rpc, **changes)


def test_bad_shape(rpc):
    with pytest.raises(InputError, match=r"rpc\.point_shape"):
        rpc.project(np.zeros(3))
