"""Control and check points from files: gcp_list.txt (OpenDroneMap), CSV, or the points of a block folder.

gcp_list.txt    first line the coordinate system, then  X Y Z x_px y_px image [name]  a line, separated by tabs or
                blanks; '#' begins a comment; pixels count from the outer corner of the first one
CSV             point,X,Y,Z[,sX,sY,sZ][,role][,radius][,nX,nY,nZ], and beside it or in a second file
                image,point,x_px,y_px; radius [m] of a round target, n a vector square to it
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

import numpy as np

from raybundle.block import ROLES, Role
from raybundle.block.frames import in_file_frames
from raybundle.errors import InputError, Text, message, note, phrase
from raybundle.io.geo.areas import check_area
from raybundle.io.geo.gcp_rows import GCP_COLUMNS, GcpRow, content_lines, gcp_rows
from raybundle.io.geo.parsed_systems import parse_crs
from raybundle.io.reading.dialects import header_of
from raybundle.io.reading.words import number_of, quoted
from raybundle.io.tables import SHOWN, Column, Problem, fail, read_table
from raybundle.numerics.arrays import Array, Index, Mask

XYZ, SIGMA, NORMAL = ("X", "Y", "Z"), ("sX", "sY", "sZ"), ("nX", "nY", "nZ")
COLUMNS = ("point", *XYZ, *SIGMA, "role", "radius", *NORMAL, "tolerance")
"""Of a table of control"""
CHANCE = 0.01
"""Probability below which heights that agree to the last digit are not taken for measured."""
MEASUREMENTS = "measurements"
"""What a second CSV is called if it lies beside the first: NAME-measurements.csv."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Measurements:
    """Image measurements of control and check points, one row each."""

    image: tuple[str, ...]
    """(m,) names as they stand in the file."""
    point: Index
    """(m,) position in `ControlFile.ids`."""
    xy_px: Array
    """(m, 2) pixel frame of BLOCK_FORMAT; NaN nowhere."""
    line: Index
    """(m,) line of the file, for messages."""
    covariance: Array | None = None
    """(m, 3) variances of x and y and covariance [px^2]; NaN, None: as of all points marked by hand"""
    radius_px: Array | None = None
    """(m,) mean radius of the image of a round target; NaN, None: not known"""

    def __len__(self) -> int:
        return len(self.image)

    @property
    def covariances(self) -> Array:
        """(m, 3), NaN where not known."""
        return np.full((len(self), 3), np.nan) if self.covariance is None else self.covariance

    @property
    def radii_px(self) -> Array:
        """(m,), NaN where not known."""
        return np.full(len(self), np.nan) if self.radius_px is None else self.radius_px

    def rows(self, rows: Index) -> Measurements:
        """Some of them."""
        return Measurements(
            image=tuple(self.image[k] for k in rows), point=self.point[rows], xy_px=self.xy_px[rows],
            line=self.line[rows], covariance=self.covariances[rows], radius_px=self.radii_px[rows],
        )  # fmt: skip

    def and_(self, others: Measurements) -> Measurements:
        """Both."""
        return Measurements(
            image=(*self.image, *others.image), point=np.concatenate([self.point, others.point]),
            xy_px=np.vstack([self.xy_px, others.xy_px]), line=np.concatenate([self.line, others.line]),
            covariance=np.vstack([self.covariances, others.covariances]),
            radius_px=np.concatenate([self.radii_px, others.radii_px]),
        )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlFile:
    """What a file states about control and check points."""

    path: Path
    crs: str | None
    """Coordinate system as the file names it; None where it names none."""
    ids: tuple[str, ...]
    xyz: Array
    """(n, 3) in that system, x east or longitude; NaN where not known."""
    sigma: Array
    """(n, 3) 0 = held; NaN where the coordinate is not known; assumed ones in metres, others see `stated`."""
    role: Index
    """(n,) `Role`; CONTROL unless the file states otherwise."""
    measurements: Measurements
    remarks: tuple[str, ...] = ()
    """What was assumed."""
    radius: Array | None = None
    """(n,) of round targets, whose measured centres are those of ellipses [m]; NaN: no round target."""
    normal: Array | None = None
    """(n, 3) unit vectors square to round targets, in the axes of the coordinates; NaN: not known."""
    stated: Mask | None = None
    """(n,) whose standard deviations in plan stand in the file; None: of no point"""
    reported: Mask | None = None
    """(n, 3) whose standard deviation stands in the file, in the unit of its coordinates; None: all are in metres"""
    stem: str = ""
    """What names that were made for points without any begin with; empty where they are the file's"""


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlDefaults:
    """Standard deviations where a file shows none: of coordinates in a system of the earth, in metres."""

    plan: float = 0.01
    height: float = 0.02
    unit: str = ""
    """of the two, for remarks; empty: not stated"""
    role: Literal["control", "check"] = "control"


DEFAULTS = ControlDefaults()


def read_control(
    path: str | Path, *, measurements: str | Path | None = None, defaults: ControlDefaults = DEFAULTS
) -> ControlFile:
    """Control and check points of a file.

    path          gcp_list.txt, a CSV file, or a block folder (its points.csv and observations.csv); a CSV of image
                  measurements alone: points of which nothing is given, the ends of a scale bar
    measurements  a CSV of image measurements; None: NAME-measurements.csv beside a CSV, if there is one
    raises        InputError with file, line and column
    Limits: whether the images exist; names are as they stand there.
    """
    path = Path(path)
    if path.is_dir():
        return _read_block_points(path, defaults)
    if _is_table(path):
        if measurements is None and _are_marks(path):
            return _marks_alone(path)
        return _read_csv(path, None if measurements is None else Path(measurements), defaults)
    if measurements is not None:
        raise InputError("control.own_measurements", measurements=str(measurements), file=path)
    return read_gcp_list(path, defaults=defaults)


def read_gcp_list(path: str | Path, *, defaults: ControlDefaults = DEFAULTS) -> ControlFile:
    """A gcp_list.txt: lines with the same name are one point; without names, lines with the same X Y Z.

    Heights that are 0 throughout, or all the same, are taken as unknown, and a remark states it.
    """
    path = Path(path)
    lines = content_lines(path)
    first, crs = next(lines, (0, ""))
    if not crs:
        raise InputError("gcp_list.empty", file=path, line=1)
    if len(crs.split()) >= len(GCP_COLUMNS) and number_of(crs.split()[0]) is not None:
        raise InputError("gcp_list.no_system", file=path, line=first)
    try:
        parse_crs(crs)
    except InputError as error:
        details = [] if error.message is None else [error.message]
        raise InputError("gcp_list.no_system", details=details, file=path, line=first) from None
    rows, problems = gcp_rows(lines)
    if problems:
        fail(path, problems)
    if not rows:
        raise InputError("gcp_list.no_point", file=path, line=first)
    result = _grouped(path, crs, rows, defaults)
    beyond = check_area(crs, np.array([r.xyz[:2] for r in rows]), path, lines=result.measurements.line)
    result = replace(result, remarks=(*result.remarks, *beyond))
    return _with_unknown_heights(result, np.zeros(len(result.ids), bool))


def _grouped(path: Path, crs: str, rows: Sequence[GcpRow], defaults: ControlDefaults) -> ControlFile:
    named = [bool(r.name) for r in rows]
    if any(named) and not all(named):
        row = rows[named.index(False)]
        raise InputError("gcp_list.name_missing", file=path, line=row.line, column="name")
    points: dict[object, int] = {}
    first: list[GcpRow] = []
    index: list[int] = []
    problems: list[Problem] = []
    seen: dict[tuple[int, str], int] = {}
    for row in rows:
        key: object = row.name or repr(row.xyz)
        k = points.setdefault(key, len(points))
        if k == len(first):
            first.append(row)
        elif not np.array_equal(first[k].xyz, row.xyz, equal_nan=True):
            blanks = max(row.columns, first[k].columns) > len(GCP_COLUMNS) + 1
            differs = message(
                "gcp_list.coordinates_differ", point=row.name, image=row.image, earlier=first[k].line, blanks=blanks
            )
            problems.append(Problem(row.line, "X", differs))
        if (k, row.image) in seen:
            again = message("table.pair_twice", names=["image", "name"], earlier=seen[k, row.image], rows=False)
            problems.append(Problem(row.line, "image", again))
        seen[k, row.image] = row.line
        index.append(k)
    if problems:
        fail(path, problems)
    xyz = np.array([r.xyz for r in first])
    stem = "check" if defaults.role == "check" else "gcp"  # files of both may come without names
    return ControlFile(
        path=path,
        crs=crs,
        ids=tuple(r.name or f"{stem}{k:02d}" for k, r in enumerate(first)),
        xyz=xyz,
        sigma=_default_sigma(xyz, defaults),
        role=np.full(len(first), ROLES[defaults.role], np.int32),
        measurements=Measurements(
            image=tuple(r.image for r in rows),
            point=np.array(index, np.int32),
            xy_px=np.array([r.xy for r in rows]),
            line=np.array([r.line for r in rows], np.int32),
        ),
        remarks=(*(() if any(named) else (_nameless(stem, 0),)), *_behind_names(path, rows)),
        stem="" if any(named) else stem,
    )


def _behind_names(path: Path, rows: Sequence[GcpRow]) -> tuple[str, ...]:
    """Remark on words behind the names of points: columns of a program, or names with blanks."""
    more = [r for r in rows if r.rest]
    if not more:
        return ()
    unread = note(
        "control_file.words_behind_names", name=path.name, n=len(more), words=quoted(more[0].rest),
        point=quoted(more[0].name), line_number=more[0].line,
    )  # fmt: skip
    return (Text.of(unread),)


def _nameless(stem: str, first: int) -> str:
    names = [f"{stem}{first + k:02d}" for k in range(2)]
    return Text.of(note("control_file.no_names", names=names))


def named_apart(files: Sequence[ControlFile]) -> tuple[ControlFile, ...]:
    """The files, of which those without names have names that no other file has: made ones count on."""
    taken = {name for f in files if not f.stem for name in f.ids}
    found: list[ControlFile] = []
    for f in files:
        first = 0
        while f.stem and taken & {f"{f.stem}{first + k:02d}" for k in range(len(f.ids))}:
            first += 1
        if first:
            remarks = tuple(_nameless(f.stem, first) if r == _nameless(f.stem, 0) else r for r in f.remarks)
            f = replace(f, ids=tuple(f"{f.stem}{first + k:02d}" for k in range(len(f.ids))), remarks=remarks)  # noqa: PLW2901
        taken.update(f.ids)
        found.append(f)
    return tuple(found)


def assumed_words(defaults: ControlDefaults) -> str:
    """What is stated of coordinates whose file states no standard deviation."""
    unit = defaults.unit or "none"
    return phrase("control_file.sigma_assumed", plan=defaults.plan, height=defaults.height, unit=unit)


def _default_sigma(xyz: Array, defaults: ControlDefaults) -> Array:
    sigma = np.tile([defaults.plan, defaults.plan, defaults.height], (len(xyz), 1))
    return np.where(np.isfinite(xyz), sigma, np.nan)


def _with_unknown_heights(control: ControlFile, stated: Mask) -> ControlFile:
    """Control whose heights are believed: a column of equal heights beside points that differ is no measurement.

    stated  (n,) heights whose standard deviation stands in the file: they are believed, whatever they are
    Heights that are exactly 0 at all of several points are what programs write where nothing is known.  Others that are
    equal: of level ground, heights measured with the standard deviation s and written in steps of d agree to the last
    digit by chance with the probability (d / (2 sqrt(pi) s))^(n - 1), the density of a difference of two at 0 times the
    step; below CHANCE that is not believed.
    """
    z = control.xyz[:, 2]
    asked = np.isfinite(z) & ~stated
    heights, n = z[asked], int(asked.sum())
    if n < 2 or np.ptp(heights) > 0 or not np.ptp(control.xyz[asked, :2], axis=0).any():
        return control
    if heights[0] != 0:
        step = 10.0 ** -len(repr(float(heights[0])).partition(".")[2].rstrip("0"))
        s = float(np.max(control.sigma[asked, 2]))
        chance = min(1.0, step / (2 * math.sqrt(math.pi) * s)) ** (n - 1) if s > 0 else 1.0
        if chance >= CHANCE:
            return control
    unknown = np.where(asked, np.nan, 1.0)
    xyz, sigma = control.xyz.copy(), control.sigma.copy()
    xyz[:, 2] *= unknown
    sigma[:, 2] *= unknown
    equal = note("control_file.heights_unknown", name=control.path.name, n=n, height=float(heights[0]))
    return replace(control, xyz=xyz, sigma=sigma, remarks=(*control.remarks, Text.of(equal)))


def _read_csv(path: Path, measurements: Path | None, defaults: ControlDefaults) -> ControlFile:
    table = read_table(
        path,
        (
            Column(name="point", kind="id"),
            *(Column(name=n, kind="number", empty=True) for n in XYZ),
            *(Column(name=n, kind="number", empty=True, optional=True, limit=">= 0") for n in SIGMA),
            Column(name="role", kind="text", optional=True, empty=True),
            Column(name="radius", kind="number", empty=True, optional=True, limit="> 0"),
            *(Column(name=n, kind="number", empty=True, optional=True) for n in NORMAL),
            Column(name="tolerance", kind="text", empty=True, optional=True),
        ),
    )
    ids, xyz, sigma = table.text["point"], table.numbers(*XYZ), table.numbers(*SIGMA)
    roles = table.text.get("role", ("",) * len(ids))
    known = {"": ROLES[defaults.role], **ROLES}
    problems = [
        Problem(k + table.first_line, "role", message("value.not_supported", value=quoted(r), known=list(ROLES)))
        for k, r in enumerate(roles)
        if r not in known
    ]
    bare = np.isfinite(sigma) & ~np.isfinite(xyz)
    problems += [
        Problem(
            int(k) + table.first_line,
            SIGMA[a],
            message("point.sigma_without_coordinate", point=ids[k], sigma=SIGMA[a], coordinate=XYZ[a]),
        )
        for k, a in np.argwhere(bare)
    ]
    empty = np.flatnonzero(~np.isfinite(xyz).any(axis=1))
    problems += [
        Problem(int(k) + table.first_line, "X", message("control.no_coordinate", point=ids[k]))
        for k in empty
        if known.get(roles[k]) != Role.TIE
    ]
    normal = table.numbers(*NORMAL)
    length = np.linalg.norm(normal, axis=1)
    problems += [
        Problem(
            int(k) + table.first_line,
            NORMAL[0],
            message("control.normal", point=ids[k]),
        )
        for k in np.flatnonzero(np.isfinite(normal).any(axis=1) & ~(length > 0))
    ]
    if problems:
        fail(path, problems[: SHOWN + 1])
    given = np.isfinite(sigma)
    remarks: tuple[str, ...] = ()
    if (np.isfinite(xyz) & ~given).any():
        remarks = (assumed_words(defaults),)
    if any(table.text.get("tolerance", ())):  # people have one file for both
        remarks = (*remarks, phrase("control_file.tolerance_unused"))
    beside = path.with_name(f"{path.stem}-{MEASUREMENTS}.csv")
    file = measurements or (beside if beside.is_file() else None)
    control = ControlFile(
        path=path,
        crs=None,
        ids=ids,
        xyz=xyz,
        sigma=np.where(given, sigma, _default_sigma(xyz, defaults)),
        role=np.array([known[r] for r in roles], np.int32),
        measurements=_no_measurements() if file is None else read_measurements(file, ids, str(path)),
        remarks=remarks,
        radius=table.numbers("radius")[:, 0],
        normal=normal / np.where(length > 0, length, np.nan)[:, None],
        stated=np.asarray(given[:, :2].any(axis=1), bool),
        reported=given,
    )
    return _with_unknown_heights(control, given[:, 2])


def _is_table(path: Path) -> bool:
    """Whether a file is a table of points or marks: by its ending, or by its header, as spreadsheets save text."""
    if path.suffix.lower() == ".csv":
        return True
    names = set(header_of(path))
    return {"point", *XYZ[:2]} <= names or {"image", "point", "x_px", "y_px"} <= names


def _are_marks(path: Path) -> bool:
    """Whether a CSV is one of image measurements, without coordinates."""
    return {"image", "point", "x_px", "y_px"} <= set(header_of(path))


def _marks_alone(path: Path) -> ControlFile:
    """Points that are only marked, as they appear."""
    named: dict[str, int] = {}
    read_table(
        path,
        (
            Column(name="image", kind="text"),
            Column(name="point", kind="new_reference", known=named),
            *(Column(name=n, kind="number") for n in ("x_px", "y_px")),
        ),
    )
    nothing = np.full((len(named), 3), np.nan)
    return ControlFile(
        path=path, crs=None, ids=tuple(named), xyz=nothing, sigma=nothing.copy(),
        role=np.full(len(named), Role.TIE, np.int32), measurements=read_measurements(path, tuple(named), path.name),
    )  # fmt: skip


def _no_measurements() -> Measurements:
    none = np.zeros(0, np.int32)
    return Measurements(image=(), point=none, xy_px=np.zeros((0, 2)), line=none)


def read_measurements(path: str | Path, ids: Sequence[str], where: str) -> Measurements:
    """The image measurements `image,point,x_px,y_px` of a CSV file.

    ids     names of the points that it may refer to; where: the file that holds them, for the message
    raises  InputError with line and column, also where a point stands twice in an image
    """
    images: dict[str, int] = {}
    table = read_table(
        Path(path),
        (
            Column(name="image", kind="new_reference", known=images),
            Column(name="point", kind="reference", known={p: k for k, p in enumerate(ids)}, where=where),
            Column(name="x_px", kind="number"),
            Column(name="y_px", kind="number"),
        ),
        unique=("image", "point"),
    )
    names = list(images)
    return Measurements(
        image=tuple(names[k] for k in table.index["image"].tolist()),
        point=table.index["point"],
        xy_px=table.numbers("x_px", "y_px"),
        line=np.arange(table.rows, dtype=np.int32) + table.first_line,
    )


def _read_block_points(folder: Path, defaults: ControlDefaults) -> ControlFile:
    """Control and check points of a block folder, with their image observations."""
    from raybundle.io.block.folder import read_block

    del defaults  # a block states everything
    block = in_file_frames(read_block(folder))
    named = np.flatnonzero(block.points.role != Role.TIE)
    if len(named) == 0:
        raise InputError("control.none_in_block", file=folder / "points.csv")
    position = np.full(len(block.points), -1, np.int32)
    position[named] = np.arange(len(named))
    o = block.observations
    rows = np.flatnonzero(position[o.point] >= 0)
    files = [f or i for f, i in zip(block.images.file, block.images.ids, strict=True)]
    return ControlFile(
        path=folder,
        crs=None,
        ids=tuple(block.points.ids[k] for k in named.tolist()),
        xyz=block.points.xyz[named],
        sigma=block.points.sigma[named],
        role=np.asarray(block.points.role)[named],
        measurements=Measurements(
            image=tuple(files[k] for k in o.image[rows].tolist()),
            point=position[o.point[rows]],
            xy_px=o.xy_px[rows],
            line=rows.astype(np.int32) + 2,
        ),
        stated=np.ones(len(named), bool),
    )
