"""Product: a true orthophoto as GeoTIFF, and from which photograph each pixel is and how far it may be off."""

from __future__ import annotations

from pathlib import Path

from raybundle.io.raster_library import raster_library
from raybundle.results.record import STATE
from raybundle.surfaces.orthophoto_files import FILES, write_orthophoto
from raybundle.surfaces.product import Context, Product, Written, register
from raybundle.surfaces.run import Surface


def _write(surface: Surface, out: Path, context: Context) -> Written:
    assert context.plane is not None
    reported = write_orthophoto(surface, context.plane, context.unit, out, context.export.record.get(STATE, ""))
    return Written(files=tuple(out / f for f in FILES), reported=reported)


def _check() -> None:
    raster_library()


PRODUCT = register(Product(name="ortho", files=FILES, write=_write, check=_check))
