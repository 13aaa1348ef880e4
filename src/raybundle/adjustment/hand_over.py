"""Calibrated cameras of an adjustment in the words of other programs, with their covariance."""

from __future__ import annotations

from dataclasses import replace

from raybundle.adjustment.result import Adjustment
from raybundle.block import Camera
from raybundle.cameras.opencv import OpenCVCamera, opencv_camera
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array


def interior_of(
    result: Adjustment, camera: str | None, image: str | None
) -> tuple[Camera, tuple[str, ...], Array | None]:
    """A camera with its adjusted values, the symbols that were estimated, and their covariance (u, u).

    camera  its id; None: the only one; image: where each image has an interior orientation of its own
    None in place of the covariance: without statistics.
    raises  InputError for an unknown camera or image, and where one of several has to be named
    """
    cameras = [c for c in result.adjusted.cameras if not c.is_scene]
    if camera is None:
        if len(cameras) != 1:
            raise InputError("camera.several", n=len(cameras), cameras=[c.id for c in cameras])
        camera = cameras[0].id
    found = next((c for c in cameras if c.id == camera), None)
    if found is None:
        raise InputError("camera.unknown", camera=camera, known=[c.id for c in cameras])
    own = [i for i in result.interior if i.camera == camera]
    interior = next((i for i in own if i.image == image), None)
    if interior is None:
        if image is None and own:
            raise InputError("camera.interior_per_image", camera=camera)
        if image is not None:
            raise InputError("camera.no_interior_of_image", camera=camera, image=image)
        return found, (), None if result.precision is None else _nothing()
    found = replace(found, values={**found.values, **{s: p.value for s, p in interior.parameters.items()}})
    if result.precision is None:
        return found, (), None
    key = camera if image is None else f"{camera}/{image}"
    return found, interior.free, result.precision.interior.get(key, _nothing())


def _nothing() -> Array:
    import numpy as np  # noqa: PLC0415

    return np.zeros((0, 0))


def opencv_of(result: Adjustment, camera: str | None, image: str | None, coefficients: int | None) -> OpenCVCamera:
    """`Adjustment.opencv`."""
    found, free, covariance = interior_of(result, camera, image)
    return opencv_camera(found, free, covariance, coefficients=coefficients)
