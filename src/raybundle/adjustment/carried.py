"""What GNSS and INS observe: projection centres through antennas, attitudes through IMUs, with their own unknowns."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import angle_derivatives, angles_from_rotation, cross_matrix
from raybundle.sensors.imu import told

if TYPE_CHECKING:
    from raybundle.adjustment.assemble import State, System

STEEP = 0.01
"""Cosine of phi below which omega and kappa cannot be observed one by one."""


def antennas_and_imus(block: Block, images: Mask) -> set[int]:
    """Cameras that are antennas of observed projection centres, or IMUs of observed attitudes, of these images."""
    found: set[int] = set()
    for image, of_row in ((block.stations.image, block.stations.antenna), (block.attitudes.image, block.attitudes.imu)):
        if of_row is not None:
            found |= {int(a) for a in of_row[images[image]] if a >= 0}
    return found


def check_carried(block: Block, free: dict[str, tuple[str, ...]]) -> None:
    """Raise InputError where a time offset has no velocity, or the angles of an attitude are not defined."""
    stations, attitudes = block.stations, block.attitudes
    if stations.antenna is not None:
        late = {k for k, c in enumerate(block.cameras) if c.values.get("dt", 0.0) != 0 or "dt" in free.get(c.id, ())}
        unknown = np.isnan(stations.velocities).any(axis=1)
        unknown &= np.array([a in late for a in stations.antenna.tolist()], bool)
        if unknown.any():
            names = [block.images.ids[stations.image[k]] for k in np.flatnonzero(unknown)]
            raise InputError(
                f"a time offset dt needs the velocity of each image; it is not known for {', '.join(names[:5])}. Give "
                "velocities, or times with a neighbour before or after on the same flight line, or hold dt at 0"
            )
    steep = np.flatnonzero(np.cos(attitudes.angles[:, 1]) < STEEP) if len(attitudes) else []
    if len(steep):
        k = int(steep[0])
        raise InputError(
            f"attitude of image {block.images.ids[attitudes.image[k]]}: phi {np.degrees(attitudes.angles[k, 1]):.2f} "
            "deg is within 0.6 deg of a right angle, where omega and kappa turn about the same axis; leave it out"
        )


def antenna_rows(system: System, state: State) -> list[tuple[int, Array, Array, float]]:
    """Each station observation with an antenna: position among them, unknowns, derivatives, and R'a + s + d t."""
    stations, extra = system.block.stations, system.extra
    if stations.antenna is None:
        return []
    rows = {row.camera: r for r, row in enumerate(system.interior) if not row.model.has_images}
    time = np.zeros(len(stations)) if stations.time is None else stations.time
    velocity = np.nan_to_num(stations.velocities)  # of rows whose antenna has no time offset it may not be known
    result: list[tuple[int, Array, Array, float]] = []
    mine = np.flatnonzero(extra.kind == 2)
    for k, (item, axis) in enumerate(zip(extra.item[mine], extra.component[mine], strict=True)):
        if stations.antenna[item] < 0:
            continue
        image, r = int(stations.image[item]), rows[int(stations.antenna[item])]
        row, t = system.interior[r], float(time[item])
        a, s, d = state.interior[r, :9].reshape(3, 3)
        back, v = state.rotation[image].T, float(velocity[item, axis])
        unit = np.eye(3)[axis]
        by = np.concatenate([back[axis], unit, unit * t, [v]])
        free = list(row.free) if row.node >= 0 else []
        # R_new' a = R' exp(-[delta]x) a
        columns = [system.offsets[system.image_node[image]] + 3 + np.arange(3)]
        if free:
            columns.append(system.offsets[row.node] + row.start + np.arange(len(free)))
        values = np.concatenate([(back @ cross_matrix(a))[axis], by[free]])
        moved = float(back[axis] @ a + s[axis] + d[axis] * t + v * state.interior[r, 9])
        result.append((k, np.concatenate(columns), values, moved))
    return result


@dataclass(frozen=True, slots=True, kw_only=True)
class AttitudeRows:
    """The observed angles at a state, in the order of the extra observations."""

    residual: Array
    """(k,) adjusted - observed [rad]"""
    by_rotation: Array
    """(k, 3) derivatives by a small rotation of the image"""
    by_boresight: Array
    """(k, 3)"""
    row: Index
    """(k,) interior row of the IMU, -1 for none"""


def attitude_rows(system: System, state: State) -> AttitudeRows:
    """Each observed angle: what the IMU would tell, against what it told."""
    attitudes, extra = system.block.attitudes, system.extra
    mine = np.flatnonzero(extra.kind == 5)
    item, axis = extra.item[mine], extra.component[mine]
    image = attitudes.image[item]
    rows = {row.camera: r for r, row in enumerate(system.interior) if not row.model.has_images}
    imu = np.full(len(attitudes), -1, np.int32) if attitudes.imu is None else attitudes.imu
    row = np.array([rows.get(int(a), -1) for a in imu[item]], np.int32)
    n = len(mine)
    residual, by_rotation, by_boresight = np.zeros(n), np.zeros((n, 3)), np.zeros((n, 3))
    for r in np.unique(row):
        k = np.flatnonzero(row == r)
        seen, turn, by = told(state.rotation[image[k]], np.zeros(3) if r < 0 else state.interior[r, :3])
        D = angle_derivatives(seen)[np.arange(len(k)), axis[k]]
        difference = angles_from_rotation(seen)[np.arange(len(k)), axis[k]] - extra.value[mine[k]]
        residual[k] = np.arctan2(np.sin(difference), np.cos(difference))
        by_rotation[k], by_boresight[k] = D @ turn, D @ by
    return AttitudeRows(residual=residual, by_rotation=by_rotation, by_boresight=by_boresight, row=row)
