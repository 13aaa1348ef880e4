"""The figures of docs/explanation/heights.md are those of benchmarks/surface_heights.py."""

import json
from pathlib import Path

from tests.docs.figures import in_a_row

ROOT = Path(__file__).parents[2]


def test_figures_are_those_of_the_benchmark():
    page = (ROOT / "docs/explanation/heights.md").read_text()
    found = json.loads((ROOT / "benchmarks/results/surface_heights.json").read_text())
    cells, means, profiles, volumes = (found[k] for k in ("cells", "means", "profiles", "volumes"))
    assert found["cell_m"] == 0.01
    assert in_a_row(page, f"{100 * cells['within_1.96']:.0f}", "1.96", f"{100 * cells['beyond_5']:.1f}")
    of_means, of_profiles, of_volumes = (f"{q['apart']['robust_chi2']:.2f}" for q in (means, profiles, volumes))
    assert in_a_row(page, "20", "20", of_means, of_profiles, "60", "60", of_volumes)
    within = [f"{q['apart']['chi2_within_5']:.1f}" for q in (means, profiles, volumes)]
    steps = found["steps"]["measured"]
    correlations = (f"{steps['1']:.2f}", "24", f"{steps['24']:.2f}")
    assert in_a_row(page, *within, f"{100 * means['apart']['beyond_5']:.1f}", *correlations)
    assert not found["halves"]["alarms"]
    up, down = found["halves"]["moved"]
    for m in (up, down):
        assert m["regions"] == 1
        assert abs(m["mean_mm"] - m["by_mm"]) < 2 * m["sigma_mm"]
        assert abs(m["area"] - 0.09) < 2 * m["area_sigma"]
    apart = found["halves"]["off_steps"]["robust_chi2"]
    assert apart < 1.4
    moved = (f"{abs(down['mean_mm']):.1f}", f"{up['mean_mm']:.1f}")
    assert in_a_row(page, correlations[-1], f"{apart:.2f}", "3", "30", "30", *moved)
