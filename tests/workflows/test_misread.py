"""Control and positions that are read otherwise than they were meant: mirrored, exchanged, in another unit."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block import Points, Role
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.placing.exchanged_control import misread
from raybundle.placing.georeference import georeference
from raybundle.placing.marks import Given
from raybundle.placing.mirrored import mirrored_notices, without_control
from tests.workflows.free_flight import NAMES, codes, control, error, flight, with_gps

__all__ = ["flight"]


def relief(flight):
    """The flight's control, with the block that has it on towers of up to a tenth of the extent, in its own frame."""
    rng = np.random.default_rng(4)
    given = flight.xyz + np.ptp(flight.xyz[:, 0]) * 0.1 * rng.uniform(0, 1, (6, 1)) * [0, 0, 1]
    names = tuple(f"{k}" for k in range(6))
    points = Points(ids=names, role=np.full(6, Role.CONTROL, np.int32), xyz=given, sigma=np.full((6, 3), 0.01))
    turned = 0.02 * (given + rng.normal(0, 0.01, (6, 3))) @ rotation_from_angles(np.array([0.4, -0.3, 2.0])).T
    return replace(flight.free, points=points), turned


@pytest.mark.parametrize(
    "wrong",
    [
        lambda x: x[:, [1, 0, 2]], lambda x: x[:, [0, 2, 1]], lambda x: x * [-1, 1, 1], lambda x: x * [1, 1, -1],
        lambda x: -x,
    ],
    ids=["XY", "YZ", "-X", "-Z", "all"],
)  # fmt: skip
def test_control_of_the_other_hand_is_named(flight, wrong):
    block, free = relief(flight)
    other = replace(block, points=replace(block.points, xyz=wrong(block.points.xyz)))
    (notice,) = mirrored_notices(other, free)
    assert (notice.code, notice.severity) == ("control_mirrored", "fault")
    assert notice.ids == block.points.ids
    assert notice.values["mirrored_m"] < 0.1 < notice.values["rms_m"]


def test_control_of_the_right_hand_is_no_mirror_image_whatever_is_wrong(flight):
    block, free = relief(flight)
    assert not mirrored_notices(block, free)
    cyclic = replace(block, points=replace(block.points, xyz=block.points.xyz[:, [1, 2, 0]]))
    assert not mirrored_notices(cyclic, free)
    for k in range(6):
        for axis in range(3):
            xyz = block.points.xyz.copy()
            xyz[k, axis] += 0.3 * np.ptp(xyz[:, 0])
            assert not mirrored_notices(replace(block, points=replace(block.points, xyz=xyz)), free)
    rng = np.random.default_rng(2)
    flat = block.points.xyz * [1, 1, 0] + [0, 0, 5.0]
    for _ in range(20):
        noisy = flat + rng.normal(0, 0.05, flat.shape)
        assert not mirrored_notices(replace(block, points=replace(block.points, xyz=noisy)), flat)


@pytest.mark.parametrize("pair", [(0, 2), (1, 5), (3, 4)])
def test_exchanged_names_of_control_are_named_and_take_no_part(flight, pair):
    xyz = flight.xyz.copy()
    xyz[list(pair)] = flight.xyz[list(pair[::-1])]
    placed = georeference(flight.free, flight.photos, Given(control=(control(flight, xyz),), sigma_given=True))
    (notice,) = [n for n in placed.notices if n.code == "control_exchanged"]
    names = tuple(NAMES[k] for k in pair)
    assert (notice.ids, notice.severity) == (names, "fault")
    assert (notice.values["first"], notice.values["second"]) == names
    assert error(flight, placed) < 0.5
    left = placed.block.points
    assert {n for n, c in zip(left.ids, left.is_control.any(axis=1), strict=True) if c} == set(NAMES) - set(names)
    assert placed.marked.sum() == 6


@pytest.mark.parametrize(("given", "factor"), [(1.0, 1000.0), (1000.0, 0.001)])
def test_a_point_of_another_unit_is_named_and_takes_no_part(flight, given, factor):
    xyz = given * flight.xyz
    xyz[3] *= factor
    placed = georeference(
        flight.free, flight.photos, Given(control=(control(flight, xyz, sigma=0.01 * given),), sigma_given=True)
    )
    (notice,) = [n for n in placed.notices if n.code == "control_unit"]
    assert notice.ids == ("D",)
    assert notice.values["millimetres"] == (factor > 1)
    centre = placed.block.images.centre / given
    assert np.linalg.norm(centre - flight.truth.images.centre, axis=1).max() < 0.5


@pytest.mark.long
def test_nothing_else_looks_exchanged_or_in_another_unit(flight):
    """Right control, scattered control, and every single or double error that is no exchange."""
    rng = np.random.default_rng(8)
    free = flight.xyz @ rotation_from_angles(np.array([0.4, -0.3, 2.0])).T
    for noise in (0.0, 0.01, 1.0):
        for _ in range(40):
            seen = free + rng.normal(0, 0.01, free.shape)
            xyz = flight.xyz + rng.normal(0, 1, free.shape) * noise
            assert misread(seen, xyz, units=True) is None
            wrong = rng.choice(6, int(rng.integers(1, 3)), replace=False)
            xyz[wrong] += rng.normal(0, 0.3 * np.ptp(flight.xyz[:, 0]), (len(wrong), 3))
            assert misread(seen, xyz, units=True) is None


def test_few_points_and_points_in_a_line_tell_no_exchange(flight):
    swapped = flight.xyz[[1, 0, 2, 3]]
    assert misread(flight.xyz[:4], swapped, units=True) is None
    line = np.arange(6.0)[:, None] * [1.0, 2.0, 0.5]
    assert misread(line, line[[1, 0, 2, 3, 4, 5]], units=True) is None


def test_exchanged_positions_of_two_photographs_are_named_and_not_used(flight):
    photos = with_gps(flight)
    a, b = photos[1].metadata.gps, photos[5].metadata.gps
    photos[1].metadata.gps, photos[5].metadata.gps = b, a
    placed = georeference(flight.free, photos, Given())
    (notice,) = [n for n in placed.notices if n.code == "positions_exchanged"]
    ids = flight.free.images.ids
    assert (notice.ids, notice.severity) == ((ids[1], ids[5]), "fault")
    assert placed.fixed
    assert not {1, 5} & set(placed.block.stations.image.tolist())
    assert "positions_exchanged" not in codes(georeference(flight.free, with_gps(flight), Given()))


def test_control_of_the_other_hand_takes_no_part(flight):
    block, free = relief(flight)
    assert mirrored_notices(replace(block, points=replace(block.points, xyz=-block.points.xyz)), free)
    left = without_control(replace(block, points=replace(block.points, xyz=-block.points.xyz)))
    assert not left.points.is_control.any()
    assert not left.points.is_check.any()
    assert left.points.ids == block.points.ids
