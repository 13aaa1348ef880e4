"""Each action as the command that does the same: what the studio does can be read, kept and repeated."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import Any


def command_of(source: Path, verb: str, arguments: Mapping[str, Any]) -> str:
    """The command line of an action; empty for what has none of its own."""
    words = _WORDS.get(verb)
    if words is None:
        return ""
    return shlex.join(["raybundle", "mark", verb, str(source), *words(arguments)])


def _number(value: float) -> str:
    return f"{value:.10g}"


def _mark(a: Mapping[str, Any]) -> list[str]:
    xx, yy, xy = a["covariance"]
    told = [str(a["image"]), str(a["point"]), _number(a["x_px"]), _number(a["y_px"])]
    if xy:
        return [*told, "--covariance", *(_number(v) for v in (xx, yy, xy))]
    return [*told, "--sigma", _number(xx**0.5), _number(yy**0.5)]


def _point(a: Mapping[str, Any]) -> list[str]:
    told = [str(a["point"]), "--role", str(a["role"])]
    for axis, value, sigma in zip("xyz", a["xyz"], a["sigma"], strict=True):
        if value is not None:
            told += [f"--{axis}", _number(value)]
        if sigma is not None:
            told += [f"--s{axis}", _number(sigma)]
    return told


_WORDS = {
    "put": _mark,
    "move": _mark,
    "remove": lambda a: [str(a["image"]), str(a["point"])],
    "point": _point,
    "bar": lambda a: [str(a["start"]), str(a["end"]), _number(a["length"]), _number(a["sigma"])],
    "undo": lambda _: [],
    "redo": lambda _: [],
}
