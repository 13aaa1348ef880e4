"""Control that contradicts the rest: which point, whether one alone is found, and what hangs on it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.blunders.control_notices import not_located
from raybundle.adjustment.blunders.control_tests import ControlTests, WrongPoint
from raybundle.adjustment.estimation import open_datum
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.datum import open_values
from raybundle.block import Block, Role
from raybundle.block.rejection import Rejection, RejectionKind, Rejections
from raybundle.errors import Value


@dataclass(frozen=True, slots=True, kw_only=True)
class WrongControl:
    """A control point that an adjustment with it rejects."""

    name: str
    w: float
    """test value of its coordinates together"""
    limit: float
    """of w"""
    others: tuple[str, ...] = ()
    """control points of which one that is wrong would explain that as well"""
    open: tuple[str, ...] = ()
    """of the datum, what nothing determines without it"""
    settled: bool = True
    """whether the adjustment that rejects it has ended"""

    @property
    def may_go(self) -> bool:
        """Whether it is known to be the wrong one, and can be spared."""
        return self.settled and not self.others and not self.open


IN_ROUNDS = 10
"""Points that are tested in each round of data snooping."""


def suspected(result: Adjustment) -> WrongPoint | None:
    """The control point that is wrong, of several that one whose error costs the square sum most."""
    return max(ControlTests(result, IN_ROUNDS).contradiction.wrong, key=lambda p: p.square, default=None)


def judged(
    result: Adjustment, suspect: WrongPoint, free: dict[str, tuple[str, ...]], reasons: Rejections
) -> WrongControl:
    """Whether the suspect may be left out: the adjustment has ended, the point is located, and the datum stays.

    result   of an adjustment in which it takes part, with test values
    free     camera id -> free parameters; reasons: of image observations that take no part

    Located: as for rays (`separability.unlocatable`; Förstner 1983), every other control point is refuted: beside it
    let go, this one still contradicts.
    """
    block, _ = left_out(result.adjusted, suspect.name, reasons)
    after = open_datum(block, result.options, free, reasons)
    lost = after if len(after) > len(result.datum_defect) else ()
    return WrongControl(
        name=suspect.name, w=suspect.w, limit=suspect.limit, others=suspect.others, open=lost, settled=result.converged
    )


def left_out(block: Block, name: str, reasons: Rejections) -> tuple[Block, Rejections]:
    """The block with a control point turned into a check point; a single ray of it shows nothing any more."""
    k = block.points.ids.index(name)
    role = block.points.role.copy()
    role[k] = Role.CHECK
    rays = np.flatnonzero(block.observations.point == k)
    if len(rays) == 1:  # it held the point's image
        lone = Rejection(kind=RejectionKind.SINGLE_RAY)
        reasons = tuple(r or lone if i == rays[0] else r for i, r in enumerate(reasons))
    return replace(block, points=replace(block.points, role=role)), reasons


def rejected_notice(wrong: WrongControl) -> Notice:
    """The fault of a point that was left out."""
    return Notice(code="control_rejected", values={"point": wrong.name, "w": wrong.w}, ids=(wrong.name,))


def kept_notice(wrong: WrongControl) -> Notice:
    """The fault of a point that contradicts the rest and takes part, with why it does."""
    if wrong.others:
        return not_located((wrong.name, *wrong.others), wrong.w, wrong.limit)
    values: dict[str, Value] = {"point": wrong.name, "w": wrong.w}
    if not wrong.open:
        return Notice(code="control_not_located.unfinished", values=values, ids=(wrong.name,))
    part, each = open_values(wrong.open)
    values |= {"n": len(wrong.open), "part": part}
    return Notice(code="control_not_located.datum", values=values, ids=(wrong.name,), details=each)
