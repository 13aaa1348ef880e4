"""The figures of docs/how-to/surface.md are those of benchmarks/surface_truth.py."""

import json
from pathlib import Path

ROOT = Path(__file__).parents[2]


def between(values, digits, factor=1.0):
    """The smallest and the largest, as the page writes them."""
    return f"{factor * min(values):.{digits}f} to {factor * max(values):.{digits}f}"


def test_figures_are_those_of_the_benchmark():
    page = " ".join((ROOT / "docs/how-to/surface.md").read_text().split())
    found = json.loads((ROOT / "benchmarks/results/surface_truth.json").read_text())
    maps = found["portal"]["maps"]
    assert len(maps) == 4
    assert found["portal"]["density"] == 2
    everywhere, inside = ([m[name] for m in maps] for name in ("all", "interior"))
    assert f"{between([a['within_1.96'] for a in everywhere], 1, 100)} % of all depths" in page
    assert f"and {between([a['within_1.96'] for a in inside], 1, 100)} % of those" in page
    assert f"{between([a['beyond_5'] for a in everywhere], 1, 100)} % are off by more than five" in page
    assert f"{between([m['error_mm'] for m in maps], 2)} mm at pixels" in page
    assert f"cover {between([m['complete'] for m in maps], 2)} of what" in page
    near = [between([m["neighbours"][lag]["measured"] for m in maps], 2) for lag in ("4", "8", "16")]
    assert f"{near[0]}, {near[1]} and {near[2]} at 4, 8 and 16 pixels" in page
    union = found["union"]
    assert union["density"] == 2
    assert f"and {between([union['maps'][m['map']]['confirmed'] for m in maps], 2)} with doubtful" in page
    assert f"cover {union['covered']:.2f} of the surface" in page
    assert f"({union['alone']:.2f} without doubtful depths)" in page
    assert f"{100 * union['all']['within_1.96']:.1f} % of these depths" in page
    assert f"and {100 * union['all']['beyond_5']:.1f} % are off" in page
    assert min(m["error_mm"] / m["peers"]["sgbm"]["error_mm"] for m in maps) > 0.3
    assert max(m["error_mm"] / m["peers"]["sgbm"]["error_mm"] for m in maps) < 0.4  # a third
    # a fifth too small: a chi-square of 1.2^2
    assert max(max(m["contrast"]["0-6"], m["by_sources"]["1-2"]) for m in maps) < 1.2**2
    relief = found["fountain"]["noise_and_orientation"]
    assert 0.7 < relief["chi2_robust"] < 1.4
    assert relief["within_1.96"] < 0.95
