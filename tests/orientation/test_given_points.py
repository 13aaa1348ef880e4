"""Given coordinates of tie points: kept where they are near their rays, intersected anew where the rays do better."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import Severity
from raybundle.block import Role
from raybundle.block.rejection import Rejection, RejectionKind
from raybundle.numerics.progress import silent
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.orientation.known_points import intersected_where_better
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import field_scene
from raybundle.workflows import adjust as workflow
from raybundle.workflows.final_adjustment import _decided
from tests.fields import SMALL

SNOOPING = AdjustmentOptions(jobs=1, reject="snooping")


def network(seed, share=0.0, metres=0.0, orientation=(0.02, 0.02)):
    """Convergent images of a field: orientations off by metres and radians, a share of the points by metres."""
    s = simulate(field_scene(SMALL), Survey(seed=seed, orientation="exact", points="exact", control=0))
    block, rng = s.observed, np.random.default_rng(seed)
    images = block.images
    turn = np.array([rotation_from_vector(v) for v in rng.normal(0, orientation[1], (len(images), 3))])
    moved = replace(
        images, centre=images.centre + rng.normal(0, orientation[0], (len(images), 3)), rotation=turn @ images.rotation
    )
    bad = rng.random(len(block.points)) < share
    xyz = block.points.xyz + bad[:, None] * rng.normal(0, metres, block.points.xyz.shape)
    return replace(block, images=moved, points=replace(block.points, xyz=xyz)), bad


@pytest.mark.parametrize("metres", [3.0, 1000.0])
@pytest.mark.parametrize("seed", range(4))
def test_points_far_off_cost_no_observation(seed, metres):
    block, bad = network(seed, 0.2, metres)
    result = adjust(block)
    assert result.converged
    assert all(r is None for r in result.image_observations.rejected)
    clean = adjust(network(seed)[0])
    assert result.sigma0 == pytest.approx(clean.sigma0, rel=1e-6)
    told = [n for n in result.notices if n.code == "approximate_values_replaced"]
    assert bad.any()
    assert [n.severity for n in told] == [Severity.NOTE]
    assert "points.csv" in told[0].text


def test_points_near_their_rays_are_kept_also_where_orientations_are_rough():
    block, _ = network(1, orientation=(0.05, 0.03))
    found = intersected_where_better(block)
    assert len(found.replaced) <= 0.05 * len(block.points)
    assert not len(found.gross)


def test_a_wrong_ray_makes_no_given_point_wrong():
    block, _ = network(1, orientation=(0.0, 0.0))
    o, xy = block.observations, np.array(block.observations.xy_px)
    of_first = np.flatnonzero(o.point == o.point[0])
    xy[of_first[0]] += 300.0
    found = intersected_where_better(replace(block, observations=replace(o, xy_px=xy)))
    assert o.point[0] not in found.replaced


def test_where_orientations_are_nonsense_the_points_are_kept():
    block, _ = network(1)
    turned = np.random.default_rng(2).permutation(len(block.images))
    block = replace(block, images=replace(block.images, rotation=block.images.rotation[turned]))
    assert len(intersected_where_better(block).gross) < 0.5 * len(block.points)


def test_arbitrary_coordinates_without_orientations_are_not_used_and_that_is_said():
    block, _ = network(3)
    nowhere = np.full_like(block.images.centre, np.nan)
    images = replace(block.images, centre=nowhere, rotation=np.full_like(block.images.rotation, np.nan))
    arbitrary = np.random.default_rng(3).normal(0, 2.4, block.points.xyz.shape)
    result = adjust(replace(block, images=images, points=replace(block.points, xyz=arbitrary)))
    without = adjust(replace(block, images=images, points=replace(block.points, xyz=np.full_like(arbitrary, np.nan))))
    assert result.sigma0 == pytest.approx(without.sigma0, rel=1e-6)
    assert "approximate_values_replaced" in {n.code for n in result.notices}


@pytest.mark.parametrize("shift", [(0.0, 0.0, 0.0), (100.0, 200.0, 10.0), (5e5, 5e6, 100.0)])
def test_check_points_in_another_system_than_a_free_block_cost_nothing(shift):
    """Their coordinates are there to be compared; where they begin, their rays say."""
    block, _ = network(1, orientation=(0.0, 0.0))
    role, xyz = np.array(block.points.role), block.points.xyz.copy()
    role[:5] = Role.CHECK
    xyz[:5] += shift
    checked = replace(block, points=replace(block.points, role=role, xyz=xyz))
    plain = adjust(block, SNOOPING)
    for result in (adjust(checked, SNOOPING), _decided(checked, SNOOPING, silent, ())):
        assert all(r is None for r in result.image_observations.rejected)
        assert result.sigma0 == pytest.approx(plain.sigma0, rel=1e-6)
        assert np.array_equal(result.given.points.xyz[:5], xyz[:5])  # what was given stays to be compared
        assert not [n for n in result.notices if n.code == "approximate_values_replaced"]


def test_a_minimum_in_which_cameras_look_away_is_doubted(monkeypatch):
    """Rough approximate values can end in a minimum with a part of the points behind the cameras."""
    block, _ = network(1)
    whole = adjust(block)
    o = block.observations

    def away(given, observed, options, progress):
        found = from_given(given, observed, options, progress)
        lost = [Rejection(kind=RejectionKind.BEHIND_CAMERA) if k % 20 == 0 else None for k in range(len(o))]
        return replace(found, image_observations=replace(found.image_observations, rejected=tuple(lost)))

    from_given = workflow._from_given
    monkeypatch.setattr(workflow, "_from_given", away)
    result = adjust(block)
    assert result.sigma0 == pytest.approx(whole.sigma0, rel=1e-6)
    assert all(r is None for r in result.image_observations.rejected)
    (stated,) = (n for n in result.notices if n.code == "approximate_values_replaced")
    assert (stated.variant, stated.values["n"]) == ("behind", -(-len(o) // 20))
