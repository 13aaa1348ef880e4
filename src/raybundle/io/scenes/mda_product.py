"""What product.xml of RADARSAT-2 and of RCM have in common; they put the same elements in different places.

Ground range is counted from the nearest pixel, whichever column that is.  The time of the first line is that of the
first line of the image, which is the later one where lines are in decreasing order.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.errors import Message, note
from raybundle.io.reading.xml import Element, read_xml
from raybundle.io.scenes.base import Scene, check_denominators, element_text
from raybundle.io.scenes.radar_tables import (
    EXTENT,
    ORDERS,
    SIDES,
    Columns,
    amount,
    choice,
    ground_columns,
    instant,
    only,
    orbit_of,
    rational_functions,
    seconds,
    tie_points,
    tied,
    whole,
)
from raybundle.scenes.kinds.range_doppler import C_LIGHT, RangeDoppler

MAPS = frozenset({"SSG", "SPG", "GCD", "GCC"})
"""Types of products that are maps."""
VECTOR = ("timeStamp", *(f"{a}{k}" for k in ("Position", "Velocity") for a in "xyz"))
ORBIT = ("sourceAttributes", "orbitAndAttitude", "orbitInformation", "stateVector")
PROCESSING = ("imageGenerationParameters", "sarProcessingInformation")
LINES = tuple((*PROCESSING, f"zeroDopplerTime{k}Line") for k in ("First", "Last"))


@dataclass(frozen=True, slots=True, kw_only=True)
class Parts:
    """The places of a product's elements."""

    columns: Element
    """It holds the number of columns, and slantRangeFarEdge where there is that"""
    names: tuple[str, str]
    """Of the numbers of columns and lines"""
    raster: Element
    geographic: Element | None
    near: Element
    """It holds slantRangeNearEdge"""
    height: str
    """Of the element of `geographic` with the height of the terrain"""


def read_product(path: Path, name: str, parts_of: Callable[[Element], Parts]) -> Scene:
    """The scene of a product: orbit and times; its RPC to compare, or alone where these are missing."""
    root = read_xml(path, "product", local=True)
    kind = element_text(root, "imageGenerationParameters", "generalProcessingInformation", "productType").upper()
    parts = parts_of(root)
    geographic = parts.geographic
    if kind in MAPS or (geographic is not None and geographic.find("mapProjection") is not None):
        root.fail("scene.map_product", kind=kind or "mapProjection")
    functions = None if geographic is None else geographic.find("rationalFunctions")
    rpc = None if functions is None else rational_functions(functions)
    if rpc is not None:
        check_denominators(rpc, path)
    columns, rows = (whole(parts.columns, n) for n in parts.names)
    missing = next((p for p in (ORBIT, *LINES) if root.find(*p) is None), None)
    scene: RangeDoppler | None = None
    remarks: tuple[Message, ...]
    if missing is not None:
        if rpc is None:
            root.get(*missing)
        remarks = (note("scene.rpc_only", path="/".join(missing)),)
    else:
        scene, remarks = _range_doppler(root, kind, parts, (columns, rows))
    source = root.get("sourceAttributes")
    words = (
        element_text(source, "satellite"), element_text(source, "beamModeMnemonic"), kind,
        element_text(source, "radarParameters", "polarizations"),
    )  # fmt: skip
    return Scene(
        file=path, format=name, rpc=rpc, rigorous=scene, width_px=columns, height_px=rows,
        sensor=" ".join(w for w in words if w), time=element_text(root, *LINES[0]), remarks=remarks,
    )  # fmt: skip


def _range_doppler(
    root: Element, kind: str, parts: Parts, size: tuple[int, int]
) -> tuple[RangeDoppler, tuple[Message, ...]]:  # fmt: skip
    columns, rows = size
    first, last = (root.get(*p) for p in LINES)
    epoch = instant(first)
    lasting = seconds(last, epoch)
    line_s = lasting / max(rows - 1, 1)
    order = choice(parts.raster, "lineTimeOrdering", ORDERS)
    if line_s * order <= 0:
        parts.raster.get("lineTimeOrdering").fail("scene.line_order", seconds=lasting)
    information = root.get(*ORBIT[:-1])
    orbit = orbit_of(information, list(information.all(ORBIT[-1])), epoch, VECTOR)
    ranges = _ranges(root, kind, parts, columns, epoch)
    grid = None if parts.geographic is None else parts.geographic.find("geolocationGrid")
    geographic, image = tie_points(grid)
    terrain = None if parts.geographic is None else parts.geographic.find(parts.height)
    if len(geographic):
        height = float(geographic[:, 2].mean())
    else:
        height = 0.0 if terrain is None else terrain.number("geodeticTerrainHeight", 0.0)
    scene, contradicted = tied(
        ranges.scene(
            size, orbit, (0.0, line_s), height_m=height, sign=choice(parts.raster, "pixelTimeOrdering", ORDERS),
            side=choice(root.get("sourceAttributes", "radarParameters"), "antennaPointing", SIDES),
        ),
        geographic, image,
    )  # fmt: skip
    _check_extent(scene, parts.columns)
    return scene, (note("scene.radar_delays"), *contradicted)


def _ranges(root: Element, kind: str, parts: Parts, columns: int, epoch: np.datetime64) -> Columns:
    """Slant ranges of an SLC; else by the polynomials of ground range."""
    spacing = amount(parts.raster, "sampledPixelSpacing")
    tables = list(root.get("imageGenerationParameters").all("slantRangeToGroundRange"))
    if kind == "SLC" or (kind == "MLC" and _slant(parts, spacing, columns)):
        if parts.near.find("slantRangeNearEdge") is not None or not tables:
            return Columns.slant(spacing, amount(parts.near, "slantRangeNearEdge"))
        return Columns.slant(spacing, C_LIGHT / 2 * amount(tables[0], "slantRangeTimeToFirstRangeSample", "s"))
    if not tables:
        root.get("imageGenerationParameters", "slantRangeToGroundRange")
    entries = [
        (
            seconds(t.get("zeroDopplerAzimuthTime"), epoch),
            amount(t, "groundRangeOrigin"),
            (c := only(t, "groundToSlantRangeCoefficients")).numbers(max(2, len(c.content.split()))),
        )
        for t in tables
    ]
    return ground_columns(spacing, entries)


def _slant(parts: Parts, spacing: float, columns: int) -> bool:
    """Whether columns of a product that may be either are slant ranges, by those of its edges."""
    near, far = amount(parts.near, "slantRangeNearEdge"), amount(parts.columns, "slantRangeFarEdge")
    return abs(near + columns * spacing - far) <= EXTENT * (far - near)


def _check_extent(scene: RangeDoppler, columns: Element) -> None:
    """Refuse ranges that end elsewhere than the file states."""
    if columns.find("slantRangeFarEdge") is None or columns.find("slantRangeNearEdge") is None:
        return
    near, far = (amount(columns, f"slantRange{k}Edge") for k in ("Near", "Far"))
    edges = np.array([0.5, scene.width_px - 0.5])
    reached = float(scene.slant_range(edges, np.full(2, scene.middle_and_half[0])).max())
    if not abs(reached - far) <= EXTENT * (far - near):
        columns.get("slantRangeFarEdge").fail("scene.range_extent", reached_m=reached, stated_m=far)
