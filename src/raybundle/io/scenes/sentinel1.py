"""Sentinel-1: the annotation of a swath (XML), alone or in its SAFE folder; SLC with and without bursts, and GRD.

Pixels and lines of the file count from 0 at centres.  Orbits stand in the frame that turns with the earth, images are
focused to zero Doppler.  Delays of atmosphere and tides are in none of the tables.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.errors import Message, note
from raybundle.io.reading.xml import Element, read_xml
from raybundle.io.scenes.base import Scene, SceneFormat, element_text, register
from raybundle.io.scenes.radar_tables import instant, seconds
from raybundle.numerics.arrays import Array
from raybundle.scenes.kinds.range_doppler import C_LIGHT, RangeDoppler
from raybundle.scenes.orbit import Orbit

SIZES = ("numberOfSamples", "numberOfLines")


def read(path: Path) -> Scene:
    """The scene of an annotation file; raises InputError where its tables contradict each other."""
    root = read_xml(path, "product")
    image = root.get("imageAnnotation", "imageInformation")
    columns, rows = (int(image.number(k)) for k in SIZES)
    epoch = instant(image.get("productFirstLineUtcTime"))
    vectors = list(root.get("generalAnnotation", "orbitList").all("orbit"))
    orbit = Orbit(
        times=np.array([seconds(v.get("time"), epoch) for v in vectors]),
        positions=np.array([[v.get("position").number(k) for k in "xyz"] for v in vectors]).reshape(-1, 3),
        velocities=np.array([[v.get("velocity").number(k) for k in "xyz"] for v in vectors]).reshape(-1, 3),
    ).fitted()
    step = image.number("azimuthTimeInterval")
    burst_y, burst_times = _bursts(root, rows, epoch)
    spacing, first, range_times, coefficients = _ranges(root, image, epoch)
    heights = [p.number("height") for p in root.get("geolocationGrid", "geolocationGridPointList").children]
    remarks: list[Message] = [note("scene.radar_delays")]
    if len(burst_y) > 1:
        remarks.append(note("scene.bursts", n=len(burst_y)))
    head = root.get("adsHeader")
    return Scene(
        file=path, format="sentinel1", width_px=columns, height_px=rows, time=element_text(head, "startTime"),
        sensor=" ".join(element_text(head, k) for k in ("missionId", "swath", "productType", "polarisation")),
        remarks=tuple(remarks),
        rigorous=RangeDoppler(
            width_px=columns, height_px=rows, orbit=orbit, burst_y=burst_y, burst_times=burst_times - step / 2,
            line_s=step, pixel_m=spacing, first_m=first - spacing / 2, range_times=range_times,
            range_coefficients=coefficients, range_steps=True,
            height_m=round(float(np.mean(heights)), 1) if heights else 0.0,
        ),
    )  # fmt: skip


def _bursts(root: Element, rows: int, epoch: np.datetime64) -> tuple[Array, Array]:
    """First lines of the bursts [px], and the times of their centres [s]; one for an image in one piece."""
    timing = root.get("swathTiming")
    bursts = list(timing.get("burstList").all("burst"))
    if not bursts:
        return np.zeros(1), np.zeros(1)
    lines = int(timing.number("linesPerBurst"))
    if lines * len(bursts) != rows:
        timing.get("linesPerBurst").fail("scene.burst_lines", n=len(bursts), lines=lines, rows=rows)
    return lines * np.arange(float(len(bursts))), np.array([seconds(b.get("azimuthTime"), epoch) for b in bursts])


def _ranges(root: Element, image: Element, epoch: np.datetime64) -> tuple[float, float, Array, Array]:
    """Range from column to column and at the centre of the first [m]; times and coefficients of slant ranges by it."""
    product = root.get("generalAnnotation", "productInformation")
    if element_text(product, "projection") == "Slant Range":
        first = C_LIGHT / 2 * image.number("slantRangeTime")
        return C_LIGHT / 2 / product.number("rangeSamplingRate"), first, np.zeros(1), np.array([[0.0, 1.0]])
    found = list(root.get("coordinateConversion", "coordinateConversionList").all("coordinateConversion"))
    if not found:
        root.get("coordinateConversion").fail("scene.no_ground_range")
    origins = np.array([c.number("gr0") for c in found])
    if np.ptp(origins) > 0:
        found[0].get("gr0").fail("scene.ground_range_origins")
    rows = [c.get("grsrCoefficients") for c in found]
    coefficients = np.array([r.numbers(len(rows[0].content.split())) for r in rows])
    times = np.array([seconds(c.get("azimuthTime"), epoch) for c in found])
    return image.number("rangePixelSpacing"), -float(origins[0]), times, coefficients


def _recognises(path: Path, head: bytes) -> bool:
    del path
    return b"<product" in head and b"<adsHeader" in head and b"<missionId>S1" in head


register(
    SceneFormat(
        name="sentinel1", title="Sentinel-1 annotation XML (SLC, GRD)", recognises=_recognises, read=read,
        within="annotation/s1*.xml",
    )
)  # fmt: skip
