"""Levenberg-Marquardt with gain control; the last steps are pure Gauss-Newton.

Damping after Marquardt 1963 with the gain ratio of Nielsen 1999; a step that carries object points
behind a camera is tried again shorter.  Points whose rays diverge never come to an end: they are named once the steps
are short.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.assemble import State
from raybundle.errors import NoConvergence
from raybundle.numerics.arrays import Index
from raybundle.numerics.progress import Progress, silent

FLOOR = 1e-10
"""Smallest damping: it carries the open datum, and is too small to slow anything else."""
CAUTIOUS = 1e-4
"""Damping of the first step from approximate values."""
CLOSE = 1.0
"""Steps, in standard deviations, from which on damping is not needed where they bring what they promise.

Where a step was refused before, it goes down slowly.
"""
ROUNDING = 1e-13
"""Share of the square sum below which a predicted decrease is rounding."""
NOISE = 1e-11
"""Share of the square sum below which a difference of two of them states nothing."""
NEARLY = 1e-3
"""Steps, in standard deviations, that are short enough where points run away whose rays diverge."""
EXACT = 1e-5
"""Smallest sigma0 by which steps are measured: below it observations are exact, and steps are rounding."""
HUBER = 2.0
"""Whitened residual length beyond which the robust start weighs linearly."""


class Equations(Protocol):
    """The normal equations of a network, in one piece (`Normals`) or in parts (`raybundle.blocking`)."""

    @property
    def unknowns(self) -> int:
        """Number of unknowns before a datum is chosen."""
        ...

    @property
    def observations(self) -> int:
        """Number of observations."""
        ...

    def reduce(self, state: State, *, damping: float = 0.0, huber: float = 0.0) -> tuple[float, int, list[int]]:
        """Form them at a state; cost, observations behind the camera, points whose own matrix is singular."""
        ...

    def trial(
        self, state: State, *, damping: float = 0.0, huber: float = 0.0, passing: bool = False
    ) -> tuple[State, float] | int:
        """The state after a step, after `reduce`, and its linearised cost; or the unknown that stops the factor."""
        ...

    def cost(self, state: State, *, huber: float = 0.0) -> tuple[float, int]:
        """Half the weighted square sum, and the observations behind the camera."""
        ...

    def excess(self, state: State, huber: float) -> float:
        """Huber's costs of long residuals over those of the weighted ones that stand for them."""
        ...

    def before(self, state: State) -> State:
        """The state with points before their cameras that all of these see behind; the same one where none is."""
        ...

    def beyond(self, state: State) -> Index:
        """Object points whose rays diverge."""
        ...


@dataclass(slots=True)
class Solution:
    """Where the iteration ended."""

    state: State
    cost: float
    """Half the weighted square sum."""
    converged: bool
    iterations: int
    step: float
    """Length of the last full step in standard deviations of the unknowns."""
    behind: int
    beyond: Index
    """Object points whose rays diverge (`far_points`)"""


def solve(
    normals: Equations,
    state: State,
    options: AdjustmentOptions,
    *,
    huber: float = 0.0,
    tolerance: float | None = None,
    damping: float = CAUTIOUS,
    approximate: bool = False,
    progress: Progress = silent,
) -> Solution:
    """Minimise the weighted square sum (or its robust form) from a state.

    The length of a step is sqrt(dx' N dx / u) / sigma0: the root mean square of its components in
    standard deviations.  Converged: an undamped step, or one damped too little to matter, is
    shorter than the tolerance.

    approximate  points that end behind their cameras may stay there, whoever asks intersects them anew; otherwise they
                 are placed before them, and the iteration goes on without any passing infinity (`far_points`)
    """
    found = _iterated(normals, state, options, huber, tolerance, damping, progress, passing=True)
    if approximate or not found.behind or not found.converged:
        return found
    turned = normals.before(found.state)
    if turned is found.state:  # control, or points that other cameras see: their observations leave
        return found
    again = _iterated(normals, turned, options, huber, tolerance, CAUTIOUS, progress, passing=False)
    if not again.converged:
        return found
    return replace(again, iterations=found.iterations + again.iterations)


def _iterated(
    normals: Equations, state: State, options: AdjustmentOptions, huber: float, tolerance: float | None, damping: float,
    progress: Progress, *, passing: bool,
) -> Solution:  # fmt: skip
    """One run of the iteration; `passing`: points may pass infinity."""
    limit = options.tolerance if tolerance is None else tolerance
    unknowns = max(normals.unknowns, 1)
    redundancy = max(normals.observations - normals.unknowns, 1)
    growth = 2.0
    cost, behind, _ = normals.reduce(state, damping=damping, huber=huber)
    excess = normals.excess(state, huber)
    length, refused_behind = np.inf, 0
    start, refused, settled = None, False, False
    iterations, done = 0, 0.0
    while iterations < options.max_iterations:
        iterations += 1
        trial = normals.trial(state, damping=damping, huber=huber, passing=passing)
        if isinstance(trial, int):
            damping, growth = max(damping, 1e-10) * growth, growth * 2
            if damping > 1e12:
                break
            normals.reduce(state, damping=damping, huber=huber)
            continue
        new, linear = trial
        predicted = cost - excess - linear
        sigma0 = max(np.sqrt(2 * cost / redundancy), EXACT)
        length = float(np.sqrt(max(2 * predicted, 0.0) / unknowns) / sigma0)
        if sigma0 == EXACT and length < limit and damping > FLOOR and not refused:
            damping = FLOOR  # exact from the start: the full step shows whether that is all
            normals.reduce(state, damping=damping, huber=huber)
            continue
        new_cost, new_behind = _cost(normals, new, huber)
        gain = _gain(cost, new_cost, predicted)
        turned = new_behind > behind and gain < 0.25 and refused_behind < 6
        settled = (length < limit or predicted < ROUNDING * cost) and damping < 1e-5
        if settled:
            # what is left to gain is below the rounding of the square sum
            if new_cost <= cost:
                state, cost, behind = new, new_cost, new_behind
            break
        if np.isfinite(new_cost) and not turned and gain > 1e-4:
            state, cost, behind, refused_behind = new, new_cost, new_behind, 0
            excess = normals.excess(state, huber)
            growth = 2.0
            damping = _less(damping, gain, floor=gain > 0.9 and length < CLOSE and not refused)
            start = length if start is None else start
            done = max(done, _share(start, length, limit))  # a step may be longer than the one before
            progress("adjusting", done)
        else:
            refused = True
            refused_behind += int(turned)
            damping, growth = max(damping, 1e-9) * growth, growth * 2
            if damping > 1e12:
                break
        if not passing and length < NEARLY and len(normals.beyond(state)):
            break
        normals.reduce(state, damping=damping, huber=huber)
    beyond = np.zeros(0, np.int64) if passing else normals.beyond(state)
    return Solution(state, cost, settled or length < NEARLY, iterations, length, behind, beyond)


def _gain(cost: float, new: float, predicted: float) -> float:
    """What a step brought over what its linear model predicted."""
    if predicted > NOISE * cost:
        return (cost - new) / predicted
    return 1.0 if new <= cost * (1 + NOISE) else -1.0  # what the costs differ by is rounding


def _less(damping: float, gain: float, *, floor: bool) -> float:
    """The damping after a step that was taken."""
    damping *= 1 / 30 if 0.95 < gain < 1.05 else max(1 / 3, 1 - (2 * min(gain, 1.0) - 1) ** 3)
    return FLOOR if floor else max(damping, FLOOR)


def _cost(normals: Equations, state: State, huber: float) -> tuple[float, int]:
    """Cost of a trial step and points behind their images; infinite where a scene does not see a point of it."""
    try:
        return normals.cost(state, huber=huber)
    except NoConvergence:
        return np.inf, 0


def _share(start: float, length: float, limit: float) -> float:
    """Share of the way done, by orders of magnitude of the step."""
    whole = np.log10(max(start, 10 * limit) / limit)
    return float(np.clip(1 - np.log10(max(length, limit) / limit) / whole, 0.0, 1.0))
