"""Options of the command line, made of the settings of a command."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING
from pathlib import Path
from typing import Any, get_args, get_origin

import click

from raybundle.cli.common import FOLDER
from raybundle.cli.numbers import Number
from raybundle.settings import Part, Range, Setting, settings_of
from raybundle.words import COMMAND_LINE, reading


def options_of(kind: type, *names: str, **types: click.ParamType) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Add an option for each setting of a command, in their order, or for those named alone.

    types  replace those of the settings' fields
    """

    def add(function: Callable[..., Any]) -> Callable[..., Any]:
        for s in reversed(settings_of(kind)):
            if not names or s.name in names:
                function = _option(s, types.get(s.name))(function)
        return function

    return add


def _option(s: Setting, own: click.ParamType | None) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    flag = f"--{s.flag}"
    names = flag, *(f"--{n}" for n in s.about.also), s.name
    with reading(COMMAND_LINE):
        words = s.help
    if s.kind is bool:
        # a flag states the opposite of the default
        return click.option(*names, is_flag=True, flag_value=not s.default, default=s.default, help=words)
    more: dict[str, Any] = {"metavar": s.about.metavar} if s.about.metavar else {}
    if s.default is MISSING:
        more["required"] = True
    else:
        shown = not s.about.unstated and s.default not in {None, "", ()}
        typed = "" if s.many else s.about.typed
        more |= {"default": (typed or s.default) if shown else None, "show_default": (s.about.typed or shown)}
    return click.option(*names, type=own or _type(s), multiple=s.many, help=words or None, **more)


def _type(s: Setting) -> Any:
    if s.choices:
        return click.Choice([c for c in s.choices if c and not (s.about.unstated and c == s.default)])
    if s.each is Path:
        return FOLDER
    if get_origin(s.each) is tuple:
        parts = get_args(s.each)
        return tuple(_number(p, r) for p, r in zip(parts, s.about.limits, strict=True))
    return _number(s.each, s.about.limits[0] if s.about.limits else Range())


def _number(kind: Any, limits: Part) -> Any:
    if kind is int and isinstance(limits, Range):
        return click.IntRange(
            None if limits.low is None else int(limits.low), None if limits.high is None else int(limits.high)
        )
    if kind is float and isinstance(limits, Range):
        return Number(limits.low, limits.high, above=limits.above)
    return str


def values_of(kind: type, given: dict[str, Any]) -> dict[str, Any]:
    """What click found, without what nobody asked for."""
    known = {s.name: s for s in settings_of(kind)}
    return {
        n: _parts(v) if known[n].about.joined else v for n, v in given.items() if n in known and v not in (None, ())
    }


def _parts(value: Any) -> tuple[str, ...]:
    """The texts of one option that is given several times, or with commas between."""
    return tuple(part.strip() for word in value for part in word.split(",") if part.strip())
