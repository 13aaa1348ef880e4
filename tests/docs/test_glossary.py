"""The glossary: complete entries, and no word in the help that it gives another term for."""

import re
import tomllib
from pathlib import Path

import pytest

REFERENCE = Path(__file__).resolve().parents[2] / "docs/reference"
TERMS = tomllib.loads((REFERENCE / "glossary.toml").read_text(encoding="utf-8"))
LONGEST = 25


@pytest.mark.parametrize("name", TERMS)
def test_an_entry_is_complete(name):
    term = TERMS[name]
    assert {"german", "definition", "source"} <= term.keys() <= {
        "german", "definition", "source", "symbol", "unit", "avoid",
    }  # fmt: skip
    assert term["source"] in {"GUM", "VIM", "ASPRS", "usage"}
    assert term["definition"].endswith(".")
    assert term["definition"].count(". ") == 0
    assert len(term["definition"].split()) <= LONGEST


def test_a_word_to_avoid_is_no_term():
    assert not {a for t in TERMS.values() for a in t.get("avoid", ())} & TERMS.keys()


def test_the_help_uses_the_terms():
    text = (REFERENCE / "command-line.md").read_text(encoding="utf-8")
    found = {
        f"{word}: {name}"
        for name, term in TERMS.items()
        for word in term.get("avoid", ())
        if re.search(rf"\b{re.escape(word)}s?\b", text, re.IGNORECASE)
    }
    assert not found
