"""Halves of the photographs of a block, adjusted by themselves: their difference over the sum of both covariances.

options.block: folder (a block of the data), or project (photographs that are oriented first); options.splits.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from real_sigmas import block_of
from tests.truth.bands import whitener
from tests.truth.real_noise import (
    POINTS,
    Stated,
    adjusted,
    determined,
    free_network,
    part_of,
    splits,
    stated,
    without_datum,
)

from ledger.errors import Collected, Errors
from ledger.judges.projects import oriented
from ledger.sets import LedgerSet, NotHere, Places
from raybundle.errors import NotSolvable

LEAST = 3
"""Rays of a point that is compared"""


def judge(one: LedgerSet, places: Places) -> list[Errors]:
    """Differences of interior orientations and of common points; splits of one set are no independent draws."""
    folder, o = places.files(one), one.options
    if o["block"] == "project":
        folder = oriented(folder / o.get("photos", "."), places.of(one), list(o.get("orient", []))) / "result"
    block = _with_values(free_network(block_of(folder)))
    used = np.bincount(block.observations.image, minlength=len(block.images)) > 0
    of, collected, lost = np.flatnonzero(used), Collected(), 0
    rng = np.random.default_rng(11)
    for half in splits(len(of), o["splits"], np.random.default_rng(12)):
        mine = np.zeros(len(used), bool)
        mine[of[half]] = True
        try:
            results = [determined(block, h) for h in (mine, used & ~mine)]
        except NotSolvable:
            lost += 1
            continue
        common = sorted(set.intersection(*(_solid(r.given) for r in results)))
        names = [str(p) for p in rng.permutation(common)[:POINTS]]
        _compare(collected, *(stated(r, names if len(names) > LEAST else []) for r in results))
    if not collected.groups:
        raise NotHere(f"none of {o['splits']} splits could be adjusted ({lost} not solvable)")
    return [errors.of_one_draw() for errors in collected.errors()]


def _with_values(block):
    """The block with adjusted values as approximations of its halves."""
    used = np.bincount(block.observations.image, minlength=len(block.images)) > 0
    whole = adjusted(part_of(block, used))
    at = {name: k for k, name in enumerate(whole.given.points.ids)}
    rows = np.array([at.get(name, -1) for name in block.points.ids])
    xyz = np.where((rows >= 0)[:, None], whole.adjusted.points.xyz[rows], block.points.xyz)
    there = whole.adjusted.images
    images = replace(block.images, centre=there.centre, rotation=there.rotation)
    return replace(block, cameras=whole.adjusted.cameras, images=images, points=replace(block.points, xyz=xyz))


def _solid(block) -> set[str]:
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    return {block.points.ids[p] for p in np.flatnonzero(rays >= LEAST)}


def _compare(collected: Collected, a: Stated, b: Stated) -> None:
    shared = [i for i, n in enumerate(a.names) if n in b.names]
    there = [b.names.index(a.names[i]) for i in shared]
    if shared:
        d = a.interior[shared] - b.interior[there]
        C = a.fields[np.ix_(shared, shared)] + b.fields[np.ix_(there, there)]
        z = whitener(C) @ d
        names = [a.names[i][1] for i in shared]
        collected.add("interior orientation", d, np.sqrt(np.diagonal(C)), names, 0, joint=(float(z @ z), len(z)))
    if len(a.xyz) > LEAST:
        basis = without_datum((a.xyz + b.xyz) / 2)
        P = basis @ basis.T
        C = P @ (a.points_fields + b.points_fields) @ P
        d = P @ (a.xyz - b.xyz).ravel()
        z = basis.T @ d
        whole = basis.T @ C @ basis
        d2 = float(z @ np.linalg.solve(whole, z))
        axes = ["X", "Y", "Z"] * len(a.xyz)
        collected.add("object points", d, np.sqrt(np.diagonal(C)), axes, 0, unit="m", joint=(d2, len(z)))
