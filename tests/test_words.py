"""Nothing reads words: what a program needs of an error or a notice stands beside them as data."""

import ast
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[1] / "src/raybundle"
LAYERS = ("adjustment", "orientation", "workflows", "block", "scenes", "report")
READING = {"partition", "split", "startswith", "endswith", "search", "match", "findall", "find", "index"}


def is_words(node):
    """Whether an expression is the text of an error or of a notice."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "str":
        return any(isinstance(a, ast.Name) and a.id in {"error", "problem"} for a in node.args)
    return isinstance(node, ast.Attribute) and node.attr == "message"


def readings(tree):
    for node in ast.walk(tree):
        words = []
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in READING:
            words = [node.func.value, *node.args]
        elif isinstance(node, ast.Compare) and any(isinstance(op, ast.In | ast.NotIn) for op in node.ops):
            words = node.comparators
        if any(is_words(n) for n in words):
            yield node.lineno


def test_nothing_reads_the_words_of_errors_and_notices():
    found = {
        str(path.relative_to(SOURCE)): lines
        for layer in LAYERS
        for path in sorted((SOURCE / layer).rglob("*.py"))
        if (lines := list(readings(ast.parse(path.read_text()))))
    }
    assert found == {}


def test_this_would_notice():
    for line in ("x = str(error).split(':')", "x = 'c of camera' in str(error)", "x = n.message.partition(': ')[2]"):
        assert list(readings(ast.parse(line)))
