"""A block as named arrays, for the cache of a project: exact, quick, without objects.

It goes over the fields of the data classes, so that a new one is kept by existing.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields
from functools import cache
from typing import Any, get_type_hints

import msgspec
import numpy as np

from raybundle.block import Block, Camera, Images, Instrument, Observations, Points
from raybundle.io.reading.trees import own_json_of
from raybundle.numerics.arrays import Array
from raybundle.numerics.records import Records
from raybundle.observations import tables

ELSEWHERE = {"place", "scene"}
"""Fields of a block with satellite scenes, which `scene_arrays` shows."""
SCENES = "scenes"
OWN: Mapping[str, type[Records]] = {"images": Images, "observations": Observations, "points": Points}
"""Parts of a block that every block has; beside them stand the tables of observations."""
LISTED: Mapping[str, type[Camera | Instrument]] = {"cameras": Camera, "instruments": Instrument}


def arrays_of_block(block: Block) -> dict[str, Array]:
    """The arrays; `block_of_arrays` makes the equal block of them."""
    lists = {name: [_as_json(thing) for thing in getattr(block, name)] for name in LISTED}
    parts: dict[str, Records] = {
        "images": block.images, "observations": block.observations, "points": block.points, **block.tables,
    }  # fmt: skip
    scenes = {SCENES: np.array(_text_of_scenes(block))} if any(c.is_scene for c in block.cameras) else {}
    return {
        "head": np.array(json.dumps({**_as_json(block), **lists})),
        **scenes,
        **{f"{part}.{name}": values for part, table in parts.items() for name, values in arrays_of_records(table)},
    }


def block_of_arrays(a: Mapping[str, Array]) -> Block:
    """The block that `arrays_of_block` was given."""
    head: dict[str, Any] = own_json_of(str(a["head"]))
    lists = {name: tuple(kind(**_known(kind, thing)) for thing in head[name]) for name, kind in LISTED.items()}
    parts = {name: part for name, kind in {**OWN, **tables}.items() if (part := _part(kind, name, a)) is not None}
    observed = {name: table for name, table in parts.items() if name in tables}
    own = {name: part for name, part in parts.items() if name not in tables}
    made: Any = {**_known(Block, head), **lists, **own, "tables": observed}
    return _with_scenes(Block(**made), own_json_of(str(a[SCENES]))) if SCENES in a else Block(**made)


def _text_of_scenes(block: Block) -> str:
    from raybundle.io.block.scene_arrays import text_of_scenes

    return text_of_scenes(block)


def _with_scenes(block: Block, entry: Mapping[str, Any]) -> Block:
    from raybundle.io.block.scene_arrays import with_scenes

    return with_scenes(block, entry)


def arrays_of_records(table: Records) -> Iterator[tuple[str, Array]]:
    """The columns of a table as arrays, by their names; a column that it lacks has none."""
    for name, c in table.columns():
        values = getattr(table, name)
        if values is None:
            continue
        if c.of == "by row":
            yield name, np.array(json.dumps(msgspec.to_builtins(values, str_keys=True)))
        else:
            yield name, np.array(values, np.str_) if c.of == "text" else values


def records_of_arrays(kind: type[Records], a: Mapping[str, Array]) -> Records:
    """The table that `arrays_of_records` was given."""
    made = dict[str, Any]()
    for name, c in kind.columns():
        if name not in a:
            continue
        if c.of == "by row":
            made[name] = msgspec.convert(own_json_of(str(a[name])), _hints(kind)[name], str_keys=True)
        else:
            made[name] = tuple(a[name].tolist()) if c.of == "text" else a[name]
    return kind(**made)


def text_of_names(names: Sequence[str]) -> str:
    """Names as one text, for an array of texts; `names_of_text` gives them back."""
    return json.dumps(list(names))


def names_of_text(text: str) -> tuple[str, ...]:
    """The names that `text_of_names` was given."""
    return tuple(value_of_text(text))


def value_of_text(text: str) -> Any:
    """A value that JSON can hold, of the text in which it is kept."""
    return own_json_of(text)


def _part(kind: type[Records], name: str, a: Mapping[str, Array]) -> Records | None:
    """A table of a block; None where nothing of it was kept."""
    head = f"{name}."
    found = {key.removeprefix(head): values for key, values in a.items() if key.startswith(head)}
    return records_of_arrays(kind, found) if found else None


@cache
def _hints(kind: type) -> Mapping[str, Any]:
    """Types of the fields of a data class."""
    return get_type_hints(kind)


def _plain(kind: type) -> list[str]:
    """Fields of a data class that a JSON text holds."""
    apart = {*ELSEWHERE, *(("tables", *LISTED, *OWN, *tables) if kind is Block else ())}
    return [f.name for f in fields(kind) if f.name not in apart]


def _as_json(thing: Any) -> dict[str, Any]:
    """The plain fields of a data class as JSON holds them."""
    return {name: msgspec.to_builtins(getattr(thing, name)) for name in _plain(type(thing))}


def _known(kind: type, entry: Mapping[str, Any]) -> dict[str, Any]:
    """The fields that `_as_json` was given."""
    return {name: msgspec.convert(entry[name], _hints(kind)[name]) for name in _plain(kind)}
