"""What figures of an interior orientation rest on: whether there are any, how far it is seen, what its errors do."""

from __future__ import annotations

import math

import numpy as np

from raybundle.adjustment.records.figures import InteriorResult
from raybundle.calibration.maps import UncertaintyMap, projection_uncertainty
from raybundle.report.figures.distortion import Interior
from raybundle.report.view import View


def drawable(view: View, result: InteriorResult) -> bool:
    """Whether it has figures of its own: it is no instrument's, and not that of a scene, which has no distortion.

    Where single images have some of the parameters, no figure stands for all of them.
    """
    camera = next((c for c in view.given.cameras if c.id == result.camera), None)  # none: an instrument
    return camera is not None and not camera.is_scene and len(result.parameters) >= len(camera.sensor.symbols)


def reach_of(view: View, result: InteriorResult, interior: Interior) -> float:
    """Largest distance of a used image point from the principal point [mm]."""
    o = view.given.observations
    camera = next(k for k, c in enumerate(view.given.cameras) if c.id == result.camera)
    mine = view.used & (view.given.images.camera[o.image] == camera)
    if result.image is not None:
        mine &= o.image == view.given.images.ids.index(result.image)
    if not mine.any():
        return math.nan
    offset = interior.camera.image_from_pixel(o.xy_px[mine]) - interior.principal_point
    return float(np.linalg.norm(offset, axis=1).max())


def uncertainty_maps(view: View, result: InteriorResult) -> tuple[UncertaintyMap, ...]:
    """Uncertainty of projection at infinity and at the typical distance of the objects; () where nothing shows it."""
    precision = view.adjustment.precision
    C = None if precision is None else precision.interior.get(result.camera)
    if C is None or result.image is not None or not len(result.free) or not np.isfinite(C).all():
        return ()
    camera = next(c for c in view.adjusted.cameras if c.id == result.camera)
    found = [
        projection_uncertainty(camera, result.free, C, distance=distance)
        for distance in (None, _typical_distance(view))
        if distance is None or distance > 0
    ]
    return tuple(m for m in found if math.isfinite(m.largest))


def _typical_distance(view: View) -> float:
    """Median distance between projection centres and the points they see."""
    o = view.given.observations
    apart = view.adjusted.points.xyz[o.point[view.used]] - view.adjusted.images.centre[o.image[view.used]]
    length = np.linalg.norm(apart, axis=1)
    return float(np.median(length[np.isfinite(length)])) if np.isfinite(length).any() else math.nan
