"""SICD (NGA.STND.0024): the metadata in a NITF, or as XML alone; images by range and zero Doppler (RMA, INCA).

Lines are ranges, columns are times of closest approach.  The orbit is a polynomial of time, here a table of its values,
which the Hermite polynomial through eight of them meets exactly.  Images in the plane of polar formatting (PFA) have no
line of one time, and are refused.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.polynomial import Polynomial

from raybundle.errors import InputError, note
from raybundle.io.reading.files import read_bytes
from raybundle.io.reading.ledger import enter_tree
from raybundle.io.reading.words import quoted, whole_of
from raybundle.io.reading.xml import Element, xml_of
from raybundle.io.scenes.base import HEAD_BYTES, Scene, SceneFormat, element_text, register
from raybundle.io.scenes.radar_tables import Columns, choice, powers, tied, whole
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import WGS84, geographic_from_geocentric
from raybundle.scenes.orbit import NEAREST, Orbit

SIDES = {"R": 1.0, "L": -1.0}
STRAIGHT_S = 1e-7
"""By which times of columns may differ from a straight line: less than a millimetre along the track"""
SEGMENTS = ((6, 10), (4, 6), (0, 0), (4, 5), (4, 9))
"""Digits of the lengths of subheader and data: images, graphics, a reserved field, texts, extensions"""
XML_BYTES = 1 << 26


def read(path: Path) -> Scene:
    """The scene of a SICD; raises InputError where its image is formed in another way."""
    with path.open("rb") as file:
        binary = file.read(4) in {b"NITF", b"NSIF"}
    root = xml_of(_extension(path) if binary else read_bytes(path), path, "SICD", local=True)
    enter_tree(root)
    kind = element_text(root, "Grid", "Type")
    inca = root.find("RMA", "INCA")
    if inca is None:
        formed = element_text(root, "ImageFormation", "ImageFormAlgo") or kind
        root.get("Grid").fail("scene.image_formation", kind=quoted(f"{formed} {kind}"))
    data = root.get("ImageData")
    rows, columns = whole(data, "NumRows"), whole(data, "NumCols")
    first = [data.number(f"First{k}", 0.0) for k in ("Row", "Col")]
    centre = [data.get("SCPPixel").number(k) for k in ("Row", "Col")]
    row_m, column_m = (root.get("Grid", k).number("SS") for k in ("Row", "Col"))
    c = powers(inca.get("TimeCAPoly"), "Coef", "exponent1")
    along = (np.array([0.0, columns / 2, columns]) - 0.5 + first[1] - centre[1]) * column_m
    t = Polynomial(c)(along)
    if not abs(t[1] - (t[0] + t[2]) / 2) <= STRAIGHT_S:
        inca.get("TimeCAPoly").fail("scene.times_curved", seconds=float(t[1] - (t[0] + t[2]) / 2))
    line_s = float(t[2] - t[0]) / columns
    near = inca.number("R_CA_SCP") + (first[0] - centre[0]) * row_m
    point = root.get("GeoData", "SCP", "ECF")
    X = np.array([[point.number(k) for k in "XYZ"]])
    scene = replace(
        Columns.slant(row_m, near).scene(
            (rows, columns), _orbit(root, t), (float(t[0]) + line_s / 2, line_s), sign=1.0,
            side=choice(root.get("SCPCOA"), "SideOfTrack", SIDES),
            height_m=float(geographic_from_geocentric(X, WGS84)[0, 2]),
        ),
        width_px=columns, height_px=rows, swapped=True,
    )  # fmt: skip
    image = np.array([[centre[1] - first[1], centre[0] - first[0]]]) + 0.5
    scene, contradicted = tied(scene, geographic_from_geocentric(X, WGS84), image)
    return Scene(
        file=path, format="sicd", width_px=columns, height_px=rows, rigorous=scene,
        sensor=" ".join(w for w in (element_text(root, "CollectionInfo", "CollectorName"), kind) if w),
        time=element_text(root, "Timeline", "CollectStart"), remarks=(note("scene.radar_delays"), *contradicted),
    )  # fmt: skip


def _orbit(root: Element, t: Array) -> Orbit:
    """State vectors about the times of the image."""
    axes = [Polynomial(powers(root.get("Position", "ARPPoly", a), "Coef", "exponent1")) for a in "XYZ"]
    low, high = float(t.min()), float(t.max())
    times = np.linspace(low - (high - low) / 4, high + (high - low) / 4, NEAREST)
    P, V = (np.stack([axis.deriv(k)(times) for axis in axes], axis=1) for k in (0, 1))
    return Orbit(times=times, positions=P, velocities=V)


def _extension(path: Path) -> bytes:
    """The XML of the first data extension of a NITF that holds a SICD."""
    with path.open("rb") as file:
        head = file.read(1 << 20)
        at, place = 360, _digits(path, head, 354, 6)
        for heads, bodies in SEGMENTS:
            count, at = _digits(path, head, at, 3), at + 3
            for _ in range(count if bodies else 0):
                a, b = _digits(path, head, at, heads), _digits(path, head, at + heads, bodies)
                at += heads + bodies
                if bodies == SEGMENTS[-1][1]:
                    file.seek(place + a)
                    text = file.read(min(b, XML_BYTES))
                    if b"SICD" in text[:HEAD_BYTES]:
                        return text
                place += a + b
    raise InputError("scene.no_sicd", file=path)


def _digits(path: Path, data: bytes, at: int, count: int) -> int:
    word = data[at : at + count].decode("latin-1")
    value = whole_of(word) if len(word) == count else None
    if value is None or value < 0:
        raise InputError("nitf.field", name=f"byte {at}", value=quoted(word), n=count, file=path)
    return value


def _recognises(path: Path, head: bytes) -> bool:
    del path
    if head.startswith((b"NITF", b"NSIF")):
        return b"SICD" in head[:200]
    return b"<SICD" in head or b":SICD" in head


register(SceneFormat(name="sicd", title="SICD (NITF, XML)", recognises=_recognises, read=read))
