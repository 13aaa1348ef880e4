"""ChArUco boards: charuco-8x6-5x5_100 has 8 x 6 squares with tags of aruco-5x5_100 in the light ones.

A board may be seen in part, since tags show which corners it shows.  Tags take 0.75 of a square unless a fourth part
states otherwise: charuco-8x6-5x5_100-0.8.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.reading.words import number_of, whole_of
from raybundle.numerics.arrays import Array
from raybundle.targets.detect import eight_bits
from raybundle.targets.kinds.tags import dictionaries, dictionary
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
)
from raybundle.targets.saddle import CornerOptions, fit_corners

NAME = re.compile(r"charuco-(\d+)x(\d+)-([a-z0-9_]+?)(?:-(0\.\d+))?")
LEAST = 6
"""Corners below which a board is not used."""
TWICE = 2
"""Tags seen in two places that say that there are two boards."""
RATIO = 0.75


@dataclass(frozen=True, slots=True, kw_only=True)
class Charuco:
    """A board of so many squares."""

    columns: int
    rows: int
    tags: str
    ratio: float = RATIO
    """side of a tag in units of a square's"""

    @property
    def family(self) -> str:
        """charuco-8x6-5x5_100."""
        tail = "" if self.ratio == RATIO else f"-{self.ratio:g}"
        return f"charuco-{self.columns}x{self.rows}-{self.tags}{tail}"

    @property
    def title(self) -> str:
        """For people."""
        return f"ChArUco board of {self.columns} x {self.rows} squares with tags {self.tags}"

    @property
    def objects(self) -> Mapping[str, Array]:
        """Corners between squares in units of a square; r0c0 is the upper left one."""
        return grid_objects(self.columns - 1, self.rows - 1)

    @property
    def turns(self) -> int:
        """Tags show all."""
        return 1

    @property
    def radius(self) -> float:
        """Corners have none."""
        return np.nan

    def find(self, image: Array, options: MarkOptions) -> Marks:
        """Corners between the tags seen."""
        del options
        eight = eight_bits(image)[0]
        found = [_corners(eight, self.board(old=old)) for old in (False, True)]
        if max(f[2] for f in found) >= TWICE:
            return nothing(self.family, two_seen(self.family))
        corners, ids, _ = max(found, key=lambda c: len(c[1]))
        if len(ids) < LEAST:
            return nothing(
                self.family, phrase("target_seen.corners_missing", target=self.family, n=len(ids), least=LEAST)
            )
        columns = self.columns - 1
        place = np.stack([ids % columns, ids // columns], axis=1).astype(float)
        u, v = _arms(place, corners)
        blank = (1 - self.ratio) / 2
        first = fit_corners(image, corners, u, v, CornerOptions(band=blank))
        if not first.measured.any():
            return nothing(self.family, phrase("target_seen.corners_blurred", target=self.family, n=len(ids)))
        # tags are blurred towards the edges
        clear = 2.4 * float(np.median(first.blur_px[first.measured]))
        c = fit_corners(image, corners, u, v, CornerOptions(band=blank, clear_px=clear))
        good = np.flatnonzero(c.measured)
        return Marks(
            family=self.family, name=tuple(f"r{ids[i] // columns}c{ids[i] % columns}" for i in good),
            xy_px=c.xy_px[good], covariance=c.covariance[good], ellipse=no_ellipses(len(good)),
            gate=c.residual[good],
        )  # fmt: skip

    @property
    def dictionary(self) -> str:
        """Name of the tags as a family of their own: aruco-5x5_100."""
        return _dictionary(self.tags)

    def board(self, *, old: bool) -> Any:
        """OpenCV's board; `old` as drawn before OpenCV 4.6, with the other colour first where rows are even."""
        board = cv2.aruco.CharucoBoard((self.columns, self.rows), 1.0, self.ratio, dictionary(self.dictionary))
        board.setLegacyPattern(old)
        return board


def _corners(image: Array, board: Any) -> tuple[Array, Array, int]:
    """Approximate corners (n, 2), pixel frame, their numbers (n,), and how many tags were seen in two places."""
    found: Any = cv2.aruco.CharucoDetector(board).detectBoard(image)
    corners, ids, _, tags = found
    twice = 0 if tags is None else len(tags) - len(np.unique(tags))
    if ids is None or not len(ids):
        return np.zeros((0, 2)), np.zeros(0, int), twice
    return corners.reshape(-1, 2).astype(float) + 0.5, ids.reshape(-1).astype(int), twice


def _arms(place: Array, xy: Array) -> tuple[Array, Array]:
    """Vectors (n, 2) in the image to the next column and the next row, from a projective map of all corners."""
    H: Any = cv2.findHomography(place, xy)[0]
    if H is None:  # all in one line
        return np.zeros_like(xy), np.zeros_like(xy)
    p = np.column_stack([place, np.ones(len(place))]) @ H.T
    J = (H[None, :2, :2] - (p[:, :2] / p[:, 2:])[:, :, None] * H[None, 2:, :2]) / p[:, 2, None, None]
    return J[:, :, 0], J[:, :, 1]


def _dictionary(tags: str) -> str:
    return tags.replace("apriltag_", "apriltag-") if tags.startswith("apriltag") else f"aruco-{tags}"


def _make(name: str) -> Target | None:
    if not name.startswith("charuco"):
        return None
    match = NAME.fullmatch(name)
    if match is None:
        raise InputError("board.charuco_name", name=str(name))
    columns, rows = (whole_of(match[k]) or 0 for k in (1, 2))
    ratio = RATIO if match[4] is None else number_of(match[4]) or 0.0
    if min(columns, rows) < 3 or not 0.3 <= ratio <= 0.95:
        raise InputError("board.charuco_size", name=str(name))
    capacity = len(dictionary(_dictionary(match[3])).bytesList)
    if columns * rows // 2 > capacity:
        raise InputError("board.charuco_tags", name=str(name), n=columns * rows // 2, tags=match[3], most=capacity)
    return Charuco(columns=columns, rows=rows, tags=match[3], ratio=ratio)


def _names(text: str) -> list[str]:
    numbers = re.findall(r"\d+", text)[:2]
    tags = [n.removeprefix("aruco-").replace("apriltag-", "apriltag_") for n in dictionaries()]
    return [f"charuco-{numbers[0]}x{numbers[1]}-{t}" for t in tags] if len(numbers) == 2 else []


register("charuco", Kind(form="charuco-COLUMNSxROWS-TAGS (squares; as charuco-8x6-5x5_100)", make=_make, names=_names))
