"""ICEYE: the XML beside an image; slant range (SLC) and ground range (GRD).

Its elements have the names of the HDF5, at any depth.  A state vector is an element with a time, posX to velZ.  Corners
show which way lines and columns run.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from raybundle.errors import Message, note
from raybundle.io.reading.words import no_number, numbers_of
from raybundle.io.reading.xml import Element, read_xml
from raybundle.io.scenes.base import Scene, SceneFormat, element_text, register
from raybundle.io.scenes.radar_tables import (
    EXTENT,
    SIDES,
    Columns,
    amount,
    choice,
    ground_columns,
    instant,
    only,
    orbit_of,
    seconds,
    tied,
    whole,
)
from raybundle.io.scenes.rpc_keys import scene_of_keys
from raybundle.numerics.arrays import Array
from raybundle.scenes.kinds.range_doppler import C_LIGHT, RangeDoppler

VECTOR = tuple(f"{k}{a}" for k in ("pos", "vel") for a in "xyz")
TIMES = ("zerodoppler_start_utc", "zerodoppler_end_utc")
CORNERS = tuple(f"coord_{a}_{r}" for a in ("first", "last") for r in ("near", "far"))
HEAD = ("satellite_name", "acquisition_mode", "product_level", "polarization")


def read(path: Path) -> Scene:
    """The scene of the XML: orbit and ranges, its RPC to compare; the RPC alone where orbit or times are missing."""
    root = read_xml(path, "", local=True)
    every = list(_within(root))
    flat = Element(path, root.line, root.name, root.attributes, [e for e in every if not e.children])
    columns, rows = (whole(flat, f"number_of_{k}_samples") for k in ("range", "azimuth"))
    keys = next((e for e in every if any(c.name == "line_off" for c in e.children)), None)
    rpc = None
    if keys is not None:
        values = {c.name: " ".join(_words(c)) for c in keys.children}
        rpc = scene_of_keys(values, path, "iceye", (columns, rows)).rpc
    vectors = [e for e in every if {c.name for c in e.children} >= {*VECTOR}]
    missing = "posX" if not vectors else next((n for n in TIMES if flat.find(n) is None), None)
    scene: RangeDoppler | None = None
    remarks: tuple[Message, ...] = (note("scene.rpc_only", path=missing or ""),)
    if missing is None or rpc is None:
        scene, remarks = _range_doppler(flat, every, vectors, (columns, rows))
    return Scene(
        file=path, format="iceye", rpc=rpc, rigorous=scene, width_px=columns, height_px=rows, remarks=remarks,
        sensor=" ".join(w for w in (element_text(flat, n) for n in HEAD) if w), time=element_text(flat, TIMES[0]),
    )  # fmt: skip


def _within(element: Element) -> Iterator[Element]:
    """An element and all below it, their names in small letters."""
    element.name = element.name.lower()
    yield element
    for child in element.children:
        yield from _within(child)


def _words(element: Element) -> list[str]:
    """The words of an element's text, which may be a list in brackets, or of its children."""
    text = " ".join(e.content for e in (element, *element.children))
    return [w for w in re.split(r"[\s,;\[\]'\"]+", text) if w]


def _numbers(element: Element) -> Array:
    values = numbers_of(_words(element))
    if values is None or not len(values):
        element.fail(no_number(element.content.strip()))
    return values


def _range_doppler(
    flat: Element, every: list[Element], vectors: list[Element], size: tuple[int, int]
) -> tuple[RangeDoppler, tuple[Message, ...]]:  # fmt: skip
    columns, rows = size
    start, end = (only(flat, n) for n in TIMES)
    epoch = instant(start)
    lasting = seconds(end, epoch)
    step = amount(flat, "azimuth_time_interval", "s")
    if not abs(step * (rows - 1) - lasting) <= 2 * step:
        flat.get("azimuth_time_interval").fail("scene.line_order", seconds=lasting)
    time = next((n for n in ("time", "state_vector_time_utc") if vectors and vectors[0].find(n)), "time")
    orbit = orbit_of(flat, vectors, epoch, (time, *VECTOR))
    across, along, geographic, image = _corners(flat, columns, rows)
    scene = _columns(flat, every).scene(
        size, orbit, (0.0 if along > 0 else lasting, along * step), sign=across, side=choice(flat, "look_side", SIDES),
        height_m=flat.number("avg_scene_height", 0.0),
    )  # fmt: skip
    scene, contradicted = tied(scene, geographic, image, limit_px=EXTENT * max(size))
    return scene, (note("scene.radar_delays"), *contradicted)


def _columns(flat: Element, every: list[Element]) -> Columns:
    """Slant ranges of an SLC; of a GRD by the polynomial of ground range."""
    group = next((e for e in every if e.name == "grsr_coefficients"), None)
    if group is None:
        return Columns.slant(amount(flat, "slant_range_spacing"), C_LIGHT / 2 * amount(flat, "first_pixel_time", "s"))
    inside = [e for e in group.children if e.name == "coefficient"]
    inside.sort(key=lambda e: e.value("number") if "number" in e.attributes else 0.0)
    c = np.array([float(e.numbers(1)[0]) for e in inside]) if inside else _numbers(group)
    origin = next((n for n in ("grsr_ground_range_origin", "ground_range_origin") if flat.find(n)), None)
    return ground_columns(amount(flat, "range_spacing"), [(0.0, amount(flat, origin) if origin else 0.0, c)])


def _corners(flat: Element, columns: int, rows: int) -> tuple[float, float, Array, Array]:
    """Directions of columns and lines (1: from near, from early), and the corners: ground (4, 3), image (4, 2)."""
    if any(flat.find(n) is None for n in CORNERS):
        return 1.0, 1.0, np.zeros((0, 3)), np.zeros((0, 2))
    table = [_numbers(flat.get(n)) for n in CORNERS]
    if any(len(row) != 4 for row in table):
        flat.get(CORNERS[0]).fail("value.count", n=len(table[0]), needed=4)
    near, far, late, _ = np.array(table)[:, :2]
    x = int(np.argmax(np.abs(far - near)))
    across, along = float(np.sign(far[x] - near[x])), float(np.sign(late[1 - x] - near[1 - x]))
    if not across * along:
        flat.get(CORNERS[0]).fail("scene.tie_points", n=4, meets=False, rms_px=None, limit_px=0.0)
    at = [[(columns - 0.5 if (k % 2) == (across > 0) else 0.5), (rows - 0.5 if (k > 1) == (along > 0) else 0.5)]
          for k in range(4)]  # fmt: skip
    height = flat.number("avg_scene_height", 0.0)
    return across, along, np.array([[row[3], row[2], height] for row in table]), np.array(at)


def _recognises(path: Path, head: bytes) -> bool:
    del path
    return (
        head.lstrip().startswith(b"<")
        and b"ICEYE" in head
        and re.search(rb"<(product|satellite)_name", head) is not None
    )


register(SceneFormat(name="iceye", title="ICEYE XML (SLC, GRD)", recognises=_recognises, read=read, within="*.xml"))
