"""Capella: the extended JSON beside an image in the slant plane, focused to zero Doppler (SLC).

Lines are times, columns ranges; rows and columns of the file count from 0 at centres.  Spotlight images of polar
formatting have no line of one time; GEO and GEC are maps.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raybundle.errors import InputError, note
from raybundle.io.reading.trees import Json, read_json
from raybundle.io.reading.words import quoted
from raybundle.io.scenes.base import Scene, SceneFormat, register
from raybundle.io.scenes.radar_tables import Columns, tied, utc
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import WGS84, geographic_from_geocentric
from raybundle.scenes.orbit import LEAST, Orbit

SIDES = {"right": 1.0, "left": -1.0}


def read(path: Path) -> Scene:
    """The scene of an image; raises InputError with the key that is missing or not supported."""
    root = read_json(path)
    collect = root.get("collect")
    image, kind = collect.get("image"), root.get("product_type").text()
    geometry = image.get("image_geometry")
    form = geometry.get("type").text()
    if form == "geotransform":
        root.get("product_type").fail("scene.map_product", kind=kind)
    if form != "slant_plane":
        geometry.get("type").fail("scene.image_formation", kind=quoted(form.upper()))
    if _doppler(geometry).any():
        geometry.get("doppler_centroid_polynomial").fail("value.not_supported", value=quoted("not 0"), known=["0"])
    rows, columns = (image.get(k).whole() for k in ("rows", "columns"))
    start = geometry.get("first_line_time")
    epoch = _instant(start)
    centre = image.get("center_pixel")
    target = geographic_from_geocentric(centre.get("target_position").numbers(3)[None], WGS84)
    side = collect.get("radar").get("pointing")
    if side.text() not in SIDES:
        side.fail("value.not_supported", value=quoted(side.text()), known=list(SIDES))
    scene = Columns.slant(*(geometry.get(k).positive() for k in ("delta_range_sample", "range_to_first_sample"))).scene(
        (columns, rows), _orbit(collect.get("state"), epoch), (0.0, geometry.get("delta_line_time").positive()),
        sign=1.0, side=SIDES[side.text()], height_m=float(target[0, 2]),
    )  # fmt: skip
    scene, contradicted = tied(scene, target, np.array([[columns // 2, rows // 2]]) + 0.5)
    return Scene(
        file=path, format="capella", width_px=columns, height_px=rows, rigorous=scene, time=start.text(),
        sensor=" ".join((*(collect.get(k).text() for k in ("platform", "mode")), kind)),
        remarks=(note("scene.radar_delays"), *contradicted),
    )  # fmt: skip


def _doppler(geometry: Json) -> Array:
    """Coefficients of the Doppler frequency that the lines are focused to."""
    rows = geometry.get("doppler_centroid_polynomial").get("coefficients").items()
    return np.concatenate([r.numbers(len(r.items())) for r in rows] or [np.zeros(0)])


def _instant(value: Json) -> np.datetime64:
    try:
        return utc(value.text())
    except ValueError:
        value.fail("value.no_time", value=quoted(value.text()))


def _orbit(state: Json, epoch: np.datetime64) -> Orbit:
    system = state.get("coordinate_system").get("type")
    if system.text() != "ecef":
        system.fail("value.not_supported", value=quoted(system.text()), known=["ecef"])
    vectors = state.get("state_vectors")
    every = vectors.items()
    if len(every) < LEAST:
        vectors.fail("scene.position_count", n=len(every), least=LEAST)
    times = np.array([float((_instant(v.get("time")) - epoch) / np.timedelta64(1, "ns")) * 1e-9 for v in every])
    P, V = (np.array([v.get(k).numbers(3) for v in every]) for k in ("position", "velocity"))
    try:
        return Orbit(times=times, positions=P, velocities=V).fitted()
    except InputError as error:
        raise error.at(vectors.file, column=vectors.at) from None


def _recognises(path: Path, head: bytes) -> bool:
    del path
    return head.lstrip().startswith(b"{") and b'"collect"' in head and b'"product_type"' in head


register(SceneFormat(name="capella", title="Capella extended JSON (SLC)", recognises=_recognises, read=read,
                     within="*_extended.json"))  # fmt: skip
