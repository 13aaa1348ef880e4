"""Parts of pictures for sheets: no finer than paper shows, as JPEG."""

from __future__ import annotations

import io
import math
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.report.drawing.content import DrawnPicture

DPI = 400
"""Of the paper: what a printer shows and a magnifier shows"""
QUALITY = 88
LARGEST_PX = 1_000_000_000
"""Pixels of a picture that are taken into memory"""


@contextmanager
def opened(path: Path) -> Generator[Any]:
    """A picture, of any size that memory holds; raises InputError."""
    import warnings

    from PIL import Image

    limit = Image.MAX_IMAGE_PIXELS
    Image.MAX_IMAGE_PIXELS = LARGEST_PX  # our own pictures are larger than the guard against foreign ones
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with Image.open(path) as picture:
                yield picture
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        raise InputError("picture.not_readable", detail=str(error), file=path) from None
    finally:
        Image.MAX_IMAGE_PIXELS = limit


def size_of(path: Path) -> tuple[int, int]:
    """Width and height [px]; raises InputError."""
    with opened(path) as picture:
        return picture.size


def cut(picture: Any, drawn: DrawnPicture, low: Array, high: Array, per_unit: float) -> tuple[bytes, Array] | None:
    """The part of an open picture in a window of the plane as JPEG, and where it lies (4,); None where there is none.

    per_unit  millimetres of paper in a unit of the plane
    """
    from PIL import Image

    extent, p = drawn.extent, drawn.pixel
    lower, upper = np.maximum(extent[:2], low), np.minimum(extent[2:], high)
    if not (upper > lower).all():
        return None
    c0, c1 = math.floor((lower[0] - drawn.left) / p), math.ceil((upper[0] - drawn.left) / p - 1e-9)
    r0, r1 = math.floor((drawn.top - upper[1]) / p), math.ceil((drawn.top - lower[1]) / p - 1e-9)
    c0, r0, c1, r1 = max(c0, 0), max(r0, 0), min(c1, drawn.width_px), min(r1, drawn.height_px)
    if c1 <= c0 or r1 <= r0:
        return None
    part = picture.crop((c0, r0, c1, r1))
    part = _on_white(part)
    factor = min(DPI / 25.4 * p * per_unit, 1.0)
    if factor < 1:
        size = (max(round((c1 - c0) * factor), 1), max(round((r1 - r0) * factor), 1))
        part = part.resize(size, Image.Resampling.LANCZOS, reducing_gap=3)
    buffer = io.BytesIO()
    part.save(buffer, "JPEG", quality=QUALITY, subsampling=0, optimize=True)
    where = np.array([drawn.left + c0 * p, drawn.top - r1 * p, drawn.left + c1 * p, drawn.top - r0 * p])
    return buffer.getvalue(), where


def _on_white(part: Any) -> Any:
    """In red, green, blue or grey of eight bits; what no photograph shows is white."""
    from PIL import Image

    if part.mode.startswith(("I;16", "I")) or part.mode == "F":
        grey = np.asarray(part, float)
        top = 257.0 if part.mode.startswith("I;16") or grey.max(initial=0) > 255 else 1.0
        return Image.fromarray(np.clip(grey / top, 0, 255).astype(np.uint8))
    if part.mode in {"RGBA", "LA", "PA"} or "transparency" in part.info:
        part = part.convert("RGBA")
        white = Image.new("RGBA", part.size, (255, 255, 255, 255))
        return Image.alpha_composite(white, part).convert("RGB")
    return part if part.mode in {"RGB", "L"} else part.convert("RGB")
