"""From photographs to tracks: features, pairs and verification, kept in the project as they are finished."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from raybundle.errors import InputError, NoOrientation
from raybundle.io.photos.cameras import camera_groups
from raybundle.io.photos.masks import Masks
from raybundle.io.photos.photo import Photo, read_grey, stored_from_upright, upright, upright_from_stored
from raybundle.io.project import Project, Stage, key_of
from raybundle.matching.features import Described, FeatureMethod, Features, feature_number
from raybundle.matching.pairs import ALL, choose_pairs, codebook, signature
from raybundle.matching.verify import VerifiedPair, beyond_chance, verify
from raybundle.numerics.arrays import Array
from raybundle.numerics.counting import counted
from raybundle.numerics.progress import Progress

VERIFICATION = 4
"""Raised with every change of what matching and verification give."""
SAVE_EVERY_S = 2.0
HELD = 400_000
"""Features whose vectors are held in memory while pairs are matched: 200 MB."""
SCALES = np.linspace(-1.0, 1.0, 33)
"""Camera constants tried, in standard deviations about the one that the photographs state."""
MOST_MASKED = 8.0
"""Times as many features as are wanted that are looked for where most of a photograph is masked."""


def feature_key(photo: Photo, method: FeatureMethod, count: int, mask: str = "") -> str:
    """What the features of a photograph depend on; `mask`: the content of its mask."""
    return key_of("features", photo.sha256, method.name, method.version, count, *([mask] if mask else []))


def feature_count(photo: Photo, most: int) -> int:
    """Features of a photograph."""
    return feature_number(photo.width_px, photo.height_px, most)


def grey_of(photo: Photo) -> Array:
    """Grey values, uint8; 16 bits are stretched between their 0.1 and 99.9 percentiles."""
    grey = read_grey(photo)
    if grey.dtype == np.uint8:
        return grey
    low, high = np.percentile(grey[::4, ::4], [0.1, 99.9])
    return np.clip((grey.astype(np.float32) - low) * (255 / max(high - low, 1)), 0, 255).astype(np.uint8)


def detected(method: FeatureMethod, photo: Photo, count: int, masks: Masks | None = None) -> Features:
    """Features in the photograph as stored; a method that knows no directions finds them in the upright picture.

    None of them, with the surroundings that it is found in, reaches into the photograph's mask.
    """
    free = None if masks is None else masks.of(photo)
    if masks is None or free is None:
        return _detected(method, photo, count)
    share = max(float(free.mean()), 1 / MOST_MASKED)
    found = _detected(method, photo, int(count / share))
    return found.rows(np.flatnonzero(masks.visible(photo, found.xy_px, found.scale_px))[:count])


def _detected(method: FeatureMethod, photo: Photo, count: int) -> Features:
    grey = grey_of(photo)
    if not method.upright:
        return method.detect(grey, count)
    f = method.detect(upright(grey, photo.orientation), count)
    xy = stored_from_upright(f.xy_px, photo)
    right = stored_from_upright(f.xy_px + np.column_stack([np.cos(f.angle), np.sin(f.angle)]), photo) - xy
    return replace(f, xy_px=xy, angle=np.arctan2(right[:, 1], right[:, 0]))


@dataclass(frozen=True, slots=True)
class FeatureStore:
    """Features of photographs, read from the project when they are asked for."""

    project: Project
    keys: tuple[str, ...]

    def of(self, i: int) -> Features:
        """The features of photograph i."""
        a = self._loaded(i)
        return Features(xy_px=a["xy_px"], scale_px=a["scale_px"], angle=a["angle"], descriptors=a["descriptors"])

    def places(self, i: int) -> Features:
        """The same without descriptors, which take nine tenths of the memory."""
        a = self._loaded(i, "xy_px", "scale_px", "angle")
        none = np.zeros((len(a["xy_px"]), 0), np.uint8)
        return Features(xy_px=a["xy_px"], scale_px=a["scale_px"], angle=a["angle"], descriptors=none)

    def _loaded(self, i: int, *names: str) -> dict[str, Array]:
        found = self.project.load(self.keys[i], names)
        if found is None:
            raise InputError(
                "a product of the features stage is damaged or gone; run the same command again",
                file=self.project.folder,
            )
        return found


def stored_features(
    project: Project, keys: Sequence[str], find: Callable[[int], Features], paths: Sequence[Path], jobs: int,
    progress: Progress,
) -> tuple[dict[int, str], bool]:  # fmt: skip
    """Find and store the features that the project lacks; which images failed and why, and whether none was lacking."""
    missing = [i for i, key in enumerate(keys) if not project.has(key)]
    failed: dict[int, str] = {}

    def work(i: int) -> str:
        try:
            f = find(i)
        except InputError as error:
            return str(error).removeprefix(f"{paths[i]}: ")
        project.store(
            keys[i], {"xy_px": f.xy_px, "scale_px": f.scale_px, "angle": f.angle, "descriptors": f.descriptors}
        )
        return ""

    with ThreadPoolExecutor(jobs) as pool:
        for k, (i, reason) in enumerate(zip(missing, pool.map(work, missing), strict=True)):
            progress("features", (k + 1) / len(missing))
            if reason:
                failed[i] = reason
    return failed, not missing


def find_features(
    project: Project,
    stage: Stage,
    photos: Sequence[Photo],
    method: FeatureMethod,
    count: int,
    jobs: int,
    progress: Progress,
    masks: Masks | None = None,
) -> tuple[FeatureStore, dict[int, str]]:
    """Features of every photograph; also the photographs whose pixels could not be read, with the reason."""
    counts = [feature_count(p, count) for p in photos]
    worn = ["" if masks is None else masks.key(p) for p in photos]
    keys = tuple(feature_key(p, method, n, m) for p, n, m in zip(photos, counts, worn, strict=True))
    stage.key = key_of("features", keys)
    failed, stage.from_cache = stored_features(
        project, keys, lambda i: detected(method, photos[i], counts[i], masks), [p.path for p in photos], jobs, progress
    )
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

    each = len(store.places(todo[0][1]).xy_px) if todo else 1

    @lru_cache(maxsize=max(4 * jobs + 2, HELD // max(each, 1)))
    def loaded(i: int) -> tuple[Array, Described]:
        f, photo = store.of(i), photos[i]
        xy = upright_from_stored(f.xy_px, photo)
        return f.xy_px, Described(xy_px=xy, descriptors=f.descriptors, size_px=photo.upright_size)

    def work(task: tuple[str, int, int]) -> tuple[str, VerifiedPair]:
        key, i, j = task
        (xy1, first), (xy2, second) = loaded(i), loaded(j)
        return key, verify(i, j, xy1, xy2, method.match(first, second), sizes[i], sizes[j])

    waiting: list[tuple[str, dict[str, Any], Array]] = []
    saved = time.perf_counter()
    found: dict[str, VerifiedPair] = {}
    with ThreadPoolExecutor(jobs) as pool:
        for n, (key, pair) in enumerate(_in_order(pool, work, todo, 4 * jobs)):
            found[key] = pair
            facts = {
                "candidates": pair.candidates, "geometry": pair.geometry, "planar_share": pair.planar_share,
                "displacement_px": pair.displacement_px, "log_chance": pair.log_chance,
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
    result = beyond_chance(result)
    good = sum(1 for p in result if len(p.matches))
    stage.summary = f"{counted(len(pairs), 'pair')}, {good} verified"
    if good and from_one_spot(result, photos, store):
        raise NoOrientation(
            f"the {good} pairs of photographs that match differ by a turn of the camera only: they were taken from "
            "one spot, and without a base there is no depth.\n"
            "  Take the photographs from different places: move sideways between them, by a tenth of the distance "
            "to the object or more."
        )
    # a copy of a photograph, or one more from the same place: points that only these two show have no depth
    return [replace(p, matches=p.matches[:0]) if p.geometry == "rotation" else p for p in result]


def from_one_spot(pairs: Sequence[VerifiedPair], photos: Sequence[Photo], store: FeatureStore) -> bool:
    """Whether a mere turn of the camera explains every pair that matches, within a thousandth of the format.

    What is left beside the turn is all that there is to tell depth from.  The camera constant may lie anywhere
    within one standard deviation of what the photographs state; strong distortion hides what this looks for.
    """
    groups = camera_groups(photos)
    own = {i: g for g in groups for i in g.photos}
    alive = np.ones(len(SCALES), bool)
    for pair in pairs:
        if not len(pair.matches):
            continue
        ends = ((pair.first, pair.matches[:, 0]), (pair.second, pair.matches[:, 1]))
        some = slice(None, None, max(1, len(pair.matches) // 300))
        xy = [store.places(i).xy_px[rows[some]] - (photos[i].width_px / 2, photos[i].height_px / 2) for i, rows in ends]
        for k in np.flatnonzero(alive):
            c = [own[i].c_px + SCALES[k] * own[i].sigma_c_px for i, _ in ends]
            limit = float(np.hypot(photos[pair.first].width_px, photos[pair.first].height_px)) / 1000
            alive[k] = min(c) > 0 and _beside_a_turn(xy[0], xy[1], c[0], c[1]) < max(limit, 1.0)
        if not alive.any():
            return False
    return bool(alive.any())


def _beside_a_turn(xy1: Array, xy2: Array, c1: float, c2: float) -> float:
    """Median [px] of what the best rotation between two bundles of rays leaves (Arun et al. 1987), wrong ones apart."""
    a, b = (np.column_stack([xy, np.full(len(xy), c)]) for xy, c in ((xy1, c1), (xy2, c2)))
    a /= np.linalg.norm(a, axis=1, keepdims=True)
    b /= np.linalg.norm(b, axis=1, keepdims=True)
    keep, apart = np.ones(len(a), bool), np.zeros(len(a))
    for _ in range(3):
        u, _, vt = np.linalg.svd(b[keep].T @ a[keep])
        R = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt
        apart = np.linalg.norm(b - a @ R.T, axis=1)
        keep = apart <= np.quantile(apart, 0.8)
    return float(np.median(apart)) * c2


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
