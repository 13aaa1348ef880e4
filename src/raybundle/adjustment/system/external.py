"""Observations of sensor models that are not compiled, evaluated for the compiled solver."""

from __future__ import annotations

import numpy as np

from raybundle.adjustment.system.assemble import State, System
from raybundle.adjustment.system.images_numpy import BEHIND, LOST, image_residuals, inverse2, project_from
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.platforms.station import sensor_from_object
from raybundle.sensors import SensorModel


def external_rows(system: System, state: State, mask: Mask) -> tuple[Array, Index]:
    """What the compiled solver takes for observations of models that it does not know.

    mask     (m,) of `System.rows`
    returns  (k, 9 + 2 w): v (2) [mm], d v / d sensor-frame point (2, 3), d v / d interior (2, w), flags; and (k, w)
             columns of the shared node for models of which a point touches few parameters, -1 for the others
    """
    o = system.block.observations
    rows, xy = system.rows[mask], system.xy_mm[mask]
    image, point = o.image[rows], o.point[rows]
    of_row = system.interior_of_image[image]
    outside = sorted(set(of_row.tolist()))
    models = {r: system.interior[r].sensor for r in outside}
    few = np.array([models[r].local_width > 0 for r in of_row.tolist()])
    w = max([1, *(models[r].local_width or len(models[r].symbols) for r in outside)])
    out, columns = np.zeros((len(rows), 9 + 2 * w)), np.full((len(rows), w), -1, np.int32)
    if not few.all():
        mine = np.flatnonzero(~few)
        v, D, _, flags = image_residuals(system, state, image[mine], point[mine], xy[mine])
        used = min(w, system.stride)
        out[mine, :2], out[mine, 2:8], out[mine, -1] = v, D[:, :, :3].reshape(-1, 6), flags
        out[mine, 8 : 8 + used], out[mine, 8 + w : 8 + w + used] = D[:, 0, 3 : 3 + used], D[:, 1, 3 : 3 + used]
    for r in (r for r in outside if models[r].local_width):
        mine, row, k = np.flatnonzero(of_row == r), system.interior[r], models[r].local_width
        P = sensor_from_object(state.rotation[image[mine]], state.centre[image[mine]], state.xyz[point[mine]])
        v, D, touched, flags = local_residuals_and_partials(row.sensor, xy[mine], P, state.interior[r])
        at = system.node_columns(r)[touched]
        D[:, :, 3:] *= (at >= 0)[:, None]
        out[mine, :2], out[mine, 2:8], out[mine, -1] = v, D[:, :, :3].reshape(-1, 6), flags
        out[mine, 8 : 8 + k], out[mine, 8 + w : 8 + w + k] = D[:, 0, 3:], D[:, 1, 3:]
        columns[mine] = 0
        columns[mine, :k] = np.maximum(at, 0)
        if row.node < 0:
            columns[mine] = -1
    return out, columns


def local_residuals_and_partials(
    model: SensorModel, xy: Array, points: Array, values: Array
) -> tuple[Array, Array, Index, Array]:
    """As `residuals_and_partials` in the measured form, for a model of which a point touches few parameters.

    xy (n, 2), points (3, n), values (k,); returns v (n, 2), D (n, 2, 3 + w), touched parameters (n, w), flags (n,)
    """
    measured = xy.T
    values = values[: len(model.symbols)]
    with np.errstate(all="ignore"):
        g, J0, touched = model.local(measured, points, values)
        if model.explicit:  # the image point is what the condition leaves of any other
            image, J, lost = measured - g, J0, np.zeros(measured.shape[1], bool)
        else:
            image, J, lost = project_from(lambda at: model.local(at, points, values)[:2], measured)
            g, J0, touched = model.local(image, points, values)
        D = np.where(lost, -J0[:, 2:], -inverse2(J[:, :2], J[:, 2:]))
    v = np.where(lost, -g, image - measured)
    flags = BEHIND * ~model.in_front(points, measured, values) + LOST * lost
    return np.ascontiguousarray(v.T), np.ascontiguousarray(np.moveaxis(D, 2, 0)), touched, flags
