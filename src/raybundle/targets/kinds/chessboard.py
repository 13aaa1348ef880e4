"""Chessboards, by their inner corners: chessboard-9x6 has 9 of them in a row and 6 rows, 10 x 7 squares.

A board is found whole or not at all: nobody can show which corners a part of it shows.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

import cv2
import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.reading.words import whole_of
from raybundle.numerics.arrays import Array
from raybundle.targets.detect import eight_bits
from raybundle.targets.marks import (
    Kind,
    MarkOptions,
    Marks,
    Target,
    grid_objects,
    no_ellipses,
    nothing,
    register,
    two_seen,
    with_numbers,
)
from raybundle.targets.saddle import CornerOptions, Corners, fit_corners

NAME = re.compile(r"chessboard-(\d+)x(\d+)")
SIDE = 1400
"""Longest side in which a board is sought: larger photographs are halved [px]."""
LEAST_SHARE = 0.8
"""Share of the corners that must be measurable."""
LARGER = 0.6
"""Share of the corners beyond one side that, seen, say that the board is larger."""
FEWEST, MOST = 3, 200
"""Corners along a side."""
BORDER = 1.3
"""How far around its corners a board is painted over, when another one is sought, in squares."""
COARSE = 14.0
"""Side of a square of the first board where a second one is sought [px]: one of half its size is found, too."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Chessboard:
    """A chessboard of so many inner corners; r0c0 lies within the first square between corners that is dark."""

    columns: int
    rows: int

    @property
    def family(self) -> str:
        """chessboard-9x6."""
        return f"chessboard-{self.columns}x{self.rows}"

    @property
    def title(self) -> str:
        """For people."""
        return f"chessboard of {self.columns} x {self.rows} inner corners"

    @property
    def objects(self) -> Mapping[str, Array]:
        """Corners in units of a square."""
        return grid_objects(self.columns, self.rows)

    @property
    def turns(self) -> int:
        """One where exactly one of the numbers of corners is odd; then colours show where a board begins."""
        if self.columns == self.rows:
            return 4 if self.columns % 2 else 2
        return 2 if (self.columns + self.rows) % 2 == 0 else 1

    @property
    def radius(self) -> float:
        """Corners have none."""
        return np.nan

    def find(self, image: Array, options: MarkOptions) -> Marks:
        """All corners that can be measured, or none."""
        del options
        boards = find_boards(eight_bits(image)[0], (self.columns, self.rows))
        if not boards:
            return nothing(
                self.family,
                phrase(
                    "target_seen.no_board",
                    target=self.family,
                    squares=self._squares(image),
                    named=f"chessboard-{self.columns - 1}x{self.rows - 1}",
                ),
            )
        if len(boards) > 1:
            return nothing(self.family, two_seen(self.family))
        (rough,) = boards
        image = np.ascontiguousarray(image, np.uint16)
        fitted = measure_grid(image, rough)
        good = fitted.measured.reshape(rough.shape[:2])
        if good.mean() < LEAST_SHARE:
            return nothing(
                self.family,
                phrase("target_seen.few_corners", target=self.family, n=int(good.sum()), of=good.size),
            )
        if beyond(image, np.where(good[..., None], fitted.xy_px.reshape(rough.shape), rough)):
            return nothing(
                self.family,
                phrase("target_seen.larger_board", columns=self.columns, rows=self.rows),
            )
        turned = self._turn(fitted.xy_px.reshape(rough.shape), fitted.contrast.reshape(good.shape))
        order = turned.reshape(-1)
        names = [f"r{r}c{c}" for r in range(self.rows) for c in range(self.columns)]
        kept = [(n, i) for n, i in zip(names, order, strict=True) if fitted.measured[i]]
        which = np.array([i for _, i in kept])
        return Marks(
            family=self.family, name=tuple(n for n, _ in kept), xy_px=fitted.xy_px[which],
            covariance=fitted.covariance[which], ellipse=no_ellipses(len(which)), gate=fitted.residual[which],
        )  # fmt: skip

    def _squares(self, image: Array) -> bool:
        """Whether a board of as many squares as this one has corners is seen."""
        columns, rows = self.columns - 1, self.rows - 1
        if min(columns, rows) < FEWEST:
            return False
        boards = find_boards(eight_bits(image)[0], (columns, rows))
        return len(boards) == 1 and not beyond(np.ascontiguousarray(image, np.uint16), boards[0])

    def _turn(self, xy: Array, contrast: Array) -> Array:
        """Corners (rows, columns) as positions in the order found: seen from the front, dark first square."""
        at = np.arange(xy.shape[0] * xy.shape[1]).reshape(xy.shape[:2])
        across, down = xy[0, -1] - xy[0, 0], xy[-1, 0] - xy[0, 0]
        if across[0] * down[1] - across[1] * down[0] < 0:  # a mirrored order, not a mirrored board
            at = at[:, ::-1]
        if at.shape != (self.rows, self.columns):
            at = np.rot90(at)
        ways = [np.rot90(at, k) for k in range(4)]
        ways = [w for w in ways if w.shape == (self.rows, self.columns)]
        flat, sign = xy.reshape(-1, 2), np.sign(np.median(contrast * _alternating(contrast.shape)))
        # + where the square between the corner, its right and its lower neighbour is light
        light = (sign * _alternating(contrast.shape)).reshape(-1)
        dark_first = [w for w in ways if _light(w, light) < 0] or ways
        return max(dark_first, key=lambda w: float(_heading(flat[w[0, -1]] - flat[w[0, 0]])))


def _alternating(shape: tuple[int, ...]) -> Array:
    return np.where(np.add.outer(np.arange(shape[0]), np.arange(shape[1])) % 2 == 0, 1, -1)


def _light(way: Array, light: Array) -> float:
    """Whether the first square of a way to number corners is light: +1, or dark: -1.

    `light` holds for the square towards the next column and row of the order found; turned by a right angle, as for one
    of two mirrored axes, that is the square beside it, of the other colour.
    """
    i, right, down = int(way[0, 0]), int(way[0, 1]), int(way[1, 0])
    return float(light[i]) * (1 if (right > i) == (down > i) else -1)


def _heading(v: Array) -> float:
    return v[0] / max(float(np.hypot(*v)), 1e-9)


def find_boards(image: Array, size: tuple[int, int]) -> list[Array]:
    """Approximate corners (rows, columns, 2), pixel frame, of whole boards, at most two; image (h, w) uint8."""
    scale = 1
    small = image
    while max(small.shape) > SIDE:
        scale *= 2
        small = cv2.resize(small[: small.shape[0] // 2 * 2, : small.shape[1] // 2 * 2], None, fx=0.5, fy=0.5,
                           interpolation=cv2.INTER_AREA)  # fmt: skip
    flags = cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE | cv2.CALIB_CB_FAST_CHECK
    seen, found = cv2.findChessboardCorners(small, size, flags=flags)
    if not seen:
        seen, found = cv2.findChessboardCornersSB(small, size, flags=cv2.CALIB_CB_NORMALIZE_IMAGE)
    if not seen:
        return []
    # OpenCV's frame begins at the centre of the first pixel, ours at its outer corner
    boards = [found.reshape(size[1], size[0], 2).astype(float) + 0.5]
    another = _another(small, boards[0], flags)
    if another is not None:
        boards.append(another)
    return [b * scale for b in boards]


def _another(image: Array, xy: Array, flags: int) -> Array | None:
    """Corners of a second board of about the same size, with the first one (rows, columns, 2) painted over."""
    steps = (xy[0] - xy[1], xy[-1] - xy[-2], xy[:, 0] - xy[:, 1], xy[:, -1] - xy[:, -2])
    rims = (xy[0], xy[-1], xy[:, 0], xy[:, -1])
    outer = np.concatenate([*rims, *(rim + BORDER * step for rim, step in zip(rims, steps, strict=True))])
    rest = image.copy()
    middle = int(np.median(image[::4, ::4]))
    cv2.fillConvexPoly(rest, np.round(cv2.convexHull(outer.astype(np.float32))).astype(np.int32), middle)
    scale = max(1.0, float(np.median([np.hypot(*step.T).mean() for step in steps])) / COARSE)
    size = (round(image.shape[1] / scale), round(image.shape[0] / scale))
    rest = cv2.resize(rest, size, interpolation=cv2.INTER_AREA)
    seen, found = cv2.findChessboardCorners(rest, xy.shape[1::-1], flags=flags)
    if not seen:
        return None
    ratio = np.array([image.shape[1] / size[0], image.shape[0] / size[1]])
    return (found.reshape(xy.shape).astype(float) + 0.5) * ratio


def measure_grid(image: Array, xy: Array, options: CornerOptions | None = None) -> Corners:
    """Fit corners (rows, columns, 2) with windows adapted to the distances between them."""
    v, u = (np.gradient(xy, axis=k) for k in (0, 1))
    return fit_corners(image, xy.reshape(-1, 2), u.reshape(-1, 2), v.reshape(-1, 2), options)


def beyond(image: Array, xy: Array) -> bool:
    """Whether the board goes on beyond the corners (rows, columns, 2) that were taken for all of them."""
    return any(seen for seen, _ in _next_rows(image, xy))


def grown(image: Array, xy: Array) -> Array:
    """Corners (rows, columns, 2) of a whole board, of which some were found; image (h, w) uint16."""
    while True:
        turn = next((k for k, (seen, _) in enumerate(_next_rows(image, xy)) if seen), None)
        if turn is None or max(xy.shape) > MOST:
            return xy
        turned = np.rot90(xy, turn)
        xy = np.rot90(np.concatenate([_next_rows(image, xy)[turn][1][None], turned]), -turn)


def _next_rows(image: Array, xy: Array) -> list[tuple[bool, Array]]:
    """Whether there is one more row beyond each side, and its corners (n, 2): of the board turned k times.

    A quick look: small windows, few iterations.
    """
    turned = [np.rot90(xy, k) for k in range(4)]
    place = [3 * t[0] - 3 * t[1] + t[2] for t in turned]
    along, across = [np.gradient(p, axis=0) for p in place], [t[0] - t[1] for t in turned]
    quick = CornerOptions(moved=0.6, most_px=5.0, iterations=6)
    seen = fit_corners(image, np.concatenate(place), np.concatenate(along), np.concatenate(across), quick)
    ends = np.cumsum([len(p) for p in place])[:-1]
    at = np.where(seen.measured[:, None], seen.xy_px, np.concatenate(place))
    return [
        (bool(good.mean() >= LARGER), corners)
        for good, corners in zip(np.split(seen.measured, ends), np.split(at, ends), strict=True)
    ]


def _make(name: str) -> Target | None:
    if not name.startswith("chessboard"):
        return None
    match = NAME.fullmatch(name)
    if match is None:
        raise InputError("board.chessboard_name", name=str(name))
    columns, rows = (whole_of(match[k]) or 0 for k in (1, 2))
    if min(columns, rows) < FEWEST or max(columns, rows) > MOST:
        raise InputError("board.chessboard_size", name=str(name))
    return Chessboard(columns=columns, rows=rows)


register(
    "chessboard",
    Kind(
        form="chessboard-COLUMNSxROWS (inner corners)",
        make=_make,
        names=lambda text: with_numbers(text, "chessboard-{}x{}"),
    ),
)
