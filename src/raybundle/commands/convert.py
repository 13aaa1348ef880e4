"""`raybundle convert`: from blocks, results and the formats of other programs to any of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import MISSING, dataclass, field, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any, Literal

from raybundle.commands.pages import TABLES_HELP
from raybundle.errors import InputError, as_detail, message
from raybundle.numerics.progress import Progress, silent
from raybundle.results.record import STATE
from raybundle.settings import ANY, keywords, made, path_of, setting

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block

APPROXIMATE_HELP = "Also write cameras with deviations above 0.1 px."
FREE_SCALE_HELP = "Allow a result with free scale. Its lengths have no unit."


@dataclass(frozen=True, slots=True, kw_only=True)
class ConvertSettings:
    """What is converted, into what."""

    source: Path
    """block folder, result folder, project of `orient`, or file or folder of another program"""
    read_as: str | None = setting(None, "Format of INPUT.  [default: recognised]", flag="from")
    to: str = setting(
        MISSING, "Format to write, or several, e.g. gpkg,dxf,las. With several, {out} NAME is the beginning of the "
        "file names (NAME.gpkg and so on). Formats that cannot be written are named at the end.",
    )  # fmt: skip
    out: Path = setting(
        MISSING, "New file or folder; nothing is overwritten. A file gets the ending of its format.", metavar="PATH"
    )
    crs: str | None = setting(
        None, "Coordinate system: EPSG:25832, EPSG:25832+7837 or a PROJ string.", metavar="SYSTEM"
    )
    frame_origin: tuple[float, float, float] | None = setting(
        None, "Origin of the block's local east-north-up frame, in {crs}. Without it, the block is in {crs} itself "
        "and is transformed to a local frame in its middle.", metavar="E N H", limits=(ANY, ANY, ANY),
    )  # fmt: skip
    undulation: float | None = setting(
        None, "Height of the geoid above the ellipsoid of WGS 84 or GRS 80, for {crs}.", metavar="M", limits=ANY
    )
    photos: Path | None = setting(
        None, "Folder of the photographs, for colours of points and {undistort}.  [default: as the project states]",
        metavar="FOLDER",
    )  # fmt: skip
    undistort: Literal["inside", "all"] | None = setting(
        None, "Write undistorted photographs into images/ beside {out}, with pinhole cameras. inside: no empty "
        "pixels. all: nothing is cut.",
    )  # fmt: skip
    within: Path | None = setting(
        None, "Plane of the drawing (dxf, gpkg): X right, Y up, Z out of it. Give the NAME.toml that rectify writes "
        "beside a picture; drawing and picture then match.", flag="in", metavar="NAME.toml",
    )  # fmt: skip
    tables: Literal["auto", "csv", "parquet"] = setting("auto", TABLES_HELP)
    approximate: bool = setting(False, APPROXIMATE_HELP)
    free_scale: bool = setting(False, FREE_SCALE_HELP)


@dataclass(frozen=True, slots=True, kw_only=True)
class Converted:
    """What a conversion came to."""

    block: Block
    """as it was given to the writer of the format"""
    points: int
    """in what was written; of several formats in the one with most of them"""
    observations: int
    """image observations, counted in the same way"""
    files: int
    written: tuple[tuple[str, Path], ...]
    """each format with its file or folder"""
    remarks: tuple[str, ...]
    """what was left out, approximated or assumed"""
    deviation_px: float
    """largest deviation of a camera from the given one, over the whole format"""
    state: str = ""
    """why the result is not to be used yet; empty: nothing states it"""
    unread: Mapping[str, int] = field(default_factory=dict[str, int])
    """number of elements of INPUT that its reader passed over, by kind"""


@keywords(ConvertSettings)
def convert(
    source: str | Path | Block | Adjustment, out: str | Path, *, to: str, progress: Progress = silent, **settings: Any
) -> Converted:
    """Convert a block, a result or the files of another program; what is written stands in `out`.

    source    a folder or file, or a block or adjustment of this program; of a result, or a project of `orient`, the
              adjusted values, without rejected observations
    out       new file or folder; nothing is overwritten
    to        "colmap", "opf", "ply" ..., "block", "rpc"; "gpkg,dxf" for files that begin with the name `out`
    settings  as of the command line, by the names of `ConvertSettings`: crs="EPSG:25832", undistort="inside"
    raises    InputError for what cannot be read or written, and where a camera would deviate by more than 0.1 px

    Limits: what the format cannot hold is lost; the remarks of the answer name what had to be changed.
    """
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block

    if isinstance(source, Block | Adjustment):
        with TemporaryDirectory() as room:
            folder = _folder_of(source, Path(room))
            return convert(folder, out, to=to, progress=progress, **settings)
    given = {"source": path_of("source", source), "out": path_of("out", out), "to": to, **settings}
    return run_convert(made(ConvertSettings, given), progress)


def _folder_of(source: Block | Adjustment, room: Path) -> Path:
    """The folder of a block or a result that is in memory."""
    from raybundle.block import Block
    from raybundle.io.block.folder import write_block
    from raybundle.report.write import write_result

    if isinstance(source, Block):
        write_block(source, room / "block")
        return room / "block"
    write_result(source, room / "result", report="none")
    return room / "result"


def run_convert(settings: ConvertSettings, progress: Progress = silent) -> Converted:
    """Read, bring to the frame asked for, and write: one format after the other."""
    from raybundle.workflows.convert import named_for

    each = tuple(dict.fromkeys(name.strip() for name in settings.to.split(",")))
    if len(each) == 1:
        return _to_one(replace(settings, out=named_for(settings.out, settings.to)), progress)
    places = _places(settings.out, each)
    done: list[Converted] = []
    failed: list[tuple[str, InputError]] = []
    for to, place in places:
        try:
            done.append(_to_one(replace(settings, to=to, out=place), progress))
        except InputError as error:
            failed.append((to, error))
    if failed:
        raise _not_all([d.written[0] for d in done], failed)
    return replace(
        done[-1],
        points=max(d.points for d in done),
        observations=max(d.observations for d in done),
        files=sum(d.files for d in done),
        written=places,
        remarks=tuple(dict.fromkeys(r for d in done for r in d.remarks)),
        deviation_px=max(d.deviation_px for d in done),
    )


def _not_all(written: Sequence[tuple[str, Path]], failed: Sequence[tuple[str, InputError]]) -> InputError:
    """What became of formats of which some cannot be written."""
    if not written and len({str(error) for _, error in failed}) == 1:
        return failed[0][1]
    details = [message("export.format_failed", details=[as_detail(error)], format=to) for to, error in failed]
    return InputError(
        "export.formats_failed", details=details, n=len(failed), written=len(written),
        places=[str(place) for _, place in written],
    )  # fmt: skip


def _places(out: Path, each: tuple[str, ...]) -> tuple[tuple[str, Path], ...]:
    """Where each of several formats goes; raises InputError before anything is written."""
    from raybundle.io.formats import formats
    from raybundle.workflows.convert import check_new

    folders = [to for to in each if to not in formats or formats[to].kind != "file"]
    if folders:
        raise InputError("export.not_one_file", formats=folders)
    places = tuple((to, out.with_name(f"{out.name}{formats[to].suffix}")) for to in each)
    if len({place for _, place in places}) < len(places):
        raise InputError("export.same_file", formats=list(each))
    for to, place in places:
        check_new(place, to)
    return places


def _to_one(settings: ConvertSettings, progress: Progress) -> Converted:
    """Read, bring to the frame asked for, and write."""
    from raybundle.block.frames import in_file_frames
    from raybundle.io.cameras.single_exposure import at_one_instant
    from raybundle.io.formats import formats
    from raybundle.io.pictures.plane_file import axes_in, underlay_of
    from raybundle.io.pictures.undistort import point_colours
    from raybundle.pipeline.project import photographs_of
    from raybundle.workflows.convert import BLOCK, RPC, check_new, held, placed, straightened, written
    from raybundle.workflows.sources import (
        read_source,
        recognised,
        result_within,
        with_adjusted_cameras,
        with_two_rays,
    )

    s, to = settings, settings.to
    if (s.frame_origin is not None or s.undulation is not None) and s.crs is None:
        raise InputError("crs.needed_by_settings")
    if s.within is not None and (to in {BLOCK, RPC} or not formats[to].in_plane):
        known = sorted(name for name, f in formats.items() if f.in_plane)
        raise InputError("format.not_in_plane", format=to, known=known)
    if s.tables != "auto" and to != BLOCK:
        raise InputError("format.no_tables", format=to)
    check_new(s.out, to)
    source = result_within(s.source) if s.read_as in {None, BLOCK} else s.source
    known = photographs_of(source)
    photos = s.photos or (known[0] if len(known) == 1 else None)
    if s.undistort and photos is None:
        raise InputError("photograph.folder_unknown", file=s.source)
    export, remarks = read_source(source, s.read_as, approximate=s.approximate)
    if to == BLOCK and (s.read_as or recognised(source)) != BLOCK:
        block, more = with_two_rays(export.block)
        export = replace(export, block=block, colours=None)
        remarks += more
    if s.crs is not None:
        export, more = placed(export, s.crs, s.frame_origin, s.undulation)
        remarks += more
    if to != BLOCK:
        export = replace(export, block=with_adjusted_cameras(export.block, source))
    if to not in {BLOCK, RPC} or s.undistort:
        block, more = at_one_instant(export.block)
        export = replace(export, block=block)
        remarks += more
    if to != BLOCK or s.undistort:
        export = replace(export, block=in_file_frames(export.block))
    if s.within is not None:
        axes, frame = axes_in(s.within, export), export.frame
        export = replace(
            export, within=axes, frame=frame if axes is None else None, underlay=underlay_of(s.within, s.out.parent)
        )  # fmt: skip
    coloured = to not in {BLOCK, RPC} and formats[to].colours
    if folders := (s.photos,) if s.photos is not None else known if coloured else ():
        colours, more = point_colours(export.block, folders, progress=progress)
        export = replace(export, colours=colours)
        remarks += more
    with ExitStack() as pictures:  # they take their name when the model has its own
        if s.undistort and photos is not None:
            images = s.out.parent / "images"
            export, more = pictures.enter_context(straightened(export, photos, images, s.undistort, progress))
            remarks += more
        progress("writing", 0.0)
        files, more, deviation = written(
            export, to, s.out, approximate=s.approximate, free_scale=s.free_scale, tables=s.tables
        )
    progress("writing", 1.0)
    points, observations, left_out = held(export.block, to)
    every = tuple(dict.fromkeys((*remarks, *more, *left_out)))
    return Converted(
        block=export.block, points=points, observations=observations, files=files, written=((to, s.out),),
        remarks=every, deviation_px=deviation, state=export.record.get(STATE, ""), unread=export.unread,
    )  # fmt: skip
