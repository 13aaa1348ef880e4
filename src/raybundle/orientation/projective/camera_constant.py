"""Camera constants that are not given (0): from control, from pairs of images, else a guess from the format."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Block, Camera
from raybundle.block.stored import is_observed_jointly
from raybundle.errors import NoOrientation
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.rows import rows_of_each
from raybundle.orientation.projective.dlt import dlt
from raybundle.orientation.projective.model import SelfCalibration, self_calibration
from raybundle.orientation.rays import common_rows, image_pairs
from raybundle.sensors import sensor_models
from raybundle.sensors.model import SensorModel

PAIRS = 20
"""Pairs of images of one camera that are asked."""
COMMON = 20
"""Common points that such a pair needs."""
MANY = 400
"""Common points of a pair of which each second, third ... is left out."""
FLAT = 0.85
"""Share of the points in one plane beyond which a pair states nothing."""
NARROW, WIDE = 0.3, 12.0
"""Camera constants in widths of the format that are believed."""
LEAST_PAIRS = 5
"""Pairs from which on their median is believed against a camera constant that is free."""
PROJECTIVE = 40
"""Images up to which a projective model is tried."""
ROUGH_PX = 2.0
"""Standard deviation of image points there: distortion is in it."""
CROOKED = 0.1
"""Misfit of a self-calibration from which it is not believed."""
FORMAT = "format"
POOR = 0.02
"""Residuals of a DLT in widths of the format beyond which it is not believed."""


def with_camera_constants(block: Block) -> tuple[Block, tuple[Notice, ...]]:
    """The block with a camera constant for each camera that has none, and what was done.

    Tried in turn: the direct linear transformation of images with six control points that are not in a plane;
    the homography of images of a control plane (Zhang 2000); pairs of images by the relative orientation with
    unknown camera constant (Stewénius et al. 2005); a projective model of all images (`self_calibration`), where each
    has a camera of its own; the larger side of the format.
    raises  NoOrientation for a sensor other than a frame camera: there the camera constant must be given
    """
    notices: list[Notice] = []
    cameras = list(block.cameras)
    projective: SelfCalibration | None = None
    asked = False
    for k, camera in enumerate(block.cameras):
        model = camera.sensor
        symbol = model.symbols[0]
        images = np.asarray(block.images.camera) == k
        if camera.values.get(symbol, 0.0) != 0 or not images[block.observations.image].any():
            continue
        if type(model).start is not SensorModel.start:
            raise NoOrientation("camera.constant_missing", camera=camera.id, parameter=symbol, model=camera.model)
        value, source, count = _found(block, camera, images)
        if source == FORMAT:
            projective = projective if asked else _projective(block)
            asked = True
            found = 0.0 if projective is None else projective.block.cameras[k].values[symbol]
            if NARROW * value < found < WIDE * value:
                value, source, count = found, "projective", len(block.images)
        cameras[k] = replace(camera, values={**camera.values, symbol: value})
        notices.append(
            Notice(
                code="camera_constant",
                values={"camera": camera.id, "c_mm": value, "parameter": symbol, "source": source, "n": count},
                ids=(camera.id,),
            )
        )
    return replace(block, cameras=tuple(cameras)), tuple(notices)


def checked_by_pairs(block: Block) -> Block:
    """The block with the camera constant of pairs of images where a free one contradicts them.

    A start from nothing but the size of the format may be a third off: rotations between images are then off as much.
    Taken where the median of five pairs or more differs by three of its standard deviations.
    """
    cameras = list(block.cameras)
    for k, camera in enumerate(block.cameras):
        model = sensor_models[camera.model]
        symbol = model.symbols[0]
        if type(model).start is not SensorModel.start or symbol not in camera.estimate or is_observed_jointly(camera):
            continue
        size = float(camera.size_mm.max())
        values = np.array(_from_pairs(block, camera, np.asarray(block.images.camera) == k))
        values = values[(values > NARROW * size) & (values < WIDE * size)]
        if len(values) < LEAST_PAIRS:
            continue
        median = float(np.median(values))
        sigma = 1.4826 * float(np.median(np.abs(values - median))) * 1.25 / np.sqrt(len(values))
        if abs(median - camera.values[symbol]) > 3 * sigma:
            cameras[k] = replace(camera, values={**camera.values, symbol: median})
    return replace(block, cameras=tuple(cameras))


def _found(block: Block, camera: Camera, images: Mask) -> tuple[float, str, int]:
    """Camera constant [mm], where it comes from, and of how many values it is the median."""
    size = float(camera.size_mm.max())
    by_dlt, by_plane = _from_control(block, camera, images)
    sources: tuple[tuple[Callable[[], list[float]], str], ...] = (
        (lambda: by_dlt, "dlt"),
        (lambda: by_plane, "plane"),
        (lambda: _from_pairs(block, camera, images), "pairs"),
    )
    for values, source in sources:
        good = [c for c in values() if NARROW * size < c < WIDE * size]
        if good:
            return float(np.median(good)), source, len(good)
    return size, FORMAT, 0


def _projective(block: Block) -> SelfCalibration | None:
    """The self-calibration of the whole block; None where it is too large, or does not succeed."""
    if not 3 <= len(block.images) <= PROJECTIVE:
        return None
    try:
        found = self_calibration(block, sigma_px=ROUGH_PX)
    except NoOrientation:
        return None
    return found if found.misfit < CROOKED else None


def _from_control(block: Block, camera: Camera, images: Mask) -> tuple[list[float], list[float]]:
    """Camera constants by DLT and by the homography of a plane, one of each image that allows it."""
    control: Mask = np.all(block.points.is_control, axis=1)
    o = block.observations
    rows_of = rows_of_each(np.where(control[o.point], o.image, -1), len(block.images))
    by_dlt: list[float] = []
    by_plane: list[float] = []
    for i in np.flatnonzero(images):
        rows = rows_of[i]
        if len(rows) < 4:
            continue
        xy, xyz = camera.image_from_pixel(o.xy_px[rows]), block.points.xyz[o.point[rows]]
        spread = np.linalg.svd(xyz - xyz.mean(axis=0), compute_uv=False)
        if spread[2] < 0.01 * spread[0]:
            c = _of_plane(xy, xyz)
            by_plane += [] if c is None else [c]
            continue
        try:
            found = dlt(xy, xyz)
        except NoOrientation:
            continue
        if not found.sigma0_mm > POOR * float(camera.size_mm.max()):
            by_dlt.append(found.c)
    return by_dlt, by_plane


def _of_plane(xy: Array, xyz: Array) -> float | None:
    """Camera constant by an image (n, 2) [mm] of points (n, 3) in a plane; None where the view is too square.

    The images of the plane's axes are at right angles and of equal length in space: two equations for 1 / c^2
    with the principal point in the middle.
    """
    _, _, axes = np.linalg.svd(xyz - xyz.mean(axis=0))
    plane = (xyz - xyz.mean(axis=0)) @ axes[:2].T
    plane = plane / np.abs(plane).max()
    scale = float(np.abs(xy).max())
    H = _homography(plane, xy / scale)
    a, b = H[:, 0], H[:, 1]
    # (a1 b1 + a2 b2) w + a3 b3 = 0 and (a1^2 + a2^2 - b1^2 - b2^2) w + a3^2 - b3^2 = 0, w = 1 / c^2
    A = np.array([a[:2] @ b[:2], a[:2] @ a[:2] - b[:2] @ b[:2]])
    right = -np.array([a[2] * b[2], a[2] ** 2 - b[2] ** 2])
    tilt = float(np.linalg.norm(right)) / max(float(a[2] ** 2 + b[2] ** 2 + (a[:2] @ a[:2] + b[:2] @ b[:2])), 1e-300)
    w = float(A @ right) / max(float(A @ A), 1e-300)
    return scale / float(np.sqrt(w)) if w > 0 and tilt > 1e-3 else None


def _homography(source: Array, target: Array) -> Array:
    """(3, 3) homography of points (n, 2) onto points (n, 2), linear; both of a size near 1."""
    n = len(source)
    h = np.concatenate([source, np.ones((n, 1))], axis=1)
    A = np.zeros((2 * n, 9))
    A[0::2, :3], A[1::2, 3:6] = h, h
    A[0::2, 6:], A[1::2, 6:] = -target[:, :1] * h, -target[:, 1:] * h
    return np.linalg.svd(A)[2][-1].reshape(3, 3)


def _from_pairs(block: Block, camera: Camera, images: Mask) -> list[float]:
    """Camera constants of pairs of images of this camera, one of each pair that determines it."""
    import poselib

    found: list[float] = []
    error = 0.002 * float(np.hypot(camera.width_px, camera.height_px))
    options: dict[str, Any] = {"max_epipolar_error": error, "max_iterations": 1000, "seed": 1}
    half = np.array([camera.width_px, camera.height_px]) / 2
    o = block.observations
    for a, b, common in image_pairs(o.image, o.point, images, len(block.points), PAIRS):
        rows = common_rows(np.flatnonzero(o.image == a), np.flatnonzero(o.image == b), o.point)
        xa, xb = (np.ascontiguousarray(o.xy_px[r[:: len(r) // MANY + 1]] - half) for r in rows)
        if common < COMMON or np.median(np.linalg.norm(xa - xb, axis=1)) < 0.02 * float(half.max()):
            continue
        _, plane = poselib.estimate_homography(xa, xb, {**options, "max_reproj_error": error}, {})
        if np.mean(plane["inliers"]) > FLAT:
            continue
        pair, info = poselib.estimate_shared_focal_relative_pose(xa, xb, [0.0, 0.0], options, {})
        if np.mean(info["inliers"]) > 0.5 and np.sum(plane["inliers"]) < FLAT * np.sum(info["inliers"]):
            found.append(float(pair.camera1.focal()) * float(np.mean(camera.pixel_mm)))
    return found
