"""Modules import downward only: no circle, imports for types and within functions included."""

import ast
import re
import tomllib
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

SOURCE = Path(__file__).parents[2] / "src/raybundle"
FROM = re.compile(r"^ *from (raybundle[\w.]*) import (\([^)]*\)|[^\n#]*)", re.MULTILINE)


def imports():
    """The modules of the package, and which of them each imports; the face of the package left out."""
    modules = {}
    for path in SOURCE.rglob("*.py"):
        parts = ("raybundle", *path.relative_to(SOURCE).with_suffix("").parts)
        modules[".".join(parts[: -1 if parts[-1] == "__init__" else None])] = path
    found = {}
    for name, path in modules.items():
        named = set()
        for module, words in FROM.findall(path.read_text(encoding="utf-8")):
            for word in re.findall(r"\w+", re.sub(r" as \w+|#.*", "", words)):
                named.add(k if (k := f"{module}.{word}") in modules else module)
        found[name] = {k for k in named & modules.keys() if k not in (name, "raybundle")}
    return found


def test_no_module_imports_itself_by_way_of_others():
    found = imports()
    assert len(found) > 1000
    try:
        TopologicalSorter(found).prepare()
    except CycleError as error:
        raise AssertionError(" -> ".join(error.args[1])) from None


def test_modules_that_a_package_lists_are_there():
    lost = []
    for path in SOURCE.rglob("__init__.py"):
        text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""
        there = {p.stem for p in path.parent.iterdir()}
        listed = re.findall(r"^(\w+) {2,}\S", text, re.MULTILINE)
        lost += [f"{path.parent.name}: {name}" for name in listed if name not in there]
    assert not lost


def test_the_architecture_page_has_the_layers():
    contracts = tomllib.loads((SOURCE.parents[1] / "pyproject.toml").read_text("utf-8"))["tool"]["importlinter"]
    layers = next(c["layers"] for c in contracts["contracts"] if c["containers"] == ["raybundle"])
    page = (SOURCE.parents[1] / "docs/explanation/architecture.md").read_text("utf-8")
    table = page.partition("| layer |")[2].partition("\n\n")[0]
    shown = [name for row in table.splitlines()[2:] for name in re.findall(r"`(\w+)`", row.split("|")[1])]
    assert sorted(shown) == sorted(re.findall(r"\w+", " ".join(layers[1:])))
