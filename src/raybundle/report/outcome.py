"""What became of something that was asked for of a result: an accuracy, tolerances, lengths."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Outcome:
    """One thing that was asked for."""

    name: str
    """as "wanted accuracy" """
    kept: bool | None
    """None: it cannot be judged"""
    sentence: str
    """what was found, against what was asked for; no stop at its end"""
