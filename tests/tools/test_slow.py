"""The list of long tests names tests that there are."""

import re
from pathlib import Path

import pytest

from tests import slow

ROOT = Path(__file__).parents[2]


def test_every_name_is_that_of_a_test():
    gone = []
    for name in slow.names():
        file, _, rest = name.partition("::")
        function = re.split(r"::|\[", rest)[-1 if "::" in rest.partition("[")[0] else 0]
        path = ROOT / file
        if not path.is_file() or f"def {function}(" not in path.read_text(encoding="utf-8"):
            gone.append(name)
    assert not gone


def test_what_is_measured_becomes_the_list(tmp_path, monkeypatch):
    monkeypatch.setattr(slow, "LIST", tmp_path / "slow.txt")
    (tmp_path / "slow.txt").write_text("tests/a.py::test_was_long\ntests/b.py::test_elsewhere\n")
    (tmp_path / "cpu").write_text(
        "0.10 tests/a.py::test_was_long\n2.00 tests/a.py::test_long[x y]\n9.00 tests/smoke/test_s.py::test_demo\n"
    )
    slow.main([tmp_path / "cpu"])
    assert slow.names() == {"tests/a.py::test_long[x y]", "tests/b.py::test_elsewhere"}


def test_measuring_appends_seconds(tmp_path):
    step = slow.Measured(tmp_path / "cpu").pytest_runtest_call(type("Item", (), {"nodeid": "tests/a.py::t"}))
    next(step)
    with pytest.raises(StopIteration):
        next(step)
    assert re.fullmatch(r"0\.\d\d tests/a\.py::t\n", (tmp_path / "cpu").read_text())
