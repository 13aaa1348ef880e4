"""ERS-1 and ERS-2 in CEOS format: the leader file (LEA_01.001) of an image in slant range (SLC) or ground range (PRI).

ESA ER-IS-EPO-GS-5902: records with four type codes and a length in front; fields in characters.  Lines and pixels come
from the descriptor of the data file (DAT_01.001), where that lies beside, else from the map projection record.  Images
are focused to zero Doppler, so that the Doppler centroids are not needed.  Times of lines are rounded to milliseconds,
a line and a half; where the first and the last state vector lie within a millisecond of the first and the last line, as
the PGS processor writes, they are the times.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, Message, note
from raybundle.io.reading.files import read_bytes
from raybundle.io.reading.words import quoted
from raybundle.io.scenes.base import Scene, SceneFormat, register
from raybundle.io.scenes.radar_tables import EXTENT, Columns, ground_columns, rounded_jointly, tied
from raybundle.io.scenes.records import RECORD_BYTES, Record
from raybundle.numerics.arrays import Array
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.scenes.kinds.range_doppler import C_LIGHT
from raybundle.scenes.orbit import LEAST, Orbit

FILE_DESCRIPTOR = b"\xc0\x12\x12"
"""Type codes of the first record of a CEOS file, from byte 6"""
HEAD, DESCRIPTOR_BYTES = 12, 720
SUMMARY, PROJECTION, PLATFORM, DETAILED, FACILITY = 10, 20, 30, 120, 200
NAMES = {SUMMARY: "DATA SET SUMMARY", PROJECTION: "MAP PROJECTION DATA", PLATFORM: "PLATFORM POSITION DATA",
         DETAILED: "DETAILED PROCESSING PARAMETERS", FACILITY: "FACILITY RELATED DATA"}  # fmt: skip
"""Records of a leader by the second of their type codes"""
MONTHS = ("JAN", "FEB", "MAR", "APR", "MAY", "JUN", "JUL", "AUG", "SEP", "OCT", "NOV", "DEC")
ROUNDED_S = 1e-3
"""The last digit of a time, which may be rounded or cut"""
OMEGA = 7.2921151467e-5
"""Rotation of the earth [rad/s]"""
FAST = 1e5
"""Velocities from here on are mm/s, as RADARSAT-1 has them"""
VECTORS = 500
"""More state vectors has no record."""


def read(path: Path) -> Scene:
    """The scene of a leader; raises InputError with record and byte where its fields contradict each other."""
    found = records_of(path)
    summary, platform = (record_of(found, code, path) for code in (SUMMARY, PLATFORM))
    mission, product = summary.text(397, 412), summary.text(1111, 1142)
    if not mission.startswith("ERS"):
        summary.fail(397, "value.not_supported", value=quoted(mission), known=["ERS1", "ERS2", "RSAT-1"])
    if "RAW" in product.upper():
        summary.fail(1111, "scene.raw_product", kind=product)
    projection = record_of(found, PROJECTION, path)
    geometry = projection.text(29, 60).upper()
    if not geometry.startswith(("SLANT", "GROUND")):
        projection.fail(29, "scene.map_product", kind=projection.text(29, 60) or "?")
    columns, rows = _size(path, projection)
    first, last = (_time(summary, byte) for byte in (1815, 1863))
    orbit = platform_orbit(platform, first)
    first_s, line_s, rounded = _lines(summary, orbit, (last - first) / np.timedelta64(1, "ns") * 1e-9, rows)
    ranges, sign = _ranges(summary, projection, found, columns, slant=geometry.startswith("SLANT"))
    side = -1.0 if summary.number(477, 484) < 0 else 1.0
    scene = ranges.scene((columns, rows), orbit, (first_s, line_s), sign=sign, side=side, height_m=0.0)
    corners = np.array([projection.number(b, b + 15) for b in range(1073, 1200, 16)]).reshape(4, 2)
    image = [[0.5, 0.5], [columns - 0.5, 0.5], [columns - 0.5, rows - 0.5], [0.5, rows - 0.5]]
    limit = 2 * max(1.0, ROUNDED_S / abs(line_s))
    scene, contradicted = tied(scene, np.insert(corners[:, ::-1], 2, 0.0, axis=1), np.array(image), limit)
    return Scene(
        file=path, format="ceos", width_px=columns, height_px=rows, rigorous=scene, time=summary.text(1815, 1838),
        sensor=f"{mission} {product}", remarks=(note("scene.radar_delays"), *rounded, *contradicted),
    )  # fmt: skip


def records_of(path: Path) -> dict[int, Record]:
    """The first record of each kind in a leader or a trailer."""
    data, at = read_bytes(path, RECORD_BYTES), 0
    found: dict[int, Record] = {}
    while data[at:].strip(b"\0 "):
        code = data[at + 5] if at + HEAD <= len(data) else 0
        size = int.from_bytes(data[at + 8 : at + HEAD], "big")
        name = NAMES.get(code, f"record {len(found) + 1}")
        if size < HEAD or at + size > len(data):
            raise InputError("binary.ends_in_record", byte=len(data), file=path, column=f"{name}, byte {at + 1}")
        found.setdefault(code, Record(path, name, data[at : at + size]))
        at += size
    return found


def record_of(found: dict[int, Record], code: int, path: Path) -> Record:
    """The record of this code; raises InputError where there is none."""
    if code not in found:
        raise InputError("scene.record_missing", name=NAMES[code], file=path)
    return found[code]


def data_file(path: Path) -> Record | None:
    """The descriptor of the data file beside a leader; None where there is none, or an empty one."""
    beside = path.with_name(re.sub("(?i)^LEA", lambda m: "DAT" if m[0].isupper() else "dat", path.name))
    if beside == path or not beside.is_file() or not beside.stat().st_size:
        return None
    return Record.at(beside, "DATA FILE DESCRIPTOR", 0, DESCRIPTOR_BYTES)


def _size(path: Path, projection: Record) -> tuple[int, int]:
    data = data_file(path)
    if data is None:
        return projection.pixels(61, 76), projection.pixels(77, 92)
    return data.pixels(249, 256), data.pixels(237, 244)


def _companions(path: Path) -> tuple[Path, ...]:
    """The data file, where the leader has another size."""
    data = data_file(path)
    if data is None:
        return ()
    projection = record_of(records_of(path), PROJECTION, path)
    stated = (projection.text(61, 76), projection.text(77, 92))
    return () if stated == (data.text(249, 256), data.text(237, 244)) else (data.path,)


def _time(record: Record, byte: int) -> np.datetime64:
    word = record.text(byte, byte + 23)
    parts = re.fullmatch(r"(\d\d?)-([A-Z]{3})-(\d{4}) +(\d\d:\d\d:\d\d(?:\.\d+)?)", word.upper())
    try:
        if parts is not None and parts[2] in MONTHS:
            month = MONTHS.index(parts[2]) + 1
            return np.datetime64(f"{parts[3]}-{month:02}-{parts[1]:0>2}T{parts[4]}", "ns")
    except ValueError:
        pass
    return record.fail(byte, "value.no_time", value=quoted(word))


def platform_orbit(platform: Record, epoch: np.datetime64) -> Orbit:
    """State vectors, brought to the frame that turns with the earth where they stand in an inertial one."""
    n = int(platform.number(141, 144))
    if not LEAST <= n <= VECTORS:
        platform.fail(141, "scene.position_count", n=n, least=LEAST)
    year, month, day = (int(platform.number(b, b + 3)) for b in (145, 149, 153))
    try:
        date = np.datetime64(f"{year + (1900 if year < 100 else 0):04}-{month:02}-{day:02}", "ns")
    except ValueError:
        platform.fail(145, "value.no_time", value=quoted(platform.text(145, 156)))
    start = float((date - epoch) / np.timedelta64(1, "ns")) * 1e-9 + platform.number(161, 182)
    times = start + platform.number(183, 204) * np.arange(n)
    table = np.array([platform.number(387 + 22 * k, 408 + 22 * k) for k in range(6 * n)]).reshape(n, 6)
    P, V = table[:, :3], table[:, 3:]
    V = V * (1e-3 if np.abs(V).max() > FAST else 1.0)
    frame, joint = platform.text(205, 268).upper(), rounded_jointly(times)
    try:
        if "INERTIAL" in frame:
            turned = np.radians(platform.number(269, 290)) + OMEGA * (times - times[0])
            axes = np.stack([rotation_from_vector(np.array([0.0, 0.0, -a])) for a in turned])
            return Orbit.of_inertial(times, P, V, axes, np.tile([0.0, 0.0, OMEGA], (n, 1)), joint=joint).fitted()
        if "ROTATING" in frame or "FIXED" in frame:
            return Orbit(times=times, positions=P, velocities=V, joint=joint).fitted()
    except InputError as error:
        raise error.at(platform.path, column=f"{platform.name}, byte 387") from None
    return platform.fail(205, "value.not_supported", value=quoted(frame), known=["rotating", "fixed", "inertial"])


def _lines(summary: Record, orbit: Orbit, lasting: float, rows: int) -> tuple[float, float, tuple[Message, ...]]:
    """Time of the first line, from line to line, and a note where they are rounded."""
    prf = summary.number(935, 950)
    if not abs(lasting) >= ROUNDED_S:
        summary.fail(1863, "scene.line_order", seconds=lasting)
    ends = orbit.times[[0, -1]] if lasting > 0 else orbit.times[[-1, 0]]
    if np.abs(ends - [0.0, lasting]).max() <= ROUNDED_S:
        return float(ends[0]), float(ends[1] - ends[0]) / max(rows - 1, 1), ()
    line_s = lasting / max(rows - 1, 1)
    if abs(abs(lasting) * prf - (rows - 1)) <= ROUNDED_S * prf:
        line_s = np.sign(lasting) / prf
    return 0.0, float(line_s), (note("scene.times_rounded", seconds=ROUNDED_S, n_px=ROUNDED_S / abs(float(line_s))),)


def _ranges(
    summary: Record, projection: Record, found: dict[int, Record], columns: int, *, slant: bool
) -> tuple[Columns, float]:
    """Slant ranges of an SLC, or by the polynomial of ground range; 1 where the first column is the nearest, else -1.

    The polynomial takes metres on the ground to slant range, in metres (PGS) or in samples from the nearest one (VMP);
    ranges of the middle and the last column show which.
    """
    times = [summary.number(b, b + 15) * 1e-3 for b in (1767, 1783, 1799)]
    sign, rate = float(np.sign(times[2] - times[0])), summary.number(711, 726) * 1e6
    if not (sign and min(times) > 0):
        summary.fail(1767, "line_scene.times_not_monotonic")
    if not rate > 0:
        summary.fail(711, "value.zero")
    near, middle, far = C_LIGHT / 2 * np.array(sorted(times))
    sample = C_LIGHT / 2 / rate
    if slant:
        choices: list[tuple[float, Array]] = [(sample, np.array([near, 1.0]))]
    else:
        facility = record_of(found, FACILITY, projection.path)
        c = np.array([facility.number(b, b + 19) for b in (1855, 1875, 1895, 1915)])
        spacing = projection.number(93, 108)
        choices = [(spacing, c), (spacing, sample * c + [near, 0.0, 0.0, 0.0])]
    span = (columns - 1) * np.array([0.0, 0.5, 1.0])
    reached = [np.polynomial.Polynomial(c)(s * span) for s, c in choices]
    off = [float(np.abs(r - [near, middle, far]).max()) for r in reached]
    k = int(np.argmin(off))
    if not off[k] <= EXTENT * (far - near):
        summary.fail(1799, "scene.range_extent", reached_m=float(reached[k][-1]), stated_m=float(far))
    spacing, c = choices[k]
    return (Columns.slant(spacing, float(near)) if slant else ground_columns(spacing, [(0.0, 0.0, c)])), sign


def is_leader(head: bytes) -> bool:
    """Whether a CEOS file begins as a leader of a radar: a data set summary follows its descriptor."""
    return head[5:8] == FILE_DESCRIPTOR and head[DESCRIPTOR_BYTES + 5 : DESCRIPTOR_BYTES + 6] == bytes([SUMMARY])


def of_radarsat(head: bytes) -> bool:
    """Whether the data set summary of a leader is one of RADARSAT-1."""
    return head[DESCRIPTOR_BYTES + 396 :].startswith(b"RSAT")


register(
    SceneFormat(
        name="ceos", title="CEOS leader of ERS (SLC, PRI)", read=read,
        recognises=lambda _, head: is_leader(head) and not of_radarsat(head), within="[Ll][Ee][Aa]_*",
        companions=_companions,
    )
)  # fmt: skip
