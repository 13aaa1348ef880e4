"""Scale bars against each other, in a network that none of them had a part in: which one is wrong, if that shows.

A bar of few micrometres that is wrong bends the network before its residual shows it; held against distances of the
free network it cannot.  The logarithms of given over measured lengths have one unknown in common, that of the scale;
each bar is compared with what the others make of it (leave-one-out by least squares with their joint covariance).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from raybundle.metrology.point_set import PointSet
from raybundle.numerics.arrays import Array
from raybundle.numerics.statistics import fisher_tail

LEVEL = 0.001
"""Probability that right bars are called contradicting: that of a single test of data snooping (Baarda 1968)"""

SETTLED = 1.01
"""F of bars down to which standard deviations are enlarged: what is left changes nothing"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Bar:
    """A scale bar as its certificate states it."""

    start: str
    end: str
    length: float
    """[m]"""
    sigma: float
    """[m]"""

    @property
    def name(self) -> str:
        """As "101 - 102"."""
        return f"{self.start} - {self.end}"


@dataclass(frozen=True, slots=True, kw_only=True)
class BarTest:
    """Scale bars against each other; arrays over the bars."""

    bars: tuple[Bar, ...]
    shown: Array
    """(k,) lengths by all other bars [m]"""
    shown_sigma: Array
    """(k,) of given minus shown, the errors of all bars and of the photographs contained [m]"""
    whole: tuple[float, float]
    """F of all together and its probability"""
    wrong: int | None
    """The bar without which the others agree, where there are three or more; None: there is none, or nobody can show"""
    sigma: Array
    """(k,) standard deviations with which they bend no network [m]: as stated where they agree; the one that is wrong
    gets what it differs by; where nobody knows which it is, all are enlarged alike until their scatter is what they
    state (Birge 1932)"""
    exchanged: tuple[int, int] | None
    """Two bars that agree with all others if each has the length of the other"""

    @property
    def contradict(self) -> bool:
        """Whether they differ by more than chance."""
        return self.whole[1] < LEVEL

    @property
    def apart(self) -> Array:
        """(k,) given minus shown [m]."""
        return np.array([b.length for b in self.bars]) - self.shown

    @property
    def order(self) -> list[int]:
        """The bars, those that differ most from the others first."""
        return np.argsort(-np.abs(self.apart) / self.shown_sigma, kind="stable").tolist()


def bars_compared(points: PointSet, bars: Sequence[Bar]) -> BarTest | None:
    """Hold scale bars against each other by the points of a network of which the scale is free.

    points  with the ends of the bars
    returns None for fewer than two bars between points that are there
    Limits: which of two bars is wrong, and an error that all of them share.
    """
    place = {name: k for k, name in enumerate(points.ids)}
    bars = tuple(b for b in bars if b.start in place and b.end in place)
    if len(bars) < 2:
        return None
    a, b = (np.array([place[getattr(bar, end)] for bar in bars]) for end in ("start", "end"))
    way = points.xyz[b] - points.xyz[a]
    measured = np.linalg.norm(way, axis=1)
    J = np.zeros((len(bars), 3 * len(points.ids)))
    for j, d in enumerate(way / measured[:, None] ** 2):
        J[j, 3 * b[j] : 3 * b[j] + 3] += d
        J[j, 3 * a[j] : 3 * a[j] + 3] -= d
    of_network = J @ points.covariance @ J.T
    given = np.array([bar.length for bar in bars])
    own = np.array([bar.sigma for bar in bars])
    whole = _agreement(measured, given, own, of_network, points.freedom)
    shown, sigma = _left_out(np.log(given / measured), of_network + np.diag((own / given) ** 2))
    apart = given - given * np.exp(-shown)
    test = BarTest(
        bars=bars, shown=given - apart, shown_sigma=given * sigma, whole=whole, wrong=None, sigma=own, exchanged=None
    )
    if not test.contradict:
        return test

    def agreement(rows: Sequence[int], lengths: Array, deviations: Array) -> tuple[float, float]:
        at = list(rows)
        return _agreement(
            measured[at], lengths[at], deviations[at], of_network[np.ix_(at, at)], points.freedom
        )  # fmt: skip

    every = range(len(bars))
    alone = [
        k for k in every if len(bars) > 2 and agreement([j for j in every if j != k], given, own)[1] >= LEVEL
    ]  # fmt: skip
    pairs = [p for p in combinations(every, 2) if agreement(every, _exchanged(given, p), own)[1] >= LEVEL]
    wide = own
    if len(alone) == 1:
        wide = np.where(np.arange(len(bars)) == alone[0], np.abs(apart), own)
    else:
        while (F := agreement(every, given, wide)[0]) > SETTLED:
            wide = wide * np.sqrt(F)
    return replace(
        test, wrong=alone[0] if len(alone) == 1 else None, sigma=wide, exchanged=pairs[0] if len(pairs) == 1 else None
    )


def _exchanged(lengths: Array, pair: tuple[int, int]) -> Array:
    found = lengths.copy()
    found[list(pair)] = lengths[[pair[1], pair[0]]]
    return found


def _agreement(measured: Array, given: Array, own: Array, of_network: Array, freedom: float) -> tuple[float, float]:
    """F of the ratios about their common value, and its probability."""
    W = np.linalg.inv(of_network + np.diag((own / given) ** 2))
    z = np.log(given / measured)
    r = z - float(W.sum(axis=0) @ z) / float(W.sum())
    dof = len(z) - 1
    F = float(r @ W @ r) / dof
    return F, fisher_tail(F, dof, freedom)


def _left_out(z: Array, C: Array) -> tuple[Array, Array]:
    """Of each ratio by how much it differs from the others' common value, and the standard deviation of that."""
    W = np.linalg.inv(C)
    ones = W.sum(axis=1)
    P = W - np.outer(ones, ones) / float(W.sum())  # takes the common value out
    variance = 1 / np.diagonal(P)
    return (P @ z) * variance, np.sqrt(variance)
