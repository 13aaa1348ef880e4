"""Nearest neighbours: the compiled search, its NumPy twin, and what counts as a match."""

import numpy as np
import pytest

from raybundle.matching.descriptors import best_matches, best_matches_twin, mutual_matches


def unit(rng, n, k=128):
    v = rng.random((n, k), dtype=np.float32)
    return v / np.linalg.norm(v, axis=1, keepdims=True)


@pytest.mark.parametrize(("n", "m"), [(1, 1), (7, 65), (200, 131), (65, 3)])
def test_compiled_search_equals_its_twin(n, m):
    rng = np.random.default_rng(n)
    a, b = unit(rng, n), unit(rng, m)
    found, twin = best_matches(a, b), best_matches_twin(a, b)
    assert (np.asarray(found[0]) == twin[0]).all()
    np.testing.assert_allclose(found[1], twin[1], rtol=1e-5)
    if m > 1:
        np.testing.assert_allclose(found[2], twin[2], rtol=1e-5)
    assert (np.asarray(found[3]) == twin[3]).all()


def test_matches_are_mutual_and_unique():
    rng = np.random.default_rng(1)
    a = unit(rng, 60)
    b = np.vstack([a[:40] + 0.01 * rng.random((40, 128), dtype=np.float32), unit(rng, 30)])
    b /= np.linalg.norm(b, axis=1, keepdims=True)
    b = np.vstack([b, b[:5]])  # the first five have a double: no match is clearly the nearest
    matches, distance = mutual_matches(a, b.astype(np.float32))
    assert {tuple(m) for m in matches.tolist()} >= {(i, i) for i in range(5, 40)}
    assert not set(range(5)) & set(matches[:, 0].tolist())
    assert (distance >= 0).all()


def test_nothing_matches_nothing():
    rng = np.random.default_rng(1)
    assert len(mutual_matches(unit(rng, 1), unit(rng, 5))[0]) == 0


@pytest.mark.parametrize(("n", "m", "k"), [(1, 1, 4), (7, 65, 128), (200, 131, 64), (65, 3, 128)])
def test_search_of_bytes_equals_that_of_their_directions(n, m, k):
    rng = np.random.default_rng(n)
    a, b = (rng.integers(0, 256, (rows, k)).astype(np.uint8) for rows in (n, m))
    a[0] = b[-1] = 255
    found, twin = best_matches(a, b), best_matches_twin(a, b)
    assert (np.asarray(found[0]) == twin[0]).all()
    np.testing.assert_allclose(found[1], twin[1], rtol=1e-5)
    if m > 1:
        np.testing.assert_allclose(found[2], twin[2], rtol=1e-5)
    assert (np.asarray(found[3]) == twin[3]).all()
