"""Lengths against known ones: errors, their standard deviations with all correlations, and what is allowed."""

from itertools import combinations

import numpy as np
import pytest
from tests.metrology.measured_sets import TURN, drawn, free_covariance, places, root_of

from raybundle.errors import InputError
from raybundle.metrology.lengths import KnownLength, length_test
from raybundle.metrology.point_set import PointSet

XYZ = places(8)
C = free_covariance(XYZ, np.random.default_rng(0))
ROOT = root_of(C)


def measured(rng, **more):
    return drawn("field", XYZ, C, ROOT, rng, TURN, (1, 2, 3), **more)


def known(sigma=0.0, off=0.0, count=28):
    pairs = list(combinations(range(len(XYZ)), 2))[:count]
    return [
        KnownLength(
            start=f"P{a + 1}", end=f"P{b + 1}", length=float(np.linalg.norm(XYZ[a] - XYZ[b])) - off, sigma=sigma
        )
        for a, b in pairs
    ]


def test_errors_of_lengths_scatter_as_their_standard_deviations_say():
    rng = np.random.default_rng(1)
    tests = [length_test(measured(rng), known()) for _ in range(300)]
    ratio = np.array([t.error / t.error_sigma for t in tests])
    assert ratio.std() == pytest.approx(1, abs=0.03)
    assert np.mean([t.within for t in tests]) == pytest.approx(0.954, abs=0.02)
    assert np.mean([t.significant.any() for t in tests]) < 0.08
    assert np.mean([t.whole[1] < 0.05 for t in tests]) == pytest.approx(0.05, abs=0.03)


def test_certificates_of_points_on_one_bar_do_not_contradict_by_their_last_digit():
    rng = np.random.default_rng(8)
    line = np.array([[0, 0, 0], [0.1, 0.0002, 0], [0.25, -0.0003, 0], [0.4, 0.0001, 0], [0, 0.3, 0.1], [0.3, 0.4, 0.0]])
    C = 25e-12 * np.eye(18)
    names = tuple("ABCDEF")
    listed = [
        KnownLength(start=names[a], end=names[b], length=round(float(np.linalg.norm(line[a] - line[b])), 7))
        for a, b in combinations(range(4), 2)
    ]
    sets = [PointSet(name="m", ids=names, xyz=line + rng.normal(0, 5e-6, (6, 3)), covariance=C) for _ in range(300)]
    tests = [length_test(m, listed) for m in sets]
    assert np.mean([t.whole[0] for t in tests]) == pytest.approx(1, abs=0.12)
    assert np.mean([t.contradicts for t in tests]) < 0.12


def test_lengths_that_were_bars_are_left_out_of_the_figures():
    m, lengths = measured(np.random.default_rng(2)), known(count=6)
    whole = length_test(m, lengths)
    done = length_test(m, lengths, bars={frozenset((lengths[0].end, lengths[0].start))})
    np.testing.assert_array_equal(done.served, [True] + [False] * 5)
    assert done.independent == 5
    assert done.rms == pytest.approx(np.sqrt(np.mean(whole.error[1:] ** 2)))
    np.testing.assert_allclose(done.error, whole.error)


def test_a_table_equals_an_own_computation():
    m, lengths = measured(np.random.default_rng(2)), known(1e-6)
    done = length_test(m, lengths, allowed=(1e-5, 2e-5))
    for k, length in enumerate(lengths):
        a, b = m.ids.index(length.start), m.ids.index(length.end)
        d = m.xyz[b] - m.xyz[a]
        L = float(np.sqrt(d @ d))
        Q = m.covariance
        A, B = slice(3 * a, 3 * a + 3), slice(3 * b, 3 * b + 3)
        variance = d @ (Q[A, A] + Q[B, B] - Q[A, B] - Q[B, A]) @ d / L**2
        assert done.error[k] == pytest.approx(L - length.length, abs=1e-15)
        assert done.error_sigma[k] == pytest.approx(np.sqrt(variance + 1e-12), rel=1e-9)
        assert done.allowed[k] == pytest.approx(1e-5 + 2e-5 * length.length)
    assert done.largest == max(abs(done.error))
    assert done.kept is bool((np.abs(done.error) <= done.allowed).all())


def test_an_error_of_scale_is_found():
    rng = np.random.default_rng(3)
    m = measured(rng)
    wrong = [KnownLength(start=k.start, end=k.end, length=1.0001 * k.length) for k in known()]
    done = length_test(m, wrong)
    assert done.whole[1] < 1e-6
    assert done.significant.any()
    assert done.within < 0.9
    assert length_test(m, known()).kept is None


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda m: (m, []), r"length_test\.no_length"),
        (lambda m: (m, [KnownLength(start="P1", end="P99", length=1.0)]), r"P99.*measurement\.unknown_points"),
        (lambda m: (m, [KnownLength(start="P1", end="P1", length=1.0)]), r"P1.*length_test\.invalid_length"),
        (lambda m: (m, [KnownLength(start="P1", end="P2", length=-1.0)]), r"P1.*P2.*1.*length_test\.invalid_length"),
        (lambda _: (measured(np.random.default_rng(1), free_scale=True), known()), r"length_test\.no_scale"),
    ],
)
def test_what_is_no_length_is_told(change, said):
    with pytest.raises(InputError, match=said):
        length_test(*change(measured(np.random.default_rng(1))))
