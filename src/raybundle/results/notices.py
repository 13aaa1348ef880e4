"""What a result states of itself, for an adjustment of its block that is made once more."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from raybundle.adjustment.result import Adjustment
from raybundle.errors import InputError
from raybundle.io.reading.trees import read_json
from raybundle.results.state import lost, notice_of, notices_in


def as_its_result(adjustment: Adjustment, folder: Path) -> Adjustment:
    """An adjustment that was made again with the notices of its result: what came before it, as the photographs' up.

    folder  the result; one without a result.json, as of a block, has none but the adjustment's own
    """
    found = _result(folder)
    return adjustment if found is None else replace(adjustment, notices=tuple(notice_of(n) for n in notices_in(found)))


def lost_accuracy(folder: Path) -> bool:
    """Whether an accuracy was asked for of a result that is not kept."""
    result = _result(folder)
    return result is not None and lost(result)


def _result(folder: Path) -> Mapping[str, Any] | None:
    try:
        result = read_json(folder / "result.json").value
    except InputError:
        return None
    return result if isinstance(result, dict) else None
