"""Rows of CSV tables as text: numbers shortest so that they read back equal, texts quoted where they must be."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import msgspec
import numpy as np

from raybundle.numerics.arrays import Array

WHOLE = 1e15
"""Below this, whole numbers are written alike with and without a fraction."""

SPECIAL = frozenset(',"\\[]') | {chr(k) for k in range(32)} | {chr(127)}
"""What a text must not hold for its row to be had from JSON."""


def rows_of(parts: Sequence[Sequence[str] | Array]) -> str:
    """The lines of columns of texts and numbers (n,) side by side, each with its end; NaN is an empty cell."""
    return _plain_rows(parts) or _quoted_rows(parts)


def _plain_rows(parts: Sequence[Sequence[str] | Array]) -> str:
    """Rows of texts without special characters, by way of JSON; empty where a text has one.

    In `["a",1.5,2.0]` brackets and quotes are marks, and `.0` stands between marks or commas only.
    """
    texts = [p for p in parts if not isinstance(p, np.ndarray)]
    if any(not SPECIAL.isdisjoint("".join(text)) for text in texts):
        return ""
    cells = [_plain_cells(np.asarray(p, float)) if isinstance(p, np.ndarray) else p for p in parts]
    lines = msgspec.json.encode(list(zip(*cells, strict=True)), enc_hook=str)
    for mark, cell in ((b".0,", b","), (b".0]", b"]"), (b"],[", b"\n")):
        lines = lines.replace(mark, cell)
    return lines[2:-2].translate(None, b'"').decode() + "\n"


def _plain_cells(values: Array) -> list[Any]:
    """Numbers; where all are whole, as such; an empty text for what is not finite, as JSON has no number for it."""
    finite = np.isfinite(values)
    known = values[finite]
    if np.array_equal(known, np.rint(known)) and (abs(known) < WHOLE).all() and not np.signbit(known).any():
        cells: list[Any] = np.where(finite, values, 0).astype(np.int64).tolist()
    else:
        cells = values.tolist()
    for k in np.flatnonzero(~finite).tolist():
        cells[k] = ""
    return cells


def _quoted_rows(parts: Sequence[Sequence[str] | Array]) -> str:
    cells = [_number_cells(p) if isinstance(p, np.ndarray) else _text_cells(p) for p in parts]
    return "".join(f"{row}\n" for row in map(",".join, zip(*cells, strict=True)))


def _number_cells(values: Array) -> list[str]:
    if len(values) == 0:
        return []
    text = msgspec.json.encode(np.asarray(values, float).tolist()).decode()[1:-1] + ","
    return text.replace("null", "").replace(".0,", ",")[:-1].split(",")


def _text_cells(values: Sequence[str]) -> list[str]:
    joined = "".join(values)
    if not any(special in joined for special in ',"\r\n'):
        return list(values)
    return [f'"{v.replace(chr(34), chr(34) * 2)}"' if any(s in v for s in ',"\r\n') else v for v in values]
