"""Least-squares matching of photographs as tasks: the pairs of images whose references lie in one leaf are one task.

Which pairs stand together changes nothing of what is measured in them; it states what a killed run loses, and which
photographs a worker has to read.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from threading import Lock

import numpy as np

from raybundle.errors import InputError
from raybundle.io.photos.photo import Photo
from raybundle.matching.least_squares import FIGURES
from raybundle.matching.refine import (
    LEVELS,
    CandidateMatches,
    Candidates,
    TrackPoints,
    match_candidates,
    pyramid,
    smoothed,
)
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.rows import rows_of_each
from raybundle.orientation.image_leaves import leaves_of
from raybundle.pipeline.executors import Threads
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from raybundle.ties.points import grey_of

VERSION = 4
KINDS = ("candidates", "windows")
"""First words of the keys of what is kept"""
SMALLEST, LARGEST, SHARE = 2, 16, 16
"""Photographs of a leaf: a sixteenth of all, within these limits.  Few tasks show no progress; small ones of a large
set read each photograph often where workers share no memory."""
WINDOW_S = 4e-4
"""CPU seconds of a candidate, for the order and the time that is left."""
ELSEWHERE = 1e9
"""Bytes of pixels that a worker elsewhere holds: a photograph of 24 megapixels and those around it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class WindowTask:
    """Candidates that are looked for in some photographs."""

    photos: tuple[Photo, ...]
    """those that take part; images are numbered among them"""
    candidates: str
    """key of the candidates and of the track points of these photographs"""
    memory: float
    """bytes of pixels that may be held; what is measured does not depend on it, nor on the threads"""
    threads: int


def matched(means: Means, photos: Sequence[Photo], points: TrackPoints, wanted: Candidates) -> CandidateMatches:
    """What least-squares matching finds at the candidates, by tasks; as `matching.refine.match_candidates`.

    raises  InputError for a photograph that can no longer be read
    """
    k = len(wanted.image)
    found = CandidateMatches(
        good=np.zeros(k, bool), xy_px=wanted.xy_px.copy(), cov_px2=np.zeros((k, 3)), correlation=np.zeros(k),
        level=np.full(k, LEVELS), window_px=np.full(k, np.nan), residual=np.zeros((k, FIGURES)),
    )  # fmt: skip
    n = len(photos)
    most = min(max(n // SHARE, SMALLEST), LARGEST)
    leaves = leaves_of(points.image, points.point, n, int(points.point.max(initial=-1)) + 1, most)
    leaf = np.zeros(n, int)
    for number, each in enumerate(leaves):
        leaf[each.own] = number
    of = leaf[points.image[wanted.reference]]
    groups = [rows for rows in rows_of_each(of, len(leaves)) if len(rows)]
    rows_of_image = rows_of_each(points.image, n)
    here = isinstance(means.executor, Threads)
    threads = max(1, means.jobs // max(len(groups), 1)) if here else 1
    tasks: list[Task] = []
    for rows in groups:
        used, arrays = _taken(points, rows_of_image, wanted.rows(rows))
        own = tuple(photos[i] for i in used.tolist())
        inputs = key_of("candidates", VERSION, arrays)
        if not means.store.has(inputs):
            means.store.store(inputs, arrays)
        options = WindowTask(
            photos=own, candidates=inputs, memory=means.memory if here else min(means.memory, ELSEWHERE),
            threads=threads,
        )  # fmt: skip
        tasks.append(
            Task(
                key=key_of("windows", VERSION, [p.sha256 for p in own], inputs), function=f"{__name__}:windows_of",
                options=options, inputs=(inputs,), cost=len(rows) * WINDOW_S, memory=0 if here else options.memory,
                name=f"{own[0].name} and {len(own) - 1} around it",
            )
        )  # fmt: skip
    for reason in means.do(tasks, "least-squares matching").values():
        raise InputError(reason)
    for task, rows in zip(tasks, groups, strict=True):
        product = means.store.wanted(task.key)
        found.xy_px[rows], found.cov_px2[rows] = product["xy_px"], product["cov_px2"]
        found.correlation[rows], found.level[rows] = product["correlation"], product["level"]
        found.window_px[rows], found.residual[rows] = product["window_px"], product["residual"]
    return replace(found, good=found.level < LEVELS)


def _taken(
    points: TrackPoints, rows_of_image: Sequence[Index], wanted: Candidates
) -> tuple[Index, dict[str, Array]]:  # fmt: skip
    """The images that candidates need, ascending, and the candidates with all track points of these images."""
    used = np.union1d(points.image[wanted.reference], wanted.image)
    mine = np.sort(np.concatenate([rows_of_image[i] for i in used.tolist()]))
    arrays = {
        "image": np.searchsorted(used, points.image[mine]).astype(np.int32), "point": points.point[mine],
        "xy_px": points.xy_px[mine], "scale_px": points.scale_px[mine], "angle": points.angle[mine],
        "of.reference": np.searchsorted(mine, wanted.reference),
        "of.image": np.searchsorted(used, wanted.image).astype(np.int32), "of.point": wanted.point,
        "of.xy_px": wanted.xy_px, "of.row": np.where(wanted.row < 0, -1, np.searchsorted(mine, wanted.row)),
    }  # fmt: skip
    if wanted.coarsest is not None:
        arrays["of.coarsest"] = wanted.coarsest
    return used, arrays


def windows_of(store: Folder, task: WindowTask) -> Product:
    """The task: candidates looked for by least-squares matching."""
    a = store.wanted(task.candidates)
    of = {name.removeprefix("of."): values for name, values in a.items() if name.startswith("of.")}
    points = TrackPoints(**{name: values for name, values in a.items() if not name.startswith("of.")})
    greys.bound(task.memory)
    found = match_candidates(
        points, Candidates(**of), lambda i, level: greys.of(task.photos[i], level), threads=task.threads
    )
    return {
        "xy_px": found.xy_px, "cov_px2": found.cov_px2, "correlation": found.correlation,
        "level": found.level.astype(np.int8), "window_px": found.window_px.astype(np.float32),
        "residual": found.residual.astype(np.float32),
    }  # fmt: skip


@dataclass(slots=True)
class Greys:
    """Smoothed photographs with their pyramids, the latest used ones within a limit of memory."""

    limit: float = ELSEWHERE
    """bytes"""
    held: OrderedDict[str, tuple[Array, ...]] = field(default_factory=OrderedDict[str, tuple[Array, ...]])
    lock: Lock = field(default_factory=Lock)

    def of(self, photo: Photo, level: int) -> Array:
        """A photograph at a level of its pyramid, uint16."""
        with self.lock:
            if photo.sha256 in self.held:
                self.held.move_to_end(photo.sha256)
                return self.held[photo.sha256][level]
        levels = pyramid(smoothed(grey_of(photo)))
        with self.lock:
            self.held[photo.sha256] = levels
            self._let_go()
        return levels[level]

    def bound(self, limit: float) -> None:
        """Hold so many bytes from now on."""
        with self.lock:
            self.limit = limit
            self._let_go()

    def _let_go(self) -> None:
        while len(self.held) > 2 and sum(a.nbytes for p in self.held.values() for a in p) > self.limit:
            self.held.popitem(last=False)

    def forget(self) -> None:
        """Let go of all of them."""
        with self.lock:
            self.held.clear()


greys = Greys()
"""Those of this process: tasks that follow each other read the same photographs."""
