"""Objects of a plan as they are reported: a kind with its size or line, a mesh, a raster of heights, a result."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError

if TYPE_CHECKING:
    from raybundle.block import Block
    from raybundle.numerics.arrays import Array
    from raybundle.objects.kinds import ObjectKind
    from raybundle.objects.surface import Surface

STEP = 0.02
"""Extent below which an object is rather stated in another unit [m]"""
RASTERS = (".tif", ".tiff", ".vrt", ".asc", ".img")


def surface_of(text: str, unit: float = 1.0, crs: str = "") -> tuple[Surface, str]:
    """The surface of an object, and the side from which it is photographed: round, front or above.

    text  KIND:NUMBERS, KIND:FILE,NUMBERS with an outline or axis, or the path of a mesh, a raster or a result
    unit  metres of one unit of a mesh
    crs   coordinate system in which a raster or an outline is wanted, where it is not its own
    """
    from raybundle.io.meshes import SUFFIXES, read_mesh
    from raybundle.objects.kinds import object_kinds

    name, colon, rest = text.partition(":")
    if colon and name in object_kinds:
        return _of_kind(object_kinds[name], text, rest, crs), object_kinds[name].side
    path = Path(text)
    suffix = path.suffix.lower()
    if suffix in SUFFIXES:
        surface = read_mesh(path, unit)
        if surface.extent < STEP:
            raise InputError(
                "mesh.too_small", extent_mm=1000 * surface.extent, unit_m=unit, least_mm=1000 * STEP, file=path,
            )  # fmt: skip
        return surface, "round"
    if suffix in RASTERS:
        from raybundle.io.geo.rasters import read_all_heights
        from raybundle.objects.heights import surface_of_heights

        return surface_of_heights(read_all_heights(path, crs), path.stem), "above"
    if path.is_dir():
        from raybundle.planning.network.of_result import surface_of_result

        return surface_of_result(block_in(path)), "round"
    raise InputError(
        "object.unknown",
        text=text,
        kinds=[example(k) for k in sorted(object_kinds)],
        meshes=list(SUFFIXES),
        rasters=list(RASTERS),
    )


def block_in(folder: Path) -> Block:
    """The block of a result, of a project's result, of a plan, or that folder itself."""
    from raybundle.io.block.folder import read_block
    from raybundle.measuring.session import block_folder

    return read_block(block_folder(folder))


def adjusted_block_in(folder: Path, threads: int = 0) -> tuple[Block, bool]:
    """The same with coordinates of all that was seen, and whether they had to be found for it.

    They stand in the frame of what was given, control and positions first; what was given stays as it was given.
    """
    import numpy as np

    block = block_in(folder)
    seen = np.unique(block.observations.point)
    if np.isfinite(block.points.xyz[seen]).all():
        return block, False
    from raybundle.adjustment.readjust import block_again
    from raybundle.adjustment.records.options import AdjustmentOptions
    from raybundle.workflows.adjust import adjust

    return block_again(adjust(block, AdjustmentOptions(statistics=False, jobs=threads))), True


def example(name: str) -> str:
    """A kind of object as one may type it."""
    from raybundle.objects.kinds import object_kinds

    return f"{name}:" + ",".join(f"{v:g}" for v in object_kinds[name].example)


def _of_kind(kind: ObjectKind, text: str, rest: str, crs: str) -> Surface:
    first, _, others = rest.partition(",")
    line: Array | None = None
    if Path(first).suffix and not _number(first):
        from raybundle.io.outlines import read_outline

        line, rest = read_outline(Path(first), crs), others
    words = [w for w in rest.replace("x", ",").split(",") if w.strip()]
    if not all(_number(w) for w in words):
        raise InputError("object.number_form", text=text, name=kind.name, needs=kind.words, example=example(kind.name))
    return kind.surface([float(w) for w in words], line)


def _number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True
