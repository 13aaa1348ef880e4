"""Control points with the coordinates of another one: a fault where photographs show two, else a caution."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.blunders.identical_control import _largest_scale, identical_control, identical_notices
from raybundle.errors import NotSolvable
from tests.adjustment.test_held_control import OPTIONS, control_names, observed
from tests.messages import with_details
from tests.native.cases import block_of


def copied(block, names, *, onto, by=0.0):
    xyz = block.points.xyz.copy()
    for name in names:
        xyz[block.points.ids.index(name)] = xyz[block.points.ids.index(onto)] + by
    return replace(block, points=replace(block.points, xyz=xyz))


@pytest.mark.parametrize("sigma", [0.0, 0.001])
def test_a_copied_line_is_a_fault(sigma):
    block = observed(sigma=(sigma,) * 3, control=6)
    names = control_names(block)
    result = adjust(copied(block, names[1:2], onto=names[0]), OPTIONS)
    (notice,) = [n for n in result.notices if n.code == "control_identical"]
    assert set(notice.ids) == set(names[:2])
    assert notice.severity == "fault"
    (pair,) = notice.details
    assert (pair.code, pair.values["first"], pair.values["second"]) == ("control_identical.pair_apart", *names[:2])
    assert pair.values["apart_px"] > 0
    assert not identical_notices(block)


@pytest.mark.parametrize("sigma", [0.0, 0.001])
def test_four_alike_are_named_whether_or_not_there_is_a_result(sigma):
    block = observed(sigma=(sigma,) * 3, control=4)
    names = control_names(block)
    block = copied(block, names[1:], onto=names[0])
    try:
        found = with_details(*(n.data for n in adjust(block, OPTIONS).notices))
    except NotSolvable as error:
        found = with_details(error.message)
    ids = (m.values.get("ids", ()) for m in found if m.code.partition(".")[0] == "control_identical")
    assert {name for pair in ids for name in pair} == set(names)


def test_two_names_of_one_point_are_a_caution_and_neighbours_nothing():
    block = observed(sigma=(0.01,) * 3, control=4)
    names = control_names(block)
    a, b = (block.points.ids.index(n) for n in names[:2])
    o = block.observations
    rng = np.random.default_rng(1)
    first = {int(i): o.xy_px[k] for k, i in enumerate(o.image) if o.point[k] == a}
    xy = o.xy_px.copy()
    for k in np.flatnonzero(o.point == b):
        xy[k] = first[int(o.image[k])] + rng.normal(0, 0.1, 2)
    same = copied(replace(block, observations=replace(o, xy_px=xy)), names[1:2], onto=names[0], by=0.004)
    (notice,) = identical_notices(same)
    assert notice.severity == "warning"
    assert notice.data.code == "control_identical.alike"
    assert not identical_notices(copied(block, names[1:2], onto=names[0], by=0.02))


def test_points_too_close_for_their_survey_are_no_fault():
    """Two targets 3 mm apart whose coordinates have a standard deviation of 1 cm, in a photograph with others."""
    block = observed(sigma=(0.01,) * 3, control=4)
    names = control_names(block)
    a, b = (block.points.ids.index(n) for n in names[:2])
    o = block.observations
    first = {int(i): o.xy_px[k] for k, i in enumerate(o.image) if o.point[k] == a}
    xy = o.xy_px.copy()
    for k in np.flatnonzero(o.point == b):
        xy[k] = first[int(o.image[k])] + 6.0
    close = copied(replace(block, observations=replace(o, xy_px=xy)), names[1:2], onto=names[0], by=0.003)
    (pair,) = identical_control(close)
    assert pair.apart_px == 0


def test_standard_deviations_as_large_as_the_distances_are_no_copied_lines():
    """Points that differ by less than their standard deviations; the photographs show them far apart."""
    block = observed(sigma=(0.001,) * 3, control=4)
    extent = float(np.ptp(block.points.xyz[block.points.is_control.any(axis=1)], axis=0).max())
    given = block.points.is_control
    loose = replace(block, points=replace(block.points, sigma=np.where(given, extent, block.points.sigma)))
    (notice,) = identical_notices(loose)
    assert notice.severity == "warning"
    assert notice.data.code == "control_identical.alike"
    names = control_names(loose)
    copy, rest = identical_notices(copied(loose, names[1:2], onto=names[0]))
    assert (copy.severity, set(copy.ids)) == ("fault", set(names[:2]))
    assert rest.severity == "warning"


def test_the_largest_scale_is_that_of_two_points_far_enough_apart_in_one_photograph():
    block = block_of(control=8)
    rows, o, xyz = np.arange(0, len(block.points), 2), block.observations, block.points.xyz
    scales = {}
    for i in range(len(block.images)):
        mine = [k for k in np.flatnonzero(o.image == i) if o.point[k] in rows]
        for a, b in combinations(mine, 2):
            length = np.linalg.norm(xyz[o.point[a]] - xyz[o.point[b]])
            scales[i, a, b] = length, np.linalg.norm(o.xy_px[a] - o.xy_px[b]) / length
    for least in (0.0, np.median([length for length, _ in scales.values()])):
        expected = max(scale for length, scale in scales.values() if length > least)
        assert _largest_scale(block, rows, least) == pytest.approx(expected)
    assert _largest_scale(block, rows, 1e9) == 0
