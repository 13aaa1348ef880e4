"""Errors of what `adjust` returns against the covariances it states, after all its decisions.

A run goes as a user goes: the block without approximate values, parameters chosen, blunders rejected; what the
notices say of whole groups and of scale bars is done, and the block adjusted once more.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from scipy.stats import gamma

from raybundle import adjust
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.result import Adjustment
from raybundle.adjustment.statistics.precision import image_unknowns, interior_unknowns
from raybundle.block import Block
from raybundle.numerics.rotation import vector_from_rotation
from raybundle.observations import in_order
from tests.truth.bands import assert_own_blocks, joint_cofactor, whitener
from tests.truth.door_blocks import Case

OPTIONS = AdjustmentOptions(estimate="auto", reject="snooping", noise="auto", jobs=1)
PLAIN = AdjustmentOptions(jobs=1)
"""Nothing is decided."""
ROUNDS = 3


def through_the_door(block: Block, *, clean: bool = False) -> list[Adjustment]:
    """The results of a block: the first, and each after what its notices told was done; the last is the user's."""
    results = [adjust(block, PLAIN if clean else OPTIONS)]
    if clean:
        return results
    for _ in range(ROUNDS):
        told = sorted_notices(block, results[-1])
        if told is None:
            break
        block = told
        results.append(adjust(block, OPTIONS))
    return results


def sorted_notices(block: Block, result: Adjustment) -> Block | None:
    """The block with what the result says of it: scale bars that are wrong left out, else groups weighted anew."""
    bars = {name for n in result.notices if n.code == "distance_suspect" for name in n.ids}
    d, ids = block.distances, block.points.ids
    good = np.array([f"{ids[a]}-{ids[b]}" not in bars for a, b in zip(d.start, d.end, strict=True)], bool)
    if not good.all():
        return block.having(
            replace(d, start=d.start[good], end=d.end[good], length=d.length[good], sigma=d.sigma[good])
        )
    names = {kind.group: kind for kind in in_order()}
    wrong = [c for c in result.variance_components if c.kind in names and c.significant]
    images = next((c.ratio for c in result.variance_components if c.kind == "image observations"), 1.0)
    for c in wrong:
        block = names[c.kind].weighted(block, c.ratio / images)
    return block if wrong else None


@dataclass
class Unknowns:
    """Unknowns of one kind: where they stand among all, and their errors."""

    at: list[tuple[str, int, int]]
    error: np.ndarray
    names: list[str]
    defect: int = 0
    """Dimensions that the datum takes from their covariance"""


def unknowns_of(result: Adjustment, truth: Block) -> dict[str, Unknowns]:
    """Points, images and interior orientations of a result, their errors after the similarity that stays open."""
    work = result.handle.work
    system, datum = work.system, work.datum
    X, C, R = in_frame(result, truth)
    a = result.adjusted
    points, images = np.flatnonzero(system.points_used), np.flatnonzero(system.images_used & system.exterior_free)
    nodes = system.point_node
    at = [
        ("node", int(system.offsets[nodes[p]] + e), e) if nodes[p] >= 0 else ("point", int(p), e)
        for p in points for e in range(3)
    ]  # fmt: skip
    found = {
        "points": Unknowns(at, (a.points.xyz[points] - X[points]).ravel(), ["X", "Y", "Z"] * len(points), datum.defect)
    }
    turns = [vector_from_rotation(a.images.rotation[i] @ R[i].T) for i in images]
    moves = np.concatenate([a.images.centre[images] - C[images], np.array(turns).reshape(-1, 3)], axis=1)
    at = [("node", int(u), 0) for i in images for u in image_unknowns(system, int(i))]
    found["stations"] = Unknowns(at, moves.ravel(), ["X", "Y", "Z", "rx", "ry", "rz"] * len(images))
    at, error, names = [], [], []
    for row in system.interior:
        if row.node < 0:
            continue
        adjusted, true = a.cameras[row.camera].values, truth.cameras[row.camera].values
        symbols = [row.model.symbols[k] for k in row.free]
        at += [("node", int(u), 0) for u in interior_unknowns(system, row)]
        error += [adjusted[s] - true.get(s, 0.0) for s in symbols]
        names += symbols
    found["interior"] = Unknowns(at, np.array(error), names)
    return found


def in_frame(result: Adjustment, truth: Block):
    """True points, centres and rotations in the frame of the result, moved within its open datum."""
    X, C, R = truth.points.xyz, truth.images.centre, truth.images.rotation
    work = result.handle.work
    if work.datum.defect == 0:
        return X, C, R
    if work.datum.defect not in (6, 7):
        raise ValueError(f"a datum open in {work.datum.open_names}")
    on = np.flatnonzero(work.datum.carriers & work.system.points_used)
    to = result.adjusted.points.xyz
    a, b = X[on] - X[on].mean(axis=0), to[on] - to[on].mean(axis=0)
    U, s, Vt = np.linalg.svd(b.T @ a)
    D = np.diag([1.0, 1.0, np.sign(np.linalg.det(U @ Vt))])
    T = U @ D @ Vt
    k = float((s * np.diag(D)).sum() / (a**2).sum()) if work.datum.defect == 7 else 1.0
    middle, place = X[on].mean(axis=0), to[on].mean(axis=0)
    return (X - middle) @ T.T * k + place, (C - middle) @ T.T * k + place, R @ T.T


def score(case: Case, seed: int, *, clean: bool = False) -> dict:
    """One run: squared errors after all, those of the first result, and the gross errors that were not found.

    clean  blocks in which there is nothing to decide, and nothing is
    """
    case = case.clean if clean else case
    block, gross = case.given(seed)
    results = through_the_door(block, clean=clean)
    last = results[-1]
    used, kinds = last.image_observations.used, squares(last, case.truth)
    return {
        "redundancy": last.redundancy, "sigma0": last.sigma0, "rounds": len(results), "kinds": kinds,
        "gross": int((gross > 0).sum()), "left": [round(float(x), 1) for x in gross[used & (gross > 0)]],
        "good_lost": int((~used & (gross == 0)).sum()),
        "first": {
            "redundancy": results[0].redundancy,
            "kinds": kinds if len(results) == 1 else squares(results[0], case.truth),
        },
    }  # fmt: skip


def squares(result: Adjustment, truth: Block) -> dict[str, dict]:
    """Of each kind of unknown the quadratic form, its degrees of freedom, and mean e^2 / s^2 by parameter."""
    kinds: dict[str, dict] = {}
    variance = result.sigma0**2 if result.redundancy > 0 else 1.0
    for kind, u in unknowns_of(result, truth).items():
        if not u.at:
            continue
        Q = variance * joint_cofactor(result.handle.work, u.at)
        if kind == "points":
            assert_own_blocks(Q, result.precision.object_points[result.handle.work.system.points_used])
        s, z = np.sqrt(np.diagonal(Q)), whitener(Q, u.defect) @ u.error
        by: dict[str, list[float]] = {}
        for name, ratio in zip(u.names, u.error / s, strict=True):
            by.setdefault(name, []).append(float(ratio**2))
        kinds[kind] = {
            "d2": float(z @ z), "degrees": len(z), "by": {name: float(np.mean(r)) for name, r in by.items()},
        }  # fmt: skip
    return kinds


def verdict(runs: Iterable[Mapping], kind: str, wrong: float = 1.0) -> dict:
    """Sum of the quadratic forms of all runs over its expectation, and the band of 99.9 %.

    With an estimated sigma0 a form over its degrees d is Fisher's F(d, r), r the redundancy: expectation r / (r - 2).
    The sum of many is taken as a gamma variable of the same mean and variance.
    wrong  stated standard deviations are multiplied by it: the test is to notice
    """
    rows = [(r["kinds"][kind]["d2"], r["kinds"][kind]["degrees"], r["redundancy"]) for r in runs if kind in r["kinds"]]
    d2, d, r = np.array(rows, float).T
    d2 = d2 / wrong**2
    mean = d * r / (r - 2)
    variance = 2 * d * r**2 * (d + r - 2) / ((r - 2) ** 2 * (r - 4))
    k = mean.sum() ** 2 / variance.sum()
    low, high = np.array(gamma(k).interval(0.999)) / k
    ratio = d2.sum() / mean.sum()
    z = (d2 - mean) / np.sqrt(variance)
    return {
        "runs": len(d2), "degrees": int(d.sum()), "ratio": float(ratio), "low": float(low), "high": float(high),
        "inside": bool(low < ratio < high), "sigma_off_percent": float(100 * (np.sqrt(ratio) - 1)),
        "spread_of_runs": float(np.std(z)), "largest_run": float(z.max()),
    }  # fmt: skip
