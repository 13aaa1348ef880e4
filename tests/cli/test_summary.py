"""What a command prints at its end: at most eight lines, with the rest behind --verbose and --json."""

import json

import pytest

from raybundle.adjustment.records.notice import Notice
from raybundle.cli.main import main
from raybundle.cli.summary import SHOWN, Summary, data, lines, loud
from raybundle.errors import Message, Severity, note
from raybundle.words import COMMAND_LINE, action, reading

FAULT = Message(code="mesh.no_triangles", values={"name": "b"}, severity=Severity.FAULT)
MANY = tuple(Notice(code="scale_unchecked", values={"n": 1, "names": [f"bar {k}"]}) for k in range(7))
REMARK = Notice(code="scale_checked", measured=Severity.NOTE)
DONE = (note("demo.interior", n=8, ratio=1.2, symbol="c"), note("summary.no_statistics"))


def summary(*notices):
    return Summary(done=DONE, notices=notices, next_step=note("summary.next_scale"), files=["a", "b"])


def test_eight_lines_however_much_is_wrong():
    printed = lines(summary(FAULT, *MANY, REMARK), verbose=False)
    assert len(printed) <= 8
    assert [line.partition(":")[0] for line in printed[2 : 2 + SHOWN]] == [FAULT.severity, *[MANY[0].severity] * 2]
    assert "5" in printed[2 + SHOWN]  # of eight, three are shown
    assert not any("scale_checked" in line for line in printed)


def test_verbose_leaves_nothing_out():
    printed = "\n".join(lines(summary(FAULT, *MANY, REMARK), verbose=True))
    assert printed.count("[scale_unchecked]") == len(MANY)
    assert "scale_checked" in printed


@pytest.mark.parametrize(("notices", "code"), [((), "summary.next_scale"), ((FAULT,), "mesh.no_triangles")])
def test_the_next_step_is_the_remedy_of_what_is_wrong(notices, code):
    with reading(COMMAND_LINE):
        printed = lines(summary(*notices), verbose=False)
        step = action(code, dict(FAULT.values)) if notices else note(code).headline()
    assert step
    assert any(line.endswith(step) for line in printed)


def test_a_quiet_command_prints_what_is_wrong_alone():
    assert len(loud(summary(FAULT, *MANY, REMARK))) == 1 + len(MANY)
    assert loud(summary(REMARK)) == []


def test_json_has_every_message_as_data():
    found = json.loads(json.dumps(data(summary(FAULT, *MANY, REMARK))))
    assert [m["code"] for m in found["summary"]] == ["demo.interior", "summary.no_statistics"]
    assert found["faults"][0]["values"] == {"name": "b"}
    assert len(found["warnings"]) == len(MANY)
    assert [m["code"] for m in found["notes"]] == ["scale_checked"]


def test_a_demonstration_prints_eight_lines(tmp_path, capsys):
    assert main(["demo", "--out", str(tmp_path / "demo")]) == 0
    printed = capsys.readouterr().out
    assert len(printed.splitlines()) <= 8
    assert len(printed.split()) <= 90
    block = str(tmp_path / "demo" / "block")
    assert main(["adjust", block, "--no-report", "--verbose", "--out", str(tmp_path / "r")]) == 0
    assert "sigma0" in capsys.readouterr().out
