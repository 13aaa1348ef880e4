"""The figures of docs/explanation/pairs.md are those of benchmarks/retrieval.py."""

import json
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_figures_are_those_of_the_benchmark():
    page = " ".join((ROOT / "docs/explanation/pairs.md").read_text().split())
    found = json.loads((ROOT / "benchmarks/results/retrieval.json").read_text())
    pot, search = found["pot"], found["search"]
    photographs, recall = sum(pot["photographs"].values()), 100 * pot["recall"]
    assert (
        f"Of the {photographs} photographs of that pot {pot['pairs matched per photograph']:.1f} pairs each were "
        f"matched: they hold {recall:.1f} % of the {pot['right pairs']} pairs with 40 verified matches, and the "
        f"photographs fall into the same {pot['parts']} parts as with all {pot['all pairs']} pairs." in page
    )
    assert pot["same parts"]
    assert (
        f"took {pot['CPU s of the choice and its pairs']:.0f} CPU seconds, all pairs {pot['CPU s of all pairs']:.0f}"
        in page
    )
    assert f"Among {search['images'] // 1000} 000 signatures the search took {search['CPU s']:.0f} CPU seconds" in page
    assert f"and {search['peak memory MB']} MB, and found" in page
    assert f"{100 * search['share of the ten neighbours found']:.1f} % of the ten nearest" in page
