"""`raybundle convert`."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Literal, cast

import click
import numpy as np

from raybundle.block import Block, Camera, Images
from raybundle.block.frames import in_file_frames
from raybundle.cli.common import (
    APPROXIMATE,
    COMMAND_SETTINGS,
    FOLDER,
    FREE_SCALE,
    NEW_FILE_OR_FOLDER,
    common_options,
    counted,
)
from raybundle.cli.numbers import NUMBER
from raybundle.errors import InputError
from raybundle.io.cameras.one_instant import at_one_instant
from raybundle.io.formats import Export, check_deviation, formats, read_format, write_format
from raybundle.io.geo.coordinate_systems import LocalFrame, frame_from_mapping, local_frame
from raybundle.io.reading.files import opened
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.pipeline.project import photographs_of

BLOCK = "block"
READABLE = [BLOCK, *sorted(n for n, f in formats.items() if f.read)]
RPC = "rpc"
WRITABLE = [BLOCK, RPC, *sorted(n for n, f in formats.items() if f.write)]
POINTS, STATIONS = ("las", "ply"), ("geojson", "kml")
"""Formats that take the points of satellite scenes, and formats of stations on a map, which scenes are not."""
TITLES = "\n".join(
    f"  {n:<12} {'read, write' if f.read and f.write else 'write' if f.write else 'read':<12} {f.title}"
    for n, f in sorted(formats.items())
)
HELP = f"""Convert between block folders, result folders and the formats of other programs.

INPUT is a block folder, a result folder (its adjusted values, without rejected observations), or a file or folder of
another program. Cameras are fitted where the other program describes distortion differently; the largest deviation is
printed, and nothing is written where it exceeds 0.1 px, unless --approximate is given. The tables of a result folder
(points.csv, images.csv, observations.csv ...) are CSV already.

\b
Formats:
  {"block":<12} {"read, write":<12} block folder; as input also a result folder
  {"rpc":<12} {"write":<12} NAME_RPC.TXT of every satellite scene, its estimated bias built in
{TITLES}

\b
Example:
  raybundle convert camcal21-result --to colmap --out model
  raybundle convert model --to block --out camcal21-again
  raybundle convert pair-project/result --to rpc --out corrected
  raybundle convert flight-result --to kml --out flight.kml --crs EPSG:32611
  raybundle convert facade-result --to colmap --out dense/sparse --photos photos --undistort inside
"""


class _Target(click.Choice[str]):
    """The formats to write, and where to look for what is none of them."""

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """As a choice; tables are none."""
        if value.lower() == "csv":
            self.fail(
                "there is no format 'csv': a block folder (--to block) and a result folder consist of CSV tables "
                "already (images.csv, points.csv, observations.csv ...); copy the one you need",
                param,
                ctx,
            )
        return super().convert(value, param, ctx)


@click.command("convert", context_settings=COMMAND_SETTINGS, help=HELP)
@click.argument("source", type=FOLDER, metavar="INPUT")
@click.option("--from", "given", type=click.Choice(READABLE), help="Format of INPUT.  [default: recognised]")
@click.option("--to", "target", type=_Target(WRITABLE), required=True, help="Format to write.")
@click.option(
    "--out", type=NEW_FILE_OR_FOLDER, required=True, metavar="PATH", help="New file or folder; nothing is overwritten."
)
@click.option("--crs", metavar="SYSTEM", help="Coordinate system: EPSG:25832, EPSG:25832+7837 or a PROJ string.")
@click.option(
    "--origin",
    nargs=3,
    type=NUMBER,
    metavar="E N H",
    help="The block stands in the local east-north-up frame at this point of --crs; without it, in --crs itself, and "
    "is brought to a local frame in its middle.",
)
@click.option("--undulation", type=NUMBER, metavar="M", help="Height of the geoid above the ellipsoid, for --crs.")
@click.option("--photos", type=FOLDER, metavar="FOLDER",
    help="The photographs: colours of points, and --undistort. An oriented project's colours are found without it.",
)  # fmt: skip
@click.option(
    "--undistort",
    type=click.Choice(["inside", "all"]),
    help="Write the photographs without distortion into images/ beside --out, and pinhole cameras. inside: no empty "
    "pixels; all: nothing is cut.",
)
@APPROXIMATE
@FREE_SCALE
@common_options
def command(
    source: Path,
    given: str | None,
    target: str,
    out: Path,
    crs: str | None,
    origin: tuple[float, float, float] | None,
    undulation: float | None,
    photos: Path | None,
    undistort: str | None,
    progress: str,
    *,
    approximate: bool,
    free_scale: bool,
) -> None:
    """Read, bring to the frame asked for, write, and print what was assumed."""
    from raybundle.cli.progress import reporting  # noqa: PLC0415  (what computes is loaded after the help)

    if (origin or undulation is not None) and crs is None:
        raise InputError("--origin and --undulation belong to a coordinate system; give --crs too")
    if undistort and photos is None:
        raise InputError("--undistort needs the photographs; give their folder: --photos FOLDER")
    _check_target(out, target)
    with reporting(progress) as tell:
        export, remarks = read_source(source, given, approximate=approximate)
        if crs is not None:
            export, more = placed(export, crs, origin, undulation)
            remarks += more
        if target != BLOCK:
            export = replace(export, block=with_adjusted_cameras(export.block, source))
        if target not in {BLOCK, RPC} or undistort:
            block, more = at_one_instant(export.block)
            export = replace(export, block=block)
            remarks += more
        if target != BLOCK or undistort:
            export = replace(export, block=in_file_frames(export.block))
        coloured = target not in {BLOCK, RPC} and formats[target].colours
        if folders := (photos,) if photos is not None else photographs_of(source) if coloured else ():
            from raybundle.io.pictures.undistort import point_colours  # noqa: PLC0415

            colours, more = point_colours(export.block, folders, progress=tell)
            export = replace(export, colours=colours)
            remarks += more
        if undistort and photos is not None:
            area = cast("Literal['inside', 'all']", undistort)
            export, more = straightened(export, photos, out.parent / "images", area, tell)
            remarks += more
        tell("writing", 0.0)
        files, more, deviation = written(export, target, out, approximate=approximate, free_scale=free_scale)
        tell("writing", 1.0)
    b = export.block
    click.echo(f" {counted(int(b.images.oriented.sum()), 'oriented image')}, {counted(len(b.points), 'point')}, "
               f"{counted(len(b.observations), 'image observation')}")  # fmt: skip
    for remark in dict.fromkeys((*remarks, *more)):
        click.echo(f" remark: {remark}")
    if deviation > 0:
        click.echo(f" cameras: largest deviation {deviation:.3g} px")
    click.echo(f" {target}: {out}" + (f" and {counted(files - 1, 'more file')}" if files > 1 and out.is_file() else ""))


def _check_target(out: Path, target: str) -> None:
    """Refuse what would be refused after all the work."""
    if out.exists() and (not out.is_dir() or any(out.iterdir())):
        raise InputError("stands there already and is not overwritten; choose another name", file=out)
    suffix = "" if target in {BLOCK, RPC} else formats[target].suffix
    allowed = {suffix, ".laz"} if suffix == ".las" else {suffix}
    if suffix and out.suffix.lower() not in allowed:
        raise InputError(f"format {target} is a file; give a name that ends in {suffix}", file=out)


def read_source(source: Path, given: str | None, *, approximate: bool = False) -> tuple[Export, tuple[str, ...]]:
    """What is to be converted, and remarks; adjusted coordinates and their precision where INPUT is a result."""
    name = given or recognised(source)
    if name != BLOCK:
        imported = read_format(name, source)
        check_deviation(imported.deviation_px, imported.remarks, source, approximate=approximate)
        return Export(block=imported.block, colours=imported.colours), imported.remarks
    if (source / "result.json").is_file():
        return _read_result(source)
    from raybundle.io.block.folder import read_block  # noqa: PLC0415

    return Export(block=read_block(source)), ()


def recognised(source: Path) -> str:
    """The format of a file or folder by its contents; raises InputError where it cannot be told."""
    if not source.exists():
        raise InputError("there is no such file or folder; check the path", file=source)
    if source.is_dir():
        names = {p.name for p in source.iterdir()}
        if names & {"block.toml", "result.json"}:
            return BLOCK
        if any(
            (source / f / f"cameras{s}").is_file() for f in (".", "sparse/0", "0", "sparse") for s in (".bin", ".txt")
        ):
            return "colmap"
        if any(n.endswith(".opf") for n in names):
            return "opf"
        for name, format_ in (("transforms.json", "nerfstudio"), ("reconstruction.json", "opensfm")):
            if name in names:
                return format_
        if "image.dat" in names:
            return "bingo"
        if any(n.endswith(".im") for n in names):
            return "patb"
    elif source.suffix.lower() in {".opf", ".xml"}:
        return {".opf": "opf", ".xml": "metashape"}[source.suffix.lower()]
    elif source.suffix.lower() == ".json":
        with opened(source) as file:
            return "opensfm" if file.read(64).lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"[") else "nerfstudio"
    raise InputError(f"its format is not recognised; give --from, one of {', '.join(READABLE)}", file=source)


def _read_result(folder: Path) -> tuple[Export, tuple[str, ...]]:
    """The adjusted values of a result folder, without rejected observations."""
    from raybundle.results.folder import read_result  # noqa: PLC0415

    result = read_result(folder)
    block = result.block
    position = {p: k for k, p in enumerate(block.points.ids)}
    xyz, sigma = np.array(block.points.xyz), np.full((len(block.points), 3), np.nan)
    rows = np.array([position[p] for p in result.points.text["point"]], int)
    adjusted = result.points.numbers("X", "Y", "Z")
    xyz[rows] = np.where(np.isfinite(adjusted), adjusted, xyz[rows])
    sigma[rows] = result.points.numbers("sX", "sY", "sZ")
    images, station_sigma = _adjusted_images(block.images, result.images.text["image"], result.images)
    o = block.observations
    out = {
        (i, p)
        for i, p, why in zip(*(result.observations.text[n] for n in ("image", "point", "rejected")), strict=True)
        if why
    }
    named = zip(o.image.tolist(), o.point.tolist(), strict=True)
    kept = np.array([(block.images.ids[i], block.points.ids[p]) not in out for i, p in named], bool)
    block = replace(
        block,
        # results of versions that did not write it into the block tell it, too
        free_scale="scale" in result.result.get("datum_defect", ()),
        images=images,
        points=replace(block.points, xyz=xyz),
        observations=replace(o, image=o.image[kept], point=o.point[kept], xy_px=o.xy_px[kept], cov_px2=o.cov_px2[kept]),
    )
    remarks = (f"{counted(int((~kept).sum()), 'rejected image observation')} left out",) if not kept.all() else ()
    frame = result.result.get("frame")
    return Export(
        block=block,
        sigma=sigma,
        station_sigma=station_sigma,
        frame=frame_from_mapping(frame) if isinstance(frame, dict) else None,
    ), remarks


def with_adjusted_cameras(block: Block, source: Path) -> Block:
    """Where INPUT is a result: observed parameters of its cameras as they were adjusted.

    A block folder keeps what was observed; other programs want what came of it.
    """
    if not (source / "result.json").is_file():
        return block
    from raybundle.io.reading.trees import Json  # noqa: PLC0415
    from raybundle.results.folder import read_result  # noqa: PLC0415

    told = Json(source / "result.json", read_result(source).result).get("cameras")
    own = {c.id: told.get(c.id) for c in block.cameras if told.has(c.id)}

    def adjusted(camera: Camera) -> Camera:
        if camera.id not in own:
            return camera
        values = {s: own[camera.id].get(s).get("value").number() for s in camera.sigma if own[camera.id].has(s)}
        return replace(camera, values={**camera.values, **values})

    cameras = tuple(map(adjusted, block.cameras))
    return replace(block, cameras=cameras)


def _adjusted_images(images: Images, ids: tuple[str, ...], table: object) -> tuple[Images, Array]:
    from raybundle.io.tables import Table  # noqa: PLC0415

    assert isinstance(table, Table)
    position = {i: k for k, i in enumerate(images.ids)}
    rows = np.array([position[i] for i in ids], int)
    centre, rotation = np.array(images.centre), np.array(images.rotation)
    sigma = np.full((len(images), 3), np.nan)
    X0 = table.numbers("X", "Y", "Z")
    R = rotation_from_angles(np.radians(table.numbers("omega_deg", "phi_deg", "kappa_deg")))
    known = np.isfinite(X0).all(axis=1) & np.isfinite(R).all(axis=(1, 2))
    centre[rows[known]], rotation[rows[known]] = X0[known], R[known]
    sigma[rows] = table.numbers("sX", "sY", "sZ")
    return replace(images, centre=centre, rotation=rotation), sigma


def placed(
    export: Export, crs: str, origin: tuple[float, float, float] | None, undulation: float | None
) -> tuple[Export, tuple[str, ...]]:
    """The block in a local frame of a coordinate system, and remarks; without an origin it stands in the system."""
    if origin is not None:
        frame = local_frame(crs, origin, undulation_m=undulation)
        return replace(export, frame=frame), frame.remarks
    block = export.block
    if block.place is not None:
        raise InputError(
            f"block {block.name} says itself where its frame stands on the earth; leave --crs out, or give --origin too"
        )
    if block.length_unit != "m":
        raise InputError(f"block {block.name}: a block in {block.length_unit} does not stand in {crs}; give --origin")
    oriented = block.images.oriented
    middle = block.images.centre[oriented].mean(axis=0) if oriented.any() else np.nanmean(block.points.xyz, axis=0)
    frame = local_frame(crs, middle, undulation_m=undulation)
    place = ", ".join(f"{v:.3f}" for v in middle)
    remark = f"the block was brought from {crs} to the local east-north-up frame at {place}"
    return replace(in_frame(export, frame), frame=frame), (remark, *frame.remarks)


def in_frame(export: Export, frame: LocalFrame) -> Export:
    """A block whose coordinates stand in the system of a frame, brought to that frame; what it observed too."""
    block = export.block
    known = block.images.oriented
    centre, rotation = np.array(block.images.centre), np.array(block.images.rotation)
    turn = frame.crs_from_local_rotation(centre[known])
    rotation[known] = rotation[known] @ turn
    centre[known] = frame.local_from_crs(centre[known])
    stations = block.stations
    # velocities would have to be turned; without them they follow from the positions
    moved = replace(stations, xyz=frame.local_from_crs(stations.xyz), velocity=None)
    points = replace(block.points, xyz=_known_plan(frame, block.points.xyz))
    images = replace(block.images, centre=centre, rotation=rotation)
    return replace(export, block=replace(block, images=images, points=points).having(moved))


def _known_plan(frame: LocalFrame, xyz: Array) -> Array:
    plan = np.isfinite(xyz[:, :2]).all(axis=1)
    result = np.full(xyz.shape, np.nan)
    result[plan] = frame.local_from_crs(xyz[plan])
    return result


def straightened(
    export: Export, photos: Path, folder: Path, area: Literal["inside", "all"], progress: Progress
) -> tuple[Export, tuple[str, ...]]:
    """The block with pinhole cameras, its photographs without distortion in a new folder."""
    from raybundle.io.folders import new_folder  # noqa: PLC0415
    from raybundle.io.pictures.undistort import undistorted_block, write_undistorted  # noqa: PLC0415

    if folder.exists():
        raise InputError("stands there already and is not overwritten; give --out in another folder", file=folder)
    with new_folder(folder) as temporary:
        remarks = write_undistorted(export.block, photos, temporary, area=area, progress=progress)
        if not any(p.is_file() for p in temporary.rglob("*")):
            raise InputError(f"no photograph of the block could be read: {remarks[0]}", file=photos)
    block, more = undistorted_block(export.block, area=area)
    return replace(export, block=block), (*remarks, *more)


def written(
    export: Export, target: str, out: Path, *, approximate: bool = False, free_scale: bool = False
) -> tuple[int, tuple[str, ...], float]:
    """Write; the number of files, remarks, and the largest deviation of a camera [px]."""
    if target == RPC:
        from raybundle.io.folders import new_folder  # noqa: PLC0415
        from raybundle.io.scene_export import write_rpcs  # noqa: PLC0415

        with new_folder(out) as folder:
            files, remarks = write_rpcs(export.block, folder)
        return len(files), remarks, 0.0
    if target != BLOCK:
        export, more = fit_for(export, target)
        result = write_format(target, export, out, approximate=approximate, free_scale=free_scale)
        result = replace(result, remarks=(*more, *result.remarks))
        return len(result.files), result.remarks, result.deviation_px
    from raybundle.io.block.folder import write_block  # noqa: PLC0415

    _check_block(export.block)
    write_block(export.block, out)
    return 1, (), 0.0


def fit_for(export: Export, target: str) -> tuple[Export, tuple[str, ...]]:
    """The block as a format of photographs can take it, and remarks; raises InputError where scenes do not fit in."""
    if not any(c.is_scene for c in export.block.cameras):
        return export, ()
    from raybundle.io.scene_export import names_of_scenes, scene_images, with_viewpoints, without_scenes  # noqa: PLC0415

    names = names_of_scenes(export.block)
    if target in POINTS:
        told = f"satellite scenes ({names}) give points; their stations are nominal viewpoints, 600 km up"
        return replace(export, block=with_viewpoints(export.block)), (told,)
    if target in STATIONS and not scene_images(export.block).all():
        return replace(export, block=without_scenes(export.block)), (f"satellite scenes are left out: {names}",)
    raise InputError(
        f"format {target} holds central projections only, and this block has satellite scenes ({names}); "
        f"{BLOCK} and {RPC} carry them, {' and '.join(POINTS)} their points"
    )


def _check_block(block: Block) -> None:
    if len(block.observations) == 0:
        raise InputError(
            f"block {block.name} has no image observations, which a block folder needs; convert it to another format"
        )
