"""How an older model was aligned, in words, numbers and warnings."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from raybundle.cli.heights.words import measured
from raybundle.errors import Message, note, warning

if TYPE_CHECKING:
    from raybundle.surfaces.heights.alignment import Alignment

WIDE = 0.65
"""Share of the heights by which an alignment rests on most of them"""
DATUMS = 110.0
"""Metres by which vertical datums differ at most: the geoid lies 107 m below the ellipsoid at most (EGM2008)"""
MOVED_ALIKE = 0.45
"""Share that may have moved alike at most"""


def alignment_facts(a: Alignment | None) -> dict[str, Any]:
    """All numbers of an alignment."""
    if a is None:
        return {}
    values = dict(zip(("up", "tilt_right", "tilt_up", "right", "above"), a.values.tolist(), strict=True))
    return {"alignment": {
        **values, **{f"{k}_sigma": s for k, s in zip(values, a.sigma.tolist(), strict=True)},
        "covariance": a.covariance.tolist(), "stable": a.share, "noise_own": a.noise.own,
        "noise_common": a.noise.common, "noise_reach_cells": a.noise.reach,
    }}  # fmt: skip


def alignment_lines(a: Alignment, unit: str) -> list[Message]:
    """How an older model was moved."""
    up, *tilts, right, above = (
        measured(v, s, "" if k in {1, 2} else unit)
        for k, (v, s) in enumerate(zip(a.values.tolist(), a.sigma.tolist(), strict=True))
    )
    return [
        note("heights.aligned", share=a.share, up=up),
        note("heights.aligned_plan", right=right, above=above),
        note("heights.aligned_tilts", tilts=tilts),
        note("heights.noise_estimated", sigma=a.noise.sigma, common=a.noise.common, cells=a.noise.reach, unit=unit),
    ]


def alignment_warnings(a: Alignment | None) -> list[Message]:
    """What makes an alignment doubtful."""
    if a is None:
        return []
    found = list[Message]()
    if not a.given and a.share < WIDE:
        found.append(warning("old_heights.narrow", share=a.share, limit=WIDE, moved=MOVED_ALIKE))
    up = float(a.values[0])
    if abs(up) > DATUMS:
        found.append(warning("old_heights.far", up=up, limit=DATUMS))
    return found
