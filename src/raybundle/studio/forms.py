"""Forms made of the settings of a command, and the settings that a form gives."""

from __future__ import annotations

import shlex
from collections.abc import Collection, Mapping, Sequence
from typing import Any, TypeVar, cast, get_args, get_origin

from starlette.exceptions import HTTPException

from raybundle.errors import InputError, phrase
from raybundle.settings import Range, Setting, made, settings_of

T = TypeVar("T")


def table_of(given: Mapping[str, Any], name: str) -> dict[str, Any]:
    """A table of what the page sends; refuses what is none."""
    value = given.get(name)
    if not isinstance(value, dict):
        raise HTTPException(400, phrase("studio_page.bad_request", name=name, kind="table"))
    return cast("dict[str, Any]", value)


def fields_of(values: Any, *, apart: Collection[str] = ()) -> list[dict[str, Any]]:
    """Each setting of a data class as a field: its flag, help, limits, choices, value and default.

    apart  settings that something else stands for
    """
    return [_field(s, getattr(values, s.name)) for s in settings_of(type(values)) if s.name not in apart]


def settings_of_form(kind: type[T], given: Mapping[str, Any], own: Mapping[str, Any], apart: Collection[str] = ()) -> T:
    """The settings that the values of a form make; what it does not give is as by default.

    own     fields that are no settings, as `out`
    raises  InputError that names the setting, the value and what is allowed
    """
    known = {s.name: s for s in settings_of(kind) if s.name not in apart}
    for name, value in given.items():
        if name not in known:
            raise InputError("setting.unknown", name=name, known=sorted(known))
        if (known[name].plain is bool) != isinstance(value, bool):
            raise InputError("setting.wrong_kind", name=name, given=str(value), flag=known[name].plain is bool)
        _check_text(name, value)
        if isinstance(value, list | dict):
            raise InputError("setting.several_values", name=name, given=str(value))
    return made(kind, {**own, **{name: _value(known[name], value) for name, value in given.items()}})


def words_of(text: str, name: str) -> list[str]:
    """The words of a text, those with blanks in quotation marks; raises InputError where a mark is not closed."""
    _check_text(name, text)
    try:
        return shlex.split(text)
    except ValueError:
        raise InputError("setting.quotation_open", name=name, given=text) from None


def _check_text(name: str, value: Any) -> None:
    if isinstance(value, str) and "\0" in value:
        raise InputError("setting.impossible_character", name=name, given=repr(value))


def _kind(s: Setting) -> str:
    if s.plain is bool:
        return "flag"
    if s.choices:
        return "choice"
    if s.plain in {int, float}:
        return "number"
    if s.about.joined:
        return "names"
    return "words" if get_origin(s.plain) is tuple else "text"


def _field(s: Setting, value: Any) -> dict[str, Any]:
    limits = next((r for r in s.about.limits if isinstance(r, Range)), Range())
    return {
        "name": s.name, "flag": f"--{s.flag}", "kind": _kind(s), "help": s.help,
        "choices": [*([""] if s.optional and s.choices else []), *s.choices],
        "whole": s.plain is int, "low": limits.low, "high": limits.high, "metavar": s.about.metavar,
        "value": _shown(s, value), "default": _shown(s, s.default),
    }  # fmt: skip


def _shown(s: Setting, value: Any) -> Any:
    """A value as its field shows it: a flag by whether it is given, several values as words."""
    match _kind(s):
        case "flag":
            return value != s.default
        case "names":
            return ",".join(value)
        case "words":
            each: Sequence[Any] = () if value is None else value
            return shlex.join(str(w) for v in each for w in (v if isinstance(v, tuple) else (v,)))
        case "text":
            return "" if value is None else str(value)
        case _:
            return value


def _value(s: Setting, given: Any) -> Any:
    """The value that is shown in a field."""
    match _kind(s):
        case "flag":
            return given != s.default
        case "words" if isinstance(given, str):
            return _tuple(s, words_of(given, s.name))
        case "text" | "choice" if given == "" and s.optional:
            return None
        case _:
            return given


def _tuple(s: Setting, words: Sequence[str]) -> Any:
    """Words as a tuple, or as several of some words each."""
    if not s.many:
        parts = get_args(s.plain)
        return _converted(s, parts, words) if words else None
    parts = get_args(s.each) if get_origin(s.each) is tuple else ()
    if not parts:
        return tuple(words)
    n = len(parts)
    if len(words) % n:
        raise InputError("setting.word_count", name=s.name, given=shlex.join(words), needed=n, form=s.about.metavar)
    return tuple(_converted(s, parts, words[k : k + n]) for k in range(0, len(words), n))


def _converted(s: Setting, parts: Sequence[Any], words: Sequence[str]) -> tuple[Any, ...]:
    if len(words) != len(parts):
        raise InputError(
            "setting.word_count", name=s.name, given=shlex.join(words), needed=len(parts), form=s.about.metavar
        )
    try:
        return tuple(p(w) if p in {int, float} else w for p, w in zip(parts, words, strict=True))
    except ValueError:
        raise InputError(
            "setting.word_count", name=s.name, given=shlex.join(words), needed=len(parts), form=s.about.metavar
        ) from None
