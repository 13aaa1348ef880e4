"""A line scanner on an aircraft: a TOML file with lens and lines, beside it a table of GNSS and INS.

    scanner = "one line of an aerial line scanner"        free text; this key makes the file one of this format
    width_px = 12000
    height_px = 5000

    [lens]
    c_mm = 62.77
    pixel_mm = 0.0065            width of an element
    x0_mm = 0.0                  principal point on the line
    y0_mm = 0.0                  place of the line, as in a positive image: a line with y0 > 0 looks ahead
    detector = "lens.csv"        instead of pixel_mm, x0_mm and y0_mm: x_px,x_mm,y_mm of calibrated elements

    [lines]
    first_s = 300.0              time in the middle of the first line
    interval_s = 0.002
    table = "lines.csv"          instead of the two: y_px,time_s

    [trajectory]
    file = "flight.csv"          time_s, a position, three angles and, if known, their standard deviations
    attitudes = "ins.csv"        where the angles have times of their own: time_s and the three angles, not in the file
    crs = "EPSG:25832"           of positions X, Y, Z; longitude_deg, latitude_deg, height_m need none
    lever_arm_m = [0, 0, 0]      from the projection centre to the point whose positions the table has
    boresight_deg = [0, 0, 0]    R = exp([b]x) R_table

Axes of lens, lever arm and boresight are those of an image: x to the right in the flight direction, y forward, z up.
Columns run to the right; a scanner whose columns run to the left has a negative pixel_mm.  Angles are omega, phi, kappa
against the axes of the positions (east, north, up where they are geographic) or roll, pitch, yaw of a body that
carries the lens downwards, against true north; in _deg, _gon or _rad.  Files stand beside the TOML file.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Literal, cast

import numpy as np

from raybundle.errors import InputError
from raybundle.io.block.toml_section import Section, read_toml
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.io.reading.words import quoted
from raybundle.io.scenes.base import Scene, SceneFormat, register
from raybundle.io.tables import Column, Table, read_table, times_in_order
from raybundle.io.trajectories.angle_csv import GEOGRAPHIC, GRID, SIGMA, UNITS
from raybundle.io.trajectories.base import WGS84_HEIGHT, Trajectory, rotations_in
from raybundle.numerics.arrays import Array
from raybundle.numerics.attitude import rotation_from_opk, rotation_from_rpy
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.trajectory import Trajectory as Path3d

ANGLES = {("omega", "phi", "kappa"): rotation_from_opk, ("roll", "pitch", "yaw"): rotation_from_rpy}
FILES = (("lens", "detector"), ("lines", "table"), ("trajectory", "file"), ("trajectory", "attitudes"))


def read(path: Path) -> Scene:
    """The scene; raises InputError with file, line and column."""
    top = read_toml(path)
    top.allow(("scanner", "width_px", "height_px", "lens", "lines", "trajectory"))
    width, height = top.whole("width_px"), top.whole("height_px")
    x, look = _look(top.section("lens"), width)
    line_y, line_times = _lines(top.section("lines"), height)
    trajectory, sigma = _trajectory(top.section("trajectory"))
    return Scene(
        file=path,
        format="airborne",
        rigorous=LineScene(
            width_px=width,
            height_px=height,
            line_y=line_y,
            line_times=line_times,
            detector_x=x,
            detector_look=look,
            trajectory=trajectory,
            view=-1.0,
            aberration=False,
            position_sigma_m=sigma[0],
            attitude_sigma_rad=sigma[1],
        ),
        width_px=width,
        height_px=height,
        sensor=top.text("scanner", ""),
        time=f"{line_times[0]:g} s",
    )


def companions(path: Path) -> tuple[Path, ...]:
    """The files that a scene's file names."""
    top = read_toml(path)
    return tuple(_beside(top.section(table), key) for table, key in FILES if key in top.section(table).values)


def _beside(section: Section, key: str) -> Path:
    """The file of a key, which must stand beside this one, so that both can be copied together."""
    name = section.text(key, "")
    if not name or Path(name).name != name:
        section.fail(key, "scene.file_elsewhere", name=quoted(name))
    return section.file.parent / name


def _either(section: Section, key: str, others: tuple[str, ...]) -> bool:
    """Whether the key of a table stands there; raises where others do as well."""
    for other in others:
        if key in section.values and other in section.values:
            section.fail(other, "scene.keys_exclusive", other=key)
    return key in section.values


def _look(lens: Section, width: int) -> tuple[Array, Array]:
    """Elements x [px] and the tangents U / W, V / W of their viewing directions."""
    lens.allow(("c_mm", "pixel_mm", "x0_mm", "y0_mm", "detector"))
    c = lens.number("c_mm", above=0)
    if _either(lens, "detector", ("pixel_mm", "x0_mm", "y0_mm")):
        file = _beside(lens, "detector")
        table = read_table(file, [Column(name=n, kind="number") for n in ("x_px", "x_mm", "y_mm")], least_rows=2)
        x, plane = table.number["x_px"], table.numbers("x_mm", "y_mm")
        if not (np.diff(x) > 0).all():
            k = int(np.flatnonzero(np.diff(x) <= 0)[0])
            raise InputError(
                "table.not_increasing",
                value=x[k + 1],
                before=x[k],
                file=file,
                line=k + table.first_line + 1,
                column="x_px",
            )
    else:
        pixel = lens.number("pixel_mm")
        if pixel == 0:
            lens.fail("pixel_mm", "value.zero")
        x = np.array([0.0, float(width)])
        along = (x - width / 2) * pixel - lens.number("x0_mm", 0.0)
        plane = np.stack([along, np.full(2, lens.number("y0_mm", 0.0))], axis=1)
    return x, -plane / c


def _lines(lines: Section, height: int) -> tuple[Array, Array]:
    """Lines y [px] and times [s]."""
    lines.allow(("first_s", "interval_s", "table"))
    if not _either(lines, "table", ("first_s", "interval_s")):
        first, interval = lines.number("first_s"), lines.number("interval_s", above=0)
        return np.array([0.5, height + 0.5]), first + np.array([0.0, height * interval])
    file = _beside(lines, "table")
    table = read_table(file, [Column(name=n, kind="number") for n in ("y_px", "time_s")], least_rows=2)
    for name in ("y_px", "time_s"):
        values = table.number[name]
        if not (np.diff(values) > 0).all():
            k = int(np.flatnonzero(np.diff(values) <= 0)[0])

            raise InputError(
                "table.not_increasing",
                value=values[k + 1],
                before=values[k],
                file=file,
                line=k + table.first_line + 1,
                column=name,
            )
    return table.number["y_px"], table.number["time_s"]


def _trajectory(section: Section) -> tuple[Path3d, tuple[float | None, float | None]]:
    """Positions of the projection centre and rotations of the image, geocentric; the usual standard deviations."""
    section.allow(("file", "attitudes", "crs", "lever_arm_m", "boresight_deg"))
    if "file" not in section.values:
        section.fail("file", "value.key_missing", name=quoted("file"))
    file = _beside(section, "file")
    apart = _beside(section, "attitudes") if "attitudes" in section.values else None
    given = _table(file, "both" if apart is None else "positions")
    crs = section.text("crs", "") or given.crs
    if given.crs is not None and crs != given.crs:
        section.fail("crs", "scene.crs_superfluous")
    if crs is None:
        section.fail("crs", "scene.crs_missing")
    frame = local_frame(crs, given.xyz[len(given) // 2])
    centre, to_local = frame.geocentric
    turned = given if apart is None else _at_times_of(_table(apart, "attitudes"), given)
    boresight = rotation_from_vector(np.radians(_three(section, "boresight_deg")))
    R = boresight @ rotations_in(turned, frame) @ to_local
    P = frame.local_from_crs(given.xyz) @ to_local + centre
    time, turned_time = cast("Array", given.time), cast("Array", turned.time)
    path = Path3d(
        position_times=time,
        positions=P,
        attitude_times=turned_time,
        quaternions=_quaternions(np.swapaxes(R, 1, 2)),
    )
    lever = _three(section, "lever_arm_m")
    # far beyond the attitudes a lever arm is that of their ends; the lines do not reach there
    back = path.rotation(np.clip(time, turned_time[0], turned_time[-1]))[0] if apart is not None else R.swapaxes(1, 2)
    trajectory = replace(path, positions=P - back @ lever)
    return trajectory, (_usual(given.sigma), _usual(turned.rotation_sigma))


def _at_times_of(attitudes: Trajectory, positions: Trajectory) -> Trajectory:
    """Attitudes of a table of their own with the places, to some metres, where they hold: north differs there."""
    time, known = cast("Array", attitudes.time), cast("Array", positions.time)
    xyz = np.stack([np.interp(time, known, column) for column in positions.xyz.T], axis=1)
    return replace(attitudes, xyz=xyz, crs=positions.crs, true_north=attitudes.true_north or positions.crs is not None)


def _usual(sigma: Array | None) -> float | None:
    known = np.zeros(0) if sigma is None else sigma[np.isfinite(sigma) & (sigma > 0)]
    return float(np.median(known)) if len(known) else None


def _three(section: Section, key: str) -> Array:
    value = section.values.get(key, [0.0, 0.0, 0.0])
    if not isinstance(value, list) or len(cast("list[Any]", value)) != 3:
        section.fail(key, "value.count", n=len(cast("list[Any]", value)) if isinstance(value, list) else 1, needed=3)
    return np.array([section.checked(key, v) for v in cast("list[Any]", value)])


def _table(file: Path, holds: Literal["both", "positions", "attitudes"]) -> Trajectory:
    """Times, positions, rotations of a table of GNSS and INS; raises InputError with line and column."""
    columns = [Column(name="time_s", kind="number"), Column(name="image", kind="text", optional=True, empty=True)]
    if holds != "attitudes":
        columns += [Column(name=n, kind="number", optional=True) for n in (*GRID, *GEOGRAPHIC)]
        columns += [Column(name=n, kind="number", optional=True, empty=True, limit=">= 0") for n in SIGMA]
    choices = [(names, unit) for names in ANGLES for unit in UNITS] if holds != "positions" else []
    for names, unit in choices:
        columns += [Column(name=f"{n}_{unit}", kind="number", optional=True) for n in names]
        columns += [Column(name=f"s{n}_{unit}", kind="number", optional=True, empty=True, limit=">= 0") for n in names]
    table = read_table(file, columns, least_rows=2)
    places = [names for names in (GRID, GEOGRAPHIC) if all(n in table.number for n in names)]
    full = [(names, unit) for names, unit in choices if all(f"{n}_{unit}" in table.number for n in names)]
    if holds != "attitudes" and len(places) != 1:
        raise InputError("table.one_position", grid=list(GRID), geographic=list(GEOGRAPHIC), file=file, line=1)
    if holds != "positions" and len(full) != 1:
        angles = [" ".join(f"{n}_deg" for n in names) for names in ANGLES]
        raise InputError("table.three_angles", choices=angles, file=file, line=1)
    times_in_order(table, file)
    return _given(file, table, places[0] if places else (), full[0] if full else None)


def _given(
    file: Path, table: Table, place: tuple[str, ...], angles: tuple[tuple[str, str, str], str] | None
) -> Trajectory:
    """What the columns `place` and `angles` (names, unit) of a table hold; NaN for positions that it has not."""
    geographic = place == GEOGRAPHIC
    unknown = np.full((table.rows, 3), np.nan)
    rotation = rotation_sigma = None
    if angles is not None:
        names, unit = angles
        rotation = ANGLES[names](table.numbers(*(f"{n}_{unit}" for n in names)) * UNITS[unit])
        rotation_sigma = table.numbers(*(f"s{n}_{unit}" for n in names)) * UNITS[unit]
    return Trajectory(
        path=file,
        names=tuple(str(k + 1) for k in range(table.rows)),
        xyz=table.numbers(*place) if place else unknown,
        sigma=table.numbers(*SIGMA) if place else unknown,
        crs=WGS84_HEIGHT if geographic else None,
        rotation=rotation,
        rotation_sigma=rotation_sigma,
        true_north=geographic or (angles is not None and angles[0][0] == "roll"),
        time=table.number["time_s"],
    )


def _quaternions(R: Array) -> Array:
    from scipy.spatial.transform import Rotation

    return Rotation.from_matrix(R).as_quat()


def _recognises(path: Path, head: bytes) -> bool:
    return path.suffix.lower() == ".toml" and b"scanner" in head


register(
    SceneFormat(
        name="airborne", title="TOML of an aerial line scanner with GNSS/INS", recognises=_recognises, read=read,
        companions=companions,
    )
)  # fmt: skip
