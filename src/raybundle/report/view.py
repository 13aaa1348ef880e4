"""An adjustment as the report looks at it: what several sections need, computed once."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.blunders.accuracy import Accuracy
from raybundle.adjustment.evaluation.check_points import check_differences, used_rays
from raybundle.adjustment.records.figures import InteriorResult
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.errors import phrase
from raybundle.metrology.lengths import LengthTest
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.report.figures.distortion import Interior, interior_of
from raybundle.report.text.numbers import significant

FREE_UNIT = "units"
"""Unit of lengths in print where nothing fixes the scale: neither metres nor millimetres."""

AWAY = 1.0
"""Distance from its ground at which a scene is drawn, in extents of the block."""


def in_unit(value: float, unit: str, digits: int = 3) -> str:
    """A length with its unit, of so many significant digits."""
    if unit != FREE_UNIT or not math.isfinite(value):
        return f"{significant(value, digits)} {unit}".strip()
    return phrase("label.in_free_units", value=float(f"{value:.{digits}g}"))


@dataclass(frozen=True, slots=True, kw_only=True)
class View:
    """An adjustment with the quantities derived from it."""

    adjustment: Adjustment
    used: Mask
    """(m,) image observations that took part"""
    rejected: Index
    """(k,) rows that did not"""
    scale: float
    """Root of the variance factor: sigma0 a posteriori; 1 where there is none, and with factors of groups"""
    factor: float
    """From the block's length unit to that of standard deviations in print"""
    unit: str
    """Unit of standard deviations in object space"""
    length_unit: str
    """Unit of coordinates"""
    std: Array | None
    """(p, 3) standard deviations of object points [unit]; NaN where held or unused"""
    rays: Array
    """(p,) used image observations"""
    check_rows: Index
    check_difference: Array
    """(k, 3) adjusted minus given [length unit]"""
    accuracy: Accuracy
    """At check points and of control left out, along the axes of the client"""
    lengths: LengthTest | None = None
    """Known lengths that took no part in the adjustment; None: there are none"""

    @property
    def compared(self) -> bool:
        """Whether anything independent was compared: check points, or lengths that took no part."""
        return self.lengths is not None or bool(np.isfinite(self.check_difference).any())

    @property
    def given(self) -> Block:
        """The block as given."""
        return self.adjustment.given

    @property
    def adjusted(self) -> Block:
        """The adjusted block."""
        return self.adjustment.adjusted

    @property
    def arbitrary_scale(self) -> bool:
        """Whether nothing fixes the scale of object space."""
        return self.adjustment.free_scale

    @property
    def free_frame(self) -> bool:
        """Whether any part of the datum was left open by the observations."""
        return bool(self.adjustment.datum_defect)

    def cameras(self) -> list[tuple[int, Mask]]:
        """Each camera with used observations, and these (m,)."""
        of = self.given.images.camera[self.given.observations.image]
        found = [(c, self.used & (of == c)) for c in range(len(self.given.cameras))]
        return [(c, mask) for c, mask in found if mask.any()]


def view_of(adjustment: Adjustment, accuracy: Accuracy | None = None, lengths: LengthTest | None = None) -> View:
    """The view of an adjustment.

    accuracy  of it along the axes of the client; None: along those of object space
    lengths   that took no part
    """
    used = adjustment.image_observations.used
    std = _object_point_std(adjustment)
    factor, unit = printed_lengths(adjustment)
    rows, difference = check_differences(adjustment)
    return View(
        adjustment=adjustment,
        used=used,
        rejected=np.flatnonzero(~used).astype(np.int32),
        scale=math.sqrt(adjustment.variance_factor) or 1.0,
        factor=factor,
        unit=unit,
        length_unit=length_unit(adjustment),
        std=None if std is None else std * factor,
        rays=used_rays(adjustment),
        check_rows=rows,
        check_difference=difference,
        accuracy=accuracy or Accuracy(adjustment),
        lengths=lengths,
    )


def printed_lengths(adjustment: Adjustment) -> tuple[float, str]:
    """Factor from the block's length unit to that of small lengths in print, and its name."""
    unit = length_unit(adjustment)
    std = _object_point_std(adjustment)
    sizes = np.zeros(0) if std is None else std[np.isfinite(std)]
    if unit == "m" and (not len(sizes) or float(np.median(sizes)) < 1):
        return 1000.0, "mm"
    return 1.0, unit


def length_unit(adjustment: Adjustment) -> str:
    """Unit of coordinates: the block's, or none where nothing fixes the scale."""
    return adjustment.length_unit or FREE_UNIT


def _object_point_std(adjustment: Adjustment) -> Array | None:
    """(p, 3) [length unit]; NaN where held or unused."""
    if adjustment.precision is None:
        return None
    full = adjustment.precision.object_point_std
    return np.where(full > 0, full, np.nan)


def key_of(result: InteriorResult) -> str:
    """Key of an interior orientation in `Precision.interior`."""
    return result.camera if result.image is None else f"{result.camera}/{result.image}"


def name_of(result: InteriorResult) -> str:
    """An interior orientation in words."""
    return f"camera {result.camera}" + ("" if result.image is None else f", image {result.image}")


def adjusted_interior(view: View, result: InteriorResult) -> Interior:
    """An interior orientation with its covariance, for curves."""
    a = view.adjustment
    camera = next(c for c in a.adjusted.cameras if c.id == result.camera)
    covariance = None if a.precision is None else a.precision.interior.get(key_of(result))
    free = () if a.precision is None else a.precision.parameters.get(key_of(result), ())
    # what is shared, or each image's own, stands elsewhere
    values = {**camera.values, **{s: p.value for s, p in result.parameters.items()}}
    return interior_of(camera, (values.get(s, 0.0) for s in camera.sensor.symbols), free, covariance)


def rms(values: Array) -> float:
    """Root mean square of the finite values; NaN if there are none."""
    good = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(good**2))) if len(good) else math.nan


def rows_of(view: View, image: int) -> Index:
    """Rows of the image points of an image that took part."""
    return np.flatnonzero(view.used & (view.given.observations.image == image)).astype(np.int32)


def with_near_viewpoints(view: View) -> View:
    """The view with scenes drawn near their ground: at their true height maps and networks would show nothing else."""
    block = view.adjusted
    scenes = [i for i, c in enumerate(block.images.camera) if block.cameras[int(c)].is_scene]
    known = np.isfinite(block.points.xyz).all(axis=1) & (view.rays > 0)
    if not scenes or not known.any():
        return view
    xyz = block.points.xyz[known]
    extent = float(np.max(np.ptp(np.percentile(xyz[:, :2], [2, 98], axis=0), axis=0)))
    centre = block.images.centre.copy()
    for i in scenes:
        seen = rows_of(view, i)
        own = block.points.xyz[view.given.observations.point[seen]] if len(seen) else xyz
        centre[i] = np.nanmedian(own, axis=0) + AWAY * extent * block.images.rotation[i, 2]
    adjusted = replace(block, images=replace(block.images, centre=centre))
    return replace(view, adjustment=replace(view.adjustment, adjusted=adjusted))
