"""What a plan counts with beforehand is what was learned, and what the documentation says."""

import json
import re
from pathlib import Path
from typing import get_args

import numpy as np
import pytest

from raybundle.commands.planning.network import MeasuredName
from raybundle.planning.measured import FREE_CAMERA, measured_kinds

ROOT = Path(__file__).parents[2]
LEARNED = json.loads((ROOT / "benchmarks/results/plan_classes.json").read_text())
PAGE = (ROOT / "docs/how-to/plan-photographs.md").read_text()


def test_every_class_can_be_asked_for():
    assert set(get_args(MeasuredName)) == set(measured_kinds)


@pytest.mark.parametrize("name", sorted(LEARNED["classes"]))
def test_natural_points_are_as_learned(name):
    kind, learned = measured_kinds[name], LEARNED["classes"][name]
    assert kind.sigma_px == round(learned["alike_sigma_px"]["median"], 2)
    assert kind.most == round(learned["most"], 2)
    assert kind.half_deg == round(learned["half_deg"])
    assert kind.width_deg == round(learned["width_deg"])
    low, high = learned["alike_sigma_px"]["least"], learned["alike_sigma_px"]["most"]
    assert f"{low:.2f} to {high:.2f} px" in kind.source or f"{low:.2f} and {high:.2f} px" in kind.source


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
    page = " ".join((ROOT / "docs/explanation/plan-precision.md").read_text().split())
    natural = [a for a in achieved.values() if a["class"] in {"natural", "phone"}]
    for free, words in ((False, "{:.2f} to {:.2f} of the standard deviations"), (True, "only {:.2f} to {:.2f}")):
        ratios = [a["median_ratio"] for a in natural if bool(a["free"]) is free]
        assert words.format(min(ratios), max(ratios)) in page
    times = sorted(round(1 / a["median_ratio"], 1) for a in natural if a["free"])
    assert (times[0], times[-1]) == FREE_CAMERA
    retro = [a["median_ratio"] for a in achieved.values() if a["class"] == "retro"]
    assert f"targets {retro[0]:.2f};" in page
