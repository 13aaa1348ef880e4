"""A result that replaces one whose scale was known says so."""

import json

import pytest

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.write import write_result
from raybundle.workflows.orienting.previous_result import less_fixed


def adjusted(control):
    survey = Survey(control=control, control_sigma=(1e-4, 1e-4, 1e-4))
    return adjust(simulate(field_scene(TargetField(stations=6)), survey).observed, AdjustmentOptions(jobs=1))


@pytest.fixture(scope="module")
def results():
    return adjusted(4), adjusted(0)


def test_a_result_of_arbitrary_scale_over_one_of_known_scale_is_a_caution(results, tmp_path):
    fixed, free = results
    write_result(fixed, tmp_path / "result", report="none")
    lost = less_fixed(tmp_path / "result", free)
    assert lost is not None
    assert lost.severity == "warning"
    assert "scale" in lost.text
    assert less_fixed(tmp_path / "result", fixed) is None


def test_nothing_is_said_where_nothing_is_lost_or_nothing_can_be_read(results, tmp_path):
    fixed, free = results
    write_result(free, tmp_path / "result", report="none")
    assert less_fixed(tmp_path / "result", fixed) is None
    assert less_fixed(tmp_path / "result", free) is None
    assert less_fixed(tmp_path / "absent", free) is None
    for text in ("{", "[]", json.dumps({"datum_defect": 3})):
        (tmp_path / "result" / "result.json").write_text(text)
        assert less_fixed(tmp_path / "result", free) is None
