"""Points that lost all their rays come back where most of these meet."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.blunders.reintersection import directions, reintersected
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.predict import image_points
from raybundle.block.rejection import Rejection, RejectionKind
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene


@pytest.fixture(scope="module")
def made():
    """An adjusted block in which a point has seven rays or more, and the truth."""
    scene = field_scene(TargetField(stations=8, frontal=0, camera=brown_camera(estimate=())))
    made = simulate(scene, Survey(orientation="exact", points="exact", interior="exact", control=4))
    return adjust_block(made.observed, AdjustmentOptions(jobs=1)), made.truth


def tied(result):
    block = result.given
    free = ~block.points.is_control.any(axis=1) & (block.ray_count >= 7)
    return int(np.flatnonzero(free)[3])


def spoilt(result, rows, px):
    """The result with some image points moved in the image."""
    o = result.given.observations
    xy = o.xy_px.copy()
    xy[rows] += px
    return replace(result, given=replace(result.given, observations=replace(o, xy_px=xy)))


def with_reasons(result, kinds):
    reasons = [None] * len(result.given.observations)
    for row, kind in kinds.items():
        reasons[row] = Rejection(kind=kind)
    return replace(result, image_observations=replace(result.image_observations, rejected=tuple(reasons)))


def brought_back(result, skip=()):
    """By the adjusted block, with the image points of the result."""
    block = replace(result.adjusted, observations=result.given.observations)
    return reintersected(result, block, set(skip))


def test_rays_lead_from_the_centres_to_the_points(made):
    _, truth = made
    rows = np.arange(0, len(truth.observations), 3)
    o = truth.observations
    along = truth.points.xyz[o.point[rows]] - truth.images.centre[o.image[rows]]
    along /= np.linalg.norm(along, axis=1)[:, None]
    np.testing.assert_allclose(directions(truth, rows), along, atol=1e-8)


@pytest.mark.parametrize("kind", [RejectionKind.BEHIND_CAMERA, RejectionKind.RAYS_DIVERGE])
def test_a_point_comes_back_without_its_blunders(made, kind):
    result, truth = made
    p = tied(result)
    rows = np.flatnonzero(result.given.observations.point == p)
    bad = rows[[1, 4]]
    found = brought_back(with_reasons(spoilt(result, bad, [[60.0, 20.0], [-15.0, 80.0]]), dict.fromkeys(rows, kind)))
    assert found is not None
    block, reasons, which = found
    assert which == {p}
    np.testing.assert_allclose(block.points.xyz[p], truth.points.xyz[p], atol=1e-3)
    others = np.arange(len(block.points)) != p
    np.testing.assert_array_equal(block.points.xyz[others], result.adjusted.points.xyz[others])
    assert {k for k, r in enumerate(reasons) if r is not None} == set(bad.tolist())
    for row, axis, px in zip(bad, "xy", (60.0, 80.0), strict=True):
        assert (reasons[row].kind, reasons[row].axis) == (RejectionKind.BLUNDER, axis)
        sigma = np.sqrt(result.given.observations.cov_px2[row, 0])
        # a ray alone beside a place that the others give
        assert reasons[row].tau == pytest.approx(px / sigma / max(result.sigma0, 1.0), rel=0.1)
        assert reasons[row].limit == result.critical_tau


def test_where_no_majority_meets_nothing_comes_back(made):
    result, _ = made
    p = tied(result)
    rows = np.flatnonzero(result.given.observations.point == p)
    rng = np.random.default_rng(5)
    half = rows[: len(rows) - len(rows) // 2]
    noisy = spoilt(result, half, rng.uniform(50, 200, (len(half), 2)) * rng.choice([-1, 1], (len(half), 2)))
    assert brought_back(with_reasons(noisy, dict.fromkeys(rows, RejectionKind.BEHIND_CAMERA))) is None


def test_known_wrong_rays_control_and_points_to_be_skipped_stay_out(made):
    result, _ = made
    p = tied(result)
    rows = np.flatnonzero(result.given.observations.point == p)
    lost = dict.fromkeys(rows.tolist(), RejectionKind.BEHIND_CAMERA)
    given = {**lost, int(rows[0]): RejectionKind.GIVEN}
    found = brought_back(with_reasons(result, given))
    assert found is not None
    assert [k for k, r in enumerate(found[1]) if r is not None] == [int(rows[0])]
    assert brought_back(with_reasons(result, lost), skip=[p]) is None
    control = int(np.flatnonzero(result.given.points.is_control.all(axis=1))[0])
    seen = np.flatnonzero(result.given.observations.point == control).tolist()
    assert brought_back(with_reasons(result, dict.fromkeys(seen, RejectionKind.BEHIND_CAMERA))) is None


def test_few_rays_that_agree_on_a_wrong_place_give_way_to_the_many_that_were_rejected(made):
    result, truth = made
    p = tied(result)
    o = result.given.observations
    rows = np.flatnonzero(o.point == p)
    wrong = rows[:2]
    kinds = dict.fromkeys(rows[2:].tolist(), RejectionKind.BLUNDER)
    other = int(np.flatnonzero(np.bincount(o.point[np.isin(o.image, o.image[wrong])], minlength=p + 9) > 1)[-1])
    exchanged = [int(np.flatnonzero((o.point == other) & (o.image == o.image[k]))[0]) for k in wrong]
    moved = spoilt(result, wrong, o.xy_px[exchanged] - o.xy_px[wrong])
    found = brought_back(with_reasons(moved, kinds))
    assert found is not None
    block, reasons, which = found
    assert which == {p}
    np.testing.assert_allclose(block.points.xyz[p], truth.points.xyz[p], atol=1e-3)
    assert {k for k, r in enumerate(reasons) if r is not None} == set(wrong.tolist())


@pytest.mark.parametrize(("aside", "located"), [(0.05, False), (0.0, True)])
def test_where_either_of_two_rays_may_be_wrong_the_point_stays_out(made, aside, located):
    """Two photographs from one place say nothing of the depth, at which the other two contradict each other."""
    result, truth = made
    p = tied(result)
    o, images = truth.observations, truth.images
    rows = np.flatnonzero(o.point == p)
    a, b, _, d = rows[:4]
    centre, rotation = images.centre.copy(), images.rotation.copy()
    centre[o.image[b]], rotation[o.image[b]] = centre[o.image[a]] + 1e-5, rotation[o.image[a]]
    beyond = truth.points.xyz[p] + aside * (truth.points.xyz[p] - centre[o.image[a]])
    xy = o.xy_px.copy()
    for row, place in ((b, truth.points.xyz[p]), (d, beyond)):
        i = o.image[row]
        xy[row] = image_points(truth.camera_of(i), rotation[i], centre[i], place[None])[0]
    block = replace(truth, images=replace(images, centre=centre, rotation=rotation), observations=replace(o, xy_px=xy))
    kinds = dict.fromkeys(rows[:4].tolist(), RejectionKind.BEHIND_CAMERA)
    kinds |= dict.fromkeys(rows[4:].tolist(), RejectionKind.GIVEN)
    found = reintersected(replace(with_reasons(result, kinds), given=block, adjusted=block), block, set())
    assert (found is not None) is located
    assert found is None or np.allclose(found[0].points.xyz[p], truth.points.xyz[p], atol=1e-3)
