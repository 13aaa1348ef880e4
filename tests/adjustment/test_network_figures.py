"""Figures of the network against their definitions, one point and one pair of images after the other."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.network import classed, precision_class, weak_images, with_std
from raybundle.block.select import with_rows
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene


@pytest.fixture(scope="module")
def result():
    """Two strips; one image keeps the points that one other shows, and two stand at nearly the same place."""
    scene = aerial_scene(AerialStrips(strips=2, images_per_strip=4, points_per_image=60, relief=150.0))
    centre = scene.centre.copy()
    centre[2] = centre[1] + [0.5, 0.3, 0.2]
    survey = Survey(orientation="exact", points="exact", interior="exact", control=6, control_sigma=(0.02,) * 3)
    block = simulate(replace(scene, centre=centre), survey).observed
    o = block.observations
    many = (np.bincount(o.point) > 2)[o.point]
    block = with_rows(block, ~((o.image == 6) & many))
    return adjust_block(block, AdjustmentOptions(jobs=1))


def rays_of(result):
    """Of each point its images, and of each image its points, from the rows that took part."""
    o, used = result.given.observations, result.image_observations.used
    seen = np.zeros((len(result.given.images), len(result.given.points)), bool)
    seen[o.image[used], o.point[used]] = True
    return seen


def test_points(result):
    n, seen = result.network, rays_of(result)
    C, X = result.adjusted.images.centre, result.adjusted.points.xyz
    for p in np.flatnonzero(seen.any(axis=0)):
        mine = np.flatnonzero(seen[:, p])
        assert n.rays[p] == len(mine)
        to, far = X[p] - C[mine], np.linalg.norm(X[p] - C[mine], axis=1)
        angles = [np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b) for a, b in combinations(to, 2)]
        if angles:
            assert n.intersection_angle[p] == pytest.approx(max(angles), rel=1e-6)
        apart = [all(np.linalg.norm(C[i] - C[j]) >= 0.01 * far.mean() for j in mine[:k]) for k, i in enumerate(mine)]
        assert n.stations_per_point[p] == sum(apart)
    assert (n.stations_per_point < n.rays).any()
    assert np.isnan(n.intersection_angle[n.rays < 2]).all()


def test_pairs(result):
    n, seen = result.network, rays_of(result)
    C, X, R = result.adjusted.images.centre, result.adjusted.points.xyz, result.adjusted.images.rotation
    expected = {}
    for i, j in combinations(range(len(C)), 2):
        common = int((seen[i] & seen[j]).sum())
        if common >= 6:
            depth = [np.mean([-R[k, 2] @ (x - C[k]) for x in X[seen[k]]]) for k in (i, j)]
            expected[i, j] = common, np.linalg.norm(C[i] - C[j]) / np.mean(depth)
    found = {tuple(p): (c, b) for p, c, b in zip(n.pair_images.tolist(), n.pair_points, n.base_to_depth, strict=True)}
    assert found.keys() == expected.keys()
    for pair, (common, ratio) in expected.items():
        assert found[pair][0] == common
        assert found[pair][1] == pytest.approx(ratio, rel=1e-6)


def test_images(result):
    n, seen, block = result.network, rays_of(result), result.given
    C, X, o = result.adjusted.images.centre, result.adjusted.points.xyz, block.observations
    camera = block.cameras[0]
    for i in range(len(C)):
        distance = np.median(np.linalg.norm(X[seen[i]] - C[i], axis=1))
        assert n.distance[i] == pytest.approx(distance, rel=1e-6)
        assert n.image_scale[i] == pytest.approx(distance * 1000 / camera.values["c"], rel=1e-6)
        xy = o.xy_px[(o.image == i) & result.image_observations.used]
        cells = {(int(x / camera.width_px * 10), int(y / camera.height_px * 10)) for x, y in xy}
        assert n.coverage[i] == pytest.approx(len(cells) / 100)
    firm = [sum(i in p and c >= 30 for p, c in zip(n.pair_images, n.pair_points, strict=True)) for i in range(len(C))]
    assert weak_images(n, len(C)).tolist() == [i for i, k in enumerate(firm) if k < 2]


def test_precision_of_the_whole(result):
    n, X = result.network, result.adjusted.points.xyz
    X = X[n.rays > 0]
    std = result.precision.object_point_std[n.rays > 0]
    # two stations side by side leave a few points poor, which hold most of the variance
    worst = np.sort((std**2).sum(axis=1))[::-1]
    assert worst[: len(std) // 20].sum() > worst.sum() / 2
    typical = std[(std**2).sum(axis=1) < worst[len(std) // 20]]
    assert n.mean_std == pytest.approx(typical.mean(), rel=1e-6)
    assert n.mean_share == pytest.approx(0.95, abs=0.01)
    even = np.ones((100, 3))
    assert with_std(n, even).mean_std == with_std(n, even).mean_share == 1
    along = (X - X.mean(axis=0)) @ np.linalg.eigh(np.cov(X.T))[1]
    assert n.extent == pytest.approx(np.linalg.norm(np.ptp(along, axis=0)), rel=0.02)
    assert n.relative_precision == pytest.approx(n.extent / n.mean_std)
    sigma_xy = np.sqrt(result.given.observations.cov_px2[0, 0]) * result.given.cameras[0].pixel_mm[0]
    for q, k in ((n.q, n.rays), (n.q_stations, n.stations_per_point)):
        # sigma_XYZ = q S sigma_xy / sqrt(k)
        assert q * n.image_scale.mean() * sigma_xy / np.sqrt(k[n.rays > 0].mean()) == pytest.approx(1000 * n.mean_std)
    twice = with_std(n, 2 * result.precision.object_point_std)
    assert twice.mean_std == pytest.approx(2 * n.mean_std)
    assert twice.relative_precision == pytest.approx(n.relative_precision / 2)
    assert n.precision_class == precision_class(n.relative_precision)
    names = [precision_class(r) for r in (24_999, 25_000, 99_999, 100_000, 199_999, 200_000)]
    assert names == ["below amateur (1:25 000)", *2 * ["amateur"], *2 * ["professional"], "photogrammetric camera"]


def test_far_points_do_not_make_the_extent(result):
    """Of many points the outermost 0.25 % at either end of an axis are left out."""
    from raybundle.adjustment.statistics.network import _extent

    xyz = np.random.default_rng(2).uniform(-1, 1, (2000, 3)) * [40, 20, 10]
    assert _extent(xyz) == pytest.approx(2 * np.sqrt(40**2 + 20**2 + 10**2), rel=0.01)
    far = np.concatenate([xyz, [[1000.0, 0, 0], [0, -1000, 0]]])
    assert _extent(far) == pytest.approx(_extent(xyz), rel=0.01)
    assert _extent(far[-150:]) > 1000


def test_tie_points_are_not_in_a_class(result):
    block = result.given
    names = tuple(f"t{k + 1}" for k in range(len(block.points)))
    assert classed(block)
    assert not classed(replace(block, points=replace(block.points, ids=names)))
