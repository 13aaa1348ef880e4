"""Words of other programs in docs/where-is.md: each names commands with options that exist, and pages that exist.

tests/docs/test_examples.py looks at options of a sentence and links; here the arguments of a group and the words typed
as a command are looked at.
"""

import re
import shlex
from pathlib import Path

import click
import pytest

from raybundle.cli.main import cli
from raybundle.cli.trade_words import command_of

DOCS = Path(__file__).resolve().parents[2] / "docs"
ROWS = [
    [cell.strip() for cell in line.strip("|").split(" | ")]
    for line in (DOCS / "where-is.md").read_text(encoding="utf-8").splitlines()
    if line.startswith("| ") and not line.startswith("| word ")
]
NO_ANSWER = {"Index (NDVI)", "solvePnP", "findEssentialMat", "Surface draw", "Mark points, reference", "Bundle report",
             "Measure Volume, Area"}  # fmt: skip
"""Rows that name no command, or a word that is a command itself"""


def commands_in(cell):
    """Each command of a cell: its path, its click command and the rest of its words."""
    for code in re.findall(r"`raybundle ([^`]+)`", cell):
        member, words, path = cli, shlex.split(code), []
        while isinstance(member, click.Group):
            path.append(words.pop(0))
            member = member.get_command(click.Context(member), path[-1])
        yield " ".join(path), member, words


def test_the_page_is_short():
    assert 60 < len(ROWS) <= 90


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[0])
def test_a_row_names_a_command_with_its_options_and_a_page(row):
    word, command, page = row
    for path, member, words in commands_in(command):
        assert member is not None, path
        known = {name for p in member.params for name in p.opts}
        assert {w for w in words if w.startswith("--")} <= known, path
    assert word in NO_ANSWER or "raybundle" in command or "report.html" in command
    links = re.findall(r"\]\(([^)]+)\)", page)
    assert links or word in NO_ANSWER
    assert all((DOCS / link).is_file() for link in links)


@pytest.mark.parametrize("row", [r for r in ROWS if r[0] not in NO_ANSWER], ids=lambda row: row[0])
def test_a_word_typed_as_a_command_gets_a_command_of_its_row(row):
    named = {path.split()[0] for path, _, _ in commands_in(row[1])} or {"adjust"}
    for word in re.split(", |: ", row[0]):
        if len(word) > len("dist"):
            answer = command_of(word)
            assert answer is not None, word
            assert answer.split()[0] in named
