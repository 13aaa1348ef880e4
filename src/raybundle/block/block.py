"""The data model: cameras, images, observations, points and control, as structs of arrays.

All lengths of object space are in the block's own `length_unit`, angles in radians, image
coordinates in the pixel frame of BLOCK_FORMAT (origin at the outer corner of the first pixel,
x right, y down).  Everything is frozen; `dataclasses.replace` makes a changed copy.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import IntEnum
from typing import Any, ClassVar, Literal, TypeVar, cast

import numpy as np

from raybundle.errors import message
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.counting import counted
from raybundle.numerics.deviations import kept_after
from raybundle.numerics.places import Place
from raybundle.numerics.records import Records, Refers, Stuck, column
from raybundle.numerics.rotation import angles_from_rotation
from raybundle.numerics.transform import SimilarityTransform
from raybundle.observations.attitude import Attitudes
from raybundle.observations.distance import Distances
from raybundle.observations.parameter import Calibrated
from raybundle.observations.relation import Relation
from raybundle.observations.station import Stations
from raybundle.observations.table import Table
from raybundle.platforms import InstrumentModel, instrument_models, sensor_models
from raybundle.sensors import SensorModel

T = TypeVar("T", bound=Table)
Residuals = Literal["measured", "corrected"]
LengthUnit = Literal["m", "mm"]
Turn = Literal[0, 90, 180, 270]
"""Quarter turns, clockwise as seen [deg]."""


class Role(IntEnum):
    """What a point is given for."""

    TIE = 0
    CONTROL = 1
    CHECK = 2

    @property
    def word(self) -> str:
        """As tables write it: tie, control or check."""
        return self.name.lower()


ROLES: Mapping[str, Role] = {role.word: role for role in Role}
"""By the word that tables write."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Parametrised(ABC):
    """What has parameters that are held, free or observed: a camera, an instrument."""

    id: str
    model: str
    """Name of a registered model."""
    values: Mapping[str, float]
    """By symbol, in the model's units (mm, mm^-2, ...); complete."""
    estimate: tuple[str, ...] | Literal["auto"] = ()
    """Symbols of the free parameters; () holds all; "auto" leaves the choice to the adjustment."""
    sigma: Mapping[str, float] = field(default_factory=dict[str, float])
    """Symbols that are observed (their value in `values`) with this standard deviation."""
    calibrated: Calibrated | None = None
    """Parameters that a calibration knows with their covariance; those of them that are free are observed"""
    relations: tuple[Relation, ...] = ()
    """What is known of several parameters together, as that corrections change smoothly in time."""
    known: Mapping[str, float] = field(default_factory=dict[str, float])
    """Values that were known before anything was measured, where `values` have moved since: what the observations do
    not determine is held there.  Not written to files: what a file gives is what is known."""

    @property
    @abstractmethod
    def sensor(self) -> SensorModel | InstrumentModel:
        """The model."""

    @property
    def parameters(self) -> Array:
        """(k,) values of the model's parameters, in its order; its defaults where `values` has none."""
        return np.array([self.values.get(p.symbol, p.default) for p in self.sensor.parameters])


@dataclass(frozen=True, slots=True, kw_only=True)
class Instrument(Parametrised):
    """A GNSS antenna, an IMU, a mount, or a trajectory that several scenes share; values not given are 0."""

    scene: InstrumentModel | None = None
    """What corrects a trajectory of scenes; None: the registered model of that name"""

    def __post_init__(self) -> None:
        """Complete the values."""
        if self.scene is not None or self.model in instrument_models:
            values = {s: float(self.values.get(s, 0.0)) for s in self.sensor.symbols}
            object.__setattr__(self, "values", values)

    @property
    def sensor(self) -> InstrumentModel:
        """The model."""
        return self.scene or instrument_models[self.model]


@dataclass(frozen=True, slots=True, kw_only=True)
class Camera(Parametrised):
    """One interior orientation and the image format it belongs to; its model is that of a sensor."""

    width_px: int
    height_px: int
    pixel_mm: tuple[float, float]
    """Width and height of a pixel."""
    interior: Literal["shared", "per_image"] = "shared"
    """Whether the images of this camera share one interior orientation or have one each."""
    per_image: tuple[str, ...] = ()
    """Symbols of which each image has its own value while the others are shared: motion during a read-out."""
    scene: SensorModel | None = None
    """A satellite scene, which is the sensor of one image alone; None: the registered model of that name."""

    @property
    def sensor(self) -> SensorModel:
        """The sensor model."""
        return self.scene or sensor_models[self.model]

    @property
    def is_scene(self) -> bool:
        """Whether this is a satellite scene."""
        return self.scene is not None

    @property
    def own_symbols(self) -> tuple[str, ...]:
        """Symbols of the parameters that each image has for itself."""
        return self.sensor.symbols if self.interior == "per_image" else self.per_image

    @property
    def size_mm(self) -> Array:
        """Width and height (2,) of the image format [mm]."""
        return np.array([self.width_px * self.pixel_mm[0], self.height_px * self.pixel_mm[1]])

    def image_from_pixel(self, xy_px: Array) -> Array:
        """Image frame (n, 2) [mm] of pixel frame (n, 2) [px]."""
        half = np.array([self.width_px, self.height_px]) / 2
        return (np.asarray(xy_px) - half) * (np.array(self.pixel_mm) * [1, -1])

    def pixel_from_image(self, xy_mm: Array) -> Array:
        """Pixel frame (n, 2) [px] of image frame (n, 2) [mm]."""
        half = np.array([self.width_px, self.height_px]) / 2
        return np.asarray(xy_mm) / (np.array(self.pixel_mm) * [1, -1]) + half


@dataclass(frozen=True, slots=True, kw_only=True)
class PixelFrame:
    """How a file's pixels lie, where they are not those of its camera: stored turned, a copy, a scan of film."""

    turned: Turn
    """By which the camera's picture was turned"""
    width_px: int
    """Of the file"""
    height_px: int
    affine: tuple[float, float, float, float, float, float] | None = None
    """Of a scan, whose place follows from fiducial marks: x = a0 x' + a1 y' + a2, y = a3 x' + a4 y' + a5 of the file by
    x', y' of the camera; None: a copy"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Images(Records):
    """Exterior orientations; NaN where not known."""

    named_by: ClassVar[tuple[str, ...]] = ("ids",)

    ids: tuple[str, ...] = column("text")
    camera: Index = column("camera")
    """(n,) position in `Block.cameras`."""
    file: tuple[str, ...] = column("text", optional=True)
    """(n,) names of files; "" of images without one, as all are where None is given."""
    centre: Array = column("number", shape=(3,), follows="position", approximate="orientation")
    """(n, 3) projection centres."""
    rotation: Array = column("number", shape=(3, 3), follows="rotation", approximate="orientation")
    """(n, 3, 3) object axes to image axes."""
    held: Mask | None = column("mask", optional=True)
    """(n,) True where the exterior orientation is known and held; None: nowhere."""
    interior: Mapping[int, Mapping[str, float]] = column("by row")
    """Parameters of single images, where a camera has some "per_image" and they are known."""
    station: Index | None = column("station", optional=True)
    """(n,) number of the station whose exterior orientation an image shares with others of a rig; None: each its own.

    Images of one station have the same centre and rotation: those of the rig, in whose frame a mounted camera stands.
    """
    date: tuple[str, ...] | None = column("text", optional=True)
    """(n,) day of each image in a block of several dates, YYYY-MM-DD; None: one date, or not known."""
    frames: Mapping[int, PixelFrame] = column("by row")
    """Images whose files are stored turned or reduced; image points are in the camera's pixels all the same."""

    def __post_init__(self) -> None:
        """Images without files."""
        if cast("Any", self.file) is None:
            object.__setattr__(self, "file", ("",) * len(self.ids))

    @property
    def oriented(self) -> Mask:
        """(n,) whether the exterior orientation is known, if only approximately."""
        return np.all(np.isfinite(self.centre), axis=1) & np.all(np.isfinite(self.rotation), axis=(1, 2))

    @property
    def angles(self) -> Array:
        """(n, 3) omega, phi, kappa [rad]."""
        return angles_from_rotation(self.rotation)


@dataclass(frozen=True, slots=True, kw_only=True)
class Observations(Records):
    """Image observations, one row per measured image point."""

    named_by: ClassVar[tuple[str, ...]] = ("image", "point")

    image: Index = column("image")
    """(m,) position in `Block.images`."""
    point: Index = column("point")
    """(m,) position in `Block.points`."""
    xy_px: Array = column("number", shape=(2,), follows="stays")
    """(m, 2) pixel frame."""
    cov_px2: Array = column("number", shape=(3,), follows="stays")
    """(m, 3) variances of x and y and their covariance [px^2]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Points(Records):
    """Object points."""

    named_by: ClassVar[tuple[str, ...]] = ("ids",)

    ids: tuple[str, ...] = column("text")
    role: Index = column("choice")
    """(p,) `Role`."""
    xyz: Array = column("number", shape=(3,), follows="position", approximate="coordinates")
    """(p, 3) given or approximate coordinates; NaN where not known."""
    sigma: Array = column("number", shape=(3,), follows="deviations")
    """(p, 3) 0 = held, > 0 = observed with this sigma, NaN = only approximate."""
    window: Array | None = column("number", follows="length", empty=True, optional=True)
    """(p,) standard deviation of the Gaussian weights of the window that matching saw of the point, on the object in
    `length_unit`; NaN where the point was not measured by matching."""
    misfit: Array | None = column("number", follows="stays", empty=True, optional=True)
    """(p,) variance of the residuals of these windows over that of their noise."""
    relief: Array | None = column("number", follows="stays", empty=True, optional=True)
    """(p,) power of displacements of the windows' parts along the parallax over that across."""
    sigma_curvature: Array | None = column("number", follows="length", empty=True, optional=True)
    """(p,) standard deviation, along the rays, of the correction for curvature of the surface within these windows."""

    def stuck(self, by: SimilarityTransform) -> Sequence[Stuck]:
        """As of all tables; of coordinates, those that are given to be checked."""
        given = np.where(self.is_check, 0.0, np.nan)
        rows = ~kept_after(by.rotation, given, alone=True)
        return [*Records.stuck(self, by), Stuck(rows, message("transform.not_given"))]

    @property
    def is_control(self) -> Mask:
        """(p, 3) coordinates that are given as control, held or weighted."""
        given = np.isfinite(self.xyz) & np.isfinite(self.sigma)
        return given & (np.asarray(self.role) == Role.CONTROL)[:, None]

    @property
    def is_check(self) -> Mask:
        """(p, 3) coordinates that are given to be checked.

        Where a point states standard deviations, a coordinate without one is only approximate, as of control; one that
        states none gives all of its coordinates.
        """
        known = np.isfinite(self.sigma)
        given = np.isfinite(self.xyz) & (known | ~known.any(axis=1, keepdims=True))
        return given & (np.asarray(self.role) == Role.CHECK)[:, None]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Block:
    """Everything that is adjusted together."""

    name: str = "block"
    about: str = ""
    source: str = ""
    licence: str = ""
    length_unit: LengthUnit = "m"
    free_scale: bool = False
    """Whether an adjustment found that nothing fixes the scale: lengths are then in no unit, whatever `length_unit`."""
    nominal_scale: bool = False
    """Whether approximate coordinates have their size from a given length, as the spacing of a board: where nothing
    that was observed fixes the scale, lengths are in `length_unit`, and the error of that length is in no sigma."""
    sigma0_apriori: float = 1.0
    residuals: Residuals = "measured"
    noise: Literal["", "white", "fields"] = ""
    """How the errors of the image points were taken when the block was adjusted; "": nobody stated."""
    datum_over: Literal["", "all", "good"] = ""
    """Points that carried inner constraints: all, or those that are well determined; "": nobody stated, all."""
    rejected: tuple[tuple[str, str], ...] = ()
    """Image observations, as image and point, that were found wrong before: they stand here and take no part."""
    place: Place | None = None
    """Where the object frame stands on the earth; satellite scenes need it."""
    cameras: tuple[Camera, ...]
    images: Images
    observations: Observations
    points: Points
    instruments: tuple[Instrument, ...] = ()
    """GNSS antennas and IMUs, which observed positions and attitudes name"""
    tables: Mapping[str, Table] = field(default_factory=dict[str, Table])
    """Observations outside the images, by the names of their tables; `having` puts one in."""

    def __repr__(self) -> str:
        """One line."""
        of = [(self.cameras, "camera"), (self.images, "image"), (self.points, "object point")]
        of += [(self.observations, "image observation"), (self.instruments, "instrument")]
        parts = [counted(len(rows), noun) for rows, noun in of if len(rows) or noun != "instrument"]
        parts += [f"{len(t)} {t.name.replace('_', ' ')}" for t in self.tables.values()]
        return f"<Block {', '.join([repr(self.name), *parts])}>"

    @property
    def parametrised(self) -> tuple[Camera | Instrument, ...]:
        """All that has parameters: the cameras, then the instruments."""
        return (*self.cameras, *self.instruments)

    def table(self, kind: type[T]) -> T:
        """The table of a kind; one without rows where there is none."""
        found: Any = self.tables.get(kind.name)
        return kind.empty() if found is None else found

    def having(self, *tables: Table) -> Block:
        """The block with these tables in place of those of the same kinds."""
        new = {**self.tables, **{t.name: t for t in tables}}
        return replace(self, tables={name: t for name, t in new.items() if len(t)})

    def adding(self, *tables: Table) -> Block:
        """The block with the rows of these tables behind those that it has."""
        return self.having(*(self.table(type(t)).append(t) for t in tables))

    def row_names(self, table: Table) -> Callable[[int], str]:
        """What rows of a table are called in messages: number in the file and what they name."""
        ids = {"point": self.points.ids, "image": self.images.ids, "text": None}
        shown = [(c.of, getattr(table, name)) for name, c in table.columns() if c.of in ids]

        def called(k: int) -> str:
            names = [v[k] if of == "text" else f"{of} {(ids[of] or ())[int(v[k])]}" for of, v in shown]
            return f"{table.name}.csv, row {k + 1} ({', '.join(dict.fromkeys(names))})"

        return called

    def of_tables(self, change: Callable[[Table], Table]) -> Block:
        """The block with all its tables changed."""
        return self.having(*map(change, self.tables.values()))

    @property
    def points_named(self) -> Mask:
        """(p,) object points that observations outside the images name."""
        return self._named("point", len(self.points))

    @property
    def images_named(self) -> Mask:
        """(n,) images that observations outside the images name."""
        return self._named("image", len(self.images))

    def _named(self, what: Refers, count: int) -> Mask:
        found = np.zeros(count, bool)
        for table in self.tables.values():
            found[table.refers(what)] = True
        return found

    @property
    def distances(self) -> Distances:
        """Scale bars."""
        return self.table(Distances)

    @property
    def stations(self) -> Stations:
        """Observed projection centres."""
        return self.table(Stations)

    @property
    def attitudes(self) -> Attitudes:
        """Observed rotations of images."""
        return self.table(Attitudes)

    @property
    def ray_count(self) -> Index:
        """(p,) image observations of each point."""
        return np.bincount(self.observations.point, minlength=len(self.points)).astype(np.int32)

    def camera_of(self, image: int) -> Camera:
        """The camera of an image, with the values that this image has for itself."""
        camera, own = self.cameras[int(self.images.camera[image])], self.images.interior.get(image)
        return camera if own is None else replace(camera, values={**camera.values, **own})

    def with_cameras(self, *cameras: Camera) -> Block:
        """The block with these cameras in place of those with the same ids."""
        new = {c.id: c for c in cameras}
        return replace(self, cameras=tuple(new.get(c.id, c) for c in self.cameras))
