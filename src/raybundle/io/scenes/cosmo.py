"""COSMO-SkyMed of both generations and KOMPSAT-5 in HDF5: slant range (SCS) and ground range (DGM).

ASI-CSM-PMG-NT-001 and ASI's products description of the second generation (CSG): attributes of the root, of a swath S01
and of its image SBI (IMG in CSG); MBI is the mosaic of a ScanSAR.  KOMPSAT-5 writes the same names.  Times are seconds
after one reference.  The polynomial of a DGM takes pixels from the nearest one to slant range.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from raybundle.errors import Message, note
from raybundle.io.reading.hdf5 import Node, hdf5_names, hdf5_root
from raybundle.io.reading.words import quoted
from raybundle.io.scenes.base import Scene, SceneFormat, element_text, register
from raybundle.io.scenes.radar_tables import (
    EXTENT,
    SIDES,
    Columns,
    choice,
    corners,
    ground_columns,
    orbit_of_table,
    tied,
)
from raybundle.numerics.arrays import Array
from raybundle.scenes.kinds.range_doppler import C_LIGHT

MARKS = frozenset({"Mission ID", "Product Type", "State Vectors Times"})
"""Attributes of the root by which a file is recognised"""
MAPS = ("GEC", "GTC", "WEC", "WTC")
LINES: Mapping[str, float] = {"EARLY-LATE": 1.0, "LATE-EARLY": -1.0}
COLUMNS: Mapping[str, float] = {"NEAR-FAR": 1.0, "FAR-NEAR": -1.0}
SCANSAR = ("REGION", "SCANSAR", "WIDE SWATH")
"""In names of modes whose SCS has an image a burst"""
EDGES = tuple(f"Zero Doppler {a} {e} Time" for a in ("Azimuth", "Range") for e in ("First", "Last"))
CORNERS = tuple(f"{r} {a} Geodetic Coordinates" for a in ("Early", "Late") for r in ("Near", "Far"))


def read(path: Path) -> Scene:
    """The scene of a product; raises InputError with the attribute that is missing or contradicts another."""
    with hdf5_root(path) as root:
        kind, mode = element_text(root, "Product Type").upper(), element_text(root, "Acquisition Mode").upper()
        _check_kind(root, kind, mode)
        image, swath = _image(root)
        rows, columns, *_ = (*image.shape, 0, 0)
        if min(rows, columns) < 1:
            image.fail("scene.pixel_count", value=min(rows, columns))
        times, ranges = (np.array([image.number(e) for e in EDGES[k : k + 2]]) for k in (0, 2))
        along, across = choice(root, "Lines Order", LINES), choice(root, "Columns Order", COLUMNS)
        step = image.number("Line Time Interval", 0.0) or abs(times[1] - times[0]) / max(rows - 1, 1)
        if not abs(step * (rows - 1) - abs(times[1] - times[0])) <= 2 * step:
            image.get("Line Time Interval").fail("scene.line_order", seconds=float(times[1] - times[0]))
        orbit = orbit_of_table(
            root, root.table("State Vectors Times"),
            *(root.table(f"ECEF Satellite {k}", columns=3) for k in ("Position", "Velocity")),
        )  # fmt: skip
        centre = root.node("Scene Centre Geodetic Coordinates")
        scene = _columns(root, image, "DGM" in kind, columns, np.sort(ranges) * C_LIGHT / 2).scene(
            (columns, rows), orbit, (float(times.min() if along > 0 else times.max()), along * step), sign=across,
            side=choice(root, "Look Side", SIDES), height_m=0.0 if centre is None else float(centre.numbers(3)[2]),
        )  # fmt: skip
        scene, contradicted = tied(scene, *_ties(image, (columns, rows), along, across), EXTENT * max(columns, rows))
        remarks: tuple[Message, ...] = (note("scene.radar_delays"), *contradicted)
        words = (element_text(root, "Satellite ID"), mode, kind, element_text(swath, "Polarisation"))
        return Scene(
            file=path, format="cosmo", width_px=columns, height_px=rows, rigorous=scene, remarks=remarks,
            sensor=" ".join(w for w in words if w), time=element_text(root, "Scene Sensing Start UTC"),
        )  # fmt: skip


def _check_kind(root: Node, kind: str, mode: str) -> None:
    """Refuse raw data, maps, and images a burst."""
    if "RAW" in kind:
        root.fail("scene.raw_product", kind=kind)
    if any(m in kind for m in MAPS):
        root.fail("scene.map_product", kind=kind)
    if "SCS" not in kind and "DGM" not in kind:
        root.get("Product Type").fail("value.not_supported", value=quoted(kind), known=["SCS", "DGM"])
    if "SCS" in kind and any(m in mode for m in SCANSAR):
        root.get("Acquisition Mode").fail("scene.burst_images", n=len(_swaths(root)))
    ellipsoid = element_text(root, "Ellipsoid Designator").upper()
    if ellipsoid and ellipsoid != "WGS84":
        root.get("Ellipsoid Designator").fail("value.not_supported", value=quoted(ellipsoid), known=["WGS84"])


def _swaths(root: Node) -> list[Node]:
    found = (root.node(f"S{k:02}") for k in range(1, 12))
    return [s for s in found if s is not None]


def _image(root: Node) -> tuple[Node, Node]:
    """The image and its swath; raises InputError where images of several polarisations have different places."""
    swaths = _swaths(root)
    mosaic = root.node("MBI")
    images = [i for s in swaths if (i := s.node("SBI") or s.node("IMG")) is not None]
    if mosaic is not None:
        return mosaic, swaths[0] if swaths else root
    if not images:
        root.fail("xml.element_missing", path="S01/SBI")
    for image in images[1:]:
        for edge in EDGES:
            if image.number(edge) != images[0].number(edge):
                image.get(edge).fail("scene.values_differ", n=len(images))
    return images[0], swaths[0]


def _columns(root: Node, image: Node, ground: bool, columns: int, edges: Array) -> Columns:  # noqa: FBT001
    """Slant ranges of an SCS; of a DGM by its polynomial, whose ends must meet the ranges that the file states."""
    near, far = edges.tolist()
    if not ground:
        found = Columns.slant(C_LIGHT / 2 * image.number("Column Time Interval"), near)
    else:
        spacing, pixels = image.number("Column Spacing"), root.table("Ground to Slant Polynomial")
        c = pixels / spacing ** np.arange(len(pixels)) if spacing else pixels
        c[0] += root.number("Ground Projection Polynomial Reference Range")
        found = ground_columns(spacing, [(0.0, 0.0, c)])
    first, last = (float(np.polynomial.Polynomial(found.coefficients[0])(found.near_m + k * found.spacing_m))
                   for k in (0, columns - 1))  # fmt: skip
    if not max(abs(first - near), abs(last - far)) <= EXTENT * (far - near):
        image.get(EDGES[3]).fail("scene.range_extent", reached_m=last, stated_m=far)
    return found


def _ties(image: Node, size: tuple[int, int], along: float, across: float) -> tuple[Array, Array]:
    """Corners of the image, where the file has them: longitude, latitude, height (4, 3), image points (4, 2)."""
    found = [n for c in CORNERS if (n := image.node(c)) is not None]
    if len(found) < len(CORNERS):
        return np.zeros((0, 3)), np.zeros((0, 2))
    return np.array([n.numbers(3) for n in found])[:, [1, 0, 2]], corners(size, along, across)


register(
    SceneFormat(
        name="cosmo", title="COSMO-SkyMed, CSG, KOMPSAT-5 HDF5 (SCS, DGM)", read=read, within="*.h5",
        recognises=lambda path, head: hdf5_names(path, head) >= MARKS,
    )
)  # fmt: skip
