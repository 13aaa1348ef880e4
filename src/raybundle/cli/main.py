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
from collections.abc import Sequence
from typing import TextIO

import click

from raybundle.cli.command import command_words
from raybundle.cli.failures import silence, told_failure
from raybundle.cli.lazy import LazyGroup
from raybundle.settings import on_the_command_line

COMMANDS = {
    "orient": "Orient photographs: calibrated cameras, object points, report.",
    "status": "Show the stages of a project folder.",
    "photos": "Show what is known about photographs before they are oriented.",
    "frames": "Take frames from a video: sharp ones, far enough apart.",
    "targets": "Print coded targets; find and measure them in photographs.",
    "calibrate": "Calibrate cameras from photographs of coded targets or a board.",
    "measure": "Measure targets: coordinates, deviations from nominal, length errors.",
    "adjust": "Adjust a block and write a result folder with its report.",
    "mark": "Measure points by hand: marks, control, scale bars, undo; adjust them with the block.",
    "query": "Coordinates, distances, angles, areas, planes of a result, with standard deviations.",
    "datum": "The points of a result in a coordinate system by some of them.",
    "compare": "Put two results side by side.",
    "moved": "What has moved between measurements of the same points.",
    "merge": "Merge projects of one object into one block over their common points.",
    "convert": "Convert to and from the formats of other programs.",
    "spreadsheet": "The tables of a result as one workbook (.xlsx).",
    "studio": "Look, measure and adjust in the browser.",
    "record": "The recording sheet of a project: object, place, client, operator, rights.",
    "sheet": "A drawing sheet true to scale: pictures, points and lines, as PDF.",
    "rectify": "A picture to scale of a plane object: facade, floor, wall painting.",
    "surface": "Dense points of what the photographs show, each with its standard deviation.",
    "heights": "Volumes, sections, contours, terrain and movements from the heights of a surface.",
    "calibration": "Convert and compare calibrations; keep them in the camera library.",
    "datasets": "Fetch public sets of photographs, checked file by file.",
    "film": "Bring image points of scanned film into the camera's frame by its fiducial marks.",
    "rpc": "Satellite scenes: show, project, correct and make rational polynomials (RPC).",
    "empirical": "Fit affine, projective and DLT models to an image of an unknown sensor.",
    "plan": "Know what photographs will determine, before they are taken.",
    "simulate": "Write a simulated block and its truth.",
    "demo": "Simulate a calibration field, calibrate it, show truth beside estimate.",
    "estimate-cost": "Say what orienting and adjusting so many photographs takes: time, memory, disk.",
    "worker": "Do tasks of runs on other machines: for a scheduler, or a share of them.",
    "scheduler": "Be the scheduler of a cluster: who hands tasks of runs to workers.",
    "doctor": "Say what is installed, what is missing and what it would bring.",
}


def _print_version(ctx: click.Context, _: click.Parameter, value: bool) -> None:  # noqa: FBT001  (click's signature)
    if value and not ctx.resilient_parsing:
        from importlib.metadata import version  # noqa: PLC0415  (reads the metadata only where it is asked for)

        click.echo(f"raybundle {version('raybundle')}")
        ctx.exit()


@click.group(cls=LazyGroup)
@click.option(
    "--version", is_flag=True, expose_value=False, is_eager=True, callback=_print_version, help="The version."
)
def cli() -> None:
    """Survey-grade photogrammetry: photographs or blocks in, coordinates with true standard deviations out.

    \b
    Examples:
      raybundle demo                                  see it work
      raybundle orient facade/ --out facade-project
      raybundle adjust camcal21 --out camcal21-result
      raybundle adjust --help
    """  # noqa: D301  (\b is click's mark for a paragraph that keeps its lines)


INTERRUPTED = "interrupted; nothing was written"
cli.home, cli.told = "raybundle.cli", COMMANDS


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command line and return its exit status; errors go to stderr without a traceback."""
    arguments = list(sys.argv[1:] if argv is None else argv)
    for name in ("stdout", "stderr"):
        # closed from outside: what is shown goes nowhere (click before 8.1.4 would fail)
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_WRONLY), "w", encoding="utf-8"))
        _printable(getattr(sys, name))
    try:
        with on_the_command_line():
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
        _say(INTERRUPTED)
        _as_json(arguments, INTERRUPTED, 130)
        return 130
    except BrokenPipeError:
        silence(sys.stdout)  # the reader of our output went away: what stands in the buffer has nowhere to go
        return 1
    except Exception as error:  # noqa: BLE001  (the last resort; the message says how to see the rest)
        return _failed(arguments, error)
    return status if isinstance(status, int) else 0


def _failed(arguments: Sequence[str], error: Exception) -> int:
    """Say what went wrong, and return the exit status."""
    if "--traceback" in arguments:
        with contextlib.suppress(OSError, ValueError):
            traceback.print_exception(error)
    text, status = told_failure(error)
    _say(text)
    _as_json(arguments, text, status)
    return status


def _printable(stream: TextIO) -> None:
    """Let signs that a stream cannot encode (a pipe on Windows has a code page) be question marks, and no error."""
    if isinstance(stream, io.TextIOWrapper) and stream.errors == "strict":
        stream.reconfigure(errors="replace")


def _as_json(arguments: Sequence[str], text: str, status: int) -> None:
    """An error as an object on stdout, where JSON was asked for."""
    if "--json" in arguments:
        words = " ".join(command_words(cli, arguments))
        told = json.dumps({"command": words, "exit_status": status, "error": text}, ensure_ascii=False)
        with contextlib.suppress(OSError, ValueError):
            click.echo(told)


def _say(text: str) -> None:
    """A line on stderr, if anybody can read it."""
    try:
        click.echo(text, err=True)
    except (OSError, ValueError):
        silence(sys.stderr)
