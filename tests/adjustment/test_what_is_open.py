"""What observations leave open of the datum, with a margin; and the sum of redundancy numbers up to rounding."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.notices import notices_of
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.reliability import redundancy_sum
from raybundle.adjustment.system.datum import LEVER, open_directions, point_generators
from raybundle.block import Stations
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from tests.verdicts.cases import CASES

SIGMA = 0.02


def straight_flight(bend=0.0, seed=1):
    """Stations on a straight line, observed, over points in relief; `bend` puts the middle ones beside it [m]."""
    scene = field_scene(TargetField(stations=8, frontal=0, camera=brown_camera(estimate=())))
    x = np.linspace(-1.0, 1.0, len(scene.centre))
    line = np.stack([x, bend * (1 - x**2), np.full_like(x, 2.5)], axis=1)
    down = np.tile(np.diag([1.0, 1.0, 1.0]), (len(x), 1, 1))
    survey = Survey(seed=seed, orientation="exact", points="exact", interior="exact", image_sigma_px=0.1)
    block = simulate(replace(scene, centre=line, rotation=down, normal=None), survey).observed
    noise = np.random.default_rng(seed).normal(0, SIGMA, line.shape)
    stations = Stations(
        image=np.arange(len(x), dtype=np.int32), xyz=line + noise, sigma=np.full(line.shape, SIGMA)
    )  # fmt: skip
    return block.having(stations)


def rows_of(xyz):
    return point_generators(xyz, np.zeros(3), 1.0).reshape(-1, 7)


@pytest.mark.parametrize("off", [0.0, 0.5, 1.2])
def test_a_line_does_not_tell_its_rotation_whatever_its_errors(off):
    x = np.linspace(-1, 1, 20)
    xyz = np.stack([x, 0.01 * off * (-1.0) ** np.arange(20), np.full(20, 0.3)], axis=1)
    rows = rows_of(xyz)
    assert open_directions(rows, np.full(len(rows), 0.01)).shape[1] == 1


def test_what_stands_beside_the_line_tells_it():
    x = np.linspace(-1, 1, 20)
    xyz = np.stack([x, 0.01 * 2 * LEVER * (-1.0) ** np.arange(20), np.full(20, 0.3)], axis=1)
    rows = rows_of(xyz)
    assert open_directions(rows, np.full(len(rows), 0.01)).shape[1] == 0
    assert open_directions(rows, np.zeros(len(rows))).shape[1] == 0


@pytest.mark.parametrize(("stations", "left"), [(4, 1), (18, 0)])
def test_many_stations_tell_a_rotation_together_that_none_tells_alone(stations, left):
    x = np.linspace(-1, 1, stations)
    xyz = np.stack([x, 0.01 * 0.6 * LEVER * (-1.0) ** np.arange(stations), np.full(stations, 0.3)], axis=1)
    rows = rows_of(xyz)
    assert open_directions(rows, np.full(len(rows), 0.01)).shape[1] == left


def test_a_shift_is_determined_however_badly():
    rows = rows_of(np.array([[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]]))
    left = open_directions(rows, np.full(len(rows), 100.0))
    assert left.shape[1] == 4  # rotations and the scale
    assert open_directions(np.zeros((0, 7)), np.zeros(0)).shape[1] == 7


@pytest.mark.parametrize(("bend", "told"), [(0.0, True), (0.5, False)])
def test_what_projection_centres_leave_open_is_a_caution_as_for_control(bend, told):
    result = adjust(straight_flight(bend), AdjustmentOptions(jobs=1))
    said = [n for n in result.notices if n.code == "control_leaves_open"]
    assert bool(said) == told
    for notice in said:
        assert notice.severity.value == "warning"
        assert notice.data.code == "control_leaves_open.line"
        assert (notice.values["kind"], notice.values["part"]) == ("centres", "about_line")
        assert notice.ids == tuple(result.given.images.ids)


@pytest.mark.parametrize(("bend", "open_"), [(0.0, 1), (0.5, 0)])
def test_an_adjusted_block_is_adjusted_to_the_same(bend, open_):
    first = adjust(straight_flight(bend), AdjustmentOptions(jobs=1))
    assert first.constraints == open_
    again = adjust(replace(first.given, images=first.adjusted.images, points=first.adjusted.points))
    assert again.constraints == first.constraints
    assert again.redundancy == first.redundancy
    assert again.sigma0 == pytest.approx(first.sigma0, rel=1e-6)
    std, same = first.precision.object_point_std, again.precision.object_point_std
    # the frame may lie turned about the line a little: lengths of standard deviations
    np.testing.assert_allclose(np.linalg.norm(same, axis=1), np.linalg.norm(std, axis=1), rtol=0.02)
    assert std.max() < 0.1  # not the rotation that errors of 2 cm tell


@pytest.mark.parametrize("name", ["square views of a plane", "square views, three distances", "two images"])
def test_rounding_is_no_fault_of_the_redundancy_numbers(name):
    make, options = CASES[name]
    result = adjust(make(), options)
    assert "redundancy_sum" not in {n.code for n in result.notices}


def test_a_wrong_redundancy_number_is_a_fault():
    result = adjust(straight_flight(0.5), AdjustmentOptions(jobs=1))
    numbers = result.image_observations.redundancy.copy()
    numbers[0] += 1e-3
    wrong = replace(result.image_observations, redundancy=numbers)
    work = result.handle.work
    for statistics, told in ((result.image_observations, False), (wrong, True)):
        found = redundancy_sum(work, work.state, work.found, statistics, result.groups, result.redundancy)
        assert ("redundancy_sum" in {n.code for n in notices_of(result, found)}) == told
