"""Steps of a conversion: to the frame asked for, to what a format can take, and into it."""

from __future__ import annotations

import re
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np

from raybundle.block import Block, Role
from raybundle.errors import InputError, message_of_text, phrase
from raybundle.io.block.folder import write_block
from raybundle.io.block.scenes import local_in
from raybundle.io.folders import check_free, new_folder
from raybundle.io.formats import Export, format_named, formats, write_format
from raybundle.io.geo.coordinate_systems import LocalFrame, in_other_projection, local_frame
from raybundle.io.pictures.undistort import undistorted_block, write_undistorted
from raybundle.io.scene_export import names_of_scenes, scene_images, with_viewpoints, without_scenes, write_rpcs
from raybundle.io.table_files import TableFormat
from raybundle.numerics.arrays import Mask
from raybundle.numerics.places import Place
from raybundle.numerics.progress import Progress
from raybundle.workflows.block_frame import moved_to
from raybundle.workflows.sources import BLOCK

RPC = "rpc"
"""The word for the RPC of satellite scenes among the formats."""
WRITABLE = (BLOCK, RPC, *sorted(n for n, f in formats.items() if f.write))
POINTS, MAPS, STATIONS = ("las", "ply"), ("dxf", "gpkg"), ("geojson", "kml")
"""Formats that take the points of satellite scenes; those of them that hold photographs, too; and formats of stations
on a map, which scenes are not."""


def named_for(out: Path, target: str) -> Path:
    """A name with the ending of a format that is one file, where it has none.

    What stands after a point may be no ending: facade-1.2.
    """
    suffix = "" if target in {BLOCK, RPC} else format_named(target).suffix
    if not suffix or re.fullmatch(r"\.[a-z][a-z0-9]+", out.suffix.lower()):
        return out
    return out.with_name(f"{out.name}{suffix}")


def check_new(out: Path, target: str) -> None:
    """Raise InputError where a format cannot be written to a path: before all the work, not after it."""
    check_free(out)
    suffix = "" if target in {BLOCK, RPC} else format_named(target).suffix
    allowed = {suffix, ".laz"} if suffix == ".las" else {suffix}
    if suffix and out.suffix.lower() not in allowed:
        raise InputError("format.file_suffix", format=target, suffix=suffix, file=out)


def placed(
    export: Export, crs: str, origin: tuple[float, float, float] | None, undulation: float | None
) -> tuple[Export, tuple[str, ...]]:
    """The block in a local frame of a coordinate system, and remarks; without an origin it stands in the system.

    A result that knows its frame is reported in another projection of the same datum.
    """
    if origin is not None:
        frame = local_frame(crs, origin, undulation_m=undulation)
        block = replace(export.block, place=_place(export.block, frame))
        return replace(export, block=block, frame=frame, map_sigma=None, map_station_sigma=None), frame.remarks
    block = export.block
    if export.frame is not None:
        if undulation is not None:
            raise InputError("block.heights_defined", block=block.name)
        frame = in_other_projection(export.frame, crs)
        # the covariances of the result are at hand along the axes of its own system alone
        return replace(export, frame=frame, map_sigma=None, map_station_sigma=None), frame.remarks
    if block.place is not None:
        raise InputError("block.place_defined", block=block.name)
    if block.length_unit != "m":
        raise InputError("block.origin_missing", block=block.name, unit=block.length_unit, system=crs)
    oriented = block.images.oriented
    middle = block.images.centre[oriented].mean(axis=0) if oriented.any() else np.nanmean(block.points.xyz, axis=0)
    frame = local_frame(crs, middle, undulation_m=undulation)
    remark = phrase("conversion.local_frame", system=crs, **dict(zip("xyz", middle, strict=True)))
    block = replace(moved_to(block, frame), place=_place(block, frame))
    return replace(export, block=block, frame=frame), (remark, *frame.remarks)


def _place(block: Block, frame: LocalFrame) -> Place | None:
    """What block.toml states of a frame; of a block with scenes, or in millimetres, what it stated before."""
    if block.length_unit != "m" or any(c.is_scene for c in block.cameras):
        return block.place
    return local_in(frame.crs, frame.origin, frame.undulation_m)


@contextmanager
def straightened(
    export: Export, photos: Path, folder: Path, area: Literal["inside", "all"], progress: Progress
) -> Generator[tuple[Export, tuple[str, ...]]]:
    """The block with pinhole cameras, and remarks; its photographs without distortion in a new folder.

    The folder takes its name when the body, which writes the model, ends without an error; else nothing is left.
    """
    check_free(folder)
    with new_folder(folder) as temporary:
        remarks = write_undistorted(export.block, photos, temporary, area=area, progress=progress)
        if not any(p.is_file() for p in temporary.rglob("*")):
            raise InputError("photograph.none_readable", details=[message_of_text(remarks[0])], file=photos)
        block, more = undistorted_block(export.block, area=area)
        yield replace(export, block=block), (*remarks, *more)


def written(
    export: Export,
    target: str,
    out: Path,
    *,
    approximate: bool = False,
    free_scale: bool = False,
    tables: TableFormat = "auto",
) -> tuple[int, tuple[str, ...], float]:
    """Write; the number of files, remarks, and the largest deviation of a camera [px]."""
    if target == RPC:
        with new_folder(out) as folder:
            files, remarks = write_rpcs(export, folder)
        return len(files), remarks, 0.0
    if target != BLOCK:
        export, more = fit_for(export, target)
        result = write_format(target, export, out, approximate=approximate, free_scale=free_scale)
        result = replace(result, remarks=(*more, *result.remarks))
        return len(result.files), result.remarks, result.deviation_px
    _check_block(export.block)
    write_block(export.block, out, tables=tables)
    return 1, (), 0.0


def fit_for(export: Export, target: str) -> tuple[Export, tuple[str, ...]]:
    """The block as a format of photographs can take it, and remarks; raises InputError where scenes do not fit in."""
    if not any(c.is_scene for c in export.block.cameras):
        return export, ()
    names = names_of_scenes(export.block)
    if target in MAPS:
        line = phrase("conversion.scenes_without_stations", scenes=names)
        return replace(export, block=with_viewpoints(export.block), nominal=scene_images(export.block)), (line,)
    if target in POINTS:
        line = phrase("conversion.scenes_nominal_stations", scenes=names)
        return replace(export, block=with_viewpoints(export.block)), (line,)
    if target in STATIONS and not scene_images(export.block).all():
        return replace(export, block=without_scenes(export.block)), (phrase("conversion.no_scenes", scenes=names),)
    raise InputError("format.no_scenes", format=target, scenes=names, whole=[BLOCK, RPC], points=[*MAPS, *POINTS])


def held(block: Block, target: str) -> tuple[int, int, tuple[str, ...]]:
    """Points and image observations of a block that a format holds, and a remark on the others.

    Points without coordinates and images without orientation have remarks of their own.
    """
    if target == BLOCK:
        return len(block.points), len(block.observations), ()
    o = block.observations
    known: Mask = np.asarray(np.isfinite(block.points.xyz).all(axis=1))
    seen = block.images.oriented[o.image] & known[o.point]
    which = "none" if target == RPC else format_named(target).points
    kept: Mask = known & {"all": True, "named": block.points.role != Role.TIE, "none": np.False_}[which]
    points = int(kept.sum())
    observations = int((seen & kept[o.point]).sum()) if target == RPC or format_named(target).observations else 0
    lost = int(known.sum()) - points, int(seen.sum()) - observations
    remark = (phrase("conversion.not_held", points=lost[0], observations=lost[1]),) if any(lost) else ()
    return points, observations, remark


def _check_block(block: Block) -> None:
    if len(block.observations) == 0:
        raise InputError("block.folder_needs_observations", block=block.name)
