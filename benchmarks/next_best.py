"""The next best photograph by updates of low rank against full adjustments: the same order and sigmas, and how much faster.

    python benchmarks/next_best.py

50 candidates of three blocks, each adjusted anew with its image points and all statistics: a flight of 500 photographs
over control, a field of targets under inner constraints, a free camera's field with a scale bar.  Figures: largest and
mean standard deviation of the points, uncertainty of projection.  Then 1000 candidates of the flight.  What an adjustment
itself repeats is measured by adjusting every fifth with its photographs in another order.
"""

from __future__ import annotations

import json
import time
from dataclasses import replace

import numpy as np

from raybundle.adjustment.additions import Photographs, with_photographs
from raybundle.adjustment.decide import decide
from raybundle.adjustment.dense import one_thread
from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block
from raybundle.block.points import automatic_name
from raybundle.calibration.maps import projection_shifts
from raybundle.planning.goals import Goal
from raybundle.planning.next_best import ranking
from raybundle.planning.outlook import Outlook
from raybundle.planning.scenes import TargetField, field_scene
from raybundle.planning.sight import Sight
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.stations import Reach, reachable
from raybundle.planning.uav_networks import Flight, flight_block

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
    sight = Sight.of(outlook.block, outlook.used, outlook.joint.points)
    up, cov = np.array([0.0, 0.0, 1.0]), np.median(outlook.block.observations.cov_px2, axis=0)
    found = reachable(outlook.block, outlook.used, 0, least, up, Reach(most=3 * most), outlook.joint.points)
    shown = sight.shown(outlook.block, 0, found.centre, found.rotation, cov, least)
    enough = np.flatnonzero(np.bincount(shown.image, minlength=len(shown)) > 0)
    return shown.chosen(enough[np.linspace(0, len(enough) - 1, min(most, len(enough))).round().astype(int)])


def figures(outlook: Outlook, result: Adjustment) -> list[float]:
    """Largest and mean standard deviation of the regarded points, and uncertainty of projection; sigma0 of the first.

    An adjustment with image points that fit exactly has a smaller sigma0: no photograph is known to fit better.
    """
    scale = np.sqrt(outlook.variance) / result.sigma0
    std = scale * result.precision.object_point_std[outlook.joint.points]
    control = outlook.block.points.is_control[outlook.joint.points].any(axis=1)
    largest = np.sort(std.max(axis=1))
    share = 0.99 if "flight" in outlook.block.name and len(std) > 200 else 1.0
    del control
    interior = next(i for i in result.interior if i.image is None)
    shifts = projection_shifts(outlook.block.cameras[0], interior.free, columns=18, rows=12)
    C = scale**2 * result.precision.interior[interior.camera]
    worst = largest[int(share * (len(largest) - 1))]
    return [float(worst), float(std[std > 0].mean()), shifts.uncertainty(C).largest]


def anew(outlook: Outlook, more: Photographs, order: np.ndarray | None = None) -> list[float]:
    """The figures of a full adjustment with a photograph."""
    block, rejected = with_photographs(outlook.block, outlook.rejected, more)
    if order is not None:
        back = np.argsort(order)
        o = block.observations
        block = replace(
            block, images=block.images.rows(order), observations=replace(o, image=back[o.image].astype("i4"))
        )
    options = replace(outlook.result.options, noise="white")
    return figures(outlook, adjust_block(block, options, free=outlook.free, rejected=rejected, start="adjusted"))


def compared(block: Block) -> dict:
    """Low rank against full adjustments."""
    result = decide(block, AdjustmentOptions(noise="white", tolerance=1e-9))
    wall, cpu = time.perf_counter(), time.process_time()
    outlook = Outlook.of(result)
    shown = candidates(outlook, CANDIDATES)
    every = np.ones(len(shown), bool)
    goals = [Goal(kind=kind, camera=block.cameras[0].id) for kind in KINDS]
    quick_cpu: dict[str, float] = {"preparation": time.process_time() - cpu}
    low = []
    for goal in goals:
        cpu = time.process_time()
        low.append([s.value for s in ranking(outlook, shown, goal, every)])
        quick_cpu[goal.kind] = time.process_time() - cpu
    wall = time.perf_counter() - wall
    began, cpu = time.perf_counter(), time.process_time()
    with one_thread():
        full = np.array([anew(outlook, shown.chosen(np.array([i]))) for i in range(len(shown))]).T
    slow, slow_cpu = time.perf_counter() - began, time.process_time() - cpu
    order = np.random.default_rng(1).permutation(len(block.images) + 1)
    again = np.array([anew(outlook, shown.chosen(np.array([i])), order) for i in range(0, len(shown), 5)]).T
    low = np.array(low)
    found: dict = {
        "photographs": len(block.images), "points": len(block.points), "image points": len(block.observations),
        "candidates": len(shown), "points regarded": len(outlook.joint.points),
        "points seen": [int(v) for v in np.quantile(np.bincount(shown.image), [0, 0.5, 1])],
        "low rank": {"s": round(wall, 3), **{f"cpu_s {k}": round(v, 3) for k, v in quick_cpu.items()}},
        "full": {"s": round(slow, 2), "cpu_s": round(slow_cpu, 2)},
    }  # fmt: skip
    for k, kind in enumerate(KINDS):
        found[kind] = {
            "now": measure(outlook, goals[k]), "best": float(low[k].min()),
            "largest relative difference": float(np.abs(low[k] / full[k] - 1).max()),
            "full adjustments repeat themselves to": float(np.abs(again[k] / full[k, ::5] - 1).max()),
            "same order": bool(np.array_equal(np.argsort(low[k], kind="stable"), np.argsort(full[k], kind="stable"))),
            "cpu ratio": round(slow_cpu / (quick_cpu["preparation"] + quick_cpu[kind]), 1),
        }  # fmt: skip
    return found


def measure(outlook: Outlook, goal: Goal) -> float:
    """What a goal amounts to now."""
    from raybundle.planning.goals import measure_of

    return measure_of(outlook, goal).standing(None).value


def many(block: Block) -> dict:
    """Seconds of 1000 candidates, everything but the adjustment itself."""
    result = decide(block, AdjustmentOptions(noise="white"))
    began = time.perf_counter()
    outlook = Outlook.of(result)
    prepared = time.perf_counter() - began
    shown = candidates(outlook, MANY)
    seen = time.perf_counter() - began - prepared
    standing = ranking(outlook, shown, Goal(), np.ones(len(shown), bool))
    return {
        "candidates": sum(s is not None for s in standing), "s": round(time.perf_counter() - began, 2),
        "s joint covariance": round(prepared, 2), "s stations and sight": round(seen, 2),
    }  # fmt: skip


def main() -> None:
    """Print the figures as JSON."""
    every = blocks()
    rows: dict = {name: compared(block) for name, block in every.items()}
    rows["1000 candidates, 500 photographs"] = many(every["flight, control"])
    print(json.dumps(rows, indent=1))


if __name__ == "__main__":
    main()
