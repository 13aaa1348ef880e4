"""Stations that were taken held against those that were planned, whatever the frame and scale of either."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import linear_sum_assignment

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.transform import similarity
from raybundle.planning.candidates import Stations

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


def ticked(planned: Stations, taken: Stations) -> Ticked:
    """Which of the planned stations were taken.

    raises  InputError where fewer than three stations of the two agree in any frame
    The frame of `taken` is arbitrary: that in which most agree with the list counts; where a list looks the same after
    a turn, as a ring, the one in which cameras are held as listed and photographs follow each other as listed.  What it
    does not tell: of a ring whose photographs come in another order, which of its stations is which.
    """
    tried = list[tuple[float, Frame]]()
    for frame in _frames(planned, taken):
        of = _assigned(planned, taken, *frame)
        tried.append((_score(planned, taken, of, frame[0]), frame))
    tried.sort(key=lambda f: -f[0])
    best, at = 0.0, None
    for _, frame in tried[:REFINED]:
        fitted, of = _fitted(planned, taken, frame)
        score = _score(planned, taken, of, fitted[0])
        if score > best:
            best, at = score, fitted
    if at is None or int(best) < max(min(3, len(planned)), SHARE * min(len(planned), len(taken))):
        raise InputError(
            f"the stations of these photographs agree with the list in {int(best)} of {min(len(planned), len(taken))} "
            "places at most: are they of this list?"
        )
    of = _one_each(planned, taken, *at)
    count = np.bincount(of[of >= 0], minlength=len(planned))
    return Ticked(
        of=of, missing=np.flatnonzero(count == 0), doubled=np.flatnonzero(count > 1),
        rolled=np.flatnonzero((of >= 0) & (_rolls(planned, taken, of, at[0]) > ROLLED_DEG)),
    )  # fmt: skip


def _fitted(planned: Stations, taken: Stations, frame: Frame) -> tuple[Frame, Index]:
    """The frame that fits best all that agree in this one, and what agrees in it."""
    of = _assigned(planned, taken, *frame)
    for _ in range(4):
        good = np.flatnonzero(of >= 0)
        if len(good) < 3:
            break
        try:
            fit = similarity(taken.centre[good], planned.centre[of[good]])
        except InputError:
            break  # in a line: the first frame stands
        frame = fit.rotation, fit.scale, fit.points(np.zeros((1, 3)))[0]
        of = _assigned(planned, taken, *frame)
    return frame, _one_each(planned, taken, *frame)


def _rolls(planned: Stations, taken: Stations, of: Index, Q: Array) -> Array:
    """(t,) turns of the cameras about their axes against the list [deg]; of no meaning beside the list."""
    turned = taken.rotation @ Q.T @ np.swapaxes(planned.rotation[np.maximum(of, 0)], 1, 2)
    return np.abs(np.degrees(np.arctan2(turned[:, 1, 0], turned[:, 0, 0])))


def _score(planned: Stations, taken: Stations, of: Index, Q: Array) -> float:
    """How many places agree; among equal numbers those in which cameras are held and follow each other as listed."""
    mine = np.flatnonzero(of >= 0)
    if not len(mine):
        return 0.0
    held = float(np.mean(_rolls(planned, taken, of, Q)[mine] < ROLLED_DEG))
    onwards = float(np.mean(np.diff(of[mine]) > 0)) if len(mine) > 1 else 0.0
    return len(np.unique(of[mine])) + 0.5 * held + 0.4 * onwards


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


def _one_each(planned: Stations, taken: Stations, Q: Array, s: float, t: Array) -> Index:
    """As `_assigned`, but stations near each other are told apart: each is taken once before one is taken twice."""
    off = _off(planned, taken, Q, s, t)
    of = np.full(len(off), -1)
    near = off.min(axis=1, keepdims=True)
    fair = np.where(off <= 2 * near + BESIDE, off, np.inf)
    rows, columns = linear_sum_assignment(np.minimum(fair, 3 * NEAR))
    good = fair[rows, columns] < NEAR
    of[rows[good]] = columns[good]
    again = (of < 0) & (off.min(axis=1) < NEAR)
    of[again] = off[again].argmin(axis=1)
    return of


def _assigned(planned: Stations, taken: Stations, Q: Array, s: float, t: Array) -> Index:
    """(t,) nearest planned station that looks alike; -1: none."""
    off = _off(planned, taken, Q, s, t)
    of = off.argmin(axis=1)
    least = off[np.arange(len(of)), of]
    return np.where(least < NEAR, of, -1)


def _off(planned: Stations, taken: Stations, Q: Array, s: float, t: Array) -> Array:
    """(t, p) distances by that of the planned station to the object; infinite where it looks elsewhere."""
    centre = s * taken.centre @ Q.T + t
    ahead = -(taken.rotation[:, 2] @ Q.T)
    away = planned.at - planned.centre
    depth = np.linalg.norm(away, axis=1)
    off = np.linalg.norm(centre[:, None] - planned.centre[None], axis=2) / depth[None]
    alike = ahead @ (away / depth[:, None]).T > np.cos(np.radians(ALONG_DEG))
    return np.where(alike, off, np.inf)
