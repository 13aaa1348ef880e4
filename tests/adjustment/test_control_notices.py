"""What is stated of control: wrong points before possibly wrong ones, and control that fits too well."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import minimize_scalar
from scipy.stats import chi2

from raybundle.adjustment.blunders.control_notices import control_notices, not_located, precise_control_notices
from raybundle.adjustment.blunders.control_tests import Contradiction, WrongPoint
from raybundle.adjustment.decision.previous_knowledge import _by_noise
from raybundle.adjustment.records.figures import VarianceComponent
from raybundle.adjustment.statistics.components import LEAST, NAMES


def wrong(name, others=(), w=6.0):
    return WrongPoint(name=name, w=w, shift=np.array([1.0, 2.0, 3.0]), square=40.0, limit=5.0, others=others)


def stated(found, *notices):
    result = SimpleNamespace(notices=notices, given=SimpleNamespace(length_unit="m"))
    return control_notices(result, found)


def test_what_is_located_stands_before_what_is_not():
    found = Contradiction(wrong=(wrong("A", w=9.0), wrong("B", ("C",)), wrong("D")), swayed=("S",))
    located, open_one = stated(found)
    assert (located.data.code, located.ids) == ("control_suspect", ("A", "D"))
    assert [m.code for m in located.details] == ["control_suspect.point"] * 2 + ["control_suspect.swayed"]
    first = located.details[0].values
    assert [first[k] for k in ("point", "w", "limit", "dx", "dy", "dz")] == ["A", 9.0, 5.0, 1.0, 2.0, 3.0]
    assert (open_one.code, open_one.ids) == ("control_not_located", ("B", "C"))
    assert {"n": 2, "point": "B", "w": 6.0, "limit": 5.0}.items() <= open_one.values.items()


def test_a_group_is_named_once_and_not_where_a_notice_names_it_already():
    found = Contradiction(wrong=(wrong("A", ("B",)), wrong("B", ("A",)), wrong("D")))
    assert [n.ids for n in stated(found)] == [("D",), ("A", "B")]
    before = not_located(("B", "E"), 6.0, 5.0)
    assert [n.ids for n in stated(found, before)] == [("D",)]
    assert [n.ids for n in stated(found, replace(before, code="other"))] == [("D",), ("A", "B")]
    assert [n.ids for n in stated(found, not_located(("D", "E"), 6.0, 5.0))] == [("A", "B")]
    (last,) = stated(Contradiction(unexplained=("A", "D")))
    assert (last.data.code, last.ids, last.values["n"]) == ("control_suspect.unexplained", ("A", "D"), 2)
    assert not stated(Contradiction())


@pytest.mark.parametrize("redundancy", [LEAST - 0.01, LEAST + 0.01, 40.0])
def test_control_fits_too_well_from_one_percent_on(redundancy):
    """The sum of squares is that low by chance in one case of a hundred; a kind of noise alone states it."""

    def stated_of(wider, *, kind="fields", groups=False):
        own = VarianceComponent(
            kind=NAMES["control"], group="all", count=9, redundancy=redundancy, ratio=2.0 / wider, significant=False
        )
        return precise_control_notices(
            SimpleNamespace(
                noise=SimpleNamespace(kind=kind), options=SimpleNamespace(variance_groups=groups), sigma0=2.0,
                variance_components=(replace(own, kind="distances", ratio=0.01), own),
            )
        )  # fmt: skip

    at = np.sqrt(redundancy / chi2(redundancy).ppf(0.01))
    assert bool(stated_of(1.001 * at)) is (redundancy >= LEAST)
    assert not stated_of(0.999 * at)
    assert not stated_of(1.001 * at, kind="white")
    assert not stated_of(1.001 * at, groups=True)
    if redundancy >= LEAST:
        assert stated_of(1.001 * at)[0].values["wider"] == pytest.approx(1.001 * at)


@pytest.mark.parametrize("sigma0", [0.5, 1.2, 1.5, 3.0])
def test_noise_enlarges_residuals_of_what_was_known_by_its_worst_case(sigma0):
    """Over all precisions a of the photographs: c^2 (c + s^2 a) / (c + a)^2 over c."""
    share = minimize_scalar(lambda a: -(1 + sigma0**2 * a) / (1 + a) ** 2, bounds=(0, 50), method="bounded")
    assert _by_noise(SimpleNamespace(sigma0=sigma0)) == pytest.approx(max(-share.fun, 1.0), rel=1e-4)
