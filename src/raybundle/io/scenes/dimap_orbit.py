"""The rigorous model in DIMAP 2 product files (DIM_*.XML) of Pleiades, Pleiades Neo and SPOT 6/7.

Geometric_Data/Refined_Model holds positions in the frame that turns with the earth, the attitude as polynomials of
the quaternion's four elements (Pleiades 1A, 1B) or as a table, and the viewing directions as polynomials of the column.
The quaternion has its scalar first and turns detector to geocentric axes; an element looks along (Y, -X, 1), with X and
Y the values of XLOS and YLOS at its column.  Rows and columns count from 1, START is the time of row 1.  Refraction and
aberration are applied where the Geometric_Settings say so.

Written from the description of the format.  Positions, attitudes, their times, the axes and refraction were held
against the RPC of one Pleiades Neo scene whose viewing directions were not at hand: as straight lines over the columns
they fit it within 0.02 px at heights from 0 to 2000 m.  Aberration cannot be distinguished from YLOS_0 in this way.
"""

from __future__ import annotations

from datetime import datetime

import numpy as np

from raybundle.errors import Message, note
from raybundle.io.reading.words import quoted
from raybundle.io.reading.xml import Element
from raybundle.io.scenes.base import element_text, numbers_of
from raybundle.numerics.arrays import Array
from raybundle.scenes.linescan import LineScene
from raybundle.scenes.scan import EPOCH
from raybundle.scenes.trajectory import Trajectory

ORBIT_M = (6.5e6, 5.0e7)
"""Geocentric distances that an orbit can have."""
SECONDS = {"": 1e-3, "ms": 1e-3, "millisecond": 1e-3, "us": 1e-6, "microsecond": 1e-6, "s": 1.0, "second": 1.0}
"""Units of the line period; without one it is in milliseconds."""
DAY_S = 86_400.0
STEP_S = 0.01
"""Interval at which polynomial attitudes are tabulated."""
MARGIN_S = 0.5
"""How far beyond the image."""


def line_scene(root: Element) -> tuple[LineScene, tuple[Message, ...]]:
    """The scene of a product file, and what was assumed; raises InputError with the line of what is missing."""
    refined = root.get("Geometric_Data", "Refined_Model")
    size = root.get("Raster_Data", "Raster_Dimensions")
    columns, rows = (_whole(size, k) for k in ("NCOLS", "NROWS"))
    time = refined.get("Time")
    start = _time(time.get("Time_Range", "START"))
    stamp = time.get("Time_Stamp", "LINE_PERIOD")
    unit = stamp.attributes.get("unit", "").lower()
    if unit not in SECONDS:
        stamp.fail("value.unit_unknown", unit=quoted(unit), known=[u for u in SECONDS if u])
    period = float(stamp.numbers(1)[0]) * SECONDS[unit]
    if not period > 0:
        stamp.fail("value.not_above", value=period, limit=0)
    position_times, positions = _ephemeris(refined.get("Ephemeris", "Point_List"), start)
    attitude_times, quaternions = _attitudes(refined.get("Attitudes"), start, rows * period)
    x, look, remarks = _look(refined.get("Geometric_Calibration"), columns)
    refraction, aberration = (_setting(root, k) for k in ("ATMOSPHERIC_REFRACTION_SETTING", "LIGHT_SPEED_SETTING"))
    corrections = note("dimap.corrections", refraction=refraction, aberration=aberration)
    return LineScene(
        epoch_s=(start - EPOCH).total_seconds(),
        width_px=columns,
        height_px=rows,
        line_y=np.array([0.5, rows + 0.5]),
        line_times=np.array([0.0, rows * period]),
        detector_x=x,
        detector_look=look,
        trajectory=Trajectory(
            position_times=position_times,
            positions=positions,
            attitude_times=attitude_times,
            quaternions=quaternions,
        ),
        aberration=aberration,
        refraction=refraction,
    ), (*remarks, corrections)


def _setting(root: Element, name: str) -> bool:
    """Whether a geometric setting is on; it is not where the file does not show."""
    settings = root.find("Processing_Information", "Product_Settings", "Geometric_Settings")
    return settings is not None and element_text(settings, name).lower() == "true"


def _whole(group: Element, name: str) -> int:
    value = group.number(name)
    if value != int(value) or not 1 <= value <= 10_000_000:
        group.get(name).fail("scene.pixel_count", value=value)
    return int(value)


def _time(element: Element) -> datetime:
    text = element.content.strip()
    try:
        return datetime.fromisoformat(text).replace(tzinfo=None)
    except ValueError:
        element.fail("value.no_time", value=quoted(text))


def _seconds(element: Element, start: datetime) -> float:
    return (_time(element) - start).total_seconds()


def _ephemeris(group: Element, start: datetime) -> tuple[Array, Array]:
    """Seconds after the first line (n,) and positions (n, 3) [m]."""
    points = list(group.all("Point"))
    if len(points) < 4:
        group.fail("scene.position_count", n=len(points), least=4)
    times = np.array([_seconds(p.get("TIME"), start) for p in points])
    P = np.array([p.get("LOCATION_XYZ").numbers(3) for p in points])
    radius = np.linalg.norm(P, axis=1)
    bad = np.flatnonzero((radius < ORBIT_M[0]) | (radius > ORBIT_M[1]))
    if len(bad):
        points[int(bad[0])].fail("scene.not_an_orbit", distance_m=radius[bad[0]], least_m=ORBIT_M[0], most_m=ORBIT_M[1])
    return times, P


def _attitudes(group: Element, start: datetime, duration: float) -> tuple[Array, Array]:
    """Seconds after the first line (n,) and quaternions (n, 4), the scalar last."""
    table = group.find("Quaternion_List")
    if table is not None:
        entries = list(table.all("Quaternion"))
        if len(entries) < 4:
            table.fail("scene.attitude_count", n=len(entries), least=4)
        times = np.array([_seconds(q.get("TIME"), start) for q in entries])
        return times, np.array([[q.number(k) for k in ("Q1", "Q2", "Q3", "Q0")] for q in entries])
    polynomials = group.find("Polynomial_Quaternions")
    if polynomials is None:
        group.fail("dimap.no_attitude")
    midnight = start.replace(hour=0, minute=0, second=0, microsecond=0)
    offset = polynomials.number("OFFSET") - (start - midnight).total_seconds()
    offset -= DAY_S * np.round(offset / DAY_S)  # the day may have ended meanwhile
    scale = polynomials.number("SCALE")
    if scale == 0:
        polynomials.get("SCALE").fail("value.zero")
    times = np.arange(-MARGIN_S, duration + MARGIN_S + STEP_S, STEP_S)
    q = [
        np.polynomial.polynomial.polyval((times - offset) / scale, numbers_of(polynomials.get(k, "COEFFICIENTS")))
        for k in ("Q1", "Q2", "Q3", "Q0")
    ]
    return times, np.stack(q, axis=1)


def _look(group: Element, columns: int) -> tuple[Array, Array, tuple[Message, ...]]:
    """Elements x [px], the tangents of their viewing directions, and what was assumed."""
    bands = list(group.all("Instrument_Calibration"))
    if not bands:
        group.fail("scene.no_look_angles", element="Instrument_Calibration")
    polynomial = bands[0].find("Polynomial_Look_Angles")
    if polynomial is None:
        bands[0].fail("scene.no_look_angles", element="Polynomial_Look_Angles")
    first = bands[0].find("Swath_Range")
    begin = 1.0 if first is None else first.number("FIRST_COL", 1.0)
    along, across = (_coefficients(polynomial, name) for name in ("YLOS", "XLOS"))
    x = np.linspace(0.0, float(columns), 2 if max(len(along), len(across)) <= 2 else 257)
    column = x - 0.5 + begin - 1  # from the first one of the detector
    value = [np.polynomial.polynomial.polyval(column, c) for c in (along, -across)]
    remarks: list[Message] = []
    if len(bands) > 1:
        name = element_text(bands[0], "BAND_ID") or "1"
        remarks.append(note("scene.one_band", n=len(bands), band=name))
    return x, np.stack(value, axis=1), tuple(remarks)


def _coefficients(group: Element, name: str) -> Array:
    """NAME_0, NAME_1 ... as far as they go."""
    found = [group.number(f"{name}_0")]
    while group.find(f"{name}_{len(found)}") is not None:
        found.append(group.number(f"{name}_{len(found)}"))
    return np.array(found)
