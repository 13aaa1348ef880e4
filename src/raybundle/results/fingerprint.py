"""What an adjustment is known by to what was made of it: whether its result is still the one that stands there."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from raybundle.errors import InputError, phrase
from raybundle.io.block.places import block_places
from raybundle.io.reading.trees import read_toml
from raybundle.io.table_files import table_file

FINGERPRINT = "result_sha256"
"""Under which what is made of a result keeps it"""
SOURCES = ("project.db", "result.json", "block.toml")
"""One of which stands in whatever a surface is measured of"""
AROUND = 2
"""Folders above a surface in which its result is looked for: heights of the ground lie in the folder of their own"""


def fingerprint(source: Path) -> str:
    """SHA-256 of the orientations and cameras of a project, a result or a block folder; empty where there are none.

    Limits: points and observations that are others and left both as they were to the last bit.
    """
    block = next((p for p in block_places(source) if (p / "block.toml").is_file()), None)
    if block is None:
        return ""
    try:
        cameras = read_toml(block / "block.toml").tree().get("cameras").value
        found = hashlib.sha256(json.dumps(cameras, sort_keys=True, default=str).encode())
        found.update(table_file(block, "images").read_bytes())
    except (InputError, OSError):
        return ""
    return found.hexdigest()


def adjusted_since(folder: Path, known: str) -> str:
    """That the project or result in which the folder of a surface lies was adjusted again; empty: nothing states it.

    known  fingerprint of the result that was measured; empty: it is not known
    """
    around = folder.resolve().parents[:AROUND] if known else ()
    source = next((p for p in around if any((p / name).is_file() for name in SOURCES)), None)
    now = "" if source is None else fingerprint(source)
    if source is None or now in {"", known}:
        return ""
    return phrase("heights.adjusted_since", name=source.name)
