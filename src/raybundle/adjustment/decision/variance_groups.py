"""Groups of observations with variance factors of their own, as far as the residuals show them.

One factor for all observations, sigma0^2, is given by the image points, of which there are most; carried to a scale bar
it changes what a laboratory has certified.  Here each camera's image points and each kind of other observations has
its own (Förstner 1979, iterated), and what the residuals cannot judge, or do not contradict, keeps the standard
deviation that it was given.  Covariances are then cofactors times 1.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from raybundle.adjustment.records.figures import GroupFactor, VarianceComponent
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.records.severity import POOR_FIT, Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.components import FARTHEST, LARGE, LEAST, LEVEL, NAMES, weighted, without_worst
from raybundle.adjustment.system.adjusted_values import started
from raybundle.block import Block
from raybundle.errors import InputError, Message, message
from raybundle.numerics.statistics import chi_square_tails

SETTLED = 1e-3
"""Relative change of a factor at which the iteration ends."""
ROUNDS = 15
FEW = 0.5
"""Redundancy from which on values of a group can contradict each other: two bars have 1 between them."""

Key = tuple[str, str]
"""Kind and group of a variance component."""
Adjust = Callable[[Block, AdjustmentOptions], Adjustment]


def by_groups(block: Block, options: AdjustmentOptions, adjusted: Adjust) -> Adjustment:
    """Adjust with variance factors of the groups; `given` of the result has the standard deviations times these.

    options   `variance_groups` is on
    adjusted  the adjustment itself
    Image points of a camera have the factor that their residuals show; control, distances and others one only where
    their residuals contradict what was stated (chi-square, 1 %, two-sided): upwards with a redundancy of FEW or more,
    as certificates that contradict each other are not to be believed however few they are, downwards with LEAST.  Where
    one value alone explains it, and the rest of its group agrees, it is named instead.  A factor above 1 is a caution,
    above POOR_FIT a fault: errors so much larger than stated are seldom random, and no factor makes those true that
    values have in common.
    Where the factors do not settle, observations contradict each other: all have one factor, and a caution states it.
    raises    InputError without statistics

    Limits: a group without redundancy is taken at its word, and little redundancy seldom sees a factor
    of 2 (`chance_to_see`).
    """
    if not options.statistics:
        raise InputError("adjustment.groups_without_statistics")
    first = adjusted(block, replace(options, variance_groups=False))
    if first.redundancy <= 0:
        return replace(first, options=options)
    others = frozenset(key for key in _steps(first) if key[0] in NAMES.values())
    found = _settled(block, options, adjusted, first, others)
    if found is not None and others:
        single = frozenset(key for key in others if _one_explains(found[0], key))
        if single != others:
            found = _without_right(block, options, adjusted, found[0], single)
    if found is None:
        return replace(first, notices=(*first.notices, _unsettled()))
    result, factors = found
    reported = _factors(result, factors)
    notices = (*result.notices, *_notice(reported), *_contradictions(reported))
    return replace(result, given=weighted(block, factors), group_factors=reported, notices=notices)


def chance_to_see(factor: float, redundancy: float) -> float:
    """Probability that errors so many times as large as stated give their group a factor, by its redundancy."""
    from scipy.special import gammaincc, gammainccinv

    return float(gammaincc(redundancy / 2, gammainccinv(redundancy / 2, LEVEL / 2) / factor**2))


def _one_explains(result: Adjustment, key: Key) -> bool:
    """Whether a single value makes a group contradict what was stated: a factor for all would hide it."""
    kind = next(k for k, name in NAMES.items() if name == key[0])
    if not any(n.code == f"{kind}_suspect" for n in result.notices):
        return False
    left = [without_worst(g) for g in result.groups if g.kind == kind]
    return any(r >= FEW and chi_square_tails(max(square, 0.0), r)[1] >= LEVEL / 2 for square, r in left)


def _without_right(
    block: Block, options: AdjustmentOptions, adjusted: Adjust, result: Adjustment, kept: frozenset[Key]
) -> tuple[Adjustment, dict[Key, float]] | None:
    """Factors of all groups but those that are `kept` and whose residuals do not contradict what was stated.

    None where they do not settle.
    """
    while True:
        found = _settled(block, options, adjusted, result, kept)
        if found is None:
            return None
        result, factors = found
        steps = _steps(result)
        right = {key for key in factors if key[0] in NAMES.values() and not _contradicts(factors[key], steps.get(key))}
        if not right:
            return found
        kept |= right


def _settled(
    block: Block, options: AdjustmentOptions, adjusted: Adjust, result: Adjustment, kept: frozenset[Key]
) -> tuple[Adjustment, dict[Key, float]] | None:
    """Adjusted anew with the factors of its own residuals until they stay; groups that are `kept` have none.

    None where they do not.
    """
    factors: dict[Key, float] = {}
    for k in range(ROUNDS):
        change = {key: c for key, c in _changes(_steps(result), factors).items() if key not in kept}
        if k and all(abs(c - 1) < SETTLED for c in change.values()):
            return result, factors
        factors = {key: factors.get(key, 1.0) * c for key, c in change.items()}
        images = _images(_steps(result))  # of others a factor as far away states that something else is wrong
        factors = {k: f for k, f in factors.items() if 1 / FARTHEST < f < FARTHEST or (k in images and f > 1)}
        result = adjusted(started(weighted(block, factors), result.adjusted), options)
        if len(block.observations) > LARGE and k:
            return result, factors
    return None


def _unsettled() -> Notice:
    return Notice(code="variance_groups.unsettled", measured=Severity.WARNING)


def _steps(result: Adjustment) -> dict[Key, VarianceComponent]:
    return {(c.kind, c.group): c for c in result.variance_components}


def _contradicts(factor: float, component: VarianceComponent | None) -> bool:
    """Whether residuals contradict a given standard deviation of which they make `factor` times as much."""
    if component is None or component.redundancy < (FEW if factor > 1 else LEAST):
        return False
    r = component.redundancy
    return 2 * min(chi_square_tails(factor**2 * r, r)) < LEVEL


def _images(steps: dict[Key, VarianceComponent]) -> list[Key]:
    """The groups of image points: the cameras, where there are several."""
    cameras = [key for key in steps if key[0] == "camera"]
    return cameras or [key for key in steps if key[0] == "image observations"]


def _changes(steps: dict[Key, VarianceComponent], before: dict[Key, float]) -> dict[Key, float]:
    """What the standard deviations of each group are to be multiplied by once more.

    before  what they were multiplied by; a group that lost its redundancy by that has no factor any more
    """
    all_images = steps.get(("image observations", "all"))
    change: dict[Key, float] = {}
    for key in _images(steps):
        own = steps[key] if steps[key].redundancy >= LEAST else all_images
        if own is not None and own.redundancy >= LEAST and own.ratio > 0:
            change[key] = own.ratio
    for key, c in steps.items():
        if key[0] in NAMES.values() and c.redundancy >= (LEAST if c.ratio <= 1 and key not in before else FEW):
            change[key] = c.ratio or 1.0
    return change if not before else {key: c for key, c in change.items() if key in before}


def _factors(result: Adjustment, factors: dict[Key, float]) -> tuple[GroupFactor, ...]:
    steps = _steps(result)
    keys = [*_images(steps), *(key for key in steps if key[0] in NAMES.values())]
    return tuple(
        GroupFactor(
            kind=key[0], group=key[1], count=steps[key].count, redundancy=steps[key].redundancy,
            factor=factors.get(key, 1.0), estimated=key in factors,
        )
        for key in keys
    )  # fmt: skip


def _contradictions(factors: tuple[GroupFactor, ...]) -> tuple[Notice, ...]:
    """Of the groups outside the images that are less precise than stated."""
    return tuple(
        Notice(
            code="group_less_precise.weighted",
            measured=Severity.FAULT if g.factor > POOR_FIT else Severity.WARNING,
            values={"kind": g.kind.replace(" ", "_"), "ratio": g.factor, "count": g.count, "redundancy": g.redundancy},
            ids=(g.kind,),
        )
        for g in factors
        if g.estimated and g.factor > 1 and g.kind in NAMES.values()
    )


def _notice(factors: tuple[GroupFactor, ...]) -> tuple[Notice, ...]:
    if not factors:
        return ()
    each = tuple(map(_group, factors))
    return (Notice(code="variance_groups", values={"n": len(factors)}, details=each, measured=Severity.NOTE),)


def _group(g: GroupFactor) -> Message:
    kind = g.kind.replace(" ", "_")
    if g.estimated:
        return message(
            "variance_groups.group", kind=kind, group=g.group, factor=g.factor, count=g.count, redundancy=g.redundancy
        )
    return message("variance_groups.as_given", kind=kind, group=g.group, count=g.count, redundancy=g.redundancy)
