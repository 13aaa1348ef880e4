"""Matching along strips: only what lies in the strip is a candidate, and each must be the other's nearest."""

import numpy as np
from scipy.spatial import KDTree

from raybundle.matching.strips import Strips, agreement, match_strips


def strips(xy, along, tolerance=5.0):
    return Strips(start=xy - along, end=xy + along, tolerance_px=tolerance)


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def test_pairs_are_those_of_the_definition():
    rng = np.random.default_rng(1)
    a, b = rng.uniform(0, 200, (60, 2)), rng.uniform(0, 200, (300, 2))
    s = strips(a, np.array([30.0, 12.0]), 7.0)
    row, point = s.pairs(np.arange(60), KDTree(b), b)
    u = np.array([30.0, 12.0]) / np.hypot(30, 12)
    along = (b[None] - a[:, None]) @ u
    across = (b[None] - a[:, None]) @ [-u[1], u[0]]
    expected = np.argwhere((np.abs(across) <= 7) & (np.abs(along) <= np.hypot(30, 12) + 7))
    assert sorted(map(list, zip(row.tolist(), point.tolist(), strict=True))) == sorted(expected.tolist())


def test_equal_descriptions_are_told_apart_by_their_place():
    """A row of equal windows: by appearance nothing is sure, along the strips each has one candidate."""
    vectors = unit(np.ones((5, 16)))
    xy1 = np.column_stack([np.arange(5) * 40.0, np.full(5, 50.0)])
    xy2 = xy1 + np.array([10.0, 3.0])
    there, back = strips(xy1, np.array([12.0, 0])), strips(xy2, np.array([12.0, 0]))
    assert match_strips(vectors, vectors, xy1, xy2, there, back).tolist() == [[k, k] for k in range(5)]
    wide, wide_back = strips(xy1, np.array([90.0, 0])), strips(xy2, np.array([90.0, 0]))
    assert len(match_strips(vectors, vectors, xy1, xy2, wide, wide_back)) == 0


def test_rows_without_a_strip_have_no_match():
    vectors = unit(np.random.default_rng(3).normal(size=(4, 16)))
    xy = np.arange(8.0).reshape(4, 2) * 30
    there = Strips(start=np.full((4, 2), np.nan), end=xy, tolerance_px=5.0)
    assert len(match_strips(vectors, vectors, xy, xy, there, strips(xy, np.array([9.0, 0])))) == 0
    assert len(match_strips(vectors, vectors[:0], xy, xy[:0], there, strips(xy[:0], np.array([9.0, 0])))) == 0


def test_agreement_finds_the_densest_place():
    rng = np.random.default_rng(4)
    values = np.concatenate([rng.normal(7.3, 0.2, 50), rng.uniform(-60, 60, 100), [np.nan]])
    found = agreement(values, 2.0)
    assert abs(found.value - 7.3) < 0.15
    assert 0.1 < found.scatter < 0.5
    assert 45 <= found.inside.sum() <= 65
    assert not found.inside[-1]
    assert np.isnan(agreement(np.array([np.nan]), 1.0).value)
