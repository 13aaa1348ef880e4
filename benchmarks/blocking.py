"""A network in parts beside the one piece: the same numbers, CPU seconds, memory; and one that no memory holds.

    python benchmarks/blocking.py [--blocks uav:1000 community:500 street:500] [--large 10000] [--folder FOLDER]
                                  [--graph 100000]

Blocks of ../shared/bench/generate_block.py with one camera for all images, control, a scale bar between its ends and
observed projection centres; and free, with inner constraints.  One thread each.  The one piece is held against itself
with its object points in another order, too: that is its own rounding.  --large: a block of so many images,
some 1140 image points each, adjusted from columns on disk through a store, one task after the other, in a process of
its own whose peak memory is told.  --graph: a made graph of so many images, some 100 image points each, is cut.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
from blocks import block_from_npz
from runs import peak_mb
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import connected_components

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.estimation import carry_out
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.statistics.precision import cofactors
from raybundle.adjustment.statistics.system_state import Work
from raybundle.adjustment.system.adjusted_values import adjusted_block
from raybundle.adjustment.system.assemble import assemble
from raybundle.adjustment.system.datum import analyse, hold_minimal
from raybundle.adjustment.system.factoring import made_by
from raybundle.adjustment.system.normals import Normals
from raybundle.block import Block, Distances, Role, Stations
from raybundle.block.select import select_block
from raybundle.blocking.columns import InFiles
from raybundle.blocking.cutting import PIECE
from raybundle.blocking.graph import meeting
from raybundle.blocking.memory import Serial
from raybundle.blocking.normals_in_parts import in_parts
from raybundle.blocking.stored import adjust_columns
from raybundle.blocking.tree import WORTH, dissect
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.numerics.arrays import Array
from raybundle.pipeline.store import Folder

HERE = Path(__file__).resolve().parent
GENERATOR = HERE.parents[1] / "shared/bench/generate_block.py"
OPTIONS = AdjustmentOptions(jobs=1, noise="white")
FREE = {"1": ("c", "k1", "k2")}


def generated(kind: str, images: int, points: int, folder: Path) -> Path:
    """A block of the generator, made once."""
    path = folder / f"{kind}{images}.npz"
    if not path.exists():
        subprocess.run([sys.executable, GENERATOR, kind, str(images), str(points), str(path), "3"], check=True)
    return path


def read(kind: str, path: Path, *, truth: bool = False) -> Block:
    """The largest part of a block that hangs together; flights are of one camera, other images have one each."""
    block = block_from_npz(path, truth=truth)
    if kind == "uav":
        camera = replace(block.cameras[0], interior="shared")
        block = replace(block, cameras=(camera,), images=replace(block.images, interior={}))
    o = block.observations
    n, size = len(block.images), len(block.images) + len(block.points)
    meets = csr_matrix((np.ones(len(o)), (o.image, n + o.point)), (size, size))
    _, part = connected_components(meets, directed=False)
    inside = part == np.bincount(part[:n]).argmax()
    return select_block(select_block(block, "image", inside[:n]), "point", inside[n:])


def with_control(block: Block, truth: Block) -> Block:
    """Twelve control points, a scale bar from end to end, and projection centres of every third image."""
    rng = np.random.default_rng(1)
    rays = np.bincount(block.observations.point, minlength=len(block.points))
    good = np.flatnonzero(rays >= np.quantile(rays, 0.9))
    control = rng.choice(good, 12, replace=False)
    role, sigma, xyz = block.points.role.copy(), block.points.sigma.copy(), block.points.xyz.copy()
    role[control], sigma[control] = Role.CONTROL, 0.05
    xyz[control] = truth.points.xyz[control] + rng.normal(0, 0.05, (12, 3))
    along = truth.points.xyz[good, 0]
    ends = good[[int(along.argmin()), int(along.argmax())]].astype(np.int32)
    length = float(np.linalg.norm(np.diff(truth.points.xyz[ends], axis=0)))
    images = np.arange(0, len(block.images), 3, dtype=np.int32)
    return replace(block, points=replace(block.points, role=role, sigma=sigma, xyz=xyz)).having(
        Distances(start=ends[:1], end=ends[1:], length=np.array([length + 0.01]), sigma=np.array([0.02])),
        Stations(
            image=images, xyz=truth.images.centre[images] + rng.normal(0, 0.1, (len(images), 3)),
            sigma=np.full((len(images), 3), 0.1),
        ),
    )  # fmt: skip


def compared(block: Block, leaf: int, worth: float) -> dict[str, object]:
    """One piece and parts: at the same state, each by itself, and CPU seconds."""
    none = (None,) * len(block.observations)
    given = assemble(block, OPTIONS, np.zeros(len(block.observations), bool), FREE).initial_state()
    t0 = time.process_time()
    one, _ = carry_out(block, OPTIONS, FREE, none)
    t1 = time.process_time()
    with made_by(in_parts(leaf, worth=worth)):
        parts, _ = carry_out(block, OPTIONS, FREE, none)
    t2 = time.process_time()
    assert one.found is not None
    assert parts.found is not None
    at = in_parts(leaf, worth=worth)(one.system, OPTIONS, FREE, np.zeros(len(block.observations), bool))
    steps = []
    for normals in (one.normals, at):
        normals.reduce(given, damping=1e-4)
        trial = normals.trial(given, damping=1e-4)
        assert not isinstance(trial, int)
        normals.reduce(one.state)
        assert normals.factorise() == 0
        steps.append(trial[0].xyz - given.xyz)
    theirs, ours = cofactors(one.normals, one.state, one.datum), cofactors(at, one.state, one.datum)
    tree = at.parts.network.tree
    std = np.sqrt(np.diagonal(theirs.points, axis1=1, axis2=2))
    used = std > 0
    apart, largest = np.abs(theirs.points - ours.points).max(axis=(1, 2)), (std**2).max(axis=1).clip(1e-300)
    return {
        "images": len(block.images), "image points": len(block.observations), "defect": one.datum.defect,
        "leaves": sum(not c for c in tree.children), "tree nodes": len(tree),
        "step": float(np.abs(steps[1] - steps[0]).max() / np.abs(steps[0]).max()),
        "cofactors": float((apart / largest).max()),
        "redundancy numbers": float(np.abs(theirs.hat - ours.hat)[:, :2].max()),
        "redundancy numbers, one piece in another order": own_rounding(one),
        "converged, in sigma": float((np.abs(one.state.xyz - parts.state.xyz)[used] / std[used]).max()),
        "CPU s, one piece": t1 - t0, "CPU s, parts": t2 - t1,
    }  # fmt: skip


def own_rounding(one: Work) -> float:
    """By what redundancy numbers of the one piece differ where its object points stand in another order."""
    block = adjusted_block(one.system, one.state)
    order = np.random.default_rng(2).permutation(len(block.points))
    place = np.argsort(order).astype(np.int32)
    o = block.observations
    turned = replace(
        block, points=block.points.rows(order), observations=replace(o, point=place[o.point])
    ).of_tables(lambda t: t.renumbered("point", place))  # fmt: skip
    found = []
    for b, number in ((block, np.arange(len(order))), (turned, order)):
        system = assemble(b, OPTIONS, np.zeros(len(o), bool), FREE)
        state = system.initial_state()
        datum = analyse(system, state, OPTIONS)
        normals = Normals.of(system, OPTIONS.jobs)
        normals.hold(system.control_held | hold_minimal(system, state, datum))
        normals.reduce(state)
        assert normals.factorise() == 0
        name = number[b.observations.point[system.rows]] * len(b.images) + b.observations.image[system.rows]
        found.append(cofactors(normals, state, datum).hat[np.argsort(name, kind="stable")])
    return float(np.abs(found[0] - found[1])[:, :2].max())


def large(images: int, folder: Path) -> dict[str, object]:
    """A block from columns on disk, in a process of its own; and the one piece of it in another."""
    columns = folder / f"columns{images}"
    if not (columns / "bare.npz").exists():
        block = read("uav", generated("uav", images, 185 * images, folder))
        made = InFiles.of(block, columns)
        np.savez(columns / "bare.npz", **arrays_of_block(made.bare))
    found = dict[str, object]()
    for what in ("stored", "one piece"):
        done = subprocess.run(
            [sys.executable, __file__, "--worker", what, "--large", str(images), "--folder", str(folder)],
            check=True, capture_output=True, text=True,
        )  # fmt: skip
        found[what] = json.loads(done.stdout.splitlines()[-1])
    return found


def worker(what: str, images: int, folder: Path) -> dict[str, object]:
    """One run of a large block."""
    began = time.process_time()
    if what == "one piece":
        block = read("uav", folder / f"uav{images}.npz")
        began = time.process_time()
        found = adjust_block(block, OPTIONS, free=FREE, extent="tests")
        told = {"sigma0": found.sigma0, "redundancy": found.redundancy}
    else:
        columns = folder / f"columns{images}"
        with np.load(columns / "bare.npz") as f:
            bare = block_of_arrays(dict(f))
        with tempfile.TemporaryDirectory(dir=folder) as store:
            made = adjust_columns(InFiles(bare, columns), OPTIONS, FREE, Folder(Path(store)), Serial())
        told = {
            "sigma0": made.sigma0, "redundancy": made.redundancy, "iterations": made.iterations,
            "sum of redundancy numbers less redundancy": made.redundancy_sum - made.redundancy,
            "image points": int(made.network.counts.sum()), "tree nodes": len(made.network.tree),
            "largest front": max(f.size for f in made.network.fronts),
        }  # fmt: skip
    peak = peak_mb()
    return {**told, "CPU s": time.process_time() - began, "peak MB": peak}


RAYS, SEEN = 12, 100
"""Image points of an object point, and of an image, in a made graph"""


def graph(images: int, leaf: int, worth: float) -> dict[str, object]:
    """The graph of a square flight of so many images is made, piece by piece, and cut."""
    side = round(images**0.5)
    count, rng = side * side, np.random.default_rng(1)
    step = np.array([(x, y) for x in range(3) for y in range(4)])

    def pieces() -> Iterator[tuple[Array, Array]]:
        points = count * SEEN // RAYS
        for begin in range(0, points, PIECE // RAYS):
            at = rng.integers(0, [side - 2, side - 3], (min(PIECE // RAYS, points - begin), 2))
            nodes = (at[:, None, 0] + step[:, 0]) * side + at[:, None, 1] + step[:, 1]
            yield np.repeat(np.arange(begin, begin + len(at)), RAYS), nodes.ravel()

    began = time.process_time()
    met = meeting(pieces(), count, np.zeros((0, 2), np.int64))
    made = time.process_time()
    places = np.column_stack([*np.divmod(np.arange(count), side), np.zeros(count)]).astype(float)
    tree = dissect(met, np.full(count, 6), places, leaf, worth)
    return {
        "images": count, "image points": count * SEEN // RAYS * RAYS, "pairs that meet": met.nnz // 2,
        "CPU s, graph": made - began, "CPU s, cut": time.process_time() - made, "tree nodes": len(tree),
        "largest separator, images": max(len(o) for o, c in zip(tree.own, tree.children, strict=True) if c),
        "peak MB": peak_mb(),
    }  # fmt: skip


def main() -> None:
    """Measure, and write the results."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--blocks", nargs="*", default=["uav:1000", "community:500", "street:500"])
    parser.add_argument("--leaf", type=int, default=1000)
    parser.add_argument("--worth", type=float, default=WORTH, help="2: cut as long as leaves are larger than asked for")
    parser.add_argument("--large", type=int, default=0)
    parser.add_argument("--graph", type=int, default=0)
    parser.add_argument("--folder", type=Path, default=HERE / "work/blocking")
    parser.add_argument("--worker", default="")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    if given.worker:
        print(json.dumps(worker(given.worker, given.large, given.folder)))
        return
    out = HERE / "results/blocking.json"
    results = json.loads(out.read_text()) if out.exists() else {}
    for name in given.blocks:
        kind, count = name.split(":")
        path = generated(kind, int(count), 250 * int(count), given.folder)
        block = read(kind, path)
        for variant, made in (("free", block), ("control", with_control(block, read(kind, path, truth=True)))):
            results[f"{kind}{count} {variant}"] = compared(made, given.leaf, given.worth)
            print(f"{kind}{count} {variant}", json.dumps(results[f"{kind}{count} {variant}"]), flush=True)
    if given.graph:
        results[f"graph of {given.graph}"] = graph(given.graph, given.leaf, given.worth)
        print(json.dumps(results[f"graph of {given.graph}"]))
    if given.large:
        results[f"uav{given.large}"] = large(given.large, given.folder)
        print(json.dumps(results[f"uav{given.large}"]))
    out.write_text(json.dumps(results, indent=1) + "\n")


if __name__ == "__main__":
    main()
