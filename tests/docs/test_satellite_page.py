"""The figures of docs/explanation/satellite-scenes.md are those of benchmarks/surface_scenes.py."""

import json
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_figures_of_surfaces_are_those_of_the_benchmark():
    page = (ROOT / "docs/explanation/satellite-scenes.md").read_text()
    kept = json.loads((ROOT / "benchmarks/results/surface_scenes.json").read_text())
    found = [kept["pair"], kept["triplet"]]

    def row(name, told):
        return f"| {name} | {told(found[0])} | {told(found[1])} |"

    def chi2(name):
        return lambda f: f"{f[name]['robust_chi2']:.2f}, {f[name]['mean_chi2'] + 1e-9:.2f}"

    assert row("tie points with a height beside them", lambda f: f["with_height"]) in page
    assert row("robust scatter of the differences", lambda f: f"{f['robust_m']:.2f} m") in page
    stated = "stated: intersection, height (noise, roughness, steps)"
    assert row(stated, lambda f: f"{f['sigma_point_m']:.2f}, {f['sigma_height_m']:.2f} m") in page
    assert row("chi-square, errors taken as independent: robust, mean", chi2("independent")) in page
    assert row("chi-square, estimates of the same data: robust, mean", chi2("of_the_same_data")) in page
    left = "heights of s2p after one shift in space: robust scatter"
    assert row(left, lambda f: f"{f['another']['left_robust_m']:.2f} m") in page
    assert row("within 2 m of them", lambda f: f"{100 * f['another']['left_within_2_m']:.2f} %") in page
    orientation = [f"{f['sigma_with_orientation_m']:.0f}" for f in found]
    assert f"{orientation[0]} and {orientation[1]} m" in page
