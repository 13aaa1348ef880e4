"""Relief within the windows of matching: what it adds to variances of tie points, and where."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.queries import covariance_between, precision_in_datum
from raybundle.adjustment.roughness import doubled
from raybundle.adjustment.severity import Severity
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.planning.scenes import TargetField, field_scene
from raybundle.planning.simulate import Survey, simulate

BLOCK = simulate(
    field_scene(TargetField(rows=5, columns=8, stations=5, frontal=1)),
    Survey(points="exact", orientation="exact", interior="exact"),
).observed


def with_windows(misfit, relief):
    n = len(BLOCK.points)
    figures = {"window": np.full(n, 0.01), "misfit": np.full(n, misfit), "relief": np.full(n, relief)}
    return replace(BLOCK, points=replace(BLOCK.points, **figures))


@pytest.fixture(scope="module")
def plain():
    return adjust_block(BLOCK, AdjustmentOptions())


@pytest.fixture(scope="module")
def rough():
    return adjust_block(with_windows(6.0, 2.0), AdjustmentOptions())


def test_the_variance_by_hand(plain):
    larger = with_windows(6.0, 2.0)
    window = larger.points.window.copy()
    window[7] *= 2.5
    rough = adjust_block(replace(larger, points=replace(larger.points, window=window)), AdjustmentOptions())
    o, s = BLOCK.observations, plain.image_observations
    k = 7
    mine = o.point == k
    ray = plain.adjusted.images.centre[o.image[mine]] - plain.adjusted.points.xyz[k]
    d = (ray / np.linalg.norm(ray, axis=1, keepdims=True)).sum(axis=0)
    d /= np.linalg.norm(d)
    square = (s.residuals_px[mine] ** 2 / o.cov_px2[mine, :2]).sum() / plain.sigma0**2
    T = (square + 1) / (s.redundancy[mine].sum() + 1)
    C = plain.precision.object_points[k]
    variance = d @ C @ d * 1.45 * (6 - 1) ** 1.55 * (1 - 1 / 2) ** 1.3 * T**0.9 * 2.5
    np.testing.assert_allclose(rough.precision.roughness[k], np.sqrt(variance) * d, rtol=1e-9)
    np.testing.assert_allclose(rough.precision.object_points[k], C + variance * np.outer(d, d), rtol=1e-9)


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
    assert wider.max() < 1.01
    assert doubled(calm.precision) == (0, 40)


def test_relief_is_no_higher_than_its_window():
    block = with_windows(1e3, 4.0)
    low = replace(block, points=replace(block.points, window=np.full(len(block.points), 1e-6)))
    result = adjust_block(low, AdjustmentOptions())
    assert np.linalg.norm(result.precision.roughness, axis=1).max() == pytest.approx(2e-6)


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
    C = covariance_between(rough, f"point:{names[3]}", f"point:{names[3]}")
    np.testing.assert_allclose(C, rough.precision.object_points[3], rtol=1e-6)
    apart = covariance_between(rough, f"point:{names[3]}", f"point:{names[4]}")
    assert np.abs(apart).max() < np.abs(C).max() / 3
    again = precision_in_datum(rough, names[:12])
    alone = precision_in_datum(adjust_block(BLOCK, AdjustmentOptions()), names[:12])
    r = rough.precision.roughness
    np.testing.assert_allclose(again.object_points - alone.object_points, r[:, :, None] * r[:, None, :], rtol=1e-5)


def test_a_block_folder_keeps_the_figures_and_may_lack_them(tmp_path):
    block = with_windows(3.5, 1.25)
    points = replace(block.points, misfit=np.where(np.arange(len(block.points)) == 2, np.nan, block.points.misfit))
    write_block(replace(block, points=points), tmp_path / "rough")
    back = read_block(tmp_path / "rough").points
    for name in ("window", "misfit", "relief"):
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
    with pytest.raises(InputError) as found:
        read_block(tmp_path / "rough")
    extent = np.linalg.norm(np.ptp(block.points.xyz, axis=0))
    for words in ("points.csv", "line 6", "column window", "1e+09", f"{extent:.6g}"):
        assert words in str(found.value)
