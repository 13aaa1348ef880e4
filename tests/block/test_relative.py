"""Relative aerial control: constants of a flight line cancel, and the sigmas are true."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Instrument, Stations
from raybundle.block.block import Attitudes, Role
from raybundle.block.relative import relative_control
from raybundle.errors import InputError
from raybundle.numerics.rotation import angles_from_rotation, rotation_from_vector
from raybundle.planning.flights.uav_networks import Flight, flight_block, uav_camera
from raybundle.planning.simulate import measured

LINES = np.repeat([0, 1, 2], 5).astype(np.int32)
SIGMA, TILT = np.array([0.02, 0.02, 0.03]), np.radians(0.02)


@pytest.fixture(scope="module")
def truth():
    """Three lines with four control points at the corners; the camera is held."""
    camera = replace(uav_camera(), estimate=())
    block = measured(
        flight_block(Flight(camera=camera, lines=3, photographs=5, points=7, size=90, alternating=True)), 0.3
    )
    p = block.points
    role, sigma = np.array(p.role), np.full_like(p.xyz, np.nan)
    corners = [k for k in np.argsort(-np.abs(p.xyz[:, :2]).sum(axis=1))[:8] if block.ray_count[k] > 2][:4]
    role[corners], sigma[corners] = Role.CONTROL, 0.01
    return replace(block, points=replace(p, role=role, sigma=sigma))


def noisy(truth, rng, *, shift=0.0, drift=0.0, turn=0.0):
    """Observations with errors, those of a line with a constant, a drift and a turn of its own."""
    n = len(truth.images)
    constant = rng.normal(0, 1, (3, 3))[LINES] * shift
    along = np.tile(np.arange(5) - 2.0, 3)[:, None] * rng.normal(0, 1, (3, 3))[LINES] * drift
    xyz = truth.images.centre + constant + along + rng.normal(0, 1, (n, 3)) * SIGMA
    askew = rotation_from_vector(rng.normal(0, 1, (3, 3))[LINES] * turn)
    seen = angles_from_rotation(askew @ truth.images.rotation) + rng.normal(0, TILT, (n, 3))
    o, p = truth.observations, truth.points
    held = (np.asarray(p.role) == Role.CONTROL)[:, None]
    every = np.arange(n, dtype=np.int32)
    return replace(
        truth,
        observations=replace(o, xy_px=o.xy_px + rng.normal(0, 0.3, o.xy_px.shape)),
        points=replace(p, xyz=p.xyz + rng.normal(0, 0.01, p.xyz.shape) * held),
    ).having(
        Stations(image=every, xyz=xyz, sigma=np.tile(SIGMA, (n, 1))),
        Attitudes(image=every, angles=seen, sigma=np.full((n, 3), TILT)),
    )


def test_normal_equations_of_differences_are_those_of_a_free_shift():
    D = np.diff(np.eye(6), axis=0)
    differences = D.T @ np.linalg.solve(D @ D.T, D)
    design = np.column_stack([np.eye(6), np.ones(6)])
    N = design.T @ design
    reduced = N[:6, :6] - np.outer(N[:6, 6], N[6, :6]) / N[6, 6]
    np.testing.assert_allclose(differences, reduced, atol=1e-12)


def test_constants_of_a_line_change_nothing(truth):
    block = noisy(truth, np.random.default_rng(1))
    first = adjust_block(relative_control(block, LINES))
    moved = block.stations.xyz + np.array([[0.4, -0.3, 0.9], [-0.7, 0.1, 0.2], [0.0, 0.6, -0.5]])[LINES]
    again = adjust_block(relative_control(block.having(replace(block.stations, xyz=moved)), LINES))
    np.testing.assert_allclose(again.adjusted.points.xyz, first.adjusted.points.xyz, atol=1e-6)
    np.testing.assert_allclose(again.precision.object_point_std, first.precision.object_point_std, rtol=1e-4)
    assert again.sigma0 == pytest.approx(first.sigma0, rel=1e-4)
    absolute = adjust_block(block.having(replace(block.stations, xyz=moved)))
    assert absolute.global_test[1] > 3 * absolute.global_test[2]


@pytest.mark.long
@pytest.mark.parametrize("drift", [False, True])
def test_stated_sigmas_are_true(truth, drift):
    rng = np.random.default_rng(2)
    runs, square_sum, redundancy, stations, theirs = 30, 0.0, 0, 0.0, 0.0
    for _ in range(runs):
        block = noisy(truth, rng, shift=0.5, drift=0.1 if drift else 0.0, turn=np.radians(0.3))
        result = adjust_block(relative_control(block, LINES, drift=drift), AdjustmentOptions(jobs=1))
        square_sum += result.sigma0**2 * result.redundancy
        redundancy += result.redundancy
        (group,) = [g for g in result.groups if g.kind == "station"]
        stations += float(np.sum((group.residual / group.sigma) ** 2))
        theirs += float(np.sum(group.redundancy))
    low, high = chi2(redundancy).interval(0.999)
    assert low < square_sum < high
    assert stations / theirs == pytest.approx(1, abs=4 * np.sqrt(2 / theirs))
    # positions taken 10 % too well would be noticed
    assert abs(1.1**2 * stations / theirs - 1) > 3 * np.sqrt(2 / theirs)


def test_a_drift_that_is_left_out_is_noticed(truth):
    block = noisy(truth, np.random.default_rng(3), shift=0.5, drift=0.2)
    without = adjust_block(relative_control(block, LINES))
    assert without.global_test[1] > without.global_test[2]
    free = adjust_block(relative_control(block, LINES, drift=True))
    assert free.global_test[1] < free.global_test[2]


def test_lines_of_few_images_and_lever_arms(truth):
    block = noisy(truth, np.random.default_rng(4))
    short = LINES.copy()
    short[5:9] = -1  # of the second line one image is left
    thin = relative_control(block, short)
    assert len(thin.stations) == len(thin.attitudes) == 10
    assert [i.id for i in thin.instruments] == ["line-1", "line-3", "ins-line-1", "ins-line-3"]
    arm = Instrument(id="gnss", model="antenna", values={"az": 0.3}, estimate=("az", "sz"), sigma={"az": 0.01})
    station = replace(block.stations, antenna=np.zeros(15, np.int32))
    found = relative_control(replace(block, instruments=(arm,)).having(station), LINES)
    assert found.instruments[1].values["az"] == 0.3
    assert found.instruments[1].estimate == ("az", "sx", "sy", "sz")
    assert found.instruments[1].sigma == {"az": 0.01}
    with pytest.raises(InputError, match=r"flight_line\.too_few_images"):
        relative_control(block, np.arange(15))
    with pytest.raises(InputError, match=r"14.*15.*flight_line\.count"):
        relative_control(block, LINES[1:])
