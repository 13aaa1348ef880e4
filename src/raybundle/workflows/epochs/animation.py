"""The dates one after another as an animation: rectified photographs with the displacements until each date."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.workflows.epochs.movements import IN_AREA, MOVED, Movements
from raybundle.workflows.epochs.pictures import DatedPictures

SHOWN_PX, FINER, MS = 960, 2, 1200
"""Longer side of the animation, dots along the side of one of its pixels while it is drawn, and time of a date"""
LONGEST = 1 / 18
"""Share of the longer side that the larger displacements are drawn with"""
NEAR, AWAY, OPEN, INK, WHITE = (213, 94, 0), (0, 114, 178), (124, 135, 146), (16, 21, 26), (255, 255, 255)
"""Displaced towards the viewer, away, not significantly (after Okabe and Ito 2008)"""


def animation(m: Movements, folders: Sequence[Path], progress: Progress = silent) -> bytes:
    """A GIF of all dates; raises InputError where points show no plane, or no photograph of a date shows it."""
    pictures = DatedPictures.of(m.adjustment.adjusted)
    d, g = m.displacements, pictures.grid
    metres = 0.001 if m.adjustment.adjusted.length_unit == "mm" else 1.0
    moved = np.array([v in {MOVED, IN_AREA} for v in d.verdict], bool)
    share = SHOWN_PX / max(g.width, g.height)
    # pixels of what is drawn, in one metre
    dots = FINER * share / (g.pixel * metres)
    factor = _round(LONGEST * FINER * SHOWN_PX / dots / _large(d.length[moved]))
    at, seen = pictures.cells(d.xyz / metres) * FINER * share, pictures.directions(d.vector) * factor * dots
    size = round(FINER * share * g.width), round(FINER * share * g.height)
    frames: list[Image.Image] = []
    for k, date in enumerate(m.dates.names):
        frame = Image.fromarray(pictures.rectified(date, folders, progress)).resize(size, Image.Resampling.LANCZOS)
        draw = ImageDraw.Draw(frame)
        shown = np.flatnonzero([v != "stable" for v in d.verdict] & ((d.end == k) | (k == 0) & (d.end == d.end.min())))
        for row in shown.tolist():
            _draw(draw, at[row], seen[row] if k else np.zeros(3), bool(moved[row] and k))
        _text(draw, (24, 16), date, 44)
        if k and moved.any():
            _key(draw, size[1], factor, dots, free=m.adjustment.free_scale)
        frames.append(frame.resize((size[0] // FINER, size[1] // FINER), Image.Resampling.BOX))
    held = BytesIO()
    frames[0].save(held, "gif", save_all=True, append_images=frames[1:], duration=MS, loop=0)
    return held.getvalue()


def _large(lengths: Array) -> float:
    """Nine of ten are shorter."""
    return max(float(np.quantile(lengths, 0.9)), 1e-12) if len(lengths) else 1.0


def _round(value: float) -> float:
    """The next smaller of 1, 2, 5, 10 ..."""
    power = 10.0 ** np.floor(np.log10(value))
    return float(power * next(f for f in (5, 2, 1) if f * power <= value * (1 + 1e-9)))


def _draw(draw: ImageDraw.ImageDraw, at: Array, seen: Array, sure: bool) -> None:  # noqa: FBT001
    """An arrow in the plane, and a dot as large as what is across it."""
    u, v = at.tolist()
    right, up, near = seen.tolist()
    if np.hypot(right, up) > 4:
        _arrow(draw, (u, v), (u + right, v - up), INK if sure else OPEN)
    radius = min(max(5.0, 0.12 * abs(near)), 18.0)
    colour = OPEN if not sure else NEAR if near >= 0 else AWAY
    draw.ellipse((u - radius, v - radius, u + radius, v + radius), fill=colour, outline=WHITE, width=2)


def _arrow(
    draw: ImageDraw.ImageDraw, start: tuple[float, float], end: tuple[float, float], colour: tuple[int, int, int]
) -> None:
    way = np.arctan2(end[1] - start[1], end[0] - start[0])
    head = min(16.0, float(np.hypot(end[0] - start[0], end[1] - start[1])))
    wings = [(end[0] + head * np.cos(way + t), end[1] + head * np.sin(way + t)) for t in (2.7, -2.7)]
    for fill, width in ((WHITE, 8), (colour, 4)):
        draw.line([start, end], fill=fill, width=width)
        draw.line([wings[0], end, wings[1]], fill=fill, width=width, joint="curve")


def _key(draw: ImageDraw.ImageDraw, height: int, factor: float, dots: float, *, free: bool) -> None:
    """An arrow of a round length."""
    length = _round(120 / (factor * dots))
    x, y = 28.0, height - 40.0
    _arrow(draw, (x, y), (x + length * factor * dots, y), INK)
    words = "" if free else f"{1000 * length:g} mm" if length < 1 else f"{length:g} m"
    _text(draw, (x + length * factor * dots + 16, y - 18), words, 32)


def _text(draw: ImageDraw.ImageDraw, at: tuple[float, float], text: str, size: int) -> None:
    font = ImageFont.load_default(size)
    draw.text(at, text, fill=WHITE, font=font, stroke_width=5, stroke_fill=INK)
