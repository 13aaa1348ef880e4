"""Judge the tie points of an orientation by the truth of a rendered set: tools/judge_points.py FOLDER PROJECT.

FOLDER is what tools/render.py wrote, PROJECT the folder of
raybundle orient FOLDER/photos --out PROJECT --control FOLDER/control.csv --mark-sigma 0.05

Control gives the frame: nothing is fitted. The errors of the orientation are part of the errors that are judged, as
they are part of the standard deviations. For results without control, --datum fit moves, turns and scales the points
onto the true surface first (seven parameters, from smooth ground and slopes). Errors from the true surface are those
along the way that is shortest in units of the covariance of the point, and along the normal of the plane of best fit in
its window, which leans away from the rays at a step.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from renderer.judging import by_class, fitted, read_points
from renderer.truth import read_surface

KINDS = {
    "surface": "from the true surface, along the shortest way by the covariance",
    "normal": "from the true surface, along the normal of the plane of best fit in the window",
    "window": "from the mean of the surface over the window",
}


def main() -> None:
    """Read the command line and print a table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("project", type=Path, help="with result/points.csv in it, or the points.csv itself")
    parser.add_argument("--window", type=float, default=6.0, help="half side of the matching window, pixels")
    parser.add_argument("--datum", choices=["control", "fit"], default="control")
    parser.add_argument("--flag-column", default="flag", help="of points.csv; points that have it are judged apart")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    surface = read_surface(options.folder)
    table = options.project if options.project.suffix == ".csv" else options.project / "result" / "points.csv"
    points = read_points(table, options.flag_column)
    half = options.window * surface.gsd
    coordinates = points.coordinates
    if options.datum == "fit":
        coordinates, _ = fitted(coordinates, surface, half, points.sigma)
    found = {
        kind: [
            {"class": name, "flagged": label, **numbers}
            for name, label, numbers in by_class(surface, points, coordinates, half, kind)
        ]
        for kind in KINDS
    }
    if options.json:
        print(json.dumps({"datum": options.datum, "window_px": options.window, **found}, indent=1))
        return
    for kind, rows in found.items():
        print(f"errors {KINDS[kind]}")
        print("class               n  chi-square  > 5 sigma  sigma mm  error mm  Spearman")
        for row in rows:
            label = f"{row['class']} {row['flagged']}".strip()
            print(
                f"{label:<16}{row['n']:>5}{row['chi_square']:>12.2f}{100 * row['beyond_5_sigma']:>9.1f} %"
                f"{row['sigma_mm']:>10.3f}{row['error_mm']:>10.3f}{row['spearman']:>10.2f}"
            )


if __name__ == "__main__":
    main()
