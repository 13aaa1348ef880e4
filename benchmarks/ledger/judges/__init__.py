"""Judges: one file for each kind of truth.  A judge is a function (set, places) -> errors."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module

from ledger.errors import Errors
from ledger.sets import LedgerSet, Places

JUDGES = {
    "network": "networks",
    "sensors": "sensor_blocks",
    "check_points": "check_points",
    "cameras": "cameras",
    "rendered": "rendered",
    "boards": "boards",
    "halves": "photograph_halves",
    "moved": "displacements",
    "heights": "height_models",
    "colmap": "colmap",
}
"""Name in a TOML file -> module of this folder, whose function `judge` is taken"""

Judge = Callable[[LedgerSet, Places], list[Errors]]


def judge_named(name: str) -> Judge:
    """The judge of this name.

    raises  KeyError with the names that there are
    """
    if name not in JUDGES:
        raise KeyError(f"judge {name!r} is none of {', '.join(JUDGES)}")
    return import_module(f"ledger.judges.{JUDGES[name]}").judge
