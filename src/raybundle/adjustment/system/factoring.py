"""How normal equations are made: in one piece, or as those say around whom an adjustment runs."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import System
from raybundle.adjustment.system.normals import Normals
from raybundle.numerics.arrays import Mask

Factoring = Callable[[System, AdjustmentOptions, Mapping[str, tuple[str, ...]], Mask], Normals]
"""Makes the normal equations of a system, of which these parameters are free and these image observations rejected."""


def in_one_piece(
    system: System, options: AdjustmentOptions, free: Mapping[str, tuple[str, ...]], rejected: Mask
) -> Normals:
    """The normal equations as one sparse matrix."""
    del free, rejected
    return Normals.of(system, options.jobs)


_around: ContextVar[Factoring] = ContextVar("factoring", default=in_one_piece)


@contextmanager
def made_by(factoring: Factoring) -> Generator[None]:
    """Normal equations of all adjustments meanwhile are made so."""
    before = _around.set(factoring)
    try:
        yield
    finally:
        _around.reset(before)


def around() -> Factoring:
    """As `made_by` states here; else in one piece."""
    return _around.get()
