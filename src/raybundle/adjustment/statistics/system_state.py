"""An adjusted system with its factor: what statistics, decisions and later questions work on."""

from __future__ import annotations

from dataclasses import dataclass

from raybundle.adjustment.statistics.noise import Spread
from raybundle.adjustment.statistics.precision import Cofactors
from raybundle.adjustment.system.assemble import State, System
from raybundle.adjustment.system.datum import Datum
from raybundle.adjustment.system.normals import Normals
from raybundle.adjustment.system.solve import Solution


@dataclass(slots=True)
class Work:
    """An adjusted system with its factor, for statistics and decisions."""

    system: System
    normals: Normals
    datum: Datum
    solution: Solution
    found: Cofactors | None
    parts: int
    state: State
    """Adjusted values in the frame of the result, at which the factor stands"""
    under_noise: Cofactors | None = None
    """The cofactors that covariances are made of: `found`, under the noise of the photographs where it is not white"""
    spread: Spread | None = None
    """How that noise spreads; None for white noise"""
