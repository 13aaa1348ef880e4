"""A satellite scene as the sensor of one image, so that it takes part in the adjustment like any other.

Its exterior orientation is given by the scene and held; what is adjusted are its own parameters: the bias of an RPC,
or the corrections of a rigorous scene's trajectory.  The condition reads image point - projection = 0, and its
partial derivatives are those of `SceneSensor.observe`.

A kind of scene is one file in `raybundle.scenes.kinds`, which registers itself.

The adjustment hands every sensor its points as (U, V, W) = R (X - X0).  R and X0 of a scene are a nominal viewpoint,
600 km up along the line of sight of its middle (of a sensor in the air: where it was then): it serves base-to-depth
ratios and figures, and is undone here.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, Literal, Protocol, Self, cast

import numpy as np

from raybundle.block import Camera
from raybundle.block.block import Relation
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Mask
from raybundle.numerics.geodesy import Ellipsoid
from raybundle.numerics.places import Place
from raybundle.scenes.observed import Observed
from raybundle.scenes.rpc import Rpc
from raybundle.scenes.rpc_fit import RpcFit, fit_rpc
from raybundle.scenes.trajectory import CorrectionModel
from raybundle.sensors import Parameter, SensorModel

VIEW_M = 600e3
"""Distance of the nominal viewpoint from the ground."""
PIXEL_MM = 0.01
"""Nominal size of a pixel; no result in px depends on it."""


class Rigorous(Protocol):
    """The physical model of a scene, as readers make it and every kind of scene that has one understands."""

    @property
    def width_px(self) -> int:
        """Columns."""
        ...

    @property
    def height_px(self) -> int:
        """Lines."""
        ...

    @property
    def ellipsoid(self) -> Ellipsoid:
        """The body."""
        ...

    @property
    def seconds(self) -> float:
        """Time that the image took."""
        ...

    def localise(self, xy_px: Array, height: Array | float) -> Array:
        """Longitude, latitude [deg], height [m] (n, 3) of image points (n, 2) at ellipsoidal heights."""
        ...

    def project(self, geographic: Array) -> Array:
        """Image points (n, 2) [px] of longitude, latitude [deg], height [m] (n, 3)."""
        ...

    def without_corrections(self) -> Self:
        """The same model in empty space and with infinitely fast light."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Key:
    """A key of a scene in block.toml beside the common ones; the type of its default is that of its value.

    A text is one of `options`, a truth value stands there where it is true, a table holds standard deviations.
    """

    name: str
    default: Any = None
    options: tuple[Any, ...] = ()
    holds: Literal["value", "fixes", "pieces"] = "value"
    """Fixes and pieces are curves in time."""


class SceneSensor(SensorModel, ABC, registered=False):
    """One kind of scene; a subclass states what is below and registers itself under its `name`."""

    kinds: ClassVar[dict[str, type[SceneSensor]]] = {}
    geometry: ClassVar[type]
    """What the readers of its files make: the first argument of its constructor, the second is the place."""
    rigorous: ClassVar[bool] = True
    """Whether that is a physical model, which the vendor's RPC of the same image has to agree with."""
    keys: ClassVar[tuple[Key, ...]] = ()
    formula: ClassVar[str]
    """Its condition, for the reference"""
    possible: ClassVar[tuple[Parameter, ...]]
    """All parameters that a scene can have, but for those of curves"""
    begin: ClassVar[Mapping[str, Any]] = {}
    """Keys with which a scene takes part where nobody states any."""
    stored: ClassVar[tuple[type, ...]] = ()
    """Data classes of its state beside its geometry"""
    explicit: ClassVar[bool | None] = True
    fixes_scale: ClassVar[bool] = True
    size_px: tuple[int, int]
    place: Place
    height_m: float
    """Ellipsoidal height of the middle of the scene."""
    file: Path | None
    """Where the scene was read."""
    airborne: bool = False
    """Whether the sensor was on an aircraft: below the height of any satellite"""
    relations: tuple[Relation, ...] = ()
    groups: Mapping[str, tuple[str, ...]] = {}
    """Names that stand for several parameters: those of an axis of a curve"""

    def __init_subclass__(cls, *, registered: bool = True) -> None:
        """Register the kind."""
        super().__init_subclass__(registered=False)
        if registered:
            SceneSensor.kinds[cls.name] = cls

    @classmethod
    @abstractmethod
    def of_keys(
        cls, model: Any, place: Place, size_px: tuple[int, int], file: Path | None, keys: Mapping[str, Any]
    ) -> Self:
        """A scene with values for all of `keys`; raises InputError with the key as its column."""

    @classmethod
    def begun(cls, model: Any, place: Place, size_px: tuple[int, int], file: Path | None = None, **keys: Any) -> Self:
        """A scene with some keys; a key that the kind does not have is passed over."""
        usual = {k.name: k.default for k in cls.keys} | dict(cls.begin)
        return cls.of_keys(model, place, size_px, file, usual | {k: v for k, v in keys.items() if k in usual})

    @classmethod
    @abstractmethod
    def example(cls, place: Place, target: tuple[float, float, float]) -> Self:
        """A simulated scene of a target (longitude, latitude [deg], height [m]): the contract tests run with it."""

    @property
    @abstractmethod
    def key_values(self) -> dict[str, Any]:
        """The values of its keys as block.toml holds them; a key without a value is not among them."""

    @property
    @abstractmethod
    def state(self) -> dict[str, Any]:
        """The arguments of its constructor, by name, but for place and file."""

    @property
    @abstractmethod
    def title(self) -> str:
        """The kind in words, for tables."""

    @classmethod
    def assumed(cls, model: Any) -> tuple[str, Mapping[str, float]] | None:
        """Code and values of the notice about usual standard deviations; None where the vendor states them."""
        del model
        return None

    def priors(self) -> dict[str, float]:
        """Standard deviations of the parameters as the vendor states them, where he does."""
        return {}

    def usual_priors(self) -> dict[str, float]:
        """Standard deviations of the parameters of `begin`: as the vendor states them, else as is usual."""
        return self.priors()

    def prior_px(self) -> Array:
        """Standard deviation (2,) [px] in x and y of the shift that the usual priors allow."""
        usual = self.usual_priors()
        ground = self.localise(np.array([self.size_px], float) / 2, self.height_m, self.defaults)
        by = self.observe(ground, self.defaults).by_parameters[0]
        return np.sqrt(((by * [usual.get(s, 0.0) for s in self.symbols]) ** 2).sum(axis=1))

    def metres(self, symbol: str) -> float:
        """Metres on the ground of one unit of a parameter; NaN where it is none of the image."""
        del symbol
        return float("nan")

    def shift(self, xy_px: Array, values: Array) -> Array | None:
        """(n, 2) px by which the parameters move image points, where they are a polynomial of these."""
        del xy_px, values
        return None

    @property
    def curves(self) -> tuple[CorrectionModel, float] | None:
        """What corrects its trajectory by its first parameters, and half the time [s] that the image took."""
        return None

    def check_near(self, xyz: Array, names: Sequence[str]) -> None:
        """Raise InputError where points (n, 3) lie so far away that the scene shows nothing of them."""

    @property
    def heights_m(self) -> tuple[float, float] | None:
        """Lowest and highest ground for which it holds, where it is bounded."""
        return None

    def as_rpc(
        self, values: Array, heights: tuple[float, float], known: tuple[tuple[str, ...], Array]
    ) -> tuple[Rpc, RpcFit | None]:
        """An RPC with the parameters built in, and how well it fits where it is a new one.

        known  symbols and covariance of the adjusted parameters; empty without a result
        """
        del known
        fit = fit_rpc(
            lambda xy, h: self.place.geographic_from_block(self.localise(xy, h, values)), self.size_px, heights
        )
        return fit.rpc, fit

    @property
    @abstractmethod
    def depth_m(self) -> float:
        """Below `height_m` by so much there is no ground."""

    @abstractmethod
    def observe(self, xyz: Array, values: Array, near: Array | None = None) -> Observed:
        """Image points [px] of object points (n, 3) and all partial derivatives.

        near  (n, 2) image points near the result, for images that show some ground twice
        """

    @abstractmethod
    def localise(self, xy_px: Array, height: Array | float, values: Array) -> Array:
        """Object points (n, 3) of image points (n, 2) [px] at ellipsoidal heights [m]."""

    def _finish(self, rise_m: float = 500.0) -> None:
        """The nominal viewpoint, by the ray of the middle between the ground and a height above it."""
        self._view_m = VIEW_M
        middle = np.array([self.size_px], float) / 2
        steps = middle + np.array([[0.0, 0.0], [self.size_px[0] / 4, 0.0]])
        values = self.defaults
        ground, right = self.localise(steps, self.height_m, values)
        above = self.localise(middle, self.height_m + rise_m, values)[0]
        back = (above - ground) / np.linalg.norm(above - ground)
        x = right - ground
        self._gsd = float(np.linalg.norm(x)) / (self.size_px[0] / 4)
        x = x - back * (x @ back)
        x /= np.linalg.norm(x)
        self.rotation: Array = np.stack([x, np.cross(back, x), back])
        self.centre: Array = ground + VIEW_M * back

    def camera_constant(self, values: Array) -> float:
        """Nominal, from the ground sampling distance."""
        del values
        return self._view_m / self._gsd * PIXEL_MM

    def object_points(self, points: Array) -> Array:
        """Object points (n, 3) of points (3, n) in the nominal sensor frame."""
        return points.T @ self.rotation + self.centre

    def condition_and_jacobian(  # pyright: ignore[reportIncompatibleVariableOverride]
        self, x: Array, y: Array, X: Array, Y: Array, Z: Array, *values: Array
    ) -> tuple[Array, Array]:
        """As of any sensor model; the parameters are those of one scene."""
        single = np.ndim(x) == 0 and np.ndim(X) == 0
        x, y, X, Y, Z = np.broadcast_arrays(*(np.atleast_1d(a) for a in (x, y, X, Y, Z)))
        own = np.array([float(np.ravel(v)[0]) for v in values])
        signed = np.array([PIXEL_MM, -PIXEL_MM])
        near = np.stack([x, y], axis=1) / signed + np.array(self.size_px) / 2
        seen = self.observe(self.object_points(np.stack([X, Y, Z])), own, near)
        image = (seen.xy_px - np.array(self.size_px) / 2) * signed
        n, k = len(x), len(own)
        J = np.zeros((2, 5 + k, n))
        J[0, 0] = J[1, 1] = 1
        by_point = np.einsum("c,nce,de->cdn", signed, seen.by_point, self.rotation)
        J[:, 2:5] = -by_point
        J[:, 5:] = -np.moveaxis(seen.by_parameters * signed[:, None], 0, 2)
        g = np.stack([x, y]) - image.T
        return (g[:, 0], J[:, :, 0]) if single else (g, J)

    def start(self, points: Array, values: Array) -> Array:
        """The projection itself."""
        own = np.array([float(np.ravel(v)[0]) for v in values])
        seen = self.observe(self.object_points(points), own)
        return ((seen.xy_px - np.array(self.size_px) / 2) * np.array([PIXEL_MM, -PIXEL_MM])).T

    def in_front(self, points: Array, image: Array | None = None, values: Array | None = None) -> Mask:
        """Everywhere below the satellite."""
        del image, values
        return points[2] < 0

    def point_on_ray(self, image: Array, values: Array, distance: float) -> Array:
        """On the ground."""
        del distance
        return self.ray(image, values)

    def ray(self, image: Array, values: Array, start: Array | None = None) -> Array:
        """Points (3, n) on the ground, in the nominal sensor frame: a scene's rays have no common centre."""
        del start
        xy_px = image.T / np.array([PIXEL_MM, -PIXEL_MM]) + np.array(self.size_px) / 2
        own = np.array([float(np.ravel(v)[0]) for v in values])
        ground = self.localise(xy_px, self.height_m, own)
        return self.rotation @ (ground - self.centre).T


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneView:
    """What stands in `Images` for a scene: the nominal viewpoint, held."""

    centre: Array
    rotation: Array


def scene_camera(
    id_: str, sensor: SceneSensor, *, estimate: tuple[str, ...] | None = None,
    sigma: dict[str, float] | None = None, values: dict[str, float] | None = None,
) -> Camera:  # fmt: skip
    """The camera of one scene.

    estimate  symbols of free parameters; None: all
    sigma     their prior standard deviations; None: those that an RPC's vendor or a table of GNSS and INS states
    """
    if sensor.links:  # what it shares is free with its instruments
        estimate, sigma = (), {}
    free = sensor.symbols if estimate is None else estimate
    unknown = [s for s in (*free, *(sigma or {}), *(values or {})) if s not in sensor.symbols]
    if unknown:
        raise InputError("camera.unknown_scene_parameter", camera=id_, name=repr(unknown[0]), known=sensor.symbols)
    if sigma is None:
        sigma = sensor.priors()
    return Camera(
        id=id_,
        model=sensor.name,
        width_px=sensor.size_px[0],
        height_px=sensor.size_px[1],
        pixel_mm=(PIXEL_MM, PIXEL_MM),
        values={**dict.fromkeys(sensor.symbols, 0.0), **(values or {})},
        estimate=free,
        sigma={s: v for s, v in sigma.items() if s in free},
        relations=() if sensor.links else sensor.relations,
        scene=sensor,
    )


def view_of(camera: Camera) -> SceneView:
    """The nominal viewpoint of a scene's camera."""
    sensor = cast("SceneSensor", camera.scene)
    return SceneView(centre=sensor.centre, rotation=sensor.rotation)
