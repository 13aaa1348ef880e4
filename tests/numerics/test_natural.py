"""Names in the order that people expect."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from raybundle.numerics.natural import natural, natural_order


@pytest.mark.parametrize(
    "names",
    [
        ["P1", "P2", "P10", "P11", "Q1"],
        ["1", "2", "10", "A"],
        ["IMG_9.jpg", "img_10.jpg", "IMG_11.jpg"],
        ["a", "a1", "a1b", "a01b2", "a2"],
        ["x9", "x" + "1" * 5000],
        ["m²", "m³"],
        ["٢", "١٠"],
    ],
)
def test_numbers_in_names_count_as_numbers(names):
    assert sorted(names, key=natural) == names


def test_names_that_differ_in_zeros_alone_keep_one_order():
    assert sorted(["a1", "a01", "A1"], key=natural) == sorted(["A1", "a1", "a01"], key=natural)


@given(st.lists(st.text()))
def test_any_names_have_an_order(names):
    order = natural_order(names)
    assert sorted(order) == list(range(len(names)))
    assert [names[k] for k in order] == sorted(names, key=natural)


def test_there_is_one_such_order():
    source = Path(__file__).parents[2] / "src" / "raybundle"
    own = [p.name for p in source.rglob("*.py") if "def natural(" in p.read_text() or "def _natural(" in p.read_text()]
    assert own == ["natural.py"]
