"""The figures of docs/how-to/heights.md are those of benchmarks/surface_heights.py."""

import json
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_figures_are_those_of_the_benchmark():
    page = " ".join((ROOT / "docs/how-to/heights.md").read_text().split())
    found = json.loads((ROOT / "benchmarks/results/surface_heights.json").read_text())
    cells, means, profiles, volumes = (found[k] for k in ("cells", "means", "profiles", "volumes"))
    assert found["cell_m"] == 0.01
    assert f"{100 * cells['within_1.96']:.0f} % of all heights lie within 1.96" in page
    assert f"{100 * cells['beyond_5']:.1f} % are off by more than five" in page
    robust = [q["apart"]["robust_chi2"] for q in (means, profiles, volumes)]
    assert (
        "robust chi-square of {:.2f}, heights along profiles {:.2f}, volumes over 60 x 60 cm {:.2f}.".format(*robust)
        in page
    )
    within = [q["apart"]["chi2_within_5"] for q in (means, profiles, volumes)]
    assert "{:.1f}, {:.1f} and {:.1f} without those beyond five".format(*within) in page
    assert f"there are {100 * means['apart']['beyond_5']:.1f} % of the means" in page
    assert not found["halves"]["alarms"]
    up, down = found["halves"]["moved"]
    assert f"as {abs(down['mean_mm']):.1f} and {up['mean_mm']:.1f} mm" in page
    for m in (up, down):
        assert m["regions"] == 1
        assert abs(m["mean_mm"] - m["by_mm"]) < 2 * m["sigma_mm"]
        assert abs(m["area"] - 0.09) < 2 * m["area_sigma"]
    apart = found["halves"]["off_steps"]["robust_chi2"]
    assert apart < 1.4
    assert f"off steps they differ by less than stated (robust chi-square {apart:.2f})" in page
    steps = found["steps"]["measured"]
    assert f"correlate by {steps['1']:.2f}, over 24 cells by {steps['24']:.2f}" in page
