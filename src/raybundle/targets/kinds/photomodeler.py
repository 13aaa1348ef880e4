"""PhotoModeler's calibration sheet: 10 x 10 dots, four of them within a ring of one, two, three or four arcs.

Dots are ordered by their neighbours, and the rings say which is which; two rings are enough, and any number of dots may
be hidden.  The rings keep PhotoModeler's numbers 1001 to 1004, the dots are called r0c0 to r9c9: rows downwards from
the side of 1001 and 1002, columns to the right from that of 1001 and 1003.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from raybundle.errors import phrase
from raybundle.numerics.arrays import Array, Index
from raybundle.targets.detect import DetectionOptions, Detections, detect_targets
from raybundle.targets.kinds.circles import marks_of_grid
from raybundle.targets.lattice import Lattice, lattices
from raybundle.targets.marks import Kind, MarkOptions, Marks, Target, nothing, register, two_seen
from raybundle.targets.rings import circle, frame, sample

FAMILY = "photomodeler-sheet"
SIDE = 10
CONTROL = {1: (1, 1), 2: (8, 1), 3: (1, 8), 4: (8, 8)}
"""Column and row of the rings of so many arcs, which are called 1001 to 1004."""
FILLED = {1: 5 / 8, 2: 1 / 2, 3: 3 / 8, 4: 1 / 2}
"""Share of the circle that the arcs take."""
RING = (2.6, 4.3)
"""Inner and outer radius of the arcs, in radii of the dot."""
RADII = (2.9, 3.3, 3.7)
"""Where arcs are read, in radii of the dot."""
TWICE = 4
"""Dots of two lattices with the same names that say that there are two sheets; else they are parts of one."""
LEAST = 25
"""Dots below which a lattice states nothing."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheet:
    """The sheet."""

    @property
    def family(self) -> str:
        """photomodeler-sheet."""
        return FAMILY

    @property
    def title(self) -> str:
        """For people."""
        return "PhotoModeler's calibration sheet of 10 x 10 dots"

    @property
    def objects(self) -> Mapping[str, Array]:
        """Dots in units of their spacing; the rings are 7 apart."""
        return {_name(c, r): np.array([c, -r, 0.0]) for r in range(SIDE) for c in range(SIDE)}

    @property
    def turns(self) -> int:
        """The rings show all."""
        return 1

    @property
    def radius(self) -> float:
        """Sheets are printed in several sizes of dots."""
        return np.nan

    def find(self, image: Array, options: MarkOptions) -> Marks:
        """All dots seen, named from at least two rings."""
        dots = detect_targets(image, None, DetectionOptions(polarity="dark", threads=options.threads))
        found = lattices(dots.xy_px, dots.ellipse, LEAST)
        if not found:
            return nothing(FAMILY, phrase("target_seen.no_raster", target=FAMILY, n=len(dots)))
        grids = [g for k in found if (g := _named(k, arcs(image, dots.rows(k.dot)))) is not None]
        if not grids:
            return nothing(FAMILY, phrase("target_seen.no_rings", n=len(found[0].dot)))
        if (np.sum([g >= 0 for g in grids], axis=0) > 1).sum() >= TWICE:
            return nothing(FAMILY, two_seen(FAMILY))
        marks = marks_of_grid(FAMILY, dots, np.max(grids, axis=0))
        places = [n[1:].split("c") for n in marks.name]
        names = tuple(_name(int(c), int(r)) for r, c in places)
        return Marks(
            family=FAMILY, name=names, xy_px=marks.xy_px, covariance=marks.covariance, ellipse=marks.ellipse,
            gate=marks.gate, remarks=marks.remarks,
        )  # fmt: skip


def _name(column: int, row: int) -> str:
    number = next((k for k, place in CONTROL.items() if place == (column, row)), 0)
    return str(1000 + number) if number else f"r{row}c{column}"


def arcs(image: Array, dots: Detections) -> Index:
    """Number of arcs (n,) around each dot, 1 to 4; 0 where there is no ring of the sheet."""
    t = circle(np.arange(96) * np.pi / 48)
    L = frame(dots.ellipse)
    around = [sample(image, dots.xy_px[:, None] + (t * r) @ L.transpose(0, 2, 1)) for r in RADII]
    v = np.mean(around, axis=0)
    ground = np.percentile(v, 85, axis=1)
    share = (v - ground[:, None]) / np.where(dots.contrast == 0, 1, dots.contrast)[:, None]
    dark = share > 0.5
    count = (dark & ~np.roll(dark, 1, axis=1)).sum(axis=1)
    filled = dark.mean(axis=1)
    wanted = np.array([-1.0, *(FILLED[k] for k in (1, 2, 3, 4))])[np.clip(count, 0, 4)]
    return np.where((count <= 4) & (abs(filled - wanted) < 0.12), count, 0)


def _named(lattice: Lattice, count: Index) -> Index | None:
    """Dots (10, 10) of the sheet, -1 where none was found; None where fewer than two rings agree on the names."""
    rings = np.flatnonzero(count)
    best, most = None, 1
    for k in range(4):
        turned = _turned(lattice.place, k)
        shifts = [tuple(np.array(CONTROL[int(count[i])]) - turned[i]) for i in rings]
        for shift in set(shifts):
            votes = shifts.count(shift)
            if votes > most:
                best, most = turned + shift, votes
    if best is None or most < len(rings) - 1:
        return None
    inside = ((best >= 0) & (best < SIDE)).all(axis=1)
    grid = np.full((SIDE, SIDE), -1)
    grid[best[inside, 1], best[inside, 0]] = lattice.dot[inside]
    return grid


def _turned(place: Index, quarter: int) -> Index:
    """Columns and rows (n, 2) after so many quarter turns of the sheet."""
    c, r = place.T
    return np.stack([(c, r), (r, -c), (-c, -r), (-r, c)][quarter], axis=1)


def _make(name: str) -> Target | None:
    return Sheet() if name == FAMILY else None


register("photomodeler", Kind(form=FAMILY, make=_make, names=lambda _: [FAMILY]))
