"""Single positions that contradict the photographs and all other positions, as one from before the receiver's fix.

An adjustment with a position that is off by a thousand standard deviations bends the block: neighbours are accused and
right image points rejected.  The similarity onto the other positions shows it before.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Block
from raybundle.errors import InputError
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.statistics import fisher_tail
from raybundle.numerics.transform import similarity
from raybundle.placing.positions import Positions

FEWEST = 6
"""Positions: without one of them, five are left, with eight coordinates beyond those of a similarity."""
LEVEL = 1e-5
"""Probability with which a right position is taken for a wrong one."""
GROSS, FAR = 10.0, 0.05
"""Distance of a wrong position from where the others put it: in its standard deviations, and as a share of the extent
of the others, which no free block bends by.  What is nearer is left to the tests of the adjustment."""
TRIED = 20
"""Positions that are left out in turn, those with the largest residuals"""
MOST = 0.25
"""Share of the positions that may be wrong."""


def without_wrong_positions(block: Block, positions: Positions) -> tuple[Positions, list[Notice]]:
    """The positions without single wrong ones, each with a fault; all of them where the others do not fit either.

    With W the square sum of the residuals of the similarity without a position, of r = 3 (n - 1) - 7 degrees of
    freedom, and W + D with it, (D / 3) / (W / r) is distributed as F(3, r) if it is right.  One after the other, the
    one with the largest D first.
    """
    rows: Index = np.flatnonzero(np.isfinite(positions.xyz).all(axis=1))
    source, target, sigma = block.images.centre[positions.image[rows]], positions.xyz[rows], positions.sigma[rows]
    keep = np.arange(len(rows))
    found: list[tuple[int, float]] = []
    while len(keep) >= FEWEST and len(found) <= MOST * len(rows):
        worst = _worst(source[keep], target[keep], sigma[keep])
        if worst is None:
            break
        found.append((int(keep[worst[0]]), worst[1]))
        keep = np.delete(keep, worst[0])
    if not found or len(found) > MOST * len(rows):
        return positions, []
    flight = positions.flight[rows]
    wrong = np.bincount(flight[[k for k, _ in found]], minlength=positions.flights)
    if (2 * wrong > np.bincount(flight, minlength=positions.flights)).any():  # a flight with a shift of its own
        return positions, []
    left = np.setdiff1d(np.arange(len(positions)), rows[[k for k, _ in found]])
    notices: list[Notice] = []
    for k, distance in found:
        name = block.images.ids[positions.image[rows[k]]]
        values = {"image": name, "distance": distance}
        notices.append(Notice(code="position_left_out", ids=(name,), values=values))
    kept = replace(
        positions, image=positions.image[left], xyz=positions.xyz[left], sigma=positions.sigma[left],
        flight=positions.flight[left], assumed=positions.assumed[left],
    )  # fmt: skip
    return kept, notices


def _worst(source: Array, target: Array, sigma: Array) -> tuple[int, float] | None:
    """The row that contradicts the others beyond doubt, and its distance from where they put it [m]."""
    n = len(source)
    redundancy = 3 * (n - 1) - 7
    try:
        each = np.sum(similarity(source, target).residuals ** 2, axis=1)
        tried = np.argsort(-each, kind="stable")[:TRIED].tolist()
        rests = [similarity(np.delete(source, k, 0), np.delete(target, k, 0)) for k in tried]
    except InputError:  # in a line
        return None
    squares = [max(float(np.sum(r.residuals**2)), 1e-300) for r in rests]
    best = int(np.argmin(squares))
    k, onto = tried[best], rests[best]
    F = (float(each.sum()) - squares[best]) / 3 / (squares[best] / redundancy)
    others = np.delete(target, k, 0)
    extent = float(np.sqrt(np.mean(np.sum((others - others.mean(axis=0)) ** 2, axis=1))))
    gap = onto.points(source[k : k + 1])[0] - target[k]
    distance = float(np.linalg.norm(gap))
    gross = distance > FAR * extent and bool((np.abs(gap) > GROSS * sigma[k]).any())
    return (k, distance) if gross and fisher_tail(F, 3, redundancy) < LEVEL / n else None
