"""What a plan counts with beforehand is what was learned, and what the documentation says."""

import json
import re
from pathlib import Path
from typing import get_args

import numpy as np
import pytest

from raybundle.commands.planning.network import MeasuredName
from raybundle.planning.measured import measured_kinds

ROOT = Path(__file__).parents[2]
LEARNED = json.loads((ROOT / "benchmarks/results/plan_classes.json").read_text())
PAGE = (ROOT / "docs/how-to/plan-photographs.md").read_text()


def test_every_class_can_be_asked_for():
    assert set(get_args(MeasuredName)) == set(measured_kinds)


def test_natural_points_are_as_learned():
    natural = measured_kinds["natural"]
    assert natural.sigma_px == round(LEARNED["alike_sigma_px"]["median"], 2)
    assert natural.most == round(LEARNED["all"]["most"], 2)
    assert natural.half_deg == round(LEARNED["all"]["half_deg"])
    assert natural.width_deg == round(LEARNED["all"]["width_deg"])


@pytest.mark.parametrize("kind", measured_kinds.values(), ids=lambda k: k.name)
def test_the_page_says_what_is_counted_with(kind):
    row = re.search(rf"^\| `{kind.name}`: [^|]*\| ([\d.]+) px \| ([^|]*) \|$", PAGE, re.MULTILINE)
    assert float(row[1]) == kind.sigma_px
    square, slant = kind.found(np.cos(np.radians([0.0, kind.half_deg])))
    if kind.half_deg < 90:
        assert f"{100 * square:.0f} %" in row[2]
        assert f"{100 * slant:.0f} % at {kind.half_deg:.0f} degrees" in row[2]
    else:
        assert row[2] == "always"


def test_the_page_says_how_true_it_is():
    achieved = json.loads((ROOT / "benchmarks/results/plan_achieved.json").read_text())
    natural = [a["median_ratio"] for a in achieved.values() if a["class"] == "natural"]
    retro = [a["median_ratio"] for a in achieved.values() if a["class"] == "retro"]
    said = f"{min(natural):.2f} to {max(natural):.2f} of the standard deviations"
    assert said in " ".join(PAGE.split())
    assert f"targets {retro[0]:.2f};" in " ".join(PAGE.split())
