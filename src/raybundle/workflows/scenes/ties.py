"""Tie points of satellite scenes: matched along the strips that their geometry allows, verified by how rays meet."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from raybundle.errors import InputError, Message, Text, message, message_of, message_of_text, without_file
from raybundle.io.block.arrays import value_of_text
from raybundle.matching.features import FeatureMethod
from raybundle.matching.methods import feature_method
from raybundle.matching.strips import agreement, by_appearance, match_strips
from raybundle.matching.verify import FEWEST, VerifiedPair, verify
from raybundle.numerics.arrays import Array
from raybundle.numerics.places import Local
from raybundle.pipeline.keys import key_of
from raybundle.pipeline.place import Product
from raybundle.pipeline.stage import Means
from raybundle.pipeline.store import Folder
from raybundle.pipeline.tasks import Task
from raybundle.ties.points import (
    PIXELS_A_SECOND,
    FeatureStore,
    arrays_of_features,
    arrays_of_pair,
    features_from,
    pair_from,
)
from raybundle.workflows.scenes.geometry import (
    LEAST_COMMON,
    SceneView,
    meeting,
    overlap,
    strips_between,
    view_of_scene,
)
from raybundle.workflows.scenes.images import SceneImage, read_scene_image, scene_features

VERSION = 1
"""Raised with every change of what matching gives."""
PIXELS_EACH = 400
STRIP = 3.0
"""Half the width of a search strip in stated standard deviations of the two shifts."""
LEAST_STRIP_PX, MOST_STRIP_PX = 8.0, 400.0
ONE_SHIFT_PX = {"none": 3.0, "shift": 3.0, "drift": 8.0, "affine": 8.0}
"""Distance from the common misfit up to which a match is believed."""
BELIEVED = 4.0
"""A shift of more stated standard deviations than that: image and RPC do not belong together."""
ENOUGH = 40
"""Matches by appearance from which a pair that does not fit its geometry states it."""
HEIGHT_M = 50.0
"""Ground may lie so far outside the heights of the RPCs."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ScenePair:
    """Two scenes with common ground and what matching found."""

    pair: VerifiedPair
    shift_px: float
    """Misfit on which the matches agree; NaN without any"""
    scatter_px: float
    limit_px: float
    trouble: Message | None = None
    """Why image and geometry of one of the two cannot belong together; None: they can"""


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneFile:
    """Where a scene is read from."""

    path: Path
    model: Path
    sha256: str
    """of the image"""


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneFeaturesTask:
    """What the features of a scene are made of."""

    scene: SceneFile
    method: str
    count: int


@lru_cache(maxsize=32)
def _scene(file: SceneFile) -> SceneImage:
    """The scene; raises InputError where the file has changed meanwhile."""
    image = read_scene_image(file.path, file.model)
    if image.sha256 != file.sha256:
        raise InputError("photograph.changed", file=file.path)
    return image


def scene_features_of(store: Folder, task: SceneFeaturesTask) -> Product:
    """The task: features of one scene."""
    del store
    return arrays_of_features(scene_features(feature_method(task.method), _scene(task.scene), task.count))


def find_scene_features(
    means: Means, images: Sequence[SceneImage], method: FeatureMethod, most: int
) -> tuple[FeatureStore, dict[int, str]]:
    """Features of every scene, and scenes whose pixels cannot be read with the reason."""
    counts = [min(most, max(500, int(s.width_px * s.height_px / PIXELS_EACH))) for s in images]
    tasks = [
        Task(
            key=key_of("scene_features", VERSION, s.sha256, *method.content, n),
            function=f"{__name__}:scene_features_of", name=s.name, cost=s.width_px * s.height_px / PIXELS_A_SECOND,
            options=SceneFeaturesTask(scene=_file(s), method=method.name, count=n),
        )
        for s, n in zip(images, counts, strict=True)
    ]  # fmt: skip
    failed = means.do(tasks, "features")
    lost = {i: without_file(failed[t.key], images[i].path) for i, t in enumerate(tasks) if t.key in failed}
    return FeatureStore(means.store, tuple(t.key for t in tasks)), lost


def _file(image: SceneImage) -> SceneFile:
    return SceneFile(path=image.path, model=image.model, sha256=image.sha256)


@dataclass(frozen=True, slots=True, kw_only=True)
class ScenePairTask:
    """What a pair of scenes is matched from."""

    scenes: tuple[SceneFile, SceneFile]
    features: tuple[str, str]
    """keys of their features"""
    method: str
    place: Local
    """about which their geometry is looked at"""
    bias: str


def scene_pair_of(store: Folder, task: ScenePairTask) -> Product:
    """The task: one pair of scenes, matched along its strips and verified."""
    method = feature_method(task.method)
    a, b = (view_of_scene(_scene(f), task.place) for f in task.scenes)
    f, g = (features_from(store.held(key)) for key in task.features)
    one = matched(
        (0, 1), a, b, (f.xy_px, g.xy_px), (method.vectors(f.descriptors), method.vectors(g.descriptors)), task.bias
    )
    trouble = "" if one.trouble is None else json.dumps(one.trouble.json())
    facts = {"shift_px": one.shift_px, "scatter_px": one.scatter_px, "limit_px": one.limit_px, "trouble": trouble}
    return {**arrays_of_pair(one.pair), **{name: np.array(value) for name, value in facts.items()}}


def match_scenes(
    means: Means, images: Sequence[SceneImage], store: FeatureStore, method: FeatureMethod, place: Local, bias: str
) -> list[ScenePair]:
    """The pairs of scenes with common ground, matched and verified; what is kept is not matched again."""
    views = [view_of_scene(s, place) for s in images]
    pairs = [
        (i, j)
        for i in range(len(images))
        for j in range(i + 1, len(images))
        if max(overlap(views[i], views[j]).share, overlap(views[j], views[i]).share) >= LEAST_COMMON
    ]
    tasks = [
        Task(
            key=key_of(
                "scene_matching", VERSION, bias, *(store.keys[k] for k in p), *(images[k].geometry_key for k in p)
            ),
            function=f"{__name__}:scene_pair_of", inputs=tuple(store.keys[k] for k in p), small=True,
            options=ScenePairTask(
                scenes=(_file(images[p[0]]), _file(images[p[1]])), features=(store.keys[p[0]], store.keys[p[1]]),
                method=method.name, place=place, bias=bias,
            ),
            name=f"{images[p[0]].name} and {images[p[1]].name}",
        )
        for p in pairs
    ]  # fmt: skip
    for reason in means.do(tasks, "matching").values():
        raise InputError(reason)
    return [_scene_pair(p, means.small(t.key)) for t, p in zip(tasks, pairs, strict=True)]


OWN = ("shift_px", "scatter_px", "limit_px", "trouble")
"""What a pair of scenes has beside what a pair of photographs has."""


def _scene_pair(pair: tuple[int, int], product: Product) -> ScenePair:
    own = {name: product[name].item() for name in OWN}
    own["trouble"] = _trouble(own["trouble"])
    return ScenePair(pair=pair_from(*pair, {n: v for n, v in product.items() if n not in OWN}), **own)


def _trouble(text: str) -> Message | None:
    """A message of a product; the words that earlier versions wrote."""
    if not text:
        return None
    return message_of(value_of_text(text)) if text.startswith("{") else message_of_text(text)


def matched(
    pair: tuple[int, int],
    a: SceneView,
    b: SceneView,
    xy: tuple[Array, Array],
    vectors: tuple[Array, Array],
    bias: str = "shift",
) -> ScenePair:
    """Match two scenes along their strips; where that finds little, say whether their geometry is to blame.

    xy, vectors  features [px] and their unit vectors, of the first and of the second
    """
    width = ONE_SHIFT_PX[bias]
    both = float(np.sqrt((a.prior_px**2 + b.prior_px**2).max()))
    tolerance = float(np.clip(STRIP * both, LEAST_STRIP_PX, MOST_STRIP_PX))
    there, back = strips_between(a, b, xy[0], tolerance), strips_between(b, a, xy[1], tolerance)
    candidates = match_strips(*vectors, *xy, there, back)
    if len(candidates) >= FEWEST:
        met = meeting(a, b, xy[0][candidates[:, 0]], xy[1][candidates[:, 1]])
        common = agreement(met.misfit_px, width)
        limit = BELIEVED * met.prior_px + width
        # matches by chance are spread over the width of the strip
        chance = len(candidates) * min(width / tolerance, 1.0)
        good = int(common.inside.sum())
        if good >= max(FEWEST, 2 * chance) and abs(common.value) <= limit:
            apart = np.linalg.norm(xy[0][candidates[:, 0]] - xy[1][candidates[:, 1]], axis=1)[common.inside]
            return ScenePair(
                pair=VerifiedPair(
                    first=pair[0], second=pair[1], matches=candidates[common.inside], candidates=len(candidates),
                    geometry="general", planar_share=0.0, displacement_px=float(np.median(apart)),
                ),
                shift_px=common.value, scatter_px=common.scatter, limit_px=limit,
            )  # fmt: skip
    return _without_geometry(pair, a, b, xy, vectors, width)


def _without_geometry(
    pair: tuple[int, int], a: SceneView, b: SceneView, xy: tuple[Array, Array], vectors: tuple[Array, Array],
    width: float,
) -> ScenePair:  # fmt: skip
    """Matches by appearance: whether they agree with each other, and if so how their geometry contradicts them."""
    rows = by_appearance(*vectors)
    found = verify(*pair, *xy, rows, a.sensor.size_px, b.sensor.size_px)
    none = VerifiedPair(
        first=pair[0], second=pair[1], matches=rows[:0], candidates=len(rows), geometry="none", planar_share=0.0,
        displacement_px=0.0,
    )  # fmt: skip
    if len(found.matches) < ENOUGH:
        return ScenePair(pair=none, shift_px=float("nan"), scatter_px=float("nan"), limit_px=float("nan"))
    met = meeting(a, b, xy[0][found.matches[:, 0]], xy[1][found.matches[:, 1]])
    common = agreement(met.misfit_px, width)
    limit = BELIEVED * met.prior_px + width
    share = float(common.inside.mean())
    low, high = max(a.heights[0], b.heights[0]), min(a.heights[1], b.heights[1])
    height, n = float(np.median(met.height_m)), len(found.matches)
    if share > 0.5 and abs(common.value) > limit:
        trouble = message(
            "scene.pair_shifted", n=n, shift_px=abs(common.value), limit_px=limit, prior_px=met.prior_px,
            times=BELIEVED,
        )  # fmt: skip
    elif share <= 0.5:
        spread = 1.4826 * float(np.median(np.abs(met.misfit_px - np.median(met.misfit_px))))
        trouble = message("scene.pair_scattered", n=n, spread_px=spread, limit_px=width)
    elif not low - HEIGHT_M <= height <= high + HEIGHT_M:
        trouble = message("scene.pair_height", n=n, height_m=height, low_m=low, high_m=high)
    else:
        trouble = None
    return ScenePair(pair=none, shift_px=common.value, scatter_px=common.scatter, limit_px=limit, trouble=trouble)


def contradicting(images: Sequence[SceneImage], pairs: Sequence[ScenePair]) -> dict[int, str]:
    """Scenes whose geometry contradicts that of the others, and why.

    raises  InputError where two scenes contradict each other and nothing shows which of them is wrong
    """
    bad = [(p, p.trouble) for p in pairs if p.trouble is not None]
    if not bad:
        return {}
    good = {k for p in pairs if len(p.pair.matches) for k in (p.pair.first, p.pair.second)}
    out: dict[int, str] = {}
    for p, trouble in bad:
        ends = p.pair.first, p.pair.second
        wrong = [k for k in ends if k not in good]
        names = [images[k].name for k in ends]
        if len(wrong) == 1:
            other = names[1 - ends.index(wrong[0])]
            model = images[wrong[0]].model.name
            out[wrong[0]] = Text.of(message("scene.contradicts_other", model=model, other=other), trouble)
        elif len(wrong) == 2:
            raise InputError(
                "scene.pair_contradicts", first=names[0], second=names[1], details=[trouble],
                file=images[ends[0]].path,
            )  # fmt: skip
    return out
