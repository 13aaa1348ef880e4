"""The photographs of an adjustment, of which a surface is measured: those that are there, and why others are not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from raybundle.block import Block
from raybundle.errors import InputError, Message, Text, message, named, phrase, text_of_error, without_file
from raybundle.io.photos.photo import Photo, read_photo

SHOWN = 3
"""Names of photographs with one reason that a message has"""
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
    def reported(self) -> tuple[str, str]:
        """The image, and why it takes no part."""
        return self.image, Text.of(named(self.name, self.why))


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
        raise InputError(
            "surface.too_few_photographs", n=len(found), least=LEAST,
            details=[lost_message(lost, len(found) + len(lost))],
        )  # fmt: skip
    return found, tuple(lost)


def _photograph(block: Block, i: int, folders: Sequence[Path]) -> Photo | str:
    """That of an image, or why it cannot be used."""
    name, camera = block.images.file[i], block.cameras[int(block.images.camera[i])]
    path = next((f / name for f in folders if (f / name).is_file()), None)
    if path is None:
        return phrase("photograph.in_no_folder")
    try:
        photo = read_photo(path, name=name)
    except InputError as error:
        return without_file(text_of_error(error), path)
    frame = block.images.frames.get(i, camera)
    if (photo.width_px, photo.height_px) != (frame.width_px, frame.height_px):
        return phrase(
            "photograph.other_size", width_px=photo.width_px, height_px=photo.height_px,
            block_width_px=frame.width_px, block_height_px=frame.height_px,
        )  # fmt: skip
    return photo


def lost_message(lost: Sequence[Lost], of: int) -> Message:
    """How many of so many photographs are lost, which, and why."""
    details = list[Message]()
    for alike in of_one_reason(lost):
        names = [one.name for one in alike]
        more = f" (+{len(names) - SHOWN})" if len(names) > SHOWN else ""
        details.append(named(", ".join(names[:SHOWN]) + more, alike[0].why))
    return message("surface.photographs_lost", n=len(lost), photographs=of, details=details)


def of_one_reason(lost: Sequence[Lost]) -> list[list[Lost]]:
    """Lost photographs, those of one reason together."""
    found = dict[str, list[Lost]]()
    for one in lost:
        found.setdefault(one.why, []).append(one)
    return list(found.values())
