"""Commands with what all of them have: --settings, --json, --quiet, --overwrite and --traceback."""

from __future__ import annotations

import contextlib
import difflib
import io
import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, cast

import click

from raybundle.cli.frequent import OPTIONS
from raybundle.cli.outputs import Output
from raybundle.cli.summary import SUMMARY, data, lines, loud
from raybundle.cli.trade_words import command_of
from raybundle.errors import InputError

HELP_NAMES = ["-h", "--help"]
COMMAND_SETTINGS = {"help_option_names": HELP_NAMES, "max_content_width": 110}
FACTS, HELP_ALL, JSON, QUIET, VERBOSE = (
    f"raybundle.{word}" for word in ("facts", "help_all", "json", "quiet", "verbose")
)
GRAVE = {"fault": "faults", "warning": "warnings", "note": "notes", "left out": "left_out"}
"""Words with which a line begins that states what is wrong, and their names in JSON"""
NOT_KEPT = 4
"""Exit status where something that was asked for, a tolerance or an accuracy, is not kept"""
NEAR = 0.6
"""Likeness from which on a mistyped word is reported with what may be meant, as difflib counts it"""
ALOUD = ("fault", "warning", "left out")
"""Of these the lines that are given by a quiet command as well"""
WRITTEN = (
    "result.json", "epochs.json",
    "moved.json", "plan.json", "next.json", "transformation.json", "model.json", "check.json",
)  # fmt: skip
"""Files of a command's folder that say what it found"""


class Command(click.Command):
    """A command with the options that all commands have."""

    def __init__(self, *arguments: Any, **more: Any) -> None:
        more.setdefault("context_settings", COMMAND_SETTINGS)
        super().__init__(*arguments, **more)
        own = {name for p in self.params for name in p.opts}
        files = any(_is_file(p) for p in self.params)
        self.params += [o for o in shared_options(files=files) if own.isdisjoint(o.opts)]
        if any(isinstance(p, click.Argument) and isinstance(p.type, click.FloatRange) for p in self.params):
            self.context_settings = {**self.context_settings, "ignore_unknown_options": True}  # -5 is a number

    def get_help_option_names(self, ctx: click.Context) -> list[str]:  # noqa: ARG002 - as click calls it
        """The same in each context: click keeps the option that it makes for the first."""
        return HELP_NAMES

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Those of most use, where the command has many; all with --help-all."""
        shown = OPTIONS.get(_name(ctx))
        if shown is None or ctx.meta.get(HELP_ALL):
            super().format_options(ctx, formatter)
            return
        options = [p for p in self.get_params(ctx) if isinstance(p, click.Option)]
        records = [(p.opts, r) for p in options if (r := p.get_help_record(ctx)) is not None]
        few = [r for opts, r in records if not {*shown, "--help"}.isdisjoint(opts)]
        with formatter.section("Options"):
            formatter.write_dl(few)
        more_line(formatter, len(records) - len(few), "option")

    def invoke(self, ctx: click.Context) -> Any:
        """Do what is asked for, aloud, quietly, or as JSON; within --overwrite, what it names may be replaced."""
        _check_apart(ctx)
        if ctx.meta.get(QUIET) and "progress" in ctx.params:
            ctx.params["progress"] = "none"
        as_json, quiet = (bool(ctx.meta.get(name)) for name in (JSON, QUIET))
        if ctx.params.get("as_json") or not (as_json or quiet):
            try:
                return super().invoke(ctx)
            finally:
                if (summary := ctx.meta.get(SUMMARY)) is not None:
                    _echo(lines(summary, verbose=bool(ctx.meta.get(VERBOSE))))
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            status = super().invoke(ctx)
        summary = ctx.meta.get(SUMMARY)
        if as_json:
            from raybundle.results.contents import clean

            found = clean(_object(ctx, status, printed.getvalue()))
            click.echo(json.dumps(found, ensure_ascii=False, default=str))
            return status
        wrong = [] if summary is None else loud(summary)
        _echo(wrong + [w for w in printed.getvalue().splitlines() if status or w.strip().startswith(ALOUD)], err=True)
        return status


class SeveralNames(Command):
    """A command whose options of names take all words up to the next option."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """`--area A B C` is `--area A --area B --area C`."""
        several = {
            name for p in self.params if isinstance(p, click.Option) and p.multiple and p.nargs == 1 for name in p.opts
        }
        spread: list[str] = []
        option = ""
        for word in args:
            if word.startswith("--"):
                option = word if word in several else ""
                spread += [] if option else [word]
            elif option:
                spread += [option, word]
            else:
                spread.append(word)
        return super().parse_args(ctx, spread)


class Group(click.Group):
    """A group of commands that have what all have; a mistyped name is reported with what may be meant."""

    command_class = Command

    def __init__(self, *arguments: Any, **more: Any) -> None:
        more.setdefault("context_settings", COMMAND_SETTINGS)
        super().__init__(*arguments, **more)
        self.params.append(help_all_option())

    def resolve_command(self, ctx: click.Context, args: list[str]) -> Any:
        """The command of the first word; a usage error that states what may be meant where there is none."""
        try:
            return super().resolve_command(ctx, args)
        except click.UsageError:
            likely = self.likely(ctx, args[0])
            line = command_of(args[0]) if ctx.parent is None else None
            exact = any(name.split()[-1] == args[0] for name in likely)
            answers = list[str]()
            if exact or (likely and line is None):
                words = " or ".join(f"'{ctx.command_path} {name}'" for name in likely)
                answers.append(f"Did you mean {words}?")
            if line is not None:
                answers.append(f"{'Or run' if answers else 'Run'}: {ctx.command_path} {line}")
            if not answers:
                raise
            raise click.UsageError(" ".join([f"No such command '{args[0]}'.", *answers]), ctx) from None

    def likely(self, ctx: click.Context, word: str) -> list[str]:
        """Commands that may be meant by a word, those of groups within, too."""
        meant = {name: name for name in reversed(self.list_commands(ctx))}
        for name in self.list_commands(ctx):
            if isinstance(group := self.get_command(ctx, name), click.Group):
                meant = {sub: f"{name} {sub}" for sub in group.list_commands(ctx)} | meant
        return [meant[n] for n in difflib.get_close_matches(word, meant, cutoff=NEAR)]


def help_all_option() -> click.Option:
    """--help-all, which shows what --help leaves out."""
    return click.Option(
        ["--help-all"], is_flag=True, is_eager=True, expose_value=False, hidden=True, callback=_show_all,
        help="Show all commands and options and exit.",
    )  # fmt: skip


def _show_all(ctx: click.Context, _: click.Parameter, value: bool) -> None:  # noqa: FBT001  (click's signature)
    if value and not ctx.resilient_parsing:
        ctx.meta[HELP_ALL] = True
        click.echo(ctx.get_help(), color=ctx.color)
        ctx.exit()


def more_line(formatter: click.HelpFormatter, n: int, what: str) -> None:
    """How much more --help-all shows."""
    if n:
        formatter.write_paragraph()
        formatter.write_text(f"{n} more {what}{'s' * (n > 1)}: --help-all")


def shared_options(*, files: bool) -> list[click.Option]:
    """New options for a command; `files`: whether it writes a file that somebody may want to replace."""
    quiet = click.Option(
        ["--quiet"], is_flag=True, expose_value=False, callback=_kept(QUIET),
        help="Print only errors, faults, warnings and omissions. Files and the exit status hold the rest.",
    )  # fmt: skip
    verbose = click.Option(
        ["--verbose"], is_flag=True, expose_value=False, callback=_kept(VERBOSE),
        help="Print notes, all warnings and further figures too.",
    )  # fmt: skip
    as_json = click.Option(
        ["--json"], is_flag=True, expose_value=False, callback=_kept(JSON),
        help="Print the result as one JSON object instead of text.",
    )  # fmt: skip
    settings = click.Option(
        ["--settings"], type=click.Path(path_type=Path), metavar="FILE.toml", is_eager=True, expose_value=False,
        envvar="RAYBUNDLE_SETTINGS", callback=_settings_read,
        help="Read options from the table named after the command. Options on the command line have priority.",
    )  # fmt: skip
    overwrite = click.Option(
        ["--overwrite"], is_flag=True, is_eager=True, expose_value=False, callback=_overwriting,
        help="Replace existing files.",
    )  # fmt: skip
    traceback = click.Option(
        ["--traceback"], is_flag=True, expose_value=False, help="After an error, show its place in the program."
    )
    return [*([overwrite] if files else []), settings, as_json, quiet, verbose, traceback, help_all_option()]


def command_words(group: click.Group, arguments: Sequence[str]) -> list[str]:
    """The words of the command that arguments begin with, as far as they are one."""
    words: list[str] = []
    member: click.Command | None = group
    for word in arguments:
        context = click.Context(group)
        if not isinstance(member, click.Group) or word not in member.list_commands(context):
            break
        member = member.get_command(context, word)
        words.append(word)
    return words


def facts(**values: Any) -> None:
    """Say what a command found, for --json: paths, numbers, arrays and data classes of them."""
    context = click.get_current_context(silent=True)
    if context is not None:
        context.meta.setdefault(FACTS, {}).update(values)


def _echo(texts: Sequence[str], *, err: bool = False) -> None:
    for text in texts:
        click.echo(text, err=err)


def _check_apart(ctx: click.Context) -> None:
    """Refuse to write over what the command is to read, whatever may be overwritten."""
    places = [p for p in ctx.command.params if isinstance(p.type, click.Path)]
    paths = [(p, v) for p in places for v in _paths(ctx.params.get(p.name or ""))]
    read = {Path(v).resolve() for p, v in paths if not isinstance(p.type, Output)}
    for parameter, path in paths:
        if isinstance(parameter.type, Output) and parameter.type.wanted != "folder" and Path(path).resolve() in read:
            raise InputError("file.read_by_command", file=Path(path))


def _paths(value: Any) -> list[Any]:
    return [] if value is None else list(value) if isinstance(value, tuple) else [value]


def _is_file(parameter: click.Parameter) -> bool:
    return isinstance(parameter.type, Output) and parameter.type.wanted in {"file", "either"}


def _kept(name: str) -> Callable[[click.Context, click.Parameter, bool], None]:
    def keep(ctx: click.Context, _: click.Parameter, value: bool) -> None:  # noqa: FBT001  (click's signature)
        ctx.meta[name] = value

    return keep


def _overwriting(ctx: click.Context, _: click.Parameter, value: bool) -> None:  # noqa: FBT001  (click's signature)
    if value and not ctx.resilient_parsing:
        from raybundle.io.folders import overwriting

        ctx.with_resource(overwriting())


def _settings_read(ctx: click.Context, _: click.Parameter, value: Path | None) -> None:
    if value is not None and not ctx.resilient_parsing:
        from raybundle.cli.settings_file import defaults_of

        root = cast("click.Group", ctx.find_root().command)
        ctx.default_map = {**(ctx.default_map or {}), **defaults_of(value, ctx.command, _name(ctx), root)}


def _name(ctx: click.Context) -> str:
    """The command's words without that of the program: "plan network"."""
    return ctx.command_path.partition(" ")[2]


def _object(ctx: click.Context, status: Any, printed: str) -> dict[str, Any]:
    """What a command found and printed."""
    found: dict[str, Any] = {
        "command": _name(ctx), "exit_status": status if isinstance(status, int) else 0,
        **{name: list[str]() for name in GRAVE.values()}, "lines": list[str](),
    }  # fmt: skip
    for line in filter(None, map(str.strip, printed.splitlines())):
        kind, _, words = line.partition(": ")
        if words and kind in GRAVE:
            found[GRAVE[kind]].append(words)
        else:
            found["lines"].append(line)
    if (summary := ctx.meta.get(SUMMARY)) is not None:
        found |= data(summary)
    found |= {"out": ctx.params.get("out"), **ctx.meta.get(FACTS, {})}
    done = found["exit_status"] in {0, NOT_KEPT}  # else what stands there may be of another run
    return found | (_written(found["out"]) if done and isinstance(found["out"], Path) else {})


def _written(out: Path) -> dict[str, Any]:
    """What stands in the JSON files of a command's folder, by their names."""
    from raybundle.io.reading.trees import read_json

    places = [out / "result"] if (out / "result" / "result.json").is_file() else [out]
    files = [folder / name for folder in places for name in WRITTEN if (folder / name).is_file()]
    return {f.stem: read_json(f).value for f in files}
