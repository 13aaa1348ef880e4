"""Stage: tie points of satellite scenes measured by least-squares matching."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from raybundle.block import Block
from raybundle.errors import phrase
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.numerics.arrays import Array
from raybundle.pipeline.stage import Codec, Means, Stage
from raybundle.ties.block import TieBlock
from raybundle.ties.precise import Weights
from raybundle.workflows.orienting.state import ORIENT, OrientState
from raybundle.workflows.scenes.block import SceneSet, again, plain, refined


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What precise tie points of scenes depend on."""

    scenes: SceneSet
    tie: TieBlock


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """Precise tie points; the sensors apart, which are the scenes'."""

    block: Block
    weights: Weights
    offered: int
    measured: int
    added: int


def _inputs(state: OrientState) -> Inputs:
    scenes = state.with_scenes
    assert scenes.tie is not None
    plainly = replace(scenes.tie, block=plain(scenes.tie.block))
    return Inputs(scenes=scenes.set(state.asked.options), tie=plainly)


def measure(i: Inputs, means: Means) -> Measured:
    """Least-squares matching in pixels that are mapped from files."""
    tie = replace(i.tie, block=again(i.tie.block, i.scenes))
    found = refined(means.store.path, i.scenes, tie, means.jobs, means.progress)
    return Measured(
        block=plain(found.block), weights=found.weights, offered=found.offered, measured=found.measured,
        added=found.added,
    )  # fmt: skip


def _put(state: OrientState, m: Measured) -> OrientState:
    scenes = state.with_scenes
    block = again(m.block, scenes.set(state.asked.options))
    words = phrase("stage_summary.scene_precision", n=m.measured, of=m.offered, added=m.added)
    return replace(state, scenes=replace(scenes, block=block, weights=m.weights, measured=words))


def _arrays(m: Measured) -> dict[str, Array]:
    counts = np.array([m.offered, m.measured, m.added])
    return {**arrays_of_block(m.block), "weights": m.weights.array(), "counts": counts}


def _product(a: Mapping[str, Array]) -> Measured:
    offered, measured, added = a["counts"].tolist()
    return Measured(
        block=block_of_arrays(a), weights=Weights.of(a["weights"]), offered=offered, measured=measured, added=added
    )


def _when(state: OrientState) -> bool:
    tie = None if state.scenes is None else state.scenes.tie
    return state.asked.options.precise and tie is not None and len(tie.block.observations) > 0


STAGE = ORIENT.register(
    Stage(
        name="scene_precision",
        line="precision",
        version=10,
        after=("precision",),
        inputs=_inputs,
        function=measure,
        put=_put,
        reported=lambda s: s.with_scenes.measured,
        codec=Codec(arrays=_arrays, product=_product),
        when=_when,
    )
)
