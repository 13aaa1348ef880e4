"""Means, volumes and regions that moved, of height models with drawn errors: options.quantity, options.runs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from tests.surface.height_models import made, middles

from ledger.errors import Collected, Errors
from ledger.sets import LedgerSet, Places
from raybundle.surfaces.heights.displacement import movements
from raybundle.surfaces.heights.outlines import coverage
from raybundle.surfaces.heights.resampling import difference
from raybundle.surfaces.heights.volumes import volume

SHAPE = (64, 96)
SIGMA = 1e-3
HALF = 0.5
"""Share of a region's cells that moved, from which on it is the one that did"""


def judge(one: LedgerSet, _places: Places) -> list[Errors]:
    """Errors of one quantity in every run."""
    collected, rng = Collected(), np.random.default_rng(one.source["seed"])
    quantity = {"means": _means, "volumes": _volumes, "movements": _movements}[one.options["quantity"]]
    for run in range(one.options["runs"]):
        for label, error, sigma, unit in quantity(rng, one.options):
            moved = label if one.options["quantity"] == "movements" else ""
            module = "volumes" if unit == "m3" else one.judged[0]
            collected.add(module, error, sigma, [label], run, unit=unit, label=moved)
    return collected.errors()


def _relief():
    x, y = middles(SHAPE)
    far = np.hypot(x - 0.48, y - 0.32)
    return 0.05 + 0.1 * np.maximum(1 - far / 0.2, 0.0)


def _rings(rng: np.random.Generator, options):
    """A quadrangle somewhere on the model; options.side: half of its sides [cells]."""
    middle = rng.uniform([30, 24], [66, 40])
    side = rng.uniform(*options.get("side", (10, 22)), (4, 2))
    corners = middle + side * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    return [corners]


def _means(rng, options):
    """Mean height within an outline."""
    relief = _relief()
    covered = coverage(_rings(rng, options), SHAPE)
    true = volume(made(relief), covered, 0.0)
    found = volume(
        made(relief, rng=rng, sigma=options.get("sigma", SIGMA), common=options["common"], fine=8), covered, 0.0
    )
    area = true.plan_area
    yield "mean height", (found.net.value - true.net.value) / area, found.net.sigma / area, "m"


def _volumes(rng, options):
    """Volume above a level, and above the plane by the outline."""
    relief, rings = _relief(), _rings(rng, options)
    covered = coverage(rings, SHAPE)
    drawn = made(relief, rng=rng, sigma=options.get("sigma", SIGMA), common=options["common"], fine=8)
    for label, base in (("above a level", 0.02), ("above the rim", rings)):
        true, found = (volume(m, covered, base) for m in (made(relief), drawn))
        yield label, found.net.value - true.net.value, found.net.sigma, "m3"


def _movements(rng, options):
    """Movement of the inner part of a region that `movements` outlines, and the whole volume that moved."""
    x, y = middles(SHAPE)
    relief = 0.01 * np.sin(20 * x) * np.cos(15 * y)
    before, after = (made(relief, rng=rng, sigma=4e-4, common=options["common"]) for _ in range(2))
    moved = np.zeros(SHAPE)
    r, c = rng.integers(8, 24), rng.integers(8, 50)
    moved[r : r + 26, c : c + 30] = options["movement"]
    d = difference(before, after)
    d = replace(d, heights=replace(d.heights, height=(d.heights.height + moved).astype(np.float32)))
    for region in movements(d).regions:
        if np.mean(moved[region.cells] != 0) > HALF:
            yield "amount", region.amount - options["movement"], region.amount_sigma, "m"
            true = float(moved.sum()) * d.cell**2
            yield "moved volume", region.volume - true, region.volume_sigma, "m3"
