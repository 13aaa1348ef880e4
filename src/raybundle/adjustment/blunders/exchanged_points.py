"""Rejected image points of an image that fit under one another's names: exchanged when they were measured."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.predict import predicted_px
from raybundle.block.points import automatic
from raybundle.block.rejection import RejectionKind
from raybundle.errors import message
from raybundle.numerics.arrays import Index

SHOWN = 5
BLUNDERS = {RejectionKind.BLUNDER, RejectionKind.BLUNDER_NOT_LOCATED, RejectionKind.BEHIND_CAMERA}


def exchanged_notices(result: Adjustment) -> list[Notice]:
    """Remarks on the image points that are rejected under their own names and fit under those of each other.

    People exchange names; of tie points that were found without a name it is a mismatch.
    """
    o, ids = result.given.observations, result.given.points.ids
    out = np.array([r is not None and r.kind in BLUNDERS for r in result.image_observations.rejected], bool)
    rows = np.flatnonzero(out)
    rows = rows[np.argsort(o.image[rows], kind="stable")]
    parts = np.split(rows, np.flatnonzero(np.diff(o.image[rows])) + 1) if len(rows) else []
    found = [(int(o.image[part[0]]), pair) for part in parts for pair in _pairs(result, int(o.image[part[0]]), part)]
    unnamed = automatic(ids)
    named = [(i, pair) for i, pair in found if not unnamed[list(pair)].any()]
    matched = [(i, pair) for i, pair in found if unnamed[list(pair)].any()]
    notices = list[Notice]()
    if named:
        notices.append(_notice(result, "names_exchanged", named))
    if matched:
        notices.append(_notice(result, "ties_mismatched", matched))
    return notices


def _notice(result: Adjustment, code: str, found: Sequence[tuple[int, tuple[int, int]]]) -> Notice:
    ids, images = result.given.points.ids, result.given.images.ids
    each = tuple(
        message("names_exchanged.pair", first=ids[a], second=ids[b], image=images[i]) for i, (a, b) in found[:SHOWN]
    )
    return Notice(code=code, values={"pairs": len(found)}, ids=_names(result, found), details=each)


def _names(result: Adjustment, found: Sequence[tuple[int, tuple[int, int]]]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(result.given.points.ids[k] for _, pair in found for k in pair))[:100]


def _pairs(result: Adjustment, image: int, row: Index) -> list[tuple[int, int]]:
    """Two points each that lie where the other one was measured, within the limit of data snooping."""
    block, o = result.adjusted, result.given.observations
    row = row[np.isfinite(block.points.xyz[o.point[row]]).all(axis=1)]
    if len(row) < 2:
        return []
    at = predicted_px(block, image, block.points.xyz[o.point[row]])
    sigma = np.sqrt(o.cov_px2[row, :2]) * max(result.sigma0, 1.0) * result.critical_tau
    fits = (np.abs(at[:, None] - o.xy_px[row][None]) < sigma[None]).all(axis=2)  # [predicted, measured]
    both = np.argwhere(fits & fits.T)
    return [(int(o.point[row[a]]), int(o.point[row[b]])) for a, b in both.tolist() if a < b]
