"""Cameras of the files of a result that are stored turned or reduced, beside those of the result."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from pathlib import Path

import click

from raybundle.block.frames import stored_ways
from raybundle.cli.common import counted
from raybundle.errors import InputError
from raybundle.io.calibrations import Calibration, Conversion
from raybundle.results.folder import read_result


def calibrations_of_files(folder: Path) -> tuple[Calibration, ...]:
    """A calibration for each way in which files are stored other than their camera has its pixels.

    Where the camera's model cannot be turned, that is printed: the camera of the result is then the only one.
    """
    block = read_result(folder).block
    found: list[Calibration] = []
    for way in stored_ways(block):
        own = block.cameras[way.camera].id
        some = ", ".join(way.images[:5]) + (" ..." if len(way.images) > 5 else "")
        which = f"{counted(len(way.images), 'photograph')} stored {way.words} ({some})"
        try:
            camera = way.camera_of_files(block)
        except InputError as error:
            click.echo(f" caution: camera {own} is not that of {which}: {error.headline}")
            continue
        remark = (
            f"camera {camera.id} is that of {which}; camera {own} is not theirs, unless their pixels are brought to "
            "its frame first"
        )
        found.append(Calibration(id=camera.id, camera=camera, pixel_mm=camera.pixel_mm, remarks=(remark,)))
    return tuple(found)


def with_names(
    conversions: Sequence[Conversion], of_files: AbstractSet[str], out: Path, *, several: bool
) -> list[tuple[Path, list[Conversion]]]:
    """The files to write: one, or one for each stored way beside that of the result where a file holds one camera.

    of_files  ids of the cameras of `calibrations_of_files`
    raises    InputError where one of them is there already
    """
    beside = [c for c in conversions if c.calibration.id in of_files]
    if several or not 0 < len(beside) < len(conversions):
        return [(out, list(conversions))]
    files = [(out, [c for c in conversions if c.calibration.id not in of_files])]
    files += [(out.with_stem(f"{out.stem}-{c.calibration.id}"), [c]) for c in beside]
    for path, _ in files:
        if path.exists():
            raise InputError("stands there already and is not overwritten; choose another name", file=path)
    return files
