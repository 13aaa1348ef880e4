"""What `raybundle merge` finds out of two measurements before it takes them for one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import floor, log10
from pathlib import Path
from typing import TYPE_CHECKING

from raybundle.errors import InputError, NotSolvable
from raybundle.numerics.counting import counted_are, significant
from raybundle.settings import option

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment, InteriorResult
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
        """Without what control says; raises InputError and NotSolvable."""
        from raybundle.measuring.session import adjusted_as_free  # noqa: PLC0415

        return adjusted_as_free(self.source)

    @cached_property
    def shape(self) -> PointSet:
        """The points of `as_free`."""
        return self._points(self.as_free)

    @cached_property
    def placed(self) -> tuple[PointSet, bool]:
        """The points where control, positions and bars have them, and whether these fix all of the frame."""
        from raybundle.block.joined import fixed  # noqa: PLC0415
        from raybundle.measuring.session import adjusted_again, readjusted  # noqa: PLC0415

        if fixed(self.block) < 2:
            return self.shape, False
        done = adjusted_again(self.source) if isinstance(self.source, Path) else readjusted(self.source)
        points = self._points(done)
        return (points if self.brought is None else points.moved(self.brought)), not done.datum_defect

    @property
    def gives_scale(self) -> str:
        """What tells its scale, in words."""
        if self.block.points.is_control.any():
            return f"control of {self.name}"
        if len(self.block.stations):
            return f"positions of {self.name}"
        d, ids = self.block.distances, self.block.points.ids
        told = [
            f"{ids[d.start[k]]} - {ids[d.end[k]]} of {d.length[k]:.10g} {self.block.length_unit}"
            for k in range(min(BARS, len(d)))
        ]
        return f"scale bar {', '.join(told)}{' ...' if len(d) > BARS else ''} of {self.name}" if told else self.name

    def _points(self, done: Adjustment) -> PointSet:
        from raybundle.measuring.point_sets import point_set  # noqa: PLC0415

        points = point_set(done, self.name)
        return replace(points, ids=tuple(self.called.get(i, i) for i in points.ids))


def measured_once(blocks: Sequence[Block], names: Sequence[str]) -> list[str]:
    """Cautions about photographs that two blocks have with the same image points.

    raises  InputError where a block has no photograph that is not in another
    """
    from itertools import combinations  # noqa: PLC0415

    from raybundle.block.same_images import images_measured_alike  # noqa: PLC0415

    cautions: list[str] = []
    for (one, first), (two, second) in combinations(zip(names, blocks, strict=True), 2):
        alike = images_measured_alike(second, first)
        if not alike:
            continue
        told = (
            f"{counted_are(len(alike), 'photograph')} in {one} and in {two} with the same image points "
            f"({', '.join(alike[:3])}{' ...' if len(alike) > 3 else ''})"
        )
        fewest, whose = min((len(first.images), one), (len(second.images), two))
        if len(alike) >= fewest:
            raise InputError(f"{told}, all that {whose} has: they would count twice; leave it out")
        cautions.append(f"{told}: they count twice, and standard deviations come out too small; leave them out of one")
    return cautions


def stayed_of(base: Member, member: Member, significance: float) -> Congruence | str:
    """The congruence test of two measurements, whose scale is free; or why there is none.

    raises  InputError where most common points are not one point
    """
    from raybundle.metrology.congruence import LEAST, congruence  # noqa: PLC0415

    try:
        if len(set(member.shape.ids) & set(base.shape.ids)) < LEAST:
            return f"{member.name} has fewer than {LEAST} points in common with {base.name}: none is tested"
        tested = congruence([base.shape, replace(member.shape, free_scale=True)], significance=significance)
    except (InputError, NotSolvable) as error:
        return f"common points of {member.name} were not tested: {error.text()}"
    moved = int(tested.moved.sum())
    if 2 * moved > len(tested.ids):
        raise InputError(
            f"{moved} of {len(tested.ids)} points that {member.name} and {base.name} call alike are not one point: are "
            "the names those of another object, or exchanged?"
        )
    return tested


def check_frames(base: Member, member: Member, stayed: Sequence[str]) -> list[str]:
    """Cautions where two measurements that each know their scale, or their frame, contradict each other in it.

    raises  InputError where their scales differ as units do
    """
    from raybundle.block.joined import fixed  # noqa: PLC0415
    from raybundle.metrology.bars import LEVEL  # noqa: PLC0415
    from raybundle.metrology.frames import between  # noqa: PLC0415
    from raybundle.numerics.length_units import is_other_unit  # noqa: PLC0415

    if not fixed(base.block) or not fixed(member.block):
        return []
    try:
        (one, whole), (other, other_whole) = base.placed, member.placed
        if one.free_scale or other.free_scale:
            return []
        both = set(one.ids) & set(other.ids)
        found = between(one, other, [i for i in stayed if i in both], placed=whole and other_whole)
    except (InputError, NotSolvable) as error:
        return [f"the scales of {base.name} and {member.name} were not tested: {error.text()}"]
    if is_other_unit(found.factor):
        raise InputError(_other_unit(base, member, found))
    if found.scale[1] < LEVEL:
        told = (
            f"lengths of {member.name} are {_told(found)} times those of {base.name}, which is more than chance: one "
            f"of these is wrong: {base.gives_scale}; {member.gives_scale}"
        )
        return [told]
    if found.frame is not None and found.frame[1] < LEVEL:
        off = significant(float((found.shift**2).sum() ** 0.5))
        told = (
            f"{member.name} and {base.name} do not stand in one frame: common points are shifted by {off} m and turned "
            f"by {significant(1e3 * found.turn)} mrad on the mean (F {found.frame[0]:.3g}); compare their control"
        )
        return [told]
    return []


def _told(found: Between) -> str:
    """The factor in the digits of its standard deviation, and this."""
    digits = max(0, 1 - floor(log10(found.sigma))) if found.sigma > 0 else 6
    return f"{found.factor:.{digits}f} (standard deviation {found.sigma:.2g})"


def _other_unit(base: Member, member: Member, found: Between) -> str:
    from raybundle.numerics.length_units import units_of  # noqa: PLC0415

    units = units_of(found.factor)
    seems = "" if units is None else f": {member.name} is in {units[0]} and {base.name} in {units[1]}, it seems"
    return (
        f"lengths of {member.name} are {found.factor:.6g} times those of {base.name}, and both have a scale{seems}; "
        f"give lengths in the unit that block.toml names ({base.gives_scale}; {member.gives_scale})"
    )


def check_cameras(base: Member, member: Member) -> list[str]:
    """Cautions where cameras that are said to be the same differ by more than chance.

    raises  InputError where a parameter differs by more than CONTRADICTS standard deviations, or held ones differ
    """
    from raybundle.block.joined import CONTRADICTS  # noqa: PLC0415
    from raybundle.metrology.bars import LEVEL  # noqa: PLC0415

    try:
        mine, theirs = (
            {i.camera: i for i in m.as_free.interior if i.image is None} for m in (member, base)
        )  # fmt: skip
    except (InputError, NotSolvable) as error:
        return [f"cameras of {member.name} and {base.name} were not compared: {error.text()}"]
    cautions: list[str] = []
    for camera in [c for c in mine if c in theirs]:
        a, b = theirs[camera], mine[camera]
        worst = max(_apart(a, b), default=None)
        if worst is None:
            continue
        times, symbol = worst
        one, two = a.parameters[symbol], b.parameters[symbol]
        values = (
            f"{symbol} of camera {camera} is {one.value:.6g} {one.unit} in {base.name} and {two.value:.6g} {two.unit} "
            f"in {member.name}, {significant(times)} standard deviations apart"
        )
        if times > CONTRADICTS:
            raise InputError(
                f"{values} (limit {CONTRADICTS:g}): they are not the same camera, or it was touched between; leave "
                f"{option('same_camera')} out, and each project keeps its own"
            )
        F, p = _together(a, b, base.as_free.redundancy + member.as_free.redundancy)
        if p < LEVEL:
            cautions.append(
                f"camera {camera} differs between {base.name} and {member.name} by more than chance (F {F:.3g}; "
                f"{values}): was it touched between?"
            )
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
    import numpy as np  # noqa: PLC0415

    from raybundle.numerics.statistics import joint_test  # noqa: PLC0415

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
