"""Predicted places and intersections: their covariance is that of all unknowns together, and it is true."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.predict import predicted_px
from raybundle.block.select import with_rows
from raybundle.errors import code_of
from raybundle.measuring.actions.verbs import Put
from raybundle.measuring.position import locate
from raybundle.measuring.predict import affine, predict, visible, worst
from raybundle.measuring.session import Session
from raybundle.measuring.state import EMPTY, folded
from raybundle.measuring.views import seen_in
from raybundle.workflows.adjust import adjust

from .scenes import simulation, small_block

SIGMA = 0.3


@pytest.fixture(scope="module")
def session():
    return Session.of(adjust(small_block()))


def without_point(block, p):
    """The block without a point, and its rows."""
    o = block.observations
    mine = np.asarray(o.point) == p
    kept = with_rows(block, ~mine)
    return kept, [(block.images.ids[i], xy) for i, xy in zip(o.image[mine], o.xy_px[mine], strict=True)]


def many_rays(block, least=4):
    return [int(p) for p in np.flatnonzero((block.ray_count >= least) & (np.asarray(block.points.role) == 0))]


def marks(name, rows):
    put = [Put(image=i, point=name, x_px=x, y_px=y, covariance=(SIGMA**2, SIGMA**2, 0.0)) for i, (x, y) in rows]
    return folded(put)


@pytest.mark.parametrize("datum", ["auto", "inner"])
def test_joint_covariances_are_those_of_the_adjustment(datum):
    block = small_block()
    if datum == "inner":
        points = replace(
            block.points, role=np.zeros_like(block.points.role), sigma=np.full_like(block.points.sigma, np.nan)
        )
        block = replace(block, points=points)
    session = Session.of(adjust(block, AdjustmentOptions()))
    a, p = session.adjustment, many_rays(block)[:2]
    names = [block.points.ids[k] for k in p]
    C = session.joint.of_points(p)
    np.testing.assert_allclose(C[:3, 3:], a.covariance(f"point:{names[0]}", f"point:{names[1]}"), rtol=1e-6, atol=1e-14)
    np.testing.assert_allclose(C[:3, :3], a.precision.object_points[p[0]], rtol=1e-6, atol=1e-14)
    nodes, own = session.joint.point_columns(p[0])
    np.testing.assert_allclose(own, C[:3, :3], rtol=1e-9)
    unknown = session.joint.of_image(1)
    across = a.covariance(f"point:{names[0]}", "image:" + block.images.ids[1])
    np.testing.assert_allclose(nodes[unknown.unknowns[:3]].T, across[:, :3], rtol=1e-6, atol=1e-14)
    own_image = session.joint.between_images(1, 1)
    np.testing.assert_allclose(own_image, own_image.T, rtol=1e-6, atol=1e-16)
    np.testing.assert_allclose(own_image[:3, :3], a.precision.images[1][:3, :3], rtol=1e-6, atol=1e-14)


def test_an_adjusted_point_is_predicted_where_the_adjustment_puts_it(session):
    b = session.block
    p = many_rays(b)[0]
    i = int(b.observations.image[np.asarray(b.observations.point) == p][0])
    # a mark that is also a row of the block would be left out; here the whole adjustment is asked
    free = next(k for k in range(len(b.images)) if k not in b.observations.image[np.asarray(b.observations.point) == p])
    found = predict(session, EMPTY, b.points.ids[p], b.images.ids[free])
    assert found.source == "adjusted"
    assert found.neglected == ""
    np.testing.assert_allclose(found.xy_px, predicted_px(b, free, b.points.xyz[p][None])[0], atol=1e-9)
    one, three = found.ellipse(), found.ellipse(3)
    assert three.a == pytest.approx(3 * one.a)
    assert one.a >= one.b > 0
    apart = predict(session, EMPTY, b.points.ids[p], b.images.file[i])
    assert apart.source == "intersected"
    assert apart.image == b.images.ids[i]


def simulated_predictions(runs, kind):
    """Errors and covariances of predictions in an image whose own observation of the point was kept out."""
    errors, covariances = [], []
    for seed in range(runs):
        made = simulation(seed=seed + 100)
        truth, block = made.truth, made.observed
        p = many_rays(block)[seed % 20]
        name = block.points.ids[p]
        if kind == "intersected":
            rest, rows = without_point(block, p)
            state = marks("new", rows[1:])
            session, name, image = Session.of(adjust(rest)), "new", rows[0][0]
        else:  # one of its rays kept out of the adjustment, one marked again after it
            o = block.observations
            mine = np.flatnonzero(np.asarray(o.point) == p)
            keep = np.ones(len(o), bool)
            keep[mine[:2]] = False
            session = Session.of(adjust(with_rows(block, keep)))
            state = (
                marks(name, [(block.images.ids[o.image[mine[1]]], o.xy_px[mine[1]])]) if kind == "updated" else EMPTY
            )
            image = block.images.ids[o.image[mine[0]]]
        found = predict(session, state, name, image)
        assert found.source == kind
        i = block.images.ids.index(image)
        errors.append(np.array(found.xy_px) - predicted_px(truth, i, truth.points.xyz[p][None])[0])
        covariances.append(found.covariance)
    return np.array(errors), np.array(covariances)


@pytest.mark.long
@pytest.mark.parametrize("kind", ["intersected", "adjusted", "updated"])
def test_the_covariance_of_a_prediction_is_true(kind):
    e, C = simulated_predictions(60, kind)
    square = np.einsum("ni,nij,nj->n", e, np.linalg.inv(C), e)
    low, high = chi2(2 * len(e)).ppf([0.0005, 0.9995])
    assert low < square.sum() < high


def test_a_mark_made_since_updates_as_a_new_adjustment_would(session):
    """The update of the joint covariance is the adjustment with one observation more, to first order."""
    block = small_block()
    o = block.observations
    p = many_rays(block)[3]
    mine = np.flatnonzero(np.asarray(o.point) == p)
    keep = np.ones(len(o), bool)
    keep[mine[0]] = False
    before, whole = Session.of(adjust(with_rows(block, keep))), session
    state = marks(block.points.ids[p], [(block.images.ids[o.image[mine[0]]], o.xy_px[mine[0]])])
    found = locate(before, state, block.points.ids[p])
    assert found.kind == "updated"
    # both variances of unit weight differ by a hundredth at most
    np.testing.assert_allclose(found.xyz, whole.block.points.xyz[p], atol=0.1 * found.sigma.max())
    np.testing.assert_allclose(found.covariance, whole.adjustment.precision.object_points[p], rtol=0.03, atol=1e-10)


def test_a_point_seen_once_lies_on_its_epipolar_line(session):
    b, truth = session.block, simulation().truth
    p = many_rays(b)[5]
    o = b.observations
    mine = np.flatnonzero(np.asarray(o.point) == p)
    state = marks("once", [(b.images.ids[o.image[mine[0]]], o.xy_px[mine[0]])])
    j = int(o.image[mine[1]])
    found = predict(session, state, "once", b.images.ids[j])
    assert (found.xy_px, found.source) == (None, "ray")
    assert found.segment_sigma_px > 0
    at = predicted_px(truth, j, truth.points.xyz[p][None])[0]
    a, d = found.segment[:-1], np.diff(found.segment, axis=0)
    t = np.clip(((at - a) * d).sum(axis=1) / (d * d).sum(axis=1), 0, 1)
    distance = np.linalg.norm(a + t[:, None] * d - at, axis=1).min()
    assert distance < 4 * found.segment_sigma_px + 0.05  # chords of the curve
    camera = session.camera(j)
    assert (found.segment >= 0).all()
    assert (found.segment <= [camera.width_px, camera.height_px]).all()


def test_where_a_point_is_visible_but_not_measured(session):
    b = session.block
    p = many_rays(b)[5]
    found = visible(session, EMPTY, b.points.ids[p])
    measured = {b.images.ids[i] for i in b.observations.image[np.asarray(b.observations.point) == p]}
    assert found
    assert not measured & {v.image for v in found}
    assert [v.angle_deg for v in found] == sorted(v.angle_deg for v in found)
    for v in found:
        xy = predicted_px(b, b.images.ids.index(v.image), b.points.xyz[p][None])[0]
        np.testing.assert_allclose(v.xy_px, xy)


def test_what_is_worst(session):
    found = worst(session, EMPTY, most=5)
    for kind, down in (("w", True), ("sigma", True), ("rays", False)):
        values = [w.value for w in found if w.kind == kind]
        assert len(values) == 5
        assert values == sorted(values, reverse=down) or kind == "rays"
    top = next(w for w in found if w.kind == "w")
    state = folded([])
    assert top.image in session.known.size_px
    assert state == EMPTY


def test_without_statistics_there_is_no_covariance_and_it_is_said():
    block = small_block()
    session = Session.of(adjust(block, AdjustmentOptions(statistics=False)))
    p = many_rays(block)[0]
    free = next(
        k
        for k in range(len(block.images))
        if k not in block.observations.image[np.asarray(block.observations.point) == p]
    )
    found = predict(session, EMPTY, block.points.ids[p], block.images.ids[free])
    assert found.xy_px is not None
    assert found.covariance is None
    assert found.ellipse() is None
    assert code_of(found.neglected) == "measuring.no_statistics"


def test_what_cannot_be_predicted_says_why(session):
    b = session.block
    found = predict(session, EMPTY, "nowhere", b.images.ids[0])
    assert (found.xy_px, found.source) == (None, "unknown")
    assert code_of(found.why) == "measuring.no_other_mark"


def test_how_a_small_piece_of_the_object_looks_in_another_image(session):
    """Against the places of points round the first, on the plane that faces both images."""
    b = session.block
    p = many_rays(b)[0]
    rows = np.flatnonzero(np.asarray(b.observations.point) == p)[:2]
    i, k = (int(b.observations.image[r]) for r in rows)
    name = b.points.ids[p]
    A = affine(session, EMPTY, name, b.images.ids[i], b.images.ids[k])
    X = b.points.xyz[p]
    towards = sum((b.images.centre[n] - X) / np.linalg.norm(b.images.centre[n] - X) for n in (i, k))
    right = np.cross(towards, [0.3, 0.5, 0.8])
    up = np.cross(towards, right)
    for d in (right, up, right + up):
        step = 1e-4 * d / np.linalg.norm(d)
        here, there = (seen_in(session, np.array([n, n]), X + step)[0] - seen_in(session, np.array([n]), X)[0]
                       for n in (i, k))  # fmt: skip
        np.testing.assert_allclose(A @ here, there, rtol=1e-3, atol=1e-6)
    B = affine(session, EMPTY, name, b.images.ids[k], b.images.ids[i])
    np.testing.assert_allclose(A @ B, np.eye(2), atol=1e-9)
