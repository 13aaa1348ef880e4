"""Dots without a name are linked by oriented images, and none that do not belong together."""

from dataclasses import replace

import numpy as np

from raybundle.block.select import with_rows
from raybundle.orientation.unknown_points import link_unnamed
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene


def test_every_dot_finds_its_own():
    """40 of 140 points are known; the others are image points in any order, with as many false ones."""
    scene = field_scene(TargetField(stations=8, frontal=2))
    truth = simulate(scene, Survey(image_sigma_px=0.1, seed=4)).truth
    noise = np.random.default_rng(1)
    o = truth.observations
    named = o.point < 40
    block = replace(with_rows(truth, named), cameras=truth.cameras)
    dots, owner = [], []
    for i in range(len(truth.images)):
        mine = np.flatnonzero((o.image == i) & ~named)
        xy = o.xy_px[mine] + 0.1 * noise.standard_normal((len(mine), 2))
        false = noise.uniform([0, 0], [6000, 4000], (len(mine), 2))
        order = noise.permutation(2 * len(mine))
        dots.append(np.vstack([xy, false])[order])
        owner.append(np.append(o.point[mine], np.full(len(mine), -1))[order])
    groups = link_unnamed(block, dots)
    found = [{int(owner[i][d]) for i, d in group} for group in groups]
    assert all(len(f) == 1 and -1 not in f for f in found)
    rays = np.bincount(o.point, minlength=len(truth.points))
    assert len(found) == (rays[40:] >= 3).sum()
    assert len({min(f) for f in found}) == len(found)
    assert sum(len(g) for g in groups) > 0.98 * (~named)[rays[o.point] >= 3].sum()
    assert len({(i, d) for g in groups for i, d in g}) == sum(len(g) for g in groups)


def test_nothing_to_link():
    truth = simulate(field_scene(TargetField(stations=4, frontal=0)), Survey()).truth
    assert link_unnamed(truth, [np.zeros((0, 2))] * len(truth.images)) == []
