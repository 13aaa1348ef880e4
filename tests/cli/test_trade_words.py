"""Words of the trade name the command that does what they mean; the help lists commands by task."""

import shlex

import click
import pytest
from click.testing import CliRunner

from raybundle.cli.main import COMMANDS, cli
from raybundle.cli.trade_words import TRADE_WORDS


def command_and_words(line):
    """The command of a line, and the words that follow its name."""
    member, words = cli, shlex.split(line)
    while isinstance(member, click.Group):
        member = member.get_command(click.Context(member), words.pop(0))
    return member, words


@pytest.mark.parametrize("line", sorted(set(TRADE_WORDS.values())))
def test_the_named_command_has_these_options(line):
    command, words = command_and_words(line)
    assert command is not None
    known = {name for p in command.params for name in p.opts}
    assert {w for w in words if w.startswith("--")} <= known
    needed = {p.opts[0] for p in command.params if isinstance(p, click.Option) and p.required}
    assert needed <= set(words)
    assert words


@pytest.mark.parametrize(
    ("word", "line"),
    [("orthophoto", "surface RESULT --ortho CELL"), ("DSM", "surface RESULT --dsm CELL"),
     ("point_clouds", "surface RESULT --las"), ("undistort", "convert RESULT --to colmap"),
     ("georef", "orient PHOTOS --control"),
     ("dense cloud", "surface RESULT"), ("drone flight planning", "plan mission"), ("align photos", "orient PHOTOS")],
)  # fmt: skip
def test_a_word_of_the_trade_is_answered_and_does_nothing(word, line):
    done = CliRunner().invoke(cli, [word, "project"])
    assert done.exit_code == 2
    assert f"Run: {'cli'} {line}" in done.output.replace("raybundle", "cli")


def test_no_word_of_the_trade_hides_a_command():
    assert not set(TRADE_WORDS) & set(COMMANDS)
    done = CliRunner().invoke(cli, ["adjst"])
    assert "Did you mean" in done.output


def test_the_help_lists_each_command_once_under_its_task():
    shown = CliRunner().invoke(cli, ["--help"]).output
    for name, summary in COMMANDS.items():
        assert shown.count(f"\n  {name} ") == 1, name
        assert len(summary.split()) <= 10
    assert "\nSurface and maps:\n" in shown
