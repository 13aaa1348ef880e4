"""A block as other programs can take it: images with a place of their own, exposed at one instant.

Formats of other programs know neither rigs nor read-outs.  A camera on a rig stands for itself with the exterior
orientation that follows from the rig's; of a rolling shutter, and of a frame on a trajectory, the middle row stands for
the image, and its image points are moved to where they would be had all rows been read at that instant.  A line sensor
has no such instant and stays as it is.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.block import Block, Camera
from raybundle.block.rigs import is_mounted, without_rigs
from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Mask
from raybundle.platforms import Carried, Platform
from raybundle.platforms.station import sensor_from_object
from raybundle.sensors import SensorModel


@dataclass(frozen=True, slots=True, kw_only=True)
class _Unloaded:
    """A sensor and what it stood on, from the sensor outwards."""

    sensor: SensorModel
    platforms: tuple[Platform, ...]


def at_one_instant(block: Block) -> tuple[Block, tuple[str, ...]]:
    """The block without platforms, and remarks; the same block where no sensor stands on one."""
    mounted = [c.id for c in block.cameras if is_mounted(c)]
    block = without_rigs(block) if mounted else block
    loads = [_unloaded(c.sensor) for c in block.cameras]
    on_rigs = (phrase("conversion.rigs", cameras=mounted),) if mounted else ()
    if not any(u.platforms for u in loads):
        return block, on_rigs
    xy = block.observations.xy_px.copy()
    interior = {k: dict(v) for k, v in block.images.interior.items()}
    cameras, largest = list(block.cameras), dict[str, float]()
    for k, unloaded in enumerate(loads):
        camera = block.cameras[k]
        if not unloaded.platforms:
            continue
        for i in np.flatnonzero(block.images.camera == k).tolist():
            values = {**camera.values, **interior.get(i, {})}
            moved, rows = _moved(block, i, replace(camera, values=values), unloaded)
            if len(rows):
                xy[rows] += moved
                size = float(np.linalg.norm(moved, axis=1).max(initial=0.0))
                largest[camera.id] = max(largest.get(camera.id, 0.0), size)
            interior[i] = {s: v for s, v in interior.get(i, {}).items() if s in unloaded.sensor.symbols}
        cameras[k] = _alone(camera, unloaded.sensor)
    remarks = [phrase("conversion.read_out", camera=name, largest_px=size) for name, size in largest.items()]
    images = replace(block.images, station=None, interior={k: v for k, v in interior.items() if v})
    observations = replace(block.observations, xy_px=xy)
    return replace(block, cameras=tuple(cameras), images=images, observations=observations), (*remarks, *on_rigs)


def _unloaded(sensor: SensorModel) -> _Unloaded:
    found: list[Platform] = []
    while isinstance(sensor, Carried) and not sensor.sensor.line:
        found.append(sensor.platform)
        sensor = sensor.sensor
    return _Unloaded(sensor=sensor, platforms=tuple(reversed(found)))


def _alone(camera: Camera, sensor: SensorModel) -> Camera:
    """The camera with its sensor alone."""
    own = sensor.symbols
    estimate = camera.estimate if camera.estimate == "auto" else tuple(s for s in camera.estimate if s in own)
    return replace(
        camera, model=sensor.name, values={s: v for s, v in camera.values.items() if s in own}, estimate=estimate,
        sigma={s: v for s, v in camera.sigma.items() if s in own},
        per_image=tuple(s for s in camera.per_image if s in own),
    )  # fmt: skip


def _moved(block: Block, image: int, camera: Camera, unloaded: _Unloaded) -> tuple[Array, Array]:
    """By what the image points of an image move where all rows are read at once (k, 2) [px], and their rows.

    To first order, from the point where the read-out has it to where it is at the middle row.
    """
    o = block.observations
    placed: Mask = np.asarray(np.isfinite(block.points.xyz).all(axis=1), bool)
    rows = np.flatnonzero((o.image == image) & placed[o.point])
    moves = any(p.moves for p in unloaded.platforms)
    if not moves or not len(rows) or not block.images.oriented[image]:
        return np.zeros((0, 2)), rows[:0]
    R, X0 = block.images.rotation[image], block.images.centre[image]
    there = sensor_from_object(R[None], X0[None], block.points.xyz[o.point[rows]])
    still = there
    measured = camera.image_from_pixel(o.xy_px[rows]).T
    for platform in reversed(unloaded.platforms):  # from outside
        still = there
        there = platform.place(measured, there, np.array([camera.values.get(s, 0.0) for s in platform.symbols]))
    if np.array_equal(still, there):
        return np.zeros((0, 2)), rows[:0]
    own = [np.full(len(rows), camera.values.get(p.symbol, p.default)) for p in unloaded.sensor.parameters]
    _, J = unloaded.sensor.condition_and_jacobian(*measured, *there, *own)
    B, by_point = np.moveaxis(J[:, :2], 2, 0), np.moveaxis(J[:, 2:5], 2, 0)
    shift = -np.linalg.solve(B, by_point @ (still - there).T[:, :, None])[:, :, 0]
    known = np.isfinite(shift).all(axis=1)
    return shift[known] / (np.array(camera.pixel_mm) * [1, -1]), rows[known]
