"""What the result that a run is about to replace had, and the new one has not."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.datum import open_values
from raybundle.errors import InputError
from raybundle.io.reading.trees import read_json


def less_fixed(folder: Path, adjustment: Adjustment) -> Notice | None:
    """The caution that a result replaces one whose scale or place was known; None where nothing is lost.

    folder  of the earlier result; without one that can be read nothing is stated
    """
    try:
        earlier: Any = read_json(folder / "result.json").value
    except InputError:
        return None
    before: object = earlier.get("datum_defect") if isinstance(earlier, dict) else None
    if not isinstance(before, list):
        return None
    lost = [name for name in adjustment.datum_defect if name not in before]
    if len(adjustment.datum_defect) <= len(before) or not lost:
        return None
    part, details = open_values(lost)
    return Notice(code="datum_lost", values={"part": part}, details=details)
