"""What has moved, as files: differences and their significance as GeoTIFF, regions as table and outlines, a picture."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from raybundle.io.drawings import Drawn, write_geojson, write_gpkg
from raybundle.io.folders import new_folder
from raybundle.numerics.arrays import Array
from raybundle.surfaces.files.detection_picture import detection_picture
from raybundle.surfaces.files.displacement_picture import write_picture
from raybundle.surfaces.files.input import Opened
from raybundle.surfaces.heights.contours import ring_lines
from raybundle.surfaces.heights.displacement import Movements, Region
from raybundle.surfaces.heights.height_model import HeightModel
from raybundle.surfaces.heights.level_of_detection import DetectionMap, SmallestMovement

RASTER, TABLE, LINES, LAYER, PICTURE = "difference.tif", "moved.csv", "moved.geojson", "moved.gpkg", "difference.png"
SMALLEST, DETECTABLE, DETECTABLE_PICTURE = "smallest.csv", "detectable.tif", "detectable.png"
MOSTLY = 0.8
"""Share of a surface on which the picture has a level of detection"""
BANDS = ("difference", "sigma", "movement against the rest", "sigma of that", "significance", "region")
COLUMNS = (
    "region", "x", "y", "area", "area_sigma", "mean", "mean_sigma", "amount", "amount_sigma", "volume", "volume_sigma",
    "outline_sigma", "peak",
)  # fmt: skip
SMALLEST_LINE = "# of squares: the smallest movement found with a chance of 80 %, in the median and in the best quarter"
NOT_KNOWN_LINE = (
    "# empty, or no row: not known for squares of this size; windows of other sizes may find movements of them"
)
COLUMNS_LINE = "# mean: volume / area; amount: movement of the inner part, where the outline does not count"


def write_movements(
    o: Opened, model: HeightModel, found: Movements, smallest: tuple[SmallestMovement, ...], out: Path
) -> tuple[Path, ...]:
    """Write all files into a new folder."""
    number = np.zeros(model.shape, np.float32)
    for k, r in enumerate(found.regions, 1):
        number[r.cells] = k
    bands = (
        model.heights.height,
        np.where(model.known, model.sigma, np.nan),
        found.local,
        found.sigma,
        found.peak,
        number,
    )
    names = [RASTER, TABLE, LINES, LAYER, SMALLEST, PICTURE]
    with new_folder(out) as new:
        with o.file.new(new / RASTER, BANDS) as write:
            write(0, 0, np.stack(bands, axis=2).astype(np.float32))
        rows = [_row(o, k, r) for k, r in enumerate(found.regions, 1)]
        unit = o.unit or "no unit: the scale is free"
        lines = [
            f"# lengths in {unit}",
            COLUMNS_LINE,
            ",".join(COLUMNS),
            *(",".join(f"{v:.8g}" for v in row) for row in rows),
        ]
        (new / TABLE).write_text("\n".join(lines) + "\n", encoding="utf-8")
        drawn = [d for row, r in zip(rows, found.regions, strict=True) for d in _areas(o, row, r)]
        write_geojson(new / LINES, drawn, o.file.wkt)
        if drawn:
            write_gpkg(new / LAYER, drawn, "moved", o.file.wkt)
        else:
            names.remove(LAYER)
        (new / SMALLEST).write_text("\n".join([*lines[:1], *_would(smallest)]) + "\n", encoding="utf-8")
        write_picture(str(new / PICTURE), o, model, found, smallest)
        maps = found.detectable(model)
        if maps:
            sides = tuple(f"detectable over {m.side:.3g} x {m.side:.3g} {o.unit}".rstrip() for m in maps)
            with o.file.new(new / DETECTABLE, sides) as write:
                amounts = np.stack([m.amount for m in maps], axis=2)
                write(0, 0, np.where(np.isfinite(amounts), amounts, np.nan).astype(np.float32))
            detection_picture(o, _shown(maps)).save(new / DETECTABLE_PICTURE)
            names += [DETECTABLE, DETECTABLE_PICTURE]
    return tuple(out / n for n in names)


def _shown(maps: Sequence[DetectionMap]) -> DetectionMap:
    """That of the smallest squares with a known level of detection on most of the surface, else of the largest."""
    return next((m for m in maps if np.isfinite(m.amount).sum() > MOSTLY * (~np.isnan(m.amount)).sum()), maps[-1])


def _would(smallest: tuple[SmallestMovement, ...]) -> list[str]:
    """What the table of the smallest movements states."""
    rows = [",".join("" if np.isnan(v) else f"{v:.4g}" for v in (s.side, s.amount, s.best))
            for s in smallest if np.isfinite(s.best)]  # fmt: skip
    return [SMALLEST_LINE, NOT_KNOWN_LINE, "side,amount,amount_best_quarter", *rows]


def _row(o: Opened, number: int, r: Region) -> list[float]:
    """What the table states of a region."""
    rows, columns = np.nonzero(r.cells)
    x, y = o.places(np.array([[columns.mean() + 0.5, rows.mean() + 0.5]]))[0]
    numbers = (
        r.area, r.area_sigma, r.mean, r.mean_sigma, r.amount, r.amount_sigma, r.volume, r.volume_sigma, r.edge, r.peak
    )  # fmt: skip
    return np.array([number, x, y, *numbers], float).tolist()


def _areas(o: Opened, row: list[float], r: Region) -> list[Drawn]:
    """The outlines of a region: parts that touch at corners alone are areas of their own."""
    rings = [o.places(line) for line in ring_lines(r.cells)]
    fields: dict[str, float | str] = dict(zip(COLUMNS, row, strict=True))
    found = list[Drawn]()
    outer = [ring for ring in rings if _signed(ring) * _signed(max(rings, key=lambda q: abs(_signed(q)))) > 0]
    holes = [ring for ring in rings if not any(ring is q for q in outer)]
    for ring in outer:
        low, high = ring.min(axis=0), ring.max(axis=0)
        own = [h for h in holes if (h.min(axis=0) >= low).all() and (h.max(axis=0) <= high).all()]
        found.append(Drawn(kind="area", rings=(ring, *own), layer="MOVED", fields=fields))
    return found


def _signed(ring: Array) -> float:
    x, y = (ring - ring[0]).T
    return float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) / 2
