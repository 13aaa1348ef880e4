"""Memory of an adjustment: all in memory, large arrays in files, normal equations in parts besides.

    python benchmarks/memory.py [--images 1000 2000] [--folder FOLDER]

Flights of ../shared/bench/generate_block.py (some 1500 image points an image).  Each way runs in a process of its own,
with one thread; told are the largest memory that is its own (what lies in files can be dropped by the system at any
time) beyond what the process had before, for each image observation, and CPU seconds.  What
`workflows.within_memory` reckons with comes from here.
"""

from __future__ import annotations

import argparse
import gc
import json
import os
import subprocess
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path
from threading import Event, Thread

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from blocking import FREE, OPTIONS, generated, read
from raybundle.adjustment.system.factoring import in_one_piece, made_by
from raybundle.blocking.network_in_memory import WholeNormals
from raybundle.blocking.normals_in_parts import in_parts
from raybundle.numerics import large
from raybundle.pipeline.store import Folder
from raybundle.workflows.adjust import adjust
from raybundle.workflows.within_memory import IN_FILES, IN_MEMORY, IN_PARTS, bytes_of

HERE = Path(__file__).resolve().parent
WAYS = {"in memory": IN_MEMORY, "in files": IN_FILES, "in files and parts": IN_PARTS}
READY = 50e6


def own_memory() -> float:
    """Bytes of this process that no file holds (Linux)."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return 1024.0 * next(int(line.split()[1]) for line in lines if line.startswith("RssAnon"))


def measured(way: str, path: Path) -> dict[str, float]:
    """One adjustment with everything that a report needs."""
    empty, peak, stop = own_memory(), [0.0], Event()
    options = replace(OPTIONS, noise="auto")

    def watch() -> None:
        while not stop.wait(0.02):
            peak[0] = max(peak[0], own_memory())

    with tempfile.TemporaryDirectory(dir=path.parent) as work:
        room = None if way == "in memory" else Path(work)
        with large.in_files(room):
            block = read("uav", path)
            block = replace(block, cameras=tuple(replace(c, estimate=FREE[c.id]) for c in block.cameras))
            o = block.observations
            kept = {name: large.kept(getattr(o, name)) for name in ("image", "point", "xy_px", "cov_px2")}
            block = replace(block, observations=replace(o, **kept))
            del o, kept
            gc.collect()
            Thread(target=watch, daemon=True).start()
            parts = in_parts(store=lambda: Folder(Path(work) / "parts"), ready=READY)
            began = time.process_time()
            with made_by(parts if way == "in files and parts" else in_one_piece):
                done = adjust(block, options)
            took = time.process_time() - began
            stop.set()
    count = len(done.given.observations)
    work = done.handle.work
    assert work is not None
    factor = 0.0 if isinstance(work.normals, WholeNormals) else bytes_of(work.normals)
    return {
        "image points": count, "CPU s": took, "peak MB": (peak[0] - empty) / 1e6, "sigma0": done.sigma0,
        "bytes an image point": (peak[0] - empty - factor) / count,
    }  # fmt: skip


def main() -> None:
    """Measure and write the figures."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--images", type=int, nargs="*", default=[1000, 2000])
    parser.add_argument("--folder", type=Path, default=HERE / "work" / "blocking")
    parser.add_argument("--one", nargs=2)
    args = parser.parse_args()
    if args.one:
        print(json.dumps(measured(args.one[0], Path(args.one[1]))))
        return
    args.folder.mkdir(parents=True, exist_ok=True)
    found = {}
    for images in args.images:
        path = generated("uav", images, images * 175, args.folder)
        for way, reckoned in WAYS.items():
            command = [sys.executable, __file__, "--one", way, str(path)]
            said = subprocess.run(command, check=True, capture_output=True, text=True).stdout
            figures = {**json.loads(said), "reckoned with": reckoned}
            found[f"{images} images, {way}"] = figures
            print(images, way, figures, flush=True)
    (HERE / "results" / "memory.json").write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
