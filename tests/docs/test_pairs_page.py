"""The figures of docs/explanation/pairs.md are those of benchmarks/retrieval.py."""

import json
from pathlib import Path

from tests.docs.figures import in_a_row

ROOT = Path(__file__).parents[2]


def test_figures_are_those_of_the_benchmark():
    page = (ROOT / "docs/explanation/pairs.md").read_text()
    found = json.loads((ROOT / "benchmarks/results/retrieval.json").read_text())
    pot, search = found["pot"], found["search"]
    pairs, chosen = pot["pairs matched per photograph"], pot["CPU s of the choice and its pairs"]
    assert pot["same parts"]
    assert in_a_row(
        page, f"{sum(pot['photographs'].values())}", f"{pairs:.1f}", f"{100 * pot['recall']:.1f}",
        f"{pot['right pairs']}", "40", f"{pot['parts']}", f"{pot['all pairs']}", f"{chosen:.0f}",
        f"{pot['CPU s of all pairs']:.0f}", f"{search['images'] // 1000}", "000", f"{search['CPU s']:.0f}",
        f"{search['peak memory MB']}", f"{100 * search['share of the ten neighbours found']:.1f}",
    )  # fmt: skip
