"""Feature methods: points of an image with a description by which they are found again.

A method is a class with a `name`, `detect` and `vectors`, in a module of this folder that is called like it; `register`
makes it known.  A learned one names the packages that it needs, and may match two images in its own way.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np

from raybundle.matching.descriptors import mutual_matches
from raybundle.numerics.arrays import Array, Index

PIXELS_EACH = 400
"""Pixels of a photograph for each feature: a third to a half of them is measured, by windows of 11 to 17 px."""
ENOUGH, CLOSEST = 4000, 100
"""Features below which photographs have closer ones, down to these pixels for each: windows then begin to overlap.

Photographs that see the same from afar share a tenth of their features or less, however small they are, and a pair is
believed from 15 to 40 of them."""
LEAST = 500
"""Features of the smallest pictures."""
BYTES_A_PIXEL = 12.0
"""That a photograph takes while it is read and reduced."""
CLEAR = 0.7
"""Ratio of Lowe (2004) of matches that hardly err, by which images are compared before they are matched."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Features:
    """Features of one image, strongest first."""

    xy_px: Array
    """(n, 2) pixel frame"""
    scale_px: Array
    """(n,) radius of the described surroundings is proportional to it"""
    angle: Array
    """(n,) direction of the surroundings [rad], clockwise in the pixel frame"""
    descriptors: Array
    """(n, k) uint8"""

    def __len__(self) -> int:
        return len(self.xy_px)

    def rows(self, index: Index) -> Features:
        """A selection."""
        return Features(
            xy_px=self.xy_px[index],
            scale_px=self.scale_px[index],
            angle=self.angle[index],
            descriptors=self.descriptors[index],
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Described:
    """The features of one image as they are matched."""

    xy_px: Array
    """(n, 2) pixel frame of the upright picture"""
    descriptors: Array
    """(n, k) uint8, as stored"""
    size_px: tuple[int, int]
    """width and height of the upright picture"""
    scale_px: Array = field(default_factory=lambda: np.zeros(0))
    """(n,) as of the features, by which a first look chooses"""


def feature_number(width_px: int, height_px: int, most: int) -> int:
    """Features of a photograph: so many that the windows of those that are measured hardly overlap.

    Measurements from the same pixels are not independent, and their number would promise too much precision.
    """
    area = width_px * height_px
    return min(most, max(area // PIXELS_EACH, min(ENOUGH, area // CLOSEST), LEAST))


class FeatureMethod(ABC):
    """How features are found, described and matched."""

    name: str
    version: int = 1
    """Raised with every change of the result; part of the key under which features are kept."""
    upright: bool = False
    """Whether what is found changes when the picture is turned; photographs are then searched the right way up."""
    needs: ClassVar[tuple[str, ...]] = ()
    """Packages beyond those that raybundle brings."""
    install: ClassVar[str] = ""
    """The command that installs them."""
    looks: bool = False
    """Whether `likely_matches` is another than `match`."""
    codebook: str = ""
    """Of the words for signatures that come with the package; empty: they are learnt from each set of photographs."""

    @property
    def content(self) -> tuple[object, ...]:
        """What a method is known by."""
        return self.name, self.version

    @abstractmethod
    def detect(self, grey: Array, count: int) -> Features:
        """At most `count` features of a grey image (h, w), uint8, spread over the format."""

    @abstractmethod
    def vectors(self, descriptors: Array) -> Array:
        """Unit vectors (n, k) float32 whose inner product measures likeness, of stored descriptors."""

    def mirrored(self, descriptors: Array) -> Array | None:
        """The stored descriptors of the same features of the mirrored picture; None: only by detecting them anew."""
        del descriptors
        return None

    def bytes_needed(self, pixels: float) -> float:
        """Memory that finding the features of a photograph of so many pixels takes, by which tasks wait for each other.

        Of methods that search a reduced photograph; others know better.
        """
        return BYTES_A_PIXEL * pixels

    def match(self, first: Described, second: Described) -> Index:
        """Candidate matches (k, 2) of two images; unless a method knows better, mutual nearest neighbours."""
        return mutual_matches(self.vectors(first.descriptors), self.vectors(second.descriptors))[0]

    def likely_matches(self, first: Described, second: Described) -> Index:
        """The same, but none where a first look finds no more than chance gives; unless a method knows one, `match`."""
        return self.match(first, second)

    def shared(self, first: Array, second: Array) -> int:
        """Descriptors, as stored, of two images that are alike without doubt: a rough and quick comparison."""
        return len(mutual_matches(self.vectors(first), self.vectors(second), CLEAR)[0])


methods: dict[str, FeatureMethod] = {}


def register(method: FeatureMethod) -> FeatureMethod:
    """Make a method known under its name."""
    methods[method.name] = method
    return method


def spread(xy_px: Array, strength: Array, count: int, width: int, height: int) -> Index:
    """Positions of at most `count` features, strong ones first in every cell of a grid over the format.

    The cells take turns: the strongest of each, then the second of each, until `count` are taken, so that
    weakly textured parts of the image keep theirs.  Sorted by strength.
    """
    order = np.argsort(-strength, kind="stable")
    if len(order) <= count:
        return order
    cell_px = np.sqrt(width * height / max(count / 24, 1))
    columns = int(np.ceil(width / cell_px))
    cell = (xy_px[order, 1] // cell_px).astype(np.int64) * columns + (xy_px[order, 0] // cell_px).astype(np.int64)
    by_cell = np.argsort(cell, kind="stable")
    first = np.searchsorted(cell[by_cell], cell[by_cell], side="left")
    turn = np.empty(len(order), np.int64)
    turn[by_cell] = np.arange(len(order)) - first
    taken = np.argsort(turn, kind="stable")[:count]
    return order[np.sort(taken)]
