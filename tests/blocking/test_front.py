"""Elimination of a front, against the inverse of the whole matrix."""

import numpy as np
import pytest

from raybundle.blocking.front import (
    Equations,
    Front,
    Placement,
    cofactors,
    eliminate,
    forward,
    packed,
    packed_at,
    solved,
    unpacked,
)


def equations(n, o, seed=1):
    """Equations of n unknowns, o of them own, and their matrix and right side."""
    rng = np.random.default_rng(seed)
    J = rng.standard_normal((3 * n, n))
    N, right = J.T @ J, rng.standard_normal(n)
    e = Equations(
        np.asfortranarray(np.tril(N[:o, :o])), np.asfortranarray(N[o:, :o]), np.asfortranarray(np.tril(N[o:, o:])),
        right.copy(), np.diagonal(N).copy(),
    )  # fmt: skip
    return e, N, right


@pytest.mark.parametrize(("n", "o"), [(7, 4), (5, 5), (6, 0)])
def test_two_steps_are_one(n, o):
    e, N, right = equations(n, o)
    found = eliminate(e, 0.0)
    assert found.failed < 0
    rest = np.tril(found.reduced) + np.tril(found.reduced, -1).T
    whole = np.linalg.solve(N, right)
    outer = np.linalg.solve(rest, found.right) if n > o else np.zeros(0)
    assert np.allclose(outer, whole[o:], rtol=1e-12, atol=0)
    assert np.allclose(solved(found.L, found.V, found.y, outer), whole[:o], rtol=1e-12, atol=0)
    Q = np.linalg.inv(N)
    mine = np.tril(cofactors(found.L, found.V, np.asfortranarray(np.tril(Q[o:, o:]))))
    assert np.allclose(mine, np.tril(Q), rtol=1e-11, atol=1e-14)
    two = np.column_stack([right, 2 * right])
    assert np.allclose(forward(found.L, two[:o])[:, 0], found.y, rtol=1e-12, atol=1e-14)


def test_damping_is_a_share_of_the_diagonal_and_an_open_unknown_is_named():
    e, N, _ = equations(6, 3)
    damped = N + 0.1 * np.diag(np.diagonal(N) * (np.arange(6) < 3))
    L = eliminate(e, 0.1).L
    L = np.tril(L)
    assert np.allclose(L @ L.T, damped[:3, :3])
    e, N, _ = equations(6, 3)
    e.A[2, :] = 0.0
    assert eliminate(e, 0.0).failed == 2
    e, N, _ = equations(6, 3)
    e.A[1, 1] = e.A[1, 0] ** 2 / e.A[0, 0] * (1 - 1e-9)
    assert eliminate(e, 0.0).failed == 1


def test_a_child_is_added_where_it_belongs():
    sizes = np.array([2, 3, 1, 2])
    front = Front(np.array([1, 3]), np.array([0, 2]), sizes)
    assert (front.columns, front.size) == (5, 8)
    at = front.unknowns(np.array([3, 0, 2]))
    assert at.tolist() == [3, 4, 5, 6, 7]
    e = Equations.empty(front)
    child = np.tril(np.arange(25.0).reshape(5, 5))
    e.add_reduced(at, packed(child))
    whole = np.zeros((8, 8))
    whole[np.ix_(at, at)] = child
    assert np.array_equal(e.A, whole[:5, :5])
    assert np.array_equal(e.B, whole[5:, :5])
    assert np.array_equal(e.C, whole[5:, 5:])


@pytest.mark.parametrize("k", [0, 1, 7, 200])
def test_a_packed_triangle_is_the_lower_one(k):
    rng = np.random.default_rng(k)
    whole = rng.standard_normal((k + 3, k + 3))
    at = np.sort(rng.choice(k + 3, k, replace=False))
    mine = np.asfortranarray(whole[np.ix_(at, at)])
    triangle = packed(mine)
    assert triangle.shape == (k * (k + 1) // 2,)
    assert np.array_equal(np.tril(unpacked(triangle)), np.tril(mine))
    assert np.array_equal(packed_at(whole, at), triangle)


def test_single_elements_stand_where_they_belong():
    front = Front(np.array([1, 3]), np.array([0, 2]), np.array([2, 3, 1, 2]))
    rng = np.random.default_rng(4)
    whole = np.tril(rng.standard_normal((8, 8)))
    row, col = np.nonzero(whole)
    order = rng.permutation(len(row))
    given = np.append(np.nan, whole[row[order], col[order]])  # the first one is not asked for
    e = Equations.empty(front)
    for _ in range(2):
        e.add(Placement.in_front(front, row[order], col[order], np.arange(1, len(given))), given)
    assert np.array_equal(e.A, 2 * whole[:5, :5])
    assert np.array_equal(e.B, 2 * whole[5:, :5])
    assert np.array_equal(e.C, 2 * whole[5:, 5:])
