"""How many photographs there are, and how large they are, by their headers alone."""

from __future__ import annotations

from pathlib import Path

from raybundle.errors import InputError
from raybundle.io.photos.container import SUFFIXES, Unusable, read_header
from raybundle.io.photos.photo import LIMIT_PIXELS


def counted_headers(folder: Path) -> tuple[int, float, tuple[str, ...]]:
    """Photographs in a folder, pixels of all of them, and files that are called photographs and cannot be read.

    raises  InputError for what is no folder
    """
    if not folder.is_dir():
        raise InputError("folder.missing_itself", file=folder)
    count, pixels, unread = 0, 0.0, list[str]()
    for path in sorted(folder.iterdir()):
        if path.suffix.lower() not in SUFFIXES or not path.is_file():
            continue
        try:
            header = read_header(path, limit_pixels=LIMIT_PIXELS)
        except (Unusable, OSError):
            unread.append(path.name)
            continue
        count, pixels = count + 1, pixels + header.width_px * header.height_px
    return count, pixels, tuple(unread)
