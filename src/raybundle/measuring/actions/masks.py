"""Areas of photographs in which nothing is to be measured, drawn as polygons; and the pictures made of them."""

from __future__ import annotations

import shutil
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import ClassVar

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.io.folders import new_folder
from raybundle.io.photos.masks import Masks, find_masks, mask_file
from raybundle.io.photos.photo import Photo, read_photo
from raybundle.io.reading.words import quoted
from raybundle.measuring.actions.base import Action
from raybundle.measuring.actions.checks import check_name, check_number
from raybundle.measuring.frames import to_camera, to_file
from raybundle.measuring.names import Known
from raybundle.measuring.state import Draft, MaskedArea, State
from raybundle.numerics.arrays import Array, Mask

MOST_CORNERS = 5000
LEAST_PX2 = 1.0
"""Area of a polygon: that of a pixel."""
PARTS = 8
"""Bits of a pixel's fraction with which corners are drawn."""
FOLDER = "measured-masks"
"""Of a project: the pictures that the last run of `orient` took."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SetMask(Action):
    """An area of a photograph, or of all photographs of its camera, to be left out; one of that name is replaced."""

    verb: ClassVar[str] = "mask"
    mask: str
    image: str
    polygon: tuple[tuple[float, float], ...]
    """corners in the pixels of the image's file"""
    camera: bool = False
    """whether it is left out of every photograph of the same camera, at the same place of its format"""

    def settled(self, state: State, known: Known) -> Action:
        del state
        check_name("mask", self.mask)
        image, n = known.image(self.image), len(self.polygon)
        if not 3 <= n <= MOST_CORNERS:
            raise InputError("mark.mask_corners", mask=self.mask, n=n, most=MOST_CORNERS)
        for k, place in enumerate(self.polygon):
            for axis, value in zip("xy", place, strict=True):
                check_number(f"{self.mask}, polygon[{k}].{axis}", value)
            known.inside(image, *place)
        if not (hull := hull_area(self.polygon)) >= LEAST_PX2:
            raise InputError("mark.mask_area", mask=self.mask, area_px2=hull, least_px2=LEAST_PX2)
        return replace(self, image=image)

    def apply(self, draft: Draft) -> None:
        draft.masks[self.mask] = MaskedArea(image=self.image, polygon=tuple(self.polygon), camera=self.camera)


@dataclass(frozen=True, slots=True, kw_only=True)
class Unmask(Action):
    """Take a drawn mask away."""

    verb: ClassVar[str] = "unmask"
    mask: str

    def settled(self, state: State, known: Known) -> Action:
        del known
        if self.mask not in state.masks:
            raise InputError("mark.no_mask", mask=quoted(self.mask), known=list(state.masks), n=len(state.masks))
        return self

    def apply(self, draft: Draft) -> None:
        draft.masks.pop(self.mask, None)


def hull_area(polygon: Sequence[tuple[float, float]]) -> float:
    """Area [px^2] of the convex hull of a polygon that may cross itself; 0 for corners in one line."""
    import cv2

    corners = (np.array(polygon, float) - polygon[0]).astype(np.float32)
    return float(cv2.contourArea(cv2.convexHull(corners)))


def masked_in(block: Block, state: State, image: int) -> dict[str, Array]:
    """Name -> corners (n, 2) of the areas left out of an image, in the pixels of its file.

    What was drawn for all photographs of a camera lies at the same place of the camera's format, however a file is
    turned.  Areas drawn in images that the block does not hold are left out.
    """
    index = {name: k for k, name in enumerate(block.images.ids)}
    found: dict[str, Array] = {}
    for name, drawn in state.masks.items():
        at, xy = index.get(drawn.image), np.array(drawn.polygon, float)
        if at == image:
            found[name] = xy
        elif at is not None and drawn.camera and block.images.camera[at] == block.images.camera[image]:
            found[name] = to_file(block, image, to_camera(block, at, xy))
    return found


def free_of(polygons: Sequence[Array], size_px: tuple[int, int]) -> Mask:
    """(h, w) False in the polygons (n, 2) [px, from the outer corner of the first pixel] and where their edges pass.

    size_px  width and height
    Where a polygon crosses itself, what lies inside an odd number of times is left out.
    """
    import cv2

    drawn = np.full((size_px[1], size_px[0]), 255, np.uint8)
    for polygon in polygons:
        # OpenCV counts from the centre of the first pixel, in parts of a pixel
        corners = np.round((polygon - 0.5) * 2**PARTS).astype(np.int32)
        cv2.fillPoly(drawn, [corners], 0, shift=PARTS)
    return drawn > 0


def drawn_by_file(block: Block, state: State) -> dict[str, list[Array]]:
    """File of an image, as the block names it -> the polygons (n, 2) left out of it; only images with any."""
    found: dict[str, list[Array]] = {}
    for k, name in enumerate(block.images.ids):
        if polygons := masked_in(block, state, k):
            found[block.images.file[k] or name] = [*polygons.values()]
    return found


def photographs_in(block: Block, folders: Sequence[Path]) -> list[Photo]:
    """The photographs of a block that are found in some folders, each called as the block calls its file."""
    return [read_photo(path, name=name) for name, path in photograph_files(block, folders).items()]


def photograph_files(block: Block, folders: Sequence[Path]) -> dict[str, Path]:
    """Where the photographs of a block are, by the names of their files in it; those found in some folders."""
    found: dict[str, Path] = {}
    for name in block.images.file:
        parts = Path(name.replace("\\", "/"))
        inside = bool(name) and not parts.is_absolute() and ".." not in parts.parts
        path = next((p for f in folders if inside for p in (f / parts, f / parts.name) if p.is_file()), None)
        if path is not None:
            found[name] = path
    return found


def write_masks(folder: Path, photos: Sequence[Photo], drawn: Mapping[str, list[Array]], given: Path | None) -> int:
    """Write PHOTO.png for each photograph that has a mask, as COLMAP names them: 0 where nothing is to be measured.

    photos  all photographs
    drawn   file or name of a photograph -> polygons (n, 2) [px of the file] (`drawn_by_file`)
    given   a folder of masks that are heeded, too; None: none
    returns how many are written; the folder holds nothing else after
    raises  InputError where nothing is to be written
    A given mask that cannot be used is copied as it is, for the reader to say so, unless something is drawn there.
    """
    from PIL import Image

    masks = Masks(photos=()) if given is None else find_masks(given, photos)
    refused = {name for name, _ in masks.refused}
    count = 0
    with new_folder(folder, replacing=True) as made:
        for photo in photos:
            polygons = drawn.get(photo.name, [])
            free = masks.of(photo) if photo.name in masks.files else None
            if polygons:
                own = free_of(polygons, (photo.width_px, photo.height_px))
                free = own if free is None else free & own
            file = made / f"{photo.name}.png"
            file.parent.mkdir(parents=True, exist_ok=True)
            if free is None:
                if photo.name in refused and given is not None and (there := mask_file(given, photo)) is not None:
                    shutil.copyfile(there, file)  # whoever reads it states again why it cannot be used
                continue
            # an orientation of its own shows that it lies on the pixels as stored
            exif = Image.Exif()
            exif[274] = photo.orientation
            Image.fromarray(np.asarray(free, np.uint8) * 255).save(file, exif=exif)
            count += 1
        if not count:
            raise InputError(
                "mark.no_masks_at_all",
                file=folder,
            )
    return count
