"""Of the CPU time of a start in parts and of least-squares matching that of their tasks: what workers can share.

    python benchmarks/stage_shares.py [--images 700] [--strips 4] [--each 6]

--images          simulated photographs (benchmarks/stages_at_size.py), started in parts
--strips, --each  made photographs (benchmarks/many_images.py), oriented with least-squares matching

One process that does one task at a time, while nothing else is done.  The figures are those of the constants
`start_shared`, `precision_shared` and `photographs_of_window` of `raybundle.workflows.costs`.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import time
from collections import defaultdict
from dataclasses import replace
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import many_images
import numpy as np
import stages_at_size as made
from run import machine

import raybundle as rb
from raybundle.pipeline import executors
from raybundle.pipeline.tasks import Done, Task, do
from raybundle.workflows.orienting.stages import ORIENT

HERE = Path(__file__).resolve().parent
WORK = HERE / "work" / "shares"


class Clock:
    """CPU seconds of tasks, by the name of their function; photographs that each task of windows reads."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = defaultdict(float)
        self.count: dict[str, int] = defaultdict(int)
        self.photographs = 0

    def __call__(self, task: Task, store: object) -> Done:
        began = time.process_time()
        done = do(task, store)
        name = task.function.rpartition(":")[2]
        self.seconds[name] += time.process_time() - began
        self.count[name] += 1
        if name == "windows_of":
            self.photographs += len(task.options.photos)
        return done


def start(images: int) -> dict:
    """A start in parts of simulated photographs."""
    executors.do = clock = Clock()
    folder = WORK / "start"
    shutil.rmtree(folder, ignore_errors=True)
    project, rng = made.Project.open(folder), np.random.default_rng(18)
    try:
        method = made.feature_method("rootsift")
        flight = made.fly(images, rng)
        photos = made.photographs(flight, rng)
        found = made.keep(project, flight, method.name, rng)
        options = made.OrientOptions(precise=False, start="parts")
        asked = made.Asked(inputs=(), name="flight", options=options, given=made.Given(), method=method)
        state = made.OrientState(asked=asked, given=made.Given(), method=method, photos=photos, features=found)
        run = made.Run(project=project, executor=made.Threads(1))
        for name in ("cameras", "matching"):
            state = run.stages((ORIENT.stages[name],), state)
        began = time.process_time()
        state = run.stages((ORIENT.stages["start"],), replace(state))
        took = time.process_time() - began
    finally:
        project.close()
        shutil.rmtree(folder, ignore_errors=True)
    tasks = clock.seconds["grown"] + clock.seconds["settled"]
    return {
        "images": images, "oriented": sum(int(b.images.oriented.sum()) for b in state.blocks),
        "image points": sum(len(b.observations) for b in state.blocks), "CPU s": took, "CPU s of tasks": tasks,
        "leaves": clock.count["grown"], "share": tasks / took,
    }  # fmt: skip


def precision(strips: int, each: int) -> dict:
    """Least-squares matching of made photographs."""
    executors.do = clock = Clock()
    shutil.rmtree(WORK, ignore_errors=True)
    many_images.fly(WORK / "photos", strips, each)
    rb.orient(WORK / "photos", WORK / "project", jobs=1, report=False)
    result = json.loads((WORK / "project/result/result.json").read_text())
    took = {s["name"]: s["cpu_seconds"] for s in result["stages"]}["precision"]
    shutil.rmtree(WORK, ignore_errors=True)
    tasks, count = clock.seconds["windows_of"], clock.count["windows_of"]
    return {
        "images": strips * each, "image points": result["observations"] / 2, "CPU s": took, "CPU s of tasks": tasks,
        "tasks": count, "photographs of a task": clock.photographs / count, "share": tasks / took,
    }  # fmt: skip


def main() -> None:
    """Measure, and write the results."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--images", type=int, default=700)
    parser.add_argument("--strips", type=int, default=4)
    parser.add_argument("--each", type=int, default=6)
    given = parser.parse_args()
    found = {"machine": machine(), "start": start(given.images), "precision": precision(given.strips, given.each)}
    (HERE / "results/stage_shares.json").write_text(json.dumps(found, indent=1) + "\n")
    print(json.dumps(found, indent=1))


if __name__ == "__main__":
    main()
