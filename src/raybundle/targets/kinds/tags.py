"""Square tags: apriltag-36h11, aruco-4x4_50; found and read by OpenCV, measured along their sides.

Corner 1 is the upper left one as the dictionary draws the tag, the others follow clockwise.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.numerics.arrays import Array
from raybundle.targets.border import fit_squares
from raybundle.targets.detect import eight_bits
from raybundle.targets.marks import Kind, MarkOptions, Marks, Target, nearest, no_ellipses, nothing, register
from raybundle.targets.tag_fit import fit_tags
from raybundle.targets.tag_reading import bits_of, read_modules

SMALL_PX = 25.0
"""Side of a tag below which its sides are too short to be measured one by one: a module is 3 px or less."""
LEAST_SIDE_PX = 6.0
"""Of a tag that can be read at all: its modules would be smaller than a pixel."""


@functools.cache
def dictionaries() -> dict[str, int]:
    """OpenCV's dictionaries by the names in use here: apriltag-36h11, aruco-5x5_100, aruco-mip_36h12."""
    found: dict[str, int] = {}
    for name in dir(cv2.aruco):
        if name.startswith("DICT_"):
            short = name[5:].lower()
            short = short.replace("apriltag_", "apriltag-") if short.startswith("apriltag") else short
            short = short.removeprefix("aruco_") if short.startswith("aruco_") else short
            found[short if short.startswith("apriltag") else f"aruco-{short}"] = int(getattr(cv2.aruco, name))
    return found


def dictionary(name: str) -> Any:
    """A dictionary of tags; raises InputError."""
    known = dictionaries()
    if name not in known:
        near = nearest(name, [*known])
        raise InputError("target.unknown_tags", name=str(name), near=near, n=len(near), known=sorted(known))
    return cv2.aruco.getPredefinedDictionary(known[name])


@dataclass(frozen=True, slots=True, kw_only=True)
class Tags:
    """Single tags of a dictionary."""

    name: str

    @property
    def family(self) -> str:
        """apriltag-36h11."""
        return self.name

    @property
    def title(self) -> str:
        """For people."""
        return f"square tags {self.name}"

    @property
    def objects(self) -> Mapping[str, Array]:
        """Unknown: single targets."""
        return {}

    @property
    def turns(self) -> int:
        """Every corner has its name."""
        return 1

    @property
    def radius(self) -> float:
        """Corners have none."""
        return np.nan

    def find(self, image: Array, options: MarkOptions) -> Marks:
        """Corners of all tags, by their sides or, of small ones, by the whole tag; those of repeated ones unnamed."""
        del options
        tags = dictionary(self.name)
        ids, corners = seen_tags(eight_bits(image)[0], tags)
        if not len(ids):
            return nothing(self.family)
        numbers, count = np.unique(ids, return_counts=True)
        twice = numbers[count > 1]
        squares = fit_squares(image, corners, 1 / (tags.markerSize + 2))
        xy, C = squares.xy_px, squares.covariance
        residual, good = squares.residual, squares.measured
        small = sides(corners).min(axis=1) < SMALL_PX
        whole = np.flatnonzero(small | ~good.all(axis=1))
        if len(whole):
            drawn = np.stack([bits_of(tags, int(i)) for i in ids[whole]])
            fitted = fit_tags(image, corners[whole], drawn)
            # a tag that was drawn as a whole is measured so; a large one keeps the corners that its sides gave
            take = fitted.measured & (small[whole] | ~good[whole].any(axis=1))
            rows = whole[take]
            xy[rows], C[rows] = fitted.xy_px[take], fitted.covariance[take]
            residual[rows], good[rows] = fitted.residual[take, None], True
            good[whole[small[whole] & ~fitted.measured]] = False
        named = ~np.isin(ids, twice)
        return Marks(
            family=self.family,
            name=tuple(f"{ids[i]}/{k + 1}" if named[i] else "" for i, k in zip(*np.nonzero(good), strict=True)),
            xy_px=xy[good],
            covariance=C[good],
            ellipse=no_ellipses(int(good.sum())),
            gate=residual[good],
            remarks=tuple(
                phrase("target_seen.tag_in_places", tag=str(i), n=n)
                for i, n in zip(twice.tolist(), count[count > 1].tolist(), strict=True)
            ),
        )


def sides(corners: Array) -> Array:
    """(n, 4) lengths of the sides of squares (n, 4, 2) [px]."""
    return np.hypot(*(np.roll(corners, -1, axis=1) - corners).transpose(2, 0, 1))


def seen_tags(image: Array, tags: Any) -> tuple[Array, Array]:
    """Numbers (n,) and approximate corners (n, 4, 2), pixel frame, of all tags in an image (h, w) uint8.

    OpenCV takes the smallest tag as a share of the image (3 % of its longer side for the four sides together, 45 px a
    side in 24 megapixels); here it is what can be read, whatever the image.  Small ones that it finds and cannot read
    are read by their modules, so that its version does not matter.
    """
    parameters = cv2.aruco.DetectorParameters()
    share = 4 * LEAST_SIDE_PX / max(image.shape)
    parameters.minMarkerPerimeterRate = min(parameters.minMarkerPerimeterRate, share)
    seen: Any = cv2.aruco.ArucoDetector(tags, parameters).detectMarkers(image)
    ids = np.zeros(0, int) if seen[1] is None else np.asarray(seen[1], int).reshape(-1)
    corners = np.array(seen[0], float).reshape(-1, 4, 2) + 0.5
    left = np.array(seen[2], float).reshape(-1, 4, 2) + 0.5
    size = sides(left)
    left = left[(size.min(axis=1) >= LEAST_SIDE_PX) & (size.max(axis=1) < SMALL_PX) & _apart(left, corners)]
    number, turned = read_modules(image, left, tags)
    number, turned = number[number >= 0], turned[number >= 0]
    # the inner and the outer edge of a rim are two quadrangles: the larger one counts
    order = np.argsort(-sides(turned).min(axis=1), kind="stable")
    kept: list[int] = []
    for k in order:
        if _apart(turned[[k]], turned[kept])[0]:
            kept.append(int(k))
    return np.concatenate([ids, number[kept]]), np.concatenate([corners, turned[kept]])


def _apart(some: Array, others: Array) -> Array:
    """(n,) whether the middles of squares (n, 4, 2) lie farther than half a side from those of others (k, 4, 2)."""
    gap = some.mean(axis=1)[:, None] - others.mean(axis=1)[None]
    return (np.hypot(*gap.transpose(2, 0, 1)) > sides(some).max(axis=1)[:, None] / 2).all(axis=1)


def _make(name: str) -> Target | None:
    if not name.startswith(("apriltag", "aruco")):
        return None
    dictionary(name)
    return Tags(name=name)


register(
    "tags",
    Kind(form="apriltag-36h11 and others, aruco-4x4_50 and others", make=_make, names=lambda _: [*dictionaries()]),
)
