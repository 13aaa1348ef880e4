"""Options and phrases that several commands share."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal, cast

import click

from raybundle.numerics.counting import counted, grouped, significant

__all__ = [
    "COMMAND_SETTINGS",
    "FOLDER",
    "NEW_FILE",
    "NEW_FILE_OR_FOLDER",
    "NEW_FOLDER",
    "TRACEBACK",
    "Output",
    "common_options",
    "counted",
    "grouped",
    "significant",
]  # fmt: skip
COMMAND_SETTINGS = {"help_option_names": ["-h", "--help"], "max_content_width": 110}
FOLDER = click.Path(path_type=Path)


class Output(click.Path):
    """Where a command writes: that something can be written there is found out before anything is computed."""

    def __init__(self, wanted: Literal["file", "folder", "either"]) -> None:
        super().__init__(path_type=Path)
        self.wanted: Literal["file", "folder", "either"] = wanted

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The path; raises InputError where nothing can be written there."""
        from raybundle.io.folders import check_place  # noqa: PLC0415

        path = super().convert(value, param, ctx)
        if not (ctx is not None and ctx.resilient_parsing):
            check_place(cast("Path", path), self.wanted)
        return path


NEW_FILE, NEW_FOLDER, NEW_FILE_OR_FOLDER = Output("file"), Output("folder"), Output("either")


TRACEBACK = click.option(
    "--traceback", is_flag=True, expose_value=False, help="After an error, show where in the program it arose."
)


def common_options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add --progress (an argument `progress`) and --traceback (looked up by `main`)."""
    function = TRACEBACK(function)
    return click.option(
        "--progress",
        type=click.Choice(["auto", "json", "none"]),
        default="auto",
        show_default=True,
        help="auto: a bar on a terminal, nothing when piped; json: a JSON object a line on stderr.",
    )(function)


class SeveralNames(click.Command):
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
