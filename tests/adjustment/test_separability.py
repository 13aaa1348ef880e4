"""A blunder that cannot be located costs the point, and is told; one that can be costs the ray."""

from dataclasses import replace

import numpy as np
from scipy.stats import norm

from raybundle.adjustment.blunders.separability import SURE, _correlations, unlocatable
from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.rejection import RejectionKind
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, TargetField, aerial_scene, brown_camera, field_scene

SNOOPING = AdjustmentOptions(jobs=1, reject="snooping")
EXACT = Survey(orientation="exact", points="exact", interior="exact", image_sigma_px=0.3)


def strips():
    camera = brown_camera(values={"c": 24.0, **dict.fromkeys(("K1", "K2", "K3", "P1", "P2"), 0.0)}, estimate=())
    plan = AerialStrips(camera=camera, height=12.0, relief=0.5, strips=2, images_per_strip=6)
    return simulate(aerial_scene(plan), EXACT).observed


def with_blunder(block, row, px):
    o = block.observations
    xy = o.xy_px.copy()
    xy[row] += px
    return replace(block, observations=replace(o, xy_px=xy))


def row_of_point_with(block, rays):
    count = np.bincount(block.observations.point, minlength=len(block.points))
    point = int(np.flatnonzero(count == rays)[len(np.flatnonzero(count == rays)) // 2])
    return int(np.flatnonzero(block.observations.point == point)[0]), point


def test_a_wrong_ray_of_three_costs_the_point_and_is_told():
    block = strips()
    row, point = row_of_point_with(block, 3)
    result = decide(with_blunder(block, row, (0.0, 25.0)), SNOOPING)
    reasons = [
        r for r, p in zip(result.image_observations.rejected, block.observations.point, strict=True) if p == point
    ]
    assert {r.kind for r in reasons if r} == {RejectionKind.BLUNDER_NOT_LOCATED}
    (told,) = [n for n in result.notices if n.code == "blunder_not_located"]
    assert told.ids == (block.points.ids[point],)
    assert np.isnan(result.precision.object_points[point]).all()


def test_a_wrong_ray_of_many_is_located():
    block = simulate(field_scene(TargetField(stations=12, camera=brown_camera(estimate=()))), EXACT).observed
    row, point = row_of_point_with(block, int(block.ray_count.max()))
    result = decide(with_blunder(block, row, (25.0, 15.0)), SNOOPING)
    out = np.flatnonzero([bool(r) for r in result.image_observations.rejected])
    assert out.tolist() == [row]
    assert np.isfinite(result.precision.object_points[point]).all()


def test_no_point_is_left_with_two_rays_after_a_rejection():
    block, rng = strips(), np.random.default_rng(3)
    o = block.observations
    wrong = rng.random(len(o)) < 0.03
    noisy = replace(o, xy_px=o.xy_px + wrong[:, None] * rng.normal(0, 20, (len(o), 2)))
    result = decide(replace(block, observations=noisy), SNOOPING)
    used = result.image_observations.used
    left = np.bincount(o.point[used], minlength=len(block.points))
    assert not ((left < block.ray_count) & (left > 0) & (left < 3)).any()
    lost_alone = ~used & ~wrong & (left[o.point] > 0)
    assert lost_alone.sum() <= 1


def test_a_blunder_is_located_where_every_other_ray_is_refuted_with_99_percent():
    """By a blunder in another ray w1 is rho w2 on average, and has the variance 1 - rho^2."""
    plan = TargetField(rows=4, columns=5, stations=4, frontal=1, camera=brown_camera(estimate=()))
    result = adjust_block(simulate(field_scene(plan), EXACT).observed, AdjustmentOptions(jobs=1))
    o = result.given.observations
    point = int(np.argmax(result.given.ray_count))
    rays = np.flatnonzero(o.point == point)
    row, others = int(rays[0]), rays[1:]
    rho = _correlations(result.adjusted, row, others)
    k = int(np.argmax(rho))
    assert 0.2 < rho[k] < 0.95
    for w in (1.0, 3.0, 6.0):
        least = rho[k] * w + norm.ppf(0.99) * np.sqrt(1 - rho[k] ** 2)
        for more, located in ((0.02, True), (-0.02, False)):
            t = np.zeros_like(result.image_observations.t)
            t[others[k], 1], t[row, 0] = w, -(least + more)
            quiet = rho * 0 + SURE * np.sqrt(1 - rho**2) < least + more
            assert quiet[np.arange(len(rho)) != k].all() or not located
            shown = replace(result, image_observations=replace(result.image_observations, t=t))
            assert unlocatable(shown, np.array([row])).tolist() == [not located]
