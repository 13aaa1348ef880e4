"""Scenes in object space: one frame for all, control points and their marks, and control that contradicts a scene."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, cast

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.system.scene_start import with_scene_points
from raybundle.block import Block, Role
from raybundle.errors import InputError, phrase
from raybundle.io.geo.control_files import ControlFile
from raybundle.io.geo.coordinate_systems import WGS84, LocalFrame, local_frame
from raybundle.numerics.arrays import Array
from raybundle.numerics.places import Local
from raybundle.placing.georeference import Georeferenced, frame_of
from raybundle.placing.marks import (
    Given,
    Placing,
    add_points,
    drop_single_marks,
    drop_unseen_checks,
    without_empty_control,
)
from raybundle.scenes.sensor import SceneSensor
from raybundle.workflows.scenes.block import SceneSet, joined, with_cameras
from raybundle.workflows.scenes.images import SceneImage

if TYPE_CHECKING:
    from raybundle.io.photos.photo import Photo

SAME_M = 0.02
"""Difference at 10 km from the origin up to which two frames count as one."""
NEAR_DEG = 0.5
"""Control whose longitudes and latitudes lie so near the scenes is given in degrees."""
BELIEVED = 5.0
"""Control marks may lie so many stated standard deviations from where the RPC puts them."""
LEAST_PX = 12.0
"""What is believed in any case: stated accuracies may be optimistic."""
ONE_SHIFT = 8.0
"""Scatter of the marks about one shift, in standard deviations of mark and point, above which they do not fit it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Placed:
    """Where everything stands."""

    frame: LocalFrame
    place: Local


def control_in_system(given: Given, scenes: SceneSet, crs: str | None) -> Given:
    """Control files that name no coordinate system get one: `crs`, or degrees where they look like it.

    raises  InputError where neither is the case
    """
    files: list[ControlFile] = []
    for c in given.control:
        if c.crs:
            files.append(c)
            continue
        system = crs
        if system is None:
            lon, lat, _ = scenes.place.origin
            known = np.isfinite(c.xyz[:, :2]).all(axis=1)
            far = np.abs(c.xyz[known, :2] - [lon, lat])
            if known.any() and not (far < NEAR_DEG + _extent_deg(scenes)).all():
                x, y = c.xyz[np.flatnonzero(known)[0], :2].tolist()
                raise InputError(
                    "scene.control_without_system",
                    x=x,
                    y=y,
                    longitude_deg=lon,
                    latitude_deg=lat,
                    file=c.path,
                )
            system = WGS84
        remark = phrase("scene.control_system", name=c.path.name, system=system, given=bool(crs))
        files.append(replace(c, crs=system, remarks=(*c.remarks, remark)))
    return replace(given, control=tuple(files))


def _extent_deg(scenes: SceneSet) -> float:
    scales = [float(s.rpc.ground_scale[:2].max()) for s in scenes.images if s.rpc is not None]
    return max(scales, default=1.0)


def common_frame(scenes: SceneSet, photos: Sequence[Photo], given: Given) -> tuple[Placed, tuple[Notice, ...]]:
    """The frame of the control, else of the photographs' positions, else in the middle of the scenes.

    A system whose datum differs from that of the scenes (WGS 84) by more than a shift has its control brought over;
    the frame is then one of WGS 84.
    """
    frame = frame_of(photos, given) or local_frame(WGS84, scenes.place.origin)
    lon, lat, h = frame.wgs84_from_local(np.zeros((1, 3)))[0].tolist()
    place = Local(origin=(lon, lat, h))
    probe = 1e4 * np.array([[1.0, 0, 0], [0, 1, 0], [-1, -1, 0.01]])
    off = np.abs(place.block_from_geographic(frame.wgs84_from_local(probe)) - probe).max()
    if off <= SAME_M:
        return Placed(frame=frame, place=place), ()
    found = Notice(
        code="scene_datum",
        values={"system": frame.crs, "off_m": float(off)},
    )
    return Placed(frame=local_frame(WGS84, (lon, lat, h)), place=place), (found,)


def in_frame(given: Given, placed: Placed) -> Given:
    """Control of another datum in the system of the frame."""
    files: list[ControlFile] = []
    for c in given.control:
        if c.crs == placed.frame.crs or not c.crs or placed.frame.crs != WGS84:
            files.append(c)
            continue
        middle = np.nanmean(c.xyz, axis=0)
        own = local_frame(c.crs, middle)
        files.append(replace(c, crs=WGS84, xyz=own.wgs84_from_local(own.local_from_crs(c.xyz))))
    return replace(given, control=tuple(files))


def marks_in(given: Given, names: Sequence[str], *, inside: bool) -> Given:
    """The control with the marks in images of these names only; or the marks in all others, and their points alone."""
    plain = {n.lower() for n in names} | {n.rsplit(".", 1)[0].lower() for n in names}

    def mine(name: str) -> bool:
        short = name.replace("\\", "/").rsplit("/", 1)[-1].lower()
        return short in plain or short.rsplit(".", 1)[0] in plain

    files: list[ControlFile] = []
    for c in given.control:
        m = c.measurements
        keep = np.array([mine(n) == inside for n in m.image], bool)
        kept = replace(
            m,
            image=tuple(n for n, k in zip(m.image, keep, strict=True) if k),
            point=m.point[keep],
            xy_px=m.xy_px[keep],
            line=m.line[keep],
        )
        files.append(replace(c, measurements=kept) if inside else _marked(replace(c, measurements=kept)))
    return replace(given, control=tuple(files))


def _marked(control: ControlFile) -> ControlFile:
    """The control without points that no measurement names."""
    m = control.measurements
    rows = np.unique(m.point)
    return replace(
        control,
        ids=tuple(control.ids[k] for k in rows.tolist()),
        xyz=control.xyz[rows],
        sigma=control.sigma[rows],
        role=control.role[rows],
        measurements=replace(m, point=np.searchsorted(rows, m.point).astype(np.int32)),
    )


def place_scenes(block: Block, scenes: SceneSet, given: Given, placed: Placed) -> Placing:
    """The block of scenes in the common frame, with control and check points and their marks in scenes.

    raises  InputError where control contradicts a scene beyond what its vendor states
    """
    cameras = tuple(
        replace(fresh, values=old.values)
        for fresh, old in zip(scenes.cameras(placed.place), block.cameras, strict=True)
    )
    state = Placing(with_cameras(block, cameras, placed.place))
    ties = len(state.block.observations)
    add_points(state, cast("Sequence[Photo]", scenes.images), given, placed.frame)
    check_marks(state.block, scenes.images, ties, given.mark_px)
    return state


def check_marks(block: Block, images: Sequence[SceneImage], first: int, mark_px: float) -> None:
    """Raise InputError where the marks of control (rows from `first` on) fit no shift that a scene's vendor allows."""
    o, p = block.observations, block.points
    full = np.atleast_1d(p.is_control.all(axis=1))
    for i, image in enumerate(images):
        rows = first + np.flatnonzero((o.image[first:] == i) & full[o.point[first:]])
        if len(rows) < 2:
            continue
        sensor = cast("SceneSensor", block.cameras[int(block.images.camera[i])].scene)
        try:
            sensor.check_near(p.xyz[o.point[rows]], [p.ids[k] for k in o.point[rows].tolist()])
        except InputError as error:
            details = [error.message] if error.message else ()
            raise InputError("scene.control_far_away", details=details, file=image.path) from None
        seen = sensor.observe(p.xyz[o.point[rows]], sensor.defaults)
        apart = o.xy_px[rows] - seen.xy_px
        own = np.sqrt(mark_px**2 + ((seen.by_point * p.sigma[o.point[rows]][:, None]) ** 2).sum(axis=2))
        shift = np.median(apart, axis=0)
        limit = np.maximum(BELIEVED * sensor.prior_px(), LEAST_PX)
        dx, dy = shift.tolist()
        if (np.abs(shift) > limit).any():
            raise InputError(
                "scene.control_shifted",
                limit_x_px=limit[0],
                limit_y_px=limit[1],
                file=image.path,
                n=len(rows),
                model=image.model.name,
                dx_px=dx,
                dy_px=dy,
            )
        spread = 1.4826 * np.median(np.abs(apart - shift), axis=0)
        allowed = ONE_SHIFT * np.median(own, axis=0) + 3.0
        if len(rows) >= 4 and (spread > allowed).any():
            raise InputError(
                "scene.control_scattered",
                spread_x_px=spread[0],
                spread_y_px=spread[1],
                limit_x_px=allowed[0],
                limit_y_px=allowed[1],
                file=image.path,
                n=len(rows),
                model=image.model.name,
                dx_px=dx,
                dy_px=dy,
            )


def places_of_marks(block: Block) -> dict[str, Array]:
    """Where points that are marked in scenes stand by them: points of one scene at the height of the control."""
    o, p = block.observations, block.points
    full = p.is_control.all(axis=1)
    marked = np.unique(o.point[np.asarray(p.role)[o.point] != Role.TIE])
    if not len(marked):
        return {}
    start = with_scene_points(replace(block, points=replace(p, xyz=np.where(p.is_control, p.xyz, np.nan)))).points.xyz
    tie = np.asarray(p.role) == Role.TIE
    known = full | (tie & np.isfinite(p.xyz).all(axis=1))
    height = float(np.median(p.xyz[known, 2])) if known.any() else 0.0
    found: dict[str, Array] = {}
    for k in marked.tolist():
        row = int(np.flatnonzero(o.point == k)[0])
        camera = block.cameras[int(block.images.camera[o.image[row]])]
        place = start[k]
        if not np.isfinite(place).all():
            sensor = cast("SceneSensor", camera.scene)
            place = sensor.localise(o.xy_px[row : row + 1], _ellipsoidal(sensor, height), camera.parameters)[0]
        found[p.ids[k]] = place
    return found


def _ellipsoidal(sensor: SceneSensor, height: float) -> float:
    """The ellipsoidal height [m] of a local height near the middle of a scene."""
    middle = np.array([sensor.size_px], float) / 2
    ground = sensor.localise(middle, sensor.height_m, sensor.defaults)
    return sensor.height_m + height - float(ground[0, 2])


def finish(state: Placing, photographs: Georeferenced | None, placed: Placed, more: Sequence[Notice]) -> Georeferenced:
    """Scenes and photographs as one block, every point with approximate coordinates."""
    block = joined(state.block, None if photographs is None else photographs.block)
    both = Placing(with_scene_points(_guessed(block)), [*more, *state.notices])
    if photographs is not None:
        known = {n.text for n in both.notices}
        both.notices += [n for n in photographs.notices if n.text not in known]
    drop_single_marks(both)
    drop_unseen_checks(both)
    block, own = both.block, set[str]()
    if photographs is not None:
        own = {n for n, m in zip(photographs.block.points.ids, photographs.marked, strict=True) if m}
    marked = (np.asarray(block.points.role) != Role.TIE) | np.array([n in own for n in block.points.ids], bool)
    block = without_empty_control(block)
    return Georeferenced(block=block, frame=placed.frame, notices=tuple(both.notices), marked=marked, fixed=True)


def _guessed(block: Block) -> Block:
    """Points of which part is given, or that one image shows, begin where the others are high."""
    o = block.observations
    scene = np.array([c.is_scene for c in block.cameras])[block.images.camera]
    rays = np.bincount(o.point[scene[o.image]], minlength=len(block.points))
    xyz = block.points.xyz.copy()
    known = np.isfinite(xyz).all(axis=1)
    height = float(np.median(xyz[known, 2])) if known.any() else 0.0
    given = block.points.is_control
    part = ~known & (given.any(axis=1) | (rays < 2))
    if not part.any():
        return block
    middle = np.median(xyz[known], axis=0) if known.any() else np.zeros(3)
    fill = np.where(np.isfinite(xyz), xyz, [*middle[:2], height])
    xyz[part] = fill[part]
    return replace(block, points=replace(block.points, xyz=xyz))
