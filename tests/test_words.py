"""Nothing reads words: what a program needs of an error or a notice stands beside them as data."""

import ast
import pkgutil
import re
from importlib import import_module

import pytest

import raybundle as rb
from raybundle import commands
from raybundle.cli.main import main
from raybundle.errors import InputError
from raybundle.settings import option, settings_of
from raybundle.words import COMMAND_LINE, reading
from tests.sources import trees

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
        name: lines
        for name, tree in trees(r"str\((error|problem)|\.message\b")
        if name.split("/")[0] in LAYERS and (lines := list(readings(tree)))
    }
    assert found == {}


def test_this_would_notice():
    for line in ("x = str(error).split(':')", "x = 'c of camera' in str(error)", "x = n.message.partition(': ')[2]"):
        assert list(readings(ast.parse(line)))


FLAG = re.compile(r"(?<![\w-])--[a-z]")
OF_OTHER_PROGRAMS = ("pyproj sync --file", "pip install --no-deps")
TELLS_COMMANDS = {"commands/show.py", "studio/products.py", "studio/runnable.py", "studio/verbs.py"}
"""What makes command lines: of actions, of runs, of the studio itself."""


def flags_in(tree):
    """Texts in which a flag of the command line stands."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            text = node.value
            for other in OF_OTHER_PROGRAMS:
                text = text.replace(other, "")
            if FLAG.search(text):
                yield node.lineno, text


def below_the_command_line(pattern):
    for name, tree in trees(pattern, without=("cli/",)):
        if name not in TELLS_COMMANDS:
            yield name, tree


def test_no_text_below_the_command_line_holds_a_flag():
    assert {name: found for name, tree in below_the_command_line("--[a-z]") if (found := list(flags_in(tree)))} == {}


def test_a_flag_would_be_noticed():
    assert list(flags_in(ast.parse("raise InputError(f'{n} cameras; give --from')")))
    assert not list(flags_in(ast.parse("x = 'a dash -- and a word, e-mail, --'")))


def options_named(tree):
    """Names of settings that messages name, with their flags where they are said."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "option":
            flag = next((k.value.value for k in node.keywords if k.arg == "flag"), "")
            if node.args and isinstance(node.args[0], ast.Constant):
                yield node.args[0].value, flag


def test_what_a_message_names_is_a_setting_under_its_flag():
    kinds = [
        value
        for module in pkgutil.walk_packages(commands.__path__, "raybundle.commands.")
        for name, value in vars(import_module(module.name)).items()
        if name.endswith("Settings")
    ]
    known = {(s.name, s.flag) for kind in kinds for s in settings_of(kind)} | BY_HAND
    asked = {
        (name, flag or name.replace("_", "-"))
        for _, tree in below_the_command_line(r"\boption\(")
        for name, flag in options_named(tree)
    }
    assert asked <= known


BY_HAND = {("port", "port"), ("overwrite", "overwrite")}
"""Options of the studio, and of all commands, which are no data class."""


def test_a_setting_is_spelt_as_its_reader_writes_it():
    assert option("size", "WIDTH", "HEIGHT") == "size=(WIDTH, HEIGHT)"
    assert option("crs", "EPSG:25832") == 'crs="EPSG:25832"'
    assert option("gps", False, flag="no-gps") == "gps=False"
    assert option("read_out", 25.0) == "read_out=25"
    assert option("control") == "control="
    with reading(COMMAND_LINE):
        assert option("size", "WIDTH", "HEIGHT") == "--size WIDTH HEIGHT"
        assert option("crs", "EPSG:25832") == "--crs EPSG:25832"
        assert option("gps", False, flag="no-gps") == "--no-gps"
        assert option("read_out", 25.0) == "--read-out 25"
        assert option("separate", "a b|c", flag="own-camera") == "--own-camera 'a b|c'"
    assert option("control") == "control="


def test_python_and_the_command_line_tell_the_same_error_each_in_its_way(tmp_path, capsys):
    with pytest.raises(InputError, match=r"read_as=.*format\.not_recognised"):
        rb.convert(tmp_path, tmp_path / "out", to="block")
    assert main(["convert", str(tmp_path), "--to", "block", "--out", str(tmp_path / "out")]) == 2
    assert "--from" in capsys.readouterr().err
