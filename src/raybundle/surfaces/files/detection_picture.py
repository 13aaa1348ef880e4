"""The smallest detectable movement at each place as a picture, with axes, a scale bar and a legend."""

from __future__ import annotations

import cv2
import numpy as np
from PIL import Image

from raybundle.errors import phrase
from raybundle.surfaces.files.displacement_picture import LEFT, TOP, Sheet, axes, hatched, scale_bar
from raybundle.surfaces.files.input import Opened
from raybundle.surfaces.heights.level_of_detection import DetectionMap

UNKNOWN = (150, 150, 150)
"""Of places where the level of detection is not known for squares of this size"""
LEAST_RANGE = 3.0
"""Of amounts from one end of the colours to the other: smaller differences look small"""
CLEAR = 0.02
"""Share of the places with the smallest and the largest amounts that have the colours of the ends"""


def detection_picture(o: Opened, found: DetectionMap) -> Image.Image:
    """Dark where small movements are detected, bright where large ones are; grey: not known; hatched: not tested."""
    sheet, amount = Sheet.of(found.amount.shape), found.amount
    known = np.isfinite(amount)
    low, high = np.quantile(amount[known], (CLEAR, 1 - CLEAR)).tolist() if known.any() else (1.0, 2.0)
    high = max(high, LEAST_RANGE * low)
    share = np.clip(np.log(np.where(known, amount, low) / low) / np.log(high / low), 0, 1)
    colours = _coloured(share)
    colours[np.isinf(amount)] = UNKNOWN
    how = cv2.INTER_NEAREST if sheet.scale >= 1 else cv2.INTER_AREA
    image = cv2.resize(colours, sheet.size, interpolation=how)
    hole = cv2.resize(np.isnan(amount).astype(np.uint8), sheet.size, interpolation=cv2.INTER_NEAREST) > 0
    image[hole] = hatched(*image.shape[:2])[hole]
    sheet.image.paste(Image.fromarray(image), (LEFT, TOP))
    unit = o.unit or "none"
    sheet.text(LEFT, TOP - 12, phrase("height_drawing.detectable", side=found.side, unit=unit), 18, "ls")
    axes(sheet, o)
    left, wide, y = scale_bar(sheet, o), 260, sheet.bottom + 56
    scale = _coloured(np.linspace(0, 1, wide)[None].repeat(14, axis=0))
    sheet.image.paste(Image.fromarray(scale), (left, y))
    sheet.draw.rectangle((left - 1, y - 1, left + wide, y + 14), outline=(110, 110, 110))
    for k in (0.0, 0.5, 1.0):
        sheet.text(left + k * wide, y + 18, f"{low * (high / low) ** k:.2g} {o.unit}".rstrip(), 13, "ma")
    x = 8.0
    for state in ("unknown", "untested"):
        box = (round(x), y + 48, round(x) + 22, y + 62)
        if state == "untested":
            sheet.image.paste(Image.fromarray(hatched(14, 22)), box[:2])
        sheet.draw.rectangle(box, fill=UNKNOWN if state == "unknown" else None, outline=(40, 40, 40))
        text = phrase("height_drawing.detectable_swatch", state=state)
        sheet.text(x + 28, y + 55, text, 13, "lm")
        x += 60 + sheet.draw.textlength(text, font_size=13)
    return sheet.image


def _coloured(share: np.ndarray) -> np.ndarray:
    """(..., 3) uint8 from dark to bright at shares 0 to 1 (cividis, which the colour-blind can read)."""
    scale = cv2.applyColorMap(np.arange(256, dtype=np.uint8)[None], cv2.COLORMAP_CIVIDIS)[0, :, ::-1]
    return np.ascontiguousarray(scale[np.round(255 * share).astype(int)])
