"""Each action as the command that does the same: what the studio does can be read, kept and repeated."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.settings import as_typed


def command_of(source: Path, verb: str, arguments: Mapping[str, Any]) -> str:
    """The command line of an action."""
    return shlex.join(["raybundle", "mark", _SUBCOMMANDS.get(verb, verb), *_WORDS[verb](str(source), arguments)])


def _given(folder: str, options: list[str], *words: Any) -> list[str]:
    """Options, then what may begin with a minus sign."""
    return [*options, "--", folder, *(str(w) for w in words)]


def _mark(folder: str, a: Mapping[str, Any]) -> list[str]:
    covariance = ["--covariance", *(repr(float(v)) for v in a["covariance"])]
    return _given(folder, covariance, a["image"], a["point"], float(a["x_px"]), float(a["y_px"]))


def _fiducial(folder: str, a: Mapping[str, Any]) -> list[str]:
    if a["x_px"] is None:
        return _given(folder, [], a["image"], a["name"])
    covariance = ["--covariance", *(repr(float(v)) for v in a["covariance"])]
    return _given(folder, covariance, a["image"], a["name"], float(a["x_px"]), float(a["y_px"]))


def _point(folder: str, a: Mapping[str, Any]) -> list[str]:
    options = ["--role", str(a["role"])]
    for flag, values in (("--coordinates", a["xyz"]), ("--sigma", a["sigma"])):
        if any(v is not None for v in values):
            options += [flag, *("-" if v is None else repr(float(v)) for v in values)]
    return _given(folder, options, a["point"])


def _line(folder: str, a: Mapping[str, Any]) -> list[str]:
    kind = [] if a["kind"] == "straight" else ["--figure", str(a["kind"])]
    options = ["--sigma", repr(float(a["sigma"])), *kind]
    return _given(folder, options, a["line"], *a["points"])


def _beyond(folder: str, a: Mapping[str, Any]) -> list[str]:
    return _given(folder, [f"--{a['quantity']}", repr(float(a["limit"]))])


def _short(value: float) -> str:
    """A number without the decimals of a whole one."""
    return repr(float(value)).removesuffix(".0")


def _mask(folder: str, a: Mapping[str, Any]) -> list[str]:
    corners = " ".join(f"{_short(x)},{_short(y)}" for x, y in a["polygon"])
    return _given(folder, ["--polygon", corners, *(["--all-images"] if a["camera"] else [])], a["mask"], a["image"])


def _draw(folder: str, a: Mapping[str, Any]) -> list[str]:
    corners = " ".join(f"{_short(x)},{_short(y)}" for x, y in a["corners"])
    given = [("--layer", "layer", "lines"), ("--note", "note", ""), ("--surface", "surface", "surface")]
    more = [word for flag, name, usual in given if a[name] != usual for word in (flag, str(a[name]))]
    return _given(folder, [f"--{a['kind']}", corners, *more], a["drawing"])


def _words(*names: str) -> Callable[[str, Mapping[str, Any]], list[str]]:
    """A verb whose arguments stand as they are."""
    return lambda folder, a: _given(folder, [], *(a[n] for n in names if a[n] != ""))


_WORDS: Mapping[str, Callable[[str, Mapping[str, Any]], list[str]]] = {
    "put": _mark, "move": _mark, "point": _point, "line": _line, "fiducial": _fiducial,
    "remove": _words("image", "point"),
    "rename": _words("point", "to"), "forget": _words("point"), "bar": _words("start", "end", "length", "sigma"),
    "unbar": _words("start", "end"), "datum": _words("origin", "axis", "plane"), "reject": _words("image", "point"),
    "accept": _words("image", "point"), "reject_beyond": _beyond, "parameter": _words("camera", "symbol", "choice"),
    "control": _words("file"), "mask": _mask, "unmask": _words("mask"), "draw": _draw,
    "erase": _words("drawing"), "undo": _words(), "redo": _words(),
}  # fmt: skip
_SUBCOMMANDS = {"reject_beyond": "reject"}
"""Verbs that are options of another."""


def command_of_adjusting(source: Path, options: AdjustmentOptions) -> str:
    """The command line that adjusts with these options; parameters that are freed or held are in the journal."""
    return shlex.join(["raybundle", "mark", "adjust", *_given(str(source), as_typed(options))])
