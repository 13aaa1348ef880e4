"""The verdict on a calibration: what the network determines decides, not how small the residuals are."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Observations
from raybundle.block.select import with_rows
from raybundle.calibration.cross_validation import cross_validation
from raybundle.calibration.maps import calibration_difference
from raybundle.calibration.one_camera import find_splits, own_interiors
from raybundle.calibration.quality import calibration_qualities
from raybundle.planning.next.calibration import advised, next_photographs
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene

ROLLS = (0.0, 90.0, 180.0, 270.0)


def calibrated(*, seed=1, camera=None, **plan):
    scene = field_scene(TargetField(**plan))
    survey = Survey(seed=seed, image_sigma_px=0.05, points="exact", orientation="exact", interior="exact")
    block = simulate(scene, survey).observed
    cameras = (replace(block.cameras[0], estimate="auto"),)
    return decide(replace(block, cameras=cameras), AdjustmentOptions(reject="snooping"))


def codes(quality):
    """What speaks against a calibration, by the codes of its reasons."""
    return {m.code.removeprefix("calibration_quality.") for r in quality.reasons for m in r.messages}


@pytest.fixture(scope="module")
def good():
    return calibrated()


@pytest.fixture(scope="module")
def narrow():
    return calibrated(roll_deg=(0.0,), tilt_deg=10.0, depth=0.0)


def test_a_good_network_is_called_good(good):
    (q,) = calibration_qualities(good)
    assert q.grade == "good"
    head, figures = q.headline.messages
    assert (head.code, figures.values["largest_px"]) == ("calibration_quality.head_good", q.uncertainty_px)
    assert q.image_sigma_px == pytest.approx(0.05, rel=0.05)
    assert q.uncertainty_px < q.image_sigma_px
    assert q.rolls == 4
    assert q.reach > 0.9
    assert q.validation.ratio == pytest.approx(1.05, abs=0.08)


@pytest.mark.parametrize("reach", [0.7, 0.78, 0.84])
def test_points_that_do_not_reach_the_corners_make_it_good_as_far_as_they_reach(reach):
    field = field_scene(TargetField())
    survey = Survey(seed=3, image_sigma_px=0.03, points="exact", orientation="exact", interior="exact")
    done = simulate(field, survey)
    camera = done.observed.cameras[0]
    size = np.array([camera.width_px, camera.height_px])
    radius = np.linalg.norm(done.observed.observations.xy_px - size / 2, axis=1) / np.linalg.norm(size / 2)
    block = with_rows(replace(done.observed, cameras=(replace(camera, estimate="auto"),)), radius < reach)
    result = decide(block, AdjustmentOptions(reject="snooping"))
    (q,) = calibration_qualities(result)
    assert q.grade == "usable"
    assert q.reach == pytest.approx(reach, abs=0.02)
    assert q.inside_px < min(q.worst_px, 0.1)
    assert q.headline.messages[0].values == {"reach": q.reach, "inside_px": q.inside_px}
    true = calibration_difference(done.truth.cameras[0], result.adjusted.cameras[0])
    near = np.linalg.norm(true.xy_px - size / 2, axis=2) < q.reach * np.linalg.norm(size / 2)
    assert np.linalg.norm(true.shift_px, axis=2)[near].max() < q.inside_px


def test_a_narrow_network_is_not_and_what_helps_is_named_first(narrow):
    q = advised(calibration_qualities(narrow)[0], narrow)
    assert q.grade in {"usable", "weak"}
    assert {"no_convergence", "not_rolled"} <= codes(q)
    assert any(
        (m.code, m.values.get("angle_deg")) == ("next_photograph.roll", 90) for p in q.advice for m in p.words.messages
    )
    assert q.advice[-1].ratio < 0.35
    assert [p.ratio for p in q.advice] == sorted((p.ratio for p in q.advice), reverse=True)


def test_the_predicted_effect_is_what_such_photographs_bring(narrow):
    """The proposals for the narrow network against a network that is rolled and converges."""
    last = next_photographs(narrow, "1")[-1]
    better = calibrated(roll_deg=ROLLS, tilt_deg=40.0, depth=0.0)
    (q,) = calibration_qualities(better)
    assert last.uncertainty_px == pytest.approx(q.uncertainty_px, rel=0.6)


def test_what_is_not_determinable_stands_before_any_number():
    a = calibrated(stations=4, frontal=0, roll_deg=(0.0,), depth=0.0, tilt_deg=0.02)
    q = advised(calibration_qualities(a)[0], a)
    assert q.grade in {"not determinable", "weak"}
    assert a.not_determinable or q.uncertainty_px > 3 * q.image_sigma_px
    assert q.advice


def test_cross_validation_of_few_photographs_is_not_tried():
    assert cross_validation(calibrated(stations=3, frontal=0), "1") is None


def scaled(good, factor):
    """The same photographs, the image of each magnified by a factor of its own (n,)."""
    o = good.given.observations
    middle = np.array([3000.0, 2000.0])
    moved = replace(o, xy_px=middle + (o.xy_px - middle) * factor[o.image, None])
    block = replace(good.adjusted, observations=moved, cameras=(replace(good.given.cameras[0], estimate="auto"),))
    return decide(block, AdjustmentOptions())


def test_cross_validation_notices_what_does_not_carry_over(good):
    """Photographs with a camera constant of their own fit when they take part and not when they are left out."""
    n = len(good.given.images)
    two = np.where(np.isin(np.arange(n), [3, 8]), 1.002, 1.0)
    found = cross_validation(scaled(good, two), "1")
    assert found.contradicts
    assert found.excess > 3
    every = 1 + 4e-4 * np.random.default_rng(3).standard_normal(n)
    unsteady = scaled(good, every)
    assert cross_validation(unsteady, "1").contradicts
    (q,) = calibration_qualities(unsteady)
    assert q.grade == "weak"
    assert "contradicted" in codes(q)


def test_the_prediction_of_photographs_left_out_is_true(good):
    """The statistic has Fisher's distribution: 60 folds of one and the same camera, and a test that is not blind."""
    found = [cross_validation(good if s == 1 else calibrated(seed=s, stations=8), "1") for s in range(1, 13)]
    statistic = np.concatenate([f.statistic for f in found])
    assert 0.95 < statistic.mean() < 1.05
    assert not any(f.contradicts for f in found)
    assert statistic.max() < 1.2 * np.median(np.concatenate([f.limit for f in found]))


def test_few_views_are_not_called_another_camera():
    """Four photographs: those left out fit much worse, and as predicted."""
    few = calibrated(stations=3, frontal=1, roll_deg=(0.0, 90.0), depth=0.1, tilt_deg=25.0)
    found = cross_validation(few, "1")
    assert found.ratio > 1.3
    assert found.few_views
    (q,) = calibration_qualities(few)
    assert "few_views" in codes(q)
    assert "contradicted" not in codes(q)


def test_own_interiors_scatter_as_they_should(good):
    images, shift, spread = own_interiors(good, "1")
    assert len(images) == len(good.given.images)
    size = np.einsum("ni,nij,nj->n", shift, np.linalg.inv(spread), shift) / 3
    assert 0.3 < size.mean() < 1.5
    assert find_splits(good, "1") == ()


@pytest.mark.parametrize("how", ["names", "order", "values"])
def test_two_cameras_are_found(good, how):
    n = len(good.given.images)
    side = {"names": np.arange(n) % 2 == 0, "order": np.arange(n) < 8}.get(how, np.arange(n) % 3 == 0)
    ids = tuple(
        f"{'left' if how == 'names' and s else 'p' if how != 'names' else 'right'}_{k}" for k, s in enumerate(side)
    )
    if how != "names":
        ids = tuple(f"{k}" for k in range(n))
    o: Observations = good.given.observations
    shift = np.where(side[o.image, None], 0.0, np.array([3.0, -2.0]))
    block = replace(
        good.adjusted,
        images=replace(good.adjusted.images, ids=ids),
        observations=replace(o, xy_px=o.xy_px + shift),
        cameras=(replace(good.given.cameras[0], estimate="auto"),),
    )
    mixed = decide(block, AdjustmentOptions())
    splits = find_splits(mixed, "1")
    exact = [s for s in splits if set(s.groups[0].tolist()) in ({*np.flatnonzero(side)}, {*np.flatnonzero(~side)})]
    assert exact
    assert np.abs(exact[0].difference[1:]) == pytest.approx([3.0, 2.0], abs=1.5)
    assert any(s.sought for s in splits) or how != "values"
