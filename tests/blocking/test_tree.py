"""Where a network is cut: every observation on one path, separators as small as can be."""

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import csr_matrix

from raybundle.blocking.graph import meeting
from raybundle.blocking.tree import _cover, dissect


def graph_of(count, edges):
    """The symmetric graph of edges."""
    a, b = np.array(sorted(edges), int).reshape(-1, 2).T
    ones = np.ones(2 * len(a), np.int8)
    return csr_matrix((ones, (np.concatenate([a, b]), np.concatenate([b, a]))), shape=(count, count))


@given(st.sets(st.tuples(st.integers(0, 4), st.integers(5, 9)), min_size=1, max_size=14))
@settings(max_examples=60, deadline=None)
def test_a_separator_is_a_smallest_set_that_touches_every_cut_edge(edges):
    side = np.arange(10) >= 5
    found = set(_cover(graph_of(10, edges), side).tolist())
    assert all(a in found or b in found for a, b in edges)
    every = (set(c) for k in range(11) for c in combinations(range(10), k))
    assert len(found) == len(next(c for c in every if all(a in c or b in c for a, b in edges)))


def grid(n):
    """Nodes of a grid that meet their neighbours, and one that meets all; rows of three in a line."""
    at = np.arange(n * n).reshape(n, n)
    rows = [at[i, j : j + 3] for i in range(n) for j in range(n - 2)]
    rows += [at[i : i + 3, j] for i in range(n - 2) for j in range(n)]
    row = np.repeat(np.arange(len(rows)), 4)
    node = np.concatenate([np.append(r, n * n) for r in rows])
    places = np.stack(np.unravel_index(np.arange(n * n), (n, n)), axis=1).astype(float)
    return row, node, np.vstack([places, [np.nan, np.nan]])


@pytest.mark.parametrize("most", [3, 8, 30, 1000])
def test_what_stands_in_one_row_lies_on_one_path(most):
    row, node, places = grid(12)
    count = len(places)
    tree = dissect(meeting([(row, node)], count, np.zeros((0, 2), int)), np.ones(count, int), places, most)
    assert np.array_equal(np.sort(np.concatenate(tree.own)), np.arange(count))
    above, home = np.eye(len(tree), dtype=bool), tree.home
    for t in range(len(tree) - 2, -1, -1):
        above[t] |= above[tree.parent[t]]
    rows, homes = tree.homes(row, node)
    assert np.array_equal(rows, np.unique(row))
    for r, t in zip(rows, homes, strict=True):
        assert above[t, home[node[row == r]]].all()
    leaves = [len(own) for own, c in zip(tree.own, tree.children, strict=True) if not c]
    # of a small part a grid's separator is most, and what cannot be cut with gain stays
    assert max(leaves) <= max(most, 24)
    assert (len(leaves) > 1) == (most < count)
    assert home[-1] == len(tree) - 1, "what meets all others stands at the root"


def test_pieces_of_the_incidences_give_the_same_graph():
    row, node, places = grid(7)
    none = np.zeros((0, 2), int)
    whole = meeting([(row, node)], len(places), none)
    half = np.searchsorted(row, row[len(row) // 2])
    parts = meeting([(row[:half], node[:half]), (row[half:], node[half:])], len(places), none)
    assert (whole != parts).nnz == 0
    more = meeting([(row, node)], len(places), np.array([[0, 48], [3, 3]]))
    assert more[0, 48]
    assert more[48, 0]
    assert not more.diagonal().any()


def test_a_graph_that_cannot_be_cut_is_one_leaf():
    every = set(combinations(range(9), 2))
    assert len(dissect(graph_of(9, every), np.full(9, 6), np.random.default_rng(1).random((9, 3)), 12)) == 1
