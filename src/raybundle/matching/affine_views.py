"""Features of affine views (Morel and Yu 2009), for wide baselines."""

from __future__ import annotations

import cv2
import numpy as np

from raybundle.matching.descriptors import nearest_matches
from raybundle.matching.features import CLEAR, Described, FeatureMethod, Features, feature_number
from raybundle.matching.reduced import LONGEST_PX
from raybundle.matching.rootsift import RootSift
from raybundle.numerics.arrays import Array, Index

TILTS = (np.sqrt(2.0), 2.0, 2.0 * np.sqrt(2.0))
"""Compression of an affine view in one direction."""
TURN_DEG = 72.0
"""Step of that direction, divided by the tilt (Morel and Yu 2009, section 5)."""
VIEWS = (
    (1.0, 0.0),
    *((t, k * np.radians(TURN_DEG / t)) for t in TILTS for k in range(round(180 * t / TURN_DEG))),
)
"""Tilt and direction [rad] of each view, the copy itself first."""
CHOSEN = 8
"""Pairs of views from which the matches of two photographs are taken: those with the most clear ones.  Views of like
tilt show the same, and matches of all the others are wrong."""
RATIO = 0.75
"""Of distances to the nearest and the second: lower than among few, since wrong matches of all chosen pairs add up."""
CELL_PX = 4.0
"""Places of a photograph closer than this are one: a point shows in several views, and counts once."""
BORDER = 3.0
"""Distance of a feature from the border of the copy, in its scales: beyond the border a view shows nothing."""


class AffineViews(FeatureMethod):
    """RootSIFT of views of a reduced copy, as if the camera had moved round the object.

    The last byte of a descriptor is the number of its view.
    """

    name = "affine_views"

    def __init__(self) -> None:
        self.method = RootSift()

    @property
    def content(self) -> tuple[object, ...]:
        """With that of the features."""
        return *super().content, *self.method.content

    def detect(self, grey: Array, count: int) -> Features:
        """Features of all views at their places in the photograph, at most `count` of each."""
        copy = _copy(grey)
        most = feature_number(copy[0].shape[1], copy[0].shape[0], count)
        found = [self._features(k, grey.shape, *_view(*copy, *v), int(most / v[0])) for k, v in enumerate(VIEWS)]
        return Features(
            xy_px=np.vstack([f.xy_px for f in found]), scale_px=np.concatenate([f.scale_px for f in found]),
            angle=np.concatenate([f.angle for f in found]), descriptors=np.vstack([f.descriptors for f in found]),
        )  # fmt: skip

    def _features(
        self, number: int, shape: tuple[int, ...], view: Array, linear: Array, shift: Array, count: int
    ) -> Features:
        back = np.linalg.inv(linear)
        f = self.method.detect(np.ascontiguousarray(view), count)
        xy = (f.xy_px - shift) @ back.T
        right = np.column_stack([np.cos(f.angle), np.sin(f.angle)]) @ back.T
        scale = f.scale_px * np.sqrt(abs(np.linalg.det(back)))
        inside = np.minimum(xy, np.array([shape[1], shape[0]]) - xy).min(axis=1) > BORDER * scale
        whole = Features(
            xy_px=xy, scale_px=scale, angle=np.arctan2(right[:, 1], right[:, 0]),
            descriptors=np.hstack([f.descriptors, np.full((len(xy), 1), number, np.uint8)]),
        )  # fmt: skip
        return whole.rows(np.flatnonzero(inside))

    def vectors(self, descriptors: Array) -> Array:
        """Those of RootSIFT."""
        return self.method.vectors(descriptors[:, :-1])

    def bytes_needed(self, pixels: float) -> float:
        """As of RootSIFT."""
        return self.method.bytes_needed(pixels)

    def match(self, first: Described, second: Described) -> Index:
        """Matches of the pairs of views with the most clear ones, each place of a photograph once.

        One view of each pair is the copy itself.  Which pairs are taken does not depend on where their features lie:
        chance gives matches that fit a geometry as often as in any other pair.
        """
        rows = [[np.flatnonzero(d.descriptors[:, -1] == k) for k in range(len(VIEWS))] for d in (first, second)]
        found: list[tuple[int, Index, Array]] = []
        for a, b in ((0, 0), *((k, 0) for k in range(1, len(VIEWS))), *((0, k) for k in range(1, len(VIEWS)))):
            own, other = rows[0][a], rows[1][b]
            m, distance, following = nearest_matches(first.descriptors[own, :-1], second.descriptors[other, :-1])
            ratio = distance / np.maximum(following, 1e-9)
            good = ratio < RATIO
            clear = int((ratio < CLEAR).sum())
            found.append((clear, np.column_stack([own[m[good, 0]], other[m[good, 1]]]), ratio[good]))
        found.sort(key=lambda f: -f[0])
        matches = np.vstack([f[1] for f in found[:CHOSEN]])
        order = np.argsort(np.concatenate([f[2] for f in found[:CHOSEN]]), kind="stable")
        for end, described in enumerate((first, second)):
            cell = np.floor(described.xy_px[matches[order, end]] / CELL_PX).astype(np.int64)
            _, once = np.unique(cell[:, 0] * 10_000_000 + cell[:, 1], return_index=True)
            order = order[np.sort(once)]
        return matches[order].astype(np.int32)


def _copy(grey: Array) -> tuple[Array, Array, Array]:
    """A copy of an image (h, w) no longer than `LONGEST_PX`, with its map."""
    h, w = grey.shape
    factor = max(1.0, max(h, w) / LONGEST_PX)
    size = max(1, round(w / factor)), max(1, round(h / factor))
    small = cv2.resize(grey, size, interpolation=cv2.INTER_AREA) if factor > 1 else grey
    return small, np.diag([size[0] / w, size[1] / h]), np.zeros(2)


def _view(picture: Array, linear: Array, shift: Array, tilt: float, direction: float) -> tuple[Array, Array, Array]:
    """A picture compressed by `tilt` in one direction, without aliasing, with its map."""
    if tilt == 1:
        return picture, linear, shift
    h, w = picture.shape
    c, s = np.cos(direction), np.sin(direction)
    turn = np.array([[c, s], [-s, c]])
    corners = np.array([[0, 0], [w, 0], [0, h], [w, h]]) @ turn.T
    low = corners.min(axis=0)
    width, height = (int(v) for v in np.ceil(corners.max(axis=0) - low))
    half = np.full(2, 0.5)  # pixel 0 of OpenCV has its centre at 0.5
    turned = cv2.warpAffine(
        picture, np.column_stack([turn, turn @ half - low - half]), (width, height), flags=cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )  # fmt: skip
    turned = cv2.GaussianBlur(turned, (0, 0), sigmaX=0.8 * np.sqrt(tilt**2 - 1), sigmaY=0.01)
    narrow = max(int(width / tilt), 1)
    view = cv2.resize(turned, (narrow, height), interpolation=cv2.INTER_LINEAR)
    squeeze = np.diag([narrow / width, 1.0])
    return view, squeeze @ turn @ linear, squeeze @ (turn @ shift - low)
