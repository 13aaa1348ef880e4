"""Residuals of image observations against a block as it stands, without adjusting."""

from __future__ import annotations

import numpy as np

from raybundle.block import Block
from raybundle.numerics.arrays import Array
from raybundle.platforms.station import sensor_from_object
from raybundle.sensors import sensor_models


def residuals_px(block: Block, rows: Array) -> Array:
    """Residuals (k, 2) [px], model - measured, of these rows of the observations.

    In the measured image to first order: -B^-1 g at the measured point.
    """
    observations = block.observations
    result = np.zeros((len(rows), 2))
    camera = block.images.camera[observations.image[rows]]
    for c in np.unique(camera):
        mine = np.flatnonzero(camera == c)
        cam = block.cameras[c]
        model = sensor_models[cam.model]
        image = observations.image[rows[mine]]
        point = observations.point[rows[mine]]
        values = np.array([[cam.values[s] for s in model.symbols]] * len(mine)).T
        for k, i in enumerate(image):
            own = block.images.interior.get(int(i))
            if own is not None:
                values[:, k] = [own[s] for s in model.symbols]
        P = sensor_from_object(block.images.rotation[image], block.images.centre[image], block.points.xyz[point])
        xy = cam.image_from_pixel(observations.xy_px[rows[mine]]).T
        g, J = model.condition_and_jacobian(*xy, *P, *values)
        B = np.moveaxis(J[:, :2], 2, 0)
        v = -np.linalg.solve(B, g.T[..., None])[..., 0]
        result[mine] = v / (np.array(cam.pixel_mm) * [1, -1])
    return result
