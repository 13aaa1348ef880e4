"""Notices are graded by data: one table of codes, one order in every place that shows them."""

import ast
import json
import re
from dataclasses import replace

import pytest

from raybundle.adjustment.notices import notices_of
from raybundle.adjustment.records.notice import Notice, gravest_first, sorted_notices
from raybundle.adjustment.records.severity import SEVERITY, Severity
from raybundle.adjustment.statistics.components import NAMES
from raybundle.cli.summary import SHOWN, lines, of_adjustment
from raybundle.report.sections.result import result_section
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of
from raybundle.results.contents import result_json
from raybundle.results.state import relative_heights, state_messages, state_words
from tests.sources import texts, trees

REMARK, CAUTION, FAULT = (
    Notice(code="not_significant", message="the remark"),
    Notice(code="small_angle", message="the caution"),
    Notice(code="control_suspect", message="the fault"),
)


def codes_of(call, kinds):
    """Codes of one `Notice(code=...)`, of a notice with numbers of its own, or of `....tell(code, ...)`."""
    name = call.func.id if isinstance(call.func, ast.Name) else getattr(call.func, "attr", "")
    if name in kinds:
        return [k.value for k in call.keywords if k.arg == "code"]
    return call.args[:1] if ast.unparse(call.func) == "state.tell" else []


def codes_in_the_source():
    found = {f"{kind}_suspect" for kind in NAMES} | {"start_behind", "start_parallel"}  # made of variables
    nodes = [n for _, tree in trees(r"Notice|state\.tell") for n in ast.walk(tree)]
    classes = [n for n in nodes if isinstance(n, ast.ClassDef)]
    kinds = {"Notice", *(c.name for c in classes if any(ast.unparse(b) == "Notice" for b in c.bases))}
    calls = [n for n in nodes if isinstance(n, ast.Call)]
    found |= {c.value for call in calls for c in codes_of(call, kinds) if isinstance(c, ast.Constant)}
    quoted = {t for text in texts().values() for t in re.findall(r'"(\w+(?:\.\w+)*)"', text)}
    found |= {t for t in quoted if t.partition(".")[0] in SEVERITY}  # codes chosen before the call
    return {code.partition(".")[0] for code in found}


def test_every_code_has_a_severity_and_no_severity_stands_without_its_code():
    assert len(SEVERITY) > 50
    assert codes_in_the_source() == set(SEVERITY)


def test_the_order_is_by_severity_and_keeps_the_order_within_one():
    second = replace(FAULT, message="another fault")
    assert gravest_first([REMARK, FAULT, CAUTION, second]) == [FAULT, second, CAUTION, REMARK]
    assert Notice(code="never seen", message="m").severity is Severity.WARNING


def test_many_notices_of_one_kind_are_read_as_one(case):
    """On the command line and in the report; the file keeps them all."""
    many = tuple(Notice(code="not_determinable", message=f"1: u{k:02} open", ids=("1", f"u{k:02}")) for k in range(69))
    three = tuple(Notice(code="small_angle", message=f"m{k}", ids=(f"i{k}",)) for k in range(3))
    ordered = sorted_notices((*three, *many, REMARK))
    assert [n.code for n in ordered] == ["not_determinable", *["small_angle"] * 3, REMARK.code]
    assert ordered[0].text.startswith("1: u00 open. ")
    assert "68" in ordered[0].text
    assert "1: u01, 1: u02, " in ordered[0].text
    assert ordered[0].text.endswith("1: u10, ...")
    assert len(ordered[0].ids) == 70
    a = replace(case("rich"), notices=(*many, REMARK))
    assert sum("not_determinable" in line for line in lines(of_adjustment(a, []), verbose=True)) == 1
    assert sum("u0" in w["message"] for w in result_json(a)["warnings"]) == 10


def test_report_command_line_and_file_show_the_gravest_first(case):
    a = replace(case("rich"), notices=(REMARK, CAUTION, FAULT))
    shown = next(p for p in result_section(view_of(a), verdict(view_of(a))).parts if p.kind == "table")
    assert [row[0].text if hasattr(row[0], "text") else row[0] for row in shown.rows] == ["fault", "warning", "note"]
    printed = [line.partition(": ")[0] for line in lines(of_adjustment(a, []), verbose=True)]
    assert [word for word in printed if word in set(Severity)] == ["fault", "warning", "note"]
    assert not any(line.startswith("note") for line in lines(of_adjustment(a, []), verbose=False))
    written = json.loads(json.dumps(result_json(a)["warnings"]))
    assert [(w["severity"], w["code"]) for w in written] == [
        ("fault", "control_suspect"), ("warning", "small_angle"), ("note", "not_significant"),
    ]  # fmt: skip


def test_a_fault_is_printed_however_many_remarks_stand_before_it(case):
    many = replace(case("rich"), notices=(*[REMARK] * (2 * SHOWN), *[CAUTION] * (2 * SHOWN), FAULT))
    printed = lines(of_adjustment(many, []), verbose=False)
    assert sum(line.startswith("fault") for line in printed) == 1
    assert sum(line.startswith(("fault", "warning")) for line in printed) <= SHOWN


@pytest.mark.parametrize(
    ("notices", "grade"),
    [((), "good"), ((REMARK,), "good"), ((REMARK, CAUTION), "remarks"), ((REMARK, CAUTION, FAULT), "attention")],
)
def test_the_headline_follows_the_worst_notice(case, notices, grade):
    found = verdict(view_of(replace(case("rich"), notices=notices)))
    assert found.grade == grade
    assert [m.values for m in found.headline.messages if m.code == "verdict.faults"] == (
        [{"n": 1}] if grade == "attention" else []
    )


def test_residuals_three_times_too_large_are_a_fault_and_too_small_ones_a_remark(case):
    a = case("rich")
    lower, _, upper = a.global_test
    for value, sigma0, severity in (
        (1.05 * upper, 1.05, Severity.NOTE),
        (2 * upper, 1.4, Severity.WARNING), (20 * upper, 4.5, Severity.FAULT), (0.5 * lower, 0.7, Severity.NOTE),
    ):  # fmt: skip
        changed = replace(a, global_test=(lower, value, upper), sigma0=sigma0)
        (told,) = [n for n in notices_of(changed, None) if n.code == "global_test"]
        assert told.severity is severity


def test_commands_grade_what_they_print_with_the_same_three_words():
    for path, tree in trees("caution:|remark:"):
        found = [n.value for n in ast.walk(tree) if isinstance(n, ast.Constant) and path.startswith("cli/")]
        assert [t for t in found if isinstance(t, str) and t.lstrip().startswith(("caution:", "remark:"))] == [], (
            path.name
        )


def test_heights_that_nobody_measured_travel_with_what_is_made_of_a_result():
    levelled = {"code": "levelled", "message": "heights of the control are not known", "severity": "warning"}
    relative = state_words({"warnings": [levelled]})
    assert [m.code for m in relative.messages] == ["state.heights_relative"]
    assert relative_heights(relative)
    assert [m.severity for m in state_messages(relative)] == ["warning"]
    assert [m.severity for m in state_messages(str(relative))] == ["warning"]
    wrong = {"code": "control_contradicts", "message": "P1", "severity": "fault"}
    found = state_words({"warnings": [levelled, wrong]})
    assert [m.code for m in found.messages] == ["state.faults", "state.fault_text", "state.heights_relative"]
    assert found.messages[0].values == {"n": 1}
    assert relative_heights(found)
    assert [(m.code, m.severity) for m in state_messages(found)] == [(m.code, "fault") for m in found.messages]
    assert [m.severity for m in state_messages(str(found))] == ["fault"]
    assert state_messages("") == []
    assert state_words({"warnings": [{"code": "model", "message": "x", "severity": "warning"}]}) == ""
