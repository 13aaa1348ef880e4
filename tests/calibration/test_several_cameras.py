"""Photographs of several cameras that were taken for one are named; those of one camera are not."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.evaluation.image_interiors import groups_of, own_interiors
from raybundle.adjustment.records.severity import Severity
from raybundle.calibration.several_cameras import several_cameras
from tests.adjustment.mixed_cameras import adjusted, mixed

TWO = [{}, {"c": 0.2, "x0": 0.1}]
"""1 % of c; 25 px of x0"""


@pytest.mark.parametrize("seed", range(3))
def test_images_of_two_cameras_are_taken_apart(seed):
    block, of = mixed(TWO, seed)
    found = several_cameras(adjusted(block))
    apart = found.applied(block)
    pairs = set(zip(apart.images.camera.tolist(), of.tolist(), strict=True))
    assert len(apart.cameras) == 2
    assert len(pairs) == 2
    (notice,) = found.notices
    assert (notice.code, notice.severity, notice.ids) == ("several_cameras", Severity.FAULT, ("1", "1-2"))
    smaller = min((0, 1), key=lambda k: (of == k).sum())
    names = [n for n, k in zip(block.images.ids, of, strict=True) if k == smaller]
    if (of == smaller).sum() < len(of) / 2:
        assert [d.values["pattern"] for d in notice.details] == ["|".join(names)]
    after = adjusted(apart)
    c = [i.parameters["c"] for i in sorted(after.interior, key=lambda i: of[apart.images.camera.tolist().index(
        [k.id for k in apart.cameras].index(i.camera))])]  # fmt: skip
    assert c[1].value - c[0].value == pytest.approx(0.2, abs=4 * np.hypot(c[0].std, c[1].std))
    assert several_cameras(after) is None


def test_images_of_three_cameras_are_taken_apart():
    block, of = mixed([{}, {"c": 0.3}, {"c": -0.2, "y0": 0.15}], 5, images=15)
    apart = several_cameras(adjusted(block)).applied(block)
    assert len(apart.cameras) == 3
    assert len(set(zip(apart.images.camera.tolist(), of.tolist(), strict=True))) == 3


@pytest.mark.parametrize("runs", [6, pytest.param(60, marks=pytest.mark.long)])
@pytest.mark.parametrize("focus", [0.0, 2e-3])
def test_images_of_one_camera_stay_together(runs, focus):
    """Smooth errors of 0.3 px, and a focus that wanders by 6 px at half the format: no groups."""
    assert not any(several_cameras(adjusted(mixed([{}], seed, focus=focus)[0])) for seed in range(runs))


def test_what_a_single_image_asks_for_is_what_it_has():
    block, of = mixed(TWO, 1)
    (own,) = own_interiors(adjusted(block))
    d = own.difference_px - own.difference_px.mean(axis=0)
    c = np.array([d[of == k, 0].mean() for k in (0, 1)])
    assert c[1] - c[0] == pytest.approx(0.2 / 20.4 * 3000, rel=0.6)
    groups = groups_of(own)
    assert sorted(map(len, groups.images)) == sorted(np.bincount(of).tolist())
    assert groups.probability < 0.01


def test_what_images_ask_for_does_not_depend_on_the_stated_precision():
    block, _ = mixed(TWO, 1)
    o = block.observations
    (own,), (other,) = (
        own_interiors(adjusted(replace(block, observations=replace(o, cov_px2=o.cov_px2 * f)))) for f in (1.0, 9.0)
    )
    np.testing.assert_allclose(other.difference_px, own.difference_px, rtol=1e-3, atol=1e-4)
    np.testing.assert_allclose(other.covariance, own.covariance, rtol=1e-2, atol=1e-3 * np.abs(own.covariance).max())
