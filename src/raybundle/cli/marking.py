"""What the subcommands of `raybundle mark` have in common: the group, and how one is an action on a folder."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from raybundle.cli.common import FOLDER, Group, facts
from raybundle.cli.summary import Summary, of_texts, report
from raybundle.errors import Severity, note

if TYPE_CHECKING:
    from raybundle.measuring.journal import Entry


@click.group("mark", cls=Group)
def command() -> None:
    """Measure points by hand in the images of a project, result or block folder, or in photographs alone.

    A project stores every action in FOLDER/measured.db, another folder in FOLDER.measured.db beside it. For a folder of
    photographs, a new project FOLDER-project is made beside it. There, marks orient the photographs: six points in the
    first two, then four with coordinates in each further one. Undo and redo are unlimited. Pixel coordinates start at
    the outer corner of the first pixel of the stored file.

    \b
    Example:
      raybundle mark put facade-project IMG_3.jpg gate 1204.3 880.1 --mark-sigma 0.3
      raybundle mark bar facade-project A B 1.0003 0.0001
      raybundle mark adjust facade-project
    """


def _author(function: Callable[..., Any]) -> Callable[..., Any]:
    return click.option(
        "--operator", "author", default="", metavar="TEXT", help="Name of the operator, for the journal."
    )(function)


def subcommand(name: str) -> Callable[[Callable[..., Any]], click.Command]:
    """A subcommand that is one action on a folder."""

    def made(function: Callable[..., Any]) -> click.Command:
        with_options = click.argument("folder", type=FOLDER)(_author(function))
        return command.command(name)(with_options)

    return made


def do(folder: Path, verb: str, author: str, /, **arguments: Any) -> None:
    """Do an action of a verb and report its number; a folder of photographs has its project begun."""
    from raybundle.cli.progress import reporting
    from raybundle.commands.marks import control_remarks, mark, mark_verdict
    from raybundle.commands.new_project import measuring_folder, standing_folder

    begun, lines = list[Path](), list[str]()
    if standing_folder(folder) is None:
        begun.append(measuring_folder(folder, notify=lines.append))
    seq = mark(folder, verb, operator=author, **arguments)
    facts(action=seq, verb=verb)
    of = _moved(folder, seq) if verb in {"undo", "redo"} else None
    action = note(
        "project_status.action", seq=seq, verb=verb, of=of.seq if of else 0, of_verb=of.verb if of else "",
        arguments=words(of.arguments) if of else [],
    )  # fmt: skip
    first = [note("project_status.begun")] if begun else []
    test = None
    if verb in {"put", "move"}:
        with reporting("auto") as notify:
            test = mark_verdict(folder, arguments["image"], arguments["point"], notify)
    tested = [] if test is None else [*test.messages]
    fine = [m for m in tested if m.severity is not Severity.WARNING]
    bad = [m for m in tested if m.severity is Severity.WARNING]
    if verb == "control":
        found = of_texts(control_remarks(folder, arguments["file"]))
        fine += [m for m in found if m.severity is not Severity.WARNING]
        bad += [m for m in found if m.severity is Severity.WARNING]
    report(Summary(done=[*first, action, *fine], notices=[*bad, *of_texts(lines)], files=begun))


def _moved(folder: Path, seq: int) -> Entry | None:
    """The action that an undo took back, or that a redo did again."""
    from raybundle.commands.marks import history
    from raybundle.measuring.state import in_force

    entries = [e for e in history(folder) if e.seq <= seq]
    _, moved = in_force([e.action for e in entries])
    return None if moved[-1] is None else entries[moved[-1]]


def words(arguments: Mapping[str, Any]) -> list[str]:
    """The arguments of an action, without what was not given."""
    return [f"{n} {_plain(v)}" for n, v in arguments.items() if v not in (None, "", [], [None, None, None])]


SHOWN = 12
"""Values of an argument that are reported one by one."""


def _plain(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.10g}"
    if isinstance(value, list) and len(value) > SHOWN:
        return f"{len(value)} of them"
    return " ".join(map(_plain, value)) if isinstance(value, list | tuple) else str(value)
