"""Stations that a further photograph could be taken from: near existing ones, and round the object."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.planning.next.visibility import well_spread

MOST = 1000
"""Candidates."""
STEPS = (0.25, 0.5, 1.0)
"""Shifts of existing stations to each side, and towards and away from the object, as shares of the reach."""
NEARER = 0.6
"""Of the distance to what is looked at, the most that a station moves towards it: nearer, the format holds little."""
RING = (0.7, 1.0, 1.4)
"""Distances of stations round the object, as shares of the median one."""
TURN = np.radians(15)
"""Between stations round the object: the photographs of a ring are as near as half of what points look alike from."""
ROLLS = np.radians([0.0, 90.0, -90.0])
SAME_PLACE, SAME_WAY = 0.02, np.radians(10)
"""Of the distance to the object, and turn, below which a photograph is one that there is, once more"""
WEAK = 3
"""Weak places that are looked at, besides the middle of the object."""
FEW = 200
"""Points up to which the lowest and outermost count; of more, 1 % at either end of an axis do not."""
APART = 0.2
"""Of the extent of the object, how far weak places are apart."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Reach:
    """Where one can stand, in the frame and the length unit of the block; None: not limited, or as stated."""

    step: float | None = None
    """Farthest from an existing station; None: the median distance from the stations to the points that they see"""
    around: float | None = None
    """Farthest from the box round the object points"""
    heights: tuple[float, float] | None = None
    """Lowest and highest Z over the lowest object point; None: where the vertical is known, none below the lowest
    station"""
    clearance: float | None = None
    """Least distance to any object point; None: a tenth of the median distance"""
    forbidden: Array = field(default_factory=lambda: np.zeros((0, 2, 3)))
    """(k, 2, 3) boxes in which no station may be"""
    allowed: Callable[[Array], Mask] | None = None
    """Which (n,) of places (n, 3) are allowed besides; None: all"""
    most: int = MOST
    """Candidates"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Reachable:
    """Stations (n) that could be taken."""

    centre: Array
    """(n, 3)"""
    rotation: Array
    """(n, 3, 3) object axes to image axes"""
    towards: Array
    """(n, 3) what is looked at"""


def reachable(
    block: Block, used: Mask, camera: int, least: Array, up: Array | None, reach: Reach, points: Index
) -> Reachable:
    """Stations for a camera, evenly thinned to as many as are wanted.

    used     (m,) image observations that take part
    points   (t,) object points that are regarded
    least    (t,) how little each is determined: the worst are looked at, and the middle of all
    up       (3,) vertical; None: not known, rolls are then taken from the nearest existing photograph
    raises   InputError where no station is left within the limits
    """
    o, images = block.observations, block.images
    seen = np.bincount(o.image[used], minlength=len(images)) > 0
    mine = np.flatnonzero(seen & (images.camera == camera))
    if not len(mine):
        raise InputError("plan.camera_not_used", camera=block.cameras[camera].id)
    rows = np.flatnonzero(used & (images.camera[o.image] == camera))
    distance = float(np.median(np.linalg.norm(block.points.xyz[o.point[rows]] - images.centre[o.image[rows]], axis=1)))
    xyz = block.points.xyz[points]
    targets = looked_at(xyz, least)
    step = reach.step or distance
    centre, towards, like = _shifted(block, mine, targets, step)
    round_centre, round_towards = _round(block, mine, targets, distance)
    nearest = np.argmin(np.linalg.norm(round_centre[:, None] - images.centre[mine][None], axis=2), axis=1)
    centre, towards = np.concatenate([centre, round_centre]), np.concatenate([towards, round_towards])
    like = np.concatenate([like, mine[nearest]])
    within = _within(centre, towards, images.centre[mine], xyz, reach, step, distance)
    if up is not None and reach.heights is None:  # people stand on the ground
        within &= centre @ up >= (images.centre[mine] @ up).min() - 1e-9 * distance
    if not within.any():
        raise InputError("plan.no_station_within", n=len(within))
    centre, towards, like = centre[within], towards[within], like[within]
    chosen = well_spread(centre, max(1, reach.most // len(ROLLS)))
    centre, towards, like = centre[chosen], towards[chosen], like[chosen]
    level = looking(towards - centre, images.rotation[like], up)
    roll = rotation_from_vector(np.stack([np.zeros(3), np.zeros(3), ROLLS], axis=1))
    rotation = (roll[None] @ level[:, None]).reshape(-1, 3, 3)
    centre, towards = np.repeat(centre, len(ROLLS), axis=0), np.repeat(towards, len(ROLLS), axis=0)
    new = ~_again(centre, rotation, block, np.repeat(like, len(ROLLS)), distance)
    return Reachable(centre=centre[new], rotation=rotation[new], towards=towards[new])


def _again(centre: Array, rotation: Array, block: Block, like: Index, distance: float) -> Mask:
    """(n,) whether a photograph would be an existing one once more: of that place, in that direction, held alike."""
    near = np.linalg.norm(centre - block.images.centre[like], axis=1) < SAME_PLACE * distance
    trace = np.einsum("nij,nij->n", rotation, block.images.rotation[like])
    return near & (trace > 1 + 2 * np.cos(SAME_WAY))


def looked_at(xyz: Array, least: Array) -> Array:
    """(q, 3) the middle of points (t, 3) and the places of the worst of them, apart from one another."""
    middle = np.median(xyz, axis=0)
    extent = float(np.linalg.norm(np.quantile(xyz, 0.98, axis=0) - np.quantile(xyz, 0.02, axis=0)))
    found = [middle]
    for k in np.argsort(-least, kind="stable")[: max(1, len(xyz) // 10)]:
        if len(found) > WEAK:
            break
        if len(found) == 1 or np.linalg.norm(np.array(found[1:]) - xyz[k], axis=1).min() > APART * extent:
            found.append(xyz[k])
    return np.array(found)


def looking(direction: Array, near: Array, up: Array | None) -> Array:
    """(n, 3, 3) cameras that look along directions (n, 3), held level.

    near  (n, 3, 3) existing photographs: where the vertical is not known, or looked along, x is as near as can be to
          theirs
    """
    z = -direction / np.linalg.norm(direction, axis=1, keepdims=True)
    right = near[:, 0].copy()
    if up is not None:
        level = np.cross(np.broadcast_to(up, z.shape), z)
        size = np.linalg.norm(level, axis=1, keepdims=True)
        right = np.where(size > np.sin(np.radians(20)), level / np.maximum(size, 1e-300), right)
    x = right - np.einsum("ni,ni->n", right, z)[:, None] * z
    short = np.linalg.norm(x, axis=1) < 1e-3
    x[short] = np.cross(near[short, 1], z[short])
    x = x / np.linalg.norm(x, axis=1, keepdims=True)
    return np.stack([x, np.cross(z, x), z], axis=1)


def _shifted(block: Block, mine: Index, targets: Array, step: float) -> tuple[Array, Array, Index]:
    """Stations beside existing ones (thinned where there are very many), what is looked at, and the existing one."""
    images = block.images
    some = mine[well_spread(images.centre[mine], 60)]
    R, X0 = images.rotation[some], images.centre[some]
    moves = [np.zeros(3)]
    moves += [s * share * np.eye(3)[axis] for share in STEPS for axis in (0, 1, 2) for s in (-1.0, 1.0)]
    moved = X0[:, None] + step * np.einsum("kj,nji->nki", np.array(moves), R)
    # what each existing photograph looks at stays in sight
    depth = np.einsum("ni,ni->n", X0 - targets[0], R[:, 2])
    ahead = X0 - np.maximum(depth, 1e-3 * np.abs(depth).max(initial=1.0))[:, None] * R[:, 2]
    looked = np.concatenate([ahead[:, None], np.broadcast_to(targets, (len(some), *targets.shape))], axis=1)
    n, k, q = len(some), len(moves), looked.shape[1]
    centre = np.broadcast_to(moved[:, :, None], (n, k, q, 3)).reshape(-1, 3)
    towards = np.broadcast_to(looked[:, None], (n, k, q, 3)).reshape(-1, 3)
    return centre.copy(), towards.copy(), np.repeat(some, k * q)


def _round(block: Block, mine: Index, targets: Array, distance: float) -> tuple[Array, Array]:
    """Stations on rings round the object, over the sides from which it was photographed and some steps of TURN more."""
    middle = targets[0]
    away = block.images.centre[mine] - middle
    away = away / np.maximum(np.linalg.norm(away, axis=1, keepdims=True), 1e-300)
    count = int(np.ceil(4 * np.pi / TURN**2))
    k = np.arange(count) + 0.5
    z, turn = 1 - 2 * k / count, np.pi * (1 + np.sqrt(5)) * k
    flat = np.sqrt(1 - z**2)
    directions = np.stack([flat * np.cos(turn), flat * np.sin(turn), z], axis=1)
    directions = directions[(directions @ away.T).max(axis=1) > np.cos(3 * TURN)]
    centre = middle + distance * np.array(RING)[:, None, None] * directions
    centre = centre.reshape(-1, 3)
    q = len(targets)
    return np.repeat(centre, q, axis=0), np.tile(targets, (len(centre), 1))


def _within(
    centre: Array, towards: Array, existing: Array, xyz: Array, reach: Reach, step: float, distance: float
) -> Mask:
    """(n,) stations within the limits."""
    from scipy.spatial import KDTree

    good = np.linalg.norm(centre - towards, axis=1) >= NEARER * distance / 2
    good &= KDTree(existing).query(centre)[0] <= step * (1 + 1e-9)
    good &= KDTree(xyz).query(centre)[0] >= (0.1 * distance if reach.clearance is None else reach.clearance)
    low, high = np.quantile(xyz, [0.01, 0.99], axis=0) if len(xyz) > FEW else (xyz.min(axis=0), xyz.max(axis=0))
    if reach.heights is not None:
        above = centre[:, 2] - low[2]
        good &= (above >= reach.heights[0]) & (above <= reach.heights[1])
    if reach.around is not None:
        beyond = np.maximum(np.maximum(low - centre, centre - high), 0.0)
        good &= np.linalg.norm(beyond, axis=1) <= reach.around
    if len(reach.forbidden):
        within = (centre[:, None] >= reach.forbidden[:, 0]) & (centre[:, None] <= reach.forbidden[:, 1])
        good &= ~np.any(np.asarray(within.all(axis=2)), axis=1)
    rows = np.flatnonzero(good)
    if reach.allowed is not None and len(rows):
        good[rows] = reach.allowed(centre[rows])
    return np.asarray(good)
