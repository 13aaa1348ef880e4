"""Are predicted standard deviations those of errors: 20 random networks, against adjustments of drawn errors.

python benchmarks/plan_monte_carlo.py [DRAWS]        500 draws of each and more: 6 CPU minutes

Objects of every kind and random size, cameras of random c, format and free parameters, 10 to 30 stations at random
places before random points, each point in three photographs or more, datum of inner constraints or control.  The ratio
of a network is the standard deviation that `planning.network.expected.Networks` predicts over the empirical one, root
mean square over all coordinates; its chance error comes from the spread of the draws.
"""

from __future__ import annotations

import json
import platform
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.errors import NotSolvable
from raybundle.objects.kinds import object_kinds
from raybundle.objects.surface import spread
from raybundle.planning.network.candidates import Stations
from raybundle.planning.network.expected import Expected, Networks
from raybundle.planning.network.planned_block import planned_block
from raybundle.planning.network.site import Access, Site
from raybundle.planning.synthetic_networks import brown_camera

RESULT = Path(__file__).with_name("results") / "plan_monte_carlo.json"
NETWORKS, POINTS = 20, 40
FREE = {
    "calibrated": (), "c, x0, y0": ("c", "x0", "y0"), "Brown's eight": ("c", "x0", "y0", "K1", "K2", "K3", "P1", "P2"),
}  # fmt: skip
TRIES = 2000
BAND = (0.95, 1.05)
ENOUGH, MOST = 0.015, 5000
"""Chance error up to which draws are added, a hundred at a time, and how many at most"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawn:
    """A network."""

    name: str
    site: Site
    stations: Stations
    control: np.ndarray | None
    expected: Expected


def drawn(seed: int) -> Drawn:
    """A random network that is determined, each point in three photographs or more."""
    rng = np.random.default_rng([20, seed])
    kinds = list(object_kinds.values())
    kind = kinds[seed % len(kinds)]
    numbers = tuple((np.array(kind.example) * np.exp(rng.uniform(-0.7, 0.7, len(kind.example)))).tolist())
    surface = kind.surface(numbers)
    points = spread(surface, POINTS, seed=seed)
    free = list(FREE)[seed // len(kinds) % len(FREE)]
    pixel = rng.uniform(0.003, 0.006)
    camera = brown_camera(
        values={"c": 6000 * pixel * rng.uniform(0.6, 1.2), "K1": 0.0, "K2": 0.0, "K3": 0.0, "P1": 0.0, "P2": 0.0},
        pixel_mm=pixel, estimate=FREE[free],
    )  # fmt: skip
    size = float(np.ptp(points.xyz, axis=0).max())
    sigma_px = float(np.exp(rng.uniform(np.log(0.05), np.log(0.5))))
    low, high = points.xyz.min(axis=0) - 3 * size, points.xyz.max(axis=0) + 3 * size
    site = Site(surface=surface, points=points, camera=camera, access=Access(low=low, high=high), sigma_px=sigma_px,
                incidence_deg=75.0)  # fmt: skip
    control = None
    if seed % 3 == 2:
        control = np.full((POINTS, 3), np.inf)
        control[rng.choice(POINTS, 6, replace=False)] = size * rng.uniform(1e-4, 5e-4)
    networks = Networks(site, control, least_rays=3)
    for _ in range(TRIES):
        stations = before(site, size, int(rng.integers(10, 31)), rng)
        e = networks.expected(networks.parts(stations.centre, stations.rotation))
        if isinstance(e, Expected) and determined(site, stations, control):
            name = f"{kind.name}, {free}, {'inner constraints' if control is None else 'control'}"
            return Drawn(name=name, site=site, stations=stations, control=control, expected=e)
    raise SystemExit(f"seed {seed}: no network of {TRIES} is determined")


def before(site: Site, size: float, count: int, rng: np.random.Generator) -> Stations:
    """Stations before random points within 55 degrees of their normals, the axes near the middle of the object."""
    p = site.points
    row = rng.integers(0, len(p), count)
    way = p.normal[row] + 0.8 * rng.uniform(-1, 1, (count, 3))
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    at = p.xyz.mean(axis=0) + rng.normal(0, 0.05 * size, (count, 3))
    centre = at + way * size * rng.uniform(1.0, 2.0, (count, 1))
    return Stations(centre=centre, at=at, roll=rng.integers(0, 4, count) * np.pi / 2)


def options(site: Site, control: np.ndarray | None) -> AdjustmentOptions:
    names = tuple(f"T{k + 1}" for k in range(len(site.points))) if control is None else ()
    datum = "inner" if control is None else "control"
    return AdjustmentOptions(datum=datum, datum_points=names, jobs=1, noise="white")


def determined(site: Site, stations: Stations, control: np.ndarray | None) -> bool:
    block = planned_block(site, stations, control_sigma=control, seed=None)
    try:
        return not adjust_block(block, options(site, control)).not_determinable
    except NotSolvable:
        return False


def compared(network: Drawn, draws: int) -> dict[str, object]:
    """Predicted against empirical."""
    site, e = network.site, network.expected
    square = np.zeros((0, len(site.points), 3))
    while len(square) < MOST and (len(square) < draws or chance(square) > ENOUGH):
        square = np.concatenate([square, errors(network, range(1000 + len(square), 1100 + len(square))) ** 2])
    variance = np.diagonal(e.points, axis1=1, axis2=2)
    each = square.mean(axis=(1, 2))
    ratio = float(np.sqrt(variance.mean() / each.mean()))
    axes = np.sqrt(variance.mean(axis=0) / square.mean(axis=(0, 1)))
    return {
        "network": network.name, "stations": len(network.stations), "rays": round(float(e.rays.mean()), 1),
        "predicted_mm": float(f"{1000 * np.sqrt(variance.mean()):.4g}"),
        "empirical_mm": float(f"{1000 * np.sqrt(each.mean()):.4g}"), "ratio": round(ratio, 4),
        "draws": len(square), "chance": round(chance(square), 4),
        "ratio_xyz": axes.round(3).tolist(),
    }  # fmt: skip


def errors(network: Drawn, seeds: range) -> np.ndarray:
    """(k, t, 3) true errors of the points in adjustments of drawn errors."""
    site, found = network.site, []
    for seed in seeds:
        block = planned_block(site, network.stations, control_sigma=network.control, seed=seed)
        result = adjust_block(block, options(site, network.control))
        found.append(result.adjusted.points.xyz - site.points.xyz)
    return np.array(found)


def chance(square: np.ndarray) -> float:
    """Standard deviation of the ratio of a network, from the mean squares of its draws: points are correlated."""
    each = square.mean(axis=(1, 2))
    return float(each.std(ddof=1) / each.mean() / 2 / np.sqrt(len(each)))


def main() -> int:
    """Draw, adjust, compare; 1 if a ratio is outside the band or its chance error is not below 0.02."""
    draws = int(sys.argv[1]) if len(sys.argv) > 1 else 500
    start, rows = time.process_time(), list[dict[str, object]]()
    for seed in range(NETWORKS):
        rows.append(compared(drawn(seed), draws))
        print(json.dumps(rows[-1]), flush=True)
    ratio = np.array([r["ratio"] for r in rows], float)
    chance = np.array([r["chance"] for r in rows], float)
    told = {
        "python": platform.python_version(), "machine": platform.machine(), "least_draws": draws,
        "cpu_minutes": round((time.process_time() - start) / 60, 2), "least": ratio.min(), "most": ratio.max(),
        "mean": round(float(ratio.mean()), 4), "largest_chance": chance.max(), "band": BAND,
        "off_in_chance": [round(float(v), 1) for v in (ratio - 1) / chance], "networks": rows,
    }  # fmt: skip
    RESULT.write_text(json.dumps(told, indent=1) + "\n", encoding="utf-8")
    good = BAND[0] < ratio.min() and ratio.max() < BAND[1] and chance.max() < 0.02
    print(
        f"{ratio.min():.3f} to {ratio.max():.3f}, chance error up to {chance.max():.3f}: {'good' if good else 'not so'}"
    )
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
