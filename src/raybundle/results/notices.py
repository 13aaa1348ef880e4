"""What a result says of itself, for an adjustment of its block that is made once more."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from raybundle import words
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.errors import InputError, message_of
from raybundle.io.reading.trees import read_json
from raybundle.results.state import lost, notices_in, severity_of


def as_its_result(adjustment: Adjustment, folder: Path) -> Adjustment:
    """An adjustment that was made again with the notices of its result: what came before it, as the photographs' up.

    folder  the result; one without a result.json, as of a block, has none but the adjustment's own
    """
    told = _told(folder)
    return adjustment if told is None else replace(adjustment, notices=tuple(_notice(n) for n in notices_in(told)))


def lost_accuracy(folder: Path) -> bool:
    """Whether an accuracy was asked for of a result that is not kept."""
    told = _told(folder)
    return told is not None and lost(told)


def _told(folder: Path) -> Mapping[str, Any] | None:
    try:
        told = read_json(folder / "result.json").value
    except InputError:
        return None
    return told if isinstance(told, dict) else None


def _notice(told: Mapping[str, Any]) -> Notice:
    """A notice of result.json; with its text where this version lacks the code, or an older one wrote no values."""
    code, values = str(told.get("code", "")), told.get("values") or {}
    ids = tuple(str(i) for i in told.get("ids") or ())
    known = code in words.codes() and {*words.examples(code)} <= {*values, *(["ids"] if ids else [])}
    return Notice(
        code=code, message="" if known else str(told.get("message", "")), measured=severity_of(told), ids=ids,
        values=values, details=tuple(map(message_of, told.get("details") or ())),
    )  # fmt: skip
