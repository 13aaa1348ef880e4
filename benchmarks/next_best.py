"""The next best photograph by updates of low rank against full adjustments: the same order and sigmas, how much faster.

    python benchmarks/run.py next_best

50 candidates of three blocks, each adjusted anew with its image points and all statistics: a flight of 500 photographs
over control, a field of targets under inner constraints, the same with scale bars.  Figures: largest and mean standard
deviation of the points, uncertainty of projection.  A leaner way by force is timed beside: nothing adjusted, no tests,
only the normal equations of each, their factor and its selected inverse.  Then 1000 candidates of the flight.
"""

from __future__ import annotations

import json
import time
from dataclasses import replace

import numpy as np

from raybundle.adjustment.decision.decide import decide
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.evaluation.additions import Photographs, with_photographs
from raybundle.adjustment.evaluation.joint_cofactors import Factored
from raybundle.adjustment.readjust import block_again
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.system.dense import one_thread
from raybundle.block import Block
from raybundle.block.points import automatic_name
from raybundle.calibration.maps import projection_shifts
from raybundle.planning.flights.uav_networks import Flight, flight_block
from raybundle.planning.next.best import ranking
from raybundle.planning.next.goals import Goal, measure_of
from raybundle.planning.next.outlook import Outlook
from raybundle.planning.next.stations import Reach, reachable
from raybundle.planning.next.visibility import PointSight
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene

CANDIDATES, MANY = 50, 1000
KINDS = ("worst", "mean", "calibration")


def blocks() -> dict[str, Block]:
    """The blocks, tie points of the flight named as a program names them."""
    flight = flight_block(Flight(lines=20, photographs=25, base=20, spacing=40, size=700, points=110, control=5))
    names = (
        automatic_name(k) if role == 0 else name
        for k, (name, role) in enumerate(zip(flight.points.ids, flight.points.role, strict=True))
    )
    flight = replace(flight, points=replace(flight.points, ids=tuple(names)))
    plan = TargetField(rows=18, columns=26, stations=60, frontal=20, roll_deg=(0.0, 90.0))
    survey = Survey(points="exact", orientation="exact", interior="exact")
    return {
        "flight, control": flight,
        "targets, inner constraints": simulate(field_scene(plan), survey).observed,
        "targets, scale bars": simulate(field_scene(plan), replace(survey, scale_bars=3)).observed,
    }


def candidates(outlook: Outlook, most: int) -> Photographs:
    """Reachable stations with the points that photographs there would show; those that show enough."""
    least = np.sqrt(outlook.joint.variances()).max(axis=1)
    sight = PointSight.of(outlook.block, outlook.used, outlook.joint.points, 0)
    up = np.array([0.0, 0.0, 1.0])
    found = reachable(outlook.block, outlook.used, 0, least, up, Reach(most=3 * most), outlook.joint.points)
    shown = sight.shown(outlook.block, 0, found.centre, found.rotation, least)
    enough = np.flatnonzero(np.bincount(shown.image, minlength=len(shown)) > 0)
    return shown.chosen(enough[np.linspace(0, len(enough) - 1, min(most, len(enough))).round().astype(int)])


def figures(outlook: Outlook, result: Adjustment) -> list[float]:
    """Largest and mean standard deviation of the regarded points, and uncertainty of projection; sigma0 of the first.

    An adjustment with image points that fit exactly has a smaller sigma0: no photograph is known to fit better.
    """
    scale = np.sqrt(outlook.variance) / result.sigma0
    std = scale * result.precision.object_point_std[outlook.joint.points]
    largest = np.sort(std.max(axis=1))
    share = 0.99 if "flight" in outlook.block.name and len(std) > 200 else 1.0
    interior = next(i for i in result.interior if i.image is None)
    shifts = projection_shifts(outlook.block.cameras[0], interior.free, columns=18, rows=12)
    C = scale**2 * result.precision.interior[interior.camera]
    worst = largest[int(share * (len(largest) - 1))]
    return [float(worst), float(std[std > 0].mean()), shifts.uncertainty(C).largest]


def with_one(outlook: Outlook, more: Photographs) -> tuple:
    """The block and its rejections with a photograph."""
    return with_photographs(block_again(outlook.result), outlook.rejected, more)


def anew(outlook: Outlook, more: Photographs) -> list[float]:
    """The figures of a full adjustment with a photograph."""
    block, rejected = with_one(outlook, more)
    full = adjust_block(block, outlook.result.options, free=outlook.free, rejected=rejected, start="adjusted")
    return figures(outlook, full)


def lean(outlook: Outlook, more: Photographs) -> float:
    """The largest variance by a factor with the photograph and its selected inverse, nothing being adjusted."""
    block, rejected = with_photographs(outlook.block, outlook.rejected, more)
    found = Factored.at(block, outlook.result.options, outlook.free, rejected, like=outlook.factored).found
    return float(np.diagonal(found.points[outlook.joint.points], axis1=1, axis2=2).max())


def timed(work) -> tuple:
    """What it gives, its seconds and its seconds of processors."""
    wall, cpu = time.perf_counter(), time.process_time()
    found = work()
    return found, time.perf_counter() - wall, time.process_time() - cpu


def compared(block: Block) -> dict:
    """Low rank against full adjustments."""
    result = decide(block, AdjustmentOptions(noise="white", tolerance=1e-9))
    (outlook, shown), prepared, prepared_cpu = timed(lambda: prepare(result))
    every = np.ones(len(shown), bool)
    goals = [Goal(kind=kind, camera=block.cameras[0].id) for kind in KINDS]
    quick = [timed(lambda goal=goal: [s.value for s in ranking(outlook, shown, goal, every)]) for goal in goals]
    each = [shown.chosen(np.array([i])) for i in range(len(shown))]
    with one_thread():
        full, slow, slow_cpu = timed(lambda: np.array([anew(outlook, more) for more in each]).T)
        _, brief, brief_cpu = timed(lambda: [lean(outlook, more) for more in each])
    found: dict = {
        "photographs": len(block.images), "points": len(block.points), "image points": len(block.observations),
        "candidates": len(shown), "points regarded": len(outlook.joint.points),
        "points seen": [int(v) for v in np.quantile(np.bincount(shown.image), [0, 0.5, 1])],
        "s": {"preparation": round(prepared, 3), "full adjustments": round(slow, 2), "factors alone": round(brief, 2)},
        "cpu s": {
            "preparation": round(prepared_cpu, 3), "full adjustments": round(slow_cpu, 2),
            "factors alone": round(brief_cpu, 2),
        },
    }  # fmt: skip
    for k, kind in enumerate(KINDS):
        values, wall, cpu = quick[k]
        low = np.array(values)
        found[kind] = {
            "now": measure(outlook, goals[k]), "best": float(low.min()),
            "largest relative difference": float(np.abs(low / full[k] - 1).max()),
            "same order": bool(np.array_equal(np.argsort(low, kind="stable"), np.argsort(full[k], kind="stable"))),
            "s": round(wall, 3), "cpu s": round(cpu, 3),
            "times faster": {
                "than full adjustments": round(slow / wall, 1),
                "than full adjustments, preparation counted": round(slow / (wall + prepared), 1),
                "than factors alone": round(brief / wall, 1),
            },
        }  # fmt: skip
    return found


def prepare(result: Adjustment) -> tuple[Outlook, Photographs]:
    """The joint covariance, the stations and what they see."""
    outlook = Outlook.of(result)
    return outlook, candidates(outlook, CANDIDATES)


def measure(outlook: Outlook, goal: Goal) -> float:
    """What a goal amounts to now."""
    return measure_of(outlook, goal).standing(None).value


def many(block: Block) -> dict:
    """Seconds of 1000 candidates, and of the adjustment before."""
    result, adjusted, _ = timed(lambda: decide(block, AdjustmentOptions(noise="white")))
    outlook, prepared, _ = timed(lambda: Outlook.of(result))
    shown, seen, _ = timed(lambda: candidates(outlook, MANY))
    every = np.ones(len(shown), bool)
    standing, ranked, _ = timed(lambda: ranking(outlook, shown, Goal(), every))
    _, added, _ = timed(lambda: outlook.added(shown.chosen(np.array([0]))))
    return {
        "candidates": sum(s is not None for s in standing), "s": round(prepared + seen + ranked, 2),
        "s joint covariance": round(prepared, 2), "s stations and sight": round(seen, 2), "s ranking": round(ranked, 2),
        "s adjustment before": round(adjusted, 2), "s to go on with one more": round(added + ranked, 2),
    }  # fmt: skip


def main() -> None:
    """Print the figures as JSON."""
    every = blocks()
    rows: dict = {name: compared(block) for name, block in every.items()}
    rows["1000 candidates, 500 photographs"] = many(every["flight, control"])
    print(json.dumps(rows, indent=1))


if __name__ == "__main__":
    main()
