"""ICEYE: the HDF5 of an image, or the XML beside it; slant range (SLC) and ground range (GRD).

Both have the same names, those of the XML at any depth.  A state vector is an element with a time, posX to velZ, or a
row of tables.  Corners show which way lines and columns run.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from raybundle.errors import Message, note
from raybundle.io.reading.files import as_utf8, opened
from raybundle.io.reading.hdf5 import hdf5_names, hdf5_root
from raybundle.io.reading.words import no_number, numbers_of
from raybundle.io.reading.xml import Element, read_xml
from raybundle.io.scenes.base import Scene, SceneFormat, element_text, register
from raybundle.io.scenes.radar_tables import (
    EXTENT,
    SIDES,
    Columns,
    amount,
    choice,
    corners,
    ground_columns,
    instant,
    only,
    orbit_of,
    orbit_of_table,
    seconds,
    tied,
    whole,
)
from raybundle.io.scenes.rpc_keys import scene_of_keys
from raybundle.numerics.arrays import Array
from raybundle.scenes.kinds.range_doppler import C_LIGHT, RangeDoppler
from raybundle.scenes.orbit import Orbit

VECTOR = tuple(f"{k}{a}" for k in ("pos", "vel") for a in "xyz")
TIME, GROUND = "state_vector_time_utc", "grsr_coefficients"
MARKS = frozenset({"satellite_name", "product_name"})
PIXELS = ("s_i", "s_amplitude")
"""Tables of an HDF5: by which it is recognised; the pixels of an SLC, and of a GRD"""
TIMES = ("zerodoppler_start_utc", "zerodoppler_end_utc")
CORNERS = tuple(f"coord_{a}_{r}" for a in ("first", "last") for r in ("near", "far"))
MOST_BYTES = 1 << 24
"""What is read of an XML to recognise it: state vectors every 0.1 s are some 70 kB"""
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
        time = next((n for n in ("time", TIME) if vectors and vectors[0].find(n)), "time")
        ground = next((e for e in every if e.name == GROUND), None)
        scene, remarks = _range_doppler(
            flat, ground, (columns, rows), lambda epoch: orbit_of(flat, vectors, epoch, (time, *VECTOR))
        )
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
    flat: Element, ground: Element | None, size: tuple[int, int], orbit_at: Callable[[np.datetime64], Orbit]
) -> tuple[RangeDoppler, tuple[Message, ...]]:  # fmt: skip
    columns, rows = size
    start, end = (only(flat, n) for n in TIMES)
    epoch = instant(start)
    lasting = seconds(end, epoch)
    step = amount(flat, "azimuth_time_interval", "s")
    if not abs(step * (rows - 1) - lasting) <= 2 * step:
        flat.get("azimuth_time_interval").fail("scene.line_order", seconds=lasting)
    orbit = orbit_at(epoch)
    across, along, geographic, image = _corners(flat, columns, rows)
    scene = _columns(flat, ground).scene(
        size, orbit, (0.0 if along > 0 else lasting, along * step), sign=across, side=choice(flat, "look_side", SIDES),
        height_m=flat.number("avg_scene_height", 0.0),
    )  # fmt: skip
    scene, contradicted = tied(scene, geographic, image, limit_px=EXTENT * max(size))
    return scene, (note("scene.radar_delays"), *contradicted)


def _columns(flat: Element, group: Element | None) -> Columns:
    """Slant ranges of an SLC; of a GRD by the polynomial of ground range."""
    if group is None:
        return Columns.slant(amount(flat, "slant_range_spacing"), C_LIGHT / 2 * amount(flat, "first_pixel_time", "s"))
    inside = [e for e in group.children if e.name == "coefficient"]
    inside.sort(key=lambda e: e.value("number") if "number" in e.attributes else e.number("number", 0.0))
    c = np.array([float((e.find("value") or e).numbers(1)[0]) for e in inside]) if inside else _numbers(group)
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
    height = flat.number("avg_scene_height", 0.0)
    return across, along, np.array([[row[3], row[2], height] for row in table]), corners((columns, rows), along, across)


def read_hdf5(path: Path) -> Scene:
    """The scene of an HDF5; raises InputError with the table that is missing or contradicts another."""
    with hdf5_root(path) as root:
        columns, rows = (whole(root, f"number_of_{k}_samples") for k in ("range", "azimuth"))

        def orbit_at(epoch: np.datetime64) -> Orbit:
            times = root.get(TIME)
            words = [Element(path, 0, TIME, times.attributes, content=w) for w in times.content.split()]
            table = [root.table(f"{k}{a}") for k in ("pos", "vel") for a in "XYZ"]
            if any(len(v) != len(words) for v in table):
                times.fail("value.count", n=len(words), needed=len(table[0]))
            vectors = np.hsplit(np.stack(table, axis=1), 2)
            return orbit_of_table(root, np.array([seconds(w, epoch) for w in words]), *vectors)

        image = next((n for k in PIXELS if (n := root.node(k)) is not None), None)
        if image is not None and image.shape != (rows, columns):
            image.fail("value.count", n=image.shape[-1], needed=columns)
        ground = None if image is not None and image.name != PIXELS[-1] else root.find(GROUND)
        scene, remarks = _range_doppler(root, ground, (columns, rows), orbit_at)
        return Scene(
            file=path, format="iceye-hdf5", rigorous=scene, width_px=columns, height_px=rows, remarks=remarks,
            sensor=" ".join(w for w in (element_text(root, n) for n in HEAD) if w), time=element_text(root, TIMES[0]),
        )  # fmt: skip


def _recognises(path: Path, head: bytes) -> bool:
    if not head.lstrip().startswith(b"<"):
        return False
    if b"ICEYE" not in head and b"<Metadata" in head:  # long tables may stand before its name
        with opened(path) as file:
            head = as_utf8(file.read(MOST_BYTES), whole=False)
    return b"ICEYE" in head and re.search(rb"<(product|satellite)_name", head) is not None


register(SceneFormat(name="iceye", title="ICEYE XML (SLC, GRD)", recognises=_recognises, read=read, within="*.xml"))
register(
    SceneFormat(
        name="iceye-hdf5", title="ICEYE HDF5 (SLC, GRD)", read=read_hdf5, within="*.h5",
        recognises=lambda path, head: hdf5_names(path, head) >= MARKS,
    )
)  # fmt: skip
