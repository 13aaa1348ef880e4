"""The command line: `raybundle COMMAND`; subcommands are loaded when they are called.

Exit status: 0 done; 1 internal error; 2 bad input or usage; 3 not solvable as given; 5 tasks wait for others; 130
interrupted.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import sys
import traceback
from collections.abc import Mapping, Sequence
from typing import Any, TextIO

import click

from raybundle.cli import frequent
from raybundle.cli.command import command_words
from raybundle.cli.failures import failure_lines, silence
from raybundle.cli.lazy import LazyGroup
from raybundle.errors import RaybundleError, message
from raybundle.words import COMMAND_LINE, reading

TASKS: dict[str, dict[str, str]] = {
    "Plan": {
        "plan": "Design networks and flights; predict their precision.",
        "simulate": "Write a simulated block and its truth.",
    },
    "Photograph and calibrate": {
        "photos": "List what the photographs state: camera, position, date.",
        "frames": "Extract sharp frames from a video.",
        "targets": "Print coded targets; detect and measure them.",
        "calibrate": "Calibrate cameras from coded targets or a board.",
        "calibration": "Convert and compare calibrations; keep a camera library.",
        "film": "Transform scanned film by its fiducial marks.",
    },
    "Orient and adjust": {
        "orient": "Orient photographs, with GCPs and check points or without.",
        "adjust": "Adjust a block; write a result folder and report.",
        "mark": "Measure points, control and scale bars by commands.",
        "datum": "Transform a result into the system of given points.",
        "merge": "Merge projects of one object into one block.",
        "status": "Show the stages of a project.",
    },
    "Measure": {
        "studio": "View, digitise, measure and adjust in the browser.",
        "measure": "Measure targets: coordinates, deviations, length errors.",
        "query": "Compute distances, angles, areas and planes with precision.",
        "compare": "Compare two results.",
        "epochs": "Adjust photographs of several dates; detect what moved.",
        "moved": "Detect displacements between epochs of the same points.",
        "strain": "Measure displacements and strains of a flat specimen.",
    },
    "Surface and maps": {
        "surface": "Compute point cloud, DSM, orthophoto and mesh.",
        "heights": "Compute DTM, cut and fill volumes, profiles, contours, differences.",
        "facade": "Draw a wall with relief: true orthophoto, sheet, sections.",
        "rectify": "Rectify a plane object to scale: facade, floor, painting.",
        "sheet": "Draw a sheet to scale as PDF.",
    },
    "Exchange": {
        "convert": "Convert from and to COLMAP, Metashape, LAS; undistort photographs.",
        "spreadsheet": "Write the tables of a result as a workbook.",
        "record": "Edit the recording sheet: object, client, rights.",
        "archive": "Write a package for deposit: result, record, checksums.",
    },
    "Satellite": {
        "rpc": "Project, correct, fit and orthorectify by RPC.",
        "empirical": "Fit affine, projective and DLT models.",
    },
    "Large projects": {
        "estimate-cost": "Estimate time, memory and disk of a project.",
        "worker": "Run tasks for a scheduler.",
        "scheduler": "Distribute tasks to workers.",
    },
    "Help": {
        "demo": "Simulate and calibrate a testfield; compare with truth.",
        "datasets": "Download public photographs, with checksums.",
        "doctor": "Check the installation.",
        "explain": "Explain a message by its code.",
    },
}
"""Commands by task, with what each does"""
COMMANDS = {name: summary for commands in TASKS.values() for name, summary in commands.items()}


def _print_version(ctx: click.Context, _: click.Parameter, value: bool) -> None:  # noqa: FBT001  (click's signature)
    if value and not ctx.resilient_parsing:
        from importlib.metadata import version

        click.echo(f"raybundle {version('raybundle')}")
        ctx.exit()


@click.group(cls=LazyGroup)
@click.option(
    "--version", is_flag=True, expose_value=False, is_eager=True, callback=_print_version, help="Print the version."
)
def cli() -> None:
    """Survey-grade photogrammetry: photographs or blocks in, coordinates with true standard deviations out.

    \b
    Examples:
      raybundle demo                                  see it work
      raybundle orient facade/ --out facade-project
      raybundle adjust camcal21 --out camcal21-result
      raybundle adjust --help
    """


cli.home, cli.summaries, cli.sections, cli.frequent = "raybundle.cli", COMMANDS, TASKS, frequent.COMMANDS


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command line and return its exit status; errors go to stderr without a traceback."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    for name in ("stdout", "stderr"):
        # closed from outside: what is shown goes nowhere (click before 8.1.4 would fail)
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_WRONLY), "w", encoding="utf-8"))
        _printable(getattr(sys, name))
    try:
        with reading(COMMAND_LINE):
            status = cli.main(arguments, prog_name="raybundle", standalone_mode=False)
        if sys.stdout is not None:
            sys.stdout.flush()
    except click.ClickException as error:
        with contextlib.suppress(OSError, ValueError):
            error.show()
        _as_json(arguments, error.format_message(), error.exit_code)
        return error.exit_code
    except (KeyboardInterrupt, click.Abort) as error:
        if isinstance(error.__cause__, EOFError):  # click takes the end of any file for that of the keyboard's input
            return _failed(arguments, error.__cause__)
        words = message("interruption.nothing_written").headline()
        _say(words)
        _as_json(arguments, words, 130)
        return 130
    except BrokenPipeError:
        silence(sys.stdout)  # the reader of our output went away: what stands in the buffer has nowhere to go
        return 1
    except Exception as error:  # noqa: BLE001  (the last resort; the message states how to see the rest)
        return _failed(arguments, error)
    return status if isinstance(status, int) else 0


def _failed(arguments: Sequence[str], error: Exception) -> int:
    """Say what went wrong, and return the exit status."""
    if "--traceback" in arguments:
        with contextlib.suppress(OSError, ValueError):
            traceback.print_exception(error)
    with reading(COMMAND_LINE):
        text, status = failure_lines(error)
    _say(text)
    data = error.json() if isinstance(error, RaybundleError) else {}
    _as_json(arguments, text, status, data)
    return status


def _printable(stream: TextIO) -> None:
    """Let signs that a stream cannot encode (a pipe on Windows has a code page) be question marks, and no error."""
    if isinstance(stream, io.TextIOWrapper) and stream.errors == "strict":
        stream.reconfigure(errors="replace")


def _as_json(arguments: Sequence[str], text: str, status: int, data: Mapping[str, Any] | None = None) -> None:
    """An error as an object on stdout, with `--json`: its text, and its code, values and place as data."""
    if "--json" in arguments:
        words = " ".join(command_words(cli, arguments))
        found = json.dumps({"command": words, "exit_status": status, "error": text, **(data or {})}, ensure_ascii=False)
        with contextlib.suppress(OSError, ValueError):
            click.echo(found)


def _say(text: str) -> None:
    """A line on stderr, if anybody can read it."""
    try:
        click.echo(text, err=True)
    except (OSError, ValueError):
        silence(sys.stderr)
