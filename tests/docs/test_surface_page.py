"""The figures of docs/explanation/surface.md are those of benchmarks/surface_truth.py."""

import json
from pathlib import Path

from tests.docs.figures import in_a_row

ROOT = Path(__file__).parents[2]


def between(values, digits, factor=1.0):
    """The smallest and the largest, as the page writes them."""
    return f"{factor * min(values):.{digits}f}", f"{factor * max(values):.{digits}f}"


def test_figures_are_those_of_the_benchmark():
    page = (ROOT / "docs/explanation/surface.md").read_text()
    found = json.loads((ROOT / "benchmarks/results/surface_truth.json").read_text())
    maps = found["portal"]["maps"]
    assert len(maps) == 4
    assert found["portal"]["density"] == 2
    everywhere, inside = ([m[name] for m in maps] for name in ("all", "interior"))
    assert in_a_row(
        page, *between([a["within_1.96"] for a in everywhere], 1, 100), "1.96",
        *between([a["within_1.96"] for a in inside], 1, 100), *between([a["beyond_5"] for a in everywhere], 1, 100),
        *between([m["error_mm"] for m in maps], 2),
    )  # fmt: skip
    near = [n for lag in ("4", "8", "16") for n in between([m["neighbours"][lag]["measured"] for m in maps], 2)]
    assert in_a_row(page, *near, "4", "8", "16")
    union = found["union"]
    assert union["density"] == 2
    confirmed = between([union["maps"][m["map"]]["confirmed"] for m in maps], 2)
    of_all = (f"{100 * union['all']['within_1.96']:.1f}", "1.96", f"{100 * union['all']['beyond_5']:.1f}")
    assert in_a_row(page, *between([m["complete"] for m in maps], 2), *confirmed)
    assert in_a_row(page, f"{union['covered']:.2f}", f"{union['alone']:.2f}", *of_all)
    assert min(m["error_mm"] / m["peers"]["sgbm"]["error_mm"] for m in maps) > 0.3
    assert max(m["error_mm"] / m["peers"]["sgbm"]["error_mm"] for m in maps) < 0.4  # a third
    # a fifth too small: a chi-square of 1.2^2
    assert max(max(m["contrast"]["0-6"], m["by_sources"]["1-2"]) for m in maps) < 1.2**2
    relief = found["fountain"]["noise_and_orientation"]
    assert 0.7 < relief["chi2_robust"] < 1.4
    assert relief["within_1.96"] < 0.95
