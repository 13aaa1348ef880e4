"""A network in parts is the network in one piece: step, cofactors, redundancy numbers, tests."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.engine import adjust_block, free_parameters
from raybundle.adjustment.evaluation.queries import covariance
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.precision import cofactors
from raybundle.adjustment.system.factoring import in_one_piece, made_by
from raybundle.block.select import with_rows
from raybundle.blocking import sweeps
from raybundle.blocking.front import packed, unpacked
from raybundle.blocking.normals_in_parts import in_parts
from raybundle.errors import NotSolvable
from tests.blocking.networks import flight

OPTIONS = AdjustmentOptions(jobs=1)


def per_image(block):
    """Every image with a camera constant of its own."""
    return replace(block, cameras=(replace(block.cameras[0], per_image=("c",)),))


def held(block):
    """Three images held, and control that is held."""
    images = np.arange(len(block.images)) < 3
    sigma = np.where(block.points.is_control, 0.0, block.points.sigma)
    return replace(
        block, images=replace(block.images, held=images), points=replace(block.points, sigma=sigma), tables={},
        instruments=(),
    )  # fmt: skip


NETWORKS = {
    "everything": (flight, OPTIONS),
    "inner constraints": (lambda: flight(control=0, observed=False), OPTIONS),
    "free, no scale": (lambda: flight(control=0, observed=False, bar=False), OPTIONS),
    "minimal": (lambda: flight(control=0, observed=False), replace(OPTIONS, datum="minimal")),
    "some points": (lambda: flight(observed=False), replace(OPTIONS, datum="inner", datum_over="good")),
    "interior of each image": (lambda: per_image(flight()), OPTIONS),
    "held": (lambda: held(flight()), OPTIONS),
    "robust start": (flight, replace(OPTIONS, robust_start=True)),
}


def apart(a, b, of=None):
    """Largest difference of arrays, in units of `of`; where one has no number the other has none."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    assert np.array_equal(np.isnan(a), np.isnan(b))
    if not a.size or np.isnan(a).all():
        return 0.0
    unit = np.nanmax(np.abs(a)) if of is None else of
    return float(np.nanmax(np.abs(a - b) / unit))


def made_as(factoring, adjusting, block, options):
    with made_by(factoring):
        return adjusting(block, options)


def by_parts(adjusting, block, options):
    return made_as(in_parts(60), adjusting, block, options)


def stds(cofactors):
    """Roots of the diagonals (n, k)."""
    return np.sqrt(np.diagonal(np.asarray(cofactors, float), axis1=-2, axis2=-1))


@pytest.mark.parametrize("name", NETWORKS)
def test_a_network_in_parts_is_the_one_piece(name):
    make, options = NETWORKS[name]
    block = make()
    one, parts = adjust_block(block, options), by_parts(adjust_block, block, options)
    tree = parts.handle.work.normals.parts.network.tree
    assert sum(not c for c in tree.children) >= 3
    assert (parts.iterations, parts.redundancy, parts.datum) == (one.iterations, one.redundancy, one.datum)
    std = one.precision.object_point_std
    assert apart(one.adjusted.points.xyz, parts.adjusted.points.xyz, np.where(std > 0, std, 1.0)) < 1e-4
    assert apart(stds(one.precision.object_points), stds(parts.precision.object_points)) < 1e-7
    assert apart(stds(one.precision.images), stds(parts.precision.images)) < 1e-7
    assert set(one.precision.interior) == set(parts.precision.interior)
    for key, Q in one.precision.interior.items():
        assert apart(Q, parts.precision.interior[key]) < 1e-7, key
        assert apart(one.precision.interior_exterior[key], parts.precision.interior_exterior[key]) < 1e-6, key
    ours, theirs = parts.image_observations, one.image_observations
    # of what has hardly any redundancy, tests and effects are rounding by the root of it
    told = np.where(theirs.redundancy > 0.01, 1.0, np.nan)
    assert apart(theirs.w * told, ours.w * told, 1.0) < 1e-4
    assert apart(theirs.external * told, ours.external * told) < 1e-4
    assert [g.kind for g in one.groups] == [g.kind for g in parts.groups]
    for a, b in zip(one.groups, parts.groups, strict=True):
        assert apart(a.redundancy, b.redundancy, 1.0) < 1e-8, a.kind
    assert [n.code for n in one.notices] == [n.code for n in parts.notices]


@pytest.mark.parametrize("name", NETWORKS)
def test_at_the_same_state_step_cofactors_and_redundancy_are_those_of_one_piece(name):
    make, options = NETWORKS[name]
    block = make()
    result = adjust_block(block, options)
    work, free = result.handle.work, {c.id: free_parameters(c) for c in block.parametrised}
    one, state = work.normals, work.state
    parts = in_parts(60)(work.system, options, free, np.zeros(len(block.observations), bool))
    first, second = one.reduce(state, damping=1e-6), parts.reduce(state, damping=1e-6)
    assert apart(first[0], second[0]) < 1e-12
    (a, _), (b, _) = one.trial(state, damping=1e-6), parts.trial(state, damping=1e-6)
    moved = [np.abs(s.xyz - state.xyz).max() for s in (a, b)]
    assert apart(a.xyz, b.xyz, max(*moved, np.ptp(state.xyz) * 1e-6)) < 1e-9
    for normals in (one, parts):
        normals.reduce(state)
        assert not normals.factorise()
    theirs, ours = cofactors(one, state, work.datum), cofactors(parts, state, work.datum)
    assert apart(theirs.points, ours.points) < 1e-9
    assert apart(theirs.hat, ours.hat, 1.0) < 1e-10
    for n in range(len(work.system.sizes)):
        a, b = one.node_block(theirs.inverse, n, n), parts.node_block(ours.inverse, n, n)
        size = np.sqrt(np.outer(np.diagonal(a), np.diagonal(a)))
        assert apart(a, b, np.where(size > 0, size, 1.0)) < 1e-9, n
    if theirs.transformation is not None:
        assert apart(theirs.transformation.nodes_h, ours.transformation.nodes_h) < 1e-9
        assert apart(theirs.transformation.inner, ours.transformation.inner) < 1e-9


def test_a_separator_block_that_is_dropped_is_noticed(monkeypatch):
    block = flight()
    one = adjust_block(block, OPTIONS)
    whole, dropped = sweeps.up, list[int]()

    def up(network, t, work, state, how, outside, children):
        found = whole(network, t, work, state, how, outside, children)
        if not network.tree.children[t]:
            lower = unpacked(found["reduced"])
            lower[6:12, :6] = 0.0
            found["reduced"] = packed(lower)
            dropped.append(t)
        return found

    monkeypatch.setattr(sweeps, "up", up)
    parts = by_parts(adjust_block, block, OPTIONS)
    assert dropped
    assert apart(stds(one.precision.images), stds(parts.precision.images)) > 1e-6
    assert np.abs(one.image_observations.redundancy - parts.image_observations.redundancy).max() > 1e-6


def test_questions_are_answered_from_the_parts():
    block = flight()
    names = f"point:{block.points.ids[3]}", f"point:{block.points.ids[150]}", f"image:{block.images.ids[2]}"
    one = covariance(adjust_block(block, OPTIONS), names)
    first = by_parts(adjust_block, block, OPTIONS)
    others = [by_parts(adjust_block, block, OPTIONS) for _ in range(5)]
    for result in (first, others[-1]):
        assert apart(one.matrix, covariance(result, names).matrix) < 1e-9


def test_what_is_not_determined_is_named_as_in_one_piece():
    block = flight(control=0, observed=False, bar=False)
    camera = replace(block.cameras[0], estimate=("c", "x0", "y0", "affinity", "shear", "K1", "K2", "K3"))
    level = replace(block.points, xyz=np.where([True, True, False], block.points.xyz, 0.0))
    block = replace(block, cameras=(camera,), points=level)
    errors = []
    for factoring in (in_one_piece, in_parts(60)):
        with pytest.raises(NotSolvable) as error:
            made_as(factoring, adjust_block, thinned(block), OPTIONS)
        errors.append(str(error.value).splitlines()[0])
    assert errors[0] == errors[1]


def thinned(block):
    """Two rays for each point at most, and few of them: what is not determined."""
    o = block.observations
    order = np.lexsort((o.image, o.point))
    first = np.searchsorted(o.point[order], o.point[order])
    return with_rows(block, np.isin(np.arange(len(o)), order[np.arange(len(o)) - first < 2]))


def test_blunders_are_found_and_parameters_chosen_alike():
    block = flight(interior="exact")
    o, rng = block.observations, np.random.default_rng(5)
    wrong = rng.choice(len(o), 6, replace=False)
    xy = o.xy_px.copy()
    xy[wrong] += rng.choice([-25.0, 25.0], (6, 2))
    camera = replace(block.cameras[0], estimate="auto")
    block = replace(block, cameras=(camera,), observations=replace(o, xy_px=xy))
    options = replace(OPTIONS, reject="snooping")
    one, parts = decide(block, options), by_parts(decide, block, options)
    reasons = [[r and r.kind for r in a.image_observations.rejected] for a in (one, parts)]
    assert reasons[0] == reasons[1]
    assert sum(r is not None for r in reasons[1]) >= 4
    assert [i.parameters.keys() for i in one.interior] == [i.parameters.keys() for i in parts.interior]
    assert {k: p.status for i in one.interior for k, p in i.parameters.items()} == {
        k: p.status for i in parts.interior for k, p in i.parameters.items()
    }
    assert parts.sigma0 == pytest.approx(one.sigma0, rel=1e-9)
