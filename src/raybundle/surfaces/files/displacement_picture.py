"""What has moved as a picture: regions in colours, all else muted, with axes, a scale bar and what is what."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from PIL import Image, ImageDraw, ImageFont

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.files.drawings import ticks
from raybundle.surfaces.files.input import Opened
from raybundle.surfaces.heights.contours import ring_lines
from raybundle.surfaces.heights.displacement import Movements
from raybundle.surfaces.heights.height_model import HeightModel
from raybundle.surfaces.heights.level_of_detection import SmallestMovement

SHOWN_PX, LEAST_PX = 1400, 900
"""Longer side of the surface, and the width of the sheet at least"""
RED, WHITE, BLUE = (178, 24, 43), (247, 247, 247), (33, 102, 172)
"""Of what has risen, stayed and sunk (after ColorBrewer's RdBu by Cynthia Brewer)"""
MUTED, UNMEASURED, HATCH, INK = (226, 226, 226), (186, 186, 186), (150, 150, 150), (40, 40, 40)
PALE = 0.2
"""Strength of the colours of what is within chance"""
SMOOTH = 5
"""Cells along the side of the means that colours are of"""
LEFT, RIGHT, TOP, BOTTOM = 96, 28, 44, 176
"""Margins [px]; what is what stands below"""
MOST_LABELS = 40


def write_picture(
    path: str, o: Opened, model: HeightModel, found: Movements, smallest: tuple[SmallestMovement, ...]
) -> None:
    """Write it as PNG."""
    picture(o, model, found, smallest).save(path)


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheet:
    """A picture, and where the surface lies on it."""

    image: Image.Image
    draw: ImageDraw.ImageDraw
    scale: float
    """pixels along the side of a cell"""
    right: int
    bottom: int

    @classmethod
    def of(cls, shape: tuple[int, int]) -> Sheet:
        """An empty one for a surface of so many rows and columns."""
        scale = SHOWN_PX / max(shape)
        rows, columns = (max(1, round(n * scale)) for n in shape)
        image = Image.new("RGB", (max(LEFT + columns + RIGHT, LEAST_PX), TOP + rows + BOTTOM), (255, 255, 255))
        return cls(image=image, draw=ImageDraw.Draw(image), scale=scale, right=LEFT + columns, bottom=TOP + rows)

    @property
    def size(self) -> tuple[int, int]:
        """Columns and rows of the surface [px]."""
        return self.right - LEFT, self.bottom - TOP

    def text(self, x: float, y: float, text: str, size: int = 14, anchor: str = "la", halo: int = 0) -> None:
        """Write."""
        self.draw.text(
            (x, y), text, fill=INK, font=ImageFont.load_default(size), anchor=anchor, stroke_width=halo,
            stroke_fill=(255, 255, 255),
        )  # fmt: skip


def picture(o: Opened, model: HeightModel, found: Movements, smallest: tuple[SmallestMovement, ...]) -> Image.Image:
    """Regions that have moved in the colours of their movement, what is within chance pale, holes hatched."""
    size = _size(found, smallest)
    sheet = Sheet.of(model.shape)
    sheet.image.paste(_surface(model, found, size, sheet.size), (LEFT, TOP))
    sheet.text(LEFT, TOP - 12, _title(found), 18, "ls")
    _outlines(sheet, found, o.unit)
    axes(sheet, o)
    _legend(sheet, o, size, smallest)
    return sheet.image


def _title(found: Movements) -> str:
    return phrase("height_drawing.regions_moved", n=len(found.regions))


def _size(found: Movements, smallest: tuple[SmallestMovement, ...]) -> float:
    """Movement of the full colour: of what has moved most, or would have been found."""
    most = max((max(abs(r.amount), abs(r.mean)) for r in found.regions), default=0.0)
    would = [s.amount for s in smallest if np.isfinite(s.amount)] + [s.best for s in smallest if np.isfinite(s.best)]
    known = np.isfinite(found.local) & (found.sigma > 0)
    size = most or min(would, default=5 * float(np.median(found.sigma[known])) if known.any() else 1.0)
    power = 10.0 ** np.floor(np.log10(size))
    return float(next(k for k in (1, 1.5, 2, 3, 4, 5, 6, 8, 10) if k * power >= size * (1 - 1e-3)) * power)


def _coloured(share: Array) -> Array:
    """(..., 3) from blue at -1 through white to red at 1."""
    white, red, blue = (np.array(c, float) for c in (WHITE, RED, BLUE))
    share = np.clip(share, -1, 1)[..., None]
    return np.where(share > 0, white + share * (red - white), white - share * (blue - white))


def _means(model: HeightModel, local: Array, within: Mask) -> Array:
    """(rows, columns) weighted means of neighbours within the same."""
    used = within & model.known
    w = np.where(used, 1 / np.maximum(np.square(model.local.astype(float)), 1e-300), 0.0)
    w /= max(float(w.max(initial=0.0)), 1e-300)
    total, weight = (cv2.blur(v, (SMOOTH, SMOOTH)) for v in (w * np.where(used, local, 0.0), w))
    return np.where(weight > 0, total / np.maximum(weight, 1e-300), 0.0)


def _surface(model: HeightModel, found: Movements, size: float, shape: tuple[int, int]) -> Image.Image:
    """The surface alone, of so many columns and rows."""
    moved = np.zeros(model.shape, bool)
    for r in found.regions:
        moved |= r.cells
    differs = model.local > 0
    mean = _means(model, found.local, ~moved & differs)
    # what lies within the standard deviation of a single height fades
    mean *= np.minimum(1.0, np.abs(mean) / np.maximum(np.nan_to_num(model.local.astype(float)), 1e-300))
    still = PALE * (_coloured(mean / size) - WHITE) + MUTED
    still[~differs] = MUTED
    colours = still
    for r in found.regions:
        colours[r.cells] = _coloured(_means(model, found.local, r.cells) / size)[r.cells]
    how = cv2.INTER_NEAREST if shape[0] >= model.shape[1] else cv2.INTER_AREA
    image = cv2.resize(np.clip(colours, 0, 255).astype(np.uint8), shape, interpolation=how)
    hole = cv2.resize((~model.known & ~moved).astype(np.uint8), shape, interpolation=cv2.INTER_NEAREST) > 0
    image[hole] = hatched(*image.shape[:2])[hole]
    return Image.fromarray(image)


def hatched(rows: int, columns: int) -> Array:
    """(rows, columns, 3) uint8 of what was not measured."""
    r, c = np.mgrid[:rows, :columns]
    return np.where(((r + c) % 8 < 2)[..., None], HATCH, UNMEASURED).astype(np.uint8)


def _outlines(sheet: Sheet, found: Movements, unit: str) -> None:
    """Outlines of what has moved, with their numbers and amounts."""
    for n, r in enumerate(found.regions, 1):
        lines = [line * sheet.scale + (LEFT, TOP) for line in ring_lines(r.cells)]
        for line in lines:
            sheet.draw.line([*map(tuple, line.tolist()), tuple(line[0].tolist())], fill=(255, 255, 255), width=5)
            sheet.draw.line([*map(tuple, line.tolist()), tuple(line[0].tolist())], fill=INK, width=2)
        if n > MOST_LABELS:
            continue
        ring = max(lines, key=len)
        x, y = ring[:, 0].max() + 6, ring[:, 1].min()
        text = f"{n}: {signed(r.amount, r.amount_sigma)} {unit}".rstrip()
        wide = sheet.draw.textlength(text, font=ImageFont.load_default(15))
        if x + wide > sheet.right:
            x = max(LEFT + 2.0, ring[:, 0].min() - 6 - wide)
        sheet.text(x, max(y, TOP + 2), text, 15, "la", 3)


def signed(value: float, sigma: float) -> str:
    """With its sign, to the place of the first digit of its standard deviation, at least two digits."""
    places = max(0, int(np.ceil(-np.log10(sigma)))) if sigma > 0 else 4
    places = max(places, 1 - int(np.floor(np.log10(abs(value)))) if value else 0)
    return f"{value:+.{places}f}"


def axes(sheet: Sheet, o: Opened) -> None:
    """Coordinates along the left and lower edge."""
    sheet.draw.rectangle((LEFT - 1, TOP - 1, sheet.right, sheet.bottom), outline=(110, 110, 110))
    f = o.file
    unit = f" [{o.unit}]" if o.unit else ""
    x, digits = ticks(f.left, f.left + f.width * f.cell, max(2, (sheet.right - LEFT) // 130))
    for v in x.tolist():
        at = LEFT + (v - f.left) / f.cell * sheet.scale
        sheet.draw.line((at, sheet.bottom, at, sheet.bottom + 5), fill=INK)
        sheet.text(at, sheet.bottom + 8, f"{v:.{digits}f}", 13, "ma")
    y, digits = ticks(f.top - f.height * f.cell, f.top, max(2, (sheet.bottom - TOP) // 110))
    for v in y.tolist():
        at = TOP + (f.top - v) / f.cell * sheet.scale
        sheet.draw.line((LEFT - 6, at, LEFT - 1, at), fill=INK)
        sheet.text(LEFT - 9, at, f"{v:.{digits}f}", 13, "rm")
    names = ("east", "north") if f.wkt else ("right", "up")
    sheet.text(sheet.right, sheet.bottom + 26, f"{names[0]}{unit}", 13, "ra")
    sheet.text(6, TOP - 14, f"{names[1]}{unit}", 13, "ls")


def scale_bar(sheet: Sheet, o: Opened) -> int:
    """A bar of a round length of about a fifth of the sheet; where a scale of colours begins beside it."""
    y, draw = sheet.bottom + 56, sheet.draw
    length, digits = ticks(0, max(sheet.right - LEFT, 200) / 4 / sheet.scale * o.file.cell, 2)
    bar = float(length[-1]) / o.file.cell * sheet.scale
    draw.rectangle((8, y + 4, 8 + bar / 2, y + 10), fill=INK)
    draw.rectangle((8 + bar / 2, y + 4, 8 + bar, y + 10), fill=(255, 255, 255), outline=INK)
    sheet.text(8 + bar + 8, y + 7, f"{length[-1]:.{digits}f} {o.unit}", 13, "lm")
    return max(LEFT, round(8 + bar + 110))


def _legend(sheet: Sheet, o: Opened, size: float, smallest: tuple[SmallestMovement, ...]) -> None:
    """A scale bar, what colours are, and how small a movement would have been found."""
    y, draw = sheet.bottom + 56, sheet.draw
    unit = o.unit or "none"
    left, wide = scale_bar(sheet, o), 260
    share = np.linspace(-1, 1, wide)[None].repeat(14, axis=0)
    sheet.image.paste(Image.fromarray(np.round(_coloured(share)).astype(np.uint8)), (left, y))
    draw.rectangle((left - 1, y - 1, left + wide, y + 14), outline=(110, 110, 110))
    for k, text in ((0.0, f"{-size:.2g}"), (0.5, "0"), (1.0, f"+{size:.2g}")):
        sheet.text(left + k * wide, y + 18, text, 13, "ma")
    sheet.text(8, y + 42, phrase("height_drawing.movement", unit=unit, upright=bool(o.file.wkt)), 14)
    x = 8.0
    for state, colour in (("moved", None), ("chance", MUTED), ("unknown", HATCH)):
        text = phrase("height_drawing.swatch", state=state)
        box = (round(x), y + 66, round(x) + 22, y + 80)
        if colour == HATCH:
            sheet.image.paste(Image.fromarray(hatched(14, 22)), box[:2])
        draw.rectangle(box, fill=colour if colour == MUTED else None, outline=INK, width=1 if colour else 2)
        sheet.text(x + 28, y + 73, text, 13, "lm")
        x += 28 + draw.textlength(text, font=ImageFont.load_default(13)) + 22
    would = [f"{s.amount:.2g} ({s.side:.3g} x {s.side:.3g})" for s in smallest if np.isfinite(s.amount)]
    if would:
        sheet.text(8, y + 90, phrase("height_drawing.smallest_movements", unit=unit, movements=would), 13)
