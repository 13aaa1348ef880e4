"""What a file of positions and attitudes states, and how it goes into a block."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path, PurePosixPath

import numpy as np

from raybundle.block import Stations
from raybundle.errors import InputError
from raybundle.io.folders import check_free, make_parent, new_files
from raybundle.io.geo.areas import check_area
from raybundle.io.geo.coordinate_systems import LocalFrame, local_frame
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.io.ids import check_ids
from raybundle.io.reading.files import as_utf8, guarded, opened
from raybundle.io.reading.ledger import ledger, not_read
from raybundle.io.reading.words import whole_of
from raybundle.numerics.arrays import Array, Index, Mask
from raybundle.numerics.natural import natural

WGS84_HEIGHT = "EPSG:4979"
"""Longitude, latitude and height above the ellipsoid of WGS 84."""
WEEK_S = 604_800.0
NUMBER = re.compile(r"(?<!\d)\d{3,6}(?!\d)")
"""Running numbers of photographs in the names that cameras give: DJI_20240501101530_0012_V.JPG."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Reading:
    """One of the conventions in which the angles or the matrices of a file can be read."""

    name: str
    """Convention and unit as the setting `attitudes` takes them: opk-gon, pok-deg, matrix, matrix-inverse"""
    convention: str
    """opk | pok"""
    angles: Array
    """(n, 3) in the order of the convention [rad]; NaN where not known"""
    rotation: Array
    """(n, 3, 3) object axes to image axes"""
    sigma: Array | None = None
    """(n, 3) standard deviations of the angles [rad]"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Trajectory:
    """Positions and attitudes at exposures."""

    path: Path
    names: tuple[str, ...]
    """(n,) of the photographs, as the file has them; running numbers where `numbered`."""
    xyz: Array
    """(n, 3) x east or longitude [deg], y north or latitude, z height; NaN where not known."""
    sigma: Array
    """(n, 3) standard deviations east, north, up [m]; NaN where not stated."""
    correlation: Array | None = None
    """(n, 3) correlation coefficients of east with north, east with up, north with up; None: not stated."""
    crs: str | None = None
    """Coordinate system; None where the file does not show."""
    numbered: bool = False
    """Whether the names are numbers of photographs in the order of their exposure."""
    ordered: bool = False
    """Whether rows belong to photographs by their order alone: one for each, in the natural order of names."""
    rotation: Array | None = None
    """(n, 3, 3) object axes to image axes; NaN where not known.  None: the file has no attitudes."""
    rotation_sigma: Array | None = None
    """(n, 3) standard deviations of the three angles of the file, in its order [rad]."""
    convention: str = ""
    """Of the angles in the file: "opk", "pok", "rpy-ned" or "gimbal"; empty without attitudes."""
    angles: Array | None = None
    """(n, 3) the angles as the file has them, in the order of its convention [rad]."""
    readings: tuple[Reading, ...] = ()
    """Readings that the photographs choose from, the first where all fit alike; `rotation` is None where the file does
    not prefer one."""
    undecided: str = ""
    """Columns that have several readings."""
    true_north: bool = False
    """Whether the object axes of the attitudes are east, north, up at each position and not those of the grid."""
    time: Array | None = None
    """(n,) GPS time [s]: week times 604 800 plus second of the week where the week is known."""
    offset: Array | None = None
    """(n, 3) from the antenna's phase centre to the camera, east, north, up [m]; already applied to `xyz`."""
    fix: tuple[str, ...] = ()
    """(n,) "rtk fixed", "rtk float", "single", "none" or ""."""
    remarks: tuple[str, ...] = ()
    """What was assumed or left out."""
    lines: Index = field(default_factory=lambda: np.zeros(0, np.int32))
    """(n,) line of the file, for messages."""

    def __len__(self) -> int:
        return len(self.names)


Reader = Callable[[Path], Trajectory]
Writer = Callable[[Trajectory, Path], None]


@dataclass(frozen=True, slots=True, kw_only=True)
class TrajectoryFormat:
    """A format of positions and attitudes."""

    name: str
    title: str
    read: Reader
    recognises: Callable[[str, str], bool]
    """Whether the beginning of a file with this suffix (lower case, with its point) is of the format."""
    write: Writer | None = None
    """None: it is only read"""


trajectory_formats: dict[str, TrajectoryFormat] = {}


def register(format_: TrajectoryFormat) -> TrajectoryFormat:
    """Make a format known under its name."""
    trajectory_formats[format_.name] = format_
    return format_


def read_trajectory(path: str | Path, *, name: str | None = None) -> Trajectory:
    """Positions and attitudes of a file; the format by its contents unless stated.

    raises  InputError with file, line and column
    """
    path = Path(path)
    if name is not None:
        return _read(_named(name), path)
    with opened(path) as file:
        head = as_utf8(file.read(4096), whole=False).decode("utf-8", errors="replace")
    for format_ in trajectory_formats.values():
        if format_.recognises(head, path.suffix.lower()):
            return _read(format_, path)
    raise InputError(
        "trajectory.format_unknown", known=list(trajectory_formats),
        file=path, line=1,
    )  # fmt: skip


def _read(format_: TrajectoryFormat, path: Path) -> Trajectory:
    with guarded(path), ledger() as passed_over:
        found = format_.read(path)
        remarks = not_read(passed_over.counts())
    beyond = () if found.crs is None else check_area(found.crs, found.xyz[:, :2], found.path, lines=found.lines)
    return replace(found, remarks=(*found.remarks, *remarks, *beyond))


def write_trajectory(trajectory: Trajectory, path: str | Path, *, name: str) -> None:
    """Write a new file in a format; raises InputError where something stands there, or what it needs is not known."""
    path = Path(path)
    write = _named(name).write
    if write is None:
        raise InputError("format.only_read", format=name, file=path)
    check_free(path)
    check_ids("position", trajectory.names, path)
    make_parent(path)
    with new_files(path) as (file,):
        write(trajectory, file)


def _named(name: str) -> TrajectoryFormat:
    if name not in trajectory_formats:
        raise InputError("format.unknown", format=name, known=list(trajectory_formats))
    return trajectory_formats[name]


def matched(trajectory: Trajectory, files: Sequence[str]) -> Index:
    """(k,) the row of the trajectory for each file of a photograph; -1 where it has none.

    By name, with or without its suffix; where the file has numbers alone, by the last number of three to six digits in
    the photograph's name.
    raises  InputError where one row belongs to two photographs, or rows without names are not one for each
    """
    if trajectory.ordered:
        if len(files) != len(trajectory):
            raise InputError(
                "trajectory.count_differs",
                positions=len(trajectory),
                photographs=len(files),
                file=trajectory.path,
            )
        rank = sorted(range(len(files)), key=lambda k: natural(files[k]))
        return np.argsort(np.array(rank, np.int32)).astype(np.int32)
    if trajectory.numbered:
        rows = {int(n): k for k, n in enumerate(trajectory.names)}
        found = [rows.get(_number(f), -1) for f in files]
    else:
        rows_by_name = {_stem(n): k for k, n in enumerate(trajectory.names)}
        found = [rows_by_name.get(_stem(f), -1) for f in files]
    taken: dict[int, str] = {}
    for row, file in zip(found, files, strict=True):
        if row >= 0 and row in taken:
            raise InputError(
                "trajectory.position_twice",
                name=trajectory.names[row],
                first=taken[row],
                second=file,
                file=trajectory.path,
                line=int(trajectory.lines[row]) if len(trajectory.lines) else None,
            )
        taken[row] = file
    return np.array(found, np.int32)


def _number(file: str) -> int:
    found = NUMBER.findall(PurePosixPath(file.replace("\\", "/")).stem)
    number = whole_of(found[-1]) if found else None
    return -1 if number is None else number


def _stem(name: str) -> str:
    path = PurePosixPath(name.replace("\\", "/"))
    return path.stem.lower()


def stations_of(
    trajectory: Trajectory,
    files: Sequence[str],
    frame: LocalFrame | None,
    *,
    default_sigma: tuple[float, float, float] = (5.0, 5.0, 10.0),
) -> Stations:
    """Observed projection centres for the images of a block, by the files of its photographs.

    frame          the local frame of the block; None: the block stands in the trajectory's system
    default_sigma  [m] where the file has none
    raises         InputError where positions are geographic and there is no frame, or no photograph is in the file
    Positions of another system than the frame's are transformed; those of a file without a system are in the frame's.
    """
    rows = matched(trajectory, files)
    images = np.flatnonzero(rows >= 0)
    images = images[np.isfinite(trajectory.xyz[rows[images], :2]).all(axis=1)]
    if len(images) == 0:
        raise InputError(
            "trajectory.no_photograph_found",
            n=len(files),
            photograph=files[0] if files else "-",
            name=trajectory.names[0] if trajectory.names else "-",
            file=trajectory.path,
        )
    if frame is None and trajectory.crs is not None and parse_crs(trajectory.crs).is_geographic:
        raise InputError(
            "trajectory.needs_local_frame",
            file=trajectory.path,
        )
    xyz = _in_system_of(frame, trajectory).xyz[rows[images]]
    sigma = trajectory.sigma[rows[images]]
    correlation = None if trajectory.correlation is None else np.nan_to_num(trajectory.correlation[rows[images]])
    return Stations(
        image=images.astype(np.int32),
        xyz=xyz if frame is None else frame.local_from_crs(xyz),
        sigma=np.where(np.isfinite(xyz), np.where(sigma > 0, sigma, default_sigma), np.nan),
        correlation=correlation,
    )


def decided(trajectory: Trajectory, name: str) -> Trajectory:
    """The trajectory with its attitudes in one of its readings, by the name of that."""
    found = next(r for r in trajectory.readings if r.name == name)
    return replace(
        trajectory, rotation=found.rotation, rotation_sigma=found.sigma, convention=found.convention,
        angles=found.angles, readings=(),
    )  # fmt: skip


def no_attitudes(trajectory: Trajectory, path: Path) -> InputError:
    """Why a trajectory has no rotations: its file has none, or has several readings of them."""
    if not trajectory.readings:
        return InputError("trajectory.no_attitudes", file=path)
    return InputError(
        "trajectory.undecided", readings=[r.name for r in trajectory.readings], first=trajectory.readings[0].name,
        file=trajectory.path, column=trajectory.undecided,
    )  # fmt: skip


def in_wgs84(trajectory: Trajectory, crs: str | None) -> Trajectory:
    """The trajectory in longitude, latitude and ellipsoidal height, its attitudes against true north.

    crs     the system of positions whose file shows none
    raises  InputError where neither shows a system
    Standard deviations along the grid are taken for those along east and north.
    """
    crs = trajectory.crs or crs
    if crs is None:
        raise InputError(
            "trajectory.no_crs",
            file=trajectory.path,
        )
    if crs == WGS84_HEIGHT:
        return trajectory
    beyond = () if trajectory.crs else check_area(crs, trajectory.xyz[:, :2], trajectory.path, lines=trajectory.lines)
    known: Mask = np.asarray(np.isfinite(trajectory.xyz[:, :2]).all(axis=1), bool)
    place = trajectory.xyz[known]
    frame = frame_at(crs, trajectory, known)
    xyz = np.full_like(trajectory.xyz, np.nan)
    height = np.isfinite(place[:, 2])
    filled = np.where(height[:, None] | [True, True, False], place, frame.origin[2])
    xyz[known] = frame.wgs84_from_local(frame.local_from_crs(filled))
    xyz[np.flatnonzero(known)[~height], 2] = np.nan
    rotation = trajectory.rotation
    if rotation is not None and not trajectory.true_north:
        turned = np.full_like(rotation, np.nan)
        turned[known] = rotation[known] @ frame.crs_from_local_rotation(filled) @ frame.local_from_enu(filled)
        rotation = turned
    return replace(
        trajectory, xyz=xyz, crs=WGS84_HEIGHT, rotation=rotation, true_north=rotation is not None,
        remarks=(*trajectory.remarks, *beyond, *frame.remarks),
    )  # fmt: skip


def _in_system_of(frame: LocalFrame | None, trajectory: Trajectory) -> Trajectory:
    """The trajectory with positions in the system of the frame, and attitudes that `rotations_in` turns from there."""
    own = trajectory.crs
    if frame is None or own is None or own == frame.crs:
        return trajectory
    if parse_crs(own).equals(parse_crs(frame.crs), ignore_axis_order=True):
        return trajectory
    there = in_wgs84(trajectory, None)
    xyz = np.full_like(there.xyz, np.nan)
    known = np.isfinite(there.xyz[:, :2]).all(axis=1)
    xyz[known] = frame.crs_from_local(frame.local_from_wgs84(there.xyz[known]))
    return replace(there, xyz=xyz, crs=frame.crs)


def frame_at(crs: str, trajectory: Trajectory, rows: Mask | Index) -> LocalFrame:
    """The local frame in a system at the mean of some positions in it; raises InputError where there are none."""
    place = trajectory.xyz[rows]
    place = place[np.isfinite(place[:, :2]).all(axis=1)]
    if not len(place):
        raise InputError("trajectory.no_position", file=trajectory.path)
    heights = place[np.isfinite(place[:, 2]), 2]
    return local_frame(crs, (*place[:, :2].mean(axis=0), heights.mean() if len(heights) else np.nan))


def rotations_in(trajectory: Trajectory, frame: LocalFrame | None) -> Array:
    """(n, 3, 3) rotations from the axes of a block to the image axes; NaN where not known.

    Attitudes against true north are turned from east, north, up at each position to the frame's axes (the convergence
    of meridians); those against the grid by the rotation of the grid.
    raises  InputError where the file has no attitudes, or true north needs a frame
    """
    if trajectory.rotation is None:
        raise no_attitudes(trajectory, trajectory.path)
    if frame is None:
        if trajectory.true_north and trajectory.crs != WGS84_HEIGHT:
            raise InputError("trajectory.north_needs_frame", file=trajectory.path)
        return trajectory.rotation
    trajectory = _in_system_of(frame, trajectory)
    assert trajectory.rotation is not None
    turn = (
        np.swapaxes(frame.local_from_enu(trajectory.xyz), -1, -2)
        if trajectory.true_north
        else frame.crs_from_local_rotation(trajectory.xyz)
    )
    return trajectory.rotation @ turn
