"""What a run of `orient` knows, stage by stage; each stage of `workflows.orienting.stages` gives some of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.options import RejectMode
from raybundle.adjustment.result import Adjustment
from raybundle.block import Block, Camera
from raybundle.io.photos.cameras import CameraGroup
from raybundle.io.photos.masks import Masks
from raybundle.io.photos.photo import Photo
from raybundle.io.trajectories import Trajectory
from raybundle.matching.features import FeatureMethod
from raybundle.matching.verify import VerifiedPair
from raybundle.pipeline.stage import Workflow
from raybundle.placing.georeference import Georeferenced
from raybundle.placing.marks import Given
from raybundle.ties.block import TieBlock
from raybundle.ties.match_weights import Matches
from raybundle.ties.pairs import Round
from raybundle.ties.points import FeatureStore
from raybundle.ties.precise import Weights
from raybundle.ties.wide_baselines import Step
from raybundle.workflows.orienting.connected_components import ConnectedComponent
from raybundle.workflows.orienting.excluded_features import Dropped
from raybundle.workflows.orienting.options import OrientOptions
from raybundle.workflows.orienting.previous_names import Earlier
from raybundle.workflows.scenes.block import SceneSet
from raybundle.workflows.scenes.geometry import place_of_scenes
from raybundle.workflows.scenes.images import FoundScenes, SceneImage
from raybundle.workflows.scenes.ties import ScenePair
from raybundle.workflows.stage_arrays import Reasons


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """What a run was asked for."""

    inputs: tuple[Path, ...]
    name: str
    """of the project"""
    options: OrientOptions
    calibration: tuple[Camera, ...] = ()
    given: Given
    positions: Trajectory | None = None
    method: FeatureMethod
    earlier: Earlier | None = None
    reject: RejectMode = "snooping"
    """none: whoever asks adjusts the block again, and looks for gross errors then"""


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneState:
    """The satellite scenes of a run on their way to a block."""

    images: tuple[SceneImage, ...] = ()
    lost: Reasons = ()
    """scenes that take no part though they could be read"""
    features: FeatureStore | None = None
    pairs: tuple[ScenePair, ...] = ()
    tie: TieBlock | None = None
    block: Block | None = None
    weights: Weights | None = None
    measured: str = ""
    """what least-squares matching gave, in a few words"""

    def set(self, options: OrientOptions) -> SceneSet:
        """The scenes that are left."""
        return SceneSet(images=self.images, place=place_of_scenes(self.images), bias=options.scene_bias)

    def rows(self, index: Sequence[int]) -> SceneState:
        """Some of the scenes."""
        features = None if self.features is None else self.features.rows(index)
        return replace(self, images=tuple(self.images[i] for i in index), features=features)


@dataclass(frozen=True, slots=True, kw_only=True)
class OrientState:
    """What a run knows."""

    asked: Asked
    given: Given
    """what is known of object space, by names of photographs"""
    method: FeatureMethod
    photos: tuple[Photo, ...] = ()
    """that take part"""
    refused: Reasons = ()
    lost: Reasons = ()
    """photographs that take no part though they could be read"""
    remarks: tuple[str, ...] = ()
    reported: tuple[str, ...] = ()
    """remarks of what was measured"""
    notices: tuple[Notice, ...] = ()
    masks: Masks | None = None
    features: FeatureStore | None = None
    groups: tuple[CameraGroup, ...] = ()
    pairs: tuple[VerifiedPair, ...] = ()
    rounds: tuple[Round, ...] = ()
    """in which the pairs were chosen, of many photographs"""
    repeats: dict[int, int] = field(default_factory=dict[int, int])
    """photographs that show the same picture as another, by their index"""
    mirrored: tuple[int, ...] = ()
    """photographs that are mirrored against the others"""
    ties: tuple[TieBlock, ...] = ()
    """tie points with approximate values, of every part"""
    further: tuple[Step, ...] = ()
    """what further methods of matching gave"""
    further_budget_s: float = 0.0
    """CPU seconds that they might take"""
    blocks: tuple[Block, ...] = ()
    """the same, measured precisely where that was asked for"""
    weights: tuple[Weights, ...] = ()
    matches: tuple[Matches, ...] = ()
    dropped: Dropped | None = None
    offered: int = 0
    """features that least-squares matching was to measure again"""
    scenes_found: FoundScenes | None = None
    again: bool = False
    """whether this is the second way, by features of reduced copies"""
    scenes: SceneState | None = None
    """None: there are no scenes"""
    placed: Georeferenced | None = None
    adjustment: Adjustment | None = None
    other_components: tuple[ConnectedComponent, ...] = ()
    """of photographs that nothing joins to the first"""

    @property
    def oriented(self) -> int:
        """Photographs of the largest part."""
        return int(self.ties[0].block.images.oriented.sum()) if self.ties else 0

    @property
    def with_scenes(self) -> SceneState:
        """The scenes, of which there are some."""
        assert self.scenes is not None
        return self.scenes

    @property
    def found(self) -> FeatureStore:
        """The features, which are found."""
        assert self.features is not None
        return self.features


ORIENT: Workflow[OrientState] = Workflow("orient")
"""The stages, each in a module of `workflows.orienting.stages`"""
