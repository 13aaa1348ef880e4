"""Pictures of a plane: put together from photographs, written with a world file and a description beside them."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.block import Camera
from raybundle.errors import InputError
from raybundle.io.folders import new_files
from raybundle.io.pictures.undistort import opened_photo
from raybundle.numerics.arrays import Array, Mask

TILE = 128
"""Cells of the coarse map on a side that are worked on together."""
WORLD = {".tif": ".tfw", ".tiff": ".tfw", ".png": ".pgw", ".jpg": ".jgw", ".jpeg": ".jgw"}
"""Suffixes of pictures and of their world files."""


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
        import cv2  # noqa: PLC0415  (only where photographs are written)

        height, width = self.seen.shape
        limit = np.array(pixels.shape[1::-1], float)
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
                xy = _between(at[row : row + m + 1, column : column + n + 1], step)[:h, :w]
                mine = _nearest(chosen, row, column, m, n, step)[:h, :w]
                mine = mine & np.isfinite(xy).all(axis=2) & ((xy >= 0) & (xy <= limit)).all(axis=2)
                target = (slice(top, top + h), slice(left, left + w))
                mine &= ~self.seen[target]
                if not mine.any():
                    continue
                # the library counts from the centre of the first pixel
                found = cv2.remap(
                    pixels, (xy[..., 0] - 0.5).astype(np.float32), (xy[..., 1] - 0.5).astype(np.float32),
                    interpolation=cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE,
                )  # fmt: skip
                self.colours[target][mine] = found[mine]
                self.seen[target] |= mine
                taken += int(mine.sum())
        if taken:
            self.shares[name] = taken / (height * width)

    def write(self, path: Path, *, left: float, top: float, pixel: float, about: Mapping[str, Any]) -> None:
        """Write the picture, its world file and NAME.toml; raises InputError for a suffix that is none of a picture."""
        from PIL import Image  # noqa: PLC0415

        suffix = path.suffix.lower()
        if suffix in {".jpg", ".jpeg"}:
            picture = Image.fromarray(np.where(self.seen[..., None], self.colours, 255).astype(np.uint8))
            options: dict[str, Any] = {"quality": 95, "subsampling": 0}
        else:
            picture = Image.fromarray(np.dstack([self.colours, np.where(self.seen, 255, 0).astype(np.uint8)]))
            options = {"compression": "tiff_deflate"} if suffix in {".tif", ".tiff"} else {}
        world = [pixel, 0.0, 0.0, -pixel, left + pixel / 2, top - pixel / 2]
        with new_files(path.with_suffix(".toml"), path.with_suffix(WORLD[suffix]), path) as (told, placed, file):
            picture.save(file, **options)
            placed.write_text("".join(f"{v:.12g}\n" for v in world), encoding="ascii")
            told.write_text(_toml(about), encoding="utf-8")


def check_picture(path: Path) -> None:
    """Raise InputError where a picture cannot or must not be written to this file."""
    if path.suffix.lower() not in WORLD:
        raise InputError(f"a picture needs a name that ends in {', '.join(sorted(WORLD))}", file=path)
    for file in (path, path.with_suffix(WORLD[path.suffix.lower()]), path.with_suffix(".toml")):
        if file.exists():
            raise InputError("stands there already and is not overwritten; choose another name", file=file)
    if not path.parent.is_dir():
        raise InputError("its folder does not exist; make it first", file=path)


def _between(at: Array, step: int) -> Array:
    """Places at every pixel of cells, linear between their corners (m + 1, n + 1, 2)."""
    m, n = at.shape[0] - 1, at.shape[1] - 1
    share = (np.arange(step) / step).astype(np.float32)
    lines = at[:, :-1, None] * (1 - share)[:, None] + at[:, 1:, None] * share[:, None]
    lines = lines.reshape(m + 1, n * step, 2)
    whole = lines[:-1, None] * (1 - share)[:, None, None] + lines[1:, None] * share[:, None, None]
    return whole.reshape(m * step, n * step, 2)


def _nearest(chosen: Mask, row: int, column: int, m: int, n: int, step: int) -> Mask:
    """Whether the nearest corner of the coarse map is chosen, for every pixel of some cells."""
    i = row + (np.arange(m * step) + step // 2) // step
    j = column + (np.arange(n * step) + step // 2) // step
    return chosen[np.minimum(i, chosen.shape[0] - 1)[:, None], np.minimum(j, chosen.shape[1] - 1)]


def _toml(about: Mapping[str, Any]) -> str:
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
