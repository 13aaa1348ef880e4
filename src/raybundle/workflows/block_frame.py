"""Blocks of photographs whose `[frame]` names a coordinate system: in a local frame of that system.

A bundle needs a Cartesian frame, and a map is none (`io.geo.coordinate_systems`).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.block import Block
from raybundle.block.joined import TILT
from raybundle.block.transform import transform_block
from raybundle.errors import InputError, Message, Severity, Value, message, phrase
from raybundle.io.block.scenes import local_in
from raybundle.io.geo.coordinate_systems import LocalFrame, local_frame
from raybundle.io.geo.parsed_systems import parse_crs, system_name
from raybundle.numerics.arrays import Array
from raybundle.numerics.deviations import PAIRS, correlation_matrices
from raybundle.numerics.places import Local, Place, Projected
from raybundle.numerics.transform import SimilarityTransform

LEAVES = frozenset(("position", "vector", "rotation", "covariance", "deviations", "correlations"))
"""How columns follow a transformation that a map projection does not leave as they are"""


def in_block_frame(block: Block) -> tuple[Block, LocalFrame | None, tuple[str, ...]]:
    """The block in a local east-north-up frame of the system that its block.toml names, that frame, and remarks.

    `kind = "local"` with `crs`: it stands there already.  `kind = "projected"`: its coordinates are those of the
    system and are brought to the local frame at the origin; standard deviations follow, correlated where they were.
    No frame is known of other blocks, nor of those with satellite scenes, which keep the frame that they are given in.
    raises  InputError where the origin is not near the block, and for observations that would not follow
    """
    place = block.place
    if any(c.is_scene for c in block.cameras) or not isinstance(place, Projected | Local):
        return block, None, ()
    if isinstance(place, Local) and not place.crs:
        return block, None, ()
    if block.length_unit != "m":
        raise InputError("object_frame.needs_metres", block=block.name, unit=block.length_unit)
    if isinstance(place, Local):
        frame = local_frame(place.crs, place.crs_origin, undulation_m=place.undulation_m)
        return block, frame, frame.remarks
    frame = local_frame(place.name, place.origin)
    _check_near(block, frame)
    _check_follows(block)
    x, y, z = place.origin
    reported = phrase("conversion.local_frame", system=system_name(place.name), x=x, y=y, z=z)
    moved = replace(moved_to(block, frame), place=local_in(place.name, place.origin))
    return moved, frame, (reported, *frame.remarks)


def moved_to(block: Block, frame: LocalFrame) -> Block:
    """A block whose coordinates stand in the system of a frame, brought to that frame; what it observed too."""
    known = block.images.oriented
    centre, rotation = np.array(block.images.centre), np.array(block.images.rotation)
    placed = np.isfinite(centre).all(axis=1)
    rotation[known] = rotation[known] @ frame.crs_from_local_rotation(centre[known])
    centre[placed] = frame.local_from_crs(centre[placed])
    stations, points = block.stations, block.points
    sigma, correlation = _deviations(frame, stations.xyz, stations.sigma, stations.correlation)
    # velocities would have to be turned; without them they follow from the positions
    moved = replace(stations, xyz=_known_plan(frame, stations.xyz), sigma=sigma, correlation=correlation, velocity=None)
    own, _ = _deviations(frame, points.xyz, points.sigma, None)
    return replace(
        block,
        images=replace(block.images, centre=centre, rotation=rotation),
        points=replace(points, xyz=_known_plan(frame, points.xyz), sigma=own),
    ).having(moved)


def _known_plan(frame: LocalFrame, xyz: Array) -> Array:
    plan = np.isfinite(xyz[:, :2]).all(axis=1)
    result = np.full(xyz.shape, np.nan)
    if plan.any():
        result[plan] = frame.local_from_crs(xyz[plan])
    return result


def _deviations(frame: LocalFrame, xyz: Array, sigma: Array, correlation: Array | None) -> tuple[Array, Array | None]:
    """Standard deviations (n, 3) and correlations (n, 3) in the frame, of those in its system.

    Of a point of which not all three are observed, they keep the axes of the grid: what the others are is not known.
    """
    plan, height = frame.units_m
    found, joint = sigma * [plan, plan, height], None if correlation is None else np.array(correlation)
    rows = np.flatnonzero(np.isfinite(xyz).all(axis=1) & (sigma > 0).all(axis=1))
    if not len(rows):
        return found, joint
    given = correlation_matrices(None if correlation is None else correlation[rows], len(rows))
    C = frame.local_covariance(xyz[rows], given * sigma[rows][:, :, None] * sigma[rows][:, None, :])
    found[rows] = np.sqrt(np.diagonal(C, axis1=1, axis2=2))
    if joint is not None:
        for k, (i, j) in enumerate(PAIRS):
            joint[rows, k] = C[:, i, j] / (found[rows, i] * found[rows, j])
    return found, joint


def _check_near(block: Block, frame: LocalFrame) -> None:
    """Raise InputError where coordinates lie nearer to zero than to the origin: they are counted from it."""
    xyz = np.vstack([block.images.centre, block.points.xyz, block.stations.xyz])[:, :2]
    known = xyz[np.isfinite(xyz).all(axis=1)]
    if not len(known):
        return
    xy = np.median(known, axis=0)
    off = float(np.hypot(*(xy - frame.origin[:2])))
    if off <= np.hypot(*xy):
        return
    raise InputError(
        "object_frame.far_from_origin",
        block=block.name,
        system=system_name(frame.crs),
        x_m=float(xy[0]),
        y_m=float(xy[1]),
        origin_x_m=frame.origin[0],
        origin_y_m=frame.origin[1],
    )


def _check_follows(block: Block) -> None:
    """Raise InputError where a block in a map has observations that do not follow into a local frame."""
    for name, table in block.tables.items():
        turned = [n for n, c in table.cells() if c.follows in LEAVES]
        if name == "stations" or not len(table):
            continue
        if turned or table.upright or name == "attitudes":
            raise InputError("object_frame.needs_local", block=block.name, tables=name)


@dataclass(frozen=True, slots=True, kw_only=True)
class Brought:
    """A block in the frame of another."""

    block: Block
    by: SimilarityTransform | None
    """None: it stood there, or the place of one on the earth is not known"""
    reported: Message | None = None


def in_frame_of(block: Block, base: Block) -> Brought:
    """A block that stands on the earth, in the frame of another that does; others stay.

    raises  InputError where the two stand in different coordinate systems or kinds of frame, and for observations that
            do not follow

    The two frames are Cartesian, so that this is a shift and a turn, exact: by the curvature of the earth 1e-4 rad in
    600 m.  Standard deviations of points follow as in `moved_to`; correlations between their coordinates, smaller than
    the turn, are lost.
    """
    here, there = block.place, base.place
    if here is None or there is None or _one_frame(here, there):
        return Brought(block=block, by=None)
    frames = _frames(here, there)
    if frames is None or {block.length_unit, base.length_unit} != {"m"}:
        raise InputError(
            "join.frames_differ", block=block.name, other=base.name, unit=block.length_unit,
            other_unit=base.length_unit, details=[_frame(block.name, here), _frame(base.name, there)],
        )  # fmt: skip
    (centre, R), (base_centre, base_R) = frames
    by = SimilarityTransform(rotation=base_R @ R.T, translation=base_R @ (centre - base_centre))
    reported = Message(
        code="join.other_frame", severity=Severity.NOTE,
        values={
            "name": block.name, "base": base.name, "away_m": float(np.linalg.norm(by.translation)),
            **_frame_values(here),
        },
    )  # fmt: skip
    return Brought(block=replace(_turned(replace(block, place=None), by), place=there), by=by, reported=reported)


def _one_frame(here: Place, there: Place) -> bool:
    if isinstance(here, Projected) and isinstance(there, Projected):
        return _same_system(here.name, there.name)
    return here == there


def _same_system(one: str, other: str) -> bool:
    return one == other or bool(parse_crs(one).equals(parse_crs(other)))


def _frames(here: Place, there: Place) -> tuple[tuple[Array, Array], tuple[Array, Array]] | None:
    """Geocentric origins and rotations to the axes of two local frames of one system; None where they are of two."""
    if not (isinstance(here, Local) and isinstance(there, Local)):
        return None
    if here.crs and there.crs:
        if not _same_system(here.crs, there.crs) or here.undulation_m != there.undulation_m:
            return None
        one, two = (local_frame(p.crs, p.crs_origin, undulation_m=p.undulation_m).geocentric for p in (here, there))
        return one, two
    if here.crs or there.crs or here.ellipsoid != there.ellipsoid:
        return None
    one, two = ((p.geocentric_from_block(np.zeros((1, 3)))[0], p.place.local_from_geocentric_rotation())
                for p in (here, there))  # fmt: skip
    return one, two


def _frame(block: str, place: Place) -> Message:
    """In which frame a block is."""
    if isinstance(place, Projected):
        return message("join.frame_projected", block=block, system=system_name(place.name))
    if not isinstance(place, Local):
        return message("join.frame_geocentric", block=block)
    if not place.crs:
        lon, lat, h = place.origin
        return message("join.frame_local", block=block, longitude_deg=lon, latitude_deg=lat, height_m=h)
    x, y, h = place.crs_origin
    geoid = float("nan") if place.undulation_m is None else place.undulation_m
    return message(
        "join.frame_of_system", block=block, system=system_name(place.crs), x_m=x, y_m=y, height_m=h, geoid_m=geoid,
        geoid=place.undulation_m is not None,
    )  # fmt: skip


def _frame_values(place: Place) -> dict[str, Value]:
    kind = "projected" if isinstance(place, Projected) else "local" if isinstance(place, Local) else "geocentric"
    system = place.name if isinstance(place, Projected) else place.crs if isinstance(place, Local) else ""
    origin = (place.crs_origin if place.crs else place.origin) if isinstance(place, Local) else ()
    return {"kind": kind, "known": bool(system), "system": system_name(system) if system else "", "origin": [*origin]}


def _turned(block: Block, by: SimilarityTransform) -> Block:
    """A block after a shift and a turn; standard deviations of points and stations as of `moved_to`."""
    p = block.points
    xyz = by.points(p.xyz)
    given = p.is_control | p.is_check
    lost = np.flatnonzero((given & ~np.isfinite(xyz)).any(axis=1))
    if len(lost):
        raise InputError("join.point_incomplete", point=p.ids[int(lost[0])], block=block.name)
    levelled = [t.name.replace("_", " ") for t in block.tables.values() if t.upright and len(t)]
    tilt = float(np.linalg.norm(by.rotation[:2, 2]))
    if levelled and tilt > TILT:
        raise InputError(
            "join.vertical_of_tables",
            block=block.name,
            tables=[t.name for t in block.tables.values() if t.upright and len(t)],
            tilt_deg=float(np.degrees(tilt)),
            limit_deg=float(np.degrees(TILT)),
        )
    full = np.flatnonzero((p.sigma > 0).all(axis=1))
    sigma = np.array(p.sigma)
    sigma[full] = np.sqrt(sigma[full] ** 2 @ (by.rotation**2).T)
    stations = block.stations
    if len(stations) and stations.correlation is None:
        block = block.having(replace(stations, correlation=np.zeros((len(stations), 3))))
    bare = replace(block, points=replace(p, role=np.zeros_like(p.role), sigma=np.full_like(p.sigma, np.nan)))
    moved = transform_block(bare, by, observed="follow")
    return replace(moved, points=replace(p, xyz=xyz, sigma=sigma))
