"""Lines and areas on a surface as files for CAD and GIS."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from raybundle.io.drawings import Drawn, Label, write_dxf, write_geojson, write_gpkg
from raybundle.surfaces.files.input import Opened


def write_drawn(o: Opened, drawn: Sequence[Drawn], labels: Callable[[], list[Label]], layer: str, path: Path) -> None:
    """A DXF, GeoPackage or GeoJSON by its ending, in the coordinates of the grid; of a map in its system.

    layer  of the GeoPackage; lines and areas together lie on two
    """
    kind = path.suffix.lower()
    if kind == ".dxf":
        about = {"surface": o.file.block or o.folder.name, "unit": o.unit or "none: the scale is free"}
        write_dxf(path, drawn, labels(), o.unit, about)
    elif kind == ".gpkg":
        kinds = list(dict.fromkeys(d.kind for d in drawn))
        for each in kinds:
            name = layer if len(kinds) == 1 else f"{layer}_{each}s"
            write_gpkg(path, [d for d in drawn if d.kind == each], name, o.file.wkt)
    else:
        write_geojson(path, drawn, o.file.wkt)
