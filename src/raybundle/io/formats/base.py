"""What a foreign format is, and the view of a block that all writers share."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

import numpy as np

from raybundle.block import Block, Camera, Images, Observations, Points, Role
from raybundle.cameras.conversions import LIMIT_PX, CameraFit, interiors, parameter_vector
from raybundle.errors import InputError, Message, note, phrase
from raybundle.io.folders import check_free, check_new_file, make_parent, new_files, new_folder
from raybundle.io.geo.coordinate_systems import LocalFrame
from raybundle.io.ids import check_ids_of
from raybundle.io.reading.files import guarded, opened
from raybundle.io.reading.ledger import ledger, not_read
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.readable import readable, readable_names
from raybundle.sensors import ProjectionDiverged, sensor_models

SENSOR_FROM_CV = np.diag([1.0, -1.0, -1.0])
"""Computer vision's camera axes are x right, y down, z forward; ours x right, y up, the view along -Z."""
GREY = 128
SIGMA_PX = 1.0
"""Standard deviation given to image observations of formats that show none."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PlaneAxes:
    """Axes of a plane in a block: X to the right in it, Y up in it, Z out of it."""

    origin: Array
    """(3,)"""
    axes: Array
    """(3, 3), rows right, up, normal"""

    def coordinates(self, xyz: Array) -> Array:
        """(n, 3) on these axes."""
        return (xyz - self.origin) @ self.axes.T

    def sigma(self, sigma: Array) -> Array:
        """(n, 3) standard deviations on these axes of coordinates whose correlations are not known."""
        return np.sqrt(sigma**2 @ (self.axes**2).T)


@dataclass(frozen=True, slots=True, kw_only=True)
class Underlay:
    """A picture to scale below a drawing in the axes of its plane or map."""

    file: str
    """path, as the drawing names it"""
    extent: tuple[float, float, float, float]
    """left, bottom, right, top"""
    size_px: tuple[int, int]
    """width, height"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Displaced:
    """Displacements of points between dates, in the axes of the block."""

    point: tuple[str, ...]
    start: tuple[str, ...]
    """(r,) earlier date"""
    end: tuple[str, ...]
    xyz: Array
    """(r, 3) at the earlier date [m]"""
    vector: Array
    """(r, 3) [m]"""
    covariance: Array
    """(r, 3, 3) [m^2]"""
    p: Array
    """(r,) probability without motion"""
    verdict: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Export:
    """What a writer is given."""

    block: Block
    """With adjusted coordinates; a point or image without them is left out."""
    colours: Array | None = None
    """(p, 3) red, green, blue, 0 to 255; None: grey."""
    sigma: Array | None = None
    """(p, 3) standard deviations of the object points, unit of the block; NaN where not known."""
    station_sigma: Array | None = None
    """(n, 3) standard deviations of the projection centres."""
    station_angle_sigma: Array | None = None
    """(n, 3) standard deviations of omega, phi, kappa of the stations [rad]."""
    frame: LocalFrame | None = None
    """Where the block stands on the earth."""
    map_sigma: Array | None = None
    """(p, 3) standard deviations of the object points along the axes of the frame's system, in its units, where known
    better than from `sigma`, which lacks the correlations between the coordinates."""
    map_station_sigma: Array | None = None
    """(n, 3) the same of the projection centres."""
    nominal: Mask | None = None
    """(n,) images that stand for satellite scenes, whose stations are no places; None: no image."""
    given: Array | None = None
    """(p, 3) coordinates that were given of control and check points; NaN where none."""
    record: Mapping[str, str] = field(default_factory=dict[str, str])
    """What is stated of the delivery: title, client, rights and the like; its state, where it is not to be used yet."""
    within: PlaneAxes | None = None
    """Axes of a plane in which it is written; then `frame` is None."""
    underlay: Underlay | None = None
    """Picture of that plane or map."""
    interior: Mapping[str, tuple[tuple[str, ...], Array]] = field(
        default_factory=dict[str, tuple[tuple[str, ...], "Array"]]
    )
    """Camera -> symbols of its free parameters and their covariance, in their units, where a result shows it."""
    displaced: Displaced | None = None
    """What moved between the dates of a result of several."""
    unread: Mapping[str, int] = field(default_factory=dict[str, int])
    """Number of elements of the file it comes from that the reader passed over, by kind."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Import:
    """What a reader returns."""

    block: Block
    colours: Array | None = None
    """(p, 3) red, green, blue, 0 to 255."""
    remarks: tuple[Message, ...] = ()
    """What was left out, approximated or assumed."""
    deviation_px: float = 0.0
    """Largest deviation of our cameras from those of the file, over the whole format."""
    unread: Mapping[str, int] = field(default_factory=dict[str, int])
    """Number of elements of the file that were passed over, by kind; `read_format` fills it in."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Written:
    """What a writer wrote."""

    files: tuple[Path, ...]
    remarks: tuple[str, ...] = ()
    deviation_px: float = 0.0
    """Largest deviation of the written cameras from ours, over the whole format."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Draft:
    """What a writer states about what it wrote into its folder."""

    remarks: tuple[str, ...] = ()
    deviation_px: float = 0.0


Writer = Callable[[Export, Path], Draft]
"""Writes to the path, in a temporary folder: a new file or, for formats that are folders, an empty folder."""
Reader = Callable[[Path], Import]


@dataclass(frozen=True, slots=True, kw_only=True)
class Format:
    """A foreign format."""

    name: str
    title: str
    kind: Literal["file", "folder"]
    suffix: str = ""
    """Of a file, with its point."""
    write: Writer | None = None
    read: Reader | None = None
    looks: Callable[[Path], bool] | None = None
    """Whether an existing file or folder looks like one; None: nothing shows."""
    needs_frame: bool = False
    """Whether it can only be written where the block's coordinate system is known."""
    colours: bool = False
    """Whether its points have colours."""
    points: Literal["all", "named", "none"] = "all"
    """Which it holds; named: control and check points."""
    observations: bool = True
    """Whether it holds the image observations of these."""
    metric: bool = False
    """Whether who reads it takes its coordinates for metres, or for places on the earth."""
    in_plane: bool = False
    """Whether it can be written in the axes of a plane."""


formats: dict[str, Format] = {}


def register(format_: Format) -> Format:
    """Make a format known under its name."""
    formats[format_.name] = format_
    return format_


def format_named(name: str) -> Format:
    """The format of this name; raises InputError, which lists the known ones."""
    if name not in formats:
        raise InputError("format.unknown", format=name, known=sorted(formats))
    return formats[name]


def looks_like(path: Path) -> tuple[str, ...]:
    """The readable formats that an existing file or folder looks like."""
    return tuple(name for name, f in sorted(formats.items()) if f.read and f.looks is not None and f.looks(path))


def json_begins(path: Path) -> str:
    """The first character of a file of JSON: "{" or "["; empty for everything else."""
    if path.is_dir() or path.suffix.lower() != ".json":
        return ""
    with opened(path) as file:
        return file.read(64).lstrip(b"\xef\xbb\xbf \t\r\n")[:1].decode("latin-1")


def read_format(name: str, path: str | Path) -> Import:
    """What stands in a file or folder of this format.

    raises  InputError with file and place for anything that cannot be read, and for formats that are only written
    """
    format_, path = format_named(name), Path(path)
    if format_.read is None:
        raise InputError(
            "format.only_written", format=name, known=sorted(f.name for f in formats.values() if f.read), file=path
        )
    if not path.exists():
        raise InputError("file.missing", file=path)
    with guarded(path), ledger() as passed_over:
        found = format_.read(path)
        unread = passed_over.counts()
    remarks = (*found.remarks, *(t.message for t in not_read(unread)))
    return replace(found, remarks=remarks, unread=unread)


def write_format(
    name: str, export: Export, path: str | Path, *, approximate: bool = False, free_scale: bool = False
) -> Written:
    """Write a block in this format, whole or not at all.

    path         a new file, or a new or empty folder; what stands there is never overwritten
    approximate  also where a camera in the format deviates from ours by more than 0.1 px
    free_scale   also a block whose scale nothing fixes, in a format that counts in metres
    raises       InputError where something stands at `path`, or the block cannot be written in this format
    """
    format_, path = format_named(name), Path(path)
    if format_.write is None:
        raise InputError("format.only_read", format=name, file=path)
    if format_.needs_frame and export.frame is None:
        raise InputError(
            "format.needs_crs",
            format=name,
            file=path,
        )
    check_free(path)
    check_ids_of(export.block, path)
    if export.block.free_scale and format_.metric and not free_scale:
        raise InputError("format.free_scale", format=name, file=path)
    remarks = (phrase("conversion.free_scale"),) if export.block.free_scale else ()
    if format_.kind == "folder":
        with new_folder(path) as folder:
            draft = format_.write(export, folder)
            check_deviation(draft.deviation_px, path, approximate=approximate, undistort=True)
            names = sorted(p.relative_to(folder) for p in folder.rglob("*") if p.is_file())
        files = tuple(path / n for n in names)
        return Written(files=files, remarks=(*remarks, *draft.remarks), deviation_px=draft.deviation_px)
    written = _write_files(format_.write, export, path, approximate=approximate)
    return replace(written, remarks=(*remarks, *written.remarks))


def check_deviation(deviation_px: float, path: Path, *, approximate: bool, undistort: bool = False) -> None:
    """Raise InputError where cameras deviate by more than 0.1 px from what they stand for and no one allowed it.

    undistort  whether photographs without distortion can be written instead
    """
    if not approximate and not deviation_px <= LIMIT_PX:
        raise InputError(
            "format.camera_deviation",
            deviation_px=deviation_px,
            limit_px=LIMIT_PX,
            undistort=undistort,
            file=path,
        )


def fitted_camera(fit: CameraFit, name: str, remarks: list[Message], deviations: list[float]) -> Camera:
    """The camera of a fit; a fit that is not exact is remarked on with its misfit, which is kept.

    name  of the camera in the file
    """
    if fit.deviation_px > EXACT_PX:
        remarks.append(
            note(
                "import.camera_fitted", camera=name, model=fit.camera.model, deviation_px=fit.deviation_px,
                covered=fit.covered, whole=fit.covered == 1,
            )
        )  # fmt: skip
        deviations.append(fit.deviation_px)
    return fit.camera


EXACT_PX = 1e-9
"""Of rounding."""


def _write_files(write: Writer, export: Export, path: Path, *, approximate: bool) -> Written:
    made: list[Path] = []
    make_parent(path)
    with new_files(path) as (temporary,):
        draft = write(export, temporary)
        check_deviation(draft.deviation_px, path, approximate=approximate, undistort=True)
        made = sorted(temporary.parent.iterdir())
        for file in made:
            check_new_file(path.parent / file.name)
        for file in made:
            if file.name != path.name:
                file.replace(path.parent / file.name)
    files = tuple(path.parent / f.name for f in made)
    return Written(files=files, remarks=draft.remarks, deviation_px=draft.deviation_px)


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """The oriented images, the known points and the observations between them, as writers need them."""

    cameras: tuple[Camera, ...]
    """One interior orientation each."""
    names: tuple[str, ...]
    """(n,) file names; ids where there are none or they repeat."""
    camera: Index
    """(n,) position in `cameras`."""
    rotation: Array
    """(n, 3, 3) object axes to image axes, as everywhere here."""
    centre: Array
    """(n, 3)"""
    source: Index
    """(n,) position of the image in the block."""
    points: Index
    """(p,) position of the point in the block."""
    xyz: Array
    """(p, 3)"""
    colours: Array
    """(p, 3) uint8"""
    image: Index
    """(m,) position of the observation's image in this scene; rows are sorted by it."""
    point: Index
    """(m,) position of the observation's point in this scene."""
    xy_px: Array
    """(m, 2)"""
    error_px: Array
    """(m,) distance between the observation and the projected point; NaN where it has no image."""
    remarks: tuple[str, ...] = field(default=())


def scene(export: Export) -> Scene:
    """The part of a block that a foreign format can take; raises InputError if no image is oriented."""
    block = export.block
    oriented: Mask = block.images.oriented
    known: Mask = np.all(np.isfinite(block.points.xyz), axis=1)
    if not oriented.any():
        raise InputError("block.no_oriented_image", block=block.name)
    used, camera_of = interiors(block)
    new_image, new_point = _positions(oriented), _positions(known)
    o = block.observations
    rows = np.flatnonzero(oriented[o.image] & known[o.point])
    rows = rows[np.argsort(new_image[o.image[rows]], kind="stable")]
    image, point = new_image[o.image[rows]], new_point[o.point[rows]]
    s = Scene(
        cameras=used,
        names=_names(block.images, oriented),
        camera=camera_of[oriented],
        rotation=block.images.rotation[oriented],
        centre=block.images.centre[oriented],
        source=np.flatnonzero(oriented),
        points=np.flatnonzero(known),
        xyz=block.points.xyz[known],
        colours=_colours(export.colours, known),
        image=image,
        point=point,
        xy_px=o.xy_px[rows],
        error_px=np.zeros(0),
        remarks=tuple(_left_out(block, oriented, known)),
    )
    return replace(s, error_px=_errors(s))


def _positions(kept: Mask) -> Index:
    return np.where(kept, np.cumsum(kept) - 1, -1)


def _colours(colours: Array | None, known: Mask) -> Array:
    if colours is None:
        return np.full((int(known.sum()), 3), GREY, np.uint8)
    return np.clip(np.rint(np.nan_to_num(np.asarray(colours, float), nan=GREY)), 0, 255).astype(np.uint8)[known]


def _names(images: Images, kept: Mask) -> tuple[str, ...]:
    files = [f or i for f, i in zip(images.file, images.ids, strict=True)]
    if len(set(files)) < len(files):
        files = list(images.ids)
    return tuple(files[k] for k in np.flatnonzero(kept).tolist())


def _left_out(block: Block, oriented: Mask, known: Mask) -> list[str]:
    remarks: list[str] = []
    if not oriented.all():
        ids = [block.images.ids[k] for k in np.flatnonzero(~oriented).tolist()]
        remarks.append(phrase("conversion.not_oriented", n=len(ids), total=len(oriented), names=ids))
    if not known.all():
        ids = [block.points.ids[k] for k in np.flatnonzero(~known).tolist()]
        remarks.append(phrase("conversion.no_coordinates", n=len(ids), total=len(known), names=ids))
    return remarks


def _errors(s: Scene) -> Array:
    error = np.full(len(s.image), np.nan)
    for k, camera in enumerate(s.cameras):
        rows = np.flatnonzero(s.camera[s.image] == k)
        if len(rows) == 0:
            continue
        at, model, values = s.image[rows], sensor_models[camera.model], parameter_vector(camera)
        local = np.einsum("nij,nj->in", s.rotation[at], s.xyz[s.point[rows]] - s.centre[at])
        measured = camera.image_from_pixel(s.xy_px[rows]).T
        try:
            image, _ = model.solve(local, values, measured)
        except (ProjectionDiverged, np.linalg.LinAlgError):
            continue
        error[rows] = np.linalg.norm(camera.pixel_from_image(image.T) - s.xy_px[rows], axis=1)
    return error


def cv_pose(s: Scene) -> tuple[Array, Array]:
    """Rotations (n, 3, 3) from object axes to computer vision's camera axes, and translations (n, 3)."""
    R = SENSOR_FROM_CV @ s.rotation
    return R, -np.einsum("nij,nj->ni", R, s.centre)


def deviation_remark(deviations: Sequence[tuple[str, str, float]]) -> tuple[tuple[str, ...], float]:
    """Remarks on fitted cameras (id, model, deviation in px), and the largest deviation."""
    remarks = tuple(
        phrase("conversion.camera_fitted", camera=id_, model=model, largest_px=d)
        for id_, model, d in deviations
        if d > 1e-9
    )
    return remarks, max((d for _, _, d in deviations), default=0.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Tracks:
    """Points and observations as a reader found them; positions are checked by `block_of`."""

    point_ids: tuple[str, ...]
    xyz: Array
    image: Index
    point: Index
    xy_px: Array


def block_of(
    *, name: str, source: str, cameras: tuple[Camera, ...], images: Images, tracks: Tracks
) -> tuple[Block, tuple[Message, ...]]:
    """A block of what a reader found, and remarks: doubled observations are left out, the sigma is assumed."""
    key = tracks.image.astype(np.int64) * max(1, len(tracks.point_ids)) + tracks.point
    _, first = np.unique(key, return_index=True)
    keep = np.sort(first)
    remarks: list[Message] = []
    if len(keep) < len(key):
        remarks.append(note("import.repeated_observations", n=len(key) - len(keep)))
    if len(keep):
        remarks.append(note("import.sigma_assumed", sigma_px=SIGMA_PX))
    count = len(tracks.point_ids)
    images = replace(images, ids=readable_names(images.ids), file=tuple(map(readable, images.file)))
    block = Block(
        name=name or "block",
        source=source,
        cameras=cameras,
        images=images,
        observations=Observations(
            image=tracks.image[keep].astype(np.int32),
            point=tracks.point[keep].astype(np.int32),
            xy_px=tracks.xy_px[keep],
            cov_px2=np.tile([SIGMA_PX**2, SIGMA_PX**2, 0.0], (len(keep), 1)),
        ),
        points=Points(
            ids=readable_names(tracks.point_ids),
            role=np.full(count, Role.TIE, np.int32),
            xyz=tracks.xyz,
            sigma=np.full((count, 3), np.nan),
        ),
    )
    return block, tuple(remarks)
