"""A satellite scene as the sensor of one image, so that it takes part in the adjustment like any other.

Its exterior orientation is given by the scene and held; what is adjusted are its own parameters: the bias of an RPC,
or the corrections of a rigorous scene's trajectory.  The condition reads image point - projection = 0, and its
partial derivatives are those of `observe_rpc_at` and `observe_line_at`.

The adjustment hands every sensor its points as (U, V, W) = R (X - X0).  R and X0 of a scene are a nominal viewpoint,
600 km up along the line of sight of its middle (of a sensor in the air: where it was then): it serves base-to-depth
ratios and figures, and is undone here.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar, cast

import numpy as np

from raybundle.block import Camera
from raybundle.block.block import Relation
from raybundle.errors import InputError, NoConvergence
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.geodesy import geographic_from_geocentric
from raybundle.numerics.places import Place
from raybundle.scenes.bias import BIAS_PARAMETERS, BiasKind
from raybundle.scenes.corrections import bends
from raybundle.scenes.linescan import LineScene, observe_line_at
from raybundle.scenes.rpc import Observed, Rpc, correct_image, observe_rpc_at
from raybundle.scenes.trajectory import AXES, CorrectionModel
from raybundle.sensors import Parameter, SensorModel

LOW_M = 60e3
"""Height above the ground of a sensor in the air, whose viewpoint is where it was in the middle of the scene."""
VIEW_M = 600e3
"""Distance of the nominal viewpoint from the ground."""
RANGES, DEEP_M = 4.0, 10e3
"""Ground below the middle of a scene: in halves of the range of an RPC, and of a scene that shows no range."""
PIXEL_MM = 0.01
"""Nominal size of a pixel; no result in px depends on it."""
MEANINGS = {
    "A0": "parameter.bias_shift_x", "B0": "parameter.bias_shift_y",
    "A1": "parameter.bias_x_columns", "B1": "parameter.bias_y_columns",
    "A2": "parameter.bias_x_rows", "B2": "parameter.bias_y_rows",
}  # fmt: skip


def _correction(model: CorrectionModel, symbol: str) -> Parameter:
    meaning, values = model.meaning(symbol)
    return Parameter(symbol, model.unit(symbol), meaning, values=values)


class SceneSensor(SensorModel, ABC, registered=False):
    """What the two kinds of scenes have in common."""

    explicit: ClassVar[bool | None] = True
    fixes_scale: ClassVar[bool] = True
    size_px: tuple[int, int]
    place: Place
    height_m: float
    """Ellipsoidal height of the middle of the scene."""
    file: Path | None
    """Where the scene was read."""

    @property
    @abstractmethod
    def depth_m(self) -> float:
        """Below `height_m` by so much there is no ground."""

    @abstractmethod
    def observe(self, xyz: Array, values: Array) -> Observed:
        """Image points [px] of object points (n, 3) and all partial derivatives."""

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
        seen = self.observe(self.object_points(np.stack([X, Y, Z])), own)
        signed = np.array([PIXEL_MM, -PIXEL_MM])
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
        n = points.shape[1]
        g, _ = self.condition_and_jacobian(np.zeros(n), np.zeros(n), *points, *values)
        return -g

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


class RpcSensor(SceneSensor, registered=False):
    """An RPC scene; the parameters are those of its bias [px]."""

    name = "rpc"

    def __init__(
        self, rpc: Rpc, place: Place, size_px: tuple[int, int], bias: BiasKind = "shift", file: Path | None = None
    ) -> None:
        """Place an RPC scene of this size with this model of its bias."""
        self.rpc, self.place, self.size_px, self.file = rpc, place, size_px, file
        self.bias: BiasKind = bias
        self.parameters = tuple(Parameter(s, "px", MEANINGS[s]) for s in BIAS_PARAMETERS[bias])
        self.height_m = float(rpc.ground_offset[2])
        self._finish()

    @property
    def depth_m(self) -> float:
        """By the range of heights for which the polynomials hold."""
        return RANGES * float(self.rpc.ground_scale[2])

    def observe(self, xyz: Array, values: Array) -> Observed:
        """As `SceneSensor`."""
        return observe_rpc_at(self.rpc, self.place, xyz, self.bias, values)

    def localise(self, xy_px: Array, height: Array | float, values: Array) -> Array:
        """As `SceneSensor`."""
        try:
            ground = self.rpc.localise(correct_image(self.rpc, xy_px, self.bias, values), height)
        except NoConvergence as error:
            details = [error.message] if error.message else []
            raise NoConvergence("rpc.scene_localisation", details=details, scene=str(self.file or self.name)) from None
        return self.place.block_from_geographic(ground)

    def priors(self) -> dict[str, float]:
        """Standard deviations of the parameters as the vendor states them, where he does [px].

        ERR_BIAS for the shifts; ERR_RAND, which changes within the scene, for the terms that do.
        """
        found: dict[str, float] = {}
        gsd = np.linalg.norm(self.rpc.pixel_on_ground(), axis=1)
        for s in self.symbols:
            metres = self.rpc.err_bias_m if s[1] == "0" else self.rpc.err_rand_m
            if metres:
                found[s] = metres / float(gsd[0 if s[0] == "A" else 1])
        return found


class LineSensor(SceneSensor, registered=False):
    """A rigorous line scene; the parameters correct its trajectory [m, rad, s]."""

    name = "linescan"

    def __init__(
        self, scene: LineScene, place: Place, corrections: CorrectionModel, height_m: float = 0.0,
        file: Path | None = None, smooth: Mapping[str, float] | None = None,
    ) -> None:  # fmt: skip
        """Place a line scene with these corrections of its trajectory.

        smooth  axis of a curve ("rx") -> standard deviation of its bends, which are observed as zero
        """
        self.scene, self.place, self.corrections, self.file = scene, place, corrections, file
        self.size_px = (scene.width_px, scene.height_px)
        self.height_m = float(height_m)
        self.smooth = dict(smooth or {})
        if strange := [s for s in self.smooth if s not in corrections.groups]:
            raise InputError(
                "line_scene.smooth_unknown",
                name=repr(strange[0]),
                known=list(corrections.groups),
                n=len(corrections.groups),
            )
        self.parameters = tuple(_correction(corrections, s) for s in corrections.symbols)
        self._width = corrections.width if corrections.groups else 0
        sensor = scene.rays(np.array([self.size_px], float) / 2)[0]
        above = float(geographic_from_geocentric(sensor, scene.ellipsoid)[0, 2]) - self.height_m
        if above <= 0:
            raise InputError("line_scene.below_ground", height_m=self.height_m, above_m=-above)
        self._finish(min(500.0, above / 2))
        if above < LOW_M:
            self.centre = place.block_from_geographic(geographic_from_geocentric(sensor, scene.ellipsoid))[0]
            middle = self.localise(np.array([self.size_px], float) / 2, self.height_m, self.defaults)[0]
            self._view_m = float(np.linalg.norm(self.centre - middle))

    @property
    def depth_m(self) -> float:
        """From the highest mountain to below the deepest shore."""
        return DEEP_M

    @property
    def local_width(self) -> int:  # pyright: ignore[reportIncompatibleVariableOverride]
        """Parameters that one image point touches, where there is a curve."""
        return self._width

    def priors(self) -> dict[str, float]:
        """Standard deviations as the table of GNSS and INS states them.

        Those of positions for all corrections of the position, those of attitudes for the curves of the attitude; a
        polynomial of the attitude takes the misalignment of the INS, which its table does not know.
        """
        found: dict[str, float] = {}
        for s in self.symbols:
            if s.rstrip("0123456789").rstrip("_") in AXES["position"] and self.scene.position_sigma_m:
                found[s] = self.scene.position_sigma_m
            if s.startswith("r") and "_" in s and self.scene.attitude_sigma_rad:
                found[s] = self.scene.attitude_sigma_rad
        return found

    def in_front(self, points: Array, image: Array | None = None, values: Array | None = None) -> Mask:
        """Everywhere: `observe` raises where a line does not see a point."""
        del image, values
        return np.ones(points.shape[1], bool)

    @property
    def relations(self) -> tuple[Relation, ...]:
        """The bends of the curves that are observed as zero."""
        c, found = self.corrections, list[Relation]()
        for axis, sigma in self.smooth.items():
            curve = c.attitude_curve if axis in AXES["attitude"] else c.position_curve
            members = c.groups[axis]
            for k, factors in [] if curve is None else bends(curve):
                terms = dict(zip(members[k : k + 3], factors.tolist(), strict=True))
                found.append(Relation(name=f"bend of {axis} at {members[k + 1]}", terms=terms, sigma=sigma))
        return tuple(found)

    def observe(self, xyz: Array, values: Array) -> Observed:
        """As `SceneSensor`."""
        return observe_line_at(self.scene, self.place, xyz, self.corrections, values)

    def local(self, image: Array, points: Array, values: Array) -> tuple[Array, Array, Index]:
        """G (2, n), its Jacobian (2, 5 + w, n) and the positions (n, w) of the parameters that it is taken by."""
        xyz = self.object_points(points)
        own = values[:, 0] if values.ndim == 2 else values
        signed = np.array([PIXEL_MM, -PIXEL_MM])
        begin = image.T / signed + np.array(self.size_px) / 2
        seen = self.scene.observe_few(self.place.geocentric_from_block(xyz), self.corrections, own, begin)
        xy, by_point, few, touched = seen
        J = np.zeros((2, 5 + few.shape[2], len(xyz)))
        J[0, 0] = J[1, 1] = 1
        by_block = by_point @ self.place.geocentric_by_block(xyz)
        J[:, 2:5] = -np.einsum("c,nce,de->cdn", signed, by_block, self.rotation)
        J[:, 5:] = -np.moveaxis(few * signed[:, None], 0, 2)
        return image - ((xy - np.array(self.size_px) / 2) * signed).T, J, touched

    def localise(self, xy_px: Array, height: Array | float, values: Array) -> Array:
        """As `SceneSensor`."""
        return self.place.block_from_geographic(self.scene.localise(xy_px, height, self.corrections, values))


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneView:
    """What stands in `Images` for a scene: the nominal viewpoint, held."""

    centre: Array
    rotation: Array


def scene_camera(
    id_: str, sensor: RpcSensor | LineSensor, *, estimate: tuple[str, ...] | None = None,
    sigma: dict[str, float] | None = None, values: dict[str, float] | None = None,
) -> Camera:  # fmt: skip
    """The camera of one scene.

    estimate  symbols of free parameters; None: all
    sigma     their prior standard deviations; None: those that an RPC's vendor or a table of GNSS and INS states
    """
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
        relations=sensor.relations if isinstance(sensor, LineSensor) else (),
        scene=sensor,
    )


def view_of(camera: Camera) -> SceneView:
    """The nominal viewpoint of a scene's camera."""
    sensor = cast("SceneSensor", camera.scene)
    return SceneView(centre=sensor.centre, rotation=sensor.rotation)
