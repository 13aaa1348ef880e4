"""The part of a run that belongs to satellite scenes, stage by stage beside the photographs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from raybundle.adjustment.result import Notice
from raybundle.block import Block
from raybundle.io.photos.photo import Photo
from raybundle.io.project import Project, Stage, key_of
from raybundle.matching.features import FeatureMethod
from raybundle.numerics.counting import counted
from raybundle.numerics.progress import Progress
from raybundle.scenes.bias import BiasKind
from raybundle.workflows.georeference import Georeferenced, Surroundings
from raybundle.workflows.marks import Given, add_bars
from raybundle.workflows.parts import place_parts
from raybundle.workflows.precise import Weights
from raybundle.workflows.scene_block import SceneSet, refine_scenes, refuse_nothing_common, start_scenes
from raybundle.workflows.scene_geometry import place_of_scenes
from raybundle.workflows.scene_images import FoundScenes, SceneImage
from raybundle.workflows.scene_joins import with_joins
from raybundle.workflows.scene_place import (
    common_frame,
    control_in_system,
    finish,
    in_frame,
    marks_in,
    place_scenes,
    places_of_marks,
)
from raybundle.workflows.scene_ties import ScenePair, contradicting, find_scene_features, match_scenes
from raybundle.workflows.tie_block import TieBlock
from raybundle.workflows.tie_points import FeatureStore

NOT_JOINED = (
    "nothing joins it to the photographs: mark three points, control or not, in it and in two photographs, or give "
    "control for the photographs"
)


@dataclass(slots=True)
class SceneRun:
    """The scenes of a project on their way to a block."""

    bias: BiasKind
    crs: str | None
    images: tuple[SceneImage, ...]
    refused: list[tuple[str, str]]
    lost: list[tuple[str, str]] = field(default_factory=list[tuple[str, str]])
    """Scenes that take no part, and why"""
    store: FeatureStore | None = None
    pairs: tuple[ScenePair, ...] = ()
    tie: TieBlock | None = None
    block: Block | None = None
    weights: Weights | None = None

    @classmethod
    def of(cls, found: FoundScenes, bias: BiasKind, crs: str | None) -> SceneRun:
        """The run of the scenes that were found."""
        return cls(bias=bias, crs=crs, images=found.scenes, refused=list(found.refused))

    @property
    def set(self) -> SceneSet:
        """The scenes that are left."""
        return SceneSet(images=self.images, place=place_of_scenes(self.images), bias=self.bias)

    def features(
        self, project: Project, stage: Stage, method: FeatureMethod, most: int, jobs: int, progress: Progress
    ) -> None:
        """Features of the scenes."""
        store, failed, kept = find_scene_features(project, self.images, method, most, jobs, progress)
        stage.from_cache = stage.from_cache and kept
        stage.key = key_of("features", stage.key, store.keys)
        self.refused += [(self.images[i].name, why) for i, why in failed.items()]
        self._keep([i for i in range(len(self.images)) if i not in failed], store)
        stage.summary = _and(stage.summary, counted(len(self.images), "scene"))

    def _keep(self, rows: Sequence[int], store: FeatureStore) -> None:
        self.images = tuple(self.images[i] for i in rows)
        self.store = FeatureStore(store.project, tuple(store.keys[i] for i in rows))

    def matching(self, project: Project, stage: Stage, method: FeatureMethod, jobs: int, progress: Progress) -> None:
        """Pairs of scenes; one whose geometry contradicts the others' leaves."""
        assert self.store is not None
        pairs: list[ScenePair] = []
        while self.images:
            pairs = match_scenes(
                project, stage, self.images, self.store, method, self.set.place, self.bias, jobs, progress
            )
            wrong = contradicting(self.images, pairs)
            if not wrong:
                break
            self.lost += [(self.images[i].name, why) for i, why in wrong.items()]
            self._keep([i for i in range(len(self.images)) if i not in wrong], self.store)
        self.pairs = tuple(pairs) if self.images else ()
        good = sum(1 for p in self.pairs if len(p.pair.matches))
        stage.summary = _and(stage.summary, f"{counted(len(self.pairs), 'pair')} of scenes, {good} verified")

    def start(
        self, project: Project, stage: Stage, name: str, given: Given, photographs: int, jobs: int, progress: Progress
    ) -> None:
        """Tracks with approximate coordinates."""
        assert self.store is not None
        scenes = self.set
        names = [s.name for s in self.images]
        inside = marks_in(given, names, inside=True)
        marks = sum(len(c.measurements) for c in inside.control)
        refuse_nothing_common(scenes, self.pairs, marks, photographs, [*self.refused, *self.lost])
        self.tie = start_scenes(project, stage, name, scenes, self.store, self.pairs, jobs, progress)
        marked = {n.rsplit(".", 1)[0].lower() for c in inside.control for n in c.measurements.image}
        self.lost += [(n, w) for n, w in self.tie.not_oriented if n.rsplit(".", 1)[0].lower() not in marked]
        self.block = self.tie.block
        stage.summary = _and(stage.summary, f"{counted(len(self.tie.block.points), 'point')} of scenes")

    def precision(self, project: Project, stage: Stage, jobs: int, progress: Progress) -> None:
        """Least-squares matching of their tie points."""
        if self.tie is None or not len(self.tie.block.observations):
            return
        self.block, self.weights, (offered, measured, added) = refine_scenes(
            project, stage, self.set, self.tie, jobs, progress
        )
        stage.summary = _and(stage.summary, f"{measured} of {offered} in scenes, {added} rays added")

    def place(
        self, blocks: Sequence[Block], photos: Sequence[Photo], given: Given, store: FeatureStore, method: FeatureMethod
    ) -> tuple[Georeferenced, tuple[Georeferenced, ...]]:
        """Scenes and photographs in one block in object space, and photographs that nothing places there."""
        assert self.block is not None
        scenes = self.set
        given = control_in_system(given, scenes, self.crs)
        placed, told = common_frame(scenes, photos, given)
        given = in_frame(given, placed)
        names = [s.name for s in self.images]
        state = place_scenes(self.block, scenes, marks_in(given, names, inside=True), placed)
        notices = [*told, *scenes.notices(), *_files(given)]
        notices += [Notice(code="coordinate_system", message=r) for r in placed.frame.remarks]
        if not blocks:
            add_bars(state, given)
            return finish(state, None, placed, notices), ()
        first, apart = place_parts(
            blocks,
            photos,
            marks_in(given, names, inside=False),
            Surroundings(frame=placed.frame, places=places_of_marks(state.block)),
        )
        if first.fixed:
            assert self.store is not None
            whole = finish(state, first, placed, notices)
            photographs = {p.name: i for i, p in enumerate(photos)}
            block, more = with_joins(whole.block, photographs, store, names, self.store, method)
            return replace(whole, block=block, notices=(*more, *whole.notices)), apart
        if not len(state.block.observations):
            # scenes in which nothing is measured: there is no block but that of the photographs
            self.lost = [(n, w) for n, w in self.lost if n not in names] + [(n, NOT_JOINED) for n in names]
            return first, apart
        return finish(state, None, placed, notices), (first, *apart)

    @property
    def oriented(self) -> int:
        """Scenes that take part."""
        return len(self.images) - len([n for n, _ in self.lost if n in {s.name for s in self.images}])


def _files(given: Given) -> list[Notice]:
    return [Notice(code="control_file", message=r) for c in given.control for r in c.remarks]


def _and(first: str, second: str) -> str:
    return f"{first}; {second}" if first else second
