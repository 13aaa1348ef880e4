"""Decisions: which observations are blunders, which parameters of the interior orientation are worth estimating.

Every decision is listed with its reason; nothing is decided that the options do not ask for.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import groupby
from typing import Protocol

import numpy as np

from raybundle.adjustment.asked_parameters import check_asked, with_asked
from raybundle.adjustment.engine import Extent, Start, adjust_block, as_start, free_parameters
from raybundle.adjustment.exchanged_points import exchanged_notices
from raybundle.adjustment.known_before import against_known
from raybundle.adjustment.masking import Unmasked, is_suspect, masked_notices, unmasked
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.pixel_shape import beyond_sensor, shape_limit, under_its_noise, untold_shape
from raybundle.adjustment.reintersection import reintersected
from raybundle.adjustment.rejected_groups import rejected_group_notices
from raybundle.adjustment.result import Adjustment, InteriorResult, Notice, printed_unit
from raybundle.adjustment.severity import Severity
from raybundle.adjustment.snooping import apart, bent_by_distances, innocent, is_blunder, with_rejected, without_reasons
from raybundle.adjustment.wrong_control import (
    WrongControl,
    judged,
    kept_notice,
    left_out,
    rejected_notice,
    suspected,
)
from raybundle.block import Block, Camera
from raybundle.block.rejection import Rejections, given_rejections
from raybundle.block.stored import is_observed_jointly
from raybundle.errors import DatumDefect, NoConvergence, NotSolvable, RankDefect
from raybundle.numerics.progress import Progress, silent
from raybundle.numerics.statistics import fisher_tail
from raybundle.sensors import sensor_models
from raybundle.settings import option

ROUNDS = 40
CHOICES = 30
"""Steps of the choice of parameters; each holds one or one group."""
OF_THE_END = {"control_not_located", "snooping_masked", "image_contradicts", "control_contradicts", "names_exchanged"}
"""Codes of notices on what snooping leaves: those of an earlier run are replaced"""
MASKING_ROUNDS = (10, 20, 30)
"""Rounds of data snooping at which masked gross errors are looked for, beside where no suspect is left."""
DROP_ORDER = ("harmonic", "read-out", "affinity", "decentring", "radial", "principal point", "scale")
"""Which kind of parameter is held first where a block determines too few."""


@dataclass(slots=True)
class Decisions:
    """What was decided so far."""

    free: dict[str, tuple[str, ...]]
    reasons: Rejections
    kept_free: frozenset[tuple[str, str]]
    """Camera, symbol: what is estimated in any case"""
    known: Mapping[str, Mapping[str, float]]
    """By camera, what was known before anything was measured: where what is not determinable is held"""
    notices: list[Notice] = field(default_factory=list[Notice])
    not_significant: list[tuple[str, str]] = field(default_factory=list[tuple[str, str]])
    not_determinable: list[tuple[str, str]] = field(default_factory=list[tuple[str, str]])
    adjusting: Adjusting = adjust_block


class Adjusting(Protocol):
    """Adjusts a block as `adjust_block` does, as far as decisions ask."""

    def __call__(
        self, block: Block, options: AdjustmentOptions, progress: Progress, *, free: dict[str, tuple[str, ...]],
        rejected: Rejections, extent: Extent, start: Start,
    ) -> Adjustment:  # fmt: skip
        """The result, with these image observations rejected and these parameters free."""
        ...


def decide(
    block: Block, options: AdjustmentOptions, progress: Progress = silent, *, notices: tuple[Notice, ...] = ()
) -> Adjustment:
    """Adjust a block with approximate values, with the decisions that the options and the block ask for."""
    began = time.perf_counter()
    start, choices = decisions(block, options, adjust_block, progress)
    final = replace(options, robust_start=options.robust_start and start is block)
    result = adjust_block(
        start, final, progress, free=choices.free, rejected=choices.reasons, notices=(*notices, *choices.notices),
        start="approximate" if start is block else "adjusted",
    )  # fmt: skip
    result = against_known(_labelled(under_its_noise(result), choices))
    return replace(result, given=block, options=options, seconds=time.perf_counter() - began)


def decisions(
    block: Block, options: AdjustmentOptions, adjusting: Adjusting, progress: Progress = silent
) -> tuple[Block, Decisions]:
    """What is decided of a block with approximate values, and the block with the values that this led to.

    adjusting  who adjusts it on the way
    """
    check_asked(block, options)
    choices = Decisions(
        free={c.id: with_asked(c, free_parameters(c), options) for c in block.parametrised},
        reasons=given_rejections(block),
        kept_free=frozenset(options.free),
        known={c.id: {**c.values, **{s: v for s, v in c.known.items() if s in c.values}} for c in block.parametrised},
        adjusting=adjusting,
    )
    automatic = [
        c.id
        for c in block.cameras
        if c.scene is None
        and (c.estimate == "auto" or (options.estimate == "auto" and c.estimate and not is_observed_jointly(c)))
    ]
    start = block
    if options.reject == "snooping":
        start = _snoop_what_is_determined(start, options, choices, automatic, progress)
    if automatic:
        start = _choose(start, options, choices, automatic, progress)
        if options.reject == "snooping":
            start = _snoop(start, options, choices, progress, start="adjusted")
    return start, choices


def _quiet(
    block: Block, options: AdjustmentOptions, choices: Decisions, progress: Progress, *, extent: Extent = "decisions",
    start: Start = "adjusted",
) -> Adjustment:  # fmt: skip
    brief = replace(
        options, statistics=True, robust_start=start == "approximate", tolerance=max(options.tolerance, 1e-4)
    )
    return choices.adjusting(
        block, brief, progress, free=choices.free, rejected=choices.reasons, extent=extent, start=start
    )


def _snoop_what_is_determined(
    block: Block, options: AdjustmentOptions, choices: Decisions, automatic: list[str], progress: Progress
) -> Block:
    """As `_snoop`; parameters that make the block singular are held first, the least needed ones before the others."""
    while True:
        try:
            return _snoop(block, options, choices, progress)
        except RankDefect as error:
            held = _hold_next(block, choices, automatic, error)
            if held is None:
                raise
            block = _with_values(block, *held)


def _snoop(
    block: Block, options: AdjustmentOptions, choices: Decisions, progress: Progress, *, start: Start = "approximate"
) -> Block:
    """Reject blunders in rounds, each round those that do not touch one another; then let rejected ones return.

    Test: tau = v / (sigma0 s sqrt r), largest of the two coordinates of an image point, against the family-wise
    critical value (Pope 1976).  A rejected observation returns once if its residual is below that limit.  Where
    rejections would leave position, orientation or scale open, it is the control that contradicts: its image
    observations return and stay, and the contradiction is told.
    """
    returned: set[int] = set()
    guarded = np.zeros(len(block.observations), bool)
    tried: Unmasked | None = None
    before: tuple[Block, Rejections] | None = None
    robust = True
    tried_again: set[int] = set()
    for number in range(ROUNDS):
        try:
            result = _quiet(block, options, choices, progress, extent="tests", start=start)
        except NotSolvable as error:
            if before is not None:  # without what a robust estimate left out the block is not determined
                block, choices.reasons, tried, before, robust = *before, None, None, False
                continue
            if robust and tried is None and _may_be_torn(error):
                tried = unmasked(block, options, choices.free, choices.reasons, guarded)
                if tried is not None:
                    block, choices.reasons, start = tried.block, tried.reasons, "adjusted"
                    continue
            if not isinstance(error, DatumDefect):
                raise
            guarded = np.asarray(block.points.is_control.any(axis=1))[block.observations.point]
            back = [i for i, r in enumerate(choices.reasons) if is_blunder(r) and guarded[i]]
            if not back:
                raise
            returned.update(back)
            choices.reasons = without_reasons(choices.reasons, back)
            continue
        start, before = "adjusted", None
        block = as_start(block, result.adjusted)
        choices.reasons = result.image_observations.rejected
        size = np.nan_to_num(np.abs(result.image_observations.t).max(axis=1))
        suspects = np.flatnonzero((size > result.critical_tau) & ~guarded)
        wrong = _wrong_control(result, choices, float(size.max(initial=0.0)))
        if wrong is not None and wrong.may_go:
            block, choices.reasons = left_out(block, wrong.name, choices.reasons)
            choices.notices.append(rejected_notice(wrong))
            continue
        if wrong is not None:  # it is the points that are wrong, not their image observations
            taken = [block.points.ids.index(name) for name in (wrong.name, *wrong.others)]
            suspects = suspects[~np.isin(block.observations.point[suspects], taken)]
        suspects = suspects[~bent_by_distances(result, suspects, size)]
        chosen = apart(block, size, suspects)
        stuck = not chosen or number in MASKING_ROUNDS
        if robust and tried is None and wrong is None and stuck and is_suspect(result):
            r = result.image_observations.redundancy
            tried = unmasked(block, options, choices.free, choices.reasons, guarded, r)
            if tried is not None:
                before = block, choices.reasons
                block, choices.reasons = tried.block, tried.reasons
                continue
        if not chosen:
            again = reintersected(result, block, tried_again)
            if again is not None:
                block, choices.reasons, found = again
                tried_again |= found
                continue
            back = [i for i in innocent(result) if i not in returned]
            if not back:
                choices.notices = [n for n in choices.notices if n.code not in OF_THE_END]
                choices.notices += [] if wrong is None else [kept_notice(wrong)]
                choices.notices += [*masked_notices(result, tried), *rejected_group_notices(result)]
                choices.notices += exchanged_notices(result)
                return block
            returned.update(back)
            choices.reasons = without_reasons(choices.reasons, back)
            continue
        choices.reasons = with_rejected(result, choices.reasons, np.array(chosen), size)
    choices.notices.append(
        Notice(code="snooping_unfinished", message=f"data snooping stopped after {ROUNDS} rounds; suspects are left")
    )
    return block


def _may_be_torn(error: NotSolvable) -> bool:
    """Whether gross errors may be why there is no solution: no convergence, or points alone that are not determined."""
    torn = isinstance(error, RankDefect) and {u.kind for u in error.undetermined} == {"point"}
    return torn or isinstance(error, NoConvergence)


def _wrong_control(result: Adjustment, choices: Decisions, largest: float) -> WrongControl | None:
    """The control point that contradicts the others more than any image observation does, and what is known of it.

    More: letting it go takes more from the square sum than leaving out the image coordinate with the largest tau.
    """
    worst = suspected(result)
    if worst is None or worst.square <= (largest * result.sigma0) ** 2:
        return None
    return judged(result, worst, choices.free, choices.reasons)


def _choose(
    block: Block, options: AdjustmentOptions, choices: Decisions, automatic: list[str], progress: Progress
) -> Block:
    """Backward elimination from all parameters, guarded by determinability; each step is told."""
    for camera in block.cameras:
        if camera.id in automatic:
            model = sensor_models[camera.model]
            named = () if camera.estimate == "auto" else camera.estimate  # of the other kinds, what is asked for
            out = {"other"} if _moves(block, camera) else {"other", "read-out"}
            every = tuple(p.symbol for p in model.parameters if p.kind not in out or p.symbol in named)
            choices.free[camera.id] = with_asked(camera, every, options)
    result: Adjustment | None = None
    for _ in range(CHOICES):
        try:
            first = result is None and options.reject == "none"
            result = _quiet(block, options, choices, progress, start="approximate" if first else "adjusted")
        except (RankDefect, NoConvergence) as error:
            held = _hold_next(block, choices, automatic, error)
            if held is None:
                raise
            block = _with_values(block, *held)
            continue
        block = as_start(block, result.adjusted)
        worst = _least_determinable(result, automatic, choices)
        if worst is not None:
            camera, symbol, reason = worst
            value = choices.known[camera][symbol]
            _hold(choices, _camera(block, camera), symbol, value, reason)
            # what it took in the fit is no value of it; the others are to be what they are beside the known one
            block = _with_values(block, camera, {symbol: value})
            continue
        beyond = beyond_sensor(result, automatic) if options.pixel_shape == "sensor" else None
        if beyond is not None and beyond.ids not in choices.kept_free:
            block = _hold_shape(block, choices, beyond, beyond.limit)
            continue
        untold = untold_shape(result, automatic) if options.pixel_shape == "sensor" else None
        if untold is not None and untold.ids not in choices.kept_free:
            choices.not_significant.append((untold.ids[0], untold.ids[1]))
            block = _hold_shape(block, choices, untold, shape_limit(_camera(block, untold.ids[0]), untold.ids[1]))
            continue
        without = _drop_insignificant(block, options, choices, automatic, result, progress)
        if without is None:
            return block
        block = without
    free = sum(len(choices.free[c]) for c in automatic)
    choices.notices.append(
        Notice(
            code="choice_unfinished",
            message=f"the choice of parameters ended after {CHOICES} steps; {free} parameters stay free, "
            f"some of them perhaps not significant. Name the parameters to hold ({option('hold')})",
            ids=tuple(automatic), values={"steps": CHOICES, "free": free, "cameras": len(automatic)},
        )
    )  # fmt: skip
    assert result is not None
    return as_start(block, result.adjusted)


def _moves(block: Block, camera: Camera) -> bool:
    """Whether images of a camera are known to move while they are read out: without that no read-out time shows."""
    own = block.images.interior
    mine = np.flatnonzero([block.cameras[c].id == camera.id for c in block.images.camera.tolist()])
    return any(own.get(int(i), {}).get(s, 0.0) for i in mine for s in camera.per_image)


def _hold_shape(block: Block, choices: Decisions, told: Notice, limit: float) -> Block:
    """The block with an affinity or shear of no sensor held as given, or at 0 where that is no sensor's either."""
    name, symbol = told.ids
    given = choices.known[name][symbol]
    choices.free[name] = tuple(s for s in choices.free[name] if s != symbol)
    choices.notices.append(told)
    return _with_values(block, name, {symbol: given if abs(given) <= limit else 0.0})


def _camera(block: Block, name: str) -> Camera:
    return next(c for c in block.cameras if c.id == name)


def _hold(choices: Decisions, camera: Camera, symbol: str, value: float, reason: str) -> None:
    """Hold a parameter at a value, and say so."""
    choices.free[camera.id] = tuple(s for s in choices.free[camera.id] if s != symbol)
    choices.not_determinable.append((camera.id, symbol))
    parameter = next(p for p in camera.sensor.parameters if p.symbol == symbol)
    at = _in_unit(value, printed_unit(parameter.unit, ""), 4) if value else "0"
    choices.notices.append(
        Notice(
            code="held_not_determinable",
            measured=Severity.REMARK if not value and _is_refinement(camera, symbol) else Severity.CAUTION,
            message=f"camera {camera.id}: {symbol} is not determinable and is held at {at}, as known before: "
            f"{reason.rstrip('.')}. All that is stated holds for that value",
            ids=(camera.id, symbol),
        )
    )


def _is_refinement(camera: Camera, symbol: str) -> bool:
    """Whether a lens is seldom far from having none of it: all but the scale, principal point, first radial term."""
    kinds = {p.symbol: p.kind for p in camera.sensor.parameters}
    first = next((s for s, kind in kinds.items() if kind == "radial"), "")
    return symbol != first and kinds[symbol] in ("radial", "decentring", "affinity")


def _in_unit(value: float, unit: str, digits: int = 2) -> str:
    return f"{value:.{digits}g} {unit}".rstrip()


def _hold_next(
    block: Block, choices: Decisions, automatic: list[str], error: NotSolvable
) -> tuple[str, dict[str, float]] | None:
    """Hold the least needed parameter, of those that the error names; camera and value, None if none is left.

    Where images or points alone are not determined, it is no parameter's fault.
    """
    named = {(u.name, u.symbol) for u in error.undetermined if u.kind == "parameter"}
    if error.undetermined and not named:
        return None
    found: list[tuple[bool, int, int, str, str]] = []
    for camera in automatic:
        for k, p in enumerate(_camera(block, camera).sensor.parameters):
            if p.kind in DROP_ORDER and p.symbol in choices.free[camera]:
                found.append(((camera, p.symbol) not in named, DROP_ORDER.index(p.kind), -k, camera, p.symbol))
    if not found:
        return None
    _, _, _, camera, symbol = min(found)
    value = choices.known[camera][symbol]
    _hold(choices, _camera(block, camera), symbol, value, str(error).splitlines()[0])
    return camera, {symbol: value}


def _least_determinable(result: Adjustment, automatic: list[str], choices: Decisions) -> tuple[str, str, str] | None:
    found: list[tuple[int, int, float, str, str, str]] = []
    for interior in result.interior:
        if interior.camera not in automatic:
            continue
        model = sensor_models[next(c.model for c in result.given.cameras if c.id == interior.camera)]
        kinds = {p.symbol: p.kind for p in model.parameters}
        order = {s: k if kinds[s] == "radial" else 0 for k, s in enumerate(model.symbols)}
        for p in interior.parameters.values():
            kept = (interior.camera, p.symbol) in choices.kept_free
            if p.status == "not determinable" and kinds[p.symbol] in DROP_ORDER and not kept:
                std = p.std_words(result.length_unit)
                reason = f"its standard deviation is {std}, {p.effect_std_px or 0:.0f} px in the image"
                effect = -(p.effect_std_px or 0)
                place = DROP_ORDER.index(kinds[p.symbol]), -order[p.symbol], effect
                found.append((*place, interior.camera, p.symbol, reason))
    return None if not found else min(found)[3:]


def _candidates(interior: InteriorResult, result: Adjustment) -> list[tuple[str, ...]]:
    """Groups that may leave: highest radial term (not K1), decentring, affinity with shear, pairs of harmonics."""
    model = sensor_models[next(c.model for c in result.given.cameras if c.id == interior.camera)]
    kinds = {p.symbol: p.kind for p in model.parameters}
    radial = [s for s in interior.free if kinds[s] == "radial"]
    groups: list[tuple[str, ...]] = [(radial[-1],)] if len(radial) > 1 else []
    for kind in ("decentring", "affinity"):
        group = tuple(s for s in interior.free if kinds[s] == kind)
        if group:
            groups.append(group)
    harmonics = [p for p in model.parameters if p.kind == "harmonic" and p.symbol in interior.free]
    groups += [tuple(p.symbol for p in pair) for _, pair in groupby(harmonics, key=lambda p: p.meaning)]
    return groups


def _drop_insignificant(
    block: Block, options: AdjustmentOptions, choices: Decisions, automatic: list[str], result: Adjustment,
    progress: Progress,
) -> Block | None:  # fmt: skip
    """The block without the group that is most probably nil, if BIC agrees; None if none leaves.

    A group stays, however uncertain, where it could move image points by more than their standard deviation: that it
    is not significant then says that the block cannot tell, and without it the others would be biased and their
    standard deviations too small.
    """
    weakest: tuple[float, str, tuple[str, ...]] | None = None
    sigma_px = float(np.median(np.sqrt(block.observations.cov_px2[:, :2]))) * result.sigma0
    for interior in result.interior:
        if interior.camera not in automatic or interior.image is not None or result.precision is None:
            continue
        C = result.precision.interior[interior.camera]
        for candidates in _candidates(interior, result):
            group = tuple(s for s in candidates if (interior.camera, s) not in choices.kept_free)
            if not group:
                continue
            k = [interior.free.index(s) for s in group]
            x = np.array([interior.parameters[s].value for s in group])
            F = float(x @ np.linalg.solve(C[np.ix_(k, k)], x) / len(k))
            p = fisher_tail(F, len(k), max(result.redundancy, 1))
            if _hidden(interior, group) > sigma_px:
                continue
            if p > options.significance and (weakest is None or p > weakest[0]):
                weakest = (p, interior.camera, group)
    if weakest is None:
        return None
    probability, camera, group = weakest
    before = dict(choices.free)
    choices.free[camera] = tuple(s for s in choices.free[camera] if s not in group)
    zeroed = _with_values(block, camera, dict.fromkeys(group, 0.0))
    try:
        without = _quiet(zeroed, options, choices, progress)
    except NotSolvable:
        choices.free = before
        return None
    m = result.observations
    gain = m * np.log(result.weighted_square_sum / without.weighted_square_sum) + len(group) * np.log(m)
    if gain < 0:  # BIC prefers to keep the group
        choices.free = before
        return None
    choices.not_significant += [(camera, s) for s in group]
    own = next(i for i in result.interior if i.camera == camera)
    choices.notices.append(
        Notice(
            code="not_significant",
            message=f"camera {camera}: {', '.join(group)} left out: probability {probability:.2g} of such values by "
            f"chance, "
            f"BIC lower by {gain:.1f} without; they could move image points by {_hidden(own, group):.2g} px at most",
            ids=(camera, *group),
        )
    )
    return as_start(zeroed, without.adjusted)


def _hidden(interior: InteriorResult, group: tuple[str, ...]) -> float:
    """Largest displacement [px] in the format that these parameters could still have, two standard deviations up."""
    parts = [interior.parameters[s] for s in group]
    return max((p.effect_px or 0.0) + 2 * (p.effect_std_px or 0.0) for p in parts)


def _with_values(block: Block, camera: str, values: Mapping[str, float]) -> Block:
    """The block with these values of a camera."""
    cameras = tuple(replace(c, values={**c.values, **values}) if c.id == camera else c for c in block.cameras)
    return replace(block, cameras=cameras)


def _labelled(result: Adjustment, choices: Decisions) -> Adjustment:
    """The result with the decisions in its parameter tables."""
    status = dict.fromkeys(choices.not_significant, "not significant")
    status |= dict.fromkeys(choices.not_determinable, "not determinable")
    interior = tuple(
        replace(
            i,
            parameters={
                s: replace(p, status=status[i.camera, s]) if (i.camera, s) in status else p
                for s, p in i.parameters.items()
            },
        )
        for i in result.interior
    )
    names = tuple(f"{s} (camera {c})" for c, s in choices.not_determinable)
    return replace(
        result,
        interior=interior,
        not_determinable=tuple(dict.fromkeys((*result.not_determinable, *names))),
        not_significant=tuple(f"{s} (camera {c})" for c, s in choices.not_significant),
    )
