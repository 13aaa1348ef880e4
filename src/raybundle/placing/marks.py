"""What is known of object space and measured in photographs: control and check points, scale bars, their marks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from pathlib import Path

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.system.predict import residuals_px
from raybundle.block import Block, Distances, Observations, Points, Role
from raybundle.block.select import select_block
from raybundle.errors import InputError, Message, Value, plain
from raybundle.io.geo.control_files import DEFAULTS, ControlDefaults, ControlFile
from raybundle.io.geo.control_systems import sigma_in_metres
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.io.photos.photo import Photo
from raybundle.io.trajectories import PhotoAttitudes
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.orientation.rays import intersect_linear, object_rays, rays_of
from raybundle.placing.upright import Upright

MARK_PX = 0.5
"""Standard deviation of a point marked in a photograph."""
TOGETHER = 1_000_000
"""Angles between rays and places that are formed at a time"""
GROSS = 30.0
"""Distance of a mark from the others' place, in standard deviations of a mark, from which it is wrong beyond doubt."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ScaleBar:
    """A distance between two measured points; InputError unless its length and its sigma are positive."""

    start: str
    end: str
    length: float
    """[m]"""
    sigma: float
    """[m]"""

    def __post_init__(self) -> None:
        if not (np.isfinite(self.length) and self.length > 0):
            raise InputError("scale_bar.length", start=self.start, end=self.end, length_m=_shown(self.length))
        if not (np.isfinite(self.sigma) and self.sigma > 0):
            raise InputError("scale_bar.sigma", start=self.start, end=self.end, sigma_m=_shown(self.sigma))
        if self.start == self.end:
            raise InputError("mark.bar_same_ends", start=self.start, end=self.end)


def _shown(value: float) -> str:
    return f"{value:g}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Given:
    """What is known of object space."""

    control: tuple[ControlFile, ...] = ()
    """control and check points with their places in the photographs; the role stands in the file"""
    scale_bars: tuple[ScaleBar, ...] = ()
    gps: bool = True
    """use the positions that the photographs state"""
    positions_frame: LocalFrame | None = None
    """local frame in the grid of a list of positions; None: they are geographic"""
    shift: bool = True
    """beside control, a shift of the positions of each flight is estimated"""
    lever_arm: tuple[tuple[float, float, float], float] | None = None
    """from the projection centre to the antenna, to the right, upwards in the image and backwards, and the standard
    deviation of each; 0: held"""
    attitudes: PhotoAttitudes | None = None
    """what an INS or a gimbal measured of the photographs' attitudes"""
    misalignment: bool = True
    """a misalignment of each camera against its attitudes is estimated"""
    defaults: ControlDefaults = DEFAULTS
    sigma_given: bool = False
    """the standard deviations in `defaults` are known, not assumed"""
    mark_px: float = MARK_PX
    up: str = "auto"
    """which way is up where control and positions do not show it: auto, terrestrial, aerial, oblique, or "A,B" """

    def __post_init__(self) -> None:
        """Raise InputError where two files give a point of one name, before anything is computed."""
        given: dict[str, Path] = {}
        for file in self.control:
            for name in file.ids:
                if name in given:
                    raise InputError("control.point_twice", point=name, table=given[name].name, file=file.path)
                given[name] = file.path


@dataclass(slots=True)
class Placing:
    """A block on its way to object space, and what there is to say."""

    block: Block
    notices: list[Notice] = field(default_factory=list[Notice])
    upright: Upright | None = None
    """how the vertical was found, where nothing else shows it"""

    def notify(self, code: str, *ids: str, details: tuple[Message, ...] = (), **values: Value) -> None:
        """Add a notice."""
        self.notices.append(Notice(code=code, values=plain(values), ids=ids, details=details))


def check_marks(photos: Sequence[Photo], given: Given) -> None:
    """Raise InputError for marks outside their photograph, and ends of scale bars that nobody marked.

    It needs the photographs' sizes alone, so that it is asked before anything is computed.  Marks of a file that the
    pictures as EXIF turns them hold, and the photographs as stored do not, are taken so later (`turned_marks`).
    """
    images = {p.name: i for i, p in enumerate(photos)}
    for c in given.control:
        if _inside_as_shown(c, photos, images):
            continue
        for name, at, line in zip(c.measurements.image, c.measurements.xy_px, c.measurements.line, strict=True):
            i = _photo(images, name)
            if i is None:
                continue
            size = photos[i].width_px, photos[i].height_px
            if not (0 <= at[0] <= size[0] and 0 <= at[1] <= size[1]):
                tag = exif_turn(photos[i])
                raise InputError(
                    "mark.outside_photograph", image=name, x_px=float(at[0]), y_px=float(at[1]), width_px=size[0],
                    height_px=size[1], turned=tag != 1, orientation=tag, file=c.path, line=int(line),
                )  # fmt: skip
    known = {name for c in given.control for name in c.ids}
    for bar in given.scale_bars:
        for name in (bar.start, bar.end):
            if name not in known:
                raise InputError("scale_bar.end_not_measured", start=bar.start, end=bar.end, point=name)


def exif_turn(photo: object) -> int:
    """EXIF's orientation, 1 where it turns nothing: satellite scenes and stand-ins for files have none."""
    return int(getattr(photo, "orientation", 1))


def _inside_as_shown(control: ControlFile, photos: Sequence[Photo], images: Mapping[str, int]) -> bool:
    """Whether all marks of a file lie inside the pictures that EXIF turns, and inside the others as stored."""
    m = control.measurements
    for name, at in zip(m.image, m.xy_px, strict=True):
        i = _photo(images, name)
        if i is None:
            continue
        photo = photos[i]
        width, height = (photo.width_px, photo.height_px) if exif_turn(photo) == 1 else photo.upright_size
        if not (0 <= at[0] <= width and 0 <= at[1] <= height):
            return False
    return True


def check_names(photos: Sequence[Photo], given: Given) -> None:
    """Raise InputError for a file that measures points in none of these photographs: it is of another set."""
    images = {p.name: i for i, p in enumerate(photos)}
    for c in given.control:
        measured = list(dict.fromkeys(c.measurements.image))
        if measured and all(_photo(images, name) is None for name in measured):
            raise InputError("control.other_photographs", names=measured, photographs=[*images], file=c.path)


def under_kept_names(control: Sequence[ControlFile], copies: Mapping[str, str]) -> tuple[ControlFile, ...]:
    """Control whose marks in photographs that were left out as copies count in those of the same content that stay.

    copies  name of a photograph that was left out -> name of the one that stays
    """

    def named(c: ControlFile) -> ControlFile:
        m = c.measurements
        image = [copies.get(n, copies.get(Path(n).name, n)) for n in m.image]
        first = {key: k for k, key in reversed([*enumerate(zip(image, m.point.tolist(), strict=True))])}
        rows = np.array(sorted(first.values()), np.int64)  # a point marked in both counts once
        return replace(c, measurements=replace(m, image=tuple(image)).rows(rows))

    return tuple(named(c) if copies else c for c in control)


def add_points(state: Placing, photos: Sequence[Photo], given: Given, frame: LocalFrame | None) -> None:
    """Control, check and merely measured points with their image measurements.

    A measured point of which nothing is used (role tie) is control without a given coordinate until the
    block is placed: so every step knows that it was marked, by its role; `without_empty_control` ends that.
    """
    check_marks(photos, given)
    images = {p.name: i for i, p in enumerate(photos)}
    block = state.block
    ids, xyz, sigma, role = list[str](), list[Array](), list[Array](), list[int]()
    image, point, xy, cov = list[int](), list[int](), list[Array](), list[Array]()
    by_hand = np.array([given.mark_px**2, given.mark_px**2, 0.0])
    for c in given.control:
        local = c.xyz if frame is None or not c.crs else frame.local_from_crs(c.xyz)
        deviations = c.sigma if frame is None else sigma_in_metres(c)
        for k, name in enumerate(c.ids):
            tie = int(c.role[k]) == Role.TIE
            place = np.full(3, np.nan) if tie else local[k]
            ids.append(name)
            xyz.append(place)
            sigma.append(np.where(np.isfinite(place), deviations[k], np.nan))
            role.append(int(Role.CONTROL if tie else c.role[k]))
        unknown: dict[str, int] = {}
        here = False
        m = c.measurements
        for name, k, at, own in zip(m.image, m.point, m.xy_px, m.covariances, strict=True):
            i = _photo(images, name)
            if i is None:
                unknown[name] = unknown.get(name, 0) + 1
                continue
            here = True
            if not block.images.oriented[i]:
                continue
            image.append(i)
            point.append(ids.index(c.ids[int(k)]))
            xy.append(at)
            cov.append(own if np.isfinite(own).all() else by_hand)
        if unknown:
            state.notices.append(
                Notice(
                    code="control_without_photograph",
                    values={"n": sum(unknown.values()), "table": c.path.name, "names": sorted(unknown)},
                    # a file of several epochs, or of a whole of which this is a part, has its other photographs here
                    measured=Severity.NOTE if here else Severity.WARNING,
                )
            )
    if not ids:
        return
    state.block = replace(
        block,
        observations=block.observations.append(
            Observations(
                image=np.array(image, np.int32), point=len(block.points) + np.array(point, np.int32),
                xy_px=np.array(xy).reshape(-1, 2), cov_px2=np.array(cov).reshape(-1, 3),
            )
        ),
        points=block.points.append(
            Points(ids=tuple(ids), role=np.array(role, np.int32), xyz=np.array(xyz), sigma=np.array(sigma))
        ),
    )  # fmt: skip


def without_empty_control(block: Block) -> Block:
    """Points that were marked and of which nothing is given are tie points: measured by hand, that is all."""
    role = np.array(block.points.role)
    role[(role == Role.CONTROL) & ~block.points.is_control.any(axis=1)] = Role.TIE
    return replace(block, points=replace(block.points, role=role))


def drop_single_marks(state: Placing) -> None:
    """Points of which nothing is given and that are marked once cannot be determined."""
    block = state.block
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    special = np.asarray(block.points.role) != Role.TIE
    single = special & ~block.points.is_control.any(axis=1) & (rays == 1)
    if not single.any():
        return
    names = tuple(block.points.ids[k] for k in np.flatnonzero(single))
    o, keep = block.observations, ~single[block.observations.point]
    state.block = replace(block, observations=o.rows(keep))
    state.notify("marked_once", *names, n=len(names))


def drop_unseen_checks(state: Placing) -> None:
    """Check points that no image shows cannot be compared."""
    block = state.block
    lost = (block.ray_count == 0) & (np.asarray(block.points.role) == Role.CHECK)
    if not lost.any():
        return
    names = tuple(block.points.ids[k] for k in np.flatnonzero(lost))
    state.block = select_block(block, "point", ~lost)
    state.notify("check_unseen.no_measurement", *names, n=len(names))


def drop_gross_marks(state: Placing, free: Array) -> None:
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
    # a target is measured more precisely than the free block shows its place
    limits = GROSS * np.maximum(np.sqrt(o.cov_px2[rows, :2].max(axis=1)), MARK_PX)
    wrong = rows[~(far <= limits)]
    for k in wrong:
        limit = float(limits[rows == k][0])
        name, file = block.points.ids[o.point[k]], block.images.ids[o.image[k]]
        beside = rows_near(block, int(k), special, limit)
        there = None if beside else point_there(block, int(k), special, xyz, limit)
        hint = "same_place" if beside else "none" if there is None else "near"
        state.notify(
            "mark_rejected", name, file, point=name, image=file, off_px=float(far[rows == k][0]), limit_px=limit,
            hint=hint, other=beside or ("" if there is None else there[0]),
            other_px=None if there is None else there[1],
        )  # fmt: skip
    if len(wrong):
        keep = np.ones(len(o), bool)
        keep[wrong] = False
        state.block = replace(block, observations=o.rows(keep))


def rows_near(block: Block, row: int, special: Mask, limit: float) -> str:
    """Another control or check point that is marked in the same photograph at the same place; empty if none is."""
    o = block.observations
    others = np.flatnonzero(special[o.point] & (o.image == o.image[row]) & (o.point != o.point[row]))
    if not len(others):
        return ""
    apart = np.linalg.norm(o.xy_px[others] - o.xy_px[row], axis=1)
    return block.points.ids[o.point[others[apart.argmin()]]] if apart.min() < limit else ""


def point_there(block: Block, row: int, special: Mask, xyz: Array, limit: float) -> tuple[str, float] | None:
    """The other control or check point that is nearest to a mark by its other marks, and how far [px].

    xyz     (p, 3) where points are by their marks; NaN: not known
    returns None where none is within the limit
    """
    o = block.observations
    others = np.flatnonzero(special & np.isfinite(xyz).all(axis=1))
    others = others[others != o.point[row]]
    if not len(others):
        return None
    taken = o.rows(np.full(len(others), row))
    tried = replace(block, observations=replace(taken, point=others.astype(np.int32)))
    tried = replace(tried, points=replace(block.points, xyz=xyz))
    apart = np.linalg.norm(residuals_px(tried, np.arange(len(others))), axis=1)
    ahead = (xyz[others] - block.images.centre[o.image[row]]) @ block.images.rotation[o.image[row]][2] < 0
    apart = np.where(ahead & np.isfinite(apart), apart, np.inf)
    k = int(apart.argmin())
    return (block.points.ids[others[k]], float(apart[k])) if apart[k] < limit else None


def _photo(images: Mapping[str, int], name: str) -> int | None:
    """The photograph that a file of measurements means: by its name, without folder, case or suffix if need be."""
    if name in images:
        return images[name]
    plain = {Path(k).name.lower(): i for k, i in images.items()}
    stems = {Path(k).stem.lower(): i for k, i in images.items()}
    return plain.get(Path(name).name.lower(), stems.get(Path(name).stem.lower()))


def add_bars(state: Placing, given: Given) -> None:
    """Scale bars between measured points."""
    if not given.scale_bars:
        return
    index = {name: k for k, name in enumerate(state.block.points.ids)}
    bars = given.scale_bars
    state.block = state.block.having(
        Distances(
            start=np.array([index[b.start] for b in bars], np.int32),
            end=np.array([index[b.end] for b in bars], np.int32),
            length=np.array([b.length for b in bars]),
            sigma=np.array([b.sigma for b in bars]),
        )
    )


def intersected(block: Block) -> Array:
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

    def at(picks: Index) -> Array:
        """(m, 3) of each choice (m, k); NaN where its rays are parallel."""
        m, k = picks.shape
        rays = centre[picks].reshape(-1, 3), direction[picks].reshape(-1, 3)
        found, _, ratio = intersect_linear(*rays, np.repeat(np.arange(m, dtype=np.int32), k), m)
        return np.where(ratio[:, None] > 1e-7, found, np.nan)

    def angles(X: Array) -> Array:
        ray = X[:, None] - centre
        ray = ray / np.maximum(np.linalg.norm(ray, axis=2, keepdims=True), 1e-300)
        return np.linalg.norm(ray - direction, axis=2)

    everything = np.arange(n)
    best, cost = at(everything[None])[0], np.inf
    if n == 2:
        return best
    pairs = np.array(list(combinations(range(n), 2)))
    for some in np.array_split(pairs, len(pairs) * n // TOGETHER + 1):
        X = at(some)
        worth = np.nan_to_num(np.sort(angles(X), axis=1)[:, n // 2], nan=np.inf)
        k = int(np.argmin(worth))
        if worth[k] < cost:
            best, cost = X[k], float(worth[k])
    near = np.flatnonzero(angles(best[None])[0] <= max(4 * cost, 1e-4)) if np.isfinite(cost) else everything
    refined = at(near[None])[0] if len(near) > 1 else best
    return refined if np.isfinite(refined).all() else best
