"""What is to be said of control that contradicts the rest: which points are wrong, and which of several may be."""

from __future__ import annotations

from collections.abc import Sequence

from raybundle.adjustment.components import LEAST, LEVEL, NAMES
from raybundle.adjustment.control_tests import Contradiction, WrongPoint
from raybundle.adjustment.result import Adjustment, Notice
from raybundle.numerics.counting import counted, counted_are
from raybundle.numerics.statistics import chi_square_tails
from raybundle.settings import option

SHOWN = 10


def control_notices(result: Adjustment, found: Contradiction) -> list[Notice]:
    """The faults of a result whose control contradicts it, the points that are wrong before those that may be.

    Points of which a notice of the result already says why they take part are not named again.
    """
    told = {i for n in result.notices if n.code == "control_not_located" for i in n.ids}
    wrong = [p for p in found.wrong if p.name not in told]
    located = [p for p in wrong if not p.others]
    notices = [_located(result, located, found.swayed)] if located else []
    for p in wrong:
        group = (p.name, *p.others)
        if p.others and not told & set(group):
            notices.append(not_located(group, _w(p)))
            told |= set(group)
    if found.unexplained:
        notices.append(_unexplained(found.unexplained))
    return notices


def precise_control_notices(result: Adjustment) -> list[Notice]:
    """A remark where control fits significantly better than sigma0, which smooth errors of photographs raise, states.

    Covariances carry one sigma0 for all observations: what hangs on control is then stated too wide.
    """
    if result.noise.kind != "fields" or result.options.variance_groups:
        return []
    own = [c for c in result.variance_components if c.kind == NAMES["control"] and c.redundancy >= LEAST]
    if not own:
        return []
    wider, redundancy = result.sigma0 / own[0].ratio, own[0].redundancy
    if not (wider > 1 and chi_square_tails(redundancy / wider**2, redundancy)[0] < LEVEL):
        return []
    message = (
        f"residuals of control are {own[0].ratio:.2g} times as large as stated, those of all observations "
        f"{result.sigma0:.2g} times: what hangs on control has standard deviations up to {wider:.2g} times too large. "
        f"Give control a variance factor of its own ({option('variance_groups')})"
    )
    return [Notice(code="control_precise", message=message, values={"ratio": own[0].ratio, "wider": wider})]


def not_located(group: Sequence[str], how: str) -> Notice:
    """The fault of several points of which one is wrong."""
    return Notice(
        code="control_not_located",
        message=f"{counted_are(len(group), 'control point')} in contradiction: {_names(group)} ({how} at {group[0]}); "
        "one of them is wrong, and which one cannot be told, so all take part. Look at their coordinates and marks; "
        "more control would tell which one it is",
        ids=tuple(group[:100]),
    )


def _located(result: Adjustment, wrong: Sequence[WrongPoint], swayed: Sequence[str]) -> Notice:
    unit = result.given.length_unit
    each = "; ".join(f"{p.name} ({_w(p)}), by {_moved(p)} {unit}" for p in wrong[:SHOWN])
    more = f"; and {counted(len(wrong) - SHOWN, 'more')}" if len(wrong) > SHOWN else ""
    cause = "it" if len(wrong) == 1 else "them"
    beside = f". {_names(swayed)} fail{'s' * (len(swayed) == 1)} the test only beside {cause}" if swayed else ""
    if len(wrong) == 1:
        message = (
            f"control point {wrong[0].name} contradicts the other observations ({_w(wrong[0])}): they would have it "
            f"elsewhere by {_moved(wrong[0])} {unit}{beside}. Check its coordinates and its number in the images"
        )
    else:
        message = (
            f"{counted(len(wrong), 'control point')} contradict the other observations, which would have them "
            f"elsewhere, the worst first: {each}{more}{beside}. Check their coordinates and their numbers in the images"
        )
    return Notice(code="control_suspect", message=message, ids=tuple(p.name for p in wrong[:100]))


def _unexplained(names: Sequence[str]) -> Notice:
    return Notice(
        code="control_suspect",
        message=f"control and the other observations contradict each other, most of all at {_names(names)}, and that "
        "a few points are wrong does not explain it. Look for what they have in common, as names, axes, the unit or "
        "the coordinate system, or give control a larger standard deviation",
        ids=tuple(names[:100]),
    )


def _w(p: WrongPoint) -> str:
    return f"|w| {p.w:.1f} of its coordinates together, limit {p.limit:.1f}"


def _moved(p: WrongPoint) -> str:
    return ", ".join(f"{axis} {d:+.3g}" for axis, d in zip("XYZ", p.shift, strict=True) if d)


def _names(names: Sequence[str]) -> str:
    return ", ".join(names[:SHOWN]) + (" ..." if len(names) > SHOWN else "")
