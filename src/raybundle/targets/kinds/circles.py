"""Rasters of dots: circles-7x5 has 7 dots in a row and 5 rows; acircles-4x11 is staggered, 11 rows of 4 dots."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from raybundle.errors import InputError, phrase
from raybundle.io.reading.words import whole_of
from raybundle.numerics.arrays import Array, Index
from raybundle.targets.detect import DetectionOptions, Detections, detect_targets
from raybundle.targets.lattice import lattices
from raybundle.targets.marks import (
    Kind,
    MarkOptions,
    Marks,
    Target,
    grid_objects,
    nothing,
    register,
    two_seen,
    with_numbers,
)

NAME = re.compile(r"(a?)circles-(\d+)x(\d+)")
MISSING = 0.1
"""Largest share of the dots that may be missing, as long as each side shows one."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Circles:
    """A raster of dots."""

    columns: int
    rows: int
    staggered: bool = False

    @property
    def family(self) -> str:
        """circles-7x5, acircles-4x11."""
        return f"{'a' if self.staggered else ''}circles-{self.columns}x{self.rows}"

    @property
    def title(self) -> str:
        """For people."""
        return f"{'staggered ' if self.staggered else ''}raster of {self.columns} x {self.rows} dots"

    @property
    def objects(self) -> Mapping[str, Array]:
        """Dots in units of the spacing; staggered: of half the spacing within a row, every second row shifted by it."""
        if not self.staggered:
            return grid_objects(self.columns, self.rows)
        return {f"r{r}c{c}": np.array([2 * c + r % 2, -r, 0.0]) for r in range(self.rows) for c in range(self.columns)}

    @property
    def turns(self) -> int:
        """Dots all look alike: only a staggered raster of an even number of rows shows its beginning."""
        if self.staggered:
            return 1 if self.rows % 2 else 2
        return 4 if self.columns == self.rows else 2

    @property
    def radius(self) -> float:
        """Not given by the name."""
        return np.nan

    def find(self, image: Array, options: MarkOptions) -> Marks:
        """Dots of the raster, where no more than a tenth of them is missing."""
        dots = detect_targets(image, None, DetectionOptions(polarity=options.polarity, threads=options.threads))
        total = self.columns * self.rows
        for sign in (-1, 1):
            chosen = dots.rows(dots.polarity == sign)
            found = lattices(chosen.xy_px, chosen.ellipse, max(5, int((1 - MISSING) * total)))
            grids = [g for k in found if (g := self._fits(k.grid(), chosen.xy_px)) is not None]
            if len(grids) > 1:
                return nothing(self.family, two_seen(self.family))
            if grids:
                return marks_of_grid(self.family, chosen, grids[0])
            if found:
                return nothing(self.family, phrase(
                    "target_seen.other_raster", target=self.family, columns=int(found[0].size[0]),
                    rows=int(found[0].size[1]),
                ))  # fmt: skip
        return nothing(self.family, phrase("target_seen.no_raster", target=self.family, n=len(dots)))

    def _fits(self, grid: Index, xy: Array) -> Index | None:
        """Dots (rows, columns) of this raster, -1 where missing, whose first row looks most to the right."""
        ways = [np.rot90(grid, k) for k in range(4)]
        if self.staggered:
            ways = [s for w in ways if (s := _straight(w, self.columns, self.rows)) is not None]
        ways = [w for w in ways if w.shape == (self.rows, self.columns) and (w < 0).mean() <= MISSING]
        return max(ways, key=lambda w: _heading(w, xy), default=None)


def _heading(way: Index, xy: Array) -> float:
    """Cosine of a raster's rows with the image's."""
    r, c = np.nonzero(way >= 0)
    p = xy[way[r, c]]
    J = np.stack([np.ones(len(r)), c, r], axis=1)
    along = np.linalg.lstsq(J, p, rcond=None)[0][1]
    return float(along[0] / max(float(np.hypot(*along)), 1e-9))


def _straight(grid: Index, columns: int, rows: int) -> Index | None:
    """A staggered raster (rows, columns) out of a lattice whose axes are its diagonals; None where it is another."""
    v, u = np.nonzero(grid >= 0)
    x, y = u - v, u + v
    y = y - y.min()
    out = np.full((rows, columns), -1)
    if y.max() >= rows:
        return None
    x = x - x.min()
    # the even rows begin first
    if not (x[y % 2 == 0] % 2 == 0).all() or not (x[y % 2 == 1] % 2 == 1).all() or x.max() >= 2 * columns:
        return None
    out[y, x // 2] = grid[v, u]
    return out


def marks_of_grid(family: str, dots: Detections, grid: Index) -> Marks:
    """The dots of a raster (rows, columns) by name."""
    r, c = np.nonzero(grid >= 0)
    chosen = dots.rows(grid[r, c])
    return Marks(
        family=family, name=tuple(f"r{a}c{b}" for a, b in zip(r, c, strict=True)), xy_px=chosen.xy_px,
        covariance=chosen.covariance, ellipse=chosen.ellipse, gate=chosen.residual,
    )  # fmt: skip


def _make(name: str) -> Target | None:
    if not name.startswith(("circles", "acircles")):
        return None
    match = NAME.fullmatch(name)
    if match is None:
        raise InputError("board.dots_name", name=str(name))
    columns, rows = (whole_of(match[k]) or 0 for k in (2, 3))
    if min(columns, rows) < 3 or max(columns, rows) > 200:
        raise InputError("board.dots_size", name=str(name))
    return Circles(columns=columns, rows=rows, staggered=bool(match[1]))


register(
    "circles",
    Kind(
        form="circles-COLUMNSxROWS, acircles-COLUMNSxROWS (staggered)",
        make=_make,
        names=lambda text: [*with_numbers(text, "circles-{}x{}"), *with_numbers(text, "acircles-{}x{}")],
    ),
)
