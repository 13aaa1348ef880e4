"""Write the table of docs/explanation/uav-precision.md; `--check` only compares.

python tools/uav_table.py [--check]
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.planning.flights.uav_networks import Flight, flight_block

PAGE = Path(__file__).resolve().parents[1] / "docs/explanation/uav-precision.md"
BEGIN, END = "<!-- table: tools/uav_table.py -->\n", "<!-- end of the table -->\n"
PLANS = {
    "one heading": Flight(),
    "headings alternate": Flight(alternating=True),
    "headings alternate, and 4 cross lines looking down": Flight(alternating=True, cross_tilt_deg=0.0),
    "headings alternate, and 4 cross lines tilted 15°": Flight(alternating=True, cross_tilt_deg=15.0),
    "headings alternate, and 4 cross lines tilted 30°": Flight(alternating=True, cross_tilt_deg=30.0),
    "one heading, exactly level": Flight(height_jitter=0.0, angle_jitter_deg=0.0),
    "headings alternate, exactly level": Flight(alternating=True, height_jitter=0.0, angle_jitter_deg=0.0),
    "exactly level, and 4 cross lines tilted 30°": Flight(
        alternating=True, cross_tilt_deg=30.0, height_jitter=0.0, angle_jitter_deg=0.0
    ),
}


def rows() -> list[str]:
    """Lines of the table."""
    lines = [
        "| flight | photographs | sigma X [mm] | Y | Z | sigma c [px] | not determinable |",
        "|---|---|---|---|---|---|---|",
    ]
    for name, plan in PLANS.items():
        result = adjust_block(flight_block(plan), AdjustmentOptions(jobs=1))
        lost = [n.split()[0] for n in result.not_determinable]
        cells = ["–"] * 4 if lost else _figures(result)
        cells = [str(len(result.given.images)), *cells, ", ".join(lost) or "none"]
        lines.append(f"| {name} | {' | '.join(cells)} |")
    return lines


def _figures(result: Adjustment) -> list[str]:
    assert result.precision is not None
    rms = 1e3 * np.sqrt(np.mean((result.precision.object_point_std / result.sigma0) ** 2, axis=0))
    c = (result.interior[0].parameters["c"].std or np.nan) / result.sigma0 / result.given.cameras[0].pixel_mm[0]
    return [*(f"{v:.0f}" for v in rms), f"{c:.1f}"]


def main() -> int:
    """Write or compare; 1 if the page differs."""
    text = PAGE.read_text(encoding="utf-8")
    head, rest = text.split(BEGIN)
    new = head + BEGIN + "\n" + "\n".join(rows()) + "\n\n" + END + rest.split(END)[1]
    if "--check" in sys.argv[1:]:
        if new != text:
            print(f"{PAGE.name} is not what tools/uav_table.py writes; run it")
        return int(new != text)
    PAGE.write_text(new, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
