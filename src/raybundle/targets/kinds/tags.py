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

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array
from raybundle.targets.border import fit_squares
from raybundle.targets.detect import eight_bits
from raybundle.targets.marks import Kind, MarkOptions, Marks, Target, no_ellipses, nothing, register


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
        raise InputError(f"unknown tags {name!r}; known: {', '.join(sorted(known))}")
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
        """Corners of all tags whose four sides can be measured; a tag seen twice is left out, and that is remarked."""
        del options
        tags = dictionary(self.name)
        detector = cv2.aruco.ArucoDetector(tags, cv2.aruco.DetectorParameters())
        seen: Any = detector.detectMarkers(eight_bits(image)[0])
        found, ids = seen[:2]
        if ids is None or not len(ids):
            return nothing(self.family)
        ids = ids.reshape(-1)
        numbers, count = np.unique(ids, return_counts=True)
        twice = numbers[count > 1]
        once = ~np.isin(ids, twice)
        corners = np.array(found, float).reshape(-1, 4, 2)[once] + 0.5
        squares = fit_squares(image, corners, 1 / (tags.markerSize + 2))
        good = squares.measured
        return Marks(
            family=self.family,
            name=tuple(f"{ids[once][i]}/{k + 1}" for i, k in zip(*np.nonzero(good), strict=True)),
            xy_px=squares.xy_px[good],
            covariance=squares.covariance[good],
            ellipse=no_ellipses(int(good.sum())),
            gate=squares.residual[good],
            remarks=tuple(f"tag {i} seen in two places" for i in twice),
        )


def _make(name: str) -> Target | None:
    if not name.startswith(("apriltag", "aruco")):
        return None
    dictionary(name)
    return Tags(name=name)


register("tags", Kind(form="apriltag-36h11 and others, aruco-4x4_50 and others", make=_make))
