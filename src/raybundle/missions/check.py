"""Photographs that were flown against the plan: what is missing, what was seen, what is to be flown again."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError
from raybundle.missions.camera import MissionCamera
from raybundle.missions.mission import Exposures, Mission, exposures
from raybundle.missions.places import Places, free_places, places
from raybundle.missions.polygons import widened
from raybundle.missions.report import Spread, beside, spread
from raybundle.missions.terrain import Ground
from raybundle.missions.views import Coverage, coverage, ground_points, overlap
from raybundle.numerics.arrays import Array, Mask

NEAREST_M = 10.0
"""How far from its planned place a photograph may be at least: receivers without corrections are off by some metres."""
PITCH, HEADING = np.radians(20), np.radians(60)
"""By which a photograph's view may differ from the planned one that it is taken for."""
SEEN_SHARE = 0.5
"""Of the photographs that the plan gives a place, below which it is to be flown again where nothing else is asked."""
LEAST = 3


@dataclass(frozen=True, slots=True, kw_only=True)
class Flown:
    """Photographs as they were taken, in the order of their time; NaN where nothing is known."""

    names: tuple[str, ...]
    xyz: Array
    """(n, 3) in the plan's coordinate system; the height in that of the plan, or off by one value for all [m]"""
    heading: Array
    """(n,) from grid north [rad]"""
    pitch: Array
    """(n,) [rad]"""
    roll: Array
    """(n,) [rad]"""
    seconds: Array
    """(n,) since the first"""
    exposure_s: Array
    """(n,)"""
    blur_px: Array
    """(n,) beyond the middle of the set"""
    blurred: Mask
    """(n,) whether that is beyond the scatter of the set"""
    height_known: bool = False
    """whether heights count from the take-off, so that they can be compared with the plan"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Limits:
    """From which on a photograph does not count."""

    blur_px: float = 1.5
    tilt: float = float(np.radians(10))
    seen: int | None = None
    """photographs that are to show each place; None: half of what the plan gives it, three at least"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Gap:
    """What is to be flown again."""

    outline: Array
    """(k, 2) [m]"""
    area_m2: float
    seen: int
    """photographs that show the place seen by the fewest"""
    wanted: int
    """that are to show it"""


@dataclass(frozen=True, slots=True, kw_only=True)
class FlightCheck:
    """What came of a plan."""

    planned: Exposures
    flown: Flown
    match: Array
    """(n,) row of the planned photograph for which each is taken, -1 for none"""
    missing: Array
    """rows of planned photographs that nobody took"""
    off_plan_m: Array
    """(n,) distance from the planned place in plan; NaN without one"""
    off_height_m: Array
    """(n,) above the planned height, less `height_offset_m`; NaN without one"""
    height_offset_m: float
    """that was taken from all heights, their zero not being that of the plan"""
    tilt: Array
    """(n,) angle between the viewing axis and the planned one [rad]; NaN where no attitude is known"""
    motion_px: Array
    """(n,) predicted motion during the exposure; NaN where speed or exposure are not known"""
    counted: Mask
    """(n,) photographs that count: neither blurred nor tilted too far, with a place"""
    along: Spread | None
    """overlap along lines of photographs that follow each other and count"""
    across: Spread | None
    coverage: Coverage
    expected: Array
    """photographs that the plan gives each place of the coverage"""
    gaps: tuple[Gap, ...]
    """the largest first"""

    @property
    def refly(self) -> bool:
        """Whether something is to be flown again."""
        return bool(self.gaps)


def check_flight(mission: Mission, flown: Flown, ground: Ground, limits: Limits | None = None) -> FlightCheck:
    """Compare photographs with their plan.

    ground  heights where they are known, NaN elsewhere
    raises  InputError where no photograph has a position, or none lies where the plan is
    Limits: whether photographs can be oriented; the sharpness of what all photographs share; whether a
    place is hidden by what stands before it.
    """
    limits = limits or Limits()
    planned = exposures(mission)
    match = _matched(mission, planned, flown)
    taken = match >= 0
    if not taken.any():
        _nowhere(mission, planned, flown)
    off_height, offset = _heights(planned, flown, match)
    actual = _as_flown(planned, flown, match, off_height)
    tilt = _tilts(planned, flown, match, actual)
    blurred = flown.blurred & (flown.blur_px > limits.blur_px)
    counted = np.isfinite(flown.xyz[:, :2]).all(axis=1) & ~blurred & ~(tilt > limits.tilt)
    good = actual.rows(np.flatnonzero(counted))
    where, normals = _places(mission, planned, ground)
    expected = coverage(mission.camera, planned, where, normals).count
    seen = coverage(mission.camera, good, where, normals)
    wanted = (
        np.maximum(np.ceil(SEEN_SHARE * expected), LEAST) if limits.seen is None else np.full(len(where), limits.seen)
    )
    wanted = np.minimum(wanted, expected).astype(int)
    along, across = _overlaps(mission, planned, actual, match, counted, ground)
    return FlightCheck(
        planned=planned, flown=flown, match=match, missing=np.setdiff1d(np.arange(len(planned)), match[taken]),
        off_plan_m=_off_plan(planned, flown, match), off_height_m=off_height, height_offset_m=offset, tilt=tilt,
        motion_px=_motion(mission.camera, actual, flown, ground), counted=counted, along=along, across=across,
        coverage=seen, expected=expected, gaps=_gaps(mission, where, seen.count, wanted),
    )  # fmt: skip


def _matched(mission: Mission, planned: Exposures, flown: Flown) -> Array:
    """Rows of planned photographs (n,): pairs taken nearest first, each at most once."""
    from scipy.spatial import KDTree

    match = np.full(len(flown.names), -1)
    rows = np.flatnonzero(np.isfinite(flown.xyz[:, :2]).all(axis=1))
    if not len(rows):
        raise InputError("flight_check.no_positions")
    reach = max(mission.base / 2, NEAREST_M)
    near: list[list[int]] = KDTree(planned.xyz[:, :2]).query_ball_point(flown.xyz[rows, :2], reach)
    pairs: list[tuple[float, int, int]] = []
    for i, others in zip(rows.tolist(), near, strict=True):
        for j in others:
            if _same_view(planned, flown, i, j):
                d = flown.xyz[i] - planned.xyz[j]
                up = d[2] if flown.height_known and np.isfinite(d[2]) else 0.0
                pairs.append((float(np.hypot(np.hypot(d[0], d[1]), up)), i, j))
    free = np.ones(len(planned), bool)
    for _, i, j in sorted(pairs):
        if match[i] < 0 and free[j]:
            match[i], free[j] = j, False
    return match


def _same_view(planned: Exposures, flown: Flown, i: int, j: int) -> bool:
    """Whether nothing that is known of a photograph's view speaks against a planned one."""
    if np.isfinite(flown.pitch[i]) and abs(flown.pitch[i] - planned.pitch[j]) > PITCH:
        return False
    tilted = planned.pitch[j] > -np.pi / 2 + PITCH
    if not tilted or not np.isfinite(flown.heading[i]):
        return True
    return bool(abs((flown.heading[i] - planned.heading[j] + np.pi) % (2 * np.pi) - np.pi) < HEADING)


def _nowhere(mission: Mission, planned: Exposures, flown: Flown) -> None:
    middle = np.nanmean(flown.xyz[:, :2], axis=0) - planned.xyz[:, :2].mean(axis=0)
    away = float(np.hypot(*middle))
    raise InputError("flight_check.other_place", away_m=away, mission=mission.name)


def _off_plan(planned: Exposures, flown: Flown, match: Array) -> Array:
    d = np.linalg.norm(flown.xyz[:, :2] - planned.xyz[np.maximum(match, 0), :2], axis=1)
    return np.where(match >= 0, d, np.nan)


def _heights(planned: Exposures, flown: Flown, match: Array) -> tuple[Array, float]:
    """Heights above the planned ones, and what was taken from all where their zero is another."""
    d = np.where(match >= 0, flown.xyz[:, 2] - planned.xyz[np.maximum(match, 0), 2], np.nan)
    known = np.isfinite(d)
    offset = 0.0 if flown.height_known or not known.any() else float(np.median(d[known]))
    return d - offset, offset


def _as_flown(planned: Exposures, flown: Flown, match: Array, off_height: Array) -> Exposures:
    """The photographs with what is not known of them taken from the plan: of their match, or the nearest one."""
    far = np.linalg.norm(planned.xyz[None, :, :2] - np.nan_to_num(flown.xyz[:, None, :2]), axis=2).argmin(axis=1)
    of = np.where(match >= 0, match, far)
    xyz = planned.xyz[of].copy()
    placed = np.isfinite(flown.xyz[:, :2]).all(axis=1)
    xyz[placed, :2] = flown.xyz[placed, :2]
    xyz[:, 2] += np.nan_to_num(off_height)
    return Exposures(
        xyz=xyz, heading=np.where(np.isfinite(flown.heading), flown.heading, planned.heading[of]),
        pitch=np.where(np.isfinite(flown.pitch), flown.pitch, planned.pitch[of]), line=planned.line[of],
        flight=planned.flight[of], distance=planned.distance[of],
        roll=np.nan_to_num(flown.roll),
    )  # fmt: skip


def _tilts(planned: Exposures, flown: Flown, match: Array, actual: Exposures) -> Array:
    """Angles between viewing axes and planned ones; a roll turns about the axis and is none."""
    axis = -actual.rotation[:, 2]
    wanted = -planned.rotation[np.maximum(match, 0)][:, 2]
    angle = np.arccos(np.clip(np.sum(axis * wanted, axis=1), -1, 1))
    known = (match >= 0) & np.isfinite(flown.pitch) & np.isfinite(flown.heading)
    return np.where(known, angle, np.nan)


def _motion(camera: MissionCamera, actual: Exposures, flown: Flown, ground: Ground) -> Array:
    """Predicted motion in the image [px]: speed between photographs, exposure time, distance to what is seen."""
    n = len(flown.names)
    speed = np.full(n, np.nan)
    dt = np.diff(flown.seconds)
    with np.errstate(divide="ignore", invalid="ignore"):
        v = np.where((dt > 0) & (dt < 30), np.linalg.norm(np.diff(actual.xyz, axis=0), axis=1) / dt, np.nan)
    if n > 1:
        speed = np.fmin(np.append(v, np.nan), np.append(np.nan, v))
    middle = ground_points(camera, actual, ground, (1, 1))[:, 0, 0]
    away = np.linalg.norm(middle - actual.xyz, axis=1)
    return speed * flown.exposure_s * camera.c_px / away


def _places(mission: Mission, planned: Exposures, ground: Ground) -> tuple[Places, Array | None]:
    """Places that are to be seen, and where they face: a grid over an area, else where planned photographs look."""
    footprint = min(mission.camera.footprint(mission.camera.distance(mission.gsd)))
    if mission.closed and np.isnan(planned.distance).any():
        return places(mission.outline, footprint / 12, ground), None
    met = ground_points(mission.camera, planned, ground, (1, 1), (1.0, 1.0)).reshape(-1, 3)
    good = np.isfinite(met).all(axis=1)
    walls = np.isfinite(planned.distance).all()
    where = free_places(met[good], max(mission.base, footprint / 12))
    return where, planned.rotation[good][:, 2] if walls else None


def _overlaps(
    mission: Mission, planned: Exposures, actual: Exposures, match: Array, counted: Mask, ground: Ground
) -> tuple[Spread | None, Spread | None]:
    """Overlaps of photographs that count: each with the next one taken on its line, and with the next line's."""
    row = np.full(len(planned), -1)
    ok = (match >= 0) & counted
    row[match[ok]] = np.flatnonzero(ok)
    taken = np.flatnonzero(row >= 0)
    same = planned.line[taken[1:]] == planned.line[taken[:-1]]
    first, second = row[taken[:-1][same]], row[taken[1:][same]]
    along = overlap(mission.camera, actual, ground, first, second, abreast=False) if len(first) else None
    a, b = beside(mission, planned, ground)
    keep = (row[a] >= 0) & (row[b] >= 0) if len(a) else np.zeros(0, bool)
    across = overlap(mission.camera, actual, ground, row[a][keep], row[b][keep], abreast=True) if keep.any() else None
    return None if along is None else spread(along), None if across is None else spread(across)


def _gaps(mission: Mission, where: Places, seen: Array, wanted: Array) -> tuple[Gap, ...]:
    """Places that lack photographs, those nearer to each other than photographs together.

    An area that a single photograph adds to the plan, base by spacing, is no reason to fly again while `LEAST`
    photographs show all of it.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import KDTree

    rows = np.flatnonzero(seen < wanted)
    if not len(rows):
        return ()
    pairs = KDTree(where.xyz[rows]).query_pairs(max(1.5 * where.step, mission.base), output_type="ndarray")
    graph = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(len(rows), len(rows)))
    _, label = connected_components(graph, directed=False)
    found: list[Gap] = []
    for k in range(int(label.max()) + 1):
        own = rows[label == k]
        worst = own[np.argmin(seen[own] - wanted[own])]
        area = where.area_m2(own)
        if area < mission.base * mission.spacing and (seen[own] >= LEAST).all():
            continue
        found.append(
            Gap(
                outline=widened(where.middle[own], where.step / 2),
                area_m2=area,
                seen=int(seen[worst]),
                wanted=int(wanted[worst]),
            )
        )
    return tuple(sorted(found, key=lambda g: -g.area_m2))
