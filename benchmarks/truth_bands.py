"""Monte-Carlo errors of every kind of unknown against the 99.9 % band of chi-square: what long truth tests print."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Mapping

import numpy as np
from scipy.stats import chi2, kstest

Errors = Mapping[str, tuple[np.ndarray, int]]
"""Kind of unknown -> normalised squared errors (runs,), degrees of freedom of one."""


def figures(block: str, errors: Errors) -> list[dict]:
    """Each kind of unknown of a block: the sum of its normalised squared errors beside its band."""
    rows = []
    for kind, (d2, degrees) in errors.items():
        low, high = chi2(degrees * len(d2)).interval(0.999)
        rows.append(
            {
                "block": block, "unknowns": kind, "runs": len(d2), "degrees": degrees,
                "mean_over_degrees": float(np.mean(d2) / degrees), "sum": float(d2.sum()), "low": float(low),
                "high": float(high), "inside": bool(low < d2.sum() < high),
                "ks_p": float(kstest(d2, chi2(degrees).cdf).pvalue),
            }
        )  # fmt: skip
    return rows


def run(blocks: Mapping[str, Callable[[int], Errors]], runs: int) -> int:
    """Print the figures of blocks, each a function of the number of runs, as JSON; 1 if one lies outside its band."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--runs", type=int, default=runs)
    count = parser.parse_args().runs
    rows = [row for name, errors in blocks.items() for row in figures(name, errors(count))]
    print(json.dumps(rows, indent=1))
    return int(not all(row["inside"] for row in rows))
