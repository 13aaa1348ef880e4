"""Run the notebooks of docs/gallery and store their outputs in them.

    python tools/generate_gallery.py                  run all, store what they print
    python tools/generate_gallery.py --check          run all, say where stored outputs differ from new ones
    python tools/generate_gallery.py space-resection  these alone

A notebook that needs public data ends with SystemExit where these are not; its stored outputs stay.  Stored are cells
with stable names and nothing that changes from run to run, so that a change of a number is a line of a difference.
"""

import argparse
import difflib
import os
import re
import sys
from dataclasses import dataclass
from itertools import zip_longest
from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

GALLERY = Path(__file__).resolve().parents[1] / "docs/gallery"
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
UNITS = 5
"""Of its last printed digit by which a number may differ from one processor to another"""
RELATIVE = 1e-9
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Executed:
    """A notebook with new outputs, or why it was not run."""

    notebook: Any
    skipped: str | None = None


def notebooks() -> list[Path]:
    """Of the gallery, in the order of their names."""
    return sorted(GALLERY.glob("*.ipynb"))


def execute(path: Path) -> Executed:
    """Run a notebook in the folder of the gallery; raises CellExecutionError where a cell fails."""
    notebook = nbformat.read(path, as_version=4)
    for variable in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):
        os.environ.setdefault(variable, "1")  # many small matrices
    client = NotebookClient(
        notebook, timeout=120, resources={"metadata": {"path": str(GALLERY)}},
        extra_arguments=["--IPKernelApp.log_level=40"],  # errors alone
    )  # fmt: skip
    try:
        client.execute()
    except CellExecutionError as error:
        if error.ename != "SystemExit":
            raise
        return Executed(notebook=nbformat.read(path, as_version=4), skipped=error.evalue)
    return Executed(notebook=_plain(notebook))


def _plain(notebook: Any) -> Any:
    """Without what changes from run to run."""
    notebook.metadata = nbformat.from_dict(METADATA)
    counts = {"code": 0, "markdown": 0}
    for at, cell in enumerate(notebook.cells, 1):
        cell.metadata = nbformat.from_dict({k: v for k, v in cell.metadata.items() if k == "tags"})
        cell.id = f"{at:02d}-{cell.cell_type}"
        counts[cell.cell_type] += 1
        if cell.cell_type != "code":
            continue
        cell.execution_count = counts["code"]
        for output in cell.outputs:
            if output.output_type == "execute_result":
                output.execution_count = counts["code"]
            output.pop("metadata", None)
            if output.output_type != "stream":
                output.metadata = {}
        cell.outputs = [o for o in cell.outputs if o.get("name") != "stderr"]
    return notebook


def printed(notebook: Any) -> str:
    """Everything that its cells print, in order; cells that draw are tagged `figure` and do not count."""
    told: list[str] = []
    for cell in notebook.cells:
        if "figure" in cell.metadata.get("tags", ()):
            continue
        for output in cell.get("outputs", ()):
            text = output.get("text") or output.get("data", {}).get("text/plain", "")
            told.append("".join(text).rstrip("\n"))
    return "\n".join(told)


def stale(stored: str, new: str) -> list[str]:
    """Lines that differ: in their words, or in a number by more than `UNITS` of its last printed digit."""
    wrong: list[str] = []
    for old, fresh in zip_longest(stored.splitlines(), new.splitlines()):
        if old is None or fresh is None or not _same(old, fresh):
            wrong += difflib.ndiff([] if old is None else [old], [] if fresh is None else [fresh])
    return wrong


def _same(old: str, new: str) -> bool:
    if [w.split() for w in NUMBER.split(old)] != [w.split() for w in NUMBER.split(new)]:
        return False
    return all(_close(a, b) for a, b in zip(NUMBER.findall(old), NUMBER.findall(new), strict=True))


def _close(a: str, b: str) -> bool:
    if a == b:
        return True
    mantissa, _, exponent = a.lower().partition("e")
    fraction = mantissa.partition(".")[2]
    if not fraction and not exponent:  # counts
        return False
    last = 10.0 ** (int(exponent or 0) - len(fraction))
    return abs(float(a) - float(b)) <= max(UNITS * last * (1 + 1e-9), RELATIVE * abs(float(a)))


def main() -> int:
    """Run, and store or compare."""
    parser = argparse.ArgumentParser(description="Run the notebooks of the gallery and store their outputs.")
    parser.add_argument("names", nargs="*", help="notebooks without .ipynb; all if none is named")
    parser.add_argument("--check", action="store_true", help="store nothing; exit 1 where stored outputs are stale")
    asked = parser.parse_args()
    every = {p.stem: p for p in notebooks()}
    status = 0
    for name in asked.names or every:
        path = every[name]
        done = execute(path)
        if done.skipped is not None:
            print(f"{name}: {done.skipped}")
            continue
        wrong = stale(printed(nbformat.read(path, as_version=4)), printed(done.notebook))
        if not asked.check:
            path.write_text(nbformat.writes(done.notebook, indent=1) + "\n", encoding="utf-8")
        print(f"{name}: {f'{len(wrong)} lines changed' if wrong else 'as stored'}")
        if asked.check and wrong:
            print("\n".join(wrong))
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
