"""Predicted against achieved: what a plan of a result's stations promises, beside what its adjustment states.

python benchmarks/plan_achieved.py RESULT=CLASS[:SCALE] ...      as fountain/result=natural cern=retro:3

Known beforehand are the stations, the surface that the points span (discs, hidden by each other), the camera, and the
class of what is measured (`planning.measured`: sigma of an image coordinate, share of photographs in which a point is
found); nothing of what was measured where.  SCALE is by how much the photographs were made smaller after they were
taken.  Written: the median over the points of predicted by stated sigma; the largest of the predicted map by the
largest of the stated one (medians over sixty patches of the surface); the same with the image sigma of the result.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from threadpoolctl import threadpool_limits

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.planning.achieved import achieved

OUT = Path(__file__).with_name("results") / "plan_achieved.json"


def main() -> None:
    """Compare, print and write."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", nargs="+")
    told = {}
    for text in parser.parse_args().results:
        path, _, words = text.partition("=")
        name, _, scale = words.partition(":")
        folder = Path(path)
        with threadpool_limits(1):
            told[folder.name] = achieved(folder / "result" if (folder / "result").is_dir() else folder, name,
                                         float(scale or 1))  # fmt: skip
        print(folder.name, json.dumps(told[folder.name]))
    OUT.write_text(json.dumps(told, indent=1) + "\n")


if __name__ == "__main__":
    main()
