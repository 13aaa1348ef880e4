"""From a free block to object space: control and check points, scale bars, GNSS positions, coordinate system."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from pathlib import Path

import numpy as np

from raybundle.adjustment.predict import residuals_px
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.block import Block, Distances, Role, Stations
from raybundle.block.select import transformed
from raybundle.errors import InputError
from raybundle.io.control_files import DEFAULTS, ControlDefaults, ControlFile
from raybundle.io.coordinate_systems import WGS84, LocalFrame, local_frame
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.transform import similarity
from raybundle.orientation.rays import intersect_linear, object_rays, rays_of

MARK_PX = 0.5
"""Standard deviation of a point marked in a photograph."""
GPS_M = (5.0, 5.0, 10.0)
"""Standard deviation of a GPS position that states none."""
LEVEL = 0.05
"""Tangent of the angle to which a block is level by the viewing direction of its photographs."""
TRIALS = 2000
GROSS = 30.0
"""Distance of a mark from the others' place, in standard deviations of a mark, from which it is wrong beyond doubt."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ScaleBar:
    """A distance between two measured points."""

    start: str
    end: str
    length: float
    sigma: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Given:
    """What is known of object space."""

    control: tuple[ControlFile, ...] = ()
    """control and check points with their places in the photographs; the role stands in the file"""
    scale_bars: tuple[ScaleBar, ...] = ()
    gps: bool = True
    """use the positions that the photographs state, where there is no control"""
    defaults: ControlDefaults = DEFAULTS
    sigma_given: bool = False
    """the standard deviations in `defaults` are known, not assumed"""
    mark_px: float = MARK_PX


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


@dataclass(slots=True)
class _State:
    block: Block
    notices: list[Notice] = field(default_factory=list[Notice])

    def tell(self, code: str, message: str, *ids: str) -> None:
        self.notices.append(Notice(code=code, message=message, ids=ids))


def georeference(block: Block, photos: Sequence[Photo], given: Given) -> Georeferenced:
    """Add what is known of object space to a free block and bring the block there.

    The similarity onto control or GNSS positions is found robustly (least median of squares), so that a blunder among
    them does not bend it; the adjustment afterwards tests each of them.
    raises  InputError for photographs, points or coordinate systems that do not fit together
    """
    state = _State(block)
    frame = _frame(photos, given)
    _add_points(state, photos, given, frame)
    _add_bars(state, given)
    _drop_single_marks(state)
    free = _intersected(state.block)
    _drop_gross_marks(state, free, given.mark_px)
    control = _control_to_fit(state.block, free)
    fixed = _fix_by_control(state, free, control, given)
    if not fixed and frame is not None and given.gps:
        fixed = _fix_by_gps(state, photos, frame)
    if not fixed:
        _fix_by_bars(state, free)
        frame = None
    if frame is not None:
        state.notices += [Notice(code="coordinate_system", message=r) for r in frame.remarks]
    state.notices += [Notice(code="control_file", message=r) for c in given.control for r in c.remarks]
    marked = np.asarray(state.block.points.role) != Role.TIE
    return Georeferenced(
        block=_without_empty_control(state.block),
        frame=frame,
        notices=tuple(state.notices),
        marked=marked,
        fixed=fixed,
    )


def _without_empty_control(block: Block) -> Block:
    """Points of a control file of which nothing is known are tie points: measured by hand, that is all."""
    role = np.array(block.points.role)
    role[(role == Role.CONTROL) & ~block.points.is_control.any(axis=1)] = Role.TIE
    return replace(block, points=replace(block.points, role=role))


def _frame(photos: Sequence[Photo], given: Given) -> LocalFrame | None:
    """A local frame in the coordinate system of the control, else of the GPS positions."""
    systems = {c.crs for c in given.control if c.crs}
    if len(systems) > 1:
        raise InputError(f"control in different coordinate systems: {', '.join(sorted(systems))}; use one")
    if systems:
        crs = systems.pop()
        xyz = np.vstack([c.xyz for c in given.control if c.crs == crs])
        height = float(np.nanmean(xyz[:, 2])) if np.isfinite(xyz[:, 2]).any() else np.nan
        return local_frame(crs, (float(np.nanmean(xyz[:, 0])), float(np.nanmean(xyz[:, 1])), height))
    places = _gps(photos)
    if given.control or not given.gps or len(places) < 3:
        return None
    mean = np.nanmean(np.array([p for p, _ in places.values()]), axis=0)
    return local_frame(WGS84, (float(mean[0]), float(mean[1]), float(mean[2])))


def _gps(photos: Sequence[Photo]) -> dict[int, tuple[tuple[float, float, float], tuple[float, ...]]]:
    """Longitude, latitude, height and standard deviations of the photographs that state them."""
    found: dict[int, tuple[tuple[float, float, float], tuple[float, ...]]] = {}
    for i, photo in enumerate(photos):
        g = photo.metadata.gps
        if g is None:
            continue
        stated = g.sigma_m or (np.nan, np.nan, np.nan)
        sigma = tuple(s if np.isfinite(s) and s > 0 else d for s, d in zip(stated, GPS_M, strict=True))
        height = np.nan if g.altitude_m is None else g.altitude_m
        found[i] = (g.longitude_deg, g.latitude_deg, height), sigma
    return found


def _add_points(state: _State, photos: Sequence[Photo], given: Given, frame: LocalFrame | None) -> None:
    """Control and check points with their image measurements."""
    images = {p.name: i for i, p in enumerate(photos)}
    block = state.block
    ids, xyz, sigma, role = list[str](), list[Array](), list[Array](), list[int]()
    image, point, xy = list[int](), list[int](), list[Array]()
    for c in given.control:
        local = c.xyz if frame is None or not c.crs else frame.local_from_crs(c.xyz)
        for k, name in enumerate(c.ids):
            if name in ids:
                raise InputError(f"point {name} is given twice", file=c.path)
            ids.append(name)
            xyz.append(local[k])
            sigma.append(np.where(np.isfinite(local[k]), c.sigma[k], np.nan))
            role.append(int(c.role[k]))
        unknown: dict[str, int] = {}
        for name, k, at, line in zip(
            c.measurements.image, c.measurements.point, c.measurements.xy_px, c.measurements.line, strict=True
        ):
            i = _photo(images, name)
            if i is None:
                unknown[name] = unknown.get(name, 0) + 1
                continue
            size = photos[i].width_px, photos[i].height_px
            if not (0 <= at[0] <= size[0] and 0 <= at[1] <= size[1]):
                raise InputError(
                    f"{at[0]:g}, {at[1]:g} lies outside photograph {name} ({size[0]} x {size[1]} px); "
                    "measure in the photograph at its full size",
                    file=c.path, line=int(line),
                )  # fmt: skip
            if not block.images.oriented[i]:
                continue
            image.append(i)
            point.append(ids.index(c.ids[int(k)]))
            xy.append(at)
        if unknown:
            names = ", ".join(sorted(unknown)[:5])
            state.tell(
                "control_without_photograph",
                f"{sum(unknown.values())} measurements of {c.path.name} are in photographs that are not here: {names}",
            )
    if not ids:
        return
    n, o, p = len(block.points), block.observations, block.points
    variance = given.mark_px**2
    state.block = replace(
        block,
        observations=replace(
            o,
            image=np.concatenate([o.image, np.array(image, np.int32)]),
            point=np.concatenate([o.point, n + np.array(point, np.int32)]).astype(np.int32),
            xy_px=np.vstack([o.xy_px, np.array(xy).reshape(-1, 2)]),
            cov_px2=np.vstack([o.cov_px2, np.tile([variance, variance, 0.0], (len(image), 1))]),
        ),
        points=replace(
            p,
            ids=(*p.ids, *ids),
            role=np.concatenate([p.role, np.array(role, np.int32)]).astype(np.int32),
            xyz=np.vstack([p.xyz, np.array(xyz)]),
            sigma=np.vstack([p.sigma, np.array(sigma)]),
        ),
    )


def _drop_single_marks(state: _State) -> None:
    """Points of which nothing is given and that are marked once cannot be determined."""
    block = state.block
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    special = np.asarray(block.points.role) != Role.TIE
    single = special & ~block.points.is_control.any(axis=1) & (rays == 1)
    if not single.any():
        return
    names = tuple(block.points.ids[k] for k in np.flatnonzero(single))
    o, keep = block.observations, ~single[block.observations.point]
    state.block = replace(
        block,
        observations=replace(o, image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep], cov_px2=o.cov_px2[keep]),
    )
    state.tell("marked_once", f"marked in one photograph only, and so not determined: {', '.join(names)}", *names)


def _drop_gross_marks(state: _State, free: Array, mark_px: float) -> None:
    """Marks that lie far from where the other marks of their point meet: a wrong number, as a rule.

    Tested in the free block, whose orientation does not depend on them; smaller errors are left to data snooping.
    """
    block, o = state.block, state.block.observations
    special = np.asarray(block.points.role) != Role.TIE
    rows = np.flatnonzero(special[o.point] & np.isfinite(free[o.point]).all(axis=1))
    rays = np.bincount(o.point[rows], minlength=len(block.points))
    rows = rows[rays[o.point[rows]] > 2]
    if not len(rows):
        return
    xyz = np.where(np.isfinite(free), free, block.points.xyz)
    v = residuals_px(replace(block, points=replace(block.points, xyz=xyz)), rows)
    far = np.linalg.norm(v, axis=1)
    limit = GROSS * mark_px
    wrong = rows[~(far <= limit)]
    for k in wrong:
        name, file = block.points.ids[o.point[k]], block.images.ids[o.image[k]]
        beside = rows_near(block, int(k), special, limit)
        hint = f"; point {beside} is marked at the same place" if beside else ""
        state.tell(
            "mark_rejected",
            f"the measurement of point {name} in {file} lies {far[rows == k][0]:.0f} px from where its other "
            f"measurements put it (limit {limit:g} px) and is left out{hint}; look at it again",
            name, file,
        )  # fmt: skip
    if len(wrong):
        keep = np.ones(len(o), bool)
        keep[wrong] = False
        state.block = replace(
            block,
            observations=replace(
                o, image=o.image[keep], point=o.point[keep], xy_px=o.xy_px[keep], cov_px2=o.cov_px2[keep]
            ),
        )


def rows_near(block: Block, row: int, special: Mask, limit: float) -> str:
    """Another control or check point that is marked in the same photograph at the same place; empty if none is."""
    o = block.observations
    others = np.flatnonzero(special[o.point] & (o.image == o.image[row]) & (o.point != o.point[row]))
    if not len(others):
        return ""
    apart = np.linalg.norm(o.xy_px[others] - o.xy_px[row], axis=1)
    return block.points.ids[o.point[others[apart.argmin()]]] if apart.min() < limit else ""


def _photo(images: Mapping[str, int], name: str) -> int | None:
    """The photograph that a file of measurements means: by its name, without folder, case or suffix if need be."""
    if name in images:
        return images[name]
    plain = {Path(k).name.lower(): i for k, i in images.items()}
    stems = {Path(k).stem.lower(): i for k, i in images.items()}
    return plain.get(Path(name).name.lower(), stems.get(Path(name).stem.lower()))


def _add_bars(state: _State, given: Given) -> None:
    if not given.scale_bars:
        return
    index = {name: k for k, name in enumerate(state.block.points.ids)}
    for bar in given.scale_bars:
        for name in (bar.start, bar.end):
            if name not in index:
                raise InputError(
                    f"scale bar {bar.start} - {bar.end}: point {name} is not measured in any photograph; "
                    "give its image measurements with --control"
                )
    bars = given.scale_bars
    state.block = replace(
        state.block,
        distances=Distances(
            start=np.array([index[b.start] for b in bars], np.int32),
            end=np.array([index[b.end] for b in bars], np.int32),
            length=np.array([b.length for b in bars]),
            sigma=np.array([b.sigma for b in bars]),
        ),
    )


def _intersected(block: Block) -> Array:
    """(p, 3) points of control and check in the frame of the free block; NaN with fewer than two rays."""
    xyz = np.full((len(block.points), 3), np.nan)
    special = np.asarray(block.points.role) != Role.TIE
    ends = np.zeros(len(block.points), bool)
    ends[block.distances.start] = ends[block.distances.end] = True
    rows = np.flatnonzero((special | ends)[block.observations.point])
    if not len(rows):
        return xyz
    rays = rays_of(block)
    image = rays.image[rows]
    direction = object_rays(block.images.rotation[image], rays.direction[rows])
    point = rays.point[rows]
    for k in np.unique(point):
        mine = np.flatnonzero(point == k)
        if len(mine) > 1:
            xyz[k] = _meeting(block.images.centre[image[mine]], direction[mine])
    return xyz


def _meeting(centre: Array, direction: Array) -> Array:
    """Where rays (n, 3) meet; with three or more, where most of them do: a ray of a wrong point does not bend it."""
    n = len(centre)

    def at(pick: Array) -> Array:
        found, _, ratio = intersect_linear(centre[pick], direction[pick], np.zeros(len(pick), np.int32), 1)
        return found[0] if ratio[0] > 1e-7 else np.full(3, np.nan)

    def angles(X: Array) -> Array:
        ray = X - centre
        ray = ray / np.maximum(np.linalg.norm(ray, axis=1, keepdims=True), 1e-300)
        return np.linalg.norm(ray - direction, axis=1)

    everything = np.arange(n)
    if n == 2:
        return at(everything)
    best, cost = at(everything), np.inf
    for pair in combinations(range(n), 2):
        X = at(np.array(pair))
        if not np.isfinite(X).all():
            continue
        worth = float(np.sort(angles(X))[n // 2])
        if worth < cost:
            best, cost = X, worth
    near = np.flatnonzero(angles(best) <= max(4 * cost, 1e-4)) if np.isfinite(cost) else everything
    refined = at(near) if len(near) > 1 else best
    return refined if np.isfinite(refined).all() else best


def _control_to_fit(block: Block, free: Array) -> Index:
    """Control points with a place in the free block and at least a known plan position."""
    given = block.points.is_control
    return np.flatnonzero(given[:, 0] & given[:, 1] & np.isfinite(free).all(axis=1))


def _fix_by_control(state: _State, free: Array, control: Index, given: Given) -> bool:
    """Move the block onto the control; False where that does not suffice."""
    block = state.block
    if not block.points.is_control.any():
        return False
    height = block.points.is_control[control, 2]
    target = block.points.xyz
    if height.sum() >= 3 and not _collinear(target[control[height]]):
        chosen = control[height]
        s, R, t = _robust(free[chosen], target[chosen], 3)
        residual = s * free[chosen] @ R.T + t - target[chosen]
    elif len(control) >= 2:
        up = level_rotation(block)
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
        chosen = control
    else:
        state.tell(
            "control_too_little",
            f"{len(control)} control points with two or more rays; at least 2 are needed to place the block: "
            "measure more of them in the photographs",
        )
        raise InputError(state.notices[-1].message, file=given.control[0].path if given.control else None)
    _apply(state, free, s, R, t)
    _weigh_control(state, given, residual)
    _guess_heights(state)
    return True


def _apply(state: _State, free: Array, s: float, R: Array, t: Array) -> None:
    """Transform the block; control and check points keep what was given, the rest of them is intersected."""
    before = state.block.points
    moved = transformed(state.block, s, R, t)
    special = np.asarray(before.role) != Role.TIE
    place = s * free @ R.T + t
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


def _weigh_control(state: _State, given: Given, residual: Array) -> None:
    """Where the file states no standard deviation and the points fit worse, the fit says how good they are."""
    block, d = state.block, given.defaults
    if given.sigma_given:
        return
    scatter = float(np.median(np.linalg.norm(residual[:, :2], axis=1)) / 1.1774)  # median of a Rayleigh variable
    default = (block.points.sigma[:, :2] == d.plan).all(axis=1) & (np.asarray(block.points.role) == Role.CONTROL)
    if not default.any() or scatter <= 3 * d.plan or len(residual) < 4:
        return
    sigma = block.points.sigma.copy()
    ratio = scatter / d.plan
    sigma[default] *= ratio
    state.block = replace(block, points=replace(block.points, sigma=sigma))
    state.tell(
        "control_sigma",
        f"the file states no standard deviation of its control, and the points fit each other to {scatter:.3g} m: that "
        f"is taken for plan in place of {d.plan:g} m, and {ratio:.0f} times {d.height:g} m for heights; "
        "give sX, sY, sZ if you know better",
    )


def _guess_heights(state: _State) -> None:
    """Plan control alone hardly says what is level: the viewing direction does, to a few degrees."""
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
    state.tell(
        "levelled",
        f"heights of the control are not known: the block is levelled by the viewing direction of the photographs, "
        f"their heights are observed with {LEVEL * extent:.3g} m. Heights of the result are relative; "
        "three heights would level it",
    )


def _fix_by_gps(state: _State, photos: Sequence[Photo], frame: LocalFrame) -> bool:
    """Move the block onto the positions that the photographs state, and observe them."""
    places = _gps(photos)
    images = [i for i in places if state.block.images.oriented[i]]
    if len(images) < 3:
        return False
    geographic = np.array([places[i][0] for i in images])
    sigma = np.array([places[i][1] for i in images])
    local = frame.local_from_crs(geographic)
    heights = np.isfinite(local[:, 2])
    free = state.block.images.centre[images]
    if heights.sum() >= 3 and not _collinear(local[heights]):
        s, R, t = _robust(free[heights], local[heights], 3)
    else:
        up = level_rotation(state.block)
        s, turn, t = _robust_plan(free @ up.T, local)
        R = turn @ up
        lifted = s * free @ R.T
        t[2] = float(np.median((local - lifted)[heights, 2])) if heights.any() else 0.0
    if not s > 0:
        return False
    _apply(state, _intersected(state.block), s, R, t)
    state.block = replace(
        state.block,
        stations=Stations(
            image=np.array(images, np.int32), xyz=local, sigma=np.where(np.isfinite(local), sigma, np.nan)
        ),
    )
    state.tell("gps", f"object space by the GPS positions of {len(images)} photographs")
    return True


def _fix_by_bars(state: _State, free: Array) -> None:
    """A free block gets the scale of its bars, stands upright and has its middle at the origin."""
    block = state.block
    d = block.distances
    R = level_rotation(block)
    s = 1.0
    if len(d):
        measured = np.linalg.norm(free[d.start] - free[d.end], axis=1)
        if not np.isfinite(measured).all():
            k = int(np.flatnonzero(~np.isfinite(measured))[0])
            raise InputError(
                f"scale bar {block.points.ids[d.start[k]]} - {block.points.ids[d.end[k]]}: its end points need two or "
                "more rays each; measure them in more photographs"
            )
        s = float(np.median(d.length / measured))
    tie = np.asarray(block.points.role) == Role.TIE
    middle = np.nanmedian(block.points.xyz[tie], axis=0)
    if not len(d):
        distance = np.linalg.norm(block.images.centre[block.images.oriented] - middle, axis=1)
        s = 10.0 / max(float(np.median(distance)), 1e-300)
    _apply(state, free, s, R, -s * R @ middle)


def level_rotation(block: Block) -> Array:
    """Rotation that makes a free block level: Z against the common viewing direction, or along the images' upward axes.

    Photographs that look down together are aerial ones: Z is against their mean direction.  Otherwise Z is the mean
    upward direction of the photographs, X to the right of the mean view.
    """
    rotation = block.images.rotation[block.images.oriented]
    view = -rotation[:, 2].mean(axis=0)
    up = _upward(rotation)
    planar = _thickness(block)
    if np.linalg.norm(view) > 0.9 and planar:
        z = -view
        x = rotation[:, 0].mean(axis=0)
    else:
        z = up
        x = np.cross(view, up)
    z = z / np.linalg.norm(z)
    x = x - (x @ z) * z
    if np.linalg.norm(x) < 1e-6:
        x = np.linalg.svd(z[None])[2][1]
    x = x / np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z])


def _upward(rotation: Array) -> Array:
    """The direction nearest to one of the two axes of most images: turned photographs have theirs sideways."""
    axes = np.concatenate([rotation[:, 1], -rotation[:, 1], rotation[:, 0], -rotation[:, 0]])
    agreement = (np.clip(axes @ axes.T, 0, 1) ** 8).sum(axis=1)
    first = axes[: len(rotation)]
    best = first[int(agreement[: len(rotation)].argmax())]
    near = axes[axes @ best > 0.7]
    return near.mean(axis=0)


def _thickness(block: Block) -> bool:
    """Whether the object is flat seen along the mean view: its extent in depth small against its width."""
    tie = np.asarray(block.points.role) == Role.TIE
    xyz = block.points.xyz[tie]
    xyz = xyz[np.isfinite(xyz).all(axis=1)]
    view = -block.images.rotation[block.images.oriented][:, 2].mean(axis=0)
    view = view / max(float(np.linalg.norm(view)), 1e-12)
    depth = xyz @ view
    across = xyz - depth[:, None] * view
    spread = np.percentile(depth, 95) - np.percentile(depth, 5)
    width = np.linalg.norm(np.percentile(across, 95, axis=0) - np.percentile(across, 5, axis=0))
    centres = block.images.centre[block.images.oriented]
    base = np.linalg.norm(np.percentile(centres, 95, axis=0) - np.percentile(centres, 5, axis=0))
    distance = np.median(np.linalg.norm(centres - np.median(xyz, axis=0), axis=1))
    return bool(spread < 0.35 * width and base > 0.8 * distance)


def _collinear(xyz: Array) -> bool:
    s = np.linalg.svd(xyz - xyz.mean(axis=0), compute_uv=False)
    return bool(len(s) < 2 or s[1] < 0.02 * s[0])


def _robust(source: Array, target: Array, least: int) -> tuple[float, Array, Array]:
    """Similarity target_from_source by least median of squares (Rousseeuw 1984), then least squares of the inliers."""
    best: tuple[float, tuple[float, Array, Array]] | None = None
    for chosen in _subsets(len(source), least):
        pick = list(chosen)
        if _collinear(source[pick]):
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
    from math import comb  # noqa: PLC0415

    if comb(n, least) <= TRIALS:
        return list(combinations(range(n), least))
    rng = np.random.default_rng(1)
    return [tuple(int(i) for i in rng.choice(n, least, replace=False)) for _ in range(TRIALS)]


def accuracy(result: Adjustment) -> dict[str, object]:
    """Accuracy against check points in the sense of ASPRS (2023), and leave-one-out differences of the control.

    RMSE_H and RMSE_V combine the differences at the check points with the accuracy of the check points themselves;
    at least 30 check points are asked for there.  Leave-one-out: what a control coordinate would differ by had it
    taken no part, v / r (to first order, one coordinate at a time).
    """
    found: dict[str, object] = {}
    check = np.flatnonzero(np.asarray(result.given.points.role) == Role.CHECK)
    d = result.adjusted.points.xyz[check] - result.given.points.xyz[check]
    s = result.given.points.sigma[check]
    plan = np.isfinite(d[:, :2]).all(axis=1)
    high = np.isfinite(d[:, 2])
    if plan.any():
        own = float(np.sqrt(np.nanmean(np.nan_to_num(s[plan, :2]) ** 2) * 2))
        rmse = float(np.sqrt((d[plan, :2] ** 2).sum(axis=1).mean()))
        found["asprs"] = {
            "check_points_horizontal": int(plan.sum()), "rmse_h": float(np.hypot(rmse, own)),
            "check_points_vertical": int(high.sum()),
            "rmse_v": _vertical(d[high, 2], s[high, 2]) if high.any() else None, "enough": bool(plan.sum() >= 30),
        }  # fmt: skip
    for group in result.groups:
        if group.kind != "control":
            continue
        r = np.asarray(group.redundancy, float)
        with np.errstate(all="ignore"):
            left_out = np.where(r > 1e-6, -np.asarray(group.residual) / r, np.nan)
        found["leave_one_out"] = [
            {"point": name, "coordinate": axis, "difference": float(value)}
            for name, axis, value in zip(group.ids, group.component, left_out, strict=True)
        ]
    return found


def _vertical(d: Array, s: Array) -> float:
    return float(np.hypot(np.sqrt((d**2).mean()), np.sqrt((np.nan_to_num(s) ** 2).mean())))


def rejected_marks(result: Adjustment, marks: Mask) -> list[Notice]:
    """Image measurements of control and check points that were rejected, each by name."""
    o, ids = result.given.observations, result.given.points.ids
    found: list[Notice] = []
    for k in np.flatnonzero(marks):
        reason = result.image_observations.rejected[k]
        if reason:
            name, file = ids[o.point[k]], result.given.images.ids[o.image[k]]
            found.append(
                Notice(
                    code="mark_rejected",
                    message=f"the measurement of point {name} in {file} contradicts the others ({reason}) and is left "
                    "out; look at it again",
                    ids=(name, file),
                )
            )
    return found
