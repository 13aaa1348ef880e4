"""A part of the object: which pixels of a reference may show it, and the steps of a depth map that heed them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import cv2
import numpy as np

from raybundle.numerics.arrays import Array, Mask
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.refine import PixelGrid
from raybundle.surfaces.depths.sweep import Start, swept
from raybundle.surfaces.depths.transfer import Transfer

STEP_PX = 8
"""Pixels from one to the next that are asked; a part is shown larger than that, or not worth a depth."""
MARGIN_PX = 32
"""Pixels around a part that are measured with it: the test against neighbours, local variances and the variogram look
16 px far, and so do the neighbours that speak for those."""


class Region(Protocol):
    """A part of the object."""

    def holds(self, xyz: Array) -> Mask:
        """Which points (n, 3) lie in it."""
        ...

    def meets(self, one: Array, other: Array) -> Mask:
        """Which straight lines (n,) between points (n, 3) pass it."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Shown:
    """Where a reference may show a part."""

    may: Mask
    """(h, w) pixels whose rays pass it between the smallest and the largest depth, and a margin"""
    box: tuple[int, int, int, int]
    """left, top, right and bottom of these"""

    @property
    def share(self) -> float:
        """Of the reference's pixels."""
        return float(self.may.mean())

    def box_of(self, unit: int) -> tuple[int, int, int, int]:
        """The box made larger to whole multiples of a number of pixels, as far as the reference reaches."""
        left, top, right, bottom = self.box
        height, width = self.may.shape
        return (
            left // unit * unit, top // unit * unit,
            min(-(-right // unit) * unit, width // unit * unit), min(-(-bottom // unit) * unit, height // unit * unit),
        )  # fmt: skip

    def box_around(self, margin: int) -> tuple[float, float, float, float]:
        """The box and so many pixels around it, as far as the reference reaches."""
        left, top, right, bottom = self.box
        height, width = self.may.shape
        return (
            float(max(left - margin, 0)), float(max(top - margin, 0)), float(min(right + margin, width)),
            float(min(bottom + margin, height)),
        )  # fmt: skip


def shown_part(rays: ReferenceRays, t_range: tuple[float, float], region: Region) -> Shown | None:
    """The pixels of a reference that may show a region; None: none does.

    t_range  smallest and largest depth parameter

    Limits: whether something else hides it.
    """
    width, height = rays.camera.width_px, rays.camera.height_px
    u, v = (np.append(np.arange(STEP_PX / 2, n, STEP_PX), n - 0.5) for n in (width, height))
    xy = np.stack(np.meshgrid(u, v), axis=-1).reshape(-1, 2)
    far, near = (rays.points(xy, np.full(len(xy), t)) for t in t_range)
    nodes = region.meets(far, near).reshape(len(v), len(u))
    if not nodes.any():
        return None
    nodes[:, -2] |= nodes[:, -1]  # the rim belongs to the last cell
    nodes[-2] |= nodes[-1]
    row, column = (
        np.minimum(np.arange(n) // STEP_PX, k - 1) for n, k in zip((height, width), nodes.shape, strict=True)
    )
    may = with_margin(nodes[row][:, column], MARGIN_PX)
    rows, columns = (np.flatnonzero(may.any(axis=axis)) for axis in (1, 0))
    return Shown(may=may, box=(int(columns[0]), int(rows[0]), int(columns[-1]) + 1, int(rows[-1]) + 1))


def with_margin(mask: Mask, margin: int) -> Mask:
    """(h, w) what is chosen, and so many pixels around."""
    side = 2 * margin + 1
    return cv2.dilate(mask.astype(np.uint8), np.ones((side, side), np.uint8)) > 0


def part_of_grid(whole: PixelGrid, shown: Shown, unit: int) -> PixelGrid:
    """Those pixels of a grid that may show a part; it begins at a multiple of so many pixels, so that grids agree."""
    left, top, right, bottom = shown.box
    x0, y0 = (first + max(0, begin - first) // unit * unit for first, begin in ((whole.x0, left), (whole.y0, top)))
    columns = min(whole.columns - (x0 - whole.x0) // whole.stride, -(-(right - x0) // whole.stride))
    rows = min(whole.rows - (y0 - whole.y0) // whole.stride, -(-(bottom - y0) // whole.stride))
    return PixelGrid(x0=x0, y0=y0, stride=whole.stride, rows=max(rows, 0), columns=max(columns, 0))


def swept_part(
    reference: Array, sources: Sequence[Array], tables: Sequence[Transfer], shown: Shown, *, scale: int,
    free: Sequence[Mask | None], memory: float = np.inf,
) -> Start:  # fmt: skip
    """Approximate depths where a part may be shown, as `sweep.swept` finds them; NaN elsewhere."""
    height, width = reference.shape
    left, top, right, bottom = shown.box_of(scale)
    # tables count from the corner of what they are asked for
    moved = [replace(t, u0_px=t.u0_px - left, v0_px=t.v0_px - top) for t in tables]
    part = swept(reference[top:bottom, left:right], sources, moved, scale=scale, memory=memory, free=free)
    t = np.full((height // scale, width // scale), np.nan, np.float32)
    t[top // scale : bottom // scale, left // scale : right // scale] = part.t
    return replace(part, t=t)


def wanted_pixels(rays: ReferenceRays, start: Start, shown: Shown, region: Region) -> Mask:
    """(h, w) pixels whose approximate depths lie in a region, or that have none and may show it; and a margin."""
    rows, columns = shown.may.shape
    h, w = start.t.shape
    v, u = (np.mgrid[:h, :w] + 0.5) * start.scale
    wanted = shown.may[v.astype(int), u.astype(int)]
    known = np.flatnonzero(wanted & np.isfinite(start.t))
    xy, t = np.stack([u.flat[known], v.flat[known]], axis=1), start.t.flat[known].astype(float)
    wanted.flat[known] = region.holds(rays.points(xy, t))
    around = with_margin(wanted, -(-MARGIN_PX // start.scale))
    at_row, at_column = (np.minimum(np.arange(n) // start.scale, k - 1) for n, k in ((rows, h), (columns, w)))
    return around[at_row][:, at_column]
