"""Attitudes of files and gimbals beside the positions of photographs: observed, or left out with a word."""

from dataclasses import dataclass, replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.adjustment.engine import adjust_block
from raybundle.block.block import Camera
from raybundle.errors import InputError
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.io.trajectories import Trajectory, read_trajectory, with_positions, write_trajectory
from raybundle.io.trajectories.base import WGS84_HEIGHT
from raybundle.numerics.attitude import gimbal_from_rotation, opk_from_rotation, rotation_from_opk
from raybundle.numerics.geodesy import LocalPlace
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.placing.attitudes import find_attitudes
from raybundle.placing.georeference import georeference
from raybundle.placing.marks import Given
from raybundle.planning.flights.uav_networks import Flight, flight_block, uav_camera
from raybundle.planning.simulate import measured
from raybundle.report.sections.trajectories import trajectory_section
from raybundle.report.view import view_of
from raybundle.words import headline
from tests.messages import refused

PLACE = (11.2, 48.0, 500.0)
"""2.2 degrees east of the middle of its UTM zone: the meridians converge by 1.6 degrees."""
ASKEW = np.radians([0.3, -0.2, 0.4])
SIGMA = np.radians(0.05)
UTM = "EPSG:32632"


@pytest.fixture(scope="module")
def flight():
    """A flight with its free block, the camera held."""
    camera: Camera = replace(uav_camera(), estimate=())
    plan = Flight(
        camera=camera, lines=3, photographs=5, points=8, alternating=True, angle_jitter_deg=3, cross_tilt_deg=20
    )
    truth = flight_block(plan)
    truth = truth.having(type(truth.stations)(
        image=np.zeros(0, np.int32), xyz=np.zeros((0, 3)), sigma=np.zeros((0, 3))
    ))  # fmt: skip
    return SimpleNamespace(truth=truth, exact=measured(truth, 0.3))


def enu(truth):
    """Rotations of the images against east, north, up at each of them."""
    frame = local_frame(WGS84_HEIGHT, PLACE)
    return truth.images.rotation @ frame.local_from_enu(frame.crs_from_local(truth.images.centre))


def trajectory(truth, rng, told=None, sigma=SIGMA, askew=ASKEW):
    """What GNSS and INS would have told; `told` (n, 3, 3) in place of what the INS tells."""
    n = len(truth.images)
    centre = truth.images.centre + rng.normal(0, 1, (n, 3)) * [0.02, 0.02, 0.03]
    noise = rotation_from_vector(rng.normal(0, sigma, (n, 3)))
    return Trajectory(
        path=None, names=tuple(f"{i}.jpg" for i in truth.images.ids),
        xyz=LocalPlace(origin=PLACE).geographic_from_local(centre), sigma=np.tile([0.02, 0.02, 0.03], (n, 1)),
        crs=WGS84_HEIGHT, rotation=noise @ rotation_from_vector(-askew) @ enu(truth) if told is None else told,
        rotation_sigma=None if sigma is None else np.full((n, 3), sigma), true_north=True,
    )  # fmt: skip


@dataclass
class Facts:
    """The metadata that matter here."""

    gps: object = None
    gimbal: tuple | None = None
    make: str = ""
    model: str = ""
    serial: str = ""
    taken: object = None


@dataclass
class Shot:
    name: str
    width_px: int
    height_px: int
    metadata: Facts


def placed(flight, file, *, rng=None, use="auto", sigma_deg=None, crs=None, **given):
    """The block with what the file tells of positions and attitudes."""
    c = flight.truth.cameras[0]
    photos = [Shot(f"{n}.jpg", c.width_px, c.height_px, Facts()) for n in flight.truth.images.ids]
    told = read_trajectory(file)
    photos, _ = with_positions(photos, told, crs)
    attitudes, remarks = find_attitudes(photos, told, use=use, sigma_deg=sigma_deg, crs=crs)
    block = flight.exact
    if rng is not None:
        o = block.observations
        block = replace(block, observations=replace(o, xy_px=o.xy_px + rng.normal(0, 0.3, o.xy_px.shape)))
    done = georeference(block, photos, Given(attitudes=attitudes, **given))
    return done, remarks


def written(flight, path, rng, name="rpy", **how):
    write_trajectory(trajectory(flight.truth, rng, **how), path, name=name)
    return path


def codes(done):
    return {n.code: n for n in done.notices}


@pytest.mark.parametrize("name", ["rpy", "opk"])
def test_attitudes_of_a_file_are_observed_with_their_misalignment(flight, tmp_path, name):
    rng = np.random.default_rng(1)
    done, _ = placed(flight, written(flight, tmp_path / "flight.csv", rng, name), rng=rng)
    assert len(done.block.attitudes) == len(flight.truth.images)
    assert codes(done)["attitudes"].values["cameras"] == 1
    result = adjust_block(done.block)
    ins = next(r for r in result.interior if r.camera == "ins").parameters
    for symbol, true in zip(("bx", "by", "bz"), ASKEW, strict=True):
        assert abs(ins[symbol].value - true) < 4 * ins[symbol].std
        assert ins[symbol].std < SIGMA
    section = trajectory_section(view_of(result))
    assert section is not None
    assert headline("report_trajectories.comparison", {}) in str(section)
    held, _ = placed(flight, tmp_path / "flight.csv", rng=rng, misalignment=False)
    assert held.block.attitudes.imu is None
    assert not any(i.estimate for i in held.block.instruments)


@pytest.mark.long
def test_attitudes_and_misalignment_have_true_sigmas(flight, tmp_path):
    rng = np.random.default_rng(3)
    squares, sums, runs = [], [], 5
    for k in range(runs):
        done, _ = placed(flight, written(flight, tmp_path / f"{k}.csv", rng), rng=rng)
        result = adjust_block(done.block)
        ins = next(r for r in result.interior if r.camera == "ins")
        e = np.array([ins.parameters[s].value for s in ("bx", "by", "bz")]) - ASKEW
        std = np.array([ins.parameters[s].std for s in ("bx", "by", "bz")]) / result.sigma0
        squares.append(np.sum((e / std) ** 2))
        (group,) = [g for g in result.groups if g.kind == "attitude"]
        sums.append(np.sum(np.square(group.residual / group.sigma)) / np.sum(group.redundancy))
    low, high = chi2(3 * runs).interval(0.9995)
    assert low < sum(squares) < high
    assert np.mean(sums) == pytest.approx(1, abs=0.2)


@pytest.mark.long
def test_a_grid_needs_its_system_and_its_convergence_is_taken_out(flight, tmp_path):
    rng = np.random.default_rng(2)
    frame = local_frame(UTM, (*place_in(UTM), 500.0))
    local = frame.local_from_wgs84(LocalPlace(origin=PLACE).geographic_from_local(flight.truth.images.centre))
    xyz = frame.crs_from_local(local)
    told = trajectory(flight.truth, rng)
    grid = told.rotation @ np.swapaxes(frame.crs_from_local_rotation(xyz) @ frame.local_from_enu(xyz), 1, 2)
    in_grid = replace(told, xyz=xyz, crs=None, rotation=grid, true_north=False)
    write_trajectory(in_grid, tmp_path / "grid.csv", name="opk")
    apart = opk_from_rotation(grid)[:, 2] - opk_from_rotation(told.rotation)[:, 2]
    assert np.degrees(np.abs(np.arctan2(np.sin(apart), np.cos(apart)))).min() > 1.5
    with refused("trajectory.no_crs", file="grid.csv"):
        placed(flight, tmp_path / "grid.csv")
    done, _ = placed(flight, tmp_path / "grid.csv", rng=rng, crs=UTM)
    ins = next(r for r in adjust_block(done.block).interior if r.camera == "ins").parameters
    assert abs(ins["bz"].value - ASKEW[2]) < 4 * ins["bz"].std
    # the angles of the grid, called those against true north: it looks like a misalignment, and is said
    write_trajectory(replace(told, rotation=grid), tmp_path / "wrong.csv", name="opk")
    assert "attitudes_convergence" not in codes(done)
    write_trajectory(replace(told, rotation=rotation_from_vector(ASKEW) @ grid), tmp_path / "north.csv", name="opk")
    done, _ = placed(flight, tmp_path / "north.csv", rng=rng)
    assert codes(done)["attitudes_convergence"].values["convergence_deg"] == pytest.approx(1.65, abs=0.05)


def place_in(crs):
    from pyproj import Transformer

    return Transformer.from_crs("EPSG:4326", crs, always_xy=True).transform(*PLACE[:2])


@pytest.mark.parametrize(
    ("wrong", "named"),
    [
        (lambda a: a * [-1, -1, 1], "opk_omega_phi_reversed"),
        (lambda a: a * [1, 1, -1], "opk_kappa_reversed"),
        (lambda a: opk_from_rotation(np.swapaxes(rotation_from_opk(a), 1, 2)), "opk_inverse"),
    ],
)
def test_a_wrong_convention_is_named_and_not_adjusted_away(flight, tmp_path, wrong, named):
    rng = np.random.default_rng(4)
    told = trajectory(flight.truth, rng)
    angles = wrong(opk_from_rotation(told.rotation))
    write_trajectory(replace(told, rotation=rotation_from_opk(angles)), tmp_path / "wrong.csv", name="opk")
    done, _ = placed(flight, tmp_path / "wrong.csv", rng=rng)
    (other,) = [d for d in codes(done)["attitudes_contradict"].details if d.code == "attitudes_contradict.reading"]
    assert other.values["reading"] == named
    assert len(done.block.attitudes) == 0
    result = adjust_block(done.block)
    assert result.global_test[0] < result.global_test[1] < result.global_test[2]


def test_roll_and_pitch_exchanged(flight, tmp_path):
    rng = np.random.default_rng(5)
    file = written(flight, tmp_path / "flight.csv", rng)
    text = file.read_text()
    head, rest = text.split("\n", 1)
    swapped = head.replace("roll_deg", "x").replace("pitch_deg", "roll_deg").replace("x", "pitch_deg")
    (tmp_path / "swapped.csv").write_text(f"{swapped}\n{rest}")
    done, _ = placed(flight, tmp_path / "swapped.csv", rng=rng)
    assert [d.values["reading"] for d in codes(done)["attitudes_contradict"].details] == ["pry"]


def test_rows_of_other_photographs(flight, tmp_path):
    rng = np.random.default_rng(6)
    told = trajectory(flight.truth, rng)
    mixed = replace(told, rotation=told.rotation[rng.permutation(len(told))])
    write_trajectory(mixed, tmp_path / "mixed.csv", name="rpy")
    done, _ = placed(flight, tmp_path / "mixed.csv", rng=rng)
    assert codes(done)["attitudes_contradict"].values["other"] is False


def test_a_single_wrong_attitude_is_left_out_by_name(flight, tmp_path):
    rng = np.random.default_rng(7)
    told = trajectory(flight.truth, rng)
    rotation = told.rotation.copy()
    rotation[3] = rotation_from_vector(np.radians([0, 0, 8.0])) @ rotation[3]
    write_trajectory(replace(told, rotation=rotation), tmp_path / "one.csv", name="rpy")
    done, _ = placed(flight, tmp_path / "one.csv", rng=rng)
    (notice,) = [n for n in done.notices if n.code == "attitude_wrong"]
    assert notice.ids == (f"{flight.truth.images.ids[3]}.jpg",)
    assert len(done.block.attitudes) == len(told) - 1


def test_a_camera_mounted_across(flight, tmp_path):
    rng = np.random.default_rng(8)
    across = rotation_from_vector(np.radians([0.0, 0.0, 90.0]))
    told = trajectory(flight.truth, rng)
    write_trajectory(replace(told, rotation=across.T @ told.rotation), tmp_path / "across.csv", name="rpy")
    done, _ = placed(flight, tmp_path / "across.csv", rng=rng)
    mount = codes(done)["attitudes_mount"].values
    assert (abs(mount["angle_deg"]), mount["quarter"]) == (90.0, True)
    ins = next(r for r in adjust_block(done.block).interior if r.camera == "ins").parameters
    assert abs(ins["bz"].value - ASKEW[2]) < 5 * ins["bz"].std


def test_gimbal_angles_of_the_photographs_are_observed_where_asked_for(flight, tmp_path):
    rng = np.random.default_rng(9)
    told = trajectory(flight.truth, rng, sigma=np.radians(0.3))
    file = tmp_path / "positions.csv"
    write_trajectory(replace(told, rotation_sigma=None), file, name="rpy")
    unstated, remarks = placed(flight, file, rng=rng)
    assert [m.code for m in remarks[0].messages] == ["attitude.no_sigma_unused"]
    assert len(unstated.block.attitudes) == 0
    with refused("attitude.no_sigma", source="positions.csv"):
        placed(flight, file, use="rpy-ned")
    with pytest.raises(InputError, match=r"rpy-ned.*opk.*attitude\.other_convention"):
        placed(flight, file, use="opk", sigma_deg=(0.3, 0.3))
    with_sigma, _ = placed(flight, file, rng=rng, sigma_deg=(0.3, 1.0))
    seen = with_sigma.block.attitudes
    assert np.degrees(seen.sigma[:15, :2]) == pytest.approx(0.3, rel=0.1)
    assert np.degrees(seen.sigma[:10, 2]) == pytest.approx(1.0, rel=0.05)


def test_gimbals_alone():
    from raybundle.io.trajectories import attitudes_of_gimbals

    R = rotation_from_vector(np.radians([[0.0, 0.0, 30.0], [2.0, -3.0, 100.0]]))
    photos = [Shot("a.jpg", 1, 1, Facts(gimbal=tuple(np.degrees(g)))) for g in gimbal_from_rotation(R)]
    photos = [replace(p, name=f"{k}.jpg") for k, p in enumerate(photos)]
    assert find_attitudes(photos, None, use="auto", sigma_deg=None, crs=None) == (None, ())
    found, _ = find_attitudes(photos, None, use="gimbal", sigma_deg=(0.2, 2.0), crs=None)
    assert np.abs(found.rotation - R).max() < 1e-12
    about = np.swapaxes(R, 1, 2) @ found.covariance @ R
    assert np.degrees(np.sqrt(np.diagonal(about, axis1=1, axis2=2))) == pytest.approx(np.tile([0.2, 0.2, 2.0], (2, 1)))
    assert attitudes_of_gimbals([Shot("a.jpg", 1, 1, Facts())], sigma=None) is None
    with pytest.raises(InputError, match=r"attitude\.missing"):
        find_attitudes([Shot("a.jpg", 1, 1, Facts())], None, use="gimbal", sigma_deg=None, crs=None)


def test_a_single_line_is_turned_by_its_attitudes(tmp_path):
    """Exactly straight, positions say nothing about the turn about the line; the mounting as stated does."""
    camera: Camera = replace(uav_camera(), estimate=())
    plan = Flight(camera=camera, lines=1, photographs=6, points=8, height_jitter=0.0)
    truth = flight_block(plan)
    truth = truth.having(type(truth.stations)(
        image=np.zeros(0, np.int32), xyz=np.zeros((0, 3)), sigma=np.zeros((0, 3))
    ))  # fmt: skip
    flight = SimpleNamespace(truth=truth, exact=measured(truth, 0.3))
    rng = np.random.default_rng(11)
    done, _ = placed(flight, written(flight, tmp_path / "line.csv", rng, askew=np.radians([0.3, 0.5, 0.4])), rng=rng)
    assert codes(done)["attitudes_nominal"].values["sigma_deg"] == pytest.approx(1.0)
    result = adjust_block(done.block)
    ins = next(r for r in result.interior if r.camera == "ins").parameters
    assert max(p.std for p in ins.values()) > np.radians(0.3)
    for symbol, true in zip(("bx", "by", "bz"), np.radians([0.3, 0.5, 0.4]), strict=True):
        assert abs(ins[symbol].value - true) < 3 * ins[symbol].std
    assert not result.datum_defect


def test_a_table_of_gimbal_angles_and_yaw_from_true_north_in_a_grid(flight, tmp_path):
    rng = np.random.default_rng(12)
    told = trajectory(flight.truth, rng)
    frame = local_frame(UTM, (*place_in(UTM), 500.0))
    xyz = frame.crs_from_local(frame.local_from_wgs84(told.xyz))
    angles = np.degrees(gimbal_from_rotation(told.rotation))
    lines = ["image,X,Y,Z,gimbal_yaw_deg,gimbal_pitch_deg,gimbal_roll_deg,sX,sY,sZ"]
    lines += [
        ",".join([n, *(repr(float(v)) for v in (*p, *a)), "0.02,0.02,0.03"])
        for n, p, a in zip(told.names, xyz, angles, strict=True)
    ]
    file = tmp_path / "gimbal.csv"
    file.write_text("\n".join(lines) + "\n")
    done, _ = placed(flight, file, rng=rng, use="gimbal", sigma_deg=(0.05, 0.05), crs=UTM)
    ins = next(r for r in adjust_block(done.block).interior if r.camera == "ins").parameters
    for symbol, true in zip(("bx", "by", "bz"), ASKEW, strict=True):
        assert abs(ins[symbol].value - true) < 4 * ins[symbol].std
