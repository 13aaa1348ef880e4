"""Stations that were taken held against those that were planned, whatever the frame and scale of either."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import linear_sum_assignment

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.transform import similarity
from raybundle.planning.network.candidates import Stations

NEAR = 0.35
"""Part of the distance to what is looked at by which a station may be missed"""
BESIDE = 0.05
"""How much farther than twice the nearest planned station the one may be that a photograph is taken for: one that was
taken twice does not stand for its neighbour"""
ALONG_DEG = 25.0
"""Angle by which its view may be missed"""
ROLLED_DEG = 45.0
"""Turn about the axis from which on the camera was held otherwise"""
SHARE = 0.5
"""Of the photographs that must be on the list, or it is another one"""
CLOSE = 0.5
"""Mean nearness of stations that agree, half of the limit: those of another list lie anywhere within it"""
SAME = 0.02
"""Nearness for each place by which two ways of laying photographs onto a list differ no more than by chance: then that
counts in which they follow each other as listed"""
SEEDS, OTHERS = 10, 6
"""Stations taken from which the frame is tried, and others beside each of them"""
AGREE_DEG = 15.0
"""Angle by which the way from one to another may be off in a trial"""
MOST, REFINED = 4000, 60
"""Frames that are scored, and those of them that are fitted"""

Frame = tuple[Array, float, Array]
"""Rotation, scale and shift of the taken onto the planned"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Ticked:
    """What came of a list."""

    of: Index
    """(t,) planned station of each that was taken; -1: beside the list"""
    missing: Index
    """Planned stations that nobody took"""
    doubled: Index
    """Planned stations that were taken more than once"""
    rolled: Index
    """Taken stations at the right place whose camera was held otherwise"""
    alike: bool = False
    """Whether another way of laying the photographs onto the list fits as well: which is which follows their order"""


def ticked(planned: Stations, taken: Stations) -> Ticked:
    """Which of the planned stations were taken.

    raises  InputError where too few stations of the two agree in any frame, or badly: then they are of another list
    The frame of `taken` is arbitrary: that in which they agree best with the list counts; where a list looks the same
    after a turn, as a ring, the one in which photographs follow each other as listed.  Limits: of such a
    list whose photographs come in another order, which of its stations is which (`alike`).
    """
    tried = [(_closeness(planned, taken, *_assigned(planned, taken, f), f), f) for f in _frames(planned, taken)]
    tried.sort(key=lambda t: -t[0])
    fits = [_fitted(planned, taken, frame) for _, frame in tried[:REFINED]]
    worth = np.array([_closeness(planned, taken, of, off, frame) for frame, of, off in fits])
    if not fits:
        raise InputError("plan.one_place")
    fair = np.flatnonzero(worth > worth.max() - SAME * len(np.unique(fits[int(worth.argmax())][1])))
    k = max(fair.tolist(), key=lambda i: (_order(fits[i][1]), worth[i]))
    frame, of, off = fits[k]
    agree, wanted = len(np.unique(of[of >= 0])), min(len(planned), len(taken))
    close = _nearness(of, off).sum() / max(agree, 1)
    if agree < max(min(3, len(planned)), SHARE * wanted) or close < CLOSE:
        raise InputError("plan.other_list", n=agree, total=wanted, off=NEAR * (1 - close), limit=NEAR * (1 - CLOSE))
    count = np.bincount(of[of >= 0], minlength=len(planned))
    return Ticked(
        of=of, missing=np.flatnonzero(count == 0), doubled=np.flatnonzero(count > 1),
        rolled=np.flatnonzero((of >= 0) & (_rolls(planned, taken, of, frame[0]) > ROLLED_DEG)),
        alike=any(np.mean(fits[i][1][of >= 0] != of[of >= 0]) > SHARE for i in fair),
    )  # fmt: skip


def _fitted(planned: Stations, taken: Stations, frame: Frame) -> tuple[Frame, Index, Array]:
    """The frame that fits best all that agree in this one, what agrees in it, and how far everything is off."""
    of, off = _assigned(planned, taken, frame)
    for _ in range(4):
        good = np.flatnonzero(of >= 0)
        if len(good) < 3:
            break
        try:
            fit = similarity(taken.centre[good], planned.centre[of[good]])
        except InputError:
            break  # in a line: the first frame stands
        frame = fit.rotation, fit.scale, fit.points(np.zeros((1, 3)))[0]
        of, off = _assigned(planned, taken, frame)
    return frame, _one_each(off), off


def _rolls(planned: Stations, taken: Stations, of: Index, Q: Array) -> Array:
    """(t,) turns of the cameras about their axes against the list [deg]; of no meaning beside the list."""
    turned = taken.rotation @ Q.T @ np.swapaxes(planned.rotation[np.maximum(of, 0)], 1, 2)
    return np.abs(np.degrees(np.arctan2(turned[:, 1, 0], turned[:, 0, 0])))


def _nearness(of: Index, off: Array) -> Array:
    """(p,) of each planned station how near the best photograph of it is: 1 at its place, 0 at the limit or without."""
    mine = np.flatnonzero(of >= 0)
    near = np.zeros(off.shape[1])
    np.maximum.at(near, of[mine], 1 - off[mine, of[mine]] / NEAR)
    return near


def _closeness(planned: Stations, taken: Stations, of: Index, off: Array, frame: Frame) -> float:
    """How well stations agree: near their places, and the camera held as listed."""
    mine = np.flatnonzero(of >= 0)
    if not len(mine):
        return 0.0
    held = float(np.mean(_rolls(planned, taken, of, frame[0])[mine] < ROLLED_DEG))
    return float(_nearness(of, off).sum()) + 0.5 * held


def _order(of: Index) -> float:
    """Share of photographs that follow each other as listed."""
    mine = of[of >= 0]
    return float(np.mean(np.diff(mine) > 0)) if len(mine) > 1 else 0.0


def _frames(planned: Stations, taken: Stations) -> list[tuple[Array, float, Array]]:
    """Rotations, scales and shifts of the taken onto the planned, each from two pairs of stations."""
    rp, rt = planned.rotation, taken.rotation
    n, m = len(planned), len(taken)
    seeds = np.unique(np.linspace(0, m - 1, min(SEEDS, m)).round().astype(int))
    found = list[tuple[Array, float, Array]]()
    for a in seeds:
        others = [b for b in np.unique(np.linspace(0, m - 1, min(OTHERS, m)).round().astype(int)) if b != a]
        for i in range(n):
            for quarter in range(4):
                c, q = [(1, 0), (0, 1), (-1, 0), (0, -1)][quarter]
                turn = np.array([[c, -q, 0.0], [q, c, 0.0], [0, 0, 1.0]])
                Q = rp[i].T @ turn @ rt[a]
                for b in others:
                    way = Q @ (taken.centre[b] - taken.centre[a])
                    ways = planned.centre - planned.centre[i]
                    far, long = np.linalg.norm(ways, axis=1), float(np.linalg.norm(way))
                    if long == 0:
                        continue
                    with np.errstate(all="ignore"):
                        cosine = ways @ way / (far * long)
                    for j in np.flatnonzero(cosine > np.cos(np.radians(AGREE_DEG))):
                        s = float(far[j] / long)
                        found.append((Q, s, planned.centre[i] - s * Q @ taken.centre[a]))
    step = max(1, -(-len(found) // MOST))
    return found[::step]


def _one_each(off: Array) -> Index:
    """As `_assigned`, but stations near each other are distinguished: each is taken once before one is taken twice."""
    of = np.full(len(off), -1)
    near = off.min(axis=1, keepdims=True)
    fair = np.where(off <= 2 * near + BESIDE, off, np.inf)
    rows, columns = linear_sum_assignment(np.minimum(fair, 3 * NEAR))
    good = fair[rows, columns] < NEAR
    of[rows[good]] = columns[good]
    again = (of < 0) & (off.min(axis=1) < NEAR)
    of[again] = off[again].argmin(axis=1)
    return of


def _assigned(planned: Stations, taken: Stations, frame: Frame) -> tuple[Index, Array]:
    """(t,) nearest planned station that looks alike, -1: none; and how far every two are off."""
    off = _off(planned, taken, *frame)
    of = off.argmin(axis=1)
    return np.where(off[np.arange(len(of)), of] < NEAR, of, -1), off


def _off(planned: Stations, taken: Stations, Q: Array, s: float, t: Array) -> Array:
    """(t, p) distances by that of the planned station to the object; infinite where it looks elsewhere."""
    centre = s * taken.centre @ Q.T + t
    ahead = -(taken.rotation[:, 2] @ Q.T)
    away = planned.at - planned.centre
    depth = np.linalg.norm(away, axis=1)
    off = np.linalg.norm(centre[:, None] - planned.centre[None], axis=2) / depth[None]
    alike = ahead @ (away / depth[:, None]).T > np.cos(np.radians(ALONG_DEG))
    return np.where(alike, off, np.inf)
