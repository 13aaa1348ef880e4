"""Stage: approximate values of a block of targets, from a board or from pairs of photographs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from raybundle.adjustment.records.notice import Notice
from raybundle.block import Block, Role
from raybundle.errors import InputError, NotSolvable, excluded
from raybundle.io.block.arrays import arrays_of_block, block_of_arrays
from raybundle.io.photos.cameras import CameraGroup
from raybundle.io.photos.photo import Photo
from raybundle.numerics.arrays import Array
from raybundle.numerics.progress import Progress
from raybundle.pipeline.stage import Codec, Means, Stage
from raybundle.sensors import sensor_models
from raybundle.targets.marks import Marks, Target
from raybundle.targets.sidecar import PrintedSheet
from raybundle.workflows.calibrating.board_start import board_oriented
from raybundle.workflows.calibrating.defects import explained
from raybundle.workflows.calibrating.model_choice import with_model
from raybundle.workflows.calibrating.state import CALIBRATE, CalibrateState, Start
from raybundle.workflows.calibrating.target_block import FEWEST_TARGETS, TargetBlock, block_of_targets
from raybundle.workflows.stage_arrays import (
    notices_as_array,
    notices_of_array,
    packed,
    reasons_as_array,
    reasons_of_array,
    texts,
    unpacked,
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Inputs:
    """What approximate values depend on."""

    paths: tuple[Path, ...]
    photos: tuple[Photo, ...]
    groups: tuple[CameraGroup, ...]
    targets: tuple[Target, ...]
    marks: tuple[tuple[Marks, ...], ...]
    spacing: float | None
    sheet: PrintedSheet | None
    model: str
    estimate: tuple[str, ...]

    @property
    def content(self) -> tuple[object, ...]:
        """What they are known by; what the targets are is in their marks."""
        families = tuple((t.family, t.turns, t.objects) for t in self.targets)
        sheet = None if self.sheet is None else (self.sheet.family, self.sheet.targets)
        return self.photos, self.groups, families, self.marks, self.spacing, sheet, self.model, self.estimate


def _inputs(state: CalibrateState) -> Inputs:
    o = state.options
    return Inputs(
        paths=state.inputs, photos=state.photos, groups=state.groups, targets=state.targets, marks=state.marks,
        spacing=o.spacing, sheet=o.sheet, model=o.model, estimate=o.estimate,
    )  # fmt: skip


def begin(i: Inputs, means: Means) -> Start:
    """The named points as a block, and its approximate values; raises InputError, NotSolvable with the reason."""
    given = block_of_targets(i.photos, i.groups, i.targets, i.marks, i.spacing, i.sheet)
    given = replace(given, block=asked(given.block, i.model, i.estimate))
    if len(np.unique(given.block.observations.image)) < 2:
        raise _too_few(i)
    try:
        block, lost, reported = _approximate(given, given.block, i.targets, i.model, means.progress)
    except (InputError, NotSolvable) as error:
        raise explained(error, given.block) from error
    return Start(given=given, approximate=block, lost=tuple(lost.items()), notices=reported)


def _approximate(
    given: TargetBlock, block: Block, targets: Sequence[Target], asked_model: str, progress: Progress
) -> tuple[Block, dict[str, str], tuple[Notice, ...]]:
    """The block with approximate values, images that could not be oriented and why, and what there is to say."""
    if not given.places:
        from raybundle.orientation.approximate import possible_values
        from raybundle.orientation.projective.camera_constant import checked_by_pairs

        values = possible_values(checked_by_pairs(block), progress)
        return values.block, dict(values.not_oriented), values.notices
    model = "auto" if asked_model == "spline" else asked_model
    approximate, lost = board_oriented(block, given.places, model)
    alike = next((t for t in targets if t.turns > 1), None)
    if alike is None:
        return approximate, lost, ()
    reported = Notice(code="board_alike", values={"board": alike.title})
    p = len(approximate.points)
    held = replace(approximate.points, role=np.full(p, Role.CONTROL, np.int32), sigma=np.zeros((p, 3)))
    return replace(approximate, points=held), lost, (reported,)


def with_asked_model(block: Block, model: str) -> Block:
    """The block with a model that was asked for in place of that of the start."""
    if model in {"auto", "spline"}:
        return block
    for k, camera in enumerate(block.cameras):
        if camera.model == model:
            continue
        changed = with_model(block, k, model)
        if changed is None:
            raise InputError("camera.model_not_fitted", camera=camera.id, model=model)
        block = changed
    return block


def asked(block: Block, model: str, estimate: tuple[str, ...]) -> Block:
    """The block with the model and the parameters that were asked for."""
    if not estimate:
        return block
    if model == "spline":
        raise InputError("calibration.spline_parameters")
    model = "brown" if model == "auto" else model
    known = sensor_models[model].symbols
    unknown = [s for s in estimate if s not in known]
    if unknown:
        raise InputError("parameter.unknown", name=unknown[0], model=model, known=list(known))
    return replace(block, cameras=tuple(replace(c, estimate=estimate) for c in block.cameras))


def _too_few(i: Inputs) -> InputError:
    named_points = [sum(int(m.named.sum()) for m in sets) for sets in i.marks]
    unnamed = sum(int((~m.named).sum()) for sets in i.marks for m in sets)
    remarks = [(p.name, r) for p, sets in zip(i.photos, i.marks, strict=True) for m in sets for r in m.remarks]
    return InputError(
        "calibration.too_few_points", n=sum(k >= FEWEST_TARGETS for k in named_points), photographs=len(i.photos),
        least=FEWEST_TARGETS, families=[t.title for t in i.targets], points=sum(named_points), unnamed=unnamed,
        details=excluded(remarks[:10]), file=", ".join(map(str, i.paths)),
    )  # fmt: skip


def _arrays(s: Start) -> dict[str, Array]:
    places = s.given.places
    return {
        **packed({"given": arrays_of_block(s.given.block), "approximate": arrays_of_block(s.approximate)}),
        "radius_px": s.given.radius_px,
        "not_used": reasons_as_array(s.given.not_used),
        "place_names": texts([*places]),
        "places": np.array([*places.values()], float).reshape(-1, 3),
        "lost": reasons_as_array(s.lost),
        "notices": notices_as_array(s.notices),
    }


def _product(a: Mapping[str, Array]) -> Start:
    blocks = {part: block_of_arrays(arrays) for part, arrays in unpacked(a).items()}
    given = TargetBlock(
        block=blocks["given"], radius_px=a["radius_px"], not_used=reasons_of_array(a["not_used"]),
        places=dict(zip(a["place_names"].tolist(), a["places"], strict=True)),
    )  # fmt: skip
    return Start(
        given=given, approximate=blocks["approximate"], lost=reasons_of_array(a["lost"]),
        notices=notices_of_array(a["notices"]),
    )  # fmt: skip


STAGE = CALIBRATE.register(
    Stage(
        name="start",
        version=3,
        after=("targets",),
        inputs=_inputs,
        function=begin,
        put=lambda s, p: replace(s, start=p),
        reported=lambda s: f"{int(s.begun.approximate.images.oriented.sum())} of {len(s.photos)} photographs",
        codec=Codec(arrays=_arrays, product=_product),
        when=lambda s: bool(s.targets),
    )
)
