"""Options from a file: a table [COMMAND], as [adjust] or [plan.network], and [all] for every command that has them.

Names are those of the command line without the dashes, or with _ for each dash within; paths count from the file's
folder.  What is typed counts before the table of the command, that before [all], and all of them before the defaults.
A value is taken as if it had been typed, and checked as that.
"""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterator
from pathlib import Path
from typing import Any, NoReturn

import click

from raybundle.errors import InputError
from raybundle.io.reading.trees import Json, Toml, read_toml

EVERY = "all"
TYPED = ("settings", "json", "quiet", "overwrite", "traceback", "help", "version")
"""Options that are typed alone: what a run prints and replaces is stated where it is begun"""


def defaults_of(path: Path, command: click.Command, name: str, root: click.Group) -> dict[str, Any]:
    """Values of a command's parameters by their names, as click takes defaults.

    raises  InputError for what is no TOML, for tables that are no commands, for names that no option has, with what
            may be meant, and for values that cannot be typed
    """
    file = read_toml(path)
    tables = dict(_tables(file, root))
    options = {_plain(n): p for p in command.params if isinstance(p, click.Option) for n in _names(p)}
    found: dict[str, Any] = {}
    for table, own in ((EVERY, False), (name, True)):
        for key, value in tables.get(table, {}).items():
            where = file.lines.get((*table.split(), key))
            if _plain(key) in TYPED:
                raise InputError(
                    "settings_file.flag_only", flag=f"--{_plain(key)}", file=path, line=where, column=value.at
                )
            option = options.get(_plain(key))
            if option is None and (own or _plain(key) not in _everywhere(root)):
                _unknown(file, table, key, options if own else _everywhere(root))
            if option is not None and option.name:
                try:
                    found[option.name] = _value(option, key, value.value, path.parent)
                except InputError as error:
                    raise error.at(path, where, value.at) from None
    return found


def _tables(file: Toml, root: click.Group) -> Iterator[tuple[str, dict[str, Json]]]:
    """The words of each command that has a table, and its rows; raises InputError for what is no command."""
    for word, value in file.tree().mapping().items():
        if word == EVERY:
            yield EVERY, dict(value.mapping())
        else:
            yield from _of_command(file, root, (), word, value)


def _of_command(
    file: Toml, group: click.Group, before: tuple[str, ...], word: str, value: Json
) -> Iterator[tuple[str, dict[str, Json]]]:
    context = click.Context(group)
    words = (*before, word)
    member = group.get_command(context, word) if word in group.list_commands(context) else None
    if member is None or not isinstance(value.value, dict):
        near = difflib.get_close_matches(word, group.list_commands(context), n=1)
        near = [f"[{'.'.join((*before, n))}]" for n in near if n != word]
        raise InputError(
            "settings_file.unknown_table", name=".".join(words), table=isinstance(value.value, dict), n=len(near),
            near=near, general=f"[{EVERY}]", file=file.file, line=file.lines.get(words),
        )  # fmt: skip
    if not isinstance(member, click.Group):
        yield " ".join(words), dict(value.mapping())
        return
    for inner, more in value.mapping().items():
        yield from _of_command(file, member, words, inner, more)


def _plain(name: str) -> str:
    return name.lstrip("-").replace("_", "-")


def _value(option: click.Option, key: str, value: Any, folder: Path) -> Any:
    """What click makes a value of; a flag by its own name, or the setting that it turns around.

    raises  InputError for what cannot be typed
    """
    if option.is_flag:
        if not isinstance(value, bool):
            raise InputError("value.no_truth_value", value=repr(value))
        named = any(_plain(n) == _plain(key) for n in option.opts)
        return option.flag_value if named and value else option.default if named else value
    is_path = isinstance(option.type, click.Path)
    if not option.multiple:
        return _once(value, option.nargs, folder if is_path else None)
    deep = option.nargs > 1
    several = isinstance(value, list) and (not deep or all(isinstance(v, list) for v in value))
    return [_once(v, option.nargs, folder if is_path else None) for v in (value if several else [value])]


def _once(value: Any, count: int, folder: Path | None) -> Any:
    """The words of one use of an option that takes so many."""
    if count == 1:
        return _word(value, folder)
    if not isinstance(value, list) or len(value) != count:
        raise InputError("value.count", n=len(value) if isinstance(value, list) else 1, needed=count)
    return [_word(v, folder) for v in value]


def _word(value: Any, folder: Path | None) -> str:
    """A value as it is typed; a path counts from a folder."""
    if isinstance(value, str):
        return value if folder is None else str(folder / value)
    if isinstance(value, bool) or not isinstance(value, int | float) or folder is not None:
        raise InputError("value.no_text" if folder is not None else "value.no_number_or_text", value=repr(value))
    return repr(value)


def _everywhere(root: click.Group) -> frozenset[str]:
    """Names of the options of all commands."""
    return frozenset(_plain(n) for p in _all(root) for n in _names(p))


def _names(parameter: click.Parameter) -> tuple[str, ...]:
    return (*parameter.opts, parameter.name) if parameter.name else tuple(parameter.opts)


def _all(command: click.Command) -> list[click.Parameter]:
    if not isinstance(command, click.Group):
        return command.params
    context = click.Context(command)
    members = [command.get_command(context, n) for n in command.list_commands(context)]
    return [p for member in members if member is not None for p in _all(member)]


def _unknown(file: Toml, table: str, key: str, options: Collection[str]) -> NoReturn:
    near = difflib.get_close_matches(_plain(key), sorted(options), n=3)
    raise InputError(
        "settings_file.unknown_option", entry=f"[{'.'.join(table.split())}] {key}", flag=f"--{_plain(key)}",
        command=f"raybundle {table}", every=table == EVERY, n=len(near), near=near,
        file=file.file, line=file.lines.get((*table.split(), key)),
    )  # fmt: skip
