"""Simulated calibration networks of all kinds: the grade that the verdict gives against that of the true error."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.calibration.maps import calibration_difference, projection_shifts
from raybundle.calibration.quality import SURE, CalibrationQuality, calibration_qualities
from raybundle.errors import RaybundleError
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, brown_camera, field_scene

GRADES = ("good", "usable", "weak")
GOOD_PX, USABLE_PX = 0.1, 0.3
"""Worst true error of projection over the format, at infinity."""


@dataclass(frozen=True, kw_only=True)
class Judged:
    """One network: what its verdict says, what is true."""

    seed: int
    verdict: str
    truth: str
    worst_px: float
    quality: CalibrationQuality | None
    chances: tuple[float, float, float] = (0.0, 0.0, 1.0)
    """Probabilities of the true grades, by the covariance with the standard deviation that was drawn"""
    place: float = np.nan
    """Share of the largest errors, by that covariance, that are smaller than the true one"""

    def oracle(self, sure: float = SURE) -> int:
        """The best grade (0..2) by these probabilities: good where it is so with a probability of `sure`.

        Being one class off costs 1; a good that is none costs sure / (1 - sure).  The expected cost of good is
        (1 - P(good)) sure / (1 - sure), of another grade at least P(good): good is right from P(good) = sure on.
        """
        good, usable, weak = self.chances
        return 0 if good >= max(sure, usable, weak) else 1 + int(weak > usable)


def network(seed: int) -> tuple[TargetField, float]:
    """A plan of photographs and the standard deviation of an image coordinate, of three kinds in turn.

    As the guide advises (targets, rolls, convergence); with something missing; from hand-held snapshots of natural
    points.  How often verdict and truth agree depends on how many networks lie near a limit: the largest error of one
    network is a random number that scatters by a factor of two, whatever its covariance says (`Judged.oracle`,
    benchmarks/verdict_ceiling.py).
    """
    rng = np.random.default_rng(seed)
    kind = seed % 3
    if kind == 0:
        return _plan(rng, seed, (12, 20), (0.15, 0.6), (30, 45), 1.0), float(rng.uniform(0.005, 0.03))
    if kind == 1:
        return _plan(rng, seed, (6, 20), (0.0, 0.4), (10, 45), 0.5), float(np.exp(rng.uniform(*np.log([0.03, 0.3]))))
    return _plan(rng, seed, (4, 12), (0.0, 0.3), (5, 25), 0.3), float(np.exp(rng.uniform(*np.log([0.3, 1.0]))))


def evenly(seed: int) -> tuple[TargetField, float]:
    """A plan and a standard deviation of any quality."""
    rng = np.random.default_rng(seed)
    return _plan(rng, seed, (4, 20), (0.0, 0.6), (8, 45), 0.5), float(np.exp(rng.uniform(*np.log([0.005, 1.0]))))


def _plan(
    rng: np.random.Generator, seed: int, stations: tuple[int, int], depth: tuple[float, float],
    tilt: tuple[float, float], rolled: float,
) -> TargetField:  # fmt: skip
    rolls = (0.0, 90.0, 180.0, 270.0) if rng.random() < rolled else (0.0,)
    return TargetField(
        camera=brown_camera(values={"P1": rng.normal(0, 1e-5), "P2": rng.normal(0, 1e-5), "x0": rng.normal(0, 0.05)}),
        stations=int(rng.integers(*stations)), frontal=int(rng.integers(0, 5)), roll_deg=rolls,
        depth=rng.uniform(*depth), tilt_deg=rng.uniform(*tilt), rows=int(rng.integers(6, 12)),
        columns=int(rng.integers(8, 15)), distance=rng.uniform(1.9, 2.4), seed=seed,
    )  # fmt: skip


def judged(seed: int, draw: Callable[[int], tuple[TargetField, float]] = network) -> Judged:
    """The verdict on a network by the way that a user's photographs go, beside the truth."""
    plan, sigma = draw(seed)
    seen = simulate(field_scene(plan), Survey(seed=seed, image_sigma_px=sigma, points="approximate"))
    block = replace(seen.observed, cameras=tuple(replace(c, estimate="auto") for c in seen.observed.cameras))
    try:
        result = decide(block, AdjustmentOptions(reject="snooping", robust_start=True, jobs=1))
        (quality,) = calibration_qualities(result)
    except RaybundleError:
        return Judged(seed=seed, verdict="weak", truth="weak", worst_px=np.inf, quality=None)
    worst = calibration_difference(seen.truth.cameras[0], result.adjusted.cameras[0]).largest
    truth = "good" if worst <= GOOD_PX else "usable" if worst <= USABLE_PX else "weak"
    verdict = quality.grade if quality.grade in GRADES else "weak"
    drawn = _drawn(result)
    good, weak = float(np.mean(drawn <= GOOD_PX)), float(np.mean(drawn > USABLE_PX))
    return Judged(
        seed=seed, verdict=verdict, truth=truth, worst_px=worst, quality=quality,
        chances=(good, 1 - good - weak, weak), place=float(np.mean(drawn < worst)),
    )  # fmt: skip


def _drawn(result: Adjustment) -> np.ndarray:
    """Largest errors of projection [px] by the covariance with sigma0 = 1, which is the truth here."""
    (interior,) = result.interior
    shifts = projection_shifts(result.adjusted.cameras[0], interior.free)
    return shifts.worst_errors(result.precision.interior[interior.camera] / result.sigma0**2)


def confusion(rows: list[Judged]) -> np.ndarray:
    """(3, 3) counts: truth down, verdict across."""
    table = np.zeros((3, 3), int)
    for r in rows:
        table[GRADES.index(r.truth), GRADES.index(r.verdict)] += 1
    return table
