"""Marks that are centres of round targets: what is measured is the centre of an ellipse, not the image of the centre.

Radii stand in the control file, normals there or in the neighbours: targets on a wall or a floor lie in a plane.  The
offset depends on the orientation to second order only, so that it is taken off once, in the block as it was placed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.block import Block
from raybundle.calibration.eccentricity import eccentricity_px, target_normals
from raybundle.io.geo.control_files import ControlFile
from raybundle.numerics.arrays import Array
from raybundle.placing.marks import Placing


def take_eccentricity_off(state: Placing, control: Sequence[ControlFile]) -> None:
    """Move measured centres of round targets to the images of their centres; the block stands in metres.

    Targets whose normal nothing shows stay as measured, and are reported.
    """
    block = state.block
    radius, stated = _as_given(block, control)
    seen = _as_seen(block, control)
    radius = np.where(np.isfinite(radius), radius, seen)
    o = block.observations
    rows = np.flatnonzero((radius[o.point] > 0) & block.images.oriented[o.image])
    if not len(rows):
        return
    round_ = np.flatnonzero(radius > 0)
    normal = np.full(block.points.xyz.shape, np.nan)
    normal[round_] = target_normals(block.points.xyz[round_])
    given = np.isfinite(stated).all(axis=1)
    normal[given] = stated[given]
    unknown = [block.points.ids[k] for k in round_ if not np.isfinite(normal[k]).all()]
    placed = np.isfinite(block.points.xyz).all(axis=1)
    shift = eccentricity_px(block, np.where(placed, radius, 0.0), normal)
    state.block = replace(block, observations=replace(o, xy_px=o.xy_px - shift))
    largest = float(np.linalg.norm(shift[rows], axis=1).max())
    done = len(round_) - len(unknown)
    if done:
        state.notify("target_eccentricity", n=done, largest_px=largest)
    if unknown:
        state.notify("target_without_normal", *unknown, n=len(unknown))


def _as_seen(block: Block, control: Sequence[ControlFile]) -> Array:
    """Radii (p,) of targets from the sizes of their images: r_px Z / c, of a target that turns a diameter to the view.

    NaN without a place or a size.  An ellipse's mean radius is r sqrt(cos t) c / Z at the angle t of its normal to the
    ray; the largest of a target's images comes near r c / Z.
    """
    index = {name: k for k, name in enumerate(block.points.ids)}
    image = {name: k for k, name in enumerate(block.images.ids)}
    radius = np.full(len(index), np.nan)
    for file in control:
        m = file.measurements
        for name, k, size in zip(m.image, m.point, m.radii_px, strict=True):
            i, p = image.get(name), index.get(file.ids[int(k)])
            if i is None or p is None or not np.isfinite(size) or not block.images.oriented[i]:
                continue
            camera = block.cameras[int(block.images.camera[i])]
            symbol = camera.sensor.scale_symbol
            if not symbol or not np.isfinite(block.points.xyz[p]).all():
                continue
            depth = abs(float((block.images.rotation[i] @ (block.points.xyz[p] - block.images.centre[i]))[2]))
            r = float(size) * depth * float(np.mean(camera.pixel_mm)) / camera.values[symbol]
            radius[p] = np.fmax(radius[p], r)
    return radius


def _as_given(block: Block, control: Sequence[ControlFile]) -> tuple[Array, Array]:
    """Radii (p,) and normals (p, 3) of the points of a block; NaN where nothing is stated."""
    index = {name: k for k, name in enumerate(block.points.ids)}
    radius, normal = np.full(len(index), np.nan), np.full((len(index), 3), np.nan)
    for file in control:
        for k, name in enumerate(file.ids):
            if name in index and file.radius is not None:
                radius[index[name]] = file.radius[k]
            if name in index and file.normal is not None:
                normal[index[name]] = file.normal[k]
    return radius, normal
