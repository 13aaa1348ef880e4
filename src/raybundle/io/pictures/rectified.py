"""Pictures of a plane: put together from photographs, written with a world file and a description beside them."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.block import Camera
from raybundle.errors import InputError, phrase
from raybundle.io.folders import check_free, new_files
from raybundle.io.pictures.geotiff import TAGS, system_file, system_text, tags_of, write_geotiff
from raybundle.io.pictures.resampling import between, sampled
from raybundle.io.pictures.undistort import opened_photo
from raybundle.io.raster_library import found_raster_library
from raybundle.numerics.arrays import Array, Mask

TILE = 128
"""Cells of the coarse map on a side that are worked on together."""
WORLD = {".tif": ".tfw", ".tiff": ".tfw", ".png": ".pgw", ".jpg": ".jgw", ".jpeg": ".jgw"}
"""Suffixes of pictures and of their world files."""
TIFF = (".tif", ".tiff")
MAP_DIGITS = 15
"""Significant digits of a world file in a map: all that a double holds."""


@dataclass(slots=True)
class Rectified:
    """A picture on its way: colours (height, width, 3), and which pixels have any."""

    colours: Array
    seen: Mask
    shares: dict[str, float] = field(default_factory=dict[str, float])
    """Photograph -> share of the picture that comes from it."""
    slope: tuple[float, float] = (0.0, 0.0)
    """Root mean square and largest tangent of the angle between the rays that were used and the plane's normal."""

    @staticmethod
    def empty(height: int, width: int) -> Rectified:
        """A picture without anything."""
        return Rectified(colours=np.zeros((height, width, 3), np.uint8), seen=np.zeros((height, width), bool))

    @staticmethod
    def photograph(folders: Sequence[Path], name: str, camera: Camera | None) -> Array:
        """Colours (h, w, 3) uint8 of a photograph as stored; raises what opening it raises."""
        folder = next((f for f in folders if (f / name).is_file()), folders[0] if folders else Path())
        pixels = np.asarray(opened_photo(folder, name, camera))
        if pixels.dtype != np.uint8:
            pixels = (pixels / 257).astype(np.uint8)
        return np.repeat(pixels[..., None], 3, axis=2) if pixels.ndim == 2 else pixels[..., :3]

    def add(self, name: str, pixels: Array, at: Array, chosen: Mask, step: int) -> None:
        """Take the chosen cells (m, n) from a photograph whose places [px] at the cells' corners are (m, n, 2)."""
        height, width = self.seen.shape
        taken = 0
        cells = chosen[:-1, :-1] | chosen[1:, :-1] | chosen[:-1, 1:] | chosen[1:, 1:]
        for row in range(0, cells.shape[0], TILE):
            for column in range(0, cells.shape[1], TILE):
                part = cells[row : row + TILE, column : column + TILE]
                if not part.any():
                    continue
                m, n = part.shape
                top, left = row * step, column * step
                h, w = min(m * step, height - top), min(n * step, width - left)
                xy = between(at[row : row + m + 1, column : column + n + 1], step)[:h, :w]
                mine = _nearest(chosen, row, column, m, n, step)[:h, :w]
                target = (slice(top, top + h), slice(left, left + w))
                mine = mine & ~self.seen[target]
                if not mine.any():
                    continue
                found, inside = sampled(pixels, xy)
                mine &= inside
                self.colours[target][mine] = found[mine]
                self.seen[target] |= mine
                taken += int(mine.sum())
        if taken:
            self.shares[name] = taken / (height * width)

    def write(
        self, path: Path, *, left: float, top: float, pixel: float, about: Mapping[str, Any], wkt: str = "",
        record: Mapping[str, str] | None = None,
    ) -> tuple[str, ...]:  # fmt: skip
        """Write the picture, its world file and NAME.toml; remarks.

        wkt     the coordinate system of left and top: a TIFF becomes a GeoTIFF where rasterio is there, and beside all
                others stands a file that names the system
        record  what is stated of the delivery: object, operator and rights stand in tags of TIFF and JPEG
        raises  InputError for a suffix that is none of a picture
        """
        from PIL import Image

        suffix, remarks = path.suffix.lower(), tuple[str, ...]()
        library = found_raster_library() if wkt and suffix in TIFF else None
        digits, tags = MAP_DIGITS if wkt else 12, tags_of(record or {})
        if suffix in {".jpg", ".jpeg"}:
            picture = Image.fromarray(np.where(self.seen[..., None], self.colours, 255).astype(np.uint8))
            options: dict[str, Any] = {"quality": 95, "subsampling": 0, "exif": _exif(tags)}
        else:
            picture = Image.fromarray(np.dstack([self.colours, np.where(self.seen, 255, 0).astype(np.uint8)]))
            options = {"compression": "tiff_deflate", "tiffinfo": _exif(tags)} if suffix in TIFF else {}
        world = [pixel, 0.0, 0.0, -pixel, left + pixel / 2, top - pixel / 2]
        beside = (path.with_suffix(".toml"), path.with_suffix(WORLD[suffix]), system_file(path))
        with new_files(*beside, path) as (header, placed, system, file):
            if library is not None:
                write_geotiff(library, file, self.colours, self.seen, left=left, top=top, pixel=pixel, wkt=wkt,
                              tags=tags)  # fmt: skip
            else:
                picture.save(file, **options)
                if wkt:
                    system.write_text(system_text(wkt), encoding="utf-8")
            placed.write_text("".join(f"{v:.{digits}g}\n" for v in world), encoding="ascii")
            header.write_text(toml_text(about), encoding="utf-8")
        if not (wkt and library is None):
            system_file(path).unlink(missing_ok=True)  # of an older picture that is overwritten
        if wkt and library is None:
            remarks = (phrase("conversion.system_beside", name=system_file(path).name, tiff=suffix in TIFF),)
        return remarks


def _exif(tags: Mapping[str, str]) -> Any:
    """Tags as Pillow writes them, in UTF-8: ASCII, of which TIFF speaks, has no umlauts."""
    from PIL import Image

    found = Image.Exif()
    for name, words in {**tags, "Software": "raybundle"}.items():
        found[TAGS[name]] = words.encode()
    return found


def check_picture(path: Path) -> None:
    """Raise InputError where a picture cannot or must not be written to this file."""
    if path.suffix.lower() not in WORLD:
        raise InputError("picture.suffix", known=sorted(WORLD), file=path)
    for file in (path, path.with_suffix(WORLD[path.suffix.lower()]), path.with_suffix(".toml"), system_file(path)):
        check_free(file)
    if not path.parent.is_dir():
        raise InputError("folder.missing", file=path)


def _nearest(chosen: Mask, row: int, column: int, m: int, n: int, step: int) -> Mask:
    """Whether the nearest corner of the coarse map is chosen, for every pixel of some cells."""
    i = row + (np.arange(m * step) + step // 2) // step
    j = column + (np.arange(n * step) + step // 2) // step
    return chosen[np.minimum(i, chosen.shape[0] - 1)[:, None], np.minimum(j, chosen.shape[1] - 1)]


def toml_text(about: Mapping[str, Any]) -> str:
    """What NAME.toml beside a picture states, as text."""
    lines: list[str] = []
    for key, value in about.items():
        if isinstance(value, Mapping):
            lines += [
                "",
                f"[{key}]",
                *(f"{json.dumps(k, ensure_ascii=False)} = {json.dumps(v)}" for k, v in value.items()),
            ]
        else:
            lines.append(f"{key} = {json.dumps(value, ensure_ascii=False)}")
    return "\n".join(lines) + "\n"
