"""The list of long tests names tests that there are, and is chosen by seconds and by blocks that are run."""

import json
import re
import sys
from pathlib import Path

import numpy as np
import pytest

from tests import slow

ROOT = Path(__file__).parents[2]
sys.path.append(str(ROOT / "benchmarks"))

import block_coverage  # noqa: E402
import short_suite  # noqa: E402
from block_coverage import merged, packed, unpacked  # noqa: E402


def test_every_name_is_that_of_a_test():
    gone = []
    for name in slow.names():
        file, _, rest = name.partition("::")
        function = re.split(r"::|\[", rest)[-1 if "::" in rest.partition("[")[0] else 0]
        path = ROOT / file
        if not path.is_file() or f"def {function}(" not in path.read_text(encoding="utf-8"):
            gone.append(name)
    assert not gone


CPU = {"tests/a.py::cheap": 0.05, "tests/a.py::one": 1.0, "tests/a.py::two": 0.6, "tests/a.py::both": 1.1,
       "tests/a.py::nothing": 0.7, "tests/a.py::too_long": 1.6, "tests/smoke/test_s.py::demo": 9.0,
       "tests/words/t.py::same": 0.8, "tests/a.py::case[x]": 0.9, "tests/a.py::case[y]": 0.8}  # fmt: skip
RAN = {"cheap": "1000", "one": "0100", "two": "0010", "both": "0110", "nothing": "1000", "too_long": "1111",
       "demo": "1000", "same": "1000", "case[x]": "1000", "case[y]": "1000"}  # fmt: skip


def coverage(ran):
    rows = [["", 0, packed(np.array([False] * 4))]]
    rows += [[name, s, packed(np.array([*map(int, ran[name.rpartition(":")[2]])]))] for name, s in CPU.items()]
    return merged(None, rows, ["a 1", "a 2", "a 3", "b 1"])


def chosen_at(tmp_path, monkeypatch, *arguments):
    monkeypatch.setattr(slow, "LIST", tmp_path / "slow.txt")
    slow.LIST.write_text("tests/a.py::two\ntests/b.py::elsewhere\n")
    (tmp_path / "map").write_text(json.dumps(coverage(RAN)))
    (tmp_path / "cpu").write_text("".join(f"{s} {name}\n" for name, s in CPU.items()))
    monkeypatch.setattr("sys.argv", ["short_suite.py", str(tmp_path / "cpu"), *arguments])
    short_suite.main()
    return {name.rpartition(":")[2] for name in slow.names()}


def test_what_brings_no_block_becomes_long(tmp_path, monkeypatch):
    found = chosen_at(tmp_path, monkeypatch, "--map", str(tmp_path / "map"), "--times", "1")
    assert found == {"nothing", "too_long", "one", "two", "case[x]", "elsewhere"}
    found = chosen_at(tmp_path, monkeypatch, "--map", str(tmp_path / "map"), "--times", "2")
    assert found == {"nothing", "too_long", "case[x]", "elsewhere"}


def test_blocks_of_the_core_are_run_more_often(tmp_path, monkeypatch):
    monkeypatch.setattr(short_suite, "SOURCE", ROOT)
    monkeypatch.setattr(short_suite, "CORE", ["a"])
    found = chosen_at(tmp_path, monkeypatch, "--map", str(tmp_path / "map"), "--core-times", "2")
    assert found == {"nothing", "too_long", "case[x]", "elsewhere"}


def test_what_later_ones_made_needless_is_not_chosen():
    ran = np.array([[1, 1, 0, 0], [1, 0, 1, 0], [0, 1, 0, 1]])
    assert short_suite.chosen(ran, np.array([1.0, 1.2, 1.2]), np.zeros(4), 1) == [1, 2]


def test_what_long_tests_run_alone_is_counted(tmp_path):
    (tmp_path / "map").write_text(json.dumps(coverage(RAN)))
    table = block_coverage.Map(tmp_path / "map")
    long = {"tests/a.py::one", "tests/a.py::two", "tests/a.py::both", "tests/a.py::too_long"}
    assert short_suite.alone(table, long) == {"tests/a.py::too_long": 3}
    assert short_suite.alone(table, long - {"tests/a.py::one"}) == {"tests/a.py::too_long": 2}


def test_without_a_map_what_takes_too_long_becomes_long(tmp_path, monkeypatch):
    assert chosen_at(tmp_path, monkeypatch) == {"too_long", "two", "elsewhere"}


SOURCE = "def f(a):\n    if a:\n        a += 1\n    for b in a:\n        print(b)\n    return a\n"


def test_a_condition_is_marked_on_both_sides(tmp_path, monkeypatch):
    (tmp_path / "m.py").write_text(SOURCE)
    keys = [key for key, _, _ in block_coverage.marked(block_coverage.tree_of(tmp_path / "m.py"))]
    assert keys == ["..f 1", "..f 1 past 0", "..f 2", "..f 3"]
    scope = {"ran_": bytearray(5)}
    exec(block_coverage.instrumented(tmp_path / "m.py", 1), scope)  # noqa: S102
    assert scope["f"](()) == ()
    assert list(scope["ran_"]) == [0, 1, 1, 0, 0]
    assert scope["f"]([]) == []


def test_a_map_keeps_tests_that_were_not_measured_now(monkeypatch):
    monkeypatch.setattr(block_coverage, "is_there", lambda test: test != "tests/a.py::two")
    earlier = coverage(RAN)
    now = [["", 0, packed(np.array([False] * 2))], ["tests/a.py::one", 0.2, packed(np.array([True, False]))]]
    found = merged(earlier, now, ["b 1", "c 1"])
    assert found["blocks"] == ["b 1", "c 1", "a 1", "a 2", "a 3"]
    assert found["tests"].keys() == CPU.keys() - {"tests/a.py::two"}
    assert list(unpacked(found["tests"]["tests/smoke/test_s.py::demo"][1], 5)) == [False, False, True, False, False]
    assert list(unpacked(found["tests"]["tests/a.py::one"][1], 5)) == [True, False, False, False, False]
    again = merged(found, [now[0]], ["a 1", "a 2"])
    assert again["blocks"] == ["a 1", "a 2", "b 1", "c 1"]


def test_a_function_that_is_gone_is_not_there():
    assert block_coverage.is_there("tests/tools/test_slow.py::test_a_part_is_one_of_all[0/7]")
    assert not block_coverage.is_there("tests/tools/test_slow.py::test_that_there_never_was")
    assert not block_coverage.is_there("tests/gone.py::test_a_part_is_one_of_all")


@pytest.mark.parametrize("text", ["0/7", "8/7", "x", "1"])
def test_a_part_is_one_of_all(text):
    assert slow.part("2/7") == (2, 7)
    with pytest.raises(ValueError):
        slow.part(text)


def test_measuring_appends_seconds(tmp_path):
    step = slow.Measured(tmp_path / "cpu").pytest_runtest_call(type("Item", (), {"nodeid": "tests/a.py::t"}))
    next(step)
    with pytest.raises(StopIteration):
        next(step)
    assert re.fullmatch(r"0\.\d\d tests/a\.py::t\n", (tmp_path / "cpu").read_text())
