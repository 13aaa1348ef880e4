"""From a free block to object space: control and check points, scale bars, GNSS positions, coordinate system."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from raybundle.adjustment.blunders.identical_control import identical_notices
from raybundle.adjustment.records.notice import Notice, notice_of_text
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Role
from raybundle.block.rejection import Rejection
from raybundle.block.select import with_rows
from raybundle.block.transform import transform_block
from raybundle.errors import InputError, Value
from raybundle.io.geo.coordinate_systems import WGS84, LocalFrame, local_frame
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.transform import SimilarityTransform, similarity
from raybundle.orientation.rays import object_rays, rays_of
from raybundle.orientation.similarity_onto_rays import KnownRays, onto_rays
from raybundle.placing.attitudes import observe_attitudes
from raybundle.placing.exchanged_axes import control_as_read, positions_as_read
from raybundle.placing.exchanged_control import without_exchanged_positions, without_misread_control
from raybundle.placing.marks import (
    Given,
    Placing,
    add_bars,
    add_points,
    drop_gross_marks,
    drop_single_marks,
    drop_unseen_checks,
    intersected,
    without_empty_control,
)
from raybundle.placing.mirrored import mirrored_notices, without_control
from raybundle.placing.positions import SCALE, Positions, mean_place, observe, positions_of, scale_sigma, turn_sigma
from raybundle.placing.rescaled_marks import take_at_their_size
from raybundle.placing.rotated_marks import take_turned_back
from raybundle.placing.rounded_marks import take_eccentricity_off
from raybundle.placing.scale_bar_units import without_strange_bars
from raybundle.placing.upright import Upright, doubts, upright
from raybundle.placing.wrong_positions import without_wrong_positions

LEVEL = 0.05
"""Tangent of the angle to which a block is level by the viewing direction of its photographs."""
TRIALS = 2000
TOLD, PASSED = 8, 0.05
"""Coordinates that rays to control must show, one more than a similarity has, and by how much they may miss [rad]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Georeferenced:
    """A block in object space, as far as that is known."""

    block: Block
    frame: LocalFrame | None
    notices: tuple[Notice, ...]
    marked: Mask
    """(p,) points that were marked in photographs"""
    fixed: bool
    """placed in the object system by control or positions"""
    firm: bool = True
    """whether they also show how it is turned; positions in a line do not"""
    upright: Upright | None = None
    """how the vertical was found, where neither control nor positions show it"""
    joined: tuple[tuple[str, ...], ...] = ()
    """photographs of each part, where the block is of several without common points"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Surroundings:
    """What stands in object space already: satellite scenes."""

    frame: LocalFrame
    places: Mapping[str, Array]
    """Name of a marked point -> its place (3,) by the scenes, good enough to begin with"""


def georeference(
    block: Block, photos: Sequence[Photo], given: Given, around: Surroundings | None = None
) -> Georeferenced:
    """Add what is known of object space to a free block and bring the block there.

    around  what the block is brought to; None: to the control or the positions, in their frame
    The similarity onto control or GNSS positions is found robustly (least median of squares), so that a blunder among
    them does not bend it; the adjustment afterwards tests each of them.
    raises  InputError for photographs, points or coordinate systems that do not fit together
    """
    state = Placing(block)
    frame = frame_of(photos, given) if around is None else around.frame
    if frame is not None and around is None:
        state.notices.append(place_notice(frame, given))
    add_points(state, photos, given, frame)
    state.notices += identical_notices(state.block)
    add_bars(state, given)
    if around is None:  # else a scene may show the point as well
        drop_single_marks(state)
    take_turned_back(state, photos, given.control, given.mark_px)
    take_at_their_size(state, given.control, given.mark_px)
    free = intersected(state.block)
    drop_gross_marks(state, free)
    _drop_wrong_control(state, free, given, frame)
    control = _control_to_fit(state.block, free)
    positions = None if frame is None or not given.gps else _likely_positions(state, photos, frame)
    alone = positions is None or len(positions) < 3
    fixed = firm = _fix_by_control(state, photos, free, control, given, alone=alone, around=around)
    if not fixed and positions is not None:
        fixed = _fix_by_positions(state, photos, positions, given)
        firm = turn_sigma(positions) <= SCALE
        _refuse_little_control(state, control, given, placed=fixed)
    if fixed and positions is not None and len(positions):
        observe(state, positions, given)
    if fixed and frame is not None:
        observe_attitudes(state, photos, given, frame)
    if fixed and len(state.block.distances):
        state.block, removed = without_strange_bars(state.block)
        state.notices += removed
    if not fixed:
        drop_single_marks(state)
        _fix_by_bars(state, photos, free, given)
        frame = None
    if frame is not None and around is None:
        own = () if given.positions_frame is None else given.positions_frame.remarks
        remarks = dict.fromkeys((*frame.remarks, *own))
        state.notices += [notice_of_text("coordinate_system", r) for r in remarks]
    state.notices += [notice_of_text("control_file", r) for c in given.control for r in c.remarks]
    if fixed or len(state.block.distances):  # in metres
        take_eccentricity_off(state, given.control)
    drop_unseen_checks(state)
    marked = np.asarray(state.block.points.role) != Role.TIE
    return Georeferenced(
        block=without_empty_control(state.block),
        frame=frame,
        notices=tuple(state.notices),
        marked=marked,
        fixed=fixed,
        firm=firm or len(state.block.attitudes) > 0,
        upright=state.upright,
    )


def frame_of(photos: Sequence[Photo], given: Given) -> LocalFrame | None:
    """A local frame in the coordinate system of the control, else of the list of positions, else WGS 84."""
    systems = {c.crs for c in given.control if c.crs}
    if len(systems) > 1:
        raise InputError("control.several_systems", systems=sorted(systems))
    if systems:
        crs = systems.pop()
        xyz = np.vstack([c.xyz for c in given.control if c.crs == crs])
        height = float(np.nanmean(xyz[:, 2])) if np.isfinite(xyz[:, 2]).any() else np.nan
        return local_frame(crs, (float(np.nanmean(xyz[:, 0])), float(np.nanmean(xyz[:, 1])), height))
    mean = mean_place(photos)
    if any(np.isfinite(c.xyz).any() for c in given.control) or not given.gps or mean is None:
        return None
    return given.positions_frame or local_frame(WGS84, mean)


def place_notice(frame: LocalFrame, given: Given) -> Notice:
    """Where on the earth control or positions lie, from which a reader sees an exchanged sign or column."""
    lon, lat = frame.wgs84_from_local(np.zeros((1, 3)))[0, :2].tolist()
    return Notice(
        code="place.of_block",
        values={
            "of": "control" if any(c.crs for c in given.control) else "positions",
            "latitude": lat, "longitude": lon, "latitude_deg": abs(lat), "longitude_deg": abs(lon),
            "north": "S" if lat < 0 else "N", "east": "W" if lon < 0 else "E",
        },
    )  # fmt: skip


def _drop_wrong_control(state: Placing, free: Array, given: Given, frame: LocalFrame | None) -> None:
    """Take all control out where its columns or axes are misread, or else misread points of it."""
    state.block, found = control_as_read(
        state.block, free, given.control, None if frame is None else frame.undulation_m
    )
    state.notices += found
    if found:
        return
    mirrored = mirrored_notices(state.block, free)
    state.notices += mirrored
    if mirrored:
        state.block = without_control(state.block)
        return
    state.block, found = without_misread_control(state.block, free, units=frame is None)
    state.notices += found


def _likely_positions(state: Placing, photos: Sequence[Photo], frame: LocalFrame) -> Positions:
    """The positions that photographs state, without those that are misread."""
    positions = positions_of(photos, state.block.images.oriented, frame)
    positions, found = positions_as_read(state.block, photos, positions)
    if found:
        state.notices += found
        return positions
    positions, found = without_exchanged_positions(state.block, positions)
    state.notices += found
    if not found:
        positions, found = without_wrong_positions(state.block, positions)
        state.notices += found
    return positions


def _control_to_fit(block: Block, free: Array) -> Index:
    """Control points with a place in the free block and at least a known plan position."""
    given = block.points.is_control
    return np.flatnonzero(given[:, 0] & given[:, 1] & np.isfinite(free).all(axis=1))


def _fix_by_control(
    state: Placing,
    photos: Sequence[Photo],
    free: Array,
    control: Index,
    given: Given,
    *,
    alone: bool,
    around: Surroundings | None = None,
) -> bool:
    """Move the block onto the control; False where there is none, or too little and positions that may help."""
    block = state.block
    if not block.points.is_control.any() and around is None:
        return False
    height = block.points.is_control[control, 2]
    target = block.points.xyz
    if height.sum() >= 3 and not _collinear(target[control[height]]):
        chosen = control[height]
        s, R, t = _robust(free[chosen], target[chosen], 3)
        residual = s * free[chosen] @ R.T + t - target[chosen]
    elif (by_rays := _by_rays(block, free, around)) is not None:
        s, R, t = by_rays
        residual = s * free[control[height]] @ R.T + t - target[control[height]]
    elif len(control) >= 2:
        # what satellites see as well is the ground
        up = _level(state, photos, free, given.up if around is None else "aerial")
        flat = free @ up.T
        s, turn, shift = _robust_plan(flat[control], target[control])
        R = turn @ up
        known = control[height]
        t = shift.copy()
        lifted = s * free @ R.T
        t[2] = (
            float(np.median(target[known, 2] - lifted[known, 2]))
            if len(known)
            else -float(np.median(lifted[control, 2]))
        )
        residual = (lifted[control] + t - target[control])[:, :2]
    else:
        if alone:
            _refuse_little_control(state, control, given, placed=False)
        return False
    _apply(state, free, s, R, t)
    _weigh_control(state, given, residual)
    _guess_heights(state)
    return True


def _by_rays(block: Block, free: Array, around: Surroundings | None) -> tuple[float, Array, Array] | None:
    """The similarity onto control of which too little has two rays; None where its rays do not determine it either.

    Where control alone does not, the places of marked points by the scenes help.
    """
    full = np.isin(np.arange(len(block.points)), np.flatnonzero(block.points.is_control.all(axis=1)))
    known = np.where(full[:, None], block.points.xyz, np.nan)
    found = _by_rays_to(block, free, known)
    if found is None and around is not None:
        for k, name in enumerate(block.points.ids):
            if name in around.places and not np.isfinite(known[k]).all():
                known[k] = around.places[name]
        found = _by_rays_to(block, free, known)
    return found


def _by_rays_to(block: Block, free: Array, known: Array) -> tuple[float, Array, Array] | None:
    """The similarity onto points (p, 3) that are known, else NaN."""
    o = block.observations
    mine = np.isin(o.point, np.flatnonzero(np.isfinite(known).all(axis=1))) & np.asarray(block.images.oriented)[o.image]
    _, count = np.unique(o.point[mine], return_counts=True)
    if np.minimum(2 * count, 3).sum() < TOLD:
        return None
    image, point = o.image[mine], o.point[mine]
    rays = KnownRays(
        image=image,
        point=point,
        target=known[point],
        centre=block.images.centre[image],
        direction=object_rays(block.images.rotation[image], rays_of(with_rows(block, mine)).direction),
    )
    found = onto_rays(rays, free[point])
    if found is None or np.median(found.angle) > PASSED:
        return None
    return found.scale, found.rotation, found.translation


def _refuse_little_control(state: Placing, control: Index, given: Given, *, placed: bool) -> None:
    """Raise InputError where there is control but nothing that placed the block."""
    if placed or not state.block.points.is_control.any():
        return
    raise InputError(
        "control.too_few_measured", n=len(control), least=2, file=given.control[0].path if given.control else None
    )


def _apply(state: Placing, free: Array, s: float, R: Array, t: Array) -> None:
    """Transform the block; control and check points keep what was given, the rest of them is intersected."""
    before = state.block.points
    by = SimilarityTransform(scale=s, rotation=R, translation=t)
    moved = transform_block(state.block, by, observed="stay")
    special = np.asarray(before.role) != Role.TIE
    place = by.points(free)
    xyz = moved.points.xyz.copy()
    xyz[special] = np.where(np.isfinite(before.xyz[special]), before.xyz[special], place[special])
    tie = ~special & np.isfinite(free).all(axis=1)
    xyz[tie] = place[tie]
    # a point marked once begins at the height of the others
    lost = special & ~np.isfinite(xyz).all(axis=1)
    if lost.any():
        middle = np.nanmedian(xyz[~lost], axis=0)
        xyz[lost] = np.where(np.isfinite(xyz[lost]), xyz[lost], middle)
    state.block = replace(moved, points=replace(moved.points, xyz=xyz))


def _weigh_control(state: Placing, given: Given, residual: Array) -> None:
    """Where the file states no standard deviation and the points fit worse, the fit states how good they are."""
    block, d = state.block, given.defaults
    if given.sigma_given or not len(residual):
        return
    scatter = float(np.median(np.linalg.norm(residual[:, :2], axis=1)) / 1.1774)  # median of a Rayleigh variable
    assumed = {i for c in given.control for k, i in enumerate(c.ids) if c.stated is None or not c.stated[k]}
    default = np.array([i in assumed for i in block.points.ids], bool) & (np.asarray(block.points.role) == Role.CONTROL)
    default &= (block.points.sigma[:, :2] == d.plan).all(axis=1)
    if not default.any() or scatter <= 3 * d.plan or len(residual) < 4:
        return
    sigma = block.points.sigma.copy()
    ratio = scatter / d.plan
    sigma[default] *= ratio
    state.block = replace(block, points=replace(block.points, sigma=sigma))
    state.notify(
        "control_sigma", plan_m=scatter, assumed_plan_m=d.plan, height_m=ratio * d.height, assumed_height_m=d.height
    )


def _guess_heights(state: Placing) -> None:
    """Plan control alone hardly states what is level: the viewing direction does, to a few degrees."""
    block = state.block
    given = block.points.is_control
    if given[:, 2].sum() >= 3 or not given[:, 0].any():
        return
    plan = given[:, 0] & ~given[:, 2] & np.isfinite(block.points.xyz).all(axis=1)
    if not plan.any():
        return
    extent = float(np.ptp(block.points.xyz[plan][:, :2], axis=0).max()) or 1.0
    sigma = block.points.sigma.copy()
    sigma[plan, 2] = LEVEL * extent
    state.block = replace(block, points=replace(block.points, sigma=sigma))
    state.notify(
        "levelled", *(block.points.ids[k] for k in np.flatnonzero(plan)),
        angle_deg=float(np.degrees(LEVEL)), sigma_m=LEVEL * extent,
    )  # fmt: skip


def _fix_by_positions(state: Placing, photos: Sequence[Photo], positions: Positions, given: Given) -> bool:
    """Move the block onto the positions that the photographs state; False where they are too few or too near."""
    if len(positions) < 3:
        return False
    weak = scale_sigma(positions)
    if weak > SCALE:
        state.notify("gps_too_near", n=len(positions), scale=weak, limit=SCALE)
        return False
    local = positions.xyz
    heights = np.isfinite(local[:, 2])
    free = state.block.images.centre[positions.image]
    if heights.sum() >= 3 and not _collinear(local[heights]) and not _collinear(free[heights]):
        s, R, t = _robust(free[heights], local[heights], 3)
    else:
        up = _level(state, photos, intersected(state.block), given.up)
        s, turn, t = _robust_plan(free @ up.T, local)
        R = turn @ up
        lifted = s * free @ R.T
        t[2] = float(np.median((local - lifted)[heights, 2])) if heights.any() else 0.0
    if not s > 0:
        return False
    _apply(state, intersected(state.block), s, R, t)
    return True


def _fix_by_bars(state: Placing, photos: Sequence[Photo], free: Array, given: Given) -> None:
    """A free block gets the scale of its bars, stands upright and has its middle at the origin."""
    block = state.block
    d = block.distances
    R = _level(state, photos, free, given.up)
    s = 1.0
    if len(d):
        measured = np.linalg.norm(free[d.start] - free[d.end], axis=1)
        if not np.isfinite(measured).all():
            k = int(np.flatnonzero(~np.isfinite(measured))[0])
            raise InputError(
                "scale_bar.too_few_rays", start=block.points.ids[d.start[k]], end=block.points.ids[d.end[k]]
            )
        s = float(np.median(d.length / measured))
    tie = np.asarray(block.points.role) == Role.TIE
    middle = np.nanmedian(block.points.xyz[tie], axis=0)
    if not len(d):
        distance = np.linalg.norm(block.images.centre[block.images.oriented] - middle, axis=1)
        s = 10.0 / max(float(np.median(distance)), 1e-300)
    _apply(state, free, s, R, -s * R @ middle)


def _level(state: Placing, photos: Sequence[Photo], free: Array, way: str) -> Array:
    """Rotation that makes the block level, points at `free` (p, 3); what is not sure is reported."""
    block = state.block
    state.upright = upright(replace(block, points=replace(block.points, xyz=free)), photos, way)
    state.notices += doubts(state.upright, way)
    return state.upright.rotation


def _collinear(xyz: Array) -> bool:
    s = np.linalg.svd(xyz - xyz.mean(axis=0), compute_uv=False)
    return bool(len(s) < 2 or s[1] < 0.02 * s[0])


def _robust(source: Array, target: Array, least: int) -> tuple[float, Array, Array]:
    """Similarity target_from_source by least median of squares (Rousseeuw 1984), then least squares of the inliers."""
    best: tuple[float, tuple[float, Array, Array]] | None = None
    for chosen in _subsets(len(source), least):
        pick = list(chosen)
        if _collinear(source[pick]) or _collinear(target[pick]):  # so are two photographs with one position
            continue
        fit = _fit(source[pick], target[pick])
        cost = float(np.median(np.linalg.norm(fit[0] * source @ fit[1].T + fit[2] - target, axis=1)))
        if best is None or cost < best[0]:
            best = (cost, fit)
    fit = best[1] if best is not None else _fit(source, target)
    for _ in range(5):
        v = np.linalg.norm(fit[0] * source @ fit[1].T + fit[2] - target, axis=1)
        keep = v <= max(4 * float(np.median(v)), 1e-9)
        if keep.sum() < least:
            break
        fit = _fit(source[keep], target[keep])
    return fit


def _fit(source: Array, target: Array) -> tuple[float, Array, Array]:
    found = similarity(source, target)
    return float(found.scale), found.rotation, found.translation


def _robust_plan(source: Array, target: Array) -> tuple[float, Array, Array]:
    """The same in plan, about the vertical: scale, rotation (3, 3), translation (3,) with height 0."""
    a, b = source[:, 0] + 1j * source[:, 1], target[:, 0] + 1j * target[:, 1]
    best: tuple[float, complex, complex] | None = None
    for i, j in _subsets(len(a), 2):
        if abs(a[i] - a[j]) < 1e-9 * max(float(np.abs(a - a.mean()).max()), 1e-300):
            continue
        m = (b[i] - b[j]) / (a[i] - a[j])
        k = b[i] - m * a[i]
        cost = float(np.median(np.abs(m * a + k - b)))
        if best is None or cost < best[0]:
            best = (cost, complex(m), complex(k))
    assert best is not None
    _, m, k = best
    for _ in range(5):
        v = np.abs(m * a + k - b)
        keep = v <= max(4 * float(np.median(v)), 1e-9)
        if keep.sum() < 2:
            break
        x, y = a[keep] - a[keep].mean(), b[keep] - b[keep].mean()
        m = complex((np.conj(x) @ y) / (np.conj(x) @ x))
        k = complex(b[keep].mean() - m * a[keep].mean())
    c, s = m.real / abs(m), m.imag / abs(m)
    return abs(m), np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]), np.array([k.real, k.imag, 0.0])


def _subsets(n: int, least: int) -> list[tuple[int, ...]]:
    """All subsets of a small set, some by chance (fixed seed) of a large one."""
    from math import comb

    if comb(n, least) <= TRIALS:
        return list(combinations(range(n), least))
    rng = np.random.default_rng(1)
    return [tuple(int(i) for i in rng.choice(n, least, replace=False)) for _ in range(TRIALS)]


def _rejection_values(reason: Rejection) -> dict[str, Value]:
    tested = bool(np.isfinite(reason.tau))
    return {
        "kind": reason.kind.value, "tested": tested, "tau": reason.tau if tested else None,
        "limit": reason.limit if tested else None,
    }  # fmt: skip


def rejected_marks(result: Adjustment, marks: Mask) -> list[Notice]:
    """Image measurements of marked points that were rejected, each by name: control, check, ends of scale bars."""
    o, ids = result.given.observations, result.given.points.ids
    found: list[Notice] = []
    for k in np.flatnonzero(marks):
        reason = result.image_observations.rejected[k]
        if reason:
            name, file = ids[o.point[k]], result.given.images.ids[o.image[k]]
            found.append(
                Notice(
                    code="mark_rejected.test", ids=(name, file),
                    values={"point": name, "image": file, **_rejection_values(reason)},
                )
            )  # fmt: skip
    return found
