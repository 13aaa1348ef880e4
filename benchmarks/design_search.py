"""The best networks that a long search by other code finds in the problems of `design_problems.py`.

CMA-ES (Hansen 2016; package `cma`) over place, point looked at and roll of eight stations, begun anew fifty times from
random stations and from the poor start, 18 CPU seconds each; then the five best go on for a minute each: 20 CPU minutes
a problem.  Results are added to benchmarks/results/design_search.json; what is there is not searched again.

    python benchmarks/design_search.py [NAME ...]
"""

from __future__ import annotations

import json
import os
import sys
import time
import warnings
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import cma
import numpy as np
from design_problems import STATIONS, UNSEEN, Judge, look, problems

RESTARTS, EACH, BEST, LONGER = 50, 18.0, 5, 60.0
OUT = Path(__file__).with_name("results") / "design_search.json"


class Search:
    """Stations as numbers of about 1, and back."""

    def __init__(self, judge: Judge) -> None:
        self.judge, p = judge, judge.p
        self.middle, self.half = (p.low + p.high) / 2, (p.high - p.low) / 2
        low, high = p.targets.min(axis=0), p.targets.max(axis=0)
        self.aim, self.around = (low + high) / 2, np.maximum((high - low) / 2, 0.1 * np.ptp(p.targets))

    def stations(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        a = x.reshape(STATIONS, 7)
        return self.middle + self.half * a[:, :3], self.aim + self.around * a[:, 3:6], np.pi * a[:, 6]

    def numbers(self, centre: np.ndarray, at: np.ndarray, roll: np.ndarray) -> np.ndarray:
        parts = (centre - self.middle) / self.half, (at - self.aim) / self.around, roll[:, None] / np.pi
        return np.concatenate(parts, axis=1).ravel()

    def value(self, x: np.ndarray) -> float:
        centre, at, roll = self.stations(x)
        if np.linalg.norm(centre - at, axis=1).min() < 1e-3:
            return 2 * UNSEEN
        return self.judge.worth(centre, look(centre, at, roll))

    def drawn(self, rng: np.random.Generator) -> np.ndarray:
        """The best of 30 sets of random stations that may be."""
        best, worth = None, np.inf
        for _ in range(30):
            places = np.empty((0, 3))
            while len(places) < STATIONS:
                more = self.middle + self.half * rng.uniform(-1, 1, (64, 3))
                places = np.concatenate([places, more[self.judge.violation(more) == 0]])
            at = self.aim + self.around * rng.uniform(-0.5, 0.5, (STATIONS, 3))
            x = self.numbers(places[:STATIONS], at, rng.choice([0.0, np.pi / 2], STATIONS))
            if (w := self.value(x)) < worth:
                best, worth = x, w
        assert best is not None
        return best

    def descend(self, x: np.ndarray, spread: float, seconds: float, seed: int) -> tuple[np.ndarray, float, int]:
        """CMA-ES from x for so many CPU seconds; begun anew from its best where it stands still."""
        end = time.process_time() + seconds
        best, worth, count = x, self.value(x), 0
        while time.process_time() < end:
            options = {"verbose": -9, "seed": seed, "maxfevals": 10**9, "tolfun": 1e-7, "CMA_diagonal": 0}
            es = cma.CMAEvolutionStrategy(best, spread, options)
            while not es.stop() and time.process_time() < end:
                xs = es.ask()
                values = [self.value(v) for v in xs]
                es.tell(xs, values)
                count += len(xs)
                k = int(np.argmin(values))
                if values[k] < worth:
                    best, worth = np.array(xs[k]), values[k]
            spread, seed = max(0.5 * spread, 0.01), seed + 1000
        return best, worth, count


def searched(name: str) -> dict[str, object]:
    p = next(p for p in problems() if p.name == name)
    judge = Judge(p)
    search = Search(judge)
    begun = time.process_time()
    found, count = [], 0
    for k in range(RESTARTS):
        rng = np.random.default_rng([k, 7])
        x = search.numbers(*p.start) if k == 0 else search.drawn(rng)
        x, worth, n = search.descend(x, 0.2, EACH, 1 + k)
        found.append((worth, k, x))
        count += n
        print(f"{name} {k:2d} {worth:9.4f} best {min(f[0] for f in found):9.4f}", flush=True)
    found.sort(key=lambda f: f[0])
    worths = [f[0] for f in found]
    for i, (_, k, first) in enumerate(found[:BEST]):
        x, worth, n = search.descend(first, 0.05, LONGER, 5000 + k)
        found[i], count = (worth, k, x), count + n
    worth, k, x = min(found[:BEST], key=lambda f: f[0])
    centre, at, roll = search.stations(x)
    start = judge.sigma(p.start[0], look(*p.start))
    return {
        "problem": name,
        "objective": p.objective,
        "free": p.free,
        "sigma_mm": 1e3 * judge.sigma(centre, look(centre, at, roll)),
        "start_mm": 1e3 * start if np.isfinite(start) else None,
        "worth": worth,
        "restart": k,
        "restarts": RESTARTS,
        "worths_of_restarts": [round(w, 4) for w in worths],
        "evaluations": count,
        "cpu_s": round(time.process_time() - begun),
        "centre": centre.tolist(),
        "at": at.tolist(),
        "roll": roll.tolist(),
    }


if __name__ == "__main__":
    warnings.filterwarnings("ignore")
    done = json.loads(OUT.read_text()) if OUT.exists() else {}
    for p in problems():
        if p.name in done or (sys.argv[1:] and p.name not in sys.argv[1:]):
            continue
        result = searched(p.name)
        done = json.loads(OUT.read_text()) if OUT.exists() else {}
        done[p.name] = result
        OUT.write_text(json.dumps(done, indent=1) + "\n")
