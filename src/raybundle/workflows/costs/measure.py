"""Constants of this machine: a made flight is adjusted in parts, made photographs are matched, fronts eliminated."""

from __future__ import annotations

import datetime as dt
import math
import tempfile
import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.adjustment.system.dense import one_thread
from raybundle.block import Block
from raybundle.blocking import front as fronts
from raybundle.blocking.columns import InFiles
from raybundle.blocking.network import Network
from raybundle.blocking.stored import StoredAdjustment, adjust_columns
from raybundle.matching.features import Described, Features, feature_number
from raybundle.matching.methods import feature_method
from raybundle.matching.signatures import COARSE, DESCRIBED, shipped_codebook, signature, widest
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress, silent
from raybundle.pipeline.store import Folder
from raybundle.planning.rendered.ground import gravel_pit
from raybundle.planning.rendered.rendering import View
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import AerialStrips, aerial_scene, brown_camera, look_at
from raybundle.workflows.costs.adjustment import KEPT, KINDS, operations
from raybundle.workflows.costs.constants import REVISION, Constants, Sweep, processor, shipped, version
from raybundle.workflows.costs.photographs import FEATURES
from raybundle.workflows.costs.recording import CountingFolder, Recording, TaskRecord

SWEEP_OF = {
    "up": "up", "down": "down", "inverse": "covariances", "generators": "covariances", "right_up": "covariances",
    "right_down": "covariances", "describe": "statistics", "astray": "statistics", "moments": "statistics",
    "placed": "statistics", "reported": "statistics", "stated": "statistics",
}  # fmt: skip
"""Which sweep a kind of task belongs to"""
FLIGHTS = ((10, 20, 1000, 600), (14, 24, 150, 300))
"""Made flights: strips, images of each, image points of an image, unknowns of a leaf.  One of large parts with as many
image points as in earnest, which no cache holds, and one of many small parts: so what an image point takes and what an
unknown does are distinguished."""
FREE = ("c", "x0", "y0")
"""Parameters of the made flights' camera"""
OPTIONS = AdjustmentOptions(jobs=1, noise="white")
CHILD = 0.8
"""Of a front the part that each of its children touches"""
FRONT = (600, 1200)
"""Own and boundary unknowns of the front that is eliminated: as high in the tree of a flight of 10 000 images"""
PHOTO_PX = (1200, 900)
"""Format of the made photographs"""
FLAT = ("x0", "y0", "K1", "K2", "K3", "P1", "P2")
SIGNATURES = (500, 2000, 2048)
"""Signatures that are compared with how many others, and their length"""
BY_RATIO = (
    "start_point_ms",
    "start_image_ms",
    "precision_point_ms",
    "decisions_point_ms",
    "decisions_image_ms",
    "report_point_ms",
    "report_image_ms",
)
"""Constants that are not measured here, but those shipped by the ratio of what is"""
ROUNDS = 5
"""Of what takes well below a second: the median counts"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Recorded:
    """An adjustment in parts with what each of its tasks took."""

    found: StoredAdjustment
    records: tuple[TaskRecord, ...]
    seconds: float
    """CPU, of all"""
    cutting_s: float
    """CPU before the first task"""
    disk: int
    """bytes at the end"""
    points: int
    """object points"""


def recorded(
    columns: InFiles, free: Mapping[str, tuple[str, ...]], leaf: int, folder: Path, *, keep: int = KEPT
) -> Recorded:
    """Adjust a block in parts, one task after the other, and keep what each took.

    folder  where the store is kept meanwhile
    keep    parts that are held ready for use
    """
    store, doing = CountingFolder(folder), Recording()
    began = time.process_time()
    found = adjust_columns(columns, OPTIONS, free, store, doing, leaf=leaf, keep=keep)
    ended = time.process_time()
    assert doing.begun is not None
    return Recorded(
        found=found, records=tuple(doing.records), seconds=ended - began, cutting_s=doing.begun - began,
        disk=sum(p.stat().st_size for p in folder.rglob("*.npz")), points=columns.points,
    )  # fmt: skip


def made_flight(strips: int, each: int, points: int) -> Block:
    """A flight of one camera with three free parameters, 75 % and 40 % overlap, approximate values."""
    camera = brown_camera(
        values={"c": 50.0, **dict.fromkeys(FLAT, 0.0)}, size_px=(10000, 7500), pixel_mm=0.005,
        estimate=FREE,
    )  # fmt: skip
    plan = AerialStrips(
        camera=camera, strips=strips, images_per_strip=each, points_per_image=points, forward_overlap=0.75,
        side_overlap=0.4,
    )  # fmt: skip
    survey = Survey(image_sigma_px=0.3, points="approximate", approximate=1e-4, interior="exact")
    return simulate(aerial_scene(plan), survey).observed


@dataclass(frozen=True, slots=True, kw_only=True)
class _Dense:
    """What fronts take, CPU nanoseconds: a thousand operations, an element."""

    operation_ns: dict[str, float]
    element_ns: dict[str, float]


def _dense() -> _Dense:
    """A front of two children's messages eliminated, solved and inverted; what is not arithmetic goes by elements."""
    rng = np.random.default_rng(1)
    o, b = FRONT
    n = o + b
    W = rng.normal(0, 1, (n, n))
    N = np.asfortranarray(W @ W.T + n * np.eye(n))
    at = np.sort(rng.choice(n, int(CHILD * n), replace=False))
    message = fronts.packed_at(N, at)
    found: list[list[float]] = []
    for _ in range(ROUNDS):
        e = fronts.Equations(N[:o, :o].copy("F"), N[o:, :o].copy("F"), N[o:, o:].copy("F"), np.ones(n), np.ones(n))
        with tempfile.TemporaryDirectory() as folder:
            store = Folder(Path(folder))
            clock = [time.process_time()]
            store.store("child", {"reduced": message})
            for _ in range(2):
                e.add_reduced(at, Folder(store.path).lent("child")["reduced"])
            clock.append(time.process_time())
            left = fronts.eliminate(e, 0.0)
            clock.append(time.process_time())
            store.store("up", {"L": fronts.packed(left.L), "V": left.V, "y": left.y})
            own = Folder(store.path).lent("up")
            L = fronts.unpacked(own["L"])
            clock.append(time.process_time())
            fronts.solved(L, own["V"], own["y"], np.ones(b))
            clock.append(time.process_time())
            Q = fronts.cofactors(L, own["V"], np.eye(b))
            clock.append(time.process_time())
            store.store("inverse", {"Q": fronts.packed_at(Q, at), "Q too": fronts.packed_at(Q, at)})
            fronts.unpacked(Folder(store.path).lent("inverse", ("Q",))["Q"])
            clock.append(time.process_time())
        found.append(np.diff(clock).tolist())
    assembled, up, kept, solved, inverse, handed = np.median(np.array(found), axis=0).tolist()
    per = 1e9 / n**2
    return _Dense(
        operation_ns={
            "up": 1e12 * up / operations(o, b, "up"), "covariances": 1e12 * inverse / operations(o, b, "covariances")
        },
        element_ns={
            "up": per * (assembled + kept / 2), "down": per * (kept / 2 + solved),
            "covariances": per * (handed + kept / 2),
        },
    )  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Fronts:
    """Sizes of the tree nodes of a network."""

    own: Array
    """(t,) unknowns that each eliminates"""
    size: Array
    """(t,) of its front"""
    points: Array
    """(t,) image points that it reduces"""

    @classmethod
    def of(cls, *networks: Network) -> Fronts:
        """Those of networks, one behind the other."""
        fronts_ = [f for n in networks for f in n.fronts]
        return cls(
            own=np.array([f.columns for f in fronts_], float), size=np.array([f.size for f in fronts_], float),
            points=np.concatenate([n.counts for n in networks]).astype(float),
        )  # fmt: skip

    def operations(self, sweep: str) -> Array:
        """(t,) floating-point operations."""
        pairs = zip(self.own.tolist(), (self.size - self.own).tolist(), strict=True)
        return np.array([operations(o, b, sweep) for o, b in pairs])


def sweep_of(
    records: Iterable[TaskRecord], fronts_: Fronts, sweep: str, *, operation_ns: float, element_ns: float, tasks: int
) -> Sweep:
    """Constants of a sweep by its tasks: least squares without negative ones, tasks weighted by their size.

    tasks  of each tree node when the sweep is done once; the constants are those of all of them together
    """
    count = len(fronts_.size)
    took, times = np.zeros((3, count)), np.zeros(count)
    for r in records:
        took[:, r.node] += r.seconds, r.read, r.written
        times[r.node] += 1
    took *= tasks / times
    done = operation_ns * 1e-12 * fronts_.operations(sweep)
    done += 1e-9 * element_ns * fronts_.size**2
    seconds = _without_negative(np.column_stack([np.ones(count), fronts_.points]), np.maximum(took[0] - done, 0.0))
    known = np.column_stack([np.ones(count), fronts_.points, fronts_.size**2])
    read, written = (_without_negative(known, values, even=True) for values in took[1:])
    return Sweep(
        task_s=seconds[0], point_us=1e6 * seconds[1], element_ns=element_ns, operation_ns=operation_ns,
        read_point=read[1], read_element=read[2], written_point=written[1], written_element=written[2],
    )  # fmt: skip


def _without_negative(known: Array, values: Array, *, even: bool = False) -> list[float]:
    """Least squares with no negative unknown (Lawson and Hanson 1974).

    What a task takes varies with its size: weights by what is known of it, not by what it took, keep the sum.

    even  all weights alike: bytes do not vary
    """
    from scipy.optimize import nnls

    scale = np.ones(len(values)) if even else 1 / np.sqrt((known / known.max(axis=0)).mean(axis=1))
    columns = known * scale[:, None]
    norm = np.linalg.norm(columns, axis=0)
    found, _ = nnls(columns / norm, values * scale)
    return (found / norm).tolist()


@dataclass(frozen=True, slots=True, kw_only=True)
class _Matched:
    """What photographs take before approximate values."""

    feature_mpx_s: float
    nearest_s: float
    signature_s: float
    likeness_ns: float
    compare_ms: float


def _matched() -> _Matched:
    """Features of two made photographs of one place, their signatures, a comparison, a pair."""
    method = feature_method("rootsift")
    grey = _photographs()
    height, width = grey[0].shape
    count = feature_number(width, height, FEATURES)
    found: list[Features] = []
    seconds: list[float] = []
    for picture in grey:
        began = time.process_time()
        found.append(method.detect(picture, count))
        seconds.append(time.process_time() - began)
    words = shipped_codebook(method.codebook).words
    described = [Described(xy_px=f.xy_px, descriptors=f.descriptors, size_px=(width, height)) for f in found]
    signatures = np.random.default_rng(1).normal(0, 1, SIGNATURES[1:]).astype(np.float32)
    wide = found[0].descriptors[widest(found[0], DESCRIBED)]
    coarse = [f.descriptors[widest(f, COARSE)] for f in found]

    return _Matched(
        feature_mpx_s=min(seconds) / (width * height / 1e6),
        nearest_s=_median(lambda: method.match(described[0], described[1])) / (len(found[0]) * len(found[1]) / 1e6),
        signature_s=_median(lambda: signature(method.vectors(wide), words)),
        likeness_ns=1e12 * _median(lambda: signatures[:SIGNATURES[0]] @ signatures.T) / (2 * math.prod(SIGNATURES)),
        compare_ms=1e3 * _median(lambda: method.shared(coarse[0], coarse[1])),
    )  # fmt: skip


def _photographs() -> list[Array]:
    """Two grey pictures of a made ground, 80 % in common."""
    camera = brown_camera(size_px=PHOTO_PX, pixel_mm=0.0073, values={"c": 8.62, **dict.fromkeys(FLAT, 0.0)})
    ground = gravel_pit((70.0, 60.0))
    found: list[Array] = []
    for k, x in enumerate((-4.0, 4.0)):
        centre = np.array([x, 0.0, 42.0])
        rotation = look_at(centre, centre - [0, 0, 1.0], up=np.array([0.0, 1.0, 0.0]))[0]
        view = View(name=f"{k}", camera=camera, centre=centre, rotation=rotation)
        found.append(ground.photograph(view, np.random.default_rng(k)).mean(axis=2).astype(np.uint8))
    return found


def _median(work: Callable[[], object]) -> float:
    """CPU seconds, as often as not."""
    found: list[float] = []
    for _ in range(ROUNDS):
        began = time.process_time()
        work()
        found.append(time.process_time() - began)
    return float(np.median(found))


def _flown(strips: int, each: int, points: int, leaf: int) -> Recorded:
    """A made flight, adjusted; no part stays ready, as where there are many."""
    block = made_flight(strips, each, points)
    with tempfile.TemporaryDirectory() as folder:
        columns = InFiles.of(block, Path(folder) / "columns")
        free = {block.cameras[0].id: FREE}
        return recorded(columns, free, leaf, Path(folder) / "store", keep=1)


def measure(progress: Progress = silent) -> Constants:
    """The constants of this machine, some half a minute of one processor.

    What is not measured here, as what photographs take after matching, is that of the shipped constants, by the ratio
    of what is measured of both.  Memory and bytes are those shipped: they are the program's, not the machine's.
    """
    reference = shipped()
    with one_thread():
        progress("measuring", 0.0)
        matched = _matched()
        progress("measuring", 0.3)
        dense = _dense()
        progress("measuring", 0.4)
        runs = [_flown(*flight) for flight in FLIGHTS]
    sizes = Fronts.of(*(r.found.network for r in runs))
    begin = np.cumsum([0, *(len(r.found.network.tree) for r in runs)]).tolist()
    records = [replace(t, node=t.node + b) for r, b in zip(runs, begin[:-1], strict=True) for t in r.records]
    sweeps: dict[str, Sweep] = {}
    for sweep, tasks in KINDS.items():
        mine = [r for r in records if SWEEP_OF.get(r.name) == sweep]
        rate, each = dense.operation_ns.get(sweep, 0.0), dense.element_ns.get(sweep, 0.0)
        own: Sweep = sweep_of(mine, sizes, sweep, operation_ns=rate, element_ns=each, tasks=tasks)
        of: Sweep = getattr(reference, sweep)
        sweeps[sweep] = replace(
            of, task_s=own.task_s, point_us=own.point_us, element_ns=each, operation_ns=rate
        )  # fmt: skip
    large = runs[0]
    points = float(large.found.network.counts.sum())
    driver = sum(r.seconds - r.cutting_s - sum(t.seconds for t in r.records) for r in runs)
    slower = float(
        np.sqrt(sweeps["up"].point_us / reference.up.point_us * matched.feature_mpx_s / reference.feature_mpx_s)
    )
    progress("measuring", 1.0)
    day = dt.datetime.now(dt.UTC).date().isoformat()
    return replace(
        reference, processor=processor(), version=version(), revision=REVISION,
        measured=f"{day}; verification, start, precision, decisions and report by ratio to {reference.processor}",
        **sweeps,
        cutting_point_us=1e6 * large.cutting_s / (points * math.log2(points)),
        driver_task_ms=1e3 * max(driver, 0.0) / len(records),
        feature_mpx_s=matched.feature_mpx_s, nearest_s=matched.nearest_s, signature_s=matched.signature_s,
        likeness_ns=matched.likeness_ns, compare_ms=matched.compare_ms, verify_ms=slower * reference.verify_ms,
        **{name: slower * getattr(reference, name) for name in BY_RATIO},
    )  # fmt: skip
