"""Groups of images: best divisions by trying all, and their probability by drawing."""

from itertools import combinations

import numpy as np
import pytest

from raybundle.adjustment.evaluation.image_interiors import (
    FEWEST,
    LEVEL,
    OwnInteriors,
    _divided,
    _in_two,
    groups_of,
)
from raybundle.adjustment.statistics.fields import OWN


def within(parts):
    return sum(((p - p.mean()) ** 2).sum() for p in parts)


@pytest.mark.parametrize("seed", range(3))
def test_sorted_values_are_divided_best(seed):
    rng = np.random.default_rng(seed)
    values = np.sort(rng.normal(size=(4, 3 * FEWEST + 4)), axis=1)
    shares, cuts = _divided(values, 3)
    for row, v in enumerate(values):
        whole = within([v])
        for groups in (2, 3):
            tried = [c for c in combinations(range(1, len(v)), groups - 1) if min(np.diff([0, *c, len(v)])) >= FEWEST]
            best = min(tried, key=lambda c: within(np.split(v, c)))
            assert shares[groups - 2, row] == pytest.approx(within(np.split(v, best)) / whole)
            assert tuple(cuts[groups - 2][row]) == best


@pytest.mark.parametrize("seed", range(3))
def test_the_best_division_into_two_has_the_least_ratio_of_determinants(seed):
    """Wilks: det W / det T of the scatter within and of all, where groups are as clear as they are looked for."""
    rng = np.random.default_rng(seed)
    n, k = 2 * FEWEST + 3, 2
    x = rng.normal(size=(n, k)) @ [[1.0, 0.6], [0.0, 0.8]]
    x[: FEWEST + 1] += [4.0, -3.0]
    order = rng.permutation(n)
    x = x[order]
    ratio, side = _in_two(x[None])
    scatter = np.linalg.det(np.cov(x.T, bias=True) * n)

    def wilks(mask):
        return np.linalg.det(sum(np.cov(x[m].T, bias=True) * m.sum() for m in (mask, ~mask))) / scatter

    masks = [np.isin(np.arange(n), c) for size in range(FEWEST, n - FEWEST + 1) for c in combinations(range(n), size)]
    best = min(masks, key=wilks)
    assert ratio[0] == pytest.approx(wilks(best), rel=1e-6)
    assert ratio[0] == pytest.approx(wilks(side[0]), rel=1e-6)
    assert set(np.flatnonzero(side[0])) in (set(np.flatnonzero(best)), set(np.flatnonzero(~best)))


def own(difference, sigma=1.0):
    n, k = difference.shape
    return OwnInteriors(images=np.arange(n) * 2 + 1, difference_px=difference, covariance=np.eye(n * k) * sigma**2)


def test_groups_are_stated_with_their_means_and_their_scatter():
    rng = np.random.default_rng(1)
    n = 3 * FEWEST
    x = rng.normal(size=(n, len(OWN)))
    x[:FEWEST, 2] += 14.0
    x[FEWEST : 2 * FEWEST, 2] -= 11.0
    found = groups_of(own(x))
    parts = [np.arange(FEWEST, 2 * FEWEST), np.arange(2 * FEWEST, n), np.arange(FEWEST)]
    assert found.symbol == OWN[2]
    assert [i.tolist() for i in found.images] == [(2 * p + 1).tolist() for p in parts]
    np.testing.assert_allclose(found.means_px, [x[p, 2].mean() for p in parts])
    assert found.scatter_px == pytest.approx(np.sqrt(within([x[p, 2] for p in parts]) / (n - 3)))
    assert found.probability < LEVEL


def test_without_groups_none_are_found_at_the_stated_rate():
    """Of 6 sets at one percent hardly one."""
    sets = [np.random.default_rng(seed).normal(size=(2 * FEWEST + 2, len(OWN))) for seed in range(6)]
    assert sum(groups_of(own(x)) is not None for x in sets) < 2
    assert all(groups_of(own(5 * x, 5.0)) is None for x in sets[:2] if groups_of(own(x)) is None)
