"""What has moved, as files: differences and their significance as GeoTIFF, regions as table and outlines, a picture."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np

from raybundle.io.drawings import Drawn, write_geojson, write_gpkg
from raybundle.io.folders import new_folder
from raybundle.numerics.arrays import Array
from raybundle.surfaces.contours import ring_lines
from raybundle.surfaces.height_model import HeightModel
from raybundle.surfaces.movements import Movements, Region
from raybundle.workflows.heights_read import Opened

RASTER, TABLE, LINES, LAYER, PICTURE = "difference.tif", "moved.csv", "moved.geojson", "moved.gpkg", "difference.png"
BANDS = ("difference", "sigma", "movement against the rest", "sigma of that", "significance", "region")
COLUMNS = (
    "region", "x", "y", "area", "area_sigma", "mean", "mean_sigma", "amount", "amount_sigma", "volume", "volume_sigma",
    "outline_sigma", "peak",
)  # fmt: skip
TOLD = "# mean: volume / area; amount: movement of the inner part, where the outline does not count"
SHOWN_PX = 1600
"""Longer side of the picture"""
SPREAD = 5.0
"""Median standard deviations up to which colours go, at least"""
BLUE, WHITE, RED, GREY = (172, 102, 33), (247, 247, 247), (43, 24, 178), (200, 200, 200)
"""Of what has sunk, stayed, risen and was not measured (BGR; after ColorBrewer's RdBu by Cynthia Brewer)"""


def write_movements(o: Opened, model: HeightModel, found: Movements, out: Path) -> tuple[Path, ...]:
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
    names = [RASTER, TABLE, LINES, LAYER, PICTURE]
    with new_folder(out) as new:
        with o.file.new(new / RASTER, BANDS) as write:
            write(0, 0, np.stack(bands, axis=2).astype(np.float32))
        rows = [_row(o, k, r) for k, r in enumerate(found.regions, 1)]
        unit = o.unit or "no unit: the scale is free"
        told = [f"# lengths in {unit}", TOLD, ",".join(COLUMNS), *(",".join(f"{v:.8g}" for v in row) for row in rows)]
        (new / TABLE).write_text("\n".join(told) + "\n", encoding="utf-8")
        drawn = [d for row, r in zip(rows, found.regions, strict=True) for d in _areas(o, row, r)]
        write_geojson(new / LINES, drawn, o.file.wkt)
        if drawn:
            write_gpkg(new / LAYER, drawn, "moved", o.file.wkt)
        else:
            names.remove(LAYER)
        cv2.imwrite(str(new / PICTURE), picture(model, found, o.unit))
    return tuple(out / n for n in names)


def _row(o: Opened, number: int, r: Region) -> list[float]:
    """What the table says of a region."""
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


def picture(model: HeightModel, found: Movements, unit: str) -> Array:
    """(h, w, 3) uint8 BGR: movements against the rest, red upwards and blue downwards, regions outlined."""
    known = model.known & np.isfinite(found.local)
    size = SPREAD * float(np.median(found.sigma[known]))
    for r in found.regions:
        size = max(size, 1.3 * abs(r.amount))
    share = np.clip(np.where(known, found.local, 0.0) / size, -1, 1)[..., None]
    white, red, blue = (np.array(c, float) for c in (WHITE, RED, BLUE))
    colours = np.where(share > 0, white + share * (red - white), white - share * (blue - white))
    colours[~known] = GREY
    k = max(1, SHOWN_PX // max(model.shape))
    image = np.repeat(np.repeat(np.round(colours).astype(np.uint8), k, axis=0), k, axis=1)
    if max(image.shape) > SHOWN_PX:
        factor = SHOWN_PX / max(image.shape)
        image = cv2.resize(image, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA)
    scale = image.shape[1] / model.shape[1]
    for n, r in enumerate(found.regions, 1):
        lines = ring_lines(r.cells)
        for line in lines:
            cv2.polylines(image, [np.round(line * scale).astype(np.int32)], True, (30, 30, 30), 2, cv2.LINE_AA)
        x, y = (max(lines, key=len).max(axis=0) * scale).astype(int)
        cv2.putText(image, str(n), (int(x) + 4, int(y)), cv2.FONT_HERSHEY_SIMPLEX, 0.7, (30, 30, 30), 2, cv2.LINE_AA)
    return np.concatenate([image, _legend(image.shape[1], size, unit)])


def _legend(width: int, size: float, unit: str) -> Array:
    """Colours and what they are."""
    bar = np.full((88, width, 3), 255, np.uint8)
    white, red, blue = (np.array(c, float) for c in (WHITE, RED, BLUE))
    n = max(60, min(400, width - 120))
    share = np.linspace(-1, 1, n)[:, None]
    bar[12:32, 40 : 40 + n] = np.round(
        np.where(share > 0, white + share * (red - white), white - share * (blue - white))
    )
    for x, text in ((40, f"{-size:.2g}"), (40 + n // 2, "0"), (40 + n, f"+{size:.2g}")):
        (w, _), _ = cv2.getTextSize(text, cv2.FONT_HERSHEY_SIMPLEX, 0.5, 1)
        cv2.putText(bar, text, (max(2, x - w // 2), 52), cv2.FONT_HERSHEY_SIMPLEX, 0.5, (60, 60, 60), 1, cv2.LINE_AA)
    told = f"movement against the rest [{unit or 'no unit: the scale is free'}]; grey: not in both"
    (w, _), _ = cv2.getTextSize(told, cv2.FONT_HERSHEY_SIMPLEX, 0.5, 1)
    size_of = 0.5 * min(1.0, (width - 16) / w)
    cv2.putText(bar, told, (8, 78), cv2.FONT_HERSHEY_SIMPLEX, size_of, (60, 60, 60), 1, cv2.LINE_AA)
    return bar
