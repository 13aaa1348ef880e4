"""The contract of a platform: what carries a sensor, and where a point then lies in the sensor's own frame.

A platform takes the point in the frame that an exterior orientation gives to the axes of the sensor at the moment when
the image point was taken.  A sensor knows nothing of it; both together are a model (`raybundle.platforms.carried`).
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from importlib import import_module
from typing import ClassVar

import numpy as np

from raybundle.errors import Message
from raybundle.numerics.arrays import Array
from raybundle.numerics.maths import Scalar
from raybundle.numerics.motion import Point
from raybundle.sensors.model import Parameter, SensorModel


class Platform:
    """What carries a sensor, stated as one function: `point`.  Jacobians and native code are derived from it."""

    registry: ClassVar[dict[str, Platform]] = {}
    followers: ClassVar[list[Callable[[Platform], None]]] = []
    """Called with each platform that is registered later"""

    name: ClassVar[str]
    """Model names are SENSOR_NAME"""
    parameters: tuple[Parameter, ...]
    point: ClassVar[Callable[..., Point]]
    """(x, y, X, Y, Z, *parameters): the point (X, Y, Z) in the axes of the sensor that measured it at x, y [mm]"""
    uses_image: ClassVar[bool]
    """Whether that depends on x and y"""
    moves: ClassVar[bool] = False
    """Whether it moves while an image is taken, line by line; a model has one motion at most"""
    looks_elsewhere: ClassVar[bool]
    """Whether the sensor may look another way than the frame of the exterior orientation does"""
    order: ClassVar[int]
    """From the sensor outwards: a platform carries what platforms of lower order carry"""

    def __init_subclass__(cls) -> None:
        """Check the statement against itself and register the platform."""
        stated = tuple(inspect.signature(cls.point).parameters)[5:]
        declared = tuple(p.symbol for p in cls.parameters)
        if stated != declared:
            raise TypeError(f"{cls.__name__}.point takes {stated}, parameters states {declared}")
        made = cls()
        Platform.registry[cls.name] = made
        for follow in Platform.followers:
            follow(made)

    @cached_property
    def symbols(self) -> tuple[str, ...]:
        """Symbols of the parameters in their order."""
        return tuple(p.symbol for p in self.parameters)

    def carries(self, sensor: SensorModel) -> bool:
        """Whether a sensor may stand on it: a frame; on one that moves, a frame with rows that are read in turn."""
        return sensor.frame and (sensor.one_exposure or not self.moves)

    def parameters_with(self, sensor: SensorModel) -> tuple[Parameter, ...]:
        """The parameters where it carries this sensor, which may need other defaults."""
        del sensor
        return self.parameters

    def objection(self, sensor: SensorModel, values: Mapping[str, float], free: Sequence[str]) -> Message | None:
        """Why observations by a sensor do not determine these values, and what to do; None for nothing."""
        del sensor, values, free
        return None

    @cached_property
    def point_and_jacobian(self) -> Callable[..., tuple[Array, Array]]:
        """The point (3, n) and its Jacobian (3, 5 + m, n) by x, y, X, Y, Z and the parameters."""
        if type(self).__module__.startswith("raybundle.platforms."):
            try:
                return import_module(f"raybundle.platforms.generated.{self.name}").point_and_jacobian
            except ModuleNotFoundError:
                pass
        from raybundle.numerics.derive import derive_point

        return derive_point(type(self).point, self.symbols)

    def place(self, image: Array, points: Array, values: Array) -> Array:
        """Points (3, n) in the axes of the sensor, measured at `image` (2, n) [mm]; values (m,) or (m, n)."""
        found: Sequence[Scalar] = type(self).point(*image, *points, *values)
        return np.stack(np.broadcast_arrays(*found))

    def placed_back(self, image: Array, points: Array, values: Array) -> Array:
        """Points (3, n) in the frame of the exterior orientation that lie at `points` (3, n) for the sensor.

        The inverse of `place`, which is a motion of the point: R (point - P), of R and P whatever the image point.
        """
        origin = self.place(image, np.zeros_like(points), values)
        by_axis = [self.place(image, np.zeros_like(points) + e[:, None], values) - origin for e in np.eye(3)]
        return np.einsum("ein,in->en", np.stack(by_axis), points - origin)

    def line_passing(self, points: Array, values: Array) -> Array:
        """Image coordinate y (n,) [mm] at which a line sensor passes points (3, n), about; of platforms that move."""
        del values
        return np.zeros_like(points[1])
