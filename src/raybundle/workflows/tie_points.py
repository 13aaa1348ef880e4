"""From photographs to tracks: features, pairs and verification, kept in the project as they are finished."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.io.photos.photo import Photo, read_grey
from raybundle.io.project import Project, Stage, key_of
from raybundle.matching.descriptors import mutual_matches
from raybundle.matching.features import FeatureMethod, Features
from raybundle.matching.pairs import ALL, choose_pairs, codebook, signature
from raybundle.matching.verify import VerifiedPair, verify
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress

VERIFICATION = 1
"""Raised with every change of what matching and verification give."""
SAVE_EVERY_S = 2.0
PIXELS_EACH = 400
"""Pixels of a photograph for each feature."""


def feature_key(photo: Photo, method: FeatureMethod, count: int) -> str:
    """What the features of a photograph depend on."""
    return key_of("features", photo.sha256, method.name, method.version, count)


def feature_count(photo: Photo, most: int) -> int:
    """Features of a photograph: so many that the windows by which they are measured hardly overlap.

    Measurements from the same pixels are not independent, and their number would promise too much precision.
    """
    return min(most, max(500, int(photo.width_px * photo.height_px / PIXELS_EACH)))


def grey_of(photo: Photo) -> Array:
    """Grey values, uint8; 16 bits are stretched between their 0.1 and 99.9 percentiles."""
    grey = read_grey(photo)
    if grey.dtype == np.uint8:
        return grey
    low, high = np.percentile(grey[::4, ::4], [0.1, 99.9])
    return np.clip((grey.astype(np.float32) - low) * (255 / max(high - low, 1)), 0, 255).astype(np.uint8)


@dataclass(frozen=True, slots=True)
class FeatureStore:
    """Features of photographs, read from the project when they are asked for."""

    project: Project
    keys: tuple[str, ...]

    def of(self, i: int) -> Features:
        """The features of photograph i."""
        a = self.project.load(self.keys[i])
        if a is None:
            raise InputError(
                "a product of the features stage is damaged or gone; run the same command again",
                file=self.project.folder,
            )
        return Features(xy_px=a["xy_px"], scale_px=a["scale_px"], angle=a["angle"], descriptors=a["descriptors"])


def find_features(
    project: Project,
    stage: Stage,
    photos: Sequence[Photo],
    method: FeatureMethod,
    count: int,
    jobs: int,
    progress: Progress,
) -> tuple[FeatureStore, dict[int, str]]:
    """Features of every photograph; also the photographs whose pixels could not be read, with the reason."""
    counts = [feature_count(p, count) for p in photos]
    keys = tuple(feature_key(p, method, n) for p, n in zip(photos, counts, strict=True))
    missing = [i for i, key in enumerate(keys) if not project.has(key)]
    stage.key = key_of("features", keys)
    stage.from_cache = not missing
    failed: dict[int, str] = {}

    def work(i: int) -> str:
        try:
            f = method.detect(grey_of(photos[i]), counts[i])
        except InputError as error:
            return str(error)
        project.store(
            keys[i], {"xy_px": f.xy_px, "scale_px": f.scale_px, "angle": f.angle, "descriptors": f.descriptors}
        )
        return ""

    with ThreadPoolExecutor(jobs) as pool:
        for k, (i, reason) in enumerate(zip(missing, pool.map(work, missing), strict=True)):
            progress("features", (k + 1) / len(missing))
            if reason:
                failed[i] = reason
    stage.summary = f"{len(photos) - len(failed)} photographs"
    return FeatureStore(project, keys), failed


def match_pairs(
    project: Project,
    stage: Stage,
    photos: Sequence[Photo],
    store: FeatureStore,
    method: FeatureMethod,
    pairs: Sequence[tuple[int, int]],
    jobs: int,
    progress: Progress,
) -> list[VerifiedPair]:
    """Matched and verified pairs; those that the project holds already are not matched again."""
    sizes = [(p.width_px, p.height_px) for p in photos]
    keys = [key_of("pair", VERIFICATION, store.keys[i], store.keys[j]) for i, j in pairs]
    known = project.pairs(keys)
    todo = [(k, i, j) for k, (i, j) in zip(keys, pairs, strict=True) if k not in known]
    stage.key = key_of("matching", keys)
    stage.from_cache = not todo

    @lru_cache(maxsize=96)
    def loaded(i: int) -> tuple[Array, Array]:
        f = store.of(i)
        return f.xy_px, method.vectors(f.descriptors)

    def work(task: tuple[str, int, int]) -> tuple[str, VerifiedPair]:
        key, i, j = task
        (xy1, v1), (xy2, v2) = loaded(i), loaded(j)
        matches, _ = mutual_matches(v1, v2)
        return key, verify(i, j, xy1, xy2, matches, sizes[i], sizes[j])

    waiting: list[tuple[str, dict[str, Any], Array]] = []
    saved = time.perf_counter()
    found: dict[str, VerifiedPair] = {}
    with ThreadPoolExecutor(jobs) as pool:
        for n, (key, pair) in enumerate(_in_order(pool, work, todo, 4 * jobs)):
            found[key] = pair
            facts = {
                "candidates": pair.candidates, "geometry": pair.geometry, "planar_share": pair.planar_share,
                "displacement_px": pair.displacement_px,
            }  # fmt: skip
            waiting.append((key, facts, pair.matches))
            progress("matching", (n + 1) / len(todo))
            if time.perf_counter() - saved > SAVE_EVERY_S:
                project.store_pairs(waiting)
                waiting, saved = [], time.perf_counter()
    if waiting:
        project.store_pairs(waiting)
    result: list[VerifiedPair] = []
    for key, (i, j) in zip(keys, pairs, strict=True):
        if key in found:
            result.append(found[key])
        else:
            facts, matches = known[key]
            result.append(VerifiedPair(first=i, second=j, matches=matches, **facts))
    good = sum(1 for p in result if len(p.matches))
    stage.summary = f"{len(pairs)} pairs, {good} verified"
    return result


def _in_order(pool: ThreadPoolExecutor, work: Callable[[Any], Any], tasks: Sequence[Any], ahead: int) -> Any:
    """Results in the order of the tasks, with only so many tasks ahead in work: memory stays bounded."""
    from collections import deque  # noqa: PLC0415

    waiting: deque[Any] = deque()
    for task in tasks:
        waiting.append(pool.submit(work, task))
        if len(waiting) >= ahead:
            yield waiting.popleft().result()
    while waiting:
        yield waiting.popleft().result()


def pairs_of(
    photos: Sequence[Photo], store: FeatureStore, method: FeatureMethod, positions: Array | None, progress: Progress
) -> list[tuple[int, int]]:
    """The pairs to match; for large sets by sequence, position and content."""
    if len(photos) <= ALL:
        return choose_pairs(len(photos))
    samples: list[Array] = []
    for i in range(len(photos)):
        samples.append(method.vectors(store.of(i).descriptors[:400]))
        progress("choosing pairs", (i + 1) / len(photos))
    words = codebook(samples)
    signatures = np.stack([signature(s, words) for s in samples])
    return choose_pairs(len(photos), positions=positions, signatures=signatures)
