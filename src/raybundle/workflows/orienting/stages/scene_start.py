"""Stage: tracks of satellite scenes with approximate coordinates."""

from __future__ import annotations

from dataclasses import dataclass, replace

from raybundle.errors import phrase
from raybundle.pipeline.stage import Codec, Means, Stage
from raybundle.ties.block import TieBlock
from raybundle.ties.points import FeatureStore
from raybundle.workflows.orienting.state import ORIENT, OrientState
from raybundle.workflows.scenes.block import SceneSet, again, plain, refuse_nothing_common, started
from raybundle.workflows.scenes.place import marks_in
from raybundle.workflows.scenes.ties import ScenePair
from raybundle.workflows.stage_arrays import arrays_of_tie, tie_of_arrays


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What approximate values of scenes depend on."""

    scenes: SceneSet
    features: FeatureStore
    pairs: tuple[ScenePair, ...]


def _inputs(state: OrientState) -> Inputs:
    scenes = state.with_scenes
    assert scenes.features is not None
    wanted = scenes.set(state.asked.options)
    inside = marks_in(state.given, [s.name for s in scenes.images], inside=True)
    marks = sum(len(c.measurements) for c in inside.control)
    refuse_nothing_common(wanted, scenes.pairs, marks, len(state.photos), [*state.refused, *scenes.lost])
    return Inputs(scenes=wanted, features=scenes.features, pairs=scenes.pairs)


def begin(i: Inputs, means: Means) -> TieBlock:
    """Tracks with approximate coordinates, wrong ones left out; the sensors apart, which are the scenes'."""
    tie = started(i.scenes, i.features, i.pairs, means.jobs, means.progress)
    return replace(tie, block=plain(tie.block))


def _put(state: OrientState, tie: TieBlock) -> OrientState:
    scenes = state.with_scenes
    tie = replace(tie, block=again(tie.block, scenes.set(state.asked.options)))
    inside = marks_in(state.given, [s.name for s in scenes.images], inside=True)
    marked = {n.rsplit(".", 1)[0].lower() for c in inside.control for n in c.measurements.image}
    lost = tuple((n, w) for n, w in tie.not_oriented if n.rsplit(".", 1)[0].lower() not in marked)
    return replace(state, scenes=replace(scenes, tie=tie, block=tie.block, lost=(*scenes.lost, *lost)))


def _outcome(state: OrientState) -> str:
    tie = state.with_scenes.tie
    return "" if tie is None else phrase("stage_summary.scene_points", n=len(tie.block.points))


STAGE = ORIENT.register(
    Stage(
        name="scene_start",
        line="start",
        version=5,
        after=("start",),
        inputs=_inputs,
        function=begin,
        put=_put,
        reported=_outcome,
        codec=Codec(arrays=arrays_of_tie, product=tie_of_arrays),
        when=lambda s: s.scenes is not None,
    )
)
