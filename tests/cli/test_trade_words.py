"""Words of the trade name the command that does what they mean; the help lists commands by task."""

import re
import shlex

import click
import pytest
from click.testing import CliRunner
from tests.cli.walk import commands

from raybundle.cli import frequent
from raybundle.cli.command import Command
from raybundle.cli.main import COMMANDS, TASKS, cli
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


def listed(output):
    """The names that stand at the beginning of indented lines."""
    return re.findall(r"^  (\S+)", output, re.MULTILINE)


def test_the_help_lists_each_command_once_under_its_task():
    shown = CliRunner().invoke(cli, ["--help-all"]).output
    for name, summary in COMMANDS.items():
        assert listed(shown).count(name) == 1, name
        assert len(summary.split()) <= 10
    assert [f"{task}:" for task in TASKS] == re.findall(r"^([A-Z].*:)$", shown, re.MULTILINE)[1:]


def test_the_short_help_shows_ten_commands():
    shown = CliRunner().invoke(cli, ["--help"]).output
    assert len(set(frequent.COMMANDS)) == 10
    assert set(frequent.COMMANDS) <= set(COMMANDS)
    assert [n for n in COMMANDS if n in listed(shown)] == [n for n in COMMANDS if n in frequent.COMMANDS]
    assert shown.rstrip().endswith(f"{len(COMMANDS) - 10} more commands: --help-all")


@pytest.mark.parametrize("words", frequent.OPTIONS)
def test_the_short_help_of_a_command_shows_ten_options(words):
    command = {" ".join(w): c for w, c in commands()}[words]
    assert len(set(frequent.OPTIONS[words])) == 10
    assert set(frequent.OPTIONS[words]) <= {o for p in command.params for o in p.opts}
    short, whole = (
        CliRunner().invoke(cli, [*words.split(), flag]).output.partition("\nOptions:\n")[2]
        for flag in ("--help", "--help-all")
    )
    shown = [p for p in command.params if isinstance(p, click.Option) and not p.hidden]
    few = {o for p in shown for o in p.opts if not set(frequent.OPTIONS[words]).isdisjoint(p.opts)}
    assert {o.rstrip(",") for o in re.findall(r"^  (--\S+)", short, re.MULTILINE)} <= few
    assert all(o in short for o in frequent.OPTIONS[words])
    assert short.rstrip().endswith(f"{len(shown) - 10} more options: --help-all")
    assert all(p.opts[0] in whole for p in shown)
    assert "--help-all" not in whole


def test_the_help_is_the_same_whatever_context_came_first():
    ask = click.Option(["--ask"])
    first, second = (Command("ask", params=[ask], callback=print) for _ in range(2))
    first.get_params(click.Context(first))
    shown = [CliRunner().invoke(c, ["--help"]).output for c in (first, second)]
    assert shown[0] == shown[1]
    assert "  -h, --help" in shown[0]


def test_no_long_help_without_a_short_one():
    for words, command in commands():
        many = sum(1 for p in command.params if isinstance(p, click.Option) and not p.hidden)
        assert many <= 40 or " ".join(words) in frequent.OPTIONS, words
