"""Control of a scene: points with their places on the ground and in images, from CSV, GeoJSON, GeoPackage and lists.

CSV             point,lon_deg,lat_deg,h_m,x_px,y_px[,sE_m,sN_m,sU_m][,image][,role]; or point,X,Y,Z with x_px,y_px in
                the same table; or control as `orient` takes it, whose image points stand in a second table
GeoJSON, what   points whose attributes are point (or id, name), x_px, y_px [, image][, role][, sX, sY, sZ]; or only a
OGR reads       name, with the image points in a second table
gcp_list.txt    as `orient` takes it

Coordinates are brought to longitude, latitude and height above the ellipsoid in WGS 84, through their own datum and
geoid.  Pixels count from the outer corner of the first one; the attribute `ji` of orthority from its centre.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.block import Role
from raybundle.errors import InputError, Text, note
from raybundle.io.geo.control_files import (
    COLUMNS,
    DEFAULTS,
    ControlFile,
    assumed_words,
    read_control,
    read_measurements,
)
from raybundle.io.geo.coordinate_systems import WGS84, LocalFrame, height_remarks, local_frame, parse_crs
from raybundle.io.reading.dialects import header_of
from raybundle.io.reading.files import check_regular
from raybundle.io.reading.trees import Json, read_json
from raybundle.io.reading.words import number_of, quoted
from raybundle.io.scenes.wkb import points_of
from raybundle.io.tables import Column, Table, header_shown, holds_values, read_table
from raybundle.numerics.arrays import Array, Mask

GEOGRAPHIC = ("lon_deg", "lat_deg", "h_m")
XYZ, SIGMA, SIGMA_ENU = ("X", "Y", "Z"), ("sX", "sY", "sZ"), ("sE_m", "sN_m", "sU_m")
IMAGE_POINTS = ("image", "point", "x_px", "y_px")
NAMES = ("point", "id", "name", "Name", "ID")
"""Attributes that name a point, the first that is there."""
IMAGES = ("image", "scene", "filename", "file")
HEIGHTS = ("Z", "h_m", "height", "elevation")
"""Attributes that show the height of a point whose geometry has none."""
JSON = (".geojson", ".json")
LISTS = (".csv", ".txt")


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneControl:
    """Control and check points of scenes, one row an image point."""

    file: Path
    ids: tuple[str, ...]
    geographic: Array
    """(n, 3) longitude, latitude [deg], ellipsoidal height [m] in WGS 84"""
    xy_px: Array
    """(n, 2) measured, pixel frame"""
    sigma_m: Array | None
    """(n, 3) standard deviations of the ground points, east, north, up; None: none is stated"""
    image: tuple[str, ...]
    """(n,) name of the image, empty where the file names none"""
    check: Mask
    """(n,) points that take no part and check"""
    remarks: tuple[str, ...] = ()
    heights_m: Array | None = None
    """(n,) heights as the file has them, above its own surface, in the unit of its system taken to metres; None: it has
    geocentric coordinates"""

    def rows(self, wanted: Sequence[int]) -> SceneControl:
        """Some of the rows."""
        rows = list(wanted)
        return replace(
            self, ids=tuple(self.ids[k] for k in rows), geographic=self.geographic[rows], xy_px=self.xy_px[rows],
            sigma_m=None if self.sigma_m is None else self.sigma_m[rows], image=tuple(self.image[k] for k in rows),
            check=self.check[rows], heights_m=None if self.heights_m is None else self.heights_m[rows],
        )  # fmt: skip

    def of(self, *names: str, alone: bool = False) -> SceneControl:
        """The rows of one scene, by its name or that of a file of it; those that name no image belong to any.

        alone   there is no other scene: points that all are of one image are taken for its, whatever its name
        raises  InputError where all name other images
        """
        mine = {scene_key(n) for n in names}
        rows = [k for k, image in enumerate(self.image) if not image or scene_key(image) in mine]
        if rows:
            return self.rows(rows)
        others = list(dict.fromkeys(self.image))
        if alone and len(others) == 1:
            assumed = note("scene_control.image_assumed", name=self.file.name, image=others[0], scene=names[0])
            return replace(self, remarks=(*self.remarks, Text.of(assumed)))
        raise InputError("scene_control.other_images", scene=names[0], others=others, file=self.file)


def scene_key(name: str) -> str:
    """What is the same of the names of a scene's files: NAME.tif, NAME_RPC.TXT, NAME.XML."""
    stem = Path(name).name
    for end in (".aux.xml", *([Path(stem).suffix] if Path(stem).suffix else [])):
        stem = stem.removesuffix(end)
    return stem.casefold().removesuffix("_rpc")


@dataclass(slots=True, kw_only=True)
class _Rows:
    """Points as a file has them, before their coordinates are those of WGS 84."""

    file: Path
    ids: list[str]
    xyz: Array
    crs: str | None
    xy_px: Array
    image: list[str]
    sigma: Array
    """(n, 3) in the axes and units of the coordinates; NaN where not stated"""
    role: list[str]
    lines: list[int] = field(default_factory=list[int])
    remarks: tuple[str, ...] = ()


def read_scene_control(
    path: Path, *, image_points: Path | None = None, crs: str | None = None, undulation: float | None = None
) -> SceneControl:
    """Control of scenes from a file.

    image_points  table image,point,x_px,y_px of points that `path` shows on the ground alone
    crs           coordinate system, with heights perhaps, of files that name none, as EPSG:32633+5773
    undulation    height of the geoid above the ellipsoid [m], where heights count from it and no grid is there
    raises        InputError with file, line and column; where heights are not known
    """
    if path.suffix.lower() == ".csv":
        header = header_of(path)
        _check_columns(path, header, image_points)
        if "lon_deg" in header:
            if crs is not None or undulation is not None:
                raise InputError(
                    "scene_control.geographic_columns",
                    columns=list(GEOGRAPHIC),
                    file=path,
                )
            return _geographic_table(path, image_points)
        rows = _plain_table(path) if "x_px" in header else _of_control_file(path, image_points)
    elif path.suffix.lower() in LISTS or path.is_dir():
        rows = _of_control_file(path, image_points)
    else:
        rows = _features(path, image_points)
    return _placed(rows, crs, undulation)


def _check_columns(path: Path, header: Sequence[str], image_points: Path | None) -> None:
    """Raise InputError for a table whose columns are neither those of scenes' control nor those of photographs'."""
    names = set(header)
    if {"point", "X"} <= names <= set(COLUMNS) or set(IMAGE_POINTS) <= names or image_points is not None:
        return
    forms = [("point", *place, "x_px", "y_px") for place in (GEOGRAPHIC, XYZ)]
    if any(names.issuperset(form) for form in forms):
        return
    if holds_values(header):
        raise InputError("table.no_header", header=header_shown(header), needed=list(forms[0]), file=path, line=1)
    raise InputError(
        "scene_control.columns_missing", header=header_shown(header), geographic=list(forms[0]), grid=list(forms[1]),
        image_points=list(IMAGE_POINTS), file=path, line=1,
    )  # fmt: skip


def _others(*, sigma: tuple[str, ...]) -> list[Column]:
    return [
        *(Column(name=n, kind="number", optional=True, empty=True, limit=">= 0") for n in sigma),
        Column(name="image", kind="text", optional=True, empty=True),
        Column(name="role", kind="text", optional=True, empty=True),
    ]


def _geographic_table(path: Path, image_points: Path | None) -> SceneControl:
    _none_beside(path, image_points)
    kind = "text" if "image" in header_of(path) else "id"
    columns = [Column(name=c, kind="number") for c in (*GEOGRAPHIC, "x_px", "y_px")]
    table = read_table(path, [Column(name="point", kind=kind), *columns, *_others(sigma=SIGMA_ENU)])
    stated = table.numbers(*SIGMA_ENU)
    return SceneControl(
        file=path, ids=table.text["point"], geographic=table.numbers(*GEOGRAPHIC),
        xy_px=table.numbers("x_px", "y_px"), sigma_m=stated if np.isfinite(stated).all() else None,
        image=_texts(table, "image"), check=_check_mask(path, _texts(table, "role"), table.first_line),
        heights_m=table.number["h_m"],
    )  # fmt: skip


def _plain_table(path: Path) -> _Rows:
    """Coordinates in any system and image points in one table."""
    kind = "text" if "image" in header_of(path) else "id"
    columns = [Column(name=c, kind="number") for c in (*XYZ, "x_px", "y_px")]
    table = read_table(path, [Column(name="point", kind=kind), *columns, *_others(sigma=SIGMA)])
    return _Rows(
        file=path, ids=list(table.text["point"]), xyz=table.numbers(*XYZ), crs=None,
        xy_px=table.numbers("x_px", "y_px"), image=list(_texts(table, "image")), sigma=table.numbers(*SIGMA),
        role=list(_texts(table, "role")), lines=list(range(table.first_line, table.rows + table.first_line)),
    )  # fmt: skip


def _texts(table: Table, name: str) -> tuple[str, ...]:
    return table.text.get(name, ("",) * table.rows)


def _check_mask(path: Path, roles: Sequence[str], first_line: int = 2) -> Mask:
    for k, role in enumerate(roles):
        if role not in {"", "control", "check"}:
            raise InputError(
                "value.not_supported", value=quoted(role), known=["control", "check"], file=path,
                line=k + first_line if path.suffix.lower() in LISTS else None, column="role",
            )  # fmt: skip
    return np.array([r == "check" for r in roles], bool)


def _none_beside(path: Path, image_points: Path | None) -> None:
    if image_points is not None:
        raise InputError(
            "scene_control.image_points_twice",
            table=str(image_points),
            file=path,
        )


def _of_control_file(path: Path, image_points: Path | None) -> _Rows:
    """Control as of photographs: ground points in one table, image points in another, or a list of both."""
    if image_points is not None and image_points.suffix.lower() != ".csv":
        given = read_control(path)
        marks = _marks_of(_ogr(image_points, geometry=False), image_points, given.ids, path)
        return _marked(given, *marks)
    control = read_control(path, measurements=image_points)
    m = control.measurements
    if not len(m):
        raise InputError(
            "scene_control.no_image_point",
            columns=list(IMAGE_POINTS),
            file=path,
        )
    return _marked(control, list(m.image), m.point.tolist(), m.xy_px)


def _marked(control: ControlFile, images: list[str], points: list[int], xy_px: Array) -> _Rows:
    assumed = assumed_words(DEFAULTS)
    roles = np.asarray(control.role)[points]
    stated = np.zeros(len(points), bool) if control.stated is None else np.asarray(control.stated)[points]
    return _Rows(
        file=control.path, ids=[control.ids[k] for k in points], xyz=control.xyz[points], crs=control.crs, xy_px=xy_px,
        image=images, sigma=np.where(stated[:, None], control.sigma[points], np.nan),
        role=["check" if r == Role.CHECK else "control" for r in roles],
        remarks=tuple(r for r in control.remarks if r != assumed),
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class _Feature:
    """A point with its attributes."""

    xyz: tuple[float, float, float]
    """NaN for a height that its geometry does not show"""
    values: Mapping[str, Any]
    where: str


def _features(path: Path, image_points: Path | None) -> _Rows:
    crs, features = _geojson(path) if path.suffix.lower() in JSON else _ogr(path, geometry=True)
    if not features:
        raise InputError("scene_control.no_point", file=path)
    ids = [_name(f, k, path) for k, f in enumerate(features)]
    xyz = np.array([(*f.xyz[:2], _height(f, path)) for f in features])
    sigma = np.array([[_number(f, n, path) for n in SIGMA] for f in features])
    roles = [_word(f, "role") for f in features]
    if image_points is None:
        return _Rows(
            file=path, ids=ids, xyz=xyz, crs=crs, xy_px=np.array([_image_point(f, path) for f in features]),
            image=[next((w for n in IMAGES if (w := _word(f, n))), "") for f in features], sigma=sigma, role=roles,
        )  # fmt: skip
    if twice := sorted({n for n in ids if ids.count(n) > 1}):
        raise InputError("scene_control.point_twice", point=twice[0], file=path)
    if image_points.suffix.lower() == ".csv":
        m = read_measurements(image_points, ids, str(path))
        images, points, xy = list(m.image), m.point.tolist(), m.xy_px
    else:
        images, points, xy = _marks_of(_ogr(image_points, geometry=False), image_points, ids, path)
    return _Rows(
        file=path, ids=[ids[k] for k in points], xyz=xyz[points], crs=crs, xy_px=xy, image=images, sigma=sigma[points],
        role=[roles[k] for k in points],
    )  # fmt: skip


def _marks_of(
    table: tuple[str | None, list[_Feature]], file: Path, ids: Sequence[str], path: Path
) -> tuple[list[str], list[int], Array]:
    known = {name: k for k, name in enumerate(ids)}
    rows = table[1]
    lacking = sorted({w for f in rows if (w := _word(f, "point")) not in known})
    if lacking:
        raise InputError("scene_control.point_missing", point=lacking[0], table=path.name, file=file)
    xy = np.array([_image_point(f, file) for f in rows]).reshape(-1, 2)
    return [_word(f, "image") for f in rows], [known[_word(f, "point")] for f in rows], xy


def _word(feature: _Feature, name: str) -> str:
    value = feature.values.get(name)
    if value is None or (isinstance(value, float) and np.isnan(value)):
        return ""
    return str(int(value)) if isinstance(value, float) and value.is_integer() else str(value)


def _number(feature: _Feature, name: str, path: Path) -> float:
    value = feature.values.get(name)
    if value is None or value == "":
        return float("nan")
    found = number_of(value) if isinstance(value, str) else float(value) if isinstance(value, int | float) else None
    if found is None:
        raise InputError(
            "scene_control.attribute_not_a_number", name=name, value=quoted(value), file=path, column=feature.where
        )
    return found


def _name(feature: _Feature, k: int, path: Path) -> str:
    found = next((w for n in NAMES if (w := _word(feature, n))), "")
    if not found.isprintable():
        raise InputError("name.unprintable", name=quoted(found), file=path, column=feature.where)
    return found or f"point {k + 1}"


def _height(feature: _Feature, path: Path) -> float:
    if np.isfinite(feature.xyz[2]):
        return feature.xyz[2]
    return next((h for n in HEIGHTS if np.isfinite(h := _number(feature, n, path))), float("nan"))


def _image_point(feature: _Feature, path: Path) -> tuple[float, float]:
    if (ji := feature.values.get("ji")) is not None:  # column, row as orthority counts them, from the first centre
        pair = [float(v) for v in ji] if isinstance(ji, list | tuple | np.ndarray) else []
        if len(pair) == 2:
            return pair[0] + 0.5, pair[1] + 0.5
    x, y = _number(feature, "x_px", path), _number(feature, "y_px", path)
    if not (np.isfinite(x) and np.isfinite(y)):
        raise InputError(
            "scene_control.no_image_attributes", names=list(feature.values)[:12], n=len(feature.values),
            columns=list(IMAGE_POINTS), file=path, column=feature.where,
        )  # fmt: skip
    return x, y


def _geojson(path: Path) -> tuple[str | None, list[_Feature]]:
    """RFC 7946: longitude, latitude, ellipsoidal height; the older member `crs` is taken where it stands."""
    top = read_json(path)
    crs: str | None = WGS84
    if top.has("crs"):
        name = top.get("crs").get("properties").get("name").text()
        crs = WGS84 if "CRS84" in name else f"EPSG:{name.rpartition(':')[2]}" if "EPSG" in name else name
    found: list[_Feature] = []
    for k, feature in enumerate(top.get("features").items()):
        geometry = feature.get("geometry")
        if geometry.get("type").text() != "Point":
            geometry.get("type").fail("scene_control.not_a_point", kind=quoted(geometry.get("type").text()))
        numbers = [n.number() for n in geometry.get("coordinates").items()]
        if len(numbers) < 2:
            geometry.get("coordinates").fail("scene_control.coordinate_count", n=len(numbers))
        values = dict(_values(feature))
        xyz = (numbers[0], numbers[1], numbers[2] if len(numbers) > 2 else float("nan"))
        found.append(_Feature(xyz=xyz, values=values, where=f"features.{k}"))
    return crs, found


def _values(feature: Json) -> dict[str, Any]:
    values = {k: v.value for k, v in feature.get("properties").mapping().items()} if feature.has("properties") else {}
    if feature.has("id"):
        values.setdefault("id", feature.get("id").value)
    return values


def _ogr(path: Path, *, geometry: bool) -> tuple[str | None, list[_Feature]]:
    """Points of the first layer that has them, or rows of the first that has columns point, x_px and y_px."""
    check_regular(path)
    library = _pyogrio(path)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of the library, about layers and measures
            for layer, kind in library.list_layers(str(path)):
                info, _, shapes, data = library.raw.read(str(path), layer=layer, read_geometry=geometry)
                names = list(info["fields"])
                if not geometry and not {"point", "x_px", "y_px"} <= set(names):
                    continue
                if geometry and (kind is None or "Point" not in str(kind)):
                    continue
                places = points_of(shapes, path) if geometry else np.full((len(data[0]), 3), np.nan)
                rows = [
                    _Feature(
                        xyz=(float(x), float(y), float(z)),
                        values={n: _plain(column[k]) for n, column in zip(names, data, strict=True)},
                        where=f"{layer}, row {k + 1}",
                    )
                    for k, (x, y, z) in enumerate(places)
                ]
                return info.get("crs") or None, rows
    except (library.errors.DataSourceError, library.errors.DataLayerError) as error:
        raise InputError("file.not_readable", detail=str(error).splitlines()[0][:200], file=path) from None

    raise InputError("scene_control.no_layer", points=geometry, columns=list(IMAGE_POINTS), file=path)


def _plain(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return value.tolist()
    return value.item() if isinstance(value, np.generic) else value


def _pyogrio(path: Path) -> Any:
    try:
        library: Any = import_module("pyogrio")  # an extra
        import_module("pyogrio.raw")
    except ImportError:
        raise InputError(
            "package.pyogrio_reading",
            file=path,
        ) from None
    return library


def _placed(rows: _Rows, crs: str | None, undulation: float | None) -> SceneControl:
    """The points in WGS 84, with standard deviations east, north, up."""
    system, remarks = _system(rows, crs)
    unknown = [k for k in range(len(rows.ids)) if not np.isfinite(rows.xyz[k]).all()]
    if unknown:
        raise InputError(
            "scene_control.no_height", n=len(unknown), total=len(rows.ids), point=rows.ids[unknown[0]],
            file=rows.file, line=rows.lines[unknown[0]] if rows.lines else None,
        )  # fmt: skip
    geographic, sigma = geographic_of(rows.xyz, system, undulation, rows.sigma, rows.file)
    reported = height_remarks(system, undulation)
    return SceneControl(
        file=rows.file, ids=tuple(rows.ids), geographic=geographic, xy_px=rows.xy_px, sigma_m=sigma,
        image=tuple(rows.image), check=_check_mask(rows.file, rows.role), remarks=(*rows.remarks, *remarks, *reported),
        heights_m=None if parse_crs(system).is_geocentric else rows.xyz[:, 2] * _height_unit_m(system),
    )  # fmt: skip


def _height_unit_m(crs: str) -> float:
    return LocalFrame(crs=crs, origin=(0.0, 0.0, 0.0)).units_m[1]


def _system(rows: _Rows, crs: str | None) -> tuple[str, tuple[str, ...]]:
    """The coordinate system of the points, and what was assumed."""
    if rows.crs is not None and crs is not None:
        own, given = (_plan(c) for c in (rows.crs, crs))
        if not own.equals(given, ignore_axis_order=True):
            raise InputError(
                "scene_control.other_system",
                own=own.name,
                system=given.name,
                file=rows.file,
            )
        return crs, ()
    if (system := rows.crs or crs) is not None:
        return system, ()
    plan = np.abs(rows.xyz[:, :2])
    if not (plan <= [360, 90]).all():
        k = int(np.argmax(plan.max(axis=1)))
        x, y = rows.xyz[k, :2]
        raise InputError(
            "scene_control.not_degrees",
            point=rows.ids[k],
            x=x,
            y=y,
            file=rows.file,
        )
    return WGS84, (Text.of(note("scene_control.wgs84_assumed")),)


def _plan(crs: str) -> Any:
    system = parse_crs(crs)
    if system.is_compound:
        system = system.sub_crs_list[0]
    return system.to_2d()


def geographic_of(
    xyz: Array, crs: str, undulation: float | None, sigma: Array, file: Path
) -> tuple[Array, Array | None]:
    """Longitude, latitude, ellipsoidal height (n, 3) in WGS 84 of points in any system, and sigma east, north, up [m].

    sigma  (n, 3) in the axes and units of the system; NaN: not stated, taken as free of error where others are
    """
    try:
        frame = local_frame(crs, xyz.mean(axis=0), undulation_m=undulation)
        geographic = frame.wgs84_from_local(frame.local_from_crs(xyz))
    except InputError as error:
        raise error.at(file) from None
    if not np.isfinite(sigma).any():
        return geographic, None
    covariance = np.nan_to_num(sigma)[:, :, None] ** 2 * np.eye(3)
    turn = frame.local_from_enu(xyz)
    local = frame.local_covariance(xyz, covariance)
    enu = np.swapaxes(turn, 1, 2) @ local @ turn
    return geographic, np.sqrt(np.diagonal(enu, axis1=1, axis2=2))
