"""Foreign bytes become numbers, trees and rows in raybundle.io.reading alone."""

import ast

import pytest
from tests.sources import trees

OWN_WAYS = ("io/reading/", "words/")
"""Where bytes become numbers, and where the program reads its own catalogues"""
READERS = ("io", "targets", "cli", "report", "workflows", "scenes", "block")
"""Packages in which words of files, or of the command line, become numbers."""
MODULES = {"tomllib", "configparser", "pickle", "marshal", "shelve", "yaml"}
CALLS = {
    "csv": {"reader", "DictReader", "Sniffer"},
    "json": {"load", "loads", "JSONDecoder"},
    "ast": {"literal_eval"},
    "np": {"fromstring", "loadtxt", "genfromtxt", "fromregex"},
}
OWN = {"own_json_of"}
WORDS = {"word", "words", "text", "cell", "cells", "match", "found", "groups", "utm", "token"}
"""Names that hold pieces of text in the readers."""


def modules(pattern, within=("",)):
    found = trees(pattern, within=within, without=OWN_WAYS)
    return ((name, tree) for name, tree in found if "generated" not in name.split("/"))


def foreign(tree):
    """Imports and calls that read a format themselves."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (f"import {a.name}" for a in node.names if a.name.partition(".")[0] in MODULES)
        elif isinstance(node, ast.ImportFrom):
            top = (node.module or "").partition(".")[0]
            taken = {a.name for a in node.names}
            if top in MODULES or taken & CALLS.get(top, set()):
                yield f"from {node.module} import {', '.join(sorted(taken))}"
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            name = node.func.value.id if isinstance(node.func.value, ast.Name) else ""
            if node.func.attr in CALLS.get(name, set()):
                yield f"{name}.{node.func.attr}"


def converted(tree):
    """float(...) and int(...) of what is a text by its name, by being a piece of a match, or by a ValueError caught."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Try) and any(
            h.type is not None and "ValueError" in ast.dump(h.type) for h in node.handlers
        ):
            calls = [c for statement in node.body for c in ast.walk(statement)]
        else:
            calls = [node] if isinstance(node, ast.Call) and node.args and is_text(node.args[0]) else []
        for call in calls:
            if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id in {"int", "float"}:
                yield ast.unparse(call)
        if is_map(node) and ast.unparse(node.args[0]) in {"int", "float"}:
            yield ast.unparse(node)


def is_map(node):
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "map"


def is_text(node):
    if isinstance(node, ast.Subscript):
        return is_text(node.value) and isinstance(node.slice, ast.Constant | ast.Slice | ast.UnaryOp)
    if isinstance(node, ast.Call):
        return isinstance(node.func, ast.Attribute) and node.func.attr in {"split", "strip", "group", "replace"}
    return isinstance(node, ast.Name) and node.id in WORDS


def test_no_module_reads_a_format_itself():
    names = "|".join([*MODULES, *(name for called in CALLS.values() for name in called)])
    found = {name: sorted(set(foreign(tree))) for name, tree in modules(rf"\b({names})\b")}
    assert {p: what for p, what in found.items() if what} == {}


def test_no_reader_converts_words_itself():
    within = [f"{folder}/" for folder in READERS]
    found = {name: list(converted(tree)) for name, tree in modules(r"\b(int|float)\(|map\((int|float)", within)}
    assert {p: what for p, what in found.items() if what} == {"report/text/numbers.py": ["float(text)"]}


def test_what_the_program_wrote_itself_is_read_in_one_module():
    users = [
        name for name, tree in modules("|".join(OWN)) if OWN & {n.id for n in ast.walk(tree) if isinstance(n, ast.Name)}
    ]
    assert users == ["io/block/arrays.py"]


@pytest.mark.parametrize(
    "code",
    [
        "import tomllib", "from csv import reader", "from json import loads", "import json\njson.loads('1')",
        "import ast\nast.literal_eval('1')", "import numpy as np\nnp.loadtxt('a')", "import pickle",
    ],
)  # fmt: skip
def test_the_test_would_notice_a_format(code):
    assert list(foreign(ast.parse(code)))


@pytest.mark.parametrize(
    "code",
    [
        "float(word)",
        "int(match[1])",
        "float(text.strip())",
        "list(map(float, x))",
        "try:\n  float(q)\nexcept ValueError: 1",
    ],
)
def test_the_test_would_notice_a_word(code):
    assert list(converted(ast.parse(code)))
