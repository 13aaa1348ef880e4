"""Numbers in print: digits as the standard deviation allows."""

import math

import numpy as np
import pytest

from raybundle.report.text.numbers import (
    cells,
    column_decimals,
    decimals_for,
    fixed,
    grouped,
    listed,
    per_cent,
    probability,
    significant,
    unbroken,
    unit_text,
    with_sigma,
)


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (0.0, 3, "0"), (1.0, 3, "1.00"), (0.0669, 2, "0.067"), (-12.345, 3, "−12.3"), (9.996, 3, "10.0"),
        (999.6, 3, "1000"), (12345.6, 3, "12\u202f300"), (2.5e-7, 2, "2.5 × 10⁻⁷"), (-3.1e9, 2, "−3.1 × 10⁹"),
        (math.nan, 3, "–"), (math.inf, 3, "–"),
    ],
)  # fmt: skip
def test_significant_digits(value, digits, text):
    assert significant(value, digits) == text


@pytest.mark.parametrize(
    ("value", "sigma", "text"),
    [
        (7.457072, 0.0010442, ("7.4571", "0.0010")),
        (-4.49281e-5, 2.64e-6, ("−4.49 × 10⁻⁵", "0.26 × 10⁻⁵")),
        (0.0045907, 2.2e-5, ("0.004591", "0.000022")),
        (1234.5, 67.0, ("1234", "67")),
        (0.5, 1200.0, ("0", "1200")),
        (2.0, math.nan, ("2", "–")),
        (2.0, 0.0, ("2", "–")),
    ],
)
def test_value_and_sigma_to_the_second_digit_of_sigma(value, sigma, text):
    assert with_sigma(value, sigma) == text


def test_no_negative_zero():
    assert fixed(-0.0004, 2) == "0.00"
    assert cells([-0.0004, -1.0, math.nan], 2) == ["0.00", "−1.00", "–"]


def test_decimals():
    assert [decimals_for(s) for s in (0.012, 0.99, 1.5, 250.0)] == [3, 2, 1, 0]
    assert column_decimals(np.array([np.nan, 0.0])) == 3
    assert column_decimals(np.array([[0.05, 0.5], [np.nan, 5.0]])) == 3


def test_words():
    assert grouped(1234567) == "1\u202f234\u202f567"
    assert grouped(-1234) == "−1\u202f234"
    assert grouped(math.nan) == "–"
    assert unit_text("mm^-2") == "mm⁻²"
    assert unit_text("1") == ""
    assert (probability(2e-9), probability(0.25)) == ("< 0.001", "0.250")
    assert (per_cent(0.001), per_cent(0.8), per_cent(math.nan)) == ("0.1 %", "80 %", "–")
    assert listed("abcd", 2) == "a, b and 2 more"


def test_numbers_in_sentences_are_not_broken():
    assert unbroken("67 200 rays 18 673 in 8 m, ± 0.4 m, 48452 / 1 234 567") == (
        "67\u202f200 rays 18\u202f673 in 8 m, ±\u00a00.4 m, 48452 / 1\u202f234\u202f567"
    )
