"""Circular targets as Agisoft numbers them.

Even number of set sectors, at least four of them, never all within one half of the ring, not all set.  The rule gives
the counts of the four families and the published table of 12 bits row by row.  The radii of the rings are not
published; users report a whole diameter of 3.5 times that of the dot.  So sectors are read in a band that any ring
from 2 or 2.3 to 3 or 3.5 radii fills.
"""

from __future__ import annotations

from raybundle.numerics.arrays import Index, Mask
from raybundle.targets.codes import RingFamily, population, register


def rule(codes: Index, bits: int) -> Mask:
    """Which canonical codes belong to the family."""
    set_ = population(codes, bits)
    return (set_ % 2 == 0) & (set_ >= 4) & (codes >= 1 << (bits // 2)) & (codes != (1 << bits) - 1)


for _bits in (12, 14, 16, 20):
    register(
        RingFamily(
            name=f"agisoft{_bits}", title=f"Agisoft circular, {_bits} bits", bits=_bits, ring=(2.0, 3.5), ground=4.6,
            read=(2.45, 2.9), rule=rule,
        )
    )  # fmt: skip
