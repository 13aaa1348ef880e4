"""Points that photographs and satellite scenes have in common: tie points of photographs looked for in the scenes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import cast

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Block, Observations, Role
from raybundle.errors import Message, message
from raybundle.matching.features import FeatureMethod
from raybundle.matching.strips import APART_PX, FARTHEST, RATIO
from raybundle.matching.verify import FEWEST
from raybundle.numerics.arrays import Array, Index
from raybundle.scenes.sensor import SceneSensor
from raybundle.ties.points import FeatureStore

FEATURE_PX = 1.0
"""Distance between a measured image point and the feature that it comes from."""
POSITION_M = 2.0
"""How far a placed block of photographs may be off besides what is stated of its control."""
STRIP, MOST_PX = 3.0, 250.0
ONE_SHIFT_PX = 2.5
"""Distance from the common map up to which a match is believed."""
ROUNDS = 8
LEAST_SIGMA_PX = 0.25
MOST_POINTS = 3000
"""Points that are looked for in one scene."""


def with_joins(
    block: Block,
    photographs: Mapping[str, int],
    store: FeatureStore,
    scenes: Sequence[str],
    scene_store: FeatureStore,
    method: FeatureMethod,
) -> tuple[Block, tuple[Notice, ...]]:
    """The block with tie points of photographs measured in scenes as well, by their features.

    photographs, scenes  names of the images whose features the stores hold, in their order
    Believed is what agrees on one linear map of the scene, for the scene lacks a shift, and photographs that are placed
    by their positions a shift, a turn and a scale; the standard deviation is the scatter about it.  Scenes and
    photographs of other resolutions or seasons have nothing in common here.
    """
    points = _described_points(block, photographs, store, method)
    if points is None:
        return block, ()
    described, vectors = points
    added: list[tuple[int, Index, Array, float]] = []
    counts: list[Message] = []
    for k, name in enumerate(scenes):
        i = block.images.ids.index(name)
        found = _in_scene(block, i, described, vectors, scene_store, k, method)
        if found is not None:
            point, xy, sigma = found
            added.append((i, point, xy, sigma))
            counts.append(message("scene_joins.scene", n=len(point), scene=name))
    if not added:
        return block, ()
    variance = np.concatenate([np.full(len(p), s**2) for _, p, _, s in added])
    more = Observations(
        image=np.concatenate([np.full(len(p), i) for i, p, _, _ in added]).astype(np.int32),
        point=np.concatenate([p for _, p, _, _ in added]).astype(np.int32),
        xy_px=np.vstack([xy for _, _, xy, _ in added]),
        cov_px2=np.column_stack([variance, variance, np.zeros(len(variance))]),
    )
    notice = Notice(code="scene_joins", values={"scenes": len(counts)}, details=tuple(counts))
    return replace(block, observations=block.observations.append(more)), (notice,)


def _described_points(
    block: Block, photographs: Mapping[str, int], store: FeatureStore, method: FeatureMethod
) -> tuple[Index, Array] | None:
    """Tie points with coordinates that photographs see, and the description of one feature of each."""
    from scipy.spatial import KDTree

    o = block.observations
    tie = (np.asarray(block.points.role) == Role.TIE) & np.isfinite(block.points.xyz).all(axis=1)
    found: dict[int, Array] = {}
    for i, name in enumerate(block.images.ids):
        if name not in photographs:
            continue
        rows = np.flatnonzero((o.image == i) & tie[o.point])
        features = store.of(photographs[name])
        if not len(rows) or not len(features):
            continue
        distance, nearest = (np.atleast_1d(a) for a in KDTree(features.xy_px).query(o.xy_px[rows]))
        near = distance < FEATURE_PX
        vectors = method.vectors(features.descriptors[nearest[near]])
        for p, v in zip(o.point[rows[near]].tolist(), vectors, strict=True):
            found.setdefault(p, v)
    if len(found) < FEWEST:
        return None
    points = np.array(list(found), np.int64)
    if len(points) > MOST_POINTS:
        points = points[np.linspace(0, len(points) - 1, MOST_POINTS).astype(int)]
    return points, np.array([found[int(p)] for p in points])


def _in_scene(
    block: Block, i: int, points: Index, vectors: Array, store: FeatureStore, k: int, method: FeatureMethod
) -> tuple[Index, Array, float] | None:
    """Points found in a scene, where, and the standard deviation [px]; None where too few agree."""
    from scipy.spatial import KDTree

    camera = block.cameras[int(block.images.camera[i])]
    sensor = cast("SceneSensor", camera.scene)
    seen = sensor.observe(block.points.xyz[points], camera.parameters)
    inside = ((seen.xy_px > 0) & (seen.xy_px < np.array(sensor.size_px))).all(axis=1)
    if inside.sum() < FEWEST:
        return None
    points, vectors, expected = points[inside], vectors[inside], seen.xy_px[inside]
    per_metre = float(np.median(np.linalg.norm(seen.by_point[inside], axis=1)))
    radius = min(STRIP * float(sensor.prior_px().max()) + STRIP * POSITION_M * per_metre, MOST_PX)
    features = store.of(k)
    own = method.vectors(features.descriptors)
    near = KDTree(features.xy_px).query_ball_point(expected, radius)
    hit, where = list[int](), list[int]()
    for row, candidates in enumerate(near):
        if not candidates:
            continue
        at = np.array(candidates)
        distance = np.sqrt(np.maximum(2 - 2 * own[at] @ vectors[row], 0))
        best = int(distance.argmin())
        apart = np.abs(features.xy_px[at] - features.xy_px[at[best]]).max(axis=1) > APART_PX
        second = float(distance[apart].min()) if apart.any() else np.inf
        if distance[best] < FARTHEST and distance[best] < RATIO * second:
            hit.append(row)
            where.append(int(at[best]))
    if len(hit) < FEWEST:
        return None
    return _agreeing(points[hit], expected[hit], block.points.xyz[points[hit], 2], features.xy_px[where], radius)


def _agreeing(
    points: Index, expected: Array, height: Array, xy: Array, radius: float
) -> tuple[Index, Array, float] | None:
    """Matches whose shifts agree on a linear map of place and height; None where no more do than would by chance."""
    from scipy.spatial import KDTree

    d = xy - expected
    tree = KDTree(d)
    count = np.array([len(n) for n in tree.query_ball_point(d, ONE_SHIFT_PX)])
    middle = d[int(count.argmax())]
    inside = np.zeros(len(d), bool)
    for _ in range(5):
        inside = np.linalg.norm(d - middle, axis=1) <= ONE_SHIFT_PX
        middle = np.median(d[inside], axis=0)
    least = max(FEWEST, 3 * len(d) * (ONE_SHIFT_PX / radius) ** 2)
    if inside.sum() < least:
        return None
    of = np.column_stack([expected, height])
    of = np.column_stack([np.ones(len(d)), (of - of.mean(axis=0)) / np.maximum(of.std(axis=0), 1e-9)])
    left = d - middle
    for _ in range(ROUNDS):
        left = d - of @ np.linalg.lstsq(of[inside], d[inside], rcond=None)[0]
        inside = np.linalg.norm(left, axis=1) <= ONE_SHIFT_PX
        if inside.sum() < least:
            return None
    scatter = 1.4826 * float(np.median(np.abs(left[inside])))
    # one feature of the scene is one point
    _, first = np.unique(np.round(xy[inside], 1), axis=0, return_index=True)
    chosen = np.flatnonzero(inside)[first]
    return points[chosen], xy[chosen], max(scatter, LEAST_SIGMA_PX)
