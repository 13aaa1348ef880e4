"""Alternative: features of reduced copies, where photographs show nothing at the size of their pixels.

Photographs that are soft, noisy or heavily compressed are oriented by features of copies where these orient more of
them; they are tried where the first start leaves photographs.
"""

from __future__ import annotations

from dataclasses import replace

from raybundle.adjustment.records.notice import Notice
from raybundle.errors import NoOrientation
from raybundle.matching.reduced import LONGEST_PX, WORTH, Reduced, reduction
from raybundle.pipeline.stage import Alternative
from raybundle.ties.start import LEFT
from raybundle.workflows.orienting.state import ORIENT, OrientState


def _begin(before: OrientState, first: OrientState | None) -> OrientState | None:
    """The state with another method of features; None where that is not worth it, and with scenes."""
    photos, oriented = before.photos, 0 if first is None else first.oriented
    large = all(reduction(p.width_px, p.height_px) >= WORTH for p in photos)
    if before.scenes is not None or not photos or oriented >= (1 - LEFT) * len(photos) or not large:
        return None
    return replace(before, method=Reduced(before.method), again=True)


def _better(first: OrientState, second: OrientState) -> OrientState:
    """The second way where it orients more photographs, with a word."""
    return _with_notice(second, first.oriented) if second.oriented > first.oriented else first


def _with_notice(state: OrientState, whole: int) -> OrientState:
    values = {"size_px": LONGEST_PX, "oriented": state.oriented, "photographs": len(state.photos), "whole": whole}
    return replace(state, notices=(*state.notices, Notice(code="reduced_features", values=values)))


ALTERNATIVE = ORIENT.register_alternative(
    Alternative(
        first=("matching", "scene_matching", "start", "scene_start"),
        second=("features", "matching", "start"),
        begin=_begin,
        better=_better,
        only=lambda s: _with_notice(s, 0),
        nothing=NoOrientation,
    )
)
