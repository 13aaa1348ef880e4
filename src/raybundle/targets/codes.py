"""Ring codes: a number read around a dot, the same wherever the reading begins.

A ring of N sectors holds N bits.  Sector k reaches counter-clockwise, as seen from the front, from k to k + 1 times
360/N degrees and holds bit k; a set bit has the colour of the dot.  Of the N numbers that one ring can be read as, the
least is its code.  Sorted upwards, the codes of a family are numbered from 1: that is the id of a target.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np

from raybundle.errors import InputError
from raybundle.io.reading.files import read_lines
from raybundle.io.reading.words import quoted, whole_of
from raybundle.numerics.arrays import Array, Index, Mask

Rule = Callable[[Index, int], Mask]
"""Which of the canonical codes (n,) of so many bits belong to a family."""

MOST_BITS = 24
"""The rings of more bits are too many to be listed."""
TABLE_BYTES = 1 << 24


def rotations(codes: Index, bits: int) -> Index:
    """All readings (n, bits) of rings: column k begins k sectors later."""
    c = np.asarray(codes, np.int64)[:, None]
    k = np.arange(bits)
    return ((c >> k) | (c << (bits - k))) & ((1 << bits) - 1)


def canonical(codes: Index, bits: int) -> Index:
    """The least reading (n,) of each ring."""
    c = np.asarray(codes, np.int64)
    least, full = c.copy(), (1 << bits) - 1
    for k in range(1, bits):
        np.minimum(least, ((c >> k) | (c << (bits - k))) & full, out=least)
    return least


def population(codes: Index, bits: int) -> Index:
    """Set bits (n,) of each code."""
    return ((np.asarray(codes)[:, None] >> np.arange(bits)) & 1).sum(axis=1)


def rings(bits: int) -> Index:
    """The canonical codes of all rings with at least one set sector, upwards."""
    codes = np.arange(1, 1 << bits, 2, dtype=np.int64)
    return codes[canonical(codes, bits) == codes]


@dataclass(frozen=True, kw_only=True)
class RingFamily:
    """Which rings exist, what they are called, and how they are drawn; all radii in units of the dot's radius."""

    name: str
    title: str
    bits: int
    ring: tuple[float, float]
    """inner and outer radius of the ring; between the dot and the ring nothing is printed"""
    ground: float
    """radius to which a target keeps its ground free of anything else"""
    read: tuple[float, float]
    """radii between which the sectors are read"""
    rule: Rule | None = None
    table: Mapping[int, int] = field(default_factory=dict[int, int])
    """codes by id, where there is no rule"""

    @cached_property
    def codes(self) -> Index:
        """Codes (n,) in the order of `ids`."""
        if self.rule is None:
            return np.array([self.table[i] for i in sorted(self.table)], np.int64)
        every = rings(self.bits)
        return every[self.rule(every, self.bits)]

    @cached_property
    def ids(self) -> Index:
        """Ids (n,), upwards."""
        if self.rule is None:
            return np.array(sorted(self.table), np.int64)
        return np.arange(1, len(self.codes) + 1)

    @cached_property
    def _order(self) -> Index:
        return np.argsort(self.codes, kind="stable")

    def __len__(self) -> int:
        return len(self.codes)

    def id_of(self, readings: Index) -> Index:
        """Ids (n,) of rings read from any sector on; -1 where the family has no such ring."""
        code = canonical(np.asarray(readings, np.int64), self.bits)
        known = self.codes[self._order]
        at = np.minimum(np.searchsorted(known, code), len(known) - 1)
        return np.where(known[at] == code, self.ids[self._order][at], -1)

    def code_of(self, ids: Index) -> Index:
        """Codes (n,) of ids; raises InputError where the family has no such id."""
        wanted = np.atleast_1d(np.asarray(ids, np.int64))
        at = np.minimum(np.searchsorted(self.ids, wanted), len(self) - 1)
        bad = wanted[self.ids[at] != wanted]
        if len(bad):
            raise InputError(
                "target.no_such_id",
                family=self.name,
                ids_missing=bad.tolist(),
                n=len(self),
                first=self.ids[0],
                last=self.ids[-1],
            )
        return self.codes[at]


registry: dict[str, RingFamily] = {}


def register(family: RingFamily) -> RingFamily:
    """Make a family known by its name."""
    registry[family.name] = family
    return family


def family_named(name: str) -> RingFamily:
    """The registered family of this name; raises InputError."""
    if name not in registry:
        raise InputError("target.unknown_ring_family", name=str(name), known=sorted(registry))
    return registry[name]


def sectors(code: int, bits: int) -> Array:
    """Runs of set sectors (n, 2): beginning and end in units of a sector, the end above the beginning."""
    value = (code >> np.arange(bits)) & 1
    if value.all():
        return np.array([[0, bits]])
    begins = np.flatnonzero((value == 1) & (np.roll(value, 1) == 0))
    return np.array([[b, b + 1 + int(np.argmin(np.roll(value, -b - 1)))] for b in begins]).reshape(-1, 2)


def read_table(
    path: Path,
    bits: int,
    *,
    ring: tuple[float, float] = (2.0, 3.0),
    name: str = "",
) -> RingFamily:
    """A family of one's own from a text file: one target a line, its id and its code in decimal.

    Separated by blanks, commas or semicolons; `#` begins a comment.  A first line may name the columns, id and code, in
    either order.  Any reading of a ring will do for its code.
    Raises InputError with the line where a row cannot be used: no numbers, an id given twice, a ring given twice.
    """
    if not 3 <= bits <= MOST_BITS:
        raise InputError("ring_table.bits", bits=bits, most=MOST_BITS, file=path)
    table: dict[int, int] = {}
    seen: dict[int, int] = {}
    columns = ["id", "code"]
    header = True
    for number, row in read_lines(path, TABLE_BYTES):
        words = row.partition("#")[0].replace(",", " ").replace(";", " ").split()
        if not words:
            continue
        if header and sorted(w.strip('"').lower() for w in words) == sorted(columns):
            columns = [w.strip('"').lower() for w in words]
            header = False
            continue
        header = False
        values = [whole_of(w) for w in words]
        if len(values) != 2 or any(v is None or not 0 <= v < 1 << 62 for v in values):
            raise InputError("ring_table.row", value=quoted(row), file=path, line=number)
        id_, code = (values[columns.index(c)] or 0 for c in ("id", "code"))
        if not 0 < code < 1 << bits:
            raise InputError("ring_table.code_out_of_range", ring=code, largest=(1 << bits) - 1, file=path, line=number)
        code = int(canonical(np.array([code]), bits)[0])
        if id_ in table:
            raise InputError("ring_table.id_twice", file=path, line=number, id=id_)
        if code in seen:
            raise InputError("ring_table.ring_twice", file=path, line=number, ring=code, id=seen[code])
        table[id_], seen[code] = code, id_
    if not table:
        raise InputError("ring_table.empty", file=path)
    if not 1.2 <= ring[0] < ring[1]:
        raise InputError("ring_table.ring_radii", inner=ring[0], outer=ring[1], file=path)
    return own_family(name or path.stem, f"rings of {bits} bits by the table {path.name}", bits, ring, table)


def own_family(name: str, title: str, bits: int, ring: tuple[float, float], table: Mapping[int, int]) -> RingFamily:
    """A family of one's own by codes of ids, each the least reading of its ring."""
    inner, outer = ring
    quarter = (outer - inner) / 4
    return RingFamily(
        name=name,
        title=title,
        bits=bits,
        ring=ring,
        ground=outer + (inner - 1),
        read=(inner + quarter, outer - quarter),
        table=table,
    )
