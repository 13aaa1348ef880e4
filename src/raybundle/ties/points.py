"""From photographs to tracks: features, pairs and verification, kept in the project as they are finished."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from typing import overload

import numpy as np

from raybundle.errors import InputError, NoOrientation, without_file
from raybundle.io.photos.cameras import camera_groups
from raybundle.io.photos.masks import MaskFile, Masks
from raybundle.io.photos.photo import Photo, PhotoFormat, read_grey, stored_from_upright, upright, upright_from_stored
from raybundle.matching.features import Described, FeatureMethod, Features, feature_number
from raybundle.matching.methods import feature_method
from raybundle.matching.tracks import Tracks
from raybundle.matching.verify import VerifiedPair, beyond_chance, verify
from raybundle.numerics.arrays import Array
from raybundle.numerics.rows import rows_of_each
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task

VERIFICATION = 5
"""Raised with every change of what matching and verification give."""
PIXELS_A_SECOND, PAIR_S = 25e6, 0.07
"""Of feature detection, and of matching a pair: for the order of tasks and the time that is left."""
SCALES = np.linspace(-1.0, 1.0, 33)
"""Camera constants tried, in standard deviations about the one that the photographs state."""
MOST_MASKED = 8.0
"""Times as many features as are wanted that are looked for where most of a photograph is masked."""


def feature_key(photo: Photo, method: FeatureMethod, count: int, mask: str = "") -> str:
    """What the features of a photograph depend on; `mask`: the content of its mask."""
    return key_of("features", photo.sha256, *method.content, count, *([mask] if mask else []))


def feature_count(photo: Photo, most: int) -> int:
    """Features of a photograph."""
    return feature_number(photo.width_px, photo.height_px, most)


def grey_of(photo: Photo) -> Array:
    """Grey values, uint8; 16 bits are stretched between their 0.1 and 99.9 percentiles."""
    return np.clip(exact_grey_of(photo), 0, 255).astype(np.uint8)


def exact_grey_of(photo: Photo) -> Array:
    """The same without rounding, float32 of 16 bits, whose noise rounding may hide; what is brighter stays so."""
    grey = read_grey(photo)
    if grey.dtype == np.uint8:
        return grey
    low, high = np.percentile(grey[::4, ::4], [0.1, 99.9])
    return (grey.astype(np.float32) - np.float32(low)) * np.float32(255 / max(high - low, 1))


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
    """Features of photographs, read when they are asked for."""

    store: Folder
    keys: tuple[str, ...]

    @property
    def content(self) -> tuple[str, ...]:
        """What they are known by."""
        return self.keys

    def of(self, i: int) -> Features:
        """The features of photograph i."""
        return features_from(self._loaded(i))

    def places(self, i: int) -> Features:
        """The same without descriptors, which take nine tenths of the memory."""
        a = self._loaded(i, "xy_px", "scale_px", "angle")
        return features_from({**a, "descriptors": np.zeros((len(a["xy_px"]), 0), np.uint8)})

    def rows(self, index: Sequence[int]) -> FeatureStore:
        """Those of some photographs."""
        return FeatureStore(self.store, tuple(self.keys[i] for i in index))

    def count(self, i: int) -> int:
        """How many photograph i has."""
        return len(self._loaded(i, "angle")["angle"])

    def xy_px(self) -> Sequence[Array]:
        """(n, 2) where those of each photograph lie, read anew whenever they are asked for."""
        return _StoredPlaces(self)

    def of_tracks(self, tracks: Tracks) -> Features:
        """Those of tracks, row by row, without descriptors; one photograph in memory at a time."""
        m = len(tracks.image)
        xy, scale, angle = np.empty((m, 2)), np.empty(m), np.empty(m)
        for i, mine in enumerate(rows_of_each(tracks.image, len(self.keys))):
            if len(mine):
                f = self.places(i).rows(tracks.feature[mine])
                xy[mine], scale[mine], angle[mine] = f.xy_px, f.scale_px, f.angle
        return Features(xy_px=xy, scale_px=scale, angle=angle, descriptors=np.zeros((m, 0), np.uint8))

    def _loaded(self, i: int, *names: str) -> dict[str, Array]:
        return self.store.wanted(self.keys[i], names)


@dataclass(frozen=True, slots=True)
class _StoredPlaces(Sequence[Array]):
    """Where the features of photographs lie, read when one is asked for."""

    features: FeatureStore

    def __len__(self) -> int:
        return len(self.features.keys)

    @overload
    def __getitem__(self, index: int) -> Array: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Array]: ...
    def __getitem__(self, index: int | slice) -> Array | Sequence[Array]:
        if isinstance(index, slice):
            return _StoredPlaces(FeatureStore(self.features.store, self.features.keys[index]))
        return self.features.store.wanted(self.features.keys[index], ("xy_px",))["xy_px"]


def features_from(a: Product) -> Features:
    """Features of their arrays."""
    return Features(xy_px=a["xy_px"], scale_px=a["scale_px"], angle=a["angle"], descriptors=a["descriptors"])


def arrays_of_features(f: Features) -> dict[str, Array]:
    """Features as they are kept."""
    return {"xy_px": f.xy_px, "scale_px": f.scale_px, "angle": f.angle, "descriptors": f.descriptors}


@dataclass(frozen=True, slots=True, kw_only=True)
class FeaturesTask:
    """What the features of a photograph are made of."""

    photo: Photo
    method: str
    count: int
    mask: MaskFile | None = None


def features_of(store: Folder, task: FeaturesTask) -> Product:
    """The task: features of one photograph."""
    del store
    masks = None if task.mask is None else Masks(photos=(task.photo,), files={task.photo.name: task.mask})
    return arrays_of_features(detected(feature_method(task.method), task.photo, task.count, masks))


def find_features(
    means: Means, photos: Sequence[Photo], method: FeatureMethod, count: int, masks: Masks | None = None
) -> tuple[FeatureStore, dict[int, str]]:
    """Features of every photograph; also the photographs whose pixels could not be read, with the reason."""
    counts = [feature_count(p, count) for p in photos]
    worn = ["" if masks is None else masks.key(p) for p in photos]
    tasks = [
        Task(
            key=feature_key(p, method, n, m), function=f"{__name__}:features_of",
            options=FeaturesTask(
                photo=p, method=method.name, count=n, mask=None if masks is None else masks.files.get(p.name)
            ),
            cost=p.width_px * p.height_px / PIXELS_A_SECOND, memory=method.bytes_needed(p.width_px * p.height_px),
            name=p.name,
        )
        for p, n, m in zip(photos, counts, worn, strict=True)
    ]  # fmt: skip
    failed = means.do(tasks, "features")
    lost = {i: without_file(failed[t.key], photos[i].path) for i, t in enumerate(tasks) if t.key in failed}
    return FeatureStore(means.store, tuple(t.key for t in tasks)), lost


@dataclass(frozen=True, slots=True, kw_only=True)
class PairTask:
    """What a pair is matched from."""

    formats: tuple[PhotoFormat, PhotoFormat]
    features: tuple[str, str]
    """keys of their features"""
    method: str
    whole: bool = False
    """whatever a first look finds"""


def pair_of(store: Folder, task: PairTask) -> Product:
    """The task: one pair, matched and verified; or not matched where a first look finds no more than chance gives."""
    method = feature_method(task.method)
    xy: list[Array] = []
    described: list[Described] = []
    for format_, key in zip(task.formats, task.features, strict=True):
        f = features_from(store.held(key))
        xy.append(f.xy_px)
        described.append(
            Described(
                xy_px=upright_from_stored(f.xy_px, format_), descriptors=f.descriptors, size_px=format_.upright_size,
                scale_px=f.scale_px,
            )
        )  # fmt: skip
    sizes = [(p.width_px, p.height_px) for p in task.formats]
    matches = (method.match if task.whole else method.likely_matches)(described[0], described[1])
    return arrays_of_pair(verify(0, 1, xy[0], xy[1], matches, sizes[0], sizes[1]))


def arrays_of_pair(pair: VerifiedPair) -> dict[str, Array]:
    """A verified pair as it is kept."""
    facts = {
        "candidates": pair.candidates, "geometry": pair.geometry, "planar_share": pair.planar_share,
        "displacement_px": pair.displacement_px, "log_chance": pair.log_chance,
    }  # fmt: skip
    return {**{name: np.array(value) for name, value in facts.items()}, "matches": pair.matches}


def pair_from(first: int, second: int, product: Product) -> VerifiedPair:
    """The verified pair of two images."""
    facts = {name: value.item() for name, value in product.items() if name != "matches"}
    return VerifiedPair(first=first, second=second, matches=product["matches"], **facts)


def verified_pairs(
    means: Means, photos: Sequence[Photo], store: FeatureStore, method: FeatureMethod,
    pairs: Sequence[tuple[int, int]], whole: Collection[tuple[int, int]] = (),
) -> list[VerifiedPair]:  # fmt: skip
    """Pairs, each matched and verified by itself; those that are kept already are not matched again.

    whole  those of them that are matched whatever a first look finds
    """
    formats = [p.format for p in photos]
    tasks = [
        Task(
            key=key_of("matching", VERIFICATION, method.name, store.keys[i], store.keys[j], (i, j) in whole),
            function=f"{__name__}:pair_of", inputs=(store.keys[i], store.keys[j]), small=True, cost=PAIR_S,
            options=PairTask(
                formats=(formats[i], formats[j]), features=(store.keys[i], store.keys[j]), method=method.name,
                whole=(i, j) in whole,
            ),
            name=f"{photos[i].name} and {photos[j].name}",
        )
        for i, j in pairs
    ]  # fmt: skip
    for reason in means.do(tasks, "matching").values():
        raise InputError(reason)
    return [pair_from(i, j, means.small(t.key)) for t, (i, j) in zip(tasks, pairs, strict=True)]


def match_pairs(
    means: Means, photos: Sequence[Photo], store: FeatureStore, method: FeatureMethod,
    pairs: Sequence[tuple[int, int]], whole: Collection[tuple[int, int]] = (),
) -> list[VerifiedPair]:  # fmt: skip
    """Matched and verified pairs, without the matches of those that chance makes among so many, or a mere turn."""
    result = beyond_chance(verified_pairs(means, photos, store, method, pairs, whole))
    good = sum(1 for p in result if len(p.matches))
    if good and from_one_spot(result, photos, store):
        raise NoOrientation("tie_points.no_base", n=good)
    # a copy of a photograph, or one more from the same place: points that only these two show have no depth
    return [replace(p, matches=p.matches[:0]) if p.geometry == "rotation" else p for p in result]


def from_one_spot(pairs: Sequence[VerifiedPair], photos: Sequence[Photo], store: FeatureStore) -> bool:
    """Whether a mere turn of the camera explains every pair that matches, within a thousandth of the format.

    What is left beside the turn is all that there is to get depth from.  The camera constant may lie anywhere
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
