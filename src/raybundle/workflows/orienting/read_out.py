"""Rolling shutters: given by the photographs, or known, and then in the model of the camera.

A frame that is read row by row from a moving place shows a shear (motion along the rows) and an affinity (across them)
that change with the velocity in the camera's axes and with the distance of the object; those of the pixels do not.
Both are adjusted: affinity and shear, one value each for the camera, and one read-out time for the camera with the
velocity that each image has by the projection centres around it (platform `rolling`; Vautherin et al. 2016).  By how
much the weighted square sum falls is the likelihood ratio of each; the one with fewer parameters must explain as much.
Where it does, and times and a scale are known, the camera is taken as one with a rolling shutter.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.adjusted_values import as_start
from raybundle.block import Block, Camera, Distances
from raybundle.errors import Message, NotSolvable, message
from raybundle.io.photos.photo import Photo
from raybundle.io.photos.read_out_times import read_out_time
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import DECISIVE, chi_square_tails
from raybundle.platforms import sensor_models

VELOCITY = ("vx", "vy", "vz")
MOTION = (*VELOCITY, "wx", "wy", "wz")
SHAPE = ("A", "S")
ALPHA = 1e-3
GAP = 2.0
"""Interval between two photographs, in usual ones, beyond which no velocity is taken from them."""
BEND = np.cos(np.radians(30))
"""Cosine of the angle between the ways to and from a photograph below which its velocity is not known: a turn."""
LONGEST_S = 0.2
"""Read-out time beyond which no camera reads a frame: ten times what is usual."""
HELD = 1e-6
"""Standard deviation of a held distance by its length."""
FEWEST = 4
"""Photographs with a velocity."""
KNOWN = 0.1
"""Relative standard deviation of a read-out time that is given: lamps that blink show it to a few milliseconds."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ReadOut:
    """What a camera's affinity and shear come from."""

    camera: str
    seconds: float
    """Read-out time of the whole format; in intervals between photographs where no times are known"""
    std: float
    timed: bool
    """Whether the photographs state times"""
    by_read_out: float
    """By how much chi-square falls with one read-out time"""
    by_shape: float
    """The same with the affinity and the shear of pixels"""
    r: float = 0.0
    """As the model has it, signed: negative where rows are read upwards [s/mm]"""

    @property
    def rolling(self) -> bool:
        """Whether the read-out explains decisively more."""
        return self.by_read_out - self.by_shape > DECISIVE

    @property
    def reported(self) -> bool:
        """Whether one of the two is decisively likelier."""
        return abs(self.by_read_out - self.by_shape) > DECISIVE

    @property
    def figures(self) -> Message:
        """By how much either explains the photographs better, and the read-out time."""
        gain, other = self.by_read_out, self.by_shape
        if not self.timed:
            return message("read_out.share", share=self.seconds, by_read_out=gain, by_shape=other)
        time, sigma = 1000 * self.seconds, 1000 * self.std
        return message("read_out.time", time_ms=time, sigma_ms=sigma, by_read_out=gain, by_shape=other)

    def notice(self) -> Notice:
        """What there is to say of it where it is not in the model."""
        values = {"camera": self.camera}
        if self.rolling:
            return Notice(code="rolling_shutter", values=values, ids=(self.camera,), details=(self.figures,))
        return Notice(code="rolling_shutter.possible", values=values, ids=(self.camera,), details=(self.figures,))


@dataclass(frozen=True, slots=True, kw_only=True)
class Rolling:
    """A block in which cameras have a rolling shutter."""

    block: Block | None
    """None: no camera has"""
    notices: tuple[Notice, ...] = ()
    """What there is to say of these cameras"""


def rolling_shutters(
    result: Adjustment, block: Block, photos: Sequence[Photo], known_s: float | None = None
) -> Rolling:
    """The block, as it was given to the adjustment, with the read-out of the cameras that have a rolling shutter.

    known_s  read-out time of all cameras [s]; 0: none has one; None: what the photographs show decisively
    Limits: the rotation of a camera during the read-out, which shows as a velocity does.
    """
    if known_s == 0:
        return Rolling(block=None)
    when = {p.name: p.metadata.taken for p in photos}
    scaled = "scale" not in result.datum_defect
    notices, why = list[Notice](), list[Message]()
    for k, camera in enumerate(result.given.cameras):
        at = next((n for n, c in enumerate(block.cameras) if c.id == camera.id), -1)
        if at < 0 or f"{camera.model}_rolling" not in sensor_models:
            continue
        velocity, timed = velocities(result.adjusted, k, when)
        count = int(np.isfinite(velocity).all(axis=1).sum())
        if not timed or not scaled or count < FEWEST:
            lacking = "times" if not timed else "scale" if not scaled else "velocities"
            why.append(message("read_out_unused.camera", camera=camera.id, lacking=lacking, n=count, least=FEWEST))
            continue
        found = read_out(result, camera.id, when)
        if known_s is None and (found is None or not found.rolling):
            continue
        r = 0.0 if found is None else found.r
        if known_s is not None:  # which way the rows are read, the photographs show if they show anything
            r = float(np.copysign(known_s / float(camera.size_mm[1]), r))
        block = _rolling(block, at, _of_images(block, result.adjusted, velocity), r, observed=known_s is not None)
        images = int(((result.adjusted.images.camera == k) & result.adjusted.images.oriented).sum())
        notices.append(_modelled(camera.id, found, known_s, images - count, _known(photos, result, k)))
    changed = bool(notices)
    if known_s is not None and why:
        values = {"time_ms": 1000 * known_s, "cameras": len(why)}
        notices.append(Notice(code="read_out_unused", values=values, details=tuple(why)))
    return Rolling(block=block if changed else None, notices=tuple(notices))


def _modelled(camera: str, found: ReadOut | None, known_s: float | None, resting: int, table_s: float | None) -> Notice:
    """What there is to say of a camera whose read-out is in the model."""
    details = list[Message]()
    if known_s is not None:
        details.append(message("read_out.given", time_ms=1000 * known_s, sigma_share=KNOWN))
    if found is not None:
        details.append(found.figures)
    if table_s is not None:
        details.append(message("read_out.table", time_ms=1000 * table_s))
    if resting:
        details.append(message("read_out.still", n=resting))
    return Notice(code="read_out", values={"camera": camera}, ids=(camera,), details=tuple(details))


def _known(photos: Sequence[Photo], result: Adjustment, camera: int) -> float | None:
    """The read-out time that is known of a camera's body [s]."""
    mine = {n for n, c in zip(result.given.images.ids, result.given.images.camera.tolist(), strict=True) if c == camera}
    return next((t for p in photos if p.name in mine and (t := read_out_time(p.metadata)) is not None), None)


def _of_images(block: Block, adjusted: Block, velocity: Array) -> Array:
    """Velocities (n, 3) of the adjusted block's images for those of another block, by their names."""
    at = dict(zip(adjusted.images.ids, range(len(adjusted.images)), strict=True))
    return np.array([velocity[at[n]] if n in at else np.full(3, np.nan) for n in block.images.ids]).reshape(-1, 3)


def with_cause(result: Adjustment, photos: Sequence[Photo]) -> Adjustment:
    """The result in which an affinity or shear that no sensor has names a rolling shutter, where that is the cause.

    Of cameras whose read-out is not in the model: without times, or a scale, or where the two cannot be distinguished.
    """
    strange = {n.ids[0] for n in result.notices if n.code == "pixel_shape"}
    when = {p.name: p.metadata.taken for p in photos}
    notices = list(result.notices)
    for camera in sorted(strange):
        found = read_out(result, camera, when)
        if found is None or not (found.rolling or not found.reported):
            continue
        at = next(k for k, n in enumerate(notices) if n.code == "pixel_shape" and n.ids[0] == camera)
        mine = [n for n in notices if n.code == "pixel_shape" and n.ids[0] == camera]
        grave = Severity.FAULT if any(n.severity is Severity.FAULT for n in mine) else Severity.WARNING
        notices[at] = replace(found.notice(), measured=grave)
        if found.rolling:
            notices = [n for n in notices if n.code != "pixel_shape" or n.ids[0] != camera]
    return replace(result, notices=tuple(notices))


def read_out(result: Adjustment, camera: str, when: Mapping[str, datetime | None]) -> ReadOut | None:
    """What one read-out time explains, beside affinity and shear; None where it explains nothing, or cannot be tried.

    when  the times of the images by their names
    """
    at = next((k for k, c in enumerate(result.given.cameras) if c.id == camera), -1)
    if at < 0 or result.given.cameras[at].model != "brown":
        return None
    velocity, timed = velocities(result.adjusted, at, when)
    known = np.isfinite(velocity).all(axis=1)
    if known.sum() < FEWEST:
        return None
    free = {i.camera: i.free for i in result.interior if i.image is None}
    plain = tuple(s for s in free.get(camera, ()) if s not in SHAPE)
    start = _with(as_start(result.given, result.adjusted), at, dict.fromkeys(SHAPE, 0.0))
    scale, rolling = _variance(result), _with_scale(_rolling(start, at, velocity), result)
    neither = _adjusted(result, start, {**free, camera: plain})
    moving = _adjusted(result, rolling, {**free, camera: (*plain, "r")})
    if neither is None or moving is None:
        return None
    if chi_square_tails((neither.weighted_square_sum - moving.weighted_square_sum) / scale, 1)[1] > ALPHA:
        return None
    shape = _adjusted(result, start, {**free, camera: (*plain, *SHAPE)})
    moving = _adjusted(result, rolling, {**free, camera: (*plain, "r")}, statistics=True)
    if shape is None or moving is None:
        return None
    by = [(neither.weighted_square_sum - a.weighted_square_sum) / scale for a in (moving, shape)]
    height = float(result.given.cameras[at].size_mm[1])
    r = next(i.parameters["r"] for i in moving.interior if i.camera == camera and i.image is None)
    wider = np.sqrt(scale) / max(result.sigma0, 1e-12)
    seconds = r.value * height
    if timed and abs(seconds) > LONGEST_S:
        return None
    return ReadOut(
        camera=camera, seconds=abs(seconds), std=(r.std or 0.0) * height * wider, timed=timed, by_read_out=by[0],
        by_shape=by[1], r=r.value,
    )  # fmt: skip


def velocities(block: Block, camera: int, when: Mapping[str, datetime | None]) -> tuple[Array, bool]:
    """(n, 3) of the images of a camera in their own axes [length / s], by the projection centres before and after.

    NaN where the neighbours are far in time or the way bends.  Also whether times are known; without them images
    follow one another by their names at one interval, which is the unit of time then.
    """
    images = block.images
    mine = np.flatnonzero((images.camera == camera) & images.oriented)
    stated = [when.get(images.ids[i]) for i in mine.tolist()]
    timed = all(t is not None for t in stated) and len(set(stated)) > len(stated) // 2
    seconds = np.array([t.timestamp() for t in stated if t is not None]) if timed else np.arange(len(mine), dtype=float)
    order = np.argsort(seconds, kind="stable")
    mine, seconds = mine[order], seconds[order]
    found = np.full((len(images), 3), np.nan)
    moved = _ways(images.centre[mine], seconds)
    found[mine] = np.einsum("nij,nj->ni", images.rotation[mine], moved)
    return found, timed


def _ways(centre: Array, seconds: Array) -> Array:
    """(n, 3) velocities in object space of places in the order of time; NaN where they are not known.

    From the place before to the one after where the way is straight; at the end of a straight line from its own side.
    """
    n, step = len(centre), np.diff(seconds)
    way = np.diff(centre, axis=0)
    usual = float(np.median(step[step > 0])) if (step > 0).any() else 1.0
    near = (step > 0) & (step <= GAP * usual)
    found = np.full((n, 3), np.nan)
    for k in range(1, n - 1):
        if near[k - 1] and near[k] and _alike(way[k - 1], way[k]):
            found[k] = (way[k - 1] + way[k]) / (step[k - 1] + step[k])
    straight = found.copy()
    for k in np.flatnonzero(np.isnan(found[:, 0])):
        for side, other in ((k - 1, k - 1), (k, k + 1)):  # the way from the place before, and to the one after
            if 0 <= side < n - 1 and near[side] and _alike(way[side], straight[other]):
                found[k] = way[side] / step[side]
    return found


def _alike(one: Array, two: Array) -> bool:
    lengths = float(np.linalg.norm(one) * np.linalg.norm(two))
    return bool(lengths > 0 and one @ two > BEND * lengths)


def _rolling(block: Block, at: int, velocity: Array, r: float = 0.0, *, observed: bool = False) -> Block:
    """The block with a rolling shutter for a camera, the velocities of its images held; unknown ones are 0."""
    camera = block.cameras[at]
    moving: Camera = replace(
        camera, model=f"{camera.model}_rolling", per_image=VELOCITY,
        values={**camera.values, **dict.fromkeys(MOTION, 0.0), "r": r},
        sigma={**camera.sigma, "r": KNOWN * abs(r)} if observed else camera.sigma,
        estimate=camera.estimate if camera.estimate == "auto" else (*camera.estimate, "r"),
    )  # fmt: skip
    mine = np.flatnonzero(block.images.camera == at)
    own = {int(i): dict(zip(VELOCITY, np.nan_to_num(velocity[i]).tolist(), strict=True)) for i in mine}
    cameras = tuple(moving if k == at else c for k, c in enumerate(block.cameras))
    return replace(block, cameras=cameras, images=replace(block.images, interior={**block.images.interior, **own}))


def _with_scale(block: Block, result: Adjustment) -> Block:
    """The block with its scale held where nothing holds it: a velocity is a length, and the read-out time would scale.

    One distance between far points, as it is; nothing pulls at it.
    """
    if "scale" not in result.datum_defect:
        return block
    used = result.image_observations.used
    rays = np.bincount(block.observations.point[used], minlength=len(block.points))
    some = np.flatnonzero(rays >= min(3, rays.max()))
    xyz = block.points.xyz[some]
    a = int(np.linalg.norm(xyz - xyz.mean(axis=0), axis=1).argmax())
    away = np.linalg.norm(xyz - xyz[a], axis=1)
    b, d = int(away.argmax()), block.distances
    held = Distances(
        start=np.append(d.start, some[a]).astype(np.int32), end=np.append(d.end, some[b]).astype(np.int32),
        length=np.append(d.length, away[b]), sigma=np.append(d.sigma, HELD * away[b]),
    )  # fmt: skip
    return block.having(held)


def _with(block: Block, at: int, values: Mapping[str, float]) -> Block:
    cameras = tuple(replace(c, values={**c.values, **values}) if k == at else c for k, c in enumerate(block.cameras))
    return replace(block, cameras=cameras)


def _adjusted(
    result: Adjustment, start: Block, free: dict[str, tuple[str, ...]], *, statistics: bool = False
) -> Adjustment | None:
    options = replace(
        result.options, reject="none", robust_start=False, statistics=statistics, tolerance=1e-3, noise="white"
    )
    try:
        return adjust_block(
            start, options, free=free, rejected=result.image_observations.rejected, start="adjusted",
            extent="decisions" if statistics else "tests",
        )  # fmt: skip
    except NotSolvable:
        return None


def _variance(result: Adjustment) -> float:
    """By what a growth of the square sum counts: as in `same_camera`."""
    ratio = result.noise.ratio_interior if result.noise.kind == "fields" else 1.0
    return result.sigma0**2 * (max(ratio, 1.0) ** 2 if np.isfinite(ratio) else 1.0)
