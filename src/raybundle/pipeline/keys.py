"""Keys of products: the hash of everything that a product depends on."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping
from collections.abc import Set as AbstractSet
from dataclasses import fields, is_dataclass
from datetime import date
from enum import Enum
from pathlib import Path
from typing import Any, cast

import numpy as np

KEY = re.compile(r"[A-Za-z0-9_ -]+-[0-9a-f]{40}")
"""Keys as `key_of` makes them."""


def key_of(kind: str, *parts: object) -> str:
    """The kind of a product and the hash of everything it depends on.

    parts  texts, numbers, arrays, paths, and mappings, sequences and data classes of them.  What is known by less than
           its fields states it by a property `content`: a photograph is its bytes, wherever it lies.
    raises TypeError for a part whose content cannot be determined
    """
    text = json.dumps(parts, sort_keys=True, ensure_ascii=False, allow_nan=True, separators=(",", ":"), default=_plain)
    return f"{kind}-{hashlib.sha256(text.encode('utf-8', 'surrogatepass')).hexdigest()[:40]}"


def _plain(value: object) -> object:
    """What JSON can say of a value."""
    if hasattr(value, "content"):
        return cast("Any", value).content
    if isinstance(value, np.ndarray):
        held = np.ascontiguousarray(value)
        return [held.dtype.str, *held.shape, hashlib.sha256(held.tobytes()).hexdigest()]
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, Mapping):
        return dict(value)
    if isinstance(value, AbstractSet):
        return sorted(value)
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, Path):
        return str(value)
    if isinstance(value, date):  # with or without a time
        return value.isoformat()
    if is_dataclass(value) and not isinstance(value, type):
        return {"": type(value).__name__, **{f.name: getattr(value, f.name) for f in fields(value)}}
    raise TypeError(f"{type(value).__name__} cannot be part of a key")
