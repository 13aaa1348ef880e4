"""Why a photograph gives a surface no point: nothing confirms its depths, or others know the same places better."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.block import Block
from raybundle.numerics.arrays import Array
from raybundle.pipeline.store import Folder
from raybundle.surfaces.depth_map import doubtful_of
from raybundle.surfaces.fusion import MapView, agreement
from raybundle.surfaces.pairs import Sources
from raybundle.surfaces.rays import ReferenceRays
from raybundle.surfaces.refine import PixelGrid
from raybundle.surfaces.transfer import places_in
from raybundle.workflows.surface_state import SurfaceState
from raybundle.workflows.surfacing.fused import CONFIRMED, MOST_MAPS

ASKED = 1000
"""Points of a map at which others are asked."""
MOST = 8
"""Photographs of which it is told."""


def pointless(state: SurfaceState, counts: dict[int, int], store: Folder) -> tuple[tuple[str, str], ...]:
    """Photographs that give no point, and why; not those whose places others know better, where nothing is amiss.

    counts  points of each reference
    Orientation lets maps differ here by all that it lets them be wrong: a map that agrees so is not at fault.
    """
    told = list[tuple[str, str]]()
    of = {s.reference: s for s in state.chosen}
    for k in sorted(k for k, n in counts.items() if not n):
        why = _why(state, of[k], store)
        if why:
            told.append((state.block.images.ids[k], why))
        if len(told) == MOST:
            break
    return tuple(told)


def _why(state: SurfaceState, s: Sources, store: Folder) -> str:
    """Why a reference has no point; empty: other maps know its places better."""
    mine = _view(state, s.reference, store)
    known = np.flatnonzero(np.isfinite(mine.t))
    region = state.options.region
    if region is not None and len(known):
        inside = region.holds(mine.rays.points(mine.grid.xy_px.reshape(-1, 2)[known], mine.t.flat[known].astype(float)))
        known = known[inside]
    if not len(known):
        return "no depth was found in it" + ("" if region is None else ", of the region")
    pairs = sorted((p for p in s.pairs if p.source in state.maps), key=lambda p: (-p.points, p.source))
    others = sorted(p.source for p in pairs[:MOST_MAPS])
    few = np.full_like(mine.t, np.nan)
    at = known[np.unique(np.linspace(0, len(known) - 1, ASKED).astype(int))]
    few.flat[at] = mine.t.flat[at]
    between = float(np.nanmin(few)), float(np.nanmax(few)) * (1 + 1e-6)
    tables = [places_in(state.block, mine.rays, j, between) for j in others]
    views = (_view(state, j, store) for j in others)
    told = agreement(replace(mine, t=few), views, tables, others, own=s.reference)
    share = told.confirmed(np.ones(len(told.agree), bool))
    if share >= CONFIRMED:
        return ""
    return (
        f"other depth maps confirm {share:.0%} of its depths, and {CONFIRMED:.0%} are needed"
        if share
        else ("no other depth map confirms any of its depths")
    )


def _view(state: SurfaceState, image: int, store: Folder) -> MapView:
    """A map with its standard deviations, all parts together."""
    kept = store.wanted(state.maps[image], ("grid", "t", "slopes", "flags"))
    sigma: Array = store.wanted(state.sigmas[image], ("sigma",))["sigma"]
    block: Block = state.block
    return MapView(
        rays=ReferenceRays.of(block, image), grid=PixelGrid.of_numbers(kept["grid"]), t=kept["t"],
        slopes=kept["slopes"], sigma=sigma, doubtful=doubtful_of(kept["flags"]),
    )  # fmt: skip
