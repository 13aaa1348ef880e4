"""Block folders: block.toml and CSV tables, read strictly and written so that they read back equal.

The format stands in docs/reference/block-format.md.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from raybundle.block import Block, Camera, Images, Points
from raybundle.block.block import PixelFrame, Turn
from raybundle.block.frames import TURNS, size_ratio
from raybundle.errors import InputError, message
from raybundle.io.block.image_points import no_observations, read_observations, write_observations
from raybundle.io.block.observations import read_observation_tables, write_observation_tables
from raybundle.io.block.points import read_points, with_tie_points, write_points
from raybundle.io.block.scenes import FOLDER as SCENES
from raybundle.io.block.scenes import with_views, write_scene_files
from raybundle.io.block.tables import ANGLES, XYZ, columns_of, problems_of, require
from raybundle.io.block.toml import head_text, read_head
from raybundle.io.digits import EVERY
from raybundle.io.folders import check_free, new_folder
from raybundle.io.ids import check_ids_of
from raybundle.io.reading.files import stands
from raybundle.io.reading.words import quoted
from raybundle.io.table_files import SUFFIXES, TableFormat, new_table_file, table_file
from raybundle.io.tables import SHOWN, Column, Problem, Table, read_table, write_table
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.observations import tables as kinds
from raybundle.readable import readable, readable_names

FRAME = ("turned_deg", "file_width_px", "file_height_px")
"""Of images whose files are stored turned or reduced."""
SCAN = ("scan_xx", "scan_xy", "scan_x0", "scan_yx", "scan_yy", "scan_y0")
"""Of images whose files are scans: the file's pixels by those of the camera."""


def read_block(path: str | Path, *, progress: Progress = silent) -> Block:
    """The block in a folder.

    raises  InputError with file, line and column for anything the format does not allow
    Photographs alone, without orientation and points, need no image point: they are to be measured.
    Limits: whether the block can be adjusted; points without rays and images without
    orientation are well-formed.
    """
    folder = Path(path)
    progress("reading", 0.0)
    bare, points, at = read_without_observations(folder)
    progress("reading", 0.1)
    alone = not bare.images.oriented.any() and not stands(table_file(folder, "points"))
    observations, rejected = read_observations(
        table_file(folder, "observations"), at["image"], at["point"], least_rows=0 if alone else 1
    )
    progress("reading", 0.9)
    points = with_tie_points(points, tuple(at["point"])[len(points) :])
    tables = read_observation_tables(folder, at["image"], at["point"], bare.instruments)
    progress("reading", 1.0)
    return replace(bare, points=points, observations=observations, rejected=rejected, tables=tables)


def read_without_observations(path: str | Path) -> tuple[Block, Points, dict[str, dict[str, int]]]:
    """The block in a folder without what it observes; the points that it lists; "image", "point" -> id -> position."""
    folder = Path(path)
    _check_folder(folder)
    head = read_head(folder / "block.toml")
    images, image_ids = _read_images(table_file(folder, "images"), head.cameras)
    points = read_points(table_file(folder, "points"))
    interior = _read_interior(table_file(folder, "interior"), image_ids, images, head.cameras)
    block = Block(
        name=head.name,
        about=head.about,
        source=head.source,
        licence=head.licence,
        length_unit=head.length_unit,
        free_scale=head.free_scale,
        nominal_scale=head.nominal_scale,
        sigma0_apriori=head.sigma0_apriori,
        residuals=head.residuals,
        noise=head.noise,
        datum_over=head.datum_over,
        place=head.place,
        cameras=head.cameras,
        images=replace(images, interior=interior),
        observations=no_observations(),
        points=points.empty(),
        instruments=head.instruments,
    )
    return block, points, {"image": image_ids, "point": {point: k for k, point in enumerate(points.ids)}}


def _check_folder(folder: Path) -> None:
    if not folder.is_dir():
        raise InputError("block.is_a_file" if folder.exists() else "file.missing", file=folder)
    if not stands(folder / "block.toml"):
        if (folder / "result.json").exists():
            raise InputError("block.result_folder", block=str(folder / "block"), file=folder)
        raise InputError("block.no_block_toml", file=folder)
    for table in ("images", "observations"):
        if not stands(file := table_file(folder, table)):
            raise InputError("block.file_missing", file=file)
    known = {name.lower().rstrip("s"): name for name in _table_names()}
    for entry in sorted(folder.iterdir()):
        meant = known.get(entry.stem.lower().rstrip("s"))
        suffix = entry.suffix.lower()
        if suffix in SUFFIXES and meant is not None and entry.name != f"{meant}{suffix}":
            raise InputError("block.file_name", meant=f"{meant}{suffix}", file=entry)


def block_files() -> set[str]:
    """Names of all that may stand in a block folder."""
    return {"block.toml", *(f"{name}{suffix}" for name in _table_names() for suffix in SUFFIXES), SCENES}


def _table_names() -> tuple[str, ...]:
    return ("images", "observations", "points", *kinds, "interior")


def unread_tables(folder: Path) -> tuple[str, ...]:
    """Names of files in a block folder that look like tables and are none that is read, nor named in block.toml."""
    text = (folder / "block.toml").read_text(encoding="utf-8", errors="replace")
    found = (f.name for f in folder.iterdir() if f.suffix.lower() in SUFFIXES and f.name not in block_files())
    return tuple(sorted(name for name in found if f'"{name}"' not in text))


def _image_columns(cameras: tuple[Camera, ...]) -> tuple[Column, ...]:
    of = {c.id: k for k, c in enumerate(cameras)}
    return (
        Column(name="image", kind="id"),
        Column(name="camera", kind="reference", known=of, where="block.toml"),
        Column(name="file", kind="text", empty=True),
        *(Column(name=n, kind="number", empty=True) for n in (*XYZ, *ANGLES)),
        Column(name="held", kind="number", optional=True, empty=True),
        Column(name="station", kind="text", optional=True, empty=True),
        Column(name="date", kind="text", optional=True, empty=True),
        *(Column(name=n, kind="number", optional=True, empty=True) for n in (*FRAME, *SCAN)),
    )


def _read_images(path: Path, cameras: tuple[Camera, ...]) -> tuple[Images, dict[str, int]]:
    table = read_table(path, _image_columns(cameras), own=True)
    ids = table.text["image"]
    centre = table.numbers(*XYZ)
    angles = table.numbers(*ANGLES)
    held = table.number.get("held", np.full(len(ids), np.nan))
    known = np.isfinite(angles).sum(axis=1)
    camera = table.index["camera"]
    is_scene = np.array([c.is_scene for c in cameras])[camera]
    given = np.isfinite(np.concatenate([centre, angles, held[:, None]], axis=1)).any(axis=1)
    first = np.ones(len(ids), bool)
    first[np.unique(camera, return_index=True)[1]] = False
    oriented = (known == 3) & np.isfinite(centre).all(axis=1)
    require(
        path,
        problems_of(
            (known != 0) & (known != 3),
            "omega_deg",
            lambda k: message("image.angles_incomplete", image=ids[k], n=known[k]),
        ),
        problems_of(np.isfinite(held) & (held != 1), "held", lambda k: message("cell.not_a_flag", value=held[k])),
        problems_of(
            (held == 1) & ~oriented,
            "held",
            lambda k: message("image.held_without_orientation", image=ids[k]),
        ),
        problems_of(
            is_scene & given,
            "X",
            lambda k: message("scene.orientation_given", image=ids[k]),
        ),
        problems_of(
            is_scene & first,
            "camera",
            lambda k: message("scene.second_image", camera=cameras[camera[k]].id),
        ),
    )
    rotation = rotation_from_angles(np.radians(angles))
    if is_scene.any():
        centre, rotation, _ = with_views(centre, rotation, cameras, camera)
    return Images(
        ids=ids,
        camera=camera,
        file=table.text["file"],
        centre=centre,
        rotation=rotation,
        held=(held == 1) | is_scene if ((held == 1) | is_scene).any() else None,
        station=_stations_of(table.text.get("station")),
        date=table.text["date"] if any(table.text.get("date", ())) else None,
        frames=_frames_of(path, table, cameras, camera),
    ), {image: k for k, image in enumerate(ids)}


def _frames_of(path: Path, table: Table, cameras: tuple[Camera, ...], camera: Index) -> dict[int, PixelFrame]:
    """How the files of images lie that are stored turned or reduced."""
    ids = table.text["image"]
    columns = np.stack([table.number.get(n, np.full(len(ids), np.nan)) for n in FRAME], axis=1)
    scans = np.stack([table.number.get(n, np.full(len(ids), np.nan)) for n in SCAN], axis=1)
    given, scanned = np.isfinite(columns), np.isfinite(scans)
    turns = {float(t) for t in TURNS}
    strange = np.array([bool(np.isfinite(t)) and t not in turns for t in columns[:, 0].tolist()], bool)

    def fits(k: int) -> bool:
        one, (turned, width, height) = cameras[camera[k]], columns[k]
        same = size_ratio((one.width_px, one.height_px), (int(width), int(height)))
        return same is not None and (one.width_px == one.height_px or same[1] == (turned in {90, 270}))

    require(
        path,
        problems_of(
            np.asarray(given.any(axis=1) & ~given.all(axis=1), bool),
            FRAME[0],
            lambda k: message("image.file_frame_incomplete", image=ids[k], n=given[k].sum(), columns=FRAME),
        ),
        problems_of(
            strange,
            FRAME[0],
            lambda k: message("value.not_supported", value=f"{columns[k, 0]:g}", known=TURNS),
        ),
        problems_of(
            np.asarray(scanned.any(axis=1) & ~(scanned.all(axis=1) & given.all(axis=1)), bool),
            SCAN[0],
            lambda k: message("image.scan_incomplete", image=ids[k], needed=(*FRAME, *SCAN)),
        ),
        problems_of(
            scanned.all(axis=1) & ~(np.abs(np.linalg.det(np.nan_to_num(scans).reshape(-1, 2, 3)[:, :, :2])) > 1e-12),
            SCAN[0],
            lambda k: message("image.affine_singular", image=ids[k]),
        ),
    )
    whole = np.flatnonzero(given.all(axis=1))
    wrong = np.zeros(len(ids), bool)
    wrong[[k for k in whole.tolist() if min(columns[k, 1:]) < 1 or not (scanned[k, 0] or fits(k))]] = True
    require(
        path,
        problems_of(
            wrong,
            FRAME[1],
            lambda k: message(
                "image.file_size_differs",
                image=ids[k],
                width_px=columns[k, 1],
                height_px=columns[k, 2],
                turned_deg=columns[k, 0],
                camera_width_px=cameras[camera[k]].width_px,
                camera_height_px=cameras[camera[k]].height_px,
            ),
        ),
    )
    turned: dict[float, Turn] = {float(t): t for t in TURNS}
    return {
        k: PixelFrame(turned=turned[t], width_px=int(w), height_px=int(h), affine=_affine_of(scans[k]))
        for k, (t, w, h) in zip(whole.tolist(), columns[whole].tolist(), strict=True)
    }


def _affine_of(values: Array) -> tuple[float, float, float, float, float, float] | None:
    if not np.isfinite(values).all():
        return None
    a, b, c, d, e, f = values.tolist()
    return a, b, c, d, e, f


def _stations_of(names: tuple[str, ...] | None) -> Index | None:
    """Numbers of the rigs' stations; images without a name have one each."""
    if names is None or not any(names):
        return None
    index = {name: k for k, name in enumerate(dict.fromkeys(n for n in names if n))}
    return np.array([index[n] if n else len(index) + k for k, n in enumerate(names)], np.int32)


def _read_interior(
    path: Path, images: dict[str, int], table_of_images: Images, cameras: tuple[Camera, ...]
) -> dict[int, dict[str, float]]:
    """Interior orientations of single images; what is not listed is the camera's."""
    if not stands(path):
        return {}
    table = read_table(
        path,
        (
            Column(name="image", kind="reference", known=images, where="images.csv"),
            Column(name="parameter", kind="text"),
            Column(name="value", kind="number"),
        ),
        own=True,
    )
    result: dict[int, dict[str, float]] = {}
    problems: list[Problem] = []
    rows = zip(table.index["image"].tolist(), table.text["parameter"], table.number["value"].tolist(), strict=True)
    for line, (image, key, value) in enumerate(rows, 2):
        camera = cameras[int(table_of_images.camera[image])]
        parameter = {p.key: p for p in camera.sensor.parameters}.get(key)
        own = result.setdefault(image, {})
        if not camera.own_symbols or (parameter is not None and parameter.symbol not in camera.own_symbols):
            wrong = message("interior.shared", camera=camera.id, parameter=quoted(key))
            problems.append(Problem(line, "image", wrong))
        elif parameter is None:
            known = [p.key for p in camera.sensor.parameters]
            wrong = message("parameter.unknown", name=quoted(key), model=camera.model, known=known)
            problems.append(Problem(line, "parameter", wrong))
        elif parameter.symbol in own:
            problems.append(Problem(line, "parameter", message("parameter.twice", name=key)))
        elif parameter.kind == "scale" and value <= 0:
            problems.append(Problem(line, "value", message("value.not_above", value=value, limit=0)))
        else:
            own[parameter.symbol] = value
        if len(problems) > SHOWN:
            break
    require(path, problems)
    return result


def write_block(block: Block, path: str | Path, *, tables: TableFormat = "auto") -> None:
    """Write a block folder, whole or not at all.

    path    a new folder, or an empty one; a block that stands there is never overwritten
    tables  "csv" or "parquet" (with pyarrow); "auto": CSV, Parquet for tables of more rows than a spreadsheet holds
            where pyarrow is installed
    raises  InputError if `path` is not empty, an id is empty or duplicate, or pyarrow is missing

    Numbers are written so that they read back equal; angles of the exterior orientation to 1e-12 degrees.
    """
    folder = Path(path)
    check_free(folder)
    check_ids_of(block, folder)
    with new_folder(folder) as temporary:
        write_block_files(block, temporary, tables)


def write_block_files(block: Block, folder: Path, tables: TableFormat = "auto") -> None:
    """Write the files of a block into an existing folder."""
    block = _readable(block)
    (folder / "block.toml").write_text(head_text(block), encoding="utf-8", newline="\n")
    images, points = block.images, block.points
    is_scene = np.array([c.is_scene for c in block.cameras])[images.camera]
    if is_scene.any():
        write_scene_files(block, folder)
    blank = np.where(is_scene, np.nan, 0.0)[:, None]
    columns: dict[str, Sequence[str] | Array] = {
        "image": images.ids,
        "camera": [block.cameras[c].id for c in images.camera],
        "file": images.file,
        **columns_of(XYZ, images.centre + blank),
        **columns_of(ANGLES, angles_deg(images) + blank),
    }
    if images.held is not None and (images.held & ~is_scene).any():
        columns["held"] = np.where(images.held & ~is_scene, 1.0, np.nan)
    if images.station is not None:
        shared = np.bincount(images.station)[images.station] > 1
        columns["station"] = [f"{s}" if many else "" for s, many in zip(images.station, shared, strict=True)]
    if images.date is not None:
        columns["date"] = images.date
    if images.frames:
        rows = [images.frames.get(k) for k in range(len(images))]
        none = (np.nan,) * 3
        frames = np.array([none if f is None else (f.turned, f.width_px, f.height_px) for f in rows], float)
        columns |= columns_of(FRAME, frames)
        if any(f is not None and f.affine is not None for f in rows):
            blanks = (np.nan,) * len(SCAN)
            columns |= columns_of(SCAN, np.array([blanks if f is None else f.affine or blanks for f in rows], float))
    write_table(new_table_file(folder, "images", len(images), tables), columns, EVERY)
    write_observations(new_table_file(folder, "observations", len(block.observations), tables), block)
    if len(points):
        write_points(new_table_file(folder, "points", len(points), tables), points)
    write_observation_tables(folder, block, tables)
    _write_interior(folder, block, tables)


def _readable(block: Block) -> Block:
    """The block with names that its readers take: those of files and of foreign formats may be any."""
    images, points = block.images, block.points
    cameras = readable_names([c.id for c in block.cameras])
    return replace(
        block,
        cameras=tuple(replace(c, id=i) if i != c.id else c for c, i in zip(block.cameras, cameras, strict=True)),
        images=replace(images, ids=readable_names(images.ids), file=tuple(map(readable, images.file))),
        points=replace(points, ids=readable_names(points.ids)),
    )


def _write_interior(folder: Path, block: Block, tables: TableFormat) -> None:
    image: list[str] = []
    parameter: list[str] = []
    value: list[float] = []
    for k, values in block.images.interior.items():
        model = block.cameras[int(block.images.camera[k])].sensor
        for p in model.parameters:
            if p.symbol in values:
                image.append(block.images.ids[k])
                parameter.append(p.key)
                value.append(values[p.symbol])
    if image:
        path = new_table_file(folder, "interior", len(image), tables)
        write_table(path, {"image": image, "parameter": parameter, "value": np.array(value)}, EVERY)


def angles_deg(images: Images) -> Array:
    """Omega, phi, kappa (n, 3) [deg], rounded to 1e-12 degrees; NaN where not known."""
    known = np.isfinite(images.rotation).all(axis=(1, 2))
    angles: Array = np.full((len(images), 3), np.nan)
    if known.any():
        angles[known] = np.round(np.degrees(images.angles[known]), 12) + 0.0  # no -0
    return angles
