"""Stage: which photographs measure the surface together."""

from __future__ import annotations

from dataclasses import dataclass, replace

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.pipeline.stage import Means, Stage
from raybundle.surfaces.pairs import Sources, sources_of_each
from raybundle.workflows.surface_state import SURFACE, SurfaceState


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What the choice depends on."""

    block: Block
    images: tuple[int, ...]
    """those whose photographs are there"""


def choose(i: Inputs, means: Means) -> tuple[Sources, ...]:
    """The sources of each photograph that is there; raises InputError where no two show the same part of the object."""
    del means
    there = set(i.images)
    found = [s for s in sources_of_each(i.block, among=i.images) if s.reference in there]
    if not any(s.sources for s in found):
        refused = [p for s in found for p in s.refused]
        ids = i.block.images.ids
        why = "no two of them have enough points in common"
        if refused:
            p = max(refused, key=lambda p: p.points)
            why = f"as {ids[p.reference]} and {ids[p.source]}: {p.refusal}"
        raise InputError(
            f"a surface needs two photographs that show the same part of the object from different places; {why}"
        )
    return tuple(found)


def _put(state: SurfaceState, chosen: tuple[Sources, ...]) -> SurfaceState:
    ids = state.block.images.ids
    alone = [(ids[s.reference], _why(s)) for s in chosen if not s.sources]
    pairs = [
        (f"{ids[p.reference]} and {ids[p.source]}", p.refusal)
        for s in chosen
        for p in s.refused
        if p.reference < p.source
    ]
    return replace(state, chosen=tuple(s for s in chosen if s.sources), left_out=(*state.left_out, *alone, *pairs))


def _why(s: Sources) -> str:
    """Why a photograph measures nothing."""
    if not s.pairs:
        return "no other photograph has enough points in common with it"
    return f"no other photograph is of use with it: {max(s.pairs, key=lambda p: p.points).refusal}"


def _told(state: SurfaceState) -> str:
    pairs = sum(len(s.sources) for s in state.chosen)
    return f"{len(state.chosen)} references, {pairs} pairs"


STAGE = SURFACE.register(
    Stage(
        name="sources", function=choose, put=_put, told=_told, little=True,
        inputs=lambda s: Inputs(block=s.block, images=tuple(sorted(s.photos))),
    )
)  # fmt: skip
