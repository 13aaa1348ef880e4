"""The figures of docs/explanation/surface.md are those of benchmarks/surface_orthophoto.py."""

import json
from pathlib import Path

from tests.docs.figures import in_a_row

ROOT = Path(__file__).parents[2]


def test_figures_are_those_of_the_benchmark():
    page = (ROOT / "docs/explanation/surface.md").read_text()
    found = json.loads((ROOT / "benchmarks/results/surface_orthophoto.json").read_text())
    right, up, mesh, seams = (found[k] for k in ("right", "up", "mesh", "seams"))
    within = (f"{100 * q['within_1.96']:.1f}" for q in (right, up))
    beyond = f"{100 * max(right['beyond_5'], up['beyond_5']):.1f}"
    assert in_a_row(page, *within, "1.96", beyond, f"{found['off_robust_mm']:.2f}")
    assert f"({seams['across']:.1f} and {seams['within']:.1f})" in page
    assert in_a_row(page, f"{100 * mesh['within_1.96']:.1f}", "1.96", f"{100 * mesh['beyond_5']:.1f}")
    assert (found["cell_m"], found["pixel_m"]) == (0.01, 0.002)
    assert len(found["marks"]) == 8
    for mark in found["marks"]:
        for off, sigma in zip((mark["right_mm"], mark["up_mm"]), mark["sigma_mm"], strict=True):
            assert abs(off) < 2 * sigma, mark
