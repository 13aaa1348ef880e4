"""Photographs of each date rectified onto one plane of the object, pixel on pixel."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np

from raybundle.block import Block
from raybundle.block.frames import in_file_frames
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.workflows.object_plane import Plane, plane_of
from raybundle.workflows.rectify import Grid, grid_over, rectify_block, usual_pixel

SHOWN_PX, FINER = 1600, 2
"""Longer side of a picture, and pixels of a photograph's rectification along the side of one of its pixels at most:
what is finer than pixels would flicker from date to date"""
BEYOND, MARGIN = 0.005, 0.03
"""Share of the points that may lie beyond each side: single wrong ones do; and what is shown around the others"""
NO_COLOUR = 235
"""Grey value of what no photograph shows"""


@dataclass(frozen=True, slots=True, kw_only=True)
class DatedPictures:
    """A plane of the object, the pixels of its pictures, and the photographs of each date."""

    block: Block
    plane: Plane
    grid: Grid
    dates: tuple[str, ...]

    @classmethod
    def of(cls, block: Block) -> DatedPictures:
        """On the plane of most points of an adjusted block of several dates; raises InputError where there is none."""
        block = in_file_frames(block)
        plane = plane_of(block)
        seen = np.bincount(block.observations.point, minlength=len(block.points)) > 1
        at = plane.coordinates(block.points.xyz[seen & np.isfinite(block.points.xyz).all(axis=1)])[:, :2]
        low, high = np.quantile(at, [BEYOND, 1 - BEYOND], axis=0)
        extent = np.concatenate([low - MARGIN * (high - low), high + MARGIN * (high - low)])
        grid = grid_over(extent, max(usual_pixel(block, plane), float(max(extent[2:] - extent[:2])) / SHOWN_PX))
        return cls(block=block, plane=plane, grid=grid, dates=tuple(sorted(set(block.images.date or ()))))

    def cells(self, xyz: Array) -> Array:
        """(n, 2) columns and rows of points (n, 3), in the unit of the block."""
        return self.grid.cells(self.plane.coordinates(xyz)[:, :2])

    def directions(self, vectors: Array) -> Array:
        """(..., 3) vectors to the right, upwards, and towards the viewer."""
        return vectors @ self.plane.axes.T

    def rectified(self, date: str, folders: Sequence[Path], progress: Progress = silent) -> Array:
        """Colours (rows, columns, 3) of the photographs of a date; what lies off the plane is displaced.

        raises  InputError where no photograph of the date shows the plane
        """
        i, g = self.block.images, self.grid
        only = [name for name, d in zip(i.ids, i.date or (), strict=True) if d == date]
        parts = FINER if g.pixel >= FINER * usual_pixel(self.block, self.plane) else 1
        fine = replace(g, pixel=g.pixel / parts, width=parts * g.width, height=parts * g.height)
        picture, _ = rectify_block(
            self.block, folders, self.plane, fine, only=only, tolerated=float("inf"), progress=progress
        )  # fmt: skip
        colours = np.where(picture.seen[..., None], picture.colours, NO_COLOUR).astype(np.uint8)
        return np.asarray(cv2.resize(colours, (g.width, g.height), interpolation=cv2.INTER_AREA))
