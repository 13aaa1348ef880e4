"""A sensor on a platform as one model: made of both by the chain rule, nothing of it written twice."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from raybundle.errors import Message
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.maths import Scalar
from raybundle.platforms.platform import Platform
from raybundle.sensors.model import SensorModel

RAY_REACH = 1e3
"""Length of the viewing rays of a line, in extents of its way within the image"""


class Carried(SensorModel, registered=False):
    """A sensor on a platform; its parameters are those of the sensor, then those of the platform."""

    one_exposure = False
    line = False
    sensor: SensorModel
    platform: Platform

    @property
    def split(self) -> int:
        """Parameters of the sensor."""
        return len(self.sensor.parameters)

    @property
    def one_format(self) -> bool:
        """As of the sensor: read row by row or carried by a rig, its pixels stay where they are."""
        return self.sensor.one_format

    @cached_property
    def condition_and_jacobian(self) -> Callable[..., tuple[Array, Array]]:
        """As of every model: that of the sensor at the point where the platform puts it."""

        def chained(*arguments: Any) -> tuple[Array, Array]:
            x, y, *rest = arguments
            own = rest[3 : 3 + self.split]
            p, by = self.platform.point_and_jacobian(x, y, *rest[:3], *rest[3 + self.split :])
            g, J = self.sensor.condition_and_jacobian(x, y, *p, *own)
            return g, _chained(J, by, g.shape[1:])

        return chained

    @property
    def moves(self) -> bool:
        """Whether one of its platforms moves while an image is taken."""
        return self.platform.moves or (isinstance(self.sensor, Carried) and self.sensor.moves)

    @property
    def shipped(self) -> bool:
        """As of the sensor."""
        return self.sensor.shipped

    def camera_constant(self, values: Array) -> float:
        """That of the sensor."""
        return self.sensor.camera_constant(values[: self.split])

    def start(self, points: Array, values: Array) -> Array:
        """That of the sensor, as if the point were measured in the middle; of a line, where it passes the point."""
        own, mine = values[: self.split], values[self.split :]
        if not self.sensor.line:
            return self.sensor.start(self.platform.place(np.zeros((2, 1)), points, mine), own)
        y = self.platform.line_passing(points, mine)
        x, _ = self.sensor.start(self.platform.place(np.stack([np.zeros_like(y), y]), points, mine), own)
        return np.stack([x, y])

    def in_front(self, points: Array, image: Array | None = None, values: Array | None = None) -> Mask:
        """Of the sensor; where it may look elsewhere than the platform and is not stated, everywhere."""
        if values is None:
            seen = self.sensor.in_front(points, image)
            return np.any(points != 0, axis=0) if self.platform.looks_elsewhere else seen
        at = np.zeros((2, 1)) if image is None else image
        return self.sensor.in_front(self.platform.place(at, points, values[self.split :]), image, values[: self.split])

    def ray(self, image: Array, values: Array, start: Array | None = None) -> Array:
        """Where the viewing rays meet the unit sphere, or their directions where the sensor is not within it.

        Rays do not pass through the station.  Of a line, whose way is longer, points far along the rays.
        """
        if start is not None:
            return super().ray(image, values, start)
        place = self.point_on_ray(image, values, 0.0)
        if self.sensor.line:
            return self.point_on_ray(image, values, RAY_REACH * max(float(np.abs(place).max(initial=0.0)), 1.0))
        direction = self.point_on_ray(image, values, 1.0) - place
        along, left = np.sum(place * direction, axis=0), 1 - np.sum(place * place, axis=0)
        met = place + (np.sqrt(along**2 + np.maximum(left, 0.0)) - along) * direction
        return np.where(left > 0, met, direction)

    def point_on_ray(self, image: Array, values: Array, distance: float) -> Array:
        """Points (3, n) at this distance from where the sensor was."""
        seen = self.sensor.point_on_ray(image, values[: self.split], distance)
        return self.platform.placed_back(image, seen, values[self.split :])

    def objection(self, values: Mapping[str, float], width_mm: float, free: Sequence[str]) -> Message | None:
        """That of the sensor, or of the platform."""
        return self.sensor.objection(values, width_mm, free) or self.platform.objection(self.sensor, values, free)

    def local(self, image: Array, points: Array, values: Array) -> tuple[Array, Array, Index]:
        """As of every model: the parameters that the sensor touches, and all of the platform."""
        if not self.local_width:
            return super().local(image, points, values)
        mine = values[self.split :]
        p, by = self.platform.point_and_jacobian(*image, *points, *mine)
        g, J, touched = self.sensor.local(image, p, values[: self.split])
        of_platform = np.tile(np.arange(self.split, len(self.symbols), dtype=np.int32), (image.shape[1], 1))
        return g, _chained(J, by, g.shape[1:]), np.concatenate([touched, of_platform], axis=1).astype(np.int32)


def _chained(J: Array, by: Array, shape: tuple[int, ...]) -> Array:
    """Partials (2, 5 + k + m, n) from the sensor's (2, 5 + k, n) and those of its point (3, 5 + m, n)."""
    k, m = J.shape[1] - 5, by.shape[1] - 5
    through = np.einsum("ge...,ei...->gi...", J[:, 2:5], np.broadcast_to(by, (3, 5 + m, *shape)))
    found = np.empty((2, 5 + k + m, *shape))
    found[:, :2] = J[:, :2] + through[:, :2]
    found[:, 2:5] = through[:, 2:5]
    found[:, 5 : 5 + k] = J[:, 5:]
    found[:, 5 + k :] = through[:, 5:]
    return found


def carried(sensor: SensorModel, platform: Platform) -> Carried:
    """The model SENSOR_PLATFORM."""
    k = len(sensor.parameters)
    parameters = (*sensor.parameters, *platform.parameters_with(sensor))
    symbols = [p.symbol for p in parameters]
    if len(set(symbols)) < len(symbols):
        raise TypeError(
            f"{sensor.name} on {platform.name}: both have {sorted({s for s in symbols if symbols.count(s) > 1})}"
        )

    def condition(x: Scalar, y: Scalar, X: Scalar, Y: Scalar, Z: Scalar, *values: Scalar) -> tuple[Scalar, Scalar]:
        """The condition of the sensor at the point where the platform puts it."""
        return type(sensor).condition(x, y, *type(platform).point(x, y, X, Y, Z, *values[k:]), *values[:k])

    point = tuple(inspect.signature(condition).parameters.values())[:5]
    own = tuple(inspect.Parameter(s, inspect.Parameter.POSITIONAL_OR_KEYWORD) for s in symbols)
    condition.__signature__ = inspect.Signature((*point, *own))  # type: ignore[attr-defined]
    made: dict[str, Any] = {
        "__doc__": f"The model {sensor.name}, carried: {(platform.__doc__ or '').split(chr(10))[0]}",
        "__module__": __name__,
        "name": _name(sensor, platform),
        "parameters": parameters,
        "sensor": sensor,
        "platform": platform,
        "condition": staticmethod(condition),
        "explicit": False if platform.uses_image else sensor.explicit,
        "frame": sensor.frame,
        "local_width": sensor.local_width + len(platform.parameters) if sensor.local_width else 0,
    }
    return type(f"{type(sensor).__name__}{type(platform).__name__}", (Carried,), made, registered=False)()


def register_carried(sensor: SensorModel) -> None:
    """Put a sensor on every platform that carries it, and on platforms that stand on each other.

    One motion at most: a trajectory does not stand on a read-out, nor a read-out on a trajectory.
    """
    stacked: list[SensorModel] = [sensor]
    for platform in sorted(Platform.registry.values(), key=lambda p: p.order):
        for model in [m for m in stacked if platform.carries(sensor)]:
            if platform.moves and isinstance(model, Carried) and model.moves:
                continue
            made = SensorModel.registry.get(_name(model, platform))
            if not (isinstance(made, Carried) and made.sensor is model and made.platform is platform):
                made = carried(model, platform)
                SensorModel.registry[made.name] = made
            stacked.append(made)


def register_platform(platform: Platform) -> None:
    """Put every sensor on a platform that is registered later, also together with other platforms."""
    del platform
    for sensor in [*SensorModel.registry.values(), *SensorModel.lines.values()]:
        if not isinstance(sensor, Carried):
            register_carried(sensor)


def _name(sensor: SensorModel, platform: Platform) -> str:
    return sensor.called.get(platform.name, f"{sensor.name}_{platform.name}")
