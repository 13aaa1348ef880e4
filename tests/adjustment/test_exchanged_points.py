"""Two names exchanged in an image cost these two image points, and both points are named."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import Severity
from raybundle.block.points import automatic_name
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, Ring, aerial_scene, field_scene, ring_scene
from tests.fields import SMALL

SNOOPING = AdjustmentOptions(jobs=1, reject="snooping")
SCENES = {
    "testfield": lambda: (field_scene(SMALL), Survey(seed=4, scale_bars=2)),
    "ring": lambda: (ring_scene(Ring()), Survey(seed=4, scale_bars=2)),
    "aerial": lambda: (aerial_scene(AerialStrips()), Survey(seed=0, control=8, control_sigma=(0.02, 0.02, 0.03))),
}


def exchanged(block, rng, pairs, images):
    """The block with names exchanged in some images, and the rows."""
    o, point, bad = block.observations, block.observations.point.copy(), []
    tie = ~block.points.is_control.any(axis=1) & ~block.points_named & (block.ray_count >= 6)
    for image in rng.choice(len(block.images), images, replace=False):
        rows = rng.permutation(np.flatnonzero((o.image == image) & tie[o.point]))[: 2 * pairs]
        for a, b in rows.reshape(-1, 2).tolist():
            point[[a, b]] = o.point[[b, a]]
            bad += [a, b]
    return replace(block, observations=replace(o, point=point)), sorted(bad)


@pytest.mark.parametrize(("pairs", "images"), [(1, 1), (2, 1), (1, 4)])
@pytest.mark.parametrize("kind", list(SCENES))
def test_exchanged_names_cost_these_image_points_alone(kind, pairs, images):
    scene, survey = SCENES[kind]()
    block, bad = exchanged(simulate(scene, survey).observed, np.random.default_rng(0), pairs, images)
    result = adjust(block, SNOOPING)
    assert np.flatnonzero([r is not None for r in result.image_observations.rejected]).tolist() == bad
    (notice,) = [n for n in result.notices if n.code == "names_exchanged"]
    assert notice.values["pairs"] == pairs * images
    assert set(notice.ids) == {block.points.ids[k] for k in block.observations.point[bad]}
    assert "blunder_not_located" not in {n.code for n in result.notices}


@pytest.mark.parametrize("named", [0, 1])
def test_tie_points_that_nobody_named_are_mismatches(named):
    """Nobody has exchanged their names, not even with that of a point that has one."""
    scene, survey = SCENES["testfield"]()
    block, bad = exchanged(simulate(scene, survey).observed, np.random.default_rng(0), 1, 1)
    ids = list(block.points.ids)
    for k in block.observations.point[bad][named:].tolist():
        ids[k] = automatic_name(k)
    result = adjust(replace(block, points=replace(block.points, ids=tuple(ids))), SNOOPING)
    (notice,) = [n for n in result.notices if n.code in {"names_exchanged", "ties_mismatched"}]
    assert notice.code == "ties_mismatched"
    assert notice.severity is Severity.NOTE
    assert set(notice.ids) == {ids[k] for k in block.observations.point[bad]}


@pytest.mark.parametrize("seed", range(6))
def test_a_minority_of_exchanged_names_does_not_win(seed):
    """The same two points in several images: rays with the wrong names meet one another in the other point."""
    survey = Survey(seed=seed, control=8, control_sigma=(2e-4, 2e-4, 2e-4))
    simulated = simulate(ring_scene(Ring()), survey)
    block, rng = simulated.observed, np.random.default_rng(seed)
    o, point = block.observations, block.observations.point.copy()
    images = [set(o.image[o.point == k].tolist()) for k in range(len(block.points))]
    loose = np.flatnonzero(~block.points_named & ~block.points.is_control.any(axis=1))
    pairs = [(a, b) for a in loose for b in loose if a < b and len(images[a] & images[b]) >= 4]
    a, b = pairs[rng.integers(len(pairs))]
    rays = min(len(images[a]), len(images[b]))
    some = rng.permutation(sorted(images[a] & images[b]))[: (rays - 1) // 2]
    for image in some:
        here = {k: int(np.flatnonzero((o.image == image) & (o.point == k))[0]) for k in (a, b)}
        point[[here[a], here[b]]] = b, a
    result = adjust(replace(block, observations=replace(o, point=point)), SNOOPING)
    away = result.adjusted.points.xyz[[a, b]] - simulated.truth.points.xyz[[a, b]]
    extent = np.linalg.norm(np.ptp(simulated.truth.points.xyz, axis=0))
    assert np.linalg.norm(away[np.isfinite(away).all(axis=1)], axis=1).max(initial=0) < 0.01 * extent
    assert {"names_exchanged", "blunder_not_located"} & {n.code for n in result.notices}


@pytest.mark.parametrize("px", [8.0, 80.0, 800.0])
def test_image_points_beside_their_own_place_are_not_called_exchanged(px):
    block = simulate(field_scene(SMALL), Survey(seed=4, scale_bars=2)).observed
    o = block.observations
    rows = np.flatnonzero((o.image == 3) & ~block.points_named[o.point])[:4]
    xy = o.xy_px.copy()
    xy[rows] += px * np.array([[1, 1], [-1, 1], [1, -1], [-1, -1]])
    result = adjust(replace(block, observations=replace(o, xy_px=xy)), SNOOPING)
    assert np.flatnonzero([r is not None for r in result.image_observations.rejected]).tolist() == rows.tolist()
    assert "names_exchanged" not in {n.code for n in result.notices}
