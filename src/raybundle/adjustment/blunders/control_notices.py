"""What is to be stated of control that contradicts the rest: which points are wrong, and which of several may be."""

from __future__ import annotations

from collections.abc import Sequence

from raybundle.adjustment.blunders.control_tests import Contradiction, WrongPoint
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.components import LEAST, LEVEL, NAMES
from raybundle.errors import Value, message
from raybundle.numerics.statistics import chi_square_tails

SHOWN = 10


def control_notices(result: Adjustment, found: Contradiction) -> list[Notice]:
    """The faults of a result whose control contradicts it, the points that are wrong before those that may be.

    Points of which a notice of the result already states why they take part are not named again.
    """
    missing = {i for n in result.notices if n.code == "control_not_located" for i in n.ids}
    wrong = [p for p in found.wrong if p.name not in missing]
    located = [p for p in wrong if not p.others]
    notices = [_located(result, located, found.swayed)] if located else []
    for p in wrong:
        group = (p.name, *p.others)
        if p.others and not missing & set(group):
            notices.append(not_located(group, p.w, p.limit))
            missing |= set(group)
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
    values: dict[str, Value] = {"ratio": own[0].ratio, "sigma0": result.sigma0, "wider": wider}
    return [Notice(code="control_precise", values=values)]


def not_located(group: Sequence[str], w: float, limit: float) -> Notice:
    """The fault of several points of which one is wrong; test value of the first, and its limit."""
    values: dict[str, Value] = {"n": len(group), "point": group[0], "w": w, "limit": limit}
    return Notice(code="control_not_located", values=values, ids=tuple(group[:100]))


def _located(result: Adjustment, wrong: Sequence[WrongPoint], swayed: Sequence[str]) -> Notice:
    unit = result.given.length_unit
    each = [
        message(
            "control_suspect.point", point=p.name, w=p.w, limit=p.limit, unit=unit,
            **dict(zip(("dx", "dy", "dz"), map(float, p.shift), strict=True)),
        )
        for p in wrong[:SHOWN]
    ]  # fmt: skip
    each += [message("control_suspect.swayed", n=len(swayed), names=swayed)] if swayed else []
    values: dict[str, Value] = {"n": len(wrong), "point": wrong[0].name}
    return Notice(code="control_suspect", values=values, ids=tuple(p.name for p in wrong[:100]), details=tuple(each))


def _unexplained(names: Sequence[str]) -> Notice:
    return Notice(code="control_suspect.unexplained", values={"n": len(names)}, ids=tuple(names[:100]))
