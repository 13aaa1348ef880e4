"""What a delivery states of itself: who ordered it, who made it, of what, where and when.

The entries of the object follow the nine headings of the Core Data Index to Historic Buildings and Monuments of the
Architectural Heritage (Council of Europe 1992, with CIDOC's companion for sites: Thornes, Bold 1998); those of the
recording what the 3x3 rules of CIPA (Waldhäusl, Ogleby 1994, rule 3.2) ask to be written down on site.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, field, fields
from typing import TYPE_CHECKING, Any, Literal

from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.io.reading.trees import Json

RECORD = "record"
"""Table of project.toml and record.toml"""
RECORD_FILE = "record.toml"
STATE = "state"
"""Key of what is made of a result under which stands why that is not to be used yet"""
LONGEST = 10_000
"""Letters of an entry"""
Part = Literal["delivery", "object", "recording"]


def _entry(part: Part) -> Any:
    return field(default="", metadata={"part": part})


@dataclass(frozen=True, slots=True, kw_only=True)
class Record:
    """The recording sheet, in words as they are printed; empty: not stated."""

    title: str = _entry("delivery")
    client: str = _entry("delivery")
    operator: str = _entry("recording")
    object: str = _entry("object")
    place: str = _entry("object")
    date: str = _entry("recording")
    instruments: str = _entry("recording")
    rights: str = _entry("delivery")
    reference: str = _entry("object")
    kind: str = _entry("object")
    dating: str = _entry("object")
    persons: str = _entry("object")
    materials: str = _entry("object")
    condition: str = _entry("object")
    protection: str = _entry("object")
    description: str = _entry("object")
    purpose: str = _entry("delivery")
    conditions: str = _entry("recording")
    control: str = _entry("recording")
    archive: str = _entry("delivery")

    def as_mapping(self) -> dict[str, str]:
        """What is stated."""
        return {name: words for name, words in asdict(self).items() if words}

    def over(self, other: Record) -> Record:
        """This one, and of the other what this does not say."""
        return Record(**{**other.as_mapping(), **self.as_mapping()})


NAMES = tuple(f.name for f in fields(Record))
PARTS: Mapping[str, Part] = {f.name: f.metadata["part"] for f in fields(Record)}


def record_from(tree: Json) -> Record:
    """The table [record] of a file, empty where there is none; raises InputError for an entry that is none."""
    if not tree.has(RECORD):
        return Record()
    found: dict[str, str] = {}
    for name, value in tree.get(RECORD).mapping().items():
        if name not in NAMES:
            value.fail("record.unknown_entry", known=list(NAMES))
        found[name] = checked(name, str(value.value) if isinstance(value.value, str) else _plain(value))
    return Record(**found)


def _plain(value: Json) -> str:
    """A number or a date as it was typed: an inventory number needs no quotation marks."""
    if isinstance(value.value, dict | list | bool):
        value.fail("record.not_a_text")
    return str(value.value)


def checked(name: str, words: str) -> str:
    """An entry as it is kept: lines stay, all else that cannot be seen becomes a blank; raises InputError."""
    if len(words) > LONGEST:
        raise InputError("record.too_long", name=name, n=len(words), most=LONGEST)
    kept = "".join(c if c.isprintable() or c == "\n" else " " for c in words.replace("\r\n", "\n"))
    return kept.encode("utf-8", "replace").decode().strip()


def record_lines(record: Record) -> Iterator[str]:
    """The table as lines of TOML, in the order of its entries."""
    yield f"[{RECORD}]"
    for name, words in record.as_mapping().items():
        yield f"{name} = {json.dumps(words, ensure_ascii=False)}"  # a JSON text is one of TOML
