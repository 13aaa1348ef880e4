"""Photographs that do not hang together: each connected component is oriented, control joins what it places."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Role
from raybundle.block.merge import SUBJECTS, merge_blocks
from raybundle.block.select import with_rows
from raybundle.errors import InputError, NoOrientation, message
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.placing.georeference import Georeferenced, Surroundings, georeference
from raybundle.placing.marks import Given
from raybundle.placing.positions import without_idle
from raybundle.ties.block import TieBlock
from raybundle.ties.start import Found, StartMethod, start

FEWEST_IMAGES = 3
"""Photographs of a component that is worth a result of its own."""
PANORAMAS = ("panorama", "spherical")
"""Sensor models of images that are called panoramas."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ConnectedComponent:
    """Photographs that hang together and that nothing joins to the others."""

    adjustment: Adjustment
    photographs: tuple[str, ...]


def start_components(
    raw: Block,
    scale_px: Array,
    angle: Array,
    threads: int,
    progress: Progress = silent,
    method: StartMethod = "auto",
    in_parts: Callable[[Block], Found] | None = None,
) -> tuple[TieBlock, ...]:
    """Approximate values of every connected component, the largest first; what is in none is listed with the first.

    raises  NoOrientation where not even two photographs fit
    """
    components = [start(raw, scale_px, angle, threads, progress, method, in_parts)]
    left, reasons = _left(raw, components[0]), dict(components[0].not_oriented)
    while left.sum() >= FEWEST_IMAGES:
        rows = np.flatnonzero(left[raw.observations.image])
        try:
            found = start(
                with_rows(raw, left[raw.observations.image]), scale_px[rows], angle[rows], threads, progress, method
            )
        except NoOrientation:
            break
        oriented = found.block.images.oriented
        if oriented.sum() < FEWEST_IMAGES:
            break
        components.append(found)
        left &= ~oriented
    components.sort(key=lambda c: (-int(c.block.images.oriented.sum()), -len(c.block.observations)))
    inside = {n for p in components for n, o in zip(raw.images.ids, p.block.images.oriented, strict=True) if o}
    lost = tuple((n, r) for n, r in reasons.items() if n not in inside)
    return (replace(components[0], not_oriented=lost), *(replace(p, not_oriented=()) for p in components[1:]))


def _left(raw: Block, first: TieBlock) -> Array:
    """(n,) photographs with image points and without an orientation."""
    seen = np.bincount(raw.observations.image, minlength=len(raw.images)) > 0
    return seen & ~first.block.images.oriented


def place_components(
    blocks: Sequence[Block], photos: Sequence[Photo], given: Given, around: Surroundings | None = None
) -> tuple[Georeferenced, tuple[Georeferenced, ...]]:
    """Bring every component to object space: the block of all that are placed there, and those that are not.

    around  what stands there already, as `georeference` takes it
    The first leads: where nothing places it, none is joined to it.
    raises  InputError as `georeference` does for the first, unless others stand there: it is apart then
    """
    try:
        first = georeference(blocks[0], photos, given, around)
    except InputError:
        if around is None:
            raise
        first = georeference(blocks[0], photos, Given(gps=False, up=given.up if "," not in given.up else "auto"))
    joined, apart = [first], list[Georeferenced]()
    for block in blocks[1:]:
        try:
            placed = georeference(block, photos, given, around)
        except InputError:
            placed = georeference(block, photos, Given(gps=False, up=given.up if "," not in given.up else "auto"))
        if placed.fixed and first.fixed and not placed.firm:
            # nothing but how the photographs were held would show its turn about the line of its positions
            placed = georeference(block, photos, Given(gps=False, up=given.up if "," not in given.up else "auto"))
        (joined if placed.fixed and first.fixed else apart).append(placed)
    apart = [replace(p, block=without_idle(p.block)) for p in apart]
    if len(joined) == 1:
        return replace(first, block=without_idle(first.block)), tuple(apart)
    notices = {n.text: n for p in joined for n in p.notices}
    block = without_idle(merged([p.block for p in joined]))
    marked = np.asarray(block.points.role) != Role.TIE
    names = {n for p in joined for n, m in zip(p.block.points.ids, p.marked, strict=True) if m}
    marked |= np.array([n in names for n in block.points.ids])
    whole = replace(
        first, block=block, marked=marked, notices=tuple(notices.values()),
        joined=tuple(_names(p.block) for p in joined),
    )  # fmt: skip
    return whole, tuple(apart)


def joined_notice(joined: Sequence[Sequence[str]], main: Block) -> tuple[Notice, ...]:
    """What the result states of components that control or positions join, if photographs of them are left in it."""
    there = set(_names(main))
    counts = [n for part in joined if (n := len(there.intersection(part)))]
    if len(counts) < 2:
        return ()
    return (Notice(code="parts_joined", values={"parts": len(counts), "photographs": counts}),)


def merged(blocks: Sequence[Block]) -> Block:
    """One block of blocks over the same images and cameras, each with other images oriented, in one object system.

    The block with the most images speaks for cameras and instruments, the first for points that several hold.
    """
    most = max(range(len(blocks)), key=lambda k: int(blocks[k].images.oriented.sum()))
    return merge_blocks(blocks, prefer={**dict.fromkeys(SUBJECTS, most), "point": 0})


def component_folder(k: int) -> str:
    """Folder of the result of the k-th further component."""
    return f"result-{k + 2}"


def apart_notice(main: Block, apart: Sequence[Georeferenced], folders: Sequence[str]) -> Notice:
    """What the result of the main component states of the others."""
    names = [_names(p.block) for p in apart]
    blocks = [main, *(p.block for p in apart)]
    every = {kind for b in blocks for kind in _count(b)}
    what = every.pop() if len(every) == 1 else "image"
    values = {"what": what, "parts": len(blocks), "n": len(_oriented(main))}
    details = tuple(
        message(
            "parts_apart.part", folder=f, names=n, scenes=count.get("scene", 0), panoramas=count.get("panorama", 0),
            photographs=count.get("photograph", 0),
        )
        for count, n, f in zip((_count(p.block) for p in apart), names, folders, strict=True)
    )  # fmt: skip
    ids = tuple(n for part in names for n in part)
    if any(_count(b).keys() == {"scene"} for b in blocks):
        return Notice(code="parts_apart.scenes", values=values, ids=ids, details=details)
    return Notice(code="parts_apart", values=values, ids=ids, details=details)


def _names(block: Block) -> tuple[str, ...]:
    """The oriented images."""
    return tuple(n for n, o in zip(block.images.ids, block.images.oriented, strict=True) if o)


def _oriented(block: Block) -> list[int]:
    """The cameras of the oriented images."""
    return block.images.camera[block.images.oriented].tolist()


def _count(block: Block) -> dict[str, int]:
    """Oriented images by what they are: scene, panorama or photograph."""
    found: dict[str, int] = {}
    for c in _oriented(block):
        camera = block.cameras[c]
        kind = "scene" if camera.is_scene else "panorama" if camera.model in PANORAMAS else "photograph"
        found[kind] = found.get(kind, 0) + 1
    return dict(sorted(found.items(), reverse=True))
