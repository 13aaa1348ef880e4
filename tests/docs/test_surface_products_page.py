"""The figures of docs/how-to/surface-products.md are those of benchmarks/surface_orthophoto.py."""

import json
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_figures_are_those_of_the_benchmark():
    page = " ".join((ROOT / "docs/how-to/surface-products.md").read_text().split())
    found = json.loads((ROOT / "benchmarks/results/surface_orthophoto.json").read_text())
    right, up, mesh, seams = (found[k] for k in ("right", "up", "mesh", "seams"))
    assert f"{100 * right['within_1.96']:.1f} and {100 * up['within_1.96']:.1f} % of the pixels" in page
    assert f"and {100 * max(right['beyond_5'], up['beyond_5']):.1f} % what lies beyond five" in page
    assert f"the error is {found['off_robust_mm']:.2f} mm" in page
    assert f"({seams['across']:.1f} and {seams['within']:.1f})" in page
    assert f"{100 * mesh['within_1.96']:.1f} % of them lie" in page
    assert f"{100 * mesh['beyond_5']:.1f} % beyond five" in page
    assert (found["cell_m"], found["pixel_m"]) == (0.01, 0.002)
    assert len(found["marks"]) == 8
    for mark in found["marks"]:
        for off, sigma in zip((mark["right_mm"], mark["up_mm"]), mark["sigma_mm"], strict=True):
            assert abs(off) < 2 * sigma, mark
