"""The figures of docs/explanation/satellite-scenes.md are those of benchmarks/surface_scenes.py."""

import json
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_figures_of_surfaces_are_those_of_the_benchmark():
    page = (ROOT / "docs/explanation/satellite-scenes.md").read_text()
    kept = json.loads((ROOT / "benchmarks/results/surface_scenes.json").read_text())
    found = [kept["pair"], kept["triplet"]]

    def chi2(name):
        return lambda f: f"{f[name]['robust_chi2']:.2f}, {f[name]['mean_chi2'] + 1e-9:.2f}"

    rows = (
        lambda f: f"{f['with_height']}", lambda f: f"{f['robust_m']:.2f} m",
        lambda f: f"{f['sigma_point_m']:.2f}, {f['sigma_height_m']:.2f} m", chi2("independent"),
        chi2("of_the_same_data"), lambda f: f"{f['another']['left_robust_m']:.2f} m",
        lambda f: f"{100 * f['another']['left_within_2_m']:.2f} %",
    )  # fmt: skip
    table = [[cell.strip() for cell in line.split("|")[2:-1]] for line in page.splitlines() if line.startswith("|")]
    first = table.index(["pair", "triplet"]) + 2
    assert table[first : first + len(rows)] == [[row(f) for f in found] for row in rows]
    orientation = [f"{f['sigma_with_orientation_m']:.0f}" for f in found]
    assert f"{orientation[0]} and {orientation[1]} m" in page
