"""Masks over a photograph: what was drawn, and what was read from the folder that the project's run was given."""

from __future__ import annotations

import io
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.io.photos.masks import find_masks
from raybundle.io.photos.photo import read_photo
from raybundle.measuring.actions.masks import masked_in
from raybundle.pipeline.project import masks_given
from raybundle.studio.desk import Desk, named

LONGEST_PX = 1024
"""Side of the picture of a mask that is sent."""
COLOUR = 255, 127, 42
"""Of what is masked, as the page draws polygons; how much of the photograph shines through is for the page."""


def drawn(desk: Desk, image: str) -> dict[str, Any]:
    """The polygons that leave a part of an image out, those drawn for its camera included; pixels of its file."""
    found = masked_in(desk.given, desk.journal.state, named(desk, image))
    return {"areas": [{"mask": name, "polygon": xy.tolist()} for name, xy in found.items()]}


def picture(desk: Desk, image: str) -> bytes:
    """PNG of the mask that was read from a folder, coloured where it hides; b"": there is none that can be used."""
    from PIL import Image

    k, folder = named(desk, image), masks_given(desk.source)
    path = desk.tiles.paths.get(k)
    if folder is None or path is None:
        return b""
    photo = read_photo(path, name=desk.given.images.file[k] or image)
    try:
        free = find_masks(folder, [photo]).of(photo)
    except InputError:  # that it lacks is stated by the run's notices
        return b""
    if free is None:
        return b""
    step = max(1, -(-max(free.shape) // LONGEST_PX))
    shown = np.zeros((*free[::step, ::step].shape, 4), np.uint8)
    shown[~free[::step, ::step]] = *COLOUR, 255
    out = io.BytesIO()
    Image.fromarray(shown).save(out, "PNG")
    return out.getvalue()
