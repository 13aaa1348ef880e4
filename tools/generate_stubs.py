"""Write src/raybundle/__init__.pyi, which editors and type checkers read: every public name, keywords written out.

python tools/generate_stubs.py            write it
python tools/generate_stubs.py --check    exit status 1 where it differs

A function that takes settings stands there with each of them: type, default and help.  Other names are imported.
"""

from __future__ import annotations

import argparse
import ast
import builtins
import functools
import importlib
import inspect
import sys
import textwrap
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import raybundle
from raybundle.settings import settings_of

HOME: dict[str, str] = vars(raybundle)["_HOME"]
FILE = Path(raybundle.__file__).with_suffix(".pyi")
COMMON = {"Any": "typing", "Literal": "typing", "Path": "pathlib", "Sequence": "collections.abc"}
"""Names in the types of settings, which the module of the function need not import"""
WIDTH = 120
LONG = 40
"""Characters of a default that is written out"""


def stub() -> str:
    """The text of the file."""
    public = {n: getattr(raybundle, n) for n in sorted(raybundle.__all__) if n != "__version__"}
    taking = {n: value for n, value in public.items() if inspect.isfunction(value) and hasattr(value, "settings")}
    imports = {n: f"from raybundle.{HOME[n]} import {n} as {n}" for n in public.keys() - taking.keys()}
    types = dict(public)
    for function in taking.values():
        for name, line, type_ in needed(function):
            if types.setdefault(name, type_) is not type_:
                raise ValueError(f"{function.__name__}: another type is named {name}")
            imports.setdefault(name, line)
    listed = "\n".join(f'    "{n}",' for n in sorted(raybundle.__all__))
    return "\n".join([
        '"""Written by tools/generate_stubs.py; do not edit."""\n', *sorted(imports.values()), "",
        f"__all__ = [\n{listed}\n]\n\n__version__: str",
        *(f"\n{definition(function)}:\n{docstring(function)}" for function in taking.values()), "",
    ])  # fmt: skip


def definition(function: Callable[..., Any]) -> str:
    """The head of a function, a line each parameter."""
    signature = inspect.signature(function)
    lines, keyword = [f"def {function.__name__}("], False
    for p in signature.parameters.values():
        if p.kind is p.KEYWORD_ONLY and not keyword:
            keyword = True
            lines.append("    *,")
        star = {p.VAR_KEYWORD: "**", p.VAR_POSITIONAL: "*"}.get(p.kind, "")
        keyword = keyword or p.kind is p.VAR_POSITIONAL
        default = "" if p.default is p.empty else f" = {written(p.default)}"
        lines.append(f"    {star}{p.name}: {p.annotation}{default},")
    return "\n".join([*lines, f") -> {signature.return_annotation}"])


def written(default: object) -> str:
    """A default as source code; ... for a long one, and for what is no literal."""
    text = repr(default)
    try:
        ast.literal_eval(text)
    except (SyntaxError, ValueError):
        return "..."
    return text if len(text) <= LONG else "..."


def docstring(function: Any) -> str:
    """The docstring of a function, and the help of each of its settings."""
    parameters = inspect.signature(function).parameters
    taken = [s for s in settings_of(function.settings) if parameters[s.name].kind is inspect.Parameter.KEYWORD_ONLY]
    width = max(len(s.name) for s in taken) + 2
    lines = [
        textwrap.fill(
            f"{s.name:<{width}}{'False: ' * (s.default is True)}{s.help}", WIDTH - 4, subsequent_indent=" " * width,
            break_long_words=False, break_on_hyphens=False,
        )
        for s in taken
    ]  # fmt: skip
    text = "\n".join([inspect.getdoc(function) or "", "", *lines])
    return textwrap.indent(f'"""{text}\n"""'.replace("\\", "\\\\"), "    ")


def needed(function: Callable[..., Any]) -> Iterator[tuple[str, str, object]]:
    """Names in the annotations of a function, each with its import and the type."""
    signature, module = inspect.signature(function), inspect.getmodule(function)
    assert module is not None
    types = [p.annotation for p in signature.parameters.values()] + [signature.return_annotation]
    names = {n.id for t in types for n in ast.walk(ast.parse(t)) if isinstance(n, ast.Name)}
    known = imported(Path(module.__file__ or "")) | {n: f"from {m} import {n}" for n, m in COMMON.items()}
    for name in sorted(names - set(dir(builtins))):
        line = known.get(name, f"from {module.__name__} import {name}")
        yield name, line, getattr(importlib.import_module(line.split()[1]), name)


@functools.cache
def imported(file: Path) -> dict[str, str]:
    """The names that a module imports from others."""
    tree = ast.parse(file.read_text(encoding="utf-8"))
    found = [n for n in ast.walk(tree) if isinstance(n, ast.ImportFrom)]
    return {a.name: f"from {n.module} import {a.name}" for n in found for a in n.names if a.asname is None}


def main() -> int:
    """Write or compare; 1 if the file differs."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare")
    given, text = parser.parse_args(), stub()
    if FILE.is_file() and FILE.read_text(encoding="utf-8") == text:
        return 0
    if given.check:
        print(f"{FILE.name} is not up to date: python tools/generate_stubs.py")
        return 1
    FILE.write_text(text, encoding="utf-8")
    print(f"{FILE.name}: written")
    return 0


if __name__ == "__main__":
    sys.exit(main())
