"""Figures of residuals against their definitions, one pair of image points and one cell after the other."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2, f

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.cell_means import (
    between_images,
    cell_means,
    normalised_residuals,
    systematic_notices,
)
from raybundle.adjustment.evaluation.residual_structure import repeated_residuals, residual_structure
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block.rejection import Rejection, RejectionKind
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene

SHARED = 0.6
"""Part of each residual that neighbours in the drawn residuals have in common"""


@pytest.fixture(scope="module")
def result():
    """An adjustment of which places in the images and residuals are drawn anew: half-common ones within a place."""
    scene = aerial_scene(AerialStrips(strips=2, images_per_strip=5, points_per_image=150, relief=150.0))
    survey = Survey(orientation="exact", points="exact", interior="exact", control=8, control_sigma=(0.02,) * 3)
    block = simulate(scene, survey).observed
    result = adjust_block(block, AdjustmentOptions(jobs=1))
    rng, o, s = np.random.default_rng(5), block.observations, result.image_observations
    m, camera = len(o.image), block.cameras[0]
    size = np.array([camera.width_px, camera.height_px])
    diagonal = math.hypot(*size)
    places = rng.uniform(0.1, 0.9, (12, 2)) * size
    mine = rng.integers(0, 12, m)
    xy = np.clip(places[mine] + rng.normal(0, 0.012 * diagonal, (m, 2)), 0, size - 1)
    sigma = rng.uniform(0.2, 0.6, (m, 2))
    cov = np.stack([*(sigma**2).T, np.zeros(m)], axis=1)
    common = rng.normal(size=(12, 2))[mine]
    r = np.clip(s.redundancy, 0.05, None)
    v = (rng.normal(size=(m, 2)) + SHARED * common) * sigma * np.sqrt(r)
    reasons = tuple(Rejection(kind=RejectionKind.GIVEN) if k in (3, 40) else None for k in range(m))
    found = replace(s, residuals_px=v, w=v / sigma / np.sqrt(r), rejected=reasons)
    given = replace(block, observations=replace(o, xy_px=xy, cov_px2=cov))
    return replace(result, given=given, image_observations=found)


def normalised(result):
    s, o = result.image_observations, result.given.observations
    return s.residuals_px / np.sqrt(o.cov_px2[:, :2]) / np.sqrt(np.maximum(s.redundancy, 0.05))


def test_neighbours(result):
    o, used = result.given.observations, np.flatnonzero(result.image_observations.used)
    camera = result.given.cameras[0]
    diagonal = math.hypot(camera.width_px, camera.height_px)
    z = normalised(result)
    variance = np.mean(z[used] ** 2)
    products, of_images = [], {}
    for i in range(len(result.given.images)):
        mine = [k for k in used if o.image[k] == i]
        for n, a in enumerate(mine):
            for b in mine[:n]:
                if 0.01 * diagonal < math.dist(o.xy_px[a], o.xy_px[b]) <= 0.03 * diagonal:
                    products.append(z[a] @ z[b] / 2 / variance)
                    of_images.setdefault(i, []).append(products[-1])
    found = residual_structure(result)
    assert found.pairs == len(products) > 1000
    assert found.correlation == pytest.approx(np.mean(products))
    assert found.correlation == pytest.approx(SHARED**2 / (1 + SHARED**2), abs=0.15)
    assert found.std == pytest.approx(1 / np.sqrt(2 * len(products)))
    assert found.factor == pytest.approx(np.sqrt(1 + 2 * np.sum(products) / len(used)))
    for i, mean in enumerate(found.images):
        many = len(of_images.get(i, ())) >= 100
        assert mean == pytest.approx(np.mean(of_images[i])) if many else np.isnan(mean)


def test_neighbours_are_correlated_by_nothing_where_errors_are_independent(result):
    s = result.image_observations
    rng = np.random.default_rng(6)
    sigma = np.sqrt(result.given.observations.cov_px2[:, :2] * np.maximum(s.redundancy, 0.05))
    free = replace(result, image_observations=replace(s, residuals_px=sigma * rng.normal(size=s.residuals_px.shape)))
    for found in (residual_structure(free), repeated_residuals(free, 0)):
        assert abs(found.correlation) < 5 * found.std


def test_the_same_place_in_other_images(result):
    o, used = result.given.observations, np.flatnonzero(result.image_observations.used)
    camera = result.given.cameras[0]
    side = 0.04 * math.hypot(camera.width_px, camera.height_px)
    z = normalised(result)
    v = z * np.sqrt(o.cov_px2[:, :2])
    cell = np.floor(o.xy_px / side).astype(int).tolist()
    variance, total, pairs = np.mean(z[used] ** 2), 0.0, 0
    for n, a in enumerate(used):
        for b in used[:n]:
            if cell[a] == cell[b] and o.image[a] != o.image[b] and o.point[a] != o.point[b]:
                total, pairs = total + z[a] @ z[b] / 2 / variance, pairs + 1
    found = repeated_residuals(result, 0)
    assert found.pairs == pairs > 1000
    assert found.correlation == pytest.approx(total / pairs)
    assert found.std == pytest.approx(1 / np.sqrt(2 * pairs))
    assert found.rms_px == pytest.approx(np.sqrt(total / pairs * np.mean(v[used] ** 2)))
    assert found.noticed


def test_means_of_cells(result):
    s, o, camera = result.image_observations, result.given.observations, result.given.cameras[0]
    tests = normalised_residuals(result)
    np.testing.assert_allclose(tests[s.used], s.w[s.used] / result.sigma0)
    assert np.isnan(tests[~s.used]).all()
    means = cell_means(result, camera, s.used, tests)
    assert (means.columns, means.rows) == (8, 6)  # of 4 x 3 formats with 400 to 2400 points
    filled, limit = 0, None
    for row in range(6):
        for column in range(8):
            k = row * 8 + column
            share = o.xy_px / [camera.width_px, camera.height_px] * [8, 6]
            mine = s.used & (np.floor(share) == [column, row]).all(axis=1)
            assert means.count[k] == mine.sum()
            if mine.any():
                filled += 1
                np.testing.assert_allclose(means.mean_px[k], s.residuals_px[mine].mean(axis=0))
                assert means.redundancy[k] == pytest.approx(s.redundancy[mine].mean())
                # sums of n independent normal deviates over the root of n
                assert means.test[k] == pytest.approx((tests[mine].sum(axis=0) ** 2).sum() / mine.sum())
    limit = chi2(2).isf(0.05 / filled)
    assert means.limit == pytest.approx(limit)
    assert means.tested == filled
    assert means.significant.tolist() == [bool(t > limit) for t in np.nan_to_num(means.test)]
    assert means.systematic
    full = np.flatnonzero(means.count >= max(3, 0.1 * np.median(means.count[means.count > 0])))
    assert np.flatnonzero(means.well_filled).tolist() == full.tolist()
    square = sum(means.count[k] * (means.mean_px[k] ** 2).sum() for k in full) / means.count[full].sum() / 2
    assert means.rms_px == pytest.approx(np.sqrt(square))
    assert means.largest_px == pytest.approx(max(np.hypot(*means.mean_px[k]) for k in full))
    (notice,) = systematic_notices(result)
    (each,) = notice.details
    overall = np.sqrt(np.mean(s.residuals_px[s.used] ** 2))
    assert each.values["cells"] == means.significant.sum()
    assert each.values["share"] == pytest.approx(means.rms_px / overall)


@pytest.mark.parametrize(("number", "due"), [(399, 0), (400, 1)])
def test_of_fewer_than_400_image_points_nothing_is_stated_by_cells(result, number, due):
    s = result.image_observations
    keep = np.flatnonzero(s.used)[:number]
    reasons = tuple(
        None if k in set(keep.tolist()) else Rejection(kind=RejectionKind.GIVEN) for k in range(len(s.used))
    )
    v = 9 * np.abs(s.residuals_px)
    few = replace(result, image_observations=replace(s, rejected=reasons, residuals_px=v, w=9 * np.abs(s.w)))
    assert len(systematic_notices(few)) == due


def test_what_images_have_in_common_is_tested_between_images():
    """Hotelling: (n - 2) / (2 (n - 1)) T^2 is F(2, n - 2); each image's points of a cell count as one observation."""
    rng = np.random.default_rng(1)
    image, cell = rng.integers(0, 9, 900), rng.integers(0, 7, 900)
    cell[image < 5] %= 6  # the last cell is shown by four images: too few
    tests = rng.normal(size=(900, 2)) + 0.5 * rng.normal(size=(9, 2))[image] + [0.2, 0.0]
    tests[:5, 0] = np.nan
    found = between_images(cell, image, tests, 8)
    for k in range(6):
        sums = []
        for i in range(9):
            mine = tests[(cell == k) & (image == i) & np.isfinite(tests).all(axis=1)]
            sums.append(mine.sum(axis=0) / np.sqrt(len(mine)))
        n, mean = len(sums), np.mean(sums, axis=0)
        T2 = n * mean @ np.linalg.solve(np.cov(np.transpose(sums)), mean)
        tail = f(2, n - 2).sf((n - 2) / (2 * (n - 1)) * T2)
        assert chi2(2).sf(found[k]) == pytest.approx(tail)
    assert found[6:].tolist() == [0, 0]
