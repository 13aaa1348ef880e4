"""Where commands write."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal, cast

import click


class Output(click.Path):
    """Where a command writes: that something can be written there is found out before anything is computed.

    wanted  "file", a new one, which is not overwritten unless that is asked for; "page", a file that a command knows
            to be its own; "folder"; "either", a new file or a folder
    """

    def __init__(self, wanted: Literal["file", "page", "folder", "either"]) -> None:
        super().__init__(path_type=Path)
        self.wanted: Literal["file", "page", "folder", "either"] = wanted

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The path; raises InputError where nothing can be written there, or what stands there would be lost."""
        from raybundle.io.folders import check_new_file, check_place

        path = cast("Path", super().convert(value, param, ctx))
        if not (ctx is not None and ctx.resilient_parsing):
            check_place(path, "file" if self.wanted == "page" else self.wanted)
            if self.wanted in {"file", "either"} and not path.is_dir():
                check_new_file(path)
        return path


NEW_FILE, NEW_PAGE, NEW_FOLDER, NEW_FILE_OR_FOLDER = Output("file"), Output("page"), Output("folder"), Output("either")
