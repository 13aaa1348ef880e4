"""A list of positions that lies far from the positions that the photographs themselves record.

A list with latitude and longitude exchanged is a place on the earth as often as not, and a flight along the equator
keeps its shape in the exchange.  What the receivers in the cameras recorded shows it before anything is measured.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.errors import InputError, Value
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.io.photos.photo import Photo
from raybundle.io.trajectories import Trajectory, in_wgs84, matched
from raybundle.numerics.arrays import Array
from raybundle.numerics.geodesy import WGS84, geocentric_from_geographic

FEWEST = 3
"""Photographs: a median outvotes one camera with a position from somewhere else."""
FAR_M = 35_000.0
"""Radius of the largest cell of a mobile network (timing advance of GSM), from which a camera without a fix takes its
position: the largest error of what a photograph records.  Datums differ by less than a tenth of it."""
NEARER = 10.0
"""Ratio of the distances from which the exchange of the axes explains them."""


def distant_positions(photos: Sequence[Photo], positions: Trajectory, crs: str | None) -> tuple[Notice | None, bool]:
    """The fault of a list far from the photographs' own positions, and whether an exchange of its axes explains it.

    photos  as they are found, with the positions that they record
    crs     the system of a list that names none
    raises  InputError where the list cannot be matched or transformed

    The median of the distances counts: single photographs may record a wrong place.
    """
    rows = matched(positions, [p.name for p in photos])
    both = [k for k, row in enumerate(rows.tolist()) if row >= 0 and photos[k].metadata.gps is not None]
    recorded = [g for k in both if (g := photos[k].metadata.gps) is not None]
    own = np.array([(g.longitude_deg, g.latitude_deg) for g in recorded]).reshape(-1, 2)
    system = positions.crs or crs
    given = _distances(in_wgs84(positions, crs).xyz[rows[both]], own)
    if np.isfinite(given).sum() < FEWEST:
        return None, False
    distance = float(np.nanmedian(given))
    if distance <= FAR_M:
        return None, False
    exchanged = replace(positions, xyz=positions.xyz[:, [1, 0, 2]])
    try:
        other = float(np.nanmedian(_distances(in_wgs84(exchanged, crs).xyz[rows[both]], own)))
    except InputError:  # no place on the earth
        other = np.inf
    names = tuple(photos[k].name for k in both)
    values: dict[str, Value] = {
        "distance": distance, "exchanged": other if np.isfinite(other) else None, "photographs": len(both),
        "distance_km": distance / 1000, "table": positions.path.name,
    }  # fmt: skip
    if other * NEARER > distance:
        return Notice(code="positions_distant", ids=names[:100], values=values), False
    geographic = system is not None and parse_crs(system).is_geographic
    more: dict[str, Value] = {"geographic": geographic, "exchanged_km": other / 1000}
    return Notice(code="positions_axes.list", ids=names[:100], values={**values, **more}), True


def _distances(place: Array, own: Array) -> Array:
    """(n,) distances on the ground [m] between places (n, 3) and (n, 2), longitude, latitude [deg]; NaN stays."""
    a, b = (geocentric_from_geographic(np.column_stack([p[:, :2], np.zeros(len(p))])) for p in (place, own))
    chord = np.linalg.norm(a - b, axis=1)
    return 2 * WGS84.a * np.arcsin(np.minimum(chord / (2 * WGS84.a), 1))
