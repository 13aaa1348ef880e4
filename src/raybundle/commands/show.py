"""A result to look at, from Python: its report or its network in the browser, or the studio."""

from __future__ import annotations

import atexit
import subprocess
import sys
import tempfile
import webbrowser
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Literal

from raybundle.adjustment.result import Adjustment
from raybundle.commands.new_project import measuring_folder
from raybundle.commands.opening import hand_over
from raybundle.errors import InputError
from raybundle.report.show import Page, show_page
from raybundle.report.write import write_result
from raybundle.results.folder import ResultFolder

SECONDS = 10.0
"""In which a studio ends that is asked to"""


@dataclass(frozen=True, slots=True, kw_only=True)
class RunningStudio:
    """A studio that runs beside this program, until it is stopped or this program ends."""

    address: str
    """To open in a browser; it lets in once."""
    folder: Path
    """What is open: project, result or block folder; what is measured is kept in or beside it."""
    process: subprocess.Popen[str]

    def stop(self) -> None:
        """End it; what was measured is kept."""
        self.process.terminate()
        try:
            self.process.wait(SECONDS)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        if self.process.stdout is not None:
            self.process.stdout.close()

    def __repr__(self) -> str:
        """Where it is."""
        state = "" if self.process.poll() is None else ", ended"
        return f"<studio of {self.folder}: {self.address}{state}>"

    def _repr_html_(self) -> str:
        """A link that opens it."""
        address = escape(self.address, quote=True)
        return f'<a href="{address}" target="_blank" rel="noopener">studio of {escape(str(self.folder))}</a>'


def show(
    result: Adjustment | ResultFolder | str | Path, path: str | Path | None = None, *,
    what: Literal["", "report", "network", "studio"] = "", photos: Sequence[str | Path] = (),
) -> Page | RunningStudio:  # fmt: skip
    """Show the report of a result, its network in three dimensions, or the studio, in the browser.

    result   an adjustment; or a project, result or block folder, or a folder of photographs, for the studio
    path     of a report or network the HTML file, of a studio the result folder that an adjustment is written to;
             None: in a new temporary folder, which stays
    what     "": the report of an adjustment, the studio of a folder
    photos   folders where the photographs are, for the studio
    returns  the page, which a notebook shows within itself, or the running studio: `.address`, `.stop()`.  In a
             notebook, and where no browser can be opened, none is
    raises   InputError where there is nothing to open
    """
    what = what or ("report" if isinstance(result, Adjustment) else "studio")
    if what != "studio":
        if not isinstance(result, Adjustment):
            from raybundle.io.reading.words import quoted

            raise InputError("studio.page_of_folder", page=quoted(what))
        return show_page(result, path, what=what)
    folder = _folder_of(result, path)
    process = _begun(folder, photos)
    found = RunningStudio(address=_address(process, folder), folder=folder, process=process)
    atexit.register(found.stop)
    if "ipykernel" not in sys.modules:
        page = hand_over(found.address, Path(tempfile.mkdtemp(prefix="raybundle-")))
        atexit.register(page.unlink, missing_ok=True)
        with suppress(webbrowser.Error):
            webbrowser.open(page.as_uri())
    return found


def _folder_of(result: Adjustment | ResultFolder | str | Path, path: str | Path | None) -> Path:
    """A folder that the studio opens."""
    if isinstance(result, Adjustment):
        folder = Path(tempfile.mkdtemp(prefix="raybundle-")) / "result" if path is None else Path(path)
        write_result(result, folder, report="none")
        return folder
    if path is not None:
        raise InputError("studio.path_of_folder")
    return result.path if isinstance(result, ResultFolder) else measuring_folder(Path(result))


def _begun(folder: Path, photos: Sequence[str | Path]) -> subprocess.Popen[str]:
    """The command line's studio as a process of its own: it answers while this program computes."""
    where = [word for p in photos for word in ("--photos", str(p))]
    command = [sys.executable, "-m", "raybundle", "studio", "--no-browser", *where, "--", str(folder)]
    return subprocess.Popen(  # noqa: S603  (this program itself)
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, encoding="utf-8", errors="replace"
    )


def _address(process: subprocess.Popen[str], folder: Path) -> str:
    """The address that a studio prints; raises InputError with what it stated where it ends before."""
    assert process.stdout is not None
    stated: list[str] = []
    for line in process.stdout:
        stated.append(line)
        if "http://" in line:
            return line[line.index("http://") :].strip()
    process.wait()
    process.stdout.close()
    output = "".join(stated).strip()
    raise InputError("studio.not_started", folder=str(folder), status=process.returncode, n=len(output), detail=output)
