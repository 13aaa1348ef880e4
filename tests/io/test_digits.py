"""Numbers are written with the digits they deserve, and one module says how many."""

import ast
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from tests.sources import trees

import raybundle
from raybundle.io.digits import (
    EVERY,
    PART,
    STD,
    Figures,
    Places,
    Within,
    by_sigma,
    exact,
    exacts,
    jointly,
    of_correlations,
    of_covariances,
    of_pairs,
    of_residual,
    one,
)
from raybundle.io.tables import write_table
from raybundle.numerics.deviations import PAIRS

SOURCE = Path(raybundle.__file__).parent
FINITE = st.floats(-1e12, 1e12)
SIGMA = st.floats(1e-12, 1e6)


@given(FINITE, SIGMA)
def test_rounding_changes_no_number_by_more_than_a_thousandth_of_its_sigma(value, sigma):
    found = one(value, by_sigma(np.array([sigma])))
    assert abs(found - value) <= PART * sigma * (1 + 1e-6) + 2e-16 * abs(value)


@given(FINITE, SIGMA)
def test_no_digit_is_written_that_is_not_needed(value, sigma):
    """One place fewer would change some numbers by more."""
    text = exact(one(value, by_sigma(np.array([sigma]))))
    places = len(text.partition(".")[2]) if "e" not in text else 0
    if text.partition(".")[2] not in {"", "0"} and "e" not in text and abs(value) * 10**places < 1e14:
        assert 0.5 * 10.0 ** (1 - places) > PART * sigma * (1 - 1e-6)


@given(FINITE, st.integers(1, 8))
@example(0.15, 1)
def test_significant_digits_are_those_that_python_writes(value, figures):
    # half way between two of them, as 0.15 is but for its last bit, either will do
    near = (value, np.nextafter(value, -np.inf), np.nextafter(value, np.inf))
    written = [pytest.approx(float(f"{v:.{figures}g}"), rel=1e-15, abs=1e-300) for v in near]
    assert one(value, Figures(figures)) in written


@given(st.floats(-1e5, 1e5), st.integers(0, 8))
def test_rounded_numbers_are_the_nearest_decimal_fractions(value, places):
    text = exact(one(value, Places(places)))
    assert float(text) == one(float(text), Places(places))
    if "e" not in text:
        assert len(text.partition(".")[2]) <= max(places, 1)


def test_what_has_no_sigma_keeps_its_digits():
    values = np.array([1 / 3, 2 / 3, np.nan, -1 / 3, 1e300 / 3])
    found = by_sigma(np.array([0.0, np.nan, 1.0, 0.01, 1.0])).of(values)
    np.testing.assert_array_equal(found, [1 / 3, 2 / 3, np.nan, -0.33333, 1e300 / 3])
    assert one(-1e-9, Places(3)) == 0
    assert exact(one(-1e-9, Places(3))) == "0.0"
    np.testing.assert_array_equal(EVERY.of(values), values)
    assert one(1.23456789e-200, STD) == 1.23457e-200
    assert one(123456.0, Within(np.array([2000.0]))) == 123000.0


def test_coordinates_that_are_correlated_are_rounded_together():
    """Seen from a narrow bundle the depth is known to 10, across it to 0.01: rounding must not show across."""
    rng = np.random.default_rng(3)
    R = np.linalg.qr(rng.normal(size=(200, 3, 3)))[0]
    C = R @ np.diag([0.01, 0.01, 10.0]) ** 2 @ np.swapaxes(R, 1, 2)
    xyz = rng.normal(0, 1000, (200, 3))
    e = np.stack([rule.of(xyz[:, k]) for k, rule in enumerate(jointly(C))], axis=1) - xyz
    assert np.sqrt(np.einsum("ni,nij,nj->n", e, np.linalg.inv(C), e)).max() <= PART
    alone = np.stack([by_sigma(np.sqrt(C[:, k, k])).of(xyz[:, k]) for k in range(3)], axis=1) - xyz
    assert np.sqrt(np.einsum("ni,nij,nj->n", alone, np.linalg.inv(C), alone)).max() > 10 * PART  # would be noticed


def test_rounded_correlations_leave_every_variance():
    rng = np.random.default_rng(5)
    A = rng.normal(size=(100, 3, 3)) * np.array([1, 0.1, 0.03])
    C = A @ np.swapaxes(A, 1, 2)
    s = np.sqrt(np.diagonal(C, axis1=1, axis2=2))
    rounded = C.copy()
    for (i, j), rule, same in zip(PAIRS, of_pairs(C), of_covariances(C), strict=True):
        r = rule.of(C[:, i, j] / (s[:, i] * s[:, j])) * s[:, i] * s[:, j]
        assert (abs(same.of(C[:, i, j]) - C[:, i, j]) <= 1.0001 * rule.limit * s[:, i] * s[:, j]).all()
        rounded[:, i, j] = rounded[:, j, i] = r
    to = np.linalg.cholesky(np.linalg.inv(C))
    ratio = np.linalg.eigvalsh(np.swapaxes(to, 1, 2) @ rounded @ to)
    assert abs(np.sqrt(ratio) - 1).max() < PART
    assert of_correlations(np.zeros((2, 3, 3))).shape == (2,)


def test_held_and_unknown_numbers_have_no_part_in_it():
    C = np.zeros((2, 3, 3))
    C[0] = np.diag([0.01, 0.0, 0.02]) ** 2
    C[1] = np.nan
    limits = np.stack([rule.limit for rule in jointly(C)], axis=1)
    np.testing.assert_allclose(limits, [[PART * 0.01 / 3, 0, PART * 0.02 / 3], [0, 0, 0]])


def test_residuals_know_their_own_sigma():
    v, w = np.array([0.0123456, 1e-7 / 3, 0.0]), np.array([0.5, np.nan, 0.0])
    np.testing.assert_array_equal(of_residual(v, w).of(v), [0.01235, 1e-7 / 3, 0.0])


def test_every_column_of_numbers_says_its_digits(tmp_path):
    with pytest.raises(ValueError, match=r"how many digits x of t\.csv"):
        write_table(tmp_path / "t.csv", {"a": ["1"], "x": np.ones(1)}, {})
    assert exacts([1, 0.1]) == "[1.0, 0.1]"


OWN = {
    "io/digits.py", "io/rows.py", "io/reading/words.py",
    "targets/sidecar.py",  # below io
    "io/photos/movie.py",  # a number of a film's metadata as text
    "io/geo/control_files.py",  # digits of a given height are counted; a key of equal coordinates
}  # fmt: skip
WRITERS = {
    "io/formats/opensfm.py",  # a table of another program, with its digits
    "commands/demonstrations/files.py",  # made data, texts
}
LAYERS = ("io", "results", "commands", "measuring", "targets", "missions", "planning")
LONG = tuple(f".{n}{kind}" for n in range(11, 19) for kind in "fge")


def formats_numbers(tree):
    """Texts made of numbers with all or very many digits, and tables that are written without `write_table`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "repr":
            yield ast.unparse(node)
        elif isinstance(node, ast.Call) and ast.unparse(node.func) in {"csv.writer", "csv.DictWriter"}:
            yield ast.unparse(node.func)
        elif isinstance(node, ast.FormattedValue):
            number = isinstance(node.value, ast.Call) and ast.unparse(node.value.func) == "float"
            if node.conversion == ord("r") and (number or isinstance(node.value, ast.ListComp)):
                yield ast.unparse(node)
            if node.format_spec is not None and ast.unparse(node.format_spec).strip("f'\"") in LONG:
                yield ast.unparse(node)


def test_no_writer_says_the_digits_itself():
    found = {
        name: what
        for name, tree in trees(r"\brepr\(|!r|csv\.|:\.1[1-8][fge]")
        if name.startswith(LAYERS) and name not in OWN | WRITERS and (what := list(formats_numbers(tree)))
    }
    assert found == {}


@pytest.mark.parametrize(
    "code", ["repr(x)", "f'{float(x)!r}'", "f'{x:.17g}'", "f'{[float(v) for v in x]!r}'", "csv.writer(f)"]
)
def test_the_test_would_notice_one(code):
    assert list(formats_numbers(ast.parse(code)))
