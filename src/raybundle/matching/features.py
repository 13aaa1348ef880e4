"""Feature methods: points of an image with a description by which they are found again.

A method is a class with a `name` and `detect`; `register` makes it known, `feature_methods` lists all.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from importlib import import_module
from typing import ClassVar

import numpy as np

from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index

BUILT_IN = ("rootsift",)


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


class FeatureMethod(ABC):
    """How features are found and described."""

    name: ClassVar[str]
    version: ClassVar[int] = 1
    """Raised with every change of the result; part of the key under which features are kept."""

    @abstractmethod
    def detect(self, grey: Array, count: int) -> Features:
        """At most `count` features of a grey image (h, w), uint8, spread over the format."""

    @abstractmethod
    def vectors(self, descriptors: Array) -> Array:
        """Unit vectors (n, k) float32 whose inner product measures likeness, of stored descriptors."""


_methods: dict[str, FeatureMethod] = {}


def register(method: FeatureMethod) -> FeatureMethod:
    """Make a method known under its name."""
    _methods[method.name] = method
    return method


def feature_method(name: str) -> FeatureMethod:
    """The method of this name.

    raises  InputError that lists the known ones
    """
    if name not in _methods and name in BUILT_IN:
        import_module(f"raybundle.matching.{name}")
    if name not in _methods:
        known = ", ".join(sorted({*_methods, *BUILT_IN}))
        raise InputError(f"unknown feature method {name!r}; known: {known}")
    return _methods[name]


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
