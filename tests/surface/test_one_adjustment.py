"""Differences of two surfaces of one adjustment: what its orientation does to both alike is in none of them."""

from dataclasses import replace

import numpy as np
import pytest

from raybundle.surfaces.heights.resampling import difference
from tests.surface.height_models import made

SHAPE = (64, 96)


def of_one(rng, shape=SHAPE):
    """Two models of one adjustment: a common error of 5 mm, and one of 1 mm that the second alone has."""
    a, b = (made(np.zeros(shape), common=5e-3, rng=rng) for _ in range(2))
    blocks = a.moved.shape[:2]
    own = np.full((*blocks, 1, 1), 1e-3, np.float32)
    both = [
        replace(m, moved=np.concatenate([m.moved, k * own], axis=3), errors="one", adjustment="one")
        for m, k in ((a, 0), (b, 1))
    ]
    return both[0], both[1]


def test_what_moves_both_alike_cancels_and_the_rest_is_stated():
    rng = np.random.default_rng(3)
    a, b = of_one(rng)
    together = difference(a, b)
    apart = difference(replace(a, errors="another"), b)
    mean = np.full(SHAPE, 1 / np.prod(SHAPE))
    assert together.sum_of(mean).orientation == pytest.approx(1e-3, rel=1e-5)
    assert apart.sum_of(mean).orientation == pytest.approx(np.sqrt(2 * 5e-3**2 + 1e-3**2), rel=1e-3)
    assert together.sum_of(mean).local == pytest.approx(apart.sum_of(mean).local)
    assert np.allclose(together.heights.orientation, 1e-3, rtol=1e-5)
    assert together.errors == "one"
    assert apart.errors == ""
    # models that do not know of their adjustment are independent
    assert difference(replace(a, errors=""), replace(b, errors="")).moved.shape[3] == 2 * a.moved.shape[3]


def test_the_stated_error_of_a_mean_difference_is_true():
    rng = np.random.default_rng(4)
    chi2 = []
    for _ in range(200):
        a, b = of_one(rng, (32, 32))
        errors = rng.normal(size=a.moved.shape[3])
        error = [float((m.moved @ errors)[0, 0, 0]) for m in (a, b)]
        # the noise of a mean of a thousand cells is far smaller
        moved = [
            replace(m, heights=replace(m.heights, height=np.full((32, 32), e, np.float32)))
            for m, e in zip((a, b), error, strict=True)
        ]
        found = difference(*moved).sum_of(np.full((32, 32), 1 / 1024))
        chi2.append((found.value / found.sigma) ** 2)
    assert 0.75 < np.mean(chi2) < 1.25
