"""A block and what was measured by hand make a block, which is adjusted as any other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from raybundle.block import ROLES, Block, Distances, Observations, Points, Role
from raybundle.block.select import select_block
from raybundle.block.transform import transform_block
from raybundle.errors import InputError, phrase
from raybundle.measuring.axes import (
    BY_POINTS,
    BY_VERTICAL,
    by_points,
    by_vertical,
    check_direction,
    check_points,
    turn_between,
    vertical,
)
from raybundle.measuring.control_names import check_names
from raybundle.measuring.film import Scans, placed
from raybundle.measuring.frames import in_camera
from raybundle.measuring.orienting import oriented
from raybundle.measuring.state import Axes, LineKind, State
from raybundle.numerics.arrays import Array
from raybundle.numerics.transform import SimilarityTransform, similarity
from raybundle.observations.alignment import Levels, Lines, OnFigure, Planes, PlumbLines
from raybundle.observations.coordinates import Coordinates
from raybundle.observations.kind import in_order
from raybundle.orientation.absolute import partial_similarity
from raybundle.orientation.projective.missing_data import Lack
from raybundle.orientation.rays import intersect_linear, object_rays, rays_of
from raybundle.placing.positions import determined_shifts, free_shifts

FIGURES: Mapping[LineKind, type[OnFigure]] = {
    "straight": Lines, "plumb": PlumbLines, "level": Levels, "plane": Planes,
}  # fmt: skip
"""The tables of the figures that are measured by hand."""
UP = np.array([0.0, 0.0, 1.0])
FAR_APART = 1e5
"""How many times farther than the others a control point may lie: a metre apart, and 100 km away."""
PARALLEL = 1e-7
"""Ratio of eigenvalues below which rays are parallel, as where control is intersected."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Merged:
    """A block with what was measured by hand."""

    block: Block
    left_out: Mapping[str, str] = field(default_factory=dict[str, str])
    """point, bar or line -> why it does not stand in the block"""
    new: bool = False
    """whether photographs were oriented from the marks"""
    lacking: tuple[Lack, ...] = ()
    """what photographs without orientation lack; their marks do not stand in the block"""
    unknown: tuple[str, ...] = ()
    """cameras whose constant comes from the marks alone"""
    film: tuple[str, ...] = ()
    """what is to be stated of fiducial marks, in sentences"""
    marked: frozenset[str] = frozenset()
    """points that are marked by hand"""


def merge(block: Block, state: State, scans: Scans | None = None) -> Merged:
    """The block with points, marks, control, bars, lines and rejections of a state.

    A mark stands in place of the block's own observation of that point in that image.  Photographs without orientation
    are oriented from their marks, as far as these allow.  Where nothing fixed the block in
    space and control is measured now, it is brought there; where bars alone are, to their scale; where axes are
    defined by points, into these: their coordinates that are 0 by definition are held.
    scans   what is known of the film that photographs are scans of: their fiducial marks say where they lie
    raises  InputError for axes beside control, and for what names an image that the block does not hold
    """
    film = placed(block, state, scans)
    state = _without_marks(state, {k.image for k in film.lacking})
    base = _renamed(film.block, state)
    free = not _fixed(base)
    start = oriented(_with_marks(base, state), state, free=free)
    made = start.block
    places = _met(made, [k for k, name in enumerate(made.points.ids) if name in state.points or _of_use(name, state)])
    made, places = _placed(made, state, places, free=free and not start.by_control)
    if base.stations.antenna is not None and not determined_shifts(base):
        made, places = _shifted(made, state, places)
    made = _with_points(made, state, places)
    check_far_apart(made, state)
    if not free:
        check_names(made, state, places)
    made, out = _without_thin(made, state)
    made = made if determined_shifts(base) else free_shifts(made)
    made = _with_tables(made, state, out)
    if state.datum is not None:
        made = _in_axes(made, state.datum)
    return Merged(
        block=_with_rejected(made, state), left_out=out, new=start.new, unknown=start.unknown,
        lacking=(*film.lacking, *(k for k in start.lacking if k.image not in {f.image for f in film.lacking})),
        film=film.words, marked=frozenset(p for _, p in state.marks),
    )  # fmt: skip


def _without_marks(state: State, images: set[str]) -> State:
    """The state without the marks in some images."""
    if not images:
        return state
    return replace(state, marks={k: m for k, m in state.marks.items() if k[0] not in images})


def _fixed(block: Block) -> bool:
    """Whether something puts a block into its object space."""
    return bool(block.points.is_control.any() or len(block.stations) or len(block.table(Coordinates)))


def _fixing(block: Block, *, upright: bool = True) -> list[str]:
    """What of a block shows where its axes are, in words: control, and observations in axes that exist already.

    upright  whether what shows no more than the vertical counts
    """
    found = ["control points"] if block.points.is_control.any() else []
    kinds = (k for k in in_order() if k.table is not None and k.carries_datum and not k.fixes_scale)
    kinds = (k for k in kinds if upright or not (k.table is not None and k.table.upright))
    return found + [k.title[:1].lower() + k.title[1:] for k in kinds if len(k.table_of(block))]


def _of_use(name: str, state: State) -> bool:
    return any(name in pair for pair in state.bars) or (state.datum is not None and name in state.datum.points)


def _renamed(block: Block, state: State) -> Block:
    if not state.renamed:
        return block
    ids = tuple(state.renamed.get(name, name) for name in block.points.ids)
    rejected = tuple((i, state.renamed.get(p, p)) for i, p in block.rejected)
    return replace(block, points=replace(block.points, ids=ids), rejected=rejected)


def _with_marks(block: Block, state: State) -> Block:
    """With all marks, and the points that the block did not hold."""
    point = {name: k for k, name in enumerate(block.points.ids)}
    image = {name: k for k, name in enumerate(block.images.ids)}
    fresh = [name for name in state.points if name not in point]
    point |= {name: len(block.points) + k for k, name in enumerate(fresh)}
    n, p, o = len(fresh), block.points, block.observations
    rows: list[tuple[int, int]] = []
    places: list[Array] = []
    covariances: list[tuple[float, float, float]] = []
    for (name, pid), mark in state.marks.items():
        i = image.get(name)
        if i is None:
            raise InputError("mark.image_not_in_block", point=pid, image=name)
        xy, C = in_camera(block, i, mark)
        rows.append((i, point[pid]))
        places.append(xy)
        covariances.append((float(C[0, 0]), float(C[1, 1]), float(C[0, 1])))
    total = len(p) + n
    key = np.asarray(o.image, np.int64) * total + o.point
    marked = np.array([i * total + k for i, k in rows], np.int64)
    by_hand, none = np.array(rows, np.int32).reshape(-1, 2), np.full((n, 3), np.nan)
    return replace(
        block,
        observations=o.rows(~np.isin(key, marked)).append(
            Observations(
                image=by_hand[:, 0],
                point=by_hand[:, 1],
                xy_px=np.array(places, float).reshape(-1, 2),
                cov_px2=np.array(covariances, float).reshape(-1, 3),
            )
        ),
        points=p.append(Points(ids=tuple(fresh), role=np.full(n, Role.TIE, np.int32), xyz=none, sigma=none)),
        rejected=tuple(r for r in block.rejected if r not in state.marks),
    )


def _met(block: Block, which: Sequence[int]) -> Array:
    """(p, 3) where the rays of some points meet, in the frame of the images; NaN of the others."""
    xyz = np.full((len(block.points), 3), np.nan)
    o = block.observations
    rows = np.flatnonzero(np.isin(o.point, np.array(which, np.int64)) & block.images.oriented[o.image])
    scenes = np.array([c.is_scene for c in block.cameras], bool)
    rows = rows[~scenes[block.images.camera[o.image[rows]]]]
    if not len(rows):
        return xyz
    part = o.rows(rows)
    rays = rays_of(replace(block, observations=part))
    direction = object_rays(block.images.rotation[part.image], rays.direction)
    number, index = np.unique(part.point, return_inverse=True)
    found, count, ratio = intersect_linear(
        block.images.centre[part.image], direction, index.astype(np.int32), len(number)
    )  # fmt: skip
    good = (count > 1) & (ratio > PARALLEL)
    xyz[number[good]] = found[good]
    return xyz


def _placed(block: Block, state: State, places: Array, *, free: bool) -> tuple[Block, Array]:
    """Brought to where control states, or to the scale of bars, where nothing fixed the block before."""
    if not free:
        return block, places
    change = _to_control(block, state, places) or _to_bars(block, state, places)
    if change is None:
        return block, places
    s, R, t = change
    by = SimilarityTransform(scale=s, rotation=R, translation=t)
    return replace(transform_block(block, by, observed="stay"), free_scale=False), by.points(places)


def _shifted(block: Block, state: State, places: Array) -> tuple[Block, Array]:
    """Moved to where control states: from there the shift of positions is found, however large it is."""
    given = np.full_like(places, np.nan)
    for k, name in enumerate(block.points.ids):
        if name in state.points and state.points[name].role == "control":
            given[k] = _numbers(state.points[name].xyz)
    apart = given - places
    known = np.isfinite(apart).any(axis=0)
    shift = np.zeros(3)
    shift[known] = np.nanmedian(apart[:, known], axis=0)
    by = SimilarityTransform(translation=shift)
    return transform_block(block, by, observed="stay"), by.points(places)


def _to_control(block: Block, state: State, places: Array) -> tuple[float, Array, Array] | None:
    index = {name: k for k, name in enumerate(block.points.ids)}
    control = {name: v for name, v in state.points.items() if v.role == "control"}
    at = np.array([index[name] for name in control], np.int64)
    target = np.array([_numbers(v.xyz) for v in control.values()]).reshape(-1, 3)
    seen = np.isfinite(places[at]).all(axis=1) if len(at) else np.zeros(0, bool)
    at, target = at[seen], target[seen]
    given = np.isfinite(target)
    full = given.all(axis=1)
    if full.sum() >= 3:
        try:
            found = similarity(places[at[full]], target[full])
        except InputError:  # in one line: what else is given decides, below
            pass
        else:
            return found.scale, found.rotation, found.translation
    if given.sum() >= 7 and len(at) >= 3:
        return partial_similarity(places[at], np.where(given, target, 0.0), given)
    return None


def _to_bars(block: Block, state: State, places: Array) -> tuple[float, Array, Array] | None:
    index = {name: k for k, name in enumerate(block.points.ids)}
    xyz = np.where(np.isfinite(places), places, block.points.xyz)
    ratios = [bar.length / np.linalg.norm(xyz[index[a]] - xyz[index[b]]) for (a, b), bar in state.bars.items()]
    ratios = [float(r) for r in ratios if np.isfinite(r) and r > 0]
    if not ratios or len(block.distances):
        return None
    return float(np.median(ratios)), np.eye(3), np.zeros(3)


def _with_points(block: Block, state: State, places: Array) -> Block:
    """Roles and given coordinates; approximate ones where the rays meet."""
    p = block.points
    role, xyz, sigma = np.array(p.role), np.array(p.xyz), np.array(p.sigma)
    index = {name: k for k, name in enumerate(p.ids)}
    for name, value in state.points.items():
        k = index[name]
        if value.reported:
            role[k] = ROLES[value.role]
            given, s = _numbers(value.xyz), _numbers(value.sigma)
            if value.role == "tie":
                s = np.full(3, np.nan)
            xyz[k] = np.where(np.isfinite(given), given, places[k])
            sigma[k] = np.where(np.isfinite(given), s, np.nan)
        elif not np.isfinite(xyz[k]).all():
            xyz[k] = places[k]
    return replace(block, points=replace(p, role=role.astype(np.int32), xyz=xyz, sigma=sigma))


def check_far_apart(block: Block, state: State) -> None:
    """Raise InputError for control given by hand that lies absurdly far from all other control of a block.

    Distances are from the median of all control with three coordinates, each against the median distance of the others.
    """
    p = block.points
    at = np.flatnonzero(np.isfinite(p.xyz).all(axis=1) & p.is_control.all(axis=1))
    if len(at) < 3:
        return
    far = np.linalg.norm(p.xyz[at] - np.median(p.xyz[at], axis=0), axis=1)
    worst = int(np.argmax(far))
    rest = float(np.median(np.delete(far, worst)))
    name = p.ids[at[worst]]
    if name in state.points and far[worst] > FAR_APART * rest > 0:
        raise InputError(
            "mark.control_far_away",
            point=name,
            distance=far[worst],
            unit=block.length_unit,
            ratio=far[worst] / rest,
            limit=FAR_APART,
        )


def _without_thin(block: Block, state: State) -> tuple[Block, dict[str, str]]:
    """Without points measured by hand that nothing determines yet."""
    rays, p = block.ray_count, block.points
    out: dict[str, str] = {}
    gone = np.zeros(len(p), bool)
    for k, name in enumerate(p.ids):
        if name not in state.points:
            continue
        if p.role[k] == Role.TIE and rays[k] < 2:
            marks = len(state.marks_of(name))
            oriented = marks >= 2 if rays[k] else marks > 0
            out[name] = phrase("measuring.too_few_marks", n=int(rays[k]), oriented=oriented)
        elif p.role[k] != Role.TIE and rays[k] == 0:
            role, oriented = state.points[name].role, bool(state.marks_of(name))
            out[name] = phrase("measuring.unmarked_point", role=role, oriented=oriented)
        gone[k] = name in out
    if not gone.any():
        return block, out
    o, keep = block.observations, ~gone[block.observations.point]
    return select_block(replace(block, observations=o.rows(keep)), "point", ~gone), out


def _with_tables(block: Block, state: State, out: dict[str, str]) -> Block:
    index = {name: k for k, name in enumerate(block.points.ids)}
    bars = {pair: bar for pair, bar in state.bars.items() if _there(pair, f"{pair[0]}-{pair[1]}", index, out)}
    d = block.distances
    new = {frozenset((index[a], index[b])) for a, b in bars}
    old = np.array([frozenset(pair) not in new for pair in zip(d.start.tolist(), d.end.tolist(), strict=True)], bool)
    added = Distances(
        start=np.array([index[a] for a, _ in bars], np.int32), end=np.array([index[b] for _, b in bars], np.int32),
        length=np.array([b.length for b in bars.values()], float),
        sigma=np.array([b.sigma for b in bars.values()], float),
    )  # fmt: skip
    made = _upright(block, state, index).having(d.rows(old).append(added))
    return made.having(*(_lines(made, state, kind, table, index, out) for kind, table in FIGURES.items()))


def _upright(block: Block, state: State, index: Mapping[str, int]) -> Block:
    """Turned so that the vertical that is measured by hand is Z, where nothing has stated the vertical before."""
    figures = [line for line in state.lines.values() if line.upright and all(p in index for p in line.points)]
    if not figures or _fixing(block):
        return block
    reported: dict[str, list[Array]] = {"level": [], "plumb": []}
    for line in figures:
        reported[line.kind].append(block.points.xyz[[index[p] for p in line.points]])
    if not all(np.isfinite(xyz).all() for part in reported.values() for xyz in part):
        return block
    R = turn_between(vertical(reported["level"], reported["plumb"], UP), UP)
    return transform_block(block, SimilarityTransform(rotation=R, translation=np.zeros(3)), observed="stay")


def _lines(
    block: Block, state: State, kind: str, table: type[OnFigure], index: Mapping[str, int], out: dict[str, str]
) -> OnFigure:
    """The block's figures of a kind with those measured by hand, which replace those of the same name."""
    lines = {n: line for n, line in state.lines.items() if line.kind == kind and _there(line.points, n, index, out)}
    there = block.table(table)
    kept = there.rows(np.array([n not in lines for n in there.figure], bool))
    rows = [(n, index[point], line.sigma) for n, line in lines.items() for point in line.points]
    fresh = table(
        figure=tuple(r[0] for r in rows), point=np.array([r[1] for r in rows], np.int32),
        sigma=np.array([r[2] for r in rows], float),
    )  # fmt: skip
    return kept.append(fresh)


def _there(points: Sequence[str], name: str, index: Mapping[str, int], out: dict[str, str]) -> bool:
    lacking = [p for p in points if p not in index]
    if lacking:
        cause = out.get(lacking[0]) or phrase("measuring.not_in_block")
        out[name] = phrase("measuring.point_left_out", point=lacking[0], cause=cause)
    return not lacking


def _in_axes(block: Block, axes: Axes) -> Block:
    """In the axes of points, whose coordinates are held as far as they are 0 by definition."""
    if fixing := _fixing(block, upright=bool(axes.plane)):
        raise InputError("axes.contradicts_block", names=axes.points, tables=fixing)
    index = {name: k for k, name in enumerate(block.points.ids)}
    at = [index.get(name, -1) for name in axes.points]
    xyz = np.array([block.points.xyz[k] if k >= 0 else np.full(3, np.nan) for k in at])
    if axes.plane:
        check_points(axes.points, xyz)
        R, zero = by_points(xyz), BY_POINTS
    else:
        if not any(len(k.table_of(block)) for k in in_order() if k.table is not None and k.table.upright):
            raise InputError("axes.no_vertical", names=axes.points)
        check_direction(axes.points, xyz, UP)
        R, zero = by_vertical(xyz, UP), BY_VERTICAL
    moved = transform_block(block, SimilarityTransform(rotation=R, translation=-R @ xyz[0]), observed="stay")
    p = moved.points
    role, new, sigma = np.array(p.role), np.array(p.xyz), np.array(p.sigma)
    for k, held in zip(at, zero, strict=True):
        role[k] = Role.CONTROL
        new[k, list(held)], sigma[k] = 0.0, np.nan
        sigma[k, list(held)] = 0.0
    return replace(moved, points=replace(p, role=role, xyz=new, sigma=sigma))


def _with_rejected(block: Block, state: State) -> Block:
    rejected = dict.fromkeys((*block.rejected, *sorted(state.rejected - state.marks.keys())))
    return replace(block, rejected=tuple(rejected))


def _numbers(values: Sequence[float | None]) -> Array:
    return np.array([np.nan if v is None else v for v in values], float)
