"""RADARSAT-1 in CEOS format of CDPF: the leader (LEA_01.001) with its data file, ground range (SGF, SGX, ScanSAR).

CDPF RZ-SP-50-5313: polynomials of slant range stand in the record of detailed processing parameters, times, slant
ranges and geographic coordinates of each line before its pixels.  Times are whole milliseconds, through which a
straight line runs.  State vectors stand in an inertial frame, velocities in mm/s.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, note
from raybundle.io.reading.words import quoted, whole_of
from raybundle.io.scenes.base import Scene, SceneFormat, register
from raybundle.io.scenes.ceos import (
    DESCRIPTOR_BYTES,
    DETAILED,
    PLATFORM,
    PROJECTION,
    ROUNDED_S,
    SUMMARY,
    data_file,
    is_leader,
    of_radarsat,
    platform_orbit,
    record_of,
    records_of,
)
from raybundle.io.scenes.radar_tables import EXTENT, Columns, ground_columns, tied
from raybundle.io.scenes.records import Record
from raybundle.numerics.arrays import Array

SETS, SET_BYTES = 20, 117
TERRAIN = (1201, 1264)
"""Heights of the four corners in the map projection record"""
PREFIX_BYTES = 156
"""Of a line up to its geographic coordinates"""
SAMPLED = 64
"""Lines whose times and places are read"""
COMPLEX_BYTES = 4


def read(path: Path) -> Scene:
    """The scene of a leader; raises InputError with record and byte where its fields contradict each other."""
    found = records_of(path)
    trailer = _trailer(path)
    if DETAILED not in found and trailer is not None:
        found |= records_of(trailer)
    summary, platform, detailed = (record_of(found, code, path) for code in (SUMMARY, PLATFORM, DETAILED))
    data = data_file(path)
    if data is None:
        raise InputError("scene.record_missing", name="DATA FILE (DAT_01.001)", file=path)
    map_ = found.get(PROJECTION)
    if map_ is not None and (projection := map_.text(413, 444)):
        map_.fail(413, "scene.map_product", kind=projection)
    if data.number(225, 228) >= COMPLEX_BYTES:
        data.fail(225, "value.not_supported", value=quoted("SLC"), known=["SGF", "SGX", "SCN", "SCW"])
    columns, rows = data.pixels(249, 256), data.pixels(237, 244)
    chosen = np.unique(np.linspace(0, rows - 1, SAMPLED).round().astype(int))
    times, ranges, places = _lines(data, chosen)
    epoch = times[0]
    seconds = (times - epoch) / np.timedelta64(1, "ms") * 1e-3
    line_s, first_s = np.polyfit(chosen, seconds, 1) if rows > 1 else (0.0, 0.0)
    off = np.abs(np.polyval([line_s, first_s], chosen) - seconds).max()
    if not (off <= ROUNDED_S < abs(seconds[-1])):
        data.fail(DESCRIPTOR_BYTES + 45, "scene.line_order", seconds=float(seconds[-1]))
    sign = float(np.sign(ranges[0, 2] - ranges[0, 0])) or 1.0
    known = map_ is not None and map_.text(*TERRAIN)
    height = (
        float(np.mean([map_.number(b, b + 15) for b in range(TERRAIN[0], TERRAIN[1], 16)])) if known and map_ else 0.0
    )
    columns_ = _polynomials(detailed, columns, np.sort(ranges[0])[[0, 2]], epoch)
    scene = columns_.scene(
        (columns, rows), platform_orbit(platform, epoch), (float(first_s), float(line_s)), sign=sign,
        side=-1.0 if summary.number(477, 484) < 0 else 1.0, height_m=height,
    )  # fmt: skip
    across = np.array([0.5, columns / 2, columns - 0.5])
    image = np.stack(np.meshgrid(across, chosen + 0.5), axis=-1).reshape(-1, 2)
    ground = np.insert(places.reshape(-1, 2), 2, height, axis=1)
    scene, contradicted = tied(scene, ground, image, 2 * max(1.0, ROUNDED_S / abs(line_s)))
    rounded = note("scene.times_rounded", seconds=ROUNDED_S, n_px=ROUNDED_S / abs(float(line_s)))
    return Scene(
        file=path, format="radarsat1", width_px=columns, height_px=rows, rigorous=scene, time=f"{epoch}",
        sensor=f"{summary.text(397, 412)} {summary.text(1111, 1142)}".strip(),
        remarks=(note("scene.radar_delays"), rounded, *contradicted),
    )  # fmt: skip


def _lines(data: Record, chosen: Array) -> tuple[Array, Array, Array]:
    """Times (n,), slant ranges of first, middle, last pixel (n, 3) [m], longitude and latitude of these (n, 3, 2)."""
    size = int(Record.at(data.path, "IMAGE LINE 1", DESCRIPTOR_BYTES, 12).values(9, "I")[0])
    times: list[np.datetime64] = []
    rows: list[tuple[float, ...]] = []
    for k in chosen.tolist():
        line = Record.at(data.path, f"IMAGE LINE {k + 1}", DESCRIPTOR_BYTES + k * size, min(size, PREFIX_BYTES))
        year, day, ms = (int(v) for v in line.values(37, "3I"))
        if not (1990 <= year <= 2100 and 1 <= day <= 366 and ms < 86_400_000):
            line.fail(37, "value.no_time", value=f"{year} {day} {ms}")
        times.append(np.datetime64(f"{year}-01-01", "ms") + np.timedelta64((day - 1) * 86_400_000 + ms, "ms"))
        rows.append((*line.values(65, "3I"), *line.values(133, "6i")))
    table = np.array(rows)
    return np.array(times), table[:, :3], 1e-6 * np.stack([table[:, 6:], table[:, 3:6]], axis=2)


def _polynomials(detailed: Record, columns: int, edges: Array, epoch: np.datetime64) -> Columns:
    """Polynomials of ground range, whose ends must meet the slant ranges of the first line."""
    n, spacing = int(detailed.number(4883, 4886)), detailed.number(7227, 7242)
    if not 1 <= n <= SETS:
        detailed.fail(4883, "scene.no_ground_range")
    if not spacing > 0:
        detailed.fail(7227, "value.zero")
    entries: list[tuple[float, float, Array]] = []
    for k in range(n):
        at = 4887 + SET_BYTES * k
        c = np.array([detailed.number(b, b + 15) for b in range(at + 21, at + SET_BYTES, 16)])
        entries.append((float((_update(detailed, at) - epoch) / np.timedelta64(1, "ms")) * 1e-3, 0.0, c))
    reached = np.polynomial.Polynomial(entries[0][2])(np.array([0.0, (columns - 1) * spacing]))
    if not np.abs(reached - edges).max() <= EXTENT * (edges[1] - edges[0]):
        detailed.fail(4908, "scene.range_extent", reached_m=float(reached[1]), stated_m=float(edges[1]))
    return ground_columns(spacing, entries)


def _update(detailed: Record, at: int) -> np.datetime64:
    """The time of a polynomial: YYYY-DDD-hh:mm:ss.sss."""
    word = detailed.text(at, at + 20)
    try:
        year, day, clock = word.split("-")
        n = whole_of(day) or 0
        if 1 <= n <= 366:
            return np.datetime64(f"{year}-01-01T{clock}", "ms") + np.timedelta64(n - 1, "D")
    except ValueError:
        pass
    return detailed.fail(at, "value.no_time", value=quoted(word))


def _trailer(path: Path) -> Path | None:
    """The trailer beside a leader, which holds the parameters in some products."""
    beside = path.with_name(re.sub("(?i)^LEA", lambda m: "TRA" if m[0].isupper() else "tra", path.name))
    return beside if beside != path and beside.is_file() else None


def _companions(path: Path) -> tuple[Path, ...]:
    data = data_file(path)
    return tuple(p for p in (None if data is None else data.path, _trailer(path)) if p is not None)


register(
    SceneFormat(
        name="radarsat1", title="RADARSAT-1 CEOS leader (SGF, SGX, ScanSAR)", read=read, within="[Ll][Ee][Aa]_*",
        recognises=lambda _, head: is_leader(head) and of_radarsat(head), companions=_companions,
    )
)  # fmt: skip
