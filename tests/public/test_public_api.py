"""The public interface is what tests/public/public_api.txt says: a change of it is seen in review."""

import difflib
import importlib.util
from pathlib import Path

import pytest

TOOL = Path(__file__).resolve().parents[2] / "tools/public_api.py"


@pytest.fixture(scope="module")
def tool():
    spec = importlib.util.spec_from_file_location("public_api", TOOL)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_interface_is_the_stored_one(tool):
    stored = tool.FILE.read_text(encoding="utf-8").splitlines()
    changed = list(difflib.unified_diff(stored, tool.interface().splitlines(), "stored", "now", lineterm="", n=1))
    assert not changed, "\n".join([*changed, "if that is meant: python tools/public_api.py --write"])


def test_what_a_change_looks_like(tool):
    def before(a: "int", *, b: "str" = "x") -> "None":
        """Nothing."""

    def after(a: "int", b: "str" = "y", *more: "float") -> "None":
        """Nothing."""

    assert list(tool.function_lines("f", before, "")) == ["f() -> None", "    a: int", "    *", "    b: str = 'x'"]
    assert list(tool.function_lines("f", after, "")) == [
        "f() -> None", "    a: int", "    b: str = 'y'", "    *more: float"]  # fmt: skip

    def evaluated(a: int) -> None:
        """Annotated by objects, whose words are not the same with every Python."""

    with pytest.raises(TypeError, match="from __future__ import annotations"):
        list(tool.function_lines("f", evaluated, ""))


def test_what_a_class_inherits_is_told(tool):
    lines = list(tool.class_lines("InputError", __import__("raybundle").InputError))
    assert lines[0] == "class InputError(RaybundleError)"
    assert any(line.startswith("    __init__()") for line in lines)
