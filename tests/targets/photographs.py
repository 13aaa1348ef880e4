"""Photographs of a sheet of coded targets through a camera with distortion, rendered without the code that measures.

The viewing rays of a true camera meet the plane of the sheet; what is printed there is sampled finely, edges by their
share of a sample, blurred by a Gaussian (optics), averaged over square pixels (sensor), given noise and rounded.  Only
the surroundings of targets are drawn finely: the rest of the photograph is plain ground.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np
from scipy.interpolate import RectBivariateSpline

from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block, Camera, Observations, Points
from raybundle.calibration.eccentricity import CircleImages
from raybundle.planning.synthetic_networks import brown_camera, look_at
from raybundle.platforms.station import sensor_from_object
from raybundle.targets.codes import family_named
from tests.targets.render import ring_pattern

STEP = 8
"""Pixels between exact rays; between them the places on the sheet are interpolated."""
FAMILY = "aicon14"
FREE = ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S")


@dataclass(frozen=True, kw_only=True)
class SheetNetwork:
    """A plane sheet of targets and photographs of it."""

    width_px: int
    height_px: int
    barrel_px: float
    """Distortion in the corners of the format"""
    radius_mm: float
    """Of the dots"""
    photographs: int = 10
    columns: int = 7
    rows: int = 5
    pitch_mm: float = 55.0
    noise: float = 1.5
    fine: int = 3
    """Samples along a pixel; 2 do for targets of some 100 px"""
    seed: int = 0


def true_camera(plan: SheetNetwork) -> Camera:
    """A camera with so much barrel distortion, principal point and decentring off zero."""
    rng = np.random.default_rng(plan.seed)
    pixel = 36.0 / plan.width_px
    half = np.hypot(plan.width_px, plan.height_px) / 2 * pixel
    size = plan.barrel_px * pixel
    # image = ray - distortion: a positive correction of the measured point is barrel
    K1 = 1.3 * size / half**3
    values = {
        "c": 32.0 + rng.uniform(-2, 2), "x0": rng.uniform(-0.3, 0.3), "y0": rng.uniform(-0.3, 0.3), "K1": K1,
        "K2": -0.3 * size / half**5, "K3": 0.0, "P1": rng.normal(0, 2e-6), "P2": rng.normal(0, 2e-6), "A": 0.0,
        "S": 0.0,
    }  # fmt: skip
    return brown_camera(values=values, size_px=(plan.width_px, plan.height_px), pixel_mm=pixel)


def places(plan: SheetNetwork) -> np.ndarray:
    """(n, 2) middles of the targets [mm], the sheet around the origin."""
    x, y = np.meshgrid(np.arange(plan.columns), np.arange(plan.rows))
    xy = np.stack([x.ravel(), y.ravel()], axis=1) - [(plan.columns - 1) / 2, (plan.rows - 1) / 2]
    return xy * plan.pitch_mm


def stations(plan: SheetNetwork) -> tuple[np.ndarray, np.ndarray]:
    """Projection centres (n, 3) and rotations (n, 3, 3): convergent and rolled, some near the normal."""
    rng = np.random.default_rng(plan.seed + 1000)
    n = plan.photographs
    azimuth = 2 * np.pi * np.arange(n) / n + rng.uniform(-0.2, 0.2, n)
    tilt = np.radians(np.where(np.arange(n) % 5 == 4, 5.0, rng.uniform(30, 40, n)))
    out = np.stack([np.sin(tilt) * np.cos(azimuth), np.sin(tilt) * np.sin(azimuth), np.cos(tilt)], axis=1)
    width = plan.columns * plan.pitch_mm
    centre = out * (0.95 * width * rng.uniform(0.95, 1.1, (n, 1)))
    aim = np.concatenate([rng.uniform(-0.04, 0.04, (n, 2)) * width, np.zeros((n, 1))], axis=1)
    return centre, look_at(centre, aim, np.arange(n) % 4 * np.pi / 2, up=np.array([0.0, 1.0, 0.0]))


def ground_of(camera: Camera, X0: np.ndarray, R: np.ndarray, pixel: np.ndarray) -> np.ndarray:
    """Places (n, 2) on the plane Z = 0 that pixels (n, 2) show."""
    d = camera.sensor.ray(camera.image_from_pixel(pixel).T, camera.parameters).T @ R
    return (X0 - d * (X0[2] / d[:, 2])[:, None])[:, :2]


def photograph(plan: SheetNetwork, camera: Camera, X0: np.ndarray, R: np.ndarray, rng: np.random.Generator):
    """Grey values (h, w) uint8 of one photograph."""
    w, h = plan.width_px, plan.height_px
    x, y = (np.arange(-2 * STEP, n + 3 * STEP, STEP, float) for n in (w, h))
    nodes = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    at = ground_of(camera, X0, R, nodes).reshape(len(y), len(x), 2)
    spline = [RectBivariateSpline(y, x, at[..., k]) for k in (0, 1)]
    family = family_named(FAMILY)
    image = np.full((h, w), 40.0)
    for k, middle in enumerate(places(plan)):
        # the window: where the sheet is within 3.4 radii
        near = nodes[np.linalg.norm(at.reshape(-1, 2) - middle, axis=1) < 3.4 * plan.radius_mm + plan.pitch_mm / 6]
        if not len(near):
            continue
        low = np.clip(np.floor(near.min(axis=0)).astype(int) - STEP, 0, [w, h])
        high = np.clip(np.ceil(near.max(axis=0)).astype(int) + STEP, 0, [w, h])
        if (high - low < 4).any():
            continue
        fx, fy = ((np.arange(a * plan.fine, b * plan.fine) + 0.5) / plan.fine for a, b in zip(low, high, strict=True))
        q = np.stack([s(fy, fx) for s in spline], axis=-1)
        q = (q - middle) / plan.radius_mm
        r = np.hypot(q[..., 0], q[..., 1])
        slope = np.hypot(*np.gradient(r))
        code = int(family.code_of(np.array([k + 1]))[0])
        fine = ring_pattern(q, 1 / np.maximum(slope, 1e-9), family.ring, family.bits, code)
        fine = cv2.GaussianBlur(fine, (0, 0), 0.7 * plan.fine, borderType=cv2.BORDER_REPLICATE)
        size = high - low
        mean = fine.reshape(size[1], plan.fine, size[0], plan.fine).mean(axis=(1, 3))
        part = image[low[1] : high[1], low[0] : high[0]]
        np.maximum(part, 40 + 160 * mean, out=part)
    image += rng.normal(0, plan.noise, image.shape)
    return np.clip(np.round(image), 0, 255).astype(np.uint8)


def photographed(plan: SheetNetwork, folder: Path) -> Camera:
    """Write the photographs of a network into a folder; the true camera."""
    camera = true_camera(plan)
    rng = np.random.default_rng(plan.seed + 2000)
    folder.mkdir(parents=True, exist_ok=True)
    for k, (X0, R) in enumerate(zip(*stations(plan), strict=True)):
        cv2.imwrite(str(folder / f"{k:02}.png"), photograph(plan, camera, X0, R, rng))
    return camera


def normalised_error(done, truth: Camera) -> tuple[float, int]:
    """Squared error of the estimated interior orientation against its covariance, and its degrees of freedom."""
    a = done.adjustment
    (interior,) = a.interior
    free = interior.free
    # pixels of a camera without metadata have a nominal size: values scale with the image
    scale = a.adjusted.cameras[0].pixel_mm[0] / truth.pixel_mm[0]
    power = {"c": 1, "x0": 1, "y0": 1, "K1": -2, "K2": -4, "K3": -6, "P1": -1, "P2": -1, "A": 0, "S": 0}
    e = np.array([interior.parameters[s].value - truth.values[s] * scale ** power[s] for s in free])
    C = a.precision.interior[interior.camera]
    return float(e @ np.linalg.solve(C, e)), len(free)


def first_order_images(block: Block, rows: np.ndarray, radius: np.ndarray, normal: np.ndarray) -> CircleImages:
    """`circle_images` of the central projection alone, distortion carried to first order: what must be noticed.

    The dual conic of the image is P P' - r^2 (I - n n'), its centre (U W + r^2 nU nW, V W + r^2 nV nW) /
    (W^2 - r^2 (1 - nW^2)).
    """
    o = block.observations
    R, X0 = block.images.rotation[o.image[rows]], block.images.centre[o.image[rows]]
    P = sensor_from_object(R, X0, block.points.xyz[o.point[rows]]).T
    a, b, c = np.einsum("nij,nj->in", R, normal)
    (U, V, W), r2 = P.T, radius**2
    depth = W * W - r2 * (1 - c * c)
    there = np.stack([(U * W + r2 * a * c) / depth * W, (V * W + r2 * b * c) / depth * W, W], axis=1)
    shifted = X0 + np.einsum("nji,nj->ni", R, there)

    def residuals(xyz: np.ndarray) -> np.ndarray:
        k = len(rows)
        part = Observations(
            image=o.image[rows], point=np.arange(k, dtype=np.int32), xy_px=o.xy_px[rows], cov_px2=o.cov_px2[rows]
        )
        points = Points(
            ids=tuple(map(str, range(k))), role=np.zeros(k, np.int32), xyz=xyz, sigma=np.full((k, 3), np.nan)
        )
        return residuals_px(replace(block, observations=part, points=points), np.arange(k))

    offset = residuals(shifted) - residuals(block.points.xyz[o.point[rows]])
    c_px = np.array([x.values["c"] / np.mean(x.pixel_mm) for x in block.cameras])[block.images.camera[o.image[rows]]]
    size = radius * c_px * np.sqrt(np.abs(U * a + V * b + W * c) / np.abs(W) ** 3)
    return CircleImages(offset_px=offset, radius_px=size)
