"""What actions may name: images with their formats, object points, image observations."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.io.reading.words import quoted


@dataclass(frozen=True, slots=True, kw_only=True)
class Known:
    """Images, points and image observations that exist without anything measured by hand."""

    size_px: Mapping[str, tuple[int, int]]
    """image -> width and height of its file"""
    names: Mapping[str, str]
    """id or file -> image; files without their folder, too, where one image alone has that name"""
    points: frozenset[str] = frozenset()
    block: Block | None = None
    fiducials: tuple[str, ...] = ()
    """fiducial marks of the film that the photographs are scans of; (): they are none"""
    _rows: dict[str, int] = field(default_factory=dict[str, int])

    @classmethod
    def of(cls, block: Block, fiducials: Iterable[str] = ()) -> Known:
        """What a block holds; image points are in the pixels of the files.

        fiducials  names of the fiducial marks, where the photographs are scans of film
        """
        size: dict[str, tuple[int, int]] = {}
        pairs: list[tuple[str, str]] = []
        for i, (name, file) in enumerate(zip(block.images.ids, block.images.file, strict=True)):
            frame = block.images.frames.get(i) or block.cameras[int(block.images.camera[i])]
            size[name] = frame.width_px, frame.height_px
            pairs += [(file, name), (Path(file).name, name)] if file else []
        return cls(
            size_px=size, names=_unique(size, pairs), points=frozenset(block.points.ids), block=block,
            fiducials=tuple(fiducials),
        )  # fmt: skip

    @classmethod
    def of_photos(cls, sizes: Mapping[str, tuple[int, int]]) -> Known:
        """Photographs that no block holds yet: name -> width and height of the file."""
        pairs = [(Path(name).name, name) for name in sizes]
        return cls(size_px=dict(sizes), names=_unique(sizes, pairs))

    def image(self, name: str) -> str:
        """The image that a name means; raises InputError."""
        found = self.names.get(name)
        if found is None:
            raise InputError("mark.unknown_image", image=quoted(name), n=len(self.size_px), known=list(self.size_px))
        return found

    def inside(self, image: str, x: float, y: float) -> None:
        """Raise InputError for a place outside an image."""
        width, height = self.size_px[image]
        if not (0 <= x <= width and 0 <= y <= height):
            raise InputError("mark.outside_image", image=image, x_px=x, y_px=y, width_px=width, height_px=height)

    def observed(self, image: str, point: str) -> bool:
        """Whether the block holds an observation of this point in this image."""
        if self.block is None or point not in self.points:
            return False
        o, b = self.block.observations, self.block
        if not self._rows:
            self._rows.update({f"p{name}": k for k, name in enumerate(b.points.ids)})
            self._rows.update({f"i{name}": k for k, name in enumerate(b.images.ids)})
        i, p = self._rows[f"i{image}"], self._rows[f"p{point}"]
        return bool(np.any(o.image[np.asarray(o.point) == p] == i))

    def pairs(self) -> frozenset[tuple[str, str]]:
        """(image, point) of every image observation of the block."""
        if self.block is None:
            return frozenset()
        o, images, points = self.block.observations, self.block.images.ids, self.block.points.ids
        return frozenset((images[i], points[p]) for i, p in zip(o.image.tolist(), o.point.tolist(), strict=True))


def _unique(ids: Iterable[str], pairs: Iterable[tuple[str, str]]) -> dict[str, str]:
    """Name -> id; an id means itself, a name of several means none."""
    found: dict[str, set[str]] = {}
    for name, image in pairs:
        found.setdefault(name, set()).add(image)
    return {**{n: next(iter(s)) for n, s in found.items() if len(s) == 1}, **{i: i for i in ids}}
