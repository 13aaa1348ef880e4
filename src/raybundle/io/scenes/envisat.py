"""Envisat ASAR and ERS SAR in the format of Envisat (.N1, .E1, .E2): images in slant range (S), ground range (P, M).

Envisat-1 Products Specifications, volume 8 (PO-RS-MDA-GS-2009), and the ASAR Product Handbook, 6.6: a main and a
specific header in lines NAME=value; data set descriptors in the second place the annotation.  Times are days, seconds,
microseconds from 2000 on; state vectors stand in the frame that turns with the earth, in cm and 10 um/s.  Samples and
lines count from 1 at centres.  Images are focused to zero Doppler, so that the Doppler centroids are not needed.  The
geolocation grid lies at the average height of the scene, which files of older processors state as 0.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, note
from raybundle.io.reading.words import no_number, quoted, whole_of
from raybundle.io.scenes.base import Scene, SceneFormat, register
from raybundle.io.scenes.radar_tables import Columns, ground_columns, rounded_jointly, tied
from raybundle.io.scenes.records import Record
from raybundle.numerics.arrays import Array
from raybundle.scenes.kinds.range_doppler import C_LIGHT
from raybundle.scenes.orbit import Orbit

MAIN_BYTES = 1247
KINDS = ("IMS", "IMP", "IMM", "APS", "APP", "APM", "WSM", "GM1")
SWATHS = 5
"""Of wide swath; in slant range (WSS) each is an image"""
MAPS = ("IMG", "APG")
EPOCH = np.datetime64("2000-01-01", "ns")
DAYS, RECORDS = 50_000, 10_000
"""Times lie within so many days of 2000; no data set of the annotation has more records."""
VECTORS, GRID = 5, 11
"""State vectors of a record, tie points of a line"""
MAIN, SLANT_GROUND, LOCATION = "MAIN PROCESSING PARAMS ADS", "SR GR ADS", "GEOLOCATION GRID ADS"
SETTLED = 2.0
"""By how many lines the times may differ from what their interval makes of them"""


def read(path: Path) -> Scene:
    """The scene of a product; raises InputError with record and byte where its fields contradict each other."""
    head = Record.at(path, "MPH", 0, MAIN_BYTES)
    product = _text(head, "PRODUCT")
    _check_kind(head, product)
    size = _count(head, "SPH_SIZE")
    specific = Record.at(path, "SPH", MAIN_BYTES, size)
    (main, *_) = _records(specific, MAIN)
    grid = _records(specific, LOCATION)
    first, last = _time(main, 1), _time(main, 14)
    columns, rows = (main.counted(byte, main.values(byte, "I")[0]) for byte in (61, 57))
    lasting = _seconds(last, first)
    (interval,) = main.values(53, "f")
    if not abs(abs(lasting) - interval * (rows - 1)) <= SETTLED * interval:
        main.fail(53, "scene.line_order", seconds=lasting)
    (height,) = main.values(1542, "f")
    near, step = _near(grid[0])
    ranges = _ranges(specific, main, first, near, columns)
    scene = ranges.scene(
        (columns, rows), _orbit(main, first), (0.0, lasting / max(rows - 1, 1)), sign=step, side=1.0, height_m=height
    )
    scene, contradicted = tied(scene, *_ties(grid, height))
    return Scene(
        file=path, format="envisat", width_px=columns, height_px=rows, rigorous=scene, sensor=product[:10],
        time=f"{first.astype('datetime64[us]')}", remarks=(note("scene.radar_delays"), *contradicted),
    )  # fmt: skip


def _check_kind(head: Record, product: str) -> None:
    """Refuse raw data, maps, and images that are not in one piece."""
    kind, level = product[4:7], product[8:9]
    byte = head.data.find(b"PRODUCT=") + 1
    if level == "0":
        head.fail(byte, "scene.raw_product", kind=product[:10])
    if kind in MAPS:
        head.fail(byte, "scene.map_product", kind=kind)
    if kind == "WSS":
        head.fail(byte, "scene.burst_images", n=SWATHS)
    if kind not in KINDS or level != "1":
        head.fail(byte, "value.not_supported", value=quoted(product[:10]), known=list(KINDS))


def _text(header: Record, name: str, start: int = 0) -> str:
    """The value of a line of a header, without its quotes and its unit."""
    found = re.compile(rb'(?:^|\n)%s="?([^"\n<]*)' % name.encode()).search(header.data, start)
    if found is None:
        header.fail(start + 1, "scene.record_missing", name=name)
    return found[1].decode("latin-1").strip()


def _count(header: Record, name: str, start: int = 0) -> int:
    word = _text(header, name, start)
    value = whole_of(word.lstrip("+0") or "0")
    if value is None or value < 0:
        header.fail(header.data.find(f"{name}=".encode(), start) + 1, no_number(word))
    return value


def _records(header: Record, name: str) -> list[Record]:
    """The records of a data set by its descriptor."""
    start = header.data.find(f'DS_NAME="{name} '.encode())
    if start < 0:
        header.fail(1, "scene.record_missing", name=name)
    first, n, size = (_count(header, key, start) for key in ("DS_OFFSET", "NUM_DSR", "DSR_SIZE"))
    if not n:
        header.fail(start + 1, "scene.record_missing", name=name)
    if n > RECORDS:
        header.fail(start + 1, "value.too_large", value=str(n), largest=RECORDS)
    whole = Record.at(header.path, name, first, n * size)
    return [Record(header.path, f"{name} {k + 1}", whole.data[k * size : (k + 1) * size]) for k in range(n)]


def _time(record: Record, byte: int) -> np.datetime64:
    days, seconds, micro = (int(v) for v in record.values(byte, "iII"))
    if abs(days) > DAYS or seconds > 86400 or micro >= 1_000_000:
        record.fail(byte, "value.no_time", value=f"{days} d {seconds} s {micro} us")
    return EPOCH + np.timedelta64((days * 86400 + seconds) * 1_000_000 + micro, "us")


def _seconds(time: np.datetime64, epoch: np.datetime64) -> float:
    return float((time - epoch) / np.timedelta64(1, "us")) * 1e-6


def _orbit(main: Record, epoch: np.datetime64) -> Orbit:
    starts = [1766 + 36 * k for k in range(VECTORS)]
    table = np.array([main.values(s + 12, "6i") for s in starts])
    times = np.array([_seconds(_time(main, s), epoch) for s in starts])
    try:
        return Orbit(
            times=times, positions=table[:, :3] * 1e-2, velocities=table[:, 3:] * 1e-5, joint=rounded_jointly(times)
        ).fitted()
    except InputError as error:
        raise error.at(main.path, column=f"{main.name}, byte 1766") from None


def _near(line: Record) -> tuple[tuple[float, float], float]:
    """Sample and slant range of the nearest tie point of a line; 1 where samples run away from the radar, else -1."""
    samples, ns = np.array(line.values(26, f"{GRID}I")), np.array(line.values(70, f"{GRID}f"))
    step = np.sign(np.diff(samples)) * np.sign(np.diff(ns))
    if not (abs(step.sum()) == GRID - 1 and ns.min() > 0):
        line.fail(70, "line_scene.times_not_monotonic")
    k = int(ns.argmin())
    return (float(samples[k]), C_LIGHT / 2 * 1e-9 * float(ns[k])), float(step[0])


def _ranges(specific: Record, main: Record, epoch: np.datetime64, near: tuple[float, float], columns: int) -> Columns:
    """Slant ranges, or the polynomials of ground range."""
    if not main.values(124, "B")[0]:
        (rate,) = main.values(984, "f")
        if not rate > 0:
            main.fail(984, "value.zero")
        spacing, (sample, range_m) = C_LIGHT / 2 / rate, near
        return Columns.slant(spacing, range_m - min(sample - 1, columns - sample) * spacing)
    (spacing,) = main.values(45, "f")
    entries: list[tuple[float, float, Array]] = []
    for record in _records(specific, SLANT_GROUND):
        origin, *coefficients = record.values(18, "6f")
        entries.append((_seconds(_time(record, 1), epoch), origin, np.array(coefficients)))
    return ground_columns(spacing, entries)


def _ties(grid: list[Record], height: float) -> tuple[Array, Array]:
    """Longitude, latitude, height (n, 3) and image points (n, 2): first lines of all granules, last one of the last."""
    ground: list[Array] = []
    image: list[Array] = []
    for record, start in [*((g, 26) for g in grid), (grid[-1], 280)]:
        line, n = record.values(14, "II")
        line += n - 1 if start == 280 else 0
        samples = np.array(record.values(start, f"{GRID}I"))
        latitude, longitude = (np.array(record.values(start + b, f"{GRID}i")) * 1e-6 for b in (132, 176))
        ground.append(np.stack([longitude, latitude, np.full(GRID, height)], axis=1))
        image.append(np.stack([samples, np.full(GRID, line)], axis=1) - 0.5)
    return np.concatenate(ground), np.concatenate(image)


def _recognises(path: Path, head: bytes) -> bool:
    del path
    return head.startswith((b'PRODUCT="ASA_', b'PRODUCT="SAR_'))


register(
    SceneFormat(
        name="envisat", title="Envisat and ERS N1, E1, E2 (IM, AP, WSM, GM1)", recognises=_recognises,
        read=read, within="*.[NE][12]",
    )
)  # fmt: skip
