"""What a calibration is worth in the image: uncertainty of projection, and the difference of two calibrations.

Interior orientation is never used alone.  A shift of the principal point looks like a rotation of the camera, and
whoever uses the calibration estimates that rotation anew.  Both maps are therefore given after the rotation (and for
objects at a distance the translation) that a user's exterior orientation takes up.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.predict import projected
from raybundle.block import Camera
from raybundle.cameras.fixed_rays import derivatives, in_pixels
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.rotation import cross_matrix, rotation_from_vector, vector_from_rotation
from raybundle.sensors import sensor_models

STEPS = 8
COLUMNS, ROWS = 60, 40
"""Places over a format"""
DRAWS = 1000
"""Draws behind the distribution of the largest error: its 99th percentile is good to some 5 %."""


@dataclass(frozen=True, slots=True, kw_only=True)
class UncertaintyMap:
    """Standard deviation of projection over the format."""

    xy_px: Array
    """(rows, columns, 2) image points"""
    covariance: Array
    """(rows, columns, 2, 2) [px^2]; NaN outside the field of the model"""
    distance: float | None
    """Object distance in length units of the block; None: infinity"""

    @property
    def std(self) -> Array:
        """(rows, columns) root of the mean variance of the two coordinates [px]."""
        return np.sqrt(np.trace(self.covariance, axis1=2, axis2=3) / 2)

    @property
    def largest(self) -> float:
        """Largest standard deviation of the map [px]."""
        return float(np.nanmax(self.std))


def projection_uncertainty(
    camera: Camera,
    free: tuple[str, ...],
    covariance: Array,
    *,
    distance: float | None = None,
    columns: int = COLUMNS,
    rows: int = ROWS,
) -> UncertaintyMap:
    """Covariance of the image of a fixed ray by the errors of an interior orientation.

    camera      with the adjusted values
    free        symbols of the estimated parameters, in the order of `covariance` (u, u)
    distance    of the object along each ray; None: infinitely far.  Nearer, the user's exterior orientation takes up
                a translation too
    Limits: errors of a model that does not fit the lens.
    """
    return projection_shifts(camera, free, distance=distance, columns=columns, rows=rows).uncertainty(covariance)


@dataclass(frozen=True, slots=True, kw_only=True)
class ProjectionShifts:
    """How the images of fixed rays move by errors of an interior orientation, the best rotation taken out."""

    xy_px: Array
    """(rows, columns, 2) image points"""
    by_parameter: Array
    """(rows, columns, 2, u) motion [px] per unit of each parameter; NaN where the model sees nothing"""
    distance: float | None
    """Object distance in length units of the block; None: infinity"""

    def uncertainty(self, covariance: Array) -> UncertaintyMap:
        """What a covariance (u, u) of the parameters makes of it."""
        C = self.by_parameter @ np.asarray(covariance) @ np.swapaxes(self.by_parameter, -1, -2)
        return UncertaintyMap(xy_px=self.xy_px, covariance=C, distance=self.distance)

    def worst_errors(self, covariance: Array, draws: int = DRAWS, *, within_px: float = np.inf) -> Array:
        """Largest errors (draws,) of projection over the format [px], sorted, if parameters scatter so.

        Lengths of the shift after the best rotation, as `calibration_difference` has them between estimate and truth.
        Where one parameter dominates, the largest error is the absolute value of a normal deviate; where many do, it is
        a maximum of many: no fixed multiple of a standard deviation serves both, hence the draws, the same each time.

        within_px  distance from the middle of the format up to which they count
        """
        C = np.asarray(covariance)
        value, axes = np.linalg.eigh(C)
        half = axes * np.sqrt(np.maximum(value, 0))
        p = np.random.default_rng(1).standard_normal((draws, len(C))) @ half.T
        middle = (self.xy_px[0, 0] + self.xy_px[-1, -1]) / 2
        by = self.by_parameter[np.linalg.norm(self.xy_px - middle, axis=2) <= within_px]
        by = by[np.isfinite(by).all(axis=(1, 2))]
        x, y = (by[:, k] @ p.T for k in (0, 1))
        return np.sort(np.sqrt((x * x + y * y).max(axis=0, initial=0.0)))


def projection_shifts(
    camera: Camera, free: tuple[str, ...], *, distance: float | None = None, columns: int = COLUMNS, rows: int = ROWS
) -> ProjectionShifts:
    """The motions behind `projection_uncertainty`, see there; they serve for any number of covariances.

    The image of a ray moves by -B^-1 (dg/dp dp); the rotation that fits this field best over the whole format is taken
    out.
    """
    xy, image = _grid(camera, columns, rows)
    by = _without_motion(camera, free, image, image, distance)
    return ProjectionShifts(xy_px=xy, by_parameter=by.reshape(rows, columns, 2, len(free)), distance=distance)


def shifts_at(camera: Camera, free: tuple[str, ...], pixels: Array, *, distance: float | None = None) -> Array:
    """Motions (n, 2, u) [px] of fixed rays per unit of each parameter at pixels (n, 2), as in `projection_shifts`.

    The rotation that is taken out is that of the whole format, whatever the pixels.
    """
    _, format_ = _grid(camera, COLUMNS, ROWS)
    return _without_motion(camera, free, camera.image_from_pixel(pixels).T, format_, distance)


def _without_motion(
    camera: Camera, free: tuple[str, ...], image: Array, format_: Array, distance: float | None
) -> Array:
    """Shifts (n, 2, u) of image points (2, n) by the parameters, less the motion of the camera that fits `format_`."""
    shift, motion = _moved(camera, free, format_, distance)
    seen: Mask = np.asarray(np.isfinite(shift).all(axis=(1, 2)))
    taken_up = np.linalg.lstsq(
        motion[seen].reshape(-1, motion.shape[2]), shift[seen].reshape(-1, len(free)), rcond=None
    )[0]
    if image is not format_:
        shift, motion = _moved(camera, free, image, distance)
    return shift - motion @ taken_up


def _moved(camera: Camera, free: tuple[str, ...], image: Array, distance: float | None) -> tuple[Array, Array]:
    """By the parameters (n, 2, u) and by a small motion of the camera (n, 2, k) [px]; NaN where nothing is seen."""
    points = camera.sensor.ray(image, camera.parameters) * (distance or 1.0)
    B, by_point, by_parameter = derivatives(camera, image, points)
    seen = np.flatnonzero(np.isfinite(B).all(axis=(1, 2)) & np.isfinite(points).all(axis=0))
    position = [camera.sensor.symbols.index(s) for s in free]
    by = np.concatenate([by_parameter[seen][:, :, position], by_point[seen] @ _motions(points[:, seen].T, distance)], 2)
    found = np.full((image.shape[1], 2, by.shape[2]), np.nan)
    found[seen] = in_pixels(camera, B[seen], by)
    return found[:, :, : len(free)], found[:, :, len(free) :]


def uncertainty_of(result: Adjustment, camera: str, *, distance: float | None = None) -> UncertaintyMap:
    """The uncertainty map of a camera of an adjustment; raises InputError where it has no estimated parameters."""
    interior = next((i for i in result.interior if i.camera == camera and i.image is None), None)
    if interior is None or result.precision is None or not interior.free:
        raise InputError("calibration.not_estimated", camera=camera)
    adjusted = next(c for c in result.adjusted.cameras if c.id == camera)
    return projection_uncertainty(adjusted, interior.free, result.precision.interior[camera], distance=distance)


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationDifference:
    """How far two calibrations of one camera place the image of the same ray apart."""

    xy_px: Array
    """(rows, columns, 2) image points of the first"""
    shift_px: Array
    """(rows, columns, 2) second minus first after the best rotation; NaN where one of them sees nothing"""
    rotation: Array
    """(3,) rotation vector that was taken out [rad]"""
    translation: Array
    """(3,) in length units; zero at infinity"""

    @property
    def rms(self) -> float:
        """Root mean square length of the shift [px]."""
        return float(np.sqrt(np.nanmean(np.sum(self.shift_px**2, axis=2))))

    @property
    def largest(self) -> float:
        """Largest length of the shift [px]."""
        return float(np.sqrt(np.nanmax(np.sum(self.shift_px**2, axis=2))))


def calibration_difference(
    first: Camera, second: Camera, *, distance: float | None = None, columns: int = COLUMNS, rows: int = ROWS
) -> CalibrationDifference:
    """Compare two calibrations, of any two models, in pixels of the first over its format.

    raises  InputError where the formats differ
    """
    if (first.width_px, first.height_px) != (second.width_px, second.height_px):
        raise InputError(
            "calibration.formats_differ",
            first_px=[first.width_px, first.height_px],
            second_px=[second.width_px, second.height_px],
        )
    xy, image = _grid(first, columns, rows)
    points = (sensor_models[first.model].ray(image, first.parameters) * (distance or 1.0)).T
    values = second.parameters
    turn, moved = np.eye(3), np.zeros(3)
    there = second.image_from_pixel(xy.reshape(-1, 2)).T
    shift = np.full((len(points), 2), np.nan)
    for _ in range(STEPS):
        P = points @ turn.T + moved
        there, seen = projected(second, P.T, values, there)
        shift = np.where(seen[:, None], second.pixel_from_image(there.T) - xy.reshape(-1, 2), np.nan)
        if seen.sum() < 6:
            break
        B, by_point, _ = derivatives(second, there[:, seen], P[seen].T)
        motion = in_pixels(second, B, by_point @ _motions(P[seen], distance))
        step, *_ = np.linalg.lstsq(motion.reshape(-1, motion.shape[2]), -shift[seen].ravel(), rcond=None)
        small = rotation_from_vector(step[:3])
        turn, moved = small @ turn, small @ moved
        if distance is not None:
            moved = moved + step[3:]
        if np.abs(step).max() < 1e-12 * max(distance or 1.0, 1.0):
            break
    return CalibrationDifference(
        xy_px=xy, shift_px=shift.reshape(rows, columns, 2), rotation=vector_from_rotation(turn), translation=moved
    )


def _grid(camera: Camera, columns: int, rows: int) -> tuple[Array, Array]:
    """Image points (rows, columns, 2) [px] in the middles of equal cells, and (2, n) in the image frame."""
    x = (np.arange(columns) + 0.5) / columns * camera.width_px
    y = (np.arange(rows) + 0.5) / rows * camera.height_px
    xy = np.stack(np.meshgrid(x, y), axis=2)
    return xy, camera.image_from_pixel(xy.reshape(-1, 2)).T


def _motions(points: Array, distance: float | None) -> Array:
    """(n, 3, 3) how points (n, 3) move by a small rotation; (n, 3, 6) where a translation moves them too."""
    turn = -cross_matrix(points)
    if distance is None:
        return turn
    return np.concatenate([turn, np.broadcast_to(np.eye(3), turn.shape)], axis=2)


def scaled(camera: Camera, width_px: int, height_px: int) -> Camera:
    """The same calibration for photographs reduced or enlarged as a whole; raises InputError for another shape."""
    if abs(width_px * camera.height_px - height_px * camera.width_px) > max(camera.width_px, camera.height_px):
        raise InputError(
            "calibration.cropped_format",
            width_px=width_px,
            height_px=height_px,
            camera_width_px=camera.width_px,
            camera_height_px=camera.height_px,
        )
    factor = camera.width_px / width_px
    pixel = (camera.pixel_mm[0] * factor, camera.pixel_mm[1] * camera.height_px / height_px)
    return replace(camera, width_px=width_px, height_px=height_px, pixel_mm=pixel)
