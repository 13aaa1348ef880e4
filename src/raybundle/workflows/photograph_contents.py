"""Whether photographs are still those that a result was made of."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from raybundle.errors import InputError, phrase
from raybundle.io.photos.photo import Photo
from raybundle.io.reading.trees import read_json

CONTENTS = "photographs_sha256"
"""Key of result.json: what each photograph held when it was oriented, by its file name"""


def contents_of(result: Path) -> dict[str, str]:
    """SHA-256 of the photographs that a result was made of, by file name; empty where it does not say."""
    try:
        return {k: v.text() for k, v in read_json(result / "result.json").get(CONTENTS).mapping().items()}
    except InputError:
        return {}


def other_contents(photos: Iterable[Photo], known: Mapping[str, str]) -> str:
    """A remark that photographs are not those that were oriented; empty: they are, or nothing is known of them.

    known  of `contents_of`
    A photograph whose metadata alone were changed has other bytes and the same pixels: it is reported and used.
    """
    others = [p for p in photos if known.get(p.name, p.sha256) != p.sha256]
    if not others:
        return ""
    names = {content: name for name, content in known.items()}
    exchanged = [p for p in others if p.sha256 in names]
    if exchanged:
        pairs = [f"{p.name}: {names[p.sha256]}" for p in exchanged]
        return phrase("surface.photographs_exchanged", n=len(exchanged), names=pairs)
    return phrase("surface.photographs_replaced", n=len(others), names=[p.name for p in others])
