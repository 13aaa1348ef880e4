"""A photograph whose few points nobody sees from nearby leaves; one with neighbours stays."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.block.select import with_rows
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.ties.far_apart import APART, FEW, nearest_rays, not_too_far


@pytest.fixture
def block():
    truth = simulate(field_scene(TargetField()), Survey(orientation="exact", points="exact", interior="exact")).truth
    o = truth.observations
    return with_rows(truth, (o.image < 4) & (o.point < FEW))


def turned(block, image, degrees):
    """The block with a photograph's centre carried round the object."""
    middle = block.points.xyz[np.unique(block.observations.point)].mean(axis=0)
    a = np.radians(degrees)
    turn = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    centre = block.images.centre.copy()
    others = np.delete(np.arange(4), image)
    centre[:4] = centre[others[0]] + np.linspace(0, 0.1, 4)[:, None]
    centre[image] = middle + turn @ (centre[others[0]] - middle)
    return replace(block, images=replace(block.images, centre=centre))


def test_angles_are_those_to_the_nearest_other_ray(block):
    far = turned(block, 2, 80.0)
    o, X = far.observations, far.points.xyz
    shared = [k for k in np.unique(o.point[o.image == 2]) if (o.point == k).sum() > 1]
    for k, angle in zip(shared, next(nearest_rays(far, [2])), strict=True):
        rays = {i: X[k] - far.images.centre[i] for i in o.image[o.point == k]}
        unit = {i: d / np.linalg.norm(d) for i, d in rays.items()}
        assert angle == pytest.approx(min(np.arccos(unit[2] @ unit[i]) for i in unit if i != 2))


@pytest.mark.parametrize(("degrees", "leaves"), [(40.0, False), (85.0, True)])
def test_a_photograph_that_only_far_ones_join_leaves_by_name(block, degrees, leaves):
    failed = {}
    far = turned(block, 2, degrees)
    keep = not_too_far(far, failed)
    assert (np.median(next(nearest_rays(far, [2]))) > APART) == leaves
    assert list(failed) == ([far.images.ids[2]] if leaves else [])
    assert np.array_equal(keep, (far.observations.image != 2) | (not leaves))
    if leaves:
        (why,) = failed[far.images.ids[2]].messages
        assert (why.code, round(why.values["limit_deg"])) == ("not_oriented.wide_baseline", 65)


def test_many_points_are_no_chance(block):
    far = turned(block, 2, 85.0)
    again = replace(far, observations=replace(far.observations, **{
        name: np.concatenate([getattr(far.observations, name)] * 9)[: 9 * len(far.observations)]
        for name in ("image", "point", "xy_px", "cov_px2")
    }))  # fmt: skip
    assert (again.observations.image == 2).sum() > FEW
    assert not_too_far(again, {}).all()
