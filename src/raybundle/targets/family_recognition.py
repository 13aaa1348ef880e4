"""Which board or which tags a photograph shows, by its looks: tried where nobody named the family.

Tags show their dictionary, and those of a ChArUco board the numbers of its squares; the squares of a chessboard and the
dots of a raster are counted.  What is returned is a name as `marks.target` understands it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.targets.codes import RingFamily
from raybundle.targets.detect import DetectionOptions, detect_targets, eight_bits
from raybundle.targets.kinds.charuco import RATIO
from raybundle.targets.kinds.chessboard import SIDE, grown
from raybundle.targets.kinds.circles import MISSING, Circles
from raybundle.targets.kinds.tags import dictionaries, dictionary, seen_tags
from raybundle.targets.lattice import lattices
from raybundle.targets.rings import circle, frame, sample

LARGEST = (
    "apriltag-36h11", "apriltag-25h9", "apriltag-16h5", "aruco-4x4_1000", "aruco-5x5_1000", "aruco-6x6_1000",
    "aruco-7x7_1000", "aruco-original", "aruco-mip_36h12",
)  # fmt: skip
"""Dictionaries that are tried; the smaller ones of ArUco are the beginnings of these."""
SQUARES = range(3, 41)
"""Squares along a side of a ChArUco board."""
FITS = 0.2
"""Largest mean distance of a board's tags from their places, in squares."""
TAGS_OF_A_BOARD = 5
"""Tags in one photograph from which on the board is reported."""
DOTS = 12
"""Dots of a raster at least: fewer stand in rows on many things."""
FULL = 0.9
"""Share of the places of a raster that must hold a dot."""
SHORT = (5, 4)
"""Corners from which on a chessboard is seen."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SeenTags:
    """Tags of one dictionary in one photograph."""

    id: Index
    """(n,)"""
    corners: Array
    """(n, 4, 2) pixel frame, from the upper left one clockwise as the dictionary draws the tag"""


def tags_seen(image: Array) -> dict[str, SeenTags]:
    """Tags (h, w) by dictionary, each number once; empty where there are none."""
    eight = eight_bits(image)[0]
    found: dict[str, SeenTags] = {}
    for name in LARGEST:
        ids, corners = seen_tags(eight, dictionary(name))
        if not len(ids):
            continue
        numbers, first = np.unique(ids, return_index=True)
        found[name] = SeenTags(id=numbers, corners=corners[first])
    return found


def smallest(name: str, most: int) -> str:
    """The smallest dictionary that begins as this one does and holds the tag `most`."""
    stem, _, count = name.rpartition("_")
    if not count.isdecimal() or not name.startswith("aruco-") or "x" not in stem:
        return name
    sizes = sorted(int(n.rpartition("_")[2]) for n in dictionaries() if n.startswith(f"{stem}_"))
    return f"{stem}_{next(s for s in sizes if s > most)}"


def charuco_of(name: str, views: Sequence[SeenTags]) -> str | None:
    """Name of the ChArUco board whose tags these are, None where they are none of a board.

    A board's tags are numbered along its rows, one in every other square.  Limits: rows of squares
    beyond the last tag that any view shows.
    """
    views = [v for v in views if len(v.id) >= TAGS_OF_A_BOARD]
    if not views:
        return None
    tried = [
        (np.median([_fit(v, columns, first) for v in views], axis=0), columns, first)
        for columns in SQUARES
        for first in (0, 1)
    ]
    (off, ratio), columns, first = min(tried, key=lambda k: float(k[0][0]))
    if not off < FITS:
        return None
    last = max(int(v.id.max()) for v in views)
    rows = int(_places(np.array([last]), columns, first)[0, 1]) + 1
    ratio = round(20 * ratio) / 20 if abs(20 * ratio - round(20 * ratio)) < 0.4 else round(ratio, 2)
    tags = smallest(name, (columns * rows + 1) // 2 - 1)
    short = tags.removeprefix("aruco-") if tags.startswith("aruco-") else tags.replace("apriltag-", "apriltag_")
    tail = "" if ratio == RATIO else f"-{ratio:g}"
    if rows < SQUARES[0] or not 0.3 <= ratio <= 0.95:
        return None
    return f"charuco-{columns}x{rows}-{short}{tail}"


def _places(ids: Index, columns: int, first: int) -> Index:
    """Column and row (n, 2) of tags; those of the first row stand in columns first, first + 2 ..."""
    own, other = len(range(first, columns, 2)), len(range(1 - first, columns, 2))
    pair, rest = np.divmod(ids, own + other)
    upper = rest < own
    row = 2 * pair + ~upper
    column = np.where(upper, first + 2 * rest, 1 - first + 2 * (rest - own))
    return np.stack([column, row], axis=1)


def _fit(view: SeenTags, columns: int, first: int) -> tuple[float, float]:
    """Mean distance of tags from their places in a board [squares], and the side of a tag in squares."""
    place = _places(view.id, columns, first) + 0.5
    H: Any = cv2.findHomography(view.corners.mean(axis=1), place.astype(float), 0)[0]
    if H is None:
        return np.inf, 0.0
    p = np.column_stack([view.corners.reshape(-1, 2), np.ones(4 * len(place))]) @ H.T
    at = (p[:, :2] / p[:, 2:]).reshape(-1, 4, 2)
    right = np.median(at[:, 1] - at[:, 0], axis=0)
    if not right[0] > 2 * abs(right[1]):  # tags stand upright in their board
        return np.inf, 0.0
    side = np.linalg.norm(at - np.roll(at, 1, axis=1), axis=2)
    return float(np.linalg.norm(at.mean(axis=1) - place, axis=1).mean()), float(np.median(side))


def ring_end(image: Array, family: RingFamily) -> float:
    """Outer radius of the rings (h, w) that are read as those of a family, in radii of their dots; NaN without any.

    The median over rings and directions.  Families that share codes under different numbers differ in it.
    """
    d = detect_targets(image, family, DetectionOptions(uncoded="none"))
    if not len(d):
        return float("nan")
    radii = np.arange(family.read[0], 4.6, 0.05)
    u = circle(np.arange(180) * np.pi / 90)
    places = (u * np.append(1.5, radii)[:, None, None]).reshape(-1, 2) @ frame(d.ellipse).transpose(0, 2, 1)
    v = sample(eight_bits(image)[0], d.xy_px[:, None] + places).reshape(len(d), 1 + len(radii), len(u))
    ground = np.median(v[:, 0], axis=1)[:, None, None]
    share = (v[:, 1:] - ground) * np.sign(d.contrast)[:, None, None]
    inner = share[:, radii < family.read[1]].mean(axis=1)
    dark = inner.max(axis=1, keepdims=True)
    on = inner > 0.75 * dark  # the middle of set sectors
    off = share < 0.5 * dark[..., None]
    end = np.where(off.any(axis=1), radii[np.argmax(off, axis=1)], radii[-1])
    return float(np.median(end[on]))


def raster_of(image: Array, threads: int = 1) -> str | None:
    """Name of the raster of dots in a photograph (h, w), as circles-7x5 or acircles-4x11; None where there is none."""
    dots = detect_targets(image, None, DetectionOptions(threads=threads))
    for sign in (-1, 1):
        chosen = dots.rows(dots.polarity == sign)
        for k in lattices(chosen.xy_px, chosen.ellipse, DOTS):
            columns, rows = k.size
            grid = k.grid()
            if min(columns, rows) >= 3 and (grid >= 0).mean() >= FULL:
                return Circles(columns=max(columns, rows), rows=min(columns, rows)).family
            staggered = _staggered(grid >= 0)
            if staggered is not None:
                return staggered.family
    return None


def _staggered(filled: Mask) -> Circles | None:
    """The staggered raster whose diagonals are the axes of a lattice."""
    found: list[tuple[float, Circles]] = []
    for k in range(4):
        v, u = np.nonzero(np.rot90(filled, k))
        x, y = u - v, u + v
        x, y = x - x.min(), y - y.min()
        even = y % 2 == 0
        if even.all() or not even.any() or (x[even] % 2).any() or not (x[~even] % 2).all():
            continue
        columns, rows = int(x.max()) // 2 + 1, int(y.max()) + 1
        if min(columns, rows) >= 3:
            found.append((len(x) / (columns * rows), Circles(columns=columns, rows=rows, staggered=True)))
    # seen from the side, with rows for columns, some places of a raster are empty
    fullest = max(found, key=lambda f: f[0], default=None)
    return fullest[1] if fullest is not None and fullest[0] >= 1 - MISSING else None


def chessboard_of(image: Array) -> str | None:
    """Name of the chessboard in a photograph (h, w), as chessboard-9x6; None where there is none."""
    small = eight_bits(image)[0]
    while max(small.shape) > SIDE:
        small = cv2.resize(small[: small.shape[0] // 2 * 2, : small.shape[1] // 2 * 2], None, fx=0.5, fy=0.5,
                           interpolation=cv2.INTER_AREA)  # fmt: skip
    flags = cv2.CALIB_CB_LARGER | cv2.CALIB_CB_NORMALIZE_IMAGE
    seen, found, meta = cv2.findChessboardCornersSBWithMeta(small, SHORT, flags)
    if not seen:
        return None
    corners = np.asarray(found, float).reshape(*meta.shape[:2], 2) + 0.5
    # what was found may be a part of the board
    rows, columns = grown(np.ascontiguousarray(small, np.uint16), corners).shape[:2]
    return f"chessboard-{max(rows, columns)}x{min(rows, columns)}"
