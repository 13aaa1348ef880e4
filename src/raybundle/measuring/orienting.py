"""Photographs without orientation in which points are marked: oriented by these, before a block is merged."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.block import ROLES, Block
from raybundle.measuring.state import State
from raybundle.numerics.arrays import Array, Mask
from raybundle.orientation.projective.manual_points import FewPoints, orient_few
from raybundle.orientation.projective.missing_data import Lack


@dataclass(frozen=True, slots=True, kw_only=True)
class Oriented:
    """A block without the marks of photographs that could not be oriented."""

    block: Block
    new: bool = False
    """whether photographs were oriented here"""
    lacking: tuple[Lack, ...] = ()
    unknown: tuple[str, ...] = ()
    """cameras whose constant comes from the marks alone"""
    by_control: bool = False
    """whether it stands in the frame of control already"""


def unoriented(block: Block) -> Mask:
    """(n,) photographs without orientation; satellite scenes have theirs in their files."""
    scenes = np.array([c.is_scene for c in block.cameras], bool)[block.images.camera]
    return ~block.images.oriented & ~scenes


def oriented(block: Block, state: State, *, free: bool) -> Oriented:
    """Orient the photographs in which everything that is observed was marked by hand.

    block  with the marks of the state
    free   whether nothing fixed the block in space before: its own frame is then not that of control
    Blocks of matched points that are not oriented yet are left to the adjustment's own start.
    """
    out = unoriented(block)
    if not out.any():
        return Oriented(block=block)
    by_hand = _by_hand(block, state, out)
    if (out & ~by_hand).any() and not block.images.oriented.any():
        return Oriented(block=block)
    found: FewPoints = orient_few(_with_given(block, state), control=not free)
    images, cameras = found.block.images, found.block.cameras
    made = replace(block, images=images, cameras=cameras)
    left = (unoriented(made) & by_hand)[block.observations.image]
    return Oriented(
        block=_without_rows(made, left), new=bool(found.new.any()), lacking=found.lacking, unknown=found.unknown,
        by_control=found.by_control,
    )  # fmt: skip


def _by_hand(block: Block, state: State, images: Mask) -> Mask:
    """(n,) those of some images in which nothing but marks of the state is observed."""
    o, b = block.observations, block
    rows = np.flatnonzero(images[o.image])
    foreign = [r for r in rows.tolist() if (b.images.ids[o.image[r]], b.points.ids[o.point[r]]) not in state.marks]
    return images & (np.bincount(o.image[foreign], minlength=len(images)) == 0)


def _without_rows(block: Block, out: Mask) -> Block:
    o, keep = block.observations, ~out
    return replace(
        block,
        observations=replace(o, image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep], cov_px2=o.cov_px2[keep]),
    )


def _with_given(block: Block, state: State) -> Block:
    """With the roles and coordinates that points were given; what is only approximate is left out."""
    p = block.points
    role, xyz, sigma = np.array(p.role), np.array(p.xyz), np.array(p.sigma)
    index = {name: k for k, name in enumerate(p.ids)}
    for name, value in state.points.items():
        if value.reported and value.role == "control":
            k = index[name]
            role[k] = ROLES[value.role]
            xyz[k], sigma[k] = _numbers(value.xyz), _numbers(value.sigma)
    return replace(block, points=replace(p, role=role.astype(np.int32), xyz=xyz, sigma=sigma))


def _numbers(values: tuple[float | None, float | None, float | None]) -> Array:
    return np.array([np.nan if v is None else v for v in values], float)
