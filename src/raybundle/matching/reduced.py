"""Features of photographs that show nothing at the size of their pixels: soft, noisy or heavily compressed ones."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.matching.features import Described, FeatureMethod, Features, feature_number
from raybundle.numerics.arrays import Array, Index

LONGEST_PX = 1600
"""Longer side of the copies: three quarters of a megapixel and more, as photographs had before 2002, are enough."""
SUFFIX = f", at most {LONGEST_PX} px"
"""Of the names of such methods."""
WORTH = 2.0
"""Reduction from which on another try is worth the time: the method itself begins at half the size."""


class Reduced(FeatureMethod):
    """Another method on copies that are reduced by area; places and sizes are those of the photographs."""

    def __init__(self, method: FeatureMethod) -> None:
        self.method = method
        self.name = method.name + SUFFIX
        self.upright = method.upright
        self.codebook = method.codebook

    @property
    def content(self) -> tuple[object, ...]:
        """That of the method, under the name of the reduced one."""
        return self.name, *self.method.content[1:]

    def detect(self, grey: Array, count: int) -> Features:
        """At most `count` features, as many as a photograph of that size has."""
        import cv2

        h, w = grey.shape
        factor = reduction(w, h)
        if factor <= 1:
            return self.method.detect(grey, count)
        size = max(1, round(w / factor)), max(1, round(h / factor))
        small = np.ascontiguousarray(cv2.resize(grey, size, interpolation=cv2.INTER_AREA))
        found = self.method.detect(small, feature_number(*size, count))
        back = np.array([w / size[0], h / size[1]])
        return replace(found, xy_px=found.xy_px * back, scale_px=found.scale_px * float(back.mean()))

    def vectors(self, descriptors: Array) -> Array:
        """Those of the method."""
        return self.method.vectors(descriptors)

    def mirrored(self, descriptors: Array) -> Array | None:
        """As the method has them."""
        return self.method.mirrored(descriptors)

    def match(self, first: Described, second: Described) -> Index:
        """As the method matches."""
        return self.method.match(first, second)

    def shared(self, first: Array, second: Array) -> int:
        """As the method compares."""
        return self.method.shared(first, second)


def reduction(width_px: int, height_px: int) -> float:
    """By what a photograph is reduced; 1 and less: not at all."""
    return max(width_px, height_px) / LONGEST_PX
