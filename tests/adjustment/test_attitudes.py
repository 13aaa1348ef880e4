"""Observed attitudes with the misalignment of an IMU, and the clock of a GNSS antenna, in the adjustment."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle import adjust
from raybundle.adjustment.engine import adjust_block
from raybundle.block import Instrument, Stations
from raybundle.block.block import Attitudes
from raybundle.errors import DatumDefect, InputError, RankDefect
from raybundle.io.block.folder import read_block, write_block
from raybundle.numerics.rotation import angles_from_rotation, left_jacobian, rotation_from_vector
from raybundle.planning.simulate import Survey, measured, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene
from raybundle.platforms.imu import reported
from tests.truth.mixed_blocks import MonteCarlo

MISALIGNMENT = ("bx", "by", "bz")
LEVER = np.array([0.10, -0.05, 0.30])
BORESIGHT = np.array([0.008, -0.012, 0.015])
LATE = 0.02
SIGMA = np.radians([0.005, 0.005, 0.01])


def flight(
    *, arm=(), clock=(), boresight=("bx", "by", "bz"), control=4, arm_sigma=None, boresight_sigma=None, positions=True,
    attitudes=True, speed=(60.0, -45.0, 75.0), alike=False, velocities=True,
):  # fmt: skip
    """Three strips, the middle one flown the other way; positions of 3 cm, attitudes of 0.005 and 0.01 degrees."""
    survey = Survey(image_sigma_px=0.3, control=control, control_sigma=(0.02, 0.02, 0.02), interior="exact")
    truth = simulate(aerial_scene(AerialStrips(images_per_strip=4, points_per_image=20)), survey).truth
    line = np.repeat([0, 1, 2], 4)
    turn = np.array([np.eye(3), np.diag([-1.0, -1.0, 1.0]), np.eye(3)])[line]
    rotation = np.tile(truth.images.rotation[0], (12, 1, 1)) if alike else turn @ truth.images.rotation
    truth = measured(replace(truth, images=replace(truth.images, rotation=rotation)), 0.3)
    v = np.array(speed)[line][:, None] * np.array([1.0, 0.1, 0.02])
    antenna = Instrument(
        id="gnss", model="antenna", values=dict(zip(("ax", "ay", "az", "dt"), (*LEVER, LATE), strict=True)),
        estimate=(*arm, *clock), sigma=arm_sigma or {},
    )  # fmt: skip
    imu = Instrument(
        id="ins", model="imu", values=dict(zip(MISALIGNMENT, BORESIGHT, strict=True)), estimate=tuple(boresight),
        sigma=boresight_sigma or {},
    )  # fmt: skip
    xyz = truth.images.centre + np.swapaxes(rotation, 1, 2) @ LEVER + v * LATE
    stations = Stations(
        image=np.arange(12, dtype=np.int32), xyz=xyz, sigma=np.full((12, 3), 0.03), velocity=v if velocities else None,
        antenna=np.zeros(12, np.int32), time=np.arange(12.0),
    )  # fmt: skip
    angles = angles_from_rotation(rotation_from_vector(-BORESIGHT) @ rotation)
    seen = Attitudes(
        image=np.arange(12, dtype=np.int32), angles=angles, sigma=np.tile(SIGMA, (12, 1)), imu=np.ones(12, np.int32)
    )
    truth = replace(truth, instruments=(antenna, imu))
    return truth.having(*([stations] if positions else []), *([seen] if attitudes else []))


class Carried(MonteCarlo):
    """Monte Carlo that draws errors of the attitudes as well."""

    def noisy(self, rng):
        block = super().noisy(rng)
        a = block.attitudes
        return block.having(replace(a, angles=a.angles + rng.normal(0, 1, a.angles.shape) * a.sigma))


def test_the_flight_is_consistent():
    block = flight()
    result = adjust_block(block)
    assert result.sigma0 < 1e-6
    ins = next(i for i in result.interior if i.camera == "ins")
    assert [ins.parameters[s].value for s in MISALIGNMENT] == pytest.approx(list(BORESIGHT), abs=1e-9)


def test_how_an_imu_follows_image_and_boresight():
    rng = np.random.default_rng(1)
    R, b = rotation_from_vector(rng.normal(0, 1, (5, 3))), np.array([0.3, -0.2, 0.5])
    seen, by_rotation, by_boresight = reported(R, b)
    for axis in range(3):
        d = np.zeros(3)
        d[axis] = 1e-6
        turned = reported(rotation_from_vector(d) @ R, b)[0]
        small = (turned @ np.swapaxes(seen, 1, 2) - np.eye(3))[:, [2, 0, 1], [1, 2, 0]] / 1e-6
        assert np.abs(small - by_rotation[:, axis]).max() < 1e-5
        moved = reported(R, b + d)[0]
        small = (moved @ np.swapaxes(seen, 1, 2) - np.eye(3))[:, [2, 0, 1], [1, 2, 0]] / 1e-6
        assert np.abs(small - by_boresight[:, axis]).max() < 1e-5
    assert np.abs(left_jacobian(1e-3 * b) - left_jacobian(1.001e-3 * b)).max() < 1e-6


@pytest.mark.parametrize(
    "how",
    [
        {},
        {"clock": ("dt",), "arm": ("ax", "ay", "az"), "arm_sigma": dict.fromkeys(("ax", "ay", "az"), 0.05)},
        {"control": 0, "boresight_sigma": {"bz": 1e-3}},
        {"clock": ("dt",), "boresight": ("bx", "by"), "velocities": False},
    ],
    ids=["boresight", "boresight, lever arm and clock", "no control", "clock, velocities by the positions"],
)
def test_boresight_lever_arm_and_clock_have_true_sigmas(how):  # benchmarks/truth_trajectories.py has 200 runs
    block = flight(**how)
    if (
        how.get("velocities") is False
    ):  # positions that lie on straight lines, so that their differences are the velocity
        block = block.having(replace(block.stations, velocity=None))
        v = block.stations.velocities
        xyz = block.images.centre + np.swapaxes(block.images.rotation, 1, 2) @ LEVER
        for _ in range(30):
            v = replace(block.stations, xyz=xyz + v * LATE).velocities
        block = block.having(replace(block.stations, xyz=xyz + v * LATE))
    runs = 40
    found = Carried.of(block).errors(runs, seed=4)
    owners = {kind.rpartition(" of ")[2] for kind in found}
    assert "ins" in owners
    assert ("gnss" in owners) == ("clock" in how)
    for kind, (d2, degrees) in found.items():
        low, high = chi2(degrees * runs).interval(0.9995)
        assert low < d2.sum() < high, kind


def test_statistics_of_attitudes_are_those_of_any_observation():
    block = Carried.of(flight(clock=("dt",))).noisy(np.random.default_rng(2))
    result = adjust_block(block)
    (group,) = [g for g in result.groups if g.kind == "attitude"]
    assert group.component[:3] == ("omega", "phi", "kappa")
    assert len(group.given) == 36
    assert ((group.redundancy > 0) & (group.redundancy < 1)).all()
    total = np.nansum(result.image_observations.redundancy) + sum(np.nansum(g.redundancy) for g in result.groups)
    assert total == pytest.approx(result.redundancy, rel=1e-6)
    assert {"attitudes", "stations"} <= {c.kind for c in result.variance_components}
    assert result.global_test[0] < result.global_test[1] < result.global_test[2]
    wrong = block.attitudes.angles.copy()
    wrong[5, 1] += np.radians(0.1)
    again = adjust_block(block.having(replace(block.attitudes, angles=wrong)))
    (group,) = [g for g in again.groups if g.kind == "attitude"]
    assert np.nanargmax(np.abs(group.w)) == 5 * 3 + 1
    neglected = adjust_block(block.having(replace(block.attitudes, imu=None)))
    assert neglected.global_test[1] > 3 * neglected.global_test[2]


def test_what_attitudes_determine():
    # without control and positions they fix the rotation, if the misalignment is known
    known = adjust_block(noisy(positions=False, boresight=(), control=0))
    assert known.datum_defect == ("position X", "position Y", "position Z", "scale")
    with pytest.raises(DatumDefect, match=r"(?s)IMU.*datum\.misalignment_unknown"):
        adjust_block(flight(positions=False, control=0, alike=True))
    without = adjust_block(noisy(attitudes=False))
    assert "ins" not in [i.camera for i in without.interior]


def noisy(**how):
    return Carried.of(flight(**how)).noisy(np.random.default_rng(6))


def test_a_clock_and_a_shift_are_one_at_one_speed():
    block = flight(clock=("dt", "sx", "sy", "sz"), speed=(60.0, 60.0, 60.0), control=6)
    with pytest.raises(RankDefect, match=r"rank\.not_determined"):
        adjust_block(block)
    two = adjust_block(noisy(clock=("dt", "sx", "sy", "sz"), control=6))
    gnss = next(i for i in two.interior if i.camera == "gnss")
    assert gnss.parameters["dt"].std < 1e-3
    assert not two.not_determinable


def test_a_clock_needs_velocities():
    block = flight(clock=("dt",))
    s = block.stations
    with pytest.raises(InputError, match=r"station\.velocity_unknown"):
        adjust_block(block.having(replace(s, velocity=None, time=np.zeros(12))))
    apart = replace(s, velocity=None, time=np.arange(12.0) + np.repeat([0.0, 100.0, 200.0], 4))
    v = apart.velocities
    assert np.abs(v[4] - (s.xyz[5] - s.xyz[4])).max() < 1e-9  # not across the turn
    assert np.abs(v[5] - (s.xyz[6] - s.xyz[4]) / 2).max() < 1e-9


def test_attitudes_near_a_right_angle_are_refused():
    block = flight()
    angles = block.attitudes.angles.copy()
    angles[3, 1] = np.radians(89.8)
    with pytest.raises(InputError, match=r"89\.80.*0\.6.*attitude\.phi_right_angle"):
        adjust_block(block.having(replace(block.attitudes, angles=angles)))


def test_attitudes_and_imus_go_through_folders(tmp_path):
    block = Carried.of(flight(clock=("dt",), boresight_sigma={"bz": 1e-3})).noisy(np.random.default_rng(3))
    write_block(block, tmp_path / "block")
    again = read_block(tmp_path / "block")
    assert again.cameras == block.cameras
    assert again.instruments == block.instruments
    np.testing.assert_array_equal(again.attitudes.imu, block.attitudes.imu)
    np.testing.assert_allclose(again.attitudes.angles, block.attitudes.angles, rtol=0, atol=2e-14)
    np.testing.assert_allclose(again.attitudes.sigma, block.attitudes.sigma, rtol=1e-14)
    np.testing.assert_array_equal(again.stations.velocity, block.stations.velocity)
    assert adjust(again).sigma0 == pytest.approx(adjust_block(block).sigma0, rel=1e-6)
    folder = tmp_path / "block"
    text = (folder / "attitudes.csv").read_text(encoding="utf-8")
    (folder / "attitudes.csv").write_text(text.replace(",ins", ",gnss", 1), encoding="utf-8")
    with pytest.raises(InputError, match=r"attitudes\.csv.*2.*cell\.unknown_id"):
        read_block(folder)
    (folder / "attitudes.csv").write_text(text, encoding="utf-8")
    head = (folder / "block.toml").read_text(encoding="utf-8")
    (folder / "block.toml").write_text(head.replace("[imus.ins]", "[imus.gnss]"), encoding="utf-8")
    with pytest.raises(InputError, match=r"IMU.*instrument\.name_taken"):
        read_block(folder)
