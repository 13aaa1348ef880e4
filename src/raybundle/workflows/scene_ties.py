"""Tie points of satellite scenes: matched along the strips that their geometry allows, verified by how rays meet."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np

from raybundle.errors import InputError
from raybundle.io.project import Project, Stage, key_of
from raybundle.matching.features import FeatureMethod
from raybundle.matching.strips import agreement, by_appearance, match_strips
from raybundle.matching.verify import FEWEST, VerifiedPair, verify
from raybundle.numerics.arrays import Array
from raybundle.numerics.places import Local
from raybundle.numerics.progress import Progress
from raybundle.workflows.scene_geometry import (
    LEAST_COMMON,
    SceneView,
    meeting,
    overlap,
    strips_between,
    view_of_scene,
)
from raybundle.workflows.scene_images import SceneImage, scene_features
from raybundle.workflows.tie_points import FeatureStore, stored_features

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
"""Matches by appearance from which a pair that does not fit its geometry says so."""
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
    trouble: str = ""
    """Why image and geometry of one of the two cannot belong together; empty: they can"""


def find_scene_features(
    project: Project,
    images: Sequence[SceneImage],
    method: FeatureMethod,
    most: int,
    jobs: int,
    progress: Progress,
) -> tuple[FeatureStore, dict[int, str], bool]:
    """Features of every scene, scenes whose pixels cannot be read with the reason, and whether all were kept before."""
    counts = [min(most, max(500, int(s.width_px * s.height_px / PIXELS_EACH))) for s in images]
    keys = tuple(
        key_of("features", "scene", VERSION, s.sha256, method.name, method.version, n)
        for s, n in zip(images, counts, strict=True)
    )
    failed, kept = stored_features(
        project, keys, lambda i: scene_features(method, images[i], counts[i]), [s.path for s in images], jobs, progress
    )
    return FeatureStore(project, keys), failed, kept


def match_scenes(
    project: Project,
    stage: Stage,
    images: Sequence[SceneImage],
    store: FeatureStore,
    method: FeatureMethod,
    place: Local,
    bias: str,
    jobs: int,
    progress: Progress,
) -> list[ScenePair]:
    """The pairs of scenes with common ground, matched and verified; what the project holds is not matched again."""
    views = [view_of_scene(s, place) for s in images]
    pairs = [
        (i, j)
        for i in range(len(images))
        for j in range(i + 1, len(images))
        if max(overlap(views[i], views[j]).share, overlap(views[j], views[i]).share) >= LEAST_COMMON
    ]
    keys = [
        key_of("pair", "scene", VERSION, bias, *(store.keys[k] for k in p), *(images[k].geometry_key for k in p))
        for p in pairs
    ]
    known = project.pairs(keys)
    todo = [(key, p) for key, p in zip(keys, pairs, strict=True) if key not in known]
    stage.key = key_of("matching", stage.key, keys)
    stage.from_cache = stage.from_cache and not todo

    def work(task: tuple[str, tuple[int, int]]) -> tuple[str, ScenePair]:
        key, (i, j) = task
        f, g = store.of(i), store.of(j)
        return key, matched(
            (i, j), views[i], views[j], (f.xy_px, g.xy_px),
            (method.vectors(f.descriptors), method.vectors(g.descriptors)), bias,
        )  # fmt: skip

    found: dict[str, ScenePair] = {}
    with ThreadPoolExecutor(jobs) as pool:
        for n, (key, one) in enumerate(pool.map(work, todo)):
            found[key] = one
            project.store_pairs([(key, _facts(one), one.pair.matches)])
            progress("matching", (n + 1) / len(todo))
    return [found[key] if key in found else _of_facts(p, *known[key]) for key, p in zip(keys, pairs, strict=True)]


def _facts(one: ScenePair) -> dict[str, Any]:
    p = one.pair
    return {
        "candidates": p.candidates, "geometry": p.geometry, "displacement_px": p.displacement_px,
        "shift_px": one.shift_px, "scatter_px": one.scatter_px, "limit_px": one.limit_px, "trouble": one.trouble,
    }  # fmt: skip


def _of_facts(pair: tuple[int, int], facts: Mapping[str, Any], matches: Array) -> ScenePair:
    return ScenePair(
        pair=VerifiedPair(
            first=pair[0], second=pair[1], matches=matches, candidates=facts["candidates"],
            geometry=facts["geometry"], planar_share=0.0, displacement_px=facts["displacement_px"],
        ),
        shift_px=facts["shift_px"], scatter_px=facts["scatter_px"], limit_px=facts["limit_px"],
        trouble=facts["trouble"],
    )  # fmt: skip


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
    height = float(np.median(met.height_m))
    if share > 0.5 and abs(common.value) > limit:
        trouble = (
            f"their {len(found.matches)} common points agree on a step of {abs(common.value):.0f} px between the two, "
            f"the stated accuracy allows {limit:.0f} px ({BELIEVED:g} times {met.prior_px:.1f} px)"
        )
    elif share <= 0.5:
        spread = 1.4826 * float(np.median(np.abs(met.misfit_px - np.median(met.misfit_px))))
        trouble = (
            f"their {len(found.matches)} common points fit no constant step: they scatter by {spread:.0f} px "
            f"(limit {width:g} px)"
        )
    elif not low - HEIGHT_M <= height <= high + HEIGHT_M:
        trouble = (
            f"the rays of their {len(found.matches)} common points meet at a height of {height:.0f} m, the RPCs are "
            f"for {low:.0f} to {high:.0f} m"
        )
    else:
        trouble = ""
    return ScenePair(pair=none, shift_px=common.value, scatter_px=common.scatter, limit_px=limit, trouble=trouble)


def contradicting(images: Sequence[SceneImage], pairs: Sequence[ScenePair]) -> dict[int, str]:
    """Scenes whose geometry contradicts that of the others, and why.

    raises  InputError where two scenes contradict each other and nothing tells which of them is wrong
    """
    bad = [p for p in pairs if p.trouble]
    if not bad:
        return {}
    good = {k for p in pairs if len(p.pair.matches) for k in (p.pair.first, p.pair.second)}
    out: dict[int, str] = {}
    for p in bad:
        ends = p.pair.first, p.pair.second
        wrong = [k for k in ends if k not in good]
        names = [images[k].name for k in ends]
        advice = "look whether each image has its own RPC or XML beside it, and whether it was cut, scaled or turned"
        if len(wrong) == 1:
            other = names[1 - ends.index(wrong[0])]
            out[wrong[0]] = (
                f"its geometry ({images[wrong[0]].model.name}) contradicts that of {other}, which agrees with other "
                f"scenes: {p.trouble}; {advice}"
            )
        elif len(wrong) == 2:
            raise InputError(f"{names[0]} and {names[1]}: {p.trouble}; {advice}", file=images[ends[0]].path)
    return out
