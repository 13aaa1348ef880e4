"""Stage: which photographs measure the surface together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from raybundle.block import Block
from raybundle.errors import InputError, Text, message, message_of_text, named, phrase
from raybundle.pipeline.stage import Means, Stage
from raybundle.surfaces.depths.depth_map import depth_range
from raybundle.surfaces.depths.pairs import Sources, sources_of_each
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.region_pixels import shown_part
from raybundle.surfaces.photographs import Lost, lost_message
from raybundle.surfaces.region import SurfaceRegion
from raybundle.surfaces.state import SURFACE, SurfaceState


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What the choice depends on."""

    block: Block
    images: tuple[int, ...]
    """those whose photographs are there"""
    region: SurfaceRegion | None
    lost: tuple[Lost, ...]
    """those that are not"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Chosen:
    """What measures what."""

    sources: tuple[Sources, ...]
    shares: Mapping[int, float] = field(default_factory=dict[int, float])
    """of the pixels of each reference that may show the region; empty: no region is asked for"""


def choose(i: Inputs, means: Means) -> Chosen:
    """The sources of each photograph that is there; raises InputError where no two show the same part of the object.

    Of a region they are those of the whole: a reference measures the same, whatever else is measured.
    """
    there = set(i.images)
    found = [s for s in sources_of_each(i.block, among=i.images) if s.reference in there]
    if not any(s.sources for s in found):
        refused = [p for s in found for p in s.refused]
        ids = i.block.images.ids
        details = [message("depths.no_common_points")]
        if refused:
            p = max(refused, key=lambda p: p.points)
            details = [named(f"{ids[p.reference]}, {ids[p.source]}", p.refusal)]
        if i.lost:
            details.append(lost_message(i.lost, len(there) + len(i.lost)))
        raise InputError("surface.no_pair", details=details)
    if i.region is None:
        return Chosen(sources=tuple(found))
    shares = dict[int, float]()
    for n, s in enumerate(found):
        means.progress("photographs of the region", n / len(found))
        if s.sources:
            shares[s.reference] = _share(i.block, s.reference, i.region)
    if not any(shares.values()):
        left, bottom, right, top = i.region.extent
        raise InputError("surface.region_not_shown", left=left, right=right, bottom=bottom, top=top)
    return Chosen(sources=tuple(found), shares=shares)


def _share(block: Block, k: int, region: SurfaceRegion) -> float:
    """Of the pixels of a reference that may show the region."""
    rays = ReferenceRays.of(block, k)
    try:
        t_range = depth_range(block, rays, k)
    except InputError:
        return 1.0  # its map states why there is none
    shown = shown_part(rays, t_range, region)
    return 0.0 if shown is None else shown.share


def _put(state: SurfaceState, found: Chosen) -> SurfaceState:
    ids, chosen = state.block.images.ids, found.sources
    blind = [k for k, share in found.shares.items() if not share]
    alone = [(ids[s.reference], _why(s)) for s in chosen if not s.sources]
    pairs = [
        (f"{ids[p.reference]} – {ids[p.source]}", p.refusal)
        for s in chosen
        for p in s.refused
        if p.reference < p.source
    ]
    unseen = [(ids[k], phrase("depths.region_not_shown")) for k in blind]
    return replace(
        state, chosen=tuple(s for s in chosen if s.sources and s.reference not in blind), shares=found.shares,
        left_out=(*state.left_out, *alone, *unseen, *pairs),
    )  # fmt: skip


def _why(s: Sources) -> Text:
    """Why a photograph measures nothing."""
    if not s.pairs:
        return phrase("depths.no_partner")
    refusal = max(s.pairs, key=lambda p: p.points).refusal
    return Text.of(message("depths.no_useful_partner"), message_of_text(refusal))


def _outcome(state: SurfaceState) -> str:
    pairs = sum(len(s.sources) for s in state.chosen)
    return f"{len(state.chosen)} references, {pairs} pairs"


STAGE = SURFACE.register(
    Stage(
        name="sources", function=choose, put=_put, reported=_outcome, little=True,
        inputs=lambda s: Inputs(block=s.block, images=tuple(sorted(s.photos)), region=s.options.region, lost=s.lost),
    )
)  # fmt: skip
