"""What is done the quick way comes to the same: parts of a network, starts, brief extents, expected covariances."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment import estimation
from raybundle.adjustment.engine import adjust_block, free_parameters
from raybundle.adjustment.evaluation.joint_cofactors import Factored, joint_cofactors
from raybundle.adjustment.evaluation.residual_structure import _neighbours
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.precision import cofactors, interior_unknowns, precision
from raybundle.adjustment.statistics.some_points import needed, solver_of
from raybundle.adjustment.system import dense
from raybundle.adjustment.system.assemble import assemble
from raybundle.adjustment.system.defects import components, held_by_points
from raybundle.adjustment.system.normals import Normals
from raybundle.block import Role
from raybundle.block.rejection import Rejection, RejectionKind
from raybundle.calibration.maps import projection_shifts, projection_uncertainty
from raybundle.numerics import native
from raybundle.observations.distance import Distances
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene

OPTIONS = AdjustmentOptions(jobs=1, tolerance=1e-9)


@pytest.fixture(scope="module")
def block():
    scene = field_scene(TargetField())
    return simulate(scene, Survey(seed=3, image_sigma_px=0.05, points="exact", orientation="exact")).observed


@pytest.fixture(scope="module")
def adjusted(block):
    return adjust_block(block, OPTIONS)


def again(adjusted):
    return replace(adjusted.adjusted, observations=adjusted.given.observations)


@pytest.mark.parametrize("seed", range(6))
def test_parts_of_a_network_are_those_that_common_points_join(block, seed):
    """Images in runs that share no point: near one another or far, one part or several."""
    rng = np.random.default_rng(seed)
    n, p = len(block.images), len(block.points)
    o = block.observations
    group, of = np.arange(n) * (1 + seed % 3) // n, np.arange(p) * (1 + seed % 3) // p
    rejected = (group[o.image] != of[o.point]) | (rng.random(len(o)) < 0.2)
    seen = np.zeros((n, p), bool)
    seen[o.image[~rejected], o.point[~rejected]] = True
    joined = np.linalg.matrix_power((seen @ seen.T).astype(float), n) > 0
    expected = {tuple(np.flatnonzero(joined[i])) for i in np.flatnonzero(seen.any(axis=1))}
    assert {tuple(part) for part in components(block, rejected)} == expected
    assert len(expected) == 1 + seed % 3


def test_held_points_join_nothing_and_hold_a_part_where_they_span_a_plane(block):
    p = len(block.points)
    known = replace(block.points, role=np.full(p, Role.CONTROL, np.int32), sigma=np.zeros((p, 3)))
    held = replace(block, points=known)
    none = np.zeros(len(block.observations), bool)
    assert [part.tolist() for part in components(held, none)] == [[i] for i in range(len(block.images))]
    assert held_by_points(held, ~none)
    assert not held_by_points(block, ~none)
    line = np.outer(np.arange(p), [1.0, 2.0, 3.0])
    assert not held_by_points(replace(held, points=replace(known, xyz=line)), ~none)
    two = block.observations.point < 2
    assert not held_by_points(held, two)


def test_a_start_from_adjusted_values_ends_at_the_same_values(block, adjusted):
    rejected = tuple(
        Rejection(kind=RejectionKind.GIVEN) if i % 50 == 0 else None for i in range(len(block.observations))
    )
    near = replace(OPTIONS, tolerance=1e-4)
    first = adjust_block(again(adjusted), near, rejected=rejected)
    quick = adjust_block(again(adjusted), near, rejected=rejected, start="adjusted")
    assert quick.converged
    assert quick.iterations < first.iterations
    for symbol, p in first.interior[0].parameters.items():
        assert abs(quick.interior[0].parameters[symbol].value - p.value) <= near.tolerance * (p.std or 0.0)
    assert quick.sigma0 == pytest.approx(first.sigma0, rel=1e-9)


def test_a_start_that_is_called_adjusted_and_is_not_ends_there_too(block, adjusted):
    camera = block.cameras[0]
    far = replace(camera, values={**camera.values, "c": 1.1 * camera.values["c"]})
    found = adjust_block(replace(block, cameras=(far,)), OPTIONS, start="adjusted")
    assert found.converged
    p = adjusted.interior[0].parameters["c"]
    assert abs(found.interior[0].parameters["c"].value - p.value) < 1e-4 * p.std


def test_brief_extents_say_less_and_the_same(block, adjusted):
    tests = adjust_block(block, OPTIONS, extent="tests")
    decisions = adjust_block(block, OPTIONS, extent="decisions")
    for brief in (tests, decisions):
        assert brief.image_observations.t == pytest.approx(adjusted.image_observations.t, abs=1e-9)
        assert brief.critical_tau == adjusted.critical_tau
    assert not tests.interior
    assert decisions.interior[0].parameters["c"].std == pytest.approx(adjusted.interior[0].parameters["c"].std)


def test_the_covariance_that_a_network_promises_is_that_of_its_adjustment(block, adjusted):
    free = {c.id: free_parameters(c) for c in block.parametrised}
    factored = Factored.at(again(adjusted), OPTIONS, free, (None,) * len(block.observations))
    joint = joint_cofactors(factored, np.arange(3))
    row = next(r for r in factored.system.interior if r.image < 0)
    Q = joint.of_unknowns(interior_unknowns(factored.system, row))
    expected = adjusted.precision.interior[block.cameras[0].id]
    assert adjusted.sigma0**2 * Q == pytest.approx(expected, rel=1e-5, abs=1e-9 * np.abs(expected).max())


def test_motions_serve_for_any_covariance(adjusted):
    camera, free = adjusted.adjusted.cameras[0], adjusted.interior[0].free
    C = adjusted.precision.interior[camera.id]
    shifts = projection_shifts(camera, free, columns=9, rows=6)
    direct = projection_uncertainty(camera, free, 4 * C, columns=9, rows=6)
    assert direct.std == pytest.approx(2 * shifts.uncertainty(C).std, rel=1e-9)
    # the motion that is left has no part that a rotation of the camera would take up
    nearly = projection_shifts(camera, free, distance=1e9, columns=9, rows=6)
    assert nearly.uncertainty(C).largest <= shifts.uncertainty(C).largest * (1 + 1e-6)


def test_neighbours_are_the_pairs_within_the_distances():
    xy = np.random.default_rng(1).random((300, 2))
    one, other = _neighbours(xy, 0.03, 0.1)
    distance = np.linalg.norm(xy[:, None] - xy, axis=2)
    i, j = np.nonzero((distance > 0.03) & (distance <= 0.1) & (np.arange(300)[:, None] < np.arange(300)))
    assert {frozenset(k) for k in zip(one, other, strict=True)} == {frozenset(k) for k in zip(i, j, strict=True)}
    assert len(one) == len(i)


@pytest.mark.skipif(not native.available(), reason="the native kernels are not there; they alone take LAPACK's threads")
def test_small_matrices_take_one_thread_and_the_number_comes_back():
    threads = dense.set_dense_kernels()
    if threads is None:
        pytest.skip("SciPy is not linked to OpenBLAS; its threads are left as they are")
    before = threads.read()
    threads.set(2)
    if threads.read() != 2:
        pytest.skip("one processor: OpenBLAS takes one thread anyway")
    try:
        with dense.as_many_threads_as_help(dense.SMALL):
            assert threads.read() == 1
        assert threads.read() == 2
        with dense.as_many_threads_as_help(dense.SMALL + 1):
            assert threads.read() == 2
        with pytest.raises(ZeroDivisionError), dense.as_many_threads_as_help(3):
            1 / 0
        assert threads.read() == 2
    finally:
        threads.set(before)


def test_sparse_matrices_count_by_what_their_unknowns_meet(block):
    """Twelve images of one object are a full matrix; a chain of them is not."""
    options = AdjustmentOptions()
    free = {c.id: free_parameters(c) for c in block.parametrised}
    system = assemble(block, options, np.zeros(len(block.observations), bool), free)
    full = Normals.of(system, 1)
    assert 0.9 * len(full.right) <= full.meeting <= 1.1 * len(full.right) + 6
    o = block.observations
    far = np.array([(i - int(p)) % len(block.images) > 1 for i, p in zip(o.image, o.point, strict=True)])
    chain = Normals.of(assemble(block, options, far, dict.fromkeys(free, ())), 1)
    assert chain.meeting < 0.6 * len(chain.right)


def test_free_networks_are_factored_once_where_they_will_stand(block, monkeypatch):
    """Moved onto the given coordinates first; the same as moved after a first factor and inverted again there."""
    calls = []

    def counted(name):
        true = getattr(estimation, name)
        monkeypatch.setattr(estimation, name, lambda *a: (calls.append(name), true(*a))[1])

    counted("_factor")
    counted("cofactors")
    rng = np.random.default_rng(5)
    xyz = block.points.xyz * 1.01 + rng.normal(0, 0.01 * np.ptp(block.points.xyz), block.points.xyz.shape)
    result = adjust_block(replace(block, points=replace(block.points, xyz=xyz)), OPTIONS)
    assert calls == ["_factor", "cofactors"]
    work = result.handle.work
    assert work.datum.kind == "inner"
    assert work.datum.defect > 0
    assert np.abs(work.state.xyz - work.solution.state.xyz).max() > 1e-4 * work.datum.extent
    estimation._factor(work.normals, work.solution.state, work.datum)
    work.normals.reduce(work.state)
    assert work.normals.factorise() == 0
    twice = precision(work.normals, work.state, cofactors(work.normals, work.state, work.datum), result.sigma0**2)
    key = next(iter(twice.interior))
    for a, b in (
        (result.precision.object_points, twice.object_points),
        (result.precision.images, twice.images),
        (result.precision.interior[key], twice.interior[key]),
    ):
        s = np.sqrt(np.diagonal(b, axis1=-2, axis2=-1))
        assert (np.abs(a - b) / (s[..., :, None] * s[..., None, :])).max() < 1e-9


@pytest.mark.parametrize("datum", ["free", "control", "distance"])
@pytest.mark.parametrize("noise", ["white", "fields"])
def test_some_points_have_the_covariances_that_they_have_among_all(block, noise, datum):
    points, given = block.points, block
    if datum == "control":
        role, sigma = np.array(points.role), np.array(points.sigma)
        role[:6], sigma[:6] = Role.CONTROL, 1e-4
        sigma[3] = 0.0
        given = replace(block, points=replace(points, role=role, sigma=sigma))
    if datum == "distance":
        length = np.array([np.linalg.norm(points.xyz[20] - points.xyz[1])])
        start, end = np.array([1], np.int32), np.array([20], np.int32)
        given = block.having(Distances(start=start, end=end, length=length, sigma=length * 1e-4))
    work = adjust_block(given, replace(OPTIONS, noise=noise)).handle.work
    assert (work.spread is None) == (noise == "white")
    some, rng = np.union1d(needed(work), [2, 3, 20, 30, 31]).astype(int), np.random.default_rng(1)
    nodes, given = rng.normal(size=(len(work.normals.right), 3)), rng.normal(size=(len(some), 3, 3))
    every = np.zeros((*work.state.xyz.shape, 3))
    every[some] = given
    whole = work.normals.solve(work.state, nodes, every) if work.spread is None else work.spread.solve(nodes, every)
    n, q = solver_of(work, some)(nodes, given)
    np.testing.assert_allclose(n, whole[0], rtol=1e-7, atol=1e-9 * np.abs(whole[0]).max())
    np.testing.assert_allclose(q, whole[1][some], rtol=1e-7, atol=1e-9 * np.abs(q).max())
