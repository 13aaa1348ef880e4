"""Product: heights above a plane as GeoTIFF, their standard deviations, and what is needed to compute with them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from raybundle.io.pictures.geotiff import system_file, system_text
from raybundle.io.raster_library import raster_library
from raybundle.results.fingerprint import FINGERPRINT
from raybundle.results.record import STATE
from raybundle.surfaces.files.heights import FILES, HEIGHTS, HeightFile, write_heights
from raybundle.surfaces.product import Context, Product, Written, register
from raybundle.surfaces.run import Surface

SYSTEM = system_file(Path(HEIGHTS)).name
"""Beside the heights, where programs look for a system that GeoTIFF does not hold: one in three dimensions"""


def _write(surface: Surface, out: Path, context: Context) -> Written:
    assert surface.heights is not None
    assert context.plane is not None
    file = HeightFile.of(surface.heights.grid, context.plane, context.unit, surface.block.name)
    if state := context.export.record.get(STATE):  # travels with all that is made of these heights
        file = replace(file, plane={**file.plane, STATE: state})
    if context.fingerprint:
        file = replace(file, plane={**file.plane, FINGERPRINT: context.fingerprint})
    reported = write_heights(surface, file, out)
    with_height = file.with_heights
    if with_height is None or with_height.is_compound:
        (out / SYSTEM).unlink(missing_ok=True)
    else:
        (out / SYSTEM).write_text(system_text(with_height.to_wkt()), encoding="utf-8")
    return Written(files=tuple(out / f for f in FILES), reported=reported)


def _check() -> None:
    raster_library()


PRODUCT = register(Product(name="dsm", files=(*FILES, SYSTEM), write=_write, check=_check))
