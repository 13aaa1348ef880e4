"""Satellite scenes and photographs in one block in object space."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from raybundle.adjustment.records.notice import Notice, notice_of_text
from raybundle.block import Block
from raybundle.errors import phrase
from raybundle.io.photos.photo import Photo
from raybundle.matching.features import FeatureMethod
from raybundle.placing.georeference import Georeferenced, Surroundings
from raybundle.placing.marks import Given, add_bars
from raybundle.ties.points import FeatureStore
from raybundle.workflows.orienting.connected_components import place_components
from raybundle.workflows.orienting.options import OrientOptions
from raybundle.workflows.orienting.state import SceneState
from raybundle.workflows.scenes.joins import with_joins
from raybundle.workflows.scenes.place import (
    common_frame,
    control_in_system,
    finish,
    in_frame,
    marks_in,
    place_scenes,
    places_of_marks,
)
from raybundle.workflows.stage_arrays import Reasons


def place_with_scenes(
    state: SceneState, options: OrientOptions, blocks: Sequence[Block], photos: Sequence[Photo], given: Given,
    store: FeatureStore, method: FeatureMethod,
) -> tuple[Georeferenced, tuple[Georeferenced, ...], Reasons]:  # fmt: skip
    """Scenes and photographs in one block in object space, photographs that nothing places there, and lost scenes."""
    assert state.block is not None
    assert state.features is not None
    scenes = state.set(options)
    given = control_in_system(given, scenes, options.crs)
    placed, found = common_frame(scenes, photos, given)
    given = in_frame(given, placed)
    names = [s.name for s in state.images]
    placing = place_scenes(state.block, scenes, marks_in(given, names, inside=True), placed)
    notices = [*found, *scenes.notices(), *(_files(given))]
    notices += [notice_of_text("coordinate_system", r) for r in placed.frame.remarks]
    if not blocks:
        add_bars(placing, given)
        return finish(placing, None, placed, notices), (), state.lost
    first, apart = place_components(
        blocks,
        photos,
        marks_in(given, names, inside=False),
        Surroundings(frame=placed.frame, places=places_of_marks(placing.block)),
    )
    if first.fixed:
        whole = finish(placing, first, placed, notices)
        photographs = {p.name: i for i, p in enumerate(photos)}
        block, more = with_joins(whole.block, photographs, store, names, state.features, method)
        return replace(whole, block=block, notices=(*more, *whole.notices)), apart, state.lost
    if not len(placing.block.observations):
        # scenes in which nothing is measured: there is no block but that of the photographs
        lost = (
            *((n, w) for n, w in state.lost if n not in names),
            *((n, phrase("not_oriented.not_joined")) for n in names),
        )
        return first, apart, lost
    return finish(placing, None, placed, notices), (first, *apart), state.lost


def _files(given: Given) -> list[Notice]:
    return [notice_of_text("control_file", r) for c in given.control for r in c.remarks]
