"""Coordinates with a joint covariance: true standard deviations, tests of correlated observations, refusals."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.field_system import sparse_normals
from raybundle.adjustment.system.normals import Normals
from raybundle.errors import InputError
from raybundle.io.block.folder import read_block, write_block
from raybundle.observations.coordinates import Coordinates, ObservedCoordinates
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.write import write_result
from raybundle.results.folder import read_result

SCENE = field_scene(TargetField(rows=5, columns=6, depth=0.4, size=(0.8, 0.6), stations=6, frontal=1))
KNOWN = np.array([0, 5, 8, 14, 21, 24, 29], np.int32)
OWN, COMMON = 3e-4, 2e-3
ONE = AdjustmentOptions(jobs=1)


def covariance():
    """Of the known points: errors of their own, and a shift, rotations and scale that they have in common."""
    xyz = SCENE.xyz[KNOWN] - SCENE.xyz[KNOWN].mean(axis=0)
    G = np.zeros((len(KNOWN), 3, 7))
    G[:, :, :3] = np.eye(3)
    for a in range(3):
        G[:, :, 3 + a] = np.cross(np.eye(3)[a], xyz)
    G[:, :, 6] = xyz
    G = G.reshape(-1, 7)
    own = OWN**2 * np.kron(np.eye(len(KNOWN)), np.array([[1.0, 0.3, -0.2], [0.3, 1.5, 0.1], [-0.2, 0.1, 4.0]]))
    return own + COMMON**2 * G @ G.T


def table(xyz, C, network="gnss", points=KNOWN):
    """Rows of a network of points with coordinates (k, 3) and covariance (3 k, 3 k)."""
    k = len(points)
    a, b = np.triu_indices(k)
    blocks = C.reshape(k, 3, k, 3)[a, :, b].reshape(-1, 9)
    return Coordinates(
        network=(network,) * len(a), point=points[a], other=points[b],
        xyz=np.where((a == b)[:, None], xyz[a], np.nan), covariance=blocks,
    )  # fmt: skip


def drawn(seed, C=None):
    """Truth, a free network with cameras held, and the errors of its known points."""
    C = covariance() if C is None else C
    made = simulate(SCENE, Survey(image_sigma_px=0.5, interior="exact", seed=seed))
    error = np.random.default_rng(1000 + seed).multivariate_normal(np.zeros(len(C)), C).reshape(-1, 3)
    cameras = tuple(replace(c, estimate=()) for c in made.observed.cameras)
    return made.truth, replace(made.observed, cameras=cameras), made.truth.points.xyz[KNOWN] + error


def squared(result, truth, points):
    error = (result.adjusted.points.xyz - truth.points.xyz)[points]
    C = result.precision.object_points[points]
    return float(np.einsum("pi,pij,pj->", error, np.linalg.inv(C), error)) / error.size


@pytest.mark.long
def test_standard_deviations_hold_and_would_not_without_correlations():
    """Squared errors over the stated covariance; coordinates of one point, over runs, are chi-square distributed."""
    C = covariance()
    joint, alone, tests, parts = [], [], [], []
    for seed in range(60):
        truth, block, xyz = drawn(seed)
        result = adjust(block.having(table(xyz, C)), ONE)
        assert result.datum == "control" or not result.datum_defect
        (g,) = result.groups
        r = np.nansum(result.image_observations.redundancy) + g.redundancy.sum()
        assert r == pytest.approx(result.redundancy, abs=1e-5)
        joint.append(squared(result, truth, [12]))
        tests.append(np.nanmean(g.w**2))
        parts.append(g.square.sum() / g.redundancy.sum())
        if seed < 20:
            bare = adjust(block.having(table(xyz, np.diag(np.diagonal(C)))), ONE)
            alone.append(squared(bare, truth, [12]))
    # 180 squares: standard deviation sqrt(2 / 180) = 0.105
    assert 0.65 < np.mean(joint) < 1.4
    assert 0.8 < np.mean(tests) < 1.2
    assert 0.8 < np.mean(parts) < 1.2
    assert np.mean(alone) > 2


def test_it_is_the_dense_adjustment():
    """Coordinates, cofactors, redundancy numbers, test values and detectable errors by the formulas of the textbook."""
    _, block, xyz = drawn(3)
    C = covariance()
    result = adjust(block.having(table(xyz, C)), ONE)
    work = result.handle.work
    system, state = work.system, work.state
    e = work.normals.extra(state)
    assert len(e.residual) == 3 * len(KNOWN)
    A = np.zeros((len(e.residual), int(system.offsets[-1])))
    np.add.at(A, (e.row, e.unknown), e.value)
    (g,) = result.groups
    root = np.linalg.cholesky(C)
    v = g.residual
    np.testing.assert_allclose(e.residual, np.linalg.solve(root, v), rtol=1e-8, atol=1e-10)
    columns = [system.offsets[system.point_node[p]] + a for p in KNOWN for a in range(3)]
    np.testing.assert_allclose(A[:, columns], np.linalg.inv(root), rtol=1e-8, atol=1e-6)
    normals = Normals.of(system, 1)
    normals.reduce(state)
    N = sparse_normals(normals).toarray()
    Q = np.linalg.inv(N)[np.ix_(columns, columns)]
    P = np.linalg.inv(C)
    Qv = C - Q
    np.testing.assert_allclose(g.redundancy, np.diagonal(Qv @ P), rtol=1e-6, atol=1e-8)
    test = np.sqrt(np.diagonal(P @ Qv @ P))
    np.testing.assert_allclose(g.w, P @ v / test, rtol=1e-6, atol=1e-8)
    np.testing.assert_allclose(g.mdb, 4.1320 / test, rtol=1e-3)
    np.testing.assert_allclose(g.adjusted_std, result.sigma0 * np.sqrt(np.diagonal(Q)), rtol=1e-6)
    assert float(g.square.sum()) == pytest.approx(v @ P @ v, rel=1e-8)


def test_uncorrelated_ones_are_control():
    _, block, xyz = drawn(5)
    sigma = np.sqrt(np.diagonal(covariance())).reshape(-1, 3)
    points = block.points
    given, s, role = points.xyz.copy(), points.sigma.copy(), np.asarray(points.role).copy()
    given[KNOWN], s[KNOWN], role[KNOWN] = xyz, sigma, 1
    control = adjust(replace(block, points=replace(points, xyz=given, sigma=s, role=role)), ONE)
    found = adjust(block.having(table(xyz, np.diag(sigma.ravel() ** 2))), ONE)
    np.testing.assert_allclose(found.adjusted.points.xyz, control.adjusted.points.xyz, rtol=0, atol=1e-9)
    np.testing.assert_allclose(found.precision.object_points, control.precision.object_points, rtol=1e-6, atol=1e-16)
    (a,), (b,) = found.groups, control.groups
    for name in ("residual", "redundancy", "w", "mdb", "square", "adjusted_std"):
        np.testing.assert_allclose(getattr(a, name), getattr(b, name), rtol=1e-5, atol=1e-9)


def test_points_that_take_no_part_leave_the_others_their_covariance():
    _, block, xyz = drawn(7)
    C = covariance()
    lone = len(block.points)
    points = block.points
    more = replace(
        block,
        points=replace(
            points, ids=(*points.ids, "unseen"), xyz=np.vstack([points.xyz, np.zeros(3)]),
            sigma=np.vstack([points.sigma, np.full(3, np.nan)]), role=np.append(points.role, 1),
        ),
    )  # fmt: skip
    bigger = np.eye(len(C) + 3) * 1e-4
    bigger[:-3, :-3] = C
    bigger[-3:, :-3], bigger[:-3, -3:] = 1e-9, 1e-9
    with_it = table(np.vstack([xyz, np.zeros(3)]), bigger, points=np.append(KNOWN, np.int32(lone)))
    a, b = adjust(more.having(with_it), ONE), adjust(block.having(table(xyz, C)), ONE)
    assert a.sigma0 == pytest.approx(b.sigma0, rel=1e-12)
    # steps that gain less than the rounding of the square sum are not taken: they move points by so much
    np.testing.assert_allclose(a.adjusted.points.xyz[:lone], b.adjusted.points.xyz, rtol=0, atol=1e-8)


def test_a_gross_error_is_named_though_the_network_hides_it():
    _, block, xyz = drawn(9)
    xyz = xyz.copy()
    xyz[3, 1] += 20 * OWN
    result = adjust(block.having(table(xyz, covariance())), ONE)
    (g,) = result.groups
    worst = int(np.nanargmax(np.abs(g.w)))
    assert (g.ids[worst], g.component[worst]) == (block.points.ids[KNOWN[3]], "Y")
    (suspect,) = [n for n in result.notices if n.code == "coordinate_suspect"]
    assert block.points.ids[KNOWN[3]] in suspect.text


def test_it_stands_in_folders(tmp_path):
    _, block, xyz = drawn(11)
    block = block.having(table(xyz, covariance()))
    write_block(block, tmp_path / "block")
    again = read_block(tmp_path / "block")
    there = again.tables["coordinates"]
    np.testing.assert_array_equal(there.covariance, block.tables["coordinates"].covariance)
    result = adjust(again, ONE)
    write_result(result, tmp_path / "out")
    shown = read_result(tmp_path / "out").others["coordinates"]
    (g,) = result.groups
    own = np.array(shown.text["point"]) == np.array(shown.text["other"])
    assert (abs(shown.numbers("vX", "vY", "vZ")[own].ravel() - g.residual) <= 1.001e-3 * abs(g.residual / g.w)).all()
    assert ObservedCoordinates.title in (tmp_path / "out/report.html").read_text()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda t: replace(t, covariance=np.abs(t.covariance) + 1.0), r"network\.covariance_not_positive"),
        (lambda t: replace(t, covariance=-t.covariance), r"network\.variance_not_positive"),
        (lambda t: t.rows(np.arange(len(t)) > 0), r"network\.point_without_coordinates"),
        (lambda t: t.append(t), r"network\.pair_twice"),
        (lambda t: replace(t, xyz=np.nan_to_num(t.xyz, nan=1.0)), r"(?s)column X: .*network\.coordinates_of_pair"),
        (lambda t: replace(t, xyz=np.full_like(t.xyz, np.nan)), r"network\.coordinates_missing"),
    ],
)
def test_what_is_wrong_is_said(tmp_path, change, words):
    _, block, xyz = drawn(13)
    write_block(block.having(change(table(xyz, covariance()))), tmp_path / "block")
    with pytest.raises(InputError, match=words):
        adjust(read_block(tmp_path / "block"), ONE)


def test_a_point_is_not_known_twice():
    _, block, xyz = drawn(15)
    points = block.points
    given, s, role = points.xyz.copy(), points.sigma.copy(), np.asarray(points.role).copy()
    given[KNOWN[0]], s[KNOWN[0]], role[KNOWN[0]] = xyz[0], 1e-3, 1
    block = replace(block, points=replace(points, xyz=given, sigma=s, role=role))
    with pytest.raises(InputError, match=r"network\.point_given_twice"):
        adjust(block.having(table(xyz, covariance())), ONE)
