"""The photographs of an adjustment, of which a surface is measured: those that are there, and why others are not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.io.photos.photo import Photo, read_photo
from raybundle.numerics.counting import some_of
from raybundle.settings import option

LEAST = 2
"""Photographs of a surface"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Lost:
    """A photograph that was adjusted and cannot be used."""

    image: str
    name: str
    """of its file"""
    why: str

    @property
    def told(self) -> tuple[str, str]:
        """The image, and why it takes no part."""
        return self.image, f"{self.name}: {self.why}"


def photographs_there(block: Block, folders: Sequence[Path]) -> tuple[dict[int, Photo], tuple[Lost, ...]]:
    """The photographs of a block's oriented images, by image, and those that are not there or do not fit.

    raises  InputError where fewer are left than a surface needs
    """
    found, lost = dict[int, Photo](), list[Lost]()
    for i, name in enumerate(block.images.file):
        if not block.images.oriented[i]:
            continue
        photo = _photograph(block, i, folders)
        if isinstance(photo, Photo):
            found[i] = photo
        else:
            lost.append(Lost(image=block.images.ids[i], name=name, why=photo))
    if lost and len(found) < LEAST:
        first = "a surface needs two photographs that show the same part of the object from different places"
        raise InputError(
            f"{first if found else 'no photograph of the result was found'}; "
            f"{lost_words(lost, len(found) + len(lost))}; say where they are with {option('photos', 'FOLDER')}"
        )
    return found, tuple(lost)


def _photograph(block: Block, i: int, folders: Sequence[Path]) -> Photo | str:
    """That of an image, or why it cannot be used."""
    name, camera = block.images.file[i], block.cameras[int(block.images.camera[i])]
    path = next((f / name for f in folders if (f / name).is_file()), None)
    if path is None:
        return "in none of the folders of the photographs"
    try:
        photo = read_photo(path, name=name)
    except InputError as error:
        return error.text().removeprefix(f"{path}: ")
    frame = block.images.frames.get(i, camera)
    if (photo.width_px, photo.height_px) != (frame.width_px, frame.height_px):
        return f"of {photo.width_px} x {photo.height_px} px, its camera of {frame.width_px} x {frame.height_px}"
    return photo


def lost_words(lost: Sequence[Lost], of: int) -> str:
    """How many of so many photographs are lost, which, and why."""
    each = "; ".join(f"{some_of([one.name for one in alike])}: {alike[0].why}" for alike in of_one_reason(lost))
    return f"{len(lost)} of {of} photographs that were adjusted cannot be used: {each}"


def of_one_reason(lost: Sequence[Lost]) -> list[list[Lost]]:
    """Lost photographs, those of one reason together."""
    found = dict[str, list[Lost]]()
    for one in lost:
        found.setdefault(one.why, []).append(one)
    return list(found.values())
