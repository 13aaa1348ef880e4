"""Every function of the compiled solver against its NumPy twin, at a state that is not the solution."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system import defects
from raybundle.adjustment.system import normals as normals_module
from raybundle.adjustment.system.assemble import assemble
from raybundle.numerics import native
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.sensors import sensor_models
from tests.native.cases import (
    FREE,
    block_of,
    close,
    correlated,
    held_images,
    intersection,
    own_model,
    per_image,
    single_image_camera,
)

pytestmark = pytest.mark.skipif(not native.available(), reason="the kernels are not compiled")
BLOCKS = {
    **{model: lambda model=model: block_of(model, control=6) for model in FREE},
    "retained points": lambda: block_of(control=5, scale_bars=3, control_sigma=(1e-4, 0.0, 1e-4)),
    "per image": lambda: per_image(block_of(control=8)),
    "single image": lambda: single_image_camera(correlated(block_of(control=8, scale_bars=1))),
    "held images": lambda: held_images(block_of(station_sigma=1e-3)),
    "intersection": lambda: intersection(block_of()),
    "corrected": lambda: replace(correlated(block_of(control=5)), residuals="corrected"),
}


def setting(block, *, compiled, threads=2):
    """Normal equations and a state some tens of sigma from the block's values."""
    rejected = (np.arange(len(block.observations)) % 9 == 0) & (block.ray_count[block.observations.point] > 3)
    free = {c.id: tuple(c.estimate) for c in block.parametrised}
    system = assemble(block, AdjustmentOptions(), rejected, free)
    with pytest.MonkeyPatch.context() as patch:
        if not compiled:
            patch.setattr(normals_module.native, "module", lambda: None)
            patch.setattr(normals_module.native, "sensor_models", frozenset)
        normals = normals_module.Normals.of(system, threads)
    rng = np.random.default_rng(7)
    state = system.initial_state()
    state.xyz = state.xyz + np.where(system.held, 0, rng.normal(0, 3e-4, state.xyz.shape))
    state.centre = state.centre + rng.normal(0, 3e-4, state.centre.shape)
    state.rotation = rotation_from_vector(rng.normal(0, 1e-4, state.centre.shape)) @ state.rotation
    return normals, state


@pytest.fixture(params=BLOCKS)
def pair(request):
    block = BLOCKS[request.param]()
    (compiled, state), (twin, _) = (setting(block, compiled=c) for c in (True, False))
    assert type(twin.solver).__module__ == "raybundle.adjustment.system.normals_numpy"
    assert type(compiled.solver).__module__ != "raybundle.adjustment.system.normals_numpy"
    return compiled, twin, state


def blocks_agree(compiled, twin, a, b, tolerance):
    """Compare all blocks that the compiled layout has; the scale is that of the two nodes."""
    n = len(compiled.system.sizes)
    scale = [np.sqrt(np.diagonal(compiled.node_block(a, k, k))) for k in range(n)]
    count = 0
    for i in range(n):
        for j in range(i, n):
            if compiled.solver.block(i, j) >= 0:
                s = np.outer(scale[i], scale[j])
                difference = compiled.node_block(a, i, j) - twin.node_block(b, i, j)
                assert np.abs(difference / s).max(initial=0.0) < tolerance
                count += 1
    assert count >= n


@pytest.mark.parametrize(("damping", "huber"), [(0.0, 0.0), (1e-2, 0.0), (1e-3, 1.5)])
def test_reduce_and_step(pair, damping, huber):
    compiled, twin, state = pair
    a, b = (n.reduce(state, damping=damping, huber=huber) for n in (compiled, twin))
    assert a[0] == pytest.approx(b[0], rel=1e-12)
    assert a[1:] == b[1:]
    blocks_agree(compiled, twin, compiled.values, twin.values, 1e-11)
    close(compiled.right, twin.right, 1e-10)
    close(compiled.diagonal, twin.diagonal, 1e-12)
    a, b = (n.step(state, damping=damping, huber=huber) for n in (compiled, twin))
    close(a[0], b[0], 1e-7)
    close(a[1], b[1], 1e-7)
    assert a[2] == pytest.approx(b[2], rel=1e-9)


def test_huber_weights_change_the_cost(pair):
    compiled, twin, state = pair
    plain = compiled.cost(state)[0]
    robust, same = (n.cost(state, huber=1.0)[0] for n in (compiled, twin))
    assert robust == pytest.approx(same, rel=1e-12)
    assert robust < 0.9 * plain


def test_residuals(pair):
    compiled, twin, state = pair
    (v, flags), (w, others) = (n.residuals(state) for n in (compiled, twin))
    close(v, w, 1e-11)
    np.testing.assert_array_equal(flags, others)


def test_solve_with_right_sides_for_points(pair):
    compiled, twin, state = pair
    rng = np.random.default_rng(3)
    nodes = rng.normal(size=(len(compiled.right), 5))
    points = rng.normal(size=(len(state.xyz), 3, 5))
    points[~compiled.system.points_used] = 0
    found = []
    for normals in (compiled, twin):
        normals.reduce(state)
        assert normals.solver.factorise(normals.values, np.zeros(0)) == 0
        found.append(normals.solve(state, nodes, points))
    close(found[0][0], found[1][0], 1e-8)
    close(found[0][1], found[1][1], 1e-8)


def test_neither_solves_after_a_factorisation_that_stops(pair):
    """A factor that stood before is gone as well: the matrix it belongs to is another."""
    for normals in pair[:2]:
        normals.reduce(pair[2])
        assert normals.factorise() == 0
        good = normals.values.copy()
        for bad in (np.nan, 0.0):
            normals.values[:] = bad
            if not len(normals.right):  # every unknown is a point's
                continue
            assert normals.factorise() > 0
            for use in (lambda n=normals: n.solved(n.right), normals.selected_inverse, normals.least_share):
                with pytest.raises(ValueError, match="not factorised"):
                    use()
        normals.values[:] = good
        assert normals.factorise() == 0
        assert np.isfinite(normals.solved(normals.right)).all()


def test_what_cannot_be_factored_has_no_null_space_to_be_named(pair):
    for normals in pair[:2]:
        normals.reduce(pair[2])
        normals.values[:] = np.nan
        assert not len(defects.null_vectors(normals)[0])
        assert defects.null_space(normals) == ([], [])
        error = defects.no_convergence(normals, pair[2], 7, np.nan)
        assert error.undetermined == ()
        assert "after 7 iterations" in str(error)


@pytest.mark.parametrize("datum", [0, 3])
def test_inverse_and_statistics(pair, datum):
    compiled, twin, state = pair
    rng = np.random.default_rng(4)
    N, p = len(compiled.right), len(state.xyz)
    nodes, given = rng.normal(size=(N, datum)), rng.normal(size=(p, 3, datum))
    middle, gauge = rng.normal(size=(datum, datum)), rng.normal(size=(p, 3, datum))
    inverses, found = [], []
    for normals in (compiled, twin):
        normals.reduce(state)
        assert normals.solver.factorise(normals.values, np.zeros(0)) == 0
        inverse = np.zeros_like(normals.values)
        normals.solver.selected_inverse(inverse)
        inverses.append(inverse)
        found.append(
            normals.solver.statistics(*normals.arguments(state), 2, inverse, datum, nodes, given, gauge, middle)
        )
    blocks_agree(compiled, twin, *inverses, 1e-8)
    free = compiled.system.points_used[:, None] & ~compiled.system.held
    cofactors = [f[0] * free[:, :, None] * free[:, None] for f in found]
    assert np.abs(cofactors[0]).max() > 0
    close(*cofactors, 1e-8)
    close(found[0][1], found[1][1], 1e-8)
    close(found[0][2], found[1][2], 1e-8)
    close(found[0][3], found[1][3], 1e-8)


def test_the_diagonal_of_a_q_a_is_that_of_the_definition(pair):
    """Neither side is taken on trust: A Q A' from a dense design matrix of all unknowns."""
    _, twin, state = pair
    twin.reduce(state)
    assert twin.solver.factorise(twin.values, np.zeros(0)) == 0
    inverse = np.zeros_like(twin.values)
    twin.solver.selected_inverse(inverse)
    none = np.zeros(0)
    cofactor, hat, _, _ = twin.solver.statistics(*twin.arguments(state), 1, inverse, 0, none, none, none, none)
    A, free = whole_design(twin, state)
    Q = np.linalg.pinv(A.T @ A, rcond=1e-15, hermitian=True) if A.shape[1] else np.zeros((0, 0))
    m = len(twin.system.rows)
    D = A[: 2 * m].reshape(m, 2, -1)
    H = np.einsum("rak,kl,rbl->rab", D, Q, D)
    np.testing.assert_allclose(hat, np.stack([H[:, 0, 0], H[:, 1, 1], H[:, 0, 1]], axis=1), atol=1e-6)
    assert hat[:, :2].sum() > 0.1 * len(free)
    points = np.flatnonzero(twin.system.points_used & (twin.system.point_node < 0) & ~twin.system.held.any(axis=1))
    where = {int(p): k for k, p in enumerate(free) if p >= 0}
    mine = np.stack([Q[where[3 * p] : where[3 * p] + 3, where[3 * p] : where[3 * p] + 3] for p in points])
    close(cofactor[points], mine, 1e-6)


def whole_design(normals, state):
    """A of all observations by differences of their residuals, and of each column 3 point + axis, -1 for nodes."""
    system = normals.system
    zero, still = np.zeros(len(normals.right)), np.zeros_like(state.xyz)

    retained = np.flatnonzero(system.point_node >= 0)
    at = system.offsets[system.point_node[retained]][:, None] + np.arange(3)

    def residuals(step, points):
        points = points.copy()
        points[retained] = step[at]
        moved = system.updated(state, step, points)
        prior = np.sqrt(normals.solver.weight) * (moved.xyz - normals.solver.value)
        return np.concatenate([normals.residuals(moved)[0].ravel(), normals.extra(moved).residual, prior.ravel()])

    columns, free = [], []
    for k in np.flatnonzero(normals.diagonal > 1.0):
        step = zero.copy()
        step[k] = 3e-4 / np.sqrt(normals.diagonal[k]) * 100
        columns.append((residuals(step, still) - residuals(-step, still)) / (2 * step[k]))
        free.append(-1)
    for p, axis in np.argwhere(system.points_used[:, None] & (system.point_node < 0)[:, None] & ~system.held):
        points = still.copy()
        points[p, axis] = 1e-5
        columns.append((residuals(zero, points) - residuals(zero, -points)) / 2e-5)
        free.append(3 * p + axis)
    return np.stack(columns, axis=1), np.array(free)


def turned_away(block, count=3):
    """The block with some object points mirrored at the first image's projection centre."""
    image, point = block.observations.image, block.observations.point
    chosen = np.unique(point[image == 0])[:count]
    xyz = block.points.xyz.copy()
    xyz[chosen] = 2 * block.images.centre[0] - xyz[chosen]
    return replace(block, points=replace(block.points, xyz=xyz)), chosen


@pytest.mark.parametrize("model", sorted(sensor_models))
def test_points_behind_are_flagged_as_the_model_says(model):
    block, chosen = turned_away(block_of(model))
    (compiled, state), (twin, _) = (setting(block, compiled=c) for c in (True, False))
    (v, flags), (w, others) = (n.residuals(state) for n in (compiled, twin))
    np.testing.assert_array_equal(flags, others)
    shown = flags == 0
    close(v[shown], w[shown], 1e-10)
    o = block.observations
    mirrored = (o.image[compiled.system.rows] == 0) & np.isin(o.point[compiled.system.rows], chosen)
    assert mirrored.any()
    if not any(model.startswith(m.name) and m.all_round for m in sensor_models.values()):
        assert (flags[mirrored] & 1 == 1).all()
    assert compiled.cost(state)[1] == twin.cost(state)[1] == np.count_nonzero(flags & 1)


def test_points_without_a_projection_are_flagged_one_by_one():
    block = block_of()
    camera = replace(block.cameras[0], values={**block.cameras[0].values, "K1": -2.2e-3, "K2": 0.0, "K3": 0.0})
    block = replace(block, cameras=(camera,))
    (compiled, state), (twin, _) = (setting(block, compiled=c) for c in (True, False))
    (v, flags), (w, others) = (n.residuals(state) for n in (compiled, twin))
    lost = (flags & 2) > 0
    assert 0 < lost.sum() < len(lost)
    np.testing.assert_array_equal(flags, others)
    close(v[~lost], w[~lost], 1e-9)


def test_a_model_of_the_users_own_says_what_is_behind():
    mine = own_model()
    try:
        block, _ = turned_away(block_of())
        own = block.with_cameras(replace(block.cameras[0], model=mine.name))
        (compiled, state), (external, _) = (setting(b, compiled=True) for b in (block, own))
        assert external.external.all()
        (v, flags), (w, others) = (n.residuals(state) for n in (compiled, external))
        assert (flags & 1).any()
        np.testing.assert_array_equal(flags, others)
        close(v, w, 1e-10)
    finally:
        del sensor_models[mine.name]


def test_a_point_without_depth_is_named_by_both():
    block = block_of(control=5)
    o = block.observations
    tie = next(p for p in range(len(block.points)) if not block.points.is_control[p].any() and block.ray_count[p] > 2)
    keep = np.ones(len(o), bool)
    keep[np.flatnonzero(o.point == tie)[1:]] = False
    fewer = replace(o, image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep], cov_px2=o.cov_px2[keep])
    block = replace(block, observations=fewer)
    (compiled, state), (twin, _) = (setting(block, compiled=c) for c in (True, False))
    weak = [n.reduce(state)[2] for n in (compiled, twin)]
    assert sorted(weak[0]) == sorted(weak[1])
    assert tie in weak[0]
