"""What `raybundle merge` finds out of two measurements before it takes them for one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import isinf
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError, Message, NotSolvable, Severity, Value, as_detail, message, note, warning

if TYPE_CHECKING:
    from raybundle.adjustment.records.figures import InteriorResult
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block
    from raybundle.metrology.congruence import Congruence
    from raybundle.metrology.frames import Between
    from raybundle.metrology.point_set import PointSet
    from raybundle.numerics.transform import SimilarityTransform

BARS = 3
"""Scale bars that a message names of a measurement"""


@dataclass(frozen=True, kw_only=True)
class Member:
    """One of the measurements that are merged."""

    name: str
    block: Block
    """with coordinates, in the frame of the merged block where both stand on the earth"""
    source: Block | Path
    """what is adjusted again: the folder of a result knows its options"""
    brought: SimilarityTransform | None
    """from the frame of `source` to that of `block` [m]"""
    called: Mapping[str, str]
    """dots that have another name in `block`"""

    @cached_property
    def as_free(self) -> Adjustment:
        """Without what control states; raises InputError and NotSolvable."""
        from raybundle.measuring.session import adjusted_as_free

        return adjusted_as_free(self.source)

    @cached_property
    def shape(self) -> PointSet:
        """The points of `as_free`."""
        return self._points(self.as_free)

    @cached_property
    def placed(self) -> tuple[PointSet, bool]:
        """The points where control, positions and bars have them, and whether these fix all of the frame."""
        from raybundle.block.joined import fixed
        from raybundle.measuring.session import adjusted_again, readjusted

        if fixed(self.block) < 2:
            return self.shape, False
        done = adjusted_again(self.source) if isinstance(self.source, Path) else readjusted(self.source)
        points = self._points(done)
        return (points if self.brought is None else points.moved(self.brought)), not done.datum_defect

    @property
    def gives_scale(self) -> Message:
        """What defines its scale: control, positions, or its scale bars with their lengths."""
        d, ids = self.block.distances, self.block.points.ids
        kind = "control" if self.block.points.is_control.any() else "positions" if len(self.block.stations) else "bars"
        rows = range(min(BARS, len(d)) if kind == "bars" else 0)
        return message(
            "join.scale_of",
            details=[
                message(
                    "join.scale_bar", start=ids[d.start[k]], end=ids[d.end[k]], length=float(d.length[k]),
                    unit=self.block.length_unit,
                ) for k in rows
            ],
            name=self.name, kind=kind, n=len(d),
        )  # fmt: skip

    def _points(self, done: Adjustment) -> PointSet:
        from raybundle.measuring.point_sets import point_set

        points = point_set(done, self.name)
        return replace(points, ids=tuple(self.called.get(i, i) for i in points.ids))


def measured_once(blocks: Sequence[Block], names: Sequence[str]) -> list[Message]:
    """Cautions about photographs that two blocks have with the same image points.

    raises  InputError where a block has no photograph that is not in another
    """
    from itertools import combinations

    from raybundle.block.same_images import images_measured_alike

    cautions: list[Message] = []
    for (one, first), (two, second) in combinations(zip(names, blocks, strict=True), 2):
        alike = images_measured_alike(second, first)
        if not alike:
            continue
        fewest, name = min((len(first.images), one), (len(second.images), two))
        if len(alike) >= fewest:
            raise InputError("join.same_measurement", n=len(alike), first=one, second=two, names=alike, name=name)
        cautions.append(warning("join.same_photographs", n=len(alike), first=one, second=two, names=alike))
    return cautions


def stayed_of(base: Member, member: Member, significance: float) -> Congruence | Message:
    """The congruence test of two measurements, whose scale is free; or why there is none.

    raises  InputError where most common points are not one point
    """
    from raybundle.metrology.congruence import LEAST, congruence

    try:
        if len(set(member.shape.ids) & set(base.shape.ids)) < LEAST:
            return note("join.too_few_to_test", name=member.name, base=base.name, least=LEAST)
        tested = congruence([base.shape, replace(member.shape, free_scale=True)], significance=significance)
    except (InputError, NotSolvable) as error:
        return note("join.points_not_tested", details=[as_detail(error)], name=member.name)
    moved = int(tested.moved.sum())
    if 2 * moved > len(tested.ids):
        raise InputError("join.points_moved", moved=moved, n=len(tested.ids), name=member.name, base=base.name)
    return tested


def check_frames(base: Member, member: Member, stayed: Sequence[str]) -> list[Message]:
    """Cautions where two measurements that each know their scale, or their frame, contradict each other in it.

    raises  InputError where their scales differ as units do
    """
    from raybundle.block.joined import fixed
    from raybundle.metrology.bars import LEVEL
    from raybundle.metrology.frames import between
    from raybundle.numerics.length_units import is_other_unit

    if not fixed(base.block) or not fixed(member.block):
        return []
    try:
        (one, whole), (other, other_whole) = base.placed, member.placed
        if one.free_scale or other.free_scale:
            return []
        both = set(one.ids) & set(other.ids)
        found = between(one, other, [i for i in stayed if i in both], placed=whole and other_whole)
    except (InputError, NotSolvable) as error:
        return [warning("join.scales_not_tested", details=[as_detail(error)], base=base.name, name=member.name)]
    if is_other_unit(found.factor):
        raise InputError(_other_unit(base, member, found))
    scales = [base.gives_scale, member.gives_scale]
    if found.scale[1] < LEVEL:
        return [
            warning(
                "join.scales_contradict", details=scales, name=member.name, base=base.name, factor=found.factor,
                sigma=found.sigma,
            )
        ]  # fmt: skip
    if found.frame is not None and found.frame[1] < LEVEL:
        return [
            warning(
                "join.frames_contradict", name=member.name, base=base.name, F=found.frame[0],
                shift_m=float((found.shift**2).sum() ** 0.5), turn_mrad=1e3 * found.turn,
            )
        ]  # fmt: skip
    return []


def _other_unit(base: Member, member: Member, found: Between) -> Message:
    from raybundle.numerics.length_units import units_of

    unit, base_unit = units_of(found.factor) or ("", "")
    return message(
        "join.other_unit", details=[base.gives_scale, member.gives_scale], name=member.name, base=base.name,
        factor=found.factor, likely=bool(unit), unit=unit, base_unit=base_unit,
    )  # fmt: skip


def check_cameras(base: Member, member: Member) -> list[Message]:
    """Cautions where cameras that are stated to be the same differ by more than chance.

    raises  InputError where a parameter differs by more than CONTRADICTS standard deviations, or held ones differ
    """
    from raybundle.block.joined import CONTRADICTS
    from raybundle.metrology.bars import LEVEL

    try:
        mine, theirs = (
            {i.camera: i for i in m.as_free.interior if i.image is None} for m in (member, base)
        )  # fmt: skip
    except (InputError, NotSolvable) as error:
        return [warning("join.cameras_not_compared", details=[as_detail(error)], name=member.name, base=base.name)]
    cautions: list[Message] = []
    for camera in [c for c in mine if c in theirs]:
        a, b = theirs[camera], mine[camera]
        worst = max(_apart(a, b), default=None)
        if worst is None:
            continue
        times, symbol = worst
        one, two = a.parameters[symbol], b.parameters[symbol]
        values: dict[str, Value] = {
            "camera": camera, "symbol": symbol, "base": base.name, "name": member.name, "unit": one.unit,
            "first": one.value, "second": two.value, "held": isinf(times), "times": 0.0 if isinf(times) else times,
        }  # fmt: skip
        if times > CONTRADICTS:
            raise InputError(Message(code="join.camera_contradicts", values={**values, "limit": CONTRADICTS}))
        F, p = _together(a, b, base.as_free.redundancy + member.as_free.redundancy)
        if p < LEVEL:
            cautions.append(Message(code="join.camera_differs", severity=Severity.WARNING, values={**values, "F": F}))
    return cautions


def _apart(a: InteriorResult, b: InteriorResult) -> list[tuple[float, str]]:
    """Differences of common parameters in their standard deviations; infinite where held ones differ."""
    found: list[tuple[float, str]] = []
    for symbol in [s for s in a.parameters if s in b.parameters]:
        one, two = a.parameters[symbol], b.parameters[symbol]
        off = abs(one.value - two.value)
        sigma = ((one.std or 0.0) ** 2 + (two.std or 0.0) ** 2) ** 0.5
        same = off <= 1e-9 * max(abs(one.value), abs(two.value))
        found.append((0.0 if same else off / sigma if sigma else float("inf"), symbol))
    return found


def _together(a: InteriorResult, b: InteriorResult, freedom: float) -> tuple[float, float]:
    """F of all parameters that both estimated being the same, and its probability."""
    import numpy as np

    from raybundle.numerics.statistics import joint_test

    free = [s for s in a.free if s in b.free]
    if not free:
        return 0.0, 1.0
    C = np.zeros((len(free), len(free)))
    scale = np.array([a.parameters[s].std or 1.0 for s in free])  # parameters have units of their own
    for i in (a, b):
        at = [i.free.index(s) for s in free]
        std = np.array([i.parameters[s].std or 0.0 for s in free]) / scale
        C += i.correlations[np.ix_(at, at)] * std[:, None] * std
    d = np.array([a.parameters[s].value - b.parameters[s].value for s in free]) / scale
    return joint_test(d, C, freedom)
