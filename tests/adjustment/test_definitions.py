"""Statistics by their definitions, on small numbers of which the answer is known otherwise."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import chi2, f

from raybundle.adjustment.blunders import suspects
from raybundle.adjustment.blunders.collinear_points import _straight
from raybundle.adjustment.blunders.identical_control import _largest_scale
from raybundle.adjustment.decision.variance_groups import _one_explains
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.image_interiors import OwnInteriors, groups_of
from raybundle.adjustment.evaluation.joint_cofactors import Factored, JointCofactors, joint_cofactors
from raybundle.adjustment.noise_sample import _neighbouring
from raybundle.adjustment.notices import _points, _without_worst
from raybundle.adjustment.records.figures import VarianceComponent
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.components import NAMES, settled_components
from raybundle.adjustment.statistics.network import classed
from raybundle.adjustment.statistics.reliability import _of_piece
from raybundle.adjustment.system import defects
from raybundle.adjustment.system.datum import well_spread
from raybundle.adjustment.system.input_checks import _check_indices
from raybundle.errors import InputError
from raybundle.numerics.statistics import DELTA0
from tests.native.cases import block_of, per_image
from tests.native.test_kernels import setting


def test_tests_of_correlated_image_points_are_those_of_their_matrices():
    rng = np.random.default_rng(1)
    n = 60
    a, b, c = 10 ** rng.uniform(-3, 3, n), rng.normal(size=n), 10 ** rng.uniform(-3, 3, n)
    c[:20], a[:20] = 10 ** rng.uniform(3, 4, (2, 20))
    b *= a
    b[:20] *= 1e-3
    W = np.zeros((n, 2, 2))
    W[:, 0, 0], W[:, 1, 0], W[:, 1, 1] = a, b, c
    half = rng.normal(size=(n, 2, 2))
    R = half @ half.transpose(0, 2, 1)
    R /= 2 * np.trace(R, axis1=1, axis2=2)[:, None, None]
    R[::5] *= 1e-11  # not controlled
    H = np.eye(2) - R
    v = rng.normal(size=(n, 2))
    effects = rng.normal(size=(n, 3, 2))
    pixel = np.tile([0.005, -0.004], (n, 1))
    system = SimpleNamespace(whiten=np.stack([a, b, c], axis=1), pixel_mm=pixel)
    hat = np.stack([H[:, 0, 0], H[:, 1, 1], H[:, 1, 0]], axis=1)
    found = _of_piece(system, v, SimpleNamespace(hat=hat, effect=effects), 2.0, slice(None))
    mm = np.linalg.solve(W, v[:, :, None])[:, :, 0]
    np.testing.assert_allclose(found["residuals_px"], mm / pixel, rtol=1e-9)
    P = W.transpose(0, 2, 1) @ W
    Qvv = np.linalg.solve(W, np.linalg.solve(W, R.transpose(0, 2, 1)).transpose(0, 2, 1))
    sure = np.arange(n) % 5 > 0
    redundancy = np.einsum("nij,nji->ni", Qvv, P)
    np.testing.assert_allclose(
        found["redundancy"][sure], redundancy[sure], rtol=1e-6, atol=1e-6 * np.abs(redundancy).max()
    )
    np.testing.assert_allclose(found["least_control"][sure], np.linalg.eigvalsh(R)[sure, 0], atol=1e-12)
    variance = np.einsum("nij,njk,nki->ni", P, Qvv, P)
    for name in ("w", "t", "mdb_px", "external"):
        assert np.isnan(found[name][~sure]).all()
    w = (P @ mm[:, :, None])[:, :, 0] / np.sqrt(variance) * [1, -1]
    np.testing.assert_allclose(found["w"][sure], w[sure], rtol=1e-5)
    np.testing.assert_allclose(found["t"][sure], w[sure] / 2, rtol=1e-5)
    mdb = DELTA0 / np.sqrt(variance)
    np.testing.assert_allclose(found["mdb_px"][sure], (mdb / np.abs(pixel))[sure], rtol=1e-5)
    moved = np.abs(effects @ W).max(axis=1) * mdb
    np.testing.assert_allclose(found["external"][sure], moved[sure], rtol=1e-5)


def test_groups_that_two_parameters_show_together_alone_are_found():
    rng, n = np.random.default_rng(0), 24
    C = np.array([[1.0, 0.9], [0.9, 1.0]])
    covariance = np.kron(np.eye(n), C)
    values = rng.multivariate_normal([0, 0], C, n)
    assert groups_of(OwnInteriors(images=np.arange(n), difference_px=values, covariance=covariance)) is None
    second = np.arange(n) % 2 == 1
    values[second] += [1.6, -1.6]
    images = np.arange(n) + 100
    found = groups_of(OwnInteriors(images=images, difference_px=values, covariance=covariance))
    assert found is not None
    assert sorted(i.tolist() for i in found.images) == [images[~second].tolist(), images[second].tolist()]
    assert found.probability < 1e-2
    j = 0 if found.symbol == "c" else 1
    means = [values[np.isin(images, i), j].mean() for i in found.images]
    np.testing.assert_allclose(found.means_px, means)
    within = sum(((values[np.isin(images, i), j] - m) ** 2).sum() for i, m in zip(found.images, means, strict=True))
    assert np.isclose(found.scatter_px, np.sqrt(within / (n - 2)))


def test_the_largest_scale_of_photographs_of_two_known_points_is_that_of_these():
    block = block_of(control=8)
    o = block.observations
    first = int(o.image[0])
    rows = o.point[np.flatnonzero(o.image == first)[:2]]
    mine = np.isin(o.point, rows) & (o.image == first)
    block = replace(block, observations=o.rows(mine | ~np.isin(o.point, rows)))
    far = np.linalg.norm(np.diff(block.points.xyz[rows], axis=0))
    apart = np.linalg.norm(np.diff(o.xy_px[mine], axis=0))
    assert _largest_scale(block, rows, far / 2) == pytest.approx(apart / far)
    assert _largest_scale(block, rows, 2 * far) == 0


@pytest.mark.parametrize("significant", [False, True])
def test_components_are_iterated_where_one_is_significant(significant):
    kinds = [
        VarianceComponent(kind=kind, group="all", count=90, redundancy=60.0, ratio=ratio, significant=is_significant)
        for kind, ratio, is_significant in (("image observations", 1.1, False), ("control", 0.9, significant))
    ]

    class Asked(Exception):
        pass

    def adjusted(block):
        raise Asked

    if significant:
        with pytest.raises(Asked):
            settled_components(block_of(control=4), tuple(kinds), adjusted)
    else:
        assert settled_components(block_of(control=4), tuple(kinds), adjusted) == tuple(kinds)
    alone = (replace(kinds[0], significant=True),)
    assert settled_components(block_of(), alone, adjusted) == alone


def test_the_datum_is_carried_by_points_of_many_rays_that_are_not_far_off():
    rng, n = np.random.default_rng(5), 240
    xyz, rays = rng.normal(size=(n, 3)), rng.permutation(n)
    xyz[rays > 220] *= 1000
    datum = SimpleNamespace(defect=7, centre=np.zeros(3), extent=1.5, basis=np.eye(7))
    given = np.zeros((n, 3), bool)
    given[:, 2] = rays % 2 == 0
    points, axes, share = well_spread(xyz, rays, given, datum)
    assert len(points) == 7
    assert share > 0.01
    near = np.flatnonzero(np.linalg.norm(xyz, axis=1) < 4.5)
    assert np.isin(points, near[np.argsort(-rays[near])[:60]]).all()
    assert not given[points, axes].any()
    assert well_spread(xyz[:2], rays[:2], given[:2], datum)[2] == 0


def test_joint_cofactors_are_those_of_the_points_and_unknowns_that_are_asked_for():
    Q = np.arange(121.0).reshape(11, 11)
    joint = JointCofactors(points=np.array([2, 5, 9]), columns=np.array([-1, 9, -1, 10]), matrix=Q)
    assert joint.place(np.array([0, 2, 5, 7, 9, 12])).tolist() == [-1, 0, 1, -1, 2, -1]
    assert joint.of_unknowns(np.array([3, 1])).tolist() == [[Q[10, 10], Q[10, 9]], [Q[9, 10], Q[9, 9]]]
    assert joint.variances().tolist() == np.diagonal(Q)[:9].reshape(3, 3).tolist()


@pytest.mark.parametrize("own", [False, True])
def test_joint_cofactors_hold_the_interior_orientations_that_images_share(own):
    result = adjust_block(per_image(block_of(control=8)) if own else block_of(control=8), AdjustmentOptions(jobs=1))
    joint = joint_cofactors(Factored.of(result), np.array([1, 4]))
    free = 0 if own else sum(len(i.free) for i in result.interior)
    assert free > 0 or own
    assert joint.matrix.shape == (6 + free, 6 + free)
    assert sorted(joint.columns[joint.columns >= 0]) == list(range(6, 6 + free))


def test_an_unknown_of_which_no_reason_is_known_is_named(monkeypatch):
    normals, state = setting(block_of(control=4), compiled=True, threads=1)
    normals.reduce(state)
    monkeypatch.setattr(defects, "null_space", lambda _: ([], []))
    for unknown in (0, 7):
        (found,) = defects.explain(normals, state, (), unknown).undetermined
        assert found == defects.named_unknown(normals.system, unknown)[0]
    assert not defects.explain(normals, state, (), -1).undetermined


@pytest.mark.parametrize(("tail", "explains"), [(0.02, True), (0.006, True), (0.004, False), (1e-6, False)])
def test_a_single_value_explains_a_group_where_the_others_do_not_contradict(tail, explains):
    """At half of one percent, the test being two-sided."""
    r = np.array([0.9, 0.8, 0.7, 0.8])
    square = chi2.isf(tail, r.sum() - 1)
    group = SimpleNamespace(
        kind="control", sigma=np.ones(4), w=np.array([0.0, 0.0, 6.0, 0.0]), redundancy=r,
        square=np.array([square / 2, square / 4, 36.0, square / 4]),
    )  # fmt: skip
    notices = [SimpleNamespace(code="control_suspect")]
    result = SimpleNamespace(groups=[group], notices=notices)
    assert _one_explains(result, (NAMES["control"], "all")) is explains
    assert not _one_explains(SimpleNamespace(groups=[group], notices=[]), (NAMES["control"], "all"))


def test_of_points_with_small_angles_a_hundred_are_listed():
    result = adjust_block(block_of(control=4), AdjustmentOptions(jobs=1))
    block, n = result.given, len(result.given.points)
    points = block.points.rows(np.tile(np.arange(n), -(-150 // n))[:150])
    given = SimpleNamespace(
        points=points, observations=block.observations, images=block.images, distances=block.distances
    )
    rays = np.full(150, 2)
    rays[np.flatnonzero(~points.is_control.all(axis=1))[:5]] = 1  # of a single ray there is no angle
    network = SimpleNamespace(rays=rays, intersection_angle=np.full(150, 0.01))
    (notice,) = [n for n in _points(replace(result, given=given, network=network)) if n.data.code == "small_angle"]
    loose = [
        name for name, known, k in zip(points.ids, points.is_control, rays, strict=True) if k > 1 and not known.all()
    ]
    assert notice.values["n"] == len(loose) > 99
    assert list(notice.ids) == loose[:100]


@pytest.mark.parametrize(("rho", "explains"), [(0.1, False), (-0.4, False), (0.8, True), (-0.9, True)])
def test_a_blunder_explains_another_residual_where_their_tests_are_correlated(rho, explains, monkeypatch):
    """w - rho w' beside 2.33 standard deviations of it: 5.1 and 5.0, each with the other's or none."""
    check = np.array([0.7, 0.4])
    cross = rho * np.sqrt(check.prod())
    H = np.array([[1 - check[0], cross], [cross, 1 - check[1]]])
    monkeypatch.setattr(suspects, "leverages", lambda *_: H)
    group = SimpleNamespace(kind="control", w=np.array([0.0, -5.1, 0.0, 5.0]))
    found = suspects._explained(None, group, np.array([1, 3]))
    assert found == {1: (3,) if explains else (), 3: (1,) if explains else ()}
    assert suspects._explained(None, group, np.array([1])) == {}
    larger = SimpleNamespace(kind="control", w=np.array([0.0, 5.0 * abs(rho) + 2.9, 0.0, 5.0]))
    assert suspects._explained(None, larger, np.array([1, 3]))[1] == ()


@pytest.mark.parametrize(("tie", "named", "expected"), [(4, 6, True), (5, 5, False), (6, 4, False), (0, 0, True)])
def test_classes_compare_where_less_than_half_of_the_points_seen_are_tie_points(tie, named, expected):
    ids = [*(f"t{k + 1}" for k in range(tie)), *(f"wall {k}" for k in range(named)), "t900", "t901", "t902"]
    seen = np.repeat(np.arange(tie + named), 3)
    block = SimpleNamespace(
        cameras=[SimpleNamespace(is_scene=False)], points=SimpleNamespace(ids=ids),
        observations=SimpleNamespace(point=seen),
    )  # fmt: skip
    assert classed(block) is expected
    block.cameras.append(SimpleNamespace(is_scene=True))
    assert not classed(block)


def test_a_group_without_its_worst_differs_by_the_f_test_of_what_is_left():
    """Degrees of freedom as whole numbers: 2 beside 4 of 7.4 in all, the worst value taking one."""
    seen = set()
    for square in np.geomspace(1, 1e4, 300):
        group = SimpleNamespace(
            sigma=np.array([1.0, 1.0, 0.0]), w=np.array([9.0, 0.0, 50.0]), square=np.array([81.0, square, 7.0]),
            redundancy=np.array([1.5, 1.5, np.nan]),
        )  # fmt: skip
        result = SimpleNamespace(weighted_square_sum=81.0 + square + 5.0, redundancy=7.4)
        F = (square / 2) / (5.0 / 4.4)
        expected = 2 * min(f.sf(F, 2, 4), f.sf(1 / F, 4, 2)) < 0.01
        assert _without_worst(result, group) == expected
        seen.add(bool(expected))
    assert len(seen) == 2


@pytest.mark.parametrize(
    ("n", "off", "straight"), [(2, 0, False), (3, 0, True), (3, 0.2, False), (5, 0, True), (5, 0.2, False)]
)
def test_three_points_lie_on_a_line_or_do_not(n, off, straight):
    xyz = np.linspace(0, 10, n)[:, None] * [1.0, 2.0, -1.0] + 50
    xyz[n // 2, 2] += off
    assert _straight(xyz, np.tile(1e-4 * np.eye(3), (n, 1, 1))) is straight


@pytest.mark.parametrize("name", ["image", "point"])
@pytest.mark.parametrize("beyond", [-1, 0, 1])
def test_a_position_one_after_the_last_is_refused(name, beyond):
    block = block_of(control=4)
    last = len(getattr(block, f"{name}s").ids) - 1
    at = getattr(block.observations, name).copy()
    at[3] = last + beyond
    changed = replace(block, observations=replace(block.observations, **{name: at}))
    if beyond < 1:
        _check_indices(changed)
        return
    with pytest.raises(InputError) as caught:
        _check_indices(changed)
    assert (caught.value.message.values["row"], caught.value.message.values["last"]) == (3, last)


def test_photographs_of_a_sample_are_joined_by_a_single_point():
    image, point = (
        np.array([1] * 5 + [0] * 3 + [2] * 2 + [3] * 4),
        np.array([0, 1, 2, 3, 4, 4, 5, 6, 6, 7, 8, 9, 10, 11]),
    )
    rows = block_of(control=4).observations.rows(np.arange(len(image)))
    block = SimpleNamespace(
        images=range(4),
        points=range(12),
        observations=replace(rows, image=image.astype(np.int32), point=point.astype(np.int32)),
    )
    assert _neighbouring(block).tolist() == [True, True, True, False]
