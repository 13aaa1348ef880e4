"""The long truth tests: thousands of adjustments against the stated covariances, alarms and detection rates.

python benchmarks/truth.py [--runs 2000]
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import numpy as np
from scipy.stats import chi2, kstest

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tests.truth.monte_carlo import Network


def covariances(runs: int) -> list[dict]:
    """Kolmogorov-Smirnov and sum of chi-square of every quantity, and with sigma 10 % wrong."""
    rows = []
    for kind in ("free", "control", "resection"):
        for quantity, (d2, degrees) in Network.of(kind).errors(runs, seed=1).items():
            low, high = chi2(degrees * runs).interval(0.999)
            rows.append(
                {
                    "network": kind, "quantity": quantity, "runs": runs, "degrees": degrees,
                    "ks_p": float(kstest(d2, chi2(degrees).cdf).pvalue),
                    "sum": float(d2.sum()), "low": float(low), "high": float(high),
                    "ks_p_sigma_10_percent_small": float(kstest(d2 * 1.21, chi2(degrees).cdf).pvalue),
                    "ks_p_sigma_10_percent_large": float(kstest(d2 / 1.21, chi2(degrees).cdf).pvalue),
                }
            )  # fmt: skip
    return rows


def main() -> None:
    """Print the figures as JSON."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--runs", type=int, default=2000)
    runs = parser.parse_args().runs
    network = Network.of("free")
    share, count = network.false_alarms(max(runs // 4, 50), seed=2)
    error = float(np.sqrt(0.001 * 0.999 / count))
    result = {
        "covariances": covariances(runs),
        "false_alarms": {"share": share, "tests": count, "standard_errors_from_0.001": (share - 0.001) / error},
        "detection": {"runs": 2 * runs, "share": network.detection(2 * runs, seed=3)},
        "detection_sigma_10_percent_wrong": {"share": network.detection(2 * runs, seed=3, scale=1.1)},
    }
    print(json.dumps(result, indent=1))


if __name__ == "__main__":
    main()
