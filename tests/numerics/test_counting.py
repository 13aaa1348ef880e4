"""Counts in sentences, of one and of many."""

import re
from pathlib import Path

import pytest

import raybundle
from raybundle.numerics.counting import counted, counted_are


@pytest.mark.parametrize(
    ("number", "words", "subject"),
    [(0, "0 tie points", "0 tie points are"), (1, "1 tie point", "1 tie point is"),
     (18803, "18 803 tie points", "18 803 tie points are")],
)  # fmt: skip
def test_one_and_many(number, words, subject):
    assert counted(number, "tie point") == words
    assert counted_are(number, "tie point") == subject


def test_notices_count_by_it():
    """A length at the beginning of a sentence with its noun in the plural would be wrong for one."""
    wrong = re.compile(r'(?:message=|message = \(?\s*|told = )f"\{(?:len|int)\([^"{}]*\)\} [a-z ]+s (?:are|were|have) ')
    found = [
        f"{path.name}: {hit[0][:60]}"
        for path in Path(raybundle.__file__).parent.rglob("*.py")
        for hit in wrong.finditer(path.read_text())
    ]
    assert not found
