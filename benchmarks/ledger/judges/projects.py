"""Projects of photographs: made by the command of a set, and kept in its cache folder."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

from ledger import ROOT
from ledger.sets import NotHere


def oriented(photos: Path, cache: Path, arguments: list[str]) -> Path:
    """The project of `raybundle orient PHOTOS --out CACHE/project ARGUMENTS`; what is there is taken.

    raises  NotHere with the last line of the command where it makes no result
    """
    project = cache / "project"
    if not (project / "result" / "result.json").exists():
        called("orient", str(photos), "--out", str(project), "--no-library", "--no-report", *arguments)
    return project


def called(*arguments: str) -> None:
    """Run one command of raybundle.

    raises  NotHere with its last line where it fails
    """
    command = [sys.executable, "-m", "raybundle", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        lines = [line for line in (done.stderr or done.stdout).splitlines() if line.strip()]
        raise NotHere(f"raybundle {arguments[0]} ends with {done.returncode}: {lines[-1] if lines else ''}")


def rendered(arguments: list[str], folder: Path) -> Path:
    """The folder of a rendered set, by tools/render.py; a whole one that is there is taken."""
    if not folder.exists():
        unfinished = folder.with_name(f"{folder.name}.unfinished")
        shutil.rmtree(unfinished, ignore_errors=True)
        command = [sys.executable, str(ROOT / "tools" / "render.py"), *arguments, "--out", str(unfinished)]
        subprocess.run(command, check=True, capture_output=True)
        unfinished.rename(folder)
    return folder
