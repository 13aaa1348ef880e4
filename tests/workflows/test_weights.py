"""Weights of measured image points, from the residuals of simulated blocks; blocks of tracks and their start."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.block import Role
from raybundle.block.select import with_rows
from raybundle.errors import NoOrientation, phrase
from raybundle.matching.refine import TrackPoints
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene
from raybundle.ties import precise
from raybundle.ties.block import flat_points, image_sigma_px
from raybundle.ties.match_weights import FEWEST, Weights, estimate_weights
from raybundle.ties.precise import candidates
from raybundle.ties.start import start
from tests.messages import refused

OPTIONS = AdjustmentOptions(jobs=1)
CAMERA = brown_camera(estimate=("c", "K1"))
EXACT = Survey(orientation="exact", points="exact", interior="exact", image_sigma_px=1e-6)


def field(rows=10, columns=14, stations=16):
    plan = TargetField(camera=CAMERA, rows=rows, columns=columns, stations=stations, frontal=2)
    return simulate(field_scene(plan), EXACT).truth


def measured(truth, weights, seed, share=(1.0, 0.0, 0.0, 0.0)):
    """The block with errors of these variances; the covariances that the grey values promise; levels; references."""
    rng = np.random.default_rng(seed)
    m = len(truth.observations)
    level = rng.choice(4, m, p=share)
    grey = np.zeros((m, 3))
    grey[:, :2] = (0.02 * 2.0 ** level[:, None]) ** 2 * rng.lognormal(0, 1.0, m)[:, None]
    _, first = np.unique(truth.observations.point, return_index=True)
    reference = np.zeros(m, bool)
    reference[first] = True
    cov = weights.covariance(grey, level, reference)
    error = rng.normal(0, 1, (m, 2)) * np.sqrt(cov[:, :2])
    o = truth.observations
    return replace(truth, observations=replace(o, xy_px=o.xy_px + error)), grey, level, reference


def settled(block, grey, level, reference, rounds=4):
    weights = Weights()
    for _ in range(rounds):
        o = replace(block.observations, cov_px2=weights.covariance(grey, level, reference))
        result = adjust_block(replace(block, observations=o), OPTIONS)
        weights = estimate_weights(result, grey, level, reference, weights)
    return weights, result


@pytest.mark.parametrize(
    "true",
    [
        Weights(factors=(9.0, 9, 9, 9), floors_px2=(0.03**2,) * 4, reference_px2=0.1**2),
        Weights(factors=(2.0, 2, 2, 2), floors_px2=(0.08**2,) * 4, reference_px2=0.05**2),
        Weights(factors=(30.0, 3, 3, 3), floors_px2=(0.01**2,) * 4, reference_px2=0.2**2),
    ],
)
def test_weights_are_found_again(true):
    block, grey, level, reference = measured(field(), true, 1)
    found, result = settled(block, grey, level, reference)
    variance = true.factors[0] * grey[~reference, 0] + true.floors_px2[0]
    stated = found.factors[0] * grey[~reference, 0] + found.floors_px2[0]
    middle = np.quantile(grey[~reference, 0], [0.1, 0.9])
    inside = (grey[~reference, 0] > middle[0]) & (grey[~reference, 0] < middle[1])
    assert np.median((stated / variance)[inside]) == pytest.approx(1.0, abs=0.15)
    assert np.abs(np.log(stated / variance)[inside]).max() < 0.4
    assert found.reference_px2 == pytest.approx(true.reference_px2, rel=0.3)
    assert result.sigma0 == pytest.approx(1.0, abs=0.05)


def test_every_level_has_its_own_line():
    true = Weights(factors=(1.0, 3.0, 1.5, 1.0), floors_px2=(0.01**2, 0.05**2, 0.2**2, 0.5**2), reference_px2=0.05**2)
    block, grey, level, reference = measured(field(14, 18, 20), true, 5, (0.4, 0.3, 0.25, 0.05))
    assert all((level[~reference] == k).sum() > 10 * FEWEST for k in range(4))
    found, result = settled(block, grey, level, reference)
    stated, variance = (w.covariance(grey, level, reference)[~reference, 0] for w in (found, true))
    for k in range(4):
        assert np.median((stated / variance)[level[~reference] == k]) == pytest.approx(1.0, abs=0.25)
    assert result.sigma0 == pytest.approx(1.0, abs=0.05)


def test_a_level_with_few_points_keeps_its_ratio_to_the_finer_one():
    true = Weights(factors=(8.0, 8, 8, 8), floors_px2=(0.05**2,) * 4)
    block, grey, level, reference = measured(field(), true, 6)
    found, _ = settled(block, grey, level, reference, rounds=1)
    start = Weights()
    assert found.factors[2] / found.factors[0] == pytest.approx(start.factors[2] / start.factors[0])
    assert found.floors_px2[3] / found.floors_px2[0] == pytest.approx(start.floors_px2[3] / start.floors_px2[0])


def test_weights_are_stored_and_read_again():
    w = Weights(factors=(1.0, 2, 3, 4), floors_px2=(5.0, 6, 7, 8), reference_px2=9.0, feature_px2=10.0)
    assert Weights.of(w.array()) == w


def test_with_true_weights_sigma0_is_one_and_ten_percent_would_show():
    true = Weights(factors=(4.0,) * 4, floors_px2=(0.02**2,) * 4, reference_px2=0.06**2)
    block, grey, level, reference = measured(field(), true, 2)
    for wrong, good in ((1.0, True), (1.1, False), (1 / 1.1, False)):
        cov = true.covariance(grey, level, reference) * wrong**2
        result = adjust_block(replace(block, observations=replace(block.observations, cov_px2=cov)), OPTIONS)
        limit = 4 / np.sqrt(2 * result.redundancy)  # four standard deviations of sigma0
        assert (abs(result.sigma0 - 1) < limit) == good


def test_the_mean_sigma_of_an_image_point_is_that_of_the_errors():
    true = Weights(factors=(4.0,) * 4, floors_px2=(0.02**2,) * 4, reference_px2=0.06**2)
    block, grey, level, reference = measured(field(), true, 3)
    cov = true.covariance(grey, level, reference)
    for units in (1.0, 5.0):
        result = adjust_block(replace(block, observations=replace(block.observations, cov_px2=cov * units**2)), OPTIONS)
        assert image_sigma_px(result) == pytest.approx(np.sqrt(cov[:, :2].mean()), rel=0.05)


def test_too_few_points_leave_the_weights_as_they_were():
    block, grey, level, reference = measured(field(rows=3, columns=4, stations=4), Weights(), 4)
    before = Weights(factors=(3.3, 3, 3, 3), floors_px2=(0.4, 0.5, 0.6, 0.7), reference_px2=0.5)
    assert estimate_weights(adjust_block(block, OPTIONS), grey, level, reference, before) == before


def test_covariances_of_weights():
    grey = np.array([[1.0, 2.0, 0.5], [1.0, 2.0, 0.5], [1.0, 1.0, 0.0]])
    weights = Weights(factors=(2.0, 3.0, 1.0, 1.0), floors_px2=(0.25, 0.5, 1.0, 1.0), reference_px2=4.0)
    cov = weights.covariance(grey, np.array([0, 0, 1]), np.array([False, True, False]))
    np.testing.assert_allclose(cov, [[2.25, 4.25, 1.0], [4.0, 4.0, 0.0], [3.5, 3.5, 0.0]])


def test_points_with_parallel_rays_are_flat():
    truth = field(rows=4, columns=5, stations=4)
    assert not flat_points(truth).any()
    xyz = truth.points.xyz.copy()
    xyz[3] = np.nan
    one_ray = truth.observations.point != 5
    one_ray[np.flatnonzero(~one_ray)[0]] = True
    block = with_rows(replace(truth, points=replace(truth.points, xyz=xyz)), one_ray)
    assert np.flatnonzero(flat_points(block)).tolist() == [3, 5]


def test_points_seen_from_one_place_are_flat():
    scene = field_scene(TargetField(camera=CAMERA, stations=0, frontal=4))
    shake = 1e-3 * np.random.default_rng(1).normal(size=(4, 3))
    one_place = replace(scene, centre=scene.centre[0] + shake, rotation=np.repeat(scene.rotation[:1], 4, axis=0))
    assert flat_points(simulate(one_place, EXACT).truth).all()


def test_tie_points_are_looked_for_where_they_are(monkeypatch):
    monkeypatch.setattr(precise, "SURROUNDINGS", 0.2)  # targets stand farther apart than features do
    truth = field(rows=12, columns=14, stations=4)
    hidden = np.random.default_rng(1).random(len(truth.observations)) < 0.15
    block = with_rows(truth, ~hidden)
    o = block.observations
    ones = np.ones(len(o))
    points = TrackPoints(image=o.image, point=o.point, xy_px=o.xy_px, scale_px=ones, angle=0 * ones)
    _, first = np.unique(o.point, return_index=True)
    found = candidates(block, points, first)
    seen = set(zip(o.image.tolist(), o.point.tolist(), strict=True))
    ids = [block.points.ids[k] for k in found.point]
    places = {}
    for i, p, xy in zip(truth.observations.image, truth.observations.point, truth.observations.xy_px, strict=True):
        places[int(i), truth.points.ids[p]] = xy
    assert len(found.image) > 0.4 * hidden.sum()
    assert not seen & set(zip(found.image.tolist(), found.point.tolist(), strict=True))
    known = [
        (k, places[i, p]) for k, (i, p) in enumerate(zip(found.image.tolist(), ids, strict=True)) if (i, p) in places
    ]
    assert len(known) > 0.95 * len(found.image)
    rows = [k for k, _ in known]
    assert np.abs(found.xy_px[rows] - np.array([xy for _, xy in known])).max() < 0.1
    assert (o.point[found.reference] == found.point).all()


def raw_block(seed=3, **survey):
    """Tracks as matching gives them: nothing known but the image points and a rough camera."""
    plan = TargetField(camera=brown_camera(estimate=("c", "K1")), rows=10, columns=12, stations=8, frontal=2)
    s = simulate(field_scene(plan), Survey(seed=seed, orientation="absent", image_sigma_px=0.5, **survey))
    return replace(s.observed, cameras=(replace(s.observed.cameras[0], estimate="auto"),)), s


def started(block):
    ones = np.ones(len(block.observations))
    return start(block, ones, 0 * ones, 1)


def test_the_start_finds_every_image_and_leaves_wrong_rays_out():
    raw, s = raw_block(gross_share=0.03, gross_px=80.0)
    tie = started(raw)
    assert tie.not_oriented == ()
    assert tie.block.images.oriented.all()
    assert tie.block.cameras[0].estimate == "auto"
    assert len(tie.scale_px) == len(tie.angle) == len(tie.block.observations)
    assert len(tie.block.observations) == pytest.approx((~s.gross).sum(), rel=0.03)
    assert (tie.block.points.role == Role.TIE).all()


def test_an_image_with_few_common_points_is_named_and_the_others_are_oriented():
    raw, _ = raw_block()
    o = raw.observations
    rows = np.flatnonzero(o.image == 4)
    keep = np.ones(len(o), bool)
    keep[rows[5:]] = False
    tie = started(with_rows(raw, keep))
    ((name, reason),) = tie.not_oriented
    assert name == raw.images.ids[4]
    assert reason == phrase("not_oriented.few_common", n=5, least=12)
    assert not (tie.block.observations.image == 4).any()


def test_the_smaller_part_of_a_set_in_two_parts_is_named():
    raw, _ = raw_block()
    o = raw.observations
    left = o.image < 6
    point = np.where(left, o.point, o.point + len(raw.points))
    double = replace(
        raw,
        observations=replace(o, point=point.astype(np.int32)),
        points=replace(
            raw.points, ids=(*raw.points.ids, *(f"{name}b" for name in raw.points.ids)),
            role=np.tile(raw.points.role, 2), xyz=np.tile(raw.points.xyz, (2, 1)),
            sigma=np.tile(raw.points.sigma, (2, 1)),
        ),
    )  # fmt: skip
    tie = started(double)
    assert [name for name, _ in tie.not_oriented] == list(raw.images.ids[6:])
    assert {r for _, r in tie.not_oriented} == {phrase("not_oriented.separate_part", n=4, largest=6)}


def test_nothing_in_common_says_how_to_photograph():
    raw, _ = raw_block()
    with refused("tie_points.too_few_common", NoOrientation):
        started(with_rows(raw, raw.observations.image == 2))
