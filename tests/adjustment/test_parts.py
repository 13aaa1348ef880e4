"""Two networks in one block: each is adjusted as if it were alone, and each needs a datum of its own."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.defects import held_by_points
from raybundle.block import Role
from raybundle.block.select import with_rows
from raybundle.errors import DatumDefect
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene

OPTIONS = AdjustmentOptions(jobs=1, tolerance=1e-6)


@pytest.fixture(scope="module")
def apart():
    """Two strips without a common point, with control in both."""
    scene = aerial_scene(AerialStrips(strips=2, images_per_strip=4, points_per_image=40, relief=150.0))
    survey = Survey(orientation="exact", points="exact", interior="exact", control=40)
    block = simulate(scene, survey).observed
    o, p = block.observations, len(block.points)
    rays = np.stack([np.bincount(o.point[(o.image >= 4) == strip], minlength=p) for strip in (False, True)])
    of = rays.argmax(axis=0)
    keep = (of[o.point] == (o.image >= 4)) & (rays.max(axis=0) > 1)[o.point]
    block = with_rows(block, keep)
    mine = np.zeros(len(block.points), int)
    mine[block.observations.point] = block.observations.image >= 4
    return block, mine


def strip_of(block, number):
    return with_rows(block, (block.observations.image >= 4) == bool(number))


def test_each_part_is_adjusted_as_if_it_were_alone(apart):
    block, of = apart
    both = adjust_block(block, OPTIONS)
    assert both.network.components == 2
    alone = [adjust_block(strip_of(block, k), OPTIONS) for k in (0, 1)]
    assert [a.network.components for a in alone] == [1, 1]
    assert both.weighted_square_sum == pytest.approx(sum(a.weighted_square_sum for a in alone))
    for k, a in enumerate(alone):
        mine = np.flatnonzero(of == k)
        its = [a.given.points.ids.index(block.points.ids[p]) for p in mine]
        np.testing.assert_allclose(both.adjusted.points.xyz[mine], a.adjusted.points.xyz[its], atol=1e-6)
        cofactor = both.precision.object_points[mine] / both.variance_factor
        own = a.precision.object_points[its] / a.variance_factor
        np.testing.assert_allclose(cofactor, own, rtol=1e-5, atol=1e-12)


def test_a_part_without_a_datum_is_named(apart):
    block, of = apart
    role, sigma = block.points.role.copy(), block.points.sigma.copy()
    role[of == 1], sigma[of == 1] = Role.TIE, np.nan
    rows = block.observations.image >= 4
    free = replace(block, points=replace(block.points, role=role, sigma=sigma))
    assert held_by_points(block, rows)
    assert not held_by_points(free, rows)
    assert held_by_points(free, ~rows)
    with pytest.raises(DatumDefect) as caught:
        adjust_block(free, OPTIONS)
    assert caught.value.message.code == "block.parts_without_datum"
    assert caught.value.message.values["n"] == 1
    assert set(caught.value.message.details[0].values["images"]) == set(block.images.ids[4:])


def test_control_on_a_line_holds_no_part(apart):
    block, _ = apart
    rows = np.ones(len(block.observations), bool)
    xyz = block.points.xyz.copy()
    xyz[:, 1:] = xyz[:, :1] * [0.5, 0.1] + [3.0, 7.0]
    assert not held_by_points(replace(block, points=replace(block.points, xyz=xyz)), rows)
    xyz[:, 1] += np.where(np.arange(len(xyz)) % 2, 0.05, -0.05) * np.ptp(xyz[:, 0])
    assert held_by_points(replace(block, points=replace(block.points, xyz=xyz)), rows)
