"""Stage: what is known of object space, held against the photographs before anything is measured."""

from __future__ import annotations

from dataclasses import dataclass, replace

from raybundle.io.photos.masks import Masks, find_masks
from raybundle.io.photos.photo import Photo
from raybundle.pipeline.stage import Means, Stage
from raybundle.placing.attitudes import find_attitudes
from raybundle.placing.control_at_one_place import check_apart
from raybundle.placing.georeference import frame_of
from raybundle.placing.marks import Given, check_marks, check_names
from raybundle.workflows.mask_notices import mask_notices
from raybundle.workflows.orienting.state import ORIENT, Asked, OrientState
from raybundle.workflows.orienting.unused_options import check_asked


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """Photographs, and what was given with them."""

    asked: Asked
    photos: tuple[Photo, ...]
    given: Given
    scenes: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Known:
    """What is known, by the photographs that are there."""

    given: Given
    remarks: tuple[str, ...]
    masks: Masks | None


def _inputs(state: OrientState) -> Inputs:
    return Inputs(asked=state.asked, photos=state.photos, given=state.given, scenes=state.scenes is not None)


def check(i: Inputs, means: Means) -> Known:
    """Hold what was given against the photographs; raises InputError where it cannot belong to them."""
    del means
    options, positions = i.asked.options, i.asked.positions
    check_marks(i.photos, i.given)
    if not i.scenes:  # which have names and a frame of their own
        check_names(i.photos, i.given)
        check_apart(i.given)
        frame_of(i.photos, i.given)
    remarks = check_asked(
        i.photos, i.given, positions=positions, crs=options.crs, relative=options.relative, scenes=i.scenes
    )
    attitudes, reported = find_attitudes(
        i.photos, positions, use=options.attitudes, sigma_deg=options.attitude_sigma, crs=options.crs
    )
    masks = find_masks(options.masks, i.photos) if options.masks is not None and i.photos else None
    return Known(given=replace(i.given, attitudes=attitudes), remarks=(*remarks, *reported), masks=masks)


def _put(state: OrientState, known: Known) -> OrientState:
    scenes = state.scenes_found
    return replace(
        state,
        given=known.given,
        remarks=(*state.remarks, *known.remarks, *(() if scenes is None else scenes.remarks)),
        masks=known.masks,
        notices=(*state.notices, *(() if known.masks is None else mask_notices(known.masks))),
    )


STAGE = ORIENT.register(
    Stage(name="known", line="photographs", after=("targets",), inputs=_inputs, function=check, put=_put, little=True)
)
