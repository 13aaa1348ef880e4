"""Relief within the windows of matching: what it adds to variances of tie points, and where."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.queries import precision_in_datum
from raybundle.adjustment.evaluation.tie_roughness import doubled
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import Severity
from raybundle.io.block.folder import read_block, write_block
from raybundle.measuring.joint import Joint
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from tests.messages import refused

BLOCK = simulate(
    field_scene(TargetField(rows=5, columns=8, stations=5, frontal=1)),
    Survey(points="exact", orientation="exact", interior="exact"),
).observed


def with_windows(misfit, relief):
    n = len(BLOCK.points)
    figures = {"window": np.full(n, 0.001), "misfit": np.full(n, misfit), "relief": np.full(n, relief)}
    return replace(BLOCK, points=replace(BLOCK.points, **figures))


@pytest.fixture(scope="module")
def plain():
    return adjust_block(BLOCK, AdjustmentOptions())


@pytest.fixture(scope="module")
def rough():
    return adjust_block(with_windows(6.0, 2.0), AdjustmentOptions())


def mean_rays_of(result):
    o, found = BLOCK.observations, []
    for k in range(len(BLOCK.points)):
        ray = result.adjusted.images.centre[o.image[o.point == k]] - result.adjusted.points.xyz[k]
        d = (ray / np.linalg.norm(ray, axis=1, keepdims=True)).sum(axis=0)
        found.append(d / np.linalg.norm(d))
    return np.array(found)


def places_of(result):
    """(p, p) rows of the points, nearest first, each beginning with itself."""
    xyz = result.adjusted.points.xyz
    return np.argsort(np.linalg.norm(xyz[:, None] - xyz, axis=2), axis=1)


def squares_of(result):
    """Square sums of standardised residuals of the points, and their redundancies."""
    o, s = result.given.observations, result.image_observations
    square = (s.residuals_px**2 / o.cov_px2[:, :2]).sum(axis=1) / result.sigma0**2
    n = len(BLOCK.points)
    return np.bincount(o.point, square, n), np.bincount(o.point, s.redundancy.sum(axis=1), n)


def scatter_of(result):
    xyz, near = result.adjusted.points.xyz, places_of(result)
    own = []
    for k, d in enumerate(mean_rays_of(result)):
        v = xyz[near[k, 1:11]] - xyz[k]
        across = np.linalg.svd(d[None])[2][1:]
        A = np.column_stack([np.ones(10), v @ across.T])
        solved, *_ = np.linalg.lstsq(A, v @ d, rcond=None)
        own.append(((v @ d - A @ solved) ** 2).sum() / 7)
    return np.array([np.median(np.array(own)[n[:11]]) for n in near])


def test_the_variance_by_hand(plain):
    n = len(BLOCK.points)
    rng = np.random.default_rng(5)
    misfit, relief, window = rng.uniform(1.5, 9, n), rng.uniform(1.2, 3, n), rng.choice([0.0005, 0.0008], n)
    points = replace(BLOCK.points, window=window, misfit=misfit, relief=relief)
    bent = np.where(np.arange(n) % 3, rng.uniform(0, 0.001, n), np.nan)
    points = replace(points, sigma_curvature=bent)
    rough = adjust_block(replace(BLOCK, points=points), AdjustmentOptions())
    near, d = places_of(plain), mean_rays_of(plain)
    square, r = squares_of(plain)
    C = plain.precision.object_points
    s2 = np.einsum("pi,pij,pj->p", d, C, d)
    own = []
    for k in range(n):
        place = near[k, :25]
        M = max(misfit[k] - 1, np.median(misfit[place] - 1))
        S = max(1 - 1 / relief[k], np.median(1 - 1 / relief[place]))
        T, W = (square[k] + 1) / (r[k] + 1), window[k] / window[place].min()
        own.append(
            window[k] ** 2 * min(120 * M**2 * S**2 * T * W**5.5 * (s2[k] * (1 + r[k]) / window[k] ** 2) ** 2.5, 4)
        )
    own = np.array(own)
    assert (own < 3.9 * window**2).any()
    assert (own > 3.9 * window**2).any()
    own = 1 / (1 / own + 1 / (1.5 * scatter_of(plain)))
    least = np.array([np.median(own[place[:9]]) / 4 for place in near])
    assert (least > own).any()
    ratio = np.array([square[place[:9]].sum() / r[place[:9]].sum() for place in near])
    chance = np.array([1 + 2 * np.sqrt(2 / r[place[:9]].sum()) for place in near])
    variance = np.maximum(own, least) + np.where(ratio > chance, ratio - 1, 0) * s2 + np.nan_to_num(bent) ** 2
    np.testing.assert_allclose(rough.precision.roughness, np.sqrt(variance)[:, None] * d, rtol=1e-6, atol=1e-12)
    np.testing.assert_allclose(
        rough.precision.object_points,
        C + variance[:, None, None] * d[:, :, None] * d[:, None, :],
        rtol=1e-6,
        atol=1e-14,
    )


def test_residuals_of_a_place_widen_its_points(plain):
    corner = places_of(plain)[np.argmin(BLOCK.points.xyz[:, 0] + BLOCK.points.xyz[:, 1]), :12]
    o = BLOCK.observations
    noise = np.random.default_rng(2).normal(0, 3 * np.sqrt(o.cov_px2[:, :2])) * np.isin(o.point, corner)[:, None]
    noisy = replace(with_windows(1.0, 1.0), observations=replace(o, xy_px=o.xy_px + noise))
    result = adjust_block(noisy, AdjustmentOptions())
    square, r = squares_of(result)
    d = mean_rays_of(result)
    added = np.einsum("pi,pi->p", result.precision.roughness, d) ** 2
    s2 = np.einsum("pi,pij,pj->p", d, result.precision.object_points, d) - added
    place = places_of(result)[:, :9]
    ratio = square[place].sum(axis=1) / r[place].sum(axis=1)
    wide = ratio > 1 + 2 * np.sqrt(2 / r[place].sum(axis=1))
    assert wide[corner[:4]].all()
    assert not wide.all()
    np.testing.assert_allclose(added[wide], (ratio[wide] - 1) * s2[wide], rtol=1e-3)
    assert (added[~wide] < 1e-3 * s2[~wide]).all()


def test_neighbours_on_a_plane_show_that_there_is_no_relief():
    flat = simulate(
        field_scene(TargetField(rows=5, columns=8, stations=5, frontal=1, depth=0.0)),
        Survey(points="exact", orientation="exact", interior="exact"),
    ).observed
    n = len(flat.points)
    points = replace(flat.points, window=np.full(n, 0.001), misfit=np.full(n, 9.0), relief=np.full(n, 3.0))
    result = adjust_block(replace(flat, points=points), AdjustmentOptions())
    alone = adjust_block(flat, AdjustmentOptions())
    ratio = result.precision.object_point_std[:, 2] / alone.precision.object_point_std[:, 2]
    assert np.median(ratio) < 2.5
    assert np.linalg.norm(result.precision.roughness, axis=1).max() < 0.001


def test_everything_but_variances_of_tie_points_stays(plain, rough):
    np.testing.assert_array_equal(rough.adjusted.points.xyz, plain.adjusted.points.xyz)
    np.testing.assert_array_equal(rough.precision.images, plain.precision.images)
    assert plain.precision.roughness is None
    wide, of = doubled(rough.precision)
    assert wide > 30
    assert of == 40
    assert doubled(plain.precision) == (0, 0)
    calm = adjust_block(with_windows(1.0, 1.0), AdjustmentOptions())
    wider = calm.precision.object_point_std / plain.precision.object_point_std
    assert np.median(wider) < 1.001
    assert wider.max() < 1.5  # chance lets residuals of a place in forty exceed their redundancy
    assert doubled(calm.precision) == (0, 40)


def test_relief_is_no_higher_than_its_window():
    block = with_windows(1e3, 4.0)
    low = replace(block, points=replace(block.points, window=np.full(len(block.points), 1e-6)))
    result = adjust_block(low, AdjustmentOptions())
    assert np.median(np.linalg.norm(result.precision.roughness, axis=1)) == pytest.approx(2e-6)


def test_figures_of_windows_that_are_there_in_part_are_a_caution():
    whole = with_windows(6.0, 2.0)
    for missing in ("misfit", "relief", "window"):
        points = replace(whole.points, **{missing: None})
        notices = adjust_block(replace(whole, points=points), AdjustmentOptions()).notices
        (notice,) = [n for n in notices if n.code == "relief_unknown"]
        assert notice.severity is Severity.WARNING
        assert notice.ids == (missing,)
    for block in (whole, BLOCK):
        codes = {n.code for n in adjust_block(block, AdjustmentOptions()).notices}
        assert "relief_unknown" not in codes


def test_questions_hold_it(rough):
    names = rough.given.points.ids
    C = rough.covariance(f"point:{names[3]}")
    np.testing.assert_allclose(C, rough.precision.object_points[3], rtol=1e-6)
    apart = rough.covariance(f"point:{names[3]}", f"point:{names[4]}")
    assert np.abs(apart).max() < np.abs(C).max() / 3
    joint = Joint.of(rough)  # of what is measured by hand
    both = np.block([[C, apart], [apart.T, rough.precision.object_points[4]]])
    np.testing.assert_allclose(joint.of_points([3, 4]), both, rtol=1e-6, atol=1e-9 * C.max())
    np.testing.assert_allclose(joint.points_with([4, 3], [3])[:, :, :3], [apart.T, C], rtol=1e-6, atol=1e-9 * C.max())
    np.testing.assert_allclose(joint.point_columns(3)[1], C, rtol=1e-6, atol=1e-9 * C.max())
    again = precision_in_datum(rough, names[:12])
    alone = precision_in_datum(adjust_block(BLOCK, AdjustmentOptions()), names[:12])
    r = rough.precision.roughness
    np.testing.assert_allclose(again.object_points - alone.object_points, r[:, :, None] * r[:, None, :], rtol=1e-5)


def test_a_block_folder_keeps_the_figures_and_may_lack_them(tmp_path):
    block = with_windows(3.5, 1.25)
    number = np.arange(len(block.points))
    misfit, bent = (
        np.where(number == 2, np.nan, block.points.misfit),
        np.where(number == 4, np.nan, 0.001 * (number + 1)),
    )
    points = replace(block.points, misfit=misfit, sigma_curvature=bent)
    write_block(replace(block, points=points), tmp_path / "rough")
    back = read_block(tmp_path / "rough").points
    for name in ("window", "misfit", "relief", "sigma_curvature"):
        np.testing.assert_array_equal(getattr(back, name), getattr(points, name))
    write_block(BLOCK, tmp_path / "plain")
    assert read_block(tmp_path / "plain").points.misfit is None
    head = (tmp_path / "plain" / "points.csv").read_text().splitlines()[0]
    assert head == "point,role,X,Y,Z,sX,sY,sZ"


def test_a_window_that_is_larger_than_the_object_is_refused(tmp_path):
    block = with_windows(3.5, 1.25)
    window = block.points.window.copy()
    window[4] = 1e9
    write_block(replace(block, points=replace(block.points, window=window)), tmp_path / "rough")
    extent = pytest.approx(np.linalg.norm(np.ptp(block.points.xyz, axis=0)))
    at = {"file": "points.csv", "line": 6, "column": "window"}
    with refused("point.window_too_large", **at, window=1e9, extent=extent):
        read_block(tmp_path / "rough")
