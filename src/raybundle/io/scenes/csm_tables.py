"""The tables of a line-scan ISD: positions and attitudes in time, brought to the axes that turn with the body.

Tables are the samples of reduced SPICE kernels, and their steps are not always equal.  Positions come with velocities
and are interpolated by Hermite cubics.  Attitudes of unequal steps are interpolated on great circles (slerp) to equal
ones, as USGSCSM does; what that costs across the widest gap is measured on the table itself (`_bridged`).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from raybundle.errors import Message, Severity, Value
from raybundle.io.reading.trees import Json
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import Ellipsoid
from raybundle.scenes.trajectory import GAP, Trajectory, rotation_from_quaternion

NODES = 25
"""Positions to which USGSCSM interpolates shorter tables."""
WINDOWS = 300
"""Stretches of a table, spread over it, on which the unrest of the attitude is measured."""
STEADY_S = 3.0
"""From a frame's time to further entries of its tables."""
UNKNOWN_PX = 1.0
"""Pointing across a gap that is not known to a pixel is no rigorous model any more."""


def body_trajectory(
    root: Json, ellipsoid: Ellipsoid, metres: float, pixel_rad: float, *, rigid: bool = False
) -> tuple[Trajectory, list[Message]]:
    """The sensor's path and attitude in the axes of the body, and what is to be stated of them.

    metres     of a unit of the positions
    pixel_rad  angle of a pixel across the flight
    rigid      of frames, which an attitude that is not known between entries does not bend: it is noted, not refused
    raises     InputError where tables do not fit each other, the body or the lines
    """
    group = root.get("instrument_position")
    positions = np.array([r.numbers(3) for r in group.get("positions").items()]).reshape(-1, 3) * metres
    radius = np.linalg.norm(positions, axis=1)
    if len(radius) == 0 or radius.min() <= ellipsoid.b:
        group.fail("isd.position_inside_body", distance_m=radius.min(initial=0), radius_m=ellipsoid.a)
    times = times_of(root, group, "ephemeris", len(positions))
    position_times, positions = _equal_steps(group, times, positions, metres)
    body_times, body = rotations(root, "body_rotation")
    pointing_times, pointing = rotations(root, "instrument_pointing")
    at_positions, at_pointing = (slerp(body_times, body, t) for t in (position_times, pointing_times))
    attitude_times, attitude, remarks = _bridged(
        root.get("instrument_pointing"),
        pointing_times,
        at_pointing @ np.swapaxes(pointing, 1, 2),
        pixel_rad,
        rigid=rigid,
    )
    position_times, placed = _steady(position_times, np.einsum("nij,nj->ni", at_positions, positions))
    attitude_times, turned = _steady(attitude_times, _rotation(attitude).as_quat())
    return Trajectory(
        position_times=position_times, positions=placed, attitude_times=attitude_times, quaternions=turned
    ), remarks


def _steady(times: Array, values: Array) -> tuple[Array, Array]:
    """A table of one entry, as frames have it, as one that holds for some seconds; others as they are."""
    if len(times) != 1:
        return times, values
    return times + STEADY_S * np.array([-1.0, 0.0, 1.0]), np.repeat(values, 3, axis=0)


def times_of(root: Json, group: Json, name: str, count: int) -> Array:
    """Seconds after the centre of the image of a table's entries."""
    if group.has("ephemeris_times") or not root.has(f"t0_{name}"):
        times = group.get("ephemeris_times").items()
        if len(times) != count:
            group.get("ephemeris_times").fail("isd.time_count", n=len(times), entries=count)
        found = np.array([t.number() for t in times]) - root.get("center_ephemeris_time").number()
    else:
        found = root.get(f"t0_{name}").number() + root.get(f"dt_{name}").number() * np.arange(count)
    if (np.diff(found) <= 0).any():
        k = int(np.argmin(np.diff(found)))
        group.fail("isd.time_order", entry=k + 2, time_s=found[k + 1], before_s=found[k])
    return found


def rotations(root: Json, key: str) -> tuple[Array, Array]:
    """Times (n,) and rotations (n, 3, 3) from inertial axes to those of the detector or the body."""
    group = root.get(key)
    q = np.array([r.numbers(4) for r in group.get("quaternions").items()]).reshape(-1, 4)
    if len(q) == 0 or (np.linalg.norm(q, axis=1) < 1e-6).any():
        group.get("quaternions").fail("isd.quaternion_zero", n=len(q))
    R = rotation_from_quaternion(q[:, [1, 2, 3, 0]])
    if group.has("constant_rotation"):
        R = group.get("constant_rotation").numbers(9).reshape(3, 3) @ R
    return times_of(root, group, "quaternion", len(q)), R


def _equal_steps(group: Json, times: Array, positions: Array, metres: float) -> tuple[Array, Array]:
    """The positions at 25 or more equal steps, by Hermite cubics where the table has velocities.

    USGSCSM does so; where velocities contradict the positions, as in some synthetic files, this is felt.
    """
    if not group.has("velocities") or len(times) < 2:
        return times, positions
    from scipy.interpolate import CubicHermiteSpline

    velocities = np.array([r.numbers(3) for r in group.get("velocities").items()]).reshape(-1, 3) * metres
    if len(velocities) != len(times):
        group.get("velocities").fail("isd.velocity_count", n=len(velocities), positions=len(times))
    at = np.linspace(times[0], times[-1], max(NODES, len(times)))
    return at, CubicHermiteSpline(times, positions, velocities)(at)


def _rotation(R: Array) -> Any:
    from scipy.spatial.transform import Rotation

    return Rotation.from_matrix(R)


def slerp(times: Array, R: Array, at: Array) -> Array:
    """Rotations (n, 3, 3) at other times, on the great circle between neighbours and beyond the ends of the table.

    Exact for a body that turns at a constant rate.  A table of one entry holds for all times.
    """
    if len(times) == 1:
        return np.broadcast_to(R[0], (len(at), 3, 3))
    k = np.clip(np.searchsorted(times, at, side="right") - 1, 0, len(times) - 2)
    turns = _rotation(np.swapaxes(R[:-1], 1, 2) @ R[1:]).as_rotvec()
    share = (at - times[k]) / np.diff(times)[k]
    from scipy.spatial.transform import Rotation

    return R[k] @ Rotation.from_rotvec(share[:, None] * turns[k]).as_matrix()


def _bridged(
    group: Json, times: Array, R: Array, pixel_rad: float, *, rigid: bool
) -> tuple[Array, Array, list[Message]]:
    """Times and rotations at equal steps, where those of a table are unequal by half or more; as given otherwise.

    raises  InputError where the pointing inside the widest gap is not known to a pixel
    """
    if len(times) < 3:
        return times, R, []
    step = np.diff(times)
    usual = float(np.median(step))
    if step.max() <= GAP * usual and step.min() >= usual / 2:
        return times, R, []
    widest = int(np.argmax(step))
    remarks: list[Message] = []
    if step[widest] > GAP * usual:
        error = _hidden(times, R, float(step[widest]), usual)
        gaps = int((step > GAP * usual).sum())
        measured = bool(np.isfinite(error))
        values: dict[str, Value] = {
            "n": gaps, "steps": float(step[widest] / usual), "from_s": float(times[widest]),
            "to_s": float(times[widest + 1]), "error_px": float(error / pixel_rad) if measured else None,
        }  # fmt: skip
        if not rigid and (not measured or error > UNKNOWN_PX * pixel_rad):
            group.fail("isd.attitude_gap", **values, measured=measured, limit_px=UNKNOWN_PX)
        remarks.append(Message(code="isd.attitude_gap_bridged", values=values, severity=Severity.NOTE))
    at = np.linspace(times[0], times[-1], len(times))
    return at, slerp(times, R, at), remarks


def _hidden(times: Array, R: Array, gap: float, usual: float) -> float:
    """Root mean square of the largest angles [rad] off great circles over stretches of the table as long as a gap.

    A pair of entries that far apart, with entries between them, is such a gap of which the content is known: what
    the gap hides is to be expected as large, and so the spacecraft's own unrest is in it.  nan without such a pair.
    """
    first = np.arange(len(times) - 2)
    last = np.searchsorted(times, times[first] + gap * (1 - 1e-6))
    good = (last < len(times)) & (last - first >= 2)
    good[good] &= times[last[good]] - times[first[good]] <= gap + usual
    wide = np.append(0, np.cumsum(np.diff(times) > GAP * usual))
    good[good] &= wide[last[good]] == wide[first[good]]  # no gap within
    largest: list[float] = []
    some = slice(None, None, max(1, int(good.sum()) // WINDOWS))
    for a, b in zip(first[good][some], last[good][some], strict=True):
        inner = np.arange(a + 1, b)
        over = slerp(times[[a, b]], R[[a, b]], times[inner])
        largest.append(float(_rotation(np.swapaxes(over, 1, 2) @ R[inner]).magnitude().max()))
    return float(np.sqrt(np.mean(np.square(largest)))) if largest else float("nan")
