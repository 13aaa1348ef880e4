"""What the geometry of satellite scenes states before anything is adjusted: common ground, search strips, misfit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.block import Camera
from raybundle.errors import InputError
from raybundle.matching.strips import Strips
from raybundle.numerics.arrays import Array
from raybundle.numerics.places import Local
from raybundle.scenes.bias import BiasKind
from raybundle.scenes.kinds import scene_kinds
from raybundle.scenes.kinds.rpc import RpcSensor
from raybundle.scenes.rpc_fit import fit_rpc
from raybundle.scenes.sensor import SceneSensor, scene_camera
from raybundle.workflows.scenes.images import SceneImage

GRID = 24
"""Points along each side of a scene by which common ground is judged."""
LEAST_COMMON = 0.01
"""Share of a scene below which common ground is not worth matching."""
GROUND_M = (-100.0, 3000.0)
"""Heights of ground that are looked for where a scene does not say."""
LEVELS_M, MOST_LEVELS = (20.0, 100.0), 100
"""Distance of the heights at which common ground is looked for, and their number at the most."""
RANGE = 3.0
"""Points farther from the middle of an RPC than so many times its range have no place in it."""
STEPS = 6


def place_of_scenes(scenes: Sequence[SceneImage]) -> Local:
    """A local frame in the middle of the scenes."""
    middles = np.array([middle_of_scene(s) for s in scenes])
    middles[:, 0] -= 360 * np.round((middles[:, 0] - middles[0, 0]) / 360)
    lon, lat, h = middles.mean(axis=0).tolist()
    return Local(origin=(round(lon, 7), round(lat, 7), round(h, 2)))


def middle_of_scene(image: SceneImage) -> Array:
    """Longitude, latitude, height of the middle of a scene."""
    middle = np.array([[image.width_px / 2, image.height_px / 2]])
    if image.rpc is not None:
        return image.rpc.localise(middle, float(image.rpc.ground_offset[2]))[0]
    assert image.rigorous is not None
    return image.rigorous.localise(middle, np.zeros(1))[0]


def kind_of_scene(image: SceneImage) -> tuple[type[SceneSensor], Any]:
    """The kind of a scene and its geometry: the RPC where it has one, else the rigorous model."""
    model = image.rpc or image.rigorous
    return next(k for k in scene_kinds.values() if isinstance(model, k.geometry)), model


def sensor_of(image: SceneImage, place: Local, bias: BiasKind) -> SceneSensor:
    """The sensor of a scene: its RPC with a bias, or where there is none its rigorous model as it begins."""
    kind, model = kind_of_scene(image)
    return kind.begun(model, place, (image.width_px, image.height_px), image.model, bias=bias)


def camera_of_scene(image: SceneImage, place: Local, bias: BiasKind) -> Camera:
    """The camera of a scene; what its vendor states is the prior of its parameters, else what is usual."""
    sensor = sensor_of(image, place, bias)
    return scene_camera(image.name, sensor, sigma=sensor.usual_priors())


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneView:
    """A scene as its geometry is used for matching: an RPC, its bias zero."""

    name: str
    sensor: RpcSensor
    heights: tuple[float, float]
    """Lowest and highest ground [m above the ellipsoid]."""
    prior_px: Array
    """(2,)"""

    def ground(self, xy_px: Array, height: float) -> Array:
        """Local points (n, 3) of image points (n, 2) at a height; NaN where there are none."""
        return self.sensor.place.block_from_geographic(self.sensor.rpc.ground_where_any(xy_px, height))

    def image(self, xyz: Array) -> Array:
        """Image points (n, 2) of local points (n, 3), NaN where there are none."""
        result = np.full((len(xyz), 2), np.nan)
        known = np.atleast_1d(np.isfinite(xyz).all(axis=1))
        if known.any():
            rpc = self.sensor.rpc
            apart = self.sensor.place.geographic_from_block(xyz[known]) - rpc.ground_offset
            apart[:, 0] -= 360 * np.round(apart[:, 0] / 360)
            known[known] = (np.abs(apart) < RANGE * rpc.ground_scale).all(axis=1)
        try:
            result[known] = self.sensor.observe(xyz[known], self.sensor.defaults).xy_px
        except InputError:
            return result
        return result


def view_of_scene(image: SceneImage, place: Local) -> SceneView:
    """The view of a scene."""
    sensor = sensor_of(image, place, "shift")
    rpc = image.rpc
    if rpc is None:  # an orbit ends with its scene: an RPC stands for it where points beyond the edge are asked for
        assert image.rigorous is not None
        rpc = fit_rpc(image.rigorous.localise, sensor.size_px, GROUND_M).rpc
    near = RpcSensor(rpc, place, sensor.size_px, "shift", image.model)
    return SceneView(name=image.name, sensor=near, heights=sensor.heights_m or GROUND_M, prior_px=sensor.prior_px())


@dataclass(frozen=True, slots=True, kw_only=True)
class Overlap:
    """Ground that two scenes have in common."""

    share: float
    """Of the first scene's ground, at whatever height"""
    heights: tuple[float, float]
    """Between which it may lie"""


def overlap(a: SceneView, b: SceneView) -> Overlap:
    """The common ground of two scenes, looked for at all heights for which both hold."""
    low, high = max(a.heights[0], b.heights[0]), min(a.heights[1], b.heights[1])
    if high - low < 1:
        low, high = a.heights
    steps = (np.arange(GRID) + 0.5) / GRID
    xy = np.stack([s.ravel() for s in np.meshgrid(steps * a.sensor.size_px[0], steps * a.sensor.size_px[1])], axis=1)
    extent = float(np.nanmin(np.ptp(a.ground(xy, (low + high) / 2)[:, :2], axis=0)))
    step = float(np.clip(extent / 8, *LEVELS_M)) if np.isfinite(extent) else LEVELS_M[1]
    levels = np.linspace(low, high, int(np.clip((high - low) / step, 3, MOST_LEVELS)))
    seen, common = np.zeros(len(xy), bool), list[float]()
    for h in levels.tolist():
        there = b.image(a.ground(xy, h))
        with np.errstate(invalid="ignore"):
            inside = ((there >= 0) & (there <= np.array(b.sensor.size_px))).all(axis=1)
        seen |= inside
        common += [h] if inside.any() else []
    if not common:
        return Overlap(share=0.0, heights=(low, high))
    reach = float(levels[1] - levels[0])
    return Overlap(share=float(seen.mean()), heights=(max(low, min(common) - reach), min(high, max(common) + reach)))


def strips_between(a: SceneView, b: SceneView, xy_px: Array, tolerance_px: float) -> Strips:
    """Where points (n, 2) of the first scene lie in the second, from the lowest to the highest ground."""
    low, high = overlap(a, b).heights
    return Strips(start=b.image(a.ground(xy_px, low)), end=b.image(a.ground(xy_px, high)), tolerance_px=tolerance_px)


@dataclass(frozen=True, slots=True, kw_only=True)
class Meeting:
    """How the rays of matched points of two scenes meet."""

    height_m: Array
    """(n,) above the ellipsoid"""
    misfit_px: Array
    """(n,) what intersecting leaves: a step of either image across the common plane of the rays shows here"""
    prior_px: float
    """Standard deviation of the misfit by the stated shifts of the two scenes"""


def meeting(a: SceneView, b: SceneView, xy_a: Array, xy_b: Array) -> Meeting:
    """Intersect the rays of image points (n, 2), (n, 2) and say what is left.

    Four image coordinates determine three of a point; the fourth condition is the misfit.  A wrong shift along the
    common plane of the rays does not show in it but in the height.
    """
    sensors = (a.sensor, b.sensor)
    xyz = a.ground(xy_a, sum(overlap(a, b).heights) / 2)
    miss, J = np.zeros((len(xyz), 4)), np.zeros((len(xyz), 4, 3))
    for _ in range(STEPS):
        seen = [s.observe(xyz, s.defaults) for s in sensors]
        miss = np.concatenate([xy_a - seen[0].xy_px, xy_b - seen[1].xy_px], axis=1)
        J = np.concatenate([s.by_point for s in seen], axis=1)
        step = np.linalg.solve(np.swapaxes(J, 1, 2) @ J + 1e-9 * np.eye(3), np.einsum("nki,nk->ni", J, miss)[..., None])
        step = step[..., 0]
        length = np.linalg.norm(step, axis=1, keepdims=True)
        xyz = xyz + step * np.minimum(1, 3000 / np.maximum(length, 1e-9))
    left = np.linalg.svd(J)[0][:, :, 3]
    first = left[len(left) // 2]
    left = left * np.where(left @ first < 0, -1, 1)[:, None]  # an axis has no sign
    typical = np.median(left, axis=0)
    sigma = float(np.sqrt(((typical * np.concatenate([a.prior_px, b.prior_px])) ** 2).sum()))
    geographic = a.sensor.place.geographic_from_block(xyz)
    return Meeting(height_m=geographic[:, 2], misfit_px=(left * miss).sum(axis=1), prior_px=sigma)
