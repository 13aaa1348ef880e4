"""Which pairs of a large set are matched: five sets in one pot against all pairs; the search among 100 000 signatures.

    python benchmarks/retrieval.py [--photographs ../shared/data/photos] [--images 100000] [--keep]

The pot: fountain-p11, herzjesu-p8, castle-p19, sceaux-castle and copr-uav, 90 photographs under shuffled names, so that
neither names nor folders tell what belongs together (copr-uav without its GPS positions, that pixels alone decide).
The stage `matching` of `orient` chooses and matches; then all 4005 pairs are matched.  A pair is right that has 40
verified matches among them.  The words come from other photographs (tools/make_codebook.py).
What the pot does not have: thousands of photographs, nights, seasons.
"""

from __future__ import annotations

import argparse
import json
import shutil
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
from runs import measured, peak_mb

from raybundle.io.photos.photo import find_photos
from raybundle.matching.methods import feature_method
from raybundle.matching.nearest import most_similar
from raybundle.matching.pairs import SIMILAR, all_pairs, parts_of
from raybundle.matching.signatures import LENGTH, NORM
from raybundle.matching.verify import STRONG
from raybundle.pipeline.executors import Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from raybundle.ties.points import find_features, match_pairs
from raybundle.workflows.orienting.options import OrientOptions
from raybundle.workflows.orienting.stages.matching import Inputs, match

HERE = Path(__file__).resolve().parent
WORK = HERE / "work" / "retrieval"
SETS = ("fountain-p11", "herzjesu-p8", "castle-p19", "sceaux-castle", "copr-uav")


def make_pot(photographs: Path, folder: Path, seed: int) -> dict[str, str]:
    """Write the photographs under shuffled names; the set of each name."""
    files = [
        (name, path)
        for name in SETS
        for path in sorted((photographs / name / "images").iterdir())
        if path.suffix.lower() in (".jpg", ".jpeg", ".png")
    ]
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    turn = np.random.default_rng(seed).permutation(len(files))
    own: dict[str, str] = {}
    for k, (name, path) in zip(turn, files, strict=True):
        target = folder / f"photograph_{k:03d}{path.suffix.lower()}"
        shutil.copyfile(path, target)
        own[target.name] = name
    return own


def pot(photographs: Path, seed: int, jobs: int = 1, work: Path = WORK) -> dict:
    """Recall and parts of the pairs that are chosen, against all pairs; CPU seconds of both."""
    own = make_pot(photographs, work / "pot", seed)
    found = find_photos([work / "pot"]).photos
    photos = tuple(replace(p, metadata=replace(p.metadata, gps=None)) for p in found)
    method, options = feature_method(OrientOptions().features), OrientOptions()
    opened = Project.open(work / "project")
    try:
        means = Means(project=opened, executor=Threads(jobs))
        features, _ = find_features(means, photos, method, options.feature_count)
        began = time.process_time()
        chosen = match(Inputs(photos=photos, features=features, method=method, masked=False), means)
        chosen_s = time.process_time() - began
        pairs = [(int(i), int(j)) for i, j in all_pairs(len(photos))]
        began = time.process_time()
        every = match_pairs(means, photos, features, method, pairs, frozenset(pairs))  # without the first look
        all_s = time.process_time() - began
    finally:
        opened.close()
    right = {(p.first, p.second) for p in every if len(p.matches) >= STRONG}
    tried = {(p.first, p.second) for p in chosen.pairs}
    hit = {(p.first, p.second) for p in chosen.pairs if len(p.matches) >= STRONG}
    n = len(photos)
    parts = [parts_of(np.array(sorted(links)), n) for links in (hit, right)]
    return {
        "photographs": {name: sum(1 for o in own.values() if o == name) for name in SETS},
        "seed": seed,
        "all pairs": len(pairs),
        "right pairs": len(right),
        "pairs matched": len(tried),
        "pairs matched per photograph": round(len(tried) / n, 2),
        "rounds": {r.why: r.pairs for r in chosen.rounds},
        "recall": round(len(right & hit) / len(right), 4),
        "parts": int(parts[0].max()) + 1,
        "parts with all pairs": int(parts[1].max()) + 1,
        "same parts": bool(np.array_equal(parts[0], parts[1])),
        "CPU s of the choice and its pairs": round(chosen_s, 1),
        "CPU s of all pairs": round(all_s, 1),
    }


def simulated(images: int) -> np.ndarray:
    """(n, LENGTH) signatures of images along a line, whose neighbours share what they show, under noise."""
    rng = np.random.default_rng(1)
    result = np.empty((images, LENGTH), np.int16)
    seen = rng.normal(size=(12, LENGTH)).astype(np.float32)
    total = seen.sum(axis=0)
    for k in range(images):
        one = total + rng.normal(0, 2.0, LENGTH).astype(np.float32)
        result[k] = np.round(one * (NORM / np.linalg.norm(one)))
        new = rng.normal(size=LENGTH).astype(np.float32)
        total += new - seen[k % 12]
        seen[k % 12] = new
    return result


def search(images: int) -> dict:
    """The most alike of simulated signatures: CPU seconds, peak memory, and how many of the nearest ten are found."""
    signatures = simulated(images)
    began = time.process_time()
    first, second = most_similar(signatures, SIMILAR)
    spent = time.process_time() - began
    near = np.bincount(first[np.abs(first - second) <= 5], minlength=images)[5:-5]
    return {
        "images": images,
        "CPU s": round(spent, 1),
        "peak memory MB": round(peak_mb()),
        "share of the ten neighbours found": round(float(near.mean()) / 10, 4),
    }


def main() -> int:
    """Print the figures as JSON."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--photographs", type=Path, default=HERE.parents[1] / "shared" / "data" / "photos")
    parser.add_argument("--images", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=("pot", "search"))
    parser.add_argument("--keep", action="store_true", help="keep the photographs and the project")
    asked = parser.parse_args()
    result: dict = {}
    if asked.only != "search":
        result["pot"] = pot(asked.photographs, asked.seed)
    if asked.only == "search":
        result = search(asked.images)
    elif asked.only is None:
        command = [sys.executable, __file__, "--only", "search", "--images", str(asked.images)]
        result["search"] = json.loads(measured(command, cpus=1)["output"])
    if not asked.keep:
        shutil.rmtree(WORK, ignore_errors=True)
    print(json.dumps(result, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
