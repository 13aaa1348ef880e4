"""Why a photograph gives a surface no point: nothing confirms its depths, or others know the same places better."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from raybundle.errors import Text, phrase
from raybundle.surfaces.stages.fusion import CONFIRMED

if TYPE_CHECKING:
    from raybundle.block import Block
    from raybundle.pipeline.store import Folder

MOST = 8
"""Photographs of which it is reported."""


def pointless(
    block: Block, clouds: Mapping[int, str], store: Folder, *, region: bool = False
) -> tuple[tuple[str, str], ...]:
    """Photographs that give no point, and why; not those whose places others know better, where nothing is amiss.

    clouds  key of what each reference gives, as the fusion keeps it
    region  points of a part of the object alone were asked for
    """
    reported = list[tuple[str, str]]()
    for k, key in sorted(clouds.items()):
        if len(store.wanted(key, ("image",))["image"]):
            continue
        found = store.wanted(key, ("depths", "share"))
        if why := _why(found["depths"].item(), found["share"].item(), region=region):
            reported.append((block.images.ids[k], why))
        if len(reported) == MOST:
            break
    return tuple(reported)


def _why(depths: int, share: float, *, region: bool) -> Text | None:
    """Why a reference has no point; None: other maps know its places better.

    depths  that it knows in what is asked for; share  of them that other maps confirm
    """
    if not depths:
        return phrase("surface_remark.no_depth", region=region)
    if share >= CONFIRMED:
        return None
    return phrase("surface_remark.too_few_confirmed", share=share, needed=CONFIRMED)
