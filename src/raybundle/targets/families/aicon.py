"""Rings after Schneider 1991 as AICON numbers them.

Even number of set sectors, at least one pair of opposite sectors both set, not all sectors set.  Rule after the expired
patent DE 197 33 466 A1; the tables of 12, 14 and 20 bits that circulate follow from it row by row.
"""

from __future__ import annotations

from raybundle.numerics.arrays import Index, Mask
from raybundle.targets.codes import RingFamily, population, register


def rule(codes: Index, bits: int) -> Mask:
    """Which canonical codes belong to the family."""
    half = bits // 2
    opposite = codes & (codes >> half) & ((1 << half) - 1)
    return (population(codes, bits) % 2 == 0) & (opposite != 0) & (codes != (1 << bits) - 1)


for _bits, _ring, _ground, _read in (
    (12, (2.0, 3.0), 3.9, (2.25, 2.75)),
    (14, (2.0, 3.0), 3.9, (2.25, 2.75)),
    (20, (2.5, 4.0), 4.5, (2.85, 3.65)),
):
    register(
        RingFamily(
            name=f"aicon{_bits}", title=f"AICON (Schneider), {_bits} bits", bits=_bits, ring=_ring, ground=_ground,
            read=_read, rule=rule,
        )
    )  # fmt: skip
