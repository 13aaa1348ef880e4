"""Parts of a block."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Literal

import numpy as np

from raybundle.block.block import Block, Role
from raybundle.errors import InputError
from raybundle.numerics.arrays import Index, Mask
from raybundle.numerics.records import positions, taken


def select_block(
    block: Block, what: Literal["point", "image", "camera", "instrument"], which: Mask | Index | Sequence[str]
) -> Block:
    """The block with some of its object points, images, cameras or instruments only.

    which   ids, a mask (k,), or positions (j,), each once, in the order that is wished
    raises  InputError for an id that the block does not have
    Rows that name one that leaves go with it, and the images of a camera; `rejected`, which names by ids, stays.
    """
    every = getattr(block, f"{what}s")
    count, at = len(every), np.asarray(which if isinstance(which, np.ndarray) else list(which))
    if at.dtype.kind not in "biu" and len(at):
        at = _named(every, what, at.tolist())
    elif at.dtype.kind == "b" and len(at) != count:
        raise InputError("select.mask", name=f"{what}s", n=len(at), count=count)
    at = positions(at)
    if len(np.unique(at)) < len(at):
        raise InputError("select.twice", name=f"{what}s")
    new: Index = np.full(count, -1, np.int32)
    new[at] = np.arange(len(at))
    if what == "camera":
        there: Mask = new[block.images.camera] >= 0
        rest = block if there.all() else select_block(block, "image", there)
        return replace(rest, cameras=taken(rest.cameras, at), images=rest.images.renumbered("camera", new))
    if what == "instrument":
        found = replace(block, instruments=taken(block.instruments, at))
    elif what == "image":
        found = replace(block, images=block.images.rows(at), observations=block.observations.renumbered("image", new))
    else:
        found = replace(block, points=block.points.rows(at), observations=block.observations.renumbered("point", new))
    return found.of_tables(lambda t: t.renumbered(what, new))


def _named(every: Any, what: str, ids: Sequence[str]) -> Index:
    """Positions of ids."""
    known = {name: k for k, name in enumerate(getattr(every, "ids", None) or [c.id for c in every])}
    for name in ids:
        if name not in known:
            raise InputError("cell.unknown_id", id=str(name), table=f"{what}s")
    return np.array([known[name] for name in ids], np.int32)


def with_rows(block: Block, keep: Mask) -> Block:
    """The block with these image observations (m,) only; tie points left without any leave it.

    Control points, check points and points that other observations name stay, images stay.
    """
    return select_block(replace(block, observations=block.observations.rows(keep)), "point", points_left(block, keep))


def points_left(block: Block, keep: Mask) -> Mask:
    """(p,) object points that `with_rows` leaves in the block."""
    seen = np.bincount(block.observations.point[keep], minlength=len(block.points)) > 0
    return seen | (np.asarray(block.points.role) != Role.TIE) | block.points_named


def without_images(block: Block, out: Mask) -> Block:
    """The block without the image points, orientation, position and attitude of these images (n,).

    The images stay by name; tie points left with one ray leave.
    """
    if not out.any():
        return block
    o = block.observations
    keep = ~out[o.image]
    rays = np.bincount(o.point[keep], minlength=len(block.points))
    fixed = block.points.is_control.any(axis=1)
    thin = with_rows(block, keep & ((rays > 1) | fixed)[o.point])
    images = replace(
        thin.images,
        centre=np.where(out[:, None], np.nan, thin.images.centre),
        rotation=np.where(out[:, None, None], np.nan, thin.images.rotation),
    )
    left: Index = np.where(out, -1, np.arange(len(out))).astype(np.int32)
    return replace(thin, images=images).of_tables(lambda t: t.renumbered("image", left))
