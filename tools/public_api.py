"""The public interface of the package as text, one line a name, parameter or field, so that a change of it is seen.

python tools/public_api.py            what it is now
python tools/public_api.py --check    exit status 1 where it is not what is stored
python tools/public_api.py --write    into tests/public/public_api.txt, which a test holds it against

Names are those of `raybundle.__all__`; of a class its fields and public methods, those that it has from other classes
of the package included.  Annotations are told as the source has them, so that the text is the same with every Python.
"""

from __future__ import annotations

import argparse
import dataclasses
import enum
import inspect
import sys
import types
from collections.abc import Iterator
from pathlib import Path
from typing import Any, get_overloads

import raybundle

FILE = Path(__file__).resolve().parents[1] / "tests/public/public_api.txt"
MARKS = {inspect.Parameter.VAR_POSITIONAL: "*", inspect.Parameter.VAR_KEYWORD: "**"}


def interface() -> str:
    """All public names, a paragraph each."""
    return "\n\n".join("\n".join(of(name)) for name in sorted(raybundle.__all__)) + "\n"


def of(name: str) -> Iterator[str]:
    """The lines of one public name."""
    value = getattr(raybundle, name)
    if isinstance(value, type):
        yield from class_lines(name, value)
    elif isinstance(value, types.FunctionType):
        for shape in get_overloads(value) or [value]:
            yield from function_lines(name, shape, "")
    else:
        yield f"{name}: {type(value).__name__}"


def function_lines(name: str, function: types.FunctionType, indent: str) -> Iterator[str]:
    """A function: its parameters by kind with annotations and defaults, and what it returns."""
    signature = inspect.signature(function)
    yield f"{indent}{name}() -> {words_of(signature.return_annotation, name)}"
    kind = inspect.Parameter.POSITIONAL_OR_KEYWORD
    for p in signature.parameters.values():
        if p.name in ("self", "cls"):
            continue
        if p.kind is inspect.Parameter.KEYWORD_ONLY and kind not in (p.kind, inspect.Parameter.VAR_POSITIONAL):
            yield f"{indent}    *"
        kind = p.kind
        default = "" if p.default is inspect.Parameter.empty else f" = {default_words(p.default)}"
        yield f"{indent}    {MARKS.get(p.kind, '')}{p.name}: {words_of(p.annotation, name)}{default}"


def class_lines(name: str, cls: type) -> Iterator[str]:
    """A class: what it is of, fields or members, properties and methods."""
    bases = ", ".join(b.__name__ for b in cls.__bases__ if b is not object)
    how = " (frozen)" if dataclasses.is_dataclass(cls) and cls.__dataclass_params__.frozen else ""
    yield f"class {name}({bases}){how}" if bases else f"class {name}{how}"
    if issubclass(cls, enum.Enum):
        for member in cls:
            yield f"    {member.name} = {member.value!r}"
    fields = dataclasses.fields(cls) if dataclasses.is_dataclass(cls) else ()
    for field in fields:
        if field.init and not field.name.startswith("_"):
            yield f"    {field.name}: {words_of(field.type, name)}{field_default(field)}"
    own = {f.name for f in fields}
    for member, value in sorted(members(cls).items()):
        if member in own:
            continue
        if isinstance(value, property) or type(value).__name__ == "cached_property":
            getter = value.fget if isinstance(value, property) else value.func
            yield f"    {member}: {words_of(inspect.get_annotations(getter).get('return'), name)} (property)"
        elif isinstance(value, classmethod | staticmethod):
            yield f"    {type(value).__name__}"
            yield from function_lines(member, value.__func__, "    ")
        elif isinstance(value, types.FunctionType):
            yield from function_lines(member, value, "    ")
        elif isinstance(value, str | int | float | tuple):
            yield f"    {member} = {default_words(value)}"


def members(cls: type) -> dict[str, Any]:
    """Public attributes that classes of this package give it, and how it is made where that is written out."""
    found: dict[str, Any] = {}
    for base in reversed(cls.__mro__):
        if base.__module__.partition(".")[0] != "raybundle":
            continue
        for name, value in vars(base).items():
            written = name == "__init__" and not dataclasses.is_dataclass(base)
            slot = isinstance(value, types.MemberDescriptorType)
            if (not name.startswith("_") or written) and not slot and not isinstance(value, enum.Enum):
                found[name] = value
    return found


def words_of(annotation: Any, where: str) -> str:
    """An annotation as the source has it; raises TypeError where a module evaluates its annotations."""
    if annotation is inspect.Parameter.empty or annotation is None:
        return "None" if annotation is None else "?"
    if not isinstance(annotation, str):
        raise TypeError(f"{where}: its module lacks 'from __future__ import annotations'")
    return annotation


def field_default(field: dataclasses.Field[Any]) -> str:
    """What a field is without being given."""
    if field.default is not dataclasses.MISSING:
        return f" = {default_words(field.default)}"
    return "" if field.default_factory is dataclasses.MISSING else " = ..."


def default_words(value: Any) -> str:
    """A default; of what has no short words its type."""
    if isinstance(value, enum.Enum):
        return f"{type(value).__name__}.{value.name}"
    if value is None or isinstance(value, bool | int | float | str):
        return repr(value)
    if isinstance(value, tuple) and not hasattr(value, "_fields"):
        return f"({', '.join(default_words(v) for v in value)}{',' if len(value) == 1 else ''})"
    name = getattr(value, "__name__", None)
    return name if isinstance(name, str) else f"<{type(value).__name__}>"


def main() -> int:
    """Print it, or write it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true", help="into tests/public/public_api.txt")
    parser.add_argument("--check", action="store_true", help="compare it with that file")
    asked, text = parser.parse_args(), interface()
    same = FILE.is_file() and FILE.read_text(encoding="utf-8") == text
    if asked.check:
        print("" if same else f"{FILE.name} is not up to date: python tools/public_api.py --write", end="")
        return 0 if same else 1
    if not asked.write:
        sys.stdout.write(text)
    elif not same:
        FILE.write_text(text, encoding="utf-8")
        print(f"{FILE.name}: written")
    return 0


if __name__ == "__main__":
    sys.exit(main())
