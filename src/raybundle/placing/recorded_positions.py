"""Positions that fit far better than stated: what that states, and what it does not."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.errors import Message, message, message_of_text, note
from raybundle.io.photos.cameras import CameraGroup
from raybundle.numerics.statistics import chi_square_tails

ALPHA = 1e-3
"""Probability by chance of residuals so small, below which the positions are relatively more precise than stated."""
FEWEST = 6.0
"""Redundancy of the positions from which on that is asked."""
DIRECTIONS = (("plan", ("X", "Y")), ("height", ("Z",)))


def with_relative_precision(result: Adjustment) -> Adjustment:
    """The result with a word where the residuals of positions are significantly smaller than their sigma.

    A receiver's errors change slowly: neighbouring positions have them in common, and residuals after the adjustment
    show what differs alone.  What was stated stays the standard deviation of where the whole block is.
    """
    g = next((g for g in result.groups if g.kind == "station"), None)
    if g is None:
        return result
    smaller: list[Message] = []
    for where, axes in DIRECTIONS:
        rows = np.isin(np.array(g.component), axes) & (g.sigma > 0) & np.isfinite(g.redundancy)
        r = float(g.redundancy[rows].sum())
        square = float(((g.residual[rows] / g.sigma[rows]) ** 2).sum())
        if r < FEWEST or chi_square_tails(square, r)[0] > ALPHA:
            continue
        stated = float(np.median(g.sigma[rows]))
        estimated = float(stated * np.sqrt(square / r))
        smaller.append(message("relative_positions.direction", direction=where, sigma_m=estimated, stated_m=stated))
    if not smaller:
        return result
    control = bool(result.given.points.is_control.any())
    notice = Notice(code="relative_positions", values={"control": control}, details=tuple(smaller))
    return replace(result, notices=(*result.notices, notice))


def camera_notices(groups: Sequence[CameraGroup]) -> list[Notice]:
    """What metadata leave open of the cameras, and what was joined; one notice for cameras with the same remark."""
    apart = [(g, g.projection) for g in groups if g.projection]
    remarks = [(g, r) for g in groups for r in g.remarks if g.stored is None]
    # beside a calibration that is taken, what speaks against it
    doubts = [(g, r) for g in groups for r in g.remarks if g.stored is not None]
    joined = [(g, j) for g in groups for j in g.joined]
    return [
        *_once("camera_projection", apart), *_once("camera", remarks), *_once("camera", doubts, Severity.WARNING),
        *_once("camera_joined", joined),
    ]  # fmt: skip


def _once(code: str, stated: Sequence[tuple[CameraGroup, str]], measured: Severity | None = None) -> Iterator[Notice]:
    """Each remark once, with the cameras to which it applies."""
    for text in dict.fromkeys(text for _, text in stated):
        same = [g for g, other in stated if other == text]
        found, ids = message_of_text(text), tuple(g.id for g in same)
        cameras = note("camera_start.cameras", cameras=ids, n=len(ids), photographs=sum(len(g.photos) for g in same))
        yield Notice(
            code=code, words=found.code, values=found.values, details=(cameras, *found.details), ids=ids,
            measured=measured,
        )  # fmt: skip
