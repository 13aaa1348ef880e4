"""Every rule of network design: its direction, its factors, and what the page says of it."""

import re
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from raybundle.planning.rules import in_order, rules, told
from raybundle.planning.rules.resolution import fitted, matched

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import rules_page  # noqa: E402

NAMES = [r.name for r in in_order()]


@cache
def evidence(name):
    return rules[name].evidence()


@pytest.mark.parametrize("name", NAMES)
def test_the_rule_holds(name):
    assert rules[name].broken(evidence(name)) == []


@pytest.mark.parametrize("name", NAMES)
def test_the_page_says_what_is_computed(name):
    """Every number of a sentence or a table; those of the figure too."""
    rule = rules[name]
    page = rules_page.PAGE.read_text(encoding="utf-8")
    written = re.search(rf'<a id="{name}"></a>.*?(?=<a id=|## Literature)', page, re.DOTALL)
    assert written
    assert rules_page.same(written.group(0).strip(), rules_page.section(rule, evidence(name)).strip())
    picture = (rules_page.IMAGES / f"{name}.svg").read_text(encoding="utf-8")
    assert rules_page.same(picture, rules_page.figure(rule, evidence(name)))
    assert told(rule, evidence(name)).statement in page


@pytest.mark.parametrize("name", NAMES)
def test_a_rule_has_sources_and_limits_for_numbers_that_it_computes(name):
    rule = rules[name]
    assert rule.sources
    assert rule.limits
    assert set(rule.limits) <= set(evidence(name).numbers)


def test_the_page_has_every_rule_once_and_its_literature():
    page = rules_page.PAGE.read_text(encoding="utf-8")
    assert re.findall(r'<a id="([\w-]+)"></a>', page) == NAMES
    assert sorted(p.stem for p in rules_page.IMAGES.glob("*.svg")) == sorted(NAMES)
    assert page.endswith(rules_page.literature())


def test_a_page_that_differs_is_noticed():
    assert rules_page.same("falls to 1 / 6.6", "falls to 1 / 6.7")
    assert not rules_page.same("falls to 1 / 6.6", "falls to 1 / 6.8")
    assert not rules_page.same("falls to 1 / 6.6", "rises to 1 / 6.6")


def test_factors_as_the_covariance_gives_them():
    """45 against 10 degrees, rolls, four against eight rays, distances: within 2 % of what is frozen here.

    The networks are fixed and their observations exact, so that only a change of program can move them.
    """
    frozen = {
        ("convergence", "c"): 6.57, ("convergence", "c_axes"): 8.60, ("convergence", "points"): 3.94,
        ("rolls", "x0"): 13.9, ("rolls", "y0"): 20.2, ("rolls", "c"): 1.0, ("rays", "four_eight"): np.sqrt(2),
        ("distances", "c"): 1.64, ("distances", "x0"): 2.60,
    }  # fmt: skip
    for (name, key), value in frozen.items():
        assert evidence(name).numbers[key] == pytest.approx(value, rel=0.02), (name, key)


@pytest.mark.parametrize("step", [1, 4])
def test_what_matching_and_targets_state_is_true(step):
    """Errors over stated standard deviations; 36 windows and 24 targets tell it to a fifth."""
    error, cov = matched(step, 0.25, 2.0)
    assert 0.7 < np.sqrt(np.mean(error**2 / cov[:, :2])) < 1.4
    error, cov = fitted(step)
    assert 0.6 < np.sqrt(np.mean(error**2 / np.diagonal(cov, axis1=1, axis2=2))) < 1.4
