"""One sensor behind photographs stored in several ways: turned by a program, or reduced; joined where they agree.

Files do not show that a program turned their pixels, nor which way.  Photographs that may be of one sensor are oriented
as of two cameras; then each possible turn is adjusted with one interior orientation.  By how much the weighted square
sum grows is the likelihood ratio of that hypothesis, chi-square distributed with as many degrees of freedom as
parameters were saved (Wilks 1938): it takes the parameters' difference under their full covariance, common object
points included.  Where errors are smooth fields, the parameters scatter by more than white noise states, and the square
sum counts by the variance that they have.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.adjusted_values import as_start
from raybundle.block import Block
from raybundle.block.block import Turn
from raybundle.block.frames import joined, size_ratio, stored_turned
from raybundle.errors import NotSolvable
from raybundle.io.photos.cameras import CameraGroup, may_share_sensor
from raybundle.io.photos.photo import Photo
from raybundle.numerics.statistics import DECISIVE, chi_square_tails

ALPHA = 0.001
"""Probability by chance below which photographs are of two cameras, as of every blunder."""
FEWEST_HALVES = 6
"""Photographs without metadata from which on some are looked at as upside down."""
TILT_DEG = 30.0
"""From the vertical up to which a gimbal's heading is that of the image's upper side, and by how far the two may
differ: a compass is wrong by some degrees."""
COARSE_STEPS = 8
"""Places in the order of the photographs at which that is looked for first."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Join:
    """Files of one camera that are copies of another's pictures."""

    other: str
    camera: str
    turned: Turn


@dataclass(frozen=True, slots=True, kw_only=True)
class Shared:
    """What photographs were found to share."""

    joins: tuple[Join, ...] = ()
    half_turned: tuple[str, ...] = ()
    """Photographs that are stored upside down"""
    notices: tuple[Notice, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.joins or self.half_turned)

    def applied(self, block: Block) -> Block:
        """The block with these joins; image points are brought over."""
        if self.half_turned:
            images = np.flatnonzero(np.isin(np.array(block.images.ids), self.half_turned))
            block = stored_turned(block, images, 180)
        for j in self.joins:
            ids = [c.id for c in block.cameras]
            block = joined(block, ids.index(j.other), ids.index(j.camera), j.turned)
        return block

    def grouped(self, groups: Sequence[CameraGroup]) -> tuple[CameraGroup, ...]:
        """The cameras of the photographs after these joins."""
        into = {j.other: j.camera for j in self.joins}
        more = {g.id: [p for o in groups if into.get(o.id) == g.id for p in o.photos] for g in groups}
        return tuple(
            replace(g, photos=tuple(sorted([*g.photos, *more[g.id]]))) if more[g.id] else g
            for g in groups
            if g.id not in into
        )


def shared_sensors(
    result: Adjustment, groups: Sequence[CameraGroup], photos: Sequence[Photo], *, reduced: bool = True
) -> Shared:
    """Which cameras of an adjusted block are one sensor in files stored differently, and what there is to say.

    reduced  whether copies of another size are looked at, too

    Limits: whether cameras that are kept apart are two; focus or zoom may have been another.
    """
    joins, notices = list[Join](), list[Notice]()
    taken: set[str] = set()
    seen = np.unique(result.given.images.camera[result.given.images.oriented])
    present = {result.given.cameras[k].id for k in seen.tolist()}
    order = sorted((g for g in groups if g.id in present), key=_first)
    for k, one in enumerate(order):
        for two in order[k + 1 :]:
            if {one.id, two.id} & taken or not _candidates(one, two, photos, reduced=reduced):
                continue
            join, found = _tested(result, one, two)
            notices.append(found)
            if join is not None:
                joins.append(join)
                taken.add(two.id)
    upside_down = None
    if not joins and (named := against_gimbal(result.adjusted, photos)):
        upside_down = _half_turned_by(result, named)
    elif not joins and _may_be_upside_down(result, groups, photos):
        upside_down = _half_turned(result, photos)
    if upside_down is not None:
        return replace(upside_down, notices=(*notices, *upside_down.notices))
    return Shared(joins=tuple(joins), notices=tuple(notices))


def _first(group: CameraGroup) -> tuple[int, bool, int]:
    """By what the camera is chosen whose frame all take: the largest, the sensor's usual way, the most photographs."""
    return -group.width_px * group.height_px, group.width_px < group.height_px, -len(group.photos)


def _candidates(one: CameraGroup, two: CameraGroup, photos: Sequence[Photo], *, reduced: bool) -> bool:
    """Whether two cameras may be one; without metadata only by pixels that are exchanged in width and height."""
    same = size_ratio((one.width_px, one.height_px), (two.width_px, two.height_px))
    if one.stored is not None or two.stored is not None or one.pattern != two.pattern or same is None:
        return False
    a, b = photos[one.photos[0]], photos[two.photos[0]]
    copy = same[0] != 1.0
    square = one.width_px == one.height_px
    if copy and (not reduced or not (a.metadata.model or a.metadata.serial)):
        return False
    return (copy or square or same[1]) and may_share_sensor(a, b)


def _tested(result: Adjustment, one: CameraGroup, two: CameraGroup) -> tuple[Join | None, Notice]:
    """One interior orientation for two cameras in each turn that their sizes allow, against two."""
    same = size_ratio((one.width_px, one.height_px), (two.width_px, two.height_px))
    assert same is not None
    turns: tuple[Turn, ...] = (90, 270) if same[1] else (0,)
    apart, free = _apart(result, one.id, two.id)
    scale = _variance(result)
    found: list[tuple[float, int, Turn]] = []
    for turned in turns:
        join = Join(other=two.id, camera=one.id, turned=turned)
        together = _adjusted(result, Shared(joins=(join,)), free)
        if together is not None and together.redundancy > apart.redundancy:
            grown = (together.weighted_square_sum - apart.weighted_square_sum) / scale
            found.append((max(grown, 0.0), together.redundancy - apart.redundancy, turned))
    ids = (one.id, two.id)
    pair = {
        "camera": one.id, "other": two.id, "n": len(two.photos), "photographs": len(one.photos) + len(two.photos),
        "width_px": two.width_px, "height_px": two.height_px, "turned": same[1], "reduced": same[0] != 1,
    }  # fmt: skip
    found.sort()
    if not found:
        return None, Notice(code="camera_kept_apart.not_adjusted", values=pair, ids=ids)
    value, dof, turned = found[0]
    pair |= {"chi_square": value, "dof": dof}
    if chi_square_tails(value, dof)[1] < ALPHA:
        return None, Notice(code="camera_kept_apart", values=pair, ids=ids)
    pair |= {"turn_deg": int(turned), "other_chi_square": found[1][0] if len(found) > 1 else float("nan")}
    join = Join(other=two.id, camera=one.id, turned=turned)
    if len(found) > 1 and found[1][0] - value < DECISIVE:
        return join, Notice(code="camera_joined.doubtful", values=pair, ids=ids, measured=Severity.WARNING)
    return join, Notice(code="camera_joined", values=pair, ids=ids)


def _variance(result: Adjustment) -> float:
    """By what a growth of the square sum counts: sigma0^2, and how much wider than by white noise cameras scatter."""
    ratio = result.noise.ratio_interior if result.noise.kind == "fields" else 1.0
    return result.sigma0**2 * (max(ratio, 1.0) ** 2 if np.isfinite(ratio) else 1.0)


def _apart(result: Adjustment, one: str, two: str) -> tuple[Adjustment, dict[str, tuple[str, ...]]]:
    """The adjustment with two interior orientations of the same free parameters, and the free parameters."""
    free = {i.camera: i.free for i in result.interior if i.image is None}
    both = tuple(dict.fromkeys((*free.get(one, ()), *free.get(two, ()))))
    wider = {**free, one: both, two: both}
    again = _adjusted(result, Shared(), wider)
    return (result, free) if again is None else (again, wider)


def _adjusted(result: Adjustment, shared: Shared, free: dict[str, tuple[str, ...]]) -> Adjustment | None:
    """What was adjusted, once more with what is shared; None where that cannot be."""
    start = shared.applied(as_start(result.given, result.adjusted))
    options = replace(
        result.options, reject="none", robust_start=False, statistics=False, tolerance=1e-3, noise="white"
    )
    ids = {c.id for c in start.cameras}
    try:
        return adjust_block(
            start, options, free={k: v for k, v in free.items() if k in ids},
            rejected=result.image_observations.rejected, extent="tests", start="adjusted",
        )  # fmt: skip
    except NotSolvable:
        return None


def _may_be_upside_down(result: Adjustment, groups: Sequence[CameraGroup], photos: Sequence[Photo]) -> bool:
    """Whether it is worth while to look: one camera that contradicts what is known, of photographs that say nothing."""
    stated = any(p.metadata.make or p.metadata.model for p in photos)
    free = any(i.free for i in result.interior)
    strange = any(n.code == "camera_contradicts" for n in result.notices)
    return strange and free and not stated and len(groups) == 1 and len(photos) >= FEWEST_HALVES


def against_gimbal(block: Block, photos: Sequence[Photo]) -> tuple[str, ...]:
    """Photographs that look the other way than their gimbals say, beside the others: stored upside down, perhaps.

    Of vertical photographs the heading of the gimbal and the direction of the image's upper side differ by one angle,
    the same for all; a program that turned the pixels of some so that they look alike adds 180 degrees.
    Empty where a photograph of the block states no heading, is not vertical, or fits neither.
    """
    gimbal = {p.name: p.metadata.gimbal for p in photos}
    oriented = np.flatnonzero(block.images.oriented)
    stated = [gimbal.get(block.images.ids[i]) for i in oriented.tolist()]
    if len(oriented) < FEWEST_HALVES or any(g is None or abs(g[1] + 90) > TILT_DEG for g in stated):
        return ()
    R = block.images.rotation[oriented]
    up = R[:, 2].mean(axis=0)
    up /= np.linalg.norm(up)
    east = np.linalg.svd(up[None])[2][1]
    north = np.cross(up, east)
    direction = np.arctan2(R[:, 1] @ north, R[:, 1] @ east)
    found = np.radians([(g[0] + (180 if abs(g[2]) > 90 else 0)) for g in stated if g is not None])
    both = direction + found  # headings grow clockwise
    middle = np.angle(np.exp(2j * both).mean()) / 2
    off = np.angle(np.exp(1j * (both - middle)))
    turned = np.abs(off) > np.pi / 2
    if turned.all() or not turned.any() or np.abs(np.angle(np.exp(2j * off)) / 2).max() > np.radians(TILT_DEG):
        return ()
    few = turned if 2 * turned.sum() <= len(turned) else ~turned
    return tuple(block.images.ids[i] for i in oriented[few].tolist())


def _half_turned_by(result: Adjustment, names: tuple[str, ...]) -> Shared | None:
    """These photographs as stored upside down, where that explains them better."""
    free = {i.camera: i.free for i in result.interior if i.image is None}
    after = _adjusted(result, Shared(half_turned=names), free)
    if after is None:
        return None
    gain = (result.weighted_square_sum - after.weighted_square_sum) / _variance(result)
    if gain < DECISIVE:
        return None
    n = int(result.given.images.oriented.sum())
    values = {"n": len(names), "others": n - len(names), "gain": gain}
    found = Notice(code="camera_joined.gimbal", values=values, ids=names)
    return Shared(half_turned=names, notices=(found,))


def _half_turned(result: Adjustment, photos: Sequence[Photo]) -> Shared | None:
    """Photographs up to one in their order, or after it, that are stored upside down, where that explains them better.

    A half turn leaves the format and moves the principal point to the other side.  With as many parameters, the
    likelihood of each place in the order is compared; that of the best must be decisive among all of them.
    """
    free = {i.camera: i.free for i in result.interior if i.image is None}
    names = [p.name for p in photos if p.name in set(result.given.images.ids)]
    tried: dict[int, float] = {}

    def square_sum(k: int) -> float:
        if k not in tried:
            after = _adjusted(result, Shared(half_turned=tuple(names[k:])), free)
            tried[k] = np.inf if after is None else after.weighted_square_sum
        return tried[k]

    n = len(names)
    step = max(1, n // (COARSE_STEPS + 1))
    best = min(range(step, n, step), key=square_sum)
    while step > 1:
        step = (step + 1) // 2
        best = min((k for k in (best - step, best, best + step) if 0 < k < n), key=square_sum)
    gain = (result.weighted_square_sum - square_sum(best)) / _variance(result)
    if gain < DECISIVE + 2 * np.log(n):
        return None
    few = names[best:] if 2 * best >= n else names[:best]
    values = {"n": len(few), "first": few[0], "last": few[-1], "others": n - len(few), "gain": gain}
    found = Notice(code="camera_joined.half_turned", values=values, ids=tuple(few))
    return Shared(half_turned=tuple(few), notices=(found,))
