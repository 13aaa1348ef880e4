"""Do two versions of the program give the same results?  Result files of ten blocks, number by number.

    python benchmarks/same_results.py OTHER_RAYBUNDLE [--work FOLDER]

OTHER_RAYBUNDLE is the command of the other version (`.venv/bin/raybundle` of a checkout of it).  Both adjust the same
block folders: published ones of RAYBUNDLE_DATA (default ../shared/data) and simulated ones with every kind of
observation.  Numbers of result.json and of all tables are compared; a number differs where it is apart by more than
1e-9 of the largest one of its column, or of its entry in result.json, and by more than one in the last place that is
written: numbers of results are rounded, and 1e-15 may tip the last.  Prints JSON: for each block how many numbers
were compared, and where how much differs.
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.adjustment.test_attitudes import noisy
from tests.truth.mixed_blocks import MonteCarlo, ikonos_pair, mixed, room, two_camera_rig
from tests.truth.platform_blocks import platform_block

from raybundle.block import Block
from raybundle.io.block.folder import write_block
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene

DATA = Path(os.environ.get("RAYBUNDLE_DATA", Path(__file__).resolve().parents[2] / "shared/data")) / "blocks"
PUBLISHED = ("roma", "sxb", "camcal21", "prague-s1", "riva-net1", "rc30-pair", "resection-mikhail")
MADE = {
    "targets": lambda: simulate(field_scene(TargetField()), Survey()).observed,
    "satellite": lambda: with_errors(ikonos_pair()),
    "panoramas": lambda: with_errors(room()),
    "mixed": lambda: with_errors(mixed()),
    "rig": lambda: with_errors(two_camera_rig()),
    "rolling": lambda: with_errors(platform_block("brown_rolling")),
    "airborne": noisy,
}
NOT_COMPARED = {"seconds", "cpu_seconds", "created", "version", "revision", "files", "stages", "machine", "warnings"}
ENOUGH = 1e-9


def with_errors(truth: Block) -> Block:
    """A block at its true values with errors of what is observed: without any, residuals are rounding."""
    return MonteCarlo.of(truth).noisy(np.random.default_rng(3))


def blocks(work: Path) -> dict[str, Path]:
    """Folders of the blocks."""
    found = {name: DATA / name for name in PUBLISHED if (DATA / name).is_dir()}
    for name, make in MADE.items():
        found[name] = work / "blocks" / name
        write_block(make(), found[name])
    return found


def adjusted(command: str, block: Path, out: Path) -> int:
    """Exit status of `raybundle adjust`."""
    run = [command, "adjust", str(block), "--out", str(out), "--no-report", "--jobs", "1"]
    return subprocess.run(run, capture_output=True, check=False).returncode


def last_place(text: str) -> float:
    """One in the last place of a number as it is written."""
    digits, _, power = text.lower().partition("e")
    return 10.0 ** (int(power or 0) - len(digits.partition(".")[2]))


Numbers = dict[str, list[tuple[float, float]]]
"""By file and column, each with one in its last place"""


def numbers_of(folder: Path) -> Numbers:
    """Every number of a result folder."""
    found: Numbers = {}

    def walk(value: object, name: str) -> None:
        if isinstance(value, dict):
            for key, inner in value.items():
                if key not in NOT_COMPARED:
                    walk(inner, f"{name}/{key}")
        elif isinstance(value, list):
            for inner in value:
                walk(inner, name)
        elif isinstance(value, int | float):
            found.setdefault(name, []).append((float(value), last_place(repr(float(value)))))

    for file in sorted(folder.rglob("*.json")):
        walk(json.loads(file.read_text()), file.name)
    for file in sorted(folder.rglob("*.csv")):
        for row in csv.DictReader(file.read_text().splitlines()):
            for key, cell in row.items():
                try:
                    number = float(cell), last_place(cell)
                    found.setdefault(f"{file.relative_to(folder)}/{key}", []).append(number)
                except (TypeError, ValueError):
                    continue
    return found


def apart(first: Numbers, second: Numbers) -> dict:
    """Where they differ."""
    compared, worst = 0, dict[str, float | str]()
    for name in sorted(first.keys() | second.keys()):
        (a, a_last), (b, b_last) = (np.array(x.get(name, [])).reshape(-1, 2).T for x in (first, second))
        if len(a) != len(b):
            worst[name] = f"{len(a)} and {len(b)} numbers"
            continue
        compared += len(a)
        scale = float(np.nanmax(np.abs(a), initial=0.0)) or 1.0
        same = (a == b) | (np.isnan(a) & np.isnan(b))
        same |= np.abs(a - b) <= 1.001 * np.maximum(a_last, b_last)
        gap = np.where(same, 0.0, np.abs(a - b) / scale)
        if not gap.max(initial=0.0) <= ENOUGH:
            worst[name] = float(gap.max())
    return {"numbers": compared, "differ": worst}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("other")
    parser.add_argument("--work", type=Path)
    asked = parser.parse_args()
    own = str(Path(sys.executable).parent / "raybundle")
    table = {}
    with tempfile.TemporaryDirectory() as temporary:
        work = asked.work or Path(temporary)
        for name, block in blocks(work).items():
            out = [work / side / name for side in ("other", "own")]
            status = [adjusted(c, block, o) for c, o in zip((asked.other, own), out, strict=True)]
            row = apart(*(numbers_of(o) for o in out)) if status[0] == status[1] and out[0].exists() else {}
            table[name] = {"status": status, **row}
    sys.stdout.write(json.dumps(table, indent=1) + "\n")
    return int(any(len(set(t["status"])) > 1 or t.get("differ") for t in table.values()))


if __name__ == "__main__":
    sys.exit(main())
