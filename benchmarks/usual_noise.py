"""Residuals and smooth errors of sets of photographs, and the limits in `adjustment/evaluation/unusual_noise.py`.

    python benchmarks/usual_noise.py RESULT ...

Reads result folders of `orient` (result.json, observations.csv) and writes benchmarks/results/usual_noise.json: rms of
the residuals and smooth errors [px] of each, the 95 % quantiles of log-normal distributions, and the probability that
both are exceeded.
"""

from __future__ import annotations

import csv
import json
import sys
from pathlib import Path

import numpy as np
from scipy.stats import multivariate_normal, norm

from raybundle.adjustment.statistics.fields import smooth_px

RESULTS = Path(__file__).resolve().parent / "results/usual_noise.json"
LEAST_PX = 0.01
"""Smooth errors below count as none."""


def of_folder(folder: Path) -> dict[str, float] | None:
    """Rms of the residuals and smooth errors [px]; None under white noise."""
    noise = json.loads((folder / "result.json").read_text(encoding="utf-8"))["noise"]
    if noise["kind"] != "fields":
        return None
    with (folder / "observations.csv").open(encoding="utf-8", newline="") as f:
        rows = [(r["vx_px"], r["vy_px"]) for r in csv.DictReader(f) if not r["rejected"]]
    rms = float(np.sqrt(np.nanmean(np.array(rows, float) ** 2)))
    return {"rms_px": rms, "smooth_px": smooth_px(noise["tau_px"] ** 2, noise["focus_px"] ** 2)}


def main() -> int:
    """All folders."""
    sets = {f.resolve().parent.parent.name: of_folder(f) for f in map(Path, sys.argv[1:])}
    found = {name: row for name, row in sets.items() if row is not None}
    rms, smooth = (np.array([row[k] for row in found.values()]) for k in ("rms_px", "smooth_px"))
    there = smooth > LEAST_PX
    logs = np.log(np.stack([rms[there], smooth[there]]))
    spread, z = logs.std(axis=1, ddof=1), norm.ppf(0.95)
    rms_limit = float(np.exp(np.log(rms).mean() + z * np.log(rms).std(ddof=1)))
    smooth_limit = float(np.exp(logs[1].mean() + z * spread[1]))
    limits = np.log([rms_limit, smooth_limit])
    both = multivariate_normal(-logs.mean(axis=1), np.cov(logs)).cdf(-limits) * there.mean()
    summary = {
        "sets": len(found), "rms_limit_px": rms_limit, "smooth_limit_px": smooth_limit, "both_exceeded": float(both),
        "sets_beyond_both": int(((rms > rms_limit) & (smooth > smooth_limit)).sum()),
    }  # fmt: skip
    print(summary)
    text = json.dumps({"summary": summary, "sets": found}, indent=1, sort_keys=True)
    RESULTS.write_text(text + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
