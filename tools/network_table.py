"""Write the table of docs/explanation/calibration-networks.md; `--check` only compares.

python tools/network_table.py [--check]
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.planning.network.calibration_networks import ROLLS, FlatField, flat_field_scene
from raybundle.planning.simulate import Survey, simulate

PAGE = Path(__file__).resolve().parents[1] / "docs/explanation/calibration-networks.md"
BEGIN, END = "<!-- table: tools/network_table.py -->\n", "<!-- end of the table -->\n"
SURVEY = Survey(orientation="exact", points="exact", interior="exact", image_sigma_px=0.05)
PLANS = {
    "square, one distance": FlatField(tilt_deg=0.0, shift=0.1),
    "square, three distances": FlatField(tilt_deg=0.0, shift=0.1, distances=(1.2, 1.5, 1.8)),
    "walking round, image-up to the middle, 30°": FlatField(tilt_deg=30.0, up_to_centre=True),
    **{
        f"tilt {t}°, {words}": FlatField(tilt_deg=float(t), rolls_deg=rolls)
        for t in (5, 10, 20, 30, 45)
        for words, rolls in (("no rolls", (0.0,)), ("rolls 0, 90, 180, 270°", ROLLS))
    },
}


def rows() -> list[str]:
    """Lines of the table."""
    lines = ["| network | sigma c [px] | sigma x0 | sigma y0 | not determinable |", "|---|---|---|---|---|"]
    for name, plan in PLANS.items():
        result = adjust_block(simulate(flat_field_scene(plan), SURVEY).observed, AdjustmentOptions(jobs=1))
        camera = result.given.cameras[0]
        parameters = result.interior[0].parameters
        std = [(parameters[s].std or np.nan) / result.sigma0 / camera.pixel_mm[0] for s in ("c", "x0", "y0")]
        lost = [s for s in ("c", "x0", "y0", "K1", "K2", "K3") if parameters[s].status == "not determinable"]
        cells = [("–" if s in lost else f"{v:.2f}") for s, v in zip(("c", "x0", "y0"), std, strict=True)]
        lines.append(f"| {name} | {' | '.join(cells)} | {', '.join(lost) or 'none'} |")
    return lines


def main() -> int:
    """Write or compare; 1 if the page differs."""
    text = PAGE.read_text(encoding="utf-8")
    head, rest = text.split(BEGIN)
    new = head + BEGIN + "\n" + "\n".join(rows()) + "\n\n" + END + rest.split(END)[1]
    if "--check" in sys.argv[1:]:
        if new != text:
            print(f"{PAGE.name} is not what tools/network_table.py writes; run it")
        return int(new != text)
    PAGE.write_text(new, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
