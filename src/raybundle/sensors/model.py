"""The contract every sensor model fulfils, and everything derived from it.

A sensor model is a condition g(x, y, X, Y, Z, *parameters) = 0: two equations between the measured
image point (x, y) [mm] and the object point (X, Y, Z) in the sensor's own frame (x right, y up, the
view along -Z; the length unit is the block's).
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from typing import ClassVar, Literal

import numpy as np

from raybundle.errors import Message, worded
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.maths import Scalar

Kind = Literal["scale", "principal point", "radial", "decentring", "affinity", "harmonic", "read-out", "other"]


@dataclass(frozen=True, slots=True)
class Parameter:
    """One parameter of an interior orientation."""

    symbol: str
    unit: str
    """"mm" (written with the suffix _mm in block.toml), "mm^-2", "1" ..."""
    meaning: str
    """code of its text, or words"""
    default: float = 0.0
    typical: float = 0.0
    """A magnitude as real sensors have it: the contract tests run there."""
    kind: Kind = "other"
    holdable: bool = True
    shear: bool = False
    """Of the kind affinity: rows and columns that are not at right angles, rather than of unequal scale."""
    values: tuple[tuple[str, str | int | bool], ...] = ()
    """of the text of its meaning, with their names"""

    @property
    def words(self) -> str:
        """Its meaning in words."""
        return worded(self.meaning, **dict(self.values))

    @property
    def is_length(self) -> bool:
        """Whether it grows with the object: "length", "length/s", "length/mm"."""
        return self.unit.startswith("length")

    @property
    def key(self) -> str:
        """The key in block.toml."""
        return f"{self.symbol}_mm" if self.unit == "mm" else self.symbol


RESERVED = frozenset({"g", "J", "shape", "np", "numpy", "in", "out", "l", *"xyXYZ"})
"""Names that the derived functions use for themselves."""


class ProjectionDiverged(ArithmeticError):
    """Newton's method did not find the image of an object point."""


class SensorModel:
    """Interior orientation of one kind of sensor, stated as one condition equation.

    A subclass states `name`, `parameters` and `condition`.  Projection, viewing rays, Jacobians
    and native code are derived; override `start` and `in_front` where the model needs it.
    """

    name: ClassVar[str]
    parameters: tuple[Parameter, ...]
    registry: ClassVar[dict[str, SensorModel]] = {}
    condition: ClassVar[Callable[..., tuple[Scalar, Scalar]]]
    explicit: ClassVar[bool | None] = None
    """Whether the condition reads x - f(X, Y, Z, parameters); None: found out from the condition."""
    by_image: ClassVar[bool] = False
    """Whether it reads f(x, y, parameters) + c (X, Y) / Z, c the first parameter: distortion is one of image points"""
    fixes_scale: ClassVar[bool] = False
    """Whether the model itself knows lengths in object space, as a satellite scene does."""
    followers: ClassVar[list[Callable[[SensorModel], None]]] = []
    """Notified of every model that registers itself later: platforms carry it"""
    lines: ClassVar[dict[str, SensorModel]] = {}
    """Sensors of one line, which are models on platforms alone"""
    line: ClassVar[bool] = False
    """Whether it sees one line at a time, so that it is a model on a platform that moves and not by itself"""
    called: ClassVar[Mapping[str, str]] = {}
    """Platform -> name of the model of both, where it is not SENSOR_PLATFORM"""
    frame: ClassVar[bool] = True
    """Whether all of an image is seen from one place in one orientation, so that platforms can carry the sensor"""
    one_exposure: ClassVar[bool] = True
    """Whether an image is taken at one instant from one place on a plane sensor: targets calibrate it."""
    all_round: ClassVar[bool] = False
    """Whether points beside the sensor and behind it have an image as well: all but the projection centre"""
    local_width: ClassVar[int] = 0
    """Parameters that one image point touches, where they are few of many (see `local`); 0: it may touch all."""

    moves_along: bool = False
    """Whether a station is none for all of an image, so that `stations` are asked for: a line scanner in the air"""
    links: Mapping[str, str] = {}
    """Symbol -> id of the instrument that has this parameter, under the same symbol, for several cameras"""

    def __init_subclass__(cls, *, registered: bool = True) -> None:
        """Check the statement against itself and register the model.

        registered  False for models of single images (`raybundle.scenes.sensor`), which are made from a file
        """
        if not registered:
            return
        stated = tuple(inspect.signature(cls.condition).parameters)[5:]
        declared = tuple(p.symbol for p in cls.parameters)
        if stated != declared:
            raise TypeError(f"{cls.__name__}.condition takes {stated}, parameters states {declared}")
        if taken := RESERVED.intersection(declared):
            raise TypeError(
                f"{cls.__name__}: a parameter cannot be called {', '.join(sorted(taken))}; choose another name"
            )
        made = cls()
        (SensorModel.lines if cls.line else SensorModel.registry)[cls.name] = made
        for follow in SensorModel.followers:
            follow(made)

    def __str__(self) -> str:
        """The registered name."""
        return self.name

    @property
    def one_format(self) -> bool:
        """Whether image coordinates are places on one plane format, over which an image's errors may be smooth."""
        return self.one_exposure

    @cached_property
    def symbols(self) -> tuple[str, ...]:
        """Symbols of the parameters in their order."""
        return tuple(p.symbol for p in self.parameters)

    @cached_property
    def scale_symbol(self) -> str:
        """Symbol of the camera constant, or what else the scale is; "" for a sensor that has none."""
        return next((p.symbol for p in self.parameters if p.kind == "scale"), "")

    @cached_property
    def defaults(self) -> Array:
        """(k,) default values."""
        return np.array([p.default for p in self.parameters])

    @cached_property
    def typical(self) -> Array:
        """(k,) values as a real sensor has them."""
        return np.array([p.typical or p.default for p in self.parameters])

    @cached_property
    def condition_and_jacobian(self) -> Callable[..., tuple[Array, Array]]:
        """G (2, n) and its Jacobian (2, 5 + k, n) by x, y, X, Y, Z and the parameters.

        Shipped models have it generated (`sensors/generated`); others derive it with SymPy, which
        the extra `raybundle[models]` installs.
        """
        if self.shipped:
            try:
                generated = import_module(f"raybundle.sensors.generated.{self.name}")
            except ModuleNotFoundError:
                pass
            else:
                return generated.condition_and_jacobian
        from raybundle.numerics.derive import derive

        return derive(type(self).condition, self.symbols)

    @property
    def shipped(self) -> bool:
        """Whether it is one of raybundle's own, rather than of the user's."""
        return type(self).__module__.startswith("raybundle.sensors.")

    @property
    def native(self) -> bool:
        """Whether the model is compiled into the native kernel."""
        from raybundle.numerics import native

        return self.shipped and self.name in native.sensor_models()

    def camera_constant(self, values: Array) -> float:
        """Camera constant [mm] of parameters (k,), for image scales; the first parameter."""
        return abs(float(values[0]))

    def start(self, points: Array, values: Array) -> Array:
        """First guess (2, n) [mm] of the image of sensor-frame points (3, n); central projection by default."""
        return -values[0] * points[:2] / points[2]

    def in_front(self, points: Array, image: Array | None = None, values: Array | None = None) -> Mask:
        """(n,) whether sensor-frame points (3, n) lie on the side that the sensor sees (measured at `image`)."""
        del image, values
        return np.any(points != 0, axis=0) if self.all_round else points[2] < 0

    def stations(self, xy_px: Array, values: Array) -> Array:
        """Where the sensor was (n, 3) in the object frame for image points (n, 2), of a sensor that `moves_along`."""
        raise NotImplementedError

    def objection(self, values: Mapping[str, float], width_mm: float, free: Sequence[str]) -> Message | None:
        """Why observations do not determine these values, or determine others, and what to do; None for nothing.

        values    parameters by symbol; width_mm of the format; free  symbols that are estimated
        """
        del values, width_mm, free
        return None

    def condition_at(self, image: Array, points: Array, values: Array) -> Array:
        """G (2, n) at image points (2, n) [mm], sensor-frame points (3, n) and parameters (k,) or (k, n)."""
        return self.condition_and_jacobian(*image, *points, *values)[0]

    def local(self, image: Array, points: Array, values: Array) -> tuple[Array, Array, Index]:
        """G (2, n), its Jacobian (2, 5 + w, n), and the positions (n, w) of the parameters that it is taken by.

        image (2, n) [mm], points (3, n) in the sensor frame, values (k,) or (k, n).  A model with many parameters of
        which a point touches few (`local_width`) states which; by default all.
        """
        g, J = self.condition_and_jacobian(*image, *points, *values)
        k = len(self.symbols)
        return g, J, np.tile(np.arange(k, dtype=np.int32), (image.shape[1], 1))

    def project(self, points: Array, values: Array, start: Array | None = None) -> tuple[Array, Array]:
        """Image points (2, n) [mm] of sensor-frame points (3, n), and d image / d point (2, 3, n).

        values  (k,) or (k, n) parameters.  Newton with the derived Jacobian.
        Raises ProjectionDiverged where no image point is found, as beyond the radius up to which a
        distortion can be inverted.  Whether the point lies in front is for `in_front` to say.
        """
        image, jacobian = self.solve(points, values, start)
        by_image, by_point = (np.moveaxis(j, 2, 0) for j in (jacobian[:, :2], jacobian[:, 2:5]))
        return image, np.moveaxis(-np.linalg.solve(by_image, by_point), 0, 2)

    def solve(self, points: Array, values: Array, start: Array | None = None) -> tuple[Array, Array]:
        """Image points (2, n) [mm] that fulfil the condition, and the Jacobian (2, 5 + k, n) there."""
        image = self.start(points, values) if start is None else start
        scale = 1e-13 * max(1.0, float(np.abs(image).max(initial=0.0)))
        with np.errstate(all="ignore"):
            for _ in range(50):
                g, jacobian = self.condition_and_jacobian(*image, *points, *values)
                step = _solve2(jacobian[:, :2], g)
                image = image - step
                if not np.isfinite(step).all():
                    break
                if np.abs(step).max(initial=0.0) <= scale * 100:
                    _, jacobian = self.condition_and_jacobian(*image, *points, *values)
                    return image, jacobian
        raise ProjectionDiverged(f"{self.name}: no image point after 50 iterations")

    def point_on_ray(self, image: Array, values: Array, distance: float) -> Array:
        """Points (3, n) in the sensor frame about so far away that image points (2, n) [mm] show."""
        return self.ray(image, values) * distance

    def ray(self, image: Array, values: Array, start: Array | None = None) -> Array:
        """Unit viewing directions (3, n) in the sensor frame of image points (2, n) [mm].

        Newton on the unit sphere with the derived Jacobian, from `start` or the central projection; closed form where
        distortion is one of image points.
        The ray passes through the projection centre; models with an eccentricity say so themselves.
        """
        if self.by_image and start is None:
            u, v = type(self).condition(*image, 0.0, 0.0, -1.0, *values)
            d = np.stack([u, v, np.broadcast_to(-values[0], image.shape[1:])])
            return d / np.linalg.norm(d, axis=0)
        if start is None:
            c = np.broadcast_to(values[0], image.shape[1:])
            d = np.stack([image[0], image[1], -c])
        else:
            d = start
        d = d / np.linalg.norm(d, axis=0)
        for _ in range(50):
            g, jacobian = self.condition_and_jacobian(*image, *d, *values)
            # shortest step: A' (A A')^-1 g
            A = jacobian[:, 2:5]
            step = np.einsum("ken,kn->en", A, _solve2(np.einsum("ken,len->kln", A, A), g))
            step = step - d * np.sum(d * step, axis=0)
            length = np.linalg.norm(step, axis=0)
            step = step * np.minimum(1.0, 0.3 / np.maximum(length, 1e-300))
            d = d - step
            d = d / np.linalg.norm(d, axis=0)
            if length.max(initial=0.0) < 1e-14:
                break
        return d


def _solve2(matrix: Array, right: Array) -> Array:
    """Solutions (2, n) of the 2 x 2 systems (2, 2, n)."""
    (a, b), (c, d) = matrix
    det = a * d - b * c
    return np.stack([(d * right[0] - b * right[1]) / det, (a * right[1] - c * right[0]) / det])
