"""Coordinates of which all stand in another order or unit: latitude and longitude exchanged, heights in feet.

In degrees the exchange is no mirror image: it stretches the plan too, and no mend in metres undoes it.  Every mend is
therefore made in the coordinates' own system and compared with the photographs after the conversion.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Block, Role
from raybundle.errors import InputError, Value
from raybundle.io.geo.control_files import ControlFile
from raybundle.io.geo.coordinate_systems import WGS84, local_frame
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.length_units import UNITS
from raybundle.numerics.statistics import fisher_tail
from raybundle.numerics.transform import similarity
from raybundle.placing.mirrored import without_control
from raybundle.placing.positions import Positions

FEWEST = 4
"""Places: five coordinates beyond those of a similarity."""
LEVEL = 1e-5
"""Probability with which right coordinates are taken for misread ones, over all mends together, at most."""
DECIDEDLY = 2.0
"""Ratio of the misfits from which a mend is better."""
STATED, ROUGHLY = 3.0, 0.01
"""Misfit up to which mended coordinates fit: in their standard deviations, or as a share of their extent, which a free
block with an unadjusted camera holds."""
LINE = 0.05
"""Width of the places, as a share of their length, up to which they stand in a line."""
EXCHANGED, FEET = "axes_exchanged", "heights_in_feet"
MENDS: Mapping[str, Array] = {
    EXCHANGED: np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, 1]]),
    FEET: np.diag([1.0, 1, UNITS["feet"]]),
}
"""Matrices from the coordinates as given to the mended ones."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MisreadAxes:
    """A mend with which all coordinates fit the photographs."""

    mend: str
    before: float
    """Misfit of a coordinate as given [m]"""
    after: float
    """Misfit of a coordinate after the mend [m]"""


def misread_axes(
    source: Array, given: Array, sigma: float, crs: str | None, *, undulation_m: float | None = None
) -> MisreadAxes | None:
    """The mend of coordinates that fits the photographs decidedly better; None where none does.

    source  (n, 3) the places as the photographs alone have them
    given   (n, 3) the coordinates in their own system
    sigma   standard deviation of a coordinate [m]
    crs     the system; None: metres, where an exchange is a mirror image (`mirrored`)

    With W the square sum of the residuals of the similarity as given, W' after a mend, both with r = 3 n - 7 degrees of
    freedom, W / W' is distributed as F(r, r) if both fitted alike.  A mend that compresses an axis compresses the
    errors there, too: the residuals count at the larger of their sizes before and after the mend.
    """
    n = len(source)
    if n < FEWEST:
        return None
    redundancy = 3 * n - 7
    try:
        local, jacobian = _local(given, crs, undulation_m)
        if _in_line(local) or _in_line(source):
            return None
        before = _square_sum(similarity(source, local).residuals)
    except InputError:
        return None
    found: list[MisreadAxes] = []
    for name, mend in MENDS.items():
        if name == EXCHANGED and crs is None:
            continue
        try:
            other, own = _local(given @ mend.T, crs, undulation_m)
            residuals = similarity(source, other).residuals
        except InputError:  # no place on the earth
            continue
        back = jacobian @ np.linalg.inv(mend) @ np.linalg.inv(own)
        after = max(_square_sum(residuals), _square_sum(residuals @ back.T), 1e-300)
        rms = float(np.sqrt(_square_sum(residuals) / redundancy))
        extent = float(np.sqrt(_square_sum(other - other.mean(axis=0)) / n))
        if (
            np.sqrt(before / after) >= DECIDEDLY
            and rms <= max(STATED * sigma, ROUGHLY * extent)
            and fisher_tail(before / after, redundancy, redundancy) < LEVEL / len(MENDS)
        ):
            found.append(MisreadAxes(mend=name, before=float(np.sqrt(before / redundancy)), after=rms))
    return min(found, key=lambda m: m.after, default=None)


def positions_as_read(block: Block, photos: Sequence[Photo], positions: Positions) -> tuple[Positions, list[Notice]]:
    """No positions and the fault that names the mend, where all of them are misread; else the positions as they are."""
    rows: Index = np.flatnonzero(np.isfinite(positions.xyz).all(axis=1))
    gps = [photos[i].metadata.gps for i in positions.image[rows].tolist()]
    own = np.array([(g.longitude_deg, g.latitude_deg, g.altitude_m) for g in gps if g is not None], float)
    sigma = float(np.sqrt(np.mean(positions.sigma[rows] ** 2))) if len(rows) else np.nan
    found = misread_axes(block.images.centre[positions.image[rows]], own.reshape(-1, 3), sigma, WGS84)
    if found is None:
        return positions, []
    names = tuple(block.images.ids[i] for i in positions.image[rows].tolist())
    values = {"n": len(rows), "before_m": found.before, "after_m": found.after}
    code = "positions_unit" if found.mend == FEET else "positions_axes"
    notice = Notice(code=code, ids=names[:100], values=values)
    left = replace(
        positions, image=positions.image[:0], xyz=positions.xyz[:0], sigma=positions.sigma[:0],
        flight=positions.flight[:0], assumed=positions.assumed[:0],
    )  # fmt: skip
    return left, [notice]


def control_as_read(
    block: Block, free: Array, control: Sequence[ControlFile], undulation_m: float | None
) -> tuple[Block, list[Notice]]:
    """The block without control and the fault that names the mend, where all of it is misread; else the block as it is.

    free   (p, 3) the points as the photographs alone have them; NaN where they do not
    """
    points = block.points
    own = {name: xyz for c in control for name, xyz in zip(c.ids, c.xyz, strict=True)}
    crs = {c.crs for c in control if np.isfinite(c.xyz).any()}
    if len(crs) != 1:
        return block, []
    system = crs.pop()
    usable = np.isin(np.asarray(points.role), (Role.CONTROL, Role.CHECK)) & np.isfinite(points.xyz).all(axis=1)
    rows = [k for k in np.flatnonzero(usable & np.isfinite(free).all(axis=1)).tolist() if points.ids[k] in own]
    given = np.array([own[points.ids[k]] for k in rows]).reshape(-1, 3)
    sigma = float(np.sqrt(np.nanmean(points.sigma[rows] ** 2))) if np.isfinite(points.sigma[rows]).any() else 0.0
    found = misread_axes(free[rows], given, sigma, system, undulation_m=undulation_m)
    if found is None:
        return block, []
    names = tuple(points.ids[k] for k in rows)
    values: dict[str, Value] = {"n": len(rows), "before_m": found.before, "after_m": found.after}
    if found.mend == FEET:
        return without_control(block), [Notice(code="control_unit", ids=names[:100], values=values)]
    values["geographic"] = bool(system and parse_crs(system).is_geographic)
    return without_control(block), [Notice(code="control_mirrored.axes", ids=names[:100], values=values)]


def _local(xyz: Array, crs: str | None, undulation_m: float | None) -> tuple[Array, Array]:
    """Local coordinates (n, 3), east, north, up at the middle of the places, and their derivatives (3, 3) there."""
    if crs is None:
        return xyz, np.eye(3)
    middle = xyz.mean(axis=0)
    if parse_crs(crs).is_geographic and abs(middle[1]) > 90:
        raise InputError("position.beyond_degrees", value=middle[1], limit=90)
    frame = local_frame(crs, middle, undulation_m=undulation_m)
    local, jacobian = frame.local_from_crs(xyz), frame.jacobian(middle[None])[0]
    if not (np.isfinite(local).all() and abs(np.linalg.det(jacobian)) > 0):
        raise InputError("crs.no_local_frame", x=middle[0], y=middle[1], system=crs)
    return local, jacobian


def _in_line(xyz: Array) -> bool:
    s = np.linalg.svd(xyz - xyz.mean(axis=0), compute_uv=False)
    return bool(s[1] < LINE * s[0])


def _square_sum(residuals: Array) -> float:
    return float(np.sum(residuals**2))
