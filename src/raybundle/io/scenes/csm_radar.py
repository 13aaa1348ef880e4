"""Radar ISD JSON of the Community Sensor Model (UsgsAstroSarSensorModel), as ALE writes it.

Columns are ground ranges, of which cubics at given times make slant ranges.  State vectors stand in an inertial frame;
their velocities lose omega x P where they are brought to the frame that turns with the body.  Doppler is zero.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.errors import note
from raybundle.io.reading.trees import Json
from raybundle.io.reading.words import quoted
from raybundle.io.scenes.base import Scene
from raybundle.io.scenes.csm_tables import rotations, slerp, times_of
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import Ellipsoid
from raybundle.scenes.kinds.range_doppler import RangeDoppler
from raybundle.scenes.orbit import Orbit

SIDES = {"right": 1.0, "left": -1.0}


def radar_scene(root: Json, path: Path, ellipsoid: Ellipsoid, metres: float) -> Scene:
    """The scene of a radar ISD, its positions in units of so many metres."""
    rows, columns = root.get("image_lines").whole(), root.get("image_samples").whole()
    centre = root.get("center_ephemeris_time").number()
    step, pixel = (root.get(k).positive() for k in ("line_exposure_duration", "scaled_pixel_width"))
    side = root.get("look_direction").text().lower()
    if side not in SIDES:
        root.get("look_direction").fail("value.not_supported", value=quoted(side), known=list(SIDES))
    start = root.get("starting_ephemeris_time").number() - centre
    times = np.array([t.number() for t in root.get("range_conversion_times").items()]) - centre
    cubics = np.array([c.numbers(4) for c in root.get("range_conversion_coefficients").items()]).reshape(-1, 4)
    return Scene(
        file=path, format="csm", width_px=columns, height_px=rows,
        sensor=root.get("name_sensor").text() if root.has("name_sensor") else "",
        remarks=(note("scene.radar_delays"),),
        rigorous=RangeDoppler(
            width_px=columns, height_px=rows, orbit=_orbit(root, metres), burst_y=np.zeros(1),
            burst_times=np.array([start - step / 2]), line_s=step, pixel_m=pixel, first_m=-pixel / 2,
            range_times=times, range_coefficients=cubics, wavelength_m=root.get("wavelength").number(),
            side=SIDES[side], ellipsoid=ellipsoid,
        ),
    )  # fmt: skip


def _orbit(root: Json, metres: float) -> Orbit:
    group = root.get("instrument_position")
    P, V = (_vectors(group, key) * metres for key in ("positions", "velocities"))
    if len(V) != len(P):
        group.get("velocities").fail("isd.velocity_count", n=len(V), positions=len(P))
    times = times_of(root, group, "ephemeris", len(P))
    body_times, R = rotations(root, "body_rotation")
    omega = _vectors(root.get("body_rotation"), "angular_velocities")
    if len(omega) != len(body_times):
        root.get("body_rotation").fail("isd.velocity_count", n=len(omega), positions=len(body_times))
    turning = np.stack([np.interp(times, body_times, w) for w in omega.T], axis=1)
    return Orbit.of_inertial(times, P, V, slerp(body_times, R, times), turning, joint=False)


def _vectors(group: Json, key: str) -> Array:
    return np.array([r.numbers(3) for r in group.get(key).items()]).reshape(-1, 3)
