"""What stages of `surface` have in common that work by tasks: parts of blocks, tasks that must not fail, colours."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from raybundle.adjustment.evaluation.queries import joint_orientation
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.block.select import select_block
from raybundle.errors import InputError
from raybundle.io.block.arrays import arrays_of_block
from raybundle.io.photos.framed import in_camera_frame
from raybundle.io.photos.masks import MaskFile, Masks
from raybundle.io.photos.photo import Photo, read_colour
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from raybundle.surfaces.depths.orientation import MOST_ERRORS, CommonRoot
from raybundle.surfaces.depths.pairs import Sources
from raybundle.ties.points import grey_of

VERSION = 1
PART, TOGETHER = "surface part", "surface orientation"
"""First words of the keys of parts of the block, and of the errors of all orientations together"""


def part_of(block: Block, images: Index) -> Block:
    """Some images of a block, ascending, and the points that they see."""
    inside = np.zeros(len(block.images), bool)
    inside[images] = True
    part = select_block(block, "image", inside)
    return select_block(part, "point", np.bincount(part.observations.point, minlength=len(part.points)) > 0)


def stored_part(block: Block, images: Sequence[int], store: Folder) -> str:
    """The key of such a part, kept where it is not yet."""
    arrays = arrays_of_block(part_of(block, np.array(images)))
    key = key_of(PART, arrays)
    if not store.has(key):
        store.store(key, arrays)
    return key


def adjustment_key(adjustment: Adjustment) -> str:
    """The key of an adjustment."""
    return key_of("adjustment", VERSION, arrays_of_block(adjustment.adjusted), adjustment.options)


def stored_together(
    adjustment: Adjustment, chosen: Sequence[Sources], references: Sequence[int], means: Means, about: str
) -> str:
    """The key of the independent errors behind all orientations of references and their sources.

    Where there are few of them, those of all photographs of the adjustment: another surface of it, of other
    photographs, then moves by the same.  about: the key of the adjustment
    """
    there = set(references)
    mine = sorted({j for s in chosen if s.reference in there for j in (s.reference, *s.sources)})
    every = np.flatnonzero(adjustment.adjusted.images.oriented).tolist()
    # more unknowns than errors that are kept: each surface keeps its own, which show more of it
    for images in (every, mine) if len(every) <= MOST_ERRORS // 6 else (mine,):
        key = key_of(TOGETHER, VERSION, about, images)
        if means.store.has(key):
            return key
        try:
            joint = joint_orientation(adjustment, images)
        except InputError:  # a photograph that took no part in the adjustment
            if images == mine:
                raise
            continue
        if images == mine or len(joint.unknowns) <= MOST_ERRORS:
            means.store.store(key, CommonRoot.of(joint).as_arrays())
            return key
    raise AssertionError


def all_done(means: Means, tasks: Sequence[Task], what: str) -> None:
    """Do tasks; raises InputError where one of them fails."""
    for reason in means.do(tasks, what, apart=True).values():
        raise InputError(reason)


def _shown(photo: Photo) -> Array:
    """Red, green, blue (h, w, 3) uint8; more than 8 bits without colour, as of a scene, are stretched as grey is."""
    colour = read_colour(photo)
    if photo.bits > 8 and (colour == colour[..., :1]).all():
        colour = np.repeat(grey_of(photo)[..., None], 3, axis=2)
    return colour


def colours_of(photo: Photo, block: Block, image: int, px: float = 1.0) -> tuple[Array, Array]:
    """A photograph (h, w, 3) uint8 in its camera's frame, and the factors (2,) from the camera's pixels to these.

    px  pixels to a place that is looked up: it is reduced where these are two or more
    """
    pixels = in_camera_frame(_shown(photo), block, image)
    factor = max(1, int(px))
    if factor == 1:
        return pixels, np.ones(2)
    small = cv2.resize(pixels, None, fx=1 / factor, fy=1 / factor, interpolation=cv2.INTER_AREA)
    return small, np.array([small.shape[1] / pixels.shape[1], small.shape[0] / pixels.shape[0]])


def free_of(photo: Photo, mask: MaskFile | None, block: Block, image: int) -> Mask | None:
    """(h, w) where a photograph may be measured in, in its camera's frame; None: everywhere."""
    found = None if mask is None else Masks(photos=(photo,), files={photo.name: mask}).of(photo)
    return None if found is None else in_camera_frame(np.where(found, np.uint8(255), np.uint8(0)), block, image) == 255
