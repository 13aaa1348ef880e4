"""Stage: pairs of satellite scenes; one whose geometry contradicts the others' leaves."""

from __future__ import annotations

from dataclasses import dataclass, replace

from raybundle.errors import phrase
from raybundle.matching.features import FeatureMethod
from raybundle.pipeline.stage import Means, Stage
from raybundle.scenes.bias import BiasKind
from raybundle.ties.points import FeatureStore
from raybundle.workflows.orienting.state import ORIENT, OrientState
from raybundle.workflows.scenes.geometry import place_of_scenes
from raybundle.workflows.scenes.images import SceneImage
from raybundle.workflows.scenes.ties import ScenePair, contradicting, match_scenes
from raybundle.workflows.stage_arrays import Reasons


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What pairs of scenes depend on."""

    images: tuple[SceneImage, ...]
    features: FeatureStore
    method: FeatureMethod
    bias: BiasKind


@dataclass(frozen=True, slots=True, kw_only=True)
class Matched:
    """What the scenes share."""

    kept: tuple[int, ...]
    """scenes that are left"""
    pairs: tuple[ScenePair, ...]
    lost: Reasons


def _inputs(state: OrientState) -> Inputs:
    scenes = state.with_scenes
    assert scenes.features is not None
    return Inputs(
        images=scenes.images, features=scenes.features, method=state.method, bias=state.asked.options.scene_bias
    )


def match(i: Inputs, means: Means) -> Matched:
    """Each pair is matched by a task of its own."""
    kept, lost, pairs = [*range(len(i.images))], list[tuple[str, str]](), list[ScenePair]()
    while kept:
        images = tuple(i.images[k] for k in kept)
        place = place_of_scenes(images)
        pairs = match_scenes(means, images, i.features.rows(kept), i.method, place, i.bias)
        wrong = contradicting(images, pairs)
        if not wrong:
            break
        lost += [(images[k].name, why) for k, why in wrong.items()]
        kept = [kept[k] for k in range(len(kept)) if k not in wrong]
    return Matched(kept=tuple(kept), pairs=tuple(pairs) if kept else (), lost=tuple(lost))


def _put(state: OrientState, m: Matched) -> OrientState:
    scenes = state.with_scenes.rows(m.kept)
    return replace(state, scenes=replace(scenes, pairs=m.pairs, lost=(*scenes.lost, *m.lost)))


def _outcome(state: OrientState) -> str:
    pairs = state.with_scenes.pairs
    good = sum(1 for p in pairs if len(p.pair.matches))
    return phrase("stage_summary.scene_pairs", n=len(pairs), verified=good)


STAGE = ORIENT.register(
    Stage(
        name="scene_matching",
        line="matching",
        after=("matching",),
        inputs=_inputs,
        function=match,
        put=_put,
        reported=_outcome,
        when=lambda s: s.scenes is not None,
    )
)
