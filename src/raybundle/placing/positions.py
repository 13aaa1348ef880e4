"""Positions of photographs that GNSS measured: in which frame, of which point of the aircraft, from which flight.

Besides control they are observed with a shift of each flight's own, which control determines: a base station in another
datum, heights above the sea instead of the ellipsoid, and what changes slowly in single positions all end in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import UTC

import numpy as np

from raybundle.block import Block, Instrument, Stations
from raybundle.block.select import select_block
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.placing.marks import Given, Placing
from raybundle.platforms.antenna import Antenna

GPS_M = (5.0, 5.0, 10.0)
"""Standard deviation of a GPS position that states none."""
PAUSE_S, PAUSE = 120.0, 20.0
"""Seconds without a photograph after which a new flight begins, and the same in usual intervals; the longer counts."""
SHIFTS = ("sx", "sy", "sz")
TURN, STEP = float(np.radians(30)), 3.0
"""Turn at which a flight line ends, and length of a step in usual ones."""
SCALE = 0.1
"""Relative standard deviation of the scale from which positions are too near each other to place a block."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Positions:
    """What the oriented photographs state of where they were, in the local frame."""

    image: Index
    """(k,) position in the block's images"""
    xyz: Array
    """(k, 3) local coordinates; NaN for a height that is not known"""
    sigma: Array
    """(k, 3)"""
    flight: Index
    """(k,) number of the flight, 0 first; flights are those of all photographs, oriented or not"""
    flights: int
    assumed: Mask
    """(k,) positions of which no standard deviation is stated"""

    def __len__(self) -> int:
        return len(self.image)


def mean_place(photos: Sequence[Photo]) -> Array | None:
    """Mean longitude, latitude [deg] and height [m] (3,) of photographs with positions; None with fewer than three."""
    known = [p.metadata.gps for p in photos if p.metadata.gps is not None]
    if len(known) < 3:
        return None
    heights = [g.altitude_m for g in known if g.altitude_m is not None]
    plan = np.mean([(g.longitude_deg, g.latitude_deg) for g in known], axis=0)
    return np.array([*plan, np.mean(heights) if heights else np.nan])


def positions_of(photos: Sequence[Photo], oriented: Array, frame: LocalFrame) -> Positions:
    """The positions of the oriented photographs (n,) that state one."""
    rows = [i for i, p in enumerate(photos) if p.metadata.gps is not None and oriented[i]]
    assumed = np.zeros(len(rows), bool)
    geographic, sigma = np.full((len(rows), 3), np.nan), np.full((len(rows), 3), np.nan)
    for k, i in enumerate(rows):
        g = photos[i].metadata.gps
        assert g is not None
        geographic[k] = g.longitude_deg, g.latitude_deg, np.nan if g.altitude_m is None else g.altitude_m
        stated = g.sigma_m or (np.nan, np.nan, np.nan)
        assumed[k] = not any(np.isfinite(s) and s > 0 for s in stated)
        sigma[k] = [s if np.isfinite(s) and s > 0 else d for s, d in zip(stated, GPS_M, strict=True)]
    local = frame.local_from_wgs84(geographic) if rows else geographic
    stated = [i for i, p in enumerate(photos) if p.metadata.gps is not None]
    number = np.full(len(photos), -1, np.int32)
    number[stated] = flights([photos[i] for i in stated])
    return Positions(
        image=np.array(rows, np.int32),
        xyz=local,
        sigma=np.where(np.isfinite(local), sigma, np.nan),
        flight=number[rows],
        flights=int(number.max()) + 1 if rows else 0,
        assumed=assumed,
    )


def flights(photos: Sequence[Photo]) -> Index:
    """Numbers (n,) of the flights: photographs of one camera without a long pause; without times they are one."""
    of_camera: dict[tuple[str, str, str], list[int]] = {}
    for i, p in enumerate(photos):
        m = p.metadata
        of_camera.setdefault((m.make, m.model, m.serial), []).append(i)
    number, result = 0, np.zeros(len(photos), np.int32)
    for rows in of_camera.values():
        taken = [photos[i].metadata.taken for i in rows]
        if any(t is None for t in taken):
            result[rows] = number
            number += 1
            continue
        seconds = np.array([t.replace(tzinfo=UTC).timestamp() for t in taken if t is not None])
        order = np.argsort(seconds, kind="stable")
        interval = np.diff(seconds[order])
        pause = max(PAUSE_S, PAUSE * float(np.median(interval))) if len(interval) else PAUSE_S
        result[np.array(rows)[order]] = number + np.concatenate([[0], np.cumsum(interval > pause)])
        number = int(result.max()) + 1
    return result


def flight_lines(photos: Sequence[Photo]) -> Index:
    """Numbers (n,) of the straight flight lines; -1 where a photograph has no position or belongs to none.

    A line is a run of photographs of one flight, in the order of their times (else of their names), along which the
    direction from one to the next turns by less than TURN and no step is longer than STEP usual ones.
    """
    stated = [i for i, p in enumerate(photos) if p.metadata.gps is not None]
    result = np.full(len(photos), -1, np.int32)
    if not stated:
        return result
    flight = flights([photos[i] for i in stated])
    lonlat = np.array([(g.longitude_deg, g.latitude_deg) for i in stated if (g := photos[i].metadata.gps) is not None])
    xy = np.radians(lonlat) * 6.371e6 * [np.cos(np.radians(lonlat[:, 1].mean())), 1.0]
    number = 0
    for f in range(int(flight.max()) + 1):
        mine = np.flatnonzero(flight == f)
        taken = [photos[stated[k]].metadata.taken for k in mine.tolist()]
        if all(t is not None for t in taken):
            mine = mine[np.argsort([t.replace(tzinfo=UTC).timestamp() for t in taken if t is not None], kind="stable")]
        for run in _straight(xy[mine]):
            result[[stated[k] for k in mine[run].tolist()]] = number
            number += 1
    return result


def _straight(xy: Array) -> list[Index]:
    """Rows of straight runs of places (n, 2), the longest first; a place belongs to one run."""
    step = np.diff(xy, axis=0)
    length = np.linalg.norm(step, axis=1)
    if not (length > 0).any():
        return []
    far = (length > STEP * np.median(length[length > 0])) | (length == 0)
    with np.errstate(invalid="ignore"):
        cosine = np.sum(step[1:] * step[:-1], axis=1) / (length[1:] * length[:-1])
    begin = np.concatenate([[True], ~(cosine > np.cos(TURN)) | far[1:] | far[:-1]])
    runs = [r for r in np.split(np.arange(len(step)), np.flatnonzero(begin)[1:]) if not far[r].any()]
    used = np.zeros(len(xy), bool)
    found: list[Index] = []
    for run in sorted(runs, key=len, reverse=True):
        rows = np.array([k for k in range(run[0], run[-1] + 2) if not used[k]], np.int32)
        if len(rows) > 1:
            used[rows] = True
            found.append(rows)
    return found


def scale_sigma(positions: Positions) -> float:
    """Relative standard deviation with which positions show the scale of a block."""
    plan = positions.xyz[:, :2] - positions.xyz[:, :2].mean(axis=0)
    extent = float(np.sqrt((plan**2).sum()))
    return float(np.sqrt((positions.sigma[:, :2] ** 2).mean())) / extent if extent > 0 else np.inf


def turn_sigma(positions: Positions) -> float:
    """Standard deviation [rad] of the turn of a block about the line of its positions; inf without heights."""
    xyz = positions.xyz[np.isfinite(positions.xyz).all(axis=1)]
    if len(xyz) < 3:
        return np.inf
    off = np.linalg.svd(xyz - xyz.mean(axis=0), compute_uv=False)[1:]
    extent = float(np.linalg.norm(off))
    return float(np.sqrt(np.nanmean(positions.sigma**2))) / extent if extent > 0 else np.inf


def observe(state: Placing, positions: Positions, given: Given) -> None:
    """Observe the positions in a placed block, each flight with the shift that control determines.

    An antenna whose shift nothing determines yet stands in the block with none: control that is marked later frees it
    (`free_shifts`).
    """
    block = state.block
    shift = determined_shifts(block) if given.shift else ()
    arm = given.lever_arm
    stations = Stations(image=positions.image, xyz=positions.xyz, sigma=positions.sigma)
    flights = 0
    if given.shift or arm is not None:
        count = positions.flights
        taken = {c.id for c in block.parametrised}
        names = [_name("gnss" if count == 1 else f"gnss-{k + 1}", taken) for k in range(count)]
        apart = positions.xyz - block.images.centre[positions.image]
        antennas = [_antenna(n, apart[positions.flight == k], shift, given) for k, n in enumerate(names)]
        first = len(block.instruments)
        block = replace(block, instruments=(*block.instruments, *antennas))
        stations = replace(stations, antenna=(first + positions.flight).astype(np.int32))
        if shift:
            flights = count
    state.block = block.having(stations)
    state.notify("gps", n=len(positions), flights=flights)
    if positions.assumed.any():
        assumed = int(positions.assumed.sum())
        state.notify("positions_assumed", n=assumed, plan_m=float(GPS_M[0]), height_m=float(GPS_M[2]))


def determined_shifts(block: Block) -> tuple[str, ...]:
    """The shifts of positions that control determines: points that two oriented images and more show."""
    o = block.observations
    rays = np.bincount(o.point[block.images.oriented[o.image]], minlength=len(block.points))
    known = block.points.is_control & (rays > 1)[:, None]
    plan, height = bool((known[:, 0] & known[:, 1]).any()), bool(known[:, 2].any())
    return (*(("sx", "sy") if plan else ()), *(("sz",) if height else ()))


def free_shifts(block: Block) -> Block:
    """The block with the shifts of its antennas free that control determines now and nothing did before."""
    stations = block.table(Stations)
    shift = determined_shifts(block)
    if stations.antenna is None or not shift:
        return block
    instruments = list(block.instruments)
    for k in np.unique(stations.antenna[stations.antenna >= 0]).tolist():
        mine = np.flatnonzero(stations.antenna == k)
        antenna, apart = instruments[k], stations.xyz[mine] - block.images.centre[stations.image[mine]]
        held = all(s not in antenna.estimate and antenna.values.get(s, 0.0) == 0.0 for s in SHIFTS)
        if antenna.model == Antenna.name and held:
            start: dict[str, float] = dict(zip(SHIFTS, _middle(apart), strict=True))
            values = {**antenna.values, **{s: start[s] for s in shift}}
            instruments[k] = replace(antenna, values=values, estimate=(*antenna.estimate, *shift))
    return replace(block, instruments=tuple(instruments))


def without_idle(block: Block) -> Block:
    """The block without instruments of which nothing is observed, as antennas of flights that are not oriented."""
    used = {int(k) for t in block.tables.values() for k in t.refers("instrument")}
    keep = np.array([k in used for k in range(len(block.instruments))], bool)
    if keep.all():
        return block
    return select_block(block, "instrument", keep)


def _name(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    return name


def _antenna(name: str, apart: Array, shift: tuple[str, ...], given: Given) -> Instrument:
    """The antenna of one flight; `apart` (k, 3): its positions minus the projection centres at the start."""
    offset, sigma = given.lever_arm or ((0.0, 0.0, 0.0), 0.0)
    arm = dict(zip(("ax", "ay", "az"), offset, strict=True))
    start = {s: _middle(apart)[SHIFTS.index(s)] for s in shift}
    free = (*(tuple(arm) if sigma > 0 else ()), *shift)
    return Instrument(
        id=name, model=Antenna.name, values={**{p.symbol: 0.0 for p in Antenna.parameters}, **arm, **start},
        estimate=free, sigma=dict.fromkeys(arm, sigma) if sigma > 0 else {},
    )  # fmt: skip


def _middle(apart: Array) -> list[float]:
    """Medians of differences (k, 3); 0 where none is known."""
    return [float(np.median(v[np.isfinite(v)])) if np.isfinite(v).any() else 0.0 for v in apart.T]
