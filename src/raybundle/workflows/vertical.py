"""What is plumb in a block: its Z axis and where that comes from, measured plumb lines, or two points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.block import Block
from raybundle.errors import InputError, Text, phrase
from raybundle.measuring.axes import vertical
from raybundle.numerics.arrays import Array, Index
from raybundle.observations.alignment import Levels, PlumbLines

Z = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True, kw_only=True)
class Plumb:
    """The vertical, and how it is known."""

    up: Array
    """(3,) unit vector"""
    words: Text
    sigma: float = float("nan")
    """standard deviation [rad] that the covariances of points do not hold; NaN: not known"""
    lines: tuple[tuple[str, ...], ...] = ()
    """points of the lines that show it; (): the Z axis"""

    @property
    def points(self) -> tuple[str, ...]:
        """By which it is reported."""
        return tuple(dict.fromkeys(n for line in self.lines for n in line))

    def up_of(self, places: Mapping[str, Array]) -> Array:
        """The vertical where the points stand at other places (3,)."""
        if not self.lines:
            return self.up
        return _along([np.array([places[n] for n in line]) for line in self.lines], self.up)


def points_at(block: Block, names: Sequence[str]) -> Index:
    """Positions (n,) of named points that have coordinates; raises InputError."""
    index = {p: k for k, p in enumerate(block.points.ids)}
    missing = [n for n in names if n not in index or not np.isfinite(block.points.xyz[index[n]]).all()]
    if missing:
        raise InputError("point.not_in_result", names=missing)
    return np.array([index[n] for n in names], np.int64)


def asked_plumb(block: Block, way: str, about: Mapping[str, Any]) -> Plumb:
    """The vertical that is asked for.

    way     z: the Z axis; lines: the plumb lines that were measured; A,B: two points, the second above the first
    about   what result.json states: `upright` shows where Z comes from
    raises  InputError for another way, for points that have no place, and where no plumb line was measured
    """
    if way.lower() == "z":
        return _of_block(block, about)
    if way.lower() == "lines":
        lines = _measured(block)
        if not lines:
            raise InputError("vertical.no_plumb_line", way=way)
        xyz = block.points.xyz
        up = _along([xyz[points_at(block, line)] for line in lines], Z)
        return Plumb(up=up, words=phrase("plumb.lines", n=len(lines)), lines=lines)
    names = tuple(n.strip() for n in way.split(","))
    if len(names) != 2 or not all(names) or names[0] == names[1]:
        raise InputError("vertical.way_unknown", way=way)
    a, b = block.points.xyz[points_at(block, names)]
    if not np.linalg.norm(b - a) > 0:
        raise InputError("vertical.points_coincide", way=way)
    up = (b - a) / np.linalg.norm(b - a)
    return Plumb(up=up, words=phrase("plumb.points", lower=names[0], upper=names[1]), lines=(names,))


def _of_block(block: Block, about: Mapping[str, Any]) -> Plumb:
    """Z, and what made it the vertical."""
    plumb, levels = (len(set(block.tables[t.name].figure)) if t.name in block.tables else 0  # pyright: ignore[reportAttributeAccessIssue]
                     for t in (PlumbLines, Levels))  # fmt: skip
    found = about.get("upright")
    if plumb or levels:
        return Plumb(up=Z, words=phrase("plumb.block_observed", lines=plumb, levels=levels))
    if not isinstance(found, Mapping) or about.get("frame") is not None:
        return Plumb(up=Z, words=phrase("plumb.block"))
    degrees, edges = found.get("sigma_deg"), found.get("plumb_edges")
    sigma = float(np.radians(degrees)) if isinstance(degrees, float | int) else float("nan")
    known = bool(np.isfinite(sigma))
    by = "edges" if isinstance(edges, int) and edges else "given" if found.get("kind") == "given" else "held"
    words = phrase(
        "plumb.block_found", by=by, edges=edges if isinstance(edges, int) else 0, known=known,
        sigma_deg=float(np.degrees(sigma)) if known else 0.0,
    )  # fmt: skip
    return Plumb(up=Z, words=words, sigma=sigma)


def _measured(block: Block) -> tuple[tuple[str, ...], ...]:
    """Names of the points of each plumb line that has two or more with coordinates."""
    table = block.tables.get(PlumbLines.name)
    if not isinstance(table, PlumbLines):
        return ()
    found: dict[str, list[str]] = {}
    for figure, point in zip(table.figure, table.point.tolist(), strict=True):
        if np.isfinite(block.points.xyz[point]).all():
            found.setdefault(figure, []).append(block.points.ids[point])
    return tuple(tuple(dict.fromkeys(names)) for names in found.values() if len(set(names)) > 1)


def _along(lines: Sequence[Array], near: Array) -> Array:
    """The direction of plumb lines (k, 3): each weighs by the squares of its points' distances from its middle."""
    if len(lines) == 1 and len(lines[0]) == 2:
        d = lines[0][1] - lines[0][0]
        d = d / np.linalg.norm(d)
        return d if d @ near >= 0 else -d
    return vertical((), lines, near)
