"""Residuals and image points by a block as it stands, without adjusting."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import assemble
from raybundle.block import Block, Camera
from raybundle.errors import NotSolvable
from raybundle.numerics.arrays import Array, Mask
from raybundle.observations.table import Table
from raybundle.platforms.station import sensor_from_object


def residuals_px(block: Block, rows: Array, xyz: Array | None = None) -> Array:
    """Residuals (k, 2) [px], model - measured, of these rows of the observations.

    xyz  (k, 3) places of their points in place of those in the block
    In the measured image to first order: -B^-1 g at the measured point.
    """
    observations = block.observations
    result = np.zeros((len(rows), 2))
    camera = block.images.camera[observations.image[rows]]
    xyz = block.points.xyz[observations.point[rows]] if xyz is None else xyz
    for c in np.unique(camera):
        mine = np.flatnonzero(camera == c)
        cam = block.cameras[c]
        model = cam.sensor
        image = observations.image[rows[mine]]
        values = np.array([cam.parameters] * len(mine)).T
        for k, i in enumerate(image):
            own = block.images.interior.get(int(i))
            if own is not None:
                values[:, k] = [own.get(p.symbol, cam.values.get(p.symbol, p.default)) for p in model.parameters]
        P = sensor_from_object(block.images.rotation[image], block.images.centre[image], xyz[mine])
        xy = cam.image_from_pixel(observations.xy_px[rows[mine]]).T
        g, J = model.condition_and_jacobian(*xy, *P, *values)
        B = np.moveaxis(J[:, :2], 2, 0)
        v = -np.linalg.solve(B, g.T[..., None])[..., 0]
        result[mine] = v / (np.array(cam.pixel_mm) * [1, -1])
    return result


def predicted_px(block: Block, image: int, xyz: Array) -> Array:
    """Image points (n, 2) [px] of object points (n, 3) in an oriented image; NaN behind the camera or not projected."""
    return image_points(block.camera_of(image), block.images.rotation[image], block.images.centre[image], xyz)


def image_points(camera: Camera, rotation: Array, centre: Array, xyz: Array) -> Array:
    """Image points (n, 2) [px] of object points (n, 3); NaN behind the camera or far outside the format.

    rotation, centre  (3, 3) and (3,) of one image, or (n, 3, 3) and (n, 3) of each point's
    """
    n = len(xyz)
    if not n:
        return np.zeros((0, 2))
    R, X0 = np.broadcast_to(rotation, (n, 3, 3)), np.broadcast_to(centre, (n, 3))
    if not camera.is_scene:
        return _where_seen(camera, R, X0, xyz)
    try:
        with np.errstate(all="ignore"):  # far from what a scene sees nothing has to be finite
            return _where_seen(camera, R, X0, xyz)
    except NotSolvable:  # what a scene does not see at all: the others are seen none the less
        if n == 1:
            return np.full((1, 2), np.nan)
        each = [slice(k, k + 1) for k in range(n)]
        return np.concatenate([image_points(camera, R[k], X0[k], xyz[k]) for k in each])


def _where_seen(camera: Camera, rotation: Array, centre: Array, xyz: Array) -> Array:
    model, values, n = camera.sensor, camera.parameters, len(xyz)
    P = sensor_from_object(rotation, centre, xyz)
    start = model.start(P, values)
    # beyond the format a distortion need not have an inverse
    near = np.asarray(model.in_front(P)) & (np.abs(start.T) < 0.75 * np.abs(camera.size_mm)).all(axis=1)
    result = np.full((n, 2), np.nan)
    found, seen = projected(camera, P[:, near], values, start[:, near])
    result[near] = np.where(seen[:, None], camera.pixel_from_image(found.T), np.nan)
    return result


def projected(camera: Camera, points: Array, values: Array, start: Array) -> tuple[Array, Mask]:
    """Images (2, n) of points (3, n) by Newton from `start`, and which (n,) of them there are.

    values  (u,) parameters of all points, or (u, n) of each
    """
    if not start.shape[1]:
        return start, np.zeros(0, bool)
    model = camera.sensor
    c = float(camera.size_mm.max()) if camera.is_scene else abs(float(np.ravel(values)[0]))
    image, step = start.copy(), np.full_like(start, np.inf)
    spread = np.repeat(values[:, None], image.shape[1], axis=1) if values.ndim == 1 else values
    with np.errstate(all="ignore"):
        for _ in range(30):
            g, J = model.condition_and_jacobian(*image, *points, *spread)
            det = J[0, 0] * J[1, 1] - J[0, 1] * J[1, 0]
            step = np.stack([J[1, 1] * g[0] - J[0, 1] * g[1], J[0, 0] * g[1] - J[1, 0] * g[0]]) / det
            image = image - step
            if np.nanmax(np.abs(step), initial=0) < 1e-10 * c:  # it is squared by the step just taken
                break
        seen = np.isfinite(step).all(axis=0) & (np.abs(step).max(axis=0) < 1e-9 * c)
        front = np.asarray(model.in_front(points, image, values))
        return np.where(seen, image, start), seen & front


def exact_tables(block: Block) -> tuple[Table, ...]:
    """The observations outside the images as the block's values have them, without errors.

    Values of points, images, cameras and instruments count as true.  Limits: unknowns of a kind of its
    own, as a total station's orientation, start where that kind starts them.
    """
    none = {owner.id: () for owner in block.parametrised}
    system = assemble(block, AdjustmentOptions(jobs=1), np.zeros(len(block.observations), bool), none)
    state = system.initial_state()
    found = list[Table]()
    for part in system.extra.parts:
        table = part.table
        if not isinstance(table, Table) or not table.observed:
            continue
        value = np.array(getattr(table, table.observed), float)
        flat = value.reshape(len(table), -1)
        residual = part.kind.observed(table, part.rows, system.extra.scope, state).residual
        flat[part.rows.item, part.rows.component if flat.shape[1] > 1 else 0] += residual
        found.append(replace(table, **{table.observed: flat.reshape(value.shape)}))
    return tuple(found)
