"""What all that measures depths asks of the rays of a reference image, whatever took it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import ClassVar, Self

import numpy as np

from raybundle.block import Block, Camera
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array

BEYOND = 0.25
"""By how much depths may lie beyond those of tie points, as a share of their range"""


@dataclass(frozen=True, slots=True, kw_only=True)
class ReferenceRays(ABC):
    """Object points along the rays of a reference image, by a depth parameter t.

    t is positive and grows towards the sensor, and a plane of the object is linear in t and the pixels of a picture
    without distortion: inverse depths along a central ray, heights along a ray of a scene.
    """

    kinds: ClassVar[list[type[ReferenceRays]]] = []

    camera: Camera

    def __init_subclass__(cls) -> None:
        """Register the kind."""
        # a data class with slots is made twice: the second stands for the first
        ReferenceRays.kinds[:] = [*(k for k in ReferenceRays.kinds if k.__qualname__ != cls.__qualname__), cls]

    @staticmethod
    def of(block: Block, image: int) -> ReferenceRays:
        """Those of an oriented image.  Raises InputError for an image without orientation."""
        camera = block.camera_of(image)
        if not block.images.oriented[image]:
            raise InputError("image.not_oriented", image=block.images.ids[image])
        kind = next(k for k in ReferenceRays.kinds if k.takes(camera))
        return kind.made(camera, block.images.rotation[image], block.images.centre[image])

    @classmethod
    @abstractmethod
    def takes(cls, camera: Camera) -> bool:
        """Whether rays of this kind are those of a camera."""

    @classmethod
    @abstractmethod
    def made(cls, camera: Camera, rotation: Array, centre: Array) -> ReferenceRays:
        """The rays of a camera that stands so."""

    @abstractmethod
    def moved(self, camera: Camera, rotation: Array, centre: Array) -> Self:
        """The same rays, the same meaning of t, with another orientation and calibration."""

    @abstractmethod
    def rays(self, xy_px: Array) -> tuple[Array, Array]:
        """Origins and directions (n, 3) in object space: a point is origin + s direction, s as `along` gives it.

        Exact where rays are straight; where they are not, as those of scenes, good for directions and derivatives.
        """

    @abstractmethod
    def along(self, t: Array) -> tuple[Array, Array]:
        """The factor s (n,) of directions at depth parameters (n,), and its derivative by them."""

    @abstractmethod
    def points(self, xy_px: Array, t: Array) -> Array:
        """Object points (n, 3) at depth parameters (n,)."""

    def steps(self, xy_px: Array, t: Array, more: Array) -> tuple[Array, Array]:
        """Object points (n, 3), and how they move where t is larger by so much (n,)."""
        xyz = self.points(xy_px, t)
        return xyz, self.points(xy_px, t + more) - xyz

    def levels(self, xy_px: Array, t: Array) -> Iterator[Array]:
        """Object points (n, 3) of all pixels at one depth parameter after the other (k,)."""
        for one in t.tolist():
            yield self.points(xy_px, np.full(len(xy_px), one))

    @abstractmethod
    def by_t(self, xy_px: Array, t: Array) -> Array:
        """Derivatives (n, 3) of the object points by the depth parameters (n,)."""

    @abstractmethod
    def parameter(self, xy_px: Array, xyz: Array) -> Array:
        """Depth parameters (n,) of object points (n, 3) that stand on the rays of (n, 2)."""

    @abstractmethod
    def directions(self, xy_px: Array) -> Array:
        """Directions (n, 3) of the rays in object space, away from the sensor, of any length."""

    @abstractmethod
    def viewer(self, coordinates: Callable[[Array], Array]) -> Array:
        """The place (3,) that the image looks from, in coordinates (n, 3) that a function gives of object points."""

    @abstractmethod
    def lengths(self, t: Array, sigma: Array) -> Array:
        """Standard deviations (n,) of depth parameters as those of depths: the same for all references of a kind."""

    @abstractmethod
    def parameters(self, t: Array, length: Array) -> Array:
        """The inverse of `lengths`."""

    @abstractmethod
    def widened(self, low: float, high: float) -> tuple[float, float]:
        """A range of depth parameters with some room at either end for what tie points do not show."""

    @property
    @abstractmethod
    def reported(self) -> str:
        """What `depths` are, in words."""

    @abstractmethod
    def depths(self, t: Array) -> Array:
        """Depths as people read them."""
