"""Ground apart from what stands on it: the simple morphological filter of Pingel, Clarke and McBride (2013), on a grid.

The surface is opened with discs that grow; what an opening cuts off by more than a slope over the disc allows stands
on the ground.  To the slope comes what the standard deviations let heights be off by.
"""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.heights.height_model import HeightModel
from raybundle.surfaces.heights.hole_filling import filled, spanned

SIGMAS = 3.0
"""By which a height may stand above the opened surface for noise alone."""
MOST = 3.0
"""Of usual standard deviations, what noise may be taken for: cells beside walls have the largest, and would stay."""
WIDEST = 1e9


def standing(model: HeightModel, largest: float, slope: float) -> Mask:
    """(rows, columns) cells that stand on the ground, and those that lie below it by blunder.

    largest  width of the largest thing that stands on the ground [cells]
    slope    steepest of the ground, rise over run
    """
    full = filled(model, WIDEST)
    known = full.known
    height = np.where(known, full.heights.height, np.nan).astype(np.float64)
    # orientation moves what stands and what it stands on alike
    local = np.where(known, np.nan_to_num(np.asarray(model.heights.local, float)), 0.0)
    usual = float(np.median(local[model.known])) if model.known.any() else 0.0
    noise = SIGMAS * np.minimum(local, MOST * usual)
    found = _opened(height, known, noise, largest, slope, model.cell)
    low = _opened(-height, known, noise, 1.0, max(slope, 5.0), model.cell)
    return model.known & (found | low)


def _opened(height: Array, known: Mask, noise: Array, largest: float, slope: float, cell: float) -> Mask:
    """What growing openings cut off."""
    last = np.where(known, height, np.inf)
    found = np.zeros(known.shape, bool)
    for radius in range(1, max(1, int(np.ceil(largest / 2))) + 1):
        disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * radius + 1,) * 2)
        eroded = cv2.erode(last, disc, borderType=cv2.BORDER_CONSTANT, borderValue=float("inf"))
        eroded = np.where(np.isfinite(eroded), eroded, -np.inf)
        opened = cv2.dilate(eroded, disc, borderType=cv2.BORDER_CONSTANT, borderValue=float("-inf"))
        with np.errstate(invalid="ignore"):
            found |= known & (last - opened > slope * radius * cell + noise)
        last = np.where(known, opened, np.inf)
    return found


def ground(model: HeightModel, largest: float, slope: float) -> tuple[HeightModel, Mask]:
    """Heights of the ground, spanned below what stands on it, and where that was.

    Limits: what the ground does below a thing that is larger than `largest`, or joins it gently.
    """
    stands = standing(model, largest, slope)
    # edges of things mix both: their neighbours are spanned, too
    wide = cv2.dilate(stands.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    wanted = wide & model.known
    # a step that is no longer there has no part in the ground
    h = model.heights
    beside = cv2.dilate(wide.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    quiet = replace(model, heights=replace(h, step=np.where(beside, 0.0, h.step).astype(np.float32)))
    return spanned(quiet, wanted), stands
