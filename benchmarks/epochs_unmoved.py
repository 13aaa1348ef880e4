"""Real photographs as of several dates, in which nothing moved: every point or area called moved is a false alarm.

    python benchmarks/epochs_unmoved.py FOLDER... [--splits ab half]

FOLDER  photographs of one set, from eight on
Splits: ab (every second photograph), abba, abc (every third; from nine on), half (the first and the second half).
"""

from __future__ import annotations

import argparse
import os
import tempfile
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np

import raybundle as rb

DATES = ("2026-05-01", "2026-06-01", "2026-07-01")
SPLITS = ("ab", "abba", "abc", "half")
SUFFIXES = {".jpg", ".jpeg", ".png", ".tif", ".tiff"}


def dates_of(split: str, n: int) -> list[str]:
    """Of each of n photographs the date that it is given."""
    k = np.arange(n)
    of = {"ab": k % 2, "abba": np.isin(k % 4, [1, 2]), "abc": k % 3, "half": k >= n // 2}[split]
    return [DATES[d] for d in of.astype(int)]


def dated(photos: list[Path], split: str, folder: Path) -> tuple[Path, ...]:
    """Links to the photographs, a folder for each date."""
    for photo, date in zip(photos, dates_of(split, len(photos)), strict=True):
        place = folder / date
        place.mkdir(exist_ok=True)
        (place / photo.name).symlink_to(photo.resolve())
    return tuple(sorted(folder.iterdir()))


def main() -> None:
    """Print a line for each split, and the sums."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--splits", nargs="+", default=["ab", "half"], choices=SPLITS)
    asked = parser.parse_args()
    runs = false = untested = points = 0
    for folder in asked.folders:
        photos = sorted(p for p in folder.iterdir() if p.suffix.lower() in SUFFIXES)
        for split in asked.splits:
            if split == "abc" and len(photos) < 9:
                continue
            with tempfile.TemporaryDirectory() as work:
                add = dated(photos, split, Path(work))
                done = rb.epochs(Path(work) / "project", add=add, report=False)
                assert done.movements is not None
                verdict = dict.fromkeys(done.movements.displacements.point, "stable")
                for p, v in zip(done.movements.displacements.point, done.movements.displacements.verdict, strict=True):
                    verdict[p] = v if v in {"moved", "moved_area", "untested"} else verdict[p]
            count = {v: list(verdict.values()).count(v) for v in ("moved", "moved_area", "untested")}
            print(f"{folder.name:16s} {split:5s} {len(verdict):6d} points {count}", flush=True)
            runs, points, untested = runs + 1, points + len(verdict), untested + count["untested"]
            false += count["moved"] + count["moved_area"] > 0
    print(f"{runs} splits, {false} with a point or an area called moved; {untested} of {points} points untested")


if __name__ == "__main__":
    main()
