"""Covariances of any pair, other datums and separability, against dense linear algebra."""

import functools

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.queries import own_values, precision_in_datum
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system import images_numpy
from raybundle.block.select import with_rows
from raybundle.errors import InputError
from raybundle.observations.alignment import Levels, Planes
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.workflows.adjust import adjust
from tests.adjustment.test_design_rows import image_design

SCENE = field_scene(TargetField(rows=4, columns=6, stations=5, frontal=1))


@functools.cache
def adjusted(**survey):
    block = simulate(SCENE, Survey(points="exact", orientation="exact", interior="exact", **survey)).observed
    return adjust_block(block, AdjustmentOptions())


@functools.cache
def dense(scale_bars):
    """Cofactor of all unknowns (nodes, points) by the bordered normal matrix with inner constraints over all points."""
    result = adjusted(scale_bars=scale_bars)
    work = result.handle.work
    system, state = work.system, work.state
    n, p = int(system.offsets[-1]), len(system.points_used)
    A = np.zeros((2 * len(system.rows) + len(system.extra), n + 3 * p))
    held, system.held = system.held, system.control_held  # no minimal datum here
    A[: 2 * len(system.rows)] = image_design(system, state)
    entries = work.normals.extra(state)
    for row, unknown, value in zip(entries.row, entries.unknown, entries.value, strict=True):
        node = int(np.searchsorted(system.offsets, unknown, side="right") - 1)
        point = int(np.flatnonzero(system.point_node == node)[0])
        A[2 * len(system.rows) + row, n + 3 * point + unknown - system.offsets[node]] += value
    system.held = held
    t = work.found.transformation
    G = np.concatenate([t.nodes, t.points.reshape(-1, t.nodes.shape[1])])
    BG = np.concatenate([np.zeros_like(t.nodes), t.points.reshape(-1, t.nodes.shape[1])])
    keep = np.abs(A).sum(axis=0) > 0
    N = A[:, keep].T @ A[:, keep]
    s = 1 / np.sqrt(np.diagonal(N))
    g = BG[keep] * s[:, None]
    g = g / np.linalg.norm(g, axis=0)
    size = len(N)
    bordered = np.block([[N * np.outer(s, s), g], [g.T, np.zeros((g.shape[1],) * 2)]])
    Q = np.linalg.inv(bordered)[:size, :size] * np.outer(s, s)
    full = np.zeros((n + 3 * p,) * 2)
    full[np.ix_(keep, keep)] = Q
    assert np.abs(A[:, keep] @ G[keep]).max() < 1e-6 * np.abs(A).max()
    return result, full, n


@pytest.mark.parametrize("scale_bars", [0, 2])
def test_every_covariance_equals_the_bordered_inverse(scale_bars):
    result, Q, n = dense(scale_bars)
    system = result.handle.work.system
    ids = result.given.points.ids
    points = [f"point:{ids[i]}" for i in (0, 5, 11)]
    for a in points:
        i = n + 3 * ids.index(a.split(":")[1])
        for b in points:
            j = n + 3 * ids.index(b.split(":")[1])
            expected = Q[i : i + 3, j : j + 3] * result.sigma0**2
            np.testing.assert_allclose(
                result.covariance(a, b), expected, rtol=1e-6, atol=1e-9 * np.abs(np.diagonal(Q)[n:]).max()
            )
    own = result.covariance("camera:1")
    np.testing.assert_allclose(own, result.precision.interior["1"], rtol=1e-8)
    row = system.interior[0]
    at = int(system.offsets[row.node])
    k = len(row.free)
    np.testing.assert_allclose(own, Q[at : at + k, at : at + k] * result.sigma0**2, rtol=1e-6)
    image = result.given.images.ids[2]
    np.testing.assert_allclose(
        result.covariance(f"image:{image}"),
        result.precision.images[2],
        rtol=1e-7,
        atol=1e-22,
    )
    cross = result.covariance("camera:1", f"image:{image}")
    s = np.sqrt(np.outer(np.diagonal(own), np.diagonal(result.precision.images[2])))
    np.testing.assert_allclose(cross / s, result.precision.interior_exterior["1"][2], atol=1e-7)


def test_a_point_that_carries_a_scale_bar_has_its_covariance_too():
    result = adjusted(scale_bars=2)
    d = result.given.distances
    name = result.given.points.ids[d.start[0]]
    np.testing.assert_allclose(
        result.covariance(f"point:{name}"),
        result.precision.object_points[d.start[0]],
        rtol=1e-6,
    )


def test_another_datum_without_adjusting_again():
    block = simulate(SCENE, Survey(points="exact", orientation="exact")).observed
    chosen = tuple(block.points.ids[i] for i in (0, 4, 9, 15, 19))
    there = adjust_block(block, AdjustmentOptions(datum_points=chosen))
    here = precision_in_datum(adjust_block(block, AdjustmentOptions(tolerance=1e-7)), chosen)
    np.testing.assert_allclose(here.object_point_std, there.precision.object_point_std, rtol=1e-4)
    back = precision_in_datum(there, block.points.ids)
    plain = adjust_block(block, AdjustmentOptions())
    np.testing.assert_allclose(back.object_point_std, plain.precision.object_point_std, rtol=1e-4)


def test_weak_points_do_not_carry_the_datum_if_asked():
    block = simulate(SCENE, Survey(points="exact", orientation="exact")).observed
    o = block.observations
    weak, keep = np.array([1, 8, 13]), np.ones(len(o), bool)
    for point in weak:  # two rays at the smallest angle
        rows = np.flatnonzero(o.point == point)
        ray = block.images.centre[o.image[rows]] - block.points.xyz[point]
        ray /= np.linalg.norm(ray, axis=1)[:, None]
        near = np.unravel_index(np.argmax(ray @ ray.T - 2 * np.eye(len(rows))), (len(rows), len(rows)))
        keep[np.delete(rows, near)] = False
    block = with_rows(block, keep)
    everything = adjust_block(block, AdjustmentOptions())
    good = adjust_block(block, AdjustmentOptions(datum_over="good"))
    carriers = np.flatnonzero(good.handle.work.datum.carriers)
    assert not np.isin(weak, carriers).any()
    assert {"over": "good", "n": len(carriers)}.items() <= good.datum.messages[0].values.items()
    there = precision_in_datum(everything, tuple(block.points.ids[k] for k in carriers))
    np.testing.assert_allclose(good.precision.image_std, there.image_std, rtol=1e-4)
    assert (good.precision.image_std[:, :3].mean(axis=0) < everything.precision.image_std[:, :3].mean(axis=0)).all()


@pytest.mark.parametrize("datum", ["inner", "minimal", "auto"])
def test_residuals_do_not_depend_on_the_datum(datum):
    block = simulate(SCENE, Survey(points="exact", orientation="approximate")).observed
    a = adjust(block, AdjustmentOptions(datum="auto", tolerance=1e-7))
    b = adjust(block, AdjustmentOptions(datum=datum, tolerance=1e-7))
    assert b.sigma0 == pytest.approx(a.sigma0, rel=1e-9)
    np.testing.assert_allclose(a.image_observations.residuals_px, b.image_observations.residuals_px, atol=1e-9)
    np.testing.assert_allclose(a.image_observations.redundancy, b.image_observations.redundancy, atol=1e-7)


def test_minimal_datum_holds_as_many_coordinates_as_are_open():
    block = simulate(SCENE, Survey(points="exact", orientation="exact")).observed
    result = adjust_block(block, AdjustmentOptions(datum="minimal"))
    assert int((result.precision.object_point_std == 0).sum()) == 7


def test_two_suspects_on_one_weak_point_are_not_separable():
    simulation = simulate(SCENE, Survey(points="exact", orientation="exact", gross_share=0.02, gross_px=30))
    result = adjust_block(simulation.observed, AdjustmentOptions())
    assert result.suspects
    for image, point, w, correlation in result.suspects:
        assert image in result.given.images.ids
        assert point in result.given.points.ids
        assert w > 3
        assert 0 <= correlation <= 1 + 1e-9


def test_unknown_names_are_refused():
    with pytest.raises(InputError, match=r"query\.unknown"):
        adjusted().covariance("point:nobody", "camera:1")


def test_decisions_do_not_move_what_is_observed():
    """Rounds of data snooping start from adjusted values; weighted control and observed parameters stay as given."""
    from dataclasses import replace

    block = simulate(
        SCENE, Survey(points="exact", orientation="exact", control=6, control_sigma=(1e-4, 1e-4, 1e-4))
    ).observed
    camera = replace(block.cameras[0], sigma={"c": 0.05})
    block = block.with_cameras(camera)
    plain = adjust(block, AdjustmentOptions(tolerance=1e-8))
    snooped = adjust(block, AdjustmentOptions(tolerance=1e-8, reject="snooping"))
    assert not any(snooped.image_observations.rejected)
    assert snooped.sigma0 == pytest.approx(plain.sigma0, rel=1e-9)
    control = next(g for g in snooped.groups if g.kind == "control")
    np.testing.assert_array_equal(control.given, next(g for g in plain.groups if g.kind == "control").given)


def test_a_suspect_where_the_lens_has_no_image_is_listed_all_the_same(monkeypatch):
    observed = simulate(SCENE, Survey(points="exact", orientation="exact", gross_share=0.02, gross_px=30)).observed
    expected = adjust_block(observed, AdjustmentOptions()).suspects

    def lost(evaluate, measured):
        return measured, evaluate(measured)[1], np.ones(measured.shape[1], bool)

    monkeypatch.setattr(images_numpy, "project_from", lost)
    found = adjust_block(observed, AdjustmentOptions()).suspects
    assert [s[:3] for s in found] == [s[:3] for s in expected]
    assert np.allclose([s[3] for s in found], [s[3] for s in expected], atol=0.01)


@pytest.mark.parametrize("survey", [{"scale_bars": 2}, {"control": 4, "control_sigma": (1e-3, 1e-3, 1e-3)}])
def test_what_a_kind_has_as_unknowns_is_told_in_the_frame_of_the_object(survey):
    """Of a plane: the distances of its points follow from its values; of a level: its height has a true variance."""
    block = simulate(SCENE, Survey(points="exact", orientation="exact", interior="exact", **survey)).observed
    points = np.array([1, 4, 8, 11, 15], np.int32)
    planes = Planes(figure=("wall",) * 5, point=points, sigma=np.full(5, 1e-2))
    result = adjust_block(block.having(planes), AdjustmentOptions())
    (g,) = [g for g in result.groups if g.kind == "plane"]
    values = own_values(result, "plane:wall")
    xyz = result.adjusted.points.xyz[points]
    np.testing.assert_allclose((xyz - values[6:]) @ values[:3], g.residual, atol=1e-9)
    C = result.covariance("plane:wall")
    assert C.shape == (3, 3)
    assert np.linalg.eigvalsh(C)[0] > 0
    level = Levels(figure=("water",) * 5, point=points, sigma=np.full(5, 1e-2))
    levelled = adjust_block(block.having(level), AdjustmentOptions())
    z = own_values(levelled, "level:water")[2]
    np.testing.assert_allclose(z, levelled.adjusted.points.xyz[points, 2].mean(), atol=1e-9)
    own = levelled.covariance("level:water")[0, 0]
    assert own > 0
    for k in points:  # as of any two unknowns
        name = f"point:{levelled.given.points.ids[k]}"
        both = levelled.covariance("level:water", name)[0, 2]
        assert both**2 <= own * levelled.covariance(name, name)[2, 2]
    with pytest.raises(InputError, match=r"query\.unknown_own"):
        own_values(result, "plane:roof")
    with pytest.raises(InputError, match=r"KIND.*NAME.*query\.unknown"):
        result.covariance("plane:roof", "plane:wall")
