"""Which contradictions of given values are those of groups, and which those of control alone."""

import pytest

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.placing.conflicts import Conflict
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.workflows import adjust


@pytest.mark.parametrize(("groups", "kept"), [(("control",), 0), (("bars",), 1), (("bars", "control"), 2)])
def test_control_alone_has_tests_of_its_own(monkeypatch, groups, kept):
    block = simulate(field_scene(TargetField()), Survey(scale_bars=1)).observed
    found = [Conflict(group=g, count=1, sigma0=1.0) for g in groups]
    monkeypatch.setattr(adjust, "conflicts", lambda *_: found)
    assert len(adjust._conflicts(block, AdjustmentOptions())) == kept
