"""Stage: tie points of photographs measured by least-squares matching."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from raybundle.block import Block
from raybundle.errors import phrase
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.io.photos.masks import Masks
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rows import rows_of_each
from raybundle.pipeline.stage import Codec, Means, Stage
from raybundle.ties.block import TieBlock
from raybundle.ties.match_weights import Matches
from raybundle.ties.precise import PreciseBlock, Visible, Weights, refine
from raybundle.ties.windows import KINDS, greys, matched
from raybundle.workflows.orienting.state import ORIENT, OrientState
from raybundle.workflows.stage_arrays import Reasons, numbered, reasons_as_array, reasons_of_array, texts, unpacked
from raybundle.workflows.stage_memory import room_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What precise tie points depend on."""

    ties: tuple[TieBlock, ...]
    photos: tuple[Photo, ...]
    masks: Masks | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """Precise tie points of every part."""

    blocks: tuple[Block, ...]
    weights: tuple[Weights, ...]
    matches: tuple[Matches, ...]
    offered: int
    measured: int
    added: int
    features_kept: int
    by_features: tuple[str, ...]
    left_out: Reasons


def _inputs(state: OrientState) -> Inputs:
    return Inputs(ties=state.ties, photos=state.photos, masks=state.masks)


def measure(i: Inputs, means: Means) -> Measured:
    """Least-squares matching of each part by tasks, photographs held in memory as far as they may."""
    visible = None if i.masks is None else _visible(i.masks, i.photos)
    match = partial(matched, means, i.photos)
    try:
        with room_of(means, max(len(tie.block.observations) for tie in i.ties)):
            found: list[PreciseBlock] = [refine(tie, match, means.jobs, means.progress, visible) for tie in i.ties]
    finally:
        greys.forget()
    return Measured(
        blocks=tuple(f.block for f in found),
        weights=tuple(f.weights for f in found),
        matches=tuple(f.matches for f in found),
        offered=sum(f.offered for f in found),
        measured=sum(f.measured for f in found),
        added=sum(f.added for f in found),
        features_kept=sum(f.features_kept for f in found),
        by_features=tuple(n for f in found for n in f.by_features),
        left_out=tuple(r for f in found for r in f.left_out),
    )


def _put(state: OrientState, m: Measured) -> OrientState:
    dropped = state.dropped
    if dropped is not None:
        dropped = replace(
            dropped, measured=m.measured, added=m.added, features_kept=m.features_kept,
            adjusted=sum(len(b.observations) for b in m.blocks),
        )  # fmt: skip
    names = list(m.by_features)
    reported = (phrase("stage_summary.by_features", names=names, n=len(names)),) if names else ()
    return replace(
        state, blocks=m.blocks, weights=m.weights, matches=m.matches, dropped=dropped, lost=(*state.lost, *m.left_out),
        reported=(*state.reported, *reported), offered=m.offered,
    )  # fmt: skip


def _outcome(state: OrientState) -> str:
    dropped, used = state.dropped, sum(len(b.observations) for b in state.blocks)
    assert dropped is not None
    return phrase(
        "stage_summary.precision", n=dropped.measured, of=state.offered, added=dropped.added, used=used
    )  # fmt: skip


def _visible(masks: Masks, photos: Sequence[Photo]) -> Visible:
    """Where the photographs show what may be measured."""

    def visible(image: Index, xy_px: Array, radius_px: Array) -> Mask:
        found = np.ones(len(image), bool)
        for photo, rows in zip(photos, rows_of_each(image, len(photos)), strict=True):
            if len(rows):
                found[rows] = masks.visible(photo, xy_px[rows], radius_px[rows])
        return found

    return visible


def _arrays(m: Measured) -> dict[str, Array]:
    parts = [
        {**arrays_of_block(b), "weights": w.array(), **{f"match_{n}": getattr(f, n) for n in Matches.FIGURES}}
        for b, w, f in zip(m.blocks, m.weights, m.matches, strict=True)
    ]
    return {
        **numbered(parts),
        "counts": np.array([m.offered, m.measured, m.added, m.features_kept]),
        "by_features": texts(m.by_features),
        "left_out": reasons_as_array(m.left_out),
    }


def _product(a: Mapping[str, Array]) -> Measured:
    parts = [*unpacked(a).values()]
    blocks = tuple(block_of_arrays(p) for p in parts)
    offered, measured, added, kept = a["counts"].tolist()
    return Measured(
        blocks=blocks, weights=tuple(Weights.of(p["weights"]) for p in parts),
        matches=tuple(_matches(b, p) for b, p in zip(blocks, parts, strict=True)),
        offered=offered, measured=measured, added=added, features_kept=kept,
        by_features=tuple(a["by_features"].tolist()), left_out=reasons_of_array(a["left_out"]),
    )  # fmt: skip


def _matches(block: Block, a: Mapping[str, Array]) -> Matches:
    o, figures = block.observations, {n: a[f"match_{n}"] for n in Matches.FIGURES}
    return Matches(images=block.images.ids, image=o.image, xy_px=o.xy_px, **figures)


STAGE = ORIENT.register(
    Stage(
        name="precision",
        kinds=KINDS,
        version=29,
        after=("scene_start",),
        inputs=_inputs,
        function=measure,
        put=_put,
        reported=_outcome,
        codec=Codec(arrays=_arrays, product=_product),
        when=lambda s: s.asked.options.precise and bool(s.photos),
    )
)
