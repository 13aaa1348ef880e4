"""Settings: fields of a frozen data class with the help, limits and names that every user of them needs.

A message names a setting by `option`, never by its flag: who works in Python reads another spelling.
"""

from __future__ import annotations

import dataclasses
import inspect
import json
import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import MISSING, dataclass, field
from functools import cache
from os import PathLike
from pathlib import Path, PurePath
from types import UnionType
from typing import Any, Literal, TypeVar, Union, cast, get_args, get_origin, get_type_hints

from raybundle import words
from raybundle.errors import InputError
from raybundle.words.options import option_words

T = TypeVar("T")
Function = TypeVar("Function", bound=Callable[..., Any])


@dataclass(frozen=True, slots=True, kw_only=True)
class Range:
    """Numbers that are allowed."""

    low: float | None = None
    high: float | None = None
    above: bool = False
    """whether `low` itself is not"""

    def check(self, name: str, value: float) -> None:
        """Raise InputError for a number that is not finite, or beyond the range."""
        given = f"{value:g}"
        if not math.isfinite(value):
            raise InputError("setting.not_finite", name=name, given=given)
        if self.low is not None and (value < self.low or (self.above and value == self.low)):
            raise InputError("setting.too_small", name=name, given=given, least=self.low, above=self.above)
        if self.high is not None and value > self.high:
            raise InputError("setting.too_large", name=name, given=given, most=self.high)


ANY, POSITIVE, NOT_NEGATIVE = Range(), Range(low=0, above=True), Range(low=0)
PIXELS = Range(low=0, high=1e5, above=True)
"""A standard deviation of image points [px]: no format is wider."""
METRES = Range(low=0, high=1e6, above=True)
"""A length of a flight [m]: farther away the Earth is not flat, and nothing flies."""
Part = Range | Literal["text"]


def option(name: str, *values: object, flag: str = "") -> str:
    """A setting as the reader of a message writes it: a flag with values, or `size=(WIDTH, HEIGHT)` in Python.

    values  what to give it; words in capitals stand for values of the reader's own, True and False for a flag alone
    flag    its name on the command line, where that is not the field's: option("gps", False, flag="no-gps")
    """
    return option_words(name, *values, flag=flag, flags=words.reader().flags)


@dataclass(frozen=True, slots=True, kw_only=True)
class About:
    """What is known of a setting beside its type and default."""

    words: str
    """its help; other settings stand there as {name}"""
    flag: str = ""
    """its name on the command line, where that is not the field's"""
    metavar: str = ""
    limits: tuple[Part, ...] = ()
    """of a number, or of each number and text of a tuple"""
    joined: bool = False
    """whether the texts of a tuple stand in one, with commas between, where they are typed"""
    unstated: bool = False
    """whether the default is what holds where nothing is stated, and no word of the command line"""
    typed: str = ""
    """the default as it is typed, where that is not its value: 5mm"""
    also: tuple[str, ...] = ()
    """other spellings of its name that are accepted on the command line, as the exchange format has them"""


def setting(
    default: Any, help_: str, *, flag: str = "", metavar: str = "", limits: Part | tuple[Part, ...] = (),
    joined: bool = False, unstated: bool = False, typed: str = "", also: tuple[str, ...] = (),
) -> Any:  # fmt: skip
    """A field of a data class of settings; with MISSING for its default it has to be given.

    help_  names another setting as {name}, which stands as a flag on the command line
    """
    parts = limits if isinstance(limits, tuple) else (limits,)
    about = About(
        words=help_, flag=flag, metavar=metavar, limits=parts, joined=joined, unstated=unstated, typed=typed, also=also
    )
    return field(default=default, metadata={"about": about})


@dataclass(frozen=True, slots=True, kw_only=True)
class Setting:
    """One setting of a command."""

    name: str
    kind: Any
    """annotated type"""
    default: Any
    about: About

    @property
    def flag(self) -> str:
        """Its name on the command line, after the dashes."""
        return self.about.flag or self.name.replace("_", "-")

    @property
    def help(self) -> str:
        """What it is, with other settings as the reader writes them."""
        return re.sub(r"\{(\w+)\}", lambda found: option(found[1]), self.about.words)

    @property
    def optional(self) -> bool:
        """Whether it may be None."""
        return type(None) in get_args(self.kind)

    @property
    def plain(self) -> Any:
        """The type without None."""
        if not self.optional:
            return self.kind
        rest = [a for a in get_args(self.kind) if a is not type(None)]
        return rest[0]

    @property
    def choices(self) -> tuple[str, ...]:
        """Of a word that is one of some."""
        return get_args(self.plain) if get_origin(self.plain) is Literal else ()

    @property
    def many(self) -> bool:
        """Whether it is any number of values."""
        return get_origin(self.plain) is tuple and get_args(self.plain)[-1] is Ellipsis

    @property
    def each(self) -> Any:
        """The type of each value."""
        return get_args(self.plain)[0] if self.many else self.plain

    def of(self, value: Any) -> Any:
        """A value as the field holds it; raises InputError that names the setting, the value and what is allowed."""
        if value is None and self.optional:
            return None
        if self.about.joined and isinstance(value, str):
            return tuple(word.strip() for word in value.split(",") if word.strip())
        if self.many:
            one = isinstance(value, str) or not isinstance(value, Iterable)
            values: list[Any] = [value] if one else [*cast("Any", value)]
            return tuple(self._one(v) for v in values)
        return self._one(value)

    def _one(self, value: Any) -> Any:
        kind = self.each
        if kind is Path:
            return path_of(self.name, value)
        if self.choices:
            if value not in self.choices:
                known = [c for c in self.choices if c]
                raise InputError("setting.not_one_of", name=self.name, given=repr(value), known=known)
            return value
        if get_origin(kind) is tuple:
            parts = get_args(kind)
            if isinstance(value, str) or len(value) != len(parts):
                raise InputError("setting.value_count", name=self.name, given=repr(value), n=len(parts))
            return tuple(
                self._number(v, p, r) if p in {int, float} else self._as(v, p)
                for v, p, r in zip(value, parts, self.about.limits or ("text",) * len(parts), strict=True)
            )
        if kind in {int, float}:
            return self._number(value, kind, self.about.limits[0] if self.about.limits else ANY)
        return self._as(value, kind)

    def _as(self, value: Any, kind: Any) -> Any:
        if isinstance(kind, type) and not isinstance(value, kind):
            raise InputError("setting.wrong_type", name=self.name, given=repr(value), type=kind.__name__)
        return value

    def _number(self, value: Any, kind: Any, limits: Part) -> Any:
        if isinstance(value, bool) or not isinstance(value, int | float) or (kind is int and value != int(value)):
            code = "setting.no_whole_number" if kind is int else "setting.no_number"
            raise InputError(code, name=self.name, given=repr(value))
        if isinstance(limits, Range):
            limits.check(self.name, value)
        return kind(value)


def path_of(name: str, value: Any) -> Path:
    """A path that Python gave; raises InputError for what is none."""
    if not isinstance(value, str | PathLike):
        raise InputError("setting.no_path", name=name, type=type(value).__name__)
    return Path(value)


@cache
def settings_of(kind: type) -> tuple[Setting, ...]:
    """The settings of a command, in their order; what is no setting is asked for apart."""
    hints = get_type_hints(kind)
    return tuple(
        Setting(name=f.name, kind=hints[f.name], default=f.default, about=f.metadata["about"])
        for f in dataclasses.fields(kind)
        if "about" in f.metadata
    )


def accepted(kind: Any) -> str:
    """The annotation of what `made` takes for a field of this type, as source code."""
    parts = get_args(kind)
    if get_origin(kind) is Literal:
        return f"Literal[{', '.join(map(repr, parts))}]"
    if get_origin(kind) in {Union, UnionType}:
        return " | ".join(map(accepted, parts))
    if get_origin(kind) is tuple and parts[-1] is Ellipsis:
        one = accepted(parts[0])
        return f"Sequence[{one}]" if get_origin(parts[0]) is tuple else f"{one} | Sequence[{one}]"
    if get_origin(kind) is tuple:
        each = [accepted(p) for p in parts]
        return f"tuple[{', '.join(each)}] | list[{' | '.join(dict.fromkeys(each))}]"
    return {Path: "str | Path", type(None): "None"}.get(kind) or kind.__name__


def keywords(kind: type) -> Callable[[Function], Function]:
    """Show the fields of a settings class as keywords in the signature of a function that takes them as `**settings`.

    Fields that the function has as parameters are not repeated.  `settings` of the function is the class.
    """

    def with_signature(function: Function) -> Function:
        signature, hints = inspect.signature(function), get_type_hints(kind)
        own = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
        more = [
            inspect.Parameter(
                f.name,
                inspect.Parameter.KEYWORD_ONLY,
                default=inspect.Parameter.empty if f.default is MISSING else f.default,
                annotation=accepted(hints[f.name]),
            )
            for f in dataclasses.fields(kind)
            if f.name not in signature.parameters
        ]
        vars(function).update(__signature__=signature.replace(parameters=[*own, *more]), settings=kind)
        return function

    return with_signature


def made(kind: type[T], given: Mapping[str, Any]) -> T:
    """The settings of these values; texts may stand for paths, one value for a tuple of one.

    raises  InputError for a name that is no setting, and for a value that cannot be
    """
    known = {s.name: s for s in settings_of(kind)}
    own = {f.name for f in dataclasses.fields(cast("Any", kind))} - known.keys()
    for name in given:
        if name not in known and name not in own:
            raise InputError("setting.unknown", name=name, known=list(known))
    return kind(**{n: known[n].of(v) if n in known else v for n, v in given.items()})


def asked(kind: type[T], photos: str | Path | Sequence[str | Path], out: str | Path, given: Mapping[str, Any]) -> T:
    """The settings of a command that takes photographs and writes a folder, as Python gives them."""
    inputs = (photos,) if isinstance(photos, str | Path) else photos
    return made(kind, {"photos": tuple(Path(p) for p in inputs), "out": Path(out), **given})


def toml_lines(section: str, values: Any) -> Iterator[str]:
    """The settings as a section of a project file; what is None is left out."""
    yield f"[{section}]"
    for f in dataclasses.fields(values):
        value = getattr(values, f.name)
        if value is not None:  # a JSON text or list is one of TOML
            yield f"{f.name} = {json.dumps(value, default=str, ensure_ascii=False)}"


def other_than_usual(values: Any) -> dict[str, object]:
    """The settings that are not as by default, by name."""
    return {
        s.name: getattr(values, s.name)
        for s in settings_of(type(values))
        if s.default is MISSING or getattr(values, s.name) != s.default
    }


def in_words(value: object) -> str:
    """A value as it is printed: files by their names, yes and no, of several values each."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, PurePath):
        return value.name or str(value)
    if isinstance(value, list | tuple):
        parts = [*cast("Any", value)]
        nested = any(isinstance(p, list | tuple) for p in parts)
        return ("; " if nested else " ").join(in_words(p) for p in parts)
    return repr(value).removesuffix(".0") if isinstance(value, float) else str(value)


def as_typed(values: Any) -> list[str]:
    """The settings that are not as by default, as words of the command line."""
    words: list[str] = []
    for s in settings_of(type(values)):
        value = getattr(values, s.name)
        if value == s.default:
            continue
        flag = f"--{s.flag}"
        if s.kind is bool:
            words.append(flag)
        elif s.about.joined:
            words += [flag, ",".join(value)]
        else:
            for each in value if s.many else (value,):
                words += [flag, *map(str, each if isinstance(each, tuple) else (each,))]
    return words
