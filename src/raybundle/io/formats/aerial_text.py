"""What the text formats of aerial triangulation share: words in lines, numbered photographs and points, control.

Their image coordinates are those of BLOCK_FORMAT's image frame (origin at the image centre, x right, y up).  What they
have no place for stands beside in files of our own, which others need not read:

cameras.toml            the cameras, as everywhere here
raybundle-images.csv    number,image,camera
raybundle-points.csv    number,point,role,sX,sY,sZ
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import NoReturn

import numpy as np

from raybundle.block import ROLES, Camera, Images, Role
from raybundle.block.block import Distances, Stations
from raybundle.errors import InputError, Message, Value, content, note, phrase
from raybundle.io.block.toml import read_cameras
from raybundle.io.calibrations.ours import cameras_text
from raybundle.io.digits import EVERY
from raybundle.io.formats.base import Export, Import, Scene, Tracks, block_of
from raybundle.io.geo.control_files import DEFAULTS
from raybundle.io.ids import repeated
from raybundle.io.reading.files import read_lines
from raybundle.io.reading.words import no_number, number_of, quoted
from raybundle.io.tables import Column, Table, read_table, write_table
from raybundle.numerics.arrays import Array

CAMERAS, IMAGES, POINTS = "cameras.toml", "raybundle-images.csv", "raybundle-points.csv"
END = "-99"
METRES = {"m": 1.0, "mm": 0.001}
NOMINAL_PIXEL_MM = 0.005
LARGEST_MM = 1000.0
"""Image coordinates beyond are no millimetres."""


@dataclass(frozen=True, slots=True)
class Line:
    """The words of one line."""

    file: Path
    number: int
    words: tuple[str, ...]

    @property
    def name(self) -> str:
        """The first word."""
        return self.words[0]

    def fail(self, code: str | Message, /, column: str | None = None, **values: Value) -> NoReturn:
        """Raise at this line."""
        raise InputError(content(code, values), file=self.file, line=self.number, column=column)

    def values(self, first: int, columns: Sequence[str]) -> list[float]:
        """The finite numbers from word `first` on, which stand for these columns."""
        if len(self.words) < first + len(columns):
            self.fail("line.too_few_words", n=len(self.words), needed=first + len(columns), columns=list(columns))
        found: list[float] = []
        for word, column in zip(self.words[first:], columns, strict=False):
            value = number_of(word)
            if value is None:
                self.fail(no_number(word), column)
            found.append(value)
        return found


def lines(path: Path) -> Iterator[Line]:
    """The lines of a file that are not empty."""
    for at, text in read_lines(path):
        words = tuple(text.split())
        if words:
            if not text.replace("\t", " ").strip().isprintable():
                raise InputError("line.unprintable", file=path, line=at)
            yield Line(path, at, words)


@dataclass(frozen=True, slots=True, kw_only=True)
class Photograph:
    """One photograph of a file of image coordinates."""

    name: str
    camera: str
    c_mm: float | None
    """None: the file does not show it."""
    points: tuple[str, ...]
    xy_mm: Array
    """(k, 2)"""
    line: Line


@dataclass(frozen=True, slots=True, kw_only=True)
class Orientation:
    """An exterior orientation with its possible readings, the first the one that the format describes."""

    centre: Array
    rotations: tuple[Array, ...]
    """Rotations (3, 3) of object axes to image axes."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Contents:
    """All that a folder holds."""

    folder: Path
    name: str
    """Of the format."""
    photographs: Sequence[Photograph]
    orientations: Mapping[str, Orientation]
    xyz: Mapping[str, tuple[float, float, float]]
    """Coordinates of points; NaN where not known."""
    control: Mapping[str, tuple[float, float, float]]
    control_sigma: Mapping[str, tuple[float, float, float]] = field(
        default_factory=dict[str, tuple[float, float, float]]
    )
    """Standard deviations of control points, where the files show them."""
    readings: Sequence[str]
    """Names of the readings of an orientation; `import.orientation_convention` has the words."""


def numbered(ids: Sequence[str]) -> list[str]:
    """Numbers for names: the names themselves where all are whole numbers without leading zeros, else 1, 2, ..."""
    if all(i.isascii() and i.isdigit() and i[0] != "0" and len(i) <= 12 for i in ids):
        return list(ids)
    return [str(k + 1) for k in range(len(ids))]


def in_metres(export: Export, name: str) -> tuple[Export, tuple[str, ...]]:
    """The block in m with what belongs to its points and images, and a remark where its unit was another."""
    block = export.block
    if block.length_unit == "m":
        return export, ()
    metres = METRES[block.length_unit]
    images = replace(block.images, centre=block.images.centre * metres)
    points = replace(block.points, xyz=block.points.xyz * metres, sigma=block.points.sigma * metres)
    kept = replace(block, length_unit="m", images=images, points=points)
    scaled = replace(
        export,
        block=kept.having(Stations.empty(), Distances.empty()),  # these formats have no place for them
        sigma=None if export.sigma is None else export.sigma * metres,
        station_sigma=None if export.station_sigma is None else export.station_sigma * metres,
    )
    return scaled, (phrase("conversion.in_metres", unit=block.length_unit, format=name),)


def checked(s: Scene, name: str) -> None:
    """Refuse what has no image coordinates in a plane."""
    for camera in s.cameras:
        if camera.is_scene:
            raise InputError("camera.not_in_format", camera=camera.id, kind="scene", format=name)


def write_own(folder: Path, s: Scene, export: Export, photographs: Sequence[str], points: Sequence[str]) -> None:
    """Write the files that stand beside."""
    block = export.block
    cameras = [replace(c, interior="shared", per_image=()) for c in s.cameras]
    (folder / CAMERAS).write_text(cameras_text(cameras), encoding="utf-8")
    of_image = [s.cameras[k].id for k in s.camera.tolist()]
    write_table(folder / IMAGES, {"number": list(photographs), "image": list(s.names), "camera": of_image}, EVERY)
    kept = s.points.tolist()
    sigma = block.points.sigma[s.points]
    if len(kept) == 0:
        return
    write_table(
        folder / POINTS,
        {
            "number": list(points),
            "point": [block.points.ids[k] for k in kept],
            "role": [Role(int(block.points.role[k])).word for k in kept],
            **{n: sigma[:, k] for k, n in enumerate(("sX", "sY", "sZ"))},
        },
        EVERY,
    )


def image_mm(s: Scene) -> Array:
    """(m, 2) image coordinates of the observations of a scene [mm]."""
    xy = np.zeros((len(s.image), 2))
    for k, camera in enumerate(s.cameras):
        rows = np.flatnonzero(s.camera[s.image] == k)
        xy[rows] = camera.image_from_pixel(s.xy_px[rows])
    return xy


def assembled(contents: Contents) -> Import:
    """The block of a folder; raises InputError where its files do not fit together."""
    remarks: list[Message] = []
    own_images = _own(contents.folder / IMAGES, ("image", "camera"))
    own_points = _own_points(contents.folder / POINTS)
    cameras, camera_of = _cameras(contents, own_images, remarks)
    names = _image_names(contents, own_images)
    point_ids, tracks = _tracks(contents, cameras, camera_of, own_points)
    images = _images(contents, names, camera_of, cameras, tracks, remarks)
    ids = [own_points[0].get(p, p) for p in point_ids]
    if len(set(ids)) < len(ids):
        raise InputError("name.twice", kind="point", name=quoted(repeated(ids)), file=contents.folder / POINTS)
    block, more = block_of(
        name=contents.folder.name,
        source=contents.name,
        cameras=cameras,
        images=images,
        tracks=replace(tracks, point_ids=tuple(ids)),
    )
    role, sigma = _roles(contents, point_ids, own_points, remarks)
    block = replace(block, points=replace(block.points, role=role, sigma=np.where(role[:, None] > 0, sigma, np.nan)))
    return Import(block=block, remarks=(*remarks, *more))


def _own(path: Path, columns: tuple[str, ...]) -> dict[str, tuple[str, ...]]:
    """The other columns by the number."""
    if not path.is_file():
        return {}
    names = [Column(name=n, kind="id" if n == columns[0] else "text") for n in columns]
    table = read_table(path, (Column(name="number", kind="id"), *names), own=True)
    return dict(zip(table.text["number"], zip(*(table.text[n] for n in columns), strict=True), strict=True))


def _own_points(path: Path) -> tuple[dict[str, str], Table | None]:
    """Names by their numbers, and the table."""
    if not path.is_file():
        return {}, None
    sigmas = (Column(name=n, kind="number", empty=True, limit=">= 0") for n in ("sX", "sY", "sZ"))
    columns = (Column(name="number", kind="id"), Column(name="point", kind="id"), Column(name="role", kind="text"))
    table = read_table(path, (*columns, *sigmas), own=True)
    for k, role in enumerate(table.text["role"]):
        if role not in ROLES:
            raise InputError(
                "value.not_supported",
                value=quoted(role),
                known=list(ROLES),
                file=path,
                line=k + table.first_line,
                column="role",
            )
    return dict(zip(table.text["number"], table.text["point"], strict=True)), table


def _image_names(contents: Contents, own: Mapping[str, tuple[str, ...]]) -> list[str]:
    names = [own.get(p.name, (p.name,))[0] for p in contents.photographs]
    seen: set[str] = set()
    for name, p in zip(names, contents.photographs, strict=True):
        if name in seen:
            p.line.fail("name.twice", kind="image", name=quoted(p.name))
        seen.add(name)
    return names


def _cameras(
    contents: Contents, own: Mapping[str, tuple[str, ...]], remarks: list[Message]
) -> tuple[tuple[Camera, ...], list[int]]:
    """The cameras, and which of them took each photograph."""
    path = contents.folder / CAMERAS
    if path.is_file():
        cameras = read_cameras(path)
        position = {c.id: k for k, c in enumerate(cameras)}
        wanted = [own[p.name][1] if p.name in own else p.camera for p in contents.photographs]
        if len(cameras) == 1 and not any(w in position for w in wanted):
            return cameras, [0] * len(wanted)
        for w, p in zip(wanted, contents.photographs, strict=True):
            if w not in position:
                p.line.fail("reference.unknown", kind="camera", name=quoted(w), where=CAMERAS)
        return cameras, [position[w] for w in wanted]
    made: dict[str, Camera] = {}
    for p in contents.photographs:
        if p.camera not in made:
            made[p.camera] = _nominal(p, [q for q in contents.photographs if q.camera == p.camera])
    remarks.append(note("import.format_assumed", format=contents.name, pixel_mm=NOMINAL_PIXEL_MM, table=CAMERAS))
    order = list(made)
    return tuple(made.values()), [order.index(p.camera) for p in contents.photographs]


def _nominal(first: Photograph, photographs: Sequence[Photograph]) -> Camera:
    if first.c_mm is None:
        first.line.fail("camera.constant_unknown", camera=first.camera, table=CAMERAS)
    largest = np.max([np.abs(p.xy_mm).max(axis=0) for p in photographs if len(p.xy_mm)] or [[1.0, 1.0]], axis=0)
    width, height = (2 * max(1, math.ceil(v / NOMINAL_PIXEL_MM * 1.02)) for v in largest.tolist())
    values = dict.fromkeys(("x0", "y0", "K1", "K2", "K3", "P1", "P2", "A", "S"), 0.0)
    return Camera(
        id=first.camera,
        model="brown",
        width_px=width,
        height_px=height,
        pixel_mm=(NOMINAL_PIXEL_MM, NOMINAL_PIXEL_MM),
        values={"c": first.c_mm, **values},
        estimate="auto",
    )


def _tracks(
    contents: Contents,
    cameras: Sequence[Camera],
    camera_of: Sequence[int],
    own: tuple[dict[str, str], Table | None],
) -> tuple[list[str], Tracks]:
    position: dict[str, int] = {}
    # the order of our own table first, so that a block comes back as it was
    for number in (*own[0], *contents.control, *contents.xyz):
        position.setdefault(number, len(position))
    image: list[int] = []
    point: list[int] = []
    xy: list[Array] = [np.zeros((0, 2))]
    for k, p in enumerate(contents.photographs):
        image += [k] * len(p.points)
        point += [position.setdefault(q, len(position)) for q in p.points]
        xy.append(cameras[camera_of[k]].pixel_from_image(p.xy_mm.reshape(-1, 2)))
    ids = list(position)
    lacking = (math.nan, math.nan, math.nan)
    xyz = [contents.xyz.get(i, contents.control.get(i, lacking)) for i in ids]
    return ids, Tracks(
        point_ids=tuple(ids),
        xyz=np.array(xyz, float).reshape(-1, 3),
        image=np.array(image, np.int64),
        point=np.array(point, np.int64),
        xy_px=np.concatenate(xy),
    )


def _roles(
    contents: Contents, ids: Sequence[str], own: tuple[dict[str, str], Table | None], remarks: list[Message]
) -> tuple[Array, Array]:
    role = np.full(len(ids), Role.TIE, np.int32)
    sigma = np.full((len(ids), 3), np.nan)
    table = own[1]
    at = {} if table is None else {n: k for k, n in enumerate(table.text["number"])}
    given = np.zeros((0, 3)) if table is None else table.numbers("sX", "sY", "sZ")
    assumed = 0
    for k, number in enumerate(ids):
        row = at.get(number)
        if row is not None and table is not None:
            role[k], sigma[k] = ROLES[table.text["role"][row]], given[row]
        elif number in contents.control:
            known = np.isfinite(contents.control[number])
            role[k] = Role.CONTROL
            reported = contents.control_sigma.get(number)
            assumed += reported is None
            sigma[k] = np.where(known, reported or (DEFAULTS.plan, DEFAULTS.plan, DEFAULTS.height), np.nan)
    if assumed:
        remarks.append(note("import.control_sigma_assumed", n=assumed, plan_m=DEFAULTS.plan, height_m=DEFAULTS.height))
    return role, sigma


def _images(
    contents: Contents,
    names: Sequence[str],
    camera_of: Sequence[int],
    cameras: Sequence[Camera],
    tracks: Tracks,
    remarks: list[Message],
) -> Images:
    n = len(names)
    centre, rotation = np.full((n, 3), np.nan), np.full((n, 3, 3), np.nan)
    found = [contents.orientations.get(p.name) for p in contents.photographs]
    reading = _best_reading(contents, found, camera_of, cameras, tracks)
    if reading:
        remarks.append(note("import.orientation_convention", reading=contents.readings[reading]))
    for k, o in enumerate(found):
        if o is not None:
            centre[k], rotation[k] = o.centre, o.rotations[reading]
    unknown = [name for name, o in zip(names, found, strict=True) if o is None]
    if unknown:
        remarks.append(note("import.not_oriented", n=len(unknown), total=n))
    return Images(
        ids=tuple(names), camera=np.array(camera_of, np.int32), file=tuple(names), centre=centre, rotation=rotation
    )


def _best_reading(
    contents: Contents,
    found: Sequence[Orientation | None],
    camera_of: Sequence[int],
    cameras: Sequence[Camera],
    tracks: Tracks,
) -> int:
    """The reading with which central projection of the known points comes nearest to the image points."""
    misfit = np.zeros(len(contents.readings))
    for k, o in enumerate(found):
        rows = np.flatnonzero(tracks.image == k)
        rows = rows[np.isfinite(tracks.xyz[tracks.point[rows]]).all(axis=1)] if len(rows) else rows
        if o is None or len(rows) == 0:
            continue
        camera = cameras[camera_of[k]]
        xy = camera.image_from_pixel(tracks.xy_px[rows])
        for j, R in enumerate(o.rotations):
            with np.errstate(all="ignore"):
                local = (tracks.xyz[tracks.point[rows]] - o.centre) @ R.T
                gap = np.linalg.norm(-camera.values.get("c", 1.0) * local[:, :2] / local[:, 2:] - xy, axis=1)
            off = np.where((local[:, 2] < 0) & np.isfinite(gap), np.minimum(gap, LARGEST_MM), LARGEST_MM)
            misfit[j] += float(off.sum())
    best = int(np.argmin(misfit))
    # only a plain advantage changes what the format states
    return best if misfit[best] < 0.2 * misfit[0] else 0
