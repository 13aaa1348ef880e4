"""CPU seconds and peak memory of every stage of `orient` after the features, for 500 to 8000 simulated photographs.

    python benchmarks/stages_at_size.py [--images 500 1000 2000 4000 8000] [--memory GB] [--profile STAGE ...]

A flight in strips over a relief, as square as its number of photographs lets it be, by a camera whose constant and
distortion differ from what the photographs state; positions with an error of 2 m.  There are no pixels: features are
the projections of points of the ground, with noise, some of them missing, some of what nothing else shows; a point has
its descriptor wherever it is seen.  Pairs that overlap are kept in the project as verified, one match in fifty to a
wrong feature, so that the stage `matching` chooses them, and matches those that it tries beside, with its own code.
Each stage is run by the code that `orient` uses, alone: what stands in memory before it is what `orient` holds then.
The start is made in several ways, in parts last.  What the flight does not have: least-squares matching, whose
tasks are pixels; features by the thousand, of which a photograph has 120 here.  Each number of photographs has a
process of its own.
"""

from __future__ import annotations

import argparse
import cProfile
import json
import math
import pstats
import shutil
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from runs import measured, peak_mb
from scipy.spatial import KDTree

from raybundle.commands.orient import write_orientation
from raybundle.io.photos.metadata import Gps, Metadata
from raybundle.io.photos.photo import Photo
from raybundle.matching.features import Features
from raybundle.matching.methods import feature_method
from raybundle.matching.verify import FEWEST, VerifiedPair
from raybundle.numerics.rotation import rotation_from_vector
from raybundle.pipeline.executors import Threads
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Run, Stage
from raybundle.placing.marks import Given
from raybundle.ties.points import VERIFICATION, FeatureStore, arrays_of_features, arrays_of_pair
from raybundle.workflows.orient import _orientation
from raybundle.workflows.orienting.options import OrientOptions
from raybundle.workflows.orienting.stages import ORIENT
from raybundle.workflows.orienting.state import Asked, OrientState

HERE = Path(__file__).resolve().parent
WORK = HERE / "work" / "stages"
RESULTS = HERE / "results" / "stages_at_size.json"
WIDTH, HEIGHT, C_PX, K1 = 1000, 750, 1013.0, -0.03
FLYING_M, ALONG_M, ACROSS_M = 100.0, 18.0, 34.0
GPS_M, NOISE_PX, WRONG, STRAY, SEEN = 2.0, 0.4, 0.02, 0.15, 0.8
FEATURES = 120
LATITUDE, LONGITUDE, METRES = 50.0, 10.0, 111_194.9
IMAGES = (500, 1000, 2000, 4000, 8000)
LIMITS = {"cpu_s": 5.0, "peak_mb": 1.5}
"""Times that four times as many photographs may take."""


@dataclass(frozen=True)
class Flight:
    """What was simulated."""

    xy: list[np.ndarray]
    """(k, 2) features of each photograph [px]"""
    point: list[np.ndarray]
    """(k,) point of the ground that each shows, -1 for none"""
    centre: np.ndarray
    descriptors: np.ndarray
    """(p, 128) uint8 of the points"""


def fly(images: int, rng: np.random.Generator) -> Flight:
    """Photographs, points and what is seen of them."""
    each = max(2, round(math.sqrt(images * ACROSS_M / ALONG_M)))
    k = np.arange(images)
    strip, along = k // each, k % each
    along = np.where(strip % 2 == 0, along, each - 1 - along)
    centre = np.column_stack([along * ALONG_M, strip * ACROSS_M, np.full(images, FLYING_M)])
    centre += rng.normal(0, 1.0, centre.shape)
    turn = np.where(strip % 2 == 0, 0.0, np.pi)
    low, high = centre[:, :2].min(axis=0) - 60, centre[:, :2].max(axis=0) + 60
    density = FEATURES * (1 - STRAY) / SEEN / (WIDTH / C_PX * FLYING_M * HEIGHT / C_PX * FLYING_M)
    count = int(density * np.prod(high - low))
    plan = rng.uniform(low, high, (count, 2))
    height = 4 * np.sin(plan[:, 0] / 23) * np.cos(plan[:, 1] / 31) + 2 * np.sin(plan[:, 1] / 7)
    ground = np.column_stack([plan, height])
    tree = KDTree(plan)
    xy, point = [], []
    for i in range(images):
        z = turn[i]
        flat = np.array([[np.cos(z), np.sin(z), 0], [-np.sin(z), np.cos(z), 0], [0, 0, 1]])
        R = rotation_from_vector(rng.normal(0, 0.03, 3)) @ flat
        near = np.sort(tree.query_ball_point(centre[i, :2], 80.0))
        d = (ground[near] - centre[i]) @ R.T
        x = -d[:, :2] / d[:, 2:]
        x *= 1 + K1 * (x**2).sum(axis=1, keepdims=True)
        px = x * [C_PX, -C_PX] + [WIDTH / 2, HEIGHT / 2] + rng.normal(0, NOISE_PX, x.shape)
        inside = ((px > 2) & (px < [WIDTH - 2, HEIGHT - 2])).all(axis=1) & (rng.random(len(px)) < SEEN)
        stray = int(STRAY * FEATURES)
        xy.append(np.vstack([px[inside], rng.uniform(0, [WIDTH, HEIGHT], (stray, 2))]))
        point.append(np.concatenate([near[inside], np.full(stray, -1)]))
    words = rng.gamma(0.6, 1.0, (count, 128))
    return Flight(xy=xy, point=point, centre=centre, descriptors=_bytes(words))


def _bytes(values: np.ndarray) -> np.ndarray:
    """Descriptors as RootSIFT keeps them, of sums of gradients (n, 128)."""
    root = np.sqrt(values / values.sum(axis=1, keepdims=True))
    return np.minimum(np.round(root * 512), 255).astype(np.uint8)


def photographs(flight: Flight, rng: np.random.Generator) -> tuple[Photo, ...]:
    """As they would have been found."""
    told = flight.centre + rng.normal(0, GPS_M, flight.centre.shape)
    return tuple(
        Photo(
            path=Path(f"flight_{i:05d}.jpg"), name=f"flight_{i:05d}.jpg", width_px=WIDTH, height_px=HEIGHT,
            sha256=f"{i:064x}",
            metadata=Metadata(
                make="raybundle", model="flight", focal35_mm=35.0,
                gps=Gps(
                    latitude_deg=LATITUDE + y / METRES,
                    longitude_deg=LONGITUDE + x / METRES / math.cos(math.radians(LATITUDE)),
                    altitude_m=z, altitude_reference="ellipsoid",
                ),
            ),
        )
        for i, (x, y, z) in enumerate(told.tolist())
    )  # fmt: skip


def keep(project: Project, flight: Flight, method_name: str, rng: np.random.Generator) -> FeatureStore:
    """Features and overlapping pairs in the project, as tasks would have left them."""
    n = len(flight.xy)
    keys = tuple(key_of("features", "simulated", i, n) for i in range(n))
    for key, xy, point in zip(keys, flight.xy, flight.point, strict=True):
        own = np.where(point >= 0, point, 0)
        d = flight.descriptors[own].astype(np.int16) + np.round(rng.normal(0, 6, (len(own), 128))).astype(np.int16)
        d[point < 0] = _bytes(rng.gamma(0.6, 1.0, (int((point < 0).sum()), 128)))
        scale = rng.gamma(2.0, 2.0, len(xy)) + 1
        project.products.store(key, arrays_of_features(Features(
            xy_px=xy, scale_px=scale, angle=rng.uniform(-3, 3, len(xy)),
            descriptors=np.clip(d, 0, 255).astype(np.uint8),
        )))  # fmt: skip
    rows: list = []
    for i, j in sorted(KDTree(flight.centre[:, :2]).query_pairs(95.0)):
        _, a, b = np.intersect1d(flight.point[i], flight.point[j], return_indices=True)
        shown = flight.point[i][a] >= 0
        a, b = a[shown], b[shown]
        if len(a) < FEWEST:
            continue
        wrong = rng.random(len(b)) < WRONG
        b[wrong] = rng.permutation(b[wrong])
        apart = np.linalg.norm(flight.xy[i][a] - flight.xy[j][b], axis=1)
        pair = VerifiedPair(
            first=0, second=1, matches=np.column_stack([a, b]), candidates=len(a) + 20, geometry="general",
            planar_share=0.5, displacement_px=float(np.median(apart)), log_chance=-500.0,
        )  # fmt: skip
        rows.append((key_of("matching", VERIFICATION, method_name, keys[i], keys[j]), arrays_of_pair(pair)))
        if len(rows) == 5000:
            project.store_small(rows)
            rows = []
    project.store_small(rows)
    return FeatureStore(project.products, keys)


@dataclass
class Watch:
    """Takes the figures of stages."""

    profiled: Sequence[str]
    figures: dict[str, dict[str, float]]

    def __call__(self, name: str, what):
        before = peak_mb(anew=True)
        profile = cProfile.Profile() if name in self.profiled else None
        began = time.process_time()
        if profile:
            profile.enable()
        result = what()
        if profile:
            profile.disable()
        self.figures[name] = {
            "cpu_s": round(time.process_time() - began, 2), "peak_mb": round(peak_mb()), "before_mb": round(before),
        }  # fmt: skip
        print(name, self.figures[name], file=sys.stderr, flush=True)
        if profile:
            stats = pstats.Stats(profile, stream=sys.stderr)
            stats.sort_stats("cumulative").print_stats(45)
            stats.sort_stats("tottime").print_stats(25)
        return result


def stages(images: int, profiled: Sequence[str], ways: Sequence[str], memory_gb: float) -> dict:
    """Figures of all stages for so many photographs, with so much memory as `orient --memory` states."""
    rng = np.random.default_rng(18)
    folder = WORK / str(images)
    shutil.rmtree(folder, ignore_errors=True)
    project = Project.open(folder)
    watch = Watch(profiled, {})
    try:
        method = feature_method("rootsift")
        flight = fly(images, rng)
        photos = photographs(flight, rng)
        found = keep(project, flight, method.name, rng)
        del flight
        options = OrientOptions(precise=False)
        asked = Asked(inputs=(), name="flight", options=options, given=Given(), method=method)
        state = OrientState(asked=asked, given=Given(), method=method, photos=photos, features=found)
        # one process does all that is counted
        run = Run(project=project, adjusting=1e9 * memory_gb, executor=Threads(1))

        def done(name: str, state: OrientState) -> OrientState:
            stage: Stage = ORIENT.stages[name]
            return run.stages((stage,), state)

        state = done("cameras", state)
        state = watch("matching", lambda: done("matching", state))

        def by(way: str) -> OrientState:
            started = replace(state, asked=replace(asked, options=replace(options, start=way)))
            return watch(f"start, {way}", lambda: done("start", started))

        oriented = {way: by(way).oriented for way in ways}
        state = done("start", replace(state, asked=replace(asked, options=replace(options, start="parts"))))
        state = watch("adjustment", lambda: done("adjustment", state))
        result = _orientation(state, project.records)
        watch("results and report", lambda: write_orientation(result, folder / "result", report="html", progress=_no))
        report = (folder / "result" / "report.html").stat().st_size / 1e6
    finally:
        project.close()
        shutil.rmtree(folder, ignore_errors=True)
    return {
        "images": images, "memory_gb": memory_gb, "oriented": oriented, "pairs": len(state.pairs),
        "image points": len(result.adjustment.given.observations), "sigma0": round(result.adjustment.sigma0, 4),
        "report_mb": round(report, 1), "stages": watch.figures,
    }  # fmt: skip


def _no(*_: object) -> None:
    """No progress."""


def compared(rows: list[dict], few: int, many: int) -> dict:
    """From few to many photographs, of each stage: how many times the CPU seconds and the peak memory."""
    of = {r["images"]: r["stages"] for r in rows}
    if not {few, many} <= of.keys():
        return {}
    return {
        name: {
            **{what: round(of[many][name][what] / of[few][name][what], 2) for what in LIMITS},
            "reached": all(of[many][name][what] <= k * of[few][name][what] for what, k in LIMITS.items()),
        }
        for name in of[few]
        if name in of[many]
    }


def kept(new: list[dict], results: Path) -> dict:
    """These rows among those of earlier runs, and what they say together."""
    earlier = json.loads(results.read_text())["rows"] if results.exists() else []
    rows = {r["images"]: r for r in (*earlier, *new)}
    ordered = [rows[n] for n in sorted(rows)]
    times = [(n, 4 * n) for n in sorted(rows) if 4 * n in rows]
    return {
        "limits": LIMITS, "rows": ordered,
        **{f"from {few} to {many}": compared(ordered, few, many) for few, many in times},
    }  # fmt: skip


def main() -> int:
    """Print the figures, and keep them beside those of other numbers of photographs."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--images", type=int, nargs="+", default=IMAGES)
    parser.add_argument("--one", type=int, help="so many photographs in this process")
    parser.add_argument("--profile", nargs="*", default=[], metavar="STAGE", help="print where stages spend their time")
    parser.add_argument("--memory", type=float, default=4.0, metavar="GB", help="as of orient; results apart")
    parser.add_argument("--starts", nargs="+", default=["parts", "growing"], help="kinds of start")
    asked = parser.parse_args()
    if asked.one:
        print(json.dumps(stages(asked.one, asked.profile, asked.starts, asked.memory)))
        return 0
    bounded = asked.memory != parser.get_default("memory")
    results = RESULTS.with_stem(f"{RESULTS.stem}_within") if bounded else RESULTS
    for n in asked.images:
        command = [sys.executable, __file__, "--one", str(n), "--memory", str(asked.memory), "--starts", *asked.starts]
        row = json.loads(measured(command, cpus=1)["output"].splitlines()[-1])
        results.write_text(json.dumps(kept([row], results), indent=1) + "\n")
        print(json.dumps(row), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
