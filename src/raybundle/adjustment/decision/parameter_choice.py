"""Which parameters of the interior orientation are estimated: those that are determinable and significant.

All cameras are decided together: each round is one adjustment, and what is held in it follows from the joint covariance
of all interior orientations (`joint_interior`), each parameter beside those that were held before.  Significance rests
on the covariance that the result will state: under smooth errors that differ from image to image, white noise takes
what they make of a few photographs for a lens.  What is determinable at all is a matter of the geometry, and of white
noise.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import groupby

import numpy as np

from raybundle.adjustment.blunders.pixel_shape import beyond_sensor, shape_limit, weak_shape
from raybundle.adjustment.decision.state import State, Task
from raybundle.adjustment.evaluation.joint_interior import JointInterior, joint_interior, smooth_errors, with_joint
from raybundle.adjustment.records.figures import InteriorResult, printed_unit
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.result_figures import Extent
from raybundle.adjustment.system.adjusted_values import as_start
from raybundle.adjustment.system.chosen_parameters import with_asked
from raybundle.block import Block, Camera
from raybundle.errors import Message, NoConvergence, NotSolvable, RankDefect, Value, message
from raybundle.numerics.statistics import fisher_tail
from raybundle.sensors import sensor_models

CHOICES = 30
"""Rounds of the choice of parameters, each with an adjustment."""
LINEAR = 0.1
"""By how much the square sum, in units of sigma0^2, may differ from what the joint covariance predicts where nothing
needs to be judged again: a chi-square at the limit of 5 % then changes its probability by a twentieth."""
DROP_ORDER = ("harmonic", "read-out", "affinity", "decentring", "radial", "principal point", "scale")
"""Which kind of parameter is held first where a block determines too few."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Group:
    """Parameters of a camera that leave together, and what spoke for it."""

    camera: str
    symbols: tuple[str, ...]
    probability: float
    """of values as large by chance"""
    square: float
    """x' C^-1 x, as stated"""
    hidden_px: float
    """by which they could still move image points, two standard deviations up"""

    @property
    def names(self) -> tuple[tuple[str, str], ...]:
        """Camera and symbol of each."""
        return tuple((self.camera, s) for s in self.symbols)


class Choice:
    """Backward elimination from all parameters of all cameras at once, guarded by determinability.

    Each round first holds what is not determinable, then affinities and shears of no sensor, and beside these groups
    that are not significant; the next adjustment confirms it.
    """

    rounds = CHOICES
    extent: Extent = "decisions"

    def decide(self, state: State, result: Adjustment, number: int, task: Task) -> State:
        """With parameters held; settled where all that is judged is as it was judged."""
        del number
        undetermined = _undetermined(result, task)
        if undetermined:  # what one took in the fit is no value of it; the others are to be what they are beside it
            for camera, symbol, reason in undetermined:
                state = _hold(state, camera, symbol, task.known[camera][symbol], reason)
            return state
        smooth = smooth_errors(result, state.noise) if task.options.noise == "fields" else None
        state = state if smooth is None else replace(state, noise=smooth.components)
        joint = joint_interior(result, list(task.automatic), smooth)
        shapes, joint = _shapes(result, joint, task) if task.options.pixel_shape == "sensor" else ([], joint)
        for notice, value in shapes:
            state = state.held(notice.ids[0], {notice.ids[1]: value}).noted(notice)
        if shapes and _least_determinable(with_joint(result, joint, white=True), task.automatic, task) is not None:
            return state
        groups = _insignificant(result, joint, task)
        if not shapes and not groups:
            return replace(state, settled=True)
        for some in dict.fromkeys((len(groups), 0 if shapes else min(len(groups), 1))):
            after = _confirmed(state, result, joint, groups[:some], task)
            if after is not None:  # linear: what was judged beside these is as it was judged
                return replace(after[0], settled=after[1] and some == len(groups))
        return replace(state, settled=not shapes)

    def unsolved(self, state: State, error: NotSolvable, task: Task) -> State | None:
        """With the least needed parameter held."""
        return hold_next(state, error, task) if isinstance(error, RankDefect | NoConvergence) else None

    def unfinished(self, state: State, task: Task) -> Notice:
        """More parameters may be held."""
        free = sum(len(state.free[c]) for c in task.automatic)
        values: dict[str, Value] = {"steps": CHOICES, "free": free, "cameras": len(task.automatic)}
        return Notice(code="choice_unfinished", ids=task.automatic, values=values)


def all_free(state: State, task: Task) -> State:
    """With all parameters of the automatic cameras free that their models have and that are asked for."""
    for name in task.automatic:
        camera = state.camera(name)
        named = () if camera.estimate == "auto" else camera.estimate  # of the other kinds, what is asked for
        out = {"other"} if _moves(state.block, camera) else {"other", "read-out"}
        model = sensor_models[camera.model]
        every = tuple(p.symbol for p in model.parameters if p.kind not in out or p.symbol in named)
        state = state.freed(name, with_asked(camera, every, task.options))
    return state


def _undetermined(result: Adjustment, task: Task) -> list[tuple[str, str, Message]]:
    """Camera, symbol and reason of what is not determinable, each beside those that are held before it.

    One of a camera: what is held at a known value changes sigma0, and with it what else is determinable.
    """
    found = list[tuple[str, str, Message]]()
    rest, shown = list(task.automatic), result
    worst = _least_determinable(result, rest, task)
    joint = joint_interior(result, rest, None) if worst is not None and len(rest) > 1 else None
    while worst is not None:
        found.append(worst)
        camera, symbol, _ = worst
        rest = [c for c in rest if c != camera]
        if joint is None or (camera, symbol) not in joint.names:  # of a single image
            break
        held = float(joint.values[joint.names.index((camera, symbol))])  # no value of it is believed
        joint = joint.held({(camera, symbol): held})
        shown = with_joint(shown, joint, white=True)
        worst = _least_determinable(shown, rest, task)
    return found


def _shapes(result: Adjustment, joint: JointInterior, task: Task) -> tuple[list[tuple[Notice, float]], JointInterior]:
    """Notices of affinities and shears that are held, and where, each beside those before it; what is left free."""
    found = list[tuple[Notice, float]]()
    while True:
        shown = with_joint(result, joint)
        beyond = beyond_sensor(shown, task.automatic)
        if beyond is not None and beyond.ids not in task.kept_free:
            notice, limit = replace(beyond, under_noise=joint.smooth), beyond.limit
        else:
            notice = weak_shape(shown, task.automatic)
            if notice is None or notice.ids in task.kept_free:
                return found, joint
            camera = next(c for c in result.given.cameras if c.id == notice.ids[0])
            limit = shape_limit(camera, notice.ids[1])
        name = notice.ids[0], notice.ids[1]
        given = task.known[name[0]][name[1]]
        value = given if abs(given) <= limit else 0.0
        found.append((notice, value))
        joint = joint.held({name: value})


def _insignificant(result: Adjustment, joint: JointInterior, task: Task) -> list[Group]:
    """Groups that are most probably nil, in the order in which they leave, each beside those before it.

    A group stays, however uncertain, where it could move image points by more than their standard deviation: that it
    is not significant then means that the block cannot decide, and without it the others would be biased and their
    standard deviations too small.
    """
    sigma = float(np.median(np.sqrt(result.given.observations.cov_px2[:, :2]))) * result.sigma0
    sigma_px = float(np.hypot(sigma, joint.smooth_px))
    found = list[Group]()
    while joint.names:
        weakest: Group | None = None
        shown = with_joint(result, joint)
        for interior in shown.interior:
            if interior.camera not in task.automatic or interior.image is not None or result.precision is None:
                continue
            for candidates in _candidates(interior, result):
                symbols = tuple(s for s in candidates if (interior.camera, s) not in task.kept_free)
                if not symbols:
                    continue
                square = joint.square([(interior.camera, s) for s in symbols])
                p = fisher_tail(square / len(symbols), len(symbols), joint.residuals)
                hidden = _hidden(interior, symbols)
                if hidden > sigma_px or not p > task.options.significance:
                    continue
                if weakest is None or p > weakest.probability:
                    weakest = Group(
                        camera=interior.camera, symbols=symbols, probability=p, square=square, hidden_px=hidden
                    )
        if weakest is None:
            return found
        found.append(weakest)
        joint = joint.held(dict.fromkeys(weakest.names, 0.0))
    return found


def _confirmed(
    state: State, result: Adjustment, joint: JointInterior, groups: list[Group], task: Task
) -> tuple[State, bool] | None:
    """Without these groups, adjusted, and whether that is as predicted; None where it is refuted.

    joint  what is predicted without the parameters that are held already
    The square sum may grow by what the joint covariance predicts.  Beyond that the Bayesian information criterion
    (Schwarz 1978) decides, for what is not linear.
    """
    zeroed = state
    for g in groups:
        zeroed = zeroed.held(g.camera, dict.fromkeys(g.symbols, 0.0))
    try:
        without = task.adjusted(zeroed, "residuals")
    except NotSolvable:
        return None
    names = [n for g in groups for n in g.names]
    variance = max(joint.square_sum, 1e-300) / max(joint.redundancy, 1)
    grown = (without.weighted_square_sum - joint.square_sum) / variance
    excess = grown - (joint.square(names, white=True) if names else 0.0)
    penalty = np.log(max(result.observations, 2))
    if names and joint.square(names) + excess > len(names) * penalty:  # BIC prefers to keep them
        return None
    notices = list[Notice]()
    for g in groups:
        gain = len(g.symbols) * penalty - g.square - max(excess, 0.0) * len(g.symbols) / len(names)
        values: dict[str, Value] = {
            "camera": g.camera, "n": len(g.symbols), "symbols": g.symbols, "p": g.probability, "bic": float(gain),
            "effect_px": g.hidden_px,
        }  # fmt: skip
        notices.append(Notice(code="not_significant", values=values, ids=(g.camera, *g.symbols)))
    adjusted = replace(
        zeroed, block=as_start(zeroed.block, without.adjusted),
        not_significant=(*zeroed.not_significant, *names), notices=(*zeroed.notices, *notices),
    )  # fmt: skip
    return adjusted, abs(excess) < LINEAR


def _moves(block: Block, camera: Camera) -> bool:
    """Whether images of a camera are known to move while they are read out: without that no read-out time shows."""
    own = block.images.interior
    mine = np.flatnonzero([block.cameras[c].id == camera.id for c in block.images.camera.tolist()])
    return any(own.get(int(i), {}).get(s, 0.0) for i in mine for s in camera.per_image)


def _hold(state: State, name: str, symbol: str, value: float, reason: Message) -> State:
    """With a parameter held at a value, and a notice of it."""
    camera = state.camera(name)
    parameter = next(p for p in camera.sensor.parameters if p.symbol == symbol)
    unit = printed_unit(parameter.unit, "") if value else ""
    notice = Notice(
        code="held_not_determinable",
        measured=Severity.NOTE if not value and _is_refinement(camera, symbol) else Severity.WARNING,
        values={"camera": name, "symbol": symbol, "at": value, "unit": unit},
        ids=(name, symbol),
        details=(reason,),
    )
    held = state.held(name, {symbol: value}).noted(notice)
    return replace(held, not_determinable=(*held.not_determinable, (name, symbol)))


def _is_refinement(camera: Camera, symbol: str) -> bool:
    """Whether a lens is seldom far from having none of it: all but the scale, principal point, first radial term."""
    kinds = {p.symbol: p.kind for p in camera.sensor.parameters}
    first = next((s for s, kind in kinds.items() if kind == "radial"), "")
    return symbol != first and kinds[symbol] in ("radial", "decentring", "affinity")


def hold_next(state: State, error: NotSolvable, task: Task) -> State | None:
    """With the least needed parameter held, of those that the error names; None if none is left.

    Where images or points alone are not determined, it is no parameter's fault.
    """
    named = {(u.name, u.symbol) for u in error.undetermined if u.kind == "parameter"}
    if error.undetermined and not named:
        return None
    found: list[tuple[bool, int, int, str, str]] = []
    for camera in task.automatic:
        for k, p in enumerate(state.camera(camera).sensor.parameters):
            if p.kind in DROP_ORDER and p.symbol in state.free[camera]:
                found.append(((camera, p.symbol) not in named, DROP_ORDER.index(p.kind), -k, camera, p.symbol))
    if not found:
        return None
    _, _, _, camera, symbol = min(found)
    reason = error.message or message("rank.not_determined")
    return _hold(state, camera, symbol, task.known[camera][symbol], reason)


def _least_determinable(result: Adjustment, automatic: Sequence[str], task: Task) -> tuple[str, str, Message] | None:
    found: list[tuple[int, int, float, str, str, Message]] = []
    for interior in result.interior:
        if interior.camera not in automatic:
            continue
        model = sensor_models[next(c.model for c in result.given.cameras if c.id == interior.camera)]
        kinds = {p.symbol: p.kind for p in model.parameters}
        order = {s: k if kinds[s] == "radial" else 0 for k, s in enumerate(model.symbols)}
        for p in interior.parameters.values():
            kept = (interior.camera, p.symbol) in task.kept_free
            if p.status == "not determinable" and kinds[p.symbol] in DROP_ORDER and not kept:
                reason = message(
                    "held_not_determinable.sigma", sigma=math.nan if p.std is None else p.std,
                    unit=printed_unit(p.unit, result.length_unit), effect_px=p.effect_std_px or 0.0,
                )  # fmt: skip
                effect = -(p.effect_std_px or 0)
                place = DROP_ORDER.index(kinds[p.symbol]), -order[p.symbol], effect
                found.append((*place, interior.camera, p.symbol, reason))
    return None if not found else min(found, key=lambda f: f[:5])[3:]


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


def _hidden(interior: InteriorResult, group: tuple[str, ...]) -> float:
    """Largest displacement [px] in the format that these parameters could still have, two standard deviations up."""
    parts = [interior.parameters[s] for s in group]
    return max((p.effect_px or 0.0) + 2 * (p.effect_std_px or 0.0) for p in parts)
