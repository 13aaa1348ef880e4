"""The uncertainty of a projection as a function of the pixel."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from raybundle.adjustment.result import Adjustment, interior_of
from raybundle.calibration.maps import shifts_at
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array


def projection_uncertainty(
    result: Adjustment, pixels: ArrayLike, *, camera: str | None = None, image: str | None = None,
    distance: float | None = None,
) -> Array:  # fmt: skip
    """Covariances (n, 2, 2) [px^2] of the images of fixed rays, by the errors of a calibration.

    pixels    (n, 2) x, y [px], from the outer corner of the first pixel
    camera    its id; None: the only one; image: where each image has an interior orientation of its own
    distance  of the object along each ray, in units of the block; None: infinitely far
    raises    InputError for pixels that are no pairs, an unknown camera, and without statistics

    The rotation (and for objects at a distance the translation) that fits the motion over the whole format best is
    taken out: whoever uses the calibration determines it anew.  NaN where the model sees nothing.

    Limits: errors of a model that does not fit the lens.
    """
    found, free, covariance = interior_of(result, camera, image)
    if covariance is None:
        raise InputError("adjustment.no_statistics")
    at = np.asarray(pixels, float)
    if at.ndim != 2 or at.shape[1] != 2:
        raise InputError("pixels.shape", shape=[*at.shape])
    if distance is not None and not distance > 0:
        raise InputError("pixels.distance", distance=float(distance))
    if not free:
        return np.zeros((len(at), 2, 2))
    by = shifts_at(found, free, at, distance=distance)
    return by @ covariance @ np.swapaxes(by, -1, -2)
