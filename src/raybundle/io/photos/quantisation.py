"""Tables by which a JPEG was quantised."""

from __future__ import annotations

from pathlib import Path


def quantisation_tables(path: Path) -> list[list[int]]:
    """Tables (64 each) of a JPEG, that of luminance first; [] of other files, and where the file is not there.

    Not known: what was lost before, by a camera or program that wrote the picture as another JPEG.
    """
    from PIL import Image, UnidentifiedImageError

    try:
        with Image.open(path) as picture:
            tables = getattr(picture, "quantization", None) or {}
    except (OSError, UnidentifiedImageError):
        return []
    return [list(tables[k]) for k in sorted(tables)]
