"""The modules of the package as text and as trees; to parse them all takes seconds, so that tests ask for a few."""

import ast
import gc
import re
from functools import cache
from pathlib import Path

import raybundle

SOURCE = Path(raybundle.__file__).parent


@cache
def texts():
    """Path within the package -> text of every module."""
    return {p.relative_to(SOURCE).as_posix(): p.read_text(encoding="utf-8") for p in sorted(SOURCE.rglob("*.py"))}


def trees(pattern, *, within=("",), without=()):
    """(path within the package, tree) of the modules in the text of which a regular expression is found.

    within, without  beginnings of paths that are looked at, or left out
    """
    wanted = re.compile(pattern)
    for name, text in texts().items():
        if name.startswith(tuple(within)) and wanted.search(text) and not name.startswith(tuple(without)):
            yield name, _parsed(text)


def _parsed(text):
    gc.disable()  # a tree has no garbage: to look for it takes a quarter of the time
    try:
        return ast.parse(text)
    finally:
        gc.enable()
