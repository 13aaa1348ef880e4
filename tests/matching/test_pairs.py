"""The choice of pairs in large sets."""

import numpy as np
import pytest

from raybundle.matching.pairs import ALL, SEQUENCE, choose_pairs, codebook, signature


@pytest.mark.parametrize("n", [0, 1, 2, ALL])
def test_small_sets_are_matched_all_with_all(n):
    pairs = choose_pairs(n)
    assert len(pairs) == len(set(pairs)) == n * (n - 1) // 2
    assert all(i < j for i, j in pairs)


def test_of_a_large_set_all_pairs_only_on_request():
    n = ALL + 1
    assert len(choose_pairs(n, everything=True)) == n * (n - 1) // 2
    assert choose_pairs(n) == [(i, j) for i in range(n) for j in range(i + 1, min(i + 1 + SEQUENCE, n))]


def test_strips_are_tied_by_position_and_unknown_positions_do_no_harm():
    along, strip = np.meshgrid(np.arange(20.0), np.arange(5.0))
    positions = np.stack([10 * along.ravel(), 30 * strip.ravel(), np.full(100, 80.0)], axis=1)
    positions[7] = np.nan
    pairs = set(choose_pairs(100, positions=positions))
    assert {(k, k + 20) for k in range(80) if k != 7} <= pairs
    assert len(pairs) < 100 * 99 / 4
    assert (7, 8) in pairs
    assert (7, 27) not in pairs


def contents(seed, n=200, d=16, places=10):
    """Descriptor vectors of pictures; every tenth shows the same place."""
    rng = np.random.default_rng(seed)
    things = rng.normal(size=(places, n, d))
    pictures = [things[k % places] + rng.normal(0, 0.15, (n, d)) for k in range(80)]
    return [(v / np.linalg.norm(v, axis=1, keepdims=True)).astype(np.float32) for v in pictures]


def test_pictures_of_one_place_have_like_signatures_and_are_paired():
    vectors = contents(1)
    words = codebook(vectors)
    s = np.stack([signature(v, words) for v in vectors])
    np.testing.assert_allclose(np.linalg.norm(s, axis=1), 1, atol=1e-5)
    likeness = s @ s.T
    same = (np.arange(80)[:, None] - np.arange(80)) % 10 == 0
    other = likeness[~same]
    assert likeness[same].min() > other.max()
    pairs = set(choose_pairs(80, signatures=s))
    assert {(k, k + 70) for k in range(10)} <= pairs


def test_the_codebook_is_the_same_every_time():
    vectors = contents(2)
    np.testing.assert_array_equal(codebook(vectors), codebook(vectors))


def test_a_picture_without_features_has_an_empty_signature():
    words = codebook(contents(3))
    s = signature(np.zeros((0, 16), np.float32), words)
    assert not s.any()
    assert np.isfinite(s).all()
