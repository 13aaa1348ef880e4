"""Errors of a demonstration: truth beside estimate and standard deviation."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from raybundle.errors import Message, note

if TYPE_CHECKING:
    from raybundle.adjustment.result import Adjustment
    from raybundle.block import Block
    from raybundle.numerics.arrays import Array


def interior_errors(truth: Block, a: Adjustment) -> list[Message]:
    """The largest error of an interior orientation in units of its standard deviation."""
    true = truth.cameras[0].values
    ratios = {
        p.symbol: (p.value - true[p.symbol]) / p.std
        for interior in a.interior
        for p in interior.parameters.values()
        if p.std is not None and p.std > 0
    }
    if not ratios:
        return []
    worst = max(ratios, key=lambda symbol: abs(ratios[symbol]))
    return [note("demo.interior", n=len(ratios), ratio=abs(ratios[worst]), symbol=worst)]


def interior_lines(truth: Block, a: Adjustment) -> list[str]:
    """Truth, estimate, sigma and their ratio for each parameter."""
    true = truth.cameras[0].values
    lines = [f" {'parameter':12}{'truth':>16}{'estimate':>16}{'sigma':>12}{'error / sigma':>16}"]
    for interior in a.interior:
        for p in interior.parameters.values():
            if p.std is None or not p.std > 0:
                continue
            texts = together((true[p.symbol], p.value, p.std), p.std)
            ratio = (p.value - true[p.symbol]) / p.std
            lines.append(f" {p.symbol:4}{p.unit:8}{texts[0]:>16}{texts[1]:>16}{texts[2]:>12}{ratio:>16.2f}")
    return lines


def together(values: tuple[float, ...], std: float) -> tuple[str, ...]:
    """Numbers written down to the second digit of a standard deviation, small ones with one common exponent."""
    decimals = 1 - math.floor(math.log10(std))
    if decimals <= 7:
        return tuple(f"{v:.{max(decimals, 0)}f}" for v in values)
    largest = max(abs(v) for v in values)
    exponent = math.floor(math.log10(largest))
    return tuple(f"{v / 10.0**exponent:.{max(decimals + exponent, 0)}f}e{exponent:+03d}" for v in values)


def rigid_difference(estimate: Array, truth: Array) -> tuple[Array, Array]:
    """Estimate minus truth (n, 3) after the best rigid motion onto the truth, and its rotation (3, 3).

    Least squares without weights (Arun, Huang and Blostein 1987); the scale is left as it is.
    """
    from raybundle.numerics.rotation import nearest_rotation

    a, b = estimate - estimate.mean(axis=0), truth - truth.mean(axis=0)
    turn = nearest_rotation(b.T @ a)
    return a @ turn.T - b, turn
