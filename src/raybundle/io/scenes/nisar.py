"""NISAR level 1 RSLC in HDF5, by either radar (LSAR, SSAR): slant range, focused to zero Doppler.

JPL D-102268: ranges of columns, times of lines and state vectors stand in tables, times in seconds after the date of
their unit.  The geolocation grid has coordinates by height, time and range.
"""

from __future__ import annotations

from math import prod
from pathlib import Path

import numpy as np
from pyproj import Transformer

from raybundle.errors import InputError, Message, note
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.io.reading.hdf5 import Node, hdf5_names, hdf5_root
from raybundle.io.reading.words import quoted
from raybundle.io.scenes.base import Scene, SceneFormat, element_text, register
from raybundle.io.scenes.radar_tables import SIDES, Columns, choice, orbit_of_table, tied, utc
from raybundle.numerics.arrays import Array

RADARS = ("LSAR", "SSAR")
MAPS = ("GSLC", "GCOV", "GUNW", "GOFF")
READ = ("RSLC", "SLC")
"""Groups of the product; files of before 2022 have the second"""
FREQUENCIES = ("frequencyA", "frequencyB")
SINCE = "seconds since"
UNIFORM = 1e-3
"""Share of a step by which ranges and times may leave an equal spacing"""
TIES = 6
"""Values of the geolocation grid along each of its axes that are compared"""


def read(path: Path) -> Scene:
    """The scene of the first frequency; raises InputError with the table that is missing or contradicts another."""
    with hdf5_root(path) as root:
        radar, product = _product(root)
        swaths = product.get("swaths")
        bands = [f for f in FREQUENCIES if swaths.find(f, "slantRange") is not None]
        ranges, (first_m, pixel_m) = _uniform(swaths, bands[0] if bands else FREQUENCIES[0], "slantRange")
        lines, (first_s, line_s) = _uniform(swaths, "zeroDopplerTime")
        orbit = product.get("metadata", "orbit")
        late = float((_epoch(orbit) - _epoch(swaths, "zeroDopplerTime")) / np.timedelta64(1, "ns")) * 1e-9
        vectors = (_node(orbit).table(k, columns=3) for k in ("position", "velocity"))
        identification = radar.get("identification")
        terrain = product.find("metadata", "processingInformation", "parameters", "referenceTerrainHeight")
        scene = Columns.slant(abs(pixel_m), first_m if pixel_m > 0 else first_m + (ranges - 1) * pixel_m).scene(
            (ranges, lines), orbit_of_table(orbit, _node(orbit).table("time") + late, *vectors), (first_s, line_s),
            sign=float(np.sign(pixel_m)), side=choice(identification, "lookDirection", SIDES),
            height_m=0.0 if terrain is None else float(np.mean(_node(terrain).table())),
        )  # fmt: skip
        grid = product.find("metadata", "geolocationGrid")
        contradicted: tuple[Message, ...] = ()
        if grid is not None and grid.find("coordinateX") is not None:
            scene, contradicted = tied(scene, *_ties(_node(grid), (first_m, pixel_m), (first_s, line_s)))
        others = [note("scene.image_used", name=bands[0], others=bands[1:])] if bands[1:] else []
        mission, kind = (element_text(identification, k) for k in ("missionId", "productType"))
        return Scene(
            file=path, format="nisar", width_px=ranges, height_px=lines, rigorous=scene,
            sensor=f"{mission} {radar.name} {kind}", time=element_text(identification, "zeroDopplerStartTime"),
            remarks=(note("scene.radar_delays"), *others, *contradicted),
        )  # fmt: skip


def _product(root: Node) -> tuple[Node, Node]:
    """The group of the radar, and that of the product in it; raises InputError for maps and other products."""
    science = _node(root.get("science"))
    radars = [r for name in RADARS if (r := science.node(name)) is not None]
    if not radars:
        science.get(RADARS[0])
    for name in MAPS:
        if radars[0].node(name) is not None:
            radars[0].fail("scene.map_product", kind=name)
    if radars[0].node("RRSD") is not None:
        radars[0].fail("scene.raw_product", kind="RRSD")
    found = next((p for name in READ if (p := radars[0].node(name)) is not None), None)
    if found is None:
        kind = element_text(radars[0], "identification", "productType")
        radars[0].fail("value.not_supported", value=quoted(kind), known=["RSLC"])
    return radars[0], found


def _node(element: object) -> Node:
    assert isinstance(element, Node)  # the elements of an HDF5 file are
    return element


def _uniform(parent: object, *names: str) -> tuple[int, tuple[float, float]]:
    """Number, and first value and step, of a table of equal steps."""
    table = _node(_node(parent).get(*names))
    values = table.table()
    n = len(values)
    if n < 2 or not (step := float(values[-1] - values[0]) / (n - 1)):
        table.fail("scene.pixel_count", value=n)
    off = float(np.abs(values - values[0] - step * np.arange(n)).max() / abs(step))
    if not off <= UNIFORM:
        table.fail("scene.not_uniform", steps=off, limit=UNIFORM)
    return n, (float(values[0]), step)


def _epoch(parent: object, name: str = "time") -> np.datetime64:
    """The date that times are counted from."""
    unit = _node(parent).get(name, "units")
    _, since, date = unit.content.partition(SINCE)
    try:
        if since:
            return utc(date)
    except ValueError:
        pass
    return unit.fail("value.no_time", value=quoted(unit.content))


def _ties(grid: Node, ranges: tuple[float, float], lines: tuple[float, float]) -> tuple[Array, Array]:
    """Points of the geolocation grid: longitude, latitude, height (n, 3), image points (n, 2)."""
    axes = [grid.table(k) for k in ("heightAboveEllipsoid", "zeroDopplerTime", "slantRange")]
    shape = tuple(map(len, axes))
    xy: list[Array] = []
    for name in ("coordinateX", "coordinateY"):
        node = _node(grid.get(name))
        if node.values is None:
            node.numbers(prod(shape))
        if node.shape != shape:
            node.fail("value.count", n=prod(node.shape), needed=prod(shape))
        xy.append(np.asarray(node.values, float))
    # grids of single images of a simulation repeat a time for other coordinates: the first of them is meant
    firsts = [np.unique(a, return_index=True)[1] for a in axes]
    chosen = np.ix_(*(f[np.unique(np.linspace(0, len(f) - 1, TIES).astype(int))] for f in firsts))
    H, T, R = (a[c] for a, c in zip(np.meshgrid(*axes, indexing="ij"), (chosen,) * 3, strict=True))
    X, Y = (v[chosen] for v in xy)
    known = np.isfinite(X) & np.isfinite(Y)
    epsg = int(grid.number("epsg", 4326.0))
    lon, lat = X[known], Y[known]
    if epsg != 4326:
        try:
            system = parse_crs(f"EPSG:{epsg}")
        except InputError as error:
            raise error.at(grid.file, column="epsg") from None
        lon, lat = Transformer.from_crs(system, 4326, always_xy=True).transform(lon, lat)
    image = [(v - first) / step + 0.5 for v, (first, step) in ((R[known], ranges), (T[known], lines))]
    return np.stack([lon, lat, H[known]], axis=1), np.stack(image, axis=1)


register(
    SceneFormat(
        name="nisar", title="NISAR RSLC HDF5", read=read, within="*.h5",
        recognises=lambda path, head: "science" in hdf5_names(path, head),
    )
)  # fmt: skip
