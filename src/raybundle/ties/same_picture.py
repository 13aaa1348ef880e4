"""Photographs that show the same picture at the same places of the format: copies, or exposures without any base.

A copy, saved anew or reduced, repeats the noise of its original: counted as a further photograph it promises standard
deviations that are too good, by up to the square root of two.  Its points coincide with those of the original, as
`adjust` looks for in blocks.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.io.photos.photo import Photo
from raybundle.io.photos.remote import at_hand
from raybundle.matching.features import FeatureMethod
from raybundle.matching.verify import VerifiedPair
from raybundle.ties.points import FeatureStore
from raybundle.ties.static_background import still_and_moving

SHOWN = 3
"""Photographs that a notice lists."""
APART_PX = 0.5
"""Median length between the places of a point up to which two photographs may be one picture: that of identical images
of a block.  Pixels that a program saves anew stay where they are; a camera in the hand moves by many."""
SHARE = 0.6
"""Of all matches that stand still, as of the points of identical images; and no others have a geometry of their own."""

COVERED = 0.8
"""Of the cells of the format in which both have features, with some that stand still: a copy has them in nearly all.

Two photographs of equal things at the same pixels have them there alone."""


def same_pictures(
    pairs: Sequence[VerifiedPair], photos: Sequence[Photo], store: FeatureStore, method: FeatureMethod
) -> dict[int, int]:
    """Photographs that repeat another, by their index, and the index of the one that is to stay.

    Of each group stays what shows its camera and, of those, what has most bytes, the least compressed.  Empty where
    fewer than two photographs would stay.

    Limits: a copy from a second exposure by a camera that stood still.
    """
    twins: dict[int, set[int]] = {}
    for p in pairs:
        if p.geometry == "none" or not _apart_px(p, photos, store) < APART_PX:
            continue
        pair = still_and_moving(photos, store, method, p.first, p.second)
        if pair.still > SHARE * pair.matches and not pair.moving and pair.covered > COVERED:
            twins.setdefault(p.first, set()).add(p.second)
            twins.setdefault(p.second, set()).add(p.first)
    repeats: dict[int, int] = {}
    for i in sorted(
        twins, key=lambda k: (not photos[k].metadata.model, -at_hand(photos[k].path, lambda p: p.stat().st_size), k)
    ):
        kept = sorted(k for k in twins[i] if k not in repeats)
        if i not in repeats:
            repeats.update(dict.fromkeys(kept, i))
    return repeats if len(photos) - len(repeats) >= 2 else {}


def _apart_px(pair: VerifiedPair, photos: Sequence[Photo], store: FeatureStore) -> float:
    """Median length between the places of a match, in pixels of the smaller photograph; infinite for other shapes."""
    small, large = sorted((pair.first, pair.second), key=lambda k: photos[k].width_px)
    size, full = ((photos[k].width_px, photos[k].height_px) for k in (small, large))
    if size == full:
        return pair.displacement_px
    rounded = abs(full[1] * size[0] / full[0] - size[1]) <= 1  # one proportion, but for whole pixels
    if not rounded or not len(pair.matches):
        return np.inf
    one, other = (
        store.places(k).xy_px[pair.matches[:, c]] / (photos[k].width_px, photos[k].height_px)
        for c, k in enumerate((pair.first, pair.second))
    )
    return float(np.median(np.linalg.norm((one - other) * size, axis=1)))


def same_picture_notice(repeats: dict[int, int], photos: Sequence[Photo]) -> Notice:
    """What there is to say of photographs that repeat others and are left out."""
    named = [f"{photos[i].name} ({photos[k].name})" for i, k in sorted(repeats.items())]
    return Notice(
        code="identical_images.copies", ids=tuple(photos[i].name for i in sorted(repeats)),
        values={"n": len(named), "names": named[:SHOWN]},
    )  # fmt: skip
